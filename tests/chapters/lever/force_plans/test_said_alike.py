"""One quantity reads the same wherever a note has it: in what is worked by hand, and in its table."""

from __future__ import annotations

import re

import pytest
from conftest import LEVERS as FILES
from conftest import solved
from exhaustive import many

from tmm_report import course, loading
from tmm_report.quantity.text import round_significant
from tmm_report.results import tables

NAMES = [path.stem for path in FILES]
FIRST = sorted(NAMES, key=lambda name: name not in ("press", "shaper_synthesis", "cam_press"))
HAND = re.compile(r"(?:velocity_plan|acceleration_plan|inertia|force_plan|lever)_\d")


def worked(of):
    """(table, key, value) of all numbers that are worked by hand."""
    for table in tables(of):
        if HAND.match(table.name) and "value" in table:
            rows = zip(table["key"].values, table["value"].values, strict=True)
            yield from ((table.name, key, float(value)) for key, value in rows)


@pytest.mark.parametrize("name", many(FIRST, 3))
def test_an_inertia_couple_has_one_sign(name):
    """That of the table: against the angular acceleration, in formulas and sums of moments too."""
    found = solved(name)
    loads = next((table for table in tables(found) if table.name == "loads_table"), None)
    if loads is None:
        pytest.skip("it has no loads")
    for place, key, value in worked(found):
        if re.fullmatch(r"M_I\w+", key) and key in loads:
            k = int(re.findall(r"_(\d+)", place)[0])
            exact = float(loads[key].values[k])
            assert value == pytest.approx(exact, rel=3e-4, abs=1e-5), (place, key)


@pytest.mark.parametrize("name", many(FIRST, 3))
def test_a_segment_has_one_name_and_a_length_of_five_digits(name):
    lengths: dict[str, set[float]] = {}
    for _, key, value in worked(solved(name)):
        if re.fullmatch(r"l_[A-Z]\d*[A-Z]\d*", key):
            lengths.setdefault(key, set()).add(value)
    assert lengths or solved(name).lever.plans is None
    for key, values in lengths.items():
        one, other = re.findall(r"[A-Z]\d*", key[2:])
        assert one == other or f"l_{other}{one}" not in lengths
        assert all(value == pytest.approx(round_significant(value, 5), rel=1e-12) for value in values), key


def test_a_centre_of_percussion_has_a_letter_that_no_point_has():
    text = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O, angle: 0 deg}}
  links:
    1: {points: {O: 0, K: 100 mm}}
    2: {points: {K: 0, B: 300 mm, S2: 100 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.02 kg*m^2}
    3: {points: [B], slides: x, mass: 1 kg, mass_centre: B}
  driver: {link: 1, speed: 600 rpm, rotation: counter-clockwise}
  assembly: {B: right}
loads: {gravity: 9.81 m/s^2}
positions: {table: 12, plans: [1], force_plan: 1}
"""
    (drawn,) = course.solve(loading.loads(text)).lever.force_plans.drawn
    assert [one.letter for one in drawn.reduced] == ["T"]
    assert [one.letter for one in solved("compressor").lever.force_plans.drawn[0].reduced] == ["K", "K"]
