"""Variants solved together: each finds to the last byte what it finds alone, whatever stands beside it."""

import operator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import FILES, examples, read
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render

from tmm_report import course, stack
from tmm_report.chapters.lever.kinetostatics.given import Diagram, Force, Loads
from tmm_report.i18n import Translator
from tmm_report.mechanics.calculus.variants import Each, Unlike, one, together
from tmm_report.problems import ProblemError
from tmm_report.results import as_json

ALONE = {"elliptic_trammel", "grain_screen", "parallelogram_drive", "press", "quick_return", "tangent"}
"""Ready variants solved alone: with change points, gaps, parallel guides, groups above class II, another method."""


def bare(name: str) -> course.Variant:
    """The lever mechanism of a ready variant, without what is stated for its own numbers alone."""
    variant = read(name)
    return replace(variant, drive=None, eccentric=None, lever=replace(variant.lever, readings={}))


@cache
def varied(name: str, seed: int) -> course.Variant:
    """A variant with other lengths and masses, by a percent or two; with its own where the seed is 0."""
    draw = np.random.default_rng(seed)
    variant, mechanism = bare(name), bare(name).lever.mechanism

    def other(x):
        return type(x)(x * (1 + 0.02 * draw.uniform(-1, 1))) if seed else x

    links = {
        key: replace(
            link,
            points={point: other(at) for point, at in link.points.items()},
            mass=other(link.mass),
            inertia=other(link.inertia),
        )
        for key, link in mechanism.links.items()
    }
    driver = replace(mechanism.driver, omega=other(mechanism.driver.omega))
    mechanism = replace(mechanism, links=links, driver=driver)
    return replace(variant, lever=replace(variant.lever, mechanism=mechanism))


def written(found) -> bytes | str:
    return str(found) if isinstance(found, ProblemError) else as_json(found, Translator("ru"))


@cache
def alone(name: str, seed: int) -> bytes | str:
    try:
        return written(course.solve(varied(name, seed)))
    except ProblemError as error:
        return str(error)


def many(rows: list[tuple[str, int]]) -> list[bytes | str]:
    return [written(found) for found in stack.solve_many([varied(*row) for row in rows])]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [path.stem for path in FILES])
def test_a_variant_finds_in_a_stack_what_it_finds_alone(name):
    rows = [(name, seed) for seed in range(stack.LEAST)]
    assert many(rows) == [alone(*row) for row in rows]


@pytest.mark.parametrize("name", [path.stem for path in FILES])
def test_all_but_the_odd_ones_are_solved_together(name, monkeypatch):
    solved = []
    monkeypatch.setattr(stack, "solve", lambda variant, moved, each: solved.append(moved))
    stack.solve_many([varied(name, 0)] * stack.LEAST)
    assert [moved is None for moved in solved] == [name in ALONE] * stack.LEAST


@pytest.mark.exhaustive
@given(st.lists(st.sampled_from([("compressor", k) for k in range(9)]), min_size=1, max_size=9))
@settings(max_examples=examples(20))
def test_companions_and_their_order_change_nothing(rows):
    assert many(rows) == [alone(*row) for row in rows]


@pytest.mark.exhaustive
@given(st.permutations([(name, k) for name in ("compressor", "shaper", "tangent") for k in range(3)]))
@settings(max_examples=examples(10))
def test_topologies_may_come_in_any_order(rows):
    assert many(rows) == [alone(*row) for row in rows]


@pytest.mark.exhaustive
def test_more_variants_than_a_stack_holds(monkeypatch):
    monkeypatch.setattr(stack, "LARGEST", 3)
    rows = [("crank_rocker", k) for k in range(8)]
    assert many(rows) == [alone(*row) for row in rows]


@pytest.mark.exhaustive
def test_many_positions_make_small_stacks(monkeypatch):
    monkeypatch.setattr(stack, "PLACES", 4 * read("crank_rocker").lever.positions.diagram)
    counts, solved = [], stack._moved
    monkeypatch.setattr(stack, "_moved", lambda some, own: (counts.append(len(own)), solved(some, own))[1])
    rows = [("crank_rocker", k) for k in range(6)]
    assert many(rows) == [alone(*row) for row in rows] and counts == [4, 2]


def test_nothing_makes_nothing():
    assert stack.solve_many([]) == []


# ---------------------------------------------------------------- mistakes


