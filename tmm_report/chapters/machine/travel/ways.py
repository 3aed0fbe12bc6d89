"""How the numbers of a machine whose main link slides are found that no formula of the note defines."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.travel.solve import Found
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, expr
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import AXIS, NAME, STATED, Input, Known, Line, Way

LAW = N_("By the laws of the forces at the place, the time and the speed of the row, summed.")
EQUATION = N_("By the equation of motion at the row: m dv/dt = F − (v²/2) dm/dx.")
ENERGY = N_("By the work of all forces from the beginning and the reduced mass of the row.")
REDUCED = N_("From the equality of kinetic energies, by the motion of the links at the place of the row.")
SLOPE = N_(
    "By the accelerations of the links in a uniform motion of the main link; no differences are taken."
)
FOLLOWS = N_("By the triangle that the link follows the stroke by.")
WORKS = N_("The integral of the force by the way.")
GAINED = N_("The kinetic energy at the end less that at the beginning: of the reduced mass and the speed.")
CHECK = N_("The sum of all works less the change of the kinetic energy, by the largest of them.")
SECOND = N_(
    "dv/dt of the found motion by the integrator's own polynomial beside that of the equation of motion."
)
FASTEST = N_("The greatest of the samples of the motion.")
KINDS = {
    "speed": N_(
        "The mass is constant and the force depends on the speed alone: t = ∫m dv/F, x = ∫m v dv/F, by Gauss's formula "
        "on pieces between the breaks of the laws."
    ),
    "angle": N_(
        "The force depends on the place alone: m v²/2 = T₀ + ∫F dx, t = ∫dx/v, by Gauss's formula on pieces between "
        "the breaks of the forces."
    ),
    "time": N_(
        "The force depends on the speed and on the place, or on the time: dx/dt = v, dv/dt = (F − m′v²/2)/m, "
        "integrated step by step (LSODA)."
    ),
}
MASS = Quantity("m", Symbol("m"), "kg", Message(N_("reduced mass at the sample")))
SPEED = Quantity("v", Symbol("v"), "m/s", Message(N_("speed of the main link")))
AGAIN = Quantity(
    "t_again",
    Symbol("t", "Σ"),
    "s",
    Message(N_("check: sum of 2Δx/(v + v′) over the intervals between the samples")),
)


def _run(found: Found, q: Known) -> Iterator[Line]:
    """The integral of the motion: its kind, its numbers at the ends, and a check of the time."""
    yield Message(KINDS[found.motion.way])
    for at, mark in ((0, "0"), (-1, "1")):
        for of, values in ((SPEED, found.v), (MASS, found.mass)):
            yield Input(of, float(values[at]), of.unit, Symbol(of.sign.base, mark))
    ends = found.v[1:] + found.v[:-1]
    again = found.t[0] + float(np.sum(2 * np.diff(found.x)[ends != 0] / ends[ends != 0]))
    yield Input(AGAIN, again, "s", AGAIN.symbol)


def _own(q: Known) -> Expr:
    return expr(q("J") / q("r") ** 2)


def _assigned(q: Known) -> Expr:
    """By its formula, where the note does not print it."""
    return expr(q.found.s.formula(q.own.removeprefix("travel_")).expression)


WAYS = (
    Way("travel_wheels.wheel travel_springs.spring travel_works.acting", NAME),
    Way("travel_wheels.m", by=_own),
    Way("travel_wheels.* travel_springs.*", STATED),
    Way("travel_motion*.t travel_motion*.s", AXIS),
    Way("travel_motion*.F_*", LAW, of="t s v"),
    Way("travel_motion*.m_red", REDUCED, of="s"),
    Way("travel_motion*.m_red_slope", SLOPE, of="s m_red"),
    Way("travel_motion*.F", LAW, of="F_dr F_red F_res"),
    Way("travel_motion*.A", ENERGY, of="s F travel_v_begin travel_m_red m_red"),
    Way("travel_motion*.v", ENERGY, of="s travel_v_begin travel_m_red m_red"),  # the forces may go by it
    Way("travel_motion*.a", EQUATION, of="F v m_red m_red_slope travel_m_red"),
    Way("travel_motion*.omega", FOLLOWS, of="s v"),
    Way("travel_motion*.I_red", REDUCED, of="m_red v omega"),
    Way("travel_works.A", WORKS, of="acting"),
    Way("travel_wheels", N_("The masses of all the wheels on the main link, summed."), of="travel_wheels.m"),
    Way("travel_length travel_a travel_v_end travel_t_end", by=_assigned),
    Way("travel_v_end travel_t_end travel_way", worked=_run),
    Way("travel_v_max", FASTEST, of="travel_v_end"),
    Way("travel_m_red travel_m_begin", REDUCED, of="travel_mass travel_wheels travel_begin"),
    Way("travel_force", LAW, of="travel_a"),
    Way("travel_gained", GAINED, of="travel_v_begin travel_v_end"),
    Way("travel_balance_error", CHECK, of="travel_gained"),
    Way("travel_residual", SECOND, of="travel_t_end"),
    Way("travel_*", STATED),
)
