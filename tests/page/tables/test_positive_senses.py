"""Words of a note and signs of the results: senses of rotation, directions of loads, strokes and their times."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Note
from pages import by_law, table_of, turned_link, value_of
from reading import LEVERS, html, results, wrong

SPINS = re.compile(r"(вращается|turns) .*ω_")
LAW = re.compile(
    r"движется вокруг неподвижной точки .* по закону времени|moves about .* by a law of time"
    r"|drives the mechanism.*given as a function of time|приводит механизм.* задан"
)
CLOCKWISE = ("по часовой стрелке", " clockwise")
COUNTER = ("против часовой стрелки", "counter-clockwise")
RIGHT_ANGLES = {"вправо": 0, "to the right": 0, "влево": 180, "to the left": 180, "вверх": 90, "upwards": 90}
RIGHT_ANGLES |= {"вниз": -90, "downwards": -90}
SLANTING = re.compile(r"([−-]?\d+(?:[.,]\d+)?)°")
AGAINST, ALONG = ("против", "against"), ("по движению", "по вращению", "along", "в сторону", "по направлению")


def wrong_driver(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """The sense of the driving link's rotation as said, and as its angles change; of one that moves by a law that."""
    if by_law(document):
        if not any(LAW.search(line) for line in note.words):
            yield "the law of the driving link is not told"
        return
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
    """A load is as long along the direction said as is stated, with its sign, at every position."""
    if "stated_table" not in document["tables"]:
        return
    along, rates = table_of(document, "stated_table"), table_of(document, "rates_table")
    said = dict(stated(note))
    for key in list(along)[2:]:
        words = next((said.pop(symbol) for symbol in _symbols(key) if symbol in said), None)
        if words is None:
            yield f"{key} is stated by no row of the note, there are {list(said)}"
            continue
        vector, motion = _acting(document, rates, key)
        yield from _unlike(f"{key} {words}", words, vector, motion, along[key])
    yield from (f"{symbol} is no load of the results" for symbol in said)


def _symbols(key: str) -> list[str]:
    """How a load may be written: one moment alone without its number."""
    symbol = key.replace("_", "", 1)
    return [symbol, symbol.removesuffix(",1")]


def _acting(
    document: dict[str, Any], rates: dict[str, np.ndarray], key: str
) -> tuple[np.ndarray, np.ndarray]:
    """A force or couple, and the velocity of its point or link."""
    loads, of = table_of(document, "loads_table"), turned_link(key[2:])
    if key + "_x" not in loads:
        return loads[key] + 0j, rates[f"w_{of}"] + 0j
    vector = loads[key + "_x"] + 1j * loads[key + "_y"]
    if f"v_{of}_x" not in rates:
        return vector, 0 * vector
    return vector, rates[f"v_{of}_x"] + 1j * rates[f"v_{of}_y"]


def _direction(words: str, motion: np.ndarray) -> np.ndarray | None:
    """The unit direction that words say, nan where nothing moves; a couple's is its sign."""
    if words in RIGHT_ANGLES:
        return np.full_like(motion, np.exp(1j * math.radians(RIGHT_ANGLES[words])))
    if match := SLANTING.search(words):
        return np.full_like(
            motion, np.exp(1j * math.radians(float(match[1].replace("−", "-").replace(",", "."))))
        )
    if any(words == said.strip() for said in CLOCKWISE + COUNTER):
        return np.full_like(motion, 1 if any(said in words for said in COUNTER) else -1)
    moving = np.abs(motion) > 1e-9 * np.nanmax(np.abs(motion), initial=0.0)
    unit = np.divide(motion, np.abs(motion), out=np.full_like(motion, np.nan), where=moving)
    if words.startswith(AGAINST):
        return -unit
    return unit if words.startswith(ALONG) else None


def _unlike(
    where: str, words: str, vector: np.ndarray, motion: np.ndarray, along: np.ndarray
) -> Iterator[str]:
    """Positions at which a load does not act as the words and its signed magnitude say."""
    way = _direction(words, motion)
    if way is None:
        yield f"{where}: a direction that nobody understands"
        return
    size = max(1e-9, np.nanmax(np.abs(vector), initial=0.0))
    for k in np.flatnonzero(np.abs(vector - along * way) > 1e-6 * size):
        yield f"{where}, position {k}: acts {vector[k]:.5g}, is stated {along[k]:.5g}"


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
    link = "1" if by_law(document) else driver(next(line for line in html(name).words if SPINS.search(line)))
    difference = math.radians(value_of(document, "phi_0")) - phi[f"phi_{link}"][0]
    assert abs(math.remainder(difference, 2 * math.pi)) < 1e-6
