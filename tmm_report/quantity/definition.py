"""A formula that defines a quantity, in symbols alone."""

from __future__ import annotations

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Expr, Page, Var
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
