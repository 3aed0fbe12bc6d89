"""View of a drive from the machine back to the motor: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from markupsafe import Markup

from tmm_report.chapters.gears.drive.power.quantities import VERDICTS
from tmm_report.chapters.gears.drive.power.steps import Steps
from tmm_report.problems import N_
from tmm_report.quantity import model as quantity
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.sheet import Row
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded
from tmm_report.report.part import Failed

MACHINE = ("force", "v_out", "D_out", "z_out", "t_out")
PARTS = {
    "stage": N_("stage %(wheels)s"),
    "bearings": N_("pairs of bearings"),
    "coupling": N_("couplings"),
    "machine": N_("working member of the machine"),
}
RULES = {
    "equal": N_("It is divided equally among the stages without a stated one:"),
    "slow": N_("It is divided so that the slow stage has %(factor)s of its square root:"),
    "fast": N_("It is divided so that the fast stage has %(factor)s of its square root:"),
    "step": N_("It is divided so that each stage has %(factor)s times the ratio of the next:"),
}


class PowerView(ChapterView):
    """`stages`: the drive's rows of its stages; `names`: the driving and driven member of each."""

    def __init__(
        self, steps: Steps, page: Page, tables: Sequence[quantity.Table], label: str, stages: Sequence[Row],
        names: Sequence[tuple[str, str]],
    ):  # fmt: skip
        super().__init__(page, steps.s, tables, f"{label}_")
        self.steps, self.power, self.plan = steps, steps.found, steps.found.plan
        self.stages, self.names = stages, names

    # ------------------------------------------------------------ what is given

    def machine(self) -> Markup:
        """Load and speed of the machine, as they are stated."""
        keys = list(MACHINE) if "force" in self.s or "v_out" in self.s else []
        keys += [
            key
            for key in ("T_out", "P_out", "n_out", "eta_out")
            if key in self.s and not self.s.has_formula(key)
        ]
        return self.listed([key for key in keys if key in self.s])

    def meant(self) -> list[dict[str, object]]:
        """What the given values are."""
        keys = [
            *MACHINE,
            *(key for key in ("T_out", "P_out", "n_out", "eta_out") if not self.s.has_formula(key)),
        ]
        stated = [self.value(key).quantity for key in keys if key in self.s]
        # known by their letters, so that the formulas that follow do not explain them again
        return [
            {"symbol": one.sign, "id": one.sign, "unit": one.printed, "message": one.meaning}
            for one in stated
        ]

    @property
    def rule(self) -> Markup:
        """How the ratio is divided; of one stage nothing is."""
        if self.plan.shares is not None and len(self.plan.shares) == 1:
            return self.t("It falls to the one stage without a stated one:")
        split = self.power.given.split
        key = "equal" if split is None else "slow" if split.slow else "fast" if split.fast else "step"
        return self.t(RULES[key], factor=self.number("factor")) if split else self.t(RULES[key])

    # ------------------------------------------------------------ formulas

    def needed(self) -> list[Formula]:
        return self.formulas("n_out", "omega_out", "T_out", "P_out")

    def divided(self) -> list[Formula]:
        """The ratios of the stages that had none."""
        rows = [self.stages[k] for k in self._order()]
        return [row.formula("u_required", digits=5) for row in rows if row.has_formula("u_required")]

    def _order(self) -> list[int]:
        """The stages that had no ratio, in the order in which one follows from another."""
        shares = list(self.plan.shares or {})
        split = self.power.given.split
        return shares[::-1] if len(shares) == 2 and split is not None and split.slow is not None else shares

    def roots(self) -> Markup:
        """The ratios of three stages and more, which are roots of a higher degree."""
        rows = [self.stages[k] for k in self._order()]
        return self.page.listed(
            self.page.value(row["u_required"].var()) for row in rows if not row.has_formula("u_required")
        )

    def teeth(self) -> list[Formula]:
        return [row.formula("z_exact") for row in self.steps.sought.values() if row.has_formula("z_exact")]

    def rounded(self) -> Markup:
        """z2 = 84, z4 = 72."""
        return self.page.values(row.z for row in self.steps.sought.values() if row.has_formula("z_exact"))

    def stated_teeth(self) -> Markup:
        return self.page.values(row.z for row in self.steps.sought.values() if not row.has_formula("z_exact"))

    def shaft_formulas(self, shaft: int) -> list[Formula]:
        row = self.steps.shafts[shaft]
        return [row.formula(key) for key in ("P", "n", "omega", "T")]

    def reached(self) -> list[Formula]:
        told = self.formulas("v_actual")
        return [*told, self.formula("delta_n")] if self.knows("delta_n") else told

    # ------------------------------------------------------------ tables

    def motors_table(self) -> Table:
        """Every motor of the list, with the reason why it is taken or not."""
        table, page = self.table("motors"), self.page
        heads = [
            self.t("Motor"),
            *(page.head(table[key].symbol(), table[key].quantity.printed) for key in ("P", "n", "u", "load")),
        ]
        rows = [
            [
                page.word(name, table, "motor", row),
                *(page.cell(table, key, row, digits=4) for key in ("P", "n", "u", "load")),
                page.word(self.t(VERDICTS[table["verdict"].values[row]]), table, "verdict", row),
            ]
            for row, name in enumerate(table["motor"].values)
        ]
        return worded(
            self.t("Motors to choose from"), [*heads, self.t("Verdict")], rows, [18, 12, 14, 14, 14, 28]
        )

    def losses_table(self) -> Table:
        """What loses power, with efficiencies and numbers."""
        table, page = self.table("losses"), self.page
        rows = [
            [
                page.word(self._part(row), table, "part", row),
                page.cell(table, "eta", row, digits=4),
                Cell(str(table["count"].values[row]), table.ref("count", row)),
            ]
            for row in range(len(table))
        ]
        heads = [self.t("Part"), page.head(table["eta"].symbol()), self.t("Number")]
        return worded(self.t("Efficiencies of the parts of the drive"), heads, rows, [50, 25, 25])

    def _part(self, row: int) -> Markup:
        table = self.table("losses")
        text = PARTS[table["part"].values[row]]
        return self.t(text, wheels=table["wheels"].values[row]) if "%(" in text else self.t(text)

    def shafts_table(self) -> Table:
        """Power, speed and torque of every shaft in the order of the power."""
        table, page = self.table("shafts"), self.page
        numbers = [
            Cell(str(shaft), table.ref("shaft", row)) for row, shaft in enumerate(table["shaft"].values)
        ]
        words = [page.word(self.by(shaft), table, "by", shaft) for shaft in range(len(table))]
        columns = [
            Column(self.t("Driven by"), words),
            *(page.column(table, key) for key in ("P", "n", "omega", "T")),
        ]
        return numeric(
            self.t("Powers, speeds and torques of the shafts"), Column(self.t("Shaft"), numbers), columns
        )

    def by(self, shaft: int) -> Markup:
        """What brings the power to a shaft."""
        if not shaft:
            return self.t("motor")
        link = self.plan.links[shaft - 1]
        return (
            self.t("coupling")
            if link.kind == "coupling"
            else self.t("stage %(wheels)s", wheels="–".join(self.names[link.stage]))
        )

    def loaded_table(self) -> Table:
        table, page = self.table("mesh_loads"), self.page
        names = [page.word(name, table, "mesh", row) for row, name in enumerate(table["mesh"].values)]
        columns = [page.column(table, key) for key in ("F_t", "F_r")]
        return numeric(
            self.t("Forces in the teeth by the torques of the shafts"), Column(self.t("Mesh"), names), columns
        )

    # ------------------------------------------------------------ what is said

    @property
    def chosen(self) -> Markup:
        """The name of the motor, marked where it stands in a table."""
        assert self.power.motor is not None and self.plan.chosen is not None
        if not self.has("motors"):
            return self.page.text(self.power.motor.name)
        return self.page.said(
            Cell(self.power.motor.name, self.table("motors").ref("motor", self.plan.chosen))
        )

    def conclusions(self) -> Iterator[Markup]:
        s = self.s
        if "load_factor" in s:
            text = N_("The machine needs %(needed)s from the motor; the motor %(name)s has %(own)s.")
            if self.power.overloaded:
                text = N_(
                    "The machine needs %(needed)s from the motor, and the motor %(name)s has only %(own)s."
                )
            said = self.t(text, needed=self.sized("P_req"), name=self.chosen, own=self.sized("P_motor"))
            yield Failed(said) if self.power.overloaded else said
        elif "P_req" in s:
            yield self.t("The machine needs %(needed)s from the motor.", needed=self.sized("P_req"))
        elif "P_allowed" in s:
            text = N_("The motor allows a useful power of the machine of %(power)s.")
            yield self.t(text, power=self.sized("P_allowed"))
        if "delta_n" in s:
            text = N_(
                "With the teeth chosen the speed of the machine deviates from the wanted one by %(deviation)s %%."
            )
            yield self.t(text, deviation=self.number("delta_n"))
