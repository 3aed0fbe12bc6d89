"""Variants drawn from the schema: nothing of the schema is never drawn, and a few dozen are solved and written out.

`python -m benchmarks.fuzz --generated` draws as many as one likes.
"""

from __future__ import annotations

import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from exhaustive import many

sys.path.append(str(Path(__file__).parents[2]))

from benchmarks.fuzz.generated import after, numbers, rules, schema
from benchmarks.fuzz.generated.whole import text, variant
from benchmarks.fuzz.judge import Outcome, odd_words, tried, unbalanced

DRAWN, TRIED = 24000, 48


@cache
def outcome(k: int) -> Outcome:
    return tried(text(f"test {k}"), rendered=True)


@pytest.mark.exhaustive
def test_every_key_alternative_and_enum_value_of_the_schema_is_drawn():
    """A new key is drawn without a line of its own; one that a rule always takes away again is told here."""
    left = set(schema.every())
    for k in range(DRAWN):
        left -= set(schema.used(variant(f"1 {k}")))
        if not left:
            break
    assert not left, f"never drawn: {sorted(left)}"


@pytest.mark.exhaustive
def test_a_key_that_is_added_to_the_schema_is_missed_where_nothing_draws_it(monkeypatch):
    """The check above sees a key that is not drawn."""
    part = schema.part("ShuntModel")
    monkeypatch.setitem(part["properties"], "brushes", {"enum": ["copper", "carbon"]})
    marks = set(schema._every("ShuntModel", part, set()))
    assert {("ShuntModel", "brushes"), ("ShuntModel.brushes", "=", "carbon")} <= marks
    assert not any("brushes" in mark for mark in schema.used({"moment": 1}, "ShuntModel", part))
    drawn = set(schema.used({"brushes": "carbon"}, "ShuntModel", part))
    assert drawn == {("ShuntModel", "brushes"), ("ShuntModel.brushes", "=", "carbon")}


def test_what_is_said_of_parts_names_parts_of_the_schema():
    """A part that is renamed would be drawn without its rules, and nothing would tell."""
    said = (
        numbers.SIZES,
        rules.ONE,
        rules.SETS,
        rules.APART,
        rules.NEEDS,
        rules.RARE,
        rules.NAMED,
        rules.SIZED,
    )
    every = [key for table in (*said, rules.RUBBING, after.AFTER) for key in table]
    parts = {"Variant", *(schema.short(name) for name in schema.whole()["$defs"])}
    assert len(every) > 300
    assert not [key for key in every if key not in parts and key.rpartition(".")[0] not in parts]


def test_a_seed_always_makes_the_same_variant():
    assert [text(f"3 {k}") for k in range(5)] == [text(f"3 {k}") for k in range(5)]
    assert len({text(f"3 {k}") for k in range(40)}) > 35


@pytest.mark.exhaustive
@pytest.mark.parametrize("k", many(range(TRIED), 4))
def test_a_generated_variant_has_its_note_or_is_refused_in_words(k):
    found = outcome(k)
    assert not found.finding or found.finding in ("memory", "time"), found.told
    assert not found.words, found.words


@pytest.mark.exhaustive
def test_a_large_share_is_solved():
    kinds = Counter(outcome(k).kind for k in range(TRIED))
    assert kinds["solved"] > TRIED / 2, kinds


def test_what_no_page_should_say_is_seen():
    page = "<style>None</style><p title='nan'>v = nan m/s, nil, infinite</p><td>None</td>"
    assert [line.split(" in ")[0] for line in odd_words(page)] == ["on the page: nan", "on the page: None"]
    assert list(unbalanced(r"\begin{document}\textbf{a \{ b} % {" + "\n" + r"\end{document}")) == []
    assert list(unbalanced(r"\begin{document}\textbf{a \} b\end{document}"))
    assert list(unbalanced(r"\begin{a}\begin{b}\end{a}\end{b}"))
