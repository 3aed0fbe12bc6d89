"""Every formula of a pair with friction against mechanics/pairs/friction.py, or against forces and works themselves."""

import math

import numpy as np
import pytest
from notes import VARIANTS
from twice import disagreements

from tmm_report import course, loading
from tmm_report.mechanics.pairs import friction as law

PULLEYS = "distance: 0.6 m, speed: 1440 rpm, width: 50 mm, thickness: 4 mm, stress: 1.6 MPa, coefficient: 0.3"
JOURNALS = "journals: {shaft: 40 mm, crank_pin: 35 mm, wrist_pin: 20 mm}"
SCREW = "kind: screw, diameter: 30 mm, pitch: 6 mm, coefficient: 0.1, load: 5 kN"
TEXTS = (
    "kind: incline, angle: 20 deg, load: 1 kN, coefficient: 0.2",
    "kind: incline, angle: 8 deg, load: 1 kN, coefficient: 0.2",
    "kind: incline, angle: 20 deg, load: 1 kN, coefficient: 0.2, force: along",
    "kind: incline, angle: 8 deg, load: 1 kN, coefficient: 0.2, force: along",
    "kind: wedge, angle: 8 deg, load: 1 kN, coefficient: 0.15, base: 0.1",
    "kind: sliders, between: 70 deg, guides: 0.1, coefficient: 0.12, face: 30 deg, load: 1 kN",
    "kind: sliders, between: 70 deg, guides: 0.1, coefficient: 0.12",
    "kind: trial, angle: 20 deg, pull: 100 N, push: 130 N",
    f"{SCREW}, starts: 2, profile: 15 deg, arm: 0.3 m",
    f"{SCREW}, arm: 0.3 m, hands: 2",
    f"{SCREW}, collar: {{coefficient: 0.2, radius: 20 mm}}, hand_force: 100 N",
    "kind: pivot, outer: 40 mm, inner: 15 mm, half_cone: 45 deg, load: 3 kN, coefficient: 0.08, speed: 300 rpm",
    "kind: pivot, outer: 40 mm, load: 3 kN, coefficient: 0.08",
    "kind: pivot, outer: 150 mm, inner: 100 mm, load: 3 kN, coefficient: 0.3, surfaces: 2, speed: 2500 rpm",
    "kind: pivot, outer: 150 mm, ratio: 0.5, load: 3 kN, coefficient: 0.05, collars: 4, half_cone: 60 deg",
    "kind: pivot, outer: 150 mm, load: 3 kN, coefficient: 0.05, collars: 3",
    "kind: belt, wrap: 200 deg, tight: 1 kN, groove: 20 deg, coefficient: 0.2, diameter: 0.2 m, speed: 100 rpm",
    "kind: belt, wrap: 200 deg, tight: 1 kN, coefficient: 0.2",
    f"kind: belt drive, driving: 0.1 m, driven: 0.3 m, {PULLEYS}, density: 1000 kg/m^3",
    f"kind: belt drive, driven: 0.1 m, driven_speed: 1800 rpm, {PULLEYS}",
    "kind: wheel, radius: 0.2 m, arm: 1 mm, load: 1 kN, coefficient: 0.2, pull: 20 N",
    "kind: wheel, radius: 0.2 m, arm: 1 mm, load: 1 kN, coefficient: 0.2, moment: 50 N*m",
    "kind: wheel, radius: 2 mm, arm: 1 mm, load: 1 kN, coefficient: 0.2",
    "kind: wheel, radius: 2 mm, arm: 1 mm, load: 1 kN, coefficient: 0.2, moment: 1.2 N*m",
    "kind: journal, diameter: 50 mm, load: 2 kN, coefficient: 0.1, speed: 600 rpm",
    f"kind: crank, force: 1 kN, crank: 50 mm, rod: 200 mm, angle: 60 deg, coefficient: 0.1, {JOURNALS}",
    f"kind: crank, force: 1 kN, crank: 50 mm, rod: 200 mm, angle: 130 deg, coefficient: 0.1, {JOURNALS}",
)


