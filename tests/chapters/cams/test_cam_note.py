"""The note of a cam: positions alike in one row, what it says at each depth, what is nought said in words."""

import re
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "page"))
from note import read, text_of

from tmm_report import course, loading, render
from tmm_report.chapters.title.given import Note
from tmm_report.problems import ProblemError
from tmm_report.report.paper.layout import Column, joined, runs

PHASES = (
    "phases: [{rise: 100 deg, law: sine, divisions: 4}, {dwell: 40 deg}, {return: 80 deg, law: cosine}, "
    "{dwell: rest}]"
)
SIZED = "base: smallest, round: 1 mm, return_angle_limit: 42 deg"
CAMS = {
    "roller": f"roller: 12 mm, lift: 30 mm, offset: 8 mm, {SIZED}",
    "free": f"roller: 12 mm, lift: 30 mm, offset: free, {SIZED}",
    "lever": f"roller: 16 mm, arm: 120 mm, swing: 18 deg, centre_distance: 150 mm, side: against, {SIZED}",
    "flat": "follower: flat, lift: 14 mm, base: smallest, least_curvature: 8 mm",
}
FORCES = "speed: 150 rpm, mass: 1.6 kg, load: {rise: 320 N}, spring: {ratio: 0.4, reserve: 1.4}, at: [35 deg, 60 deg]"


@cache
def solved(name: str, more: str = "") -> course.Results:
    cam = ", ".join(filter(None, (CAMS[name], more, "positions: 24", PHASES)))
    return course.solve(loading.loads(f"language: en\ncam: {{{cam}}}"))


@cache
def note(name: str, depth: str, more: str = "") -> str:
    results = solved(name, more)
    variant = replace(results.variant, note=Note(depth))
    return render(replace(results, variant=variant), "html", "en")["note.html"].decode()


def words(html: str) -> str:
    return re.sub(r"\s+", " ", text_of(read(html).root))


# --- rows alike


def test_rows_alike_stand_together_and_no_number_goes_astray():
    rng = np.random.default_rng(5)
    for _ in range(50):
        size = int(rng.integers(1, 30))
        cells = [[str(x) for x in rng.integers(0, 2, size)] for _ in range(2)]
        first, columns = joined(
            Column("k", [str(k) for k in range(size)]), [Column(str(n), own) for n, own in enumerate(cells)]
        )
        told: dict[int, tuple[str, ...]] = {}
        for row, name in enumerate(first.cells):
            low, _, high = name.partition("–")
            for k in range(int(low), int(high or low) + 1):
                told[k] = tuple(column.cells[row] for column in columns)
        assert told == {k: tuple(own[k] for own in cells) for k in range(size)}
        lone = [k for k, name in enumerate(first.cells) if "–" not in name]
        following = [
            (a, b, c) for a, b, c in zip(lone, lone[1:], lone[2:], strict=False) if c == a + 2 and b == a + 1
        ]
        assert not [
            three for three in following if len({tuple(one.cells[k] for one in columns) for k in three}) == 1
        ]


@pytest.mark.parametrize(
    ("numbers", "told"), [((7, 8, 9, 15), [[7, 8, 9], [15]]), ((), []), ((0, 2, 3), [[0], [2, 3]])]
)
def test_numbers_that_follow_one_another(numbers, told):
    assert runs(numbers) == told


def test_the_positions_of_a_dwell_stand_in_one_row():
    """By the phases: positions are 15° apart, the dwells go from 100° to 140° and from 220° to 360°."""
    text = words(note("roller", "course"))
    assert "7–9" in text and "15–24" in text


# --- what each depth says


def count(html: str, what: str) -> int:
    return len(re.findall(rf'id="{what}', html))


@pytest.mark.parametrize("name", sorted(CAMS))
def test_at_every_depth_the_main_numbers_stand(name):
    for depth in ("short", "course", "full"):
        html = note(name, depth)
        for key in ("cam_base", "cam_S", "cam_R", "cam_delta", "cam_rho", "cam_recovered_rounded"):
            assert f'data-q="{key}"' in html, (depth, key)
        assert ('data-q="cam_alpha_rise"' in html) == (name != "flat")


def test_a_short_note_has_one_table_of_motion_and_profile_and_a_full_one_all():
    short, usual, full = (note("roller", depth) for depth in ("short", "course", "full"))
    assert 'data-q="cam_x"' not in short and 'data-q="cam_v"' not in short
    assert 'data-q="cam_x"' in usual and "Phase 1, rise, by equal parts" not in short
    assert "Appendix A" in usual and "Phase 1, rise, by equal parts" in usual
    assert re.findall(r"Appendix \w</span> (\w+)</a>", full) == ["Drawings"]
    assert "Profile of cam 1" in full and "Profile of cam 1," not in usual
    assert count(short, "figure") == 2 < count(usual, "figure") == 3 < count(full, "figure") == 4


