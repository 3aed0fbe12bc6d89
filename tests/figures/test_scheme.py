"""Every kind of mechanism is drawn: to scale, inside its box and the page, with few labels on one another."""

import xml.etree.ElementTree as ET
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from mechanisms import CASES, compressor, four_bar, offset_slider, rotated, scotch_yoke

from tmm_report.figures.drawing import Circle, Path, Text, svg, tikz
from tmm_report.figures.placing import AWAY, LEADER
from tmm_report.figures.schemes.bodies import Motion, bodies
from tmm_report.figures.schemes.marks import JOINT
from tmm_report.figures.schemes.scheme import (
    GROUPS_PAGE,
    groups_apart,
    positions_scheme,
    scheme,
    standard_scale,
)
from tmm_report.figures.schemes.superposed import SMALL
from tmm_report.mechanics.lever.mechanism import Link

GROUPS = [("I (0,1)", ("0", "1")), ("II (2,3)", ("2", "3"))]


def overlap(a, b):
    wide, tall = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    return wide > 0.2 and tall > 0.2


def crowded(drawing):
    """How many pairs of labels lie on one another."""
    boxes = [item.box for item in drawing.items if isinstance(item, Text)]
    return sum(overlap(a, b) for a, b in combinations(boxes, 2))


def joints(drawing):
    return [item.centre for item in drawing.items if isinstance(item, Circle) and item.radius == JOINT]


@pytest.mark.parametrize("name", CASES)
def test_every_mechanism_is_drawn_inside_the_page(name):
    mechanism, places, turns = CASES[name]()
    for position in (0, 7):
        one = scheme(mechanism, places, turns, None, position)
        every = positions_scheme(mechanism, places, turns, None, position, paths=CASES[name](36)[1])
        apart = groups_apart(mechanism, places, turns, GROUPS, position).drawing
        for drawing in (one, every, apart):
            ET.fromstring(svg(drawing))
            assert "nan" not in tikz(drawing)
            assert drawing.size[0] <= 170 and drawing.size[1] <= 230
        assert apart.size[1] <= GROUPS_PAGE[1]
        assert crowded(one) == crowded(every) == crowded(apart) == 0


@pytest.mark.parametrize("name", CASES)
def test_nothing_is_clipped(name):
    drawing = scheme(*CASES[name](), None, 3)
    left, bottom, right, top = drawing.box
    for item in drawing.items:
        for z in (z for stroke in item.outline() for z in stroke):
            assert left <= z.real <= right and bottom <= z.imag <= top


def test_lengths_are_to_scale():
    mechanism, places, turns = compressor()
    drawing = scheme(mechanism, places, turns, 0.004, 2)
    for point in "OABCD":
        assert min(abs(z - places[point][2] / 0.004) for z in joints(drawing)) < 1e-9
    rods = [
        item.strokes[0]
        for item in drawing.items
        if isinstance(item, Path) and item.pen and item.pen.width == 0.6
    ]
    lengths = [abs(b - a) for a, b in rods]
    for expected in (25, 75, 77.5):
        assert min(abs(length - expected) for length in lengths) < 1e-9


def test_the_scale_is_the_finest_standard_one():
    assert standard_scale(*compressor()) == 0.005
    assert standard_scale(*offset_slider()) == 0.002


def test_a_point_within_a_straight_link_bends_nothing():
    body = bodies(Motion(*compressor(), 0.005))["2"]
    assert (
        body.plate == ()
        and len(body.bars) == 1
        and abs(body.bars[0][1] - body.bars[0][0]) == pytest.approx(60)
    )


def throws():
    """The compressor with a second throw of its crank, at a right angle, and a point of the frame below."""
    mechanism, places, turns = compressor()
    crank = replace(mechanism.links["1"], points={"O": 0, "A": 0.1, "E": 0.07j})
    more = {
        "0": replace(mechanism.links["0"], points={"O": 0, "W": -0.2j}),
        "1": crank,
        "6": Link("6", {"E": 0, "F": 0.05}),
    }
    places |= {"E": 0.07j * turns["1"], "F": 0.07j * turns["1"] + 0.05, "W": np.full(12, -0.2j)}
    return replace(mechanism, links=mechanism.links | more), places, turns | {"6": np.ones(12)}


def test_a_crank_of_two_throws_is_two_bars_and_one_of_them_is_numbered():
    body = bodies(Motion(*throws(), 0.005))["1"]
    assert body.plate == () and len(body.bars) == 2 and len(body.welds) == 1
    assert sorted(abs(b - a) for a, b in body.bars) == pytest.approx([14, 20])
    numbers = [i for i in positions_scheme(*throws(), 0.005).items if isinstance(i, Text) and i.size == SMALL]
    assert sum(i.parts == ("9",) for i in numbers) == 1


def test_a_point_that_is_no_joint_is_marked_where_it_is_fixed():
    mechanism, places, turns = throws()
    crosses = [i.strokes[0] for i in scheme(mechanism, places, turns, 0.005).items if isinstance(i, Path)]
    middles = [(stroke[0] + stroke[1]) / 2 for stroke in crosses if len(stroke) == 2]
    assert sum(abs(z + 40j) < 1e-9 for z in middles) == 2


