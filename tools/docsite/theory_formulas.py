"""Formulas of the theory pages, as the notes of ready variants print them: the symbols, without the numbers.

A line `<!-- formula: VARIANT KEY -->` of a page stands for the formula of the note of that variant whose value has this
key of results.json, with the letters that the note explains under it; `<!-- sources: NAME … -->` for books as notes
cite them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tmm_report import load, render, solve
from tmm_report.i18n import Translator
from tmm_report.report.sources import SOURCES

ROOT = Path(__file__).resolve().parents[2]
LINE = re.compile(r"^<!-- formula: (\S+) (\S+) -->$", re.M)
BOOKS = re.compile(r"^<!-- sources: ([\w ]+) -->$", re.M)
_FORMULA = re.compile(
    r'<div class="formula"[^>]*><div class="math">(.*?)</div>(?:<div class="number">.*?</div>)?</div>', re.S
)
_WHERE = re.compile(r'\s*<p class="where">(.*?)</p>', re.S)
_PIECE = re.compile(r"<math>.*?</math>", re.S)
_EQUALS = '<math><mo form="infix">=</mo>'
_KEY = re.compile(r'data-q="([^"]+)"')


class NoFormula(LookupError):
    """A page asks for a formula that the note of the variant has not."""


@cache
def note(variant: str, language: str, depth: str | None = "full") -> str:
    """The note of a ready variant as HTML; `depth` None: its own."""
    results = solve(load(ROOT / "variants" / f"{variant}.yaml"))
    page = render(results, "html", language=language, depth=depth)["note.html"]
    return page.decode() if isinstance(page, bytes) else page


def formulas(page: str) -> Iterator[tuple[str, str, str]]:
    """(key of the value, symbols, where-list) of every formula with numbers: MathML and HTML."""
    for found in _FORMULA.finditer(page):
        pieces = [piece[0] for piece in _PIECE.finditer(found[1])]
        keys = _KEY.findall(found[1])
        if keys and (end := _numbers(pieces)):
            where = _WHERE.match(page, found.end())
            yield keys[-1], "".join(pieces[:end]), where[1] if where else ""


def _numbers(pieces: list[str]) -> int:
    """Where the numbers begin: at the equals sign before the first of them. A long formula is in pieces."""
    first = next(k for k, piece in enumerate(pieces) if _KEY.search(piece))
    return next((k for k in range(first, -1, -1) if pieces[k].startswith(_EQUALS)), 0)


@cache
def keys(variant: str, language: str) -> dict[str, tuple[str, str]]:
    """Key -> symbols and where-list of the first formula for it."""
    known: dict[str, tuple[str, str]] = {}
    for key, symbols, where in formulas(note(variant, language)):
        known.setdefault(key, (symbols, where))
    return known


def formula(variant: str, key: str, language: str) -> str:
    """HTML of a formula with its letters. Raises NoFormula."""
    known = keys(variant, language)
    if key not in known:
        raise NoFormula(f"the note of {variant} has no formula for {key}; it has {', '.join(sorted(known))}")
    symbols, where = known[key]
    plain = re.sub(r"<a [^>]*>(.*?)</a>", r"\1", where)
    letters = f'\n<p class="where">{plain}</p>' if where else ""
    return f'<div class="formula">{symbols}</div>{letters}'


def filled(page: str, language: str) -> str:
    """A page with its formulas and sources. Raises NoFormula, KeyError of a book that no note cites."""
    say = Translator(language).gettext
    page = BOOKS.sub(lambda found: "\n".join(f"- {say(SOURCES[name])}" for name in found[1].split()), page)
    return LINE.sub(lambda found: formula(found[1], found[2], language), page)
