"""The dimensions of both wheels, which the note lists, worked out again from letters that it prints once for both."""

from dataclasses import fields, replace
from functools import cache

import pytest

from tmm_report import solve
from tmm_report.chapters.gears.spur.values import Wheel
from tmm_report.chapters.gears.spur.view.pair import SpurView
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.quantity.formula import Expr, Var
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

PAIRS = {
    "outer": "{kind: spur, ratio: -2, module: 6 mm, centre_distance: 130 mm, shift: rule}",
    "helical": "{kind: spur, ratio: -2.278, teeth: [18, 41], module: 3 mm, helix: 12 deg, shift: [0.2, 0.1]}",
    "inner": "{kind: spur, ratio: 2.5, module: 4 mm, teeth: [24, 60], shift: [0.3, 0.5]}",
}


@cache
def view(name: str) -> SpurView:
    found = solve(loads(f"drive: {{speed: 3000 rpm, stages: [{PAIRS[name]}]}}"))
    (stage,) = found.drive.stages
    return SpurView(stage, Page(Html(), Translator("en"), Numbering()), "stage1")


def named(sign: Symbol, index: str) -> Symbol:
    return replace(sign, sub=sign.sub + index)


def of_wheel(of: SpurView, i: int) -> dict[Symbol, tuple[str, float]]:
    """By its letter each number of wheel i, of its mate k, and of both by their own names: its key, as formulas have
    it."""
    found = {}
    for wheel, indices in ((i, ("i", of.names[i])), (1 - i, ("k", of.names[1 - i]))):
        for key, declared in Wheel.DECLARED.items():
            if declared.symbol and key in of.wheels[wheel]:
                number = of.wheels[wheel].var(key).number
                found |= {named(declared.symbol, index): (key, number) for index in indices}
    return found


def put(expression: Expr, numbers: dict[Symbol, tuple[str, float]]) -> Expr:
    """The expression with other numbers for the letters that it shows."""
    if isinstance(expression, Var):
        return replace(expression, number=numbers.get(expression.sign, ("", expression.number))[1])
    inner = {
        f.name: put(part, numbers)
        for f in fields(expression)
        if isinstance(part := getattr(expression, f.name), Expr)
    }
    return replace(expression, **inner) if inner else expression


@pytest.mark.parametrize("name", PAIRS)
def test_the_letters_give_the_numbers_of_both_wheels(name):
    of, seen = view(name), set()
    for one in of.letters():
        for i in (0, 1):
            numbers = of_wheel(of, i)
            if one.result.sub.endswith(of.names[1 - i]) and not one.result.sub.endswith("i"):
                continue  # that of the mate, by its own name
            key, number = numbers[one.result]
            assert put(one.expression, numbers).evaluate() == pytest.approx(number, rel=1e-6), (key, i)
            seen.add((key, i))
    assert {key for key, _ in seen} >= {"d", "d_b", "d_w", "d_f", "d_a", "s", "s_w", "s_a", "rho_a", "rho_p"}
    assert sum(1 for key, i in seen if (key, 1 - i) in seen) >= 20


@pytest.mark.parametrize("name", PAIRS)
def test_wheels_that_are_alike_have_one_formula(name):
    found = view(name).letters()
    shared = [one for one in found if one.result.sub.endswith("i")]
    assert (len(shared) == len(found)) == (name != "inner") and len(shared) > 4
