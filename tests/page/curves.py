"""Curves of a graph as a reader reads them: by the figures beside the axes and the letters of each axis."""

from __future__ import annotations

from typing import NamedTuple
from xml.etree.ElementTree import Element, fromstring

import numpy as np
from picture import SVG, points
from printed import number

CURVE, FRAME = "0.39", "0.22"  # mm: widths of lines by which curves and frames are known


def is_graph(svg: str) -> bool:
    """Whether a picture has curves over axes."""
    return f'stroke-width="{CURVE}"' in svg


class Axis(NamedTuple):
    """Letters and unit beside it, what 1 mm stands for, and the value at a height of 0 mm."""

    text: str
    scale: float
    zero: float

    @property
    def letter(self) -> str:
        return self.text.rsplit(", ", 1)[0].strip()

    @property
    def unit(self) -> str:
        return self.text.rsplit(", ", 1)[1].strip() if ", " in self.text else ""


Lines = list[tuple[str, list[np.ndarray]]]  # colour and strokes of each


class Curve(NamedTuple):
    axis: Axis
    turned: np.ndarray  # (P,), degrees
    values: np.ndarray  # (P,), in the unit of its axis
    name: str = ""  # beside the sample of its line over the panel
    across: float = 0.0  # degrees that 1 mm of the axis of angles stands for


class _Letters(NamedTuple):
    at: complex  # mm, y up
    text: str


def curves(svg: str) -> list[Curve]:
    """Of a sheet of panels over one axis of angles, from the top down."""
    root = fromstring(svg)
    paths = [
        (node.get("stroke-width", ""), node.get("stroke", ""), strokes(node))
        for node in root.iter(SVG + "path")
    ]
    frames = [drawn[0] for pen, _, drawn in paths if pen == FRAME and len(drawn) == 1 and len(drawn[0]) == 4]
    ruled = [line for pen, _, drawn in paths if pen == FRAME for line in drawn if len(line) == 2]
    letters = [_letters(node) for node in root.iter(SVG + "text")]
    across = _axis_of_angles(min(frames, key=lambda frame: frame.imag.min()), ruled, letters)
    lines = [(colour, drawn) for pen, colour, drawn in paths if pen == CURVE]
    found = []
    for frame in frames:
        axis, names = _axis_of_values(frame, ruled, letters), _names(frame, frames, lines, letters)
        for colour, drawn in lines:
            line = np.concatenate(drawn)
            if (
                len(drawn[0]) > 2
                and frame.imag.min() <= line.imag.min()
                and line.imag.max() <= frame.imag.max()
            ):
                values = axis.zero + axis.scale * line.imag
                turned = across.zero + across.scale * line.real
                found.append(Curve(axis, turned, values, names.get(colour, ""), across.scale))
    return found


def _names(
    frame: np.ndarray, frames: list[np.ndarray], lines: Lines, letters: list[_Letters]
) -> dict[str, str]:
    """Names of the curves of a frame by their colours: beside samples between it and the frame above."""
    low = frame.imag.max()
    high = min((other.imag.min() for other in frames if other.imag.min() > low), default=np.inf)
    found = {}
    for colour, (line, *_) in lines:
        if len(line) == 2 and low < line[1].imag < high:
            found[colour] = next((one.text for one in letters if abs(one.at - line[1] - 1.2 + 1j) < 0.5), "")
    return found


def strokes(path: Element) -> list[np.ndarray]:
    """The polylines of a path, mm, y up."""
    pieces = path.get("d", "").split("M")[1:]
    return [np.array(points(Element("path", d=piece))) for piece in pieces] or [np.zeros(0, complex)]


def _letters(node: Element) -> _Letters:
    return _Letters(complex(float(node.get("x", "0")), -float(node.get("y", "0"))), "".join(node.itertext()))


def _axis_of_values(frame: np.ndarray, ruled: list[np.ndarray], letters: list[_Letters]) -> Axis:
    """By the figures to the left of a frame, each beside its tick; its name stands over its left end."""
    left, low, high = frame.real.min(), frame.imag.min(), frame.imag.max()
    named = min((one for one in letters if _over(one, left, high)), key=lambda one: one.at.imag).text
    beside = [one for one in letters if one.at.real < left and low - 2 <= one.at.imag <= high + 2]
    ticks = [line[0].imag for line in ruled if np.ptp(line.imag) == 0 and abs(line[1].real - left) < 0.01]
    figures = [(one.at.imag + 1.0, x.value) for one in beside if (x := number(one.text)) is not None]
    return _axis(named, ticks, figures)


def _over(one: _Letters, left: float, high: float) -> bool:
    return abs(one.at.real - left) < 0.01 and 0 < one.at.imag - high < 25 and number(one.text) is None


def _axis_of_angles(frame: np.ndarray, ruled: list[np.ndarray], letters: list[_Letters]) -> Axis:
    """By the figures under the lowest frame."""
    left, low = frame.real.min(), frame.imag.min()
    under = [one for one in letters if one.at.imag < low and one.at.real >= left - 1]
    figures = [(one.at.real, x.value) for one in under if (x := number(one.text)) is not None]
    ticks = [line[0].real for line in ruled if np.ptp(line.real) == 0 and abs(line[1].imag - low) < 0.01]
    return _axis("", ticks, figures)


def _axis(named: str, ticks: list[float], figures: list[tuple[float, float]]) -> Axis:
    """The straight line through the figures at the ticks that they stand at."""
    nearest = [(min(ticks, key=lambda tick: abs(tick - at)), at, value) for at, value in figures]
    own = [(tick, value) for tick, at, value in nearest if abs(tick - at) < 1.5]
    scale, zero = np.polyfit(*zip(*own, strict=True), 1)
    return Axis(named, float(scale), float(zero))
