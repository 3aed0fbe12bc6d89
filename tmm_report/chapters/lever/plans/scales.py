"""The scales of the scheme and of the plans: stated, by a segment chosen, or round ones that fill a page.

Analytical values only say how large the plans will be; nothing is read from them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import UNITS
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.plans.drafting import Named, Scales
from tmm_report.chapters.lever.plans.given import Drawing, Kind, Segment
from tmm_report.mechanics.cams.cam import swept
from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.mechanics.lever.vector_equations import moving_points, relations
from tmm_report.problems import N_, ProblemError, mistake
from tmm_report.quantity.paper import LONGEST, SHEET, fitting_scale, legible, round_scale, segment_scale
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS
from tmm_report.records import dataclass

Array = Any

SCHEME = (135.0, 185.0)  # mm: what a scheme itself has of a portrait page, its marks around it


@dataclass(frozen=True)
class Choice:
    """A segment that gives a scale: `value`, as written, m, m/s or m/s², is `segment.mm` long. `position`: the table
    position at which a velocity or acceleration is largest."""

    segment: Segment
    value: float
    position: int
    scale: float

    @property
    def key(self) -> str:
        """Key of the velocity or acceleration."""
        return f"{'v' if self.segment.kind == 'velocity' else 'a'}_{self.segment.points[0]}"


def scales(
    drawing: Drawing, kinematics: Kinematics, positions: Sequence[int], named: Named
) -> tuple[Scales, tuple[Choice, ...]]:
    """Scales for the plans of the table positions. Raises ProblemError for a segment of nothing."""
    found = {choice.segment.kind: choice for choice in _choices(drawing, kinematics, positions, named)}

    def scale(stated: float | None, kind: Kind, fill: Callable[[], float]) -> float:
        return stated or (found[kind].scale if kind in found else fill())

    _see_legible(drawing, kinematics, positions, named)
    return (
        Scales(
            scale(drawing.length, "length", lambda: _of_scheme(kinematics)),
            scale(drawing.velocity, "velocity", lambda: _of_plans(kinematics, "v", positions, named)),
            scale(drawing.acceleration, "acceleration", lambda: _of_plans(kinematics, "a", positions, named)),
        ),
        tuple(found.values()),
    )


def _see_legible(drawing: Drawing, kinematics: Kinematics, positions: Sequence[int], named: Named) -> None:
    """See that what is to be drawn at a stated scale has a size on paper. Raises ProblemError."""
    at = ("drawing", "scales")
    if drawing.length is not None:
        legible(drawing.length, max(_scheme_size(kinematics)), (*at, "length"))
    for kind, stated in (("v", drawing.velocity), ("a", drawing.acceleration)):
        if stated is not None and positions:
            path = (*at, "velocity" if kind == "v" else "acceleration")
            legible(stated, _longest(kinematics, kind, positions, named), path)


# ---------------------------------------------------------------- a segment chosen


def _choices(
    drawing: Drawing, kinematics: Kinematics, positions: Sequence[int], named: Named
) -> Iterator[Choice]:
    for segment in drawing.segments:
        if segment.kind == "force":
            continue
        if segment.kind == "length":
            value, position = _length(kinematics.linkage.mechanism, segment), 0
        else:
            value, position = _largest(kinematics, segment, positions)
        if not value > _nothing(kinematics, segment, named):
            text = N_("%(name)s is a segment of no length: the scale cannot be found from it")
            raise ProblemError(
                [mistake(text, ("drawing", segment.name.replace("π", "pi")), name=segment.name)]
            )
        yield Choice(segment, value, position, segment_scale(value, segment.mm))


def _nothing(kinematics: Kinematics, segment: Segment, named: Named) -> float:
    """What is nothing beside the other values of its kind: a velocity at a dead point is not 0 to the last digit."""
    if segment.kind == "length":
        return 0.0
    unit = UNITS["v" if segment.kind == "velocity" else "a"]
    sizes = [np.abs(x) for key, x in kinematics.values.items() if named[key].unit == unit]
    return 1e-9 * float(np.nanmax(sizes, initial=0.0))


def _length(mechanism: Mechanism, segment: Segment) -> float:
    """Between two points of a link, m."""
    one, other = segment.points
    points = next(k.points for k in mechanism.links.values() if one in k.points and other in k.points)
    return float(np.ravel(np.abs(points[other] - points[one]))[0])


def _largest(kinematics: Kinematics, segment: Segment, positions: Sequence[int]) -> tuple[float, int]:
    """The largest velocity or acceleration of a point at the positions, as written, and where."""
    letter = "v" if segment.kind == "velocity" else "a"
    drawn = list(positions) or list(range(len(kinematics.turned)))
    sizes = np.abs(kinematics.values[f"{letter}_{segment.points[0]}"])[drawn]
    if np.isnan(sizes).all():
        return 0.0, drawn[0]
    # the driving pin's velocity is one at all positions: the first of equals is named
    k = int(np.flatnonzero(sizes >= np.nanmax(sizes) * (1 - 1e-12))[0])
    return float(round_significant(float(sizes[k]), DIGITS)), drawn[k]


# ---------------------------------------------------------------- as a person would choose


def _of_scheme(kinematics: Kinematics) -> float:
    """m/mm at which the scheme of all positions fits a portrait page."""
    return fitting_scale(*_scheme_size(kinematics), SCHEME)


def _scheme_size(kinematics: Kinematics) -> tuple[float, float]:
    """Width and height of what the mechanism sweeps, m."""
    motion, mechanism = kinematics.diagram, kinematics.linkage.mechanism.real
    places = [motion.place(point) for point in mechanism.point_names]
    return _extent(np.concatenate([*places, swept(mechanism)]))


def _of_plans(kinematics: Kinematics, kind: str, positions: Sequence[int], named: Named) -> float:
    """SI per mm at which every plan fits a portrait page, its longest vector at most 180 mm."""
    if not positions:
        return 1.0
    places = np.array([vertex[list(positions)] for vertex in _vertices(kinematics, kind)])
    boxes = [_extent(np.append(places[:, i], 0j)) for i in range(len(positions))]
    wide, high = (max(sizes) for sizes in zip(*boxes, strict=True))
    longest = _longest(kinematics, kind, positions, named)
    least = round_scale(longest, LONGEST) if longest > 0 else 0.0
    return max(fitting_scale(wide, high, SHEET), least)


def _longest(kinematics: Kinematics, kind: str, positions: Sequence[int], named: Named) -> float:
    """The longest vector of the plans of velocities or accelerations, SI."""
    sizes = [
        np.abs(x[list(positions)]) for key, x in kinematics.values.items() if named[key].unit == UNITS[kind]
    ]
    return float(np.nanmax(sizes, initial=0.0))


def _vertices(kinematics: Kinematics, kind: str) -> Iterator[Array]:
    """Every vertex of the plans from the pole, complex, (P,), SI: points, and in accelerations the ends of the normal
    and Coriolis parts."""
    values = kinematics.values
    points = dict.fromkeys(moving_points(kinematics.linkage))
    for relation in relations(kinematics.linkage):
        for branch in relation.branches:
            points |= dict.fromkeys(point for point in (branch.start, branch.end) if point)
            bend = branch.a_key("n" if branch.turns else "k")
            if kind == "a" and branch.has_bend and bend in values:
                yield values[bend] + (values[f"a_{branch.start}"] if branch.start else 0.0)
    yield from (values[f"{kind}_{point}"] for point in points if f"{kind}_{point}" in values)


def _extent(places: Array) -> tuple[float, float]:
    """Width and height of the box around places, without those that are not known."""
    known = np.ravel(places)[np.isfinite(np.ravel(places))]
    return (float(np.ptp(known.real)), float(np.ptp(known.imag))) if known.size else (0.0, 0.0)
