"""Any description of a mechanism either solves or is refused in words, in both languages: never a stack trace.

Every kind of mistake is made once in every ready variant; hypothesis piles several on one another.
"""

from __future__ import annotations

import json
import re
import warnings
from collections.abc import Iterator
from functools import cache
from itertools import islice
from zlib import crc32

import pytest
from conftest import FILES, examples
from exhaustive import many
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mutations import KINDS, Data, bare, changed
from notes import render

from tmm_report import solve
from tmm_report.course import Results
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.problems import Message, Problem, ProblemError
from tmm_report.yamlread import read

NAMES = [file.stem for file in FILES]
RUSSIAN = Translator("ru").gettext
every_kind = pytest.mark.parametrize(
    "kind", many(range(len(KINDS)), 3), ids=lambda kind: KINDS[kind].__name__
)


@cache
def description(name: str, whole: bool = True) -> Data:
    data = read(next(file for file in FILES if file.stem == name)).data
    return data if whole else bare(data)


def outcome(data: Data) -> Results | list[Problem]:
    """What is found, or the mistakes. Any other exception is a bug, and so is a warning of numpy."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            results = solve(loads(json.dumps(data, ensure_ascii=False), "v.yaml"))
        except ProblemError as error:
            return error.problems
        json.loads(render(results, "json")["results.json"], parse_constant=_refused)
        return results


def _refused(constant: str):
    raise AssertionError(f"{constant} in results.json")


def unsaid(problems: list[Problem]) -> list[str]:
    """Messages that cannot be printed or lack words in a language."""
    unfilled = [p.text() for p in problems if re.search(r"%\(|%%", p.text() + p.text(RUSSIAN))]
    messages = [
        part for p in problems for message in (p.wrong, p.right) if message for part in parts(message)
    ]
    return unfilled + [m.text for m in messages if _words(m.text) and RUSSIAN(m.text) == m.text]


def parts(message: Message) -> Iterator[Message]:
    """A message and those put into it."""
    yield message
    for value in message.values.values():
        if isinstance(value, Message):
            yield from parts(value)


def _words(text: str) -> bool:
    return re.search("[a-z]{3}", re.sub(r"%\(\w+\)", "", text)) is not None


@cache
def mistakes(kind: int, name: str) -> list[tuple[str, Data]]:
    """A kind of mistake at a place chosen by the names, in the whole variant or in the bare mechanism."""
    chosen = crc32(f"{name} {KINDS[kind].__name__}".encode())
    data = description(name, whole=chosen % 2 == 0)
    places = list(KINDS[kind](data))
    if not places:
        return []
    where, changes = places[chosen // 2 % len(places)]
    return [(f"{name}: {where}", changed(data, changes))]


@pytest.mark.exhaustive
@every_kind
def test_one_mistake_in_every_variant(kind):
    wrong, outcomes = [], []
    for name in NAMES:
        for where, data in mistakes(kind, name):
            try:
                outcomes.append(found := outcome(data))
            except Exception as error:
                wrong.append(f"{where}: {type(error).__name__}: {error}")
            else:
                wrong += [f"{where}: {text}" for text in (unsaid(found) if isinstance(found, list) else [])]
    assert not wrong, "\n" + "\n".join(wrong)
    assert outcomes


@every_kind
def test_every_kind_of_mistake_is_refused_somewhere(kind):
    """The first that is refused ends the search: a kind that is never refused breaks nothing and tests nothing."""
    every = (changed(description(n), changes) for n in NAMES for _, changes in KINDS[kind](description(n)))
    assert any(isinstance(outcome(data), list) for data in every), "no such mistake is ever refused"


@st.composite
def piles(draw: st.DrawFn) -> Data:
    """A variant with one to four mistakes."""
    data = description(draw(st.sampled_from(NAMES)), draw(st.booleans()))
    for kind in draw(st.lists(st.sampled_from(KINDS), min_size=1, max_size=4)):
        places = [changes for _, changes in kind(data)]
        if places:
            data = changed(data, places[draw(st.integers(0, len(places) - 1))])
    return data


@pytest.mark.exhaustive
@settings(
    max_examples=examples(150), suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large]
)
@given(piles())
def test_several_mistakes(data):
    found = outcome(data)
    assert not isinstance(found, list) or unsaid(found) == []


@every_kind
def test_what_still_solves_has_a_note(kind):
    """The first of a few variants that solves in spite of such a mistake."""
    start = crc32(KINDS[kind].__name__.encode()) % len(NAMES)
    tried = (data for k in range(6) for _, data in mistakes(kind, NAMES[(start + k) % len(NAMES)]))
    solved = (found for found in map(outcome, tried) if isinstance(found, Results))
    for results in islice(solved, 1):
        assert b"</html>" in render(results, "html")["note.html"]


@pytest.mark.exhaustive
def test_an_unchanged_description_solves():
    found = outcome(description("compressor"))
    assert isinstance(found, Results) and found.lever.structure.formula == "I(0,1) → II2(2,3) → II2(4,5)"
    assert isinstance(outcome(description("compressor", False)), Results)
