"""The numbers of a four-bar linkage whose coupler leads a body through three positions, or from one to another."""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.lever.synthesis.given import Body
from tmm_report.chapters.lever.synthesis.refused import mm, refused
from tmm_report.chapters.lever.synthesis.steps import SAME
from tmm_report.chapters.lever.synthesis.values import Poses, Values
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import sqrt
from tmm_report.quantity.functions import arcsin
from tmm_report.quantity.model import Table

MOST_OFF = (
    4.0  # coupler and ways of the pins together: the farthest from its pin's way that a free pivot is tried
)
OTHERS = N_("another point of the body, or other positions")
SIDES = {"left": (1.0,), "right": (-1.0,), None: (1.0, -1.0)}


def body(s: Values, asked: Body) -> tuple[Table, tuple[tuple[float, ...], ...]]:
    """The table of positions, and of two positions what solves the demand, the best first (`synthesis_solutions`)."""
    pins = pinned(asked)
    if abs(complex(*asked.points[1]) - complex(*asked.points[0])) <= 0:
        right = Message(N_("two points of the body"))
        raise refused(N_("both pins are at one place"), "body", "points", right=right)
    solutions = _between_two(s, asked, pins) if len(asked.positions) == 2 else _through_three(s, pins)
    x, y, angle = (np.array(part) for part in zip(*asked.positions, strict=True))
    table = Table(
        "synthesis_poses", Message(N_("positions of the body and places of its pins")),
        (
            Poses.x.column(x), Poses.y.column(y), Poses.angle.column(angle), Poses.x_A.column(pins[0].real),
            Poses.y_A.column(pins[0].imag), Poses.x_B.column(pins[1].real), Poses.y_B.column(pins[1].imag),
        ),
    )  # fmt: skip
    return table, solutions


def pinned(asked: Body) -> tuple[np.ndarray, np.ndarray]:
    """Places of both pins in the positions, complex, m."""
    x, y, angle = (np.array(part) for part in zip(*asked.positions, strict=True))
    first, second = (x + 1j * y + np.exp(1j * angle) * complex(*point) for point in asked.points)
    return first, second


def _placed(s: Values, crank: complex, rocker: complex, pin: np.ndarray) -> None:
    """`pin`: places of the crank's pin; the crank goes through them in their order."""
    turned = np.angle((pin - crank) / (pin[0] - crank))
    way = float(turned[-1])
    if len(pin) == 3 and (turned[1] * way < 0 or abs(turned[1]) > abs(way)):  # the long way round
        way -= math.copysign(2 * math.pi, way)
    s.crank_angle, s.crank_way = float(np.angle(pin[0] - crank)), way
    s.crank_pivot_x, s.crank_pivot_y, s.rocker_pivot_x, s.rocker_pivot_y = (
        crank.real, crank.imag, rocker.real, rocker.imag,
    )  # fmt: skip


# ---------------------------------------------------------------- three positions


def _through_three(s: Values, pins: tuple[np.ndarray, np.ndarray]) -> tuple[tuple[float, ...], ...]:
    """The pivots are the centres of the circles through the three places of each pin."""
    found = []
    for k, name in enumerate("AB"):
        try:
            found.append(synthesis.circle(pins[k]))
        except ZeroDivisionError:
            wrong = N_(
                "the three places of the pin %(name)s lie on one line: its pivot would be infinitely far away"
            )
            raise refused(wrong, "body", "points", right=Message(OTHERS), name=name) from None
    (crank, a), (rocker, c) = found
    _placed(s, crank, rocker, pins[0])
    s.crank, s.rocker, s.rod, s.frame = a, c, abs(complex(pins[1][0] - pins[0][0])), abs(rocker - crank)
    _passes(s, crank, rocker, pins)
    return ()


def _passes(s: Values, crank: complex, rocker: complex, pins: tuple[np.ndarray, np.ndarray]) -> None:
    """Raises ProblemError where the linkage does not go through the positions in their order."""
    if s.number("frame") <= SAME * s.number("crank"):
        raise refused(
            N_("both pivots would be at one place: the linkage would turn as one body"), "body", "points",
            right=Message(OTHERS),
        )  # fmt: skip
    sides = np.imag(np.conj(rocker - pins[0]) * (pins[1] - pins[0]))
    if sides.min() * sides.max() <= 0:
        raise refused(
            N_("the three positions are of different assemblies: the linkage cannot go from one to the next"), "body",
            right=Message(OTHERS),
        )  # fmt: skip
    a, b, c, d = (s.number(key) for key in ("crank", "rod", "rocker", "frame"))
    turned = np.angle((pins[0] - crank) / (rocker - crank))
    match synthesis.FourBar(a, b, c, d, 1).order(turned):
        case None:
            raise refused(
                N_("the linkage cannot go from one position to the next: between them its links do not meet"), "body",
                right=Message(OTHERS),
            )  # fmt: skip
        case order if order not in ((0, 1, 2), (2, 1, 0)):
            right = Message(
                N_("the order %(order)s, or another point of the body"),
                {"order": ", ".join(str(k + 1) for k in order)},
            )
            wrong = N_("the linkage comes to the three positions in another order than they are stated")
            raise refused(wrong, "body", "positions", right=right)


