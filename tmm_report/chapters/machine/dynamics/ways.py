"""How the numbers of the machine in motion are found that no formula of the note defines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

import numpy as np

from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.mechanics.machine.run.motion_law import Run
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Var
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import AXIS, NAME, STATED, Input, Known, Line, Way

CHARACTER = N_("By the characteristic of the motor, or of the resistances, at the speed of the row.")
EQUATION = N_("By the equation of motion at the sample: J dω/dt = M_dr − M_res − (dJ/dφ) ω²/2.")
STEADY = N_(
    "The steady motion: the speed that repeats after a cycle. The equation of motion is solved "
    "over the cycle on pieces "
    "between the jumps of the loads, from the speed at its beginning that comes back at its end."
)
ENERGY = N_(
    "By the energy at the angle: the kinetic energy at position 0 and the work of all moments from there."
)
WORKS = N_("The integral of the moment of what acts by the angle, over the regime.")
MULTIPLIER = N_(
    "The derivative of the energy after a cycle by that before it, at the steady motion; below "
    "1 it is stable."
)
CHECK = N_(
    "The sum of all works less the change of the kinetic energy, by the largest of them; the "
    "worst of the regimes."
)
SECOND = N_(
    "dω/dt of the found motion by the integrator's own polynomial beside that of the equation of motion."
)
POTENTIAL = N_(
    "The slope of the potential energy of weights and springs beside their moment, over the cycle."
)
MEAN = N_("The time of the cycle is the integral of dφ/ω over it; the mean is its angle by it.")
POWER = N_("The work of the motor in a cycle of the steady motion by its time.")
REDUCED = N_(
    "From the equality of kinetic energies: J i² of what turns, m r² of what moves along, over "
    "the efficiency."
)
RESISTS = N_(
    "From the equality of powers: M i of what turns, F r of what moves along; the efficiency by "
    "the flow of power."
)
ARM = N_(
    "The ratio of the velocity of the mass to the speed of the main shaft: by the drum or wheel and the ratio."
)
NOMINAL = N_(
    "By the nominal data of the motor that the variant states, so that its characteristic "
    "passes through them."
)
RUBBING = N_(
    "The power of friction of all the pairs at the angle by the angular velocity of the driving link, against the "
    "rotation, and the resistances of the main shaft."
)
RUBBED = N_("The mean of the moment of friction over the cycle by the speed of the driving link.")
SHARE = N_("The ratio of the mean power of friction to that of all that drives.")
LOST = N_(
    "Of each part whose gears have an efficiency what its branch takes with the acceleration, by the flow of power, "
    "less what it takes at a constant speed and its moment of inertia by the acceleration."
)
JOINED = N_(
    "The start-up, what follows it until the speed is the steady one, cycles of the steady motion and the "
    "run-down, one after another: each by the way of its regime."
)
SUMMED = N_(
    "The work of all that acts of the kind in the regime, summed; in the steady motion by its cycles."
)
GAINED = N_("J ω²/2 at the end of the regime less that at its beginning.")
CYCLES = N_("As stated, else so many that they take a quarter of the time of all other regimes.")
DRIVES = N_("The moment of the motor on the main shaft: by the ratio and the efficiency of its gear.")
RESISTING = N_("All moments that resist, on the main shaft, summed.")
KINDS = {
    "speed": N_(
        "J is constant and the moment depends on the speed alone: t = ∫J dω/M, φ = ∫J ω dω/M, by "
        "Gauss's formula on "
        "pieces between the breaks of the characteristics."
    ),
    "angle": N_(
        "The moment depends on the angle alone: J ω²/2 = T₀ + ∫M dφ, t = ∫dφ/ω, by Gauss's formula "
        "on pieces between "
        "the jumps of the loads."
    ),
    "time": N_(
        "The moment depends on the speed and on the angle, or on the time: dφ/dt = ω, dω/dt = (M − "
        "J′ω²/2)/J, integrated "
        "step by step (LSODA; cycles in between by collocation in the angle)."
    ),
}
J = Quantity("J", Symbol("J"), "kg·m²", Message(N_("moment of inertia at the sample")))
M = Quantity("M", Symbol("M"), "N·m", Message(N_("moment of all that acts, + driving")))
OMEGA = Quantity("omega", Symbol("omega"), "rad/s", Message(N_("angular velocity of the main shaft")))
STEPS = Quantity(
    "steps", None, "", Message(N_("evaluations of the moments by the integrator; 0 of an integral"))
)
SAMPLES = Quantity("samples", None, "", Message(N_("samples of the motion")))
AGAIN = Quantity(
    "t_again",
    Symbol("t", "Σ"),
    "s",
    Message(N_("check: sum of 2Δφ/(ω + ω′) over the intervals between the samples")),
)
LACK = Quantity("lack", None, "", Message(N_("check: lack in the balance of works and kinetic energy")))


def _run(found: Found, q: Known) -> Iterator[Line]:
    """The integral of a start-up or run-down: its kind, its numbers at the ends, and two checks."""
    run = dict(found.runs).get(q.own.rpartition("_")[2])
    if run is None:
        return
    yield Message(KINDS[run.way])
    for at, mark in ((0, "0"), (-1, "1")):
        for of, values in ((OMEGA, run.omega), (J, run.inertia), (M, run.moment)):
            sign = of.sign
            yield Input(of, float(values[at]), of.unit, Symbol(sign.base, mark))
    yield Input(SAMPLES, float(len(run.t)), "", None)
    yield Input(STEPS, float(run.steps), "", None)
    yield Input(AGAIN, _again(run), "s", AGAIN.symbol)
    yield Input(LACK, run.error, "", None)


def _again(run: Run) -> float:
    ends = run.omega[1:] + run.omega[:-1]
    return float(np.sum(2 * np.diff(run.phi)[ends != 0] / ends[ends != 0]))


def _inertia(q: Known) -> Expr:
    """Of the machine on the main shaft: of all parts, and of the links of a mechanism."""
    table = q.book.tables.get("dynamics_parts")
    numbers = [table.var("J_red", k) for k in range(len(table))] if table is not None else []
    rest = float(np.ravel(q.found.supplied.inertia)[0]) - sum(float(one.number) for one in numbers)
    terms: list[Expr] = [*numbers]
    if not numbers or abs(rest) > 1e-12 * float(np.ravel(q.found.supplied.inertia)[0]):
        terms.append(Var(Symbol("J", "l"), rest, "kg·m²"))
    return _sum(terms)


def _reduced(q: Known) -> Expr:
    """J i² + m r², over the efficiency where it passes to the accelerated masses."""
    terms = [q(a) * q(b) ** 2 for a, b in (("J", "i"), ("m", "r")) if q.has(a) and q.has(b)]
    if not terms:
        raise KeyError("J")
    whole = _sum(list(terms))
    return whole / q("eta") if q.found.given.passing and q.found.supplied.passing is None else whole


def _moment(q: Known) -> Expr:
    table = q.book.tables["dynamics_parts"]
    return _sum([table.var("M_red", k) for k in range(len(table))])


def _sum(terms: list[Expr]) -> Expr:
    total = terms[0]
    for one in terms[1:]:
        total = total + one
    return total


def _assigned(q: Known) -> Expr:
    """By its formula, where the note does not print it."""
    return cast(Expr, q.found.s.formula(q.own.removeprefix("dynamics_")).expression)


def _power(q: Known) -> Expr:
    steady = q.found.steady
    return q("dynamics_works:motor.A_steady") / Var(Symbol("t", "c"), float(steady.cycle), "s")


def _resisting(q: Known) -> Expr:
    """Of all works of the steady motion but the motor's, by the angle."""
    table = q.book.tables["dynamics_works"]
    names = list(table["acting"].values)
    rows = [
        k
        for k, name in enumerate(names)
        if name not in ("motor", "sum", "gained")
        and table["A_steady"].values[k] == table["A_steady"].values[k]
    ]
    angle = Var(Symbol("Phi"), float(q.found.steady.plant.panels.period))
    return -_sum([table.var("A_steady", k) for k in rows]) / angle


