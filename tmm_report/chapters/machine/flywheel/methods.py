"""The methods for the flywheel's moment of inertia, one beside another: their table, and the formulas of its rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.machine.flywheel.values import Methods
from tmm_report.mechanics.machine.flywheel.inertia import Method, Touch
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Column, Table, text_column
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine.flywheel.solve import Found

METHODS = Message(N_("moment of inertia of the flywheel by several methods"))


def compared(methods: Mapping[str, Method], own: float) -> Table:
    """One row a method; what it takes for both ends. `own`: of the machine without the flywheel, kg m²."""
    fly = np.array([method.inertia - own for method in methods.values()])
    exact = methods["exact"].inertia - own
    off = 100 * (fly - exact) / exact if exact > 0 else np.full(len(fly), np.nan)
    columns = (
        text_column("method", Message(N_("method")), list(methods)),
        Methods.J_I.column([method.inertia for method in methods.values()]),
        Methods.J_fl.column(fly),
        Methods.deviation.column(off),
        *_ends("1", [method.upper for method in methods.values()]),
        *_ends("2", [method.lower for method in methods.values()]),
    )
    return Table("flywheel_methods", METHODS, columns)


def _ends(end: str, touches: list[Touch]) -> Iterator[Column]:
    yield Methods.DECLARED[f"phi_{end}"].column(np.degrees([one.at for one in touches]))
    for key, name in (("J", "inertia"), ("A", "work"), ("s", "slope"), ("T", "cut")):
        yield Methods.DECLARED[f"{key}_{end}"].column([getattr(one, name) for one in touches])


@dataclass(frozen=True, eq=False)
class Written:
    """A method's row, written out."""

    found: Found
    method: str

    @property
    def row(self) -> int:
        return list(self.found.methods).index(self.method)

    def at(self, key: str) -> Var:
        return self.found.at(self.method, key)

    def _formula(self, key: str, expression: Expr) -> Formula:
        return self.found.compared.formula(key, self.row, expression)

    def cut(self, end: str) -> Formula:
        """A − s J_II at an end, "1" or "2": what the tangent there cuts off."""
        s = self.found.s
        squares: dict[str, tuple[Expr, Expr]] = {
            "mertsalov": (s.omega_m**2, s.omega_m**2),
            "wittenbauer": (s.omega_m**2 * (1 + s.delta), s.omega_m**2 * (1 - s.delta)),
            "exact": (s.omega_max**2, s.omega_min**2),
        }
        square = squares[self.method]["12".index(end)]
        return self._formula(f"T_{end}", self.at(f"A_{end}") - self.at(f"J_{end}") * square / 2)

    def needed(self) -> Formula:
        """J_I: of Wittenbauer by the segment between the tangents, of Rerikh by the equation of energy between both
        positions, of a constant moment of inertia by the excess work, of the others by the swing of the energy."""
        s, at = self.found.s, self.at
        swing: Expr = at("T_1") - at("T_2")
        if self.method == "rerikh":
            inertias = (1 + s.delta) * at("J_1") - (1 - s.delta) * at("J_2")
            over = 2 * (at("A_1") - at("A_2")) - s.omega_m**2 * inertias
            return self._formula("J_I", over / (2 * s.delta * s.omega_m**2))
        if not self.found.varies:
            swing = s.A_ex
        elif self.method == "wittenbauer":
            swing = s.ab * s.mu_T
        return self._formula("J_I", swing / (s.delta * s.omega_m**2))

    def wheel(self) -> Formula:
        """What is left for the flywheel."""
        return self._formula("J_fl", self.at("J_I") - self.found.s.J_own)
