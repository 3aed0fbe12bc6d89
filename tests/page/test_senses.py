"""Words of a note and signs of the results: senses of rotation, directions of loads, strokes and their times."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Note
from pages import table_of, value_of
from reading import LEVERS, html, results, wrong

SPINS = re.compile(r"(вращается|turns) .*ω_")
CLOCKWISE = ("по часовой стрелке", " clockwise")
COUNTER = ("против часовой стрелки", "counter-clockwise")
RIGHT_ANGLES = {"вправо": 0, "to the right": 0, "влево": 180, "to the left": 180, "вверх": 90, "upwards": 90}
RIGHT_ANGLES |= {"вниз": -90, "downwards": -90}
AGAINST, ALONG = ("против", "against"), ("по движению", "по вращению", "along", "в сторону", "по направлению")


def wrong_driver(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """The sense of the driving link's rotation as said, and as its angles change."""
    said = next(line for line in note.words if SPINS.search(line))
    counter = any(words in said for words in COUNTER)
    phi = table_of(document, "positions_table")[f"phi_{driver(said)}"]
    turned = math.remainder(phi[1] - phi[0], 2 * math.pi)
    if counter != (turned > 0) or (not counter and not any(words in said for words in CLOCKWISE)):
        yield f"{said!r}: the angle changes by {turned:.3f}"


def driver(line: str) -> str:
    return line.split("ω_")[1].split("=")[0]


def stated(note: Note) -> Iterator[tuple[str, str]]:
    """Symbol and direction of every stated load."""
    for table in note.tables:
        if [head.text for head in table.heads][1:] in (
            ["Нагрузка", "Приложена", "Направление"],
            ["Load", "Applied to", "Direction"],
        ):
            for row in table.rows:
                yield row[0].text, row[3].text


def wrong_directions(note: Note, document: dict[str, Any]) -> Iterator[str]:
    loads, rates = table_of(document, "loads_table"), table_of(document, "rates_table")
    for symbol, words in stated(note):
        key = f"{symbol[0]}_{symbol[1:]}"
        if key + "_x" in loads:
            vector = loads[key + "_x"] + 1j * loads[key + "_y"]
            point = symbol[1:].split(",")[0]
            velocity = rates.get(f"v_{point}_x", 0 * vector.real) + 1j * rates.get(
                f"v_{point}_y", 0 * vector.real
            )
            yield from _unlike(f"{symbol} {words}", words, vector, velocity)
        else:
            couple = loads.get(key, loads.get(f"{key},1"))
            if couple is None:
                yield f"{symbol} is no load of the results"
                continue
            yield from _unlike(
                f"{symbol} {words}", words, couple + 0j, rates[f"w_{symbol[1:].split(',')[0]}"] + 0j
            )


def _unlike(where: str, words: str, vector: np.ndarray, motion: np.ndarray) -> Iterator[str]:
    """Positions at which a load does not act as the words say."""
    acting = np.abs(vector) > 1e-9 * np.nanmax(np.abs(vector), initial=1e-30)
    power = (np.conj(vector) * motion).real
    if words in RIGHT_ANGLES:
        off = acting & (np.abs(np.angle(vector * np.exp(-1j * math.radians(RIGHT_ANGLES[words])))) > 1e-6)
    elif any(words == said.strip() for said in CLOCKWISE + COUNTER):
        off = acting & ((vector.real > 0) != any(said in words for said in COUNTER))
    elif words.startswith(AGAINST):
        off = acting & (power > 1e-9 * np.nanmax(np.abs(power), initial=0.0))
    elif words.startswith(ALONG):
        off = acting & (power < -1e-9 * np.nanmax(np.abs(power), initial=0.0))
    else:
        return
    if off.any() and (off == acting).all():  # a law may turn negative: a suction, a spring
        yield f"{where}: acts {np.unique(np.round(vector, 3))}"


@pytest.mark.parametrize("name", LEVERS)
def test_words_of_direction_are_the_signs(name):
    note, document = html(name), results(name)
    wrong([*wrong_driver(note, document), *wrong_directions(note, document)])


@pytest.mark.parametrize("name", LEVERS)
def test_strokes_and_their_times(name):
    """A stroke is the way between its extremes; the slow one takes K times as long as the fast one."""
    document, found = results(name), []
    entries = {entry["key"]: entry for entry in document["values"]}
    for key, entry in entries.items():
        of = key[2:]
        if key.startswith("H_"):
            low, high = entries[f"S_{of}_min"], entries[f"S_{of}_max"]
            if not math.isclose(entry["value"], high["value"] - low["value"], rel_tol=1e-9):
                found.append(f"{key} is {entry['value']}, its ends {low['value']} and {high['value']}")
        if key.startswith("K_"):
            out = (entries[f"S_{of}_max"]["at_deg"] - entries[f"S_{of}_min"]["at_deg"]) % 360
            ratio = max(out, 360 - out) / min(out, 360 - out)
            if not math.isclose(entry["value"], ratio, rel_tol=1e-6):
                found.append(f"{key} is {entry['value']}, by the angles {ratio}")
    wrong(found)


@pytest.mark.parametrize("name", LEVERS)
def test_angle_of_position_0(name):
    document = results(name)
    phi = table_of(document, "positions_table")
    said = next(line for line in html(name).words if SPINS.search(line))
    difference = math.radians(value_of(document, "phi_0")) - phi[f"phi_{driver(said)}"][0]
    assert abs(math.remainder(difference, 2 * math.pi)) < 1e-6
