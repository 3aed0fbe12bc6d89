"""Pictures whose parts move of themselves: wheels in mesh, a planetary stage, a drive from the side, a cam under its
follower.

What turns with what, and how fast, is the drive's: its table of speeds. The shaft whose turn is one turn of the cycle
is the crank where the drive turns that, else the fastest of the drive.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tmm_report.course import Results
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing, Moves, Moving, Text, shapes
from tmm_report.figures.primitives import Item
from tmm_report.living.cycle import places
from tmm_report.results import tables

SAME = 1e-3  # relative: speeds nearer than this are those of one shaft
_TAG = re.compile(r"<(/?)\w[^>]*?(/?)>")


def moved(pictures: Mapping[str, Drawing | Graph], results: Results) -> dict[str, Any]:
    """Anchor -> parts of its picture that move, and the numbers of the elements that they take the place of."""
    rates, found = _rates(results), {}
    for anchor, picture in pictures.items():
        moves = picture.moves if isinstance(picture, Drawing) else None
        if isinstance(picture, Drawing) and moves is not None:
            members = {name for part in moves.parts for name in (part.of, part.about) if name}
            if members <= rates.keys():
                parts = [_part(part, rates) for part in moves.parts]
                found[anchor] = {"still": list(_numbers(picture, moves)), "bare": moves.bare, "parts": parts}
                if moves.bare:
                    found[anchor]["box"] = _box(picture, moves)
    return found


def _rates(results: Results) -> dict[str, float]:
    """Turns of each member of the drive in one turn of the cycle."""
    speeds = next((t for t in tables(results) if t.name == "drive_speeds"), None)
    if speeds is None:
        return {}
    omega = dict(zip(map(str, speeds["member"].values), speeds["omega"].numbers().tolist(), strict=True))
    base = max(omega.values(), key=abs)
    if results.lever is not None:
        crank = float(np.ravel(results.lever.kinematics.omega)[0])
        base = next((w for w in omega.values() if abs(abs(w) - abs(crank)) <= SAME * abs(crank)), base)
    return {name: w / abs(base) for name, w in omega.items()} if base else {}


def _part(part: Moving, rates: Mapping[str, float]) -> dict[str, Any]:
    rate = rates.get(part.of, 0.0)
    said: dict[str, Any] = {
        "svg": shapes(part.items),
        "centre": _pair(part.centre),
        "rate": part.sense * abs(rate) if part.sense else rate,
    }
    if part.about:
        said["about"] = rates[part.about]
    if part.rise:
        said["rise"] = _pair(part.rise)
        said["across"] = _pair(part.across)
        if part.side:
            said["side"] = part.side
    if part.pitch:
        said |= {"pitch": np.degrees(part.pitch), "half": part.half}
    if part.at:
        said["at"] = places(np.degrees(part.at), 6)
    if part.turns:
        said["turns"] = places(np.degrees(part.turns), 4)
    if part.ways:
        said["ways"] = [places(np.real(part.ways), 3), places(np.imag(part.ways), 3)]
    return said


def _pair(z: complex) -> list[float]:
    return [round(z.real, 4) + 0.0, round(z.imag, 4) + 0.0]


def _box(picture: Drawing, moves: Moves) -> list[float]:
    """Room for the parts in every position: left, top, width and height, mm, y down."""
    left, bottom, right, top = picture.box
    for part in moves.parts:
        corners = np.array([z for item in part.items for z in item.corners()], complex)
        turns = np.exp(1j * np.array(part.turns if part.turns else (0.0,)))[:, None]
        ways = np.array(part.ways if part.ways else (0j,))[:, None]
        every = part.centre + (corners - part.centre) * turns + ways
        if part.about:
            every = np.abs(every).max() * np.array([1, 1j, -1, -1j])
        elif part.of:
            every = part.centre + np.abs(every - part.centre).max() * np.array([1, 1j, -1, -1j])
        left, right = min(left, float(every.real.min()) - 1), max(right, float(every.real.max()) + 1)
        bottom, top = min(bottom, float(every.imag.min()) - 1), max(top, float(every.imag.max()) + 1)
    return [round(x, 2) for x in (left, -top, right - left, top - bottom)]


def _numbers(picture: Drawing, moves: Moves) -> Iterator[int]:
    """Numbers of the elements of a picture, in its order, that are of the items at rest."""
    still, number = {id(item) for item in moves.still}, 0
    for item in picture.items:
        if not isinstance(item, Text):
            count = _elements(item)
            if id(item) in still:
                yield from range(number, number + count)
            number += count


def _elements(item: Item) -> int:
    """How many elements an item is, one within the other counted once."""
    depth = found = 0
    for closes, alone in _TAG.findall(item.svg([])):
        if closes:
            depth -= 1
            continue
        found += depth == 0
        depth += not alone
    return found
