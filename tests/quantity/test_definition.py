"""Formulas in letters: one for several things of a kind, and the first of each kind."""

import pytest

from tmm_report.i18n import Translator
from tmm_report.quantity.definition import in_letters, of_all
from tmm_report.quantity.formula import Expr, Formula, Var, sin, sqrt
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.terms.kinds import parted

TR = Translator("en")


def diameter(wheel: str, teeth: float, taken: bool = False) -> Formula:
    m, z = Var("m", 5.0, "mm"), Var(f"z_{wheel}", teeth)
    expression: Expr = m * (z - 2) if taken else m * (z + 2)
    return Formula(f"d_{wheel}", expression, "mm")


def called(wheel: str) -> dict[Symbol, Symbol]:
    return {math_symbol(f"{letter}_{wheel}"): math_symbol(f"{letter}_i") for letter in "dz"}


def test_letters_are_those_of_a_thing_of_the_kind_and_the_value_stays():
    (found,) = of_all([(diameter("4", 14.0), called("4")), (diameter("5", 28.0), called("5"))], TR)
    text = found.latex(TR).replace(" ", "")
    assert text == r"d_{i}=m\cdot\left(z_{i}+2\right)"
    assert in_letters(diameter("5", 28.0), called("5")).expression.evaluate() == 5 * 30


def test_unlike_things_keep_their_formulas_each_by_its_own_name():
    found = of_all([(diameter("4", 14.0), called("4")), (diameter("5", 28.0, taken=True), called("5"))], TR)
    assert [one.latex(TR).replace(" ", "")[:7] for one in found] == ["d_{4}=m", "d_{5}=m"]
    assert of_all([], TR) == []


@pytest.mark.parametrize("wrap", [lambda x: x, sqrt, lambda x: -x, lambda x: sin(x) ** 2, abs])
def test_letters_are_found_wherever_they_stand(wrap):
    formula = Formula("d_4", wrap(Var("z_4", 14.0) / (Var("z_4", 14.0) + 1)))
    text = in_letters(formula, called("4")).latex(TR)
    assert "4" not in text and text.count("z_{i}") == 2


def test_the_first_of_each_kind_and_what_is_no_other_formula():
    one, other, taken = diameter("4", 14.0), diameter("5", 28.0), diameter("6", 28.0, taken=True)
    same = Formula("d_7", Var("d_4", 80.0), "mm")
    assert parted([one, other, same, taken]) == ([one, taken], [other, same])


def test_what_is_nought_does_not_stand_for_its_kind():
    nought, nothing, one, other = (
        diameter(i, z) for i, z in zip("4567", (-2.0, -2.0, 28.0, 14.0), strict=True)
    )
    assert parted([nought, one, other, nothing]) == ([one], [nought, other, nothing])
    assert parted([nought, nothing]) == ([nought], [nothing])
