"""Formulas of the machine with its governor: the equations of small motions, their coefficients, stability."""

from __future__ import annotations

from tmm_report.chapters.machine.governor.quantities.in_loop import STATES
from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import FRACTION, Expr, Formula, Number, Page, Piece, Var, sqrt
from tmm_report.quantity.model import Book
from tmm_report.quantity.symbols import Latex, MathML, Symbol, notation
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Relation:
    """left = right, in symbols alone."""

    left: Expr
    right: Expr

    def latex(self, tr: Translator) -> str:
        return self._print(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self._print(notation("mathml", tr))

    def _print(self, form: Latex | MathML) -> str:
        page = Page(form, numbers=False)
        first, *rest = self.right.terms(page)
        return form.formula(["".join(self.left.terms(page)) + form.operator("=") + first, *rest])


def symbol(base: str, sub: str = "") -> Var:
    return Var(Symbol(base, sub), 0.0)


@dataclass(frozen=True, eq=False)
class Rate(Expr):
    """dφ/dt, or d²z/dt²: a derivative by the time, in symbols."""

    sign: Symbol
    order: int = 1

    def latex(self, tr: Translator) -> str:
        return self._print(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self._print(notation("mathml", tr))

    def _print(self, form: Latex | MathML) -> str:
        return form.formula([self.piece(Page(form, numbers=False)).text])

    def piece(self, page: Page) -> Piece:
        form = page.notation
        d, t, power = form.run("d"), form.run("t"), form.run(str(self.order))
        above = (d if self.order == 1 else form.power(d, power)) + form.symbol(self.sign)
        return Piece(form.fraction(above, d + (t if self.order == 1 else form.power(t, power))), FRACTION)


def rate(base: str, order: int = 1) -> Expr:
    return Rate(Symbol(base), order)


PHI, ETA, THETA, SIGMA, XI = (Var(sign, 0.0) for sign, _ in STATES.values())


class LoopFormulas:
    def __init__(self, found: LoopFound, book: Book):
        self.loop, self.book = found, book

    def var(self, key: str) -> Expr:
        return self.book[f"governor_{key}"].var()

    def _value(self, key: str, expression: Expr) -> Formula:
        return self.book[f"governor_{key}"].formula(expression)

    # ------------------------------------------------------------ equations in symbols

    def motion(self) -> list[Relation]:
        """The equations of large motions."""
        J, omega, s, z = symbol("J"), symbol("omega"), symbol("s"), symbol("z")
        held = symbol("A") * symbol("i") ** 2 * omega**2 - symbol("E") - symbol("k") * rate("z")
        machine = Relation(J * rate("omega"), symbol("M", "d") * s - symbol("M", "c"))
        governor = Relation(symbol("m", "red") * rate("z", 2), held)
        if self.loop.servo is None:
            limited = (
                (Number(1) - symbol("s", "min")) * z / symbol("h")
                if self.loop.plant.least
                else z / symbol("h")
            )
            return [machine, *self._moments(), governor, Relation(s, Number(1) - limited)]
        return [machine, *self._moments(), governor, *self._servo()]

    def _moments(self) -> list[Relation]:
        """By the speed, where they change with it."""
        above, plant = symbol("omega") - symbol("omega", "m"), self.loop.plant
        found = []
        if plant.slope:
            found.append(Relation(symbol("M", "d"), symbol("M", "m") - symbol("k", "d") * above))
        if plant.load_slope:
            found.append(Relation(symbol("M", "c"), symbol("M", "c,2") + symbol("k", "c") * above))
        return found

    def _servo(self) -> list[Relation]:
        assert self.loop.servo is not None
        h, z, x = symbol("h"), symbol("z"), symbol("x")
        neutral = z - symbol("z", "m")
        shift = neutral + x if self.loop.servo.beta else neutral
        piston = Relation(symbol("T", "s") * rate("s"), -(shift / h))
        let_go = x / symbol("T", "i")
        back = Relation(rate("x"), symbol("beta") * h * rate("s") - let_go)
        return [piston, back] if self.loop.servo.beta else [piston]

    def small(self) -> list[Relation]:
        """The equations of small motions, in relative deviations."""
        omega, h, m = symbol("omega"), symbol("h"), symbol("m", "red")
        lift = symbol("R") * omega / (m * h) * PHI - symbol("S") / m * ETA - symbol("k") / m * THETA
        rows = [
            Relation(rate("phi"), self._driven() - symbol("D") / symbol("J") * PHI),
            Relation(rate("eta"), THETA),
            Relation(rate("theta"), lift),
        ]
        return [*rows, *self._small_servo()]

    def _driven(self) -> Expr:
        """By what the supply speeds the machine up."""
        below = symbol("J") * symbol("omega")
        if self.loop.servo is not None:
            return symbol("M", "d") / below * SIGMA
        if not self.loop.plant.least:
            return -(symbol("M", "d") / below * ETA)
        return -(symbol("M", "d") * (Number(1) - symbol("s", "min")) / below * ETA)

    def _small_servo(self) -> list[Relation]:
        servo = self.loop.servo
        if servo is None:
            return []
        if not servo.beta:
            return [Relation(rate("sigma"), -(ETA / symbol("T", "s")))]
        shift = (ETA + XI) / symbol("T", "s")
        return [
            Relation(rate("sigma"), -shift),
            Relation(rate("xi"), -(symbol("beta") * shift) - XI / symbol("T", "i")),
        ]

    # ------------------------------------------------------------ coefficients

    def coefficients(self) -> list[Formula]:
        ratio, omega = self.var("i"), self.var("after_omega")
        own = self.var("k_d") * self.var("after_s")
        given = self.loop.plant
        regulation = own + self.var("k_c") if given.load_slope else own
        found = [self._value("D", regulation)] if given.slope else []
        return [*found, self._value("R", Number(2) * self.var("after_A") * omega * ratio**2)]

    # ------------------------------------------------------------ direct action

    def cubic(self) -> list[Formula]:
        J, D, m, k, S = (self.var(key) for key in ("J", "D", "after_m", "k", "after_S"))
        full = self.var("after_M_d")
        least = self.loop.plant.least
        moment = full * (Number(1) - self.var("s_min")) if least else full
        return [
            self._value("Q_s", moment / self.var("h")),
            self._value("a_0", J * m),
            self._value("a_1", J * k + D * m),
            self._value("a_2", J * S + D * k),
            self._value("a_3", D * S + self.var("Q_s") * self.var("R")),
        ]

    def characteristic(self) -> Relation:
        a, root = [symbol("a", str(k)) for k in range(4)], symbol("lambda")
        return Relation(a[0] * root**3 + a[1] * root**2 + a[2] * root + a[3], Number(0))

    def normal(self) -> Relation:
        q = symbol("q")
        return Relation(q**3 + symbol("X") * q**2 + symbol("Y") * q + Number(1), Number(0))

    def parameters(self) -> list[Formula]:
        """X, Y and their product."""
        a0, p = self.var("a_0"), self.var("p")
        return [
            self._value("X", self.var("a_1") / (a0 * p)),
            self._value("Y", self.var("a_2") / (a0 * p**2)),
            self._value("XY", self.var("X") * self.var("Y")),
        ]

    # ------------------------------------------------------------ throttle and response

    def throttle(self) -> list[Formula]:
        """What the insensitivity allows on the sleeve, against what is there."""
        epsilon, places = self.var("epsilon_allowed"), self.book.tables["governor_equilibrium"]
        least = min(range(len(places)), key=lambda row: float(places["E"].values[row]))
        held = places.var("E", least) * epsilon * sqrt(Number(1) - epsilon**2 / Number(4))
        return [
            self._value("F_allowed", held),
            self._value("F_sum", self.var("F_fr") + self.var("F_throttle")),
        ]

    def static(self) -> Formula:
        steady = self.book.tables["governor_steady"]
        before, after = steady.var("omega", 0), steady.var("omega", 1)
        return self._value("static", (after - before) / before)

    def temporary(self) -> Formula:
        return self._value("b_t", self.var("beta") * self.var("delta"))
