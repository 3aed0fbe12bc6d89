"""Numbers as they are written down by hand in a note, and the symbols of the values' keys."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import ATOM, POWER, Expr, Formula, Page, Piece, Symbol, Var
from tmm_report.quantity.symbols import Latex, MathML, notation, segment

DIGITS = 5  # significant digits that a hand calculation carries
PLACES = 3  # decimals are not carried beyond these, unless the largest value of the kind needs more

BASES = {"w": "omega", "e": "epsilon"}
UNITS = {"v": "m/s", "a": "m/s²", "w": "rad/s", "e": "rad/s²", "S": "m", "R": "N", "F": "N", "M": "N·m"}


@lru_cache(maxsize=4096)
def symbol_of(key: str) -> Symbol:
    """Symbol of a value's key: "v_BA", "a_BA_n", "w_2", "e_2", "R_24_t"."""
    base, sub, sup = (*key.split("_"), "", "")[:3]
    return Symbol(BASES.get(base, base), sub, sup)


def unit_of(key: str) -> str:
    return UNITS[key.removeprefix("Sigma")[0]]


def decimals(size: float, digits: int = DIGITS) -> int:
    """Decimals of a number with so many significant digits."""
    return digits - 1 - math.floor(math.log10(size)) if size > 0 else digits


def hand(key: str, expression: Expr, reference: float) -> Formula:
    """A formula worked by hand from the numbers as printed: five digits, and no more decimals than `reference`,
    the leading value of its kind, needs (at least three)."""
    trial = Formula(symbol_of(key), expression, unit_of(key), hand=True)
    size = abs(trial.written)
    most = max(PLACES, decimals(abs(reference)))
    digits = DIGITS - max(0, decimals(size) - most) if size > 0 else DIGITS
    return trial if digits == DIGITS else replace(trial, digits=max(1, digits))


def laid_off(ends: str, expression: Expr) -> Formula:
    """The length of a segment to be laid off, mm, by hand: no finer than a hundredth."""
    trial = Formula(segment(ends), expression, "mm", hand=True)
    digits = DIGITS - max(0, decimals(abs(trial.written)) - 2)
    return trial if digits == DIGITS else replace(trial, digits=max(1, digits))


def number(symbol: Symbol | str, value: float, unit: str = "") -> Var:
    """A number that stands in a hand calculation with all its written digits."""
    return Var(symbol, value, unit, digits=DIGITS + 2)


def length_of(ends: str, millimetres: float) -> Var:
    """A segment of a drawing, mm, as read."""
    return Var(segment(ends), millimetres, "mm", digits=DIGITS + 2)


def reaction_key(by: str, on: str) -> str:
    """ "R_12": force of link 1 on link 2; longer names are told apart by a comma."""
    return f"R_{by}{on}" if len(by) == len(on) == 1 else f"R_{by},{on}"


def load_keys(points: Sequence[str]) -> list[str]:
    """Symbols of stated forces: P_B; several at one point are numbered, P_B1, P_B2."""
    return [
        f"P_{p}" if points.count(p) == 1 else f"P_{p},{1 + points[:k].count(p)}" for k, p in enumerate(points)
    ]


@dataclass(frozen=True, eq=False)
class Unknown(Var):
    """An unknown of an equation: a symbol among the numbers."""

    def piece(self, page: Page) -> Piece:
        return Piece(page.notation.symbol(self.sign), POWER if self.sign.sup else ATOM)


@dataclass(frozen=True, eq=False)
class Equation:
    """expression = 0, its numbers put in and its unknowns as symbols; without `numbers` all in symbols."""

    expression: Expr
    numbers: bool = True

    def latex(self, tr: Translator) -> str:
        return self._print(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self._print(notation("mathml", tr))

    def _print(self, form: Latex | MathML) -> str:
        pieces = list(self.expression.terms(Page(form, numbers=self.numbers)))
        return form.formula([*pieces, form.operator("=") + form.number(0, 1)])
