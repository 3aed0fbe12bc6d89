"""What is given of the governor and its brake, as numbers of the results."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol


def value(key: str, symbol: Symbol, unit: str, text: str, number: float) -> Value:
    return Quantity(f"governor_{key}", symbol, unit, Message(text)).value(number)


def of_direct(found: DirectFound) -> Iterator[Value]:
    weights, given = found.weights, found.given
    geometry = given.geometry
    yield from (
        _of_arms(geometry, given.lowest) if isinstance(geometry, Arms) else _of_crank(geometry, given.lowest)
    )
    yield value("n", Symbol("n"), "", N_("number of balls"), weights.count)
    yield value("m", Symbol("m"), "kg", N_("mass of a ball"), weights.ball)
    yield value("m_0", Symbol("m", "0"), "kg", N_("mass of the sleeve with its load"), weights.sleeve)
    yield value("c", Symbol("c"), "N/m", N_("stiffness of the spring"), weights.stiffness)
    yield value("F_0", Symbol("F", "0"), "N", N_("force of the spring at the lower stop"), weights.preload)
    yield value("g", Symbol("g"), "m/s²", N_("acceleration of free fall"), weights.gravity)
    yield value("h", Symbol("h"), "m", N_("lift of the sleeve between its stops"), found.lift)
    yield value("F_fr", Symbol("F", "fr"), "N", N_("dry friction on the sleeve"), given.friction)
    yield value("k", Symbol("k"), "N·s/m", N_("coefficient of the dashpot of the sleeve"), given.damping)
    yield value(
        "q",
        Symbol("q"),
        "",
        N_("relative change of the speed for which the effort is found"),
        given.effort_for,
    )
    if given.choice is not None and given.choice.what != "spring":
        speed = given.choice.speeds[0]
        yield value(
            "omega_chosen", Symbol("omega", "g"), "rad/s", N_("speed wanted at the middle of the lift"), speed
        )


def _of_arms(arms: Arms, lowest: float) -> Iterator[Value]:
    yield value("l_1", Symbol("l", "1"), "m", N_("length of the upper arm"), arms.upper)
    yield value("l_2", Symbol("l", "2"), "m", N_("length of the lower arm"), arms.lower)
    yield value(
        "e_1", Symbol("e", "1"), "m", N_("distance of the upper pivot from the axis"), arms.upper_offset
    )
    yield value(
        "e_2", Symbol("e", "2"), "m", N_("distance of the lower pivot from the axis"), arms.lower_offset
    )
    yield value("x_0", Symbol("x", "0"), "m", N_("radius of the pin at the lower stop"), lowest)
    if arms.distance is not None:
        yield value("L", Symbol("L"), "m", N_("distance of the ball from the upper pivot"), arms.distance)
    if arms.extension is not None:
        yield value("b", Symbol("b"), "m", N_("length of the extension of the lower arm"), arms.extension)
        upright = float(np.arcsin((arms.upright_at - arms.lower_offset) / arms.lower))
        text = N_("angle of the lower arm with the axis at which the extension is upright")
        yield value("beta_0", Symbol("beta", "0"), "rad", text, upright)


def _of_crank(crank: BellCrank, lowest: float) -> Iterator[Value]:
    yield value("a", Symbol("a"), "m", N_("length of the ball arm"), crank.ball_arm)
    yield value("b", Symbol("b"), "m", N_("length of the sleeve arm"), crank.sleeve_arm)
    if crank.fulcrum is not None:
        yield value("r_0", Symbol("r", "0"), "m", N_("distance of the fulcrum from the axis"), crank.fulcrum)
    yield value("r_min", Symbol("r", "min"), "m", N_("radius of a ball at the lower stop"), lowest)


def of_brake(found: BrakeFound) -> Iterator[Value]:
    shoes, given = found.given.brake, found.given
    yield value("brake_n", Symbol("n"), "", N_("number of shoes"), shoes.count)
    yield value("brake_m", Symbol("m"), "kg", N_("mass of a shoe"), shoes.mass)
    yield value(
        "brake_rho", Symbol("rho", "0"), "m", N_("radius of the mass centre of a shoe at rest"), shoes.radius
    )
    yield value("brake_gap", Symbol("s"), "m", N_("gap between shoe and drum at rest"), shoes.gap)
    yield value(
        "brake_rho_contact",
        Symbol("rho"),
        "m",
        N_("radius of the mass centre of a shoe at contact"),
        shoes.at_contact,
    )
    yield value("brake_R", Symbol("R"), "m", N_("inner radius of the drum"), shoes.drum)
    yield value(
        "brake_f", Symbol("f"), "", N_("coefficient of friction of a shoe on the drum"), shoes.friction
    )
    yield value("brake_c", Symbol("c"), "N/m", N_("stiffness of the spring of a shoe"), shoes.stiffness)
    yield value(
        "brake_F_0", Symbol("F", "0"), "N", N_("force of the spring of a shoe at rest"), shoes.preload
    )
    yield value("brake_F", Symbol("F"), "N", N_("force of the spring of a shoe at contact"), shoes.spring)
    yield value("brake_M", Symbol("M"), "N·m", N_("moment that drives the shaft of the brake"), given.moment)
    if given.inertia:
        yield value(
            "brake_J", Symbol("J"), "kg·m²", N_("moment of inertia on the shaft of the brake"), given.inertia
        )
