"""The numbers of counterweights and of substituted masses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.lever.initial_data.quantities import inertia, mass
from tmm_report.chapters.machine.balancing.solve.cases import Case, Placed
from tmm_report.chapters.machine.balancing.solve.substituted_masses import Carried
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.values import Masses, Splits, Weights
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol

WEIGHTS = Message(N_("counterweights of each way of balancing"))
MASSES = Message(N_("masses that a counterweight meets, with their arms"))
SPLITS = Message(N_("masses of the floating links substituted into their joints"))
METHOD = Message(N_("way of balancing"))
LINK = Message(N_("link"))

# ---------------------------------------------------------------- counterweights

ALONG = N_("static moment of the counterweight of link %(link)s along the link")
ACROSS = N_("static moment of the counterweight of link %(link)s across the link")
STATIC = N_("static moment of the counterweight of link %(link)s")
TURNED = N_("angle of the counterweight of link %(link)s from the line of the link")
DISTANCE = N_("distance of the counterweight of link %(link)s from the pivot of the link")
CARRIED = N_("mass that link %(link)s carries at point %(point)s")
ARM_ALONG = N_("arm of the mass at point %(point)s along link %(link)s")
ARM_ACROSS = N_("arm of the mass at point %(point)s across link %(link)s")
MASS = N_("mass of the counterweight of link %(link)s")


def placed(cases: Sequence[Case]) -> list[tuple[Case, Placed]]:
    """Every counterweight in the order of the table."""
    return [(case, one) for case in cases for one in case.placed]


def met(cases: Sequence[Case]) -> list[tuple[Case, Placed, Carried]]:
    """Every mass that a counterweight meets, in the order of the table."""
    rows = placed(cases)
    return [(case, one, each) for case, one in rows if one.carried for each in one.carried.carried]


def counterweights(cases: Sequence[Case]) -> Iterator[Table]:
    """The counterweights, and the masses that they meet; nothing where there are none."""
    if rows := placed(cases):
        yield _weights(rows)
    if masses := met(cases):
        yield _masses(masses)


def _weights(rows: Sequence[tuple[Case, Placed]]) -> Table:
    links = [one.link for _, one in rows]
    moments = np.array([one.moment for _, one in rows])

    def named(of: Q, values: Sequence[float], text: str) -> Column:
        sign = of.quantity.sign
        symbols = [Symbol(sign.base, f"{sign.sub}{link}", sign.sup) for link in links]
        meanings = [Message(text, {"link": link}) for link in links]
        return Column(of.quantity, np.array(values), symbols, meanings=meanings)

    return Table(
        "counterweights",
        WEIGHTS,
        (
            text_column("method", METHOD, [case.name for case, _ in rows]),
            text_column("link", LINK, links),
            named(Weights.U_x, list(moments.real), ALONG),
            named(Weights.U_y, list(moments.imag), ACROSS),
            named(Weights.U, list(np.abs(moments)), STATIC),
            named(Weights.beta, list(np.degrees(np.angle(moments)) % 360), TURNED),
            named(Weights.rho, [one.distance for _, one in rows], DISTANCE),
            named(Weights.m_c, [one.mass for _, one in rows], MASS),
        ),
    )


def _masses(rows: Sequence[tuple[Case, Placed, Carried]]) -> Table:
    names = [each.name for *_, each in rows]
    indices = [f"{one.link},{each.name}" for _, one, each in rows]

    def named(of: Q, values: Sequence[float], text: str) -> Column:
        prime = "′" if of is Masses.m else ""  # not a mass put into a joint of a floating link
        symbols = [Symbol(of.quantity.sign.base + prime, index) for index in indices]
        meanings = [Message(text, {"link": one.link, "point": each.name}) for _, one, each in rows]
        return Column(of.quantity, np.array(values), symbols, meanings=meanings)

    return Table(
        "counterweight_masses",
        MASSES,
        (
            text_column("method", METHOD, [case.name for case, *_ in rows]),
            text_column("link", LINK, [one.link for _, one, _ in rows]),
            text_column("point", Message(N_("point")), names),
            named(Masses.m, [each.mass for *_, each in rows], CARRIED),
            named(Masses.x, [each.arm.real for *_, each in rows], ARM_ALONG),
            named(Masses.y, [_settled(each.arm) for *_, each in rows], ARM_ACROSS),
        ),
    )


def _settled(arm: complex) -> float:
    return 0.0 if abs(arm.imag) <= 1e-12 * abs(arm) else arm.imag


# ---------------------------------------------------------------- substituted masses

JOINTS = (Message(N_("first joint")), Message(N_("second joint")))


def splits(found: Found) -> Table:
    rows = found.substituted.splits
    links = [one.link for one in rows]
    first, second = ([one.joints[k] for one in rows] for k in (0, 1))

    def named(of: Q, values: list[float], subs: list[str]) -> Column:
        sign = of.quantity.sign
        return Column(of.quantity, np.array(values), [Symbol(sign.base, sub, sign.sup) for sub in subs])

    def at(names: list[str]) -> list[str]:
        return [f"{link},{name}" for link, name in zip(links, names, strict=True)]

    return Table(
        "substituted_masses",
        SPLITS,
        (
            text_column("link", LINK, links),
            text_column("first", JOINTS[0], first),
            text_column("second", JOINTS[1], second),
            Column.of_each(Splits.m.quantity, np.array([one.mass for one in rows]), [*map(mass, links)]),
            Column.of_each(
                Splits.J.quantity, np.array([one.inertia for one in rows]), [*map(inertia, links)]
            ),
            named(Splits.a, [one.arms[0] for one in rows], links),
            named(Splits.b, [one.arms[1] for one in rows], links),
            named(Splits.off, [one.off for one in rows], links),
            named(Splits.m_A, [one.masses[0] for one in rows], at(first)),
            named(Splits.m_B, [one.masses[1] for one in rows], at(second)),
            named(Splits.J_rest, [one.rest for one in rows], links),
            named(Splits.m_A3, [one.dynamic[0] for one in rows], at(first)),
            named(Splits.m_B3, [one.dynamic[1] for one in rows], at(second)),
            named(Splits.m_S3, [one.dynamic[2] for one in rows], at(["S"] * len(rows))),
        ),
    )