def _rubbed(q: Known) -> Expr:
    return q("P_fr_corrected_mean" if q.has("P_fr_corrected_mean") else "P_fr_mean")


DRIVEN = N_("The moment of the motor at the speeds of the steady motion, where it is least and greatest.")

WAYS = (
    Way("dynamics_parts.part dynamics_works.acting", NAME),
    Way(
        "dynamics_parts.F",
        N_("The weight of the mass along its motion, and the force that is stated."),
        of="m",
    ),
    Way("dynamics_parts.J_red", REDUCED, by=_reduced, of="part J i m r eta"),
    Way("dynamics_parts.M_red", RESISTS, of="part M i F r eta"),
    Way("dynamics_parts.r", ARM, of="part i m"),
    Way("dynamics_parts.*", STATED),
    Way("dynamics_characteristics.omega", AXIS),
    Way("dynamics_characteristics.*", CHARACTER, of="omega s dynamics_M_max dynamics_omega_0"),
    Way("dynamics_cycle_table.epsilon", EQUATION, of="M_sum J J_slope omega"),
    Way("dynamics_cycle_table.omega dynamics_cycle_table.t", ENERGY, of="A dynamics_T_0 J phi"),
    Way("dynamics_cycle_table.M_lost", LOST, of="epsilon M_res"),
    Way("dynamics_cycle_table.M_fr", RUBBING, of="friction_table.P_fr friction_table.T_fr phi omega"),
    Way("dynamics_cycle_table.phi", AXIS),
    Way("dynamics_cycle_table.*", STEADY, of="phi"),
    Way("dynamics_start.t dynamics_coast.t dynamics_start_table.t dynamics_coast_table.t", AXIS),
    Way("dynamics_start*.M_lost dynamics_coast*.M_lost", LOST, of="epsilon M_res"),
    Way("dynamics_start*.epsilon dynamics_coast*.epsilon", EQUATION, of="t omega M_dr M_res"),
    Way("dynamics_start*.* dynamics_coast*.*", EQUATION, of="t phi omega M_dr M_res"),
    Way("dynamics_works.*", WORKS, of="acting"),
    Way("dynamics_joined.t", AXIS),
    Way("dynamics_joined.*", JOINED, of="t phi omega"),
    Way("dynamics_regimes.regime", NAME),
    Way("dynamics_regimes.A_*", SUMMED, of="regime t turns"),
    Way("dynamics_regimes.gained", GAINED, of="A_dr A_br A_load A_fr omega_end"),
    Way("dynamics_regimes.*", JOINED, of="regime"),
    Way("dynamics_cycles", CYCLES, of="dynamics_t_start dynamics_t_coast"),
    Way("dynamics_J", by=_inertia),
    Way("dynamics_M_parts", by=_moment),
    Way("dynamics_M_steady", by=_resisting),
    Way("dynamics_t_start dynamics_t_coast dynamics_phi_start dynamics_phi_coast", worked=_run),
    Way("dynamics_omega_start dynamics_omega_coast", worked=_run),
    Way("dynamics_turns_* dynamics_epsilon dynamics_T_steady", by=_assigned),
    Way("dynamics_P", POWER, by=_power),
    Way("dynamics_P", POWER, of="dynamics_omega_m"),
    Way("dynamics_omega_m", STEADY, of="dynamics_M_steady dynamics_J dynamics_T_cycle"),
    Way(
        "dynamics_omega_min dynamics_omega_max dynamics_delta", STEADY, of="dynamics_omega_m dynamics_T_cycle"
    ),
    Way("dynamics_M_dr_min dynamics_M_dr_max", DRIVEN, of="dynamics_omega_min dynamics_omega_max"),
    Way("dynamics_T_cycle", MEAN, of="dynamics_M_steady dynamics_J omega"),
    Way("dynamics_T_0", ENERGY, of="dynamics_omega_m dynamics_delta"),
    Way("dynamics_multiplier", MULTIPLIER, of="dynamics_omega_m"),
    Way("dynamics_balance_error", CHECK, of="dynamics_t_start dynamics_t_coast dynamics_omega_m"),
    Way("dynamics_residual", SECOND, of="dynamics_omega_m dynamics_t_start"),
    Way("dynamics_potential_error", POTENTIAL, of="dynamics_omega_m dynamics_T_0 omega"),
    Way(
        "dynamics_M_closing",
        N_("The work of the loads over the cycle by its angle, with the opposite sign."),
        of="dynamics_omega_m omega",
    ),
    Way(
        "dynamics_M_max dynamics_s_cr",
        NOMINAL,
        of="dynamics_omega_0 dynamics_M_nom dynamics_omega_nom",
        enough=True,
    ),
    Way("dynamics_a dynamics_b", NOMINAL, of="dynamics_i_motor", enough=True),
    Way("dynamics_M_dr", DRIVES, of="dynamics_M_motor dynamics_i_motor dynamics_eta_motor dynamics_epsilon"),
    Way("dynamics_M_res", RESISTING, of="dynamics_M_parts dynamics_M_res* dynamics_M_brake dynamics_epsilon"),
    Way("dynamics_P_fr", RUBBED, by=_rubbed, of="omega"),
    Way("dynamics_P_fr_share", SHARE, of="dynamics_P_fr dynamics_P"),
    Way("dynamics_*", STATED),
)
