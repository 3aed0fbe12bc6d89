"""Wheels and weights against the shaking moment as they are drawn: in mesh, of their ratio; weights by the moment that
their centrifugal forces have where they are drawn."""

from dataclasses import replace

import numpy as np
import pytest
from test_shaking_moment import COUPLES, case, found_in

from tmm_report.chapters.machine.balancing.draw import scale
from tmm_report.chapters.machine.balancing.draw_moment import WEIGHT, antiphase, antiphase_scale, geared
from tmm_report.figures.drawing import AXIS, NORMAL, Circle
from tmm_report.mechanics.masses.shaking_moment import Wheel, moment_of


def circles(drawing, *pens):
    return [one for one in drawing.items if isinstance(one, Circle) and one.pen in pens and one.radius > 1.5]


@pytest.mark.parametrize("ratio", [-1.0, -2.5, -0.4])
def test_a_wheel_meshes_with_its_mate_in_the_ratio_of_their_turns(ratio):
    found = found_in("crank_rocker", f"methods: [full, optimum, inertia], wheels: {{3: {ratio}}}")
    way = case(found, "inertia")
    mu = scale(found)
    for position in (0, 4):
        drawing = geared(found, way, position, mu)
        mate, wheel = circles(drawing, NORMAL)
        pivot = complex(found.kinematics.linkage.mechanism.links["0"].points["C"]) / mu
        assert mate.centre == pytest.approx(pivot)
        assert abs(wheel.centre - mate.centre) == pytest.approx(wheel.radius + mate.radius)
        assert mate.radius / wheel.radius == pytest.approx(-ratio)
        assert wheel.fill and not mate.fill


def test_an_idler_stands_between_what_turns_alike():
    found = found_in("crank_rocker", "methods: [full, optimum, inertia]")
    way = replace(case(found, "inertia"), wheels=(Wheel("3", 2.0, 1.0),))
    first, idler, wheel = circles(geared(found, way, 0, scale(found)), NORMAL)
    for one, other in ((first, idler), (idler, wheel)):
        assert abs(one.centre - other.centre) == pytest.approx(one.radius + other.radius)
    assert first.radius / wheel.radius == pytest.approx(2)


def test_a_link_made_heavier_has_a_ring_about_its_mass_centre():
    found = found_in("compressor", "methods: [full, optimum, inertia]")
    way = case(found, "inertia")
    heavier = [one for one in way.wheels if one.inertia and one.ratio == 1]
    assert heavier
    mu = scale(found)
    rings = circles(geared(found, way, 3, mu), AXIS)
    motion, links = found.kinematics.table, found.kinematics.linkage.mechanism.links
    wanted = [complex(motion.place(links[one.link].mass_centre)[3]) / mu for one in heavier]
    assert sorted(one.centre.real for one in rings) == pytest.approx(sorted(one.real for one in wanted))


@pytest.mark.parametrize("name", ["compressor", "slider_crank_offset"])
@pytest.mark.parametrize("position", [0, 1, 5, 10])
def test_weights_have_their_moment_where_they_are_drawn(name, position):
    """Σ (axis − O) × m (kω)² (weight − axis), and no force."""
    found = found_in(name, f"methods: [full, optimum, couples], {COUPLES}")
    way = case(found, "couples")
    mu = antiphase_scale(way)
    drawing = antiphase(found, way, position)
    axes = [one.centre * mu for one in circles(drawing, AXIS)]
    weights = [
        one.centre * mu for one in circles(drawing, NORMAL) if one.radius == WEIGHT and one.fill == "grey"
    ]
    omega = abs(float(found.kinematics.omega))
    pairs = [one for one in way.couples if one.moment]
    assert len(axes) == len(weights) == 2 * len(pairs) > 0
    force, moment = 0j, 0.0
    for k, (axis, weight) in enumerate(zip(axes, weights, strict=True)):
        one = pairs[k // 2]
        assert abs(weight - axis) == pytest.approx(one.radius)
        pull = one.mass * (one.order * omega) ** 2 * (weight - axis)
        force += pull
        moment += float((np.conj(axis) * pull).imag)
    turned = np.array([found.kinematics.turned[position] * found.kinematics.cycle.sense])
    wanted = float(moment_of(way.couples, turned, omega)[0])
    size = sum(one.amplitude for one in pairs)
    assert moment == pytest.approx(wanted, abs=1e-9 * size) and abs(force) < 1e-9 * size
