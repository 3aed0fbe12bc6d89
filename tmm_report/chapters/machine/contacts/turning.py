"""Numbers of friction in what turns: pivots, belts, wheels, journals, a crank. Angles in degrees, but those of belts
in radians, as Euler's formula wants them; the rest SI."""

from __future__ import annotations

import math

from tmm_report.chapters.machine.contacts.given import Belt, BeltDrive, Crank, Journal, Pivot, Wheel
from tmm_report.mechanics.pairs import friction as law

Numbers = dict[str, float]


def pivot(of: Pivot) -> Numbers:
    about = of.load, of.rough.f, of.outer, of.inner, of.half_cone
    pressure, wear = law.pivot_pressure(*about), law.pivot_wear(*about)
    found = {
        "Q": of.load, "f": of.rough.f, "R_outer": of.outer, "r_inner": of.inner,
        "half_cone": math.degrees(of.half_cone),
        "p_mean": of.load / (math.pi * (of.outer**2 - of.inner**2)), "M_pressure": pressure, "M_wear": wear,
    }  # fmt: skip
    if of.speed is None:
        return found
    return found | {"omega": of.speed, "P_pressure": pressure * of.speed, "P_wear": wear * of.speed}


def belt(of: Belt) -> Numbers:
    """The power of the drum where it turns: what its brake or its drive must give."""
    f = law.grooved(of.rough.f, of.groove)
    slack = law.slack(of.tight, f, of.wrap)
    found = {
        "f": of.rough.f, "groove": math.degrees(of.groove), "f_red": f, "alpha": of.wrap, "T_1": of.tight,
        "T_2": slack, "F_t": of.tight - slack,
    }  # fmt: skip
    if of.diameter is None:
        return found
    found |= {"D": of.diameter, "M_drum": (of.tight - slack) * of.diameter / 2}
    if of.speed is None:
        return found
    v = of.speed * of.diameter / 2
    return found | {"omega": of.speed, "v": v, "P": (of.tight - slack) * v}


def belt_drive(of: BeltDrive) -> Numbers:
    """The most that the belt carries, with the tension it is put on with."""
    wrap = law.open_wrap(of.driving, of.driven, of.distance)
    v, most = of.speed * of.driving / 2, of.stress * of.width * of.thickness
    mass = (of.density or 0.0) * of.width * of.thickness
    centrifugal = mass * v**2
    tight = most - centrifugal
    slack = law.slack(tight, of.rough.f, wrap)
    found = {
        "d_1": of.driving, "d_2": of.driven, "a": of.distance, "omega_1": of.speed, "b": of.width,
        "t": of.thickness, "sigma": of.stress, "f": of.rough.f, "u": of.driven / of.driving, "alpha": wrap, "v": v,
        "T_max": most, "T_1": tight, "T_2": slack, "F_t": tight - slack, "P": (tight - slack) * v,
        "T_0": (tight + slack) / 2 + centrifugal,
    }  # fmt: skip
    if of.density is None:
        return found
    best = law.best_speed(most, mass)
    power = 2 / 3 * most * (1 - math.exp(-of.rough.f * wrap)) * best
    return found | {"rho": of.density, "q": mass, "T_c": centrifugal, "v_best": best, "P_best": power}


def wheel(of: Wheel) -> Numbers:
    """What makes it roll, what makes it slide, and the slopes on which it does so by itself."""
    found = {
        "N": of.load, "k": of.arm, "r": of.radius, "f": of.rough.f, "M_roll": law.rolling_moment(of.load, of.arm),
        "F_roll": of.load * of.arm / of.radius, "F_slide": of.rough.f * of.load, "f_roll": of.arm / of.radius,
        "phi_roll": math.degrees(math.atan(of.arm / of.radius)), "phi": math.degrees(law.angle(of.rough.f)),
    }  # fmt: skip
    return found if of.pull is None else found | {"F": of.pull}


def journal(of: Journal) -> Numbers:
    rho = law.friction_circle(of.rough.f, of.diameter)
    found = {
        "Q": of.load, "d": of.diameter, "f": of.rough.f, "rho": rho, "M_fr": of.load * rho,
        "phi": math.degrees(law.angle(of.rough.f)),
    }  # fmt: skip
    return found if of.speed is None else found | {"omega": of.speed, "P": of.load * rho * of.speed}


def swing(of: Crank) -> int:
    """+1 while the rod swings out, −1 while it swings back past 90°: so the wrist pin turns the force in the rod."""
    return 1 if math.cos(of.turned) > 0 else -1


def crank(of: Crank) -> Numbers:
    """The moment on the crank with and without friction in shaft, crankpin and wrist pin."""
    shaft, pin, wrist = (law.friction_circle(of.rough.f, d) for d in of.journals)
    plain = law.tilted_rod(of.turned, of.crank, 0.0, of.rod)
    tilt = law.tilted_rod(of.turned, of.crank, pin + swing(of) * wrist, of.rod)
    ideal = law.crank_moment(of.force, of.turned, of.crank, plain, 0.0)
    moment = law.crank_moment(of.force, of.turned, of.crank, tilt, shaft + pin)
    diameters = dict(zip(("d_shaft", "d_pin", "d_wrist"), of.journals, strict=True))
    return {
        "F": of.force, "r": of.crank, "l": of.rod, "phi": math.degrees(of.turned), "f": of.rough.f, **diameters,
        "rho_shaft": shaft, "rho_pin": pin, "rho_wrist": wrist, "beta": math.degrees(plain),
        "tau": math.degrees(tilt), "M_ideal": ideal, "M_crank": moment, "eta": moment / ideal,
    }  # fmt: skip