@pytest.mark.parametrize("text", TEXTS)
def test_every_formula_agrees_with_the_second_way(text):
    (item,) = course.solve(loading.loads(f"language: en\ncontacts:\n  - {{{text}}}\n")).contacts.items
    assert item.s.computed() and disagreements(item.s, WAYS[item.kind](item.of)) == []


def test_every_formula_of_a_ready_variant():
    found = course.solve(loading.load(VARIANTS / "jack_and_belt.yaml")).contacts
    assert [disagreements(item.s, WAYS[item.kind](item.of)) for item in found.items] == [[]] * len(
        found.items
    )


def _incline(of):
    phi, load, slope = law.angle(of.f), of.load, of.angle
    level = of.force == "level"
    up = (law.up_plane if level else law.up_plane_along)(load, slope, phi)
    down = (law.down_plane if level else law.down_plane_along)(load, slope, phi)
    ideal = load * (math.tan(slope) if level else math.sin(slope))  # without friction
    return {"phi": phi, "F_up": up, "F_down": down, "eta": ideal / up, "eta_back": down / ideal}


def _wedge(of):
    face, base = law.angle(of.f), law.angle(of.f_base)
    force = law.wedge(of.load, of.angle, face, base)
    return {"phi": face, "phi_base": base, "F_in": force, "F_out": law.wedge_out(of.load, of.angle, face, base),
            "alpha_lock": face + base, "eta": of.load * math.tan(of.angle) / force}  # fmt: skip


def _sliders(of):
    """The driving force by what both sliders do in a small step: F dx η = Q dy."""
    face, guide = law.angle(of.f), law.angle(of.guides)
    both, theta = face + guide, of.between
    best = law.best_face(theta, both)
    alpha = best if of.face is None else of.face
    eta = law.guided_pair(theta, alpha, both)
    lifted = math.cos(alpha) / math.cos(theta - alpha)  # dy by dx
    return {"phi": face, "phi_guide": guide, "phi_both": both, "alpha_best": best, "alpha": alpha, "eta": eta,
            "eta_best": law.best_guided_pair(theta, both), "F": (of.load or 0.0) * lifted / eta}  # fmt: skip


def _trial(of):
    """The least force is level with the cone's side: G f/√(1 + f²)."""
    f, weight = law.pulled_and_pushed(of.pull, of.push, of.angle)
    return {"f": f, "G": weight, "phi": law.angle(f), "P_least": weight * f / math.hypot(1, f)}


def _screw(of):
    lead, phi = of.starts * of.pitch, law.reduced_angle(of.f, of.profile)
    psi = law.lead_angle(lead, of.diameter)
    thread = law.screw_moment(of.load, of.diameter, psi, phi)
    low = law.lowering_moment(of.load, of.diameter, psi, phi)
    collar = of.load * of.collar.coefficient * of.collar.radius if of.collar else 0.0
    work = of.load * lead / (2 * math.pi)  # of a radian
    whole = thread + collar
    return {"h": lead, "psi": psi, "phi_red": phi, "M_thread": thread, "M_low": low, "eta_thread": work / thread,
            "M_collar": collar, "M_screw": whole, "M_back": low + collar, "eta": work / whole,
            "P_hand": whole / (of.sharing * (of.arm or 1)),
            "D_wheel": 2 * whole / (of.sharing * (of.hand_force or 1))}  # fmt: skip


def _pivot(of):
    """Pressures of a run-in pivot fall with the radius, p = C/r; C by the sum over thin rings of one collar."""
    hole = of.outer * of.ratio if of.ratio else of.inner or 0.0
    each, one_by_one = of.load / of.collars, of.collars * of.surfaces
    about = each, of.f, of.outer, hole, of.half_cone
    pressure, wear = one_by_one * law.pivot_pressure(*about), one_by_one * law.pivot_wear(*about)
    rings = hole + (np.arange(1000) + 0.5) * (of.outer - hole) / 1000
    areas = 2 * math.pi * rings * (of.outer - hole) / 1000
    worn = each / np.sum(areas / rings)
    speed = of.speed or 0.0
    return {"r_inner": hole, "p_mean": each / areas.sum(), "p_max": worn / hole if hole else math.inf,
            "M_pressure": pressure, "M_wear": wear, "P_pressure": pressure * speed, "P_wear": wear * speed}  # fmt: skip


