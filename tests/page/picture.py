"""A drawing of a note read from its SVG: arrows, dots, corners and lettering, mm of paper, y up."""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Element, fromstring

SVG = "{http://www.w3.org/2000/svg}"
_NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
_POINT = re.compile(rf"({_NUMBER})[ ,]({_NUMBER})")
_LABEL = 3.2  # the size of lettering of points, mm


@dataclass(frozen=True)
class Picture:
    arrows: list[tuple[complex, complex]]  # start and tip
    dots: list[tuple[complex, float]]  # centre and radius
    corners: list[complex]
    letters: list[tuple[complex, str]]  # place and text of the lettering of points


def place(x: str, y: str) -> complex:
    return complex(float(x), -float(y))


def points(path: Element) -> list[complex]:
    return [place(*found) for found in _POINT.findall(path.get("d", ""))]


def picture(svg: str) -> Picture:
    """An arrow is a line and the triangle that follows it."""
    nodes = list(fromstring(svg).iter())
    arrows, corners, dots, letters = [], [], [], []
    for one, other in zip(nodes, [*nodes[1:], None], strict=True):
        if one.tag == SVG + "path":
            corners += points(one)
            if other is not None and _head(other) and len(points(one)) == 2:
                arrows.append((points(one)[0], points(other)[0]))
        elif one.tag == SVG + "circle":
            dots.append((place(one.get("cx", "0"), one.get("cy", "0")), float(one.get("r", "0"))))
        elif one.tag == SVG + "text" and float(one.get("font-size", str(_LABEL))) == _LABEL:
            letters.append((place(one.get("x", "0"), one.get("y", "0")), "".join(one.itertext())))
    return Picture(arrows, dots, corners, letters)


def _head(node: Element) -> bool:
    return node.tag == SVG + "path" and len(points(node)) == 3 and node.get("d", "").endswith("Z")
