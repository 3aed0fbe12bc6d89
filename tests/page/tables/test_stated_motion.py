"""Position 0 and the assembly of the groups as a variant's file states them, in the results."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import yaml
from conftest import path_of
from note import Note
from pages import table_of
from reading import LEVERS, html, results, wrong
from statics import Places

WAYS = {"right": 1, "left": -1, "up": 1j, "down": -1j}
SIDE = re.compile(r"(left|right) of (\w+)-(\w+)")


def along(places: Any, way: complex) -> np.ndarray:
    return (np.asarray(places) * np.conj(way)).real


def wrong_zero(stated: dict[str, str], document: dict[str, Any]) -> Iterator[str]:
    """At the extreme position 0 no other position lies farther."""
    table = table_of(document, "positions_diagram")
    if "point" in stated:
        point = stated["point"]
        reached = along(table[f"x_{point}"] + 1j * table[f"y_{point}"], WAYS[stated["extreme"]])
    elif "link" in stated:
        turned = np.unwrap(table[f"phi_{stated['link']}"])
        reached = turned if stated["extreme"] == "counter-clockwise" else -turned
    else:
        return
    if np.nanmax(reached) > reached[0] + 1e-9:
        yield f"position 0 is not {stated}: {np.nanmax(reached)} is reached after {reached[0]}"


def inner(group: str, links: dict[str, list[str]]) -> str:
    """The joint of a dyad, named or as that of its links."""
    one, _, other = group.partition("-")
    return next(point for point in links[one] if point in links[other]) if other else group


def before(point: str, links: dict[str, list[str]]) -> str:
    """The joint at the other end of the rod that moves a slider's point."""
    rod = next(points for points in links.values() if point in points and len(points) > 1)
    return next(p for p in rod if p != point and sum(p in points for points in links.values()) > 1)


def wrong_assembly(data: dict[str, Any], note: Note, document: dict[str, Any]) -> Iterator[str]:
    links = {str(key): [str(p) for p in link["points"]] for key, link in data["links"].items()}
    places = Places(note, document)
    for group, side in (data.get("assembly") or {}).items():
        match = SIDE.fullmatch(str(side))
        if match:
            point, start, end = inner(group, links), places[match[2]], places[match[3]]
            found = (np.conj(end - start) * (places[point] - start)).imag * (1 if match[1] == "left" else -1)
        elif side in WAYS and "-" not in group:
            found = along(places[group] - places[before(group, links)], WAYS[side])
        else:
            continue
        if not np.atleast_1d(found)[0] > 0:
            yield f"{group} is not {side} at position 0"


@pytest.mark.parametrize("name", LEVERS)
def test_position_0_and_assembly_are_as_stated(name):
    data = yaml.safe_load(path_of(name).read_text("utf-8"))["mechanism"]
    document = results(name)
    zero = [] if {"law", "stroke"} & data["driver"].keys() else wrong_zero(data["driver"]["zero"], document)
    wrong([*zero, *wrong_assembly(data, html(name), document)])


def wrong_lengths(document: dict[str, Any], note: Note, data: dict[str, Any]) -> Iterator[str]:
    """Points of a link keep their given distances at every position."""
    columns = {c["key"]: c["values"] for c in document["tables"]["dimensions"]["columns"]}
    links, places = {str(key): of for key, of in data["links"].items()}, Places(note, document)
    for key, link, length in zip(columns["key"], columns["link"], columns["length"], strict=True):
        points = [str(point) for point in links[link]["points"]]
        ends = [(a, b) for a, b in itertools.permutations(points, 2) if key == f"l_{a}{b}"]
        for a, b in ends:
            off = np.abs(np.abs(places[b] - places[a]) - length)
            if np.nanmax(off, initial=0.0) > 1e-9:
                yield f"{key} = {length} m is {np.nanmax(off):.3g} m off at position {np.nanargmax(off)}"


@pytest.mark.parametrize("name", LEVERS)
def test_links_keep_their_lengths(name):
    data = yaml.safe_load(path_of(name).read_text("utf-8"))["mechanism"]
    wrong(list(wrong_lengths(results(name), html(name), data)))
