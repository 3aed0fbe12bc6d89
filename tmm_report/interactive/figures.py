"""The figures of a note, one by one: as a notebook shows them, or as files."""

from __future__ import annotations

import os
import re
from dataclasses import replace
from pathlib import Path

from markupsafe import Markup

from tmm_report import note
from tmm_report.course import Results
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing, svg
from tmm_report.i18n import Translator
from tmm_report.records import dataclass
from tmm_report.report import render
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering, Place
from tmm_report.report.page import Page
from tmm_report.report.part import Part


@dataclass(frozen=True, eq=False)
class Figure:
    """A figure of the note: `name`, `number` there, `caption`; a notebook shows it. In millimetres of paper."""

    name: str
    number: str
    caption: str
    picture: Drawing | Graph

    @property
    def svg(self) -> str:
        drawing = self.picture if isinstance(self.picture, Drawing) else self.picture.drawing
        return svg(drawing, title=self.caption)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write it as SVG, or as PNG by the end of the name."""
        drawing = self.picture if isinstance(self.picture, Drawing) else self.picture.drawing
        if str(path).lower().endswith(".png"):
            from tmm_report.figures.raster import png

            Path(path).write_bytes(png(drawing))
        else:
            Path(path).write_text(self.svg, encoding="utf-8")

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Figure {self.name!r}: {self.caption}>"


def gathered(results: Results, tr: Translator) -> list[Figure]:
    """All figures of the note of full depth, in its order."""
    found: list[Figure] = []
    numbering = _Named()

    def parts(page: Page) -> list[Part]:
        page.numbering = numbering
        page.form = _Gathering(numbering, found)
        return list(note.parts(results, page))

    render(parts, results.variant.title, "html", tr)
    known = numbering.resolved  # the letter of the last appendix is known in the end
    return [replace(one, number=known(one.number), caption=known(one.caption)) for one in found]


class _Named(Numbering):
    """A numbering that knows the label and number of the last figure."""

    label, number = "", ""

    def take(self, kind: str, label: str = "") -> Place:
        place = super().take(kind, label)
        if kind == "figure":
            self.label, self.number = label, place.number
        return place


class _Gathering(Html):
    """HTML that keeps the pictures."""

    def __init__(self, numbering: _Named, found: list[Figure]):
        super().__init__()
        self.numbering, self.found = numbering, found

    def picture(self, picture: Drawing | Graph, anchor: str, caption: object = "") -> Markup:
        return Markup("")

    def placed(self, figure: Markup, picture: Drawing | Graph) -> Markup:
        said = re.search(r"<figcaption>(.*?)</figcaption>", figure, re.S)
        caption = Page.plain(Markup(said[1])) if said else ""
        name = self.numbering.label.removeprefix("fig:") or f"figure{self.numbering.number}"
        self.found.append(Figure(name, self.numbering.number, " ".join(caption.split()), picture))
        return Markup("")
