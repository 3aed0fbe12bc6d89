"""Curves of a graph as a reader reads them: by the figures beside the axes and the letters of each axis."""

from __future__ import annotations

import re
from typing import NamedTuple
from xml.etree.ElementTree import Element, fromstring

import numpy as np
from picture import SVG
from printed import number

POINT = 25.4 / 72  # mm
CURVE, FRAME = "stroke-width: 1.1", "stroke-width: 0.6"
_STEP = re.compile(r"([ML]) (-?[\d.]+) (-?[\d.]+)")
_TURN = re.compile(r"translate\((-?[\d.]+) (-?[\d.]+)\) rotate\(-90\)")


class Axis(NamedTuple):
    """Letters and unit beside it, what 1 mm stands for, and the value at a height of 0 mm."""

    text: str
    scale: float
    zero: float

    @property
    def letter(self) -> str:
        return self.text.split(",")[0].strip()

    @property
    def unit(self) -> str:
        return self.text.split(",")[1].strip() if "," in self.text else ""


class Curve(NamedTuple):
    axis: Axis
    turned: np.ndarray  # (P,), degrees
    values: np.ndarray  # (P,), in the unit of its axis


class _Letters(NamedTuple):
    at: complex  # mm, y up
    text: str


def curves(svg: str) -> list[Curve]:
    """Of a sheet of panels over one axis of angles, from the top down."""
    root = fromstring(svg)
    paths = [(node.get("style", ""), strokes(node)) for node in root.iter(SVG + "path")]
    frames = [drawn for style, drawn in paths if FRAME in style and len(drawn[0]) == 5]
    letters = [_letters(node) for node in root.iter(SVG + "text")]
    lowest = min(frames, key=lambda drawn: drawn[0].imag.min())
    across = _axis_of_angles(lowest[0], letters)
    lines = [np.concatenate(drawn) for style, drawn in paths if CURVE in style and len(drawn[0]) > 2]
    found = []
    for frame in frames:
        axis = _axis_of_values(frame[0], frame[1:], letters)
        for line in lines:
            if frame[0].imag.min() <= line.imag.min() and line.imag.max() <= frame[0].imag.max():
                values = axis.zero + axis.scale * line.imag
                found.append(Curve(axis, across.zero + across.scale * line.real, values))
    return found


def strokes(path: Element) -> list[np.ndarray]:
    """The polylines of a path, mm, y up."""
    found: list[list[complex]] = []
    for kind, x, y in _STEP.findall(path.get("d", "")):
        if kind == "M":
            found.append([])
        found[-1].append(POINT * complex(float(x), -float(y)))
    return [np.array(stroke) for stroke in found] or [np.zeros(0, complex)]


def _letters(node: Element) -> _Letters:
    match = _TURN.search(node.get("transform", ""))
    x, y = match.groups() if match else (node.get("x", "0"), node.get("y", "0"))
    return _Letters(POINT * complex(float(x), -float(y)), "".join(node.itertext()))


def _axis_of_values(frame: np.ndarray, ruled: list[np.ndarray], letters: list[_Letters]) -> Axis:
    """By the figures to the left of a frame, each beside its tick."""
    left, low, high = frame.real.min(), frame.imag.min(), frame.imag.max()
    beside = [one for one in letters if one.at.real < left and low - 2 <= one.at.imag <= high + 2]
    named = next(one.text for one in beside if number(one.text) is None)
    level = [line for line in ruled if len(line) == 2 and np.ptp(line.imag) == 0]
    ticks = [line[0].imag for line in level if abs(line[1].real - left) < 0.01]
    figures = [(one.at.imag, x.value) for one in beside if (x := number(one.text)) is not None]
    nearest = [(min(ticks, key=lambda tick: abs(tick - at)), at, value) for at, value in figures]
    own = [(tick, value) for tick, at, value in nearest if abs(tick - at) < 1.5]
    scale, zero = np.polyfit(*zip(*own, strict=True), 1)
    return Axis(named, float(scale), float(zero))


def _axis_of_angles(frame: np.ndarray, letters: list[_Letters]) -> Axis:
    """By the figures under the lowest frame."""
    left, low = frame.real.min(), frame.imag.min()
    under = [one for one in letters if one.at.imag < low and one.at.real >= left - 1]
    figures = [(one.at.real, x.value) for one in under if (x := number(one.text)) is not None]
    places, values = zip(*figures, strict=True)
    scale, zero = np.polyfit(places, values, 1)
    return Axis("", float(scale), float(zero))
