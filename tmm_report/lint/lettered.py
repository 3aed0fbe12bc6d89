"""What stands in an SVG of a note, mm, y up: lettering by the advances of the note's faces, lines as segments."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice, pairwise
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

import numpy as np

from tmm_report.figures.primitives import COLOURS, TEXT
from tmm_report.report.paper.measure import letters

BELOW, ABOVE = 0.22, 0.7  # of the size: what letters take under and over their line
TEXTS, MOST, SEGMENTS = (
    2000,
    500_000,
    100_000,
)  # of a drawing, characters of a path, of a drawing: more is not read
UNSEEN = {f"#{COLOURS[name]}" for name in ("white", "pale")}  # lines that lettering may stand on
Array = Any


class Lettered(NamedTuple):
    """A text of a drawing. `box`: left, bottom, right, top."""

    text: str
    box: tuple[float, float, float, float]


def lettering(svg: Element) -> list[Lettered]:
    return [_lettered(node) for node in islice(svg.iter("text"), TEXTS)]


def _lettered(node: Element) -> Lettered:
    size = _number(node.get("font-size"), TEXT)
    x, base = _number(node.get("x")), -_number(node.get("y"))
    wide, low, high = 0.0, base, base
    for text, run, run_size, dx, dy in _runs(node, size):
        base -= dy
        wide += dx + run_size * letters(text, "italic" if run.get("font-style") == "italic" else "regular")
        if text.strip():
            low, high = min(low, base - BELOW * run_size), max(high, base + ABOVE * run_size)
    left = x - wide * {"middle": 0.5, "end": 1.0}.get(node.get("text-anchor") or "", 0.0)
    return Lettered("".join(node.itertext()), (left, low, left + wide, high))


def _runs(node: Element, size: float) -> Iterator[tuple[str, Element, float, float, float]]:
    """Text, the element that says how it looks, size, shift to the right and down of each run."""
    if node.text:
        yield node.text, node, size, 0.0, 0.0
    for run in node:
        own = _number(run.get("font-size"), size)
        yield "".join(run.itertext()), run, own, _number(run.get("dx")), _number(run.get("dy"))
        if run.tail:
            yield run.tail, node, size, 0.0, 0.0


def _number(text: str | None, otherwise: float = 0.0) -> float:
    """A coordinate; of what is none, as it were not there."""
    match = _NUMBER.fullmatch(text or "")
    return float(match[0]) if match else otherwise


_NUMBER = re.compile(r"-?\d{1,6}(?:\.\d{1,9})?")


# --- lines ---


def lines(svg: Element) -> Array:
    """All that is drawn dark as segments (M, 2), complex."""
    strokes: list[list[complex]] = []
    for node in svg.iter():
        if node.tag == "path" and _seen(node):
            strokes += _strokes(node.get("d") or "")
        elif node.tag == "circle" and _seen(node):
            centre = complex(_number(node.get("cx")), -_number(node.get("cy")))
            strokes.append([*(centre + _number(node.get("r")) * _ROUND)])
    pairs = [*islice((pair for stroke in strokes for pair in pairwise(stroke)), SEGMENTS)]
    return np.array(pairs, complex).reshape(-1, 2)


_ROUND = np.exp(2j * np.pi * np.arange(25) / 24)


def _seen(node: Element) -> bool:
    colour = node.get("stroke") or node.get("fill") or "none"
    return colour not in UNSEEN and colour != "none"


_STEP = re.compile(r"([MLAZ])([^MLAZ]*)")


def _strokes(path: str) -> list[list[complex]]:
    """The polylines of a path of M, L, A and Z, as the figures write them."""
    strokes: list[list[complex]] = []
    for command, text in _STEP.findall(path[:MOST]):
        numbers = [float(one) for one in _FLOAT.findall(text)]
        if command == "M" and len(numbers) == 2:
            strokes.append([complex(numbers[0], -numbers[1])])
        elif not strokes:
            continue
        elif command == "L" and len(numbers) == 2:
            strokes[-1].append(complex(numbers[0], -numbers[1]))
        elif command == "A" and len(numbers) == 7:
            strokes[-1] += _arc(strokes[-1][-1], numbers)
        elif command == "Z":
            strokes[-1].append(strokes[-1][0])
    return strokes


_FLOAT = re.compile(r"-?\d{1,9}(?:\.\d{1,9})?(?:e[+-]?\d{1,2})?")


def _arc(start: complex, numbers: list[float]) -> list[complex]:
    """Points of an arc of a circle from a place to its end."""
    radius, _, _, large, sweep, x, y = numbers
    end = complex(x, -y)
    half = (end - start) / 2
    if abs(half) == 0:
        return [end]
    clockwise = bool(sweep)  # y is down in SVG, and so is the sense of its angles
    height = max(radius**2 - abs(half) ** 2, 0.0) ** 0.5 * (-1 if large else 1)  # a half turn, rounded, has 0
    centre = start + half + (-1j if clockwise else 1j) * half / abs(half) * height
    first, last = np.angle(start - centre), np.angle(end - centre)
    turn = (first - last if clockwise else last - first) % (2 * np.pi)
    angles = first + (-1 if clockwise else 1) * turn * np.linspace(0, 1, 3 + int(turn / 0.2))[1:]
    return [*(centre + radius * np.exp(1j * angles))]
