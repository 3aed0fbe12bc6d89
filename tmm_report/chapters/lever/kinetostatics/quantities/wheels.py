"""The numbers of the forces in the teeth of wheels and racks within the mechanism, and of wheels that roll on rails."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.structure.quantities import index_of
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, kept
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved

Array = Any
TABLE = Message(N_("forces in the teeth of the wheels and their moments about the wheels' axes"))
ROLLING = Message(N_("forces of the rails on the wheels that roll, and the friction that holds them"))
SIZES = {
    "f": N_("force of friction of the rail on wheel %(other)s, its size"),
    "t": N_("tangential force in the teeth of links %(one)s and %(other)s, its size"),
    "n": N_("force in the teeth of links %(one)s and %(other)s along the line of action, its size"),
}


@kept
def force(one: str, other: str, index: str, part: str) -> Quantity:
    """ "t" or "n", "f" of a wheel that rolls."""
    meaning, up = Message(SIZES[part], {"one": one, "other": other}), "t" if part == "f" else part
    return Quantity(f"F_{up}_{index}", Symbol("F", index, up), "N", meaning)


@kept
def pressing(wheel: str, index: str) -> Quantity:
    text = N_("normal force of the rail on wheel %(wheel)s; below zero: the wheel would leave the rail")
    return Quantity(f"N_{index}", Symbol("N", index), "N", Message(text, {"wheel": wheel}))


@kept
def needed(wheel: str, index: str) -> Quantity:
    text = N_("coefficient of friction that wheel %(wheel)s needs so as to roll without slip")
    return Quantity(f"f_{index}", Symbol("f", index), "", Message(text, {"wheel": wheel}))


@kept
def most_needed(wheel: str, index: str) -> Quantity:
    text = N_("greatest coefficient of friction that wheel %(wheel)s needs, of those in the table")
    return Quantity(f"f_max_{index}", Symbol("f", f"{index},max"), "", Message(text, {"wheel": wheel}))


@kept
def moment(by: str, on: str, index: str, rolls: bool) -> Quantity:
    text = N_("moment that the teeth of link %(by)s give link %(on)s about its axis")
    if rolls:
        text = N_("moment that the friction of the rail gives wheel %(on)s about its axis")
    return Quantity(
        f"M_z_{on}_{index}", Symbol("M", f"{by},{on}"), "N·m", Message(text, {"by": by, "on": on})
    )


@kept
def engagement(one: str, other: str, index: str) -> Quantity:
    text = N_("angle of engagement of links %(one)s and %(other)s")
    return Quantity(
        f"alpha_w_{index}", Symbol("alpha", f"w,{index}"), "deg", Message(text, {"one": one, "other": other})
    )


def force_of(mesh: Mesh, part: str) -> Quantity:
    return force(*mesh.links, index_of(mesh), "f" if mesh.rolls and part == "t" else part)


def pressing_of(mesh: Mesh) -> Quantity:
    return pressing(mesh.links[1], index_of(mesh))


def needed_of(mesh: Mesh) -> Quantity:
    return needed(mesh.links[1], index_of(mesh))


def most_needed_of(mesh: Mesh) -> Quantity:
    return most_needed(mesh.links[1], index_of(mesh))


def moment_of(mesh: Mesh, on: str) -> Quantity:
    return moment(mesh.other(on), on, index_of(mesh), mesh.rolls)


def engagement_of(mesh: Mesh) -> Quantity:
    return engagement(*mesh.links, index_of(mesh))


def coupled_of(found: Kinetostatics) -> tuple[Coupled, ...]:
    return found.kinematics.linkage.structure.coupled


def toothed(found: Kinetostatics) -> tuple[Coupled, ...]:
    return tuple(one for one in coupled_of(found) if not one.mesh.rolls)


def rolling(found: Kinetostatics) -> tuple[Coupled, ...]:
    """Those that roll on a rail without teeth."""
    return tuple(one for one in coupled_of(found) if one.mesh.rolls)


def tables(found: Kinetostatics) -> Iterator[Table]:
    for name, solved in (("table", found.table), ("diagram", found.diagram)):
        if toothed(found):
            yield Table(f"mesh_{name}", TABLE, (*where(solved.turned), *_columns(found, solved)))
        if rolling(found):
            yield Table(f"rolling_{name}", ROLLING, (*where(solved.turned), *_of_rails(found, solved)))


def _of_rails(found: Kinetostatics, solved: Solved) -> Iterator[Column]:
    for wheel in rolling(found):
        mesh, tangential, normal = wheel.mesh, tangential_of(wheel, solved), normal_of(wheel, solved)
        yield force_of(mesh, "t").column(np.abs(tangential))
        yield pressing_of(mesh).column(normal)
        yield needed_of(mesh).column(friction_of(tangential, normal))
        yield from (moment_of(mesh, on).column(values) for on, values in moments_of(wheel, solved))


def normal_of(wheel: Coupled, solved: Solved) -> Array:
    """What the rail bears, N, (P,): all that the guide of the axle does, above zero where it presses the wheel."""
    force = solved.statics.force(wheel.mesh.carrier, FRAME)
    return dot(-wheel.mesh.toward, np.broadcast_to(force, solved.motion.shape))


def friction_of(tangential: Array, normal: Array) -> Array:
    """|F_t|/N; nan where the wheel leaves the rail."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(normal > 0, np.abs(tangential) / normal, np.nan)


def _columns(found: Kinetostatics, solved: Solved) -> Iterator[Column]:
    for wheel in toothed(found):
        mesh, tangential = wheel.mesh, tangential_of(wheel, solved)
        yield force_of(mesh, "t").column(np.abs(tangential))
        yield force_of(mesh, "n").column(mesh.normal(tangential))
        yield from (moment_of(mesh, on).column(values) for on, values in moments_of(wheel, solved))


def tangential_of(wheel: Coupled, solved: Solved) -> Array:
    """The tangential force on the moved link, above zero counter-clockwise about its axis (about that of a rack's
    wheel), N, (P,)."""
    found = solved.statics.reactions[wheel.contact.key]
    across = np.broadcast_to(found.force, solved.motion.shape) / outward_of(wheel, solved)
    return np.imag(across)


def outward_of(wheel: Coupled, solved: Solved) -> Array:
    """From the axis of the moved link (of a rack's wheel) to the pitch point, unit complex, axes of the drawing."""
    return wheel.mesh.turn(solved.motion.state) * wheel.mesh.outward(wheel.link)


def moments_of(wheel: Coupled, solved: Solved) -> Iterator[tuple[str, Array]]:
    """Of the links that turn, what the teeth turn them with, N m, (P,)."""
    mesh, on_link = wheel.mesh, tangential_of(wheel, solved)
    for link in mesh.links:
        if mesh.radius(link):
            sign = 1.0 if link == wheel.link else -1.0
            same = np.real(mesh.outward(link) / mesh.outward(wheel.link))
            yield link, sign * same * on_link * mesh.radius(link)


def values(found: Kinetostatics) -> Iterator[Value]:
    for wheel in toothed(found):
        yield engagement_of(wheel.mesh).value(float(np.degrees(wheel.mesh.pressure)))
    for wheel in rolling(found):
        solved = found.table
        needs = friction_of(tangential_of(wheel, solved), normal_of(wheel, solved))
        if np.isfinite(needs).any():
            yield most_needed_of(wheel.mesh).value(float(np.nanmax(needs)))
