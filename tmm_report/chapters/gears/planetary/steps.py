"""The numbers of a planetary stage with the expressions that the note prints of them; lengths in mm.

Teeth are sought through by the hundred thousand: the numbers are those of mechanics/gears/planetary.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.chapters.gears.planetary.solve.stated_shifts import whole
from tmm_report.chapters.gears.planetary.values import TRANSVERSE, Mesh, Values, Wheel, letters
from tmm_report.mechanics.gears.pair_sizes import least_teeth, ring_rule
from tmm_report.mechanics.gears.planetary.stage import EXTERNAL, INTERNAL, ROWS, Member
from tmm_report.quantity.formula import Expr, Number, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.functions import arctan
from tmm_report.quantity.sheet import Computed, Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.gear_terms import involute
from tmm_report.quantity.terms.wheel_words import DIAMETERS


def stage(found: Found, prefix: str) -> Stage:
    """The numbers of a stage, made once; every name begins with `prefix`."""
    return next(iter(_stages(found, prefix)))


@tabulated
def _stages(found: Found, prefix: str) -> Iterator[Stage]:
    yield Stage(found, prefix)


def _degrees(angle: Any) -> float:
    return float(np.degrees(angle))


class Stage:
    """`s`: the single numbers; `rows`: of the table of wheels, which has the one crown of a single row once; `meshes`:
    of wheel 1 and of wheel 3 with their crowns."""

    def __init__(self, found: Found, prefix: str):
        self.found, self.given, self.task = found, found.given, found.given.task
        self.scheme, self.sizes = found.scheme, found.sizes
        self.s = Values(letters(found), prefix)
        self.rows = self._wheels(f"{prefix}_wheels")
        self.meshes = self._meshes(f"{prefix}_rows")
        for step in (
            self._stated, self._helical, self._ratio, self._distances, self._undercut, self._rings, self._satellites,
            self._assembly, self._loads,
        ):  # fmt: skip
            step()

    # ------------------------------------------------------------ rows and terms

    def _wheels(self, table: str) -> tuple[Wheel, ...]:
        names, helix = self.given.wheels, self.given.helix
        other = {"x": Q(Symbol("x", "t"), "", TRANSVERSE)} if helix else {}
        return tuple(Wheel(table, row, names[wheel], other) for row, wheel in enumerate(self.scheme.wheels))

    def _meshes(self, table: str) -> tuple[Mesh, ...]:
        """The satellite's numbers by the crown's name, the ring's by the ring's."""
        names = self.given.wheels
        made = []
        for row, (ring, crown) in enumerate(((names[0], names[1]), (names[3], names[2]))):
            index = {"d_w": crown, "rho_l": crown, "d_a_cut": ring, "z_least": ring}
            total = Symbol("x", "Sigma" if self.scheme.rows[row] == EXTERNAL else "d")
            made.append(Mesh(table, row, index, {"x_sum": Mesh.x_sum.called(total)}))
        return tuple(made)

    def row_of(self, wheel: int) -> int:
        """In the table, of wheels 1, 2, 2', 3 by their index 0..3."""
        return self.scheme.wheels.index(1 if wheel == 2 and self.scheme.single else wheel)

    def w(self, wheel: int) -> Wheel:
        return self.rows[self.row_of(wheel)]

    def m(self, row: int) -> Var:
        return self.s.m if self.given.one_module else (self.s.m_I, self.s.m_II)[row]

    def basic(self) -> Var:
        """u13(H), with more digits where its difference from 1 has few of them."""
        near = max(0, math.ceil(-math.log10(abs(1 - self.found.basic))))
        return self.s["u_basic"].var(digits=5 + near)

    def teeth_sum(self, row: int) -> Expr:
        """z1 + z2 or z3 − z2' of a row."""
        outer, inner = (self.w(wheel).z for wheel in ROWS[row])
        return outer + inner if self.scheme.rows[row] == EXTERNAL else outer - inner

    # ------------------------------------------------------------ what is stated

    def _stated(self) -> None:
        s, given, task = self.s, self.given, self.task
        s.u_wanted, s.tolerance, s.eta_stopped = task.ratio, 100 * task.tolerance, given.efficiency
        s.k_least, s.k_most, s.k = task.satellites[0], task.satellites[-1], self.found.satellites
        s.ratio_weight = task.weight or None
        (s.external_least, s.external_most), (s.rings_least, s.rings_most) = task.external, task.rings
        s.combinations, s.solutions = self.found.candidates.examined, self.found.candidates.solutions
        for row, wheel in zip(self.rows, self.scheme.wheels, strict=True):
            row.z, row.x = self.found.teeth[wheel], float(self.sizes.shifts[wheel])
            if given.helix:
                row.x_n = float(self.sizes.shifts[wheel] / np.cos(given.helix))

    def _helical(self) -> None:
        """Modules, profile angle and addendum; of helical teeth of the transverse section."""
        s, given, rack = self.s, self.given, self.task.rack
        keys = ("m",) if given.one_module else ("m_I", "m_II")
        if given.module_n is None or given.rack_n is None:
            for key, metres in zip(keys, self.task.modules, strict=False):
                s.put(key, metres)
            s.alpha, s.ha = _degrees(rack.alpha), rack.ha
            return
        s.beta, s.alpha_n, s.ha_n = _degrees(given.helix), _degrees(given.rack_n.alpha), given.rack_n.ha
        turn = cos(s.beta)
        for key, normal, metres in zip(keys, given.module_n, self.task.modules, strict=False):
            s.put(f"{key}_n", normal)
            s.put(key, Computed(s.var(f"{key}_n") / turn, metres))
        s.alpha = Computed(arctan(tan(s.alpha_n) / turn), _degrees(rack.alpha))
        s.ha = Computed(s.ha_n * turn, rack.ha)

    # ------------------------------------------------------------ ratio

    @property
    def ordinary(self) -> bool:
        """Whether the carrier is held and wheel 1 drives: the stage's ratio is the basic one itself."""
        return self.task.output == "wheel3" and self.task.input == "wheel1"

    def _ratio(self) -> None:
        """Willis' ratio of the stage with its carrier stopped, and by it that of the stage."""
        s, found = self.s, self.found
        z1, z2, z2_, z3 = (self.w(wheel).z for wheel in range(4))
        value = z3 / z1 if self.scheme.single else (z2 * z3) / (z1 * z2_)
        s.u_basic = Computed(value if found.basic > 0 else -value, found.basic)
        s.u_carrier, s.delta_u = 1 - found.basic, 100 * found.deviation
        s.u = (
            found.ratio
            if self.ordinary
            else Computed(self._of_motion(self.task.input, self.task.output), found.ratio)
        )

    def _of_motion(self, input: Member, output: Member) -> Expr:
        u = self.basic()
        return {
            ("wheel1", "carrier"): 1 - u,
            ("carrier", "wheel1"): 1 / (1 - u),
            ("wheel3", "carrier"): 1 - 1 / u,
            ("carrier", "wheel3"): 1 / (1 - 1 / u),
            ("wheel3", "wheel1"): 1 / u,
        }[input, output]

    # ------------------------------------------------------------ distances and shifts

    @property
    def whole(self) -> bool:
        """Whether the shift coefficients of all wheels are stated."""
        return whole(self.task)

    @property
    def own_distance(self) -> bool:
        """Whether the centre distance is that of the row without shift: neither it nor all shifts are stated."""
        return self.task.distance is None and not self.whole

    def _distances(self) -> None:
        """The centre distance; operating angle and sum of the shifts of the rows that are opened to it."""
        s, sizes = self.s, self.sizes
        row, distance = int(np.argmax(sizes.pitch_distances)), float(sizes.centre_distance)
        own = self.m(row) * self.teeth_sum(row) / 2
        s.a_w = Computed(own, distance) if self.own_distance else distance
        for row, mesh in enumerate(self.meshes):
            mesh.z_sum, mesh.eps_alpha = self.found.rows.teeth[row], self.found.rows.contact[row]
            a, angle, total = (
                sizes.pitch_distances[row],
                _degrees(sizes.angles[row]),
                float(sizes.shift_sums[row]),
            )
            if row not in self.found.opened:
                mesh.a, mesh.alpha_w, mesh.x_sum = a, angle, total
                continue
            mesh.a = Computed(self.m(row) * self.teeth_sum(row) / 2, a)
            mesh.alpha_w = Computed(arccos(mesh.a * cos(s.alpha) / s.a_w), angle)
            needed = self.teeth_sum(row) * (involute(mesh.alpha_w) - involute(s.alpha)) / (2 * tan(s.alpha))
            mesh.x_sum = total if self.whole else Computed(needed, total)

    def _undercut(self) -> None:
        s, rack = self.s, self.task.rack
        s.least_teeth = Computed(2 * s.ha / sin(s.alpha) ** 2, self.found.least_teeth)
        s.least_teeth_rounded, s.ring_rule = least_teeth(rack), ring_rule(rack)

    # ------------------------------------------------------------ sizes

    def _rings(self) -> None:
        """Diameters; of meshes with a ring what keeps its tips clear of the satellite's fillets."""
        for wheel, row in zip(self.scheme.wheels, self.rows, strict=True):
            numbers = {key: float(self.sizes.diameters[key][wheel]) for key in DIAMETERS}
            rolling = Computed(self.m(0 if wheel < 2 else 1) * row.z, numbers.pop("d_w"))
            row.d_w = rolling.number if self.found.shifted else rolling
            tip = numbers.pop("d_a")
            plain = not self.found.shifted and wheel == self.largest_crown
            row.d_a = Computed(self.m(wheel - 1) * (row.z + 2 * self.s.ha), tip) if plain else tip
            for key, number in numbers.items():
                row.put(key, number)
            row.d_a_full = float(self.sizes.tip[wheel])
        for number, mesh in enumerate(self.meshes):
            self._ring(number, mesh)

    def _ring(self, row: int, mesh: Mesh) -> None:
        s, of, crown, central = self.s, self.found.rows, self.w(row + 1), self.w(ROWS[row][0])
        mesh.d_w, mesh.line, mesh.rho_a = float(self.sizes.working[row + 1]), of.line[row], of.curvature[row]
        if not np.isfinite(of.cut[row]):
            mesh.rho_l, mesh.d_a_cut = of.start[row], of.cut[row]
        else:
            height = s.ha - crown.x if self.sizes.shifts[row + 1] else s.ha
            start = self.m(row) * crown.z / 2 * sin(s.alpha) - self.m(row) * height / sin(s.alpha)
            mesh.rho_l = Computed(start, of.start[row])
            touching = s.a_w * sin(mesh.alpha_w) + mesh.rho_l
            mesh.d_a_cut = Computed(2 * sqrt((central.d_b / 2) ** 2 + touching**2), of.cut[row])
        if not np.isfinite(of.least[row]):
            mesh.z_least = of.least[row]
            return
        z, square = crown.z, sin(s.alpha) ** 2
        least = (z**2 * square - 4 * s.ha**2) / (2 * z * square - 4 * s.ha)
        mesh.z_least = Computed(least, of.least[row])

    @property
    def largest_crown(self) -> int:
        return 1 if self.sizes.tip[1] >= self.sizes.tip[2] else 2

    def _satellites(self) -> None:
        self.s.apart, self.s.gap = self.found.apart, self.found.gap

    # ------------------------------------------------------------ assembly, loads

    def _assembly(self) -> None:
        """(z1 + z3)/k of a single row; of two rows also over the common divisor of the crowns' teeth, and the course's
        C = z1 u1H (1 + k p)/k."""
        s, found = self.s, self.found
        z1, z2, z2_, z3 = (self.w(wheel).z for wheel in range(4))
        if self.scheme.single:
            s.assembly = Computed((z1 + z3) / s.k, found.assembly_number)
            return
        s.divisor = float(np.gcd(found.teeth[1], found.teeth[2]))
        one, other = z1 * z2_, z2 * z3
        top = one + other if self.scheme.rows[0] * self.scheme.rows[1] == INTERNAL else abs(one - other)
        s.assembly = Computed(top / (s.k * s.divisor), found.assembly_number)
        if found.turns is not None:
            s.turns = found.turns
            s.usual_assembly = Computed(
                abs(z1 * s.u_carrier) / s.k * (1 + s.k * s.turns), found.usual_assembly
            )

    def _loads(self) -> None:
        """The circumferential force on one satellite from wheel 1, of each N·m of its torque, N."""
        s, found = self.s, self.found
        rolling = self.w(0)["d_w"].var("m")
        s.eta, s.mu_l = found.efficiency, found.scale
        s.force = Computed(Number(2) / (s.k * rolling), found.force_per_moment)
