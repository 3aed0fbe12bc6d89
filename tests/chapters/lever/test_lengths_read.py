"""Lengths read off the plans stand beside their values as they are read, with all decimals of the accuracy."""

import re

import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.lever.force_plans import quantities as forces
from tmm_report.chapters.lever.plans import quantities as plans
from tmm_report.quantity.paper import read_places

CELL = r'<td[^>]*data-q="%s" data-k="%d" data-t="%s"[^>]*>([^<]*)<'
TEXT = """
language: en
mechanism:
  frame: {O: [0, 0], C: [320 mm, 60 mm]}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 300 mm, S2: 100 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.01 kg*m^2}
    3: {points: {C: 0, B: 180 mm, S3: 60 mm}, mass: 1.5 kg, mass_centre: S3, inertia: 0.004 kg*m^2}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 25 deg}}
  assembly: {B: left of A-C}
loads: {gravity: 9.81 m/s^2}
positions: {table: 12, plans: [1, 4], force_plan: [1, 4]}
drawing: {accuracy: %s}
note: {depth: full}
"""


@pytest.mark.parametrize(
    ("step", "places"), [(0.001, 3), (0.01, 2), (0.25, 2), (0.1, 1), (0.5, 1), (1.0, 0), (2.0, 0)]
)
def test_as_many_decimals_as_the_accuracy_has(step, places):
    assert read_places(step) == places


@pytest.mark.parametrize(("accuracy", "places"), [("0.25 mm", 2), ("0.1 mm", 1), ("0.01 mm", 2)])
def test_every_length_is_printed_as_it_was_read(accuracy, places):
    results = course.solve(loading.loads(TEXT % accuracy))
    text = render(results, "html", "en")["note.html"].decode()
    lever, seen = results.lever, 0
    for row, drawn in enumerate(lever.plans.drawn):
        for plan in (drawn.velocity, drawn.acceleration):
            name = f"segments_{plan.kind}"
            table = next(one for one in plans.tables(lever.plans) if one.name == name)
            for ends in plan.ends.values():
                seen += _printed(text, ends, drawn.position, name, table[ends].number(row), places)
    for drawn in lever.force_plans.drawn:
        for worked in drawn.worked:
            for key in {forces.drawn_length(of).key for of in forces.compared(drawn)} & worked.rows.keys():
                seen += _printed(text, key, drawn.position, worked.table, worked.rows[key][1], places)
    assert seen > 20


def _printed(text: str, key: str, position: int, table: str, size: float, places: int) -> int:
    """How often a length stands in a table of the note, always as it was read."""
    found = re.findall(CELL % (re.escape(key), position, table), text)
    cells = [one for one in found if "." in one or not places]
    assert cells, (key, position, table, found)
    for cell in cells:
        assert float(cell) == pytest.approx(size, abs=1e-9) and len(cell.partition(".")[2]) == places, (
            key,
            cell,
        )
    return len(cells)
