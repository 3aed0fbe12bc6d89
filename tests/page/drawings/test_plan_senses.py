"""Senses of the links as the plans of a note say them in words: the signs of the analytical angular velocities and
accelerations, and of those that were read off the plan."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Note
from pages import table_of
from reading import LEVERS, html, results, wrong

COUNTER = {
    "counter-clockwise ↺": 1,
    "против часовой стрелки ↺": 1,
    "clockwise ↻": -1,
    "по часовой стрелке ↻": -1,
}
SMALL = 1e-3  # of the largest of a link: what may be read as nothing or with either sign


NOTHING = 1e-9  # of ω of the fastest link, or of its square: rounding of a link that does not turn


def told(note: Note) -> Iterator[tuple[str, str, int, str]]:
    """ "w" or "e", link, position, words of every row."""
    for table in note.tables:
        for row in table.rows:
            mark = row[-1].mark
            match = mark and re.fullmatch(r"senses_([va])_(\d+)", mark.table)
            if match:
                yield {"v": "w", "a": "e"}[match[1]], row[0].text, int(match[2]), row[-1].text


def wrong_senses(note: Note, document: dict[str, Any]) -> Iterator[str]:
    rates = table_of(document, "rates_table")
    fastest = max(float(np.nanmax(np.abs(rates[key]))) for key in rates if key.startswith("w_"))
    noise = {"w": NOTHING * fastest, "e": NOTHING * fastest**2}
    for letter, link, k, words in told(note):
        exact = rates[f"{letter}_{link}"]
        if abs(exact[k]) < max(SMALL * np.nanmax(np.abs(exact)), noise[letter]):
            continue
        if COUNTER.get(words) != np.sign(exact[k]):
            yield f"{letter}_{link} at {k} is {exact[k]:.5g}, the plan says {words!r}"


def wrong_signs(document: dict[str, Any]) -> Iterator[str]:
    """What is read off and compared has the sign of the analytical value."""
    rates = table_of(document, "rates_table")
    for name in document["tables"]:
        if not re.fullmatch(r"comparison_\d+", name):
            continue
        columns = {column["key"]: column["values"] for column in document["tables"][name]["columns"]}
        rows = zip(columns["key"], columns["graph"], columns["analytic"], columns["delta"], strict=True)
        for key, graph, analytic, delta in rows:
            if key[0] not in "we" and min(graph, analytic) < 0:
                yield f"{name}: {key} is a magnitude and negative"
            small = SMALL * np.nanmax(np.abs(rates[key])) if key in rates else 0.0
            if delta is not None and graph * analytic < 0 and max(abs(graph), abs(analytic)) > small:
                yield f"{name}: {key} is {graph}, by the analytical method {analytic}"


@pytest.mark.parametrize("name", LEVERS)
def test_words_and_signs_of_the_plans_are_those_of_the_motion(name):
    note, document = html(name), results(name)
    found = [*wrong_senses(note, document), *wrong_signs(document)]
    some = any(table.startswith("senses_") for table in document["tables"])
    wrong(found if some == any(True for _ in told(note)) else ["no senses are told"])