@pytest.mark.parametrize("gap", [12.0, 7.5])
def test_blocks_near_each_other_are_shorter(gap):
    mechanism, places, turns = compressor()
    places["B"] = places["B"] - (places["B"][3] - places["D"][3] - gap * 0.005)
    items = [i for i in scheme(mechanism, places, turns, 0.005, 3).items if isinstance(i, Path)]
    blocks = [np.real(i.strokes[0]) for i in items if i.fill == "white" and len(i.strokes[0]) == 4]
    assert [np.ptp(block) for block in blocks] == pytest.approx([min(9.0, 0.9 * gap)] * 2)


def test_numbers_far_from_their_places_are_led_to_them():
    mechanism, places, turns = four_bar()
    small = positions_scheme(mechanism, places, turns, 0.002)
    leaders = [i.strokes[0] for i in small.items if isinstance(i, Path) and i.pen and i.pen.width == LEADER]
    texts = [i.box for i in small.items if isinstance(i, Text)]
    for start, end in leaders:
        assert abs(end - start) > AWAY
        assert any(
            x0 - 0.2 <= end.real <= x1 + 0.2 and y0 - 0.2 <= end.imag <= y1 + 0.2 for x0, y0, x1, y1 in texts
        )
    assert leaders and crowded(small) == 0


def test_a_ternary_link_is_a_plate():
    body = bodies(Motion(*CASES["four_bar"](), 0.002))["2"]
    assert len(body.plate) == 3 and body.bars == ()


def test_a_slotted_link_covers_the_travel_of_its_stone():
    mechanism, places, turns = CASES["swinging_cylinder"]()
    (a, b), *_ = bodies(Motion(mechanism, places, turns, 0.001))["2"].bars
    farthest = max(abs(places["C"] - places["A"])) / 0.001
    assert min(abs(a), abs(b)) == 0 and max(abs(a), abs(b)) > farthest


def test_a_yoke_is_a_stiff_cross_of_slot_and_rod():
    body = bodies(Motion(*scotch_yoke(), 0.002))["3"]
    assert len(body.bars) == 2 and len(body.welds) == 1 and body.blocks == ()


def test_a_link_without_points_stands_where_its_guides_cross():
    named, unnamed = (Motion(*scotch_yoke(named=flag), 0.002) for flag in (True, False))
    assert unnamed.origins["3"] == pytest.approx(named.origins["3"])


def test_a_turned_drawing_is_the_drawing_turned():
    angle, case = 0.7, compressor()
    turned = joints(scheme(*rotated(case, angle), 0.005, 4))
    assert np.allclose(turned, np.array(joints(scheme(*case, 0.005, 4))) * np.exp(1j * angle))


def test_places_that_coincide_share_a_number():
    mechanism, places, turns = compressor()
    words = [
        "".join(map(str, i.parts))
        for i in positions_scheme(mechanism, places, turns).items
        if isinstance(i, Text)
    ]
    assert {"1=11", "5=7", "6"} <= set(words)


def test_the_rotation_arrow_follows_the_sense():
    def tip(omega):
        mechanism, places, turns = compressor()
        turned = replace(mechanism, driver=replace(mechanism.driver, omega=omega))
        heads = [
            i
            for i in scheme(turned, places, turns, 0.005, 0).items
            if isinstance(i, Path) and i.fill == "black"
        ]
        return heads[0].strokes[0][0]

    assert tip(5.0).imag > 0 > tip(-5.0).imag


def test_a_position_that_does_not_assemble_is_left_out():
    mechanism, places, turns = offset_slider()
    for point in ("B", "S2"):
        places[point] = np.where(np.arange(12) == 4, np.nan, places[point])
    turns["2"] = np.where(np.arange(12) == 4, np.nan, turns["2"])
    for drawing in (
        scheme(mechanism, places, turns, None, 4),
        positions_scheme(mechanism, places, turns, None, 1),
    ):
        assert "nan" not in svg(drawing)


def test_injected_names_are_escaped():
    mechanism, places, turns = offset_slider()
    bad = '<script>"&\\'
    links = {
        name: replace(
            link, points={bad if p == "B" else p: z for p, z in link.points.items()}, mass_centre=None
        )
        for name, link in mechanism.links.items()
    }
    places[bad] = places.pop("B")
    drawing = scheme(replace(mechanism, links=links), places, turns)
    assert "<script>" not in svg(drawing) and r"\textbackslash" in tikz(drawing)


def test_outer_joints_of_a_group_are_halves():
    mechanism, places, turns = compressor()
    apart = groups_apart(mechanism, places, turns, [*GROUPS, ("II (4,5)", ("4", "5"))], 1).drawing
    assert sum(type(item).__name__ == "Arc" and item.pen.width == 0.5 for item in apart.items) == 3  # A, A, C


def test_the_same_input_gives_the_same_bytes():
    assert svg(positions_scheme(*compressor())) == svg(positions_scheme(*compressor()))
