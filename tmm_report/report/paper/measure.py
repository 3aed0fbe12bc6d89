"""How wide what the note prints is, by the advances of the faces that it carries, in ems of the text around it.

Mathematics and words are written for HTML and for LaTeX; one symbol has one width in both, so that tables and formulas
of the two are divided alike. A width is never less than the printed one.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache, lru_cache
from html import unescape
from itertools import pairwise
from xml.etree.ElementTree import Element, fromstring

from tmm_report.quantity.ref import without_attributes
from tmm_report.quantity.symbols import GREEK
from tmm_report.resources import data_root

UNKNOWN = 1000  # thousandths of an em: of a letter that no face has, which is another font's
WORDS = 1.12  # TeX's own letters are as much wider, where it has no Times; short ones have room in the cell
_INDEX = (1.0, 0.7, 0.55)  # sizes of indices and of their own
_AFTER_INDEX = 0.04


@cache
def _advances() -> Mapping[str, Mapping[str, int]]:
    """Thousandths of an em by face and letter."""
    text = (data_root() / "templates" / "fonts" / "widths.json").read_text("utf-8")
    found: Mapping[str, Mapping[str, int]] = json.loads(text)
    return found


def known_letters() -> frozenset[str]:
    """The letters that some face has."""
    return frozenset().union(*_advances().values())


def letters(text: str, face: str = "regular") -> float:
    """A text on one line. `face`: regular, bold, italic, math."""
    own, other = _advances()[face], _advances()["math"]
    return sum([own.get(sign) or other.get(sign) or UNKNOWN for sign in text]) / 1000


# --- what may stand in a cell of a table ---

_MATH = re.compile(
    r"(<math.*?</math>|(?:<m:oMath>.*?</m:oMath>)+<!--[\d.]+-->"
    r"|(?<!\\)(?:\$[^$]*\$)+/\*[\d.]+\*/|(?<!\\)\$.*?(?<!\\)\$)",
    re.S,
)
_STATED = re.compile(r"(?:/\*|<!--)([\d.]+)(?:\*/|-->)$")  # behind a formula of Typst and of Office Math
_TAG = re.compile(r"<wbr/?>|<br/?>|\\allowbreak(?:\{\}| )?|(<[^>]+>)")
_COMMAND = re.compile(
    r"\\hyperlink\{[^}]*\}|\\hspace\{[^}]*\}|\\([%&#$_{}])|\\[A-Za-z]+ ?|[{}]"
    r"|#link\(label\(\"[\w.-]*\"\)\)|\\([-/*@<>=+~`'\"\[\]])"  # of Typst
)
_BREAK = re.compile(r"[ \n\u200b]|(?<=[^\W\d]-)(?=\w)")  # a compound is broken behind its hyphen


@lru_cache(maxsize=4096)
def widest_word(cell: str) -> float:
    """The widest of what no line of a cell can break."""
    return max(map(_word, _words(cell)), default=0.0)


@lru_cache(maxsize=4096)
def whole(cell: str) -> float:
    """A cell on one line."""
    words = list(_words(cell))
    return sum(map(_word, words)) + 0.25 * max(0, len(words) - 1)


def _words(cell: str) -> Iterator[list[str]]:
    """Between two places where a line may break: text and mathematics by turns."""
    word: list[str] = []
    for k, run in enumerate(_MATH.split(_as_written(without_attributes(cell)))):
        if k % 2:
            word.append(run)
            continue
        first, *others = [part for text in _BREAK.split(_plain(run)) for part in breakable(text)]
        word.append(first)
        for other in others:
            yield word
            word = [other]
    yield word


def _as_written(cell: str) -> str:
    """A cell whose signs of text LaTeX has put into mathematics, with the signs that HTML has."""
    if "$" not in cell:
        return cell
    return _LIFTED.sub(_lifted, _ALONE.sub(lambda mark: _SIGN_OF[mark[1]], cell))


# What `formats.tex_escape` makes of signs in running text, but for Greek letters: they are written as symbols are.
_SIGN_OF = {
    "-": "−", "\\cdot": "·", "^{\\circ}": "°", "\\to": "→", "\\times": "×", "\\leqslant": "≤", "\\geqslant": "≥",
    "\\pm": "±", "\\approx": "≈", "\\parallel": "∥", "\\perp": "⟂", "\\neq": "≠", "\\infty": "∞",
    "\\circlearrowright": "↻", "\\circlearrowleft": "↺",
}  # fmt: skip
_ALONE = re.compile(r"(?<!\\)\$(" + "|".join(map(re.escape, _SIGN_OF)) + r")\$")
_LIFTED = re.compile(r"(?<!\\)\$([_^])\{(-?\d+)\}\$")
_DIGITS = {"^": str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"), "_": str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")}


def _lifted(mark: re.Match[str]) -> str:
    return mark[2].translate(_DIGITS[mark[1]])


def _plain(run: str) -> str:
    """Text of markup: a place where it may break becomes a blank."""
    text = unescape(_TAG.sub(lambda mark: "" if mark[1] else "\u200b", run))
    return _COMMAND.sub(lambda mark: mark[1] or mark[2] or "", text).replace("~", "\N{NO-BREAK SPACE}")


def _word(runs: Iterable[str]) -> float:
    return sum(map(_run, runs))


def _run(run: str) -> float:
    if _MATH.fullmatch(run):
        return mathematics(run) * (WORDS if _CYRILLIC.search(run) else 1)
    return letters(run) * (WORDS if _WIDER.search(run) else 1)


_CYRILLIC = re.compile("[\u0400-\u04ff]")
_WIDER = re.compile("[\u0400-\u04ff]|[A-Za-z]{4}")


# --- long words ---

LONG = 24  # letters: no word is as long, but a name that someone made up
_LONG = re.compile(rf"\S{{{LONG + 1},}}")
_DOT = re.compile(r"(?<=\w)\.(?=\w)")


def breakable(text: str) -> list[str]:
    """A text parted where a line may break within a word that no column holds: behind the dots of a path of keys, else
    at even distances."""
    if len(text) <= LONG or not _LONG.search(text):
        return [text]
    parts, end = [], 0
    for word in _LONG.finditer(text):
        dots = [word.start() + dot.end() for dot in _DOT.finditer(word[0])]
        longest = max(b - a for a, b in pairwise([word.start(), *dots, word.end()]))
        even = range(word.start() + LONG // 2, word.end() - 2, LONG // 2)
        for cut in dots if longest <= LONG else even:
            parts.append(text[end:cut])
            end = cut
    return [*parts, text[end:]]


# --- mathematics ---


@lru_cache(maxsize=8192)
def mathematics(text: str) -> float:
    """Neighbouring formulas, as MathML or as LaTeX between dollar signs; others say how wide they are."""
    if stated := _STATED.search(text):
        return float(stated[1])
    if text.startswith("$"):
        return latex(text[1:-1])
    return sum(mathml(node) for node in fromstring(f"<p>{without_attributes(text)}</p>"))


_WIDE_SIGNS = frozenset(" =<>≤≥≈≠→≪≫⩽⩾⟂∥")
_SIGNS = frozenset("+−-·×±")
_BRACKETS = frozenset("()[]{}|")
_ROOT, _TALL = 1.2, 1.9  # em of the sign of a root; a bracket as tall as what is in it against a low one


def mathml(node: Element, level: int = 0, within: bool = False) -> float:
    """An element of MathML; `level`: how deep among indices; `within`: a fraction or an index, where the terms of a
    fraction are as small as indices are."""
    size = _INDEX[min(level, 2)]
    match node.tag:
        case "mi" | "mn" | "mtext":
            text = node.text or ""
            leans = node.tag == "mi" and len(text) == 1 and node.get("mathvariant") is None
            return size * (_leaning(text) if leans else letters(text, "math"))
        case "mo":
            sign = node.text or ""
            grows = sign in _BRACKETS and node.get("stretchy") != "false"
            wide = letters(sign, "math") * (_TALL if grows else 1.0)
            return size * (wide + (spaces(sign) if node.get("form") != "prefix" else 0.1))
        case "mspace":
            wide = float((node.get("width") or "0em").removesuffix("em"))
            return size * (max(wide, _THICK) if wide else 0.0)
        case "mfrac":
            return max(mathml(child, level + within, True) for child in node) + 0.1
        case "msub" | "msup" | "msubsup":
            base, *indices = node
            smaller = max(mathml(one, level + 1, True) for one in indices)
            return mathml(base, level, within) + smaller + _AFTER_INDEX
        case "munder" | "mover":
            base, *others = node
            return max(mathml(base, level, within), *(mathml(one, level + 1, True) for one in others))
        case "msqrt":
            return sum(mathml(child, level, within) for child in node) + size * _ROOT
    return sum(mathml(child, level, within) for child in node)


def spaces(sign: str) -> float:
    """Around a sign between two terms."""
    return 0.56 if sign in _WIDE_SIGNS else 0.45 if sign in _SIGNS else 0.17 if sign in (",", ";") else 0.0


def _leaning(letter: str) -> float:
    return letters(italic(letter), "math")


@cache
def italic(letter: str) -> str:
    """The letter of mathematics that leans."""
    if letter == "h":
        return "\u210e"
    for first, last, to in (("a", "z", 0x1D44E), ("A", "Z", 0x1D434), ("α", "ω", 0x1D6FC)):
        if first <= letter <= last:
            return chr(to + ord(letter) - ord(first))
    return {"ϕ": "\U0001d719"}.get(letter, letter)


# --- the same of LaTeX ---

_THICK = 0.28  # em of TeX's space before a unit; a browser's is less
_PRIMES = re.compile(r"\{\}\^\{((?:\\prime)+)\}")  # on the line of their letter, as MathML has them
_LONE = re.compile(r"\\text\{([,;+−±])\}")  # among indices: a browser parts it from them
_TOKEN = re.compile(r"\\[A-Za-z]+ ?|\\.|[_^]|[{}]|[^\\{}_^]")
_NAMES = {
    **GREEK, "varphi": "φ", "varepsilon": "ε", "cdot": "·", "times": "×",
    "leqslant": "≤", "geqslant": "≥", "approx": "≈", "to": "→", "infty": "∞", "parallel": "∥", "perp": "⟂",
    "pm": "±", "neq": "≠", "sum": "∑", "prime": "′", "circ": "°", "le": "≤", "ge": "≥",
}  # fmt: skip
_UPRIGHT = frozenset(("text", "operatorname", "mathrm"))


def latex(text: str) -> float:
    """Mathematics of LaTeX."""
    text = _PRIMES.sub(lambda mark: "′″‴"[mark[1].count("\\") - 1], text)
    tokens = _TOKEN.findall(_LONE.sub(r"\1", text).replace("{,}", "\\mathrm{,}"))
    wide, end = _row(tokens, 0, 0)
    while end < len(tokens):  # a brace too many
        more, end = _row(tokens, end + 1, 0)
        wide += more
    return wide


def _row(
    tokens: list[str], at: int, level: int, upright: bool = False, within: bool = False
) -> tuple[float, int]:
    """What stands from a token up to the closing brace, and where that is. Indices of one letter stand above one
    another."""
    wide, indices = 0.0, [0.0]
    while at < len(tokens) and tokens[at] != "}":
        if tokens[at] in "_^":
            one, at = _one(tokens, at + 1, level + 1, upright, True)
            indices.append(one + _AFTER_INDEX)
        else:
            one, at = _one(tokens, at, level, upright, within)
            wide, indices = wide + max(indices) + one, [0.0]
    return wide + max(indices), at


def _one(tokens: list[str], at: int, level: int, upright: bool, within: bool) -> tuple[float, int]:
    """A group, a command with what it is of, or a letter; and the token behind it."""
    if at >= len(tokens):
        return 0.0, at
    token, size = tokens[at].rstrip() or " ", _INDEX[min(level, 2)]
    if token == "{":
        wide, end = _row(tokens, at + 1, level, upright, within)
        return wide, end + 1
    if not token.startswith("\\"):
        return size * _sign(token, upright), at + 1
    name = token[1:]
    if name in ("frac", "underset"):
        deeper = level + within
        above, at = _one(tokens, at + 1, deeper if name == "frac" else level + 1, upright, True)
        below, at = _one(tokens, at, deeper if name == "frac" else level, upright, within or name == "frac")
        return max(above, below) + (0.1 if name == "frac" else 0.0), at
    if name in ("sqrt", "overline", "underline", *_UPRIGHT):
        wide, at = _one(tokens, at + 1, level, upright or name in _UPRIGHT, within)
        return wide + (size * _ROOT if name == "sqrt" else 0.0), at
    if name in ("left", "right"):
        return size * letters(tokens[at + 1] if at + 1 < len(tokens) else "", "math") * _TALL, at + 2
    return size * (
        _sign(_NAMES[name], upright) if name in _NAMES else _THICK if name in ",;:" else 0.0
    ), at + 1


def _sign(sign: str, upright: bool) -> float:
    if sign.isspace():
        return 0.25 if upright else 0.0
    sign = "−" if sign == "-" and not upright else sign
    if upright or not sign.isalpha():
        return letters(sign, "math") + (0.0 if upright else spaces(sign))
    return _leaning(sign)
