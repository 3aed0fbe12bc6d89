"""Formulas in symbols alone: of a quantity that they define, or one for several things of a kind, whose numbers stand
in a table."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, replace

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Expr, Formula, Page, Var
from tmm_report.quantity.symbols import Latex, MathML, Symbol, notation
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Definition:
    """`result` = expression, in symbols only."""

    result: Symbol | str
    expression: Expr

    def latex(self, tr: Translator) -> str:
        return self._print(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self._print(notation("mathml", tr))

    def _print(self, form: Latex | MathML) -> str:
        first, *rest = self.expression.terms(Page(form, numbers=False))
        return form.formula([form.symbol(Var(self.result, 0.0).sign) + form.operator("=") + first, *rest])


def in_letters(formula: Formula, called: Mapping[Symbol, Symbol]) -> Definition:
    """`called`: what its letters are called here, d_4 is d_i."""
    return _as_called(formula, lambda sign: called.get(sign, sign))


def _as_called(formula: Formula, name: Callable[[Symbol], Symbol]) -> Definition:
    return Definition(name(Var(formula.result, 0.0).sign), _renamed(formula.expression, name))


def _renamed(expression: Expr, name: Callable[[Symbol], Symbol]) -> Expr:
    if isinstance(expression, Var):
        return replace(expression, symbol=name(expression.sign))
    inner = {
        field.name: _renamed(part, name)
        for field in fields(expression)
        if isinstance(part := getattr(expression, field.name), Expr)
    }
    return replace(expression, **inner) if inner else expression


def of_all(formulas: Iterable[tuple[Formula, Mapping[Symbol, Symbol]]], tr: Translator) -> list[Definition]:
    """One for all of them where it is the same in letters, or that of each, as it is called itself."""
    formulas = list(formulas)
    alike = {one.mathml(tr): one for one in (in_letters(*one) for one in formulas)}
    return [*alike.values()] if len(alike) < 2 else [in_letters(one, {}) for one, _ in formulas]


def parted(formulas: Iterable[Formula], tr: Translator) -> tuple[list[Formula], list[Formula]]:
    """The first of each kind, then the others: formulas are of one kind that differ by indices and numbers alone; what
    is another's number is none."""
    first: dict[str, Formula] = {}
    others = []
    for formula in formulas:
        shape = _as_called(formula, lambda sign: Symbol(sign.base)).mathml(tr)
        if shape in first or isinstance(formula.expression, Var):
            others.append(formula)
        else:
            first[shape] = formula
    return list(first.values()), others
