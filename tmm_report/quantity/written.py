"""Calculations by hand as a note shows them: numbers as they are written down, and what they are called."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import ATOM, POWER, Expr, Formula, Page, Piece, Symbol, Var
from tmm_report.quantity.model import Quantity, Table, plain, text_column, variable
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Notation, notation, segment
from tmm_report.records import dataclass

DIGITS = 5  # significant digits that a hand calculation carries
PLACES = 3  # decimals are not carried beyond these, unless the largest value of the kind needs more


def decimals(size: float, digits: int = DIGITS) -> int:
    """Decimals of a number with so many significant digits."""
    return digits - 1 - math.floor(math.log10(size)) if size > 0 else digits


def hand(quantity: Quantity, expression: Expr, reference: float = 0.0, ref: Ref | None = None) -> Formula:
    """A formula worked by hand from the numbers as printed: five digits, and no more decimals than `reference`,
    the leading value of its kind, needs (at least three)."""
    trial = _worked(quantity, expression, DIGITS, ref)
    size = abs(trial.written)
    most = max(PLACES, decimals(abs(reference)))
    digits = DIGITS - max(0, decimals(size) - most) if size > 0 else DIGITS
    return trial if digits == DIGITS else replace(trial, digits=max(1, digits))


def laid_off(quantity: Quantity, expression: Expr, ref: Ref | None = None) -> Formula:
    """The length of a segment to be laid off, mm, by hand: no finer than a hundredth."""
    trial = _worked(quantity, expression, DIGITS, ref)
    digits = DIGITS - max(0, decimals(abs(trial.written)) - 2)
    return trial if digits == DIGITS else replace(trial, digits=max(1, digits))


def _worked(quantity: Quantity, expression: Expr, digits: int, ref: Ref | None) -> Formula:
    return Formula(
        quantity.sign, expression, quantity.unit, digits, hand=True, ref=ref, meaning=quantity.meaning
    )


SEGMENT = Message(N_("length of a segment on the drawing"))


def segment_of(ends: str) -> Quantity:
    """The length of a drawn segment, mm, named by its ends."""
    return Quantity(ends, segment(ends), "mm", SEGMENT)


class Worked:
    """The numbers of one calculation by hand, each once, by key: what a table of the results lists.

    `table`: its name there; `position`: the table position that is worked.
    """

    def __init__(self, table: str, position: int):
        self.table, self.position = table, position
        self.rows: dict[str, tuple[Quantity, float]] = {}

    def ref(self, key: str) -> Ref:
        return Ref(key, self.position, self.table, by="value")

    def number(self, quantity: Quantity, value: float) -> Var:
        """A number that stands in the calculation with all its written digits."""
        self.rows.setdefault(quantity.key, (quantity, float(value)))
        return variable(quantity, value, digits=DIGITS + 2, ref=self.ref(quantity.key))

    def hand(self, quantity: Quantity, expression: Expr, reference: float = 0.0) -> Formula:
        """`hand`, whose result is kept."""
        return self._kept(quantity, hand(quantity, expression, reference, self.ref(quantity.key)))

    def laid_off(self, quantity: Quantity, expression: Expr) -> Formula:
        """`laid_off`, whose result is kept beside the length that is then read."""
        own = replace(quantity, key=f"laid_{quantity.key}")
        return self._kept(own, laid_off(own, expression, self.ref(own.key)))

    def _kept(self, quantity: Quantity, formula: Formula) -> Formula:
        self.rows.setdefault(quantity.key, (quantity, formula.written))
        return formula


WORKED = N_("numbers worked by hand at position %(k)s")


def worked_table(worked: Worked) -> Table:
    """One row a number: its key finds it."""
    quantities = [quantity for quantity, _ in worked.rows.values()]
    return Table(
        worked.table,
        Message(WORKED, {"k": worked.position}),
        (
            text_column("key", Message(N_("quantity")), list(worked.rows)),
            text_column("unit", Message(N_("its unit")), [quantity.unit for quantity in quantities]),
            plain("value", "", Message(N_("its value")), [value for _, value in worked.rows.values()]),
        ),
    )


@dataclass(frozen=True, eq=False)
class Unknown(Var):
    """An unknown of an equation: a symbol among the numbers."""

    def piece(self, page: Page) -> Piece:
        return Piece(page.notation.symbol(self.sign), POWER if self.sign.raised else ATOM)


@dataclass(frozen=True, eq=False)
class Equation:
    """expression = 0, its numbers put in and its unknowns as symbols; without `numbers` all in symbols."""

    expression: Expr
    numbers: bool = True

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        pieces = list(self.expression.terms(Page(form, numbers=self.numbers)))
        return form.formula([*pieces, form.operator("=") + form.number(0, 1)])


def explained(*formulas: Formula | Equation) -> Iterator[tuple[Symbol, Message, str]]:
    """Symbol, meaning and unit of every quantity of the formulas in their order, of an equation of its unknowns."""
    for formula in formulas:
        if isinstance(formula, Formula) and formula.meaning is not None:
            yield Var(formula.result, 0.0).sign, formula.meaning, formula.unit
        for var in variables(formula.expression):
            if var.meaning is not None and (isinstance(formula, Formula) or isinstance(var, Unknown)):
                yield var.sign, var.meaning, var.unit


def variables(node: Expr) -> Iterator[Var]:
    """The variables of an expression, in their order."""
    if isinstance(node, Var):
        yield node
        return
    for child in vars(node).values():  # a node has no other attributes than its fields, in their order
        if isinstance(child, Expr):
            yield from variables(child)
