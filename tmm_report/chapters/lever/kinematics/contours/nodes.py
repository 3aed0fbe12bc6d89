"""Nodes of formulas that only the contours need: an angle by its quadrant, a root by its sign, two sides."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmm_report.i18n import NP_, Translator
from tmm_report.quantity.formula import ATOM, SUM, Expr, Number, Page, Piece, Value, at
from tmm_report.quantity.functions import Degrees
from tmm_report.quantity.symbols import Notation, notation
from tmm_report.records import dataclass

Signed = tuple[int, Expr | None]  # ±1 and a term; None where it is zero


def total(terms: Sequence[Signed]) -> Expr:
    """The sum of the terms that are there; 0 of none."""
    there = [(sign, term) for sign, term in terms if term is not None]
    if not there:
        return Number(0)
    # a sum rather begins without a minus
    there.insert(0, there.pop(next((k for k, (sign, _) in enumerate(there) if sign > 0), 0)))
    (sign, first), *rest = there
    found = first if sign > 0 else -first
    for sign, term in rest:
        found = found + term if sign > 0 else found - term
    return found


def times(*factors: Expr | None) -> Expr | None:
    """The product; None where a factor is zero."""
    found: Expr | None = None
    for factor in factors:
        if factor is None:
            return None
        found = factor if found is None else found * factor
    return found


@dataclass(frozen=True, eq=False)
class Bearing(Expr):
    """The angle from the x axis of a vector by its projections, within ±180°: printed by the arctangent that is fit for
    its quadrant in the printed position."""

    y: Expr
    x: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return np.arctan2(self.y.evaluate(digits), self.x.evaluate(digits))

    def piece(self, page: Page) -> Piece:
        with np.errstate(invalid="ignore", divide="ignore"):
            x, y = at(self.x.value, page.index), at(self.y.value, page.index)
        if abs(x) >= abs(y):
            angle = _arctangent(self.y, self.x, page)
            if x > 0 or y == 0 == x:
                return angle
            return _added(angle, "+" if y >= 0 else "−", np.pi, page)
        right = Degrees(np.pi / 2 if y > 0 else -np.pi / 2).piece(page)
        text = right.text + page.notation.operator("−") + _arctangent(self.x, self.y, page).text
        return Piece(text, SUM)


def _arctangent(above: Expr, below: Expr, page: Page) -> Piece:
    ratio = page.notation.brackets((above / below).piece(page).text)
    return Piece(page.notation.function(page.notation.tr.pgettext("function", ARCTAN), ratio), ATOM)


def _added(piece: Piece, sign: str, angle: float, page: Page) -> Piece:
    return Piece(piece.text + page.notation.operator(sign) + Degrees(angle).piece(page).text, SUM)


ARCTAN = NP_("function", "arctan")


@dataclass(frozen=True, eq=False)
class Branched(Expr):
    """left ± right, the sign (a number or (P,)) being that of the stated assembly; `left` None: ± right alone."""

    left: Expr | None
    right: Expr
    sign: Value

    def evaluate(self, digits: int | None = None) -> Value:
        left = 0.0 if self.left is None else self.left.evaluate(digits)
        return left + self.sign * self.right.evaluate(digits)

    def piece(self, page: Page) -> Piece:
        return self._taken(page).piece(page)

    def terms(self, page: Page):  # type: ignore[no-untyped-def]
        return self._taken(page).terms(page)

    def _taken(self, page: Page) -> Expr:
        """The sum with the sign of the printed position."""
        ahead = at(self.sign, page.index) > 0
        if self.left is None:
            return self.right if ahead else -self.right
        return self.left + self.right if ahead else self.left - self.right


@dataclass(frozen=True, eq=False)
class Sides:
    """left = right, in symbols."""

    left: Expr
    right: Expr
    index: int | None = None

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        page = Page(form, numbers=False, index=self.index)
        first, *rest = self.right.terms(page)
        return form.formula([*self.left.terms(page), form.operator("=") + first, *rest])
