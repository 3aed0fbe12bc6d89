"""What every program is given: a crank and rods hung on it one after another, each ending in a slider or a rocker.

           C        a rod starts at a point of the crank or of an earlier rod;
      A---/----B    its end slides along a line parallel to the x axis (B), or turns about a pivot;
     /   /    [ ]   named points lie on the rod's line
    O   D

`motion` and `moment` are closed forms over any arithmetic: doubles, arrays of them, or mpmath's 40 digits, so that the
reference and the start of a simulation come from the same lines. SI, clockwise is minus, + x to the right.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

Array = Any
POSITIONS = 36
KINDS = ("position", "velocity", "acceleration", "moment")


@dataclass(frozen=True)
class Slider:
    """The rod's end on the line y = `offset`."""

    offset: float = 0.0
    mass: float = 1.0


@dataclass(frozen=True)
class Rocker:
    """The rod's end on a link that turns about `pivot`; its mass centre is the pivot."""

    pivot: complex
    length: float
    inertia: float = 0.01


@dataclass(frozen=True)
class Rod:
    """`side`: of a slider +1 to the right of `start`, −1 to the left; of a rocker +1 counter-clockwise of the line from
    `start` to the pivot. `points`: name -> distance from `start`; `centre` is one of them."""

    start: str
    end: str
    length: float
    out: Slider | Rocker
    side: int = 1
    points: Mapping[str, float] = field(default_factory=dict)
    mass: float = 1.0
    inertia: float = 0.01
    centre: str = ""

    def at(self, point: str) -> float:
        """Distance of a point of the rod from its start; of "" the middle."""
        return {self.start: 0.0, self.end: self.length, "": self.length / 2, **self.points}[point]


@dataclass(frozen=True)
class Scene:
    """`forces`: point at a rod's end -> force along x at the positions asked for, N. The crank has no mass."""

    crank: float
    rods: tuple[Rod, ...]
    omega: float = -1.0
    gravity: float = 0.0
    forces: Mapping[str, Array] = field(default_factory=dict)

    @property
    def points(self) -> tuple[str, ...]:
        """Every point that is compared, in the order of the rods."""
        return ("A", *(p for rod in self.rods for p in (rod.end, *rod.points)))

    def carrier(self, point: str) -> Rod | None:
        """The rod that has the point; None: the crank."""
        return next((rod for rod in self.rods if point == rod.end or point in rod.points), None)


def compressor() -> Scene:
    """The coursework's compressor with all its masses and gas forces (`variants/compressor.yaml`)."""
    right = Rod("A", "B", 0.3, Slider(mass=0.6), +1, {"C": 0.075, "S2": 0.15}, 1.5, 0.0135, "S2")
    left = Rod("C", "D", 0.31, Slider(mass=0.6), -1, {"S4": 0.155}, 1.55, 0.015, "S4")
    on_b = [2000, 1000, 0, 0, 0, 0, 0, 500, 1000, 1500, 2000, 2000]
    on_d = [0, 500, 1000, 1500, 2000, 2000, 2000, 1000, 0, 0, 0, 0]
    at = np.arange(POSITIONS) * 12 / POSITIONS
    forces = {"B": -np.interp(at, range(12), on_b, period=12), "D": np.interp(at, range(12), on_d, period=12)}
    return Scene(0.1, (right, left), -2 * np.pi / 0.05, -9.81, forces)


def slider_crank(r: float, l: float, offset: float = 0.0, side: int = 1) -> Scene:
    return Scene(r, (Rod("A", "B", l, Slider(offset), side),))


def four_bar(r: float, coupler: float, rocker: float, frame: float, side: int = 1) -> Scene:
    """Crank pivot at 0, the rocker's at `frame` on the x axis."""
    return Scene(r, (Rod("A", "B", coupler, Rocker(complex(frame), rocker), side),))


def angles(scene: Scene, count: int = POSITIONS, start: float = 0.0) -> Array:
    """`count` equal steps of a turn, the way the crank turns; the last is not the first again."""
    return start + np.sign(scene.omega) * np.arange(count) * (2 * np.pi / count)


# ---------------------------------------------------------------- closed forms


def motion(
    scene: Scene, phi: Any, exp: Callable[[Any], Any] = cmath.exp, sqrt: Callable[[Any], Any] = cmath.sqrt
) -> dict[str, Any]:
    """Place, velocity and acceleration of every point as "B", "v_B", "a_B"; "w_B", "e_B" of the rod that ends in B.

    Raises ZeroDivisionError at a dead point; places that do not exist come out with a complex root, so not to scale.
    """
    A, i = scene.crank * exp(1j * phi), 1j
    found = {"A": A, "v_A": i * scene.omega * A, "a_A": -scene.omega * scene.omega * A}
    for rod in scene.rods:
        P, v, a = (found[kind + rod.start] for kind in ("", "v_", "a_"))
        if isinstance(rod.out, Slider):
            y = rod.out.offset - P.imag
            along = rod.side * sqrt(rod.length * rod.length - y * y).real + i * y
            w = -v.imag / along.real
            e = -(a.imag - w * w * y) / along.real
        else:
            along, w, e = _rocker(rod, rod.out, P, v, a, sqrt)
        found |= {f"w_{rod.end}": w, f"e_{rod.end}": e}
        for point in (rod.end, *rod.points):
            arm = along * (rod.at(point) / rod.length)
            found[point] = P + arm
            found[f"v_{point}"], found[f"a_{point}"] = v + i * w * arm, a + (i * e - w * w) * arm
    return found


