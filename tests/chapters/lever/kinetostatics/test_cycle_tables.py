"""Tables of a whole cycle say of each number what it is: where an extreme is reached, which work drives, which sense of
the moment holds between which angles; the note says the same in words."""

from __future__ import annotations

import re
from html import unescape
from typing import Any

import numpy as np
import pytest
from conftest import solved
from notes import note, render

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved, at, stated
from tmm_report.chapters.lever.kinetostatics.solve.works import powers_of
from tmm_report.mechanics.lever.extremes import Peak

NAMES = ("press", "shaper", "whitworth", "engine_four_stroke")
BESIDE = {"before": -1e-9, "": 0.0, "after": 1e-9}  # rad


def forces(name: str) -> Kinetostatics:
    return solved(name).lever.kinetostatics


def directly(found: Kinetostatics, turned: Any) -> Solved:
    turned = np.atleast_1d(np.asarray(turned, float))
    motion = found.kinematics.cycle.motion(turned)
    return at(found.given, motion, turned, stated(found.given, found.kinematics, motion, turned))


def number(solved: Solved, key: str) -> Any:
    """What a key of the table of extremes means, (P,)."""
    if key == "M_bal":
        return np.broadcast_to(solved.balancing, solved.turned.shape)
    letter, links, *part = key.split("_")
    pairs = {"".join(one.pair.links): one for one in solved.statics.reactions.values()}
    if letter == "M":
        return np.broadcast_to(pairs[links].moment, solved.turned.shape)
    of = {"": np.abs, "x": np.real, "y": np.imag}["".join(part)]
    return np.broadcast_to(of(pairs[links].force), solved.turned.shape)


@pytest.mark.parametrize("name", NAMES)
def test_every_extreme_is_reached_where_the_table_says(name):
    found = forces(name)
    table = q.book(found).tables["force_extremes"]
    keys, rows = table["key"].values, range(len(table))
    sizes = [max(abs(table[end].values[row]) for end in ("least", "greatest")) for row in rows]
    for end in ("least", "greatest"):
        turned = np.radians(np.array(table[f"{end}_at"].values, float))
        there = directly(found, turned + [BESIDE[side] for side in table[f"{end}_side"].values])
        for row, key in enumerate(keys):
            missed = abs(number(there, key)[row] - table[end].values[row])
            assert missed <= 1e-5 * sizes[row] + 1e-9 * max(sizes), (end, key)


def positions(text: str) -> set[int]:
    """ "1–4, 9" """
    ranges = (part.split("–") for part in text.split(", ") if part)
    return {k for one in ranges for k in range(int(one[0]), int(one[-1]) + 1)}


@pytest.mark.parametrize("name", NAMES)
def test_each_column_of_the_works_has_its_sign(name):
    found = forces(name)
    table, works = q.book(found).tables["works"], found.works
    driving, resisting, whole = (np.array(table[key].values) for key in ("driving", "resisting", "work"))
    assert (driving >= 0).all() and (resisting <= 0).all()
    np.testing.assert_allclose(driving + resisting, whole, atol=1e-12 * works.size)
    sense = np.sign(found.kinematics.omega)
    powers = [found.table.balancing * sense, *powers_of(found.given, found.table.motion, found.table.loading)]
    for row, power in enumerate(powers):
        largest = np.abs(power).max()
        drives, resists = (positions(table[key].values[row]) for key in ("drives_at", "resists_at"))
        assert drives >= set(np.flatnonzero(power[:-1] > 1e-6 * largest)) and not drives & resists
        assert resists >= set(np.flatnonzero(power[:-1] < -1e-6 * largest))


def note_of(name: str) -> str:
    return re.sub(r"\s+", " ", unescape(note(name, "html", "en")["note.html"].decode()))


def plain(html: str) -> str:
    return re.sub(r"\s+", " ", re.sub("<[^>]*>", "", html)).strip()


@pytest.fixture(scope="module")
def press() -> str:
    return note_of("press")


@pytest.mark.exhaustive
def test_the_note_says_where_the_engine_drives(press):
    found = forces("press")
    told = plain(press)
    (drives,) = re.findall(r"sense of rotation of the driving link at the positions? ([\d–, ]+):", told)
    (gives,) = re.findall(r"It is opposite at the positions? ([\d–, ]+):", told)
    moment = found.table.balancing[:-1] * np.sign(found.kinematics.omega)
    nothing = 1e-9 * np.abs(moment).max()
    assert positions(drives) == set(np.flatnonzero(moment > nothing))
    assert positions(gives) == set(np.flatnonzero(moment < -nothing))


@pytest.mark.exhaustive
def test_the_table_of_senses_goes_from_zero_to_a_whole_turn(press):
    caption = press.index("Senses of the balancing moment over the cycle")
    (body,) = re.findall(r"<tbody>.*?</tbody>", press[caption : press.index("</table>", caption)])
    rows = [[plain(cell) for cell in re.findall(r"<td.*?</td>", row)] for row in body.split("<tr")[1:]]
    assert float(rows[0][0]) == 0 and float(rows[-1][1]) == 360
    assert [row[1] for row in rows[:-1]] == [row[0] for row in rows[1:]]
    for start, end, words, _ in rows:
        middle = directly(forces("press"), np.radians((float(start) + float(end)) / 2))
        drives = float(middle.balancing[0]) * forces("press").kinematics.omega > 0
        assert words.startswith("along" if drives else "opposite")


@pytest.mark.exhaustive
def test_the_side_of_a_jump_is_said(press):
    """The press is loaded at once at 145°: its greatest moment is that just after the jump."""
    assert "145° after the jump" in plain(press)
    assert "145° before the jump" not in plain(press)


COUNTERWEIGHT = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [300 mm, 0]}
  links:
    1: {points: {O: 0, A: 100 mm, S: -100 mm}, mass: 2 kg, mass_centre: S}
    2: {points: {A: 0, B: 250 mm}, mass: MASS, mass_centre: A}
    3: {points: {C: 0, B: 200 mm}}
  driver: {link: 1, speed: 10, gear: {radius: 50 mm, at: 0, flank: driving}}
  sketch: {A: [100 mm, 0], B: [260 mm, 190 mm]}
loads: {gravity: 9.81}
positions: {plans: [2], force_plan: 2}
"""


@pytest.mark.exhaustive
def test_a_moment_that_is_nothing_has_no_sense_and_no_jumps():
    """A crank whose counterweight holds the rod: what is left of the moment is rounding."""
    results = course.solve(loading.loads(COUNTERWEIGHT.replace("MASS", "2 kg")))
    found = results.lever.kinetostatics
    assert found.over.moment == (Peak(0.0, 0.0), Peak(0.0, 0.0))
    assert found.works.zones == () and not found.works.balancing.signs.any()
    told = plain(re.sub(r"\s+", " ", unescape(render(results, "html")["note.html"].decode())))
    assert "There is no balancing moment over the whole cycle" in told
    assert "the teeth part. There is no such position" in told


def test_a_moment_that_is_small_has_its_senses():
    """A millionth of the mass too much: a moment of gravity with one sense going up, the other going down."""
    found = course.solve(loading.loads(COUNTERWEIGHT.replace("MASS", "2.000002 kg"))).lever.kinetostatics
    assert found.over.moment[1].value == pytest.approx(2e-6 * 9.81 * 0.1, rel=1e-6)
    assert [np.degrees(zone.end) for zone in found.works.zones] == pytest.approx([90, 270, 360], abs=1e-3)
