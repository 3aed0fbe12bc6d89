"""Tables and single values are made once of what was found: readings, files and the note read the same ones."""

import pickle
from types import SimpleNamespace

import pytest
from conftest import read
from notes import render
from test_layout import ORDER

from tmm_report import course
from tmm_report.grading.expected import expected
from tmm_report.quantity.tabulated import tabulated
from tmm_report.results import tables


@tabulated
def squares(found, prefix="of"):
    for number in found.numbers:
        found.made.append(number)
        if number < 0:
            raise ValueError("below zero")
        yield f"{prefix} {number**2}"


def found(*numbers):
    return SimpleNamespace(numbers=numbers, made=[])


def test_each_is_made_once_and_only_when_it_is_reached():
    of = found(1, 2, 3)
    assert next(iter(squares(of))) == "of 1" and of.made == [1]
    assert list(squares(of)) == list(squares(of, "of")) == list(squares(of, prefix="of"))
    assert of.made == [1, 2, 3]


def test_another_prefix_and_another_found_have_their_own():
    of = found(2)
    assert [*squares(of), *squares(of, "by"), *squares(found(3))] == ["of 4", "by 4", "of 9"]


def test_an_error_is_told_every_time():
    of = found(1, -1)
    for _ in range(2):
        with pytest.raises(ValueError, match="below zero"):
            list(squares(of))


def test_two_may_read_at_once_and_a_copy_has_all_of_it():
    of = found(1, 2, 3)
    assert list(zip(squares(of), squares(of), strict=True)) == [("of 1",) * 2, ("of 4",) * 2, ("of 9",) * 2]
    assert list(pickle.loads(pickle.dumps(squares(found(1, 2))))) == ["of 1", "of 4"]


@pytest.mark.parametrize("chapter", [chapter for chapter in ORDER if chapter != "title"])
def test_every_chapter_keeps_its_tables_and_values(chapter):
    quantities = course.room(chapter, "quantities")
    for make in (quantities.tables, quantities.values):
        assert make.__wrapped__.__code__ is not make.__code__


@pytest.mark.parametrize(
    ("chapter", "room", "make"),
    [("kinematics", "quantities", "places"), ("kinetostatics", "quantities.positions", "_loads")],
)
def test_all_read_the_same_tables(chapter, room, make, monkeypatch):
    """Solved with readings, written, marked and rendered twice: of the table and the diagram positions one each."""
    quantities, calls = course.room(chapter, room), []
    of = getattr(quantities, make)
    monkeypatch.setattr(quantities, make, lambda *args: calls.append(args) or of(*args))
    results = course.solve(read("compressor"))
    expected(results)
    for fmt in ("json", "csv", "html", "html"):
        render(results, fmt)
    assert len(calls) == 2
    assert all(one is other for one, other in zip(tables(results), tables(results), strict=True))


def test_readings_make_no_table_behind_the_last_that_they_name(monkeypatch):
    quantities, calls = course.room("kinetostatics", "quantities.positions"), []
    of = quantities._loads
    monkeypatch.setattr(quantities, "_loads", lambda *args: calls.append(args) or of(*args))
    assert not course.solve(read("compressor")).lever.readings.wrong and not calls
