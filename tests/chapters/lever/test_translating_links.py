"""A link that only translates is said to: its direction is the same at every position, and no other link is named."""

from __future__ import annotations

import re

import numpy as np
import pytest
from conftest import LEVERS, solved
from exhaustive import many
from notes import note

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
