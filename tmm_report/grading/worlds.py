"""Mistakes in the whole of a work, recognised by solving the mechanism with the mistake in it: the other assembly, the
other sense of rotation, another number than the assignment's.

Each is a world of its own, in which everything hangs together as it should: what agrees with it was worked rightly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from tmm_report.backwards import solve
from tmm_report.course import Moved, Results, Variant, room
from tmm_report.judging.model import Name
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism, ZeroAngle
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.records import dataclass

Array = Any
Numbers = Mapping[Name, Array]
MOST_DYADS = 3  # all their assemblies are tried, of more each dyad's alone
STEP = 0.01  # of a datum, to see what depends on it
FARTHEST = 4.0  # times a datum is no slip of the eye
TRIES = 5
CLOSE = 1e-4
LIKELY = 3  # data looked at closely
SLACK = 3.0  # allowances by which a number may miss what is foretold from a small step
SOME = 0.4  # of the wrong cells that a datum must foretell to be looked at closely


@dataclass(frozen=True, eq=False)
class World:
    """`results`: of the mechanism with the mistake in it; `what`: the sentence, with room for the columns."""

    kind: str
    detail: str
    what: Message
    results: Results


def bare(results: Results) -> Variant:
    """The variant with its lever mechanism alone, and of that only what tables by positions need."""
    given = results.lever.given if results.lever is not None else None
    assert given is not None
    positions = replace(given.positions, plans=(), force_plan=(), diagram=given.positions.table)
    lever = replace(
        given, positions=positions, friction=None, reduction=False, readings={}, methods=None, way=None
    )
    return Variant(lever=lever, title=results.variant.title, language=results.variant.language)


def turned(results: Results) -> Iterator[World]:
    """The driving link turned the other way, positions numbered in its sense."""
    variant = bare(results)
    assert variant.lever is not None
    mechanism = variant.lever.mechanism
    if mechanism.driver.law is not None:  # it says itself which way the link turns, and when
        return
    driver = replace(mechanism.driver, omega=-mechanism.driver.omega)
    if (found := _solved(_with(variant, mechanism=replace(mechanism, driver=driver)))) is not None:
        yield World("reversed", "rotation", Message(TURNED), found)


def assembled(results: Results) -> Iterator[World]:
    """Groups put together the other way."""
    lever = results.lever
    assert lever is not None
    groups = lever.structure.linkage.groups
    able = [k for k, group in enumerate(groups) if type(group) is Dyad and group.two_roots]
    for chosen in _choices(able):
        flipped = tuple(
            replace(group, sign=-group.sign) if k in chosen and isinstance(group, Dyad) else group
            for k, group in enumerate(groups)
        )
        if (found := _otherwise(results, flipped)) is not None:
            links = ", ".join("-".join(groups[k].links) for k in chosen)
            yield World("assembly", links, Message(ASSEMBLED, {"links": links}), found)


def _choices(able: list[int]) -> Iterator[tuple[int, ...]]:
    if len(able) > MOST_DYADS:
        yield from ((k,) for k in able)
        return
    for mask in range(1, 2 ** len(able)):
        yield tuple(k for n, k in enumerate(able) if mask >> n & 1)


def _otherwise(results: Results, groups: tuple[Any, ...]) -> Results | None:
    variant, lever = bare(results), results.lever
    assert lever is not None and variant.lever is not None
    structure = replace(
        lever.structure, linkage=replace(lever.structure.linkage, groups=groups, straight=None)
    )
    try:
        motion = room("kinematics", "solve").solve(variant.lever.positions, structure)
        loads = variant.lever.loads
        forces = room("kinetostatics", "solve").solve(loads, motion) if loads else None
        return solve(variant, Moved(structure, motion, forces))
    except (ProblemError, ArithmeticError):
        return None


def _with(variant: Variant, **changes: Any) -> Variant:
    assert variant.lever is not None
    return replace(variant, lever=replace(variant.lever, **changes))


def _solved(variant: Variant) -> Results | None:
    try:
        return solve(variant)
    except (ProblemError, ArithmeticError):
        return None


# ---------------------------------------------------------------- another number than the assignment's


@dataclass(frozen=True, eq=False)
class Datum:
    """A number of the assignment: `key` as in its file, `value` in `unit`; `changed`: part by which it is taken too
    great -> the variant with it."""

    key: str
    value: float
    unit: str
    changed: Callable[[float], Variant]

    def text(self, part: float) -> str:
        return f"{self.value * (1 + part):.4g} {self.unit}"


def data(variant: Variant) -> Iterator[Datum]:
    """The numbers of a lever mechanism that may be read from another's row."""
    lever = variant.lever
    assert lever is not None
    mechanism = lever.mechanism
    yield from _lengths(variant, mechanism)
    yield from _masses(variant, mechanism)
    yield from _places(variant, mechanism)
    zero = mechanism.driver.zero
    if isinstance(zero, ZeroAngle) and mechanism.driver.law is None:
        yield _of_driver(variant, mechanism, zero)
    if lever.loads is not None:
        fixed = [(k, one) for k, one in enumerate(lever.loads.forces) if isinstance(one.direction, complex)]
        for k, force in fixed:
            yield Datum(f"loads.forces.{k}", 1.0, "×", _force(variant, k, force))


