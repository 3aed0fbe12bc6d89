"""A project of a plunger pump with slips of the pen in it, and what is said of them."""

from __future__ import annotations

from pathlib import Path

from tmm_report import loading
from tmm_report.problems import Problem, ProblemError

PUMP = (Path(__file__).parents[1] / "edges" / "pump.yaml").read_text("utf-8")


def typed(*slips: tuple[str, str], text: str = PUMP) -> str:
    """The text with each first occurrence of the one made the other."""
    for right, wrong in slips:
        assert right in text, right
        text = text.replace(right, wrong, 1)
    return text


def said(*slips: tuple[str, str], text: str = PUMP) -> list[Problem]:
    """Mistakes of the text, or else its doubts."""
    try:
        return list(loading.loads(typed(*slips, text=text), "v").doubts)
    except ProblemError as error:
        return error.problems


def lines(*slips: tuple[str, str], text: str = PUMP) -> list[str]:
    """The same as they are printed, without the name of the file."""
    return [problem.text().removeprefix("v:") for problem in said(*slips, text=text)]
