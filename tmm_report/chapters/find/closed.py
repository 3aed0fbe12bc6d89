"""The textbook's way: formulas by which an unknown follows from a demanded number, beside the root found by trials.

A formula is taken where its numbers stand in the results and do not themselves depend on the unknown: seen at two
values of it. Sources: Artobolevsky, Theory of mechanisms and machines, ch. 19 (flywheel), 20 (governor).
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from tmm_report.chapters.find.asking import Sample
from tmm_report.chapters.find.given import Given, Kind, Unknown
from tmm_report.chapters.find.letters import sought
from tmm_report.chapters.find.target import Chapter, Target
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import PI, Expr, Var, sqrt
from tmm_report.quantity.model import Book, Quantity, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.records import dataclass

WANTED = NP_("index", "want")
CLOSED = NP_("index", "form")  # by a formula
STEADY = 1e-9  # relative: by more a number depends on the unknown


class NotThereError(Exception):
    """A number of a formula is not in the results, or depends on the unknown."""


@dataclass(frozen=True)
class Known:
    """What a formula may take. `wanted`: the demanded number as it is wanted."""

    target: Target
    books: tuple[Book, Book]
    wanted: Var

    def of(self, key: str) -> Var:
        """A single number of the results."""
        return self._steady([book.values.get(key) for book in self.books])

    def any(self, key: str) -> Var | None:
        """The same; None where the results have none, or nought."""
        there = [book.values.get(key) for book in self.books]
        return None if None in there or not there[0].value else self._steady(there)  # type: ignore[union-attr]

    def beside(self, key: str) -> Var:
        """A number of the row of the demanded one."""
        table, _, _ = self.target.key.partition(".")
        return self._row(table, key, [int(self.target.pick)] * 2)

    def beside_any(self, key: str) -> Var | None:
        """The same; None where the row has none."""
        table, _, _ = self.target.key.partition(".")
        known = self.books[0].tables[table]
        return self.beside(key) if key in known and np.isfinite(known[key].numbers()).any() else None

    def least(self, table: str, key: str) -> Var:
        """The least number of a column."""
        columns = [self._column(book, table, key) for book in self.books]
        return self._row(table, key, [int(np.nanargmin(column)) for column in columns])

    def row(self, table: str, key: str, row: int) -> Var:
        """`row`: −1 the last."""
        row %= max(1, len(self.rows(table)))
        return self._row(table, key, [row, row])

    def moves(self, table: str, key: str, with_: str) -> list[int]:
        """The rows of a column whose numbers go with a single number, which depends on the unknown."""
        singles = [book.values.get(with_) for book in self.books]
        columns = [self._column(book, table, key) for book in self.books]
        return [
            row
            for row in range(len(columns[0]))
            if all(one and one.value == column[row] for one, column in zip(singles, columns, strict=True))
        ]

    def rows(self, table: str) -> range:
        return range(len(self.books[0].tables.get(table, ())))

    def _row(self, table: str, key: str, rows: Sequence[int]) -> Var:
        numbers = [self._column(book, table, key)[row] for book, row in zip(self.books, rows, strict=True)]
        if not _alike(*numbers) or rows[0] != rows[1]:
            raise NotThereError(key)
        return self.books[0].tables[table].var(key, rows[0])

    def _column(self, book: Book, table: str, key: str) -> np.ndarray:
        if table not in book.tables or key not in book.tables[table]:
            raise NotThereError(key)
        return book.tables[table][key].numbers()

    def _steady(self, there: Sequence[Value | None]) -> Var:
        first, second = there
        if first is None or second is None or not _alike(first.value, second.value):
            raise NotThereError
        return first.var()


def _alike(first: float, second: float) -> bool:
    return math.isclose(first, second, rel_tol=STEADY)


@dataclass(frozen=True)
class Inversion:
    """`unknown`, `demand`: their names, * for any part; `kind`: of the demand; `form`: the unknown, SI; `leaves`: what
    the formula leaves out, "" where it is exact."""

    unknown: str
    demand: str
    form: Callable[[Known], Expr]
    kind: Kind = "equal"
    leaves: str = ""

    def fits(self, given: Given, of: Target) -> bool:
        path = ".".join(map(str, given.unknown.path))
        key = f"{of.key}.{of.pick}" if of.pick else of.key
        level = given.demand.best or "equal"
        return level == self.kind and _like(self.unknown, path) and _like(self.demand, key)


def _like(pattern: str, name: str) -> bool:
    return re.fullmatch(re.escape(pattern).replace(r"\*", "[^.]+"), name) is not None


@dataclass(frozen=True, eq=False)
class Closed:
    """What a formula gives, SI, and what it leaves out."""

    form: Expr
    leaves: str

    @property
    def number(self) -> float:
        return float(self.form.value)


def wanted_value(of: Target, level: float, last: str = "") -> Value:
    """The demanded number as it is wanted; `last`: with which its key ends."""
    symbol = of.quantity.symbol or Symbol("y")
    symbol = replace(symbol, sub=",".join(filter(None, (symbol.sub, WANTED))))
    meaning = Message(N_("%(of)s, as it is wanted"), {"of": of.quantity.meaning})
    return Quantity(f"find_wanted{last}", symbol, of.quantity.unit, meaning, of.quantity.shown).value(level)


def closed_value(
    of: Unknown, letter: Quantity | None, number: float, last: str = "", which: str = ""
) -> Value:
    """The unknown as a formula gives it; `last`, `which`: with which its key and its index x end."""
    text = N_("unknown number %(name)s by the formula")
    return sought(of, letter, f"find_closed{last}", text, CLOSED, which).value(number)


def closed(given: Given, of: Target, wanted: float, samples: Sequence[Sample]) -> Closed | None:
    """By the first formula that fits; None where there is none."""
    if len(samples) < 2:
        return None
    known = Known(of, _books(samples), wanted_value(of, wanted).var())
    for one in INVERSIONS:
        if one.fits(given, of):
            try:
                found = Closed(one.form(known), one.leaves)
            except NotThereError:
                continue
            if math.isfinite(found.number):
                return found
    return None


def closed_pair(
    given: Given,
    targets: Sequence[Target],
    levels: Sequence[float],
    letters: Sequence[Quantity | None],
    samples: Sequence[Sample],
) -> tuple[tuple[int, Closed], ...]:
    """Of two unknowns: which of them, and its formula, in the order in which they are worked out; none where there is
    no such pair of formulas."""
    if len(samples) < 2:
        return ()
    known = Known(targets[0], _books(samples), Var("y", 0.0))
    paths, keys = [".".join(map(str, one.path)) for one in given.unknowns], [one.key for one in targets]
    for one in PAIRS:
        if sorted(paths) != sorted(one.unknowns) or sorted(keys) != sorted(one.demands):
            continue
        places = [paths.index(name) for name in one.unknowns]
        wanted = [keys.index(key) for key in one.demands]
        first, second = (wanted_value(targets[k], levels[k], "2" if k else "").var() for k in wanted)
        try:
            found = Closed(one.first(known, first, second), "")
            k = places[0]
            value = closed_value(given.unknowns[k], letters[k], found.number, "2" if k else "", str(k + 1))
            other = Closed(one.second(known, first, second, value.var()), "")
        except NotThereError:
            continue
        return (k, found), (places[1], other)
    return ()


def _books(samples: Sequence[Sample]) -> tuple[Book, Book]:
    first, second = (_book(chapters) for _, chapters in samples)
    return first, second


def _book(chapters: Sequence[Chapter]) -> Book:
    return Book.of(
        [table for _, tables, _ in chapters for table in tables],
        [value for _, _, values in chapters for value in values],
    )


# --- the formulas


def _own(k: Known) -> list[Var]:
    """Moments of inertia of the machine without its flywheel."""
    return [one for key in ("flywheel_J_own", "flywheel_J_mean") if (one := k.any(key))]


def _less_own(k: Known, all_of_it: Expr) -> Expr:
    for one in _own(k):
        all_of_it = all_of_it - one
    return all_of_it


def _of_rim(k: Known) -> Expr:
    """J of a rim of the wanted mean diameter, on the main link."""
    h, b, rho = k.of("flywheel_k_h"), k.of("flywheel_k_b"), k.of("flywheel_rho")
    spokes = k.any("flywheel_k_s")
    own = _on_main(k, PI * rho * b * h**2 * (1 + h**2) * k.wanted**5)
    return own / (4 * (1 - spokes)) if spokes else own / 4


def _of_disc(k: Known) -> Expr:
    return _on_main(k, PI * k.of("flywheel_rho") * k.of("flywheel_k_b") * k.wanted**5) / 32


def _on_main(k: Known, inertia: Expr) -> Expr:
    ratio = k.of("flywheel_i")
    return inertia if ratio.number == 1 else inertia * ratio**2


def _delta(k: Known, wheel: Expr) -> Expr:
    return k.of("flywheel_A_ex") / (sum(_own(k), wheel) * k.of("flywheel_omega_m") ** 2)


def _moment(k: Known) -> Expr:
    """M = J ε + M_res at rest, through the gear of the motor."""
    taken = k.of("dynamics_J") * k.wanted + _resisting(k)
    geared = k.any("dynamics_i_motor")
    return taken / (geared * k.of("dynamics_eta_motor")) if geared else taken


def _resisting(k: Known) -> Var:
    """Of a start-up its first moment, of constant moments without a regime the only one."""
    return k.beside("M_res") if k.target.pick else k.of("dynamics_M_res")


def _best_ratio(k: Known) -> Expr:
    """dε/du = 0 of ε = (u η M − M_res)/(J + J_m u²), where the motor's rotor is the only part on its shaft."""
    rotor = k.moves("dynamics_parts", "i", "dynamics_i_motor")
    others = [row for row in k.rows("dynamics_parts") if row not in rotor]
    load = [k.row("dynamics_parts", "J_red", row) for row in others]
    if len(rotor) != 1 or not load:
        raise NotThereError
    square = sum(load[1:], load[0]) / k.row("dynamics_parts", "J", rotor[0])
    resisting = _resisting(k)
    if not resisting.number:
        return sqrt(square)
    part = resisting / (k.of("dynamics_eta_motor") * k.of("dynamics_M_motor"))
    return part + sqrt(part**2 + square)


