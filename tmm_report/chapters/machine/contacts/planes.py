"""Numbers of friction on planes: inclines, wedges, guided sliders, screws. Angles in degrees, the rest SI."""

from __future__ import annotations

import math

from tmm_report.chapters.machine.contacts.given import Incline, Screw, Sliders, Trial, Wedge
from tmm_report.mechanics.pairs import friction as law

Numbers = dict[str, float]


def incline(of: Incline) -> Numbers:
    """Raising and lowering; the efficiency of lowering where the body drives, that is where the plane does not lock."""
    phi, slope, load = law.angle(of.rough.f), of.angle, of.load
    level = of.force == "level"
    up = (law.up_plane if level else law.up_plane_along)(load, slope, phi)
    down = (law.down_plane if level else law.down_plane_along)(load, slope, phi)
    ideal = load * (math.tan(slope) if level else math.sin(slope))
    found = {
        "Q": load, "alpha": math.degrees(slope), "f": of.rough.f, "phi": math.degrees(phi),
        "F_up": up, "F_down": down, "eta": ideal / up,
    }  # fmt: skip
    return found if slope <= phi else {**found, "eta_back": down / ideal}


def wedge(of: Wedge) -> Numbers:
    face, base = law.angle(of.rough.f), law.angle(of.base)
    force = law.wedge(of.load, of.angle, face, base)
    return {
        "Q": of.load, "alpha": math.degrees(of.angle), "f": of.rough.f, "phi": math.degrees(face),
        "f_base": of.base, "phi_base": math.degrees(base), "F_in": force,
        "F_out": law.wedge_out(of.load, of.angle, face, base),
        "alpha_lock": math.degrees(face + base), "eta": of.load * math.tan(of.angle) / force,
    }  # fmt: skip


def sliders(of: Sliders) -> Numbers:
    """The given face, or the best one; the driving force where the load is known."""
    face, guide = law.angle(of.rough.f), law.angle(of.guides)
    both, theta = face + guide, of.between
    best = law.best_face(theta, both)
    alpha = best if of.face is None else of.face
    eta = law.guided_pair(theta, alpha, both)
    found = {
        "theta": math.degrees(theta), "f": of.rough.f, "phi": math.degrees(face), "f_guide": of.guides,
        "phi_guide": math.degrees(guide), "phi_both": math.degrees(both), "alpha_best": math.degrees(best),
        "eta_best": law.best_guided_pair(theta, both), "alpha": math.degrees(alpha), "eta": eta,
    }  # fmt: skip
    if of.load is None:
        return found
    return {**found, "Q": of.load, "F": of.load * math.cos(alpha) / (math.cos(theta - alpha) * eta)}


def trial(of: Trial) -> Numbers:
    f, weight = law.pulled_and_pushed(of.pull, of.push, of.angle)
    phi = law.angle(f)
    return {
        "theta": math.degrees(of.angle), "P_pull": of.pull, "P_push": of.push, "f": f, "G": weight,
        "phi": math.degrees(phi), "P_least": weight * math.sin(phi),
    }  # fmt: skip


def screw(of: Screw) -> Numbers:
    """Moments of thread and collar, efficiency, and what the hands do."""
    lead, phi = of.starts * of.pitch, law.reduced_angle(of.rough.f, of.profile)
    psi = law.lead_angle(lead, of.diameter)
    thread = law.screw_moment(of.load, of.diameter, psi, phi)
    collar = of.load * of.collar[0] * of.collar[1] if of.collar else 0.0
    found = {
        "Q": of.load, "d_2": of.diameter, "p": of.pitch, "z": of.starts, "h": lead, "psi": math.degrees(psi),
        "beta": math.degrees(of.profile), "f": of.rough.f, "phi_red": math.degrees(phi), "M_thread": thread,
        "M_low": law.lowering_moment(of.load, of.diameter, psi, phi), "eta_thread": math.tan(psi) / math.tan(psi + phi),
        "M_screw": thread + collar, "eta": of.load * lead / (2 * math.pi * (thread + collar)),
    }  # fmt: skip
    if of.collar:
        found |= {"f_collar": of.collar[0], "R_collar": of.collar[1], "M_collar": collar}
        found |= {"M_back": found["M_low"] + collar}
    return found | _hands(of, thread + collar)


def _hands(of: Screw, moment: float) -> Numbers:
    if of.arm is not None:
        shared = {"n_hand": of.hands} if of.hands > 1 else {}
        return {"l_hand": of.arm, **shared, "P_hand": moment / (of.hands * of.arm)}
    if of.hand_force is not None:
        wheel = 2 * moment / (of.hands * of.hand_force)
        return {"P_hand": of.hand_force, "n_hand": of.hands, "D_wheel": wheel}
    return {}
