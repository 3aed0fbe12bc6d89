"""The formulas of the rows of the machine's tables, and its equations of motion in symbols."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.machine.dynamics import quantities as q
from tmm_report.chapters.machine.dynamics.parts import Taken, total
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.chapters.machine.dynamics.values import Motion
from tmm_report.mechanics.machine.characteristics import Kloss, Linear, Series
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Var, sqrt
from tmm_report.quantity.model import Table
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation

SAMPLE_SPEED = 54  # row of the characteristics of which the formula is written out


class Written:
    """`position`: the position of the cycle that is written out in full."""

    def __init__(self, found: Found, position: int):
        self.found, self.position, self.s = found, position, found.s

    @cached_property
    def _tables(self) -> dict[str, Table]:
        return {table.name: table for table in q.tables(self.found)}

    def table(self, name: str) -> Table:
        return self._tables[f"dynamics_{name}"]

    @property
    def taken(self) -> Taken:
        return Taken(self.table("parts"), self.found.whole.parts)

    # ------------------------------------------------------------ the equations of motion, in symbols

    @cached_property
    def _known(self) -> Table | None:
        """Where the motion stands that the equations are of, over the cycle or in a regime."""
        names = ("cycle_diagram", "start_diagram", "coast_diagram")
        return next((self.table(name) for name in names if f"dynamics_{name}" in self._tables), None)

    def over(self, key: str) -> Var:
        """A quantity over the motion, nan of what is not followed: the equations are printed in symbols."""
        of, table = Motion.DECLARED[key].quantity, self._known
        single = self.s.get(key) if key in ("J", "T_0") else None
        numbers: Any = np.nan if single is None else single
        return Var(of.sign, table[key].numbers() if table is not None and key in table else numbers)

    def energy(self) -> Definition:
        """T = T0 + A."""
        start = Var("T_0", self.s.get("T_0") or np.nan)
        return Definition("T", start + self.over("A"))

    def differential(self) -> Equation:
        return Equation(self._inertial() - self.over("M_dr") + self.over("M_res"), numbers=False)

    def _inertial(self) -> Expr:
        inertia = self.over("J") * self.over("epsilon")
        if self.found.constant_inertia:
            return inertia
        return inertia + self.over("J_slope") * self.over("omega") ** 2 / 2

    def lagrange(self) -> Equation:
        """J ε + J′ω²/2 + V′ − Q = 0."""
        table = self._known
        free = table["Q"].numbers() if table is not None and "Q" in table else np.nan
        return Equation(self._inertial() + self.over("V_slope") - Var("Q", free), numbers=False)

    def separated(self) -> list[Definition]:
        """dt = J dω/(M_dr − M_res), dφ = ω dt: of the samples of the start-up, by the means of each two."""
        run = self.table("start_diagram")
        t, omega, driving, resisting = (run[key].numbers() for key in ("t", "omega", "M_dr", "M_res"))
        means = {"M_dr": driving, "M_res": resisting, "omega": omega}
        mean = {key: Var(run[key].symbol(), (x[1:] + x[:-1]) / 2) for key, x in means.items()}
        time = self.over("J") * Var(Symbol("dω"), np.diff(omega)) / (mean["M_dr"] - mean["M_res"])
        return [
            Definition(Symbol("dt"), time),
            Definition(Symbol("dφ"), mean["omega"] * Var(Symbol("dt"), np.diff(t))),
        ]

    # ------------------------------------------------------------ the motor

    @property
    def row(self) -> int:
        return SAMPLE_SPEED

    def motor(self) -> list[Formula]:
        """Its moment at one speed; of an induction motor the slip first."""
        motor, table = self.found.given.motor, self.table("characteristics")
        assert motor is not None  # asked for only where there is one
        omega: Expr = table.var("omega", self.row)
        own = omega * self.s.i_motor if motor.geared else omega
        found: list[Formula] = []
        match motor.own:
            case Linear():
                moment: Expr = self.s.M_stall * (1 - own / self.s.omega_0)
            case Series():
                moment = self.s.a / (own + self.s.b) ** 2
            case Kloss():
                found.append(table.formula("s", self.row, 1 - own / self.s.omega_0))
                moment = self._kloss(table.var("s", self.row))
            case _:
                return []
        if motor.geared:
            eta = self.s.eta_motor
            brakes = table["M_dr"].values[self.row] < 0
            moment = self.s.i_motor * moment / eta if brakes else self.s.i_motor * eta * moment
        return [*found, table.formula("M_dr", self.row, moment)]

    def _kloss(self, slip: Expr) -> Expr:
        critical = self.s.s_cr
        sum_ = slip / critical + critical / slip
        if "a" not in self.s:
            return 2 * self.s.M_max / sum_
        a = self.s.a
        return 2 * self.s.M_max * (1 + a * critical) / (sum_ + 2 * a * critical)

    # ------------------------------------------------------------ what the gears lose

    def lost(self, name: str) -> list[Formula]:
        """What the gears lose by the acceleration, in the middle row of a start-up or a run-down, or at the sample
        position; of the parts whose power turns round the whole moment, less what is counted without acceleration."""
        run = dict(self.found.runs).get(name)
        plant = run.plant if run else self.found.supplied
        given = self.found.given
        unloaded = name == "coast" and given.coast is not None and not given.coast.load
        if plant.passing is None or (unloaded and any(one.moment or one.force for one in given.parts)):
            return []
        table, row = (self.table(name), len(self.table(name)) // 2) if run else (self.cycle, self.position)
        epsilon = table.var("epsilon", row)
        return [table.formula("M_lost", row, total(list(self.taken.lost(epsilon))))]

    def accelerated(self) -> Formula:
        """The angular acceleration half way through the table of the start-up, of a constant moment of inertia."""
        table = self.table("start")
        row = len(table) // 2
        moments = table.var("M_dr", row) - table.var("M_res", row)
        return table.formula("epsilon", row, moments / self.s.J)

    # ------------------------------------------------------------ the regimes one after another

    def gained(self) -> Formula:
        """The change of the kinetic energy through all regimes, by the works."""
        table = self.table("regimes")
        last = len(table) - 1
        works = [table.var(key, last) for key in q.WORKED if key in table]
        size = 10 * sum(abs(float(one.number)) for one in works)  # they are integrals to so many digits
        return table.formula("gained", last, total([*works]), scale=size)

    # ------------------------------------------------------------ the sample position of the steady motion

    @cached_property
    def cycle(self) -> Table:
        return self.table("cycle_table")

    def at(self, key: str) -> Var:
        return self.cycle.var(key, self.position)

    def sample(self) -> list[Formula]:
        """Everything of one position, from the moment of inertia to the angular acceleration."""
        k, cycle = self.position, self.cycle
        found = list(self._reduced())
        found.append(cycle.formula("M", k, self.at("M_dr") - self.at("M_res")))
        energy = 2 * (self.s.T_0 + self.at("A")) / self.at("J")
        found.append(cycle.formula("omega", k, sqrt(energy)))
        found.append(cycle.formula("epsilon", k, self._accelerating(self.at("M")) / self.at("J")))
        return found

    def _accelerating(self, moment: Expr) -> Expr:
        """Less what the growing moment of inertia takes."""
        if self.found.constant_inertia:
            return moment
        return moment - self.at("J_slope") * self.at("omega") ** 2 / 2

    def _reduced(self) -> Iterator[Formula]:
        k, cycle = self.position, self.cycle
        yield from self.lost("steady")
        if "I_red" in cycle:
            parts = [self.at("I_red"), *([self.s.J_parts] if self.found.whole.parts else [])]
            if len(parts) > 1:
                yield cycle.formula("J", k, total(list(parts)))
            resisting: Expr = self.at("M_fr") - self.at("M_red")
            if "M_lost" in cycle:
                resisting = resisting + self.at("M_lost")
            yield cycle.formula("M_res", k, resisting)

    def by_potential(self) -> Formula:
        """The angular acceleration by Lagrange's equation."""
        left = self._accelerating(self.at("Q") - self.at("V_slope"))
        return self.cycle.formula("epsilon", self.position, left / self.at("J"))
