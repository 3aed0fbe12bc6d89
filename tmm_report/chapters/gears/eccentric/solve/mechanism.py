"""Chapter of the eccentric epicyclic mechanism: teeth by the Diophantine equation, the family, one set assembled.

Sun 1 and ring 3 turn about parallel axes at the distance e; the satellites between them differ in size: 2 the largest,
4 and 4' the middle ones, 5 the smallest. The arithmetic and its sources are in mechanics/gears/eccentric/mechanism.py.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from tmm_report.chapters.gears.eccentric.given import CARRIER, RING, SUN, Given
from tmm_report.chapters.gears.eccentric.paths import Traced, traced
from tmm_report.chapters.gears.eccentric.solve import mistakes, paper
from tmm_report.chapters.gears.eccentric.solve.conditions import conditions
from tmm_report.chapters.gears.eccentric.solve.family import (
    Judged,
    chosen,
    halved,
    impossible,
    judge,
    members,
    most_ring,
    sizes,
    teeth_equation,
)
from tmm_report.chapters.gears.eccentric.solve.masses import Masses, masses_of
from tmm_report.chapters.gears.eccentric.solve.motion import Motion, motions
from tmm_report.chapters.gears.eccentric.solve.near_ratio import Near, near_sets
from tmm_report.chapters.gears.eccentric.solve.satellites import (
    WHEELS,
    Neighbours,
    Satellite,
    neighbours,
    satellites,
    unmirrored,
)
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.eccentric import teeth as toothed
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

__all__ = ["CARRIER", "RING", "SUN", "WHEELS", "Found", "Given", "Satellite", "solve"]

MIDDLE = ecc.KINDS.index("middle")
NO_AREA = 1e-12  # m²: 1e-6 mm², teeth that share less do not overlap


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `E` = 2e/m; `row`: the chosen set in `judged`; `satellites`: as assembled, by ascending φ1;
    `neighbours`: every two of them side by side; `tip`: radius of the ring's tips, m; `motions`: for the given speed of
    the driving wheel, else for 1 rad/s; `proof`: overlaps and clearances of the polygons of teeth over a full pitch.
    `nearby`: sets near the wanted ratio, `masses`: of the satellites of every set, None where they are not asked for;
    `paths`: of named points."""

    given: Given
    ratio_of_teeth: Fraction
    E: int
    equation: ecc.Equation
    solution: ecc.Solution
    judged: Judged
    row: int
    satellites: tuple[Satellite, ...]
    neighbours: tuple[Neighbours, ...]
    conditions: tuple[Condition, ...]
    tip: float
    motions: tuple[Motion, ...]
    proof: toothed.Proof
    nearby: Near | None = None
    paths: tuple[Traced, ...] = ()
    masses: Masses | None = None

    @property
    def e(self) -> float:
        """The eccentricity, m."""
        return self.E * self.given.module / 2

    @property
    def t(self) -> int:
        return int(self.judged.family.t[self.row])

    @property
    def sun(self) -> int:
        return int(self.judged.family.sun[self.row])

    @property
    def ring(self) -> int:
        return int(self.judged.family.ring[self.row])

    @property
    def largest(self) -> int:
        """Teeth of the largest satellite of the set, assembled or not; rounded down where it has half a tooth."""
        return int(self.judged.family.satellites[self.row, 0])

    @property
    def halved(self) -> bool:
        """Whether the largest and the smallest satellites have half a tooth: the family is that of the middle ones."""
        return halved(self.given, self.ratio_of_teeth, self.E)

    @property
    def by_middle(self) -> bool:
        """Whether the satellites are assembled with the middle ones, the largest and the smallest left out."""
        return not {"largest", "smallest"} & {s.kind for s in self.satellites} and self.middle_whole

    # --- satellites

    @property
    def upper(self) -> tuple[Satellite, ...]:
        """The satellites without those that mirror another below the axis."""
        return tuple(s for s in self.satellites if not s.below)

    @property
    def near(self) -> tuple[Neighbours, ...]:
        """Neighbours, without the pairs that mirror another."""
        return unmirrored(self.neighbours)

    # --- the middle satellites of the chosen set

    @property
    def crowded(self) -> bool:
        """Whether the largest satellite collides with the middle ones."""
        return bool(self.judged.closed[self.row] <= self.given.clearance)

    @property
    def middle_whole(self) -> bool:
        """Whether a middle satellite has a whole number of teeth."""
        return float(self.judged.family.satellites[self.row, MIDDLE]).is_integer()

    @property
    def assembles(self) -> bool:
        """Whether the middle satellites assemble."""
        return self.middle_whole and abs(float(self.judged.residue[self.row, MIDDLE])) <= self.given.slack

    @property
    def replaced(self) -> bool:
        """Whether the smallest satellite stands in place of the largest because of its neighbours."""
        kinds = {s.kind for s in self.satellites}
        return self.crowded and "largest" not in kinds and {"middle", "smallest"} <= kinds

    # --- teeth

    @property
    def cut(self) -> float:
        """By how much the ring's tips are cut down to keep clear of the satellites' fillets, m."""
        return self.tip - self.given.module * (self.ring / 2 - self.given.rack.ha)

    @property
    def failed(self) -> tuple[Condition, ...]:
        return tuple(condition for condition in self.conditions if not condition.met)

    @property
    def overlap(self) -> float:
        """The largest overlap of polygons of teeth, m²."""
        return float(self.proof.overlap.max())

    @property
    def clearance(self) -> float:
        """The least clearance of polygons of teeth, m."""
        return float(self.proof.clearance.min())

    @property
    def touching(self) -> bool:
        """Whether no polygons of teeth overlap."""
        return self.overlap <= NO_AREA

    # --- on paper

    @property
    def scale(self) -> float:
        """Of the assembled mechanism, mm of paper to mm."""
        return paper.scale(self.given, self.ring)

    @property
    def close_scale(self) -> float:
        """Of the close views."""
        return paper.close_scale(self.given)

    @property
    def narrowest(self) -> Neighbours | None:
        """The nearest neighbours; None: so far apart that neither would be in a close view."""
        nearest = min(self.neighbours, key=lambda pair: pair.gap, default=None)
        return nearest if nearest is not None and 1e3 * nearest.gap * self.close_scale < paper.ROUND else None

    def summary(self) -> list[Message]:
        """The main numbers in a sentence."""
        text = N_(
            "eccentric epicyclic mechanism: sun %(sun)s, largest planet gear %(largest)s, ring %(ring)s teeth; "
            "planet gears mounted: %(count)s; conditions not met: %(failed)s"
        )
        values: dict[str, object] = {"sun": self.sun, "largest": self.largest, "ring": self.ring}
        if self.halved:
            text = N_(
                "eccentric epicyclic mechanism: sun %(sun)s, ring %(ring)s teeth, planet gears %(satellites)s; "
                "planet gears mounted: %(count)s; conditions not met: %(failed)s"
            )
            values["satellites"] = ", ".join(str(s.teeth) for s in self.upper)
        return [Message(text, values | {"count": len(self.satellites), "failed": len(self.failed)})]

    def assembled(self, tolerance: float | None = None) -> toothed.Assembly:
        """The wheels with their teeth, turned so that they mesh; `tolerance` of the outlines, m."""
        return _assembled(self.given, self.sun, self.ring, self.e, self.satellites, tolerance)


