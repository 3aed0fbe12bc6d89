"""Quantities of points and links over the cycle: positions and angles turned, places, velocities, accelerations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.checks.digits_left import digits_left
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.lever.vector_equations import (
    Branch,
    driving_pin,
    moving_points,
    relations,
    turning_links,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, kept
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.cycle import PHI as PHI
from tmm_report.quantity.terms.cycle import POSITION as POSITION
from tmm_report.quantity.terms.directions import X_OF, Y_OF

Array = Any

CLOSENESS = N_("closeness of group %(group)s to a singular position, 1 … 0 (of a dyad, a sine)")

PHASE = Quantity(
    "phi",
    Symbol("theta"),
    "deg",
    Message(N_("phase of the driving link's law: 360° in the time in which it goes once")),
)


def along(law: bool) -> Quantity:
    """Over what a cycle goes: the angle turned, or the phase of a `law` of the driving link."""
    return PHASE if law else PHI


def where(turned: Array, law: bool = False) -> tuple[Column, Column]:
    """The first columns of a table by positions: their numbers and the angle turned, rad, or the phase of a `law` of
    the driving link."""
    return POSITION.column(list(range(len(turned)))), along(law).column(np.degrees(turned))


# ---------------------------------------------------------------- places


def places(motion: Motion) -> Iterator[Column]:
    for point in moving_points(motion.linkage):
        place = motion.place(point)
        for axis, text, values in (
            ("x", X_OF, place.real),
            ("y", Y_OF, place.imag),
        ):
            yield coordinate(axis, text, point).column(values)
    for link in turning_links(motion.linkage):
        yield angle(link).column(np.degrees(np.angle(motion.turn(link))))
    for label, sine in motion.sines.items():
        near, digits = nearness(label)
        yield near.column(sine)
        yield digits.column(digits_left(sine))


@kept
def coordinate(axis: str, text: str, point: str) -> Quantity:
    """x or y of a point."""
    return Quantity(f"{axis}_{point}", Symbol(axis, point), "m", Message(text, {"name": point}))


@kept
def angle(link: str) -> Quantity:
    meaning = Message(N_("angle of link %(name)s from the x axis"), {"name": link})
    return Quantity(f"phi_{link}", Symbol("phi", link), "deg", meaning)


@kept
def nearness(group: str) -> tuple[Quantity, Quantity]:
    """Closeness of a group to a singular position, and the digits that remain there."""
    of = {"group": group}
    digits = Message(N_("decimal digits that remain in group %(group)s"), of)
    return (
        Quantity(f"sin_{group}", None, "", Message(CLOSENESS, of)),
        Quantity(f"digits_{group}", None, "", digits),
    )


# ---------------------------------------------------------------- velocities and accelerations

POINT = {"v": N_("velocity of point %(of)s"), "a": N_("acceleration of point %(of)s")}
LINK = {"w": N_("angular velocity of link %(name)s"), "e": N_("angular acceleration of link %(name)s")}
RELATIVE = N_("velocity of point %(one)s relative to point %(other)s")
PARTS = {
    "n": N_("normal acceleration of point %(one)s relative to point %(other)s"),
    "t": N_("tangential acceleration of point %(one)s relative to point %(other)s"),
    "k": N_("Coriolis acceleration of point %(one)s relative to point %(other)s"),
    "r": N_("sliding acceleration of point %(one)s relative to point %(other)s"),
}
BASES = {"w": "omega", "e": "epsilon"}
UNITS = {"v": "m/s", "a": "m/s²", "w": "rad/s", "e": "rad/s²"}


@kept
def point_rate(letter: str, point: str) -> Quantity:
    """Velocity "v" or acceleration "a" of a point."""
    meaning = Message(POINT[letter], {"of": point})
    return Quantity(f"{letter}_{point}", Symbol(letter, point), UNITS[letter], meaning)


@kept
def link_rate(letter: str, link: str) -> Quantity:
    """Angular velocity "w" or acceleration "e" of a link."""
    meaning = Message(LINK[letter], {"name": link})
    return Quantity(f"{letter}_{link}", Symbol(BASES[letter], link), UNITS[letter], meaning)


def rates(linkage: Linkage) -> dict[str, Quantity]:
    """Every velocity, acceleration and angular rate of the note by its key (see `relations.named_values`)."""
    found: list[Quantity] = []
    for point in moving_points(linkage):
        found += [point_rate("v", point), point_rate("a", point)]
    pin = driving_pin(linkage) if linkage.mechanism.driver.law is not None else None
    if pin is not None:
        found += _of_pin(pin, linkage.structure.driver_pair.name)
    for relation in relations(linkage):
        for branch in relation.branches:
            found += _of_branch(branch)
    for link in turning_links(linkage):
        found += [link_rate("w", link), link_rate("e", link)]
    known: dict[str, Quantity] = {}
    for quantity in found:
        known.setdefault(quantity.key, quantity)
    return known


@kept
def _of_pin(pin: str, pivot: str) -> tuple[Quantity, ...]:
    """Parts of the acceleration of the driving link's pin about its pivot."""
    return tuple(
        Quantity(
            f"a_{pin}{pivot}_{part}",
            Symbol("a", pin + pivot, part),
            "m/s²",
            Message(PARTS[part], {"one": pin, "other": pivot}),
        )
        for part in "nt"
    )


@kept
def _of_branch(branch: Branch) -> tuple[Quantity, ...]:
    return tuple(_branch_rates(branch))


def _branch_rates(branch: Branch) -> Iterator[Quantity]:
    for point in (branch.start, branch.end):
        if point is not None:
            yield from (point_rate("v", point), point_rate("a", point))
    about = branch.start or (branch.arm[0] if branch.arm else branch.guide)
    pair = {"one": branch.end, "other": about}
    yield Quantity(branch.v_key, Symbol("v", branch.pair), "m/s", Message(RELATIVE, pair))
    if branch.has_bend or branch.start is not None:
        for part in ("n", "t") if branch.turns else ("k", "r") if branch.has_bend else ("r",):
            symbol = Symbol("a", branch.pair, part)
            yield Quantity(f"a_{branch.pair}_{part}", symbol, "m/s²", Message(PARTS[part], pair))


def rated(quantities: Mapping[str, Quantity], values: Mapping[str, Array]) -> Iterator[Column]:
    for key, numbers in values.items():
        if np.iscomplexobj(numbers):
            yield from quantities[key].vector(numbers)
        else:
            yield quantities[key].column(numbers)
