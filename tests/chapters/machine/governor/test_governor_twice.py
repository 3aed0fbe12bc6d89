"""Every formula of a governor, its loop and its brake by a second way: mechanics' numpy, differences, another law."""

import numpy as np
import pytest
from notes import VARIANTS
from twice import disagreements, rows_disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.governor import equations, rows
from tmm_report.chapters.machine.governor.quantities import of_brake, of_direct
from tmm_report.chapters.machine.governor.view.brake import BrakeView
from tmm_report.i18n import Translator
from tmm_report.mechanics.machine.governor import equilibrium as g
from tmm_report.mechanics.machine.governor import stability as small
from tmm_report.quantity.written import variables
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

ARMS = (
    "  arms: {upper: 300 mm, lower: 280 mm, upper_offset: 20 mm, lower_offset: 40 mm}\n"
    "  sleeve: {mass: 40 kg, friction: 5 N}\n  radius: {lowest: 150 mm, highest: 200 mm}\n"
)
CRANK = (
    "  bell_crank: {ball_arm: 120 mm, sleeve_arm: 80 mm, fulcrum: 140 mm, level: %s}\n"
    "  radius: {lowest: 120 mm}\n  lift: 20 mm\n"
)
MACHINE = (
    "  machine: {inertia: 60 kg*m^2, ratio: 1.2, torque: {full: 400 N*m, slope: 3 N*m*s/rad}, "
    "load: {before: 200 N*m, after: 260 N*m, slope: 1 N*m*s/rad}, "
    "throttle: {least: 5 %, force: 2 N, insensitivity: 3 %}}\n"
)
TEXTS = {
    "Watt": "  arms: {upper: 400 mm, lower: 400 mm}\n  balls: {mass: 2 kg}\n"
    "  radius: {lowest: 200 mm}\n  lift: 40 mm\n",
    "beyond the pin": ARMS + "  balls: {mass: 3 kg, distance: 380 mm}\n",
    "Proell": ARMS.replace("upper_offset: 20 mm, ", "") + "  balls: {extension: 100 mm}\n  choose: {balls: 150 rpm}\n",
    "sleeve": ARMS.replace("mass: 40 kg, ", "") + "  balls: {mass: 5 kg}\n  choose: {sleeve: 180 rpm}\n"
    "  spring: {stiffness: 2 kN/m, force: 50 N}\n",
    "spring": ARMS + "  balls: {mass: 6 kg, count: 3}\n  choose: {spring: [170 rpm, 230 rpm]}\n",
    "level": CRANK % "true" + "  balls: {mass: 2 kg}\n  spring: {stiffness: 10 kN/m, force: 1600 N}\n",
    "direct": ARMS + "  balls: {mass: 6 kg}\n" + MACHINE,
    "steep": ARMS + "  balls: {mass: 6 kg}\n" + MACHINE.replace(", slope: 3 N*m*s/rad", ""),
    "piston": CRANK % "false" + "  balls: {mass: 2 kg}\n  choose: {spring: [300 rpm, 330 rpm]}\n"
    + MACHINE + "  servo: {time: 0.3 s}\n",
    "isodrome": ARMS + "  balls: {mass: 6 kg}\n" + MACHINE
    + "  servo: {time: 0.3 s, isodrome: {time: 1 s, feedback: 0.4}}\n",
    "brake": "  brake: {mass: 1 kg, radius: 60 mm, gap: 2 mm, drum: 80 mm, friction: 0.3, "
    "spring: {stiffness: 20 kN/m, force: 3 N}, moment: 10 N*m, inertia: 2 kg*m^2}\n",
    "brake on arms": "  brake: {mass: 1 kg, radius: 60 mm, gap: 2 mm, drum: 80 mm, friction: 0.3, "
    "spring: {stiffness: 20 kN/m, force: 3 N}, moment: 10 N*m, inertia: 2 kg*m^2, "
    "arm: {pivot: 50 mm, shoe: 70 deg, mass_centre: 90 deg, spring: 40 mm, ahead: pivot}}\n",
    "mass of a brake": "  brake: {radius: 60 mm, gap: 2 mm, drum: 80 mm, friction: 0.3, "
    "spring: {stiffness: 20 kN/m, force: 3 N}, moment: 10 N*m, choose: {mass: 40 rad/s}, "
    "arm: {pivot: 50 mm, shoe: 70 deg, mass_centre: 90 deg, spring: 40 mm, ahead: shoe}}\n",
    "spring of a brake": "  brake: {mass: 3 kg, radius: 60 mm, gap: 2 mm, drum: 80 mm, friction: 0.3, "
    "spring: {stiffness: 20 kN/m}, moment: 10 N*m, choose: {spring: 60 rad/s}}\n",
}  # fmt: skip
NAMES = [*TEXTS, "governor_porter", "governor_servo", "descent_brake"]


def found_of(name):
    text = (
        "governor:\n" + TEXTS[name]
        if name in TEXTS
        else (VARIANTS / f"{name}.yaml").read_text(encoding="utf-8")
    )
    return course.solve(loading.loads(text)).governor


@pytest.mark.parametrize("name", NAMES)
def test_every_formula_agrees_with_the_second_way(name):
    found = found_of(name)
    if found.direct is not None:
        ways = _by_itself(found.direct) | (_in_loop(found.loop) if found.loop else {})
        assert disagreements(found.direct.s, ways) == []
    if found.brake is not None:
        assert disagreements(found.brake.s, _braking(found.brake)) == []


