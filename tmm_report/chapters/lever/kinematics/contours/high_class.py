"""Contours of groups above class II: the equations in projections, the values that close them, and the linear
equations of their derivatives.

A contour is Σ ±r_P + Σ l·e^{i(φ + γ)} + Σ ±s·e^{iβ} = 0, two projections; differentiated by the time, its unknown rates
stand to the left and what is known to the right. Source: Levitsky, Theory of mechanisms and machines, ch. 3.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.contours.equations import (
    BEARING,
    COEFFICIENT,
    KNOWN_A,
    KNOWN_V,
    SLID_BEND,
    SLID_RATE,
    quantity,
)
from tmm_report.chapters.lever.kinematics.contours.known import Pose, Spot
from tmm_report.chapters.lever.kinematics.contours.nodes import Signed, times, total
from tmm_report.chapters.lever.kinematics.contours.terms import (
    Contour,
    Segment,
    Slide,
    WrittenSystem,
    pairs,
    slid,
)
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.loop_equations import Form
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Var, cos, sin
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation

Array = Any
SLID = N_("displacement along guide %(guide)s")
RESIDUAL = N_("residual of the loop equations of group %(group)s")


def write(bench: Bench, group: HigherGroup) -> WrittenSystem:
    return _Writer(bench, group).written()


class _Writer:
    def __init__(self, bench: Bench, group: HigherGroup):
        self.bench, self.loops, self.group = bench, group.loops, group.group
        self.label = group.group.label
        self.joined: set[str] = set()
        self.roots = self._roots()
        self.angles = [
            bench.of_table("positions_table", q.angle(link), _angle(bench, link)) for link in self.roots
        ]
        self.slides = [self._slide(n, pair) for n, pair in enumerate(self.loops.sliding)]
        self.contours = [self._contour(form) for form in self.loops.closures]
        self.unknowns = [*self.angles, *(slide.s for slide in self.slides)]
        self.rates = [*(self._w(n) for n in range(len(self.angles))), *(x.first for x in self.slides)]
        self.bends = [*(self._e(n) for n in range(len(self.angles))), *(x.second for x in self.slides)]

    def written(self) -> WrittenSystem:
        lead = self.bench.taken()
        sums = [self._sum(contour, axis) for contour in self.contours for axis in (0, 1)]
        residuals = [self._residual(n, one) for n, one in enumerate(sums, 1)]
        self.bench.taken()
        rows = [self._row(n, contour, axis) for n, contour, axis in self._numbered()]
        coefficients = self.bench.taken()
        self._pose()
        return WrittenSystem(
            self.group, lead, tuple(Equation(one, numbers=False) for one in sums), self.unknowns, residuals,
            coefficients, self.rates, self.bends, rows, [],
        )  # fmt: skip

    def _numbered(self) -> Iterator[tuple[int, Contour, int]]:
        for n, contour in enumerate(self.contours):
            yield 2 * n + 1, contour, 0
            yield 2 * n + 2, contour, 1

    # ------------------------------------------------------------ unknowns

    def _roots(self) -> list[str]:
        """The link by which each unknown direction is named."""
        found: dict[int, str] = {}
        for link in self.group.links:
            root = self.loops.directions[link].root
            if isinstance(root, int):
                found.setdefault(root, link)
        return [found[n] for n in range(self.loops.angles)]

    def _w(self, n: int) -> Var:
        w = self.bench.w(self.roots[n])
        assert w is not None
        return w

    def _e(self, n: int) -> Var:
        e = self.bench.e(self.roots[n])
        assert e is not None
        return e

    def _slide(self, n: int, pair: Pair) -> Slide:
        """Displacement along a guide by the solver's motion, and its derivatives."""
        bench, guide = self.bench, self.loops.guides[n]
        slider = str(pair.slider)
        carrier = pair.other(slider)
        s, first, second = slid(bench, pair, slider, carrier)
        of = {"link": slider, "guide": pair.name}
        named = (
            quantity(f"s_{pair.name}", Symbol("s", pair.name), "m", SLID, guide=pair.name),
            Quantity(f"s1_{pair.name}", Symbol("s′", pair.name), "m/s", Message(SLID_RATE, of)),
            Quantity(f"s2_{pair.name}", Symbol("s′′", pair.name), "m/s²", Message(SLID_BEND, of)),
        )
        values = (bench.kept(named[0], s), bench.kept(named[1], first), bench.kept(named[2], second))
        if isinstance(guide.root, int):
            beta = self._turned(guide.root, pair.name, complex(guide.turn))
            return Slide(*values, beta, guide.root, None, None)
        beta = bench.direction(pair.name, guide.root, complex(guide.turn))
        return Slide(*values, beta, None, bench.w(guide.root), bench.e(guide.root))

    def _turned(self, root: int, ends: str, at: complex) -> Expr:
        pose = Pose(Spot("", self.angles[root], self.angles[root]), 0j, self.angles[root], 0.0, None, None)
        return self.bench.turned(pose, ends, at)

    # ------------------------------------------------------------ contours

    def _contour(self, form: Form) -> Contour:
        points = [(sign, self._point(link, complex(at))) for sign, link, at in form.points]
        self.joined = self._joined([*form.vectors, *form.units])
        known = [(1, self._fixed(link, complex(arm))) for link, arm in form.vectors if abs(arm) > 0]
        units = [(1, self._unit(c, complex(arm))) for c, arm in form.units if abs(arm) > 0]
        return Contour(points, [*known, *units], [(sign, self.slides[p]) for p, sign in form.slides])

    def _point(self, link: str, at: complex) -> Spot:
        points = self.bench.mechanism.links[link].points
        size = abs(at) + max((abs(z) for z in points.values()), default=0.0)
        named = [p for p, z in points.items() if abs(z - at) <= 1e-12 * size]
        return self.bench.spot(named[0]) if named else self.bench.auxiliary(link, at)

    def _unit(self, c: int, arm: complex) -> Segment:
        """A segment of the links of one unknown direction, named by its ends where they have names."""
        one, other = self._ends(c, arm)
        length = self.bench.length(one, other, abs(arm))
        return Segment(length, self._turned(c, one + other, arm), c, self._w(c), self._e(c))

    def _ends(self, root: int | str, arm: complex) -> tuple[str, str]:
        """Points of a link of this direction that are so apart; where one has no name it is given one."""
        found = self._candidates(root, arm)
        if not found:
            return self.bench.new_point(), self.bench.new_point()
        one, other = max(found, key=lambda ends: len(self.joined.intersection(ends)))
        return one or self.bench.new_point(), other or self.bench.new_point()

    def _candidates(self, root: int | str, arm: complex) -> list[tuple[str, str]]:
        """All points of links of this direction that are so apart."""
        found: list[tuple[str, str]] = []
        for link in self.group.links:
            of = self.loops.directions[link]
            if of.root == root:
                places, origin = self.bench.mechanism.links[link].points, self.loops.origins[link]
                found += pairs(places, complex(origin), of.turn, arm)
        return list(dict.fromkeys(found))

    def _joined(self, arms: Sequence[tuple[int | str, Any]]) -> set[str]:
        """Ends of those segments of a contour of which there is no doubt: the others join them."""
        each = [self._candidates(root, complex(arm)) for root, arm in arms if abs(arm) > 0]
        return {end for found in each if len(found) == 1 for end in found[0]}

    def _fixed(self, link: str, arm: complex) -> Segment:
        bench, (one, other) = self.bench, self._ends(link, arm)
        of = Quantity(
            f"phi_{one}{other}", Symbol("phi", one + other), "deg", Message(BEARING, {"of": one + other})
        )
        angle = bench.bearing(of, one + other, link, arm / abs(arm))
        return Segment(bench.length(one, other, abs(arm)), angle, None, bench.w(link), bench.e(link))

    # ------------------------------------------------------------ equations

    def _sum(self, contour: Contour, axis: int) -> Expr:
        own = (cos, sin)[axis]
        terms: list[Signed] = [(sign, (spot.x, spot.y)[axis]) for sign, spot in contour.points]
        terms += [(sign, part.length * own(part.angle)) for sign, part in contour.segments]
        terms += [(sign, slide.s * own(slide.beta)) for sign, slide in contour.slides]
        return total(terms)

    def _residual(self, n: int, expression: Expr) -> Formula:
        of = quantity(f"f{n}_{self.label}", Symbol("f", str(n)), "m", RESIDUAL, group=self.label)
        self.bench.own(of, expression, known=True)
        return self.bench.formulas[-1]

    def _row(self, n: int, contour: Contour, axis: int) -> list[str]:
        """Coefficients and both right sides of an equation; gives their keys."""
        keys = []
        for j in range(len(self.unknowns)):
            unit = "m" if j < len(self.angles) else ""
            terms = list(self._by(j, contour, axis))
            keys.append(self._own(f"k{n}{j + 1}", Symbol("k", f"{n}{j + 1}"), unit, COEFFICIENT, terms))
        known = [(-sign, term) for sign, term in self._known(contour, axis)]
        keys.append(self._own(f"b{n}", Symbol("b", str(n)), "m/s", KNOWN_V, known))
        bent = [(-sign, term) for sign, term in self._bent(contour, axis)]
        keys.append(self._own(f"d{n}", Symbol("d", str(n)), "m/s²", KNOWN_A, bent))
        return keys

    def _own(self, key: str, symbol: Symbol, unit: str, text: str, terms: list[Signed]) -> str:
        found = f"{key}_{self.label}"
        self.bench.own(quantity(found, symbol, unit, text, group=self.label), total(terms), known=True)
        return found

    def _by(self, j: int, contour: Contour, axis: int) -> Iterator[Signed]:
        """The derivative of a contour by an unknown."""
        own, other, sign = (cos, sin)[axis], (sin, cos)[axis], (-1, 1)[axis]
        if j >= len(self.angles):
            wanted = self.slides[j - len(self.angles)]
            yield from ((way, own(slide.beta)) for way, slide in contour.slides if slide is wanted)
            return
        yield from (
            (sign * way, part.length * other(part.angle)) for way, part in contour.segments if part.turns == j
        )
        yield from (
            (sign * way, slide.s * other(slide.beta)) for way, slide in contour.slides if slide.turns == j
        )

    def _known(self, contour: Contour, axis: int) -> Iterator[Signed]:
        """The first derivative with the unknowns kept."""
        other, sign = (sin, cos)[axis], (-1, 1)[axis]
        yield from ((way, spot.v and spot.v[axis]) for way, spot in contour.points)
        for way, part in contour.segments:
            if part.turns is None:
                yield sign * way, times(part.length, part.w, other(part.angle))
        for way, slide in contour.slides:
            if slide.turns is None:
                yield sign * way, times(slide.s, slide.w, other(slide.beta))

    def _bent(self, contour: Contour, axis: int) -> Iterator[Signed]:
        """The second derivative without the unknowns' second derivatives."""
        yield from ((way, spot.a and spot.a[axis]) for way, spot in contour.points)
        for way, part in contour.segments:
            rates = (part.w, part.e if part.turns is None else None)
            yield from _second(way, part.length, *rates, part.angle, axis)
        for way, slide in contour.slides:
            w = slide.w if slide.turns is None else self._w(slide.turns)
            yield from _second(way, slide.s, w, slide.e, slide.beta, axis)
            other, sign = (sin, cos)[axis], (-1, 1)[axis]
            yield sign * way, times(2 * slide.first, w, other(slide.beta)) if w is not None else None

    # ------------------------------------------------------------ the links afterwards

    def _pose(self) -> None:
        for link in self.group.links:
            of = self.loops.directions[link]
            points = self.bench.mechanism.links[link].points
            reference = self.loops.references[link]
            name = reference.name if reference.name in points else next(iter(points), None)
            if name is None:
                continue
            base, origin = self.bench.spot(name), complex(points[name])
            if isinstance(of.root, int):
                angle, zero = self.angles[of.root], -float(np.angle(of.turn))
                w, e = self._w(of.root), self._e(of.root)
                self.bench.poses[link] = Pose(base, origin, angle, zero, w, e)
            else:
                beta = self.bench.direction(link, of.root, complex(of.turn))
                self.bench.poses[link] = Pose(
                    base, origin, beta, 0.0, self.bench.w(of.root), self.bench.e(of.root)
                )


def _second(
    way: int, length: Expr, w: Expr | None, e: Expr | None, angle: Expr, axis: int
) -> Iterator[Signed]:
    own, other, sign = (cos, sin)[axis], (sin, cos)[axis], (-1, 1)[axis]
    yield -way, times(length, w**2 if w is not None else None, own(angle))
    yield sign * way, times(length, e, other(angle))


def _angle(bench: Bench, link: str) -> Array:
    return np.angle(bench.motion.turn(link))
