"""The course's records against the chapters' rooms: types, keys, order, what is loaded when; the public examples."""

import doctest
import subprocess
import sys
import typing
from dataclasses import fields
from pathlib import Path

import pytest
from conftest import read, solved

import tmm_report
from tmm_report import course, loading
from tmm_report.variant.model import Block

RECORDS = {"title": course.Variant, **dict.fromkeys(course.LEVER, course.LeverGiven)}
RECORDS |= dict.fromkeys(course.BESIDE, course.Variant)
OWN = ("document", "lever", "places", "file", "doubts", "template")  # of the variant itself


def types(record) -> dict[str, object]:
    """The types of a record's fields."""
    return {one.name: eval(str(one.type), vars(course)) for one in fields(record)}


def given(chapter: str) -> dict[str, object]:
    """The types of what a chapter's block gives, by field of the record."""
    kind = typing.get_type_hints(course.room(chapter, "block").given)["return"]
    return typing.get_type_hints(kind) if typing.is_typeddict(kind) else {}


@pytest.mark.parametrize("chapter", RECORDS)
def test_what_a_block_gives_has_the_types_of_the_record(chapter):
    """The one seam that the type checker does not see, as rooms are found by name."""
    assert given(chapter).items() <= types(RECORDS[chapter]).items()


def test_every_field_of_what_is_given_comes_from_one_block():
    names = [name for chapter in RECORDS for name in given(chapter)]
    fields_ = [*types(course.LeverGiven), *(name for name in types(course.Variant) if name not in OWN)]
    assert sorted(names) == sorted(fields_)


@pytest.mark.exhaustive
def test_every_key_of_the_file_belongs_to_one_block():
    blocks = [course.room(chapter, "block").Block for chapter in RECORDS]
    keys = [key for block in blocks for key in block.model_fields]
    assert len(set(keys)) == len(keys) and set(keys) == loading.schema()["properties"].keys()
    assert all(issubclass(block, Block) and block.__doc__ for block in blocks)


@pytest.mark.parametrize("chapter", course.OTHERS)
def test_a_chapter_beside_the_levers_has_the_key_of_its_name(chapter):
    own = (
        [] if chapter == "cam_forces" else [chapter]
    )  # the keys of a cam's forces stand in the block of the cam
    assert [*course.room(chapter, "block").Block.model_fields] == own


def test_no_public_type_is_any():
    for record in (course.Variant, course.LeverGiven, course.LeverFound, course.Results):
        assert not {name for name, kind in types(record).items() if "Any" in str(kind)}, record
    for function in (tmm_report.load, tmm_report.solve, tmm_report.render):
        assert function.__annotations__ and "Any" not in str(function.__annotations__)


def test_solved_chapters_stand_in_the_order_of_the_note():
    rare = ("cams", "methods", "press", "reduction", "transmission", "translation")
    usual = [name for name in course.LEVER if name not in rare]
    assert [name for name, _ in course.chapters(solved("compressor"))] == [
        *usual, "flywheel", "balancing", "drive",
    ]  # fmt: skip
    assert [name for name, _ in course.chapters(solved("eccentric"))] == ["eccentric"]
    bare = course.solve(course.Variant(course.LeverGiven(read("shaper").lever.mechanism)))
    assert [name for name, _ in course.chapters(bare)] == ["structure", "kinematics", "plans"]


# --- what is loaded


def loaded(program: str) -> set[str]:
    """Modules that a program has loaded at its end."""
    program += "\nimport sys; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


SOLVED = "from tmm_report import load, render, solve; render(solve(load({!r})), 'json')"
HEAVY = {"jinja2", "matplotlib", "scipy", "tmm_report.figures", "tmm_report.report"}


def test_importing_the_package_loads_nothing_heavy():
    assert not loaded("import tmm_report") & {"numpy", "pydantic", "yaml", "tmm_report.course", *HEAVY}


def test_solving_a_lever_loads_no_gears_and_nothing_of_the_page():
    modules = loaded(SOLVED.format(read("press").file))
    assert not modules & HEAVY
    others = (
        name for name in (*course.GEARS, *course.OTHERS) if name != "cam"
    )  # phases are read by its block
    gears = {f"tmm_report.chapters.{course.wing(name)}{name}" for name in others}
    assert not (gears | {"tmm_report.chapters.cams.cam.solve"}) & modules
    assert (
        "tmm_report.chapters.lever.friction.block" in modules
    )  # the names are those of modules, so this test can fail


# --- the public interface


def test_the_examples_of_the_public_functions_run(monkeypatch):
    monkeypatch.chdir(Path(read("compressor").file).parents[1])  # the examples name variants/compressor.yaml
    found = {one.name: one for one in doctest.DocTestFinder().find(tmm_report, "tmm_report") if one.examples}
    assert set(found) >= {"tmm_report", *(f"tmm_report.{name}" for name in tmm_report.__all__)}
    runner = doctest.DocTestRunner()
    assert not [name for name, one in found.items() if runner.run(one).failed]
