"""Two pairs of teeth in contact, conjugate points and the graph of specific sliding, measured on the paper."""

import math

import numpy as np
import pytest

from tmm_report.chapters.gears.spur.draw.phase import phase_drawing
from tmm_report.chapters.gears.spur.draw.sliding import CURVES, sliding_drawing
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.chapters.gears.spur.solve.mesh import ROUND, TALL, round_scale
from tmm_report.figures.drawing import DASHED, Arc, Circle, Path, Text
from tmm_report.mechanics.calculus.polygons import clearance
from tmm_report.quantity.text import number
from tmm_report.report.paper.sheets import USUAL

GIVEN = {
    "reference": spur.Given(-2, 0.006, 0.130, wheels=("4", "5")),
    "multiplier": spur.Given(-0.5, 0.006, None, (28, 14)),
    "ring": spur.Given(3, 0.004, None, (20, 60), shift=(0.4, 1.0)),
    "ring drives": spur.Given(1 / 3, 0.004, None, (60, 20), shift=(1.0, 0.4)),
    "helical": spur.Given(-2.5, 0.003, 0.125, helix=0.2094395, shift="equal sliding"),
    "three pairs": spur.Given(-1.5, 0.003, None, (80, 120), rack=spur.Rack(math.radians(15), 1.1, 0.2)),
}


def num(value):
    return number(value, 4)


@pytest.fixture(scope="module", params=GIVEN)
def found(request):
    return spur.solve(GIVEN[request.param])


def way(found, name):
    return found.phase.points[name] - found.path.points["P"]


def test_teeth_touch_in_both_points_at_once(found):
    """Where the outlines are placed to touch in K1, they touch in K2, a base pitch on, and share no area."""
    mesh = found.mesh
    one, other = (mesh.outline(i, way(found, "K1")) for i in (mesh.small, 1 - mesh.small))
    assert -2e-2 < clearance(one, other, mesh.pair.internal) < 2e-2
    for i in (0, 1):
        k2 = mesh.length(way(found, "K2")) * mesh.along
        radius = np.array([found.phase.radii[i][1]])
        flanks = [mesh.flank(i, radius, way(found, "K1"), tooth)[0] for tooth in (-1, 1)]
        assert min(abs(z - k2) for z in flanks) < 1e-6


def test_the_points_of_contact_are_a_base_pitch_apart_on_the_active_part(found):
    k1, k2 = (found.phase.points[name] for name in ("K1", "K2"))
    a, b = (found.path.points[name] for name in "AB")
    assert abs(k2 - k1) == pytest.approx(float(found.pair.p_b))
    assert abs(k1 - a) == pytest.approx(abs(b - k2)) and (k1 - a) * (b - k1) > 0


def test_conjugate_points_come_together_in_t(found):
    """The points of the flanks at the radii of T, turned until they touch, are one point: T."""
    mesh = found.mesh
    t = mesh.length(way(found, "T")) * mesh.along
    for i in (0, 1):
        radius = np.array([found.phase.radii[i][2]])
        assert mesh.flank(i, radius, way(found, "T"))[0] == pytest.approx(t, abs=1e-6)
        before = complex(mesh.flank(i, radius, way(found, "K1"))[0])
        assert abs(before - mesh.centre(i)) == pytest.approx(abs(t - mesh.centre(i))) and abs(before - t) > 2


def test_the_drawing_letters_what_the_rule_needs(found):
    drawing = phase_drawing(found.mesh, found.phase, found.given.wheels, num)
    letters = {
        "".join(p if isinstance(p, str) else p.base + p.sub for p in i.parts)
        for i in drawing.items
        if isinstance(i, Text)
    }
    assert {"K1", "K2", "T", "t1", "t2", "A", "B", "P"} <= letters
    dots = [item.centre for item in drawing.items if isinstance(item, Circle) and item.radius == 0.9]
    for name in ("K1", "K2", "T"):
        at = found.mesh.length(way(found, name)) * found.mesh.along
        assert min(abs(z - at) for z in dots) < 1e-9
    assert USUAL.sheet_of(drawing.size) is None or USUAL.percent(drawing.size) == 100


def test_each_arc_of_the_rule_is_about_its_own_axis_and_ends_in_t(found):
    mesh = found.mesh
    drawing = phase_drawing(mesh, found.phase, found.given.wheels, num)
    t = mesh.length(way(found, "T")) * mesh.along
    arcs = [item for item in drawing.items if isinstance(item, Arc) and item.pen.dash == DASHED.dash]
    assert [arc.centre for arc in arcs] == [mesh.centre(0), mesh.centre(1)]
    assert all(arc.at(arc.end) == pytest.approx(t, abs=1e-6) for arc in arcs)


@pytest.mark.exhaustive
def test_one_pair_in_mesh_has_no_second_point():
    assert spur.solve(spur.Given(-2, 0.006, 0.1365, (14, 28))).phase is None


def test_the_graph_of_sliding_stands_on_the_line_of_action_at_its_scale(found):
    mesh, per_mm = found.mesh, found.sliding_scale
    drawing = sliding_drawing(mesh, found.given.wheels, per_mm, num)
    for i, pen in enumerate(CURVES):
        (curve,) = [np.array(p.strokes[0]) for p in drawing.items if isinstance(p, Path) and p.pen == pen]
        assert abs(curve[-1].real - curve[0].real) == pytest.approx(
            mesh.length(abs(float(found.pair.active)))
        )
        rho = curve.real / mesh.mm + mesh.places["P"]
        slid = (found.pair.sliding(rho).first, found.pair.sliding(rho).second)[i]
        assert curve.imag * per_mm == pytest.approx(slid, abs=1e-9)
        assert np.abs(curve.imag).max() <= TALL


def test_the_names_of_the_points_under_the_graph_stand_apart():
    """C is 0.08 mm of paper from P."""
    found = spur.solve(spur.Given(2.5, 0.002, None, (24, 60), shift=(0.3, 0.3)))
    drawing = sliding_drawing(found.mesh, found.given.wheels, found.sliding_scale, num)
    texts = [text for text in drawing.items if isinstance(text, Text)]
    foot = min(text.at.imag for text in texts)
    names = sorted(text.at.real for text in texts if text.at.imag == foot)
    assert len(names) >= 5
    assert min(np.diff(names)) >= 3.9


@pytest.mark.parametrize("largest", [0.02, 0.4, 1.1634, 4.0, 4.321, 130.0])
def test_the_scale_of_sliding_is_round_and_fills_the_height(largest):
    scale = round_scale(largest)
    digits = scale / 10 ** math.floor(math.log10(scale) + 1e-9)
    assert min(abs(digits - n) for n in ROUND) < 1e-9
    assert TALL / 2.5 - 1e-9 <= largest / scale <= TALL * (1 + 1e-9)
