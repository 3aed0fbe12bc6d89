"""Every ready variant against its golden file; after a change of numbers on purpose: `python tools/golden.py`."""

from __future__ import annotations

import json
import runpy
from pathlib import Path

import pytest
from conftest import ALL_FILES, read, solved

TOOL = runpy.run_path(str(Path(__file__).parents[2] / "tools" / "golden.py"))
NAMES = [file.stem for file in ALL_FILES]


@pytest.mark.parametrize("name", NAMES)
def test_numbers_are_those_of_the_golden_file(name):
    golden = TOOL["read"](name)
    assert golden, f"tests/golden/{name}.json is missing: python tools/golden.py {name}"
    wrong = TOOL["differences"](golden, TOOL["key_numbers"](solved(name)))
    assert not wrong, "\n" + "\n".join(wrong)


def test_no_golden_file_without_a_variant():
    """Nor an approved text of another note than those that the tool refreshes."""
    texts = {f"{name}.{language}.txt" for name in NAMES for language in TOOL["languages"](read(name))}
    texts |= {f"{name}.numbers" for name in TOOL["READ_IN_ALL"]}
    assert {file.name for file in TOOL["GOLDEN"].iterdir()} == {f"{name}.json" for name in NAMES} | texts


@pytest.mark.parametrize("name", NAMES)
def test_golden_files_hold_the_numbers_that_matter(name):
    rows, found = TOOL["key_numbers"](solved(name)), solved(name)
    if found.lever and found.lever.kinetostatics:
        assert len(rows["M_bal at the positions"]) == found.variant.lever.positions.table + 1
        assert sum(key.endswith("at most") for key in rows) == len(
            found.lever.kinetostatics.table.statics.reactions  # with a cam, of the replacing link too
        )
    for travel in found.lever.kinematics.travels if found.lever else ():
        assert {f"{letter}_{travel.output.name}" for letter in "HSVA"} <= set(rows)


ROWS = {"structure": "I(0,1)", "M": [100.0, -3.0, None], "R": [1e-9]}


@pytest.mark.parametrize(
    ("change", "wrong"),
    [
        ({}, []),
        ({"M": [100.0 + 9e-8, -3.0 - 9e-8, None]}, []),
        ({"M": [100.0, -3.0 + 2e-7, None]}, ["M[1]"]),
        ({"M": [100.0, None, 0.0], "R": [1.01e-9]}, ["M[1]", "M[2]", "R[0]"]),
        ({"M": [100.0, -3.0]}, ["M"]),
        ({"structure": "I(0,2)"}, ["structure"]),
        ({"new": [1.0]}, ["new"]),
    ],
)
def test_every_wrong_number_is_reported(change, wrong):
    found = TOOL["differences"](ROWS, {**ROWS, **change})
    assert [text.split(":")[0] for text in found] == wrong


def test_a_row_that_is_gone_is_reported():
    assert TOOL["differences"](ROWS, {"structure": "I(0,1)", "R": [1e-9]}) == [
        f"M: is no more, was {ROWS['M']}"
    ]


def test_written_and_read_back(tmp_path, monkeypatch):
    tool = TOOL["write"].__globals__
    monkeypatch.setitem(tool, "GOLDEN", tmp_path / "golden")
    tool["write"]("one", ROWS)
    assert tool["read"]("one") == ROWS and tool["read"]("other") == {}
    assert json.loads((tmp_path / "golden" / "one.json").read_text(encoding="utf-8")) == ROWS
