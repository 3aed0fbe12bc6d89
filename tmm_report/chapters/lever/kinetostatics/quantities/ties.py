"""The numbers of springs and dampers: what is stated of them; length, velocity, force and power at the positions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link
from tmm_report.chapters.lever.kinetostatics.solve.lengths import law_of, line, ties_of
from tmm_report.chapters.lever.kinetostatics.ties import Damper, End, Spring, apart
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, kept, text_column
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved

Array = Any
SPRINGS = Message(N_("springs between points"))
DAMPERS = Message(N_("viscous dampers between points"))
TIES = Message(N_("lengths of springs and dampers, their rates, forces and powers"))

STIFFNESS = Quantity("c", Symbol("c"), "N/m", Message(N_("stiffness of the spring")))
FREE = Quantity("l_0", Symbol("l", "0"), "m", Message(N_("length of the spring without any force")), "mm")
VISCOSITY = Quantity(
    "b", Symbol("b"), "N·s/m", Message(N_("coefficient of viscous resistance of the damper"))
)
PRELOAD = Quantity("F_0", Symbol("F", "0"), "N", Message(N_("stated force of the spring, its preload")))
AT_LENGTH = Quantity(
    "l_F", Symbol("l", "F"), "m", Message(N_("length of the spring under its preload")), "mm"
)
SPRING_CALLED, DAMPER_CALLED = N_("Spring %(of)s"), N_("Damper %(of)s")
OWN = {Spring: N_("spring %(of)s"), Damper: N_("damper %(of)s")}


# ---------------------------------------------------------------- quantities


def said(end: End) -> Message:
    """How a tie is called."""
    return _called(_own(end), end.of)


def _own(end: End) -> str:
    return OWN[type(end.tie)]


def _called(own: str, of: str) -> Message:
    return Message(own, {"of": of})


@kept
def _of_tie(letter: str, of: str, unit: str, text: str, own: str, shown: str = "") -> Quantity:
    meaning = Message(text, {"tie": _called(own, of)})
    return Quantity(f"{letter}_{of}", Symbol(letter, of), unit, meaning, shown)


def length(end: End) -> Quantity:
    return _of_tie("l", end.of, "m", N_("length: %(tie)s"), _own(end), "mm")


def rate(end: End) -> Quantity:
    return _of_tie(
        "v", end.of, "m/s", N_("rate of the length, above zero where it grows: %(tie)s"), _own(end)
    )


def force(end: End) -> Quantity:
    text = N_("force, above zero where it draws its points together: %(tie)s")
    return _of_tie("F", end.of, "N", text, _own(end))


def power(end: End) -> Quantity:
    return _of_tie("N", end.of, "W", N_("power given to the mechanism: %(tie)s"), _own(end))


def coefficient(end: End) -> Symbol:
    """Of one of them: c₁, b₂."""
    return _numbered(STIFFNESS if isinstance(end.tie, Spring) else VISCOSITY, end)


def at_end(end: End) -> Quantity:
    """The force on one of its points."""
    return _at_end(end.of, end.at, _own(end))


@kept
def _at_end(of: str, at: str, own: str) -> Quantity:
    meaning = Message(N_("force on point %(at)s: %(tie)s"), {"at": at, "tie": _called(own, of)})
    return Quantity(f"F_{of},{at}", Symbol("F", f"{of},{at}"), "N", meaning)


def _numbered(of: Quantity, end: End) -> Symbol:
    """The symbol of one of them: c₁, l₀,₁."""
    sign = of.sign
    return Symbol(sign.base, ",".join(filter(None, (sign.sub, end.of[1:]))))


# ---------------------------------------------------------------- tables


def tables(found: Kinetostatics) -> Iterator[Table]:
    ties = ties_of(found.given)
    if not ties:
        return
    yield from given_tables(found, ties)
    law = found.kinematics.by_law
    for name, solved in (("table", found.table), ("diagram", found.diagram)):
        yield Table(f"ties_{name}", TIES, (*where(solved.turned, law), *_columns(found, solved, ties)))


def given_tables(found: Kinetostatics, ties: Sequence[End]) -> Iterator[Table]:
    springs = [end for end in ties if isinstance(end.tie, Spring)]
    dampers = [end for end in ties if isinstance(end.tie, Damper)]
    if springs:
        yield Table("springs", SPRINGS, (*_between(found, springs), *_of_springs(found, springs)))
    if dampers:
        viscous = [end.tie.viscosity for end in dampers]  # type: ignore[attr-defined]
        signs = [_numbered(VISCOSITY, end) for end in dampers]
        yield Table("dampers", DAMPERS, (*_between(found, dampers), Column(VISCOSITY, viscous, signs)))


def _between(found: Kinetostatics, ties: Sequence[End]) -> Iterator[Column]:
    """How each is called, its name, its points and the links that take its forces."""
    rows = [(end.of, end.name or end.of, *end.tie.between, *_links(found, end)) for end in ties]
    texts = (
        ("key", N_("how it is called")),
        ("name", N_("its name")),
        ("one", N_("its first point")),
        ("other", N_("its second point")),
        ("link_one", N_("link that takes the force on the first point")),
        ("link_other", N_("link that takes the force on the second point")),
    )
    for i, (key, text) in enumerate(texts):
        yield text_column(key, Message(text), [row[i] for row in rows])


def _links(found: Kinetostatics, end: End) -> list[str]:
    """Of both points the links; of a fixed one the frame."""
    own = [found.given.forces[k] for k in of_tie(found, end)]
    taken = {one.at: loaded_link(found.table.motion, one) for one in own}
    return [taken.get(point, FRAME) for point in end.tie.between]


def of_tie(found: Kinetostatics, end: End) -> list[int]:
    """Numbers of its ends among the forces."""
    return next(own for own in apart(found.given.forces)[1] if found.given.forces[own[0]] is end)


def _of_springs(found: Kinetostatics, springs: Sequence[End]) -> Iterator[Column]:
    """Stiffness, free length and, where one is stated by it, preload and the length under it."""
    tied: list[Any] = [end.tie for end in springs]
    free = [law_of(end.tie, found.kinematics).free for end in springs]  # type: ignore[attr-defined]
    loaded = [math.nan if tie.preload is None else tie.preload for tie in tied]
    under = [l0 + force / tie.stiffness for l0, force, tie in zip(free, loaded, tied, strict=True)]
    columns = [(STIFFNESS, [tie.stiffness for tie in tied]), (FREE, free)]
    if np.isfinite(loaded).any():
        columns += [(PRELOAD, loaded), (AT_LENGTH, under)]
    for of, values in columns:
        yield Column(of, values, [_numbered(of, end) for end in springs])


def _columns(found: Kinetostatics, solved: Solved, ties: Sequence[End]) -> Iterator[Column]:
    for end in ties:
        one = line(*end.tie.between, solved.motion)
        drawn = solved.loading.stated[of_tie(found, end)[0]]
        shape = solved.motion.shape
        yield length(end).column(np.broadcast_to(one.length, shape))
        yield rate(end).column(np.broadcast_to(one.rate, shape))
        yield force(end).column(np.broadcast_to(drawn, shape))
        yield power(end).column(np.broadcast_to(-drawn * one.rate, shape))
