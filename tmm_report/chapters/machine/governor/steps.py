"""The single numbers of the governor, its loop and its brake, each assigned the expression that the note prints."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.machine.governor import given as stated
from tmm_report.chapters.machine.governor.given import Given, Plant
from tmm_report.chapters.machine.governor.quantities import places, steady
from tmm_report.chapters.machine.governor.rows import added, at, held, taken
from tmm_report.chapters.machine.governor.values import OF_CRANK, Brake, Values
from tmm_report.mechanics.machine.governor.equilibrium import Equilibrium
from tmm_report.quantity.formula import Expr, cos, sin, sqrt
from tmm_report.quantity.sheet import Computed

if TYPE_CHECKING:
    from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
    from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
    from tmm_report.chapters.machine.governor.solve.steady_states import Steady


# --- the centrifugal governor by itself


def mechanism(given: Given) -> Values:
    """Its lengths."""
    if given.arms is None:
        return _crank(given)
    s, arms, balls = Values(), given.arms, given.balls
    s.l_1, s.l_2, s.e_1, s.e_2 = arms.upper, arms.lower, arms.upper_offset, arms.lower_offset
    s.x_0, s.L, s.b = given.lowest, balls.distance, balls.extension
    if balls.extension is not None:
        s.beta_0 = float(np.arcsin((given.lowest - arms.lower_offset) / arms.lower))
    return s


def _crank(given: Given) -> Values:
    s, crank = Values(OF_CRANK), given.bell_crank
    assert crank is not None  # `mistakes`
    s.a, s.b, s.r_0, s.r_min = crank.ball_arm, crank.sleeve_arm, crank.fulcrum, given.lowest
    return s


def direct(found: DirectFound) -> None:
    """Its weights, those that are chosen by their formulas, and its figures of merit."""
    s, given = found.s, found.given
    s.n, s.g, s.h = found.weights.count, found.weights.gravity, found.lift
    s.F_fr, s.k, s.q = given.sleeve.friction, given.sleeve.damping, given.effort
    s.omega_0, s.omega_h = found.ends
    s.omega_m = found.mean
    _weights(found)
    s.delta = 2 * (s.omega_h - s.omega_0) / (s.omega_h + s.omega_0)
    s.effort = at(found, "E") / 2 * ((1 + s.q) ** 2 - 1)
    s.power = s.effort * s.h
    s.stiffness_needed, s.preload_allowed = found.stiffness_needed, found.preload_allowed


def _weights(found: DirectFound) -> None:
    s, of, chosen = found.s, found.weights, found.given.choose
    if chosen is None or chosen.balls is None:
        s.m = of.ball
    if chosen is None or chosen.sleeve is None:
        s.m_0 = of.sleeve
    if chosen is None or chosen.spring is None:
        s.c, s.F_0, s.spring_top = of.stiffness, of.preload, of.preload + of.stiffness * found.lift
    if chosen is None:
        return
    s.omega_chosen = chosen.middle
    if chosen.spring is not None:
        s.F_0 = Computed(_pressed(found, 0, s.omega_0), of.preload)
        s.spring_top = _pressed(found, len(places(found)) - 1, s.omega_h)
        s.c = Computed((s.spring_top - s.F_0) / s.h, of.stiffness)
    elif chosen.balls is not None:
        lifted: Expr = at(found, "r") * at(found, "dr") * s.omega_chosen**2
        if np.any(found.table.balls.dh):
            lifted = lifted - s.g * at(found, "dy")
        s.m = Computed(added(held(found, balls=False)) / (s.n * lifted), of.ball)
    else:
        rest = taken(at(found, "A") * s.omega_chosen**2, held(found, sleeve=False))
        s.m_0 = Computed(rest / s.g, of.sleeve)


def _pressed(found: DirectFound, row: int, speed: Expr) -> Expr:
    """What the spring presses with at an end of the lift."""
    s = found.s
    lifted = s.n * s.m * at(found, "r", row) * at(found, "dr", row) * speed**2
    return taken(lifted, held(found, row, spring=False))


# --- the machine with its governor


def machine(s: Values, plant: Plant, omega: float, after: Steady, there: Equilibrium) -> None:
    """What is stated of it, and the coefficients of the small motions about the steady state `after`, `there`: of the
    governor in it; `omega`: mean speed, rad/s."""
    torque, load, throttle = plant.torque, plant.load, plant.throttle
    s.J, s.i, s.omega_mean = plant.inertia, plant.ratio, omega
    s.M_mean, s.k_d, s.k_c = torque.full, torque.slope, load.slope
    s.load_before, s.load_after = load.before, load.after
    s.s_min, s.F_throttle, s.epsilon_allowed = throttle.least, throttle.force, throttle.insensitivity
    s.after_omega, s.after_M_d, s.after_s = after.omega, after.full, after.s
    s.after_A, s.after_S, s.after_m = (float(one[0]) for one in (there.A, there.S, there.mass))
    own = s.k_d * s.after_s
    s.D = (own + s.k_c if load.slope else own) if torque.slope else load.slope
    s.R = 2 * s.after_A * s.after_omega * s.i**2


def loop(found: LoopFound) -> None:
    """The throttle, stability, the response."""
    s, plant, response = found.s, found.plant, found.response
    if plant.throttle.insensitivity is not None:
        E = places(found.direct)["E"].values
        least, epsilon = at(found.direct, "E", int(np.argmin(E))), s.epsilon_allowed
        s.F_allowed = least * epsilon * sqrt(1 - epsilon**2 / 4)
        s.F_sum = s.F_fr + s.F_throttle
    s.slowest = float(found.eigenvalues.real.max())
    if found.servo is None:
        _cubic(found)
    else:
        _servo(found)
    states = steady(found)
    before, after = states.var("omega", 0), states.var("omega", 1)
    s.static = (after - before) / before
    s.peak, s.peak_time = found.peak, float(response.t[found.worst])
    s.final, s.settled = found.final / found.before.omega - 1, found.settled


def _cubic(found: LoopFound) -> None:
    """Of direct action: a₀λ³ + a₁λ² + a₂λ + a₃, and as q³ + Xq² + Yq + 1 where its last coefficient is positive."""
    s = found.s
    J, D, m, k, S = s.J, s.D, s.after_m, s.k, s.after_S
    full = s.after_M_d * (1 - s.s_min) if found.plant.throttle.least else s.after_M_d
    s.Q_s = full / s.h
    s.a_0 = J * m
    s.a_1 = J * k + D * m
    s.a_2 = J * S + D * k
    s.a_3 = D * S + s.Q_s * s.R
    cube = s.number("a_3") / s.number("a_0")
    if cube > 0:
        s.p = cube ** (1 / 3)
        s.X = s.a_1 / (s.a_0 * s.p)
        s.Y = s.a_2 / (s.a_0 * s.p**2)
        s.XY = s.X * s.Y
    s.k_min = found.damping_needed or None


def _servo(found: LoopFound) -> None:
    s, servo = found.s, found.servo
    assert servo is not None
    s.T_s, s.zone, s.z_m = servo.T, servo.zone, found.governor.neutral
    if servo.beta:
        s.beta, s.T_i = servo.beta, servo.Ti
        s.b_t = s.beta * s.delta
    if found.feedback_needed is not None:
        low, high = found.feedback_needed
        s.beta_min = low if low > 0 else None
        s.beta_max = high if np.isfinite(high) else None


# --- the brake


def brake(given: stated.Brake) -> Brake:
    s = Brake()
    choose = given.choose
    s.n, s.f, s.R = given.count, given.friction, given.drum
    s.m = None if choose and choose.mass else given.mass
    s.rho, s.gap, s.c = given.radius, given.gap, given.spring.stiffness
    s.F_0 = None if choose and choose.spring else given.spring.force
    s.M, s.J = given.moment, given.inertia
    s.wanted = (choose.mass or choose.spring) if choose else None
    if given.arm is None:
        _sliding(s)
    else:
        _on_arms(s, given.arm)
    s.power = s.M * s.held
    if given.inertia:
        s.contact_time = s.J * s.contact / s.M
    return s


def _sliding(s: Brake) -> None:
    """Shoes that move along their radius; the mass or the force of the spring, where it is chosen, is not there yet."""
    s.rho_contact = s.rho + s.gap
    if "F_0" in s:
        s.F = s.F_0 + s.c * s.gap
    if "m" not in s:
        s.m = (s.F / s.rho_contact + s.M / (s.n * s.f * s.rho_contact * s.R)) / s.wanted**2
    s.K = s.n * s.f * s.m * s.rho_contact * s.R
    if "F_0" not in s:
        s.F = s.m * s.rho_contact * (s.wanted**2 - s.M / s.K)
        s.F_0 = s.F - s.c * s.gap
    s.contact = sqrt(s.F / (s.m * s.rho_contact))
    _held(s)
    s.pressing = s.m * s.rho_contact * (s.held**2 - s.contact**2)


def _on_arms(s: Brake, arm: stated.ShoeArm) -> None:
    """Moments about the pivot of an arm; friction draws a shoe on that goes before its pivot."""
    s.a, s.psi, s.psi_m, s.l_F = arm.pivot, arm.shoe, arm.mass_centre, arm.spring
    s.l_C, s.l_N, s.l_T = s.a * sin(s.psi_m), s.a * sin(s.psi), s.R - s.a * cos(s.psi)
    s.theta = s.gap / s.l_N
    s.rho_contact = s.rho + s.theta * s.l_C
    on, off = s.l_N - s.f * s.l_T, s.l_N + s.f * s.l_T
    own, other = (on, off) if arm.ahead == "shoe" else (off, on)
    if "F_0" in s:
        s.F = s.F_0 + s.c * s.theta * s.l_F
    if "m" not in s:
        s.m = (s.F * s.l_F + s.M * own / (s.n * s.f * s.R)) / (s.rho_contact * s.l_C * s.wanted**2)
    s.K = s.n * s.f * s.m * s.rho_contact * s.R * s.l_C / own
    if "F_0" not in s:
        s.F = s.m * s.rho_contact * s.l_C * (s.wanted**2 - s.M / s.K) / s.l_F
        s.F_0 = s.F - s.c * s.theta * s.l_F
    s.contact = sqrt(s.F * s.l_F / (s.m * s.rho_contact * s.l_C))
    _held(s)
    s.pressing = s.m * s.rho_contact * s.l_C * (s.held**2 - s.contact**2) / own
    s.f_lock = s.l_N / s.l_T
    if arm.ahead == "shoe" or s.number("f") < s.number("f_lock"):
        s.back = sqrt(s.contact**2 + s.M * other / (s.n * s.f * s.m * s.rho_contact * s.R * s.l_C))


def _held(s: Brake) -> None:
    s.held = sqrt(s.contact**2 + s.M / s.K)
    s.spread = s.held / s.contact - 1
