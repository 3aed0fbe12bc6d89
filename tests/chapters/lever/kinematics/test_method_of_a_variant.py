"""`method:`, `accuracy:`, `methods:` of a variant: another way to the motion, and the chapter that compares them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import read, solved, stating
from typer.testing import CliRunner

from tmm_report.chapters.lever.kinematics.given import AUTO, Way
from tmm_report.chapters.lever.methods.given import Comparison
from tmm_report.chapters.lever.methods.quantities import tables
from tmm_report.chapters.lever.methods.view import MethodsView
from tmm_report.cli import app
from tmm_report.commands.files import render
from tmm_report.course import Variant, solve, solve_lever
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.mechanics.rivals import cost
from tmm_report.mechanics.rivals.choice import ACCURACY, FLOOR, table_of
from tmm_report.mechanics.rivals.motion.every import motion_method
from tmm_report.mechanics.rivals.trials import SAME, worst
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell
from tmm_report.report.words import method_name
from tmm_report.stack import solve_many

SMALL = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [200 mm, 20 mm]}
  links:
    1: {points: {O: 0, A: 60 mm}, inertia: 0.004}
    2: {points: {A: 0, B: 180 mm, S2: 100 mm}, mass: 2.4, mass_centre: S2, inertia: 0.012}
    3: {points: {C: 0, B: 120 mm}, inertia: 0.006}
  driver: {link: 1, speed: 180 rpm, zero: {angle: 0 deg}}
  assembly: {B: left of A-C}
loads: {gravity: 9.81}
"""


def small(*lines: str) -> Variant:
    return loads(SMALL + "\n".join(lines) + "\n")


def by(method: str, accuracy: float | None = None):
    """Of the small mechanism."""
    return solve_lever(replace(small().lever, way=Way(method, accuracy)))


def off(one, other) -> float:
    """Largest difference of the rates at the table positions, by the largest of each."""
    own, exact = one.kinematics.values, other.kinematics.values
    return max(
        float(np.max(np.abs(own[key] - exact[key])) / np.max(np.abs(exact[key])))
        for key in exact
        if np.max(np.abs(exact[key])) > 1e-9
    )


# --- the keys


def test_left_out_nothing_is_chosen_and_nothing_compared():
    lever = small().lever
    assert (lever.way, lever.methods, lever.accuracy) == (None, None, None)
    assert solve(small()).lever.kinematics.choice is None and solve(small()).lever.methods is None


@pytest.mark.parametrize(
    ("written", "key"),
    [("closed form", "groups"), ("groups", "groups"), ("root finder", "root_finder"), ("root_finder", "root_finder"),
     ("drawing 0.1", "drawing_0.1"), ("auto", AUTO), ("AUTO", AUTO), ("Newton", "newton"),
     ("constraints dop853", "constraints_dop853")],
)  # fmt: skip
def test_a_method_is_named_with_blanks_or_as_in_the_results(written, key):
    assert small(f"method: {written}", "accuracy: 1e-5").lever.way == Way(key, 1e-5)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("method: newtom", "newtom is no method; did you mean newton?"),
        ("method: 3", "3 is no method; known: closed form, newton,"),
        ("accuracy: 0", "accuracy"),
        ("accuracy: 1", "1e-12 … 0.5"),
        ("accuracy: 1e-13", "1e-12 … 0.5"),  # two ways in double precision tell no more
        ("method: [newton]", "[…] is no method"),
        ("accuracy: 1 mm", "accuracy"),
        ("methods: newton", "newton is neither true nor false"),
    ],
)
def test_a_wrong_value_is_told_with_what_would_be_right(line, said):
    with pytest.raises(ProblemError) as error:
        small(line)
    (problem,) = error.value.problems
    assert said in problem.text() and problem.line == SMALL.count("\n") + 1


@pytest.mark.parametrize("line", ["method: newton", "accuracy: 1e-6", "methods: true"])
def test_the_keys_belong_to_a_lever_mechanism(line):
    rotor = render(solved("rotor"), "json")  # it has no lever mechanism, and solves
    assert rotor
    text = "rotor: {}\n"
    with pytest.raises(ProblemError, match="there is no lever mechanism"):
        loads(text + line + "\n")


def test_a_method_that_cannot_be_used_is_refused_with_the_reason():
    trammel = stating(read("elliptic_trammel"), way=Way("fourier"))
    with pytest.raises(ProblemError, match="cannot be used here: the driving link swings") as error:
        solve(trammel)
    assert error.value.problems[0].path == ("method",)


# --- the motion by another method


