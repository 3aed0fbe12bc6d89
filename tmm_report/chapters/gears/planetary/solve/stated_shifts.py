"""Shift coefficients stated of all wheels: the centre distance that belongs to them, and whether they agree."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmm_report.chapters.gears.planetary.given import Given
from tmm_report.mechanics.gears.involute import inv, inverse
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.sought import Task
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake

CLOSE = 0.0025  # modules: what rounding of three coefficients to three places leaves
EXACT = 1e-9


def whole(task: Task) -> bool:
    """Whether the shifts of all wheels are stated."""
    return task.shifts is not None and not math.isnan(task.shifts[0])


def settled(given: Given) -> Given:
    """With the centre distance that the stated shifts of row 1 have without backlash, where none is stated. Raises
    ProblemError where the shifts do not belong to one distance."""
    task = given.task
    if not whole(task) or given.teeth is None:
        return given
    if np.any(p.teeth_sums(task.scheme, np.array(given.teeth)) <= 0):
        return given  # told with the teeth
    if task.distance is None:
        task = replace(task, distance=_distance(task, given.teeth))
    if problems := list(_apart(given, task)):
        raise ProblemError(problems)
    return replace(given, task=task)


def _distance(task: Task, teeth: tuple[int, int, int, int]) -> float:
    """Of row 1: inv α_w = inv α + 2 x_Σ tan α/z_Σ, a_w = a cos α/cos α_w."""
    assert task.shifts is not None
    alpha, total = task.rack.alpha, int(p.teeth_sums(task.scheme, np.array(teeth))[0])
    x = task.shifts[0] + task.scheme.rows[0] * task.shifts[1]
    found = float(inv(alpha)) + 2 * x * math.tan(alpha) / total
    if found <= 0:
        wrong = N_(
            "the profile shift coefficients of wheel 1 and of its planet gears leave no centre distance"
        )
        right = Message(N_("a larger sum of them"))
        raise ProblemError([mistake(wrong, ("shift",), right)])
    return task.modules[0] * total / 2 * math.cos(alpha) / math.cos(float(inverse(found)))


def misses(task: Task, teeth: tuple[int, int, int, int]) -> list[float]:
    """What the stated x_Σ of each row exceeds that of its centre distance by, in transverse modules."""
    stated, asked = (replace(task, shifts=shifts).sizes(np.array(teeth)) for shifts in (task.shifts, None))
    return [float(miss) for miss in stated.shift_sums - asked.shift_sums]


def _apart(given: Given, task: Task) -> Iterator[Problem]:
    assert given.teeth is not None and task.shifts is not None and task.distance is not None
    for row, miss in enumerate(misses(task, given.teeth)):
        if abs(miss) <= CLOSE or math.isnan(miss):
            continue
        central, crown = p.ROWS[row]
        turn = math.cos(given.helix)
        wrong = N_(
            "the profile shift coefficients of wheels %(pair)s do not belong to the centre distance %(a)s mm"
        )
        right = N_("with that of wheel %(crown)s the coefficient of wheel %(central)s is %(x)s")
        values = {"pair": f"{given.wheels[central]}-{given.wheels[crown]}", "a": f"{1e3 * task.distance:.6g}"}
        said = {"crown": given.wheels[crown], "central": given.wheels[central]}
        said["x"] = f"{(task.shifts[central] - miss) / turn:.4f}"
        yield mistake(wrong, ("shift",), Message(right, said), **values)


def doubts(given: Given, teeth: tuple[int, int, int, int]) -> Iterator[Problem]:
    """Stated shifts are taken as they stand: what rounding leaves is backlash, or its want."""
    if not whole(given.task):
        return
    for row, miss in enumerate(misses(given.task, teeth)):
        if abs(miss) <= EXACT:
            continue
        play = -2 * miss * given.task.modules[row] * math.tan(given.task.rack.alpha) * 1e3
        central, crown = p.ROWS[row]
        pair = f"{given.wheels[central]}-{given.wheels[crown]}"
        inside = given.task.scheme.rows[row] == p.INTERNAL
        play = -play if inside else play
        wrong = N_("the shifts of wheels %(pair)s are taken as stated; they leave a backlash of %(play)s mm")
        yield doubt(wrong, ("shift",), None, pair=pair, play=f"{play:.3g}")
