"""Dimensions of the flywheel on its shaft: a disc, a rim on spokes, or the mass for a known radius of gyration."""

from __future__ import annotations

import math

from tmm_report.chapters.machine.flywheel.given import Disc, Given, Gyration, Rim, Wheel
from tmm_report.chapters.machine.flywheel.values import Values
from tmm_report.mechanics.machine.flywheel.inertia import disc, rim
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.formula import PI, POWER, Expr, Number, Page, Piece, sqrt
from tmm_report.records import dataclass

HIGHEST = 0.6  # of the mean diameter: a rim that leaves room for spokes and a hub
WIDEST = 2.0  # of the diameter: what is wider is no disc


@dataclass(frozen=True, eq=False)
class FifthRoot(Expr):
    """A power of 0.2."""

    body: Expr

    def evaluate(self, digits: int | None = None) -> float:
        return float(self.body.evaluate(digits)) ** 0.2

    def piece(self, page: Page) -> Piece:
        body = page.bracket(self.body.piece(page), POWER)
        return Piece(page.notation.power(body, Number(0.2).piece(page).text), POWER)


def stated(s: Values, given: Given, wheel: Wheel) -> None:
    """Of a flywheel that is there already: as reduced to the main link, or whole on its own shaft."""
    if wheel.mass is None:
        s.J_fl = wheel.inertia
        return
    s.i = ratio(given, s.number("omega_m"))
    s.m, s.k = wheel.mass, wheel.radius_of_gyration
    s.J_shaft = s.m * s.k**2
    s.J_fl = s.J_shaft * s.i**2


def dimensions(s: Values, given: Given) -> None:
    """Of the flywheel of the moment of inertia J_fl. Raises ProblemError where the stated shape cannot have it."""
    shape = given.shape
    s.i = ratio(given, s.number("omega_m"))
    s.J_shaft = s.J_fl / s.i**2
    if isinstance(shape, Gyration):
        s.k = shape.radius
        s.m = s.J_shaft / s.k**2
        return
    s.rho, s.sigma_lim = given.metal.density, given.metal.stress
    s.v_lim = given.metal.speed if given.metal.stress is None else sqrt(s.sigma_lim / s.rho)
    if isinstance(shape, Disc):
        _disc(s, shape)
    else:
        _rim(s, shape)
    s.omega_s = s.i * s.omega_max
    s.v = s.omega_s * s.D_out / 2
    s.sigma = s.rho * s.v**2
    s.D_lim = 2 * s.v_lim / s.omega_s


def ratio(given: Given, omega: float) -> float:
    """Speed of the flywheel's shaft to that of the main link."""
    if given.shaft == "motor" and given.motor:
        return given.motor.speed / omega
    return given.ratio or 1.0


def _disc(s: Values, shape: Disc) -> None:
    """J = mD²/8."""
    if shape.diameter is None:
        s.k_b = shape.width
        s.D = FifthRoot(32 * s.J_shaft / (PI * s.rho * s.k_b))
        s.b = s.k_b * s.D
    else:
        s.D = shape.diameter
        s.b = 32 * s.J_shaft / (PI * s.rho * s.D**4)
        s.k_b = s.b / s.D
    s.m = 8 * s.J_shaft / s.D**2
    s.D_out = s.number("D")
    width, diameter = s.number("b"), s.number("D")
    if width > WIDEST * diameter * (1 + 1e-9):
        text = N_(
            "the disc would be %(width)s mm wide at a diameter of %(diameter)s mm: that is a shaft, no wheel"
        )
        values = {"width": f"{1e3 * width:.4g}", "diameter": f"{1e3 * diameter:.4g}"}
        key = "width" if shape.diameter is None else "diameter"
        right = _larger(disc(s.number("J_shaft"), WIDEST, s.number("rho")))
        raise ProblemError([mistake(text, ("flywheel", "disc", key), right, **values)])


def _rim(s: Values, shape: Rim) -> None:
    """The rim has what spokes and hub leave: J = m(D² + h²)/4."""
    s.k_b, s.k_s = shape.width, shape.spokes
    own = (1 - s.k_s) * s.J_shaft
    if shape.diameter is None:
        s.k_h = shape.height
        s.D = FifthRoot(4 * own / (PI * s.rho * s.k_b * s.k_h**2 * (1 + s.k_h**2)))
        s.h = s.k_h * s.D
    else:
        s.D = shape.diameter
        s.h = sqrt((sqrt(s.D**4 + 16 * own / (PI * s.rho * s.k_b * s.D)) - s.D**2) / 2)
        s.k_h = s.h / s.D
    s.b = s.k_b * s.h
    s.m = PI * s.rho * s.D * s.h * s.b
    s.D_out = s.D + s.h
    height, diameter = s.number("h"), s.number("D")
    if height > HIGHEST * diameter * (1 + 1e-9):
        text = N_(
            "the rim would be %(height)s mm high at a mean diameter of %(diameter)s mm: spokes have no room"
        )
        least = rim(float(own.value), HIGHEST, shape.width, s.number("rho"))
        values = {"height": f"{1e3 * height:.4g}", "diameter": f"{1e3 * diameter:.4g}"}
        key = "height" if shape.diameter is None else "diameter"
        raise ProblemError([mistake(text, ("flywheel", "rim", key), _larger(least), **values)])


def _larger(least: float) -> Message:
    return Message(N_("a diameter of %(least)s mm or more"), {"least": f"{math.ceil(1e3 * least)}"})
