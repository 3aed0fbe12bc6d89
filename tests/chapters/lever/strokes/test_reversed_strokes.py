"""Mechanisms whose stroke no triangle follows, against a solver that shares no code with the program."""

import re

import numpy as np
import pytest
import yaml
from exhaustive import many
from stroke_constraints import Solver
from stroke_mechanisms import KINDS, made

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import stated
from tmm_report.chapters.lever.kinetostatics.solve.positions import at
from tmm_report.mechanics.lever.driving.reversed import Reversed
from tmm_report.problems import ProblemError

SEEDS = range(6)
CASES = [(kind, seed) for seed in SEEDS for kind in KINDS]


def backwards(text):
    """The same with the stroke the other way."""
    data = yaml.safe_load(text)
    stroke = data["mechanism"]["driver"]["stroke"]
    stroke["speed"] = -stroke["speed"]
    return yaml.safe_dump(data, sort_keys=False)


def going(kind, seed):
    """A mechanism that goes all the stroke: of a stroke that leads beyond its extreme the other way; one that begins
    beside its extreme, where the checks of the program lose digits, is drawn anew."""
    text = made(kind, seed)
    try:
        stroke = loading.loads(text).lever.mechanism.driver.stroke
    except ProblemError as error:
        (problem,) = error.problems
        assert re.search(r"cannot go beyond|comes to its own limit", problem.text())
        text = backwards(text)
        stroke = loading.loads(text).lever.mechanism.driver.stroke
    off = min(abs(end - s) for end in stroke.branch.s[[0, -1]] for s in stroke.law.reach)
    return text if off > 2e-3 * stroke.law.reach[1] else going(kind, seed + 1000)


def coordinates(solver, motion, k):
    """x, y, angle of every link by the program, in the order of the solver's."""
    found = []
    for name in solver.names:
        point, at = next(iter(solver.points[name].items()))
        turn = complex(motion.turn(name)[k])
        origin = complex(motion.place(point)[k]) - turn * at
        found += [origin.real, origin.imag, float(np.angle(turn))]
    return found


@pytest.mark.parametrize(("kind", "seed"), many(CASES, len(KINDS)))
def test_motion_and_forces_are_those_of_the_constraints(kind, seed):
    text = going(kind, seed)
    lever, solver = course.solve(loading.loads(text)).lever, Solver(text)
    table, forces = lever.kinematics.table, lever.kinetostatics.table
    assert isinstance(lever.kinematics.stroke, Reversed)
    assert lever.kinetostatics.agrees
    for k in (0, 3, 6):
        t = solver.period * k / 6
        near = np.array(coordinates(solver, table, k)) + 1e-5 * np.cos(np.arange(3 * len(solver.names)))
        motion = solver.motion(t, near)
        fast, sudden = np.abs(motion[1]).max(), np.abs(motion[2]).max()
        for name in solver.names:
            _, omega, epsilon = (part[3 * solver.names.index(name) + 2] for part in motion)
            assert float(table.angular_velocity(name)[k]) == pytest.approx(omega, abs=1e-9 * fast)
            assert float(table.angular_acceleration(name)[k]) == pytest.approx(epsilon, abs=1e-8 * sudden)
            for point, own in solver.points[name].items():
                place, v, a = solver.of_point(motion, name, own)
                assert complex(table.place(point)[k]) == pytest.approx(place, abs=1e-11)
                assert complex(table.velocity(point)[k]) == pytest.approx(v, abs=1e-9 * fast)
                assert complex(table.acceleration(point)[k]) == pytest.approx(a, abs=1e-8 * sudden)
        force, joints = solver.by_equilibrium(motion)
        assert solver.by_power(motion) == pytest.approx(force, rel=1e-9)
        assert float(forces.statics.driving[k]) == pytest.approx(force, rel=1e-8)
        size = max(map(abs, joints.values()))
        for (point, one, other), of in joints.items():
            if len([pin for pin in solver.pins() if pin[0] == point]) == 1:
                assert complex(np.ravel(forces.statics.force(other, one))[k]) == pytest.approx(
                    of, abs=1e-8 * size
                )


