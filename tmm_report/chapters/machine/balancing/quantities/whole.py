"""The numbers of the mechanism balanced on its foundation: shaking, counterweights, substituted masses, harmonics."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.balancing.quantities import slider_cranks as sliders
from tmm_report.chapters.machine.balancing.quantities import weights
from tmm_report.chapters.machine.balancing.solve.cases import Case, Shaken
from tmm_report.chapters.machine.balancing.solve.counterweights import half_turn
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

SHAKING = Message(N_("shaking force and shaking moment of the mechanism as it is"))
BALANCED = Message(N_("shaking force and shaking moment left by each way of balancing, by its number"))
CASES = Message(N_("ways of balancing and what each leaves over the cycle"))
HARMONICS = Message(
    N_("harmonics of the shaking force: vectors that turn with the driving link and against it")
)
ROTORS = Message(N_("counter-rotating weights against the first and second harmonics of the shaking force"))

RMS = NP_("index", "rms")  # root mean square
FORCE = Quantity("F_shake", Symbol("F", "Sigma"), "N", Message(N_("shaking force")))
MOMENT = Quantity("M_shake", Symbol("M", "Sigma"), "N·m", Message(N_("shaking moment")))
NUMBER = Quantity("case", None, "", Message(N_("number of the way of balancing, 0: as it is")))
FORCE_MAX = Quantity("F_max", Symbol("F", "max"), "N", Message(N_("greatest shaking force")))
FORCE_AT = Quantity("F_max_at", Symbol("phi"), "deg", Message(N_("angle of turn at which it is reached")))
LEFT = Quantity(
    "left", Symbol("delta"), "", Message(N_("greatest shaking force by that of the mechanism as it is"))
)
FORCE_RMS = Quantity("F_rms", Symbol("F", RMS), "N", Message(N_("root mean square of the shaking force")))
MOMENT_MAX = Quantity("M_max", Symbol("M", "max"), "N·m", Message(N_("greatest shaking moment")))
MOMENT_RMS = Quantity("M_rms", Symbol("M", RMS), "N·m", Message(N_("root mean square of the shaking moment")))
TOTAL = Quantity("m_total", Symbol("m", "Sigma"), "kg", Message(N_("mass of all the counterweights")))
MISS = Quantity(
    "balancing_disagreement",
    None,
    "",
    Message(N_("worst relative disagreement of the shaking with the reactions of the frame")),
)
PART = Quantity("k_part", Symbol("k"), "", Message(N_("balanced part of the reciprocating masses")))
TAIL = Quantity(
    "shaking_tail", None, "", Message(N_("harmonics of the shaking force that its samples miss, relative"))
)
CENTRE_X = Quantity(
    "seen_x",
    Symbol("U", "C", "x"),
    "kg·m",
    Message(N_("centre of the smallest circle, along the driving link")),
)
CENTRE_Y = Quantity(
    "seen_y",
    Symbol("U", "C", "y"),
    "kg·m",
    Message(N_("centre of the smallest circle, across the driving link")),
)
RADIUS = Quantity("seen_radius", Symbol("R"), "kg·m", Message(N_("radius of the smallest circle")))
MEAN_X = Quantity(
    "seen_mean_x",
    Symbol("U", "D", "x"),
    "kg·m",
    Message(N_("mean of the force seen by the driving link, along it")),
)
MEAN_Y = Quantity(
    "seen_mean_y",
    Symbol("U", "D", "y"),
    "kg·m",
    Message(N_("mean of the force seen by the driving link, across it")),
)


def force(number: int) -> Quantity:
    """What a way of balancing leaves of the shaking force."""
    meaning = Message(N_("shaking force left by way %(n)s"), {"n": number})
    return Quantity(f"F_shake_{number}", Symbol("F", f"Sigma{number}"), "N", meaning)


def moment(number: int) -> Quantity:
    meaning = Message(N_("shaking moment with way %(n)s"), {"n": number})
    return Quantity(f"M_shake_{number}", Symbol("M", f"Sigma{number}"), "N·m", meaning)


@tabulated
def tables(found: Found) -> Iterator[Table]:
    sets = (("table", found.kinematics.turned), ("diagram", found.kinematics.diagram_turned))
    for name, turned in sets:
        of: Shaken = getattr(found.original, name)
        shaken = (*FORCE.vector(of.force), MOMENT.column(of.moment))
        yield Table(f"shaking_{name}", SHAKING, (*where(turned), *shaken))
        if found.cases:
            left = (
                column for k, case in enumerate(found.cases, 1) for column in _left(k, getattr(case, name))
            )
            yield Table(f"balanced_{name}", BALANCED, (*where(turned), *left))
    yield _cases(found.every)
    yield from weights.counterweights(found.cases)
    if found.substituted.splits:
        yield weights.splits(found)
    yield _harmonics(found)
    yield _rotors(found)
    yield from sliders.tables(found)


def _left(number: int, of: Shaken) -> Iterator[Column]:
    yield from force(number).vector(of.force)
    yield moment(number).column(of.moment)


def _cases(every: Sequence[Case]) -> Table:
    peaks = [case.force_max for case in every]
    return Table(
        "balancing_cases",
        CASES,
        (
            NUMBER.column(list(range(len(every)))),
            text_column("method", weights.METHOD, [case.name for case in every]),
            FORCE_MAX.column(np.array([peak.value for peak in peaks])),
            FORCE_AT.column(np.array([math.degrees(peak.turned) for peak in peaks])),
            LEFT.column(np.array([peak.value / peaks[0].value for peak in peaks])),
            FORCE_RMS.column(np.array([case.force_rms for case in every])),
            MOMENT_MAX.column(np.array([case.moment_max.value for case in every])),
            MOMENT_RMS.column(np.array([case.moment_rms for case in every])),
            TOTAL.column(np.array([case.mass for case in every])),
        ),
    )


# ---------------------------------------------------------------- harmonics of the force

ORDER = Quantity("order", Symbol("k"), "", Message(N_("order: turns in a turn of the driving link")))
FORWARD = Quantity(
    "F_with", Symbol("F", "k"), "N", Message(N_("force that turns k times with the driving link"))
)
FORWARD_AT = Quantity(
    "alpha_with", Symbol("alpha", "k"), "deg", Message(N_("its angle with the x axis at position 0"))
)
BACKWARD = Quantity(
    "F_against", Symbol("F", "-k"), "N", Message(N_("force that turns k times against the driving link"))
)
BACKWARD_AT = Quantity(
    "alpha_against", Symbol("alpha", "-k"), "deg", Message(N_("its angle with the x axis at position 0"))
)


def _harmonics(found: Found) -> Table:
    highest = len(found.harmonics) // 2
    forward, backward = found.harmonics[highest + 1 :], found.harmonics[:highest][::-1]
    size = np.abs(found.harmonics).max()
    parts = ((FORWARD, FORWARD_AT, forward), (BACKWARD, BACKWARD_AT, backward))
    columns = chain.from_iterable(
        (of.column(_sizes(values, size)), at.column(_angles(values, size))) for of, at, values in parts
    )
    return Table("shaking_harmonics", HARMONICS, (ORDER.column(list(range(1, highest + 1))), *columns))


def _sizes(values: np.ndarray, size: float) -> np.ndarray:
    found = np.abs(values)
    return np.where(found <= 1e-11 * size, 0.0, found)


def _angles(values: np.ndarray, size: float) -> np.ndarray:
    """Degrees, −180 … 180; none where there is no force."""
    return np.where(np.abs(values) <= 1e-11 * size, np.nan, np.degrees(half_turn(np.angle(values))))


PRODUCT = Quantity("mr", Symbol("U"), "kg·m", Message(N_("mass by radius of a rotor")))
AT_ZERO = Quantity(
    "alpha", Symbol("alpha"), "deg", Message(N_("angle of its mass from the x axis at position 0"))
)
ROTOR_RADIUS = Quantity("r", Symbol("r"), "m", Message(N_("radius of the mass of a rotor")))
ROTOR_MASS = Quantity("m", Symbol("m"), "kg", Message(N_("mass of a rotor")))


def _rotors(found: Found) -> Table:
    rows, asked = found.rotors, found.given.radii is not None
    signs = [str(one.order) for one in rows]

    def named(of: Quantity, values: list[float], base: str) -> Column:
        return Column(of, np.array(values), [Symbol(base, sign) for sign in signs])

    return Table(
        "lanchester_rotors",
        ROTORS,
        (
            Quantity("order", None, "", ORDER.meaning).column([one.order for one in rows]),
            named(PRODUCT, [one.moment for one in rows], "U"),
            named(AT_ZERO, [math.degrees(one.angle) if one.moment else math.nan for one in rows], "alpha"),
            named(ROTOR_RADIUS, [one.radius if asked else math.nan for one in rows], "r"),
            named(ROTOR_MASS, [one.mass if asked else math.nan for one in rows], "m"),
        ),
    )


# ---------------------------------------------------------------- single numbers


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield PART.value(found.given.part)
    yield MISS.value(found.check)
    yield TAIL.value(found.tail)
    centre, radius = found.circle
    mean = complex(found.seen.mean())
    size = float(np.abs(found.seen).max())
    for of, number in (
        (CENTRE_X, centre.real), (CENTRE_Y, centre.imag), (MEAN_X, mean.real), (MEAN_Y, mean.imag)
    ):  # fmt: skip
        yield of.value(0.0 if abs(number) <= 1e-10 * size else number)
    yield RADIUS.value(radius)
    yield from sliders.values(found)
