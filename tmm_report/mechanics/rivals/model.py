"""What a method is: one way to a quantity, called as all its rivals are, measured as they are.

A family of rivals shares its scene and what it finds: the motion of a mechanism (scene: its Cycle; found: a Motion),
its forces (scene: Loaded; found: Statics), an integral over the cycle, a start-up, the inverse involute. The error of
what is found is measured against 40 digits, `exact`, kept as two doubles that add up to the value.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Generic, TypeVar

import numpy as np

from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.forces.reactions import Load, Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import Message
from tmm_report.records import dataclass

Array = Any
Scene = TypeVar("Scene")
Found = TypeVar("Found")


@dataclass(frozen=True)
class Method(Generic[Scene, Found]):
    """One way to a quantity.

    `key`: name in a variant and in results, e.g. "newton"; `title`: id of its name in the user's language.
    `run(scene, count)`: what it finds at `count` equal steps of the cycle, the last included (count + 1 positions, as
    `Cycle.once`). What it cannot find at a position is nan there; where it breaks down as a whole it raises
    ArithmeticError, never anything else. `refuses(scene)`: why it cannot be used on this scene, None where it can.
    `settings`: what its error depends on beside the count, in words: "0.1 mm" of a drawing. `counted`: whether the
    count says anything to it; one that chooses its own steps is tried once, with the count 0.
    """

    key: str
    title: str
    run: Callable[[Scene, int], Found]
    refuses: Callable[[Scene], Message | None] = lambda scene: None
    settings: str = ""
    counted: bool = True


@dataclass(frozen=True, eq=False)
class Loaded:
    """Scene of the force methods: a motion and what acts on its links.

    `loads(motion)`: link -> everything that acts on it, inertia included, about the reference point of its state.
    """

    cycle: Cycle
    loads: Callable[[Motion], Mapping[str, Load]]


MotionMethod = Method[Cycle, Motion]
ForceMethod = Method[Loaded, Statics]


@dataclass(frozen=True, eq=False)
class Pair:
    """An exact value as two doubles, high + low; arrays of one shape."""

    high: Array
    low: Array

    def error(self, found: Array, size: Array | None = None) -> float:
        """Largest error of `found` (..., P), relative to `size` (..., 1), or else to the largest exact value of its
        row; nan if nothing was found where there is a value. A row whose size is zero is left out."""
        if size is None:
            size = np.nanmax(np.abs(self.high), axis=-1, keepdims=True, initial=0.0)
        off = np.abs((found - self.high) - self.low)
        with np.errstate(invalid="ignore", divide="ignore"):
            relative = np.where(size > 0, off / size, 0.0)
        known = np.isfinite(self.high) & (size > 0)
        lost = known & ~np.isfinite(found)
        return float("nan") if lost.any() else float(np.max(relative[known], initial=0.0))


@dataclass(frozen=True, eq=False)
class Trial:
    """One method on one scene: CPU seconds of one warm run (the least), and its errors by kind of quantity.

    `errors`: "place", "velocity", "acceleration" | "reaction", "moment" | … -> relative error. `broken`: why it found
    nothing, else None.
    """

    method: Method[Any, Any]
    count: int
    seconds: float
    errors: Mapping[str, float]
    broken: str | None = None
