"""Every formula of the vibration against mechanics/masses/vibration.py, which finds the same in other ways."""

import math

import numpy as np
import pytest
from notes import VARIANTS
from twice import disagreements

from tmm_report import course, loading
from tmm_report.mechanics.masses import vibration as vib

BASE = "vibration:\n  mass: 40 kg\n  isolators: 4\n  stiffness: 2 N/mm\n  speed: 600 rpm\n"
TEXTS = {
    "forced": BASE + "  force: 60 N\n  damping: 30 N*s/m\n  start: {displacement: 3 mm, velocity: 20 mm/s}\n",
    "deflected": BASE.replace("stiffness: 2 N/mm", "deflection: 5 mm") + "  force: 60 N\n  damping: 30 N*s/m\n",
    "slow": BASE.replace("600 rpm", "100 rpm") + "  force: 60 N\n  damping_ratio: 0.2\n",
    "undamped": BASE + "  force: 60 N\n",
    "critical": BASE + "  force: 60 N\n  damping_ratio: 1\n  start: {displacement: 3 mm}\n",
    "rough": BASE + "  force: 60 N\n  damping_ratio: 1.6\n  start: {velocity: 0.1 m/s}\n",
    "unbalance": BASE + "  unbalance: {mass: 0.2 kg, radius: 30 mm}\n  damping_ratio: 0.1\n  transmissibility: 0.2\n",
    "base": BASE + "  base: 2 mm\n  damping_ratio: 0.15\n",
    "chosen": BASE.replace("  stiffness: 2 N/mm\n", "")
    + "  force: 60 N\n  damping_ratio: 0.1\n  transmissibility: 0.1\n",
    "dry": BASE + "  force: 60 N\n  friction: 5 N\n",
    "stood": BASE + "  force: 60 N\n  damping: 30 N*s/m\n"
    "  foundation: {mass: 90 kg, stiffness: 90 N/mm, damping: 200 N*s/m}\n",
    "hung": BASE + "  force: 60 N\n  damping: 10 N*s/m\n  absorber: {mass: 4 kg, springs: 2}\n",
    "clear": BASE.replace("600 rpm", "140 rpm") + "  force: 60 N\n  absorber: {clear: [0.8, 1.2]}\n",
    "free": "vibration: {mass: 40 kg, stiffness: 8 N/mm, damping: 30 N*s/m, "
    "start: {displacement: 3 mm, velocity: 0.1 m/s}}\n",
    "creeping": "vibration: {mass: 40 kg, stiffness: 8 N/mm, damping_ratio: 1.5, start: {displacement: 3 mm}}\n",
    "disc": "vibration:\n  inertia: 0.12 kg*m^2\n  stiffness: 300 N*m/rad\n  moment: 5 N*m\n  speed: 900 rpm\n"
    "  damping_ratio: 0.05\n  absorber: {inertia: 0.01 kg*m^2, springs: 3, arm: 60 mm}\n",
}  # fmt: skip


@pytest.mark.parametrize("name", TEXTS)
def test_every_formula_agrees_with_the_second_way(name):
    found = course.solve(loading.loads(TEXTS[name])).vibration
    assert disagreements(found.s, _ways(found)) == []


@pytest.mark.parametrize("name", ["locomotive_diesel", "forging_machine_wear"])
def test_every_formula_of_a_ready_variant(name):
    found = course.solve(loading.load(VARIANTS / f"{name}.yaml")).vibration
    assert disagreements(found.s, _ways(found)) == []


