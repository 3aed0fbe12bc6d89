"""A letter left out, or typed in another script, anywhere in a variant: the right line is told, or it is solved."""

from __future__ import annotations

import random
from collections.abc import Iterator

import pytest
from mistyped import PUMP
from notes import VARIANTS

from tmm_report import loading
from tmm_report.problems import Problem, ProblemError

ALIKE = dict(zip("ABEKMHOPCTXYaeopcxyk0", "АВЕКМНОРСТХУаеорсхукО", strict=True))
TEXTS = {"pump": PUMP} | {
    name: (VARIANTS / f"{name}.yaml").read_text("utf-8") for name in ("slotter", "governor_porter")
}
EACH = 25


def mistyped(text: str, how: str) -> Iterator[tuple[int, str]]:
    """The line of a slip, and the text with it."""
    body = text.index("\n")  # a first line of comment goes on over several
    places = [n for n, char in enumerate(text) if n > body and (how == "left out" or char in ALIKE)]
    for place in sorted(random.Random(7).sample(places, min(EACH, len(places)))):
        put = "" if how == "left out" else ALIKE[text[place]]
        yield text.count("\n", 0, place) + 1, text[:place] + put + text[place + 1 :]


def mistakes(text: str) -> list[Problem]:
    try:
        loading.loads(text, "v")
    except ProblemError as error:
        return error.problems
    return []


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("how", ["left out", "of another script"])
def test_the_line_of_a_mistyped_letter_is_told(name, how):
    for line, text in mistyped(TEXTS[name], how):
        found = mistakes(text)
        near = [one for one in found if abs((one.line or 0) - line) <= 1 or f"line {line}" in one.text()]
        assert near or not found, (line, text.split("\n")[line - 1], [one.text() for one in found])
