"""Formulas in Typst's mathematics.

Whatever is not a letter of our own stands in a string, where Typst reads no command, so that no name can break out.
Source: Typst 0.15, reference, "Math".
"""

from __future__ import annotations

import re
from functools import cache

from tmm_report.i18n import Translator
from tmm_report.quantity.symbols import GREEK, Notation
from tmm_report.quantity.text import MINUS, Parts, unit_text
from tmm_report.records import dataclass

NEXT = "\N{INFORMATION SEPARATOR ONE}"  # between pieces of a formula; in no text
_LETTERS = frozenset(GREEK.values())
_OPERATORS = {"·": "⋅ ", ">": "gt ", "<": "lt "}
_BEFORE_STRING = re.compile(r'("(?:[^"\\]|\\.)*")| (?=")')  # Typst would print the blank
_STRING = {"\\": "\\\\", '"': '\\"', "$": "\\u{24}"}


def string(text: str) -> str:
    """Text between quotation marks: what Typst would read as more than a letter is written by its number."""
    return '"' + "".join(_STRING.get(sign) or (sign if sign.isprintable() else "?") for sign in text) + '"'


@dataclass(frozen=True, eq=False)
class Typst(Notation):
    """A letter or a word of Typst's has a blank behind it; a string has none about it, for Typst would print it."""

    def parts(self, parts: Parts) -> str:
        text = string(parts.digits.replace(".", self.tr.decimal))
        if parts.power is not None:
            power = self.parts(Parts(parts.power < 0, str(abs(parts.power))))
            text += f'⋅ attach("10", t: {power})'
        return f"{MINUS}{text}" if parts.negative else text

    def indexed(self, base: str, sub: str, sup: str) -> str:
        rows = (f", b: {sub}" if sub else "") + (f", t: {sup}" if sup else "")
        return f"attach({base}{rows})" if rows else base

    def run(self, run: str) -> str:
        if run[0] in "'′":
            return string("′" * len(run))
        letters = run.isalpha() and all(letter.isascii() or letter in _LETTERS for letter in run)
        if letters and (len(run) == 1 or run.isupper()):
            return "".join(f"{letter} " for letter in run)
        return string(self.word(run))

    def unit(self, unit: str) -> str:
        text = unit_text(unit, self.tr.language)
        return ("" if text == "°" else "thin ") + string(text) if text else ""

    def operator(self, sign: str) -> str:
        return _OPERATORS.get(sign, f"{sign} ")

    def negative(self, text: str) -> str:
        return f"{MINUS}{text}"

    def brackets(self, text: str, marks: str = "()") -> str:
        return f"lr(\\{marks[0]} {text}\\{marks[1]})"

    def fraction(self, above: str, below: str) -> str:
        return f"frac({above}, {below})"

    def root(self, text: str) -> str:
        return f"sqrt({text})"

    def power(self, base: str, exponent: str) -> str:
        return f"attach({base}, t: {exponent})"

    def function(self, name: str, argument: str) -> str:
        return f"op({string(name)}) {argument}"

    def integral(self, body: str, along: str, lower: str, upper: str) -> str:
        return f"attach(∫, b: {lower}, t: {upper}) {body} thin d {along}"

    def bar(self, text: str) -> str:
        return f"overline({text})"

    def underlined(self, text: str, lines: int) -> str:
        return "underline(" * lines + text + ")" * lines

    def under(self, text: str, note: str) -> str:
        return f"attach(limits({text}), b: {note})"

    def formula(self, pieces: list[str]) -> str:
        return _BEFORE_STRING.sub(lambda one: one[1] or "", NEXT.join(pieces))


@cache
def notation(tr: Translator) -> Typst:
    return Typst(tr)
