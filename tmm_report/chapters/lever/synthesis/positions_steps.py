"""The numbers of a linkage by two positions of its rocker or slider: the extreme ones, or two with those of the crank.

Axes: the crank's pivot is the origin; the rocker's pivot stands on the x axis, or the slide line goes along it, the
offset below. (Artobolevsky, Theory of mechanisms and machines, ch. 27)
"""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.lever.synthesis.given import RockerPositions, SliderPositions
from tmm_report.chapters.lever.synthesis.refused import degrees, refused
from tmm_report.chapters.lever.synthesis.steps import SAME
from tmm_report.chapters.lever.synthesis.values import Values
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import arccos, cos, sin, sqrt
from tmm_report.quantity.functions import HALF, arcsin

LEAST, MOST = 0.3, 3.0
"""Times the length that is stated: between which the one that is free is tried."""


# ---------------------------------------------------------------- a rocker


def rocker(s: Values, asked: RockerPositions) -> None:
    s.mu_permitted = asked.transmission
    if asked.crank_angles is None:
        _between_extremes(s, asked)
    else:
        _with_the_crank(s, asked)


def _between_extremes(s: Values, asked: RockerPositions) -> None:
    """Crank and rod are in one line in both: rod and crank together, or one less the other, from the crank's pivot. Of
    two triangles that are not flat, l₁ < c + d and l₂ > |c − d|, the crank is the shortest link and turns round."""
    first, second = sorted(asked.angles, key=abs)
    if math.sin(first) * math.sin(second) <= 0:
        raise refused(
            N_("the extreme positions of the rocker are on both sides of the line of the pivots: the linkage would "
            "have to be assembled anew between them"),
            "rocker_positions", "angles", right=Message(N_("both from 0 to 180 deg, or both from 0 to -180 deg")),
        )  # fmt: skip
    s.rocker = asked.rocker
    s.psi_1, s.psi_2 = first, second
    s.frame = asked.frame if asked.frame is not None else _free_frame(s)
    both, square = 2 * s.frame * s.rocker, s.frame**2 + s.rocker**2
    s.far, s.near = sqrt(square + both * cos(s.psi_1)), sqrt(square + both * cos(s.psi_2))
    s.crank, s.rod = (s.far - s.near) / 2, (s.far + s.near) / 2
    s.swing = abs(s.psi_2 - s.psi_1)
    lines = [arccos((s.frame**2 + one**2 - s.rocker**2) / (2 * s.frame * one)) for one in (s.far, s.near)]
    s.theta = abs(lines[1] - lines[0])
    s.K = (HALF + s.theta) / (HALF - s.theta)
    sides, twice = s.rod**2 + s.rocker**2, 2 * s.rod * s.rocker
    s.mu_inner = arccos((sides - (s.frame - s.crank) ** 2) / twice)
    s.mu_outer = arccos((sides - (s.frame + s.crank) ** 2) / twice)
    s.transmission = min(s.number("mu_inner"), math.pi - s.number("mu_outer"))


def extremes(s: Values, frame: np.ndarray) -> synthesis.Between:
    """Over the distance of the pivots."""
    angles = s.number("psi_1"), s.number("psi_2")
    return synthesis.rockers_between(angles, s.number("rocker"), frame)


def _free_frame(s: Values) -> float:
    c = s.number("rocker")
    return synthesis.least(lambda d: -extremes(s, d).angle, LEAST * c, MOST * c)[0]


def _with_the_crank(s: Values, asked: RockerPositions) -> None:
    """The rod is equally long in both positions: linear in the crank."""
    assert asked.crank_angles is not None and asked.frame is not None  # `block`
    s.psi_1, s.psi_2 = asked.angles
    s.phi_1, s.phi_2 = asked.crank_angles
    s.frame = asked.frame
    s.rocker = asked.rocker if asked.rocker is not None else _free_rocker(s)
    under = s.frame * (cos(s.phi_1) - cos(s.phi_2)) + s.rocker * (
        cos(s.phi_1 - s.psi_1) - cos(s.phi_2 - s.psi_2)
    )
    over = s.rocker * s.frame * (cos(s.psi_1) - cos(s.psi_2))
    _crank_there(float(over.value), float(under.value), "rocker_positions", s.number("frame"))
    s.crank = over / under
    x = s.frame + s.rocker * cos(s.psi_1) - s.crank * cos(s.phi_1)
    y = s.rocker * sin(s.psi_1) - s.crank * sin(s.phi_1)
    s.rod = sqrt(x**2 + y**2)
    found = pairs(s, np.array([s.number("rocker")]))
    if not np.isfinite(found.angle[0]):
        _apart("rocker_positions")
    s.transmission = float(found.angle[0])


def pairs(s: Values, c: np.ndarray) -> synthesis.Between:
    """Over the rocker."""
    phi, psi = ((s.number(f"{letter}_1"), s.number(f"{letter}_2")) for letter in ("phi", "psi"))
    return synthesis.rockers_through(phi, psi, s.number("frame"), c)


