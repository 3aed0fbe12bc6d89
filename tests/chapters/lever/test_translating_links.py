"""A link that only translates is said to: its direction is the same at every position, and no other link is named."""

from __future__ import annotations

import re

import numpy as np
import pytest
from conftest import LEVERS, path_of, solved
from exhaustive import many
from notes import note

from tmm_report import render, solve
from tmm_report.loading import loads

QUICK = ["parallelogram_drive", "crank_rocker", "elliptic_trammel"]
NAMES = many([*QUICK, *(path.stem for path in LEVERS if path.stem not in QUICK)], len(QUICK))
SAID = re.compile(r"Links? ([^.:]*?) only translates?:")


@pytest.mark.parametrize("name", NAMES)
def test_the_note_names_those_that_keep_their_direction(name):
    results = solved(name)
    motion, mechanism = results.lever.kinematics.diagram, results.lever.given.mechanism.real
    still = {
        link
        for link in mechanism.moving
        if np.nanmax(np.abs(motion.turn(link) - motion.turn(link).flat[0]), initial=0.0) < 1e-9
    } - {mechanism.driver.link}
    for depth in ("short", "course"):
        text = note(name, "html", "en", depth)["note.html"].decode()
        assert set(", ".join(SAID.findall(text)).split(", ")) - {""} == still


OF_LINK_2_AND_5 = {
    *("v_CB", "v_EB", "v_FD", "w_2", "e_2"),
    *(f"a_{pair}_{part}" for pair in ("CB", "EB", "FD") for part in "nt"),
}


def compared(results):
    """Keys of the rows that compare the plans with the analytical method."""
    text = render(results, "html", "en", "course")["note.html"].decode()
    return set(re.findall(r'data-q="([^"]+)"[^>]* data-t="comparison_\d+" data-by="graph"', text))


def test_what_is_nought_since_its_link_only_translates_has_no_row():
    """Of the press: link 2 carries B, C and E, link 5 carries D and F."""
    results = solved("press")
    found = {one.key: one.analytic for one in results.lever.plans.drawn[0].comparison}
    assert {key for key, value in found.items() if abs(value) < 1e-9} == OF_LINK_2_AND_5
    assert compared(results) == found.keys() - OF_LINK_2_AND_5


def test_a_student_s_own_value_of_it_keeps_its_row():
    text = path_of("press").read_text(encoding="utf-8")
    results = solve(loads(f"{text}\nreadings: {{5: {{v_CB: 0, w_3: -1.88}}}}\n"))
    assert compared(results) & OF_LINK_2_AND_5 == {"v_CB"}
