"""Random mechanisms with one Assur group of class III or IV, drawn in position 0, so that it certainly exists.

Every family is a batch of one scheme, a lane each mechanism. Its numbers are read back by the program to the last bit.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from benchmarks.random_groups.equations import Equations
from benchmarks.random_groups.schemes import Numbers, equations, places, size_of, variant

Array = Any
FAMILIES = {  # scheme, crank
    "III-RRR": ("RRR", "short"), "III-RRR-L": ("RRR", "long"),
    "III-S": ("SRR", "short"), "III-S-L": ("SRR", "long"),
    "III-S2": ("SGR", "short"), "III-S2-L": ("SGR", "long"),
    "IV": ("IV", "short"), "IV-L": ("IV", "long"), "IV-S": ("IVS", "short"),
    "dyad-III": ("DRRR", "short"), "III-dyad": ("RRRD", "short"),
    "III-P": ("RRR", "short"), "IV-P": ("IV", "short"),
}  # fmt: skip
CROSSING = ("III-P", "IV-P")  # two equal rods keep two links parallel: other branches cross that one


@dataclass(frozen=True, eq=False)
class Batch:
    """Drawn mechanisms of one scheme: their numbers, the constraints and x in position 0."""

    family: str
    scheme: str
    numbers: Numbers  # (L,) each
    sense: Array  # (L,), ±1
    size: Array  # (L,): lengths of the equations are parts of it, m
    start: Array  # (L, n)

    def __len__(self) -> int:
        return len(self.sense)

    @property
    def equations(self) -> Equations:
        return equations(self.scheme, self.numbers, self.size)

    def of(self, lanes: Array) -> Batch:
        """Some of the lanes."""
        numbers = {k: v[lanes] for k, v in self.numbers.items()}
        return replace(
            self, numbers=numbers, sense=self.sense[lanes], size=self.size[lanes], start=self.start[lanes]
        )

    def file(self, lane: int) -> str:
        """The variant's file of one mechanism."""
        one = {k: v[lane].item() for k, v in self.numbers.items()}
        sketch = {
            k: v[lane].item() for k, v in places(self.scheme, self.numbers, self.size, self.start).items()
        }
        sketch |= {p: one[p] for p in ("G", "K") if p in one}
        return json.dumps(variant(self.scheme, one, float(self.sense[lane]), sketch), indent=1)


def draw(family: str, count: int, seed: int) -> Batch:
    """`count` mechanisms of a family, the same for the same seed."""
    scheme, driver = FAMILIES[family]
    random = np.random.default_rng([seed, *family.encode()])
    least, most = (0.04, 0.1) if driver == "short" else (0.1, 0.26)
    v: dict[str, Array] = {
        "O": square(random, count), "F": square(random, count), "crank": random.uniform(least, most, count),
        "angle_zero": random.uniform(-np.pi, np.pi, count),
    }  # fmt: skip
    x = (_draw_four if scheme in ("IV", "IVS") else _draw_three)(random, scheme, v, count)
    if family in CROSSING:
        _make_parallel(scheme, v, x)
    size = size_of(v)
    if scheme not in ("IV", "IVS"):
        x[:, -2:] /= size[:, None]
    return Batch(family, scheme, v, random.choice([-1.0, 1.0], count), size, x)


def square(random: np.random.Generator, count: int, half: float = 0.3) -> Array:
    """Places in a square."""
    return random.uniform(-half, half, count) + 1j * random.uniform(-half, half, count)


def angle(random: np.random.Generator, count: int) -> Array:
    return random.uniform(-np.pi, np.pi, count)


def arm(random: np.random.Generator, count: int) -> Array:
    """Vectors of 0.08 to 0.5 m in any direction."""
    return random.uniform(0.08, 0.5, count) * np.exp(1j * angle(random, count))


