"""How symbols, numbers and the shapes of a formula are written in each format; the only markup of formulas.

Names of points and links come from users: every one of them is escaped on its way into LaTeX or MathML.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache, lru_cache
from typing import Literal

from tmm_report.i18n import NP_, Translator
from tmm_report.quantity.ref import Ref, attributes
from tmm_report.quantity.text import Parts, split, unit_text
from tmm_report.records import dataclass

GREEK = dict(
    zip(
        re.findall(
            r"\w+",
            "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau "
            "upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega",
        ),
        "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ",
        strict=True,
    )
)
_GREEK_TEX = {letter: f"\\{name}" for name, letter in GREEK.items()} | {"φ": "\\varphi", "ε": "\\varepsilon"}
_TEX = {
    "\\": "\\textbackslash{}",
    "~": "\\textasciitilde{}",
    "^": "\\textasciicircum{}",
    **{sign: "\\" + sign for sign in "{}$&#%_"},
    "µ": "\\ensuremath{\\mu}",
}
_SIGNS_TEX = {"∥": "\\parallel ", "⟂": "\\perp ", "⊥": "\\perp ", "·": "\\cdot ", "−": "-"}

_UNIT_TEX = {"·": "\\cdot ", "²": "^{2}", "³": "^{3}", "⁴": "^{4}", "°": "^{\\circ}"}

INDEX_WORDS = (
    NP_("index", "bal"),  # balancing
    NP_("index", "fr"),  # friction
    NP_("index", "gr"),  # graph-analytical
    NP_("index", "an"),  # analytical
    NP_("index", "max"),
    NP_("index", "min"),
)
# Indices of two letters that are abbreviations of words; any other two are letters side by side, as in d_ai.
SHORT_WORDS = frozenset(
    ["an", "br", "cr", "cw", "dr", "eq", "ex", "fl", "fr", "gr", "im", "in", "pc", "re", "st", "up"]
)
# MathML knows one sign for two primes; side by side they would be drawn apart.
_PRIMES = {2: "″", 3: "‴"}
_KEY = re.compile(r"(vec:)?([^_^]+)(?:_([^_^]*))?(?:[_^](.*))?", re.DOTALL)


# Compiled for the first symbol that is written, not on import: together they take as long as all the rest of this file.
@cache
def _run() -> re.Pattern[str]:
    """One kind of letter or sign at a time."""
    greek = "|".join(name for name in GREEK if name[0].isupper())
    return re.compile(greek + r"|d(?=t$)|[A-Z]+|[a-z]+|\d+|[^\W\d_]+|['′]+|.", re.DOTALL)


@cache
def _not_xml() -> re.Pattern[str]:
    """Signs that XML forbids; none of them can be printed."""
    return re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def latex_escape(text: str) -> str:
    """User's text for pdflatex with T2A: specials escaped, signs that its fonts lack become "?"."""
    return "".join(_TEX.get(sign) or (sign if _printable(sign) else "?") for sign in text)


def _printable(sign: str) -> bool:
    kazakh = sign in "ӘәҒғҚқҢңӨөҰұҮүҺһ"
    return " " <= sign <= "~" or "А" <= sign <= "я" or kazakh or sign in "ЁёІіЇїЄєҐґЎў«»“”—–…№"


_MARKUP = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#x27;"})


def xml_escape(text: str) -> str:
    """User's text for HTML and XML: markup escaped, characters that XML forbids become "?"."""
    return (text if text.isprintable() else _not_xml().sub("?", text)).translate(_MARKUP)


@dataclass(frozen=True)
class Symbol:
    """A symbol of the course: base letter ("v", "omega"), index below and above, optional vector bar.

    `kind` "segment" is the length of a drawn segment, named by its ends: a bar over all of `base`.
    """

    base: str
    sub: str = ""
    sup: str = ""
    bar: bool = False
    kind: Literal["symbol", "segment"] = "symbol"

    @property
    def raised(self) -> bool:
        """Whether something stands above its base, an index or a prime, so that a power needs brackets."""
        return bool(self.sup) or self.base.endswith(("'", "′"))

    def __str__(self) -> str:
        """In plain text, v_BA: for results.json and messages."""
        return "_".join(part for part in (self.base, self.sub, self.sup) if part)

    def latex(self, tr: Translator) -> str:
        return notation("latex", tr).symbol(self)

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        return _alone(self, form)


