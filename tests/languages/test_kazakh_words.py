"""The list of Kazakh words for a native reader says what the notes and the ready variants say."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest
from catalogues import messages
from notes import VARIANTS

from tmm_report.wording.kazakh import SOFTENED

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "kazakh_words.md").read_text("utf-8")
ROW = re.compile(
    r"^\| (?P<english>.+?) \| (?P<russian>.+?) \| (?P<word>.+?) \|(?: (?P<others>.+?) \|)?$", re.M
)
ROWS = [row for row in ROW.finditer(PAGE) if row["english"] != "English"]


@cache
def said() -> str:
    tool = messages()
    texts = tool["messages"](tool["merged"]("kk", "note"))
    forms = [form for entry in texts for form in tool["as_forms"](entry.string or "")]
    return "\n".join([*forms, *(file.read_text("utf-8") for file in VARIANTS.glob("*.yaml"))]).lower()


def with_endings(word: str) -> re.Pattern[str]:
    """A word of one or several parts; the last sound of a part may be softened, and of the third person fall."""
    parts = []
    for part in word.lower().split():
        short = re.sub(r"(?<=\w{3})(?:с?[ыі])$", "", part)
        soft = SOFTENED.get(short[-1], "")
        parts.append(rf"{re.escape(short[:-1])}[{re.escape(short[-1])}{soft}]\w*")
    return re.compile(r"(?<!\w)" + r"\s+".join(parts))


@pytest.mark.parametrize("row", ROWS, ids=[row["english"] for row in ROWS])
def test_the_notes_say_the_word(row):
    assert with_endings(row["word"]).search(said()), row["word"]


def test_the_list_is_read():
    assert len(ROWS) > 100 and sum(bool(row["others"]) for row in ROWS) >= 5
    assert not with_endings("тиек").search(said())
