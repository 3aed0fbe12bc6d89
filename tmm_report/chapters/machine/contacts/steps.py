"""The numbers of a pair, each assigned the expression that the note prints; what is stated goes in first.

Angles in degrees, but those of belts in radians, as Euler's formula wants them; the rest SI.
"""

from __future__ import annotations

from functools import reduce
from math import degrees
from operator import mul

from tmm_report.chapters.machine.contacts import given as state
from tmm_report.chapters.machine.contacts import values as v
from tmm_report.quantity.formula import PI, Expr, cos, sin, sqrt, tan
from tmm_report.quantity.functions import arcsin, arctan, exp

# --- planes and screws


def incline(s: v.Incline, of: state.Incline) -> None:
    """Raising and lowering; the efficiency of lowering where the body drives, that is where the plane does not lock."""
    s.Q, s.alpha, s.f = of.load, degrees(of.angle), of.f
    s.phi = arctan(s.f)
    load, slope, phi = s.Q, s.alpha, s.phi
    drives = slope.number > phi.number
    if of.force == "level":
        s.F_up = load * tan(slope + phi)
        s.F_down = load * tan(slope - phi)
        s.eta = tan(slope) / tan(slope + phi)
        s.eta_back = tan(slope - phi) / tan(slope) if drives else None
    else:
        s.F_up = load * sin(slope + phi) / cos(phi)
        s.F_down = load * sin(slope - phi) / cos(phi)
        s.eta = sin(slope) * cos(phi) / sin(slope + phi)
        s.eta_back = sin(slope - phi) / (sin(slope) * cos(phi)) if drives else None


def wedge(s: v.Wedge, of: state.Wedge) -> None:
    s.Q, s.alpha, s.f, s.f_base = of.load, degrees(of.angle), of.f, of.f_base
    s.phi = arctan(s.f)
    s.phi_base = arctan(s.f_base)
    load, slope, face, base = s.Q, s.alpha, s.phi, s.phi_base
    s.F_in = load * (tan(slope + face) + tan(base))
    s.F_out = load * (tan(slope - face) - tan(base))
    s.eta = tan(slope) / (tan(slope + face) + tan(base))
    s.alpha_lock = face + base


def sliders(s: v.Sliders, of: state.Sliders) -> None:
    """The given face, or the best one; the driving force where the load is known."""
    s.theta, s.f, s.f_guide, s.Q = degrees(of.between), of.f, of.guides, of.load
    s.phi = arctan(s.f)
    s.phi_guide = arctan(s.f_guide)
    s.phi_both = s.phi + s.phi_guide
    theta, both = s.theta, s.phi_both
    s.alpha_best = (theta + both) / 2
    s.eta_best = (cos(s.alpha_best) / cos(s.alpha_best - both)) ** 2
    s.alpha = s.alpha_best if of.face is None else degrees(of.face)
    alpha = s.alpha
    s.eta = cos(alpha) * cos(theta - alpha + both) / (cos(theta - alpha) * cos(alpha - both))
    if of.load is not None:
        s.F = s.Q * cos(alpha) / (cos(theta - alpha) * s.eta)


def trial(s: v.Trial, of: state.Trial) -> None:
    s.theta, s.P_pull, s.P_push = degrees(of.angle), of.pull, of.push
    theta, pull, push = s.theta, s.P_pull, s.P_push
    s.f = (push - pull) / ((pull + push) * tan(theta))
    s.G = pull * (cos(theta) / s.f + sin(theta))
    s.phi = arctan(s.f)
    s.P_least = s.G * sin(s.phi)


