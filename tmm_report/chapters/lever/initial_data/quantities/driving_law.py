"""The law by which the driving link moves, in numbers and formulas: what is stated, and φ, ω and ε by the time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from tmm_report.mechanics.calculus.motion_laws import Harmonic, MotionLaw, Phased, Polynomial
from tmm_report.mechanics.lever.mechanism import Driver
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Negative, Var, cos, expr, sin
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol

TIME = Quantity(
    "law_time", Symbol("T"), "s", Message(N_("time in which the law of the driving link goes once"))
)
MIDDLE = Quantity(
    "law_angle",
    Symbol("phi", "m"),
    "rad",
    Message(N_("angle of the driving link about which its law goes")),
    "deg",
)
START = Quantity(
    "law_angle",
    Symbol("phi", "0"),
    "rad",
    Message(N_("angle of the driving link at the beginning of its law")),
    "deg",
)
MEAN_SPEED = Quantity(
    "law_speed", Symbol("omega", "m"), "rad/s", Message(N_("mean angular velocity of the driving link"))
)
FIRST_SPEED = Quantity(
    "law_speed",
    Symbol("omega", "0"),
    "rad/s",
    Message(N_("angular velocity of the driving link at the beginning of its law")),
)
AMPLITUDE = Quantity(
    "law_amplitude",
    Symbol("Phi"),
    "rad",
    Message(N_("amplitude of the harmonic of the driving link's angle")),
    "deg",
)
FREQUENCY = Quantity(
    "law_frequency",
    Symbol("Omega"),
    "rad/s",
    Message(N_("angular frequency of the harmonic of the driving link")),
)
LEAD = Quantity(
    "law_phase",
    Symbol("alpha"),
    "rad",
    Message(N_("phase of the harmonic of the driving link in position 0")),
    "deg",
)
ACCELERATION = Quantity(
    "law_acceleration",
    Symbol("epsilon"),
    "rad/s²",
    Message(N_("stated angular acceleration of the driving link")),
)
SWING = Quantity(
    "law_swing",
    Symbol("psi"),
    "rad",
    Message(N_("angle by which the driving link swings by its phases")),
    "deg",
)
POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"


def values(driver: Driver) -> Iterator[Value]:
    """What the variant states of the law; of a table nothing but its time."""
    law = driver.law
    if law is None:
        return
    yield TIME.value(law.period)
    match law:
        case Harmonic():
            yield MIDDLE.value(law.start)
            if law.speed:
                yield MEAN_SPEED.value(law.speed)
            yield AMPLITUDE.value(law.amplitude)
            yield FREQUENCY.value(law.frequency)
            if law.lead:
                yield LEAD.value(law.lead)
        case Polynomial(coefficients=(start, *others)):
            yield START.value(start)
            if law.uniform:
                yield from _accelerated(*others)
            else:
                yield from (_factor(k).value(c) for k, c in enumerate(others, 1) if c)
        case Phased():
            yield START.value(law.start)
            yield SWING.value(law.lifts.lift)


def _accelerated(speed: float, half: float) -> Iterator[Value]:
    if speed:
        yield FIRST_SPEED.value(speed)
    yield ACCELERATION.value(2 * half)


def _factor(power: int) -> Quantity:
    """Of t, t², … in a polynomial."""
    unit = "rad/s" + "".join(POWERS[int(digit)] for digit in str(power)) if power > 1 else "rad/s"
    meaning = Message(N_("factor of power %(power)s of the time in the driving link's law"), {"power": power})
    return Quantity(f"law_c{power}", Symbol("c", str(power)), unit, meaning)


class Motion(NamedTuple):
    """Angle, angular velocity and angular acceleration by the time."""

    angle: Expr
    velocity: Expr
    acceleration: Expr


def motion(law: MotionLaw, time: Var, var: Callable[[str], Var]) -> Motion | None:
    """The law and its derivatives with numbers; `var`: what is stated, by its key. None of a table and of phases, which
    are no one formula."""
    match law:
        case Harmonic():
            return _harmonic(law, time, var)
        case Polynomial() if law.uniform:
            return _uniform(law, time, var)
        case Polynomial():
            return _polynomial(law, time, var)
    return None


def _harmonic(law: Harmonic, t: Var, var: Callable[[str], Var]) -> Motion:
    size, frequency = var("law_amplitude"), var("law_frequency")
    turned: Expr = frequency * t
    if law.lead:
        turned = turned + var("law_phase")
    angle: Expr = var("law_angle")
    velocity: Expr = size * frequency * cos(turned)
    if law.speed:
        angle, velocity = angle + var("law_speed") * t, var("law_speed") + velocity
    return Motion(angle + size * sin(turned), velocity, Negative(size * frequency**2 * sin(turned)))


def _uniform(law: Polynomial, t: Var, var: Callable[[str], Var]) -> Motion:
    epsilon = var("law_acceleration")
    angle: Expr = var("law_angle")
    velocity: Expr = epsilon * t
    if law.coefficients[1]:
        angle, velocity = angle + var("law_speed") * t, var("law_speed") + velocity
    return Motion(angle + epsilon * t**2 / 2, velocity, expr(epsilon))


def _polynomial(law: Polynomial, t: Var, var: Callable[[str], Var]) -> Motion:
    terms = [(k, var(f"law_c{k}")) for k, c in enumerate(law.coefficients) if k and c]
    angle = _sum([expr(var("law_angle")), *(c * t**k for k, c in terms)])
    velocity = _sum([c * t ** (k - 1) * k if k > 1 else expr(c) for k, c in terms])
    acceleration = _sum([c * t ** (k - 2) * (k * (k - 1)) if k > 2 else c * 2 for k, c in terms if k > 1])
    return Motion(angle, velocity, acceleration)


def _sum(terms: list[Expr]) -> Expr:
    total = terms[0] if terms else expr(0)
    for one in terms[1:]:
        total = total + one
    return total
