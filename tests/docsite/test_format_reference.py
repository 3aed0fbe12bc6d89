"""The reference of the format: no key is missing; units, defaults, examples are those of the schema and of variants."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import jsonschema
import pytest
from format_reference import ENGLISH, Reference, _at
from notes import VARIANTS
from russian_reference import RUSSIAN

from tmm_report.languages import LANGUAGES
from tmm_report.loading import schema
from tmm_report.quantity import units
from tmm_report.variant import editor, russian
from tmm_report.yamlread import loads, read

READY = {file.stem: read(file).data for file in sorted(VARIANTS.glob("*.yaml"))}
Cells = tuple[str, ...]  # name, meaning, unit, default, example


@cache
def made(language: str = "en") -> Reference:
    return Reference(schema(), READY, {"en": ENGLISH, "ru": RUSSIAN}[language])


@cache
def rows(language: str = "en") -> tuple[tuple[tuple[str, ...], Cells], ...]:
    return tuple((path, tuple(row[2:-2].split(" | "))) for path, row in made(language).rows())


def literal(cell: str) -> str:
    found = re.fullmatch("`(.*)`", cell)
    return found[1].replace("&#124;", "|") if found else ""


def as_read(text: str) -> Any:
    """As a variant has it."""
    return loads(f"x: {text}".encode(), "x").data["x"]


# --- no key is missing


def maps(node: Any) -> Iterator[dict[str, Any]]:
    """Every map of keys of the schema, wherever it stands: what has a text by languages is none."""
    if isinstance(node, dict):
        found = node.get("properties")
        if isinstance(found, dict) and set(found) != {*LANGUAGES}:
            yield found
        for one in node.values():
            yield from maps(one)
    elif isinstance(node, list):
        for one in node:
            yield from maps(one)


@pytest.mark.parametrize("language", ["en", "ru"])
def test_every_key_of_the_schema_has_its_row_with_five_cells(language):
    told = sorted(path[-1] for path, _ in rows(language))
    assert told == sorted(key for keys in maps(schema()) for key in keys) and len(told) > 1300
    assert not [path for path, cells in rows(language) if len(cells) != 5 or not cells[1] or not cells[4]]


def test_tables_stand_where_ready_variants_have_such_maps():
    """The other way: from the files, wherever they have something at a table's path."""
    used = 0
    for table in made().tables.values():
        found = [one for data in READY.values() for one in _at(data, table.path) if isinstance(one, dict)]
        keys = {key for at in made().tables.values() if at.path == table.path for key in at.keys}
        assert all({*map(str, one)} <= keys for one in found), table.path
        used += any(table.holds(one) for one in found)
    assert used > 90


def test_pages_lead_to_tables_that_there_are():
    pages = made().pages()
    anchors = {
        (page, anchor) for page, text in pages.items() for anchor in re.findall(r"\{ #([\w-]+) \}", text)
    }
    links = [
        (to, anchor)
        for text in pages.values()
        for to, anchor in re.findall(r"\]\(([\w-]+\.md)#([\w-]+)\)", text)
    ]
    assert len(links) > 200 and not {*links} - anchors
    assert len(anchors) == len(made().tables)


# --- what a row says


def nodes() -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    top = schema()["properties"]
    yield from (((key,), node) for key, node in top.items())
    for table in made().tables.values():
        yield from (((*table.path, key), node) for key, node in table.keys.items())


def test_defaults_are_those_of_the_schema():
    for (path, cells), (at, node) in zip(rows(), nodes(), strict=True):
        assert path == at
        default = node.get("default")
        if default in (None, ""):
            assert cells[3] in ("—", ENGLISH.required), path
        else:
            said = as_read(literal(cells[3]))
            agrees = (
                said == pytest.approx(default, rel=1e-5)
                if isinstance(default, float | list)
                else str(said) == str(default)
            )
            assert agrees, path


def test_examples_are_right_where_they_stand():
    """But for those that are cut short, and for numbers that depend on the rest of a variant."""
    whole = schema()
    seen = 0
    for (path, cells), (_, node) in zip(rows(), nodes(), strict=True):
        text = literal(cells[4])
        if "…" in text:
            continue
        value = as_read(text)
        wrong = [*jsonschema.Draft202012Validator({**node, "$defs": whole["$defs"]}).iter_errors(value)]
        assert not wrong, (path, text, wrong[0].message)
        seen += 1
    assert seen > 1200


def measures(given: str, wanted: str) -> bool:
    try:
        return units.between(given, wanted) > 0
    except units.WrongValue:
        return False


def test_a_number_that_is_measured_has_its_unit():
    """By its example: what is written with a unit is in that of the column, or of one in it."""
    seen = 0
    for path, cells in rows():
        written = re.fullmatch(r"[-−]?[\d.,]+ [A-Za-zµ°][\w*/^·²³]*", literal(cells[4]))
        if not written:
            continue
        unit = written[0].split(" ")[1]
        assert any(measures(unit, one) for one in cells[2].split(", ")), (path, cells)
        seen += 1
    assert seen > 300


# --- in Russian


def test_the_russian_reference_says_everything_in_russian():
    left = [
        (path, cells[1])
        for path, cells in rows("ru")
        if re.search(r"\b(the|of|left out|in place)\b", cells[1])
    ]
    assert not left
    cell = dict(rows("ru"))["mechanism", "driver", "speed"]
    assert cell[2] == "рад/с" and russian.called("speed").split(", ")[0] in cell[0]


def said(node: Any) -> Iterator[str]:
    if isinstance(node, dict):
        if isinstance(text := node.get("description"), str):
            yield " ".join(text.split())
        for key, one in node.items():
            if key not in ("examples", "default", "enum"):
                yield from said(one)
    elif isinstance(node, list):
        for one in node:
            yield from said(one)


def test_every_description_has_its_russian_and_no_other_is_kept():
    known, english = editor.meanings("ru"), set(said(schema()))
    missing = [
        text for text in english if editor.meaning(text, "ru") == text and re.search(r"[a-z]{3}", text)
    ]
    codes = re.compile(r"^(b/D|b/h|h/D)|^[\[{]|^A$")
    assert not [text for text in missing if not codes.search(text)]
    measured = {match["name"] for text in english if (match := editor._MEASURED.fullmatch(text))}
    assert {*known} - english - measured - {editor.MEASURED, "0 … 360 deg of every turn"} <= {
        dimension.name for dimension in units.DIMENSIONS.values()
    }


def test_a_translation_keeps_what_is_written_as_it_is():
    """Keys in backquotes, braces of an example, `synthesis.crank`."""
    code = re.compile(r"`[^`]+`|\{(?!ru)[^}]*\}|\d+ (?:deg|mm|kg/m)\b")
    for text, russian_text in editor.meanings("ru").items():
        kept = [one for one in code.findall(text) if one not in russian_text and text != editor.MEASURED]
        assert not kept or text.startswith("0 … 360"), (text, kept)


def test_the_schema_of_a_language_differs_in_what_it_says_alone():
    def silent(node: Any) -> Any:
        if isinstance(node, dict):
            return {
                key: silent(one)
                for key, one in node.items()
                if key != "description" or not isinstance(one, str)
            }
        return [silent(one) for one in node] if isinstance(node, list) else node

    assert silent(schema("ru")) == silent(schema()) and schema("ru") != schema()
    assert schema("ru")["properties"]["flywheel"]["description"] == "маховик машины"
