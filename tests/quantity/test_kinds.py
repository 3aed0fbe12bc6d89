"""One formula of each kind in full: what is alike stands in symbols, what is the same by its value, nothing is lost."""

from __future__ import annotations

import re

import pytest
from conftest import solved

from tmm_report import render
from tmm_report.chapters.lever.kinematics.contours.solve import contours
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Formula, Negative, Var, cos, sin
from tmm_report.quantity.terms.kinds import Kinds, value_of

L, PHI, W = Var("l_AB", 0.3, "m"), Var("phi_2", 0.5, "deg"), Var("omega_2", 2.0, "rad/s")
X = Formula("x_B", L * cos(PHI), "m")
Y = Formula("y_B", L * sin(PHI), "m")
V = Formula("v_B", W * L, "m/s")


def of(formula: Formula, *names: str) -> Formula:
    """The formula with other letters and numbers."""
    units = ("m", "deg", "rad/s")
    a, b, c = (Var(name, 0.1 * k, unit) for k, (name, unit) in enumerate(zip(names, units, strict=True), 1))
    made = {"x_B": a * cos(b), "y_B": a * sin(b), "v_B": c * a}[str(formula.result)]
    return Formula(f"{str(formula.result)[0]}_D", made, formula.unit)


def test_of_one_kind_in_two_parts_the_second_is_its_value():
    kinds = Kinds(False)
    assert kinds([X, V], "2-3") == ([X, V], [])
    again = [of(X, "l_CD", "phi_4", "omega_4"), of(V, "l_CD", "phi_4", "omega_4")]
    lines, same = kinds(again, "4-5")
    assert not lines
    assert [one.number for one in same] == [formula.written for formula in again]
    assert [str(one.symbol) for one in same] == ["x_D", "v_D"]


def test_within_a_part_it_stands_in_symbols_without_numbers():
    kinds = Kinds(False)
    first, second = kinds([V, of(V, "l_CD", "phi_4", "omega_4")], "2-3").lines
    assert first is V and not second.numbers
    equal = '<mo form="infix">=</mo>'
    assert V.mathml(Translator("en")).count(equal) == 3  # symbols, numbers, value
    assert second.mathml(Translator("en")).count(equal) == 2 and "0.03" in second.mathml(Translator("en"))


def test_the_other_axis_and_another_sign_are_alike_but_not_the_same():
    kinds = Kinds(False)
    back = Formula("x_C", Negative(L * cos(PHI)), "m")
    lines = kinds([X, Y, back], "2-3").lines
    assert [one.numbers for one in lines] == [True, False, False]
    lines, same = kinds([of(Y, "l_CD", "phi_4", "omega_4")], "4-5")
    assert not lines and len(same) == 1


@pytest.mark.parametrize(
    "other",
    [
        Formula("x_D", L + cos(PHI), "m"),  # another operation
        Formula("x_D", L * cos(PHI) * cos(PHI), "m"),
        Formula("x_D", L / cos(PHI), "m"),
        Formula("h_D", L * cos(PHI), "m"),  # another quantity
        Formula("x_D", W * cos(PHI), "m"),
    ],
)
def test_what_is_found_otherwise_is_worked_out(other):
    kinds = Kinds(False)
    kinds([X], "2-3")
    assert kinds([other], "4-5") == ([other], [])


def test_a_note_that_says_all_leaves_nothing_out():
    kinds = Kinds(True)
    for part in ("2-3", "4-5"):
        assert kinds([X, Y, X], part) == ([X, Y, X], [])


@pytest.mark.parametrize("name", ["compressor", "shaper"])
def test_every_number_of_the_contours_is_printed_at_any_depth(name):
    results = solved(name)
    written = contours(results.lever.kinematics, results.lever.sample)
    formulas = [
        formula
        for group in written.groups
        for part in ("positions", "velocities", "accelerations")
        for formula in getattr(group, part, ())
        if formula.ref is not None and formula.ref.table == "contours"
    ]
    assert len(formulas) > 10
    k = results.lever.sample
    for depth in ("course", "full"):
        text = render(results, "html", "en", depth)["note.html"].decode()
        marked = set(re.findall(rf'data-q="([^"]+)" data-k="{k}" data-t="contours"', text))
        assert {value_of(formula).ref.key for formula in formulas} <= marked


def test_a_shorter_note_works_out_fewer():
    results = solved("compressor")
    course, full = (
        render(results, "html", "en", depth)["note.html"].count(b"<math") for depth in ("course", "full")
    )
    assert course < full
