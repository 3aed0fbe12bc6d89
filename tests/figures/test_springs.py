"""Springs and dampers in schemes: a zigzag and a dashpot between their own points, as long as these are apart."""

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path as File

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.lever.force_plans.loading_draw import TIED, loading_schemes
from tmm_report.chapters.lever.schemes import ties_of
from tmm_report.figures.drawing import Path
from tmm_report.figures.schemes.ties import ASIDE, HALF, Tie
from tmm_report.figures.schemes.view import view_of
from tmm_report.figures.springs import dashpot, zigzag

CASES = File(__file__).parents[1] / "cases" / "explain"
SCREEN = (CASES / "sprung_screen.yaml").read_text("utf-8")
PLACES = st.complex_numbers(max_magnitude=80, allow_nan=False)


def lever():
    return course.solve(loading.loads("language: en\n" + SCREEN)).lever


def seen(position, found):
    """The view of a position, and where its points are on paper, mm."""
    table, mechanism = found.kinematics.table, found.kinematics.linkage.mechanism
    shape, mu = table.shape, found.plans.length_scale
    places = {point: np.broadcast_to(table.place(point), shape) for point in mechanism.point_names}
    turns = {link: np.broadcast_to(table.turn(link), shape) for link in mechanism.moving}
    view = view_of(mechanism, places, turns, mu, position, tuple(ties_of(found)))
    return view, {point: complex(place[position]) / mu for point, place in places.items()}


def strokes(items):
    return [stroke for item in items if isinstance(item, Path) for stroke in item.strokes]


def along(z, start, end):
    """A place by the line of the ends: along it and to its left."""
    return (z - start) / ((end - start) / abs(end - start))


@given(PLACES, PLACES, st.integers(2, 9))
def test_a_zigzag_goes_from_end_to_end_within_its_width(start, end, coils):
    if abs(end - start) < 3:
        return
    (stroke,) = strokes(zigzag(start, end, coils, HALF, 1.5))
    own = [along(z, start, end) for z in stroke]
    assert stroke[0] == start and stroke[-1] == end
    assert all(np.diff([z.real for z in own]) > 0)
    sides = [z.imag for z in own[2:-2]]
    assert np.abs(sides) == pytest.approx(HALF, abs=1e-9) and len(sides) == 2 * coils
    assert all(a * b < 0 for a, b in pairwise(sides))
    assert np.ptp(np.diff([z.real for z in own[2:-2]])) < 1e-9  # even coils


@given(st.floats(8, 60), st.floats(0, 1), st.floats(0, 1), st.floats(0, 6.2))
def test_a_piston_stays_in_its_cup_whatever_the_length(least, more, share, angle):
    most = least * (1 + 0.8 * more)
    end = (least + share * (most - least)) * np.exp(1j * angle)
    items = dashpot(0j, end, least, most, HALF)
    rod, cup, piston, other = ([along(z, 0j, end) for z in stroke] for stroke in strokes(items))
    assert rod[0] == 0 and other[-1].real == pytest.approx(abs(end))
    low, high = cup[1].real, cup[0].real
    assert rod[-1].real == pytest.approx(low) and low < piston[0].real < high
    assert max(abs(z.imag) for z in piston) < max(abs(z.imag) for z in cup) == pytest.approx(HALF)
    assert other[0].real == pytest.approx(piston[0].real) and abs(other[0].imag) < 1e-9


@pytest.mark.parametrize("position", [0, 2, 5, 9])
def test_both_ends_are_at_their_points_in_every_position(position):
    found = lever()
    view, places = seen(position, found)
    coils = []
    for tie in ties_of(found):
        alone = replace(view, ties=(tie,)).tied
        start, end = (places[one] for one in tie.ends)
        drawn = strokes(alone.items())
        ends = [z for stroke in drawn for z in (stroke[0], stroke[-1])]
        assert min(abs(z - start) for z in ends) < 1e-9 and min(abs(z - end) for z in ends) < 1e-9
        own = [along(z, start, end) for stroke in drawn for z in stroke]
        assert all(-1e-9 <= z.real <= abs(end - start) + 1e-9 and abs(z.imag) <= HALF + 1e-9 for z in own)
        longest = max(drawn, key=len)
        assert (len(longest) > 8) == (tie.kind == "spring")
        coils.append(len(longest))
    first, _ = seen(1, found)
    assert coils == [
        max(map(len, strokes(replace(first, ties=(tie,)).tied.items()))) for tie in ties_of(found)
    ]


def test_springs_follow_the_motion():
    found = lever()
    tie = next(ties_of(found))
    lengths = []
    for position in range(12):
        view, places = seen(position, found)
        (stroke,) = strokes(replace(view, ties=(tie,)).tied.items())
        lengths.append(abs(stroke[-1] - stroke[0]))
        assert lengths[-1] == pytest.approx(abs(places[tie.ends[1]] - places[tie.ends[0]]))
    assert np.ptp(lengths) > 0.5
    table = found.kinematics.table
    apart = np.abs(table.place("D") - complex(0.06, 0.33))[:12] / found.plans.length_scale
    assert lengths == pytest.approx(list(apart))


