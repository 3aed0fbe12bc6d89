"""The numbers of the speed governor: its equilibrium, the loop with its machine, the brake."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.machine.governor.quantities import given as values_given
from tmm_report.chapters.machine.governor.quantities import in_loop as loop_quantities
from tmm_report.chapters.machine.governor.quantities.given import value
from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.whole import Found
from tmm_report.i18n import NP_
from tmm_report.mechanics.machine.governor.equilibrium import Arms
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, plain
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

CONTACT = NP_("index", "cont")
UPPER, LOWER = NP_("index", "up"), NP_("index", "low")
FR = "fr"

POINT = Message(N_("number of the place of the sleeve"))
Z = Quantity("z", Symbol("z"), "m", Message(N_("lift of the sleeve")))
X = Quantity("x", Symbol("x"), "m", Message(N_("radius of the pin of both arms")))
H = Quantity("H", Symbol("H"), "m", Message(N_("height of the upper pivots over those of the sleeve")))
DX = Quantity("dx", Symbol("x'"), "", Message(N_("derivative of the radius of the pin by the lift")))
R = Quantity("r", Symbol("r"), "m", Message(N_("radius of the mass centre of a ball")))
DR = Quantity("dr", Symbol("r'"), "", Message(N_("derivative of the radius of a ball by the lift")))
DH = Quantity("dy", Symbol("y'"), "", Message(N_("derivative of the height of a ball by the lift")))
A = Quantity("A", Symbol("A"), "kg·m", Message(N_("inertial coefficient of the governor")))
E = Quantity("E", Symbol("E"), "N", Message(N_("supporting force on the sleeve")))
DA = Quantity("dA", Symbol("A'"), "kg", Message(N_("derivative of the inertial coefficient by the lift")))
DE = Quantity("dE", Symbol("E'"), "N/m", Message(N_("derivative of the supporting force by the lift")))
OMEGA = Quantity(
    "omega_g", Symbol("omega", "g"), "rad/s", Message(N_("speed of the governor's shaft in equilibrium"))
)
C = Quantity("C", Symbol("C"), "N", Message(N_("controlling force of one ball")))
S = Quantity("S", Symbol("S"), "N/m", Message(N_("factor of stability of the governor")))
DOWN = Quantity(
    "omega_low", Symbol("omega", LOWER), "rad/s", Message(N_("speed at which the sleeve begins to sink"))
)
UP = Quantity(
    "omega_up", Symbol("omega", UPPER), "rad/s", Message(N_("speed at which the sleeve begins to rise"))
)
EPS = Quantity("epsilon", Symbol("epsilon"), "", Message(N_("insensitivity of the governor")))
TILTS = {
    "alpha": Message(N_("angle of the upper arm with the axis")),
    "beta": Message(N_("angle of the lower arm with the axis")),
    "gamma": Message(N_("angle of the extension of the lower arm with the axis")),
    "theta": Message(N_("angle of the ball arm with the axis")),
}
BRAKING = Quantity("M_b", Symbol("M", "b"), "N·m", Message(N_("braking moment")))
SHAFT = Quantity("omega", Symbol("omega"), "rad/s", Message(N_("speed of the shaft of the brake")))
TIME = Quantity("t", Symbol("t"), "s", Message(N_("time")))


def book(found: Found) -> Book:
    """All that is said in numbers of the governor."""
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.direct is not None:
        yield Table(
            "governor_equilibrium",
            Message(N_("equilibrium of the governor over the lift")),
            _places(found.direct),
        )
        yield Table(
            "governor_curve", Message(N_("curves of equilibrium of the governor")), _curve(found.direct)
        )
    if found.loop is not None:
        yield from loop_quantities.tables(found.loop)
    if found.brake is not None:
        yield from _brake_tables(found.brake)


def _places(found: DirectFound) -> tuple[Column, ...]:
    at, balls = found.table, found.table.balls
    down, up = at.band(found.given.friction)
    columns = [plain("point", "", POINT, list(range(len(balls.z)))), Z.column(balls.z), *_arms(found)]
    for name, angle in balls.tilt.items():
        columns.append(Quantity(name, Symbol(name), "rad", TILTS[name]).column(angle))
    columns += [R.column(balls.r), DR.column(balls.dr), DH.column(balls.dh)]
    columns += [A.column(at.A), E.column(at.E), DA.column(at.dA), DE.column(at.dE), OMEGA.column(at.omega)]
    columns += [C.column(at.force), S.column(at.S), DOWN.column(down), UP.column(up)]
    return (*columns, EPS.column(at.insensitivity(found.given.friction)))


def _arms(found: DirectFound) -> Iterator[Column]:
    """Height and pin of the two arms."""
    arms, z = found.given.geometry, found.table.balls.z
    if isinstance(arms, Arms):
        height = arms.height(found.given.lowest) - z
        pin = arms.moves(z, found.given.lowest).tilt
        yield H.column(height)
        yield X.column(arms.pin(height))
        yield DX.column(arms.pin_slope(pin))


def _curve(found: DirectFound) -> tuple[Column, ...]:
    at = found.curve
    return (Z.column(at.balls.z), R.column(at.balls.r), OMEGA.column(at.omega), C.column(at.force))


def _brake_tables(found: BrakeFound) -> Iterator[Table]:
    meaning = Message(N_("braking moment over the speed"))
    yield Table("governor_brake", meaning, (SHAFT.column(found.omega), BRAKING.column(found.moment)))
    if len(found.t):
        meaning = Message(N_("start of the shaft with the brake"))
        yield Table("governor_brake_start", meaning, (TIME.column(found.t), SHAFT.column(found.started)))


# --- single numbers


@tabulated
def values(found: Found) -> Iterator[Value]:
    if found.direct is not None:
        yield from values_given.of_direct(found.direct)
        yield from _of_direct(found.direct)
    if found.loop is not None:
        yield from loop_quantities.values(found.loop)
    if found.brake is not None:
        yield from values_given.of_brake(found.brake)
        yield from _of_brake(found.brake)


def _of_direct(found: DirectFound) -> Iterator[Value]:
    low, high = found.ends
    yield value(
        "omega_0", Symbol("omega", "g,0"), "rad/s", N_("speed of the governor at the lower stop"), low
    )
    yield value(
        "omega_h", Symbol("omega", "g,h"), "rad/s", N_("speed of the governor at the upper stop"), high
    )
    yield value("omega_m", Symbol("omega", "g,m"), "rad/s", N_("mean speed of the governor"), found.mean)
    yield value("delta", Symbol("delta"), "", N_("non-uniformity of the governor"), found.delta)
    yield value("effort", Symbol("Q"), "N", N_("effort of the governor"), found.effort)
    yield value(
        "power", Symbol("W"), "J", N_("power of the governor, its effort times the lift"), found.power
    )
    top = found.spring_ends[1]
    yield value("spring_top", Symbol("F", "h"), "N", N_("force of the spring at the upper stop"), top)
    if found.stiffness_needed is not None:
        text = N_("stiffness of the spring above which the governor is stable all over its lift")
        yield value("stiffness_needed", Symbol("c", "min"), "N/m", text, found.stiffness_needed)
    if found.preload_allowed is not None:
        text = N_(
            "force of the spring at the lower stop below which the governor is stable all over its lift"
        )
        yield value("preload_allowed", Symbol("F", "0,max"), "N", text, found.preload_allowed)


def _of_brake(found: BrakeFound) -> Iterator[Value]:
    shoes = found.given.brake
    contact = Symbol("omega", CONTACT)
    yield value("brake_contact", contact, "rad/s", N_("speed at which the shoes touch"), shoes.contact)
    yield value("brake_K", Symbol("K"), "kg·m²", N_("coefficient of the braking moment"), shoes.K)
    yield value("brake_held", Symbol("omega", "h"), "rad/s", N_("speed that the brake holds"), found.held)
    yield value(
        "brake_spread", Symbol("Delta"), "", N_("excess of the held speed over that of contact"), found.spread
    )
    yield value(
        "brake_pressing",
        Symbol("N"),
        "N",
        N_("force of a shoe on the drum at the held speed"),
        found.pressing,
    )
    yield value("brake_power", Symbol("P"), "W", N_("power that the brake turns into heat"), found.power)
    if found.given.inertia:
        yield value(
            "brake_contact_time",
            Symbol("t", CONTACT),
            "s",
            N_("time from rest to contact"),
            found.contact_time,
        )
        yield value(
            "brake_settled",
            Symbol("t", "h"),
            "s",
            N_("time from rest to 99 %% of the held speed"),
            found.settled,
        )
