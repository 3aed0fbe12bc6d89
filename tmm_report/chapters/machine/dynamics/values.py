"""The single numbers of the machine in motion with their symbols, units and meanings."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.lever.moving import friction_rows
from tmm_report.chapters.machine.dynamics.plant import MOTOR
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.chapters.machine.dynamics.terms import (
    ACCELERATION,
    BRAKING,
    CR,
    DR,
    DRIVING,
    MEAN,
    OWN,
    RES,
    RESISTING,
    RUN_DOWN,
    RUN_UP,
)
from tmm_report.mechanics.calculus.laws import Constant
from tmm_report.mechanics.machine.characteristics import Kloss, Linear, Power, Series
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

# key, symbol (None of what is never written as one), unit, meaning, number, angle at which it is, rad
Row = tuple[str, Symbol | None, str, str, float] | tuple[str, Symbol | None, str, str, float, float]


@tabulated
def values(found: Found) -> Iterator[Value]:
    """All of them; every key begins with "dynamics_"."""
    for rows in (_reduced, _motor, _resistances, _friction, _steady, _energies, _uniform, _runs, _checks):
        for key, symbol, unit, meaning, number, *at in rows(found):
            quantity = Quantity(f"dynamics_{key}", symbol, unit, Message(meaning))
            yield quantity.value(number, at[0] if at else None)


def _reduced(found: Found) -> Iterator[Row]:
    whole = found.whole
    if whole.parts:
        on = N_("moment of inertia of the parts on the main shaft")
        yield "J_parts", Symbol("J", "0"), "kg·m²", on, whole.added
        resisting = N_("resisting moment of the parts on the main shaft")
        yield "M_parts", Symbol("M", "0"), "N·m", resisting, sum(one.moment for one in whole.parts)
    if found.given.speed is not None:
        yield "omega_given", Symbol("omega", "1"), "rad/s", N_("speed of the main shaft"), found.given.speed


def _motor(found: Found) -> Iterator[Row]:
    motor = found.given.motor
    if motor is None:
        if found.whole.balanced is not None:
            closing = N_("constant moment on the main shaft that closes the cycle")
            yield "M_closing", Symbol("M", DR), "N·m", closing, found.whole.balanced
        return
    if motor.geared:
        yield (
            "i_motor",
            Symbol("i", DR),
            "",
            N_("ratio of the speed of the motor to that of the main shaft"),
            motor.ratio,
        )
        yield "eta_motor", Symbol("eta", DR), "", N_("efficiency of the gear of the motor"), motor.efficiency
    match motor.own:
        case Constant(moment):
            symbol = Symbol("M", OWN if motor.geared else DR)
            yield "M_motor", symbol, "N·m", N_("constant moment of the motor"), moment
        case Linear(stall, no_load):
            yield "M_stall", Symbol("M", RUN_UP), "N·m", N_("moment of the motor at rest"), stall
            yield "omega_0", Symbol("omega", "0"), "rad/s", N_("speed of the motor without a load"), no_load
        case Series(a, b):
            yield "a", Symbol("a"), "N·m/s²", N_("first constant of the series-wound motor"), a
            yield "b", Symbol("b"), "rad/s", N_("second constant of the series-wound motor"), b
        case Kloss(synchronous, greatest, critical, stator):
            yield "omega_0", Symbol("omega", "0"), "rad/s", N_("synchronous speed of the motor"), synchronous
            yield "M_max", Symbol("M", "max"), "N·m", N_("greatest moment of the motor"), greatest
            yield "s_cr", Symbol("s", CR), "", N_("critical slip, at which it is reached"), critical
            if stator:
                yield "a", Symbol("a"), "", N_("resistance of the stator by that of the rotor"), stator


def _resistances(found: Found) -> Iterator[Row]:
    for k, one in enumerate(found.given.resistances, 1):
        if isinstance(one.law, Constant):
            text = N_("constant moment of a resistance")
            yield f"M_res{k}", Symbol("M", f"{RES},{k}"), "N·m", text, one.law.amount
        elif isinstance(one.law, Power) and one.law.exponent == 1:
            text = N_("coefficient of a viscous resistance")
            yield f"c_res{k}", Symbol("c", str(k)), "N·m·s/rad", text, one.law.moment / one.law.speed
        elif isinstance(one.law, Power):
            text = N_("moment of a fan at its stated speed")
            yield f"M_res{k}", Symbol("M", f"{RES},{k}"), "N·m", text, one.law.moment
            yield (
                f"omega_res{k}",
                Symbol("omega", str(k)),
                "rad/s",
                N_("stated speed of a fan"),
                one.law.speed,
            )
    if found.given.coast is not None and found.given.coast.brake:
        yield (
            "M_brake",
            Symbol("M", BRAKING),
            "N·m",
            N_("moment of the brake on the main shaft"),
            found.given.coast.brake,
        )


def _friction(found: Found) -> Iterator[Row]:
    return friction_rows(found.whole.machine)


def _steady(found: Found) -> Iterator[Row]:
    steady = found.steady
    if steady is None:
        return
    mean = N_("mean angular velocity of the main shaft in steady motion")
    yield "omega_m", Symbol("omega", MEAN), "rad/s", mean, steady.mean
    if not found.even:
        (low, at_low), (high, at_high) = steady.extremes
        yield (
            "omega_min",
            Symbol("omega", "min"),
            "rad/s",
            N_("least angular velocity in steady motion"),
            low,
            at_low,
        )
        greatest = N_("greatest angular velocity in steady motion")
        yield "omega_max", Symbol("omega", "max"), "rad/s", greatest, high, at_high
        yield (
            "delta",
            Symbol("delta"),
            "",
            N_("coefficient of non-uniformity of the steady motion"),
            steady.delta,
        )
        yield "T_cycle", Symbol("t", "c"), "s", N_("time of a cycle of the steady motion"), steady.cycle
    if found.by_speed:
        text = N_("part of a disturbance of the kinetic energy that is left after a cycle")
        yield "multiplier", Symbol("mu"), "", text, steady.multiplier
    driving = steady.works.get(MOTOR)
    if driving is not None:
        power = N_("mean power on the main shaft in steady motion")
        yield "P", Symbol("P"), "W", power, driving / steady.cycle
    if found.even:
        yield "M_steady", Symbol("M", RES), "N·m", N_("resisting moment in steady motion"), _resisting(found)


def _resisting(found: Found) -> float:
    if found.steady is None:
        return 0.0
    works = [work for key, work in found.steady.works.items() if key != MOTOR]
    return -sum(works) / found.steady.plant.panels.period


def _energies(found: Found) -> Iterator[Row]:
    """At position 0, from where the energy is counted, or of the even motion."""
    steady, plant = found.steady, found.supplied
    if plant.even:
        J = float(plant.inertia.flat[0])
        yield "J", Symbol("J"), "kg·m²", N_("moment of inertia of the machine on the main shaft"), J
        if steady is not None:
            text = N_("kinetic energy of the machine in steady motion")
            yield "T_steady", Symbol("T"), "J", text, J * steady.mean**2 / 2
    elif steady is not None:
        zero = np.zeros(1)
        energy = float(plant.panels.at(plant.inertia, zero)[0] * found.omega(zero)[0] ** 2 / 2)
        yield "T_0", Symbol("T", "0"), "J", N_("kinetic energy of the machine at position 0"), energy


def _uniform(found: Found) -> Iterator[Row]:
    """Of constant moments and a constant moment of inertia, where no regime is asked for."""
    if not found.uniformly:
        return
    acting = found.supplied.acting
    driving = sum((float(one.values.flat[0]) for one in acting if one.key == MOTOR), 0.0)
    net = found.supplied.mean_moment
    yield "M_dr", DRIVING.sign, "N·m", N_("driving moment on the main shaft"), driving
    yield "M_res", RESISTING.sign, "N·m", N_("resisting moment on the main shaft"), driving - net
    inertia = float(found.supplied.inertia.flat[0])
    yield "epsilon", ACCELERATION.sign, "rad/s²", N_("angular acceleration of the main shaft"), net / inertia


TEXTS = {
    "start": (N_("time of the start-up"), N_("angle turned in the start-up"), N_("speed after the start-up")),
    "coast": (N_("time of the run-down"), N_("angle turned in the run-down"), N_("speed after the run-down")),
}


def _runs(found: Found) -> Iterator[Row]:
    for name, run in found.runs:
        time, angle, speed = TEXTS[name]
        word = RUN_UP if name == "start" else RUN_DOWN
        yield f"t_{name}", Symbol("t", word), "s", time, float(run.t[-1])
        turned = float(run.phi[-1] - run.phi[0])
        yield f"phi_{name}", Symbol("phi", word), "rad", angle, turned
        yield f"turns_{name}", Symbol("n", word), "", N_("turns of the main shaft"), turned / (2 * math.pi)
        yield f"omega_{name}", Symbol("omega", word), "rad/s", speed, float(run.omega[-1])
        if name == "start" and found.given.start is not None:
            yield (
                "omega_begin",
                Symbol("omega", "b"),
                "rad/s",
                N_("speed at the beginning of the start-up"),
                float(run.omega[0]),
            )
            if found.given.start.within and found.steady is not None:
                text = N_("part of the steady speed that may be lacking after the start-up")
                yield "within", None, "", text, found.given.start.within


def _checks(found: Found) -> Iterator[Row]:
    errors = [run.error for _, run in found.runs]
    residuals = [run.residual for _, run in found.runs if run.rates is not None]
    if found.steady is not None:
        works = found.steady.works.values()
        errors.append(abs(sum(works)) / (max(map(abs, works), default=0.0) or 1.0))
        if not found.even:
            residuals.append(found.steady.residual)
    if errors:
        text = N_("worst relative lack in the balance of works and kinetic energy")
        yield "balance_error", None, "", text, max(errors)
    if residuals:
        text = N_("worst relative disagreement of the found angular acceleration with the equation of motion")
        yield "residual", None, "", text, max(residuals)
    if not math.isnan(found.conservative):
        text = N_(
            "worst relative disagreement of the moment of weights and springs with the slope of their potential"
        )
        yield "potential_error", None, "", text, found.conservative