def _draw_three(random: np.random.Generator, scheme: str, v: dict[str, Array], count: int) -> Array:
    v["C"], v["D"] = arm(random, count), arm(random, count)
    p, theta = square(random, count), angle(random, count)
    u, pin = np.exp(1j * theta), v["O"] + v["crank"] * np.exp(1j * v["angle_zero"])
    x = [v["angle_zero"], theta, p.real, p.imag]
    if scheme == "DRRR":
        pin, rod = _dyad_before(random, v, pin, count)
        x.insert(1, rod)
    if scheme in ("RRR", "RRRD", "DRRR"):
        v["HB" if scheme == "DRRR" else "AB"] = np.abs(p - pin)
    elif scheme == "SRR":
        v["angle_k2"] = np.angle((pin - p) / u)
    else:
        v["angle_k2"] = angle(random, count)
        side = (np.exp(-1j * v["angle_k2"]) / u * (p - pin)).imag
        v["N2"] = random.uniform(-0.05, 0.05, count) + 1j * side
    if scheme == "SGR":
        v["Q"], v["angle_g4"] = square(random, count), angle(random, count)
        side = (np.exp(-1j * v["angle_g4"]) * (p + v["C"] * u - v["Q"])).imag
        v["C4"] = random.uniform(-0.05, 0.05, count) + 1j * side
    else:
        v["E"] = square(random, count)
        v["EC"] = np.abs(p + v["C"] * u - v["E"])
    v["FD"] = np.abs(p + v["D"] * u - v["F"])
    if scheme == "RRRD":
        v["T"], v["K"] = arm(random, count), square(random, count)
        middle = square(random, count)
        T = p + v["T"] * u
        v["TR"], v["KR"] = np.abs(middle - T), np.abs(middle - v["K"])
        v["angle_side"] = np.sign(((v["K"] - T).conj() * (middle - T)).imag)
    return np.stack(x, axis=1)


def _dyad_before(
    random: np.random.Generator, v: dict[str, Array], pin: Array, count: int
) -> tuple[Array, Array]:
    """Rods AP and GP drawn; point H of the rocker, and the direction of AP."""
    v["G"], P = square(random, count), square(random, count)
    v["AP"], v["GP"] = np.abs(P - pin), np.abs(P - v["G"])
    v["H"] = v["GP"] * random.uniform(0.5, 1.5, count) * np.exp(1j * random.uniform(-0.6, 0.6, count))
    return v["G"] + v["H"] / v["GP"] * (P - v["G"]), np.angle(P - pin)


def _draw_four(random: np.random.Generator, scheme: str, v: dict[str, Array], count: int) -> Array:
    v["B"], v["C"], v["D"], v["E"] = (arm(random, count) for _ in range(4))
    second, fifth = angle(random, count), angle(random, count)
    u, w = np.exp(1j * second), np.exp(1j * fifth)
    pin = v["O"] + v["crank"] * np.exp(1j * v["angle_zero"])
    v["CE"] = np.abs(v["F"] + v["E"] * w - pin - v["C"] * u)
    gap = v["F"] + v["D"] * w - pin - v["B"] * u
    if scheme == "IV":
        v["BD"] = np.abs(gap)
    else:
        v["angle_k3"] = np.angle(gap / u)
    return np.stack([v["angle_zero"], second, fifth], axis=1)


def _make_parallel(scheme: str, v: dict[str, Array], x: Array) -> None:
    """Joints moved so that two rods are sides of a parallelogram, in place."""
    if scheme == "IV":
        x[:, 2] = x[:, 1]
        v["E"], u = v["D"] + v["C"] - v["B"], np.exp(1j * x[:, 1])
        pin = v["O"] + v["crank"] * np.exp(1j * v["angle_zero"])
        v["BD"] = v["CE"] = np.abs(v["F"] + v["D"] * u - pin - v["B"] * u)
    else:
        v["F"], v["FD"] = v["E"] + (v["D"] - v["C"]) * np.exp(1j * x[:, 1]), v["EC"]