@pytest.mark.parametrize("method", ["newton", "root_finder", "constraints_corrected"])
def test_exact_methods_find_what_the_closed_form_finds(method):
    assert off(by(method), by("groups")) < 1e-8


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["shaper", "quick_return"])
def test_the_chapters_after_it_take_another_motion_as_their_own(name):
    """Guides that move, a group of class III, friction corrected: all of the note goes on from there."""
    other, own = solve(stating(read(name), way=Way("newton"), readings={})), solved(name)
    assert other.lever.kinetostatics.agrees
    low, high = (one.lever.kinetostatics.table.balancing for one in (other, own))
    assert np.max(np.abs(low - high)) < 1e-9 * np.max(np.abs(high))
    assert render(other, "html")


def test_the_closed_form_named_is_the_closed_form():
    named, left_out = by("groups"), solve_lever(small().lever)
    assert off(named, left_out) == 0.0 and named.kinematics.tolerance == 1e-9
    assert np.array_equal(named.kinetostatics.table.balancing, left_out.kinetostatics.table.balancing)


def test_the_stated_error_of_a_table_method_is_the_one_that_is_found():
    found = by("differences", 0.4)
    choice = found.kinematics.choice
    assert choice.taken.key == "differences" and 0.05 < choice.worst < 0.3
    assert off(found, by("groups")) <= 1.5 * choice.worst  # angular rates, too
    assert choice.errors["place"] == FLOOR


def test_checks_are_judged_by_the_accuracy_and_not_by_rounding():
    found = by("spline", 0.05)
    forces = found.kinetostatics
    assert 1e-9 < max(forces.worst_lever, forces.worst_power) < found.kinematics.tolerance
    assert forces.agrees and not forces.strained


def test_a_method_that_misses_the_accuracy_fails_a_check():
    missed = by("differences", 1e-6).kinematics.missed
    assert missed.path == ("method",) and not missed.doubt
    assert "errs by 2e-1 of the largest value, which is more than the accuracy 1e-6" in missed.text()
    assert "accuracy: 2e-1" in missed.text()
    assert by("newton", 1e-6).kinematics.missed is None


@pytest.mark.parametrize("method", ["groups", AUTO])
def test_the_closed_form_never_misses(method):
    assert by(method, 1e-15).kinematics.missed is None


@pytest.mark.exhaustive
def test_what_is_missed_ends_with_exit_code_1_and_stands_first_in_the_note(tmp_path):
    file = tmp_path / "small.yaml"
    file.write_text(SMALL + "method: differences\naccuracy: 1e-3\n", "utf-8")
    done = CliRunner().invoke(app, ["solve", str(file), "-o", str(tmp_path / "note"), "--format", "html"])
    assert (
        done.exit_code == 1
        and f":{SMALL.count(chr(10)) + 1}:1: method: the method errs by 2e-1" in done.output
    )
    note = (tmp_path / "note" / "note.html").read_text("utf-8")
    assert "errs by" in note.split("The explanatory note has these sections")[0]


@pytest.mark.exhaustive
@pytest.mark.parametrize(("line", "told"), [("method: spline", True), ("method: closed form", False)])
def test_explain_tells_that_the_results_come_from_another_method(line, told, tmp_path):
    file = tmp_path / "small.yaml"
    file.write_text(SMALL + line + "\naccuracy: 0.2\n", "utf-8")
    done = CliRunner().invoke(app, ["explain", str(file), "v_B", "3"])
    assert done.exit_code == 0 and ("another method of the motion" in done.output) == told


def test_an_accuracy_asked_in_vain_does_not_loosen_the_checks():
    """Two ways are judged by what the method holds, not by what is asked of it."""
    assert by("newton", 0.5).kinematics.tolerance == 1e-9
    assert by("spline", 0.5).kinematics.tolerance <= 10 * by("spline", 0.5).kinematics.choice.worst


@pytest.mark.parametrize(("language", "said"), [("en", "0.1 mm"), ("ru", "0,1 мм")])
def test_a_method_is_named_as_the_language_writes_numbers_and_units(language, said):
    assert method_name(motion_method("drawing_0.1"), Translator(language)).endswith(said)


def test_of_a_stack_a_variant_with_a_method_is_solved_alone():
    plain = [stating(small(), way=way) for way in (None, Way("spline", 0.1), None, None)]
    found = solve_many(plain)
    assert [one.lever.kinematics.choice is None for one in found] == [True, False, True, True]


# --- the choice


@pytest.mark.parametrize("accuracy", [1e-12, 1e-15])
def test_where_no_other_method_holds_the_closed_form_is_taken(accuracy):
    assert by(AUTO, accuracy).kinematics.choice.taken.key == "groups"


