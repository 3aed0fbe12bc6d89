"""The numbers of the flywheel: moments, works and energies over the cycle, the methods, the motion, the dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.chapters.machine.flywheel.values import values
from tmm_report.i18n import NP_
from tmm_report.mechanics.machine.flywheel.inertia import Touch
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

__all__ = ["book", "tables", "values"]

Array = Any

CYCLE = Message(N_("moments, work, moments of inertia, energies and speeds over the cycle of the machine"))
METHODS = Message(N_("moment of inertia of the flywheel by several methods"))
PROOF = Message(
    N_("the motion with the flywheel, by the energy integral and by integration of the equation of motion")
)

DRIVING = Quantity(
    "M_dr", Symbol("M", NP_("index", "dr")), "N·m", Message(N_("driving moment on the main link"))
)
RESISTING = Quantity(
    "M_res", Symbol("M", NP_("index", "res")), "N·m", Message(N_("moment of the resistances"))
)
FRICTION = Quantity(
    "M_fr",
    Symbol("M", "fr"),
    "N·m",
    Message(N_("moment of friction in the pairs, among the moment of the resistances")),
)
EXCESS = Quantity("M_ex", Symbol("M", NP_("index", "exc")), "N·m", Message(N_("excess moment")))
WORK = Quantity(
    "A", Symbol("A"), "J", Message(N_("work of the excess moment from the beginning of the cycle"))
)
VARYING = Quantity(
    "J_II", Symbol("J", "II"), "kg·m²", Message(N_("varying part of the reduced moment of inertia"))
)
SECOND = Quantity(
    "T_II", Symbol("T", "II"), "J", Message(N_("kinetic energy of the varying part at the mean speed"))
)
FIRST = Quantity(
    "dT_I", Symbol("DeltaT", "I"), "J", Message(N_("change of the kinetic energy of the constant part"))
)
BEFORE = Quantity(
    "omega_0",
    Symbol("omega", "0"),
    "rad/s",
    Message(N_("angular velocity of the main link without the flywheel")),
)
AFTER = Quantity(
    "omega", Symbol("omega"), "rad/s", Message(N_("angular velocity of the main link with the flywheel"))
)
DEVIATION = Quantity(
    "domega",
    Symbol("Deltaomega"),
    "rad/s",
    Message(N_("difference of the angular velocity with the flywheel from the mean one")),
)
EPSILON = Quantity(
    "epsilon",
    Symbol("epsilon"),
    "rad/s²",
    Message(N_("angular acceleration of the main link with the flywheel")),
)


def book(found: Found) -> Book:
    """All that the chapter says in numbers."""
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for name, turned in (("table", found.sides.turned), ("diagram", found.sides.drawn)):
        columns = (quantity.column(numbers) for quantity, numbers in cycle(found, turned))
        yield Table(f"flywheel_{name}", CYCLE, (*where(turned), *columns))
    if found.methods:
        yield _methods(found)
    yield _proof(found)


def cycle(found: Found, turned: Array) -> Iterator[tuple[Quantity, Array]]:
    """Each quantity of the cycle at angles turned, (P,); what is not known of the variant is left out."""
    sides, of = found.sides, found.cycle
    over = of.panels
    if sides.driving is not None and sides.resisting is not None:
        yield DRIVING, over.at(sides.driving, turned)
        yield RESISTING, over.at(sides.resisting, turned)
    if sides.rubbing is not None:
        yield FRICTION, over.at(sides.rubbing, turned)
    yield EXCESS, over.at(of.moment, turned)
    # the work at the end is that of the whole cycle, nothing: what is left of it is rounding
    yield WORK, work_at(found, turned)
    if found.varies or found.lever:
        yield VARYING, over.at(of.varying, turned)
        yield SECOND, over.at(of.varying, turned) * found.omega**2 / 2
        yield FIRST, work_at(found, turned) - over.at(of.varying, turned) * found.omega**2 / 2
    if found.before is not None and not found.needless:
        yield BEFORE, over.at(found.before.omega, turned)
    yield AFTER, over.at(found.after.omega, turned)
    yield DEVIATION, over.at(found.after.omega, turned) - found.omega
    yield EPSILON, over.at(found.after.epsilon, turned)


def work_at(found: Found, turned: Array) -> Array:
    return found.cycle.panels.at(found.cycle.work, turned)


# ---------------------------------------------------------------- the methods

INERTIA = Quantity("J_I", Symbol("J", "I"), "kg·m²", Message(N_("constant moment of inertia that is needed")))
FLY = Quantity(
    "J_fl",
    Symbol("J", NP_("index", "fl")),
    "kg·m²",
    Message(N_("moment of inertia of the flywheel, reduced to the main link")),
)
OFF = Quantity(
    "deviation",
    Symbol("DeltaJ"),
    "%",
    Message(N_("difference from the exact moment of inertia of the flywheel")),
)
ENDS = {  # of a tangent: the number of the end -> what is said of the angle, J_II, A, the slope and the cut there
    "1": (
        N_("angle at which the speed is taken to be greatest"),
        N_("varying part of the moment of inertia where the speed is greatest"),
        N_("work of the excess moment where the speed is greatest"),
        N_("slope of the tangent at the greatest speed"),
        N_("work where the speed is greatest, less the energy of the varying part at this speed"),
    ),
    "2": (
        N_("angle at which the speed is taken to be least"),
        N_("varying part of the moment of inertia where the speed is least"),
        N_("work of the excess moment where the speed is least"),
        N_("slope of the tangent at the least speed"),
        N_("work where the speed is least, less the energy of the varying part at this speed"),
    ),
}
SIGNS = (("phi", "phi", "deg"), ("J", "J", "kg·m²"), ("A", "A", "J"), ("s", "s", "(rad/s)²"), ("T", "T", "J"))


def _methods(found: Found) -> Table:
    """One row a method; what it takes for both ends."""
    methods = list(found.methods.values())
    fly = np.array([method.inertia - found.cycle.own for method in methods])
    exact = fly[[method.key for method in methods].index("exact")]
    off = np.full(len(fly), np.nan) if found.needless else 100 * (fly - exact) / exact
    columns = (
        text_column("method", Message(N_("method")), [method.key for method in methods]),
        INERTIA.column([method.inertia for method in methods]),
        FLY.column(fly),
        OFF.column(off),
        *_ends("1", [method.upper for method in methods]),
        *_ends("2", [method.lower for method in methods]),
    )
    return Table("flywheel_methods", METHODS, columns)


def _ends(end: str, touches: list[Touch]) -> Iterator[Column]:
    numbers = ([getattr(one, name) for one in touches] for name in ("at", "inertia", "work", "slope", "cut"))
    for (key, base, unit), meaning, of in zip(SIGNS, ENDS[end], numbers, strict=True):
        quantity = Quantity(f"{key}_{end}", Symbol(base, end), unit, Message(meaning))
        yield quantity.column(np.degrees(of) if unit == "deg" else of)


# ---------------------------------------------------------------- the proof

WAYS = ("energy", "integration")
MOST = Quantity("omega_max", Symbol("omega", "max"), "rad/s", Message(N_("greatest angular velocity")))
LEAST = Quantity("omega_min", Symbol("omega", "min"), "rad/s", Message(N_("least angular velocity")))
DELTA = Quantity("delta", Symbol("delta"), "", Message(N_("coefficient of non-uniformity")))
MISS = Quantity(
    "miss",
    None,
    "",
    Message(N_("relative difference of the coefficient from the one by the energy integral")),
)


def _proof(found: Found) -> Table:
    low, high = found.proof.ends
    rows = [(found.after.greatest, found.after.least, found.after.delta), (high, low, found.proof.delta)]
    miss = [0.0, abs(found.proof.delta / found.after.delta - 1) if found.after.delta else 0.0]
    columns = (
        text_column("way", Message(N_("way to the motion")), list(WAYS)),
        *(of.column([row[k] for row in rows]) for k, of in enumerate((MOST, LEAST, DELTA))),
        MISS.column(miss),
    )
    return Table("flywheel_proof", PROOF, columns)
