"""The note for word processors: WordprocessingML with formulas that can be edited, pictures as metafiles.

What the macros write is finished by `report.word`: text without a run about it gets one, numbers and references
become fields, and the parts are packed. Whatever is not Markup is escaped for XML, and what fields say is made of
our own anchors alone, so that a student's text is text. Source: ECMA-376, part 1.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import field
from typing import NamedTuple

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import NORMAL, Drawing, line
from tmm_report.figures.emf import emf
from tmm_report.i18n import Translator
from tmm_report.profiles import A4
from tmm_report.quantity.notations.omml import notation
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import xml_escape
from tmm_report.records import dataclass
from tmm_report.report.formats import Mathematics, drawing_of
from tmm_report.report.numbering import Place
from tmm_report.report.paper.measure import breakable
from tmm_report.report.paper.office_math import broken, in_line, wide
from tmm_report.report.paper.rows import GAP, Ready, Row
from tmm_report.report.paper.sheets import POINT, Sheet

BREAK = "\N{ZERO WIDTH SPACE}"
EMU = 36_000  # a millimetre
TWIPS = 1440 / 25.4  # a millimetre
NUMBER = 3.6  # sizes of letters: of the number of a formula in an appendix, (A.10)
MEDIA = "word/media"


class Image(NamedTuple):
    """A picture in the text: its number and file, what is read aloud of it, width and height in EMU."""

    number: int
    file: str
    title: str
    wide: int
    tall: int


class Field(NamedTuple):
    """A piece of a number: what the word processor reckons it by, "" of what stands as it is, and what it says."""

    command: str
    text: str


@dataclass
class Docx(Ready):
    """`files`: pictures, by their places in the file; `counts`: of headings, as a word processor counts them."""

    name = "docx"
    most = 22 * 25.4  # Word takes no larger paper: MS-OI29500, 17.6.13
    files: dict[str, bytes] = field(default_factory=dict)
    images: list[Image] = field(default_factory=list)
    counts: list[int] = field(default_factory=list)

    def escape(self, text: str) -> Markup:
        return Markup(BREAK.join(map(_text, breakable(text))))

    def marked(self, text: str, ref: Ref) -> Markup:
        return self.escape(text)

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        text = item.printed(notation(tr))
        return Markup(f"{in_line(text)}<!--{wide(text):.3f}-->")  # how wide it is, for the tables

    def lines(self, item: Mathematics, tr: Translator) -> list[Markup]:
        """A displayed formula, as many lines as it takes beside its number."""
        return list(map(Markup, broken(item.printed(notation(tr)), self.line)))

    # ------------------------------------------------------------ numbers

    def counted(self, place: Place, level: int) -> bool:
        """Whether a word processor that counts the headings comes to the number of this one, too; else it is text."""
        counts = [*self.counts, 0, 0, 0][:level]
        counts[-1] += 1
        if place.number != ".".join(map(str, counts)):
            return False
        self.counts = counts
        return True

    def number(self, kind: str, place: Place) -> list[Field]:
        """A number of a figure, table or formula: counted through the note, or in the section whose number it has."""
        before, _, last = place.number.rpartition(".")
        own = re.search("-(appendix[0-9]+|drawings)", place.anchor)
        if not before:
            return [Field(f"SEQ {kind} \\* ARABIC", last)]
        if own:
            return [Field("", before + "."), Field(f"SEQ {kind}_{own[1]} \\* ARABIC", last)]
        if self.counts[:1] != [int(before)]:
            return [Field("", place.number)]
        # LibreOffice knows no counting by headings: the first of a section says so
        again = " \\r 1" if last == "1" else ""
        return [
            Field("STYLEREF 1 \\s", before),
            Field("", "."),
            Field(f"SEQ {kind} \\* ARABIC \\s 1{again}", last),
        ]

    # ------------------------------------------------------------ pictures

    def image(self, picture: Drawing | Graph, name: str, caption: object = "") -> Image:
        """A picture of its own size, or of that to which its sheet reduces it, for the macros to put into the text."""
        share = self.percent(picture) / 100
        drawing = drawing_of(picture)
        said = drawing.title or " ".join(Markup(caption).striptags().split())
        wide, tall = (round(EMU * share * side) for side in drawing.size)
        found = Image(len(self.images) + 1, bookmark(name).strip("_") + ".emf", _text(said), wide, tall)
        self.images.append(found)
        self.files[f"{MEDIA}/{found.file}"] = emf(drawing)
        return found

    def bar(self) -> Image:
        """A length that shows whether the note was printed at its own size: 100 mm."""
        marks = [line(x - 1j * half, x + 1j * half, NORMAL) for x, half in ((0, 2), (50, 1), (100, 2))]
        return self.image(Drawing((line(0j, 100 + 0j, NORMAL), *marks), "100 mm"), "bar")

    def in_row(self, row: Row[Markup]) -> Markup:
        room = self.paper.width - row.wide
        widths = [
            twips(one.wide + GAP * (k > 0) + room / len(row.figures)) for k, one in enumerate(row.figures)
        ]
        cells = "".join(f"<n:cell>{one.figure}</n:cell>" for one in row.figures)
        return Markup(
            f'<n:grid widths="{" ".join(map(str, widths))}" align="bottom"><n:row>{cells}</n:row></n:grid>'
        )

    def sideways(self, figures: Markup) -> Markup:
        """A word processor turns no picture with its caption: it lays the page on its side, with its binding above."""
        one = self.paper.margins
        return _of_own(figures, A4[::-1], (one.left, one.top, one.right, one.bottom))

    def sheet(self, sheet: Sheet, figures: Markup) -> Markup:
        return _of_own(figures, (sheet.wide, sheet.tall), sheet.margins)

    # ------------------------------------------------------------ sizes

    @property
    def line(self) -> float:
        """What a line of formulas holds beside its number, in sizes of its letters."""
        return self.formula[1] / TWIPS / (self.paper.text.size * POINT)

    @property
    def formula(self) -> tuple[int, int, int]:
        """Widths of what a numbered formula stands in: as wide on both sides as its number, twips."""
        aside = twips(NUMBER * self.paper.text.size * POINT)
        return aside, twips(self.paper.width) - 2 * aside, aside

    def widths(self, shares: Sequence[float]) -> list[int]:
        """Of the columns of a table, twips."""
        return [twips(share * self.paper.width) for share in shares]

    def beside(self, items: Sequence[Mathematics], tr: Translator) -> list[list[list[Markup]]]:
        """Formulas side by side, as many as a line holds: rows of them, each with its lines."""
        most = max(1, int(self.line // (self._widest(items, tr) + 2)))
        many = -(-len(items) // -(-len(items) // most)) if items else 1
        shown = [self.lines(item, tr) for item in items]
        return [shown[k : k + many] for k in range(0, len(shown), many)]

    def _widest(self, items: Sequence[Mathematics], tr: Translator) -> float:
        return max((wide(item.printed(notation(tr))) for item in items), default=0.0)

    @staticmethod
    def mm(length: float) -> int:
        return twips(length)

    @staticmethod
    def half_points(size: float) -> int:
        """Size of letters; in points."""
        return round(2 * size)


def _of_own(figures: Markup, size: tuple[float, float], margins: Iterable[float]) -> Markup:
    """Figures on a page of their own; its width and height, and its margins above, right, below and left, mm."""
    around = " ".join(map(str, map(twips, margins)))
    sizes = f'wide="{twips(size[0])}" tall="{twips(size[1])}" margins="{around}"'
    return Markup(f'<n:end kind="text"/>{figures}<n:end kind="sheet" {sizes}/>')


def twips(length: float) -> int:
    """Of millimetres."""
    return round(TWIPS * length)


def bookmark(anchor: str) -> str:
    """The name of a bookmark, hidden from lists: of letters, digits and low lines, 40 at most."""
    return re.sub(r"\W", "_", f"_{anchor}")[:40]


def _text(text: str) -> str:
    return xml_escape(re.sub(r"[\n\t\r]", " ", text))
