"""The graph of specific sliding and the two pairs in contact, measured on the page against results.json."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element, fromstring

import numpy as np
import pytest
from note import text_of
from picture import SVG, picture, points
from reading import BOTH, html, results, wrong

PAIR = r".*?([\w']+)-([\w']+), .*?(\d+(?:[.,]\d+)?):(\d+(?:[.,]\d+)?)"
SLIDING = re.compile(r"(?:Удельное скольжение профилей|Specific sliding of the profiles)" + PAIR)
TWO = re.compile(r"(?:Картина зацепления|Mesh of)" + PAIR + r".*(?:две пары|two pairs)")
CURVES = ("#1B4F9C", "#B3261E")  # of the wheels of a pair
WHOLE = "0.6"  # width of the curves over the active part, mm


def tables(document: dict[str, Any], wheels: tuple[str, str]) -> tuple[str, dict[str, Any]]:
    """The stage of a pair: the prefix of its names, and its tables by their own names."""
    for name, table in document["tables"].items():
        if name.endswith("_sliding") and {f"lambda_{wheel}" for wheel in wheels} <= {
            c["key"] for c in table["columns"]
        }:
            stage = name.removesuffix("_sliding")
            own = {key: of for key, of in document["tables"].items() if key.startswith(stage + "_")}
            return stage, {
                key.removeprefix(stage + "_"): {c["key"]: c["values"] for c in of["columns"]}
                for key, of in own.items()
            }
    raise AssertionError(f"no table of sliding of {wheels}")


def figures(note: Any, caption: re.Pattern[str]) -> Iterator[tuple[re.Match[str], Element, str]]:
    for figure in note.root.iter("figure"):
        match = caption.search(text_of(figure.find("figcaption")))
        if match:
            yield match, figure, note.drawings[figure.get("id") or ""]


def pairs(document: dict[str, Any]) -> int:
    return sum(name.startswith("stage") and name.endswith("_sliding") for name in document["tables"])


def scale(one: str, other: str) -> float:
    return float(one.replace(",", ".")) / float(other.replace(",", "."))


@pytest.mark.parametrize(("name", "language"), BOTH)
def test_the_graph_of_sliding_is_at_both_its_scales(name, language):
    document, found = results(name), []
    values = {entry["key"]: entry["value"] for entry in document["values"]}
    drawn = list(figures(html(name, language), SLIDING))
    assert len(drawn) == pairs(document)
    for match, _, svg in drawn:
        stage, own = tables(document, (match[1], match[2]))
        per_mm, up = scale(match[3], match[4]), values[f"{stage}_mu_sliding"]
        paths = [node for node in fromstring(svg).iter(SVG + "path") if node.get("stroke-width") == WHOLE]
        rho = 1e3 * np.array(own["sliding"][f"rho_{match[1]}"])
        middle = 1e3 * own["points"][f"rho_{match[1]}"][own["points"]["point"].index("P")]
        for wheel, colour in zip((match[1], match[2]), CURVES, strict=True):
            curve = np.array(points(next(node for node in paths if node.get("stroke") == colour)))
            at = middle + curve.real / per_mm
            order = np.argsort(rho)
            exact = np.interp(at, rho[order], np.array(own["sliding"][f"lambda_{wheel}"])[order])
            if abs(np.ptp(curve.real) - per_mm * np.ptp(rho)) > 0.01:
                found.append(f"{match[0]}: AB is {np.ptp(curve.real):.5g} mm long")
            if (off := np.abs(curve.imag - exact / up).max()) > 0.05:
                found.append(f"{match[0]}: λ of {wheel} is drawn {off:.3g} mm off")
    wrong(found)


@pytest.mark.parametrize(("name", "language"), BOTH)
def test_two_pairs_touch_a_base_pitch_apart(name, language):
    document, found = results(name), []
    values = {entry["key"]: entry["value"] for entry in document["values"]}
    drawn = list(figures(html(name, language), TWO))
    assert len(drawn) == pairs(document)
    for match, _, svg in drawn:
        stage, _ = tables(document, (match[1], match[2]))
        apart = 1e3 * values[f"{stage}_p_b"] * scale(match[3], match[4])
        marks = [place for place, radius in picture(svg).dots if radius == 0.9]
        if not any(abs(abs(a - b) - apart) < 0.02 for a, b in itertools.combinations(marks, 2)):
            found.append(f"{match[0]}: no two points of contact are {apart:.4g} mm apart")
    wrong(found)