def _ways(found):
    given, body, omega = found.given, found.body, found.omega
    m, c, b = body
    zeta, natural = float(body.ratio), float(body.natural)
    eta, n = omega / natural, zeta * natural
    ways = {
        "stiffness": c if given.deflection is None else m * 9.81 / given.deflection, "damping": b,
        "stiffness_each": c / given.isolators, "natural": natural, "decay": n,
        "zeta": zeta, "sag": 9.81 / natural**2, "eta": eta, "static": found.force / c,
    }  # fmt: skip
    if vib.kind(zeta) != "critical":
        ways |= dict.fromkeys(("damped", "root"), abs(np.sqrt(complex(1 - zeta**2))) * natural)
    ways |= _free(found, *_at_start(found)) if given.free else _forced(found, eta, zeta, *_at_start(found))
    if given.transmissibility is not None:
        wanted = given.transmissibility
        needed = float(vib.eta_for(wanted, zeta))
        half = (needed**2 - (1 - wanted**2) / (wanted * needed) ** 2) * wanted**2 / 2  # sum of both roots
        ways |= {"half": half, "needed": needed, "needed_stiffness": m * (omega / needed) ** 2,
                 "most_damping": float(vib.zeta_for(wanted, eta))}  # fmt: skip
    if given.friction is not None:
        dry = vib.dry_amplitude(body._replace(damping=0.0), omega, found.force, given.friction)
        work = 4 * given.friction * dry  # of a cycle, as π k ω A² of a damper
        ways |= {"dry": dry, "equivalent": work / (math.pi * omega * dry**2)}
    return ways | _stood(found) | _hung(found, natural)


def _at_start(found):
    """Both constants, from the drawn motion's own place and velocity: those of the free part are what is missing."""
    start, phasor, s = found.given.start, 0j if found.given.free else found.phasor, found.s
    one = start.place - phasor.imag
    push = start.rate - found.omega * phasor.real + s.number("decay") * one
    return one, push / (s.get("damped") or s.get("root") or 1.0)


def _free(found, one, other):
    n, damped = found.s.number("decay"), found.s.get("damped")
    ways = {"C1": one, "C2": other}
    if damped:
        period = 2 * math.pi / damped
        tops = vib.free(found.body, np.array([0.0, period]), found.given.start.place, found.given.start.rate)
        falls = tops[0] / tops[1]
        ways |= {
            "period": period,
            "decrement": math.log(falls),
            "falls": falls,
            "begins": abs(complex(one, other)),
        }
    return ways | {"decay": n}


def _forced(found, eta, zeta, one, other):
    given, (m, c, _) = found.given, found.body
    still = given.base is None
    handed = float(vib.transmissibility(eta, zeta))
    moved = abs(found.phasor)
    peak, height = vib.peak(zeta)
    force = found.force
    if given.unbalance is not None:
        force = given.unbalance.mass * given.unbalance.radius * found.omega**2
    on_base = (
        abs(complex(vib.through(found.body, found.omega)) * found.phasor)
        if still
        else m * found.omega**2 * moved
    )
    return {
        "force": force, "beta": float(vib.magnification(eta, zeta)), "ratio": handed, "ratio_z": handed,
        "amplitude": moved, "lag": -np.angle(found.phasor) % (2 * np.pi), "on_base": on_base,
        "on_base_each": on_base / given.isolators, "growth": math.pi * force / c, "eta_peak": float(peak),
        "beta_peak": float(height), "eta_most": 1 / float(peak) if peak else None, "C1": one, "C2": other,
    }  # fmt: skip


def _stood(found):
    if found.stood is None:
        return {}
    low, high = found.stood.natural
    return {"pair_half": (low**2 + high**2) / 2, "pair_low": low, "pair_high": high,
            "gamma": abs(found.stood.machine) / abs(found.stood.under)}  # fmt: skip


def _hung(found, natural):
    if found.absorbed is None:
        return {}
    of, stated = found.absorbed, found.given.absorber
    low, high = of.natural
    tuned, best, damper = of.fitted
    arm = stated.arm or 1.0
    return {
        "mu": of.mu, "absorber": tuned.hung.inertia, "absorber_stiffness": tuned.hung.stiffness,
        "absorber_each": tuned.hung.stiffness / (stated.springs * arm**2),
        "absorber_swing": found.force * tuned.swing, "split_half": (low**2 + high**2) / 2, "split_low": low,
        "split_high": high, "best_natural": best.natural, "best_ratio": best.ratio,
        "lanchester_ratio": damper.hung.damping / (2 * damper.hung.inertia * natural),
    }  # fmt: skip
