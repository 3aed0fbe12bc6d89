"""Force plans of mechanisms with wheels in mesh and of those that a slider or a cylinder drives, drawn at random.

Every link of a plan is in equilibrium with all that the loading scheme shows, about a point that no plan has used; so
is the mechanism as a whole; what balances it does the work of the loads; and every size is the analytical one.
"""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from conftest import stating
from test_planets import KINDS, finished, text
from test_wheels import five_bar

from tmm_report import course, loading
from tmm_report.chapters.lever.force_plans.drafting.plan import ForceDrawn, ForcePlan
from tmm_report.mechanics.calculus.vectors import cross

STEP = 1e-5  # m: a drawing by a program, read to a hundredth of a millimetre
HAND = 1e-4  # m: by a pencil, where arms stand in mm of paper
READ = 12  # steps to which readings add up in a chain of plans
ELSEWHERE = 0.37 - 0.21j  # m: about which moments are summed
STATEMENTS = Path(__file__).parents[3] / "statements"

RACK = (STATEMENTS / "rack_on_slider.yaml").read_text("utf-8")
DRIVEN_RACK = """\
mechanism:
  frame: {O: [0, 0], E: [180 mm, 0], F: [230 mm, 90 mm]}
  guides: {v: {through: F, angle: 25 deg}}
  links:
    1: {points: {O: 0, A: 50 mm}, mass: 2 kg, mass_centre: O}
    2: {points: {A: 0, B: 200 mm, S2: 90 mm}, mass: 3 kg, mass_centre: S2, inertia: 0.01 kg*m^2}
    3: {points: {E: 0, B: 120 mm}, mass: 2 kg, mass_centre: E, inertia: 0.01 kg*m^2}
    4: {points: {K: 0, S4: [20 mm, 10 mm]}, slides: v, mass: 5 kg, mass_centre: S4}
  racks: [{slider: 4, wheel: 3, side: %(side)s, radius: 60 mm, pressure_angle: 20 deg, phase: 40 deg}]
  driver: {link: 1, speed: 90 rpm}
  assembly: {B: left of A-E}
loads:
  gravity: 9.81 m/s^2
  forces: [{at: S4, direction: against motion, constant: 150 N}]
positions: {table: 12}
"""
BARE = """\
mechanism:
  frame: {O: [0, 0], Q: [%(far)s, -0.4 m]}
  links:
    1: {points: {O: 0, P: [0.8 m, %(up)s], D: [1.1 m, -0.1 m], S: [0.5 m, 0.1 m]}, mass: 30, mass_centre: S, inertia: 2}
    2: {points: {D: 0, E: 0.9 m}, mass: 4 kg, mass_centre: D, inertia: 0.1}
    3: {points: {E: 0}, mass: 6 kg, mass_centre: E, slides: x}
  guides: {x: {through: O, angle: 10 deg}}
  driver: {cylinder: [Q, P], stroke: {from: 0.9 m, harmonic: {amplitude: 0.15 m, frequency: 3 rad/s, phase: 1}}}
  assembly: {P: %(side)s of O-Q, E: right}
loads:
  gravity: 9.81 m/s^2
  forces: [{at: E, direction: against motion, constant: 400 N}]
positions: {table: 10}
"""


def stated(name: str) -> str:
    return (STATEMENTS / f"{name}.yaml").read_text("utf-8")


def at_random(kind, seed):
    rng = np.random.default_rng(500 + seed)
    return five_bar(rng)[0] if kind is five_bar else text(finished(kind(rng), rng))


MADE = {
    **{
        f"{kind.__name__} {seed}": (at_random, kind, seed) for kind in (*KINDS, five_bar) for seed in range(5)
    },
    "rack": (lambda: RACK,),
    "rack on the other side": (lambda: RACK.replace("68 mm", "-68 mm"),),
    "driven rack": (lambda: DRIVEN_RACK % {"side": "above"},),
    "driven rack below": (lambda: DRIVEN_RACK % {"side": "below"},),
    "press": (stated, "press_with_geared_cranks"),
    "tipper": (stated, "tipper_by_cylinder"),
    "slider": (stated, "slider_drives"),
    "slider backwards": (
        lambda: stated("slider_drives").replace("from: 0.35 m, to: 0.60 m", "from: 0.60 m, to: 0.35 m"),
    ),
    "boom": (lambda: (STATEMENTS.parent / "cases/explain/boom_by_cylinder.yaml").read_text("utf-8"),),
    "cylinder without links": (lambda: BARE % {"far": "0.7 m", "up": "0.2 m", "side": "left"},),
    "cylinder above": (lambda: BARE % {"far": "-0.2 m", "up": "-0.15 m", "side": "right"},),
}


@cache
def drawn(case: str, step: float = STEP) -> course.LeverFound:
    make, *of = MADE[case]
    variant = loading.loads(make(*of))
    positions = replace(variant.lever.positions, plans=(2, 5, 8), force_plan=(2, 5, 8))
    drawing = replace(variant.lever.drawing, accuracy=step)
    return course.solve(stating(variant, positions=positions, drawing=drawing)).lever


every = pytest.mark.parametrize("case", MADE)


def left(plan: ForcePlan) -> tuple[complex, float, float]:
    """What is left of the forces, N, and moments, N m, on the links of a plan, and the reach of the forces, m."""
    loads = [one for link in plan.links for one in plan.loads[link]]
    held = [one for one in plan.held if one.kind != "inner"]
    forces = [*((one.vector, one.at) for one in loads), *((one.vector, one.at) for one in held)]
    moment = sum(cross(at - ELSEWHERE, force) for force, at in forces)
    moment += sum(couple.value for link in plan.links for couple in plan.couples[link])
    moment += sum(one.couple for one in held) + (plan.drive.value if plan.drive else 0.0)
    reach = max((abs(at - ELSEWHERE) for _, at in forces), default=0.0)
    return sum((force for force, _ in forces), 0j), float(moment), reach