def _rocker(
    rod: Rod, out: Rocker, P: Any, v: Any, a: Any, sqrt: Callable[[Any], Any]
) -> tuple[Any, Any, Any]:
    """The rod from its start, its angular velocity and acceleration; P, v, a of the start."""
    D = out.pivot - P
    dd = D.real * D.real + D.imag * D.imag
    along = (dd + rod.length * rod.length - out.length * out.length) / 2
    across = sqrt(dd * rod.length * rod.length - along * along).real
    arm = (along + 1j * rod.side * across) * D / dd
    other = P + arm - out.pivot
    w = -_dot(v, other) / _dot(1j * arm, other)
    end = v + 1j * w * arm  # = i·ω·other
    turn = _dot(end, 1j * other) / _dot(other, other)
    e = -_dot(a - w * w * arm + turn * turn * other, other) / _dot(1j * arm, other)
    return arm, w, e


def _dot(one: Any, other: Any) -> Any:
    return one.real * other.real + one.imag * other.imag


def moment(scene: Scene, found: Mapping[str, Any], forces: Mapping[str, Any]) -> Any:
    """Moment of the drive on the crank, N·m, from the balance of powers: M·ω + ΣF·v + ΣM·ω = 0."""
    power = 0.0
    for rod in scene.rods:
        part = rod.at(rod.centre) / rod.length
        v, a = (found[k + rod.start] * (1 - part) + found[k + rod.end] * part for k in ("v_", "a_"))
        power = power + _dot(rod.mass * (1j * scene.gravity - a), v)
        power = (
            power - rod.inertia * found[f"e_{rod.end}"] * found[f"w_{rod.end}"] + _of_out(scene, rod, found)
        )
        power = power + _dot(forces.get(rod.end, 0.0) + 0j, found[f"v_{rod.end}"])
    return -power / scene.omega


def _of_out(scene: Scene, rod: Rod, found: Mapping[str, Any]) -> Any:
    """Power of weight and inertia of the slider or rocker."""
    out, v, a = rod.out, found[f"v_{rod.end}"], found[f"a_{rod.end}"]
    if isinstance(out, Slider):
        return _dot(out.mass * (1j * scene.gravity - a), v)
    arm = 1j * (found[rod.end] - out.pivot)
    return -out.inertia * _dot(a, arm) * _dot(v, arm) / _dot(arm, arm) ** 2


def starts(scene: Scene, phi: float) -> dict[str, complex]:
    """Places and rates at one angle in doubles, as a simulation starts from them."""
    return motion(scene, phi)


def reference(scene: Scene, phi: Array, digits: int = 40) -> dict[str, Array]:
    """Everything that is compared, at the same binary angles and data, in `digits` digits, then rounded: points,
    "v_"…, "a_"… (P,) complex, "moment" (P,)."""
    import mpmath

    rows = []
    with mpmath.workdps(digits):
        exactly = scene_in(scene, mpmath.mpf)
        for k, angle in enumerate(phi):
            found = motion(exactly, mpmath.mpf(float(angle)), mpmath.exp, mpmath.sqrt)
            row = {key: complex(value) for key, value in found.items()}
            forces = {point: mpmath.mpf(float(values[k])) for point, values in scene.forces.items()}
            rows.append(row | {"moment": float(moment(exactly, found, forces))})
    asked = [f"{kind}{point}" for kind in ("", "v_", "a_") for point in scene.points]
    return {key: np.array([row[key] for row in rows]) for key in [*asked, "moment"]}


def scene_in(scene: Scene, number: Callable[[float], Any]) -> Scene:
    """The scene with every length, speed, mass in another arithmetic; the forces stay."""

    def out(of: Slider | Rocker) -> Slider | Rocker:
        if isinstance(of, Slider):
            return Slider(number(of.offset), number(of.mass))
        return Rocker(
            number(of.pivot.real) + number(of.pivot.imag) * 1j, number(of.length), number(of.inertia)
        )

    def rod(of: Rod) -> Rod:
        points = {point: number(at) for point, at in of.points.items()}
        length, mass, inertia = number(of.length), number(of.mass), number(of.inertia)
        return replace(of, length=length, out=out(of.out), points=points, mass=mass, inertia=inertia)

    rods = tuple(map(rod, scene.rods))
    return Scene(number(scene.crank), rods, number(scene.omega), number(scene.gravity), scene.forces)