@lru_cache(maxsize=4096)
def math_symbol(key: str) -> Symbol:
    """Symbol of a key: "v_B", "a_BA^n" (also "a_BA_n"), "omega_2", "R_12^t", "vec:v_BA", "M_bal".

    Raises ValueError for a key without a base. A name that may hold "_" or "^" goes to `Symbol(...)`.
    """
    match = _KEY.fullmatch(key)
    if not match:
        raise ValueError(f"no symbol in the key {key!r}")
    bar, base, sub, sup = match.groups()
    return Symbol(base, sub or "", sup or "", bool(bar))


def both(one: str, other: str) -> str:
    """Two names as one index, as in u_15; longer ones are parted by a comma."""
    return one + other if len(one) == len(other) == 1 else f"{one},{other}"


def segment(ends: str) -> Symbol:
    """The length of a plan's segment in mm, named by its ends: "pb", "πb", "ps2"."""
    return Symbol(ends, kind="segment")


def index_runs(text: str, base: bool = False) -> Iterator[str]:
    """The runs of an index, or of the `base` of a symbol, as they are set: Greek letters by their signs, a word or a
    number whole, other letters one by one. "pi" as an index is the point p of wheel i: the number is no index."""
    for run in _run().findall(text):
        if run in GREEK and (base or run != "pi"):
            yield GREEK[run]
        elif run.isascii() and run.islower() and len(run) == 2 and run not in SHORT_WORDS:
            yield from run
        else:
            yield run


@dataclass(frozen=True, eq=False)
class Notation:
    """The shapes of a formula, which each format writes in its way. What all share: the translator and how a run of
    letters in an index is read."""

    tr: Translator

    def number(self, x: float, digits: int, scale: float = 1.0, ref: Ref | None = None) -> str:
        return self.marked(self.parts(split(x, digits, scale=scale)), ref)

    def marked(self, text: str, ref: Ref | None) -> str:
        """A printed number with the place where it stands in the results, in a format that can say it."""
        return text

    def parts(self, parts: Parts) -> str:
        raise NotImplementedError

    def symbol(self, symbol: Symbol) -> str:
        return _symbol(symbol, self)

    def indexed(self, base: str, sub: str, sup: str) -> str:
        raise NotImplementedError

    def run(self, run: str) -> str:
        """One kind of letter or sign."""
        raise NotImplementedError

    def unit(self, unit: str) -> str:
        """As it follows a number."""
        raise NotImplementedError

    def operator(self, sign: str) -> str:
        """Between two terms."""
        raise NotImplementedError

    def negative(self, text: str) -> str:
        raise NotImplementedError

    def brackets(self, text: str, marks: str = "()") -> str:
        raise NotImplementedError

    def fraction(self, above: str, below: str) -> str:
        raise NotImplementedError

    def root(self, text: str) -> str:
        raise NotImplementedError

    def power(self, base: str, exponent: str) -> str:
        raise NotImplementedError

    def function(self, name: str, argument: str) -> str:
        raise NotImplementedError

    def integral(self, body: str, along: str, lower: str, upper: str) -> str:
        raise NotImplementedError

    def bar(self, text: str) -> str:
        """Above a vector or a segment."""
        raise NotImplementedError

    def underlined(self, text: str, lines: int) -> str:
        """By as many lines as are known of a vector, up to two."""
        raise NotImplementedError

    def under(self, text: str, note: str) -> str:
        """A note below a vector."""
        raise NotImplementedError

    def formula(self, pieces: list[str]) -> str:
        """Pieces, each beginning with its relation or sign: a line may break between them."""
        raise NotImplementedError

    def text(self, text: str, base: bool = False) -> str:
        """A whole index: runs of point names (italic), digits, words (upright), Greek letters by name."""
        return "".join(self.run(run) for run in index_runs(text, base))

    def word(self, run: str) -> str:
        return self.tr.in_index(run)


