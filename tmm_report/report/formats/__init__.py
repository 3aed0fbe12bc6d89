"""The formats of the note: how text is escaped, how mathematics and pictures get in.

Whatever is not Markup is escaped for its format, so that a name from a variant can break out of none.
A format that few notes have is a room of its own, which is read when it is asked for.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import field
from functools import lru_cache
from html import unescape
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import FONTS, Drawing, svg, tikz
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.ref import Ref, attributes
from tmm_report.quantity.symbols import GREEK, Notation, latex_escape, xml_escape
from tmm_report.records import dataclass
from tmm_report.report.paper.layout import Cell, Words
from tmm_report.report.paper.lines import broken, finer, pieces
from tmm_report.report.paper.measure import breakable
from tmm_report.report.paper.rows import Ready, Row, Waiting
from tmm_report.report.paper.sheets import Sheet


class Mathematics(Protocol):
    """A Formula, VectorEquation, Inline or Symbol."""

    def latex(self, tr: Translator) -> str: ...

    def mathml(self, tr: Translator) -> str: ...

    def printed(self, form: Notation) -> str: ...


@dataclass
class Html(Ready):
    """One self-contained file: pictures stand in it as svg.

    `breaking`: whether a line may break within words longer than any of a language, as in a note; `pictures`: those of
    its figures, by their anchors; `defined`: the numbers that its formulas work out.
    """

    name = "html"
    breaking: bool = False
    files: dict[str, bytes] = field(default_factory=dict)
    pictures: dict[str, Drawing | Graph] = field(default_factory=dict)
    defined: list[Ref] = field(default_factory=list)

    def escape(self, text: str) -> Markup:
        return _escaped(text, self.breaking)

    def marked(self, text: str, ref: Ref) -> Markup:
        """A number in running text that says where it stands in the results."""
        return Markup(f"<span{attributes(ref)}>{xml_escape(text)}</span>")

    def cells(self, row: Iterable[Any]) -> Markup:
        """A row's cells; those that are numbers or words of the results say so by attributes of their elements."""
        return Markup("".join([f"<td{_data(cell)}>{self._text(cell)}</td>" for cell in row]))

    def _text(self, cell: Any) -> Markup:
        return cell if isinstance(cell, Markup) else self.escape(str(cell))

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        if isinstance(item, Formula) and item.ref is not None and item.numbers:
            self.defined.append(item.ref)
        text, share = broken(item.mathml(tr), self.paper.line) if display else (item.mathml(tr), 1.0)
        return Markup(text if share == 1 else f'<span style="font-size:{100 * share:.0f}%">{text}</span>')

    def picture(self, picture: Drawing | Graph, anchor: str, caption: object = "") -> Markup:
        """Its name, read aloud to who cannot see it, is its own title, else what its caption says before the scales;
        its letters are those of the page."""
        self.pictures[anchor] = picture
        drawing = svg(drawing_of(picture), title=_words(str(caption)))
        return Markup(drawing.replace(_LETTERS, "", 1).replace('"#000000"', '"#000"'))

    def in_row(self, row: Row[Markup]) -> Markup:
        beside = [f'<div style="flex:1 1 {one.wide:.1f}mm">{one.figure}</div>' for one in row.figures]
        return Markup(f'<div class="row">\n{"".join(beside)}</div>\n')

    def sideways(self, figures: Markup) -> Markup:
        return Markup(f'<div class="sideways"><div>\n{figures}</div></div>\n')

    def sheet(self, sheet: Sheet, figures: Markup) -> Markup:
        return Markup(f'<div class="sheet {sheet.name}">\n{figures}</div>\n')


def _words(caption: str) -> str:
    """What a caption says in plain text, without mathematics and what follows it."""
    plain = unescape(re.sub("<[^>]*>", "", caption.partition("<math")[0]))
    return plain.rstrip(" ,;:–—\N{NO-BREAK SPACE}\N{WORD JOINER}")


@lru_cache(maxsize=4096)
def _escaped(text: str, breaking: bool) -> Markup:
    """Kept, for a note says most of its words many times."""
    return Markup(_BREAK_HTML.join(map(xml_escape, breakable(text))) if breaking else xml_escape(text))


def _data(cell: Any) -> str:
    return attributes(cell.ref) if isinstance(cell, Cell | Words) else ""


TexFigure: TypeAlias = tuple[str, Markup, Markup]
"""Anchor, caption and drawing."""


