"""The numbers of the flywheel: moments, works and energies over the cycle, the methods, the motion, the dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.chapters.machine.flywheel.values import OverCycle, Proof
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Table, Value, text_column
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("flywheel_delta", "flywheel_J_fl", "flywheel_m", "flywheel_D")  # what is looked for first

Array = Any

CYCLE = Message(N_("moments, work, moments of inertia, energies and speeds over the cycle of the machine"))
PROOF = Message(
    N_("the motion with the flywheel, by the energy integral and by integration of the equation of motion")
)


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


def book(found: Found) -> Book:
    """All that the chapter says in numbers."""
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for name, turned in (("table", found.sides.turned), ("diagram", found.sides.drawn)):
        yield Table(f"flywheel_{name}", CYCLE, (*where(turned), *cycle(found, turned)))
    if found.methods:
        yield found.compared
    yield _proof(found)


def cycle(found: Found, turned: Array) -> Iterator[Column]:
    """Each quantity of the cycle at angles turned, (P,); what is not known of the variant is left out."""
    sides, of = found.sides, found.cycle
    over = of.panels
    if sides.driving is not None and sides.resisting is not None:
        yield OverCycle.M_dr.column(over.at(sides.driving, turned))
        yield OverCycle.M_res.column(over.at(sides.resisting, turned))
    if sides.rubbing is not None:
        yield OverCycle.M_fr.column(-over.at(sides.rubbing, turned))  # as the chapter of friction has it
    yield OverCycle.M_ex.column(over.at(of.moment, turned))
    # the work at the end is that of the whole cycle, nothing: what is left of it is rounding
    work = over.at(of.work, turned)
    yield OverCycle.A.column(work)
    if found.varies or found.lever:
        varying = over.at(of.varying, turned)
        yield OverCycle.J_II.column(varying)
        yield OverCycle.T_II.column(varying * found.omega**2 / 2)
        yield OverCycle.dT_I.column(work - varying * found.omega**2 / 2)
    if found.before is not None and not found.needless:
        yield OverCycle.omega_0.column(over.at(found.before.omega, turned))
    yield OverCycle.omega.column(over.at(found.after.omega, turned))
    yield OverCycle.domega.column(over.at(found.after.omega, turned) - found.omega)
    yield OverCycle.epsilon.column(over.at(found.after.epsilon, turned))


# ---------------------------------------------------------------- the proof

WAYS = ("energy", "integration")


def _proof(found: Found) -> Table:
    after, proof = found.after, found.proof
    low, high = proof.ends
    miss = abs(proof.delta / after.delta - 1) if after.delta else 0.0
    columns = (
        text_column("way", Message(N_("way to the motion")), list(WAYS)),
        Proof.omega_max.column([after.greatest, high]),
        Proof.omega_min.column([after.least, low]),
        Proof.delta.column([after.delta, proof.delta]),
        Proof.miss.column([0.0, miss]),
    )
    return Table("flywheel_proof", PROOF, columns)
