"""Drafting the force plans of a position on paper, in mm, with the calculations written beside them.

Loads are laid off in the order P0 → loads of b → P1 → loads of a → P2, then the reactions close the plan:
R_a from P2 to X, R_b from X to P0, and the inner reaction on a from X to P1. So one point X, where two lines cross,
solves any dyad; each line is a condition (see `_lines`): a moment equation, or a guide without friction.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 13; Frolov (ed.), Theory of mechanisms, ch. 5.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from tmm_report.chapters.kinetostatics import Kinetostatics, Solved, loaded_link
from tmm_report.chapters.plans import PAPER, Comparison
from tmm_report.chapters.scales import Pen, round_scale
from tmm_report.chapters.written import DIGITS, hand, load_keys, number, reaction_key, symbol_of
from tmm_report.formula import Expr, Formula, Number, Symbol, Term, VectorEquation
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.planar import cross, resolve, unit
from tmm_report.mechanics.statics import Reaction
from tmm_report.mechanics.structure import Pair
from tmm_report.quantity import round_significant

Kind = Literal["gravity", "inertia", "load", "reaction", "component"]


@dataclass(frozen=True)
class Acting:
    """A force on a link as it enters a plan: `key` of its symbol, complex N, world place of application, m."""

    key: str
    kind: Kind
    vector: complex
    at: complex


@dataclass(frozen=True)
class Couple:
    """A moment on a link, N m, + counter-clockwise."""

    key: str
    value: float


@dataclass(frozen=True)
class ForceStroke:
    """A vector of a force plan, mm of paper."""

    start: complex
    end: complex
    key: str
    kind: Kind


@dataclass(frozen=True)
class Arm:
    """The arm of a force about a joint, read off the scheme: mm of paper, and m."""

    key: str
    about: str
    millimetres: float
    metres: float


@dataclass(frozen=True, eq=False)
class ForcePlan:
    """The plan of one group, or of the driving link, at one position.

    `links`: those it is drawn for; `moments`: moment equations with their numbers; `equation`: the vector equation;
    `loads`, `couples`: what acts, by link; `inner`: formulas of the inner reaction; `scale`: N per mm.
    """

    label: str
    links: tuple[str, ...]
    scale: float
    loads: Mapping[str, tuple[Acting, ...]]
    couples: Mapping[str, tuple[Couple, ...]]
    arms: tuple[Arm, ...]
    moments: tuple[Formula, ...]
    equation: VectorEquation
    strokes: tuple[ForceStroke, ...]
    readings: tuple[Formula, ...]


@dataclass(frozen=True, eq=False)
class Reduced:
    """Inertia force and couple of a link reduced to one force: its arm h = M/F about the mass centre, m, and the
    swing centre K through which it acts, world place, m."""

    link: str
    force: float
    couple: float
    arm: float
    centre: complex


@dataclass(frozen=True, eq=False)
class ForceDrawn:
    """Force plans of one table position, the driving link's last, and the comparison of reactions and moment.

    `inertia`: formulas of the inertia forces and couples, F_I = m a_S and M_I = J ε.
    """

    position: int
    inertia: tuple[Formula, ...]
    plans: tuple[ForcePlan, ...]
    reduced: tuple[Reduced, ...]
    balancing: float  # signed, N m, + counter-clockwise
    comparison: tuple[Comparison, ...]


def draw(found: Kinetostatics, position: int, length_scale: float, force_scale: Any, pen: Pen) -> ForceDrawn:
    """Force plans of all groups, the farthest first, and of the driving link, at a table position.

    `length_scale`: m/mm of the scheme from which arms are read; `force_scale`: N/mm, one or by group, or None.
    """
    return _Draft(found, position, length_scale, force_scale, pen).drawn()


class _Draft:
    """The force plans of one position in the making."""

    def __init__(self, found: Kinetostatics, k: int, mu_l: float, scale: Any, pen: Pen):
        self.found, self.k, self.mu_l, self.scale, self.pen = found, k, mu_l, scale, pen
        self.solved: Solved = found.table
        self.motion = found.kinematics.cycle.motion(found.kinematics.turned[k : k + 1])
        self.mechanism = self.motion.linkage.mechanism
        self.acting: dict[str, list[Acting]] = {name: [] for name in self.mechanism.moving}
        self.couples: dict[str, list[Couple]] = {name: [] for name in self.mechanism.moving}
        self.inertia: list[Formula] = []
        self.reduced: list[Reduced] = []
        self.comparison: list[Comparison] = []
        self._collect()

    def drawn(self) -> ForceDrawn:
        plans = [self._group(d) for d in reversed(self.motion.linkage.dyads)]
        plan, moment = self._driving_link()
        return ForceDrawn(
            self.k, tuple(self.inertia), (*plans, plan), tuple(self.reduced), moment, tuple(self.comparison)
        )

    # ------------------------------------------------------------ what acts

    def _collect(self) -> None:
        """Loads as written: weights, inertia forces and couples, stated forces and moments."""
        load, given = self.solved.loading, self.found.given
        for link, weight in load.gravity.items():
            centre = str(self.mechanism.links[link].mass_centre)
            self._add(link, f"G_{link}", "gravity", weight[self.k], self._at(centre))
            size = self._product(f"F_I{link}", f"m_{link}", self.mechanism.links[link].mass, f"a_{centre}")
            self._add(link, f"F_I{link}", "inertia", load.inertia[link][self.k], self._at(centre), size)
        for link, couple in load.couples.items():
            size = self._product(f"M_I{link}", f"J_{link}", self.mechanism.links[link].inertia, f"e_{link}")
            self._couple(link, f"M_I{link}", couple[self.k], size)
            self._reduce(link)
        for stated, key, vector in zip(
            given.forces, load_keys([f.at for f in given.forces]), load.forces, strict=True
        ):
            self._add(loaded_link(self.motion, stated.at), key, "load", vector[self.k], self._at(stated.at))
        for number_, (on, couple) in enumerate(zip(given.moments, load.moments, strict=True), 1):
            key = f"M_{on.on}" if [m.on for m in given.moments].count(on.on) == 1 else f"M_{on.on},{number_}"
            self._couple(on.on, key, couple[self.k])

    def _at(self, point: str) -> complex:
        return complex(self.motion.place(point)[0])

    def _product(self, key: str, factor: str, of: float, rate: str) -> float:
        """An inertia force or couple by hand, from the analytical acceleration as written: F_I4 = m_4 a_S4."""
        link = key[3:]
        motion = self.motion
        value = motion.acceleration(rate[2:])[0] if rate[0] == "a" else motion.angular_acceleration(link)[0]
        written = float(round_significant(float(np.abs(value)), DIGITS))
        unit_of_rate = "m/s²" if rate[0] == "a" else "rad/s²"
        mass = number(symbol_of(factor), float(of), "kg" if rate[0] == "a" else "kg·m²")
        formula = hand(key, mass * number(symbol_of(rate), written, unit_of_rate), 0.0)
        self.inertia.append(formula)
        return formula.written

    def _add(
        self, link: str, key: str, kind: Kind, vector: complex, at: complex, size: float | None = None
    ) -> None:
        """`size`: the magnitude as already written; else the vector's own, rounded as one writes it."""
        if abs(vector) > 1e-9 * self._largest():
            written = float(round_significant(abs(vector), DIGITS)) if size is None else size
            self.acting[link].append(Acting(key, kind, complex(unit(vector) * written), at))

    def _couple(self, link: str, key: str, value: float, size: float | None = None) -> None:
        if abs(value) > 1e-9 * float(np.nanmax(self.solved.scale)):
            written = float(round_significant(abs(value), DIGITS)) if size is None else size
            self.couples[link].append(Couple(key, float(np.copysign(written, value))))

    def _largest(self) -> float:
        load = self.solved.loading
        rows = [*load.gravity.values(), *load.inertia.values(), *load.forces]
        return max((float(np.nanmax(np.abs(row))) for row in rows), default=1.0)

    def _reduce(self, link: str) -> None:
        force = next((a for a in self.acting[link] if a.kind == "inertia"), None)
        couple = next((c for c in self.couples[link] if c.key == f"M_I{link}"), None)
        if force is not None and couple is not None:
            # the force moved aside by h has the couple's moment about the mass centre
            shift = -1j * unit(force.vector) * couple.value / abs(force.vector)
            size = float(abs(force.vector))
            self.reduced.append(
                Reduced(link, size, couple.value, abs(couple.value) / size, complex(force.at - shift))
            )

    # ------------------------------------------------------------ moments

    def _arm(self, acting: Acting, joint: str, about: complex) -> tuple[Arm, float]:
        """Arm of a force about a joint as read off the scheme, and the sense of its moment."""
        moment = cross(acting.at - about, acting.vector)
        mm = self.pen.read(moment / abs(acting.vector) / self.mu_l)
        return Arm(acting.key, joint, mm, float(round_significant(mm * self.mu_l, DIGITS + 2))), float(
            np.sign(moment)
        )

    def _moment_sum(self, links: Sequence[str], joint: str, about: complex, arms: list[Arm]) -> Expr:
        """Sum of moments of all loads and couples of `links` about a joint, with the arms as read, N m."""
        total: Expr | None = None
        for link in links:
            for acting in self.acting[link]:
                arm, sense = self._arm(acting, joint, about)
                arms.append(arm)
                h = number(Symbol("h", acting.key.replace("_", "")), arm.metres, "m")
                total = _plus(total, number(symbol_of(acting.key), abs(acting.vector), "N") * h, sense)
            for couple in self.couples[link]:
                size = number(symbol_of(couple.key), abs(couple.value), "N·m")
                total = _plus(total, size, np.sign(couple.value))
        return total if total is not None else Number(0.0)

    # ------------------------------------------------------------ groups

    def _group(self, d: Dyad) -> ForcePlan:
        arms: list[Arm] = []
        moments: list[Formula] = []
        mu = self._scale(d)
        corners = self._laid_off(d, mu)
        lines, components = self._lines(d, corners, mu, arms, moments)
        (start1, along1), (start2, along2) = lines
        x, _ = resolve(start2 - start1, along1, -along2)
        X = self.pen.place(complex(start1 + x * along1))
        strokes = [*self._load_strokes(d, corners), *self._reaction_strokes(d, corners, X, components)]
        readings = self._readings(d, corners, X, mu)
        loads = {link: tuple(self.acting[link]) for link in (d.a, d.b)}
        couples = {link: tuple(self.couples[link]) for link in (d.a, d.b)}
        equation = self._equation(d, components)
        self._pass_on(d, corners, X, mu)
        label = d.group.label
        return ForcePlan(
            label,
            (d.a, d.b),
            mu,
            loads,
            couples,
            tuple(arms),
            tuple(moments),
            equation,
            tuple(strokes),
            tuple(readings),
        )

    def _scale(self, d: Dyad) -> float:
        keys = (f"{d.a}-{d.b}", f"{d.b}-{d.a}")
        if isinstance(self.scale, Mapping):
            stated = next((self.scale[key] for key in keys if key in self.scale), None)
        else:
            stated = self.scale
        if stated is not None:
            return float(stated)
        return round_scale(self._longest(d), PAPER)

    def _longest(self, d: Dyad) -> float:
        """The longest vector of a group's plan, N, to choose a scale by."""
        sizes = [abs(a.vector) for link in (d.a, d.b) for a in self.acting[link]]
        sizes += [abs(self._exact(pair)) for pair in (d.outer_a, d.outer_b)]
        return max(sizes, default=1.0)

    def _exact(self, pair: Pair) -> complex:
        """The analytical reaction, only to compare with and to choose a scale."""
        return complex(
            np.broadcast_to(self.solved.statics.reactions[pair.key].force, self.solved.motion.shape)[self.k]
        )

    def _laid_off(self, d: Dyad, mu: float) -> tuple[complex, complex, complex]:
        """P0, P1, P2: before the loads of b, between, and after the loads of a; mm."""
        P1 = sum((self.pen.place(a.vector / mu) for a in self.acting[d.b]), 0j)
        return 0j, P1, P1 + sum((self.pen.place(a.vector / mu) for a in self.acting[d.a]), 0j)

    def _lines(
        self,
        d: Dyad,
        corners: tuple[complex, complex, complex],
        mu: float,
        arms: list[Arm],
        moments: list[Formula],
    ) -> tuple[list[tuple[complex, complex]], dict[str, complex]]:
        """The two lines that cross in X, and the tangential components laid off on the way, mm by key."""
        P0, P1, P2 = corners
        s = self.motion.state
        A, B, C = (self._joint(pair) for pair in (d.outer_a, d.inner, d.outer_b))
        components: dict[str, complex] = {}
        lines = []

        def tangential(
            pair: Pair, link: str, links: Sequence[str], about: complex, joint: str, at: complex
        ) -> complex:
            """Component of an outer reaction across its arm, from the moments about a joint; mm."""
            total = self._moment_sum(links, joint, about, arms)
            size = number(
                Symbol("l", joint + pair.name), float(round_significant(abs(at - about), DIGITS + 2)), "m"
            )
            key = f"{reaction_key(pair.other(link), link)}_t"
            sum_of_moments = hand(f"SigmaM_{joint}", total, 0.0)
            moment = number(sum_of_moments.result, sum_of_moments.written, "N·m")
            formula = hand(key, -moment / size, 0.0)
            moments.extend((sum_of_moments, formula))
            components[key] = self.pen.place(1j * unit(at - about) * formula.written / mu)
            return components[key]

        def guide(pair: Pair) -> complex:
            """Direction of a reaction across a guide."""
            carrier = pair.other(str(pair.slider))
            return 1j * complex(np.ravel(s.u[carrier] * pair.along[carrier])[0])

        if d.kind in (1, 2):
            lines.append((P2 + tangential(d.outer_a, d.a, (d.a,), B, d.inner.name, A), unit(A - B)))
        elif d.kind == 3:
            lines.append((P2 + tangential(d.outer_a, d.a, (d.a, d.b), C, d.outer_b.name, A), unit(A - C)))
        else:
            lines.append((P2, guide(d.outer_a)) if d.kind == 4 else (P1, guide(d.inner)))
        if d.kind == 1:
            lines.append((P0 - tangential(d.outer_b, d.b, (d.b,), B, d.inner.name, C), unit(C - B)))
        elif d.kind == 3:
            lines.append((P1, guide(d.inner)))
        else:
            lines.append((P0, guide(d.outer_b)))
        return lines, components

    def _joint(self, pair: Pair) -> complex:
        link = pair.slider or pair.links[1]
        return complex(np.ravel(self.motion.state.world(link, pair.at[link]))[0])

    # ------------------------------------------------------------ drawing

    def _load_strokes(self, d: Dyad, corners: tuple[complex, complex, complex]) -> list[ForceStroke]:
        strokes, tip = [], corners[0]
        mu = self._scale(d)
        for acting in (*self.acting[d.b], *self.acting[d.a]):
            end = tip + self.pen.place(acting.vector / mu)
            strokes.append(ForceStroke(tip, end, acting.key, acting.kind))
            tip = end
        return strokes

    def _reaction_strokes(
        self,
        d: Dyad,
        corners: tuple[complex, complex, complex],
        X: complex,
        components: Mapping[str, complex],
    ) -> list[ForceStroke]:
        P0, P1, P2 = corners
        on_a, on_b, inner = self._keys(d)
        strokes = []
        if (part := components.get(f"{on_a}_t")) is not None:
            strokes += [
                ForceStroke(P2, P2 + part, f"{on_a}_t", "component"),
                ForceStroke(P2 + part, X, f"{on_a}_n", "component"),
            ]
        if (part := components.get(f"{on_b}_t")) is not None:
            strokes += [
                ForceStroke(X, P0 - part, f"{on_b}_n", "component"),
                ForceStroke(P0 - part, P0, f"{on_b}_t", "component"),
            ]
        return [
            *strokes,
            ForceStroke(P2, X, on_a, "reaction"),
            ForceStroke(X, P0, on_b, "reaction"),
            ForceStroke(X, P1, inner, "reaction"),
        ]

    def _keys(self, d: Dyad) -> tuple[str, str, str]:
        """Outer reactions on a and on b, and the inner one, of b on a."""
        return reaction_key(d.carrier_a, d.a), reaction_key(d.carrier_b, d.b), reaction_key(d.b, d.a)

    def _readings(
        self, d: Dyad, corners: tuple[complex, complex, complex], X: complex, mu: float
    ) -> list[Formula]:
        """Reactions read off the plan, compared with the analytical ones."""
        P0, P1, P2 = corners
        formulas = []
        scale = number(Symbol("mu", "F"), mu, "N/mm")
        vectors = (X - P2, P0 - X, P1 - X)
        for key, vector, pair in zip(self._keys(d), vectors, (d.outer_a, d.outer_b, d.inner), strict=True):
            segment = number(Symbol("L", key.replace("_", "")), self.pen.read(vector), "mm")
            formula = hand(key, segment * scale, 0.0)
            formulas.append(formula)
            floor = mu * self.pen.read_step
            self.comparison.append(Comparison(key, abs(formula.written), abs(self._exact(pair)), floor))
        return formulas

    def _pass_on(self, d: Dyad, corners: tuple[complex, complex, complex], X: complex, mu: float) -> None:
        """The solved group loads the links it hangs on with its outer reactions, turned round."""
        P0, _, P2 = corners
        for pair, link, vector in ((d.outer_a, d.a, X - P2), (d.outer_b, d.b, P0 - X)):
            carrier = pair.other(link)
            if carrier == FRAME or abs(vector) == 0:
                continue
            size = float(round_significant(self.pen.read(vector) * mu, DIGITS))
            at = self._joint(pair) + self._offset(pair)
            force = Acting(reaction_key(link, carrier), "reaction", complex(-unit(vector) * size), at)
            self.acting[carrier].append(force)

    def _offset(self, pair: Pair) -> complex:
        """Where along a moving guide the reaction acts: from the moments of the sliding link, as the solver has it."""
        if pair.kind == "R":
            return 0j
        reaction: Reaction = self.solved.statics.reactions[pair.key]
        full = replace(reaction, moment=np.broadcast_to(reaction.moment, self.solved.motion.shape))
        offset = float(np.broadcast_to(full.offset, self.solved.motion.shape)[self.k])
        carrier = pair.other(str(pair.slider))
        t = complex(np.ravel(self.motion.state.u[carrier] * pair.along[carrier])[0])
        return t * offset if np.isfinite(offset) else 0j

    def _equation(self, d: Dyad, components: Mapping[str, complex]) -> VectorEquation:
        """Sum of all forces of the group; in an RPP and RPR group the inner reaction has its own known direction."""
        on_a, on_b, _ = self._keys(d)

        def reaction(key: str) -> list[Term]:
            if f"{key}_t" in components:
                return [Term(symbol_of(f"{key}_n"), 1), Term(symbol_of(f"{key}_t"), 2)]
            pair = d.outer_a if key == on_a else d.outer_b
            return [Term(symbol_of(key), 1 if pair.kind == "P" else 0)]

        loads = [Term(symbol_of(a.key), 2) for link in (d.a, d.b) for a in self.acting[link]]
        return VectorEquation([[*reaction(on_a), *loads, *reversed(reaction(on_b))], []])

    # ------------------------------------------------------------ driving link

    def _driving_link(self) -> tuple[ForcePlan, float]:
        """The driving link: balancing moment from the moments about its pivot, reaction of the frame from the plan."""
        link, pair = self.mechanism.driver.link, self.motion.linkage.structure.driver_pair
        arms: list[Arm] = []
        O = self._joint(pair)
        formula = hand("M_bal", -self._moment_sum((link,), pair.name, O, arms), 0.0)
        sizes = [abs(a.vector) for a in self.acting[link]]
        mu = (
            float(self.scale)
            if isinstance(self.scale, int | float)
            else round_scale(max([*sizes, abs(self._exact(pair))]), PAPER)
        )
        key, tip, strokes = reaction_key(FRAME, link), 0j, []
        for acting in self.acting[link]:
            end = tip + self.pen.place(acting.vector / mu)
            strokes.append(ForceStroke(tip, end, acting.key, acting.kind))
            tip = end
        strokes.append(ForceStroke(tip, 0j, key, "reaction"))
        segment = number(Symbol("L", key.replace("_", "")), self.pen.read(tip), "mm")
        reading = hand(key, segment * number(Symbol("mu", "F"), mu, "N/mm"), 0.0)
        step = self.pen.read_step
        self.comparison.append(Comparison(key, abs(reading.written), abs(self._exact(pair)), mu * step))
        exact = float(self.solved.balancing[self.k])
        largest = max(sizes, default=0.0)
        self.comparison.append(
            Comparison("M_bal", abs(formula.written), abs(exact), largest * self.mu_l * step)
        )
        terms = [Term(symbol_of(a.key), 2) for a in self.acting[link]]
        equation = VectorEquation([[*terms, Term(symbol_of(key), 0)], []])
        loads, couples = {link: tuple(self.acting[link])}, {link: tuple(self.couples[link])}
        label = f"I(0,{link})"
        plan = ForcePlan(
            label, (link,), mu, loads, couples, tuple(arms), (formula,), equation, tuple(strokes), (reading,)
        )
        return plan, float(formula.written)


def _plus(total: Expr | None, term: Expr, sense: float) -> Expr:
    if total is None:
        return term if sense >= 0 else -term
    return total + term if sense >= 0 else total - term