def test_what_is_chosen_holds_what_is_asked():
    for accuracy in (0.5, 1e-2, 1e-4, None):
        choice = by(AUTO, accuracy).kinematics.choice
        assert not choice.asked and choice.worst <= (accuracy or ACCURACY)


def test_a_dear_closed_form_gives_way_to_what_holds_the_accuracy(monkeypatch):
    """The table of costs decides, and no method that errs by more."""
    monkeypatch.setitem(cost.MOTION, "groups", cost.Cost(1e9, 0.0, 0.0))
    taken = {accuracy: by(AUTO, accuracy).kinematics.choice for accuracy in (0.5, 1e-2, 1e-4, 1e-10)}
    assert all(choice.worst <= accuracy for accuracy, choice in taken.items())
    assert "groups" not in {choice.taken.key for choice in taken.values()}
    prices = [cost.MOTION[choice.taken.key].of(3, 12) for choice in taken.values()]
    assert prices == sorted(prices) and prices[0] < prices[-1]


def test_a_group_above_class_two_has_costs_of_its_own():
    """Followed round it is dearer than a closed form of dyads, and rates from its places alone are cheaper."""
    dyads, followed = (table_of(solved(name).lever.kinematics.cycle) for name in ("shaper", "quick_return"))
    assert followed["groups"].of(5, 36) > 3 * dyads["groups"].of(5, 36)
    assert dyads["groups"].of(5, 36) < dyads["fourier"].of(5, 36)
    assert followed["fourier"].of(5, 36) < followed["groups"].of(5, 36) < followed["newton"].of(5, 36)


@pytest.mark.exhaustive
def test_the_same_variant_gives_the_same_bytes():
    variant = small("method: auto", "accuracy: 1e-4", "methods: true")
    one, other = (render(solve(variant), fmt) for fmt in ("json", "json"))
    assert one == other
    assert render(solve(variant), "html") == render(solve(variant), "html")


# --- the chapter


@pytest.fixture(scope="module")
def compared():
    return solve_lever(replace(small().lever, methods=Comparison(1e-3))).methods


@pytest.mark.exhaustive
def test_every_family_names_the_cheapest_that_holds_the_accuracy(compared):
    assert set(compared.families) == {"motion", "forces"}
    for family in compared.families.values():
        assert family.best is not None and worst(family.best.errors) <= 1e-3
        cheaper = [one for one in family.candidates if SAME * one.seconds < family.best.seconds]
        assert all(set(one.errors) != set(family.kinds) or worst(one.errors) > 1e-3 for one in cheaper)


def test_the_cost_of_the_closed_form_at_the_table_is_the_unit(compared):
    table = next(table for table in tables(compared) if table.name == "methods_motion")
    rows = zip(table["method"].values, table["count"].values, table["cost"].values, strict=True)
    assert ("groups", 12, 1.0) in list(rows)


def test_finer_tables_err_less(compared):
    motion = compared.families["motion"].trials
    errors = [one.errors["velocity"] for one in motion if one.method.key == "spline"]
    assert len(errors) == 3 and errors == sorted(errors, reverse=True) and errors[0] > 100 * errors[-1]


def test_the_recommended_number_of_positions_is_the_first_that_is_good_throughout(compared):
    counted = compared.counted
    k = counted.counts.index(counted.recommended) if counted.recommended else len(counted.counts)
    assert all(error <= 1e-3 for row in counted.errors.values() for error in row[k:])
    assert k == 0 or any(row[k - 1] > 1e-3 for row in counted.errors.values())


@pytest.mark.exhaustive
def test_the_note_says_by_which_method_and_compares():
    variant = small("method: spline", "accuracy: 0.2", "methods: true")
    note = render(solve(variant), "html")["note.html"].decode()
    assert "found by the method that the task names" in note and "Choice of method" in note
    assert "The formulas that are written out below are those of the closed form" in note
    assert (
        'data-t="method"' in note and 'data-t="methods_motion"' in note and 'data-t="methods_counts"' in note
    )


def test_every_row_of_the_table_prints_its_own_numbers(compared):
    view = MethodsView(compared, Page(Html(), Translator("en"), Numbering()))
    for family in compared.families.values():
        (part,) = view.tried(family, "").parts
        assert len(part.rows) == len(family.rows)
        for k, row in enumerate(part.rows):
            assert {cell.ref.row for cell in row if isinstance(cell, Cell)} == {k}


@pytest.mark.exhaustive
def test_without_loads_there_are_no_methods_of_forces():
    lever = replace(small("methods: true").lever, loads=None)
    found = solve_lever(lever).methods
    assert set(found.families) == {"motion"} and "moment" not in found.counted.errors