def _friction(k: Known) -> Expr:
    return k.least("governor_equilibrium", "E") * k.wanted * sqrt(1 - k.wanted**2 / 4)


def _pressed_on(k: Known, by: Expr) -> Expr:
    """The load by a pressure times a length; of collars, which share it, of one."""
    return k.beside("Q") / _all_collars(k, by)


def _all_collars(k: Known, of_one: Expr) -> Expr:
    collars = k.beside_any("n_collars")
    return collars * of_one if collars else of_one


def _outer(k: Known) -> Expr:
    if ratio := k.beside_any("k"):
        return sqrt(_pressed_on(k, PI * k.wanted * (1 - ratio**2)))
    disc = _pressed_on(k, PI * k.wanted)
    inner = k.beside("r_inner")
    return sqrt(disc + inner**2) if inner.number else sqrt(disc)


def _inner(k: Known) -> Expr:
    return sqrt(k.beside("R_outer") ** 2 - _pressed_on(k, PI * k.wanted))


def _outer_worn(k: Known) -> Expr:
    """p_max = Q/(2π r (R − r)) of a run-in pivot."""
    if ratio := k.beside_any("k"):
        return sqrt(_pressed_on(k, 2 * PI * k.wanted * ratio * (1 - ratio)))
    inner = k.beside("r_inner")
    return inner + _pressed_on(k, 2 * PI * k.wanted * inner)


