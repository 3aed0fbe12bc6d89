"""Formulas of the note that no chapter keeps itself: a definition with the numbers of the sample position."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from tmm_report.chapters.friction.solve import PairLoss
from tmm_report.chapters.kinetostatics.solve import lever_terms
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Expr, Formula, Number, Page, Var
from tmm_report.quantity.symbols import Symbol, notation, segment
from tmm_report.quantity.written import load_keys, reaction_key, symbol_of


class Power(NamedTuple):
    """Power of a load at the sample position, W. `symbols`: of the forces it is made of."""

    symbols: tuple[Symbol, ...]
    power: float


@dataclass(frozen=True, eq=False)
class Definition:
    """`result` = expression, in symbols only."""

    result: Symbol | str
    expression: Expr

    def latex(self, tr: Translator) -> str:
        return self._print(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self._print(notation("mathml", tr))

    def _print(self, form: Any) -> str:
        first, *rest = self.expression.terms(Page(form, numbers=False))
        return form.formula([form.symbol(Var(self.result, 0.0).sign) + form.operator("=") + first, *rest])


def _definition(result: str, expression: Callable[..., Expr], *keys: str) -> Definition:
    return Definition(result, expression(*(Var(key, 0.0) for key in keys)))


WEIGHT = _definition("G", lambda m, g: m * g, "m", "g")
REDUCED_ARM = _definition("h", lambda M, F: M / F, "M_I", "F_I")
DIFFERENCE = _definition(
    "delta", lambda g, a: (g - a) / (Number(0.5) * (g + a)) * Number(100), "x_gr", "x_an"
)
POWER_BALANCE = _definition("M_bal", lambda dT, dt, N, w: (dT / dt - N) / w, "dT", "dt", "N", "omega_1")


class Samples:
    difference, weight, reduced_arm, power_balance = DIFFERENCE, WEIGHT, REDUCED_ARM, POWER_BALANCE

    def __init__(self, results: Any):
        self.r = results

    @property
    def position(self) -> int:
        """The sample position: that of the force plan, else of the plans, else the first that is regular."""
        force_plans = self.r.force_plans.drawn if self.r.force_plans is not None else ()
        if drawn := force_plans or self.r.plans.drawn:
            return drawn[0].position
        found = self.r.kinematics
        lost = (*found.singular, *found.missing)
        return next((k for k in range(len(found.turned)) if k not in lost), 0)

    def speed(self) -> Formula:
        """Revolutions a minute from the angular velocity."""
        omega = Var(self._omega, abs(self.r.kinematics.omega), "rad/s")
        return Formula("n", 30 * omega / Var("pi", np.pi), "rpm")

    @property
    def _omega(self) -> Symbol:
        return Symbol("omega", self.r.given.mechanism.driver.link)

    def mobility(self) -> Formula:
        s = self.r.structure
        n, p5, p4 = Var("n", s.moving_links), Var("p_5", s.lower_pairs), Var("p_4", s.higher_pairs)
        return Formula("W", 3 * n - 2 * p5 - p4)

    def length_scale(self) -> Formula | None:
        """mu_l of the driving link's arm; None where it has no arm."""
        mechanism, pair = self.r.given.mechanism, self.r.structure.linkage.structure.driver_pair
        points = mechanism.links[mechanism.driver.link].points
        pin = next((p for p in points if p != pair.name), None)
        if pin is None:
            return None
        length, scale = abs(points[pin] - points[pair.name]), self.r.plans.length_scale
        ends = pair.name + pin
        return Formula(
            "mu_l", Var(Symbol("l", ends), length, "m") / Var(segment(ends), length / scale, "mm"), "m/mm"
        )

    # ------------------------------------------------------------ forces

    def powers(self) -> list[Power]:
        """Powers of all loads at the sample position, in the order of `kinetostatics.lever_terms`."""
        found, k = self.r.kinetostatics, self.position
        given, loading = found.given, found.table.loading
        terms = lever_terms(given, found.table.motion, loading)[:, k]
        names: list[tuple[Symbol, ...]] = [
            (Symbol("F", f"I{link}"), Symbol("G", link)) for link in loading.inertia
        ]
        names += [(symbol_of(key),) for key in load_keys([force.at for force in given.forces])]
        names += [(Symbol("M", f"I{link}"),) for link in loading.couples]
        names += [(Symbol("M", moment.on),) for moment in given.moments]
        return [Power(name, float(term)) for name, term in zip(names, terms, strict=False)]

    def lever(self) -> Formula:
        """The balancing moment from the sum of powers, at the sample position."""
        total = Var("SigmaN", sum(p.power for p in self.powers()), "W")
        return Formula("M_bal", -total / Var(self._omega, self.r.kinematics.omega, "rad/s"), "N·m")

    def loss(self, loss: PairLoss) -> Formula:
        """Power lost in a pair at the sample position."""
        k, pair = self.position, loss.pair
        force = Var(symbol_of(reaction_key(*pair.links)), float(loss.reaction[k]), "N")
        friction = Var("f", loss.rubbing.coefficient)
        name = Symbol("P", f"fr{pair.name}")
        relative = ",".join(pair.links)
        if pair.kind == "P":
            return Formula(
                name, friction * force * Var(Symbol("v", relative), float(loss.rate[k]), "m/s"), "W"
            )
        arm = Var("d", loss.rubbing.diameter or 0.0, "m") / 2
        return Formula(
            name, friction * force * arm * Var(Symbol("omega", relative), float(loss.rate[k]), "rad/s"), "W"
        )

    def driving_power(self) -> Formula:
        moment: Expr = abs(Var("M_bal", float(self.r.kinetostatics.table.balancing[self.position]), "N·m"))
        power = moment * Var(self._omega, abs(self.r.kinematics.omega), "rad/s")
        return Formula("P_1", power, "W", scale=float(self.r.friction.table.driving.max()))

    def efficiency(self) -> Formula:
        k, table = self.position, self.r.friction.table
        driving = Var("P_1", float(table.driving[k]), "W")
        return Formula("eta", driving / (driving + Var("P_fr", float(table.total[k]), "W")), digits=4)
