"""Functions of formulas that only some chapters need, and exact angles."""

from __future__ import annotations

import math

import numpy as np

from tmm_report.i18n import NP_
from tmm_report.quantity.formula import PRODUCT, SUM, Expr, Function, Page, Piece, Value, Var
from tmm_report.records import dataclass


def arcsin(x: Expr) -> Expr:
    return Function("arcsin", x, np.arcsin)


def arctan(x: Expr) -> Expr:
    return Function(NP_("function", "arctan"), x, np.arctan)


def exp(x: Expr) -> Expr:
    return Function(NP_("function", "exp"), x, np.exp)


@dataclass(frozen=True, eq=False)
class Degrees(Expr):
    """An exact angle of the formula itself, rad, printed in degrees: the 360° of φ/360°."""

    angle: float

    def evaluate(self, digits: int | None = None) -> Value:
        return self.angle

    def piece(self, page: Page) -> Piece:
        return page.number(self.angle, 10, degrees=True, scale=0.0)


@dataclass(frozen=True, eq=False)
class Integral(Expr):
    """∫ body d(along) from `lower` to `upper`, for an equation in symbols; `number`: its value, found elsewhere."""

    body: Expr
    along: Var
    lower: Expr
    upper: Expr
    number: Value = np.nan

    def evaluate(self, digits: int | None = None) -> Value:
        return self.number

    def piece(self, page: Page) -> Piece:
        lower, upper, along = (one.piece(page).text for one in (self.lower, self.upper, self.along))
        body = page.bracket(self.body.piece(page), SUM)
        return Piece(page.notation.integral(body, along, lower, upper), PRODUCT)


FULL, HALF, RIGHT = Degrees(2 * math.pi), Degrees(math.pi), Degrees(math.pi / 2)
