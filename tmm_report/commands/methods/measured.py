"""Every method that a solved variant lets be compared, run and timed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.course import LeverFound, Results, room
from tmm_report.mechanics.rivals.choice import choose
from tmm_report.mechanics.rivals.counts import Counted
from tmm_report.mechanics.rivals.model import Method
from tmm_report.mechanics.rivals.trials import COUNTS, Judged, Rivals, run_off, trials
from tmm_report.problems import N_
from tmm_report.records import dataclass

SECONDS, QUICK = 6.0, 1.0  # of taking turns, in all
ARRAYS = (100, 10_000)  # angles of an inverse involute
SIZED = {"motion", "forces", "work"}  # whose counts are positions of the cycle


@dataclass(frozen=True, eq=False)
class Measured(Judged):
    """The rivals for one thing, as run, with measured seconds."""

    title: str


@dataclass(frozen=True, eq=False)
class All:
    """`auto`: the key of the method that `method: auto` takes; `counted`: how many positions are enough."""

    families: tuple[Measured, ...]
    accuracy: float
    auto: str | None
    counted: Counted | None

    @property
    def motion(self) -> Measured | None:
        return next((one for one in self.families if one.key == "motion"), None)


def measured(results: Results, accuracy: float, stated: bool, quick: bool) -> All:
    """`stated`: whether the accuracy is the variant's or the user's, and not what is usual."""
    scenes = list(_scenes(results))
    seconds = (QUICK if quick else SECONDS) / max(1, len(scenes))
    families = tuple(_family(*scene, accuracy, seconds) for scene in scenes)
    lever = results.lever
    auto = choose(lever.kinematics.cycle, _asked(lever), accuracy).taken.key if lever else None
    return All(families, accuracy, auto, _counted(results, accuracy if stated else None) if lever else None)


def _family(
    key: str, title: str, rivals: Rivals[Any, Any], asked: Sequence[int], accuracy: float, seconds: float
) -> Measured:
    found = trials(rivals, seconds)
    order = {method.key: k for k, method in enumerate(rivals.methods)}
    found.sort(key=lambda one: (order[one.method.key], one.count))
    judged = Measured(key, tuple(found), tuple(rivals.refused), accuracy, tuple(asked), title)
    return run_off(rivals, judged, seconds / 2)


Scene = tuple[str, str, Rivals[Any, Any], Sequence[int]]


def _scenes(results: Results) -> Iterator[Scene]:
    """Key, title and rivals of everything that the variant has, and the counts by which the cheapest is found."""
    if results.lever is not None:
        yield from _of_lever(results.lever)
    if results.dynamics is not None and results.dynamics.start is not None:
        yield from _start_up(results.dynamics.start)
    if angles := list(_angles(results)):
        yield from _involutes(angles)


def _of_lever(lever: LeverFound) -> Iterator[Scene]:
    scenes, asked = room("methods", "scenes"), _asked(lever)
    counts = tuple(sorted({*(count * lever.kinematics.cycle.turns for count in COUNTS), *asked}))
    yield "motion", N_("Methods of the motion"), scenes.motions(lever.kinematics, counts), asked
    if lever.kinetostatics is not None:
        acting = room("kinetostatics", "solve.acting_exact").acting
        yield "forces", N_("Methods of the forces"), scenes.forces(lever.kinetostatics, counts, acting), asked
    rivals = scenes.work(scenes.Moving(lever.kinematics, lever.kinetostatics), counts)
    if rivals is not None:
        yield "work", N_("Methods of the work over the cycle"), rivals, ()


def _asked(lever: LeverFound) -> tuple[int, ...]:
    """Steps of the table and of the diagrams."""
    return tuple(dict.fromkeys((lever.kinematics.positions.table, lever.kinematics.positions.diagram)))


def _counted(results: Results, accuracy: float | None) -> Counted | None:
    """Of the machine with the friction that its flywheel has."""
    lever, flywheel = results.lever, results.variant.flywheel
    assert lever is not None
    friction = lever.friction if flywheel is None or flywheel.friction else None
    moving = room("methods", "scenes").Moving(lever.kinematics, lever.kinetostatics, friction)
    found: Counted | None = room("methods", "counting").counting(moving, accuracy)
    return found


def _start_up(run: Any) -> Iterator[Scene]:
    from tmm_report.mechanics.rivals import run_up

    scene = run_up.scene_of(run)
    try:
        true = run_up.reference(scene)
    except ArithmeticError:
        return  # so stiff that nothing is there to judge by
    rivals = Rivals(run_up.RUN_UPS, scene, lambda _, found: run_up.errors(true, found), run_up.STEPS)
    yield "start_up", N_("Methods of the start-up"), rivals, ()


def _angles(results: Results) -> Iterator[float]:
    """The working pressure angles of the spur pairs, rad."""
    for stage in results.drive.stages if results.drive is not None else ():
        pair = getattr(stage, "pair", None)
        if pair is not None:
            yield float(pair.alpha_w)


def _involutes(angles: Sequence[float]) -> Iterator[Scene]:
    """Involute functions from nothing to those of the pairs and beyond, as many angles as an array has."""
    from tmm_report.mechanics.gears.involute import inv
    from tmm_report.mechanics.rivals.exact.gears import inverse
    from tmm_report.mechanics.rivals.involutes import INVOLUTES

    few = np.concatenate([inv(np.array(angles)), np.geomspace(1e-6, 5.0, 13)])
    true = np.array([float(inverse(v)) for v in few])

    def errors(count: int, found: Any) -> dict[str, float]:
        own = np.asarray(found)[: len(true)]
        return {"angle": float(np.max(np.abs(own - true) / true))}

    def sized(method: Method[Any, Any]) -> Method[Any, Any]:
        return Method(
            method.key, method.title, lambda v, count: method.run(np.resize(v, count), count), method.refuses
        )

    rivals = Rivals([sized(method) for method in INVOLUTES], few, errors, ARRAYS)
    yield "involute", N_("Methods of the inverse involute"), rivals, ARRAYS
