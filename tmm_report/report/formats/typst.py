"""The note as Typst reads it: one text with its pictures in it, from which the wheel `typst` makes a PDF.

A text is markup in which every sign that could begin a command stands behind a backslash, and no line begins with a
text: what is printed can neither be run nor break out, and names no file.
"""

from __future__ import annotations

import re
from dataclasses import field
from functools import cache, lru_cache

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing, svg
from tmm_report.i18n import Translator
from tmm_report.quantity.notations.typst import NEXT, notation, string
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import notation as other
from tmm_report.records import dataclass
from tmm_report.report.formats import Mathematics, drawing_of
from tmm_report.report.paper import measure
from tmm_report.report.paper.measure import breakable, known_letters
from tmm_report.report.paper.rows import GAP, Ready, Row
from tmm_report.report.paper.sheets import Sheet

BREAK = "\N{ZERO WIDTH SPACE}"


@dataclass
class Typst(Ready):
    """`files`: what stands beside the note: nothing."""

    name = "typst"
    files: dict[str, bytes] = field(default_factory=dict)

    def escape(self, text: str) -> Markup:
        return Markup(BREAK.join(map(typst_escape, breakable(text))))

    def marked(self, text: str, ref: Ref) -> Markup:
        return self.escape(text)

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        text = item.printed(notation(tr))
        if display:
            return Markup("".join(map(_piece, text.split(NEXT))))
        # how wide it is, for the tables: as in MathML, by whose metrics they are divided
        wide = measure.mathematics(item.printed(other("mathml", tr)).replace("<wbr/>", ""))
        first, *others = text.split(NEXT)
        # fractions are as large as in a line of their own, as in the other notes
        pieces = [f"$display({first.strip()})$", *(f'$display(""{piece.strip()})$' for piece in others)]
        return Markup(f"{''.join(pieces)}/*{wide:.3f}*/")

    def picture(self, picture: Drawing | Graph, anchor: str) -> Markup:
        size = self.percent(picture) / 100
        drawing = drawing_of(picture)
        wide, tall = drawing.size  # of what is drawn: Typst would enlarge it to another size, and cut it
        drawn = _printable(svg(drawing))
        sizes = f"{size * wide:.3f}mm, {size * tall:.3f}mm"
        return Markup(f"#note-picture({string(drawn)}, {string(_printable(drawing.title))}, {sizes});")

    def string(self, text: str) -> Markup:
        """Text of the document's properties."""
        return Markup(string(_printable(text)))

    def in_row(self, row: Row[Markup]) -> Markup:
        room = self.paper.width - row.wide
        widths = ", ".join(f"{one.wide + room / len(row.figures):.3f}mm" for one in row.figures)
        cells = "".join(f"[{one.figure}]" for one in row.figures)
        return Markup(f"#note-row(({widths}), {GAP:g}mm){cells};\n")

    def sideways(self, figures: Markup) -> Markup:
        size = f"{self.paper.height - 1:g}mm, {self.paper.width - 1:g}mm"
        return Markup(f"#note-sideways({size})[\n{figures}];\n")

    def sheet(self, sheet: Sheet, figures: Markup) -> Markup:
        margins = ", ".join(f"{one:g}mm" for one in sheet.margins)
        return Markup(f"#note-sheet({sheet.wide:g}mm, {sheet.tall:g}mm, ({margins}))[\n{figures}];\n")


# --- mathematics ---

_SIGN = re.compile("(?:[=+−≤≥≈≠→≪≫⩽⩾]|gt|lt) ?")
_PRODUCT = re.compile(r'"(?:[^"\\]|\\.)*"|\\.|[()]|(?P<cut>⋅)')


def _piece(text: str) -> str:
    """A piece of a displayed formula: its sign, and its factors, before which it may be cut where no line holds it."""
    sign = _SIGN.match(text)
    factors = [f"${factor.strip()}$.body," for factor in _factors(text)]
    begins = f"${sign[0].strip()}$.body" if sign else "none"
    relation = "true" if sign and sign[0].strip() not in "+−" else "false"
    return f"(sign: {begins}, relation: {relation}, factors: ({''.join(factors)})),"


def _factors(text: str) -> list[str]:
    """A piece cut before its products outside all brackets."""
    depth, start, cut = 0, 0, list[str]()
    for mark in _PRODUCT.finditer(text):
        if mark["cut"] is None:
            depth += {"(": 1, ")": -1}.get(mark[0], 0)
        elif depth == 0:
            cut.append(text[start : mark.start()])
            start = mark.start()
    return [*cut, text[start:]]


# --- text ---

_PLAIN = re.compile(r"[A-Za-z0-9 ,;:!?.()%&|^]")
_AS_THEY_ARE = frozenset({BREAK, "\N{NO-BREAK SPACE}", "\N{NARROW NO-BREAK SPACE}", "\N{WORD JOINER}"})


def typst_escape(text: str) -> str:
    """Text for Typst: what would be markup is escaped; a letter that none of the note's faces has becomes "?"."""
    return re.sub(r"\.(?=\.)", r"\\.", "".join(map(_sign, text)))


@lru_cache(maxsize=1024)
def _sign(sign: str) -> str:
    sign = _shown(sign)
    return sign if not sign.isascii() or _PLAIN.fullmatch(sign) else f"\\{sign}"


@cache
def _shown(sign: str) -> str:
    """A letter that some face has: no other may stand in a PDF/A."""
    if sign in "\n\t\r":
        return " "
    return sign if sign in known_letters() or sign in _AS_THEY_ARE else "?"


def _printable(text: str) -> str:
    return "".join(map(_shown, text))
