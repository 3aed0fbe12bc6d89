"""The mesh on paper: touching flanks at every characteristic point, and what is read off against what is computed."""

import math

import numpy as np
import pytest

from tmm_report.chapters.spur import contour as blocking
from tmm_report.chapters.spur import solve as spur
from tmm_report.chapters.spur.mesh import SCALES, Mesh
from tmm_report.mechanics.polygons import clearance

GIVEN = {
    "reference": spur.Given(-2, 0.006, 0.130, wheels=("4", "5")),
    "multiplier": spur.Given(-0.5, 0.006, None, (28, 14)),
    "backlash": spur.Given(-2, 0.006, 0.130, (14, 28), shift=(0.15, 0.45)),
    "ring": spur.Given(3, 0.004, None, (20, 60), shift=(0.4, 1.0)),
    "ring drives": spur.Given(1 / 3, 0.004, None, (60, 20), shift=(1.0, 0.4)),
    "helical": spur.Given(-2, 0.004, None, (17, 34), helix=0.35),
}


@pytest.fixture(scope="module", params=GIVEN)
def mesh(request):
    found = spur.solve(GIVEN[request.param])
    return Mesh(found.pair, found.points)


def test_flanks_touch_on_the_line_of_action_from_A_to_B(mesh):
    for name in "ACPDB":
        one, other = (mesh.outline(i, mesh.place(name)) for i in (mesh.small, 1 - mesh.small))
        assert -2e-2 < clearance(one, other, mesh.pair.internal) < 2e-2, name  # mm of paper
        for i in (0, 1):
            radius = abs(mesh.points[name] - mesh.centre(i)) / mesh.mm
            assert mesh.flank(i, np.array([radius]), mesh.place(name))[0] == pytest.approx(
                mesh.points[name], abs=1e-6
            )


def test_the_line_of_action_touches_both_base_circles(mesh):
    for i in (0, 1):
        radius = mesh.points[f"N{i + 1}"] - mesh.centre(i)
        assert abs(radius) == pytest.approx(mesh.radius(mesh.pair.d_b, i))
        assert (radius.conjugate() * mesh.along).real == pytest.approx(0, abs=1e-9)
    assert abs(mesh.points["N1"] - mesh.points["N2"]) == pytest.approx(mesh.length(mesh.pair.line))


def test_readings_keep_within_the_accuracy_of_the_drawing(mesh):
    assert {r.key for r in mesh.readings} >= {"N1N2", "AB", "angle", "pitch", "ratio"}
    for r in mesh.readings:
        room = {"angle": 0.3, "pitch": 0.3}  # mm of the working circle
        if r.wheel is None:
            assert abs(r.drawn - r.computed) * mesh.mm < 0.15, r
        elif r.key in room:
            assert abs(r.drawn - r.computed) * mesh.radius(mesh.pair.d_w, r.wheel) < room[r.key], r
        else:
            assert r.error < 0.02, r


def test_readings_are_of_the_drawing_and_not_the_computed_values(mesh):
    assert all(r.error > 0 for r in mesh.readings if r.key in ("angle", "ratio"))
    assert sum(r.error == 0 for r in mesh.readings) < len(mesh.readings) / 2


def test_the_scale_is_a_standard_one_and_the_largest_that_fits(mesh):
    assert mesh.scale in SCALES and mesh._fits(mesh.scale)
    larger = [k for k in SCALES if k > mesh.scale]
    assert not any(mesh._fits(k) for k in larger)


def test_the_reference_drawing():
    """Contact angle 17.261°, tooth angle 12.857°, ratio 1.3425 were read off a drawing at another scale."""
    found = spur.solve(GIVEN["reference"])
    read = {(r.key, r.wheel): r for r in Mesh(found.pair, found.points).readings}
    assert math.degrees(read["angle", 1].computed) == pytest.approx(17.261, abs=0.02)
    assert math.degrees(read["pitch", 1].computed) == pytest.approx(12.857, abs=1e-3)
    assert read["ratio", 1].drawn == pytest.approx(1.3425, rel=5e-3)
    assert read["ratio", 1].error < 2e-3


def test_the_outlines_prove_the_mesh(mesh):
    if mesh.pair.internal or (mesh.pair.interference[0] > 0 and mesh.pair.interference[1] > 0):
        assert mesh.proof.overlap < 1e-12
        assert mesh.proof.ratio == pytest.approx(float(mesh.pair.eps), abs=4e-3)
    else:
        assert mesh.proof.ratio < float(mesh.pair.eps)


def test_the_contour_judges_by_the_limits_of_the_stage():
    found = spur.solve(GIVEN["reference"])
    contour = blocking.solve(found)
    assert not contour.feasible and contour.chosen == complex(found.pair.x1, found.pair.x2)
    failed = {(c.key, c.wheel) for c in found.failed}
    assert {
        (lack.limit.kind, GIVEN["reference"].wheels[lack.limit.wheel - 1]) for lack in contour.lacks
    } == failed
    sound = spur.solve(spur.Given(-2, 0.006, 0.130, shift="limit"))
    assert blocking.solve(sound).feasible