@pytest.mark.parametrize("kind", KINDS)
def test_the_work_of_the_force_is_gained_as_energy(kind):
    """∫ F ds over the stroke, by Gauss' rule, against kinetic energy, heights and the way of the stated force."""
    text = going(kind, 0)
    data, solver = yaml.safe_load(text), Solver(text)
    lever = course.solve(loading.loads(text)).lever
    x, w = np.polynomial.legendre.leggauss(24)
    phases = np.pi * (x + 1)
    motion = lever.kinematics.cycle.motion(np.array([0.0, *phases, 2 * np.pi]))
    turned = np.array([0.0, *phases, 2 * np.pi])
    given = lever.kinetostatics.given
    driving = at(given, motion, turned, stated(given, lever.kinematics, motion, turned)).statics.driving
    work = solver.speed * solver.period / 2 * (driving[1:-1] @ w)
    energy = 0.0
    for name, link in solver.links.items():
        if "mass" in link:
            centre = link["mass_centre"]
            v, y = np.abs(motion.velocity(centre)) ** 2, motion.place(centre).imag
            e = (
                link["mass"] * (v / 2 + 9.81 * y)
                + link.get("inertia", 0) * motion.angular_velocity(name) ** 2 / 2
            )
            energy += e[-1] - e[0]
    one = data["loads"]["forces"][0]
    way = motion.place(one["at"])[-1] - motion.place(one["at"])[0]
    angle = np.radians(float(one["direction"].split()[0]))
    energy -= one["constant"] * (np.exp(-1j * angle) * way).real
    assert work == pytest.approx(energy, rel=1e-9)


@pytest.mark.parametrize("kind", ["scissor", "two_sliders"])
def test_the_reduced_mass_has_the_energy_of_all_links(kind):
    """m v²/2 = T, by the rates of the constraints."""
    text = going(kind, 2)
    solver, lever = Solver(text), course.solve(loading.loads(text + "reduction: true\n")).lever
    table = lever.kinematics.table
    for k in (1, 4):
        motion = solver.motion(solver.period * k / 6, coordinates(solver, table, k))
        energy = 0.0
        for name, link in solver.links.items():
            if "mass" in link:
                _, v, _ = solver.of_point(motion, name, solver.points[name][link["mass_centre"]])
                omega = motion[1][3 * solver.names.index(name) + 2]
                energy += (link["mass"] * abs(v) ** 2 + link.get("inertia", 0) * omega**2) / 2
        assert lever.translation.table.whole_mass[k] == pytest.approx(2 * energy / solver.speed**2, rel=1e-9)


def test_the_motion_along_the_stroke_under_forces():
    """A scissor pushed by a constant force between its arms: the energy gained is the work of all that acts."""
    text, needed = next(
        (text, force)
        for text in (going("scissor", seed) for seed in SEEDS)
        if (force := course.solve(loading.loads(text)).lever.kinetostatics.table.statics.driving).min() > 0
    )
    data = yaml.safe_load(text)
    low, high = sorted(loading.loads(text).lever.mechanism.driver.stroke.law.reach)
    push = 1.3 * float(needed.max())
    data["travel"] = {"from": low, "to": high, "driving": [{"name": "oil", "constant": f"{push!r} N"}]}
    lever = course.solve(loading.loads(yaml.safe_dump(data, sort_keys=False)))
    found = lever.travel
    assert found.v[-1] > 0
    solver = Solver(text)
    motions = []
    for s, v in ((low, 0.0), (high, float(found.v[-1]))):
        solver.start, solver.speed = s, v
        near = lever.lever.kinematics.table
        k = int(np.argmin(np.abs(lever.lever.kinematics.stroke.law.of_phase(near.phase)[0] - s)))
        motions.append(solver.motion(0, coordinates(solver, near, k)))
    energy = []
    force = data["loads"]["forces"][0]
    along = np.exp(1j * np.radians(float(force["direction"].split()[0])))
    for motion in motions:
        total = (
            -force["constant"] * (np.conj(along) * solver.of_point(motion, *solver.at(force["at"]))[0]).real
        )
        for name, link in solver.links.items():
            if "mass" in link:
                place, v, _ = solver.of_point(motion, name, solver.points[name][link["mass_centre"]])
                omega = motion[1][3 * solver.names.index(name) + 2]
                total += link["mass"] * (abs(v) ** 2 / 2 + 9.81 * place.imag)
                total += link.get("inertia", 0) * omega**2 / 2
        energy.append(total)
    assert energy[1] - energy[0] == pytest.approx(push * (high - low), rel=1e-7)
