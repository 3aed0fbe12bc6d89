"""What a force plan is drafted from: the loads as written, their moments, and the reactions read so far."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.force_plans.drafting.plan import Acting, Arm, Couple, ForceStroke, Kind, Reduced
from tmm_report.chapters.kinetostatics.solve import Kinetostatics, Solved, loaded_link
from tmm_report.chapters.plans.solve import PAPER, Comparison
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.planar import cross, unit
from tmm_report.mechanics.statics import Reaction
from tmm_report.mechanics.structure import Group, Pair
from tmm_report.quantity.formula import Expr, Formula, Number, Symbol, Term
from tmm_report.quantity.paper import Pen, round_scale
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, hand, load_keys, number, reaction_key, symbol_of


class Sheet:
    """The force plans of one position in the making. `acting`, `couples`: what loads each link, by link."""

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
        if abs(vector) > 1e-9 * self._largest:
            written = float(round_significant(abs(vector), DIGITS)) if size is None else size
            self.acting[link].append(Acting(key, kind, complex(unit(vector) * written), at))

    def _couple(self, link: str, key: str, value: float, size: float | None = None) -> None:
        if abs(value) > 1e-9 * self._largest_moment:
            written = float(round_significant(abs(value), DIGITS)) if size is None else size
            self.couples[link].append(Couple(key, float(np.copysign(written, value))))

    @cached_property
    def _largest(self) -> float:
        """The largest load over the cycle, N, beside which a force is more than rounding."""
        load = self.solved.loading
        rows = [*load.gravity.values(), *load.inertia.values(), *load.forces]
        return max((float(np.nanmax(np.abs(row))) for row in rows), default=1.0)

    @cached_property
    def _largest_moment(self) -> float:
        return float(np.nanmax(self.solved.scale))

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

    def arm(self, acting: Acting, joint: str, about: complex) -> tuple[Arm, float]:
        """Arm of a force about a joint as read off the scheme, and the sense of its moment."""
        moment = cross(acting.at - about, acting.vector)
        mm = self.pen.read(moment / abs(acting.vector) / self.mu_l)
        return Arm(acting.key, joint, mm, float(round_significant(mm * self.mu_l, DIGITS + 2))), float(
            np.sign(moment)
        )

    def moment_sum(self, links: Sequence[str], joint: str, about: complex, arms: list[Arm]) -> Expr:
        """Sum of moments of all loads and couples of `links` about a joint, with the arms as read, N m."""
        total: Expr | None = None
        for link in links:
            for acting in self.acting[link]:
                arm, sense = self.arm(acting, joint, about)
                arms.append(arm)
                h = number(Symbol("h", acting.key.replace("_", "")), arm.metres, "m")
                total = plus(total, number(symbol_of(acting.key), abs(acting.vector), "N") * h, sense)
            for couple in self.couples[link]:
                size = number(symbol_of(couple.key), abs(couple.value), "N·m")
                total = plus(total, size, np.sign(couple.value))
        return total if total is not None else Number(0.0)

    # ------------------------------------------------------------ scale, loads laid off

    def scale_of(self, group: Group) -> float:
        """N per mm of a group's plan: as stated, or a round one that keeps its longest vector on the paper."""
        stated = self.scale
        if isinstance(stated, Mapping):
            stated = next((s for key, s in stated.items() if set(key.split("-")) == set(group.links)), None)
        return float(stated) if stated is not None else round_scale(self._longest(group), PAPER)

    def _longest(self, group: Group) -> float:
        """The longest vector of a group's plan, N, to choose a scale by."""
        sizes = [abs(a.vector) for link in group.links for a in self.acting[link]]
        pairs = group.outer if group.kind is not None else (*group.outer, *group.inner)
        sizes += [abs(self.exact(pair)) for pair in pairs]
        return max(sizes, default=1.0)

    def exact(self, pair: Pair) -> complex:
        """The analytical reaction, only to compare with and to choose a scale."""
        return complex(
            np.broadcast_to(self.solved.statics.reactions[pair.key].force, self.solved.motion.shape)[self.k]
        )

    def laid_off(self, link: str, tip: complex, mu: float) -> tuple[list[ForceStroke], complex]:
        """The loads of a link laid off from `tip`, mm, and where they end."""
        strokes = []
        for acting in self.acting[link]:
            end = tip + self.pen.place(acting.vector / mu)
            strokes.append(ForceStroke(tip, end, acting.key, acting.kind))
            tip = end
        return strokes, tip

    def terms(self, link: str) -> list[Term]:
        """The loads of a link in a vector equation."""
        return [Term(symbol_of(a.key), 2) for a in self.acting[link]]

    # ------------------------------------------------------------ reactions

    def read(self, key: str, vector: complex, pair: Pair, mu: float) -> Formula:
        """A reaction read off the plan, compared with the analytical one."""
        segment = number(Symbol("L", key.replace("_", "")), self.pen.read(vector), "mm")
        formula = hand(key, segment * number(Symbol("mu", "F"), mu, "N/mm"), 0.0)
        floor = mu * self.pen.read_step
        self.comparison.append(Comparison(key, abs(formula.written), abs(self.exact(pair)), floor))
        return formula

    def pass_on(self, pair: Pair, link: str, vector: complex, mu: float) -> None:
        """A solved group loads the link it hangs on with an outer reaction on its `link`, mm, turned round."""
        carrier = pair.other(link)
        if carrier == FRAME or abs(vector) == 0:
            return
        size = float(round_significant(self.pen.read(vector) * mu, DIGITS))
        at = self.joint(pair) + self._offset(pair)
        force = Acting(reaction_key(link, carrier), "reaction", complex(-unit(vector) * size), at)
        self.acting[carrier].append(force)

    def joint(self, pair: Pair) -> complex:
        link = pair.slider or pair.links[1]
        return complex(np.ravel(self.motion.state.world(link, pair.at[link]))[0])

    def guide(self, pair: Pair) -> complex:
        """World direction of a guide."""
        carrier = pair.other(pair.slider)
        return complex(np.ravel(self.motion.state.u[carrier] * pair.along[carrier])[0])

    def _offset(self, pair: Pair) -> complex:
        """Where along a moving guide the reaction acts: from the moments of the sliding link, as the solver has it."""
        if pair.kind == "R":
            return 0j
        reaction: Reaction = self.solved.statics.reactions[pair.key]
        full = replace(reaction, moment=np.broadcast_to(reaction.moment, self.solved.motion.shape))
        offset = float(np.broadcast_to(full.offset, self.solved.motion.shape)[self.k])
        return self.guide(pair) * offset if np.isfinite(offset) else 0j


def plus(total: Expr | None, term: Expr, sense: float) -> Expr:
    """The next term of a sum, with its sign."""
    if total is None:
        return term if sense >= 0 else -term
    return total + term if sense >= 0 else total - term
