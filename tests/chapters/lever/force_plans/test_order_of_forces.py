"""A force equation as a person solves it: one unknown first, the known forces, another unknown last; and its plan."""

from __future__ import annotations

import re

import numpy as np
import pytest
from conftest import LEVERS as FILES
from conftest import solved
from exhaustive import many
from notes import note

from tmm_report import render
from tmm_report.chapters.lever.force_plans.drafting.plan import ForcePlan

LEVERS = [path.stem for path in FILES if "\nloads:" in path.read_text("utf-8")]


def plans(name: str) -> list[ForcePlan]:
    found = solved(name).lever.force_plans
    return [plan for drawn in found.drawn for plan in drawn.plans] if found else []


@pytest.mark.parametrize("name", many(LEVERS, 3))
def test_unknowns_stand_at_both_ends_of_an_equation(name):
    """What was solved before, a group above class II, has none."""
    for plan in plans(name):
        unknown = [k for k, term in enumerate(plan.equation.sides[0]) if term.known < 2]
        ends = {0, len(plan.equation.sides[0]) - 1}
        assert set(unknown) <= ends and (len(unknown) == 2 or plan.stage != "group" or plan.balances)


@pytest.mark.parametrize("name", many(LEVERS, 3))
def test_the_plan_is_closed_in_the_order_of_the_equation(name):
    """From the beginning of the first unknown, force behind force, to the same place."""
    for plan in plans(name):
        strokes = {stroke.quantity.sign: stroke for stroke in plan.strokes}
        signs = [term.symbol for term in plan.equation.sides[0]]
        if plan.balances or not set(signs) <= set(strokes):  # a force that is nil has no vector
            continue
        ends = [strokes[sign].end for sign in signs]
        starts = [strokes[sign].start for sign in signs]
        assert np.abs(np.array(starts) - np.roll(ends, 1)).max() < 1e-9, (name, plan.label)


@pytest.mark.parametrize("name", ["compressor"])
def test_what_differs_by_its_indices_is_explained_once(name):
    """Reactions of a chapter are many; the first says what all of them are."""
    text = note(name, "html", "en")["note.html"].decode()
    where = " ".join(re.findall(r'<p class="where">(.*?)</p>', text, re.S))
    said = re.sub(r"<[^>]*>", "", where)
    assert len(re.findall(r"[–—] reaction of link \d on link \d", said)) == 1
    assert len(re.findall(r"arm of force [^,;]+ on the lever", said)) == 1


def test_the_inertia_couple_that_is_written_out_is_not_nought():
    """The driving link turns evenly, and that of the rod stands for all."""
    text = render(solved("forging_machine_wear"), "html", "en", "course")["note.html"].decode()
    body = text[text.index("The inertia forces and couples at position") :]
    marks = re.findall(r'data-q="(M_I\d)"', body[: body.index("</p>", body.index('class="where"'))])
    assert "M_I2" in marks and "M_I1" not in marks
