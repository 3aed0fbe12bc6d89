"""Drawings of a spur pair: what must be seen is there, at its length in millimetres of paper."""

import math
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from tmm_report.chapters.gears.spur.draw.action import CONTACT
from tmm_report.chapters.gears.spur.draw.contour import FIELD, Plane, contour, pieces_of
from tmm_report.chapters.gears.spur.draw.mesh import mesh_drawing
from tmm_report.chapters.gears.spur.draw.sheet import ACTIVE, TEETH
from tmm_report.chapters.gears.spur.draw.zones import BEYOND, WIDE, pairs_at, zones
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.chapters.gears.spur.view.pair import SpurView
from tmm_report.figures.charts.axes import ALONG
from tmm_report.figures.dimensions import span, spread
from tmm_report.figures.drawing import THICK, Arc, Path, Text, svg, tikz
from tmm_report.i18n import Translator
from tmm_report.quantity.text import number
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.report.paper.sheets import USUAL

GIVEN = {
    "external": spur.Given(-2, 0.006, 0.130, wheels=("4", "5")),
    "ring": spur.Given(3, 0.004, None, (20, 60), shift=(0.4, 1.0)),
    "ring drives": spur.Given(1 / 3, 0.004, None, (60, 20), shift=(1.0, 0.4)),
    "few teeth": spur.Given(-3, 0.01, None, (8, 24), shift=(0.5, 0.2)),
    "many teeth": spur.Given(-1.5, 0.003, None, (80, 120)),
}


def num(value):
    return number(value, 4)


@pytest.fixture(scope="module", params=GIVEN)
def found(request):
    return spur.solve(GIVEN[request.param])


@pytest.fixture(scope="module")
def mesh(found):
    return found.mesh


@pytest.fixture(scope="module")
def drawing(mesh, found):
    return mesh_drawing(mesh, found.given.wheels, num, "Gear pair")


def texts(drawing):
    return [texts_of(item) for item in drawing.items if isinstance(item, Text)]


def texts_of(item):
    return "".join(p if isinstance(p, str) else p.base + p.sub for p in item.parts)


def upright(drawing, x):
    """The upright straight lines of a drawing at x."""
    lines = [stroke for item in drawing.items if isinstance(item, Path) for stroke in item.strokes]
    return [line for line in lines if len(line) == 2 and all(abs(z.real - x) < 1e-9 for z in line)]


def strokes(drawing, pen):
    return [np.array(i.strokes[0]) for i in drawing.items if isinstance(i, Path) and i.pen == pen]


def test_three_teeth_of_each_wheel_with_their_working_flanks(drawing, mesh):
    assert len(strokes(drawing, TEETH)) == 2
    for i in (0, 1):
        flanks = strokes(drawing, ACTIVE[i])
        assert len(flanks) == 3
        angles = np.unwrap([np.angle(f[0] - mesh.centre(i)) for f in flanks])
        assert np.abs(np.diff(angles)) == pytest.approx(mesh.wheels[i].pitch_angle)


def test_working_flanks_lie_on_the_teeth(drawing):
    """Each flank is drawn on an outline, to the steps in which that is drawn, mm."""
    outlines = strokes(drawing, TEETH)
    for i in (0, 1):
        for flank in strokes(drawing, ACTIVE[i]):
            assert min(max(distance(z, outline) for z in flank) for outline in outlines) < 0.03


def distance(z, line):
    """From a polyline, mm."""
    start, along = line[:-1], np.diff(line)
    share = np.clip(((z - start) * along.conj()).real / np.maximum(np.abs(along) ** 2, 1e-12), 0, 1)
    return np.abs(z - start - share * along).min()


def test_every_circle_has_its_radius_on_paper_and_its_label(drawing, mesh, found):
    radii = [(item.centre, item.radius) for item in drawing.items if isinstance(item, Arc)]
    for i, name in enumerate(found.given.wheels):
        for key in ("d_a", "d_w", "d_b", "d_f"):
            radius = mesh.radius(getattr(found.pair, key), i)
            assert any(abs(c - mesh.centre(i)) < 1e-9 and abs(r - radius) < 1e-9 for c, r in radii), key
            value = num(float(getattr(found.pair, key)[i]) * 500)
            assert f"r{key[2:]}{name} = {value}" in texts(drawing)


def test_the_base_circle_of_a_wheel_of_1000_teeth_is_off_the_sheet():
    found = spur.solve(spur.Given(-25, 0.002, None, (40, 1000), shift=(0.0, 0.0)))
    drawing = mesh_drawing(found.mesh, found.given.wheels, num)
    assert USUAL.turns(drawing.size) or USUAL.sheet_of(drawing.size).name == "a3"
    assert {"rb1 = 37,59", "ra2 = 1002"} <= {text.replace(".", ",") for text in texts(drawing)}


def test_the_active_part_is_as_long_as_it_is(drawing, mesh):
    (line,) = strokes(drawing, CONTACT)
    assert abs(line[1] - line[0]) == pytest.approx(abs(mesh.length(mesh.pair.active)))


def test_points_of_the_line_of_action_are_lettered(drawing):
    assert {"N1", "N2", "A", "B", "C", "D", "P"} <= set(texts(drawing))


def test_the_drawing_fits_a_sheet_and_both_formats(drawing):
    held = USUAL.turns(drawing.size) or USUAL.sheet_of(drawing.size).name in ("a3", "a3tall")
    assert held and USUAL.percent(drawing.size) == 100
    ET.fromstring(svg(drawing))
    assert tikz(drawing).count("\n") > 40


