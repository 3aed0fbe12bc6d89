"""Formulas of one kind: the first is worked out in full, those like it in symbols, those of later parts are values."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import replace
from typing import NamedTuple

from tmm_report.quantity.formula import Expr, Formula, Negative, Var

_OTHER = {
    "sin": "cos",
    "y": "x",
    "−": "+",
}  # projections on the two axes are alike, sums and differences, too


class Worked(NamedTuple):
    """`lines`: formulas as they are to be printed, in their order; `same`: results of those left out."""

    lines: list[Formula]
    same: list[Var]


class Kinds:
    """The kinds of formulas that a chapter has worked out so far; where it works out `every` one, all are printed.

    Two formulas are of one kind if they differ by their letters alone; they are alike if they differ by signs or by
    the axis on which they project, too.
    """

    def __init__(self, every: bool, left_out: Callable[[Iterable[Formula]], None] = lambda formulas: None):
        """`left_out`: what is done with those that are not printed."""
        self.every, self.left_out = every, left_out
        self._first: dict[Hashable, object] = {}  # the part of the chapter that had the kind first
        self._alike = set[Hashable]()

    def __call__(self, formulas: Iterable[Formula], part: str | None = None) -> Worked:
        """`part`: of the chapter, as a group: what is of one kind within it is printed in symbols; None: nothing is."""
        found = Worked([], [])
        for formula in formulas:
            here = object() if part is None else part
            nought = not formula.written  # what gives nothing is an example of such alone
            same, alike = _kind(formula, False), _kind(formula, True)
            if not self.every and self._known(same, nought, here) != here:
                found.same.append(value_of(formula))
                self.left_out([formula])
            else:
                known = not self.every and alike in self._alike
                found.lines.append(replace(formula, numbers=False) if known else formula)
            self._first.setdefault((same, nought), here)
            if not nought:
                self._alike.add(alike)
        return found

    def _known(self, same: Hashable, nought: bool, here: object) -> object:
        """The part that worked out such a formula first; `here` if none did."""
        return self._first.get((same, False), self._first.get((same, True), here) if nought else here)


def parted(formulas: Iterable[Formula]) -> tuple[list[Formula], list[Formula]]:
    """The first of each kind that is not nought, then the others; what is another's number is none."""
    formulas = list(formulas)
    first: dict[Hashable, Formula] = {}
    for formula in formulas:
        if isinstance(formula.expression, Var):
            continue
        leader = first.setdefault(_kind(formula, False), formula)
        if formula.written and not leader.written:
            first[_kind(formula, False)] = formula
    leading = list(first.values())
    return leading, [one for one in formulas if not any(one is leader for leader in leading)]


def value_of(formula: Formula) -> Var:
    """The result of a formula as it prints it."""
    return Var(formula.result, formula.written, formula.unit, formula.digits, formula.ref, formula.meaning)


def _kind(formula: Formula, alike: bool) -> Hashable:
    return _letter(Var(formula.result, 0.0, formula.unit), alike), _shape(formula.expression, alike)


def _letter(var: Var, alike: bool) -> Hashable:
    """What a quantity is: all segments of a drawing are one, others are told by letter, unit and direction."""
    sign = var.sign
    if sign.kind == "segment":
        return "", var.unit
    return (_OTHER.get(sign.base, sign.base), "", var.unit) if alike else (sign.base, sign.sup, var.unit)


def _shape(node: Expr, alike: bool) -> Hashable:
    """The expression without its letters; `alike`: without signs and axes, too."""
    if isinstance(node, Var):
        return _letter(node, alike)
    if alike and isinstance(node, Negative):
        return _shape(node.body, alike)
    own: list[Hashable] = [type(node).__name__]
    for child in vars(node).values():
        if isinstance(child, Expr):
            own.append(_shape(child, alike))
        elif isinstance(child, str):  # the sign of a sum, the name of a function
            own.append(_OTHER.get(child, child) if alike else child)
        elif not callable(child):
            own.append(child if isinstance(child, Hashable) else id(child))
    return tuple(own)
