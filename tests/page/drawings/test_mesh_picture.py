"""The picture of a spur pair against results.json: radii of its circles at the stated scale, and as lettered."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import fromstring

import pytest
from note import text_of
from picture import SVG
from printed import number
from reading import BOTH, html, results, wrong

MESH = re.compile(
    r"(?:Картина зацепления|Mesh of).*?([\w']+)-([\w']+), .*?(\d+(?:[.,]\d+)?):(\d+(?:[.,]\d+)?)"
)
ARC = re.compile(r"A([\d.]+) ")
LETTERED = re.compile(r"r([awbf]?)([\d']+) = (.+)")


def scale(one: str, other: str) -> float:
    """2,5:1 as a number."""
    return float(one.replace(",", ".")) / float(other.replace(",", "."))


def diameters(document: dict[str, Any], wheels: tuple[str, str]) -> Iterator[tuple[str, str, float]]:
    """Index, wheel and diameter of the circles, m."""
    for name, table in document["tables"].items():
        columns = {column["key"]: column["values"] for column in table["columns"]}
        if name.endswith("wheels") and columns["wheel"] == list(wheels) and "d_w" in columns:
            for index in ("a", "w", "", "b", "f"):
                for wheel, d in zip(wheels, columns[f"d_{index}" if index else "d"], strict=True):
                    yield index, wheel, d


@pytest.mark.parametrize(("name", "language"), BOTH)
def test_circles_of_a_mesh(name, language):
    note, document, found = html(name, language), results(name), []
    for figure in note.root.iter("figure"):
        match = MESH.search(text_of(figure.find("figcaption")))  # type: ignore[arg-type]
        if match is None:
            continue
        root, per_mm = fromstring(note.drawings[figure.get("id") or ""]), scale(match[3], match[4])
        radii = [float(r) for path in root.iter(SVG + "path") for r in ARC.findall(path.get("d", ""))]
        letters = ["".join(node.itertext()) for node in root.iter(SVG + "text")]
        known = {(index, wheel): d / 2 * 1e3 for index, wheel, d in diameters(document, match.groups()[:2])}
        for (index, wheel), radius in known.items():
            if index and not any(abs(r - per_mm * radius) < 0.002 for r in radii):
                found.append(f"{name}: no circle of r_{index}{wheel} = {radius:.4g} mm at {per_mm}:1")
        found += wrong_lettering(letters, known)
    wrong(found)


def wrong_lettering(letters: list[str], known: dict[tuple[str, str], float]) -> Iterator[str]:
    lettered = [match for text in letters if (match := LETTERED.fullmatch(text))]
    if len(lettered) < 8:
        yield f"only {len(lettered)} circles are lettered: {letters}"
    for match in lettered:
        printed = number(match[3])
        if printed is None or abs(printed.value - known[match[1], match[2]]) > printed.half * 1.01:
            yield f"{match[0]}, by the results {known[match[1], match[2]]:.6g}"