@dataclass(frozen=True, eq=False)
class Latex(Notation):
    """Math-mode LaTeX for amsmath, T2A and pdflatex."""

    def parts(self, parts: Parts) -> str:
        if parts.digits in ("—", "∞"):
            return "\\text{---}" if parts.digits == "—" else ("-" if parts.negative else "") + "\\infty"
        text = ("-" if parts.negative else "") + parts.digits.replace(".", self.decimal)
        return text if parts.power is None else f"{text}\\cdot 10^{{{parts.power}}}"

    @property
    def decimal(self) -> str:
        return "{,}" if self.tr.decimal == "," else "."

    def indexed(self, base: str, sub: str, sup: str) -> str:
        return base + (f"_{{{sub}}}" if sub else "") + (f"^{{{sup}}}" if sup else "")

    def run(self, run: str) -> str:
        if run and all(letter in _GREEK_TEX for letter in run):
            return "".join(f"{_GREEK_TEX[letter]} " for letter in run)
        if run[0] in "'′":
            return "{}^{" + "\\prime" * len(run) + "}"
        if run in _SIGNS_TEX:
            return _SIGNS_TEX[run]
        if run.isascii() and run.isalnum() and (run.isupper() or run.isdigit() or len(run) == 1):
            return run
        return f"\\text{{{latex_escape(self.word(run))}}}"

    def unit(self, unit: str) -> str:
        if unit == "deg":
            return "^{\\circ}"
        text = re.sub(r"[^\W\d_²³⁴]+|.", _unit_sign, unit_text(unit, self.tr.language))
        return f"\\;{text}" if text else ""

    def operator(self, sign: str) -> str:
        return {"·": "\\cdot ", "−": "-"}.get(sign, sign)

    def negative(self, text: str) -> str:
        return f"-{text}"

    def brackets(self, text: str, marks: str = "()") -> str:
        return f"\\left{marks[0]}{text}\\right{marks[1]}"

    def fraction(self, above: str, below: str) -> str:
        return f"\\frac{{{above}}}{{{below}}}"

    def root(self, text: str) -> str:
        return f"\\sqrt{{{text}}}"

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^{{{exponent}}}"

    def function(self, name: str, argument: str) -> str:
        return f"\\operatorname{{{name}}}{argument}"

    def integral(self, body: str, along: str, lower: str, upper: str) -> str:
        return f"\\int_{{{lower}}}^{{{upper}}}{body}\\,d{along}"

    def bar(self, text: str) -> str:
        return f"\\overline{{{text}}}"

    def underlined(self, text: str, lines: int) -> str:
        return "\\underline{" * lines + text + "}" * lines

    def under(self, text: str, note: str) -> str:
        return f"\\underset{{{note}}}{{{text}}}"

    def formula(self, pieces: list[str]) -> str:
        """Pieces, each beginning with its relation or sign, as one text for math mode."""
        return " ".join(pieces)


