"""The harness of `python -m benchmarks.fuzz`: the same cases by the same seed, what it calls a finding, a few cases."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parents[2]))

from benchmarks.fuzz import workers
from benchmarks.fuzz.__main__ import Cases
from benchmarks.fuzz.judge import MEGABYTES, SECONDS, Outcome, tried, unsaid
from benchmarks.fuzz.report import Report
from tmm_report.problems import Message, Problem


@pytest.fixture(scope="module")
def cases() -> Cases:
    return Cases(1)


@pytest.mark.exhaustive
def test_a_seed_always_makes_the_same_cases(cases):
    again = Cases(1)
    made = [cases.text(k) for k in range(40)]
    assert made == [again.text(k) for k in range(40)]
    assert len({text for text, _ in made}) > 35
    assert made != [Cases(2).text(k) for k in range(40)]


@pytest.mark.exhaustive
def test_a_few_cases_solve_or_are_refused_in_words(cases):
    kinds = []
    for k in range(24):
        outcome = tried(cases.text(k)[0], rendered=False)
        assert not outcome.finding or outcome.finding in ("memory", "time"), cases.text(k)[1]
        kinds.append(outcome.kind)
    assert {"solved", "refused"} == set(kinds)


@pytest.mark.parametrize(
    ("outcome", "finding"),
    (
        (Outcome("solved", 1.0, 100.0), ""),
        (Outcome("refused", SECONDS + 1, 100.0), "time"),
        (Outcome("solved", 1.0, MEGABYTES + 1), "memory"),
        (Outcome("KeyError", 1.0, 100.0, place="a.py:1"), "KeyError a.py:1"),
    ),
)
def test_what_is_a_finding(outcome, finding):
    assert outcome.finding == finding


def test_a_message_without_its_words_or_values_is_told():
    lines = [
        Message("some words that nobody has translated"),
        "as it is",
        Message("written: %(files)s", {"files": "%(x)s"}),
    ]
    assert [line.split(":")[0] for line in unsaid(lines)] == ["no words", "values left out"]
    assert list(unsaid([Problem(Message("the file has no variant"))])) == []


def test_a_case_that_ends_its_process_is_told_and_the_rest_goes_on():
    def case(k: int) -> Outcome:
        if k == 1:
            os._exit(3)
        return Outcome("solved", 0.0, 1.0)

    found = dict(workers.outcomes(range(4), case))
    assert {k: outcome.kind for k, outcome in found.items()} == {
        0: "solved",
        1: "Killed",
        2: "solved",
        3: "solved",
    }


def test_findings_are_kept_with_their_texts(tmp_path):
    report = Report(tmp_path, "")
    for k in range(5):
        report.add(k, Outcome("KeyError", 0.1, 90.0, place="a.py:1", told="Traceback"), f"text {k}", "word")
    report.add(5, Outcome("solved", 0.1, 90.0, words=("no words: x",)), "text 5", "")
    report.add(6, Outcome("refused", 0.1, 90.0, told="a reason"), "text 6", "")
    report.close()
    table = (tmp_path / "table.md").read_text()
    assert "| findings | 5 |" in table and "- 5 × KeyError a.py:1" in table and "- 1 × no words: x" in table
    assert sorted(file.read_text() for file in tmp_path.glob("*.yaml")) == [f"text {k}" for k in (0, 1, 2, 5)]
    assert "- 1 × a reason" in table
