"""View of a gear drive as a whole: what its two templates print beside the formulas."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any, assert_never

from markupsafe import Markup

from tmm_report.chapters.gears.drive.draw.diagrams import beside, kinematic_scheme, velocities
from tmm_report.chapters.gears.drive.power.view import PowerView
from tmm_report.chapters.gears.drive.quantities import tables
from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.chapters.gears.drive.steps import whole
from tmm_report.chapters.gears.ordinary import solve as ordinary
from tmm_report.chapters.gears.ordinary.quantities import TITLES
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.power_flow import power_flow
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity import model as quantity
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.terms.kinds import parted
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import DASH, Cell, Column, Table, numeric, worded
from tmm_report.report.part import Failed, Inner, Part

SCHEME = N_("Kinematic scheme of the drive")
SCHEMES = {
    "sun-ring": N_("planetary, single-row, external and internal mesh"),
    "external-external": N_("planetary, double-row, two external meshes"),
    "external-internal": N_("planetary, double-row, external and internal mesh"),
    "internal-internal": N_("planetary, double-row, two internal meshes"),
}


def parts(found: Found, page: Page) -> Iterator[Part | Inner]:
    """The drive at the head of its stages, then as a whole."""
    view = DriveView(found, page, "drive")
    yield Part("gears/drive", view)
    if view.power_view is not None:
        yield Part("gears/drive/power", view)
    for number, stage in enumerate(found.stages, 1):
        yield Inner(_chapter(stage), stage, f"stage{number}")
    yield Part("gears/drive/whole", view)


def _chapter(stage: Stage) -> str:
    match stage:
        case spur.Found():
            return "spur"
        case planetary.Found():
            return "planetary"
        case ordinary.Found():
            return "ordinary"
        case _:
            assert_never(stage)


def picture(found: Found, page: Page) -> Drawing:
    """The drive at a glance, for a list of many."""
    return kinematic_scheme(found.stages, found.plans, found.speed, str(page.t(SCHEME)))


class DriveView(ChapterView):
    """Members are named as in the scheme; `label`: with which the names of the results begin."""

    def __init__(self, found: Found, page: Page, label: str):
        self.found, self.plans, self.label, self.whole = found, found.plans, label, whole(found, label)
        super().__init__(page, self.whole.s, tables(found, label))
        self.speeds_of, self.members = self.table("speeds"), self.whole.members
        self.power_view = self._power()

    def _power(self) -> PowerView | None:
        steps, found = self.whole.power, self.found
        if steps is None:
            return None
        names = [(stage.input, stage.output) for stage in found.stages]
        own = [*self.book.tables.values()]
        return PowerView(steps, self.page, own, self.label, self.whole.stages, names)

    # ------------------------------------------------------------ formulas

    def laid_off(self) -> Formula:
        return self.value("v").formula(self.whole.laid_off(), size=True)

    def input_speed(self) -> Formula:
        return self.members[self.found.input].formula("omega")

    @cached_property
    def speeds(self) -> tuple[list[Formula], list[Formula]]:
        """Of all the stages in their order: the first of each kind, and the others."""
        names = (name for names in self.whole.turned for name in names)
        return parted(self.members[name].formula("omega") for name in names)

    # ------------------------------------------------------------ what is given

    def given_table(self) -> Table:
        """Stages in the order of the power."""
        table = self.table("stages")
        heads = [self.t(text) for text in (N_("Stage"), N_("Kind"), N_("Members"), N_("Required ratio"))]
        rows = [
            [
                Cell(str(row + 1), table.ref("stage", row)),
                self.kind(stage),
                table["members"].values[row],
                self.page.value(self.whole.stages[row].u_required),
            ]
            for row, stage in enumerate(self.found.stages)
        ]
        return worded(self.t("Stages of the drive"), heads, rows, [8, 40, 30, 22])

    def kind(self, stage: Stage) -> Markup:
        match stage:
            case spur.Found():
                return self.t("internal pair") if stage.given.internal else self.t("external pair")
            case planetary.Found():
                text = self.t(SCHEMES[stage.scheme.name])
                return self.page.listed([text, self.t("differential")]) if stage.second else text
            case ordinary.Found():
                return self.t(TITLES[stage.given.variety])
            case _:
                assert_never(stage)

    def listed_stages(self) -> Markup:
        """The same in a sentence."""
        said = [
            self.t(
                "%(kind)s %(members)s, %(ratio)s",
                kind=self.kind(stage),
                members="-".join(member.name for member in stage.members),
                ratio=self.page.value(self.whole.stages[row].u_required),
            )
            for row, stage in enumerate(self.found.stages)
        ]
        return self.page.listed(said, "; ")

    @property
    def tolerance(self) -> Markup:
        return self.number("tolerance")

    def rpm(self, name: str) -> Markup:
        """The rotational speed of a member."""
        return self.page.shown(self.members[name]["n"])

    def second_inputs(self) -> Markup:
        """What is said of the second inputs of differentials."""
        text = N_("Member %(name)s is the second input of a differential; it makes %(n)s rpm.")
        names = [stage.second[0] for stage in self.found.stages if stage.second]
        return self.page.listed((self.t(text, name=name, n=self.rpm(name)) for name in names), " ")

    @property
    def carried(self) -> Markup | None:
        """The symbol of speeds about carriers; None without satellites."""
        any_carried = any(m.carried_by for m in self.found.train.members)
        return self.page.sym(self.speeds_of["omega_rel"].symbol()) if any_carried else None

    @property
    def by_worm(self) -> bool:
        return any(isinstance(one, ordinary.Found) and one.kind == "worm" for one in self.found.stages)

    @property
    def carried_over(self) -> bool:
        """Whether a belt brings a velocity to another pulley."""
        return any(mesh.apart for mesh in self.found.train.meshes)

    @property
    def readable(self) -> bool:
        """Whether the output turns, and its segment is long enough for a ratio."""
        return self.whole.readable

    def symbols(self) -> list[dict[str, Any]]:
        """What the formulas of the speeds are made of: the sentence explains the first two."""
        items = [
            ("drive:omega", "omega_i", self.t("angular velocity of member i"), "rad/s"),
            ("drive:n", "n_i", self.t("its rotational speed"), "rpm"),
            ("spur:z", "z_i", self.t("number of teeth of wheel i"), ""),
        ]
        return [
            {"id": key, "symbol": symbol, "meaning": meaning, "unit": unit}
            for key, symbol, meaning, unit in items
        ]

    # ------------------------------------------------------------ tables

    def _names(self, table: quantity.Table) -> Column:
        """The members of a table."""
        names = [
            self.page.word(name, table, "member", row) for row, name in enumerate(table["member"].values)
        ]
        return Column(self.t("Member"), names)

    def _of_members(self, key: str, names: Sequence[str]) -> Column:
        """Speeds of some of the members."""
        table, rows = self.speeds_of, [self.members[name].row for name in names]
        texts = self.page.col(table[key].number(row) for row in rows)
        cells = [Cell(text, table.ref(key, row)) for text, row in zip(texts, rows, strict=True)]
        return Column(self.page.head(table[key].symbol(), table[key].unit), cells)

    def speeds_table(self) -> Table:
        caption = self.t("Speeds of all the members of the drive")
        return numeric(caption, self._names(self.speeds_of), self._speeds())

    def members_table(self) -> Table:
        """The speeds, and behind them what loads the members from outside."""
        loads = self.table("loads")
        rows = {name: row for row, name in enumerate(loads["member"].values)}
        behind = [
            column._replace(
                cells=[
                    column.cells[rows[one.name]] if one.name in rows else DASH
                    for one in self.found.train.members
                ]
            )
            for column in (self.page.column(loads, key) for key in ("T", "N"))
        ]
        caption = self.t("Speeds of all the members of the drive, external torques and powers")
        return numeric(caption, self._names(self.speeds_of), [*self._speeds(), *behind])

    def _speeds(self) -> list[Column]:
        table, members = self.speeds_of, self.found.train.members
        teeth = [
            Cell(str(m.teeth), table.ref("z", row)) if m.teeth else DASH for row, m in enumerate(members)
        ]
        columns = [
            Column(self.page.head(table["z"].symbol()), teeth),
            self.page.column(table, "omega"),
            self.page.column(table, "n"),
        ]
        if carried := [m.name for m in members if m.carried_by]:
            some = self._of_members("omega_rel", carried)
            cells = iter(some.cells)
            columns.append(some._replace(cells=[next(cells) if m.carried_by else DASH for m in members]))
        return columns

    def comparison_table(self) -> Table:
        """Velocities of the points and angular velocities by the diagrams and by calculation."""
        table, page = self.table("comparison"), self.page
        heads = [
            self.t("Quantity"),
            self.t("By the diagrams"),
            self.t("By calculation"),
            page.head(table["delta"].symbol(), table["delta"].unit),
        ]
        rows = [
            [
                page.head(table["graph"].symbol(row), table["graph"].unit_of(row)),
                page.cell(table, "graph", row),
                page.cell(table, "analytic", row),
                page.cell(table, "delta", row, digits=3, places=2),
            ]
            for row in range(len(table))
        ]
        caption = self.t("Magnitudes of velocities and angular velocities by the diagrams and by calculation")
        return worded(caption, heads, rows, [25, 25, 25, 25])

    def loads_table(self) -> Table:
        """External torques and powers; a positive power is supplied."""
        table, page = self.table("loads"), self.page
        columns = [
            page.column(table, "T"),
            self._of_members("omega", table["member"].values),
            page.column(table, "N"),
        ]
        return numeric(self.t("External torques and powers"), self._names(table), columns)

    def meshes_table(self) -> Table:
        """Direction of the power in every mesh."""
        return power_flow(self.page, self.table("meshes"), self.t("Flow of the power through the meshes"))

    def teeth_table(self) -> Table:
        """Forces in the meshes by the mean and by the greatest balancing moment."""
        table, page = self.table("teeth"), self.page
        names = [page.word(name, table, "mesh", row) for row, name in enumerate(table["mesh"].values)]
        keys = ("F_t_mean", "F_r_mean", "F_t_greatest", "F_r_greatest")
        columns = [page.column(table, key) for key in keys]
        return numeric(self.t("Forces in the teeth of the drive"), Column(self.t("Mesh"), names), columns)

    @property
    def turns_link(self) -> bool:
        """Whether the torques are found for the balancing moment of the link that the drive turns."""
        return self.found.asked

    def friction(self) -> Markup | str:
        """What is said of the friction of the pairs beside the moments of the driving link."""
        moments = self.found.moments
        if moments is None or moments.friction is None:
            return ""
        if math.isnan(moments.friction):
            return self.t(
                N_(
                    "The friction of the kinematic pairs is left out: beside some position of the cycle the reactions "
                    "grow without bound, and it has no mean."
                )
            )
        text = N_("The friction of the kinematic pairs is included in both, %(moment)s on average.")
        if not moments.rubs:
            text = N_(
                "The friction of the kinematic pairs is included in neither, as the variant states; it is "
                "%(moment)s on average."
            )
        return self.t(text, moment=self.sized("M_fr"))

    # ------------------------------------------------------------ pictures

    @cached_property
    def beside(self) -> bool:
        """Whether the scheme stands beside the diagrams."""
        return beside(self.found.stages, self.found.plans, self.found.speed)

    @property
    def drawn(self) -> str:
        """The label of the figure of the diagrams."""
        return "fig:drive" if self.beside else "fig:drive:plans"

    @cached_property
    def scheme(self) -> Drawing:
        found = self.found
        return kinematic_scheme(found.stages, found.plans, found.speed, str(self.t(SCHEME)))

    @cached_property
    def diagrams(self) -> Drawing:
        found, title = self.found, str(self.t("Diagrams of linear and angular velocities"))
        return velocities(found.stages, found.plans, found.speed, title)

    def of_diagrams(self) -> Markup:
        """What they are called below them."""
        text = N_("Diagrams of linear and angular velocities: %(length)s, %(velocity)s, %(angular)s")
        if self.beside:
            text = N_(
                "Kinematic scheme of the drive, diagrams of linear and angular velocities: %(length)s, %(velocity)s, "
                "%(angular)s"
            )
        scales = {"length": "mu_l", "velocity": "mu_v", "angular": "mu_omega"}
        return self.t(text, **{name: self.sized(key) for name, key in scales.items()})

    def conclusions(self) -> list[Markup]:
        """What failed, first; then what was found."""
        power = [*self._of_power()]
        failed = [one for one in power if isinstance(one, Failed)]
        said = [one for one in power if not isinstance(one, Failed)]
        return [*self._failures(), *failed, self.page.listed([*self._found(), *said], " ")]

    def _failures(self) -> Iterator[Markup]:
        if self.found.locks:
            yield Failed(self.t("The drive is self-locking: it cannot be driven from the input shaft."))
        if not self.found.within:
            text = N_(
                "The ratio of the gear drive deviates from the required one by %(deviation)s %%, which is more than "
                "the allowed %(tolerance)s %%."
            )
            deviation = self.number("delta_u", size=True, digits=3)
            yield Failed(self.t(text, deviation=deviation, tolerance=self.tolerance))

    def _found(self) -> Iterator[Markup]:
        if not self._one_planetary:  # else its stage says so
            text = N_(
                "The ratio of the gear drive is %(ratio)s; its deviation from the required one is %(deviation)s %%."
            )
            if self.page.nothing(self.value("delta_u")):
                text = N_("The ratio of the gear drive is %(ratio)s, as required.")
            yield self.t(text, ratio=self.sized("u_teeth"), deviation=self.number("delta_u", digits=3))
            if not self.found.locks:
                yield self.t("The efficiency of the gear drive is %(eta)s.", eta=self.number("eta"))
        if self.readable:
            text = N_(
                "By the diagram of angular velocities the ratio differs from the calculated one by %(error)s %%."
            )
            yield self.t(text, error=self.number("error", size=True, digits=3))

    @property
    def _one_planetary(self) -> bool:
        return len(self.found.stages) == 1 and isinstance(self.found.stages[0], planetary.Found)

    def _of_power(self) -> Iterator[Markup]:
        """What failed is a conclusion of its own."""
        if self.power_view is not None:
            yield from self.power_view.conclusions()