def screw(s: v.Screw, of: state.Screw) -> None:
    """Moments of thread and collar, efficiency, and what the hands do."""
    s.Q, s.d_2, s.p, s.z = of.load, of.diameter, of.pitch, float(of.starts)
    s.beta, s.f = degrees(of.profile), of.f
    load, d = s.Q, s.d_2
    s.h = s.z * s.p
    s.psi = arctan(s.h / (PI * d))
    s.phi_red = arctan(s.f / cos(s.beta)) if of.profile else arctan(s.f)
    psi, phi = s.psi, s.phi_red
    s.M_thread = load * d / 2 * tan(psi + phi)
    s.M_low = load * d / 2 * tan(phi - psi)
    s.eta_thread = tan(psi) / tan(psi + phi)
    if of.collar:
        s.f_collar, s.R_collar = of.collar.coefficient, of.collar.radius
        s.M_collar = s.f_collar * load * s.R_collar
        s.M_screw = s.M_thread + s.M_collar
        s.M_back = s.M_low + s.M_collar
    else:
        s.M_screw = s.M_thread
    s.eta = load * s.h / (2 * PI * s.M_screw)
    _hands(s, of)


def _hands(s: v.Screw, of: state.Screw) -> None:
    if of.arm is not None:
        s.l_hand, s.n_hand = of.arm, float(of.sharing) if of.sharing > 1 else None
        s.P_hand = s.M_screw / (s.n_hand * s.l_hand if of.sharing > 1 else s.l_hand)
    elif of.hand_force is not None:
        s.P_hand, s.n_hand = of.hand_force, float(of.sharing)
        s.D_wheel = 2 * s.M_screw / (s.n_hand * s.P_hand)


# --- what turns


def pivot(s: v.Pivot, of: state.Pivot) -> None:
    s.Q, s.f, s.R_outer, s.k = of.load, of.f, of.outer, of.ratio
    s.r_inner = of.hole if of.ratio is None else s.k * s.R_outer
    s.half_cone, s.omega = degrees(of.half_cone), of.speed
    s.n_surfaces, s.n_collars = (float(n) if n > 1 else None for n in (of.surfaces, of.collars))
    load, outer, inner = s.Q, s.R_outer, s.r_inner
    rubbed = s.f * load if of.surfaces == 1 else s.n_surfaces * s.f * load
    collars: list[Expr] = [] if of.collars == 1 else [s.n_collars]
    cone: list[Expr] = [] if flat(s.half_cone.number) else [sin(s.half_cone)]
    if of.hole == 0:
        s.p_mean = load / _product(*collars, PI, outer**2)
        s.M_pressure = 2 * rubbed * outer / _product(3, *cone)
        s.M_wear = rubbed * outer / _product(2, *cone)
    else:
        disc = outer**2 - inner**2
        s.p_mean = load / _product(*collars, PI, disc)
        s.p_max = load / _product(2, *collars, PI, inner, outer - inner)
        s.M_pressure = 2 * rubbed * (outer**3 - inner**3) / _product(3, disc, *cone)
        s.M_wear = rubbed * (outer + inner) / _product(2, *cone)
    if of.speed is not None:
        s.P_pressure = s.M_pressure * s.omega
        s.P_wear = s.M_wear * s.omega


def _product(first: Expr | float, *others: Expr | float) -> Expr | float:
    return reduce(mul, others, first)


def flat(angle: float) -> bool:
    """Whether half the angle of a cone or of a groove, rad, is a right one: then it is none."""
    return degrees(angle) == 90.0


def belt(s: v.Belt, of: state.Belt) -> None:
    """The power of the drum where it turns: what its brake or its drive must give."""
    s.f, s.groove, s.alpha, s.T_1 = of.f, degrees(of.groove), of.wrap, of.tight
    s.D, s.omega = of.diameter, of.speed if of.diameter is not None else None
    plain = flat(s.groove.number)
    s.f_red = of.f if plain else s.f / sin(s.groove)
    s.T_2 = s.T_1 * exp(-((s.f if plain else s.f_red) * s.alpha))
    s.F_t = s.T_1 - s.T_2
    if of.diameter is not None:
        s.M_drum = s.F_t * s.D / 2
    if "omega" in s:
        s.v = s.omega * s.D / 2
        s.P = s.F_t * s.v