def _belt(of):
    f = law.grooved(of.f, of.groove)
    slack = law.slack(of.tight, f, of.wrap)
    held, radius = of.tight - slack, (of.diameter or 0.0) / 2
    v = (of.speed or 0.0) * radius
    return {"f_red": f, "T_2": slack, "F_t": held, "M_drum": held * radius, "v": v, "P": held * v}


def _belt_drive(of):
    """The power at another speed is less than at the best one, and equals it there."""
    driving, driven = of.diameters
    wrap, section = law.open_wrap(driving, driven, of.distance), of.width * of.thickness
    v, most, mass = of.speed * driving / 2, of.stress * section, (of.density or 0.0) * section
    own = mass * v**2
    slack = law.slack(most - own, of.f, wrap)
    held = most - own - slack
    ways = {"u": driven / driving, "alpha": wrap, "v": v, "T_max": most, "q": mass, "T_c": own,
            "T_1": most - own, "T_2": slack, "F_t": held, "P": held * v,
            "T_0": (most + slack + own) / 2}  # fmt: skip
    if of.density is None:
        return ways
    best = law.best_speed(most, mass)
    tight = most - mass * best**2
    return ways | {"v_best": best, "P_best": (tight - law.slack(tight, of.f, wrap)) * best}


def _wheel(of):
    moment = law.rolling_moment(of.load, of.arm)
    roll = moment / of.radius / of.load
    ways = {"M_roll": moment, "F_roll": moment / of.radius, "F_slide": of.f * of.load, "f_roll": roll,
            "phi_roll": law.angle(roll), "phi": law.angle(of.f)}  # fmt: skip
    if of.moment is None:
        return ways | ({"r_least": of.arm / of.f, "k_most": of.f * of.radius} if of.f <= roll else {})

    def asked(load, radius):
        """Coefficient that the moments about the axle ask for: M = T r + k N, T = f N."""
        return (of.moment - of.arm * load) / radius / load

    low = {key: _root(of.f, at) for key, at in (
        ("N_need", lambda x: asked(x, of.radius)), ("r_need", lambda x: asked(of.load, x)))}  # fmt: skip
    return ways | low | {
        "T": asked(of.load, of.radius) * of.load, "f_need": asked(of.load, of.radius),
        "M_most": of.f * of.load * of.radius + moment,
    }  # fmt: skip


def _root(wanted, of):
    """Where a falling function of a positive number is what is wanted, by bisection."""
    low, high = 1e-9, 1e9
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if of(middle) > wanted else (low, middle)
    return middle


def _journal(of):
    rho = law.friction_circle(of.f, of.diameter)
    return {"phi": law.angle(of.f), "rho": rho, "M_fr": of.load * rho,
            "P": of.load * rho * (of.speed or 0.0)}  # fmt: skip


def _crank(of):
    """Without friction the moment is the force by the velocity of the slider, ds/dφ, by a small turn."""
    shaft, pin, wrist = (law.friction_circle(of.f, d) for d in of.diameters)

    def stroke(phi):
        return of.crank * math.cos(phi) + math.sqrt(of.rod**2 - (of.crank * math.sin(phi)) ** 2)

    step = 1e-5
    ideal = of.force * (stroke(of.angle - step) - stroke(of.angle + step)) / (2 * step)
    circles = pin + (wrist if of.angle < math.pi / 2 else -wrist)
    tilt = law.tilted_rod(of.angle, of.crank, circles, of.rod)
    moment = law.crank_moment(of.force, of.angle, of.crank, tilt, shaft + pin)
    return {"rho_shaft": shaft, "rho_pin": pin, "rho_wrist": wrist, "tau": tilt, "M_ideal": ideal,
            "beta": law.tilted_rod(of.angle, of.crank, 0.0, of.rod), "M_crank": moment,
            "eta": moment / ideal}  # fmt: skip


WAYS = {
    "incline": _incline, "wedge": _wedge, "sliders": _sliders, "trial": _trial, "screw": _screw, "pivot": _pivot,
    "belt": _belt, "belt_drive": _belt_drive, "wheel": _wheel, "journal": _journal, "crank": _crank,
}  # fmt: skip
