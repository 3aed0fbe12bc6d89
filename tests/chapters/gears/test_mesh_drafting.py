"""The mesh on paper: touching flanks at every characteristic point, and what is read off against what is computed."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tmm_report import loading
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.chapters.gears.spur.solve.mesh import SCALES, TOOTH
from tmm_report.chapters.gears.spur.solve.readings import Reading, read_off
from tmm_report.mechanics.calculus.polygons import clearance
from tmm_report.quantity.paper import ACCURACY

GIVEN = {
    "reference": spur.Given(-2, 0.006, 0.130, wheels=("4", "5")),
    "multiplier": spur.Given(-0.5, 0.006, None, (28, 14)),
    "backlash": spur.Given(-2, 0.006, 0.130, (14, 28), shift=(0.15, 0.45)),
    "ring": spur.Given(3, 0.004, None, (20, 60), shift=(0.4, 1.0)),
    "ring drives": spur.Given(1 / 3, 0.004, None, (60, 20), shift=(1.0, 0.4)),
    "helical": spur.Given(-2, 0.004, None, (17, 34), helix=0.35),
}


@pytest.fixture(scope="module", params=GIVEN)
def found(request):
    return spur.solve(GIVEN[request.param])


@pytest.fixture(scope="module")
def mesh(found):
    return found.mesh


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


@pytest.mark.parametrize("accuracy", [1e-6, 1e-5, 1e-4, 5e-4])
def test_readings_keep_within_the_accuracy_of_the_drawing(mesh, accuracy):
    readings, step = read_off(mesh, accuracy), 1e3 * accuracy
    assert {r.key for r in readings} >= {"AB", "angle", "pitch", "ratio"}
    assert ("N1N2" in {r.key for r in readings}) == (mesh.seen("N1") and mesh.seen("N2"))
    for r in readings:
        if r.wheel is None:
            assert abs(r.drawn - r.computed) * mesh.mm < 1.5 * step, r
        elif r.key in ("angle", "pitch"):  # along the working circle
            assert abs(r.drawn - r.computed) * mesh.radius(mesh.pair.d_w, r.wheel) < 3 * step, r
        else:
            assert r.error < 0.2 * step, r


def test_readings_are_of_the_drawing_and_not_the_computed_values(found):
    readings = found.readings
    assert all(r.error > 0 for r in readings if r.key in ("angle", "ratio"))
    assert sum(r.error == 0 for r in readings) < len(readings) / 2


def test_the_stated_accuracy_reaches_the_readings():
    """Coordinates read to 2 mm of paper lie on its multiples: no segment is shorter but 0 or 2 mm."""
    coarse = spur.solve(replace(GIVEN["reference"], accuracy=2e-3))
    drawn = [(r.drawn * coarse.mesh.mm / 2) ** 2 for r in coarse.readings if r.wheel is None]
    assert drawn == pytest.approx(np.round(drawn), abs=1e-6)
    fine = spur.solve(GIVEN["reference"])
    assert max(r.error for r in fine.readings) < 2e-3 < max(r.error for r in coarse.readings)


def test_the_difference_is_that_of_the_course():
    """200 |a − b|/(a + b): of 3 by calculation and 2 by the drawing 40 per cent, not a third or a half."""
    assert 100 * Reading("AB", None, 2.0, 3.0).error == pytest.approx(40)


def test_the_accuracy_of_a_variant_is_said_and_used():
    text = Path("variants/hoist_drive.yaml").read_text("utf-8")
    stated = loading.loads(text + "\ndrawing: {accuracy: 0.1 mm}\n")
    assert stated.drive.stages[0].accuracy == 1e-4
    assert loading.loads(text).drive.stages[0].accuracy == ACCURACY


def test_the_teeth_are_at_least_40_mm_high_at_the_smallest_such_standard_scale(mesh):
    height = 1e3 * float(min(mesh.pair.height))
    assert mesh.scale in SCALES and mesh.scale * height >= TOOTH == 40
    assert not any(k * height >= TOOTH for k in SCALES if k < mesh.scale)


def test_the_reference_drawing():
    """Contact angle 17.261°, tooth angle 12.857°, ratio 1.3425 were read off a drawing at another scale."""
    found = spur.solve(GIVEN["reference"])
    read = {(r.key, r.wheel): r for r in found.readings}
    assert math.degrees(read["angle", 1].computed) == pytest.approx(17.261, abs=0.02)
    assert math.degrees(read["pitch", 1].computed) == pytest.approx(12.857, abs=1e-3)
    assert read["ratio", 1].drawn == pytest.approx(1.3425, rel=5e-3)
    assert read["ratio", 1].error < 2e-3


def test_the_outlines_prove_the_mesh(found):
    mesh, proof = found.mesh, found.proof
    if mesh.pair.internal or (mesh.pair.interference[0] > 0 and mesh.pair.interference[1] > 0):
        assert proof.overlap < 1e-12
        assert proof.ratio == pytest.approx(float(mesh.pair.eps), abs=4e-3)
    else:
        assert proof.ratio < float(mesh.pair.eps)


def test_the_contour_judges_by_the_limits_of_the_stage():
    found = spur.solve(GIVEN["reference"])
    contour = found.contour
    assert not contour.feasible and contour.chosen == complex(found.pair.x1, found.pair.x2)
    failed = {(c.key, c.wheel) for c in found.failed}
    assert {
        (lack.limit.kind, GIVEN["reference"].wheels[lack.limit.wheel - 1]) for lack in contour.lacks
    } == failed
    sound = spur.solve(spur.Given(-2, 0.006, 0.130, shift="limit"))
    assert sound.contour.feasible
