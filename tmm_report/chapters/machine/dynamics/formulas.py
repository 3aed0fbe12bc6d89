"""The formulas of the machine in motion, each evaluated and printed by the same tree."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from tmm_report.chapters.machine.dynamics import quantities as q
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.mechanics.calculus.laws import Constant
from tmm_report.mechanics.machine.characteristics import Kloss, Linear, Series
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Number, Var, sqrt
from tmm_report.quantity.model import Book, Table
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation

SAMPLE_SPEED = 54  # row of the characteristics of which the formula is written out


def _total(terms: list[Expr]) -> Expr:
    first, *others = terms
    for term in others:
        first = first + term
    return first


class DynamicsFormulas:
    """`position`: the position of the cycle that is written out in full."""

    def __init__(self, found: Found, position: int):
        self.found, self.position = found, position

    @cached_property
    def book(self) -> Book:
        return q.book(self.found)

    def var(self, key: str) -> Var:
        return self.book[f"dynamics_{key}"].var()

    def table(self, name: str) -> Table:
        return self.book.tables[f"dynamics_{name}"]

    # ------------------------------------------------------------ reduction

    @property
    def inert(self) -> bool:
        """Whether a part has a moment of inertia or a mass."""
        return any(True for _ in self._inertias())

    def inertia(self) -> Formula:
        """Moment of inertia of the parts on the main shaft."""
        return self.book["dynamics_J_parts"].formula(_total(list(self._inertias())))

    def _inertias(self) -> Iterator[Expr]:
        table = self.table("parts")
        for row, one in enumerate(self.found.whole.parts):
            part = one.part
            for key, arm, plain in (("J", "i", part.ratio == 1), ("m", "r", False)):
                if (part.inertia if key == "J" else part.mass and part.arm) == 0:
                    continue
                yield table.var(key, row) if plain else table.var(key, row) * table.var(arm, row) ** 2

    @property
    def resisted(self) -> bool:
        """Whether a part resists or drives."""
        return any(one.moment for one in self.found.whole.parts)

    def resisting(self) -> Formula:
        """Moment of the parts on the main shaft."""
        return self.book["dynamics_M_parts"].formula(_total(list(self._moments())))

    def _moments(self) -> Iterator[Expr]:
        for row, one in enumerate(self.found.whole.parts):
            terms = self._taken(row)
            if terms:
                yield self._passed(_total(terms), row, one.moment)

    def _taken(self, row: int) -> list[Expr]:
        """What a part takes from the main shaft without losses."""
        table, part = self.table("parts"), self.found.whole.parts[row].part
        sizes = {key: float(table[key].values[row]) for key in ("M", "F")}
        return [
            table.var(key, row)
            if key == "M" and part.ratio == 1
            else table.var(key, row) * table.var(arm, row)
            for key, arm in (("M", "i"), ("F", "r"))
            if sizes[key] and not np.isnan(sizes[key])
        ]

    def _passed(self, taken: Expr, row: int, sign: float) -> Expr:
        """With the losses of the gears, on the side to which the power goes."""
        if self.found.whole.parts[row].part.efficiency == 1:
            return taken
        eta = self.table("parts").var("eta", row)
        return taken * eta if sign < 0 else taken / eta

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
        return [table.formula("M_lost", row, _total(list(self._losing(epsilon))))]

    def _losing(self, epsilon: Var) -> Iterator[Expr]:
        parts = self.table("parts")
        for row, one in enumerate(self.found.whole.parts):
            if not one.inertia or one.part.efficiency == 1:
                continue
            still = float(one.moment)
            gained, eta = parts.var("J_red", row) * epsilon, parts.var("eta", row)
            whole = still * (one.part.efficiency if still > 0 else 1 / one.part.efficiency) + gained.value
            if still == 0 or still * whole > 0:
                yield gained * (eta - 1) if whole < 0 else gained * (1 / eta - 1)
            else:
                taken = self._passed(_total([gained, *self._taken(row)]), row, whole)
                yield taken - gained - parts.var("M_red", row)

    # ------------------------------------------------------------ the motor

    @property
    def row(self) -> int:
        return SAMPLE_SPEED

    def motor(self) -> list[Formula]:
        """Its moment at one speed; of an induction motor the slip first."""
        motor, table = self.found.given.motor, self.table("characteristics")
        assert motor is not None  # asked for only where there is one
        omega: Expr = table.var("omega", self.row)
        own = omega * self.var("i_motor") if motor.geared else omega
        found: list[Formula] = []
        match motor.own:
            case Linear():
                moment: Expr = self.var("M_stall") * (1 - own / self.var("omega_0"))
            case Series():
                moment = self.var("a") / (own + self.var("b")) ** 2
            case Kloss():
                found.append(table.formula("s", self.row, 1 - own / self.var("omega_0")))
                moment = self._kloss(table.var("s", self.row))
            case _:
                return []
        if motor.geared:
            eta = self.var("eta_motor")
            brakes = table["M_dr"].values[self.row] < 0
            moment = self.var("i_motor") * moment / eta if brakes else self.var("i_motor") * eta * moment
        return [*found, table.formula("M_dr", self.row, moment)]

    def _kloss(self, s: Expr) -> Expr:
        critical = self.var("s_cr")
        sum_ = s / critical + critical / s
        if "dynamics_a" not in self.book.values:
            return 2 * self.var("M_max") / sum_
        a = self.var("a")
        return 2 * self.var("M_max") * (1 + a * critical) / (sum_ + 2 * a * critical)

    # ------------------------------------------------------------ the equation of motion, in symbols

    def energy(self) -> Definition:
        """T = T0 + A."""
        return Definition("T", Var("T_0", 0.0) + Var("A", 0.0))

    def differential(self) -> Equation:
        J, epsilon, omega = Var("J", 1.0), Var("epsilon", 1.0), Var("omega", 1.0)
        driving, resisting = Var(Symbol("M", "dr"), 1.0), Var(Symbol("M", "res"), 1.0)
        return Equation(self._inertial(J, epsilon, omega) - driving + resisting, numbers=False)

    def _inertial(self, J: Expr, epsilon: Expr, omega: Expr) -> Expr:
        if self.found.constant_inertia:
            return J * epsilon
        return J * epsilon + Var(Symbol("J'"), 1.0) * omega**2 / 2

    def lagrange(self) -> Equation:
        """J ε + J′ω²/2 + V′ − Q = 0."""
        left = self._inertial(Var("J", 1.0), Var("epsilon", 1.0), Var("omega", 1.0))
        return Equation(left + Var(Symbol("V'"), 1.0) - Var("Q", 1.0), numbers=False)

    def separated(self) -> list[Definition]:
        """dt = J dω/(M_dr − M_res), dφ = ω dt."""
        J, rise, moments = Var("J", 1.0), Var(Symbol("dω"), 1.0), Var(Symbol("M", "dr"), 1.0)
        time = J * rise / (moments - Var(Symbol("M", "res"), 1.0))
        return [
            Definition(Symbol("dt"), time),
            Definition(Symbol("dφ"), Var("omega", 1.0) * Var(Symbol("dt"), 1.0)),
        ]

    def accelerated(self) -> Formula:
        """The angular acceleration half way through the table of the start-up, of a constant moment of inertia."""
        table = self.table("start")
        row = len(table) // 2
        moments = table.var("M_dr", row) - table.var("M_res", row)
        return table.formula("epsilon", row, moments / self.var("J"))

    def uniform(self) -> list[Formula]:
        """The angular acceleration under constant moments, of a constant moment of inertia."""
        driving, motor = self.var("M_dr"), self.found.given.motor
        found = []
        if motor is not None and motor.geared and isinstance(motor.own, Constant):
            own = self.var("i_motor") * self.var("eta_motor") * self.var("M_motor")
            found.append(self.book["dynamics_M_dr"].formula(own))
        epsilon = (driving - self.var("M_res")) / self.var("J")
        return [*found, self.book["dynamics_epsilon"].formula(epsilon)]

    def kinetic(self) -> Formula:
        """Energy of the steady motion, of a constant moment of inertia."""
        return self.book["dynamics_T_steady"].formula(self.var("J") * self.var("omega_m") ** 2 / 2)

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
        energy = 2 * (self.var("T_0") + self.at("A")) / self.at("J")
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
            parts = [self.at("I_red"), *([self.var("J_parts")] if self.found.whole.parts else [])]
            if len(parts) > 1:
                yield cycle.formula("J", k, _total(list(parts)))
            resisting: Expr = self.at("M_fr") - self.at("M_red")
            if "M_lost" in cycle:
                resisting = resisting + self.at("M_lost")
            yield cycle.formula("M_res", k, resisting)

    def by_potential(self) -> Formula:
        """The angular acceleration by Lagrange's equation."""
        left = self._accelerating(self.at("Q") - self.at("V_slope"))
        return self.cycle.formula("epsilon", self.position, left / self.at("J"))

    def mean(self) -> Formula:
        ends = self.var("omega_max") + self.var("omega_min")
        return self.book["dynamics_omega_m"].formula(ends / Number(2))

    def delta(self) -> Formula:
        ends = self.var("omega_max") - self.var("omega_min")
        return self.book["dynamics_delta"].formula(ends / self.var("omega_m"))
