"""Variants beyond a limit are refused before the work, with the limit and the cure; those at the limits are taken."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from notes import VARIANTS

from tmm_report.course import solve
from tmm_report.loading import loads
from tmm_report.mechanics.lever import assur_groups
from tmm_report.mechanics.machine.run import by_time
from tmm_report.problems import ProblemError
from tmm_report.quantity.paper import PAPER, legible
from tmm_report.variant import sizes

ROCKER = (VARIANTS / "crank_rocker.yaml").read_text("utf-8")
COMPRESSOR = (VARIANTS / "compressor.yaml").read_text("utf-8")


def mistakes(text: str) -> str:
    with pytest.raises(ProblemError) as error:
        solve(loads(text))
    return str(error.value)


def slider(points: int = 0, more: str = "") -> str:
    """A slider-crank with more points on its crank."""
    rest = "".join(f", P{k}: {2 + k / 100}" for k in range(points))
    return f"""\
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{x: {{through: O, angle: 0 deg}}}}
  links:
    1: {{points: {{O: 0, A: 1{rest}}}}}
    2: {{points: {{A: 0, B: 3}}}}
    3: {{points: [B], slides: x}}
  driver: {{link: 1, speed: 10}}
  assembly: {{B: right}}
{more}
"""


def chain(dyads: int) -> str:
    """A crank and a row of rocker dyads, each driven by the one before."""
    frame = ", ".join(f"G{k}: [{0.6 * (k + 1):.2f}, 0]" for k in range(dyads))
    links = "".join(
        f"    {2 * k + 2}: {{points: {{A{k}: 0, B{k}: 0.6}}}}\n"
        f"    {2 * k + 3}: {{points: {{G{k}: 0, B{k}: 0.4, A{k + 1}: [0.1, 0.02]}}}}\n"
        for k in range(dyads)
    )
    ways = ", ".join(f"B{k}: left of A{k}-G{k}" for k in range(dyads))
    return (
        f"mechanism:\n  frame: {{O: [0, 0], {frame}}}\n  links:\n    1: {{points: {{O: 0, A0: 100 mm}}}}\n{links}"
        f"  driver: {{link: 1, speed: 10}}\n  assembly: {{{ways}}}\n"
    )


@pytest.mark.parametrize(
    "text, key, limit",
    [
        (slider(500), "mechanism.links", "506 points in all links are too many: at most 120"),
        (slider(115), "mechanism.links", "at most 120"),
        (chain(20), "mechanism.links", "41 entries are too many here: at most 40"),
        (slider(40, "positions: {table: 360}"), "positions.table", "at most 244 positions"),
        (slider(0, f"positions: {{plans: {[*range(11)] * 4}}}"), "positions.plans", "at most 36"),
        (
            chain(12).replace("mech", f"positions: {{plans: {[*range(12)]}}}\nmech", 1),
            "positions.plans",
            "at most 8",
        ),
        (slider().replace("slides: x", f"slides: {['x'] * 11}"), "mechanism.links.3.slides", "at most 10"),
        (slider(0, "wear: {" + ", ".join(f"a{k}: 1" for k in range(2001)) + "}"), "wear", "at most 2000"),
        (
            slider(0, "loads:\n  forces:\n" + "    - {at: B, direction: up, constant: 1}\n" * 61),
            "loads.forces",
            "60",
        ),
    ],
)
def test_beyond_a_limit(text, key, limit):
    said = mistakes(text)
    assert key in said and limit in said and said.count("\n") < 3


@pytest.mark.parametrize(
    "text", [slider(110), chain(3), slider(0, f"positions: {{plans: {[*range(12)] * 3}}}")]
)
def test_what_is_at_a_limit_is_taken(text):
    assert not sizes.beyond(yaml.safe_load(text))


@pytest.mark.parametrize("file", sorted(VARIANTS.glob("*.yaml")), ids=lambda file: file.stem)
def test_ready_variants_are_far_below_the_limits(file: Path):
    data = yaml.safe_load(file.read_text("utf-8"))
    assert not sizes.beyond(data)
    assert sizes.points(data) <= sizes.POINTS / 3


KEYS = st.sampled_from(
    ["mechanism", "links", "frame", "points", "positions", "table", "plans", "loads", "forces"]
)
DATA = st.recursive(
    st.none() | st.integers() | st.text(max_size=3),
    lambda x: st.lists(x) | st.dictionaries(KEYS, x),
    max_leaves=30,
)


@pytest.mark.exhaustive
@given(DATA)
def test_data_of_any_shape_is_counted_without_an_error(data):
    assert sizes.beyond(data if isinstance(data, dict) else {}) == []


# ---------------------------------------------------------------- scales


@pytest.mark.parametrize(
    "old, new, key",
    [
        ("4-5: 10", "4-5: 1e8", "drawing.scales.force.4-5"),
        ("length: 0.002,", "length: 1e-9,", "drawing.scales.length"),
        ("velocity: 0.075", "velocity: 1e7", "drawing.scales.velocity"),
        ("acceleration: 9", "acceleration: 1e-7", "drawing.scales.acceleration"),
    ],
)
def test_a_scale_at_which_nothing_can_be_drawn(old, new, key):
    assert COMPRESSOR.count(old) == 1
    said = mistakes(COMPRESSOR.replace(old, new))
    low, high = map(float, re.search(r"from (\S+) to (\S+) it can be drawn", said).groups())
    assert key in said and low < high
    stated = float(new.split()[-1].rstrip(","))
    assert not low <= stated <= high
    end = "," if old.endswith(",") else ""
    between = f"{old.rpartition(' ')[0]} {(low * high) ** 0.5:.3g}{end}"
    solve(loads(COMPRESSOR.replace(old, between)))


@given(st.floats(1e-6, 1e6), st.floats(1e-9, 1e9))
def test_a_scale_is_refused_exactly_where_paper_ends(largest, scale):
    fits = PAPER[0] <= largest / scale <= PAPER[1]
    try:
        assert legible(scale, largest, ()) == scale and fits
    except ProblemError:
        assert not fits
    assert legible(scale, 0.0, ()) == scale


def test_a_mechanism_far_from_its_axes_is_drawn_and_a_far_pivot_is_told():
    far = COMPRESSOR.replace("1: {points: {O: 0, A: 100 mm}", "1: {points: {O: 999 km, A: 100 mm}")
    assert far != COMPRESSOR and "drawing" in mistakes(far)


# ---------------------------------------------------------------- groups


def test_the_search_of_groups_ends(monkeypatch):
    """Four links that only together are a group, as on the arm of a digger."""
    text = (VARIANTS / "crank_rocker.yaml").read_text("utf-8")
    mechanism = loads(text).lever.mechanism
    monkeypatch.setattr(assur_groups, "MOST_SETS", 1)
    with pytest.raises(ProblemError, match="none of the first 1 sets of them is an Assur group"):
        assur_groups.decompose(mechanism)


# ---------------------------------------------------------------- motions


def tram(points: int) -> str:
    """A machine whose moment of inertia is stated at so many angles; it starts in some ten turns."""
    rows = ", ".join(f"[{360 * k / points:.4f} deg, {3 + k % 2}]" for k in range(points))
    return f"""\
dynamics:
  motor: {{shunt: {{moment: 50, speed: 140, no_load: 157}}}}
  varying_inertia: [{rows}]
  start: {{speed: 120}}
"""


@pytest.mark.exhaustive
def test_a_motion_of_many_cycles_is_bounded_by_the_values_that_it_takes(monkeypatch):
    found = solve(loads(tram(8))).dynamics.start
    turns = found.phi[-1] / 6.2831853
    assert turns > 6
    monkeypatch.setattr(by_time, "FOLLOWED", 4 * 300)  # values of T: four cycles of 25 panels of 12
    assert "after 5 turns" in mistakes(tram(8))


def test_the_limits_stand_in_the_documents():
    text = (Path(__file__).parents[2] / "docs" / "variant.md").read_text("utf-8").split("## Limits")[1]
    for limit in (sizes.POINTS, sizes.SLIDES, sizes.PLANS, sizes.ENTRIES):
        assert re.search(rf"(?<![\d ]){limit}(?!\d)", text.replace("; ", ";").replace("| ", "|")), limit
    assert f"{sizes.ROWS:,}".replace(",", " ") in text
