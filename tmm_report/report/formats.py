"""The two formats of the note: how text is escaped, how mathematics and pictures get in.

Whatever is not Markup is escaped for its format, so that a name from a variant can break out of neither.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any, Protocol
from xml.etree.ElementTree import Element, fromstring

from markupsafe import Markup

from tmm_report.figures.drawing import Drawing, svg, tikz
from tmm_report.figures.graphs import Graph
from tmm_report.i18n import Translator
from tmm_report.quantity.ref import Ref, attributes, without_attributes
from tmm_report.quantity.symbols import GREEK, latex_escape, xml_escape
from tmm_report.report.layout import Cell, Words


class Mathematics(Protocol):
    """A Formula, VectorEquation, Inline or Symbol."""

    def latex(self, tr: Translator) -> str: ...

    def mathml(self, tr: Translator) -> str: ...


PAGE = (165.0, 228.0)  # mm: the largest picture


def percent(picture: Drawing | Graph) -> int:
    """To how many per cent of its size a picture is reduced to fit the page; 100: not at all."""
    wide, tall = picture.size
    if turned(picture):
        wide, tall = tall, wide
    return min(100, int(100 * min(PAGE[0] / wide, PAGE[1] / tall)))


def turned(picture: Drawing | Graph) -> bool:
    """Whether a drawing too wide for the page stands on its side in it, so that it keeps its scale or more of it."""
    wide, tall = picture.size
    upright, aside = min(PAGE[0] / wide, PAGE[1] / tall), min(PAGE[0] / tall, PAGE[1] / wide)
    return isinstance(picture, Drawing) and upright < 1 and aside > upright


@dataclass
class Html:
    """One self-contained file: pictures stand in it as svg."""

    name = "html"
    files: dict[str, bytes] = field(default_factory=dict)

    def escape(self, text: str) -> Markup:
        return Markup(xml_escape(text))

    def marked(self, text: str, ref: Ref) -> Markup:
        """A number in running text that says where it stands in the results."""
        return Markup(f"<span{attributes(ref)}>{xml_escape(text)}</span>")

    def data(self, cell: Any) -> Markup:
        """The same of a table's cell, as attributes of its element."""
        return Markup(attributes(cell.ref) if isinstance(cell, Cell | Words) else "")

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        text = item.mathml(tr)
        size = LINE / max(LINE, widest(text)) if display else 1.0
        return Markup(text if size == 1 else f'<span style="font-size:{100 * size:.0f}%">{text}</span>')

    def picture(self, picture: Drawing | Graph, anchor: str) -> Markup:
        # the style sheet reduces what is larger than the page
        return Markup(svg(picture, turned(picture)) if isinstance(picture, Drawing) else picture.svg())


@dataclass
class Tex:
    """`files`: the figures that note.tex reads, by their names beside it."""

    name = "tex"
    files: dict[str, bytes] = field(default_factory=dict)

    def escape(self, text: str) -> Markup:
        return Markup(tex_escape(text))

    def marked(self, text: str, ref: Ref) -> Markup:
        return self.escape(text)

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        text = item.latex(tr)
        return Markup(
            "".join(f"\\NotePiece{{{piece}}}" for piece in pieces(text)) if display else f"${text}$"
        )

    def picture(self, picture: Drawing | Graph, anchor: str) -> Markup:
        drawn = isinstance(picture, Drawing)
        name = f"figures/{anchor}.{'tex' if drawn else 'pdf'}"
        self.files[name] = tikz(picture).encode() if isinstance(picture, Drawing) else picture.pdf()
        command = f"\\{'input' if drawn else 'includegraphics'}{{{name}}}"
        command = f"\\rotatebox{{90}}{{{command}}}" if turned(picture) else command
        size = percent(picture) / 100
        return Markup(f"\\scalebox{{{size}}}{{{command}}}" if size < 1 else command)


Format = Html | Tex


# --- lines of formulas ---

LINE = 34.0  # em: what a line of formulas holds
_LONG = 800  # characters of MathML below which no formula is too wide


def widest(text: str) -> float:
    """Estimated width of the widest of neighbouring `math` elements, em: each stays on one line."""
    if len(text) < _LONG or len(text := without_attributes(text)) < _LONG:
        return 0.0
    return max(map(_width, fromstring(f"<p>{text}</p>")), default=0.0)


def _width(node: Element) -> float:
    widths = [_width(child) for child in node]
    if node.tag == "mfrac":
        return max(widths)
    if node.tag in ("msub", "msup", "msubsup"):
        return widths[0] + 0.7 * max(widths[1:])
    signs = len(node.text or "") * 0.47
    return sum(widths) + signs + (0.5 if node.get("form") == "infix" else 0.0)


def pieces(latex: str) -> list[str]:
    """A formula cut before its relations and signs outside all braces and brackets: a line may break there."""
    found, depth, start = [], 0, 0
    for mark in _CUTS.finditer(latex):
        if mark[0] == " ":
            if depth == 0:
                found.append(latex[start : mark.start()])
                start = mark.end()
        else:
            depth += 1 if mark[0] in ("{", "\\left") else -1
    return [*found, latex[start:]]


_CUTS = re.compile(r"\\left(?![a-z])|\\right(?![a-z])|(?<!\\)[{}]| (?=[=+-])")

_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
_RAISED = dict(zip("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789", strict=True))
_GREEK_MACRO = {letter: f"$\\{name}$" for name, letter in GREEK.items() if letter != "ο"}
_TEX_SIGNS = {
    "−": "$-$", "·": "$\\cdot$", "°": "$^{\\circ}$", "→": "$\\to$", "×": "$\\times$", "≤": "$\\leqslant$",
    "≥": "$\\geqslant$", "±": "$\\pm$", "≈": "$\\approx$", "∥": "$\\parallel$", "⟂": "$\\perp$", "≠": "$\\neq$",
    "\N{NO-BREAK SPACE}": "~", "\N{NARROW NO-BREAK SPACE}": "\\,", "‖": "$\\parallel$", "∞": "$\\infty$",
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