def belt_drive(s: v.BeltDrive, of: state.BeltDrive) -> None:
    """The most that the belt carries, with the tension it is put on with."""
    (s.d_1, s.d_2), s.a, s.omega_1 = of.diameters, of.distance, of.speed
    s.b, s.t, s.sigma, s.f, s.rho = of.width, of.thickness, of.stress, of.f, of.density
    s.u = s.d_2 / s.d_1
    s.alpha = PI - 2 * arcsin(abs(s.d_2 - s.d_1) / (2 * s.a))
    s.v = s.omega_1 * s.d_1 / 2
    s.T_max = s.sigma * s.b * s.t
    heavy = of.density is not None
    if heavy:
        s.q = s.rho * s.b * s.t
        s.T_c = s.q * s.v**2
    s.T_1 = s.T_max - s.T_c if heavy else s.T_max
    s.T_2 = s.T_1 * exp(-(s.f * s.alpha))
    s.F_t = s.T_1 - s.T_2
    s.P = s.F_t * s.v
    mean = (s.T_1 + s.T_2) / 2
    s.T_0 = mean + s.T_c if heavy else mean
    if heavy:  # the centrifugal tension is then a third of what the belt bears
        s.v_best = sqrt(s.T_max / (3 * s.q))
        carried = s.T_max * (1 - exp(-(s.f * s.alpha))) * s.v_best
        s.P_best = 2 * carried / 3


def wheel(s: v.Wheel, of: state.Wheel) -> None:
    """What makes it roll, what makes it slide, and the slopes on which it does so by itself."""
    s.N, s.k, s.r, s.f, s.F = of.load, of.arm, of.radius, of.f, of.pull
    s.M_roll = s.k * s.N
    s.F_roll = s.M_roll / s.r
    s.F_slide = s.f * s.N
    s.f_roll = s.k / s.r
    s.phi_roll = arctan(s.f_roll)
    s.phi = arctan(s.f)
    if of.moment is not None:
        _driving(s, of)
    elif of.f and s.number("f") <= s.number("f_roll"):
        s.r_least = s.k / s.f
        s.k_most = s.f * s.r


def _driving(s: v.Wheel, of: state.Wheel) -> None:
    """A wheel that is driven by a moment, in steady motion: what the ground must bear, and what would be enough."""
    s.M = of.moment
    s.M_most = (s.f * s.r + s.k) * s.N
    if s.number("M") > s.number("M_roll"):
        s.T = (s.M - s.M_roll) / s.r
        s.f_need = s.T / s.N
        s.N_need = s.M / (s.f * s.r + s.k)
        s.r_need = (s.M - s.M_roll) / s.F_slide


def journal(s: v.Journal, of: state.Journal) -> None:
    s.Q, s.d, s.f, s.omega = of.load, of.diameter, of.f, of.speed
    s.phi = arctan(s.f)
    s.rho = s.f * s.d / 2
    s.M_fr = s.Q * s.rho
    if of.speed is not None:
        s.P = s.M_fr * s.omega


def crank(s: v.Crank, of: state.Crank) -> None:
    """The moment on the crank with and without friction in shaft, crankpin and wrist pin."""
    s.F, s.r, s.l, s.phi, s.f = of.force, of.crank, of.rod, degrees(of.angle), of.f
    s.d_shaft, s.d_pin, s.d_wrist = of.diameters
    s.rho_shaft = s.f * s.d_shaft / 2
    s.rho_pin = s.f * s.d_pin / 2
    s.rho_wrist = s.f * s.d_wrist / 2
    s.beta = arcsin(s.r * sin(s.phi) / s.l)
    pins = s.rho_pin + s.rho_wrist if of.swing > 0 else s.rho_pin - s.rho_wrist
    s.tau = s.beta - arcsin(pins / s.l)
    s.M_ideal = s.F / cos(s.beta) * (s.r * sin(s.phi + s.beta))
    s.M_crank = s.F / cos(s.tau) * (s.r * sin(s.phi + s.tau) - s.rho_shaft - s.rho_pin)
    s.eta = s.M_crank / s.M_ideal
