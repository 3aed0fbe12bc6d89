"""Lettering of drawings: mathematical symbols and plain words, measured, and written as SVG and as TeX.

Nothing a user typed reaches SVG or TeX unescaped: `xml_text` and `tex_text` are the only ways through.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from html import escape
from itertools import groupby
from typing import overload

from tmm_report.quantity import symbols
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Symbol:
    """A mathematical symbol. `italic=False` sets an upright base; `bar` marks a vector."""

    base: str
    sub: str = ""
    sup: str = ""
    italic: bool = True
    bar: bool = False


Part = Symbol | str  # a plain str is set upright
Parts = tuple[Part, ...]


class Label(tuple[Part, ...]):
    """Parts that name an axis and know of what and in what unit they are: so the axis can tell its scale."""

    of: symbols.Symbol
    unit: str

    @classmethod
    def made(cls, parts: Parts, of: symbols.Symbol, unit: str) -> Label:
        label = cls(parts)
        label.of, label.unit = of, unit
        return label


@dataclass(frozen=True)
class Scale:
    """What a millimetre along an axis of a quantity stands for: `value` <unit>/mm."""

    of: symbols.Symbol
    value: float
    unit: str


def scales_along(axes: Sequence[tuple[Parts, float]]) -> tuple[Scale, ...]:
    """Of the axes whose labels know what they are, by what 1 mm along each stands for."""
    return tuple(Scale(name.of, value, name.unit) for name, value in axes if isinstance(name, Label))


SMALL = 0.72  # height of an index against its base
DROP, RAISE = 0.22, 0.36  # how far an index stands below and above, in sizes of the base


def symbol(text: str, bar: bool = False) -> Symbol:
    """A Symbol from its usual writing: "p", "v_BA", "R_12^t", "a_BA_n", "S2" (digits become the index)."""
    if match := re.fullmatch(r"([^\d_^]+)(\d+)", text):
        return Symbol(match[1], match[2], bar=bar)
    return _marked(text, bar)


@overload
def lettered(quantity: symbols.Symbol, words: Callable[[str], str] = str) -> Symbol: ...
@overload
def lettered(quantity: None, words: Callable[[str], str] = str) -> None: ...
@overload
def lettered(quantity: symbols.Symbol | None, words: Callable[[str], str] = str) -> Symbol | None: ...
def lettered(quantity: symbols.Symbol | None, words: Callable[[str], str] = str) -> Symbol | None:
    """The symbol of a quantity as it is drawn; `words` translates those of its indices."""
    if quantity is None:
        return None
    base = "".join(symbols.index_runs(quantity.base, base=True))
    sub, sup = (_worded(text, words) for text in (quantity.sub, quantity.sup))
    return Symbol(base, sub, sup, bar=quantity.bar)


def _worded(index: str, words: Callable[[str], str]) -> str:
    """An index with its words translated; letters and numbers stay."""
    return "".join(words(run) if _is_word(run) else run for run in symbols.index_runs(index))


def _is_word(run: str) -> bool:
    return len(run) > 1 and run.isascii() and run.islower()


def _marked(text: str, bar: bool) -> Symbol:
    """A lower index after the first "_", an upper one after "^" or the second "_"."""
    base, *rest = re.split(r"([_^])", text, maxsplit=2)
    if not base:
        return Symbol(text, bar=bar)
    indices = {"_": "", "^": ""}
    for mark, index in zip(rest[::2], rest[1::2], strict=True):
        indices["^" if indices[mark] else mark] = index
    return Symbol(base, indices["_"], indices["^"], bar=bar)


def joined(symbols: Sequence[Part], between: str = ", ") -> Parts:
    """Several symbols as one text: b, p."""
    parts: list[Part] = []
    for one in symbols:
        parts += [between, one] if parts else [one]
    return tuple(parts)


# Widths, in sizes, after DejaVu Serif, the widest of the fonts: a label is never wider than estimated.
_NARROW, _WIDE = frozenset("iljftrI1.,;:'|!()[] ·′"), frozenset("mwMWОЖШЩЮФМЫжшщюфмыω%@—=+−→")


def _char_width(char: str) -> float:
    if char in _NARROW:
        return 0.42 if char != " " else 0.33
    if char in _WIDE:
        return 0.95
    return 0.76 if char.isupper() else 0.64


def _run_width(text: str) -> float:
    return sum(map(_char_width, text))


@lru_cache(maxsize=4096)
def width(parts: Parts, size: float) -> float:
    """Estimated width of a text `size` mm high, mm."""
    return size * sum(_run_width(part) if isinstance(part, str) else _symbol_width(part) for part in parts)


def _symbol_width(symbol: Symbol) -> float:
    return _run_width(symbol.base) + SMALL * max(_run_width(symbol.sub), _run_width(symbol.sup))


# --- which letters lean ---

_UPRIGHT = re.compile("[Ѐ-ӿΑ-Ω]")  # Cyrillic and Greek capitals, as TeX sets them


def leans(symbol: Symbol) -> bool:
    """Whether the base of a symbol is italic."""
    return symbol.italic and not _UPRIGHT.search(symbol.base)


def leaning_runs(index: str) -> Iterator[tuple[str, bool]]:
    """The runs of an index as formulas set them, and whether each is italic: letters are; words, numbers, signs and
    Cyrillic stand upright."""
    for leaning, runs in groupby(symbols.index_runs(index), key=_leans):
        yield "".join(runs), leaning


def _leans(run: str) -> bool:
    return run.isalpha() and not _is_word(run) and not _UPRIGHT.search(run)


# --- SVG ---

_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def xml_text(text: str) -> str:
    """Text escaped for XML; characters that XML cannot hold are replaced."""
    return escape(_NOT_XML.sub("\ufffd", text))


@lru_cache(maxsize=4096)
def svg_parts(parts: Parts, size: float) -> str:
    """The inside of an SVG `text` element `size` mm high; tspans move by dy and back after each index."""
    if all(isinstance(part, str) for part in parts):
        return xml_text("".join(map(str, parts)))
    out, back, skip = [], 0.0, 0.0
    for part in parts:
        for text, mark, rise, dx, small in _runs(part):
            out.append(
                _tspan(text, mark, size * (back - rise), size * (dx + skip), SMALL * size if small else None)
            )
            back, skip = rise, 0.0
        skip = _ahead(part)
    return "".join(out)


def _runs(part: Part) -> Iterator[tuple[str, str, float, float, bool]]:
    """(text, attributes, rise, shift to the right, small) of each stretch of one lettering."""
    if isinstance(part, str):
        yield part, "", 0.0, 0.0, False
        return
    bar = ' text-decoration="overline"' if part.bar else ""
    yield part.base, _ITALIC[leans(part)] + bar, 0.0, 0.0, False
    for text, leaning in leaning_runs(part.sub):
        yield text, _ITALIC[leaning], -DROP, 0.0, True
    shift = -_step_back(part)
    for text, leaning in leaning_runs(part.sup):
        yield text, _ITALIC[leaning], RAISE, shift, True
        shift = 0.0


def _step_back(symbol: Symbol) -> float:
    """How far an upper index steps back to stand over the lower one: short of its estimated width, for
    fonts are narrower than the estimate and must not run into the base."""
    return 0.75 * SMALL * _run_width(symbol.sub) if symbol.sup else 0.0


def _ahead(part: Part) -> float:
    """What is left to go to the right end of a symbol whose upper index is the shorter, in a narrow font."""
    if isinstance(part, str):
        return 0.0
    return max(0.0, _step_back(part) - 0.65 * SMALL * _run_width(part.sup)) if part.sup else 0.0


_ITALIC = {True: ' font-style="italic"', False: ""}


def _tspan(text: str, mark: str, dy: float, dx: float, size: float | None) -> str:
    """`size`: where it is another than that of the whole text, mm."""
    move = (f' dy="{dy:.3g}"' if dy else "") + (f' dx="{dx:.3g}"' if dx else "")
    look = "" if size is None else f' font-size="{size:.3g}"'
    return f"<tspan{mark}{move}{look}>{xml_text(text)}</tspan>"


# --- TeX ---

_GREEK_NAMES = """alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau
upsilon varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega phi vartheta"""
_GREEK = dict(
    zip(
        "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΥΦΨΩϕϑ",
        _GREEK_NAMES.split(),
        strict=True,
    )
)
_TEX = {
    **{char: rf"\ensuremath{{\{name}}}" for char, name in _GREEK.items()},
    **{char: "\\" + char for char in "{}$&#_%"},
    **{"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", '"': "''", "`": "'"},
    **{"<": r"\ensuremath{<}", ">": r"\ensuremath{>}", "|": r"\ensuremath{|}", "−": r"\ensuremath{-}"},
    **{
        "·": r"\ensuremath{\cdot}",
        "×": r"\ensuremath{\times}",
        "°": r"\ensuremath{{}^\circ}",
        "²": r"\ensuremath{{}^2}",
    },
    **{
        "³": r"\ensuremath{{}^3}",
        "′": r"\ensuremath{{}'}",
        "—": "---",
        "–": "--",
        "№": r"\textnumero{}",
        "\xa0": "~",
    },
    **{"→": r"\ensuremath{\to}", "µ": r"\ensuremath{\mu}"},
    **{"≤": r"\ensuremath{\le}", "≥": r"\ensuremath{\ge}", "≈": r"\ensuremath{\approx}"},
}


def _tex_char(char: str) -> str:
    if char in _TEX:
        return _TEX[char]
    if char.isspace():
        return " "
    known = " " <= char <= "~" or "À" <= char <= "ſ" or "Ѐ" <= char <= "ӿ" or char in "«»"
    return char if known else "?"  # pdflatex stops at a character its fonts do not have


def tex_text(text: str) -> str:
    """Text escaped for LaTeX; a character outside Latin, Greek and Cyrillic becomes a question mark."""
    return "".join(map(_tex_char, text))


def tex_parts(parts: Parts) -> str:
    """A label as TeX: symbols in math, words as text."""
    return "".join(tex_text(part) if isinstance(part, str) else f"${_tex_symbol(part)}$" for part in parts)


def _tex_symbol(symbol: Symbol) -> str:
    base = "".join(map(_tex_run, _BASE.findall(symbol.base)))
    base = rf"\mathit{{{base}}}" if symbol.base.isdigit() else base  # digits of math stand upright otherwise
    base = base if symbol.italic else rf"\mathrm{{{base}}}"
    base = rf"\overline{{{base}}}" if symbol.bar else f"{{{base}}}"
    indices = [
        f"{mark}{{{_tex_math(text)}}}" for mark, text in (("_", symbol.sub), ("^", symbol.sup)) if text
    ]
    return base + "".join(indices)


_BASE = re.compile(r"[A-Za-z0-9']+|[Α-Ωα-ωϕϑ]|[^A-Za-z0-9'Α-Ωα-ωϕϑ]+")


def _tex_math(text: str) -> str:
    """An index: letters and digits go into math as they are, Greek by name, words and anything else inside \\text."""
    return "".join(rf"\text{{{run}}}" if _is_word(run) else _tex_run(run) for run in symbols.index_runs(text))


def _tex_run(run: str) -> str:
    if run in _GREEK:
        return rf"\{_GREEK[run]}{{}}"
    return run if re.fullmatch(r"[A-Za-z0-9']+", run) else rf"\text{{{tex_text(run)}}}"
