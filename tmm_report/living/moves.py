"""Pictures whose parts move of themselves: wheels in mesh, a planetary stage, drives and trains from the side, an
eccentric mechanism, a cam under its follower.

How fast a member turns is what its chapter found, of a stage of a drive the drive's table of speeds. The shaft whose
turn is one turn of the cycle is the crank where the members turn that, else the fastest of them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
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
    found: dict[str, Any] = {}
    drive = _drive(results)
    for anchor, picture in pictures.items():
        moves = picture.moves if isinstance(picture, Drawing) else None
        if isinstance(picture, Drawing) and moves is not None:
            rates = _rates(moves, drive, results)
            members = {name for part in moves.parts for name in (part.of, part.about) if name}
            if members <= rates.keys():
                numbers = _numbers(picture)
                still = [k for item in moves.still for k in numbers.get(id(item), ())]
                parts = [_part(part, rates, numbers) for part in moves.parts]
                found[anchor] = {"still": still, "bare": moves.bare, "parts": parts}
                if moves.bare:
                    found[anchor]["box"] = _box(picture, moves)
    return found


def _drive(results: Results) -> dict[str, float]:
    """Speeds of the members of the drive, rad/s; of none where there is none."""
    speeds = next((t for t in tables(results) if t.name == "drive_speeds"), None)
    if speeds is None:
        return {}
    return dict(zip(map(str, speeds["member"].values), speeds["omega"].numbers().tolist(), strict=True))


def _rates(moves: Moves, drive: Mapping[str, float], results: Results) -> dict[str, float]:
    """Turns of each member in one turn of the cycle."""
    omega = drive if moves.speed is None else moves.speed
    base = omega[moves.once] if moves.once else max(omega.values(), key=abs, default=0.0)
    if results.lever is not None:
        crank = float(np.ravel(results.lever.kinematics.omega)[0])
        base = next((w for w in omega.values() if abs(abs(w) - abs(crank)) <= SAME * abs(crank)), base)
    return {name: w / abs(base) for name, w in omega.items()} if base else {}


def _part(part: Moving, rates: Mapping[str, float], numbers: Mapping[int, range]) -> dict[str, Any]:
    """Items of the picture by their numbers in it, the others as they are drawn."""
    rate = rates.get(part.of, 0.0)
    said: dict[str, Any] = {
        "svg": shapes([item for item in part.items if id(item) not in numbers]),
        "centre": _pair(part.centre),
        "rate": part.sense * abs(rate) if part.sense else rate,
    }
    if same := [k for item in part.items for k in numbers.get(id(item), ())]:
        said["same"] = same
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


def _numbers(picture: Drawing) -> dict[int, range]:
    """Of each item of a picture, by its id, the numbers of its elements in their order."""
    found, number = {}, 0
    for item in picture.items:
        if not isinstance(item, Text):
            found[id(item)] = range(number, number := number + _elements(item))
    return found


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
