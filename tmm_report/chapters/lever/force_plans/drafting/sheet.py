"""What a force plan is drafted from: the loads as written, their moments, and the reactions read so far."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from tmm_report.chapters.lever.force_plans.drafting.plan import (
    Acting,
    Arm,
    Couple,
    ForceStroke,
    Kind,
    Pole,
    Reduced,
)
from tmm_report.chapters.lever.force_plans.quantities import (
    CHOSEN,
    MU_F,
    MU_L,
    drawn_length,
    on_paper,
    percussion_letter,
)
from tmm_report.chapters.lever.force_plans.quantities import arm as arm_of
from tmm_report.chapters.lever.initial_data.quantities import inertia, mass, segment_between
from tmm_report.chapters.lever.kinematics.quantities import link_rate, point_rate
from tmm_report.chapters.lever.kinetostatics.quantities.positions import (
    forces,
    inertia_couple,
    inertia_force,
    moments,
    reaction,
)
from tmm_report.chapters.lever.kinetostatics.quantities.positions import weight as weight_of
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved, loaded_link
from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.chapters.lever.plans.solve import Comparison
from tmm_report.mechanics.calculus.vectors import cross, unit
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.cams.replacing_dyad import in_position
from tmm_report.mechanics.lever.forces.reactions import Reaction
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.quantity.formula import Expr, Formula, Number, Term, Var
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.paper import LONGEST, Pen, fitting_scale, legible, round_scale
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, Worked

HAND = 0.1  # mm: to this accuracy or worse, lengths stand in equations as they are read
SCALE: tuple[str, ...] = ("drawing", "scales", "force")  # its key
REACH = 80.0  # mm: a centre of percussion farther from the mass centre is off the sheet


class Sheet:
    """The force plans of one position in the making. `acting`, `couples`: what loads each link, by link."""

    def __init__(self, found: Kinetostatics, k: int, mu_l: float, drawing: Drawing):
        self.found, self.k, self.mu_l, self.pen = found, k, mu_l, Pen(drawing.accuracy)
        self.scale, self.segment = drawing.force, drawing.force_segment
        self.solved: Solved = found.table
        self.motion = in_position(found.kinematics.cycle.motion(found.kinematics.turned[k : k + 1]))
        self.mechanism = self.motion.linkage.mechanism
        self.acting: dict[str, list[Acting]] = {name: [] for name in self.mechanism.moving}
        self.couples: dict[str, list[Couple]] = {name: [] for name in self.mechanism.moving}
        self.worked = [Worked(f"inertia_{k}", k)]
        self.inertia: list[Formula] = []
        self.reduced: list[Reduced] = []
        self.apart: list[str] = []
        self.comparison: list[Comparison] = []
        self._collect()
        self.loads = [(link, force) for link, own in self.acting.items() for force in own]
        self.turning = [(link, couple) for link, own in self.couples.items() for couple in own]
        for link in list(self.solved.loading.couples):
            self._reduce(link)

    def begin(self) -> None:
        """The next plan has numbers of its own."""
        self.worked.append(Worked(f"force_plan_{self.k}_{len(self.worked)}", self.k))
        self.chosen: Formula | None = None  # its scale, where it follows from a segment

    def number(self, quantity: Quantity, value: float) -> Var:
        """A number of the calculation at hand."""
        return self.worked[-1].number(quantity, value)

    def hand(self, quantity: Quantity, expression: Expr) -> Formula:
        return self.worked[-1].hand(quantity, expression)

    # ------------------------------------------------------------ what acts

    def _collect(self) -> None:
        """Loads as written: weights, inertia forces and couples, stated forces and moments."""
        load, given = self.solved.loading, self.found.given
        for link, weight in load.gravity.items():
            centre = str(self.mechanism.links[link].mass_centre)
            self._add(link, weight_of(link), "gravity", weight[self.k], centre)
            acceleration = point_rate("a", centre), float(np.abs(self.motion.acceleration(centre)[0]))
            m = mass(link), self.mechanism.links[link].mass
            size = self._product(inertia_force(link), m, acceleration)
            self._add(link, inertia_force(link), "inertia", load.inertia[link][self.k], centre, size)
        for link, couple in load.couples.items():
            turning = link_rate("e", link), float(self.motion.angular_acceleration(link)[0])
            J = inertia(link), self.mechanism.links[link].inertia
            written = self._product(inertia_couple(link), J, turning, -1)
            self._couple(link, inertia_couple(link), couple[self.k], written)
        for stated, force, vector in zip(given.forces, forces(given.forces), load.forces, strict=True):
            self._add(loaded_link(self.motion, stated), force, "load", vector[self.k], stated.at)
        for on, moment, couple in zip(given.moments, moments(given.moments), load.moments, strict=True):
            self._couple(on.on, moment, couple[self.k])

    def _at(self, point: str) -> complex:
        return complex(self.motion.place(point)[0])

    def _product(
        self, quantity: Quantity, factor: tuple[Quantity, float], rate: tuple[Quantity, float], sense: int = 1
    ) -> float:
        """An inertia force or couple by hand, from the analytical acceleration as written: F_I4 = m_4 a_S4 by size,
        M_I4 = −J_4 ε_4 with its sign."""
        (of, size), (rate_of, value) = factor, rate
        written = float(round_significant(value, DIGITS))
        product = self.number(of, float(round_significant(size, DIGITS))) * self.number(rate_of, written)
        formula = self.hand(quantity, product if sense > 0 else -product)
        self.inertia.append(formula)
        return formula.written

    def _add(
        self, link: str, of: Quantity, kind: Kind, vector: complex, point: str, size: float | None = None
    ) -> None:
        """`size`: the magnitude as already written; else the vector's own, rounded as one writes it."""
        if abs(vector) > 1e-9 * self._largest:
            written = float(round_significant(abs(vector), DIGITS)) if size is None else size
            force = Acting(of, kind, complex(unit(vector) * written), self._at(point), point)
            self.acting[link].append(force)

    def _couple(self, link: str, of: Quantity, value: float, written: float | None = None) -> None:
        """`written`: with its sign as already written; else the value's own size, rounded as one writes it."""
        if abs(value) > 1e-9 * self._largest_moment:
            printed = float(round_significant(abs(value), DIGITS)) if written is None else written
            self.couples[link].append(Couple(of, float(np.copysign(printed, value)), printed))

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
        """The inertia force and couple as one force through the centre of percussion, where that lies on the sheet."""
        force = next((a for a in self.acting[link] if a.kind == "inertia"), None)
        couple = next((c for c in self.couples[link] if c.key == inertia_couple(link).key), None)
        if force is None or couple is None:
            return
        # the force moved aside by h has the couple's moment about the mass centre
        size = float(abs(force.vector))
        arm = abs(couple.value) / size
        if arm > REACH * self.mu_l:
            self.apart.append(link)
            return
        shift = -1j * unit(force.vector) * couple.value / size
        letter = percussion_letter(self.mechanism)
        moved = replace(force, at=complex(force.at + shift), point=f"{letter}{link}")
        self.reduced.append(Reduced(link, letter, size, couple.value, arm, moved.at))
        self.acting[link][self.acting[link].index(force)] = moved
        self.couples[link].remove(couple)

    # ------------------------------------------------------------ moments

    @property
    def in_mm(self) -> bool:
        """Whether arms stand in the equations of moments in mm of paper, as a person with a pencil has them."""
        return self.pen.read_step >= HAND

    def arm(self, acting: Acting, joint: str, about: complex, link: str) -> tuple[Arm, float]:
        """Arm of a force about a joint as read off the scheme, and the sense of its moment."""
        moment = cross(acting.at - about, acting.vector)
        size = abs(acting.vector)
        mm = self.pen.read(moment / size / self.mu_l) if size else 0.0
        metres = float(round_significant(mm * self.mu_l, DIGITS + 2))
        of = arm_of(acting.quantity, joint, self.in_mm)
        along = complex(unit(acting.vector)) if size else 1 + 0j  # one that is nil as read has no line
        arm = Arm(acting.quantity, joint, mm, metres, of, link, about, acting.at, along)
        return arm, float(np.sign(moment))

    def length(self, one: str, other: str, metres: float) -> Var:
        """A length of the scheme as it stands in an equation of moments: m, as printed, or mm of paper as read."""
        of = segment_between(self.mechanism, one, other)
        if not self.in_mm:
            return self.number(of, float(round_significant(metres, DIGITS)))
        return self.number(on_paper(of), self.pen.read(metres / self.mu_l))

    def moment_of(self, couple: Couple) -> Expr:
        """A couple as it stands in an equation of moments: N m, or N mm of paper."""
        moment = self.number(couple.quantity, couple.printed)
        return moment / self.number(MU_L, self.mu_l) if self.in_mm else moment

    def moment_sum(self, links: Sequence[str], joint: str, about: complex, arms: list[Arm]) -> Expr:
        """Sum of moments of all loads and couples of `links` about a joint, with the arms as read, N m or N mm."""
        total: Expr | None = None
        for link in links:
            for acting in self.acting[link]:
                arm, sense = self.arm(acting, joint, about, link)
                if not arm.millimetres:  # it acts through the joint
                    continue
                arms.append(arm)
                h = self.number(arm.quantity, arm.millimetres if self.in_mm else arm.metres)
                size = self.number(acting.quantity, acting.sense * abs(acting.vector))
                total = plus(total, size * h, sense * acting.sense)
            for couple in self.couples[link]:
                total = plus(total, self.moment_of(couple), couple.value * couple.printed)
        return total if total is not None else Number(0.0)

    # ------------------------------------------------------------ scale, loads laid off

    def scale_of(self, links: Sequence[str], pairs: Sequence[Pair], corners: Sequence[complex]) -> float:
        """N per mm of a plan: as stated, by the segment stated for its longest vector, or a round one at which the plan
        fits the page. `pairs`: whose reactions it shows; `corners`: of its polygon, N, by the analytical reactions."""
        stated, path = self.scale, SCALE
        longest, of = self._longest(links, pairs)
        if isinstance(stated, Mapping):
            own = {key: s for key, s in stated.items() if set(key.split("-")) == set(links)}
            stated, path = next(((s, (*SCALE, key)) for key, s in own.items()), (None, SCALE))
        if stated is not None:
            return legible(float(stated), longest, path)
        if self.segment is not None and of is not None:
            largest = self.number(
                replace(of, key=f"{of.key}_largest"), float(round_significant(longest, DIGITS))
            )
            self.chosen = self.hand(MU_F, largest / self.number(CHOSEN, self.segment))
            return self.chosen.written
        wide, tall = (float(np.ptp(part)) for part in (np.real(corners), np.imag(corners)))
        return max(round_scale(longest, LONGEST), fitting_scale(wide, tall))

    def _longest(self, links: Sequence[str], pairs: Sequence[Pair]) -> tuple[float, Quantity | None]:
        """The longest vector of a plan, N, and what it is."""
        sizes = [(float(abs(a.vector)), a.quantity) for link in links for a in self.acting[link]]
        sizes += [(abs(self.exact(pair)), reaction(*pair.links)) for pair in pairs]
        return max(sizes, key=lambda one: one[0], default=(1.0, None))

    def exact_on(self, pair: Pair, link: str) -> complex:
        """The analytical reaction of a pair on one of its links."""
        return self.exact(pair) * (1 if link == pair.links[1] else -1)

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
            strokes.append(ForceStroke(tip, end, acting.quantity, acting.kind))
            tip = end
        return strokes, tip

    def terms(self, link: str) -> list[Term]:
        """The loads of a link in a vector equation."""
        return [Term(a.quantity.sign, 2) for a in self.acting[link]]

    # ------------------------------------------------------------ reactions

    def read(self, of: Quantity, vector: complex, pair: Pair, mu: float) -> Formula:
        """A reaction read off the plan, compared with the analytical one."""
        return self.read_force(of, vector, abs(self.exact(pair)), mu)

    def read_force(self, of: Quantity, vector: complex, exact: float, mu: float, sign: int = 1) -> Formula:
        """A force read off the plan; `sign`: −1 of one whose number is against the sense of its quantity."""
        size = self.number(drawn_length(of), self.pen.read(vector)) * self.number(MU_F, mu)
        formula = self.hand(of, size if sign > 0 else -size)
        self.compare(of, formula, exact, mu * self.pen.read_step)
        return formula

    def compare(self, of: Quantity, formula: Formula, exact: float, floor: float) -> None:
        """By their sizes; below the floor both are nothing."""
        self.comparison.append(Comparison(of.key, abs(formula.written), abs(exact), floor))

    def moment_floor(self, link: str) -> float:
        """What half a step of reading an arm makes of a moment on a link, N m."""
        largest = max((abs(a.vector) for a in self.acting[link]), default=0.0)
        return largest * self.mu_l * self.pen.read_step

    def pass_on(self, pair: Pair, link: str, vector: complex, mu: float) -> None:
        """A solved group loads the link it hangs on with an outer reaction on its `link`, mm, turned round."""
        if abs(vector) > 0:
            size = float(round_significant(self.pen.read(vector) * mu, DIGITS))
            self.load(pair, link, complex(unit(vector) * size))

    def load(self, pair: Pair, link: str, force: complex) -> None:
        """The other link of a pair bears the force on `link`, N, turned round."""
        carrier = pair.other(link)
        if carrier != FRAME and abs(force) > 0:
            at = self.joint(pair) + self.offset(pair)
            self.acting[carrier].append(Acting(reaction(link, carrier), "reaction", -force, at, pair.name))

    def touch(self, mesh: Mesh) -> complex:
        """World place of a pitch point."""
        return complex(np.ravel(mesh.touches(self.motion.state))[0])

    def poles(self, links: Sequence[str]) -> tuple[Pole, ...]:
        """The pitch points on some links."""
        own = (mesh for mesh in self.mechanism.meshes if set(mesh.links) & set(links))
        return tuple(Pole(mesh.pole, mesh.links, self.touch(mesh)) for mesh in own)

    def joint(self, pair: Pair) -> complex:
        if pair.kind == "H":
            return self.touch(
                next(mesh for mesh in self.mechanism.meshes if set(mesh.links) == set(pair.links))
            )
        link = pair.slider or pair.links[1]
        return complex(np.ravel(self.motion.state.world(link, pair.at[link]))[0])

    def guide(self, pair: Pair) -> complex:
        """World direction of a guide."""
        carrier = pair.other(pair.slider)
        return complex(np.ravel(self.motion.state.u[carrier] * pair.along[carrier])[0])

    def offset(self, pair: Pair) -> complex:
        """Where along a moving guide the reaction acts: from the moments of the sliding link, as the solver has it."""
        if pair.kind != "P":
            return 0j
        found: Reaction = self.solved.statics.reactions[pair.key]
        full = replace(found, moment=np.broadcast_to(found.moment, self.solved.motion.shape))
        offset = float(np.broadcast_to(full.offset, self.solved.motion.shape)[self.k])
        return self.guide(pair) * offset if np.isfinite(offset) else 0j


def plus(total: Expr | None, term: Expr, sense: float) -> Expr:
    """The next term of a sum, with its sign."""
    if total is None:
        return term if sense >= 0 else -term
    return total + term if sense >= 0 else total - term


def laid_end_to_end(sheet: Sheet, links: Sequence[str], start: complex = 0j) -> list[complex]:
    """Corners of the polygon of the loads of some links, N."""
    corners = [start]
    for link in links:
        for acting in sheet.acting[link]:
            corners.append(corners[-1] + acting.vector)
    return corners
