"""Every way in which a variant's mechanism can be put together, and the sketch that chooses it.

found = find(load("variant.yaml"))
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from tmm_report.course import Variant
from tmm_report.mechanics.lever.assembly.stated import Way, sketch_angle, stated_way, ways
from tmm_report.mechanics.lever.assur_groups import Structure, decompose
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism, ZeroAngle
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.text import split
from tmm_report.records import dataclass
from tmm_report.variant import locate

MOST = 64  # ways shown: their number doubles with every dyad
SAME = 1e-4  # of the mechanism's size: ways that differ by less are one way
DIGITS = 5  # significant, of a coordinate
MM = 1e3  # mm in a metre


@dataclass(frozen=True, eq=False)
class Assemblies:
    """The ways found with the driving link's x axis at `phi`, rad, numbered from 1.

    `more`: there are others beside these. `stated`: the number of the variant's own, None where it is not among them;
    `unsaid`: why the variant states none.
    """

    variant: Variant
    structure: Structure
    phi: float
    ways: tuple[Way, ...]
    more: bool
    stated: int | None
    unsaid: tuple[Problem, ...]

    @property
    def mechanism(self) -> Mechanism:
        return self.structure.mechanism.real

    @cached_property
    def points(self) -> list[str]:
        """The points of the sketches: moving joints and a point of the driving link; all that move, if ways need it."""
        links_at, driver = self.mechanism.links_at, self.mechanism.driver.link
        moving = [p for p in self.mechanism.point_names if FRAME not in links_at(p)]
        joints = [p for p in moving if len(links_at(p)) > 1]
        if not any(driver in links_at(p) for p in joints):
            joints += [p for p in moving if driver in links_at(p)][:1]
        told_apart = set(self._sketches(joints))
        return joints if len(told_apart) == len(self.ways) else moving

    @cached_property
    def sketches(self) -> list[str]:
        """Of each way, the line of a variant's block `mechanism` that chooses it; names need no quotes in it."""
        return self._sketches(self.points)

    def _sketches(self, points: Sequence[str]) -> list[str]:
        lines = []
        for way in self.ways:
            places = [
                f"{p}: [{self._mm(way.places[p].real)}, {self._mm(way.places[p].imag)}]" for p in points
            ]
            lines.append(f"sketch: {{{', '.join(places)}}}")
        return lines

    def _mm(self, x: float) -> str:
        """A coordinate, m, as a variant states it."""
        parts = split(x * MM, self.digits, scale=self.size * MM)
        power = "" if parts.power is None else f"e{parts.power}"
        return f"{'-' if parts.negative else ''}{parts.digits}{power} mm"

    @cached_property
    def size(self) -> float:
        """The largest coordinate of a point, m: beside it rounding errors are 0."""
        return float(np.abs(self._coordinates).max())

    @cached_property
    def digits(self) -> int:
        """How many significant digits tell coordinates apart: five, more in a drawing far from its origin."""
        span = float(np.ptp(self._coordinates, axis=0).max())
        return DIGITS + (max(0, math.ceil(math.log10(self.size / span))) if span > 0 else 0)

    @cached_property
    def _coordinates(self) -> NDArray[np.float64]:
        """Of all points in all ways, (..., 2), m."""
        places = np.array([place for way in self.ways for place in way.places.values()])
        return np.stack([places.real, places.imag], axis=-1)

    @property
    def alike(self) -> list[int]:
        """Numbers of the ways that their sketches do not tell apart."""
        return [k for k, text in enumerate(self.sketches, 1) if self.sketches.count(text) > 1]


def find(variant: Variant, angle: float | None = None) -> Assemblies:
    """The ways with the driving link at an angle, rad; left out, that of the sketch, of position 0, or 0.

    Raises ProblemError where the mechanism has no Assur groups to put together.
    """
    if variant.lever is None:
        right = Message(N_("assemblies are those of a lever mechanism: the block mechanism describes one"))
        raise ProblemError([locate(mistake(N_("the variant has no lever mechanism"), right=right), variant)])
    mechanism = variant.lever.mechanism
    try:
        structure = decompose(mechanism)
        phi = _default(mechanism, structure) if angle is None else angle
        found = list(islice(ways(mechanism, phi), MOST + 1))
    except ProblemError as error:
        raise ProblemError([locate(problem, variant) for problem in error.problems]) from None
    stated, unsaid = _stated(variant, mechanism, phi, found[:MOST])
    return Assemblies(variant, structure, phi, tuple(found[:MOST]), len(found) > MOST, stated, unsaid)


def _default(mechanism: Mechanism, structure: Structure) -> float:
    angle, zero = sketch_angle(mechanism, structure), mechanism.driver.zero
    if angle is not None:
        return angle
    return zero.angle if isinstance(zero, ZeroAngle) else 0.0


def _stated(
    variant: Variant, mechanism: Mechanism, phi: float, found: Sequence[Way]
) -> tuple[int | None, tuple[Problem, ...]]:
    """The number of the way that the variant states, or why it states none."""
    try:
        own = stated_way(mechanism, phi)
    except ProblemError as error:
        return None, tuple(locate(problem, variant) for problem in error.problems)
    gaps = [_gap(way, own) for way in found] if own.closes else []
    return (int(np.argmin(gaps)) + 1 if gaps and min(gaps) < SAME else None), ()


def _gap(one: Way, other: Way) -> float:
    """How far two ways are from each other, of the mechanism's size, rad of its links."""
    places = np.array([[*way.places.values()] for way in (one, other)])
    turns = np.array([[*way.turns.values()] for way in (one, other)])
    size = np.abs(places - places[0, 0]).max() or 1.0
    return float(max(np.abs(places[1] - places[0]).max() / size, np.abs(turns[1] - turns[0]).max()))
