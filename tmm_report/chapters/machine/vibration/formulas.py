"""Formulas of the vibration with their numbers, each over the values of the results."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.machine.vibration.quantities import book, ratio
from tmm_report.chapters.machine.vibration.solve import Found
from tmm_report.chapters.machine.vibration.values import units
from tmm_report.i18n import NP_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import PI, Expr, Formula, Function, Var, cos, sin, sqrt
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.gear_terms import arctan
from tmm_report.quantity.written import Equation


class VibrationFormulas:
    def __init__(self, found: Found):
        self.found, self.given = found, found.given
        self.of = book(found)
        self.units = units(found)

    def v(self, key: str, unit: str = "") -> Var:
        return self.of[key].var(unit)

    def f(self, key: str, expression: Expr, unit: str = "") -> Formula:
        return self.of[key].formula(expression, unit)

    # --- the isolators

    def whole(self) -> list[Formula]:
        """Stiffness and damping of all the isolators side by side."""
        made = [self.f("stiffness", self.v("isolators") * self.v("stiffness_each"))]
        if self.given.ratio is None:
            made.append(self.f("damping", self.v("isolators") * self.v("damping_each")))
        return made

    def chosen(self) -> list[Formula]:
        """The stiffness that the wanted force ratio asks for."""
        wanted, zeta = self.v("wanted"), self.v("zeta")
        free = 1 - wanted**2
        p = self.v("half")
        return [
            self.f("half", wanted**2 + 2 * zeta**2 * free),
            self.f("needed", sqrt(p + sqrt(p**2 + wanted**2 * free)) / wanted),
            self.f("needed_stiffness", self.v("inertia") * (self.v("omega") / self.v("needed")) ** 2),
        ]

    def each(self) -> Formula:
        return self.f("stiffness_each", self.v("needed_stiffness") / self.v("isolators"))

    def natural(self) -> Formula:
        return self.f("natural", sqrt(self.v("stiffness") / self.v("inertia")))

    def sag(self) -> Formula:
        return self.f("sag", self.v("inertia") * self.v("g") / self.v("stiffness"))

    def damping(self) -> list[Formula]:
        """From the damping to its ratio, or back."""
        if self.given.ratio is not None:
            return [
                self.f("decay", self.v("zeta") * self.v("natural")),
                self.f("damping", 2 * self.v("decay") * self.v("inertia")),
            ]
        return [
            self.f("decay", self.v("damping") / (2 * self.v("inertia"))),
            self.f("zeta", self.v("decay") / self.v("natural")),
        ]

    def most_damping(self) -> Formula:
        wanted, eta = self.v("wanted"), self.v("eta")
        above = wanted**2 * (1 - eta**2) ** 2 - 1
        return self.f("most_damping", sqrt(above / (1 - wanted**2)) / (2 * eta))

    # --- free motion

    def equation(self) -> Equation:
        """Of the motion, in symbols: primes are derivatives by the time."""
        x, m, b, c = (Var(sign, 0.0) for sign in (self.units.x, self.units.letters[0], "b", "c"))
        once, twice = (Var(Symbol(self.units.x + primes), 0.0) for primes in ("'", "''"))
        if self.given.base is not None:
            z, speed = Var("z", 0.0), Var(Symbol("z'"), 0.0)
            return Equation(m * twice + b * (once - speed) + c * (x - z), numbers=False)
        if self.given.free:
            return Equation(m * twice + b * once + c * x, numbers=False)
        force: Expr = Var(self.units.F, 0.0) * sin(self._turned)
        if self.found.shaking is not None:
            force = Var(Symbol("F(t)"), 0.0)
        return Equation(m * twice + b * once + c * x - force, numbers=False)

    @property
    def _turned(self) -> Expr:
        return Var("omega", 0.0) * Var("t", 0.0)

    def solution(self) -> Definition:
        """The free and the forced part, in symbols."""
        t, n, one, other = (Var(sign, 0.0) for sign in ("t", "n", "C_1", "C_2"))
        decays = Function(NP_("function", "exp"), -(n * t), np.exp)
        if self.found.kind == "under":
            angle = Var("omega_d", 0.0) * t
            inside = one * cos(angle) + other * sin(angle)
        elif self.found.kind == "critical":
            inside = one + other * t
        else:
            angle = Var("q", 0.0) * t
            inside = one * Function(NP_("function", "cosh"), angle, np.cosh) + other * Function(
                NP_("function", "sinh"), angle, np.sinh
            )
        free = decays * inside if self.found.zeta > 0 else inside
        if self.given.free:
            return Definition(Symbol(self.units.x), free)
        forced = Var("A", 0.0) * sin(self._turned - Var("psi", 0.0))
        return Definition(Symbol(self.units.x), free + forced)

    def damped(self) -> Formula:
        return self.f("damped", sqrt(self.v("natural") ** 2 - self.v("decay") ** 2))

    def creep(self) -> Formula:
        return self.f("root", sqrt(self.v("decay") ** 2 - self.v("natural") ** 2))

    def constants(self) -> list[Formula]:
        """By the place and the velocity at the start."""
        one, kind = self.v("C1"), self.found.kind
        root = None if kind == "critical" else self.v("damped" if kind == "under" else "root")
        push = self.v("speed") + self.v("decay") * one
        if self.given.free:
            whole = push / root if root is not None else push
            return [self.f("C1", self.v("place")), self.f("C2", whole)]
        A, psi = self.v("amplitude"), self.v("lag", "deg")
        push = push - A * self.v("omega") * cos(psi)
        return [
            self.f("C1", self.v("place") + A * sin(psi)),
            self.f("C2", push / root if root is not None else push),
        ]

    def dying(self) -> list[Formula]:
        """Period, logarithmic decrement and what it says of two amplitudes; the first of these."""
        made = [self.f("period", 2 * PI / self.v("damped"))]
        if self.found.decrement is not None:
            made.append(self.f("decrement", self.v("decay") * self.v("period")))
            made.append(self.f("falls", Function(NP_("function", "exp"), self.v("decrement"), np.exp)))
        return [*made, self.f("begins", sqrt(self.v("C1") ** 2 + self.v("C2") ** 2))]

    # --- steady motion

    def growth(self) -> Formula:
        return self.f("growth", PI * self.v("static"))

    def unbalance(self) -> Formula:
        return self.f("force", self.v("unbalance") * self.v("radius") * self.v("omega") ** 2)

    def eta(self) -> Formula:
        return self.f("eta", self.v("omega") / self.v("natural"))

    def static(self) -> Formula:
        return self.f("static", self.v("force") / self.v("stiffness"))

    @property
    def _rest(self) -> Expr:
        """1 − η²."""
        return 1 - self.v("eta") ** 2

    @property
    def _resists(self) -> Expr:
        """4ζ²η²."""
        return 4 * self.v("zeta") ** 2 * self.v("eta") ** 2

    def beta(self) -> Formula:
        return self.f("beta", 1 / sqrt(self._rest**2 + self._resists))

    def amplitude(self) -> Formula:
        if self.given.base is not None:
            return self.f("amplitude", self.v("ratio_z") * self.v("base"))
        return self.f("amplitude", self.v("beta") * self.v("static"))

    def lag(self) -> Formula:
        """Within a half turn: beyond resonance the force is more than a quarter ahead."""
        eta, twice = self.v("eta"), 2 * self.v("zeta") * self.v("eta")
        after = None if self.given.base is None else arctan(twice)
        if self.found.eta < 1:
            lag = arctan(twice / self._rest)
        elif self.found.eta > 1:
            lag = PI - arctan(twice / (eta**2 - 1))
        else:
            lag = PI / 2
        return self.f("lag", lag if after is None else lag - after, "deg")

    # --- what reaches the base

    def ratio(self) -> Formula:
        return self.f(ratio(self.found), sqrt((1 + self._resists) / (self._rest**2 + self._resists)))

    def on_base(self) -> Formula:
        if self.given.base is not None:
            return self.f("on_base", self.v("inertia") * self.v("omega") ** 2 * self.v("amplitude"))
        return self.f("on_base", self.v("ratio") * self.v("force"))

    def on_each(self) -> Formula:
        return self.f("on_base_each", self.v("on_base") / self.v("isolators"))

    def peak(self) -> list[Formula]:
        zeta = self.v("zeta")
        return [
            self.f("eta_peak", sqrt(1 - 2 * zeta**2)),
            self.f("beta_peak", 1 / (2 * zeta * sqrt(1 - zeta**2))),
        ]

    def most(self) -> Formula:
        return self.f("eta_most", 1 / sqrt(1 - 2 * self.v("zeta") ** 2))

    # --- dry friction

    def dry(self) -> list[Formula]:
        friction, force = self.v("friction"), self.v("force")
        free = sqrt(1 - (4 * friction / (PI * force)) ** 2)
        return [
            self.f("dry", self.v("static") * free / abs(self._rest)),
            self.f("equivalent", 4 * friction / (PI * self.v("omega") * self.v("dry"))),
        ]

    # --- a base that gives way

    def pair(self) -> list[Formula]:
        m, c, under, below = (
            self.v(key) for key in ("inertia", "stiffness", "base_inertia", "base_stiffness")
        )
        h = self.v("pair_half")
        swing = sqrt(h**2 - c * below / (under * m))
        return [
            self.f("pair_half", (under * c + m * (below + c)) / (2 * under * m)),
            self.f("pair_low", sqrt(h - swing)),
            self.f("pair_high", sqrt(h + swing)),
        ]

    def gamma(self) -> Formula:
        """Of the machine and its base, by the equilibrium of the base."""
        w, c, b = self.v("omega"), self.v("stiffness"), self.v("damping")
        stiff = c + self.v("base_stiffness") - self.v("base_inertia") * w**2
        rough = w * (b + self.v("base_damping"))
        return self.f("gamma", sqrt((stiff**2 + rough**2) / (c**2 + (w * b) ** 2)))

    # --- absorbers

    def tuned(self) -> list[Formula]:
        """Mass, springs and swing of an absorber without damping."""
        made = [self.f("mu", self.v("absorber") / self.v("inertia"))]
        if self.given.absorber is not None and self.given.absorber.clear is not None:
            made = [self.f("absorber", self.v("mu") * self.v("inertia"))]
        c = self.v("absorber_stiffness")
        springs = self.v("absorber_springs")
        arm = self.given.absorber is not None and self.given.absorber.arm is not None
        below = springs * self.v("absorber_arm") ** 2 if arm else springs
        made.append(self.f("absorber_stiffness", self.v("absorber") * self.v("omega") ** 2))
        made.append(self.f("absorber_each", c / below))
        return [*made, self.f("absorber_swing", self.v("force") / c)] if self.given.base is None else made

    def split(self) -> list[Formula]:
        natural, own, h, mu = self.v("natural"), self.v("omega"), self.v("split_half"), self.v("mu")
        swing = sqrt(h**2 - natural**2 * own**2)
        return [
            self.f("split_half", (natural**2 + (1 + mu) * own**2) / 2),
            self.f("split_low", sqrt(h - swing)),
            self.f("split_high", sqrt(h + swing)),
        ]

    def best(self) -> list[Formula]:
        mu = self.v("mu")
        return [
            self.f("best_natural", self.v("natural") / (1 + mu)),
            self.f("best_ratio", sqrt(3 * mu / (8 * (1 + mu)))),
        ]

    def lanchester(self) -> Formula:
        mu = self.v("mu")
        return self.f("lanchester_ratio", 1 / sqrt(2 * (1 + mu) * (2 + mu)))