@dataclass
class Tex(Waiting[TexFigure]):
    """`files`: the figures that note.tex reads, by their names beside it."""

    name = "tex"
    files: dict[str, bytes] = field(default_factory=dict)

    def escape(self, text: str) -> Markup:
        return Markup(_BREAK_TEX.join(map(tex_escape, breakable(text))))

    def marked(self, text: str, ref: Ref) -> Markup:
        return self.escape(text)

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        text = item.latex(tr)
        line = self.paper.line
        return Markup("".join(_displayed(one, line) for one in pieces(text)) if display else f"${text}$")

    def alone(self, figure: TexFigure) -> Markup:
        return _tex_figure("NoteFigure", figure)

    def drawn(self, figure: TexFigure) -> Markup:
        return _tex_figure("NoteDrawing", figure)

    def in_row(self, row: Row[TexFigure]) -> Markup:
        """What is left of the width of the text is shared among the figures."""
        more = (self.paper.width - row.wide) / len(row.figures)
        beside = list[str]()
        for one in row.figures:
            anchor, caption, drawn = one.figure
            head = f"{{{one.wide + more:.1f}mm}}{{{anchor}}}{{{caption}}}"
            beside.append(f"\\begin{{NoteInRow}}{head}\n{drawn}%\n\\end{{NoteInRow}}%\n")
        return Markup("\\begin{NoteRow}\n" + "\\hfill\n".join(beside) + "\\end{NoteRow}\n\n")

    def sideways(self, figures: Markup) -> Markup:
        return Markup(f"\\begin{{NoteSideways}}\n{figures}\\end{{NoteSideways}}\n\n")

    def sheet(self, sheet: Sheet, figures: Markup) -> Markup:
        """With width and height of the paper and of what is printed on it, margins to the left and above."""
        sizes = "".join(f"{{{size:g}mm}}" for size in (sheet.wide, sheet.tall, *sheet.field, *sheet.corner))
        return Markup(f"\\begin{{NoteSheet}}{sizes}\n{figures}\\end{{NoteSheet}}\n\n")

    def picture(self, picture: Drawing | Graph, anchor: str) -> Markup:
        name = f"figures/{anchor}.tex"
        self.files[name] = tikz(drawing_of(picture)).encode()
        command = f"\\input{{{name}}}"
        size = self.percent(picture) / 100
        return Markup(f"\\scalebox{{{size}}}{{{command}}}" if size < 1 else command)


def _tex_figure(kind: str, figure: TexFigure) -> Markup:
    anchor, caption, drawn = figure
    return Markup(f"\\begin{{{kind}}}{{{anchor}}}{{{caption}}}\n\n{drawn}%\n\\end{{{kind}}}\n\n")


def _displayed(piece: str, line: float) -> str:
    """A piece of a formula for TeX to break before: where it is too long, at its products, too."""
    first, *others = finer(piece, line)
    factors = [f"\\NoteTimes{{{other.removeprefix(_DOT)}}}" for other in others]
    return "".join([f"\\NotePiece{{{first}}}", *factors])


_DOT = "\\cdot "


class Png(Tex):
    """The figures alone, each a picture: the text, by which they are numbered, is left out."""

    def picture(self, picture: Drawing | Graph, anchor: str) -> Markup:
        from tmm_report.figures.raster import png

        self.files[f"figures/{anchor}.png"] = png(drawing_of(picture))
        return Markup("")


if TYPE_CHECKING:
    from tmm_report.report.formats.docx import Docx
    from tmm_report.report.formats.typst import Typst

Format: TypeAlias = "Html | Tex | Typst | Docx"


def drawing_of(picture: Drawing | Graph) -> Drawing:
    return picture if isinstance(picture, Drawing) else picture.drawing


_LETTERS = f' font-family="{FONTS}"'

# --- long words ---

_BREAK_HTML, _BREAK_TEX = "<wbr/>", "\\allowbreak{}"

# --- text of LaTeX ---

_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
_RAISED = dict(zip("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789", strict=True))
_GREEK_MACRO = {letter: f"$\\{name}$" for name, letter in GREEK.items() if letter != "ο"}
_TEX_SIGNS = {
    "−": "$-$", "·": "$\\cdot$", "°": "$^{\\circ}$", "→": "$\\to$", "×": "$\\times$", "≤": "$\\leqslant$",
    "≥": "$\\geqslant$", "±": "$\\pm$", "≈": "$\\approx$", "∥": "$\\parallel$", "⟂": "$\\perp$", "≠": "$\\neq$",
    "\N{NO-BREAK SPACE}": "~", "\N{NARROW NO-BREAK SPACE}": "\\,", "‖": "$\\parallel$", "∞": "$\\infty$",
    "′": "$'$", "″": "$''$", "↻": "$\\circlearrowright$", "↺": "$\\circlearrowleft$",
    "\n": " ", "\t": " ", "’": "'", "φ": "$\\varphi$", "ε": "$\\varepsilon$",
}  # fmt: skip
_SIGNS = _GREEK_MACRO | _TEX_SIGNS
_KNOWN = re.compile("([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+|[₀₁₂₃₄₅₆₇₈₉]+|[" + re.escape("".join(_SIGNS)) + "])")


def tex_escape(text: str) -> str:
    """Text for pdflatex: the signs of mathematics go to math mode, the rest as `symbols.latex_escape` says."""
    return "".join(_tex_sign(run) if i % 2 else latex_escape(run) for i, run in enumerate(_KNOWN.split(text)))


def _tex_sign(run: str) -> str:
    if run in _SIGNS:
        return _SIGNS[run]
    mark, digits = ("_", _LOWERED) if run[0] in _LOWERED else ("^", _RAISED)
    return f"${mark}{{{''.join(digits[sign] for sign in run)}}}$"
