"""The law of the stroke by which a slider or a cylinder drives, in numbers and formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from tmm_report.chapters.lever.initial_data.quantities import driving_law
from tmm_report.chapters.lever.initial_data.quantities.driving_law import POWERS, TIME
from tmm_report.mechanics.calculus.motion_laws import Harmonic, MotionLaw, Phased, Pieces, Polynomial, RunUp
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Negative, Var, cos, expr, sin
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol

MIDDLE = Quantity("law_stroke", Symbol("s", "m"), "m", Message(N_("middle of the stroke's harmonic")))
START = Quantity("law_stroke", Symbol("s", "0"), "m", Message(N_("stroke at the beginning of its law")))
SPEED = Quantity(
    "law_stroke_speed",
    Symbol("v", "0"),
    "m/s",
    Message(N_("speed of the stroke at the beginning of its law")),
)
ACCELERATION = Quantity(
    "law_stroke_acceleration", Symbol("a", "0"), "m/s²", Message(N_("stated acceleration of the stroke"))
)
AMPLITUDE = Quantity(
    "law_stroke_amplitude", Symbol("A"), "m", Message(N_("amplitude of the stroke's harmonic"))
)
FREQUENCY = replace(driving_law.FREQUENCY, meaning=Message(N_("angular frequency of the stroke's harmonic")))
LEAD = replace(driving_law.LEAD, meaning=Message(N_("phase of the stroke's harmonic in position 0")))
STEADY = Quantity(
    "law_stroke_steady", Symbol("v", "1"), "m/s", Message(N_("speed that the stroke is run up to"))
)
UP = Quantity(
    "law_run_up", Symbol("t", "1"), "s", Message(N_("time in which the stroke is run up to its speed"))
)
DOWN = Quantity(
    "law_run_down", Symbol("t", "2"), "s", Message(N_("time in which the stroke is run down to rest"))
)
RISE = Quantity("law_stroke_rise", Symbol("h"), "m", Message(N_("rise of the stroke by its phases")))


def values(law: MotionLaw) -> Iterator[Value]:
    """What the variant states of the law; of a table nothing but its time."""
    yield TIME.value(law.period)
    match law:
        case Harmonic():
            yield MIDDLE.value(law.start)
            yield AMPLITUDE.value(law.amplitude)
            yield FREQUENCY.value(law.frequency)
            if law.lead:
                yield LEAD.value(law.lead)
        case Polynomial(coefficients=(start, speed)):
            yield START.value(start)
            yield SPEED.value(speed)
        case Polynomial(coefficients=(start, speed, half)):
            yield START.value(start)
            if speed:
                yield SPEED.value(speed)
            yield ACCELERATION.value(2 * half)
        case Polynomial(coefficients=(start, *others)):
            yield START.value(start)
            yield from (_factor(k).value(c) for k, c in enumerate(others, 1) if c)
        case RunUp():
            yield START.value(law.start)
            yield STEADY.value(law.steady)
            yield from (of.value(time) for of, time in ((UP, law.up), (DOWN, law.down)) if time)
        case Pieces():
            yield from _pieces(law)
        case Phased():
            yield START.value(law.start)
            yield RISE.value(law.lifts.lift)


def _pieces(law: Pieces) -> Iterator[Value]:
    yield START.value(law.start)
    if law.speed:
        yield SPEED.value(law.speed)
    for k, (time, acceleration) in enumerate(zip(law.times, law.accelerations, strict=True), 1):
        of = {"k": str(k)}
        meaning = Message(N_("duration of part %(k)s of the stroke's law"), of)
        yield Quantity(f"law_part_time_{k}", Symbol("t", str(k)), "s", meaning).value(time)
        meaning = Message(N_("acceleration in part %(k)s of the stroke's law"), of)
        yield Quantity(f"law_part_acceleration_{k}", Symbol("a", str(k)), "m/s²", meaning).value(acceleration)


def _factor(power: int) -> Quantity:
    """Of t, t², … in a polynomial."""
    unit = "m/s" + "".join(POWERS[int(digit)] for digit in str(power)) if power > 1 else "m/s"
    meaning = Message(N_("factor of power %(power)s of the time in the stroke's law"), {"power": power})
    return Quantity(f"law_s{power}", Symbol("c", str(power)), unit, meaning)


def motion(law: MotionLaw, t: Var, var: Callable[[str], Var]) -> tuple[Expr, Expr, Expr] | None:
    """The stroke and its derivatives with numbers; `var`: what is stated, by its key. None where there is none."""
    match law:
        case Harmonic():
            turned: Expr = var(FREQUENCY.key) * t
            if law.lead:
                turned = turned + var(LEAD.key)
            size, frequency = var(AMPLITUDE.key), var(FREQUENCY.key)
            return (
                var(MIDDLE.key) + size * sin(turned),
                size * frequency * cos(turned),
                Negative(size * frequency**2 * sin(turned)),
            )
        case Polynomial(coefficients=(_, _)):
            speed = var(SPEED.key)
            return var(START.key) + speed * t, expr(speed), expr(0)
        case Polynomial(coefficients=(_, speed_, _)):
            a, start = var(ACCELERATION.key), var(START.key)
            if not speed_:
                return start + a * t**2 / 2, a * t, expr(a)
            return start + var(SPEED.key) * t + a * t**2 / 2, var(SPEED.key) + a * t, expr(a)
    return None
