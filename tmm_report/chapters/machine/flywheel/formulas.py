"""Formulas of the flywheel: in symbols, in numbers, with their value."""

from __future__ import annotations

import operator
from collections.abc import Iterator
from functools import cached_property, reduce

from tmm_report.chapters.machine.flywheel import quantities as q
from tmm_report.chapters.machine.flywheel.given import Disc
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import PI, POWER, Expr, Formula, Number, Page, Piece, Var, sqrt
from tmm_report.quantity.model import Book, Table, Value
from tmm_report.quantity.terms.gear_terms import arctan
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class FifthRoot(Expr):
    """A power of 0.2."""

    body: Expr

    def evaluate(self, digits: int | None = None) -> float:
        return float(self.body.evaluate(digits)) ** 0.2

    def piece(self, page: Page) -> Piece:
        body = page.bracket(self.body.piece(page), POWER)
        return Piece(page.notation.power(body, Number(0.2).piece(page).text), POWER)


class FlywheelFormulas:
    def __init__(self, found: Found):
        self.found = found

    @cached_property
    def of(self) -> Book:
        return q.book(self.found)

    def one(self, key: str) -> Value:
        return self.of[f"flywheel_{key}"]

    def var(self, key: str) -> Var:
        return self.one(key).var()

    def formula(self, key: str, expression: Expr) -> Formula:
        return self.one(key).formula(expression)

    @property
    def table(self) -> Table:
        return self.of.tables["flywheel_table"]

    @property
    def methods(self) -> Table:
        return self.of.tables["flywheel_methods"]

    # ------------------------------------------------------------ the task

    def definition(self) -> Definition:
        most, least, mean = self.var("omega_max"), self.var("omega_min"), self.var("omega_m")
        return Definition(self.one("delta").symbol, (most - least) / mean)

    def speeds(self) -> Iterator[Formula]:
        mean, delta = self.var("omega_m"), self.var("delta")
        yield self.formula("omega_max", mean * (1 + delta / 2))
        yield self.formula("omega_min", mean * (1 - delta / 2))

    def own(self) -> Formula | None:
        """The machine's own constant part, where it is made of several."""
        motor = self.found.given.motor
        parts: list[Expr] = [self.var(key) for key in ("J_0", "J_c") if self.one(key).value]
        if motor and motor.inertia:
            parts.append(self.var("J_r") * (self.var("omega_nom") / self.var("omega_m")) ** 2)
        elif len(parts) < 2:
            return None
        return self.formula("J_own", reduce(operator.add, parts))

    def balance(self) -> Iterator[Formula]:
        """The constant moment that closes the cycle, its power, that of the motor."""
        yield self.formula("M_m", self.var("W") / self.var("Phi"))
        yield self.formula("P_m", self.var("M_m") * self.var("omega_m"))
        motor = self.found.given.motor
        if self.found.needed is not None and motor and motor.efficiency < 1:
            yield self.formula("P_need", self.var("P_m") / self.var("eta"))

    def swing(self) -> Formula:
        return self.formula("A_ex", self.var("A_max") - self.var("A_min"))

    def share(self) -> Formula:
        """In per cent."""
        return self.formula("C_E", self.var("A_ex") / self.var("W") * 100)

    def sample(self, k: int) -> Iterator[Formula]:
        """One position written out: the excess moment and the change of the energy of the constant part."""
        table = self.table
        if "M_dr" in table and not self.found.sides.spread:
            yield table.formula("M_ex", k, table.var("M_dr", k) + table.var("M_res", k))
        if "dT_I" in table:
            yield table.formula("T_II", k, table.var("J_II", k) * self.var("omega_m") ** 2 / 2)
            yield table.formula("dT_I", k, table.var("A", k) - table.var("T_II", k))

    # ------------------------------------------------------------ the methods

    def row(self, method: str) -> int:
        return list(self.found.methods).index(method)

    def at(self, method: str, key: str) -> Var:
        return self.methods.var(key, self.row(method))

    def _found(self, method: str, key: str, expression: Expr) -> Formula:
        return self.methods.formula(key, self.row(method), expression)

    def cuts(self, method: str) -> Iterator[Formula]:
        """A − s J_II at both ends: what the tangents cut off."""
        mean, delta = self.var("omega_m"), self.var("delta")
        most, least = self.var("omega_max"), self.var("omega_min")
        squares: dict[str, tuple[Expr, Expr]] = {
            "mertsalov": (mean**2, mean**2),
            "wittenbauer": (mean**2 * (1 + delta), mean**2 * (1 - delta)),
            "exact": (most**2, least**2),
        }
        for end, square in zip("12", squares[method], strict=True):
            work, inertia = self.at(method, f"A_{end}"), self.at(method, f"J_{end}")
            yield self._found(method, f"T_{end}", work - inertia * square / 2)

    def needed(self, method: str) -> Formula:
        """J_I by the swing of the energy."""
        swing = self.at(method, "T_1") - self.at(method, "T_2")
        return self._found(method, "J_I", swing / (self.var("delta") * self.var("omega_m") ** 2))

    def wheel(self, method: str) -> Formula:
        """What is left for the flywheel."""
        return self._found(method, "J_fl", self.at(method, "J_I") - self.var("J_own"))

    def between(self) -> Formula:
        """Rerikh: the equation of energy between both positions."""
        at, delta, mean = self.at, self.var("delta"), self.var("omega_m")
        works = 2 * (at("rerikh", "A_1") - at("rerikh", "A_2"))
        inertias = (1 + delta) * at("rerikh", "J_1") - (1 - delta) * at("rerikh", "J_2")
        return self._found("rerikh", "J_I", (works - mean**2 * inertias) / (2 * delta * mean**2))

    def simple(self) -> Formula:
        """Of a constant moment of inertia every method is this."""
        swing = self.var("A_ex") / (self.var("delta") * self.var("omega_m") ** 2)
        return self._found("exact", "J_I", swing)

    # ------------------------------------------------------------ the energy–mass diagram

    def tangents(self) -> Iterator[Formula]:
        delta, mean = self.var("delta"), self.var("omega_m")
        mu_J, mu_T = self.var("mu_J"), self.var("mu_T")
        yield self.formula("psi_1", arctan(mu_J * mean**2 * (1 + delta) / (2 * mu_T)))
        yield self.formula("psi_2", arctan(mu_J * mean**2 * (1 - delta) / (2 * mu_T)))

    def segment(self) -> Formula:
        swing = self.at("wittenbauer", "T_1") - self.at("wittenbauer", "T_2")
        return self.formula("ab", swing / self.var("mu_T"))

    def by_segment(self) -> Formula:
        length = self.var("ab") * self.var("mu_T")
        return self._found("wittenbauer", "J_I", length / (self.var("delta") * self.var("omega_m") ** 2))

    # ------------------------------------------------------------ the motion

    def estimate(self) -> Formula:
        """δ with a constant moment of inertia."""
        inertia: Expr = self.var("J_fl")
        if self.found.cycle.own:
            inertia = inertia + self.var("J_own")
        if self.found.cycle.mean_inertia:
            inertia = inertia + self.var("J_mean")
        return self.formula("delta_est", self.var("A_ex") / (inertia * self.var("omega_m") ** 2))

    def stated_wheel(self) -> Formula:
        return self.formula("J_shaft", self.var("m") * self.var("k") ** 2)

    # ------------------------------------------------------------ dimensions

    def on_shaft(self) -> Formula:
        return self.formula("J_shaft", self.var("J_fl") / self.var("i") ** 2)

    def by_gyration(self) -> Formula:
        return self.formula("m", self.var("J_shaft") / self.var("k") ** 2)

    def dimensions(self) -> Iterator[Formula]:
        yield from self._disc() if isinstance(self.found.given.shape, Disc) else self._rim()

    def _disc(self) -> Iterator[Formula]:
        shape, J, rho, D = self.found.given.shape, self.var("J_shaft"), self.var("rho"), self.var("D")
        if shape.diameter is None:  # type: ignore[union-attr]
            yield self.formula("D", FifthRoot(32 * J / (PI * rho * self.var("k_b"))))
            yield self.formula("b", self.var("k_b") * D)
        else:
            yield self.formula("b", 32 * J / (PI * rho * D**4))
        yield self.formula("m", 8 * J / D**2)

    def _rim(self) -> Iterator[Formula]:
        shape, rho, D, h = self.found.given.shape, self.var("rho"), self.var("D"), self.var("h")
        own = (1 - self.var("k_s")) * self.var("J_shaft")
        k_h, k_b = self.var("k_h"), self.var("k_b")
        if shape.diameter is None:  # type: ignore[union-attr]
            yield self.formula("D", FifthRoot(4 * own / (PI * rho * k_b * k_h**2 * (1 + k_h**2))))
            yield self.formula("h", k_h * D)
        else:
            yield self.formula("h", sqrt((sqrt(D**4 + 16 * own / (PI * rho * k_b * D)) - D**2) / 2))
        yield self.formula("b", k_b * h)
        yield self.formula("m", PI * rho * D * h * self.var("b"))
        yield self.formula("D_out", D + h)

    def speed(self) -> Iterator[Formula]:
        if self.found.sizes and self.found.sizes.ratio != 1:
            yield self.formula("omega_s", self.var("i") * self.var("omega_max"))
        yield self.formula("v", self.var("omega_s") * self.var("D_out") / 2)

    def largest(self) -> Formula:
        return self.formula("D_lim", 2 * self.var("v_lim") / self.var("omega_s"))
