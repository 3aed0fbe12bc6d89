"""Force plans as no ready variant has them: arms in mm by hand, a wheel on one flank, both ways of turning."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from conftest import read as variant_of
from exhaustive import many
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans

from tmm_report.chapters.lever.plans.given import Segment
from tmm_report.course import LeverGiven, solve
from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive


def by_hand(given: LeverGiven) -> LeverGiven:
    return replace(given, drawing=replace(given.drawing, accuracy=5e-4))


def on_one_flank(given: LeverGiven) -> LeverGiven:
    gear = GearDrive(0.08, np.radians(20), np.radians(35), one_flank=True)
    driver = replace(given.mechanism.driver, gear=gear, omega=-given.mechanism.driver.omega)
    return replace(given, mechanism=replace(given.mechanism, driver=driver))


def by_a_segment(given: LeverGiven) -> LeverGiven:
    return replace(
        given, drawing=replace(given.drawing, force=None, segments=(Segment("F", "force", (), 120.0),))
    )


@pytest.mark.exhaustive
@pytest.mark.parametrize("changed", [by_hand, on_one_flank, by_a_segment])
@pytest.mark.parametrize("name", many(["shaper", "compressor", "quick_return"]))
def test_every_number_is_marked_and_right(name, changed):
    ready = variant_of(name)
    given = replace(changed(ready.lever), readings={}, reduction=False, friction=None)
    results = solve(replace(ready, lever=given, drive=None, dynamics=None, flywheel=None, balancing=None))
    document = json.loads(render(results, "json")["results.json"])
    note = read(render(results, "html")["note.html"].decode())
    found = (wrong_cells(note, document), wrong_formulas(note, document), wrong_spans(note, document))
    wrong([*(one for some in found for one in some), *unmarked(note)])
