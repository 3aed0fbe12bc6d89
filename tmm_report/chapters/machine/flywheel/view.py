"""View of the flywheel: what its templates print beside the formulas."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.moving import friction_told
from tmm_report.chapters.machine.flywheel import draw, sketch
from tmm_report.chapters.machine.flywheel import quantities as q
from tmm_report.chapters.machine.flywheel.equations import (
    energies,
    pole,
    running_work,
    sample,
    unevenness,
    whole_work,
)
from tmm_report.chapters.machine.flywheel.methods import Written
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.model import Column
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import CycleGraphs, scale_of, scales
from tmm_report.report.page import ROUNDING, Page
from tmm_report.report.paper.layout import Table, numeric, worded
from tmm_report.report.part import Part

METHODS = {
    "exact": N_("exact"),
    "mertsalov": N_("Mertsalov"),
    "wittenbauer": N_("Wittenbauer"),
    "rerikh": N_("Rerikh"),
    "constant": N_("constant moment of inertia"),
}
OFF = {
    "mertsalov": N_("Mertsalov's method differs from it by %(off)s %%."),
    "wittenbauer": N_("Wittenbauer's method differs from it by %(off)s %%."),
    "rerikh": N_("Rerikh's method differs from it by %(off)s %%."),
}
SPEEDS = ("omega_0", "omega", "domega", "epsilon")  # columns of the motion
ENERGIES = ("J_II", "T_II", "dT_I")  # those of the varying part
WAYS = {"energy": N_("energy integral"), "integration": N_("integration of the equation of motion")}
SHOWN = ("mertsalov", "wittenbauer", "rerikh", "constant", "exact")  # in the order of the note


def parts(found: Found, page: Page) -> Iterator[Part]:
    view = FlywheelView(found, page)
    yield Part("machine/flywheel", view)
    if found.methods:
        yield Part("machine/flywheel/methods", view, concludes=False)
    yield Part("machine/flywheel/motion", view, concludes=False)
    if "J_shaft" in found.s and not (found.given.wheel and found.s.number("i") == 1):
        yield Part("machine/flywheel/sizes", view, concludes=False)


def picture(found: Found, page: Page) -> Drawing:
    """The wheel at a glance; where its shape is not known the energy–mass diagram, or the work over the cycle."""
    view = FlywheelView(found, page)
    if "D_out" in found.s:
        return view.sketch
    return view.energy_mass if found.diagram else draw.work_curve(found, view.figure)


class FlywheelView(ChapterView):
    kinds_once = True

    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, q.tables(found))
        self.found = found

    # ------------------------------------------------------------ the task

    def definition(self) -> Definition:
        return unevenness(self.found.s)

    def given_values(self) -> Markup:
        s, given = self.s, self.found.given
        keys = ["omega_m", *([] if given.wheel else ["delta"])]
        if s.has_formula("J_own"):
            keys += [key for key in ("J_0", "J_c") if s.number(key)]
        elif s.number("J_own"):
            keys.append("J_own")
        if given.motor is not None:
            keys += ["P_nom", "omega_nom", *(["J_r"] if given.motor.inertia else [])]
        return self.listed(keys)

    @property
    def geared(self) -> bool:
        """Whether the motor's gear takes a part of its power."""
        return self.s.has_formula("P_need") and self.s.get("eta") != 1

    def inline(self, *keys: str) -> Markup:
        """Formulas in running text."""
        return self.page.listed(map(self.page.math, self.formulas(*keys)))

    def friction(self) -> Markup | None:
        """What is said of the friction of the pairs; None where none is stated."""
        text = friction_told(self.found.sides.machine)
        named = {
            name: key for name, key in (("power", "P_fr"), ("share", "P_fr_share")) if f"%({name})s" in text
        }
        return self.t(text, **{name: self.number(key) for name, key in named.items()}) if text else None

    @property
    def turns(self) -> float:
        return self.found.cycle.panels.period / (2 * math.pi)

    @property
    def machine(self) -> Markup:
        machine = self.found.given.machine
        return self.t(machine) if machine else Markup()

    @property
    def within(self) -> bool:
        """Whether the unevenness is among those usual for the machine."""
        fine, coarse = self.found.given.usual or (0.0, 1.0)
        return fine * (1 - 1e-9) <= self.s.number("delta") <= coarse * (1 + 1e-9)

    @cached_property
    def position(self) -> int:
        """The position that is written out: where the excess moment is greatest."""
        moments = np.abs(self.of("table", "M_ex").numbers()[:-1])
        return int(np.argmax(moments > 0.999 * moments.max()))

    @cached_property
    def samples(self) -> list[Formula]:
        return list(sample(self.found, self.table("table"), self.position))

    @cached_property
    def energies(self) -> list[Formula]:
        return list(energies(self.found, self.table("table"), self.position))

    @cached_property
    def reduced(self) -> list[Formula]:
        """The masses and loads of a lever mechanism, reduced at the position."""
        from tmm_report.chapters.machine.flywheel import reduced  # only a lever mechanism needs it

        return list(reduced.formulas(self.found, self.table("table"), self.position))

    def whole_work(self) -> Definition:
        return whole_work(self.found)

    def work_explained(self) -> list[dict[str, Any]]:
        side = "M_res" if self.found.sides.balancing == "driving" else "M_dr"
        return [
            *self.explained("W"), *self.columns_explained("table", side, "phi"), *self.explained("Phi")
        ]  # fmt: skip

    def cycle_explained(self, *keys: str) -> list[dict[str, Any]]:
        """What is said of those columns of the cycle that this machine has."""
        table = self.table("table")
        return self.columns_explained("table", *(key for key in keys if key in table))

    def running_work(self) -> Definition:
        return running_work()

    def pole(self) -> Formula:
        return pole(scales(self.diagram))

    # ------------------------------------------------------------ tables

    def cycle(self, caption: Any) -> Table:
        """Moments, works and energies; a moment that is constant has been said."""
        of = self.found.sides.balancing
        constant = {"driving": "M_dr", "resisting": "M_res" if not self.of_friction else ""}.get(of, "")
        table = self.table("table")
        leave = ("position", constant, *SPEEDS, *self._unvaried)
        return numeric(caption, self.page.positions(table), self.columns("table", leave=leave))

    @property
    def of_friction(self) -> bool:
        """Whether friction is in the resistances, which therefore vary."""
        return "M_fr" in self.table("table")

    def speeds(self, caption: Any) -> Table:
        table = self.table("table")
        keys = [key for key in SPEEDS if key in table]
        return numeric(caption, self.page.positions(table), self.columns("table", ["phi", *keys]))

    def left_for_the_wheel(self, method: str) -> Markup:
        """J_I less the machine's own, in running text."""
        return self.page.math(self.by(method).wheel())

    def cut(self, method: str, end: str) -> Markup:
        """What a tangent of a method cuts off, in running text."""
        return self.page.value(self.table("methods").var(f"T_{end}", self.by(method).row))

    def off(self) -> Markup:
        """By how much the methods of the text differ from the exact value."""
        table = self.table("methods")
        rows = {name: self.by(name).row for name, chosen in self.found.given.chosen.items() if chosen}
        said = [
            self.t(OFF[name], off=self.page.shown(table, "deviation", row, digits=3, scale=1e-6))
            for name, row in rows.items()
        ]
        return self.page.listed(said, " ")

    def by(self, method: str) -> Written:
        """A method written out."""
        return Written(self.found, method)

    def place(self, method: str, end: str) -> Markup:
        """The angle at which a method takes the speed to be greatest, "1", or least, "2"."""
        return self.page.shown(self.table("methods"), f"phi_{end}", self.by(method).row)

    def comparison(self, caption: Any) -> Table:
        table, page = self.table("methods"), self.page
        keys = ("J_I", "J_fl", "deviation", "phi_1", "phi_2")
        heads = [page.head(table[key].symbol(), table[key].unit) for key in keys]
        rows = [
            [page.word(self.t(METHODS[name]), table, "method", k), *(self._cell(key, k) for key in keys)]
            for k, name in ((self.by(name).row, name) for name in SHOWN)
        ]
        return worded(caption, [self.t("Method"), *heads], rows, (7, 3, 3, 3, 3, 3))

    def _cell(self, key: str, row: int) -> Any:
        if key == "deviation":
            return self.page.cell(self.table("methods"), key, row, places=3)
        return self.page.cell(self.table("methods"), key, row, digits=6 if key.startswith("J") else 5)

    def proof(self, caption: Any) -> Table:
        table, page = self.table("proof"), self.page
        keys = ("omega_max", "omega_min", "delta")
        heads = [page.head(table[key].symbol(), table[key].unit) for key in keys]
        rows = [
            [
                page.word(self.t(WAYS[name]), table, "way", k),
                *(page.cell(table, key, k, digits=8) for key in keys),
            ]
            for k, name in enumerate(q.WAYS)
        ]
        return worded(caption, [self.t("Way"), *heads], rows, (8, 3, 3, 3))

    @property
    def agrees(self) -> bool:
        """Whether the motion in two ways differs by rounding alone."""
        miss = self.of("proof", "miss").numbers()[1]
        return max(abs(float(miss)), abs(self.s.number("closure"))) < ROUNDING

    def miss(self) -> Markup:
        return self.page.bound(self.table("proof"), "miss", 1)

    # ------------------------------------------------------------ diagrams

    @cached_property
    def _x(self) -> Any:
        return draw.places(self.found)

    @cached_property
    def _graphs(self) -> CycleGraphs:
        whole = abs(self.turns - round(self.turns)) < 1e-9
        return CycleGraphs(self._x, len(self.found.sides.turned) - 1 if whole else 0, self.page.tr)

    @cached_property
    def _drawn(self) -> dict[str, Column]:
        """The quantities of the cycle where curves are drawn."""
        every = q.cycle(self.found, self._x)
        return {column.key: column for column in every if column.key not in self._unvaried}

    @property
    def _unvaried(self) -> tuple[str, ...]:
        """Columns without anything in them, as no moment of inertia varies."""
        return () if self.found.varies else ENERGIES

    def _panels(self, *rows: tuple[str, ...]) -> Graph:
        """A panel for each row of quantities, of those that are known, at round scales."""
        known = [[self._drawn[key] for key in row if key in self._drawn] for row in rows]
        curves, labels = [], []
        for panel, row in enumerate(of for of in known if of):
            for column in row:
                name = self._graphs.letter(column.symbol()) if len(row) > 1 else ""
                # values beside a curve that lies on another would cover it: they stand in formulas, or under it again
                marks = () if column.key in ("omega", "A") else draw.extremes(self.found, column.key)
                if column.key == "J_II":
                    marks = marks and marks[:1]  # the least is too near to the axis
                curves.append(Curve(column.values, name, panel, marks))
            shown = Symbol(row[0].symbol().base) if len(row) > 1 else row[0].symbol()
            labels.append(self._graphs.letter(shown, row[0].unit))
        return self._graphs.graph(curves, labels)

    @property
    def derived(self) -> bool:
        """Whether the note derives the reduced moment of inertia, and does not only give it."""
        return self.page.note.stand("flywheel.derivation") != "omit"

    @cached_property
    def diagram(self) -> Graph:
        """Moments, moment of inertia, work and energy; where nothing is derived moments and work."""
        moments = ("M_dr", "M_res") if "M_dr" in self._drawn else ("M_ex",)
        rows = (moments, ("J_II",), ("A", "dT_I"))
        return self._panels(*(rows if self.derived else rows[::2]))

    def caption(self) -> Markup:
        """Of the diagram."""
        if not self.found.varies:
            return self.t(N_("Moments and work over the cycle"))
        if not self.derived:
            return self.t(N_("Moments, work and energy over the cycle"))
        return self.t(N_("Moments, moment of inertia, work and energy over the cycle"))

    @cached_property
    def speed_diagram(self) -> Graph:
        return self._panels(("omega_0", "omega"), ("domega",))

    @cached_property
    def energy_mass(self) -> Drawing:
        inertia, energy = self._drawn["J_II"], self._drawn["T_II"]
        labels = (
            self._graphs.letter(inertia.symbol(), inertia.unit),
            self._graphs.letter(Symbol(energy.symbol().base), energy.unit),
        )
        title = str(self.t("Energy–mass diagram with its tangents"))
        return draw.energy_mass(self.found, labels, self.figure, title)

    def figure(self, value: float) -> str:
        return self.page.num(value, 4)

    def diagram_scales(self) -> Markup:
        return self.listed(("mu_J", "mu_T"))

    # ------------------------------------------------------------ dimensions

    @property
    def shape(self) -> str:
        """The word by which the template knows it."""
        given = self.found.given
        return "wheel" if given.wheel else type(given.shape).__name__.lower()

    @cached_property
    def sketch(self) -> Drawing:
        outer = self.page.tr.pgettext("index", "outer")
        return sketch.sketch(self.found, self.figure, outer, str(self.t("The flywheel")))

    def sketch_scale(self) -> Var:
        return scale_of("mu_l", sketch.scale_of(self.found), "m/mm")

    @property
    def material(self) -> Markup:
        return self.t(self.found.given.metal.name or N_("stated material"))

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        found = self.found
        if found.needless:
            text = N_(
                "The machine needs no flywheel: without one its coefficient of speed fluctuation is %(delta)s."
            )
            return [self.t(text, delta=self.number("delta_0"))]
        text = N_(
            "A flywheel of %(J)s kg·m² keeps the coefficient of speed fluctuation of the machine at %(delta)s."
        )
        if "J_shaft" in self.s and self.s.number("i") != 1:
            text = N_(
                "A flywheel of %(own)s kg·m² on its own shaft, with the ratio %(ratio)s to the main link, is "
                "equivalent to one of %(J)s kg·m² on that link and keeps the coefficient of speed fluctuation of "
                "the machine at %(delta)s."
            )
        form = {"own": "J_shaft", "ratio": "i", "J": "J_fl"}
        numbers = {name: self.number(key) for name, key in form.items() if f"%({name})s" in text}
        said = [self.t(text, delta=self.number("delta_run"), **numbers)]
        if "D_out" in self.s:
            text = N_("Its diameter is %(D)s m, its width %(b)s m and its mass %(m)s kg.")
            if self.shape == "rim":
                text = N_(
                    "Its outer diameter is %(D)s m, its width %(b)s m and the mass of its rim %(m)s kg."
                )
            said.append(self.t(text, D=self.number("D_out"), b=self.number("b"), m=self.number("m")))
            text = N_("The speed at its rim, %(v)s m/s, is within the allowed %(limit)s m/s.")
            if found.bursts:
                text = N_("The speed at its rim, %(v)s m/s, is above the allowed %(limit)s m/s.")
            said.append(self.t(text, v=self.number("v"), limit=self.number("v_lim")))
        elif "m" in self.s:
            said.append(self.t(N_("Its mass is %(m)s kg."), m=self.number("m")))
        return [self.page.listed(said, " ")]
