"""Curves of equilibrium of the governor and the charts of stability of its loop."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.figures.charts.axes import axis_scale
from tmm_report.figures.charts.plane import Frame, Spot, Trace, framed, plane
from tmm_report.figures.drawing import Drawing, Pen, Tag
from tmm_report.figures.lettering import Parts
from tmm_report.mechanics.machine.governor import stability as small
from tmm_report.quantity.model import Column, Table

Array = Any
Num = Callable[[float], str]
Axes = tuple[Parts, Parts]  # letter and unit along, letter and unit up
RPM = 30 / np.pi
RAY = Pen(0.18, "grey")
FIELD = (110.0, 75.0)
FAR = 8.0  # to which value of X and Y Vyshnegradsky's diagram goes at least


def speeds(found: DirectFound, lift: Column, axes: Axes, num: Num, names: Sequence[str]) -> Drawing:
    """n(z), rpm, with the band of insensitiveness. `names` of the curves."""
    at, friction = found.curve, found.given.sleeve.friction
    z = lift.numbers(lift.quantity.printed)
    curves = [z + 1j * at.omega * RPM]
    if friction:
        curves += [z + 1j * omega * RPM for omega in at.band(friction)]
    frame = framed(curves, zero=False, field=FIELD)
    traces = [Trace(curve, (name,)) for curve, name in zip(curves, names, strict=False)]
    return plane(frame, traces, *axes, num)


def controlling(curve: Table, axes: Axes, num: Num, rpm: str) -> Drawing:
    """C(r) with rays from the origin through its ends and its middle: a ray is a speed, in `rpm`."""
    radius, force, speed = (curve[key] for key in ("r", "C", "omega_g"))
    drawn = radius.numbers(radius.quantity.printed) + 1j * force.numbers(force.quantity.printed)
    frame = framed([drawn], field=FIELD)
    rays, spots = [], []
    for k in (0, len(drawn) // 2, len(drawn) - 1):
        end = drawn[k] * _to_edge(frame, complex(drawn[k]))
        rays.append(Trace(np.array([0, end]), (), RAY))
        spots.append(Spot(complex(drawn[k]), (num(speed.number(k, "rpm")), f" {rpm}")))
    return plane(frame, [*rays, Trace(drawn, (), Pen(0.6))], *axes, num, spots=spots)


def _to_edge(frame: Frame, z: complex) -> float:
    """By what a point is lengthened to lie on the edge of the field."""
    return min(frame.high.real / z.real, frame.high.imag / z.imag if z.imag else np.inf)


# --- stability


def vyshnegradsky(found: LoopFound, axes: Axes, num: Num, words: dict[str, str]) -> Drawing:
    """The hyperbola XY = 1, the regions of the stable processes, the point of the machine."""
    assert found.vyshnegradsky is not None
    x, y = found.vyshnegradsky
    far = max(FAR, 1.15 * x, 1.15 * y)
    hyper = np.geomspace(1 / far, far, 121)
    a = np.concatenate([np.geomspace(1 / np.sqrt(far), 1, 60), np.geomspace(1, np.sqrt(far), 60)[1:]])
    double = small.double_roots(a)
    equal = np.linspace(3 / far * 1.02, 3, 80)
    curves = [
        hyper + 1j * small.hyperbola(hyper),
        double[0] + 1j * double[1],
        equal + 1j * small.equal_decay(equal),
    ]
    kept = [np.where((c.real <= far) & (c.imag <= far), c, np.nan) for c in curves]
    scale = axis_scale(far, 95)
    frame = Frame(0j, complex(far, far), scale, scale)
    pens = (Pen(0.6), Pen(0.35, "blue"), Pen(0.3, "green", (3.0, 1.0)))
    names: list[Parts] = [(words["boundary"],), (words["double"],), (words["equal"],)]
    traces = [Trace(c, n, p) for c, n, p in zip(kept, names, pens, strict=True)]
    tags = [
        Tag((words["monotonic"],), (frame.at(complex(0.72, 0.72) * far),)),
        Tag((words["aperiodic"],), (frame.at(complex(0.2, 0.8) * far),)),
        Tag((words["oscillating"],), (frame.at(complex(0.66, 0.16) * far),)),
        Tag((words["unstable"],), (frame.at(complex(0.02, 0.03) * far),), 0.4, 1 + 1j),
    ]
    spot = Spot(complex(x, y), (words["machine"],), "red")
    return plane(frame, traces, *axes, num, spots=[spot], tags=tags)


def isodrome(found: LoopFound, axes: Axes, num: Num, words: dict[str, str]) -> Drawing:
    """The boundary of stability over T_i and β with the point of the machine."""
    assert found.servo is not None
    _, beta, Ti = found.boundary
    far = complex(2.5 * found.servo.Ti, 2.5 * found.servo.beta)
    inside = (Ti <= far.real) & (beta <= far.imag)
    frame = Frame(0j, far, axis_scale(far.real, 110), axis_scale(far.imag, 85))
    traces = [Trace(np.where(inside, Ti + 1j * beta, np.nan), (words["boundary"],), Pen(0.6))]
    spots = [Spot(complex(found.servo.Ti, found.servo.beta), (words["machine"],), "red")]
    tags = [Tag((text,), (frame.at(at),)) for at, text in _named(found, far, words)]
    return plane(frame, traces, *axes, num, spots=spots, tags=tags)


def _named(found: LoopFound, far: complex, words: dict[str, str]) -> list[tuple[complex, str]]:
    """Where each region is named: at the place of the field that lies deepest in it."""
    assert found.servo is not None
    grid = [complex(far.real * i / 12, far.imag * k / 12) for i in range(1, 12) for k in range(1, 12)]
    good = {
        z: small.stable(small.polynomial(found.loop, small.Servo(found.servo.T, 0.0, z.imag, z.real)))
        for z in grid
    }
    named = []
    for wanted, text in ((True, words["stable"]), (False, words["unstable"])):
        mine, others = [z for z in grid if good[z] is wanted], [z for z in grid if good[z] is not wanted]
        if mine:
            named.append((max(mine, key=lambda z: _clear(z, others, far)), text))
    return named


def _clear(z: complex, others: list[complex], far: complex) -> float:
    """How far a place lies from the other region and from the edges, in parts of the field."""
    away = [abs(complex((z - o).real / far.real, (z - o).imag / far.imag)) for o in others]
    edges = [z.real / far.real, 1 - z.real / far.real, z.imag / far.imag, 1 - z.imag / far.imag]
    return min([*away, *edges])