@pytest.mark.parametrize("name", NAMES)
def test_formulas_of_places_agree_with_the_tables(name):
    found = found_of(name)
    if found.direct is not None:
        assert rows_disagreements(of_direct(found.direct), rows.formulas(found.direct).values()) == []
    if found.brake is not None:
        moment = BrakeView(found.brake, Page(Html(), Translator("en"), Numbering())).moment()
        assert rows_disagreements(of_brake(found.brake), [moment]) == []


@pytest.mark.parametrize("name", [name for name in NAMES if found_of(name).loop])
def test_equations_hold_in_the_steady_state_and_give_the_matrix(name):
    found = found_of(name).loop
    for relation in equations.motion(found):
        sizes = [abs(one.number) for one in variables(relation.right)]
        left, right = relation.left.evaluate(), relation.right.evaluate()
        assert left == pytest.approx(right, rel=1e-7, abs=1e-7 * max(sizes))
    ours = [relation.right.evaluate() for relation in equations.small(found)]
    assert np.array(ours) == pytest.approx(found.matrix, rel=1e-12, abs=1e-12)
    if found.servo is None:
        assert _nought(equations.characteristic(found), found.eigenvalues, found.s.number("a_0"))
        q = found.eigenvalues / found.s.number("p")
        assert _nought(equations.normal(found), q, 1.0)


def _nought(relation, roots, factor):
    """Whether its left side is nothing at the roots beside the sum of its terms there; `factor`: the first one's."""
    size = np.polyval(np.abs(np.poly(roots)), np.abs(roots)).max()
    return np.abs(relation.left.evaluate()).max() < 1e-9 * size * abs(factor)


def _by_itself(found):
    given, lift, middle = (
        found.given,
        found.lift,
        found.given.geometry.moves(np.array([found.lift / 2]), found.given.lowest),
    )
    effort = float(g.effort(found.table.E[found.middle], given.effort))
    ways = {"delta": g.nonuniformity(*found.ends), "effort": effort, "power": effort * lift}
    if (chosen := given.choose) is None:
        return ways
    if chosen.spring is not None:
        ends = given.geometry.moves(np.array([0.0, lift]), given.lowest)
        low, high = map(float, g.spring_force(ends, given.weights, np.array(chosen.spring)))
        return ways | {"F_0": low, "spring_top": high, "c": (high - low) / lift}
    way = ("m", g.ball_mass) if chosen.balls else ("m_0", g.sleeve_mass)
    return ways | {way[0]: float(way[1](middle, given.weights, chosen.middle)[0])}


def _in_loop(found):
    plant, s, after, e = found.plant, found.s, found.after, 1e-3
    wanted, mean = plant.throttle.insensitivity, found.direct.mean / plant.ratio

    def excess(omega):
        """Of the drive over the load with the supply kept, N m: a straight line."""
        over = omega - mean
        return (plant.torque.full - plant.torque.slope * over) * after.s - plant.load.slope * over

    def lifted(omega):
        return found.there.A[0] * (plant.ratio * omega) ** 2

    ways = {
        "D": (excess(after.omega - e) - excess(after.omega + e)) / (2 * e),
        "R": (lifted(after.omega + e) - lifted(after.omega - e)) / (2 * e),
        "static": after.omega / found.before.omega - 1,
    }  # fmt: skip
    if wanted is not None:
        sticks = plant.throttle.force + found.direct.given.sleeve.friction
        ways |= {"F_allowed": float(g.friction_for(found.direct.table.E, wanted).min()), "F_sum": sticks}
    if found.servo is not None:
        return ways | {"b_t": found.servo.beta * g.nonuniformity(*found.direct.ends)}
    cubic = small.polynomial(found.loop) * found.loop.J * found.loop.m
    x, y = small.vyshnegradsky(cubic) if "X" in s else (None, None)
    ways |= {f"a_{k}": float(cubic[k]) for k in range(4)}
    return ways | {"Q_s": found.loop.Q, "X": x, "Y": y, "XY": x * y if x else None}


def _braking(found):
    shoes, given = found.shoes, found.given
    held = float(shoes.held(given.moment))
    return {
        "rho_contact": shoes.at_contact, "F": shoes.spring, "contact": shoes.contact, "K": shoes.K, "held": held,
        "spread": (held - shoes.contact) / shoes.contact, "power": given.moment * held,
        "pressing": given.moment / (given.count * given.friction * given.drum),  # all shoes hold the moment
        "contact_time": shoes.time_to(0.0, given.moment, given.inertia) if given.inertia else None,
        **_on_arms(shoes, given), **_chosen(shoes, given),
    }  # fmt: skip


def _chosen(shoes, given):
    if given.choose is None:
        return {}
    name, value = ("m", shoes.mass) if given.choose.mass else ("F_0", shoes.preload)
    return {name: value}


def _on_arms(shoes, given):
    """Distances from the pivot by cross products of the directions of the forces."""
    if given.arm is None:
        return {}
    pivot, lever = given.arm.pivot, shoes.lever
    at, centre = (np.exp(1j * angle) for angle in (given.arm.shoe, given.arm.mass_centre))
    tangent = abs(((given.drum * at - pivot).conjugate() * 1j * at).imag)
    back = shoes.turned_back()
    return {
        "l_C": abs((pivot * centre).imag), "l_N": abs((pivot * at).imag), "l_T": tangent, "theta": shoes.swing,
        "f_lock": lever.normal / tangent, "back": None if back.locks else float(back.held(given.moment)),
    }  # fmt: skip
