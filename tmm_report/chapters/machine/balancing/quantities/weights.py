"""The numbers of counterweights and of substituted masses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.machine.balancing.solve.cases import Case, Placed
from tmm_report.chapters.machine.balancing.solve.substituted_masses import Carried
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol

WEIGHTS = Message(N_("counterweights of each way of balancing"))
MASSES = Message(N_("masses that a counterweight meets, with their arms"))
SPLITS = Message(N_("masses of the floating links substituted into their joints"))
METHOD = Message(N_("way of balancing"))
LINK = Message(N_("link"))

# ---------------------------------------------------------------- counterweights

X_MOMENT = Quantity(
    "U_x", Symbol("U", "", "x"), "kg·m", Message(N_("static moment of the counterweight along the link"))
)
Y_MOMENT = Quantity(
    "U_y", Symbol("U", "", "y"), "kg·m", Message(N_("static moment of the counterweight across the link"))
)
SIZE = Quantity("U", Symbol("U"), "kg·m", Message(N_("static moment of the counterweight")))
ANGLE = Quantity(
    "beta", Symbol("beta"), "deg", Message(N_("angle of the counterweight from the line of the link"))
)
DISTANCE = Quantity(
    "rho", Symbol("rho"), "m", Message(N_("distance of the counterweight from the pivot of the link"))
)
MASS = Quantity("m_c", Symbol("m", "c"), "kg", Message(N_("mass of the counterweight")))
OF_MASS = Quantity("m", Symbol("m"), "kg", Message(N_("mass on the link")))
ARM_X = Quantity("x", Symbol("x"), "m", Message(N_("arm of the mass along the link")))
ARM_Y = Quantity("y", Symbol("y"), "m", Message(N_("arm of the mass across the link")))


def placed(cases: Sequence[Case]) -> list[tuple[Case, Placed]]:
    """Every counterweight in the order of the table."""
    return [(case, one) for case in cases for one in case.placed]


def met(cases: Sequence[Case]) -> list[tuple[Case, Placed, Carried]]:
    """Every mass that a counterweight meets, in the order of the table."""
    rows = placed(cases)
    return [(case, one, mass) for case, one in rows if one.carried for mass in one.carried.carried]


def counterweights(cases: Sequence[Case]) -> Iterator[Table]:
    """The counterweights, and the masses that they meet; nothing where there are none."""
    if rows := placed(cases):
        yield _weights(rows)
    if masses := met(cases):
        yield _masses(masses)


def _weights(rows: Sequence[tuple[Case, Placed]]) -> Table:
    links = [one.link for _, one in rows]
    moments = np.array([one.moment for _, one in rows])

    def named(of: Quantity, values: Sequence[float], base: str, sub: str = "", sup: str = "") -> Column:
        return Column(of, np.array(values), [Symbol(base, f"{sub}{link}", sup) for link in links])

    return Table(
        "counterweights",
        WEIGHTS,
        (
            text_column("method", METHOD, [case.name for case, _ in rows]),
            text_column("link", LINK, links),
            named(X_MOMENT, list(moments.real), "U", sup="x"),
            named(Y_MOMENT, list(moments.imag), "U", sup="y"),
            named(SIZE, list(np.abs(moments)), "U"),
            named(ANGLE, list(np.degrees(np.angle(moments)) % 360), "beta"),
            named(DISTANCE, [one.distance for _, one in rows], "rho"),
            named(MASS, [one.mass for _, one in rows], "m", "c"),
        ),
    )


def _masses(rows: Sequence[tuple[Case, Placed, Carried]]) -> Table:
    names = [mass.name for *_, mass in rows]

    def named(of: Quantity, values: Sequence[float]) -> Column:
        return Column(of, np.array(values), [Symbol(of.sign.base, name) for name in names])

    return Table(
        "counterweight_masses",
        MASSES,
        (
            text_column("method", METHOD, [case.name for case, *_ in rows]),
            text_column("link", LINK, [one.link for _, one, _ in rows]),
            text_column("point", Message(N_("point")), names),
            named(OF_MASS, [mass.mass for *_, mass in rows]),
            named(ARM_X, [mass.arm.real for *_, mass in rows]),
            named(ARM_Y, [_settled(mass.arm) for *_, mass in rows]),
        ),
    )


def _settled(arm: complex) -> float:
    return 0.0 if abs(arm.imag) <= 1e-12 * abs(arm) else arm.imag


# ---------------------------------------------------------------- substituted masses

JOINTS = (Message(N_("first joint")), Message(N_("second joint")))
LINK_MASS = Quantity("m", Symbol("m"), "kg", Message(N_("mass of the link")))
LINK_INERTIA = Quantity(
    "J", Symbol("J"), "kg·m²", Message(N_("moment of inertia of the link about its mass centre"))
)
ARM_A = Quantity(
    "a",
    Symbol("a"),
    "m",
    Message(N_("from the first joint to the mass centre, along the line of the joints")),
)
ARM_B = Quantity(
    "b",
    Symbol("b"),
    "m",
    Message(N_("from the mass centre to the second joint, along the line of the joints")),
)
OFF = Quantity(
    "off", Symbol("h"), "m", Message(N_("distance of the mass centre from the line of the joints"))
)
AT_A = Quantity("m_A", Symbol("m", "A"), "kg", Message(N_("mass at the first joint")))
AT_B = Quantity("m_B", Symbol("m", "B"), "kg", Message(N_("mass at the second joint")))
REST = Quantity(
    "J_rest", Symbol("DeltaJ"), "kg·m²", Message(N_("what two masses lack of the moment of inertia"))
)
THREE_A = Quantity(
    "m_A3",
    Symbol("m", "A", "d"),
    "kg",
    Message(N_("mass at the first joint of three that keep the moment of inertia")),
)
THREE_B = Quantity(
    "m_B3",
    Symbol("m", "B", "d"),
    "kg",
    Message(N_("mass at the second joint of three that keep the moment of inertia")),
)
THREE_S = Quantity(
    "m_S3",
    Symbol("m", "S", "d"),
    "kg",
    Message(N_("mass at the mass centre of three that keep the moment of inertia")),
)


def splits(found: Found) -> Table:
    rows = found.substituted.splits
    links = [one.link for one in rows]
    first, second = ([one.joints[k] for one in rows] for k in (0, 1))

    def named(of: Quantity, values: list[float], base: str, subs: list[str], sup: str = "") -> Column:
        return Column(of, np.array(values), [Symbol(base, sub, sup) for sub in subs])

    def at(names: list[str]) -> list[str]:
        return [f"{link},{name}" for link, name in zip(links, names, strict=True)]

    return Table(
        "substituted_masses",
        SPLITS,
        (
            text_column("link", LINK, links),
            text_column("first", JOINTS[0], first),
            text_column("second", JOINTS[1], second),
            named(LINK_MASS, [one.mass for one in rows], "m", links),
            named(LINK_INERTIA, [one.inertia for one in rows], "J", links),
            named(ARM_A, [one.arms[0] for one in rows], "a", links),
            named(ARM_B, [one.arms[1] for one in rows], "b", links),
            named(OFF, [one.off for one in rows], "h", links),
            named(AT_A, [one.masses[0] for one in rows], "m", at(first)),
            named(AT_B, [one.masses[1] for one in rows], "m", at(second)),
            named(REST, [one.rest for one in rows], "DeltaJ", links),
            named(THREE_A, [one.dynamic[0] for one in rows], "m", at(first), "d"),
            named(THREE_B, [one.dynamic[1] for one in rows], "m", at(second), "d"),
            named(THREE_S, [one.dynamic[2] for one in rows], "m", at(["S"] * len(rows)), "d"),
        ),
    )
