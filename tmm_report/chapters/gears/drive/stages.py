"""The stages of a drive: which kinds there are, what each must tell the drive, and how each is solved.

A kind is its record (what the file states), its Found (a `Run`) and an arm of each `match` over them: here, and in the
drive's quantities, view and scheme.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Protocol, assert_never

from tmm_report.chapters.gears.drive.bounds import check_search
from tmm_report.chapters.gears.ordinary import solve as ordinary
from tmm_report.chapters.gears.ordinary.given import Ordinary, PairStage
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.mechanics.gears.trains import Member, Mesh
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

ROUNDED = 5e-7  # m: what a centre distance written in mm may differ by

Given = spur.Given | planetary.Given | ordinary.Given
Stage = spur.Found | planetary.Found | ordinary.Found


class Run(Protocol):
    """What a drive asks of a stage, whatever its kind.

    `members`, `meshes`: of which the train of the whole drive is made; `input`, `output`: the members that its shafts
    turn, `fixed`: those that stand still; `second`: the member and the speed, rad/s, of a second input. `wanted`,
    `ratio`: ω_in/ω_out asked for and found, signed, the second input at rest; `efficiency`: in this direction, 0..1.
    `sound`: whether its conditions are met; `doubts`: with places from the stage on; `summary`: what is wrong.
    """

    @property
    def name(self) -> str: ...
    @property
    def members(self) -> tuple[Member, ...]: ...
    @property
    def meshes(self) -> tuple[Mesh, ...]: ...
    @property
    def input(self) -> str: ...
    @property
    def output(self) -> str: ...
    @property
    def fixed(self) -> tuple[str, ...]: ...
    @property
    def second(self) -> tuple[str, float] | None: ...
    @property
    def wanted(self) -> float: ...
    @property
    def ratio(self) -> float: ...
    @property
    def efficiency(self) -> float: ...
    @property
    def angles(self) -> tuple[float | None, ...]:
        """Of every mesh the operating angle of pressure, rad; None of what has no teeth in one plane."""

    @property
    def shares(self) -> int:
        """Through how many like meshes side by side the power goes: satellites."""

    @property
    def sized(self) -> bool:
        """Whether its sizes are known, so that forces follow from torques."""

    @property
    def sound(self) -> bool: ...
    @property
    def doubts(self) -> tuple[Problem, ...]: ...
    def summary(self) -> list[Message]: ...


def run(stage: Stage) -> Run:
    """The stage as the drive sees it: that every kind is one, mypy holds here."""
    return stage


def solve_all(given: tuple[Given, ...]) -> tuple[Stage, ...]:
    """Every stage in its own room. Raises ProblemError with the mistakes of all of them."""
    found = [stage for stage in solve_known(given) if stage is not None]
    assert len(found) == len(given)  # those without a ratio have been given one
    return tuple(found)


def solve_known(given: tuple[Given, ...]) -> list[Stage | None]:
    """Those that have a ratio, None in the place of the others. Raises ProblemError likewise."""
    check_search(given)
    found: list[Stage | None] = []
    problems: list[Problem] = []
    for k, one in enumerate(given):
        try:
            found.append(None if is_open(one) else _solved(_on_axis(one, found[-1] if found else None)))
        except ProblemError as error:
            found.append(None)
            problems += [_placed(problem, k) for problem in error.problems]
    if problems:
        raise ProblemError(problems)
    return found


def is_open(given: Given) -> bool:
    """Whether the stage has the ratio that the drive leaves it."""
    return isinstance(given, spur.Given | PairStage) and given.open


def _on_axis(given: Given, before: Stage | None) -> Given:
    """A pair that leads back to the axis of the pair before it has the centre distance of that one. Raises ProblemError
    where there is none such, or another distance is stated."""
    if not isinstance(given, spur.Given) or not given.coaxial:
        return given
    if not isinstance(before, spur.Found):
        right = Message(
            N_("the stage before must be of kind: spur and without mistakes; else leave out coaxial")
        )
        raise ProblemError(
            [mistake(N_("no pair stands before this one to be coaxial with"), ("coaxial",), right)]
        )
    a_w, stated = float(before.pair.a_w), given.centre_distance
    if stated is not None and abs(stated - a_w) > ROUNDED:
        wrong = N_("the centre distance of %(stated)s mm is not that of the pair before, %(before)s mm")
        told = {"stated": f"{1e3 * stated:.6g}", "before": f"{1e3 * a_w:.6g}"}
        right = Message(N_("leave out centre_distance: it is that of the pair before"))
        raise ProblemError([mistake(wrong, ("centre_distance",), right, **told)])
    return replace(given, centre_distance=a_w)


@lru_cache(maxsize=32)
def _solved(given: Given) -> Stage:
    """The last ones are kept: the speed of a link that a drive turns is asked for before it is solved in its turn, a
    drive divides its ratio when its other stages are solved, and students of one class share the columns of a table of
    drives."""
    match given:
        case spur.Given():
            return spur.solve(given)
        case planetary.Given():
            return planetary.solve(given)
        case Ordinary():
            return ordinary.solve(given)
        case _:
            assert_never(given)


def working(stage: Stage, speed: float, torque: float | None) -> Stage:
    """The stage at the speed of its input, rad/s, and under the torque on it, N·m, where that is known."""
    match stage:
        case spur.Found():
            return spur.moving(stage, speed)
        case planetary.Found():
            return stage
        case ordinary.Found():
            return ordinary.working(stage, speed, torque)
        case _:
            assert_never(stage)


def doubts_of(stages: Iterable[Stage]) -> Iterator[Problem]:
    """What looks odd in the stages, each with its place in the variant."""
    for k, stage in enumerate(stages):
        yield from (_placed(problem, k) for problem in stage.doubts)


def _placed(problem: Problem, stage: int) -> Problem:
    """The problem of a stage with the stage's place in the variant before its own path."""
    return replace(problem, path=("drive", "stages", stage, *problem.path))


def member(stage: Stage, name: str) -> Member:
    """A member of the stage by its name."""
    return next(m for m in stage.members if m.name == name)