def solve(given: Given) -> Found:
    """Raises ProblemError with the mistakes of the data and what would work."""
    mistakes.check(given)
    u, E = sizes(given)
    if impossible(given, u, E):
        raise mistakes.no_solution(u, E, given.module)
    equation, solution = teeth_equation(given, u, E)
    judged = judge(given, u, E, members(given, solution, u, E, most_ring(given, u)))
    row = chosen(given, judged, u, E, solution)
    placed = satellites(given, judged, row, E)
    sun, ring, e = int(judged.family.sun[row]), int(judged.family.ring[row]), E * given.module / 2
    beside = neighbours(given, sun, placed)
    return Found(
        given,
        u,
        E,
        equation,
        solution,
        judged,
        row,
        placed,
        beside,
        tuple(conditions(given, sun, ring, e, placed, beside)),
        ecc.ring_tip(ring, np.array([s.teeth for s in placed]), given.module, given.rack),
        motions(sun, ring, placed, given.module, given.speed or 1.0),
        toothed.proof(_assembled(given, sun, ring, e, placed)),
        None if given.tolerance is None else near_sets(given, given.ratio or u, E, given.tolerance),
        tuple(traced(name, point, sun, ring, e) for name, point in given.points.items()),
        _masses(given, judged),
    )


def _masses(given: Given, judged: Judged) -> Masses | None:
    if given.width is None or given.density is None:
        return None
    return masses_of(judged, given.module, given.width, given.density)


def _assembled(
    given: Given,
    sun: int,
    ring: int,
    e: float,
    placed: tuple[Satellite, ...],
    tolerance: float | None = None,
) -> toothed.Assembly:
    places = [toothed.Place(s.wheel, s.teeth, s.centre, s.phi1, s.phi3, s.residue) for s in placed]
    cut = toothed.Cut(given.module, given.rack, given.backlash, tolerance)
    return toothed.assemble(sun, ring, e, places, cut)
