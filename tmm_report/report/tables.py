"""Tables of the initial data, structure, kinematics and plans: what stands in their columns, as text."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.kinematics.solve import Travel
from tmm_report.chapters.plans.drafting import Projections
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.relations import turning_links
from tmm_report.mechanics.structure import Pair
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.quantity.written import load_keys, symbol_of, unit_of
from tmm_report.report.columns import Columns
from tmm_report.report.layout import Column, Table, numeric, worded


class Tables(Columns):
    # ------------------------------------------------------------ initial data and structure

    def links_given(self, caption: Any) -> Table:
        """Points of the links, and their distances from the link's first point."""
        rows = []
        for name, link in self.r.given.mechanism.links.items():
            if name != FRAME and len(link.points) > 1:
                rows.append([name, ", ".join(link.points), self._lengths(link.points)])
        return worded(caption, [self.t("Link"), self.t("Points"), self.t("Dimensions")], rows, (1, 2, 7))

    def _lengths(self, points: Mapping[str, complex]) -> Markup:
        (first, start), *others = points.items()
        sizes = [self.page.value(Symbol("l", first + name), abs(z - start), "m") for name, z in others]
        if not _in_line(list(points.values())):
            ends = list(others)
            pairs = [(a, b) for i, a in enumerate(ends) for b in ends[i + 1 :]]
            sizes += [self.page.value(Symbol("l", a + b), abs(z - w), "m") for (a, z), (b, w) in pairs]
        return self.page.listed(sizes)

    def fixed_points(self, caption: Any) -> Table:
        points = self.r.given.mechanism.links[FRAME].points
        rows = (("x", [z.real for z in points.values()]), ("y", [z.imag for z in points.values()]))
        columns = [Column(self._head(axis, "m"), [self.page.num(x) for x in values]) for axis, values in rows]
        return numeric(caption, self._first(self.t("Point"), list(points)), columns)

    def masses(self, caption: Any) -> Table:
        links = [self.r.given.mechanism.links[name] for name in self.words.heavy_links]
        columns = [
            Column(self._head("m", "kg"), [self.page.num(link.mass) for link in links]),
            Column(self.t("Mass centre"), [link.mass_centre or "—" for link in links], least=11),
            Column(
                self._head("J", "kg·m²"),
                [self.page.num(link.inertia) if link.inertia else "—" for link in links],
            ),
        ]
        return numeric(caption, self._first(self.t("Link"), [link.name for link in links]), columns)

    def forces_given(self, caption: Any) -> Table:
        loads = self.r.given.loads
        keys = load_keys([force.at for force in loads.forces])
        rows = [
            [
                self.sym(symbol_of(key)),
                force.name,
                self.t("point %(point)s", point=force.at),
                self.words.direction(force.direction),
            ]
            for key, force in zip(keys, loads.forces, strict=True)
        ]
        rows += [
            [
                self.sym(Symbol("M", moment.on)),
                moment.name,
                self.t("link %(link)s", link=moment.on),
                self.words.turning(moment.direction),
            ]
            for moment in loads.moments
        ]
        heads = [self.t("Symbol"), self.t("Load"), self.t("Applied to"), self.t("Direction")]
        return worded(caption, heads, rows, (2, 5, 4, 5))

    def loads_by_position(self, caption: Any) -> Table:
        """Magnitudes of the stated loads at the table positions 0..N-1."""
        given, loading = self.r.given.loads, self.r.kinetostatics.table.loading
        count = self.r.given.positions.table
        keys = load_keys([force.at for force in given.forces])
        columns = [
            Column(self._head(symbol_of(key), "N"), [self.page.num(abs(x)) for x in vector[:count]])
            for key, vector in zip(keys, loading.forces, strict=True)
        ]
        columns += [
            Column(self._head(Symbol("M", stated.on), "N·m"), [self.page.num(abs(x)) for x in value[:count]])
            for stated, value in zip(given.moments, loading.moments, strict=True)
        ]
        return numeric(caption, self._positions(count), columns)

    def links(self, caption: Any) -> Table:
        names = [FRAME, *self.r.given.mechanism.moving]
        rows = [[name, self.words.name(name), self.words.motion(name)] for name in names]
        return worded(caption, [self.t("Link"), self.t("Name"), self.t("Motion")], rows, (1, 4, 4))

    def pairs(self, caption: Any) -> Table:
        rows = [
            [str(k), f"{pair.links[0]}–{pair.links[1]}", pair.name, self.words.pair_kind(pair), "V", "1"]
            for k, pair in enumerate(self.r.structure.pairs, 1)
        ]
        heads = [
            self.t("No."),
            self.t("Links"),
            self.t("Point, guide"),
            self.t("Kind"),
            self.t("Class"),
            self.t("Mobility"),
        ]
        return worded(caption, heads, rows, (1, 2, 2, 4, 1.4, 2))

    def groups(self, caption: Any) -> Table:
        """Groups in the order in which they are detached."""
        rows = [
            [
                self.words.group(group), ", ".join(group.links), self.words.roman(group.group_class), str(group.order),
                self.words.group_kind(group), _pair_list(group.inner), _pair_list(group.outer),
            ]
            for group in reversed(self.r.structure.groups)
        ]  # fmt: skip
        heads = [
            self.t("Group"),
            self.t("Links"),
            self.t("Class"),
            self.t("Order"),
            self.t("Kind"),
            self.t("Inner pairs"),
            self.t("Outer pairs"),
        ]
        return worded(caption, heads, rows, (2.4, 1.4, 1.4, 1.6, 3, 3, 3))

    # ------------------------------------------------------------ kinematics

    def travels(self, caption: Any) -> Table:
        """S, V, a of the outputs at the table positions."""
        columns = []
        for travel in self.r.kinematics.travels:
            symbols, units = travel_symbols(travel)
            factors = (np.degrees(1), 1, 1) if travel.output.kind == "rocker" else (1, 1, 1)
            for symbol, unit, values, factor in zip(
                symbols, units, (travel.S, travel.V, travel.a), factors, strict=True
            ):
                columns.append(Column(self._head(symbol, unit), self.col(values * factor)))
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def travel_extremes(self, caption: Any, travel: Travel) -> Table:
        symbols, units = travel_symbols(travel)
        pairs = ((travel.near, travel.far), travel.V_extremes, travel.a_extremes)
        rows = []
        for symbol, unit, (low, high), factor in zip(
            symbols, units, pairs, (np.degrees(1), 1, 1), strict=True
        ):
            factor = factor if travel.output.kind == "rocker" else 1
            size = max(abs(low.value), abs(high.value))
            texts = [
                [
                    self.page.num(e.value * factor, scale=max(1.0, size)),
                    self.page.num(np.degrees(e.turned), places=2),
                ]
                for e in (low, high)
            ]
            rows.append([self._head(symbol, unit), *texts[0], *texts[1]])
        heads = [
            self.t("Quantity"),
            self.t("Least value"),
            self.t("at the angle of turn,\N{NO-BREAK SPACE}°"),
            self.t("Greatest value"),
            self.t("at the angle of turn,\N{NO-BREAK SPACE}°"),
        ]
        return worded(caption, heads, rows, (2.2, 2, 2, 2, 2))

    def angular(self, caption: Any) -> Table:
        """Angular velocities and accelerations of the driven links at the table positions."""
        values = self.r.kinematics.values
        driver = self.r.given.mechanism.driver.link
        keys = [
            f"{letter}_{link}"
            for link in turning_links(self.r.structure.linkage)
            if link != driver
            for letter in "we"
        ]
        columns = [self._signed(key, values[key]) for key in keys]
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    @property
    def has_angular(self) -> bool:
        return len(turning_links(self.r.structure.linkage)) > 1

    # ------------------------------------------------------------ plans

    def plan_values(self, caption: Any, kind: str) -> Table:
        """Values read off all plans of a kind, "v" or "a": one row a position."""
        plans = [drawn.velocity if kind == "v" else drawn.acceleration for drawn in self.r.plans.drawn]
        keys = list(dict.fromkeys(key for plan in plans for key in plan.values if plan.per_mm[key]))
        columns = [
            Column(
                self._head(symbol_of(key), unit_of(key)),
                [self.page.num(plan.values.get(key, np.nan)) for plan in plans],
                least=9,
            )
            for key in keys
        ]
        return numeric(
            caption, self._first(self.t("Position"), [str(plan.position) for plan in plans]), columns
        )

    def projections(self, caption: Any, found: Projections) -> Table:
        """Coefficients of a group's unknown rates, right sides, and the solution in the last row."""
        rows = [
            [f"{point}, {axis}", *(self.page.num(x) for x in coefficients), self.page.num(right)]
            for point, axis, coefficients, right in found.rows
        ]
        rows.append([self.t("Solution"), *(self.page.num(x) for x in found.solution), ""])
        heads = [self._head(symbol_of(key), unit_of(key)) for key in found.unknown]
        heads = [self.t("Contour, axis"), *heads, self.t("Right side")]
        return worded(caption, heads, rows, [1.0] * len(heads))

    def segments(self, caption: Any, kind: str) -> Table:
        plans = [drawn.velocity if kind == "v" else drawn.acceleration for drawn in self.r.plans.drawn]
        names = list(dict.fromkeys(name for plan in plans for name in plan.segments))
        columns = [
            Column(
                self._head(segment(name), "mm"),
                [self.page.num(plan.segments.get(name, np.nan), 7) for plan in plans],
            )
            for name in names
        ]
        return numeric(
            caption, self._first(self.t("Position"), [str(plan.position) for plan in plans]), columns
        )


def travel_symbols(travel: Travel) -> tuple[tuple[Symbol, ...], tuple[str, ...]]:
    """Symbols and units of an output's displacement, velocity and acceleration."""
    name = travel.output.name
    if travel.output.kind == "rocker":
        return (Symbol("psi", name), Symbol("omega", name), Symbol("epsilon", name)), (
            "deg",
            "rad/s",
            "rad/s²",
        )
    return (Symbol("S", name), Symbol("V", name), Symbol("a", name)), ("m", "m/s", "m/s²")


def _in_line(points: Sequence[complex]) -> bool:
    arms = np.array(points[1:]) - points[0]
    return bool(
        np.all(np.abs((arms * np.conj(arms[0])).imag) <= 1e-9 * np.abs(arms[0]) * np.max(np.abs(arms)))
    )


def _pair_list(pairs: Sequence[Pair]) -> str:
    return ", ".join(f"{pair.links[0]}–{pair.links[1]} ({pair.name})" for pair in pairs)
