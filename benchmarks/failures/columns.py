"""What each column finds on a scene: the program as `solve` runs it, every method alone, other programs."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from benchmarks.failures.judge import NONE, REFUSED, Cell, Found, judged, usual_errors
from benchmarks.failures.scenes import SCENES
from benchmarks.failures.truth import GRAVITY, KINDS, Truth, truth
from tmm_report import course, loading
from tmm_report.chapters.lever.kinematics.view.positions import CORNER, LIMIT, PASSED
from tmm_report.commands.solve import summary
from tmm_report.i18n import Translator
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.forces import FORCES
from tmm_report.mechanics.rivals.model import Loaded, MotionMethod
from tmm_report.mechanics.rivals.motion.every import MOTIONS, PLAIN_NEWTON
from tmm_report.problems import Message, Problem, ProblemError

HARMLESS = "harmless"
APPROXIMATE = 1e-9  # a method that is off by more on a harmless scene is so everywhere
OURS = "the program"
ROOT = Path(__file__).parents[2]


@dataclass
class Listener:
    """Keeps what the console is told."""

    lines: list[str] = field(default_factory=list)

    def tell(self, line: Message | str) -> None:
        self.lines.append(str(line))

    def warn(self, line: Message | Problem | str) -> None:
        self.lines.append(line.text() if isinstance(line, Problem) else str(line))

    def speak(self, language: str) -> None: ...

    def stage(self, doing: Message) -> None: ...


@dataclass(frozen=True, eq=False)
class Solved:
    """A scene as the program solves it; `problem`: why it refuses all of it."""

    results: Any
    lines: tuple[str, ...]
    problem: str = ""

    @property
    def kinematics(self) -> Any:
        return self.results.lever.kinematics


@cache
def solved(key: str) -> Solved:
    try:
        variant = loading.loads(yaml.safe_dump(SCENES[key].variant, sort_keys=False))
        results = course.solve(variant)
    except ProblemError as error:
        return Solved(None, (), " ".join(problem.text() for problem in error.problems))
    listener = Listener()
    summary(results, Translator("en"), listener)  # type: ignore[arg-type]
    return Solved(results, tuple(listener.lines))


@cache
def exact(key: str) -> Truth:
    k = solved(key).kinematics
    return truth(SCENES[key], k.cycle, [float(x) for x in k.table.phi])


def ours(key: str) -> Cell:
    """As `tmm-report solve` prints it: places, rates, reactions, the balancing moment, and what is said of them."""
    found = solved(key)
    if found.problem:
        return Cell(REFUSED, word=found.problem)
    lever = found.results.lever
    table = lever.kinetostatics.table
    values = {**of_motion(lever.kinematics.table), **of_forces(table.statics)}
    values["force", "balancing"] = table.balancing
    return judged(exact(key), values, (*KINDS, "force"), words(found))


def words(found: Solved) -> str:
    """What the program says beside the numbers, in short; the sentences stand in `found.lines` and in the note."""
    k, said = found.kinematics, []
    if k.gaps:
        said.append("parallel guides told" if k.cycle.poles.size else "gap told")
    changes = [x for one in k.closest for x in one.changes]
    corners = [x for one in k.closest for x in one.corners]
    if changes and len(corners) < len(changes):
        said.append("change points told")
    if corners:
        said.append("corner told")
    if k.near:
        said.append(f"{min(one.digits for one in k.near)} digits told")
    if k.undefined:
        said.append("positions without rates told")
    return ", ".join(said)


def noted(found: Solved) -> list[str]:
    """What the note says of change points, beside what the console says."""
    said = []
    for one in found.kinematics.closest:
        passed = tuple(x for x in one.changes if x not in one.corners)
        for angles, text in ((passed, PASSED), (one.corners, CORNER), (one.limits, LIMIT)):
            if angles:
                where = ", ".join(f"{np.degrees(x):.3f}°" for x in angles)
                said.append(
                    str(Message(text, {"group": one.group, "links": ", ".join(one.links), "angles": where}))
                )
    return said


def of_motion(motion: Motion) -> dict[tuple[str, str], Any]:
    values: dict[tuple[str, str], Any] = {}
    with np.errstate(all="ignore"):
        for point in motion.point_index:
            values["place", point] = motion.place(point)
            values["velocity", point] = motion.velocity(point)
            values["acceleration", point] = motion.acceleration(point)
    return values


def of_forces(found: statics.Statics) -> dict[tuple[str, str], Any]:
    return {("force", key): r.force for key, r in found.reactions.items()} | {
        ("force", "balancing"): found.balancing
    }


# ---------------------------------------------------------------- methods of motion and of forces


def motion_methods() -> tuple[MotionMethod, ...]:
    found = list(MOTIONS)
    found.insert(2, PLAIN_NEWTON)
    return tuple(found)


def by_method(key: str, method: MotionMethod) -> Cell:
    found = _motion(key, method)
    if isinstance(found, Cell):
        return found
    return judged(exact(key), of_motion(found), KINDS, usual=usual(method))


@cache
def usual(method: MotionMethod) -> Mapping[str, float]:
    found = _motion(HARMLESS, method)
    if isinstance(found, Cell):
        return {}
    errors = usual_errors(exact(HARMLESS), of_motion(found))
    return errors if max(errors.values()) > APPROXIMATE else {}


def _motion(key: str, method: MotionMethod) -> Motion | Cell:
    one = solved(key)
    if one.problem:
        return Cell(NONE)
    cycle = one.kinematics.cycle
    if (why := method.refuses(cycle)) is not None:
        return Cell(REFUSED, word=str(why)) if method.key != "parallelogram" else Cell(NONE)
    try:
        return method.run(cycle, one.kinematics.positions.table)
    except ArithmeticError as error:
        return Cell(REFUSED, word=str(error))


def by_force_method(key: str, method: Any) -> Cell:
    """Forces under weight and inertia, on the motion by groups."""
    one = solved(key)
    if one.problem:
        return Cell(NONE)
    loaded = Loaded(one.kinematics.cycle, lambda motion: statics.inertia_and_gravity(motion, GRAVITY))
    if (why := method.refuses(loaded)) is not None:
        return Cell(REFUSED, word=str(why))
    try:
        found = method.run(loaded, one.kinematics.positions.table)
    except ArithmeticError as error:
        return Cell(REFUSED, word=str(error))
    return judged(exact(key), _by_position(found, exact(key)), ("force",), usual=_usual_force(method))


@cache
def _usual_force(method: Any) -> Mapping[str, float]:
    one = solved(HARMLESS)
    loaded = Loaded(one.kinematics.cycle, lambda motion: statics.inertia_and_gravity(motion, GRAVITY))
    found = method.run(loaded, one.kinematics.positions.table)
    errors = usual_errors(exact(HARMLESS), _by_position(found, exact(HARMLESS)))
    return errors if max(errors.values(), default=0.0) > APPROXIMATE else {}


def _by_position(found: statics.Statics, true: Truth) -> Found:
    shape = (len(true.angles),)
    return {key: np.broadcast_to(value, shape) for key, value in of_forces(found).items()}


def force_methods() -> tuple[Any, ...]:
    return FORCES


# ---------------------------------------------------------------- other programs


def peers(python: Path | None) -> dict[str, dict[str, Cell]]:
    """Peer -> scene -> cell, run by an interpreter in which they are installed; {} where there is none."""
    if python is None or not python.exists():
        return {}
    asked = {
        key: {"peer": scene.peer, "phi": _rising(exact(key).angles)}
        for key, scene in SCENES.items()
        if scene.peer and not solved(key).problem
    }
    done = subprocess.run(
        [str(python), "-m", "benchmarks.failures.peers"],
        input=json.dumps(asked),
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=False,
    )
    if done.returncode:
        print(done.stderr[-2000:], file=sys.stderr)
        return {}
    said = json.loads(done.stdout.splitlines()[-1])
    return {peer: _peer_cells(rows) for peer, rows in said.items()}


def _rising(angles: Sequence[float]) -> list[float]:
    """Angles of one turn in equal steps, the last a turn after the first."""
    step = angles[1] - angles[0]
    return [angles[0] + k * step for k in range(len(angles))]


def _peer_cells(rows: Mapping[str, Mapping[str, Any]]) -> dict[str, Cell]:
    usual = usual_errors(exact(HARMLESS), _of_peer(rows[HARMLESS]))
    if max(usual.values(), default=0.0) <= APPROXIMATE:
        usual = {}
    return {
        key: Cell(REFUSED, word=found["refused"])
        if "refused" in found
        else judged(exact(key), _of_peer(found), KINDS, usual=usual)
        for key, found in rows.items()
    }


def _of_peer(found: Mapping[str, Any]) -> dict[tuple[str, str], Any]:
    kinds = {"B": "place", "v_B": "velocity", "a_B": "acceleration"}
    return {
        (kind, "B"): np.array([complex(*z) for z in found[name]])
        for name, kind in kinds.items()
        if name in found
    }