def _load_worn(k: Known) -> Expr:
    outer, inner = k.beside("R_outer"), k.beside("r_inner")
    return _all_collars(k, 2 * PI * k.wanted * inner * (outer - inner))


def _load(k: Known) -> Expr:
    outer, inner = k.beside("R_outer"), k.beside("r_inner")
    return _all_collars(k, PI * k.wanted * (outer**2 - inner**2 if inner.number else outer**2))


AT_ONCE = ("dynamics_start.epsilon.0", "dynamics_epsilon")  # the acceleration at rest; without a regime
MEAN = N_("the varying part of the moment of inertia is taken as its mean")
INVERSIONS = (
    Inversion("flywheel.delta", "flywheel_J_fl", lambda k: _delta(k, k.wanted), leaves=MEAN),
    Inversion("flywheel.delta", "flywheel_D", lambda k: _delta(k, _of_rim(k)), leaves=MEAN),
    Inversion("flywheel.delta", "flywheel_D", lambda k: _delta(k, _of_disc(k)), leaves=MEAN),
    Inversion(
        "flywheel.wheel.inertia",
        "flywheel_delta",
        lambda k: _less_own(k, k.of("flywheel_A_ex") / (k.wanted * k.of("flywheel_omega_m") ** 2)),
        leaves=MEAN,
    ),
    *(Inversion("dynamics.motor.constant", key, _moment) for key in AT_ONCE),
    *(Inversion("dynamics.motor.ratio", key, _best_ratio, "greatest") for key in AT_ONCE),
    Inversion("governor.sleeve.friction", "governor_equilibrium.epsilon.max", _friction),
    Inversion("contacts.*.outer", "contacts_*.p_mean.*", _outer),
    Inversion("contacts.*.inner", "contacts_*.p_mean.*", _inner),
    Inversion("contacts.*.load", "contacts_*.p_mean.*", _load),
    Inversion("contacts.*.outer", "contacts_*.p_max.*", _outer_worn),
    Inversion("contacts.*.load", "contacts_*.p_max.*", _load_worn),
    Inversion("engine.counterweights.share", "engine_hammer", lambda k: k.wanted / k.of("engine_unit")),
    Inversion(
        "engine.speed",
        "engine_hammer",
        lambda k: sqrt(k.wanted / (k.of("engine_share") * k.of("engine_m") * k.of("engine_r"))),
    ),
)


