"""Dimensions of flywheels: moments of inertia summed up over the body, limits of the rim's speed, the drawings."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import solved

from tmm_report import course, loading
from tmm_report.chapters.machine.flywheel import draw
from tmm_report.chapters.machine.flywheel.sketch import scale_of, sketch
from tmm_report.mechanics.machine.flywheel import inertia as fly
from tmm_report.quantity.paper import ROUND

LOAD = "resisting: {table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}, speed: 12, delta: 1/25"


def alone(more: str):
    return course.solve(loading.loads(f"flywheel: {{{LOAD}, {more}}}")).flywheel


def of_ring(inner: float, outer: float, width: float, density: float) -> float:
    """∫ r² dm over a ring, by sums over its radius."""
    r = np.linspace(inner, outer, 20001)
    r = (r[1:] + r[:-1]) / 2
    return float(np.sum(r**2 * density * width * 2 * math.pi * r) * (outer - inner) / 20000)


@pytest.mark.parametrize("shape", ["disc: {width: 0.15}", "disc: {diameter: 1.1 m}", "material: cast iron"])
def test_a_disc_has_the_inertia_and_the_mass_that_are_wanted(shape):
    found = alone(shape)
    size, rho = found.s.number, found.given.metal.density
    assert of_ring(0.0, size("D") / 2, size("b"), rho) == pytest.approx(found.s.number("J_fl"), rel=1e-6)
    assert size("m") == pytest.approx(rho * size("b") * math.pi * size("D") ** 2 / 4)


@pytest.mark.parametrize(
    "shape", ["rim: {}", "rim: {diameter: 1.3 m, width: 2, spokes: 0.2}", "rim: {spokes: 0}"]
)
def test_a_rim_has_the_part_of_the_inertia_that_spokes_and_hub_leave(shape):
    found = alone(shape)
    size, rho = found.s.number, found.given.metal.density
    inner, outer = (size("D") - size("h")) / 2, (size("D") + size("h")) / 2
    part = 1 - found.given.shape.spokes
    assert of_ring(inner, outer, size("b"), rho) == pytest.approx(part * found.s.number("J_fl"), rel=1e-6)
    assert size("m") == pytest.approx(rho * size("b") * math.pi * (outer**2 - inner**2))
    assert size("b") == pytest.approx(found.given.shape.width * size("h"))


def test_a_stated_diameter_that_is_the_free_one_changes_nothing():
    free = alone("disc: {width: 0.2}")
    stated = alone(f"disc: {{diameter: {free.s.number('D')!r}}}")
    assert stated.s.number("b") == pytest.approx(free.s.number("b"))
    rim = alone("rim: {height: 0.1, width: 1.5}")
    again = alone(f"rim: {{diameter: {rim.s.number('D')!r}, width: 1.5}}")
    assert again.s.number("h") == pytest.approx(rim.s.number("h"))


def test_the_rim_is_fastest_at_its_outer_diameter_where_the_machine_is():
    found = alone("rim: {diameter: 1 m}, ratio: 3")
    assert found.s.number("v") == pytest.approx(3 * 12 * 1.02 * (1 + found.s.number("h")) / 2)
    assert found.s.number("sigma") == pytest.approx(7850 * found.s.number("v") ** 2)


def test_a_wheel_that_is_too_fast_is_told_the_diameter_that_is_not():
    found = alone("disc: {diameter: 1.5 m}, ratio: 8, material: cast iron")
    assert found.bursts and found.s.number("D_lim") < 1.5
    slow = alone(f"disc: {{diameter: {0.999 * found.s.number('D_lim')!r}}}, ratio: 8, material: cast iron")
    assert not slow.bursts


def test_a_material_by_its_numbers():
    found = alone("material: {density: 2700 kg/m^3, speed: 50 m/s}")
    assert (found.given.metal.density, found.given.metal.speed) == (2700, 50)


def test_hoop_stress_of_water_at_ten_metres_a_second():
    assert fly.hoop_stress(1000, 10) == 1e5


# --- drawings


@pytest.mark.parametrize("name", ["compressor", "punch_press"])
def test_the_energy_mass_diagram_fits_its_sheet_at_round_scales(name):
    found = solved(name).flywheel
    drawing = draw.energy_mass(found, ("J", "T"), str)
    assert drawing.size[0] < 165 and drawing.size[1] < 165
    for scale in (found.s.number("mu_J"), found.s.number("mu_T")):
        power = 10.0 ** math.floor(math.log10(scale * (1 + 1e-12)))
        assert min(abs(scale / power - one) for one in ROUND) < 1e-9


@pytest.mark.parametrize("shape", ["disc: {}", "rim: {}"])
def test_the_sketch_is_as_large_as_the_wheel_at_its_scale(shape):
    found = alone(shape)
    drawn = sketch(found, lambda x: f"{x:.4g}")
    circles = [item.radius for item in drawn.items if hasattr(item, "radius")]
    assert max(circles) * 2 * scale_of(found) == pytest.approx(found.s.number("D_out"))
    letters = "".join(
        str(item.parts) for item in drawn.items if hasattr(item, "parts") and hasattr(item, "at")
    )
    assert f"{1e3 * found.s.number('D_out'):.4g}" in letters and f"{1e3 * found.s.number('b'):.4g}" in letters