def test_parts_of_the_forces_stand_apart_and_no_number_twice():
    usual, full = note("roller", "course", FORCES), note("roller", "full", FORCES)
    for html in (usual, full):
        table = re.findall(r'<t[dh][^>]*data-q="cam_inertia" data-k="3"[^>]*>', html)
        assert len(table) == 1
    assert (
        "Components of the forces of the cam" in usual and "Components of the forces of the cam" not in full
    )
    short = note("roller", "short", FORCES)
    assert not re.findall(r'<td[^>]*data-q="cam_inertia" data-k="3"', short)
    assert re.findall(r'<td[^>]*data-q="cam_N" data-k="3"', short)


# --- what it says


def test_a_free_offset_is_the_best_one_and_is_said_once():
    free, stated = words(note("free", "full")), words(note("roller", "full"))
    assert "The cam is smallest with the offset" in free and "If the offset were free" not in free
    assert "If the offset were free" in stated and "The cam is smallest with the offset" not in stated
    found = solved("free").cam.cams[0]
    zone = found.cam.sized
    around = [zone.at(found.offset + step).radius for step in (-1e-3, 0.0, 1e-3)]
    assert min(around) == around[1]


TABLE = (
    "phases: [{rise: 100 deg, %s}, {dwell: 40 deg}, {return: 80 deg, displacement: [20, 17, 10, 3, 0]}, "
    "{dwell: rest}]"
)


@pytest.mark.parametrize(
    ("rise", "graph", "table"), [("law: sine", False, True), ("acceleration: [0, 1, 0, -1, 0]", True, True)]
)
def test_a_phase_by_a_table_of_displacements(rise, graph, table):
    """At the equal parts of the return the follower is where the table says, the second way the stated numbers."""
    cam = f"roller: 12 mm, lift: 30 mm, base: 40 mm, positions: 36, {TABLE % rise}"
    results = course.solve(loading.loads(f"language: en\ncam: {{{cam}}}"))
    found = results.cam.cams[0].at(np.radians([140, 160, 180, 200, 219.9999999]))
    assert pytest.approx(30e-3 * np.array([20, 17, 10, 3, 0]) / 20, abs=1e-9) == found.S
    assert found.first[[0, -1]] == pytest.approx([0, 0], abs=1e-9)
    text = words(render(results, "html", "en", "full")["note.html"].decode())
    assert ("is the cubic spline through them" in text) == table
    assert ("the ordinates below zero are scaled" in text) == graph
    assert "tabulated" in text


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("[20, 17, 10, 3, 0]", "[0, 3, 10, 17, 20]", "turns back within the phase"),
        ("[20, 17, 10, 3, 0]", "[4, 4, 4, 4]", "begin and end at the same place"),
        ("[20, 17, 10, 3, 0]", "[10.02, 10.01, 10, 0.02, 0.01, 0]", "turns back between them"),
        ("displacement:", "law: sine, displacement:", "a rise and a return have a law"),
        ("[20, 17, 10, 3, 0]", "[20, 0]", ""),
    ],
)
def test_a_table_of_displacements_that_is_none(old, new, says):
    cam = f"roller: 12 mm, lift: 30 mm, base: 40 mm, {TABLE % 'law: sine'}".replace(old, new)
    with pytest.raises(ProblemError) as raised:
        loading.loads(f"language: en\ncam: {{{cam}}}")
    assert any(says in one.wrong.text for one in raised.value.problems)
    assert len(raised.value.problems) == 1


def test_no_angle_under_a_flat_face_is_said_in_words():
    text = words(note("flat", "full"))
    assert "is zero at every position" in text and "The greatest pressure angle" not in text
    assert np.max(np.abs(solved("flat").cam.cams[0].drawn.alpha)) == 0


@pytest.mark.parametrize(("name", "rise"), [("roller", "30°"), ("lever", "45°"), ("free", "30°")])
def test_both_permitted_angles_are_told(name, rise):
    text = words(note(name, "course"))
    assert f"{rise} is allowed. That of the return is" in text and "42° is allowed" in text


def test_what_is_nothing_but_rounding_is_said_in_words():
    text = words(note("roller", "course", FORCES))
    assert "The differences are rounding errors of the computation" in text
    assert "agrees with it over the whole turn to the accuracy of computation" in text
    assert not re.search(r"10−1[4-9]", text)


def test_the_angles_asked_that_are_alike_are_told_together():
    text = words(note("roller", "course", FORCES))
    assert "At 35°, 60° the cam presses the follower." in text
