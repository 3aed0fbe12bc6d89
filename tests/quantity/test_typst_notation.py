"""Formulas in Typst say what those in MathML say: each is read back, sign by sign."""

from __future__ import annotations

import re

import pytest
from conftest import ALL_FILES
from heard_formulas import formulas_of
from hypothesis import given
from hypothesis import strategies as st
from typst_read import of_mathml, of_typst

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Formula, Term, Var, VectorEquation, sin, sqrt
from tmm_report.quantity.notations.typst import NEXT, notation
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.symbols import notation as other

RU = Translator("ru")


@pytest.mark.parametrize("name", sorted(path.stem for path in ALL_FILES))
def test_every_formula_of_a_note_says_the_same(name):
    items, tr = formulas_of(name)
    for item in items:
        assert of_typst(typst(item, tr)) == of_mathml(item.printed(other("mathml", tr)))
    assert items


def typst(item, tr=RU):
    return item.printed(notation(tr)).replace(NEXT, "")


def test_a_formula_as_it_is_written():
    length, rate = Var("l_AB", 0.3, "m"), Var("omega_2", -36.791, "rad/s")
    item = Formula(math_symbol("a_BA^n"), rate**2 * length, "m/s²")
    pieces = item.printed(notation(RU)).split(NEXT)
    assert pieces[0] == 'attach(a , b: B A , t: n )= attach(ω , b:"2", t:"2")⋅ attach(l , b: A B )'
    assert pieces[1] == '= attach(lr(\\( −"36,791"\\)), t:"2")⋅"0,3"'
    assert pieces[2] == '="406,07"thin"м/с²"'


def test_vectors_have_their_bars_lines_and_directions():
    item = VectorEquation([[Term("v_B")], [Term("v_A", 2), Term("v_BA", 1, "⟂ AB")]])
    last = item.printed(notation(RU)).split(NEXT)[-1]
    assert last == '+ attach(limits(underline(attach(overline(v ), b: B A ))), b:"⟂"A B )'


def test_the_reader_sees_what_is_wrong():
    """Of faults that could be made: a product, a sign, an index, a bracket lost."""
    tr, item = (
        RU,
        Formula("M", Var("F", 2.0) * Var("h", 0.5) - sqrt(Var("x", 4.0)) * sin(Var("phi", 0.1, "deg"))),
    )
    said, meant = typst(item), of_mathml(item.printed(other("mathml", tr)))
    assert of_typst(said) == meant
    for old, new in (("⋅", ""), ("−", "+ "), ("sqrt", "overline"), ('"2"', '"3"')):
        assert old in said and of_typst(said.replace(old, new)) != meant


@given(st.text(min_size=1), st.text(), st.text())
def test_no_name_breaks_out(base, sub, sup):
    text = typst(Symbol(base, sub, sup))
    of_typst(text)  # every bracket is closed
    bare = re.sub(r'"(?:[^"\\]|\\.)*"', "", text)
    assert "$" not in text and "#" not in bare


@pytest.mark.parametrize(
    "name", ['"', "\\", "$", '\\"', '");#(', '","', "_^&", "\\u{41}".replace("u", "9"), "(", ") \\("]
)
def test_signs_of_a_name_are_signs(name):
    ((_, base, below, _),) = of_typst(typst(Symbol("v", name)))
    assert base == ("v",) and "".join(below) == name
