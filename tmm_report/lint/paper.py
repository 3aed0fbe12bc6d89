"""What does not fit its paper: tables, formulas and pictures over the margin, boxes that TeX found too wide."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import zip_longest
from xml.etree.ElementTree import Element, tostring

from tmm_report.lint.made import Made, line_at
from tmm_report.lint.page import Picture, heads, rows
from tmm_report.problems import N_, Message, Problem
from tmm_report.report.paper.layout import Column
from tmm_report.report.paper.measure import mathml

OVERFULL = 1.0  # pt: what stands out less is not seen
SPARE = 0.5  # mm, em


def over_margin(made: Made) -> Iterator[Problem]:
    """Tables, formulas and pictures that are wider than the page, by the metrics of the note's faces."""
    page = made.page
    if page is None:
        return
    paper = page.paper
    for anchor, table in page.tables:
        wide = sum(column.width(paper) for column in _columns(table))
        if wide > paper.width + SPARE:
            yield _wider(made, anchor, wide, paper.width)
    for anchor, formula in page.formulas:
        wide = max(_lines(formula), default=0.0)
        if wide > paper.line + SPARE:
            yield _wider(made, anchor, wide / paper.line * paper.width, paper.width)
    for picture in page.pictures:
        size = _size(picture)
        sheet = next((one for one in paper.sheets if one.name in picture.sheet.split()), None)
        alone = paper.fits(size) or (picture.sheet == "sideways" and paper.turns(size))
        held = alone if sheet is None else sheet.holds(size) or paper.percent(size) < 100
        if not held:
            yield _wider(made, picture.anchor, size[0], paper.width if sheet is None else sheet.field[0])


def _wider(made: Made, anchor: str, wide: float, room: float) -> Problem:
    name = made.page.name(anchor) if made.page else anchor
    wrong = Message(N_("%(what)s is over the margin: %(wide).0f mm"), {"what": name, "wide": wide})
    return made.found(
        "margin",
        "note.html",
        made.line(anchor),
        wrong,
        Message(N_("the page holds %(room).0f mm"), {"room": room}),
    )


def _columns(table: Element) -> Iterator[Column]:
    names = [_inside(node) for node in heads(table)]
    columns = zip_longest(*([_inside(node) for node in row] for row in rows(table)), fillvalue="")
    for head, cells in zip_longest(names, columns, fillvalue=""):
        yield Column(head, [*cells])


def _inside(node: Element) -> str:
    """The markup within an element, as `measure` takes it."""
    inner = "".join(tostring(child, encoding="unicode") for child in node)
    return (_escaped(node.text or "") + inner).replace(" />", "/>")


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")


def _lines(formula: Element) -> Iterator[float]:
    """Widths of the lines of a displayed formula, em of the text around."""
    for holder in formula.iter():
        if not any(child.tag == "math" for child in holder):
            continue
        share = re.search(r"font-size:(\d{1,3})%", holder.get("style") or "")
        size, wide = int(share[1]) / 100 if share else 1.0, 0.0
        for child in holder:
            if child.tag == "br":
                yield wide * size
                wide = 0.0
            elif child.tag == "math" and child.get("class") != "again":
                wide += mathml(child)
        yield wide * size


def _size(picture: Picture) -> tuple[float, float]:
    """Width and height, mm."""
    wide, tall = (
        re.fullmatch(r"(\d{1,5}(?:\.\d+)?)mm", picture.svg.get(name) or "") for name in ("width", "height")
    )
    return (float(wide[1]), float(tall[1])) if wide and tall else (0.0, 0.0)


def overfull(made: Made) -> Iterator[Problem]:
    """What TeX says stands out of its line or its page."""
    log = made.log or ""
    for one in _OVERFULL.finditer(log):
        if float(one["points"]) > OVERFULL:
            wrong = Message(N_("a box is %(points)s pt too large (%(where)s)"), one.groupdict())
            yield made.found("margin", "note.log", line_at(log, one.start()), wrong)


_OVERFULL = re.compile(
    r"Overfull \\[hv]box \((?P<points>\d{1,6}(?:\.\d+)?)pt too \w+\) ?(?P<where>[^\n]{0,60})"
)
