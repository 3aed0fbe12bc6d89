"""A drawing of a note read from its SVG: arrows, dots, corners and lettering, mm of paper, y up."""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Element, fromstring

SVG = "{http://www.w3.org/2000/svg}"
_NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
_POINT = re.compile(rf"({_NUMBER})[ ,]({_NUMBER})")
_LABEL = 3.2  # the size of lettering of points, mm
_LEADER = "0.1"  # width of the lines that lead to lettering, mm


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
    return Picture(arrows, dots, corners, letters + led(nodes))


def led(nodes: list[Element]) -> list[tuple[complex, str]]:
    """Texts with the places from which a line leads to them: the line ends at the nearest text."""
    texts = [
        (_middle(node), _long(node), "".join(node.itertext())) for node in nodes if node.tag == SVG + "text"
    ]
    lines = [points(node) for node in nodes if node.get("stroke-width") == _LEADER]
    return [(line[0], _nearest(line[1], texts)) for line in lines if len(line) == 2 and texts]


def _long(node: Element) -> float:
    """About half of a text's length, mm."""
    return 0.25 * float(node.get("font-size", str(_LABEL))) * len("".join(node.itertext()))


def _middle(node: Element) -> complex:
    side = {"middle": 0, "end": -1}.get(node.get("text-anchor", ""), 1)
    return place(node.get("x", "0"), node.get("y", "0")) + complex(side * _long(node), 1.0)


def _nearest(end: complex, texts: list[tuple[complex, float, str]]) -> str:
    def off(middle: complex, long: float) -> float:
        by = end - middle
        return abs(complex(max(0.0, abs(by.real) - long), by.imag))

    return min(texts, key=lambda text: off(text[0], text[1]))[2]


def _head(node: Element) -> bool:
    return node.tag == SVG + "path" and len(points(node)) == 3 and node.get("d", "").endswith("Z")
