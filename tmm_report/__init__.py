"""tmm-report: course projects in the theory of mechanisms and machines, from a YAML variant to a finished note.

>>> from tmm_report import load, render, solve
>>> results = solve(load("variants/compressor.yaml"))
>>> files = render(results, "html")
>>> list(files)
['note.html']

What is heavy is imported only when it is needed: the solver by `load`, templates and drawings by `render`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    from tmm_report.course import Results, Variant
    from tmm_report.interactive.solved import Solved
    from tmm_report.interactive.source import Source
    from tmm_report.interactive.sweeps import Sweep
    from tmm_report.problems import ProblemError

__version__ = "0.1.0"
__all__ = ["load", "render", "solve", "sweep"]


def load(source: Source) -> Variant:
    """Read and check a variant: a file by its path, its text, or a dict of the same keys. Numbers are in SI, a planar
    vector is a complex number.

    >>> variant = load("variants/compressor.yaml")
    >>> variant.lever.mechanism.driver.link, round(variant.lever.mechanism.driver.omega, 2)
    ('1', -125.66)

    What has a line's end or begins with a brace is a text; what a department states stands beside a file alone.
    A mechanism or gears that the variant has not are None: `variant.lever`, `variant.drive`, `variant.eccentric`.
    Raises `problems.ProblemError` with all mistakes of the file, each with its line, column and key.
    """
    from tmm_report.interactive.source import load as read

    return read(source)


def solve(variant: Variant) -> Solved:
    """Solve what a variant asks, chapter by chapter.

    >>> results = solve(load("variants/compressor.yaml"))
    >>> results.lever.structure.formula
    'I(0,1) → II2(2,3) → II2(4,5)'
    >>> results.lever.kinetostatics.table.balancing.shape
    (13,)
    >>> round(results.drive.ratio, 3), results.eccentric is None
    (-13.2, True)

    By name, with unit and symbol (see `interactive.solved.Solved`; a notebook shows results and figures by themselves):

    >>> results["H_B"]
    H_B = 0.2 m
    >>> results["v_B"].unit, results["v_B"].shape, float(results["H_B"].to("mm").round(3))
    ('m/s', (13,), 200.0)
    >>> results.figure("travel:B").number
    '4'

    A chapter that the variant does not ask for is None. Raises `problems.ProblemError` with what cannot be solved
    and why, and the place of its key in the file.
    """
    from tmm_report.backwards import solve as run
    from tmm_report.interactive.solved import Solved
    from tmm_report.problems import ProblemError
    from tmm_report.variant import failed

    try:
        return Solved.of(run(variant, each=_together))
    except ProblemError as error:
        raise failed(error, variant) from None


def sweep(variant: Variant | Source, values: Mapping[str, Sequence[Any]]) -> Sweep:
    """Solve a variant with every combination of values of some keys, those of one topology at once.

    >>> s = sweep("variants/crank_rocker.yaml", {"mechanism.driver.speed": ["60 rpm", "120 rpm"]})
    >>> s["n_1"]
    n, rpm: [ 60. 120.]
    >>> s["V_3_max"].shape
    (2,)

    See `interactive.sweeps`.
    """
    from tmm_report.interactive.sweeps import sweep as run

    return run(variant, values)


def _together(variants: Sequence[Variant]) -> Iterator[Results | ProblemError]:
    """What a question asked backwards tries, variants of one topology at once."""
    from tmm_report.stack import solve_each

    return solve_each(variants)


def render(
    results: Results,
    fmt: Literal["html", "tex", "json", "csv", "png", "dxf", "sheets", "docx"] = "html",
    language: str | None = None,
    depth: Literal["short", "course", "full"] | None = None,
) -> dict[str, bytes]:
    """The note with its figures, or the numbers, as file name -> content.

    >>> results = solve(load("variants/compressor.yaml"))
    >>> list(render(results, "json"))
    ['results.json']
    >>> "tables/balancing_table.csv" in render(results, "csv")
    True

    `language`: of the note, that of the variant unless another of `languages` is named; `depth`: how much it says.
    """
    from tmm_report.commands.files import render as make

    return make(results, fmt, language, depth)