def _free_rocker(s: Values) -> float:
    d = s.number("frame")
    try:
        return synthesis.least(lambda c: -pairs(s, c).angle, LEAST * d, MOST * d)[0]
    except ValueError:
        _apart("rocker_positions", free=True)
        raise


# ---------------------------------------------------------------- a slider


def slider(s: Values, asked: SliderPositions) -> None:
    s.permitted = asked.pressure_angle
    if asked.crank_angles is None:
        _between_ends(s, asked)
    else:
        _places_with_the_crank(s, asked)
    if asked.pressure_angle is not None and s.number("pressure") > asked.pressure_angle * (1 + SAME):
        values = {"found": degrees(s.number("pressure")), "most": degrees(asked.pressure_angle)}
        raise refused(
            N_("the pressure angle comes to %(found)s, more than the permitted %(most)s"),
            "slider_positions", "pressure_angle", right=Message(N_("places farther from the crank's pivot")), **values,
        )  # fmt: skip


def _between_ends(s: Values, asked: SliderPositions) -> None:
    """The rod less the crank reaches the near place, which is no nearer than the slide line: the crank turns round."""
    near, far = sorted(asked.places, key=abs)
    if near * far <= 0:
        raise refused(
            N_("the extreme places of the slider are on both sides of the crank's pivot: the linkage would have to be "
            "assembled anew between them"),
            "slider_positions", "places", right=Message(N_("both to the right of it, or both to the left")),
        )  # fmt: skip
    s.x_1, s.x_2 = far, near
    s.offset = asked.offset or 0.0
    square = s.offset**2 if asked.offset else 0.0
    s.far, s.near = (sqrt(one**2 + square) if asked.offset else abs(one) for one in (s.x_1, s.x_2))
    s.crank, s.rod = (s.far - s.near) / 2, (s.far + s.near) / 2
    s.stroke = abs(s.x_1 - s.x_2)
    if asked.offset:
        s.theta = arcsin(s.offset / s.near) - arcsin(s.offset / s.far)
        s.K = (HALF + s.theta) / (HALF - s.theta)
    s.pressure = arcsin((s.crank + s.offset) / s.rod if asked.offset else s.crank / s.rod)


def _places_with_the_crank(s: Values, asked: SliderPositions) -> None:
    assert asked.crank_angles is not None
    s.x_1, s.x_2 = asked.places
    s.phi_1, s.phi_2 = asked.crank_angles
    s.offset = asked.offset if asked.offset is not None else _free_offset(s)
    under = s.x_1 * cos(s.phi_1) - s.x_2 * cos(s.phi_2) - s.offset * (sin(s.phi_1) - sin(s.phi_2))
    over = s.x_1**2 - s.x_2**2
    _crank_there(float(over.value), float(under.value), "slider_positions", abs(s.number("x_1")))
    s.crank = over / (2 * under)
    x, y = s.x_1 - s.crank * cos(s.phi_1), s.offset + s.crank * sin(s.phi_1)
    s.rod = sqrt(x**2 + y**2)
    found = places(s, np.array([s.number("offset")]))
    if not np.isfinite(found.angle[0]):
        _apart("slider_positions")
    s.pressure = float(found.angle[0])


def places(s: Values, e: np.ndarray) -> synthesis.Between:
    """Over the offset; `angle`: the greatest pressure angle on the way."""
    phi, x = ((s.number(f"{letter}_1"), s.number(f"{letter}_2")) for letter in ("phi", "x"))
    return synthesis.sliders_through(phi, x, e)


def span(s: Values) -> float:
    """To either side of the crank's pivot the farthest slide line that is tried, m."""
    return max(abs(s.number("x_1")), abs(s.number("x_2")))


def _free_offset(s: Values) -> float:
    try:
        return synthesis.least(lambda e: places(s, e).angle, -span(s), span(s))[0]
    except ValueError:
        _apart("slider_positions", free=True)
        raise


# ---------------------------------------------------------------- both


def _crank_there(over: float, under: float, kind: str, size: float) -> None:
    """Raises ProblemError where no crank makes the rod equally long in both positions, or one laid off backwards."""
    if over * under <= 0 or abs(over) > abs(under) * 1e3 * size:
        raise refused(
            N_("no crank turns by these angles while the other link goes from its first position to the second"),
            kind, "crank_angles", right=Message(N_("other angles, or the other sense of one of them")),
        )  # fmt: skip


def _apart(kind: str, free: bool = False) -> None:
    wrong = N_(
        "the linkage cannot go from the first position to the second: between them its links do not meet"
    )
    if free:
        wrong = N_("no linkage goes through both positions: its links do not meet between them")
    raise refused(wrong, kind, "crank_angles", right=Message(N_("other angles, or other positions")))
