"""Lever mechanisms as no ready variant has them: without loads, with two moments on one link, all reduced."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from conftest import read as variant_of
from exhaustive import many
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans

from tmm_report.chapters.lever.kinetostatics.given import Moment
from tmm_report.course import LeverGiven, solve

NAMES = ["crank_rocker", "quick_return", "tangent"]


def without_loads(given: LeverGiven) -> LeverGiven:
    return replace(given, loads=None, friction=None)


def with_two_moments(given: LeverGiven) -> LeverGiven:
    """On one link, one of them less than nothing."""
    link = given.mechanism.moving[1]
    first = Moment(name="first", on=link, direction=1, constant=10.0)
    two = (first, Moment(name="second", on=link, direction=-1, constant=-4.0))
    return replace(given, loads=replace(given.loads, moments=(*given.loads.moments, *two)))


@pytest.mark.exhaustive
@pytest.mark.parametrize("changed", [without_loads, with_two_moments])
@pytest.mark.parametrize("name", many(NAMES))
def test_every_number_is_marked_and_right(name, changed):
    ready = variant_of(name)
    given = replace(changed(ready.lever), readings={}, reduction=True)
    results = solve(replace(ready, lever=given))
    document = json.loads(render(results, "json")["results.json"])
    note = read(render(results, "html")["note.html"].decode())
    found = (wrong_cells(note, document), wrong_formulas(note, document), wrong_spans(note, document))
    wrong([*(one for some in found for one in some), *unmarked(note)])


@pytest.mark.exhaustive
def test_two_moments_on_one_link_are_told_apart():
    """Their symbols are as many as they are, in the table of the loads and wherever they act."""
    ready = variant_of("crank_rocker")
    results = solve(replace(ready, lever=replace(with_two_moments(ready.lever), readings={})))
    document = json.loads(render(results, "json")["results.json"])
    columns = document["tables"]["stated_table"]["columns"]
    symbols = [column["symbol"] for column in columns if column["key"].startswith("M_")]
    assert len(symbols) == len(set(symbols)) >= 2
    note = read(render(results, "html")["note.html"].decode())
    told = [table for table in note.tables if "Нагрузка" in [head.text for head in table.heads]]
    assert len(told) == 2  # what is stated, and the works
    for table in told:
        printed = [row[0].text for row in table.rows]
        assert len(printed) == len(set(printed))