# --- pairs


@dataclass(frozen=True)
class Twofold:
    """Two unknowns of two demands. `first`: the first of them by what is known and both wanted numbers; `second`: the
    other one by the first besides."""

    unknowns: tuple[str, str]
    demands: tuple[str, str]
    first: Callable[[Known, Var, Var], Expr]
    second: Callable[[Known, Var, Var, Var], Expr]


def _pressed(k: Known, row: int, speed: Var) -> Expr:
    """What the spring of a governor presses with at a stop: A ω² − g (m₀ + n m y')."""
    index, text = STOPS[row]
    size, slope = (
        replace(one, symbol=replace(one.sign, sub=index), meaning=Message(text, {"of": one.meaning}))
        for one in (k.row("governor_equilibrium", key, row) for key in ("A", "dy"))
    )
    heavy: Expr = k.of("governor_m_0")
    if slope.number:
        heavy = heavy + k.of("governor_n") * k.of("governor_m") * slope
    return size * speed**2 - k.of("governor_g") * heavy


STOPS = {0: ("0", N_("%(of)s, at the lower stop")), -1: ("h", N_("%(of)s, at the upper stop"))}
PAIRS = (
    Twofold(
        ("governor.spring.force", "governor.spring.stiffness"),
        ("governor_omega_0", "governor_omega_h"),
        lambda k, low, high: _pressed(k, 0, low),
        lambda k, low, high, force: (_pressed(k, -1, high) - force) / k.of("governor_h"),
    ),
)
