"""View of the eccentric epicyclic mechanism: what its template prints beside the formulas."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.eccentric.formulas import GAP, EccentricFormulas
from tmm_report.chapters.eccentric.solve import CARRIER, RING, SUN, WHEELS, Found, Satellite
from tmm_report.figures import eccentric as drawn
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.conditions import Condition
from tmm_report.mechanics.wheels import least_teeth
from tmm_report.problems import N_
from tmm_report.quantity.gear_terms import HA, C
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.layout import Column, Table, numeric, worded
from tmm_report.report.page import Page

CONDITIONS = {
    "assembly": N_("assembly of satellite %(wheel)s, pitches"),
    "neighbourhood": N_("neighbourhood of satellites %(wheel)s"),
    "tips": N_("tips of sun and ring apart"),
    "undercut": N_("no undercut of wheel %(wheel)s, teeth"),
    "root": N_("no interference of the ring with the root of satellite %(wheel)s"),
    "fouling": N_("no overlap of the tips of satellite %(wheel)s and the ring"),
}
LARGEST, MIDDLE, SMALLEST = 0, 1, 2  # places in ecc.KINDS
ZERO_AREA = 1e-12  # m²: 1e-6 mm²


class EccentricView(EccentricFormulas):
    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(found)
        self.page, self.label = page, label
        self.t, self.num = page.t, page.num

    # ------------------------------------------------------------ words

    @property
    def name(self) -> str:
        return self.found.given.name

    def given_values(self) -> Markup:
        given, rack = self.found.given, self.found.given.rack
        lengths = (("e", self.found.e), ("m", given.module))
        gaps = (("delta", given.clearance), ("j_n", given.backlash))
        items: list[tuple[Any, float, str]] = [("u", float(self.found.ratio_of_teeth), "")]
        items += [(key, 1e3 * length, "mm") for key, length in lengths]
        items += [("alpha", rack.alpha, "deg"), (HA, rack.ha, ""), (C, rack.c, "")]
        items += [(key, 1e3 * length, "mm") for key, length in gaps]
        return self.page.listed(self.page.value(*item) for item in items)

    @cached_property
    def upper(self) -> tuple[Satellite, ...]:
        """The satellites without those that mirror another below the axis."""
        return tuple(s for s in self.found.satellites if not s.wheel.endswith("'"))

    @cached_property
    def slanting(self) -> tuple[Satellite, ...]:
        """Those of `upper` that are off the axis: their angles must be computed."""
        return tuple(s for s in self.upper if s.kind not in ("largest", "smallest"))

    @cached_property
    def near(self) -> tuple[tuple[Satellite, Satellite], ...]:
        """Neighbours, without the pairs that mirror another."""
        seen, pairs = set(), []
        for one, other, _ in self.found.neighbours:
            key = frozenset((one.wheel.rstrip("'"), other.wheel.rstrip("'")))
            if key not in seen:
                seen.add(key)
                pairs.append((one, other) if one.phi1 < other.phi1 else (other, one))
        return tuple(pairs)

    def wheels(self, satellites: tuple[Satellite, ...]) -> Markup:
        return self.page.listed(s.wheel for s in satellites)

    # ------------------------------------------------------------ judgement

    @property
    def row(self) -> int:
        return self.found.row

    @property
    def middle_gap(self) -> float:
        """Free between the largest and a middle satellite of the chosen set, m."""
        return float(self.found.judged.closed[self.row])

    @property
    def crowded(self) -> bool:
        """Whether the largest satellite collides with the middle ones."""
        return self.middle_gap <= self.found.given.clearance

    @property
    def middle_residue(self) -> float:
        return float(self.found.judged.residue[self.row, MIDDLE])

    @property
    def middle_whole(self) -> bool:
        return float(self.found.judged.family.satellites[self.row, MIDDLE]).is_integer()

    @property
    def assembles(self) -> bool:
        """Whether the middle satellites assemble."""
        return self.middle_whole and abs(self.middle_residue) <= self.found.given.slack

    @property
    def whole_least(self) -> int:
        return least_teeth(self.found.given.rack)

    def sets(self, kind: str) -> Markup | None:
        """Numbers t of the sets in which the middle satellites do not assemble ("residue") or the smallest satellite
        must replace the largest ("replaced"); None where there are none."""
        judged = self.found.judged
        middle, fit = judged.allowed[:, MIDDLE], judged.fit
        whole = judged.family.satellites[:, MIDDLE] % 1 == 0  # of half a tooth there is none to assemble
        loose = whole & (np.abs(judged.residue[:, MIDDLE]) > self.found.given.slack)
        replaced = middle & (judged.closed <= self.found.given.clearance) & fit[:, MIDDLE] & fit[:, SMALLEST]
        t = judged.family.t[loose if kind == "residue" else replaced]
        numbers = self.page.listed(str(int(x)) for x in t)
        return self.page.listed([self.page.sym("t"), numbers], " = ") if len(t) else None

    @property
    def kinds(self) -> set[str]:
        return {s.kind for s in self.found.satellites}

    @property
    def replaced(self) -> bool:
        """Whether the smallest satellite stands in place of the largest because of its neighbours."""
        return self.crowded and "largest" not in self.kinds and {"middle", "smallest"} <= self.kinds

    @property
    def remainder(self) -> tuple[int, int]:
        """z1 + z3 and 2e/m modulo 4: equal where the middle satellites assemble."""
        return (self.found.sun + self.found.ring) % 4, self.found.E % 4

    @property
    def full_set(self) -> Markup | None:
        """t, teeth and the free distance of the most compact set that holds all four satellites."""
        row = self.found.judged.full
        if row is None:
            return None
        text = N_("%(t)s (teeth %(teeth)s), where %(gap)s mm are left between satellites 2 and 4")
        gap = self.num(1e3 * float(self.found.judged.closed[row]), places=3)
        return self.t(
            text, t=self.page.value("t", self.found.judged.family.t[row]), teeth=self.teeth_of(row), gap=gap
        )

    def teeth_of(self, row: int) -> Markup:
        """z1, z2, z3, z4 of a set: 34, 60, 136, 51."""
        family = self.found.judged.family
        z = (
            family.sun[row],
            family.satellites[row, LARGEST],
            family.ring[row],
            family.satellites[row, MIDDLE],
        )
        return self.page.listed((self.num(float(x)) for x in z), ", ")

    @property
    def overlap(self) -> float:
        """The largest overlap of polygons of teeth, m²."""
        return float(self.found.proof.overlap.max())

    @property
    def touching(self) -> bool:
        """Whether no polygons of teeth overlap."""
        return self.overlap <= ZERO_AREA

    @property
    def flank_clearance(self) -> float:
        return float(self.found.proof.clearance.min())

    # ------------------------------------------------------------ tables

    def family(self) -> Table:
        judged = self.found.judged
        z, sun, ring = judged.family.satellites, judged.family.sun, judged.family.ring
        whole = z[:, MIDDLE] % 1 == 0
        middle, residue = (np.where(whole, x[:, MIDDLE], np.nan) for x in (z, np.abs(judged.residue)))
        gaps = (np.where(whole, x, np.nan) for x in (judged.closed, judged.gap[:, MIDDLE, SMALLEST]))
        columns = [
            [self.num(float(x)) for x in teeth]
            for teeth in (sun, z[:, LARGEST], ring, middle, z[:, SMALLEST])
        ]
        columns += [[self.num(float(x), places=3) for x in residue]]
        columns += [[self.num(1e3 * float(x), places=3, scale=1e3) for x in gap] for gap in gaps]
        heads = [self.page.sym(key) for key in ("t", "z_1", "z_2", "z_3", "z_4", "z_5", "epsilon_4")]
        heads += [self._in("mm", Symbol(GAP, pair)) for pair in ("2,4", "4,5")]
        held = [self._held(row) for row in range(len(z))]
        rows = zip([str(int(t)) for t in judged.family.t], *columns, held, strict=True)
        shares = (2, 2, 2, 2, 2, 2, 3, 4, 4, 5)
        return worded(self.t("Sets of teeth of the family"), [*heads, self.t("Satellites")], rows, shares)

    def _in(self, unit: str, key: str | Symbol) -> Markup:
        return self.page.listed([self.page.sym(key), self.page.unit(unit)])

    def _held(self, row: int) -> str:
        """The wheels that go together in a set: 2, 4, 5, 4'."""
        wheels = WHEELS.values()
        return ", ".join(w for w, fits in zip(wheels, self.found.judged.fit[row], strict=True) if fits) or "—"

    def sizes(self) -> Table:
        """Teeth and diameters of all the wheels, mm."""
        f, m, rack = self.found, 1e3 * self.found.given.module, self.found.given.rack
        rows = [(SUN, f.sun, 1), *((s.wheel, s.teeth, 1) for s in self.upper), (RING, f.ring, -1)]
        tips = [m * (z + 2 * side * rack.ha) for _, z, side in rows]
        tips[-1] += 2e3 * self.cut_down()
        columns = [
            Column(self.page.sym("z"), [str(z) for _, z, _ in rows], 4),
            self._mm("d", [m * z for _, z, _ in rows]),
            self._mm("d_b", [m * z * math.cos(rack.alpha) for _, z, _ in rows]),
            self._mm("d_a", tips),
            self._mm("d_f", [m * (z - 2 * side * (rack.ha + rack.c)) for _, z, side in rows]),
        ]
        first = Column(self.t("Wheel"), [wheel for wheel, _, _ in rows], 8)
        return numeric(self.t("Dimensions of the wheels"), first, columns)

    def _mm(self, key: str | Symbol, values: Any) -> Column:
        return Column(self._in("mm", key), [self.num(float(x), places=3) for x in values], 8)

    def places(self) -> Table:
        """Angles, centres and assembly of the satellites."""
        all_ = self.found.satellites
        columns = [
            Column(self.page.sym("z"), [str(s.teeth) for s in all_], 4),
            self._angle("phi_1", [s.phi1 for s in all_]),
            self._angle("phi_3", [s.phi3 for s in all_]),
            self._mm("x", [1e3 * s.centre.real for s in all_]),
            self._mm("y", [1e3 * s.centre.imag for s in all_]),
            Column(self.page.sym("L"), [self.num(s.belt, places=4) for s in all_], 8),
            Column(self.page.sym("epsilon"), [self.num(abs(s.residue), places=4) for s in all_]),
        ]
        first = Column(self.t("Satellite"), [s.wheel for s in all_], 8)
        return numeric(self.t("Positions of the satellites"), first, columns)

    def _angle(self, key: str, values: list[float]) -> Column:
        head = self.page.listed([self.page.sym(key), "°"])
        return Column(head, [self.num(math.degrees(x), places=3) for x in values], 8)

    def conditions(self) -> Table:
        rows = [self._condition(condition) for condition in self.found.conditions if self._own(condition)]
        heads = [self.t("Condition"), self.t("Value"), self.t("Limit"), self.t("In hand"), self.t("Met")]
        return worded(self.t("Conditions of the mechanism"), heads, rows, (9, 2, 2, 2, 2))

    def _own(self, c: Condition) -> bool:
        """Whether the condition is not the mirror image of another."""
        pairs = [{one.wheel, other.wheel} for one, other in self.near]
        return set(c.wheel.split("–")) in pairs if c.key == "neighbourhood" else not c.wheel.endswith("'")

    def _condition(self, c: Condition) -> list[Any]:
        factor = 1e3 if c.unit == "mm" else 1.0
        text = self.t(CONDITIONS[c.key], wheel=c.wheel)
        if c.unit:
            text = self.page.listed([text, self.page.unit(c.unit)])
        sign = "≥" if c.least else "≤"
        return [
            text,
            self.num(factor * c.value, 5, scale=1.0),
            f"{sign} {self.num(factor * c.limit, 4)}",
            self.num(factor * c.margin, 4, scale=1.0),
            self.t("yes") if c.met else self.t("no"),
        ]

    def proof(self) -> Table:
        found = self.found.proof
        columns = [
            Column(
                self.t("Overlap, %(unit)s", unit=self.page.unit("mm²")),
                [self.num(1e6 * float(x), 3, scale=1e3) for x in found.overlap.max(axis=1)],
                14,
            ),
            Column(
                self.t("Least clearance, %(unit)s", unit=self.page.unit("mm")),
                [self.num(1e3 * float(x), places=5, scale=1e-3) for x in found.clearance.min(axis=1)],
                16,
            ),
        ]
        first = Column(self.t("Wheels"), [f"{one}–{other}" for one, other in found.meshes], 8)
        return numeric(self.t("Overlap and clearance of the teeth over a full pitch"), first, columns)

    def speeds(self) -> Table:
        """Speeds of all the members with one of them stopped, rad/s."""
        cases = [(CARRIER, SUN), (RING, SUN), (SUN, RING)]
        found = [self.found.speeds(stopped, driven) for stopped, driven in cases]
        names = [SUN, *(s.wheel for s in self.upper), RING, CARRIER]
        columns = [
            Column(
                self.page.listed([self.page.sym(Symbol("omega", name)), self.page.unit("rad/s")]),
                self.page.col(speed[name] for speed in found),
                8,
            )
            for name in names
        ]
        first = Column(self.t("Stopped"), [stopped for stopped, _ in cases], 12)
        return numeric(self.t("Angular velocities of the members"), first, columns)

    # ------------------------------------------------------------ pictures

    def _text(self, value: float) -> str:
        return str(self.num(value, 5))

    @cached_property
    def drawing(self) -> Drawing:
        return drawn.assembled(self.found, self._text, str(self.t("The mechanism assembled")))

    @cached_property
    def close(self) -> Drawing:
        title = N_("Meshes and neighbours enlarged") if self.beside else N_("Meshes enlarged")
        return drawn.close(self.found, self._text, str(self.t(title)))

    @cached_property
    def beside(self) -> bool:
        """Whether the close view shows neighbours besides the meshes."""
        return drawn.narrowest(self.found) is not None

    def scale(self, which: str) -> str:
        """A drawing's scale as it is written on it: 1:2, 4:1."""
        scale = drawn.scale_of(self.found) if which == "drawing" else drawn.close_scale(self.found)
        return f"{self._text(scale)}:1" if scale >= 1 else f"1:{self._text(1 / scale)}"

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        found = self.found
        text = N_(
            "The eccentric epicyclic mechanism has the teeth %(teeth)s and, with the axes stopped, the ratio "
            "%(ratio)s; number of its satellites: %(count)s."
        )
        teeth = self.page.listed(self._all_teeth())
        lines = [self.t(text, teeth=teeth, ratio=self.num(found.ratio), count=len(found.satellites))]
        if found.failed:
            failed = self.page.listed(self.failed(), "; ")
            lines.append(self.t(N_("Not all of its conditions are met: %(conditions)s."), conditions=failed))
        return lines

    def failed(self) -> list[Markup]:
        return [self.t(CONDITIONS[c.key], wheel=c.wheel) for c in self.found.failed]

    def _all_teeth(self) -> list[Markup]:
        named = [(SUN, self.found.sun), *((s.wheel, s.teeth) for s in self.upper), (RING, self.found.ring)]
        return [self.page.value(Symbol("z", wheel), z, digits=9) for wheel, z in named]
