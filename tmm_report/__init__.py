"""tmm-report: course projects in the theory of mechanisms and machines, from a YAML variant to a finished note.

from tmm_report import load, solve, render
results = solve(load("variant.yaml"))
files = render(results, "html")
"""

from __future__ import annotations

from typing import Any

__version__ = "0.1.0"
__all__ = ["load", "render", "solve"]


def load(path: Any) -> Any:
    """Read and check a variant file: a `course.Variant`. Raises `problems.ProblemError` with all mistakes."""
    from tmm_report.variant import load as read

    return read(path)


def solve(variant: Any) -> Any:
    """Solve what a variant asks: `course.Results`. Raises `problems.ProblemError` where that cannot be done."""
    from tmm_report.course import solve as run
    from tmm_report.problems import ProblemError
    from tmm_report.variant import locate

    try:
        return run(variant)
    except ProblemError as error:
        raise ProblemError([locate(problem, variant) for problem in error.problems]) from None


def render(results: Any, fmt: str = "html", language: str | None = None) -> dict[str, bytes]:
    """The note and its figures as file name -> content; `fmt`: "html", "tex", "json" or "csv"."""
    from tmm_report.commands.files import render as make

    return make(results, fmt, language)