def _link(variant: Variant, name: str, change: Callable[[Any, float], Any]) -> Callable[[float], Variant]:
    assert variant.lever is not None
    mechanism = variant.lever.mechanism

    def changed(part: float) -> Variant:
        links = dict(mechanism.links) | {name: change(mechanism.links[name], 1 + part)}
        return _with(variant, mechanism=replace(mechanism, links=links))

    return changed


def _lengths(variant: Variant, mechanism: Mechanism) -> Iterator[Datum]:
    for name, link in mechanism.links.items():
        some = [point for point, at in link.points.items() if name != FRAME and at != 0]
        for point in some:

            def longer(link: Any, by: float, point: str = point) -> Any:
                return replace(link, points={**link.points, point: link.points[point] * by})

            key = f"mechanism.links.{name}.points.{point}"
            yield Datum(key, float(abs(link.points[point])), "m", _link(variant, name, longer))
        if len(some) > 1:
            longest = max(some, key=lambda point: float(abs(link.points[point])))

            def larger(link: Any, by: float) -> Any:
                return replace(link, points={point: at * by for point, at in link.points.items()})

            key = f"mechanism.links.{name}.points"
            yield Datum(key, float(abs(link.points[longest])), "m", _link(variant, name, larger))


def _masses(variant: Variant, mechanism: Mechanism) -> Iterator[Datum]:
    for name, link in mechanism.links.items():
        for what, unit in (("mass", "kg"), ("inertia", "kg·m²")):
            if name != FRAME and (value := float(getattr(link, what))) > 0:

                def heavier(link: Any, by: float, what: str = what) -> Any:
                    return replace(link, **{what: getattr(link, what) * by})

                yield Datum(f"mechanism.links.{name}.{what}", value, unit, _link(variant, name, heavier))


def _places(variant: Variant, mechanism: Mechanism) -> Iterator[Datum]:
    """Coordinates of the frame's points; a guide goes with the point that it goes through."""
    frame = mechanism.links[FRAME].points
    for point, at in frame.items():
        for axis, along in (("x", complex(at).real), ("y", 1j * complex(at).imag)):
            if along != 0:

                def moved(part: float, point: str = point, at: Array = at, along: complex = along) -> Variant:
                    links = dict(mechanism.links)
                    links[FRAME] = replace(links[FRAME], points={**frame, point: at + part * along})
                    guides = {
                        name: replace(guide, through=guide.through + part * along)
                        if guide.link == FRAME and guide.through == at
                        else guide
                        for name, guide in mechanism.guides.items()
                    }
                    return _with(variant, mechanism=replace(mechanism, links=links, guides=guides))

                value = float(along.real + along.imag)
                yield Datum(f"mechanism.frame.{point}.{axis}", value, "m", moved)


