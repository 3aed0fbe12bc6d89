"""A few lines on what was found: what a student looks for first."""

from __future__ import annotations

import re
from collections.abc import Callable
from html import escape

from tmm_report.course import Results
from tmm_report.i18n import Translator
from tmm_report.problems import in_language
from tmm_report.quantity.model import Value
from tmm_report.quantity.symbols import GREEK
from tmm_report.quantity.text import number, unit_text
from tmm_report.quantity.units import factor
from tmm_report.results import sought

Row = tuple[str, str, str, str]
DIGITS = 5


def rows(results: Results, tr: Translator) -> list[Row]:
    """Meaning, symbol, number and unit of each, as they are printed."""
    return [_row(value, tr) for value in sought(results)]


def _row(value: Value, tr: Translator) -> Row:
    quantity = value.quantity
    unit = quantity.printed
    shown = value.value * factor(value.unit, unit) if unit != value.unit else value.value
    symbol = lettered(str(quantity.symbol), tr.in_index) if quantity.symbol is not None else ""
    text = number(float(shown), DIGITS, tr.decimal)
    return quantity.meaning.render(tr.gettext), symbol, text, unit_text(unit, tr.language) if unit else ""


def lettered(symbol: str, say: Callable[[str], str] = str) -> str:
    """A symbol with its Greek letters, ω_1; `say` translates the words of an index, M_bal."""
    base, *index = re.sub(r"[A-Za-z]+", lambda word: GREEK.get(word[0], word[0]), symbol).split("_")
    return "_".join([base, *(re.sub(r"[A-Za-z]+", lambda word: say(word[0]), part) for part in index)])


def heading(results: Results, tr: Translator) -> str:
    """What the variant is about, and the structure of its mechanism."""
    topic = in_language(results.variant.title.topic, tr.gettext)
    formula = results.lever.structure.formula if results.lever else ""
    return ": ".join(filter(None, (" ".join(topic.split()), formula))) or results.variant.file or "–"


def html(results: Results, tr: Translator) -> str:
    """The heading and the rows as a table; every text is escaped."""
    lines = "".join(
        f"<tr><td style='text-align:left'>{escape(meaning)}</td><td>{escape(symbol)}</td>"
        f"<td>{escape(text)}</td><td>{escape(unit)}</td></tr>"
        for meaning, symbol, text, unit in rows(results, tr)
    )
    return f"<table><caption>{escape(heading(results, tr))}</caption>{lines}</table>"
