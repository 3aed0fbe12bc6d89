"""Drawings measured on the paper: three segments of each kind are as long as their numbers, in print and in LaTeX."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any
from xml.etree.ElementTree import fromstring

import numpy as np
import pytest
from browser import printed_without_fonts, seen
from captions import figures, position_of
from exhaustive import many
from note import text_of
from notes import note
from pages import table_of
from paper import arrows, strokes
from picture import SVG
from reading import CHOSEN, LEVERS, html, results, wrong
from test_mesh_picture import MESH
from typesetting import by_typst, typeset
from vectors import vectors

MEASURED = 0.1  # mm
Numbers = dict[str, float]  # key of a drawn vector -> its length by the results, mm
Measured = tuple[str, str, complex, float]  # figure, key, the drawn vector and its number, mm


# --- numbers of the results ---


def segments(document: dict[str, Any], letter: str, k: int) -> Numbers:
    """Of a plan: the segments from its pole, "pb" of v_B."""
    table = table_of(document, f"segments_{letter}")
    row = list(table["position"]).index(k)
    points = {key[2:] for key in table_of(document, "positions_table") if key.startswith("x_")}
    pole = "p" if letter == "v" else "π"
    return {
        f"{letter}_{p}": table[pole + p.lower()][row]
        for p in points
        if np.isfinite(table.get(pole + p.lower(), [np.nan] * (row + 1))[row])
    }


def sides(document: dict[str, Any], k: int) -> Numbers:
    """Of force polygons: the lengths L_R that are worked out beside them."""
    found: Numbers = {}
    for name, table in document["tables"].items():
        if name.startswith(f"force_plan_{k}_"):
            columns = {column["key"]: column["values"] for column in table["columns"]}
            of = dict(zip(columns["key"], columns["value"], strict=True))
            found |= {key[2:]: value for key, value in of.items() if key.startswith("L_R")}
    return found


def arms(document: dict[str, Any], k: int) -> Numbers:
    """Of loading schemes: the arms of forces."""
    columns = {
        column["key"]: column["values"]
        for column in document["tables"].get(f"arms_{k}", {"columns": []})["columns"]
    }
    rows = zip(*(columns.get(key, []) for key in ("force", "about", "arm_mm")), strict=True)
    return {f"h_{force}_{about}": mm for force, about, mm in rows}


KINDS: dict[str, tuple[str, Callable[[dict[str, Any], int], Numbers]]] = {
    "velocity polygon": ("μ_v", lambda document, k: segments(document, "v", k)),
    "acceleration polygon": ("μ_a", lambda document, k: segments(document, "a", k)),
    "force polygon": ("μ_F", sides),
    "loading scheme": ("μ_l", arms),
}


def longest(name: str, kind: str) -> Iterator[Measured]:
    """The three longest segments of a kind that figures of one position show."""
    scale, numbers = KINDS[kind]
    page, document, found = html(name), results(name), {}
    for anchor, caption, _ in figures(page, scale):
        k = position_of(caption)
        of = numbers(document, k) if k is not None else {}
        for vector in vectors(page.drawings[anchor]).shown if of else []:
            if vector.key in of and abs(of[vector.key]) > 5:
                found.setdefault((k, vector.key), (anchor, vector.key, vector.along, abs(of[vector.key])))
    yield from sorted(found.values(), key=lambda one: -one[3])[:3]


def off(measured: Measured) -> str:
    anchor, key, along, number = measured
    same = abs(abs(along) - number) <= MEASURED
    return "" if same else f"{anchor}: {key} is {abs(along):.3f} mm, its number {number:.3f} mm"


# --- in the file ---


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", LEVERS)
def test_three_segments_are_as_long_as_their_numbers(name, kind):
    wrong([text for text in map(off, longest(name, kind)) if text])


@pytest.mark.parametrize("name", CHOSEN)
def test_a_unit_of_every_drawing_is_a_millimetre(name):
    found = []
    for anchor, svg in html(name).drawings.items():
        root = fromstring(svg)
        wide, tall = root.get("viewBox", "0 0 0 0").split()[2:]
        if (root.get("width"), root.get("height")) != (f"{wide}mm", f"{tall}mm"):
            found.append(f"{anchor}: {root.get('width')} x {root.get('height')} for {wide} x {tall}")
    wrong(found)


def test_the_style_sheet_scales_no_drawing():
    """But on the largest sheet of paper, for what even that does not hold."""
    style = note(CHOSEN[0], "html")["note.html"].decode().partition("</style>")[0]
    rules = [rule.partition("{") for rule in style.split("}") if "svg" in rule]
    scaling = re.compile(r"(?:max-|min-)?(?:width|height)|zoom|transform")
    assert rules and not [rule for rule, _, says in rules if scaling.search(says) and ".a1" not in rule]


# --- on the paper ---


@cache
def expected(name: str) -> list[Measured]:
    return [one for kind in KINDS for one in longest(name, kind)]


def bars(name: str) -> list[Measured]:
    """The driving link on the schemes, and the links that hang on it."""
    document, found = results(name), []
    places = table_of(document, "positions_table")
    for anchor, caption, mu in figures(html(name), "μ_l"):
        k = position_of(caption)
        if k is None or found:
            continue
        at = {p: complex(places[f"x_{p}"][k], places[f"y_{p}"][k]) / mu for p in "ABCD"} | {"O": 0j}
        ends = [("OA", at["A"] - at["O"]), ("AB", at["B"] - at["A"]), ("CD", at["D"] - at["C"])]
        found = [(anchor, bar, along, abs(along)) for bar, along in ends]
    return found


def sideways(name: str) -> set[str]:
    """Figures that stand on their side on a page: turned by a quarter against the clock."""
    pages = note(name, "html")["note.html"].decode().split('<div class="sideways">')[1:]
    figures = (page.partition("</div></div>")[0] for page in pages)
    return {anchor for page in figures for anchor in re.findall(r'<figure id="([^"]+)"', page)}


def unprinted(pdf: bytes, name: str) -> list[str]:
    drawn = np.array(arrows(pdf))
    lines = np.array([stroke[1] - stroke[0] for stroke in strokes(pdf) if len(stroke) == 2])
    ways = dict.fromkeys(sideways(name), 1j)
    wanted = [(anchor, key, ways.get(anchor, 1) * along, size) for anchor, key, along, size in expected(name)]
    levels = [(anchor, key, ways.get(anchor, 1) * along, size) for anchor, key, along, size in bars(name)]
    missing = [one for one in wanted if abs(drawn - one[2]).min() > MEASURED]
    missing += [one for one in levels if min(abs(lines - one[2]).min(), abs(lines + one[2]).min()) > MEASURED]
    return [f"{anchor}: {key}, {number:.2f} mm, is not on the paper" for anchor, key, _, number in missing]


@pytest.mark.exhaustive
@pytest.mark.skipif("compressor" not in CHOSEN, reason="looks at another variant")
def test_the_browser_prints_them_at_their_length():
    wrong(unprinted(seen("compressor-ru").pdf, "compressor"))


@pytest.mark.exhaustive
@pytest.mark.skipif("compressor" not in CHOSEN, reason="looks at another variant")
def test_the_browser_prints_them_at_their_length_where_no_font_is_installed():
    wrong(unprinted(printed_without_fonts("compressor", "ru"), "compressor"))


def bar_of_a_hundred(pdf: bytes) -> list[float]:
    """Lengths of lines that may be the bar of the introduction: level, with an end mark of 4 mm at both ends."""
    lines = [stroke for stroke in strokes(pdf) if len(stroke) == 2]
    marks = [
        k for k, (a, b) in enumerate(lines) if abs(abs(b - a) - 4) < MEASURED and abs((b - a).real) < 0.01
    ]
    return [
        abs(lines[k - 1][1] - lines[k - 1][0])
        for k in marks
        if k
        and abs((lines[k - 1][1] - lines[k - 1][0]).imag) < 0.01
        and abs(lines[k - 1][0] - sum(lines[k]) / 2) < 0.1
    ]


@pytest.mark.exhaustive
@pytest.mark.skipif("compressor" not in CHOSEN, reason="looks at another variant")
@pytest.mark.parametrize(
    "printed",
    many(
        [
            lambda: seen("compressor-ru").pdf,
            lambda: printed_without_fonts("compressor", "ru"),
            lambda: typeset("compressor", "ru")[1],
            lambda: by_typst("compressor", "ru"),
        ]
    ),
    ids=["browser", "without fonts", "latex", "typst"],
)
def test_the_bar_is_a_hundred_millimetres_long(printed):
    assert any(abs(length - 100) <= MEASURED for length in bar_of_a_hundred(printed()))


def meshes(name: str) -> Iterator[tuple[str, complex]]:
    """Figure and the long straight lines of each picture of a mesh, as on paper; y is up there."""
    page = html(name)
    for figure in page.root.iter("figure"):
        anchor = figure.get("id") or ""
        if MESH.search(text_of(figure.find("figcaption"))):  # type: ignore[arg-type]
            nodes = fromstring(page.drawings[anchor]).iter(SVG + "path")
            paths = [node.get("d", "") for node in nodes if not node.get("stroke-dasharray")]
            ends = [tuple(map(float, found.groups())) for path in paths if (found := LINE.fullmatch(path))]
            lines = [complex(x2 - x1, y1 - y2) for x1, y1, x2, y2 in ends]
            yield from ((anchor, line) for line in lines if abs(line) > 30)


LINE = re.compile(r"M(-?[\d.]+) (-?[\d.]+)L(-?[\d.]+) (-?[\d.]+)")


@pytest.mark.exhaustive
@pytest.mark.skipif("compressor" not in CHOSEN, reason="looks at another variant")
def test_a_mesh_is_of_its_size_where_no_font_is_installed():
    pdf = printed_without_fonts("compressor", "ru")
    lines = np.array([stroke[1] - stroke[0] for stroke in strokes(pdf) if len(stroke) == 2])
    found: dict[str, int] = {}
    for anchor, line in meshes("compressor"):  # some are drawn as dashes, of which none is as long
        found[anchor] = found.get(anchor, 0) + bool(abs(lines - line).min() <= MEASURED)
    assert len(found) == 2 and sum(found.values()) >= 3, found


@pytest.mark.exhaustive
@pytest.mark.skipif("compressor" not in CHOSEN, reason="looks at another variant")
def test_latex_prints_them_at_their_length():
    wrong(unprinted(typeset("compressor", "ru")[1], "compressor"))


@pytest.mark.skipif("compressor" not in CHOSEN, reason="looks at another variant")
def test_typst_prints_them_at_their_length():
    wrong(unprinted(by_typst("compressor", "ru"), "compressor"))
