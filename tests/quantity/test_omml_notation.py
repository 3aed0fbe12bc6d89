"""Formulas in Office Math say what those in MathML say: each is read back, sign by sign, whole and in its lines."""

from __future__ import annotations

import re
from contextlib import suppress

import pytest
from conftest import ALL_FILES
from heard_formulas import formulas_of
from hypothesis import given
from hypothesis import strategies as st
from omml_read import of_omml
from typst_read import of_mathml

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Formula, Term, Var, VectorEquation, sin, sqrt
from tmm_report.quantity.notations.omml import NEXT, notation
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.symbols import notation as other
from tmm_report.report.paper import measure
from tmm_report.report.paper.office_math import broken, in_line, wide

RU = Translator("ru")
SIGNS = "=+−≤≥≈<>≪≫"


def omml(item, tr=RU):
    return item.printed(notation(tr))


def mathml(item, tr=RU):
    return item.printed(other("mathml", tr))


@pytest.mark.parametrize("name", sorted(path.stem for path in ALL_FILES))
def test_every_formula_of_a_note_says_the_same(name):
    """In a sentence, and displayed on lines: what stands at the end of one stands at the beginning of the next."""
    items, tr = formulas_of(name)
    for item in items:
        text, meant = omml(item, tr), of_mathml(mathml(item, tr))
        assert of_omml(in_line(text)) == meant
        for lines in {tuple(broken(text, line)) for line in (200.0, 34.0, 12.0)}:  # many are the same
            assert rejoined(lines) == crossless(meant)
    assert items


def rejoined(lines):
    """The lines as one formula: the sign at the end of each begins the next, too."""
    whole = of_omml(lines[0])
    for line in lines[1:]:
        row = of_omml(line)
        assert whole[-1] == row[0] and row[0] in (*SIGNS, "×")
        whole += row[1:]
    return crossless(whole)


def crossless(tree):
    """A product that is broken has a cross for its dot."""
    return tuple("·" if part == "×" else part for part in tree)


@pytest.mark.parametrize("name", ["compressor", "hoist_drive", "cam_press"])
def test_it_is_as_wide_as_the_same_formula_of_the_other_notes(name):
    """Tables are divided and lines broken by that: a tenth more or less, and an em. A fraction within a fraction is as
    large as the other in LibreOffice."""
    items, tr = formulas_of(name)
    for item in items:
        if re.search("<mfrac>(?:(?!</mfrac>).)*<mfrac>", mathml(item, tr)):
            continue
        there = sum(map(measure.mathematics, mathml(item, tr).split("<wbr/>")))
        assert wide(omml(item, tr)) == pytest.approx(there, rel=0.12, abs=1.0)


@pytest.mark.parametrize("name", ["compressor", "hoist_drive"])
def test_no_line_is_longer_than_its_room_but_one_that_cannot_be_cut(name):
    items, tr = formulas_of(name)  # the sign that is repeated takes two ems and a half
    over = [line for item in items for line in broken(omml(item, tr), 16.0) if wide_of(line) > 18.5]
    assert not [line for line in over if factors(line)]


def wide_of(line):
    return wide(line.removeprefix("<m:oMath>").removesuffix("</m:oMath>"))


def factors(line):
    """At how many places a line could be cut: at its signs and products outside all brackets."""
    row = of_omml(line)
    depth, places = 0, 0
    for k, one in enumerate(row[:-1]):  # behind a relation stands the sign of its first term
        depth += {"(": 1, ")": -1, "[": 1, "]": -1}.get(one, 0) if isinstance(one, str) else 0
        places += k > 1 and depth == 0 and one in (*SIGNS, "·", "×")
    return places


def test_a_formula_as_it_is_written():
    length, rate = Var("l_AB", 0.3, "m"), Var("omega_2", -36.791, "rad/s")
    item = Formula(math_symbol("a_BA^n"), rate**2 * length, "m/s²")
    pieces = omml(item).split(NEXT)
    text = re.sub(' xml:space="preserve"', "", pieces[1])
    assert "".join(of_omml(pieces[2])) == "=406,07м/с²"
    assert text == (
        '<m:r><m:t>=</m:t></m:r><m:sSup><m:e><m:d><m:dPr><m:begChr m:val="("/><m:endChr m:val=")"/></m:dPr><m:e>'
        "<m:r><m:t>−</m:t></m:r><m:r><m:t>36,791</m:t></m:r></m:e></m:d></m:e><m:sup><m:r><m:t>2</m:t></m:r></m:sup>"
        "</m:sSup><m:r><m:t>·</m:t></m:r><m:r><m:t>0,3</m:t></m:r>"
    )


def test_vectors_have_their_bars_lines_and_directions():
    item = VectorEquation([[Term("v_B")], [Term("v_A", 2), Term("v_BA", 1, "⟂ AB")]])
    last = of_omml(omml(item).split(NEXT)[-1])
    assert last == (
        "+",
        ("script", (("line", (("script", (("bar", ("v",)),), ("B", "A"), ()),)),), ("⟂", "A", "B"), ()),
    )
    assert omml(item).count('val="bot"') == 3  # two lines of what is known whole, one of the other


def test_words_of_indices_are_upright_letters_lean():
    text = omml(math_symbol("M_bal"))
    assert '<m:nor/></m:rPr><m:t xml:space="preserve">ур</m:t>' in text
    assert '<m:r><m:t xml:space="preserve">M</m:t>' in text


def test_the_reader_sees_what_is_wrong():
    """Of faults that could be made: a product, a sign, a root, an index lost."""
    item = Formula("M", Var("F", 2.0) * Var("h", 0.5) - sqrt(Var("x", 4.0)) * sin(Var("phi", 0.1, "deg")))
    said, meant = omml(item).replace(NEXT, ""), of_mathml(mathml(item))
    assert of_omml(said) == meant
    for old, new in (("·", ""), ("−", "+"), (' m:val="1"', ' m:val="0"'), (">0,5<", ">0.5<")):
        assert old in said
        with suppress(ValueError):
            assert of_omml(said.replace(old, new)) != meant


def test_a_line_that_ends_with_a_sign_is_not_without_a_term():
    """LibreOffice would show an error there."""
    item = Formula("M", Var("F_1", 2.0) * Var("h_1", 0.5) + Var("F_2", 2.0) * Var("h_2", 0.5))
    lines = broken(omml(item), 8.0)
    assert len(lines) > 2
    for line in lines[:-1]:
        assert re.search(
            '>[=+×]</m:t></m:r><m:r><m:t xml:space="preserve">\u200b</m:t></m:r></m:oMath>$', line
        )


@given(st.text(min_size=1), st.text(), st.text())
def test_no_name_breaks_out(base, sub, sup):
    of_omml(omml(Symbol(base, sub, sup)))


@pytest.mark.parametrize("name", ['"', "<", "&", "</m:t>", "<m:r/>", "]]>", "\\", "&lt;", "(", "_^&"])
def test_signs_of_a_name_are_signs(name):
    ((_, base, below, _),) = of_omml(omml(Symbol("v", name)))
    assert base == ("v",) and "".join(below) == name