def _of_driver(variant: Variant, mechanism: Mechanism, zero: ZeroAngle) -> Datum:
    driver = mechanism.driver
    # where the angle is nought, parts of a radian are added
    angle = float(zero.angle) or 1.0

    def changed(part: float) -> Variant:
        at = ZeroAngle(angle=float(zero.angle) + part * angle)
        return _with(variant, mechanism=replace(mechanism, driver=replace(driver, zero=at)))

    return Datum("mechanism.driver.zero", angle, "rad", changed)


def _force(variant: Variant, k: int, force: Any) -> Callable[[float], Variant]:
    assert variant.lever is not None and variant.lever.loads is not None
    loads = variant.lever.loads

    def changed(part: float) -> Variant:
        forces = list(loads.forces)
        forces[k] = replace(force, direction=force.direction * (1 + part))
        return _with(variant, loads=replace(loads, forces=tuple(forces)))

    return changed


@dataclass(frozen=True, eq=False)
class Aim:
    """What is to be explained: the wrong cells of the work one after another, (W,): the `right` numbers, `mine`, and
    what may be missed by. `read`: the same cells of another solution."""

    right: Array
    mine: Array
    allowed: Array
    read: Callable[[Results], Array]


def misread(results: Results, aim: Aim) -> Iterator[World]:
    """The data that, taken otherwise, explain most; each with the number that explains most."""
    likely = []
    for datum, step in _steps(results):
        rate = (aim.read(step) - aim.right) / STEP
        part = _middle(aim.mine - aim.right, rate, aim.allowed)
        told = np.abs(aim.mine - aim.right - rate * part) <= SLACK * aim.allowed
        likely.append((int(told.sum()), datum, rate, part))
    likely.sort(key=lambda one: -one[0])
    for count, datum, rate, part in likely[:LIKELY]:
        if count >= SOME * len(aim.mine):
            yield from _fitted(datum, rate, part, aim)


@lru_cache(maxsize=1)  # works of one variant are marked one after another
def _steps(results: Results) -> tuple[tuple[Datum, Results], ...]:
    """Every datum, and the solution with it a little greater, where there is one."""
    found = ((datum, _solved(datum.changed(STEP))) for datum in data(bare(results)))
    return tuple((datum, step) for datum, step in found if step is not None)


def _middle(missed: Array, rate: Array, allowed: Array) -> float:
    """The change of a datum that explains most: of what each cell would have it, the weighted median."""
    some = np.isfinite(missed) & np.isfinite(rate) & (np.abs(rate) > allowed)
    if not some.any():
        return 0.0
    parts, weights = missed[some] / rate[some], np.minimum(np.abs(rate[some]) / allowed[some], 100.0)
    order = np.argsort(parts)
    heap = np.cumsum(weights[order])
    return float(parts[order][np.searchsorted(heap, heap[-1] / 2)])


def _fitted(datum: Datum, rate: Array, part: float, aim: Aim) -> Iterator[World]:
    found = None
    for _ in range(TRIES):
        part = float(np.clip(part, -0.9, FARTHEST))
        if abs(part) < STEP or (found := _solved(datum.changed(part))) is None:
            return
        now = aim.read(found)
        rate = np.where(np.abs(now - aim.right) > aim.allowed, (now - aim.right) / part, rate)
        more = _middle(aim.mine - now, rate, aim.allowed)
        if abs(more) < CLOSE:
            break
        part += more
    assert found is not None
    value = datum.text(part)
    what = Message(MISREAD, {"datum": datum.key, "value": value})
    yield World("datum", f"{datum.key} = {value}", what, found)


TURNED = N_("%(columns)s: the driving link was turned in the opposite sense")
ASSEMBLED = N_("%(columns)s: as if links %(links)s were put together the other way: the other assembly")
MISREAD = N_("%(columns)s: as with another number than the assignment's: %(datum)s = %(value)s")
