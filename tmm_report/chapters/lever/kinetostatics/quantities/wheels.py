"""The numbers of the forces in the teeth of wheels and racks within the mechanism."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.structure.quantities import index_of
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, kept
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved

Array = Any
TABLE = Message(N_("forces in the teeth of the wheels and their moments about the wheels' axes"))
SIZES = {
    "t": N_("tangential force in the teeth of links %(one)s and %(other)s, its size"),
    "n": N_("force in the teeth of links %(one)s and %(other)s along the line of action, its size"),
}


@kept
def force(one: str, other: str, index: str, part: str) -> Quantity:
    """ "t" or "n"."""
    meaning = Message(SIZES[part], {"one": one, "other": other})
    return Quantity(f"F_{part}_{index}", Symbol("F", index, part), "N", meaning)


@kept
def moment(by: str, on: str, index: str) -> Quantity:
    text = N_("moment that the teeth of link %(by)s give link %(on)s about its axis")
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
    return force(*mesh.links, index_of(mesh), part)


def moment_of(mesh: Mesh, on: str) -> Quantity:
    return moment(mesh.other(on), on, index_of(mesh))


def engagement_of(mesh: Mesh) -> Quantity:
    return engagement(*mesh.links, index_of(mesh))


def coupled_of(found: Kinetostatics) -> tuple[Coupled, ...]:
    return found.kinematics.linkage.structure.coupled


def tables(found: Kinetostatics) -> Iterator[Table]:
    if coupled_of(found):
        for name, solved in (("table", found.table), ("diagram", found.diagram)):
            yield Table(f"mesh_{name}", TABLE, (*where(solved.turned), *_columns(found, solved)))


def _columns(found: Kinetostatics, solved: Solved) -> Iterator[Column]:
    for wheel in coupled_of(found):
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
    for wheel in coupled_of(found):
        yield engagement_of(wheel.mesh).value(float(np.degrees(wheel.mesh.pressure)))
