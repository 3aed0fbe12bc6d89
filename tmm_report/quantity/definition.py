"""Formulas in symbols alone: of a quantity that they define, or one for several things of a kind, whose numbers stand
in a table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields, replace

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Expr, Formula, Page, Var
from tmm_report.quantity.symbols import Notation, Symbol, notation
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Definition:
    """`result` = expression, in symbols only."""

    result: Symbol | str
    expression: Expr

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        first, *rest = self.expression.terms(Page(form, numbers=False))
        return form.formula([form.symbol(Var(self.result, 0.0).sign) + form.operator("=") + first, *rest])


def in_letters(formula: Formula, called: Mapping[Symbol, Symbol]) -> Definition:
    """`called`: what its letters are called here, d_4 is d_i."""
    sign = Var(formula.result, 0.0).sign
    return Definition(called.get(sign, sign), _renamed(formula.expression, called))


def _renamed(expression: Expr, called: Mapping[Symbol, Symbol]) -> Expr:
    if isinstance(expression, Var):
        return replace(expression, symbol=called.get(expression.sign, expression.sign))
    inner = {
        field.name: _renamed(part, called)
        for field in fields(expression)
        if isinstance(part := getattr(expression, field.name), Expr)
    }
    return replace(expression, **inner) if inner else expression


def of_all(formulas: Iterable[tuple[Formula, Mapping[Symbol, Symbol]]], tr: Translator) -> list[Definition]:
    """One for all of them where it is the same in letters, or that of each, as it is called itself."""
    formulas = list(formulas)
    alike = {one.mathml(tr): one for one in (in_letters(*one) for one in formulas)}
    return [*alike.values()] if len(alike) < 2 else [in_letters(one, {}) for one, _ in formulas]
