"""The numbers of the eccentric epicyclic mechanism with the expressions that the note prints of them; lengths in mm.

Teeth, satellites and their places are sought among arrays: what was found is put beside its expression.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from tmm_report.chapters.gears.eccentric.given import MeshLoad
from tmm_report.chapters.gears.eccentric.paths import Traced
from tmm_report.chapters.gears.eccentric.solve import paper
from tmm_report.chapters.gears.eccentric.solve.mechanism import RING, SUN, Found
from tmm_report.chapters.gears.eccentric.solve.satellites import Neighbours
from tmm_report.chapters.gears.eccentric.solve.satellites import Satellite as Placed
from tmm_report.chapters.gears.eccentric.values import (
    Loaded,
    Masses,
    OfPath,
    Pair,
    Place,
    Satellite,
    Set,
    Values,
    Wheel,
    of_path,
    of_place,
    of_satellite,
)
from tmm_report.mechanics.gears.pair_sizes import least_ring, least_teeth, ring_rule
from tmm_report.quantity.formula import PI, Expr, Number, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.functions import FULL, HALF
from tmm_report.quantity.sheet import Computed, Sheet
from tmm_report.quantity.tabulated import tabulated
from tmm_report.records import dataclass

WRITTEN = 1  # the position of a path that is written out in full


@dataclass(frozen=True, eq=False)
class Path:
    """A path with its single numbers, and with those of the position that is written out."""

    traced: Traced
    s: OfPath
    place: Place


def steps(found: Found) -> Mechanism:
    """The numbers of the mechanism, made once."""
    return next(iter(_made(found)))


@tabulated
def _made(found: Found) -> Iterator[Mechanism]:
    yield Mechanism(found)


class Mechanism:
    """`s`: the single numbers; `set`: of the chosen set of teeth, `masses` of its satellites, where they are asked
    for; `satellites`, `pairs` of neighbours, `wheels`: the rows of their tables; `paths`: of the named points."""

    def __init__(self, found: Found):
        self.found, self.given, self.s = found, found.given, Values()
        self.set = Set("eccentric_family", found.row)
        for step in (
            self._stated, self._equation, self._chosen, self._circles, self._tips, self._proof, self._motion,
            self._drawings, self._near,
        ):  # fmt: skip
            step()
        self.satellites = tuple(self._satellite(row, of) for row, of in enumerate(found.satellites))
        self.pairs = tuple(self._pair(row, pair) for row, pair in enumerate(found.near))
        self.wheels = tuple(self._wheels())
        self.masses = self._masses()
        self.loads = tuple(self._loads())
        self.paths = tuple(self._path(path) for path in found.paths)

    def row(self, of: Placed) -> Satellite:
        """The numbers of a satellite."""
        return self.satellites[self.found.satellites.index(of)]

    # ------------------------------------------------------------ teeth

    def _stated(self) -> None:
        s, given, rack = self.s, self.given, self.given.rack
        s.e, s.m, s.u_teeth = self.found.e, given.module, float(self.found.ratio_of_teeth)
        s.alpha, s.ha, s.c = math.degrees(rack.alpha), rack.ha, rack.c
        s.delta, s.j_n, s.omega = given.clearance, given.backlash, given.speed or None

    def _equation(self) -> None:
        """The Diophantine equation a z1 + b z2 + c = 0 in whole numbers, and its solution."""
        s, eq, solution = self.s, self.found.equation, self.found.solution
        s.E, s.equation_k = Computed(2 * s.e / s.m, self.found.E), eq.k
        s.equation_a = Computed((1 - s.u_teeth) * s.equation_k, eq.a)
        s.equation_b = Computed(2 * s.equation_k, eq.b)
        s.equation_c = eq.c if self.found.halved else Computed(-(s.E * s.equation_k), eq.c)
        s.euclid_x, s.euclid_y = solution.x, solution.y
        s.divisor = s.equation_a * s.euclid_x + s.equation_b * s.euclid_y
        if not self.found.halved:
            s.z1_0 = -(s.equation_c / s.divisor) * s.euclid_x
            s.z2_0 = -(s.equation_c / s.divisor) * s.euclid_y
        s.a_1, s.b_1 = s.equation_a / s.divisor, s.equation_b / s.divisor

    def _chosen(self) -> None:
        """The set that was taken; without whole teeth of the largest satellite, by the middle one."""
        s, found, of = self.s, self.found, self.set
        largest, middle, smallest, _ = found.judged.family.satellites[found.row]
        s.t, s.z1, s.z3 = found.t, found.sun, found.ring
        ring = Computed(s.u_teeth * s.z1, found.ring)
        if found.halved:
            of.z1, of.z4, of.z3 = -(s.b_1 * s.t), s.a_1 * s.t, ring
            of.z2, of.z5 = largest, smallest
        else:
            of.z1, of.z2, of.z3 = s.z1_0 - s.b_1 * s.t, s.z2_0 + s.a_1 * s.t, ring
            of.z4 = (s.z3 - s.z1) / 2 if found.middle_whole else middle
            of.z5 = of.z2 - s.E
        s.satellites = len(found.satellites)
        s.remainder_teeth, s.remainder_E = (found.sun + found.ring) % 4, found.E % 4

    # ------------------------------------------------------------ lengths

    def _circles(self) -> None:
        """Pitch circles; what is left between those of the tips of the largest and a middle satellite."""
        s, half = self.s, self.given.module / 2
        s.r_1, s.r_3 = half * self.found.sun, half * self.found.ring
        root = sqrt((s.r_1 + s.r_3) ** 2 / 2 - s.e**2 / 4)
        s.gap_2_4 = self._noise_of_a_module(root - (s.r_3 - s.r_1) - s.e / 2 - 2 * s.ha * s.m)
        s.in_hand_2_4 = s.number("gap_2_4") - self.given.clearance

    def _noise_of_a_module(self, length: Expr) -> Computed:
        return Computed(length, scale=self.s.m.number)

    def _tips(self) -> None:
        """Sun and ring, undercut, the tips of a ring of full height."""
        s, rack = self.s, self.given.rack
        s.gap_1_3 = s.m * (s.z3 - s.z1) / 2 - s.e - 2 * s.ha * s.m
        s.least_teeth = 2 * s.ha / sin(s.alpha) ** 2
        s.least_teeth_rounded, s.ring_rule = least_teeth(rack), ring_rule(rack)
        s.alpha_a3 = arccos(s.z3 * cos(s.alpha) / (s.z3 - 2 * s.ha))
        s.cut = self.found.cut

    def _wheels(self) -> Iterator[Wheel]:
        """The sun, the satellites that mirror no other, the ring, whose tips are inside."""
        m, rack, found = self.given.module, self.given.rack, self.found
        named = [
            (SUN, found.sun, 1),
            *((of.wheel, of.teeth, 1) for of in found.upper),
            (RING, found.ring, -1),
        ]
        for row, (name, z, out) in enumerate(named):
            made = Wheel("eccentric_wheels", row, name)
            made.z, made.d, made.d_b = z, m * z, m * z * math.cos(rack.alpha)
            made.d_a = m * (z + 2 * out * rack.ha) + (2 * found.cut if out < 0 else 0.0)
            made.d_f = m * (z - 2 * out * (rack.ha + rack.c))
            yield made

    # ------------------------------------------------------------ satellites

    def _satellite(self, row: int, of: Placed) -> Satellite:
        s, made = self.s, Satellite("eccentric_satellites", row, of_satellite(of.wheel))
        made.z, made.residue = of.teeth, of.residue
        self._angles(made, of)
        made.x, made.y = of.centre.real, of.centre.imag
        made.L = of.belt if of.below else Computed(self._belt(made), of.belt)
        made.l = s.m * (s.z1 + made.z) / 2
        touching = s.z3 * cos(s.alpha) * tan(s.alpha_a3) - (s.z3 - made.z) * sin(s.alpha)
        made.rho = s.m / 2 * touching
        made.z3_least = self._least_ring(made.z, float(least_ring(of.teeth, self.given.rack)))
        return made

    def _angles(self, made: Satellite, of: Placed) -> None:
        """By the cosine rule, of those above the line of the axes."""
        s, z, numbers = self.s, made.z, (math.degrees(of.phi1), math.degrees(of.phi3))
        if of.below or of.kind in ("largest", "smallest"):
            made.phi1, made.phi3 = numbers
            return
        near, far = (s.z1 + z) ** 2, (s.z3 - z) ** 2
        made.phi1 = Computed(arccos((near + s.E**2 - far) / (2 * s.E * (s.z1 + z))), numbers[0])
        made.phi3 = Computed(arccos((near - far - s.E**2) / (2 * s.E * (s.z3 - z))), numbers[1])

    def _belt(self, of: Satellite) -> Expr:
        """L = z2/2 + z1 φ1/360 + z3 φ3/360 + z/2 (1 − (φ3 − φ1)/180), the angles in degrees; −z3/2 in the place of z2/2
        where the line goes over a middle satellite."""
        s = self.s
        around = s.z1 * of.phi1 / FULL + s.z3 * of.phi3 / FULL
        if not self.found.by_middle:
            around = self.set.z2 / 2 + s.z1 * of.phi1 / FULL + s.z3 * of.phi3 / FULL
        line = around + of.z / 2 * (1 - (of.phi3 - of.phi1) / HALF)
        return line - s.z3 / 2 if self.found.by_middle else line

    def _least_ring(self, z: Var, found: float) -> Computed | float:
        """Least teeth of the ring beside a satellite; of a small one none are enough."""
        square, ha = sin(self.s.alpha) ** 2, self.s.ha
        limit = (z**2 * square - 4 * ha**2) / (2 * z * square - 4 * ha)
        return Computed(limit, found) if math.isfinite(found) else found

    def _pair(self, row: int, pair: Neighbours) -> Pair:
        s, one, other = self.s, self.row(pair.one), self.row(pair.other)
        made = Pair("eccentric_neighbours", row, f"{pair.one.wheel},{pair.other.wheel}")
        angle = one.phi1 - other.phi1 if pair.one.phi1 else other.phi1
        made.l = sqrt(one.l**2 + other.l**2 - 2 * one.l * other.l * cos(angle))
        made.gap = self._noise_of_a_module(made.l - s.m * (one.z + other.z) / 2 - 2 * s.ha * s.m)
        return made

    # ------------------------------------------------------------ proof, motion, drawings

    def _proof(self) -> None:
        s, found = self.s, self.found
        s.checked, s.overlap, s.clearance = len(found.proof.turn), found.overlap, found.clearance

    def _motion(self) -> None:
        s = self.s
        s.u = -(s.z3 / s.z1)
        s.u_1H, s.u_3H = 1 - s.u, 1 - 1 / s.u

    def _drawings(self) -> None:
        _scaled(self.s, "drawing_", self.found.scale)
        _scaled(self.s, "close_", self.found.close_scale)

    # ------------------------------------------------------------ what may be asked for besides

    def _near(self) -> None:
        s, near, given = self.s, self.found.nearby, self.given
        if near is None or given.tolerance is None:
            return
        s.tolerance, s.u_wanted = 100 * given.tolerance, float(given.ratio or self.found.ratio_of_teeth)
        s.near_sets, s.near_holding, s.near_ring = len(near.ratio), near.holding, near.ring

    def _masses(self) -> Masses | None:
        """Discs of the satellites of whole teeth, kg, and what the smallest saves in place of the largest; m, kg."""
        s, found, given = self.s, self.found, self.given
        if found.masses is None:
            return None
        s.b, s.density = given.width, given.density
        made = Masses("eccentric_masses", found.row)
        made.held = float(found.masses.held[found.row])
        made.m2 = None if found.halved else self._disc(self.set.z2)
        made.m4 = self._disc(self.set.z4) if found.middle_whole else None
        if not found.halved:
            made.m5 = self._disc(self.set.z5)
            made.saving = made.m2 - made.m5
            s.saved_share = made.saving / made.m2 * Number(100)
        return made

    def _disc(self, z: Var) -> Expr:
        d = self.s["m"].var("m") * z
        return PI * d**2 * self.s.b * self.s.density / 4

    def _loads(self) -> Iterator[Loaded]:
        """The circumferential forces, of which the moment tells the sum, shared by the least energy of meshes and axes;
        normal forces, forces on the axes."""
        s, found, load = self.s, self.found, self.given.load
        if load is None:
            return
        r_1, r_3 = (s[key].var("m") for key in ("r_1", "r_3"))
        if load.on == "sun":
            s.M_1 = load.moment
            s.F_sum = abs(s.M_1) / r_1
            s.M_3 = s.M_1 * r_3 / r_1
        else:
            s.M_3 = load.moment
            s.F_sum = abs(s.M_3) / r_3
            s.M_1 = s.M_3 * r_1 / r_3
        s.M_H = -(s.M_1 + s.M_3)
        rows = [self._sharing(row, of, load) for row, of in enumerate(self.satellites)]
        if load.yielding is not None:
            first, *others = (row.w for row in rows)
            s.share_sum = sum(others, first)
        for row in rows:
            row.F_t = (
                s.F_sum * row.w / s.share_sum if load.yielding is not None else s.F_sum / s.var("satellites")
            )
            row.F_n = row.F_t / cos(s.alpha)
            row.Q_ = 2 * row.F_t * cos(self._leaning(row, load)) / cos(s.alpha)
        for key, angle in (("R_1", "phi1"), ("R_3", "phi3")):  # at which every normal force leans alike
            directions = (cmath.exp(1j * getattr(of, angle)) for of in found.satellites)
            forces = (row.number("F_n") * to for row, to in zip(rows, directions, strict=True))
            s.put(key, abs(sum(forces)))
        yield from rows

    def _sharing(self, number: int, of: Satellite, load: MeshLoad) -> Loaded:
        wheel = self.found.satellites[number].wheel
        row = Loaded("eccentric_loads", number, wheel)
        row.gamma = Computed(of.phi3 - of.phi1, scale=360.0)
        if load.yielding is not None:
            if "kappa" not in self.s:
                self.s.kappa = load.yielding
            row.w = 1 / (1 + 2 * self.s.kappa * cos(self._leaning(row, load)) ** 2)
        return row

    def _leaning(self, row: Loaded, load: MeshLoad) -> Expr:
        """Between a normal force and the sum of both: the satellite leans with the moment on one side of the line of
        the axes, against it on the other."""
        half = row.gamma / 2
        return self.s.alpha + half if load.moment > 0 else self.s.alpha - half

    def _path(self, path: Traced) -> Path:
        table, point = f"eccentric_path_{path.name}", path.point
        s, place = OfPath(of_path(path), prefix=table), Place(table, WRITTEN, other=of_place(path))
        s.radius, s.angle, s.turns = point.radius, math.degrees(point.angle), path.turns
        of_ring = point.of_ring
        s.rate = 1 + (self.s.z1 / self.s.z3 if of_ring else self.s.z3 / self.s.z1)
        _scaled(s, "", paper.path_scale(path))
        place.theta = math.degrees(path.theta[WRITTEN])
        turned, e, theta = s.rate * place.theta + s.angle, self.s.e, place.theta
        for key, of in (("x", cos), ("y", sin)):
            there = s.radius * of(turned)
            whole = e * of(theta) + there if of_ring else there - e * of(theta)
            place.put(key, Computed(whole, scale=s.radius.number))
        return Path(path, s, place)


def _scaled(s: Sheet, which: str, scale: float) -> None:
    """A scale is written 1:2 or 4:1: the number that is not 1."""
    s.put(f"{which}enlargement" if scale >= 1 else f"{which}reduction", scale if scale >= 1 else 1 / scale)
