"""One mistake is charged once, whichever way the values hang together."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from conftest import examples, read, solved, stating
from exhaustive import many
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course
from tmm_report.grading.charge import Clause, charged
from tmm_report.grading.expected import expected
from tmm_report.grading.marks import grade
from tmm_report.grading.model import Answered, Answers, Rule
from tmm_report.grading.rubric import Rubric

YES, NO = np.array([True]), np.array([False])
few = settings(max_examples=examples(100))


def follows(wrong, *clauses):
    found = charged(dict.fromkeys(wrong, YES), [Clause(key, sources, YES) for key, sources in clauses])
    return {key: sources[0] for key, sources in found.items()}


# ---------------------------------------------------------------- which of the wrong values are mistakes


def test_of_two_that_follow_from_each_other_the_first_is_the_mistake():
    assert follows("ab", ("a", "b"), ("b", "a")) == {"a": "", "b": "a"}


def test_the_one_is_the_mistake_from_which_most_follows():
    found = follows("abcd", ("a", "b"), ("b", "c"), ("c", "b"), ("d", "c"))
    assert [key for key, source in found.items() if not source] == ["b"]
    assert found["d"] == "c"


def test_what_needs_two_wrong_values_follows_from_them_only_when_both_are_settled():
    assert follows("abc", ("c", "ab")) == {"a": "", "b": "", "c": "a"}
    assert follows("abc", ("a", "c"), ("c", "ab"))["b"] == ""


def test_a_right_source_says_nothing():
    found = charged({"a": NO, "b": YES}, [Clause("b", ("a",), YES)])
    assert found == {"a": ("",), "b": ("",)}


def test_positions_are_settled_each_by_itself():
    wrong = {"a": np.array([True, False]), "b": np.array([True, True])}
    found = charged(wrong, [Clause("b", ("a",), np.array([True, True]))])
    assert found["b"] == ("a", "")


@few
@given(data=st.data(), size=st.integers(1, 7))
def test_whatever_follows_goes_back_to_a_mistake(data, size):
    keys = [f"k{n}" for n in range(size)]
    sources = st.lists(st.sampled_from(keys), min_size=1, max_size=3, unique=True)
    clauses = data.draw(st.lists(st.tuples(st.sampled_from(keys), sources), max_size=12))
    found = follows(keys, *((key, tuple(of)) for key, of in clauses))
    settled = {key for key, source in found.items() if not source}
    ways = [(key, set(of) - {key}) for key, of in clauses]
    while more := {key for key, of in ways if key not in settled and of and of <= settled}:
        settled |= more
    assert settled == set(keys)
    # none is a mistake that would follow from the others' being mistakes, and from these alone, in a straight line
    alone = {key for key, source in found.items() if not source}
    for key in alone:
        rest = alone - {key}
        while more := {one for one, of in ways if one not in rest and of and of <= rest}:
            rest |= more
        assert key not in rest


# ---------------------------------------------------------------- works made by solving with the mistake in


def variant_with(name, omega=1.0, mass=None):
    """A variant solved with another angular velocity, or with another mass of one link."""
    variant = stating(read(name), friction=None, reduction=False, readings={})
    mechanism = variant.lever.mechanism
    links = dict(mechanism.links)
    if mass is not None:
        link, factor = mass
        links[link] = replace(links[link], mass=links[link].mass * factor)
    driver = replace(mechanism.driver, omega=mechanism.driver.omega * omega)
    positions = replace(variant.lever.positions, plans=(), force_plan=())
    return course.solve(
        stating(variant, mechanism=replace(mechanism, driver=driver, links=links), positions=positions)
    )


ASKED = ("outputs_table", "rates_table", "loads_table", "reactions_table", "balancing_table")


def asked_of(name):
    """What a course asks for: rates as a plan gives them, forces and moments."""
    return {
        key: one
        for key, one in expected(solved(name)).items()
        if key[0] in ASKED and not re.search(r"_[xy]$|^x_|^alpha_|^M_(lever|power|\d)|^[wv]_1$|^t$", key[1])
    }


def handed_in(wanted, other, digits=4):
    columns = {}
    for name in wanted:
        values = np.array([float(f"{x:.{digits}g}") for x in other[name].values])
        blank = ("",) * len(values)
        columns[name] = Answered(values, np.isfinite(values), blank, blank)
    return Answers("x", columns)


def wrong_columns(name, other, only=lambda key: True):
    wanted = {key: one for key, one in asked_of(name).items() if only(key)}
    found = grade(solved(name), handed_in(wanted, expected(other)), Rubric(), expected(solved(name)))
    bad = (Rule.OFF, Rule.SIGN)
    return {key for key, column in found.columns.items() if any(rule in bad for rule in column.rules)}, found


MOVED = [
    "compressor",
    "shaper",
    "crank_rocker",
    "press",
    "jaw_crusher",
    "quick_return",
    "slotter",
    "piston_pump",
]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", MOVED)
@pytest.mark.parametrize("by", many([30 / np.pi, 1 / (2 * np.pi), 1.25]))
def test_a_wrong_speed_carried_through_the_whole_work_is_charged_where_it_first_shows(name, by):
    """The crank's pin: its velocity. Everything else in the work follows from that."""
    driver = read(name).lever.mechanism.driver.link
    pins = {f"v_{point}" for point in read(name).lever.mechanism.links[driver].points}
    wrong, _ = wrong_columns(name, variant_with(name, omega=by))
    assert len(wrong) == 1 and {key for _, key in wrong} <= pins | {f"w_{driver}"}, wrong


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", MOVED)
def test_velocities_along_the_axis_follow_from_those_of_the_plan(name):
    """Outputs stand in a table before the rates, but V_D is found from v_D."""
    wrong, found = wrong_columns(name, variant_with(name, omega=1.5))
    outputs = [key for key in found.columns if key[0] == "outputs_table"]
    assert outputs and not wrong & set(outputs)


@pytest.mark.parametrize("name", ["shaper", "compressor", "press", "quick_return"])
def test_a_wrong_mass_used_throughout_is_charged_by_the_loads_that_it_enters(name):
    mechanism = read(name).lever.mechanism
    link = max((one for one in mechanism.links if one != "0"), key=lambda one: mechanism.links[one].mass)
    wrong, _ = wrong_columns(name, variant_with(name, mass=(link, 1.4)))
    assert {table for table, _ in wrong} == {"loads_table"}, wrong
