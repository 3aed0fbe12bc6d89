"""Numbers: the decimal sign, noise printed for a result, one quantity printed in two ways."""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import zip_longest
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from tmm_report.lint.known import Known
from tmm_report.lint.made import Made
from tmm_report.lint.page import Number, Page, rows
from tmm_report.problems import N_, Message, Problem

NOISE = 1e-6  # of the largest number of its column: what is less is the noise of a computation
NOTHING = 1e-12  # in no unit of the course is a result so small
PICTURE = "picture"  # the table of the scales: each drawing has its own
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_NUMBER = re.compile(r"([−-]?)([0-9]+)(?:([.,])([0-9]+))?(?:·10(?:(⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,2})|\^(-?[0-9]{1,2})))?")


class Read(NamedTuple):
    """A printed number. `sign`: the decimal one, "" for none; `half`: half a unit of its last place."""

    value: float
    sign: str
    half: float


@lru_cache(maxsize=16384)  # most numbers of a note are printed many times
def read(text: str) -> Read | None:
    match = _NUMBER.fullmatch(text.strip())
    if match is None or len(text) > 60:
        return None
    minus, whole, sign, decimals, raised, power = match.groups()
    exponent = int(raised.translate(_RAISED) if raised else power or 0)
    value = float(f"{minus and '-'}{whole}.{decimals or 0}e{exponent}")
    return Read(value, sign or "", 0.5 * 10.0 ** (exponent - len(decimals or "")))


# --- the decimal sign ---


def decimal_sign(made: Made) -> Iterator[Problem]:
    """Numbers with another decimal sign than most of the note's."""
    if made.page is not None:
        found = [*_printed(made.page)]
        usual = _usual(read.sign for _, read, _ in found)
        for text, number, anchor in found:
            if number.sign not in ("", usual):
                yield _other_sign(made, "note.html", made.line(anchor), text, usual)
    if made.tex is not None:
        in_tex = [*_in_tex(made.tex)]
        usual = _usual(sign for _, _, sign in in_tex)
        for text, line, sign in in_tex:
            if sign != usual:
                yield _other_sign(made, "note.tex", line, text, usual)


_LINE = re.compile(r"^.*\d(?:\{,\}|[.,])\d.*$", re.M)
_MATH = re.compile(r"\$[^$]+\$|\\NotePiece\{.*")
_IN_TEX = re.compile(r"(?<![\d.,{}])\d+(?:\{(,)\}|(\.))\d+(?![\d.,])")
_CELL = re.compile(r"(?:^|(?<=& ))\d+([.,])\d+(?= & | \\\\ \\hline)")


def _in_tex(tex: str) -> Iterator[tuple[str, int, str]]:
    """Numbers of formulas and of cells with their lines and decimal signs."""
    line, at = 1, 0
    for row in _LINE.finditer(tex, max(tex.find("\\begin{document}"), 0)):
        line, at = line + tex.count("\n", at, row.start()), row.start()
        for formula in _MATH.findall(row[0]):
            yield from ((one[0], line, one[1] or one[2]) for one in _IN_TEX.finditer(formula))
        if row[0].endswith("\\hline"):
            yield from ((one[0], line, one[1]) for one in _CELL.finditer(row[0]))


def _usual(signs: Iterable[str]) -> str:
    counted = Counter(sign for sign in signs if sign)
    return counted.most_common(1)[0][0] if counted else ""


def _other_sign(made: Made, file: str, line: int | None, text: str, usual: str) -> Problem:
    wrong = Message(N_("%(text)s has another decimal sign than the rest of the note"), {"text": text})
    return made.found("decimal", file, line, wrong, Message(N_("write it with “%(sign)s”"), {"sign": usual}))


def _printed(page: Page) -> Iterator[tuple[str, Read, str]]:
    """Every element whose text is a number, with the anchor before it."""
    anchor = ""
    for node in page.root.iter():
        anchor = node.get("id") or anchor
        if node.tag in ("td", "mn", "span", "text") and (text := node.text) and ("," in text or "." in text):
            number = read(text)
            if number is not None:
                yield text, number, anchor


# --- noise ---


def noise(made: Made) -> Iterator[Problem]:
    """Printed numbers that are noise: below a millionth of the largest of their column, or smaller than anything.

    In a table of words a column holds many quantities, so that none is judged by another.
    """
    if made.page is None:
        return
    noisy = {number.node: (number.text, number.within) for number in made.page.numbers if _least(number)}
    for anchor, table in made.page.tables:
        if table.get("class") != "words":
            noisy |= {cell: (cell.text or "", anchor) for cell in _far_below(table)}
    right = Message(N_("print 0, or say that it is zero to the accuracy of the computation"))
    for text, anchor in noisy.values():
        values = {"text": text, "what": made.page.name(anchor)}
        wrong = Message(N_("%(text)s at %(what)s is numerical noise"), values)
        yield made.found("noise", "note.html", made.line(anchor), wrong, right)


def _least(number: Number) -> bool:
    found = read(number.text)
    return found is not None and 0 < abs(found.value) < NOTHING


def _far_below(table: Element) -> Iterator[Element]:
    """Cells of numbers that are nothing beside the largest of their column."""
    for column in zip_longest(*rows(table)):
        found = [(cell, number) for cell in column if cell is not None and (number := read(cell.text or ""))]
        largest = max((abs(number.value) for _, number in found), default=0.0)
        yield from (cell for cell, number in found if 0 < abs(number.value) < NOISE * largest)


# --- one quantity in two ways ---


def twice(made: Made) -> Iterator[Problem]:
    """Quantities that are printed in two ways: with another last digit, or to other digits."""
    if made.page is None:
        return
    ways = defaultdict[Any, list[_Reading]](list)
    known = made.known or Known({}, {})
    for number in made.page.numbers:
        if number.table != PICTURE and (found := read(number.text)) is not None:
            ways[known.identity(number)].append(_Reading(number, found))
    right = Message(N_("print one value alike everywhere"))
    for readings in ways.values():
        one = min(readings, key=lambda reading: reading.read.half)  # to the most digits
        other = next((other for other in readings if not _alike(one, other)), None)
        if other is not None:
            values = {
                "key": one.number.key,
                "one": one.number.text,
                "where": made.page.name(one.number.within),
                "other": other.number.text,
                "there": made.page.name(other.number.within),
            }
            wrong = Message(N_("%(key)s reads %(one)s at %(where)s and %(other)s at %(there)s"), values)
            yield made.found("twice", "note.html", made.line(other.number.within), wrong, right)


class _Reading(NamedTuple):
    number: Number
    read: Read


DIGITS = 5  # of an ordinary number; a difference of near ones is worked with more


def _alike(one: _Reading, other: _Reading) -> bool:
    """Whether a number `one`, to the most digits, and another read the same. In a column of numbers one may have fewer
    decimals, rounded rightly; of more than five digits five may be printed elsewhere, all but a nought or two."""
    a, b = one.read, other.read
    if a.value == b.value:
        return True
    if one.number.cell or other.number.cell:
        return abs(a.value - b.value) <= (a.half + b.half) * (1 + 1e-9)
    rounded = float(f"{a.value:.{DIGITS - 1}e}")
    return math.isclose(rounded, b.value, rel_tol=1e-9) and b.half <= 50 * _unit(b.value)


def _unit(value: float) -> float:
    """Half a unit of the fifth digit."""
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(value))) - DIGITS + 1) if value else 0.0
