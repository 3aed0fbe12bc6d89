"""View of a gear drive as a whole: what its two templates print beside the formulas."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.drive.formulas import DriveFormulas
from tmm_report.chapters.drive.solve import Found
from tmm_report.chapters.spur import solve as spur
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.drive import kinematic_scheme, velocities
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.layout import Column, Table, numeric, worded
from tmm_report.report.page import Page

SCHEMES = {
    "sun-ring": N_("planetary, single-row, external and internal mesh"),
    "external-external": N_("planetary, double-row, two external meshes"),
    "external-internal": N_("planetary, double-row, external and internal mesh"),
    "internal-internal": N_("planetary, double-row, two internal meshes"),
}

ABOUT = Symbol("omega", "", "(H)")  # about the carrier


class DriveView(DriveFormulas):
    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(found)
        self.page, self.label = page, label
        self.t, self.num, self.sym = page.t, page.num, page.sym

    # ------------------------------------------------------------ what is given

    def given_table(self) -> Table:
        """Stages in the order of the power."""
        heads = [self.t(text) for text in (N_("Stage"), N_("Kind"), N_("Members"), N_("Required ratio"))]
        rows = [
            [str(number), self.kind(stage), self._members(stage), self._wanted(stage)]
            for number, stage in enumerate(self.found.stages, 1)
        ]
        return worded(self.t("Stages of the drive"), heads, rows, [8, 40, 30, 22])

    def kind(self, stage: Any) -> Markup:
        if isinstance(stage, spur.Found):
            return self.t("internal pair") if stage.given.internal else self.t("external pair")
        text = self.t(SCHEMES[stage.scheme.name])
        return Markup("{}, {}").format(text, self.t("differential")) if stage.second else text

    def _members(self, stage: Any) -> Markup:
        return self.page.text("–".join(member.name for member in stage.members))

    def _wanted(self, stage: Any) -> Markup:
        ratio = self.stage_ratio(stage, wanted=True)
        return self.page.value(ratio.sign, stage.wanted)

    @property
    def carried(self) -> Markup | None:
        """The symbol of speeds about carriers; None without satellites."""
        return self.sym(ABOUT) if any(m.carried_by for m in self.found.train.members) else None

    def rpm(self, speed: float) -> float:
        return speed * 30 / math.pi

    @property
    def losses(self) -> float:
        """Power lost in all the meshes, W."""
        return float(sum(self.found.loads.loss))

    @property
    def runs(self) -> bool:
        """Whether the output turns: two inputs may hold it."""
        return bool(self.found.speed[self.found.output])

    @property
    def readable(self) -> bool:
        """Whether the output's segment is long enough for a ratio."""
        return bool(self.plans.segment(self.found.output))

    def symbols(self) -> list[dict[str, Any]]:
        """What the formulas of the speeds are made of."""
        items = [
            ("drive:omega", "omega_i", self.t("angular velocity of member i"), "rad/s"),
            ("drive:n", "n_i", self.t("its frequency of rotation"), "rpm"),
            ("spur:z", "z_i", self.t("number of teeth of wheel i"), ""),
        ]
        return [
            {"id": key, "symbol": symbol, "meaning": meaning, "unit": unit}
            for key, symbol, meaning, unit in items
        ]

    @property
    def second(self) -> list[tuple[str, float]]:
        """Second inputs of differentials and their speeds, rad/s."""
        return [stage.second for stage in self.found.stages if stage.second]

    # ------------------------------------------------------------ tables

    def speeds_table(self) -> Table:
        speed, members = self.found.speed, self.found.train.members
        omega = [speed[m.name] for m in members]
        about = iter(self.page.col([speed[m.name] - speed[m.carried_by] for m in members if m.carried_by]))
        first = Column(self.t("Member"), [m.name for m in members], 8)
        columns = [
            Column(self.sym("z"), [str(m.teeth) if m.teeth else "—" for m in members]),
            Column(self._head("omega", "rad/s"), self.page.col(omega), 11),
            Column(self._head("n", "rpm"), self.page.col([self.rpm(w) for w in omega]), 11),
        ]
        if any(m.carried_by for m in members):
            cells = [next(about) if m.carried_by else "—" for m in members]
            columns.append(Column(self._head(ABOUT, "rad/s"), cells, 11))
        return numeric(self.t("Speeds of all the members of the drive"), first, columns)

    def _head(self, symbol: Symbol | str, unit: str) -> Markup:
        return Markup("{}, {}").format(self.sym(symbol), self.page.text(self.page.unit(unit)))

    def comparison_table(self) -> Table:
        """Velocities of the points and angular velocities by the diagrams and by calculation."""
        rows = self.plans.comparison
        heads = [
            self.t("Quantity"),
            self.t("By the diagrams"),
            self.t("By calculation"),
            self._head("delta", "%"),
        ]
        cells = [
            [
                self._head(*_symbol(row.key)),
                self.num(row.graph),
                self.num(row.analytic),
                "—" if row.delta is None else self.num(row.delta, 3, places=2),
            ]
            for row in rows
        ]
        caption = self.t("Magnitudes of velocities and angular velocities by the diagrams and by calculation")
        return worded(caption, heads, cells, [25, 25, 25, 25])

    def loads_table(self) -> Table:
        """External torques and powers; a positive power is supplied."""
        found = self.found
        names = list(found.loads.torque)
        torque = [float(found.loads.torque[name]) for name in names]
        power = [float(found.loads.power[name]) for name in names]
        first = Column(self.t("Member"), names, 8)
        columns = [
            Column(self._head("T", "N·m"), self.page.col(torque), 9),
            Column(self._head("omega", "rad/s"), self.page.col([found.speed[name] for name in names]), 9),
            Column(self._head("N", "W"), self.page.col(power), 9),
        ]
        return numeric(self.t("External torques and powers"), first, columns)

    def meshes_table(self) -> Table:
        """Direction of the power in every mesh."""
        loads, rows = self.found.loads, []
        parts = (self.found.train.meshes, loads.mesh_power, loads.loss)
        for mesh, power, loss in zip(*parts, strict=True):
            driving = mesh.i if power > 0 else mesh.j if power < 0 else "—"
            text = f"{mesh.i}–{mesh.j}"
            rows.append(
                [
                    text,
                    mesh.carrier or "—",
                    driving,
                    self.num(abs(power)),
                    self.num(loss, 4),
                    self.num(mesh.efficiency, 4),
                ]
            )
        heads = [self.t("Mesh"), self.t("Carrier"), self.t("Driving wheel"), self._head("N", "W")]
        heads += [self._head(Symbol("N", "fr"), "W"), self.sym("eta")]
        return worded(self.t("Flow of the power through the meshes"), heads, rows, [12, 14, 22, 18, 18, 16])

    # ------------------------------------------------------------ pictures

    @cached_property
    def scheme(self) -> Drawing:
        found = self.found
        return kinematic_scheme(
            found.stages, found.plans, found.speed, str(self.t("Kinematic scheme of the drive"))
        )

    @cached_property
    def diagrams(self) -> Drawing:
        found, title = self.found, str(self.t("Diagrams of linear and angular velocities"))
        return velocities(found.stages, found.plans, found.speed, title)

    def formulas(self) -> list[Formula]:
        """Speeds of all the stages in their order."""
        return [formula for number in range(len(self.found.stages)) for formula in self.speeds(number)]

    def conclusions(self) -> list[Markup]:
        found = self.found
        ratio = self.page.value(self._whole_symbol(), found.geared)
        text = self.t(
            "The ratio of the gear drive is %(ratio)s, its deviation from the required one is %(deviation)s %%.",
            ratio=ratio,
            deviation=self.num(100 * found.deviation, 3),
        )
        if found.locks:
            return [text, self.t("The drive locks itself: it cannot be driven from the input shaft.")]
        return [
            text,
            self.t("The efficiency of the gear drive is %(eta)s.", eta=self.num(found.efficiency, 4)),
        ]


def _symbol(key: str) -> tuple[Symbol, str]:
    """Symbol and unit of a compared value: "v_B", "w_3"."""
    base, sub = key.split("_")
    return Symbol("omega" if base == "w" else base, sub), "rad/s" if base == "w" else "m/s"