def test_those_of_the_same_ends_stand_side_by_side():
    found = lever()
    view, places = seen(2, found)
    start, end = places["E"], places["L"]
    own = {tie.name: replace(view, ties=tuple(ties_of(found))).tied for tie in ties_of(found)}
    offsets = []
    for tie in ties_of(found):
        if set(tie.ends) == {"E", "L"}:
            items = list(own[tie.name]._drawn(tie, None))
            offsets.append(
                np.mean([along(z, start, end).imag for stroke in strokes(items)[2:] for z in stroke])
            )
    assert len(offsets) == 2 and abs(offsets[0] - offsets[1]) == pytest.approx(ASIDE, abs=0.8)


def test_a_fixed_place_beyond_the_points_is_a_pivot_on_the_frame():
    found = lever()
    view, places = seen(2, found)
    mu = found.plans.length_scale
    view = replace(view, ties=(Tie("spring", ("D", complex(0.1, 0.5))),))
    (stroke,) = strokes(view.tied.items())
    assert stroke[0] == pytest.approx(places["D"]) and stroke[-1] == pytest.approx(complex(0.1, 0.5) / mu)
    assert view.tied.fixed == pytest.approx([complex(0.1, 0.5) / mu])
    assert len(view.frame()) > len(replace(view, ties=()).frame())


# ---------------------------------------------------------------- in a note


def shapes(paths):
    """Of polylines of many corners the steps from corner to corner, mm, y upwards."""
    return sorted(tuple(np.round(np.diff(one), 2)) for one in paths if len(one) > 8)


def of_svg(html, caption):
    figures = re.findall(r"<figure.*?</figure>", html, flags=re.S)
    figure = next(one for one in figures if caption in re.sub(r"<[^>]+>", "", one))
    paths = re.findall(r'<path d="(M[^"ZM]*)" stroke="#000"', figure)
    return shapes(
        [[complex(float(x), -float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", d)] for d in paths]
    )


def of_tikz(picture):
    black = [line for line in picture.splitlines() if line.startswith("\\path[draw=drawingblack")]
    paths = [line for line in black if "cycle" not in line and line.count("(") == line.count("--") + 1]
    return shapes(
        [
            [complex(float(x), float(y)) for x, y in re.findall(r"\((-?[\d.]+),(-?[\d.]+)\)", line)]
            for line in paths
        ]
    )


def test_the_note_has_them_in_html_and_latex_alike():
    results = course.solve(loading.loads("language: en\n" + SCREEN))
    html, tex = render(results, "html", "en")["note.html"].decode(), render(results, "tex", "en")
    for caption in ("Kinematic scheme of the mechanism", "Scheme of the mechanism at 12 positions"):
        (number,) = re.findall(rf"{{(figure\d+)}}{{Figure \d+ — {caption}", tex["note.tex"].decode())
        web, paper = of_svg(html, caption), of_tikz(tex[f"figures/{number}.tex"].decode())
        assert len(web) == 3  # the springs: no other open line of the schemes has so many corners
        for one, other in zip(web, paper, strict=True):
            assert one == pytest.approx(other, abs=0.03)


def test_springs_of_the_machine_in_motion_are_drawn():
    text = (File(__file__).parents[2] / "variants" / "slider_crank_offset.yaml").read_text("utf-8")
    block = """dynamics:
  parts: [{name: disc, inertia: 2}]
  motor: {constant: 50}
  springs: [{at: B, to: PLACE, stiffness: 3 kN/m, length: 100 mm}]
  steady: false
  start: {time: 0.1 s}
"""
    counts = []
    for place in ("[400 mm, 20 mm]", "[40 m, 0]"):
        results = course.solve(loading.loads(text + block.replace("PLACE", place)))
        html = render(results, "html", "ru")["note.html"].decode()
        counts.append(len(of_svg(html, "Кинематическая схема механизма")))
    assert counts == [1, 0]  # what is held beyond the sheet is left out


def test_loading_schemes_show_thin_what_draws_at_the_links():
    """Of each link the springs and dampers that act on it, and no others, from their own points."""
    found = lever()
    (drawn,) = found.force_plans.drawn
    _, places = seen(drawn.position, found)
    acting = {"5": ["c3", "b1"], "4": ["b2"], "3": ["c1", "c2", "b2"], "2": ["c2"], "1": []}
    seen_links = set()
    for plan in drawn.plans:
        for links, drawing in loading_schemes(
            found.kinematics, found.plans.length_scale, drawn, plan, str, tuple(ties_of(found))
        ):
            wanted = sorted(
                round(abs(places[one.ends[0]] - places[one.ends[1]]), 3)
                for one in ties_of(found)
                if any(one.name in acting[link] for link in links) and one.kind == "spring"
            )
            thin = [
                stroke
                for item in drawing.items
                if getattr(item, "pen", None) == TIED
                for stroke in item.strokes
            ]
            springs = [stroke for stroke in thin if len(stroke) > 8]
            assert sorted(round(abs(one[-1] - one[0]), 3) for one in springs) == wanted, links
            seen_links |= set(links)
    assert seen_links == set(acting)
