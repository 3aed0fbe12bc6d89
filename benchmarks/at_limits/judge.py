"""The program's answer to a drawn mechanism, held against what is right."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter

import numpy as np

from benchmarks.at_limits.draw import OMEGA, Scene
from benchmarks.at_limits.truth import Output, Truth
from tmm_report.chapters.lever.kinematics.checks.digits_left import digits_left
from tmm_report.chapters.lever.kinematics.solve import positions as kinematics
from tmm_report.chapters.lever.structure import solve as structure
from tmm_report.loading import loads

RIGHT = {"V": 1e-8, "A": 1e-7}  # of the largest: what an extreme may be off by at a limit
BY_DIGITS = 10.0  # times the digits that are told, beside one
FLOOR = 0.1  # of ω1 or ω1², and the crank: errors are beside the motion of the mechanism


@dataclass(frozen=True)
class Verdict:
    """How right an answer is: names of what is wrong, and the largest errors of the largest value."""

    family: str
    number: int
    wrong: tuple[str, ...]
    V: float = 0.0
    A: float = 0.0
    H: float = 0.0
    seconds: float = 0.0
    note: str = ""


def asked(scene: Scene) -> tuple[kinematics.Kinematics, float]:
    """The program's kinematics of a scene, and how long they took, s."""
    lever = loads(scene.text).lever
    assert lever is not None
    begin = perf_counter()
    found = kinematics.solve(lever.positions, structure.solve(lever.mechanism))
    _ = found.links, found.dead, found.gaps
    return found, perf_counter() - begin


def judged(scene: Scene) -> Verdict:
    try:
        found, seconds = asked(scene)
    except Exception as error:
        return Verdict(scene.family, scene.number, ("no answer",), note=f"{type(error).__name__}: {error}")
    truth = Truth(scene)
    wrong: list[str] = []
    worst = {"V": 0.0, "A": 0.0, "H": 0.0}
    notes = []
    told = 0.0
    if scene.away:
        least = min(float(c.closeness.value) for c in found.closest)
        told = BY_DIGITS * 10.0 ** -float(digits_left(np.array(least)))
    for travel in (*found.travels, *found.links):
        one = Output(travel.output.kind, travel.output.name, complex(travel.output.direction))
        right, span = truth.extremes(one)
        given = np.array([[x.value for x in ends] for ends in (travel.V_extremes, travel.a_extremes)])
        unit = 1.0 if one.kind == "rocker" else float(scene.crank) / 1000
        sizes = np.maximum(np.abs(right).max(axis=1), FLOOR * unit * np.array([OMEGA, OMEGA**2]))
        for name, a, b, size in zip("VA", given, right, sizes, strict=True):
            off = float(np.abs(a - b).max() / size)
            worst[name] = max(worst[name], off)
            if not off <= max(RIGHT[name], told):
                wrong.append(name)
                notes.append(f"{name}_{one.name} {a} for {b}")
        off = abs(travel.stroke - span) / max(span, 1e-9 * unit)
        worst["H"] = max(worst["H"], off if span > 1e-7 * unit else 0.0)
        if not off <= 1e-5 and span > 1e-7 * unit:  # of samples
            wrong.append("H")
            notes.append(f"H_{one.name} {travel.stroke} for {span}")
    jumps = scene.away == 0 and _jumps(scene)
    if bool(found.gaps) != jumps:
        wrong.append("jump")
        notes.append(f"gaps {[str(g.text)[:80] for g in found.gaps]}")
    return Verdict(
        scene.family,
        scene.number,
        tuple(dict.fromkeys(wrong)),
        **worst,
        seconds=seconds,
        note="; ".join(notes),
    )


def _jumps(scene: Scene) -> bool:
    """Whether pin and pivot fall together once in the turn."""
    step = scene.steps[0]
    if step.kind == "RRR":
        x, y = scene.fixed["C"]
        same = step.p == step.q and x * x + y * y == scene.crank**2
    else:
        same = step.kind == "RPR" and step.q == 0
    return same and len(scene.changes) == 1
