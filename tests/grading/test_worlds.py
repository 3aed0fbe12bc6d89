"""Works that hang together in another world: the mechanism is solved with the mistake in it, and handed in."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from conftest import examples, read, solved, stating
from exhaustive import many
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tmm_report import course
from tmm_report.grading.expected import expected
from tmm_report.grading.marks import grade
from tmm_report.grading.model import Answered, Answers, Rule
from tmm_report.grading.rubric import Rubric
from tmm_report.grading.worlds import assembled, bare, data

TABLES = ("outputs_table", "rates_table", "loads_table", "reactions_table", "balancing_table")
few = settings(max_examples=examples(40))
NAMES = ("shaper", "crank_rocker", "jaw_crusher", "quick_return", "slotter")


def asked_of(name, tables=TABLES):
    return {
        key: one
        for key, one in expected(solved(name)).items()
        if key[0] in tables and not re.search(r"_[xy]$|^x_|^alpha_|^M_(lever|power|\d)|^[we]_1$|^t$", key[1])
    }


def handed_in(wanted, numbers, digits=4):
    columns = {}
    for name in wanted:
        values = np.array([float(f"{x:.{digits}g}") for x in numbers[name]])
        columns[name] = Answered(values, np.isfinite(values), ("",) * len(values), ("",) * len(values))
    return Answers("x", columns)


def marked(name, other, tables=TABLES):
    wanted, there = asked_of(name, tables), expected(other)
    answers = handed_in(wanted, {key: there[key].values for key in wanted})
    return grade(solved(name), answers, Rubric(), expected(solved(name)))


def charged(found):
    return [name for name, column in found.columns.items() if {Rule.OFF, Rule.SIGN} & set(column.rules)]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_the_driving_link_turned_the_other_way_is_one_mistake(name):
    variant = stating(read(name), friction=None, reduction=False, readings={})
    mechanism = variant.lever.mechanism
    driver = replace(mechanism.driver, omega=-mechanism.driver.omega)
    found = marked(name, course.solve(stating(variant, mechanism=replace(mechanism, driver=driver))))
    assert [(cause.kind, cause.detail) for cause in found.causes] == [("reversed", "rotation")]
    assert len(charged(found)) <= 1


@pytest.mark.parametrize("name", ["shaper", "crank_rocker", "jaw_crusher", "press"])
def test_the_other_assembly_is_one_mistake_and_named_by_its_links(name):
    for world in assembled(solved(name)):
        if world.results.lever.partial:
            continue
        found = marked(name, world.results)
        if len(charged(found)) == 0:
            continue  # a mirror image: nothing that is asked tells them apart
        assert ("assembly", world.detail) in [(cause.kind, cause.detail) for cause in found.causes]
        assert len(found.causes) == 1 and len(charged(found)) <= 1


DATA = [
    ("shaper", "mechanism.links.1.points.A", 1.1),
    ("shaper", "mechanism.links.3.points", 1.08),
    ("crank_rocker", "mechanism.links.1.points.A", 0.9),
    ("press", "mechanism.links.1.points.A", 1.12),
]


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "key", "by"), many(DATA))
def test_a_length_from_the_neighbours_row_is_one_mistake_and_named(name, key, by):
    keys = {datum.key: datum for datum in data(bare(solved(name)))}
    datum = keys.get(key) or keys[f"{key.rsplit('.', 2)[0]}.points"]
    found = marked(name, course.solve(datum.changed(by - 1)))
    (cause,) = found.causes
    assert cause.kind == "datum" and cause.detail.startswith(datum.key.rsplit(".points", 1)[0])
    assert float(cause.detail.split("=")[1].split()[0]) == pytest.approx(datum.value * by, rel=0.02)
    assert len(charged(found)) <= 1


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["shaper"])
def test_a_mass_from_the_neighbours_row_is_named_though_no_load_is_on_the_sheet(name):
    masses = [datum for datum in data(bare(solved(name))) if datum.key.endswith(".mass")]
    heaviest = max(masses, key=lambda datum: datum.value)
    found = marked(name, course.solve(heaviest.changed(0.4)), ("reactions_table", "balancing_table"))
    assert [cause.detail.split(" =")[0] for cause in found.causes] == [heaviest.key]
    assert len(charged(found)) == 1


@pytest.mark.exhaustive
def test_a_slip_beside_the_wrong_datum_is_charged_besides():
    name = ("rates_table", "v_B")
    datum = next(one for one in data(bare(solved("shaper"))) if one.key == "mechanism.links.1.points.A")
    there, wanted = expected(course.solve(datum.changed(0.1))), asked_of("shaper")
    numbers = {key: there[key].values.copy() for key in wanted}
    numbers[name][3] *= 1.3
    found = grade(solved("shaper"), handed_in(wanted, numbers), Rubric(), expected(solved("shaper")))
    assert [cause.kind for cause in found.causes] == ["datum"]
    assert found.columns[name].rules[3] is Rule.OFF and len(charged(found)) == 2


# ---------------------------------------------------------------- nobody is accused who is right


@pytest.mark.exhaustive
@few
@given(
    name=st.sampled_from([*NAMES, "compressor", "piston_pump", "hay_press", "loom"]),
    seed=st.integers(0, 2**32),
    noise=st.sampled_from([0.0, 0.01, 0.04]),
    digits=st.integers(3, 5),
)
def test_right_works_rounded_and_read_within_the_limit_lose_nothing_and_are_not_accused(
    name, seed, noise, digits
):
    rng, wanted = np.random.default_rng(seed), asked_of(name)
    numbers = {
        key: one.values * (1 + rng.uniform(-noise, noise, len(one.values))) for key, one in wanted.items()
    }
    wrong = {key for key, one in wanted.items() if one.angle}
    answers = handed_in(wanted.keys() - wrong, numbers, digits)
    found = grade(solved(name), answers, Rubric(), expected(solved(name)))
    assert not found.causes and not charged(found)


@pytest.mark.exhaustive
@settings(max_examples=examples(8))
@example(name="jaw_crusher", seed=0)  # psi_3 goes back nearly as it came
@given(name=st.sampled_from(NAMES), seed=st.integers(0, 2**32))
def test_noise_beyond_the_limit_has_no_name(name, seed):
    rng, wanted = np.random.default_rng(seed), asked_of(name)
    numbers = {key: one.values * (1 + rng.uniform(-0.1, 0.1, len(one.values))) for key, one in wanted.items()}
    found = grade(solved(name), handed_in(wanted, numbers), Rubric(), expected(solved(name)))
    assert not found.causes