def test_zones_add_up_to_the_active_part(mesh):
    drawing = zones(mesh, num, str)
    assert num(1e3 * abs(float(mesh.pair.active))) in texts(drawing)
    ET.fromstring(svg(drawing))


@pytest.mark.exhaustive
@pytest.mark.parametrize("distance, letters", [(0.1303, "ACPDB"), (0.136, "APB"), (0.14, "AB")])
def test_zones_letter_what_lies_on_the_active_part(distance, letters):
    """Shifted far apart the wheels have a contact ratio under 1, and then no pitch point on AB."""
    found = spur.solve(spur.Given(-2, 0.006, distance, (14, 28)))
    drawing = zones(found.mesh, num, str)
    left, _, right, _ = drawing.box
    assert right - left < WIDE + 2 * BEYOND + 5
    assert {text for text in texts(drawing) if text in "ACPDB"} == set(letters)


def test_zones_are_drawn_at_a_round_scale_and_lettered_apart():
    """A ruler reads them; with a contact ratio of little more than 1, C lies beside A and D beside B."""
    for distance in (0.130, 0.1322, 0.1329):
        drawing = zones(spur.solve(spur.Given(-2, 0.006, distance, (14, 28))).mesh, num, str)
        (scale,) = drawing.scales
        assert f"{scale.value:.6e}"[:8] in {f"{one:.6e}"[:8] for one in (1.0, 2.0, 2.5, 4.0, 5.0)}
        boxes = np.array([item.box for item in drawing.items if isinstance(item, Text)])
        low, high = np.maximum(boxes[:, None, :2], boxes[:, :2]), np.minimum(boxes[:, None, 2:], boxes[:, 2:])
        assert not np.triu((low < high).all(axis=-1), 1).any()


def test_the_line_of_the_pitch_point_does_not_cross_out_a_dimension(mesh):
    """Only the ends of zones are drawn down to the dimensions."""
    drawing = zones(mesh, num, str)
    (middle,) = [i.at.real for i in drawing.items if isinstance(i, Text) and texts_of(i) == "P"]
    lows = [min(z.imag for z in stroke) for stroke in upright(drawing, middle)]
    labels = [i for i in drawing.items if isinstance(i, Text) and texts_of(i)[0].isdigit()]
    top = max(text.at.imag for text in labels) + 1.4
    assert lows and min(lows) >= top


@pytest.mark.parametrize("ratio", [0.8, 1.0, 1.3432, 1.94, 2.6])
def test_pairs_in_mesh_are_the_contact_ratio_on_the_average(ratio):
    pitch = WIDE / ratio
    at = np.linspace(0, pitch, 40001)[:-1] + 1e-9
    assert pairs_at(at, pitch, WIDE).mean() == pytest.approx(ratio, abs=1e-3)


@pytest.mark.exhaustive
def test_the_contour_is_drawn_where_it_is(found):
    seen = found.contour
    plane = Plane(seen.window)
    step = 1 / plane.scale / 10.0 ** math.floor(math.log10(1 / plane.scale))
    assert min(abs(step - one) for one in (*ALONG, 10.0)) < 1e-9
    assert plane.corner.real < FIELD[0] + 1e-6 and plane.corner.imag < FIELD[1] + 1e-6
    drawing = contour(seen, found.given.wheels, num)
    borders, pieces = strokes(drawing, THICK), pieces_of(seen, plane)
    assert borders and len(borders) == len(pieces)
    for border, piece in zip(borders, pieces, strict=True):
        assert np.abs(border - piece).max() < 1e-12
        assert (
            min(np.abs(border - plane.at(whole)).max() for whole in seen.region if len(whole) == len(border))
            < 1e-12
        )
    assert "K" in texts(drawing) and ("L" in texts(drawing)) == (not seen.feasible)
    ET.fromstring(svg(drawing))


@pytest.mark.exhaustive
def test_tips_that_cannot_pass_each_other_are_said_so_without_a_number():
    """A ring of 41 teeth has no room for the tips of a pinion of 40: an overlap of ∞° says nothing."""
    found = spur.solve(spur.Given(1.025, 0.005, None, (40, 41)))
    view = SpurView(found, Page(Html(), Translator("en"), Numbering()), "pair")
    told = [str(lack) for lack in view.drawings.lacks()]
    assert "the tips of the ring and the pinion cannot pass each other" in told
    assert not any("∞" in text or "inf" in text for text in told)


def test_labels_of_a_column_keep_their_distance_and_their_middle():
    wanted = [0.0, 1.0, 2.0, 30.0, 31.0]
    placed = spread(wanted, 4.0)
    assert np.diff(placed).min() >= 4 - 1e-12
    assert np.mean(placed[:3]) == pytest.approx(1) and np.mean(placed[3:]) == pytest.approx(30.5)
    assert spread([0.0, 10.0], 4.0) == [0.0, 10.0]


def test_a_short_dimension_has_its_arrowheads_outside():
    def tips(length):
        return [item.strokes[0] for item in span(0, length) if item.closed]

    (_, low, _), (_, high, _) = tips(20.0)
    assert low.real > 0 and high.real < 20
    (_, low, _), (_, high, _) = tips(2.0)
    assert low.real < 0 and high.real > 2