# ---------------------------------------------------------------- two positions


def _between_two(
    s: Values, asked: Body, pins: tuple[np.ndarray, np.ndarray]
) -> tuple[tuple[float, ...], ...]:
    """The pivots lie on the perpendicular bisectors of the ways of the pins; the pivot of the rocker is free on its own
    where its length is not stated."""
    ways = [abs(complex(pin[1] - pin[0])) for pin in pins]
    for way, name in zip(ways, "AB", strict=True):
        if way <= SAME * max(abs(asked.points[0][0]), *ways):
            wrong = N_("the pin %(name)s is at one place in both positions: it has no way to halve")
            raise refused(wrong, "body", "points", right=Message(OTHERS), name=name)
    lengths = {"crank": asked.crank, "rocker": asked.rocker}
    for (key, length), way in zip(lengths.items(), ways, strict=True):
        if length is not None and length < way / 2:
            wrong = N_("this link does not reach both places of its pin, which are %(way)s apart")
            right = Message(N_("at least %(limit)s"), {"limit": mm(way / 2)})
            raise refused(wrong, "body", key, right=right, way=mm(way))
    assert asked.crank is not None
    off = math.sqrt(asked.crank**2 - ways[0] ** 2 / 4)
    solutions = []
    for side in SIDES[asked.crank_pivot] if off else (1.0,):
        solutions += [(side * off, *one) for one in _rockers(asked, pins, side * off)]
    if not solutions:
        right = Message(
            N_(
                "another length of the crank, another side of a pivot, another point of the body, or other positions"
            )
        )
        wrong = N_(
            "no such linkage leads the body from one position to the other: it would have to be assembled anew"
        )
        raise refused(wrong, "body", right=right)
    solutions.sort(key=lambda one: -one[-1])
    best = solutions[0]
    _written(s, asked, pins, ways, best)
    return tuple(solutions)


def family(pins: tuple[np.ndarray, np.ndarray], off_crank: float, off: np.ndarray) -> synthesis.Led:
    return synthesis.led(pins[0], pins[1], off_crank, off)


def farthest(pins: tuple[np.ndarray, np.ndarray]) -> float:
    """From the way of its pin, that a free pivot is tried, m."""
    return MOST_OFF * float(abs(pins[1][0] - pins[0][0]) + sum(abs(pin[1] - pin[0]) for pin in pins))


def _rockers(
    asked: Body, pins: tuple[np.ndarray, np.ndarray], off_crank: float
) -> list[tuple[float, float, float]]:
    """Of one pivot of the crank the sound solutions: how far the rocker's pivot stands from its pin's way, the distance
    of the pivots, the least transmission angle."""
    sides = SIDES[asked.rocker_pivot]
    if asked.rocker is not None:
        half = abs(complex(pins[1][1] - pins[1][0])) / 2
        offs = np.array(sides) * math.sqrt(asked.rocker**2 - half**2)
    else:
        most = farthest(pins)
        low, high = (most if side in sides else 0.0 for side in (-1.0, 1.0))
        try:
            best = synthesis.least(lambda h: -family(pins, off_crank, h).transmission, -low, high)[0]
        except ValueError:
            return []
        offs = np.array([best])
    of = family(pins, off_crank, offs)
    rows = zip(offs, np.abs(of.rocker_pivot - of.crank_pivot), of.transmission, strict=True)
    return [tuple(map(float, row)) for row in rows if math.isfinite(row[2])]  # type: ignore[misc]


def _written(
    s: Values, asked: Body, pins: tuple[np.ndarray, np.ndarray], ways: list[float], best: tuple[float, ...]
) -> None:
    off_crank, off_rocker = best[0], best[1]
    of = family(pins, off_crank, np.array([off_rocker]))
    s.way_A, s.way_B = ways
    s.crank = asked.crank
    size = sqrt(s.crank**2 - s.way_A**2 / 4)
    s.off_A = size if off_crank >= 0 else -size
    if asked.rocker is not None:
        s.rocker = asked.rocker
        size = sqrt(s.rocker**2 - s.way_B**2 / 4)
        s.off_B = size if off_rocker >= 0 else -size
    else:
        s.off_B = off_rocker
        s.rocker = sqrt(s.off_B**2 + s.way_B**2 / 4)
    s.turn_A = 2 * arcsin(s.way_A / (2 * s.crank))
    s.turn_B = 2 * arcsin(s.way_B / (2 * s.rocker))
    _placed(s, complex(of.crank_pivot), complex(of.rocker_pivot[0]), pins[0])
    s.rod, s.frame = abs(complex(pins[1][0] - pins[0][0])), best[2]
    s.transmission = best[3]