@dataclass(frozen=True, eq=False)
class MathML(Notation):
    """MathML Core, as Chromium and Firefox draw it with the embedded math font."""

    def parts(self, parts: Parts) -> str:
        text = f"<mn>{parts.digits.replace('.', self.tr.decimal)}</mn>"
        if parts.power is not None:
            power = self.parts(Parts(parts.power < 0, str(abs(parts.power))))
            text += f"<mo>·</mo><msup><mn>10</mn>{power}</msup>"
        if parts.negative:
            return f"<mrow><mo>−</mo>{text}</mrow>"
        return text if parts.power is None else f"<mrow>{text}</mrow>"

    def marked(self, text: str, ref: Ref | None) -> str:
        if ref is None:
            return text
        tag = "<mn" if text.startswith("<mn") else "<mrow"
        return f"{tag}{attributes(ref)}{text[len(tag) :]}"

    def indexed(self, base: str, sub: str, sup: str) -> str:
        base = _row(base)
        rows = "".join(_row(index) for index in (sub, sup) if index)
        tag = ("msubsup" if sup else "msub") if sub else ("msup" if sup else "mrow")
        return f"<{tag}>{base}{rows}</{tag}>" if rows else base

    def run(self, run: str) -> str:
        if run.isdigit():
            return f"<mn>{run}</mn>"
        if run[0] in "'′":
            return f"<mo>{_PRIMES.get(len(run), '′' * len(run))}</mo>"
        if len(run) == 1:
            italic = run.isascii() or (run in _GREEK_TEX and run.islower())
            upright = "" if italic or not run.isalpha() else ' mathvariant="normal"'
            tag = "mi" if run.isalpha() else "mo"
            return f"<{tag}{upright}>{xml_escape(run)}</{tag}>"
        if run.isascii() and run.isupper():
            return "".join(f"<mi>{letter}</mi>" for letter in run)
        return f"<mtext>{xml_escape(self.word(run))}</mtext>"

    def unit(self, unit: str) -> str:
        text = unit_text(unit, self.tr.language)
        gap = "" if text == "°" else '<mspace width="0.2em"/>'
        return f"{gap}<mtext>{xml_escape(text)}</mtext>" if text else ""

    def operator(self, sign: str) -> str:
        return f'<mo form="infix">{sign.replace("<", "&lt;")}</mo>'

    def negative(self, text: str) -> str:
        return f'<mrow><mo form="prefix">−</mo>{text}</mrow>'

    def brackets(self, text: str, marks: str = "()") -> str:
        # Stretched brackets have wide bearings: only what is tall gets them.
        tall = "true" if "<mfrac" in text or "<msqrt" in text else "false"
        left, right = (
            f'<mo form="{form}" stretchy="{tall}">{mark}</mo>'
            for form, mark in zip(("prefix", "postfix"), marks, strict=True)
        )
        return f"<mrow>{left}{text}{right}</mrow>"

    def fraction(self, above: str, below: str) -> str:
        return f"<mfrac>{_row(above)}{_row(below)}</mfrac>"

    def root(self, text: str) -> str:
        return f"<msqrt>{text}</msqrt>"

    def power(self, base: str, exponent: str) -> str:
        return f"<msup>{_row(base)}{_row(exponent)}</msup>"

    def function(self, name: str, argument: str) -> str:
        return f'<mrow><mi>{name}</mi><mspace width="0.17em"/>{argument}</mrow>'

    def integral(self, body: str, along: str, lower: str, upper: str) -> str:
        sign = f"<msubsup><mo>∫</mo>{_row(lower)}{_row(upper)}</msubsup>"
        return f'<mrow>{sign}{body}<mspace width="0.17em"/><mi>d</mi>{along}</mrow>'

    def bar(self, text: str) -> str:
        return f'<mover>{_row(text)}<mo stretchy="true">‾</mo></mover>'

    def underlined(self, text: str, lines: int) -> str:
        # MathML Core has no underline; a border of a row is drawn by every browser.
        style = {1: "border-bottom:0.06em solid", 2: "border-bottom:0.2em double"}.get(lines)
        return f'<mrow style="{style};padding-bottom:0.12em">{text}</mrow>' if style else text

    def under(self, text: str, note: str) -> str:
        return f"<munder>{_row(text)}{_row(note)}</munder>"

    def formula(self, pieces: list[str]) -> str:
        """Pieces as neighbouring `math` elements: lines may break between them, never inside one."""
        return "<wbr/>".join(f"<math>{piece}</math>" for piece in pieces)


def _row(text: str) -> str:
    """What takes the place of one element."""
    return text if text.count("<m") == 1 else f"<mrow>{text}</mrow>"


def _unit_sign(word: re.Match[str]) -> str:
    return _UNIT_TEX.get(word[0]) or (
        f"\\text{{{latex_escape(word[0])}}}" if word[0] not in "/()" else word[0]
    )


@lru_cache(maxsize=8192)
def _symbol(symbol: Symbol, notation: Notation) -> str:
    if symbol.kind == "segment":
        return notation.bar(_segment(symbol.base, notation))
    base = notation.text(symbol.base, base=True)
    return notation.indexed(
        notation.bar(base) if symbol.bar else base, notation.text(symbol.sub), notation.text(symbol.sup)
    )


@lru_cache(maxsize=8192)
def _alone(symbol: Symbol, notation: Notation) -> str:
    return notation.formula([notation.symbol(symbol)])


def _segment(ends: str, notation: Notation) -> str:
    """Each letter of a segment's name on its own, digits and marks as its index: ps2 -> p s₂."""
    pieces = re.findall(r"([^\W\d_]|.)(\d*)", ends, re.DOTALL)
    return "".join(
        notation.indexed(notation.run(letter), notation.text(digits), "") for letter, digits in pieces
    )


@cache
def notation(format: Literal["latex", "mathml"], tr: Translator) -> Latex | MathML:
    return Latex(tr) if format == "latex" else MathML(tr)


@lru_cache(maxsize=4096)
def with_power(symbol: Symbol, exponent: str) -> Symbol | None:
    """The symbol with a power in the place of its upper index, or None where that place is taken."""
    return replace(symbol, sup=exponent) if not symbol.raised and symbol.kind == "symbol" else None
