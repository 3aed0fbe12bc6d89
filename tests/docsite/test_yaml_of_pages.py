"""Every piece of YAML in the documentation is read: whole variants are solved, parts are held against the schema."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import jsonschema
import pytest
from pages_of_docs import PAGES, blocks

from tmm_report import load, solve
from tmm_report.loading import schema
from tmm_report.problems import ProblemError
from tmm_report.yamlread import loads

OTHERS = {  # what is no variant is read by the tests of its command
    "docs/assign.md": "template:", "docs/grading.md": "", "docs/ru/assign.md": "template:", "docs/ru/grading.md": "",
}  # fmt: skip
GROWING = ("docs/project.md", "docs/ru/project.md")
PIECES = [
    (page, at, text)
    for page in PAGES
    if page not in GROWING
    for at, text in enumerate(blocks(page, "yaml"))
    if page not in OTHERS
]
ALONE = {
    "cam",
    "drive",
    "train",
    "engine",
    "rotor",
    "governor",
    "vibration",
    "contacts",
    "efficiency",
    "eccentric",
}


def part(text: str) -> dict[str, Any]:
    """A piece as data: what is indented stands in the mechanism."""
    if text.startswith("  "):
        text = f"mechanism:\n{text}"
    found: dict[str, Any] = loads(text.encode(), "a.yaml").data
    return found


def lenient(node: Any) -> Any:
    """The schema of parts: a mechanism may lack what stands elsewhere."""
    return {**node, "$defs": {name: _open(name, one) for name, one in node["$defs"].items()}}


@cache
def validator() -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(lenient(schema()))


def _open(name: str, one: dict[str, Any]) -> dict[str, Any]:
    return (
        {key: value for key, value in one.items() if key != "required"} if name == "MechanismModel" else one
    )


def test_the_pages_are_searched():
    pages = {page for page, _, _ in PIECES}
    assert {
        "docs/variant.md",
        "docs/machine.md",
        "docs/profile.md",
        "docs/year.md",
        "docs/department.md",
    } <= pages
    assert len(PIECES) > 35


@pytest.mark.parametrize(("page", "at", "text"), PIECES, ids=[f"{page}-{at}" for page, at, _ in PIECES])
def test_a_piece_is_of_the_format(page, at, text):
    data, of_parts = part(text), validator()
    wrong = next(of_parts.iter_errors(data), None)
    assert wrong is None, wrong.message
    assert not of_parts.is_valid({"surplus": 1, **data})


@pytest.mark.parametrize(
    ("page", "at", "text"),
    [piece for piece in PIECES if {*part(piece[2])} <= ALONE],
    ids=lambda one: str(one)[:20],
)
def test_a_piece_that_is_a_whole_variant_is_solved(page, at, text):
    data = part(text)
    results = solve(load(data))
    for block in data:
        assert getattr(results, block) is not None


@pytest.mark.parametrize("page", [page for page in GROWING if page in PAGES])
def test_a_project_grows_block_by_block(page):
    """Each block is added to those before it; none of them has a mistake, and each makes its chapter."""
    file, made = "", []
    for text in blocks(page, "yaml"):
        file += text
        try:
            results = solve(load(file))
        except ProblemError as error:
            pytest.fail(f"{text}\n{error}")
        assert not made or not results.variant.doubts, results.variant.doubts  # of no loads yet it says so
        made.append(results)
    assert made[0].lever.kinetostatics is None and made[-1].lever.kinetostatics is not None
    last = made[-1]
    assert None not in (last.flywheel, last.drive, last.cam) and last.variant.title.student
    assert len(re.findall("^[a-z]+:", file, re.M)) > 8