@pytest.mark.exhaustive
def test_a_variant_that_does_not_close_leaves_the_others():
    variants = [varied("compressor", k) for k in range(4)]
    guide = replace(variants[1].lever.mechanism.guides["x"], through=1j)
    mechanism = replace(variants[1].lever.mechanism, guides={"x": guide})
    variants[1] = replace(variants[1], lever=replace(variants[1].lever, mechanism=mechanism))
    found = [written(one) for one in stack.solve_many(variants)]
    with pytest.raises(ProblemError) as mistake:
        course.solve(variants[1])
    assert found == [alone("compressor", 0), str(mistake.value), *(alone("compressor", k) for k in (2, 3))]


@pytest.mark.exhaustive
def test_a_load_that_cannot_be_read_leaves_the_others():
    variants = [varied("compressor", k) for k in range(4)]
    gas = Diagram(zero=1j, forward=[(0.0, 1.0), (1.0, 1.0)], back=[(0.0, 1.0), (1.0, 1.0)])
    across = Force(name="gas", at="B", direction=1 + 0j, by_displacement=gas)
    first = [
        replace(v, lever=replace(v.lever, loads=Loads(forces=(across,)), friction=None)) for v in variants[:1]
    ]
    good = [
        replace(
            v, lever=replace(v.lever, loads=Loads(forces=(replace(force, name="gas", at="B", direction=-1),)))
        )
        for v in variants[1:]
        for force in v.lever.loads.forces[:1]
    ]
    found = stack.solve_many([*first, *good])
    assert isinstance(found[0], ProblemError)
    assert [written(one) for one in found[1:]] == [written(course.solve(one)) for one in good]


# ---------------------------------------------------------------- numbers of many variants

numbers = st.floats(-1e6, 1e6) | st.complex_numbers(max_magnitude=1e6)


@given(st.lists(st.tuples(numbers, numbers), min_size=1, max_size=5), st.sampled_from(["add", "sub", "mul"]))
def test_each_is_reckoned_as_it_is_alone(pairs, name):
    op = getattr(operator, name)
    a, b = (Each(row) for row in zip(*pairs, strict=True))
    assert op(a, b).items == [op(x, y) for x, y in pairs]
    assert op(2.5, b).items == [op(2.5, y) for _, y in pairs]
    assert abs(a).items == [abs(x) for x, _ in pairs]


@given(st.lists(numbers, min_size=2, max_size=5), st.integers(1, 40), st.integers(0, 2**32))
def test_with_an_array_of_positions_a_row_is_as_it_is_alone(items, count, seed):
    draw = np.random.default_rng(seed)
    rows = draw.normal(size=(len(items), count)) + 1j * draw.normal(size=(len(items), count))
    each = Each(items)
    for op in (operator.mul, operator.add, operator.sub):
        left, right = op(each, rows), op(rows, each)
        for v, x in enumerate(items):
            assert np.array_equal(one(left, v).reshape(-1), op(x, rows[v]))
            assert np.array_equal(one(right, v).reshape(-1), op(rows[v], x))


def test_records_of_other_shapes_are_not_put_together():
    compressor, shaper = (read(name).lever.mechanism for name in ("compressor", "shaper"))
    with pytest.raises(Unlike):
        together([compressor, shaper])
    whole = together([compressor, compressor])
    assert whole.links["2"].points["B"].items == [compressor.links["2"].points["B"]] * 2
    assert list(whole.links) == list(compressor.links)


def test_a_number_that_is_nothing_in_one_variant_only_parts_them():
    """An arm of no length is left out of the reckoning: for all of a stack, or for none."""
    variant = varied("compressor", 1)
    links = variant.lever.mechanism.links
    moved = replace(links["2"], points={**links["2"].points, "S2": 0j})
    mechanism = replace(variant.lever.mechanism, links={**links, "2": moved})
    other = replace(variant.lever, mechanism=mechanism)
    assert stack.topology(variant.lever) == stack.topology(varied("compressor", 2).lever)
    assert stack.topology(variant.lever) != stack.topology(other)


@pytest.mark.exhaustive
@pytest.mark.parametrize("some", [slice(0, 1), slice(1, None)], ids=["first", "others"])
def test_the_note_is_the_same_too(some):
    rows = [varied("crank_rocker", seed) for seed in range(stack.LEAST)]
    for variant, found in list(zip(rows, stack.solve_many(rows), strict=True))[some]:
        assert render(found, "tex") == render(course.solve(variant), "tex")
        assert render(found, "csv") == render(course.solve(variant), "csv")
