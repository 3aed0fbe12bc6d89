"""Whether a drawn variant can be set: loaded and solved like any other, and held against what the ranges ask of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from tmm_report import course, loading
from tmm_report.assignments.conditions import holds
from tmm_report.assignments.fill import Form
from tmm_report.assignments.model import Bound, Ranges
from tmm_report.assignments.numbers import Cell, written
from tmm_report.course import OTHERS, LeverFound, Results, Variant
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.quantity.model import Value
from tmm_report.quantity.units import WrongValue, between
from tmm_report.records import dataclass
from tmm_report.results import values
from tmm_report.variant.department import Department, beside
from tmm_report.variant.errors import near

CLOSENESS = 0.1  # of a group to a singular position, where the ranges state none


@dataclass(frozen=True)
class Rejection:
    """Why a variant was not taken. Those of one `kind` are counted together."""

    kind: str
    why: Message


@dataclass(frozen=True)
class Limits:
    """Bounds of a result in its own unit; None: no limit. `text`: as stated."""

    key: str
    low: float | None
    high: float | None
    text: str


@dataclass(frozen=True, eq=False)
class Proof:
    """What every variant is held against. `whole`: whether the gears change, too, and are solved every time."""

    ranges: Ranges
    form: Form
    limits: tuple[Limits, ...]
    closeness: float
    whole: bool
    department: Department | None = None  # whose file stands beside the template

    def rejects(self, cells: Mapping[str, Cell], person: Mapping[str, str]) -> Rejection | None:
        """Why a variant cannot be set; None of one that can."""
        for one in self.ranges.conditions:
            if not holds(one, cells, {p.name: p for p in self.ranges.parameters}):
                why = Message(
                    N_("the condition %(condition)s is not met"), {"condition": shown(one.text, 80)}
                )
                return Rejection(one.text, why)
        try:
            variant = loading.loads(
                self.form.text(self.ranges.parameters, cells, person), department=self.department
            )
            results = course.solve(variant if self.whole else _lever(variant))
        except ProblemError as error:
            return _unsolved(error.problems[0])
        return next(self._wrong(results), None)

    def _wrong(self, results: Results) -> Iterator[Rejection]:
        if results.lever is not None:
            yield from _unsound(results.lever, self.closeness)
        if self.limits:
            found = {value.key: value for value in values(results)}
            yield from (wrong for limits in self.limits if (wrong := _outside(limits, found)))


def _lever(variant: Variant) -> Variant:
    """The variant without gears, which are the template's own and are solved with it."""
    return replace(variant, train=None, drive=None, eccentric=None)


def _unsolved(problem: Problem) -> Rejection:
    why = (
        Message("%(key)s: %(what)s", {"key": problem.key, "what": problem.wrong})
        if problem.key
        else problem.wrong
    )
    return Rejection(problem.wrong.text, Message(N_("it cannot be solved: %(why)s"), {"why": why}))


def _unsound(lever: LeverFound, closeness: float) -> Iterator[Rejection]:
    if lever.partial:
        yield Rejection("partial", Message(N_("it cannot be assembled all over the cycle")))
    if lever.kinematics.missed is not None:
        yield Rejection("method", Message(N_("the method of the motion does not hold the accuracy")))
    forces = lever.kinetostatics
    if forces is not None and not forces.agrees:
        yield Rejection("balance", Message(N_("the checks of the balancing moment disagree")))
    for one in lever.kinematics.closest if closeness > 0 else ():
        if not one.closeness.value >= closeness:
            text = N_("group %(group)s comes nearer than %(least)s to a singular position")
            yield Rejection(f"close {one.group}", Message(text, {"group": one.group, "least": closeness}))


def _outside(limits: Limits, found: Mapping[str, Value]) -> Rejection | None:
    number = found[limits.key].value if limits.key in found else float("nan")
    low = limits.low is None or number >= limits.low - 1e-12 * abs(limits.low)
    high = limits.high is None or number <= limits.high + 1e-12 * abs(limits.high)
    if low and high:
        return None
    text = N_("%(key)s is outside %(limits)s")
    return Rejection(f"require {limits.key}", Message(text, {"key": limits.key, "limits": limits.text}))


# ---------------------------------------------------------------- from the template


def proof(ranges: Ranges, form: Form) -> Proof:
    """What the variants of the ranges are held against. Raises ProblemError where the template itself is wrong."""
    template = loading.load(ranges.template.source)
    lever = template.lever and replace(template.lever, readings={})
    results = course.solve(replace(template, lever=lever))
    found = {value.key: value for value in values(results)}
    limits = _limits(ranges, found)
    of_lever = {value.key for value in values(replace(results, train=None, drive=None, eccentric=None))}
    touched = {path[0] for parameter in ranges.parameters for path in parameter.paths}
    whole = not touched.isdisjoint(OTHERS) or any(one.key not in of_lever for one in limits) or lever is None
    partial = lever is not None and lever.allow_partial
    closeness = ranges.closeness if ranges.closeness is not None else 0.0 if partial else CLOSENESS
    return Proof(ranges, form, limits, closeness, whole, beside(ranges.template.source))


def _limits(ranges: Ranges, found: Mapping[str, Value]) -> tuple[Limits, ...]:
    limits, problems = [], list[Problem]()
    for bound in ranges.bounds:
        try:
            limits.append(_limit(bound, found))
        except WrongValue as error:
            line, column = bound.place or (None, None)
            problems.append(
                Problem(error.wrong, error.right, ("require", shown(bound.key)), ranges.file, line, column)
            )
    if problems:
        raise ProblemError(problems)
    return tuple(limits)


def _limit(bound: Bound, found: Mapping[str, Value]) -> Limits:
    """The bounds in the unit of the result; a number without a unit is in that unit already. Raises WrongValue."""
    if bound.key not in found:
        wrong = Message(N_("the template's results have no single value %(key)s"), {"key": shown(bound.key)})
        raise WrongValue(wrong, near(bound.key, list(found)))
    unit = found[bound.key].unit
    low, high = (None if side is None else _in_unit(side, unit) for side in (bound.low, bound.high))
    text = " … ".join("" if side is None else shown(side) for side in (bound.low, bound.high)).strip()
    return Limits(bound.key, low, high, text)


def _in_unit(side: object, unit: str) -> float:
    number, given = written(side)
    return float(number) * between(given, unit) if given else float(number)