def tolerance(one: ForceDrawn, step: float = STEP) -> float:
    """N: what readings of all plans of a position may add up to."""
    return READ * max(plan.scale for plan in one.plans) * step * 1e3


@every
def test_every_plan_is_in_equilibrium(case):
    for one in drawn(case).force_plans.drawn:
        for plan in one.plans:
            force, moment, reach = left(plan)
            largest = max((abs(a.vector) for link in plan.links for a in plan.loads[link]), default=0.0)
            read = READ * largest * STEP * drawn(case).plans.length_scale * 1e3  # of arms
            assert abs(force) < tolerance(one), plan.label
            assert abs(moment) < reach * tolerance(one) + read + 1e-4 * abs(moment), plan.label


@every
def test_every_polygon_closes(case):
    """Head to tail from the pole back to it: its loads and the reactions, without components of a reaction."""
    for one in drawn(case).force_plans.drawn:
        for plan in one.plans:
            if plan.stage == "group":
                continue
            whole = {stroke.key for stroke in plan.strokes if stroke.kind != "component"}
            sides = [
                s for s in plan.strokes if s.kind != "component" or s.key.rpartition("_")[0] not in whole
            ]
            tip = 0j
            for side in sides:
                assert side.start == pytest.approx(tip, abs=1e-9), (plan.label, side.key)
                tip = side.end
            assert tip == pytest.approx(0, abs=1e-9), plan.label


@every
def test_the_whole_mechanism_is_in_equilibrium(case):
    """All loads, the reactions of the frame and what balances it; the force of a cylinder with links is inside."""
    found = drawn(case)
    inside = found.kinematics.stroke is not None and len(found.kinematics.stroke.by) == 2
    for one in found.force_plans.drawn:
        forces = [(force.vector, force.at) for _, force in one.acting]
        moment = sum(couple.value for _, couple in one.couples)
        for plan in one.plans:
            moment += plan.drive.value if plan.drive else 0.0
            for held in plan.held:
                if held.key.startswith("R_0") or (held.key == "F_stroke" and not inside):
                    forces.append((held.vector, held.at))
                    moment += held.couple
        moment += sum(cross(at - ELSEWHERE, force) for force, at in forces)
        reach = max(abs(at - ELSEWHERE) for _, at in forces)
        many = len(one.plans)
        assert abs(sum(force for force, _ in forces)) < many * tolerance(one)
        read = READ * max(abs(f) for f, _ in forces) * STEP * found.plans.length_scale * 1e3
        assert abs(moment) < many * (reach * tolerance(one) + read)


@every
@pytest.mark.parametrize("step", [STEP, HAND])
def test_sizes_are_the_analytical_ones(case, step):
    for one in drawn(case, step).force_plans.drawn:
        for row in one.comparison:
            room = tolerance(one, step) + 2e-3 * abs(row.analytic) + READ * row.floor
            assert row.graph == pytest.approx(row.analytic, abs=room), (one.position, row.key)


@every
def test_what_balances_does_the_work_of_the_loads(case):
    """By the powers alone, in which no reaction and no force in the teeth is; the lever reads the same."""
    found = drawn(case)
    solved, stroke = found.kinetostatics.table, found.kinematics.stroke
    power, scale = np.array(solved.power), np.array(solved.scale)
    if stroke is not None:
        transfer = stroke.transfer(stroke.law.of_phase(solved.motion.phase)[0])
        power, scale = power * transfer, scale * np.abs(transfer)
    floors = {d.position: max(c.floor for c in d.comparison if c.key in ("M_bal", "F_stroke"))
              for d in found.force_plans.drawn}  # fmt: skip
    for one in found.force_plans.drawn:
        k = one.position
        assert one.balancing == pytest.approx(power[k], abs=2e-3 * scale[k] + READ * floors[k])
    for lever in found.force_plans.levers:
        for row in lever.compared:
            room = 2e-3 * scale[lever.position] + READ * (row.floor + floors[lever.position])
            assert row.graph == pytest.approx(row.analytic, abs=room), (lever.position, row.key)


@every
def test_the_teeth_press_in_the_pitch_point_at_the_angle_of_engagement(case):
    """To the common tangent of the circles, so that the force drives the wheels apart, of a ring together."""
    found = drawn(case)
    motion, coupled = (
        found.kinematics.table,
        {one.link: one for one in found.kinematics.linkage.structure.coupled},
    )
    for one in found.force_plans.drawn:
        for plan in (p for p in one.plans if p.stage in ("wheel", "rack", "rolling")):
            wheel = coupled[plan.links[0]]
            mesh = wheel.mesh
            teeth = next(held for held in plan.held if held.key == f"R_{wheel.by}{wheel.link}")
            round_ = next(link for link in mesh.links if mesh.radius(link))
            axis = np.broadcast_to(motion.place(mesh.points[mesh.links.index(round_)]), motion.shape)[
                one.position
            ]
            out = (teeth.at - axis) / mesh.radius(round_)
            assert abs(out) == pytest.approx(1, abs=1e-9)  # on the pitch circle
            if abs(teeth.vector) > tolerance(one):
                apart = float((teeth.vector * np.conj(out)).real) / abs(teeth.vector)
                on_wheel = (1 if round_ == wheel.link else -1) * (1 if mesh.rings(round_) else -1)
                assert apart == pytest.approx(on_wheel * np.sin(mesh.pressure), abs=3e-3)
