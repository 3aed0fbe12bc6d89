"""View of the machine in motion: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.moving import friction_told
from tmm_report.chapters.machine.dynamics import draw
from tmm_report.chapters.machine.dynamics import quantities as q
from tmm_report.chapters.machine.dynamics.equations import Written
from tmm_report.chapters.machine.dynamics.joined import COAST, SETTLED
from tmm_report.chapters.machine.dynamics.plant import BRAKE, MOTOR, PAIRS
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.machine.reduced import LOST
from tmm_report.problems import N_
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.text import roman
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded
from tmm_report.report.part import Part

WAYS = {
    "speed": N_(
        "The moment of inertia is constant and the moments depend on the speed alone, so the variables part and "
        "the time and the angle are integrals over the speed, taken by Gaussian quadrature."
    ),
    "angle": N_(
        "All moments depend on the angle alone, so the speed follows from the energy integral, and the time from "
        "the integral of its reciprocal, taken by Gaussian quadrature."
    ),
    "time": N_(
        "The moments depend on the angle and on the speed, or on the time, so the equation is integrated numerically: "
        "from rest and to rest by the method LSODA with the relative tolerance 10⁻⁹, whole cycles between them by "
        "collocation at Gauss points."
    ),
}
MOTORS = {
    "constant": N_("The moment of the motor is constant."),
    "shunt": N_("The motor is a shunt one: its moment falls along a straight line."),
    "series": N_(
        "The motor is series-wound: without saturation its moment falls with the square of the speed, M = a/(ω + b)²."
    ),
    "induction": N_("The motor is an induction one; its moment follows from the slip by Kloss's formula."),
    "by_speed": N_(
        "The moment of the motor is given by points over the speed, with straight lines between them."
    ),
    "by_angle": N_(
        "The moment of the motor is given by points over the angle, with straight lines between them."
    ),
    "by_time": N_(
        "The moment of the motor is given by points over the time, with straight lines between them."
    ),
}

CONSTANTS = (
    "M_closing", "i_motor", "eta_motor", "M_motor", "M_stall", "omega_0", "a", "b", "M_max", "s_cr",
)  # fmt: skip


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/dynamics", DynamicsView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The start-up, or what else is found, at a glance."""
    return draw.glance(found, page)


class DynamicsView(ChapterView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, q.tables(found))
        self.found, self.position = found, _sample(found)
        self.written = Written(found, self.position)

    # ------------------------------------------------------------ words

    @property
    def waited(self) -> Markup:
        """When the machine starts, s."""
        return self.page.shown(self.table("start"), "t", 0)

    def way(self, name: str) -> Markup:
        return self.t(WAYS[dict(self.found.runs)[name].way])

    @property
    def motor_kind(self) -> Markup:
        assert self.found.given.motor is not None  # asked for only where there is one
        return self.t(MOTORS[self.found.given.motor.kind])

    @property
    def braking(self) -> bool:
        """Whether the motor is driven by the load in the steady motion."""
        driving = self.found.steady.works.get(MOTOR) if self.found.steady else None
        return driving is not None and driving < 0

    @property
    def run_down(self) -> Markup:
        """How the machine comes to rest."""
        coast = self.found.given.coast
        assert coast is not None  # asked for only where there is one
        if coast.motor == "reversed":
            return self.t("The supply of the motor is reversed, so that it brakes the machine.")
        if coast.motor == "on":
            return self.t("The motor stays on.")
        if coast.brake:
            return self.t("The motor is switched off and the brake of the main shaft applied.")
        return self.t("The motor is switched off.")

    def by_itself(self) -> Markup:
        """Why a run-down does not follow upon the other regimes; nothing where it does, or there are none."""
        found, coast = self.found, self.found.given.coast
        begin = coast.begin if coast else None
        follows = found.joined is not None and any(one.name == COAST for one in found.joined.stretches)
        if begin is None or follows or (found.steady is None and found.start is None):
            return Markup("")
        text = N_(
            "It begins at the stated %(begin)s rad/s, at which the machine is neither in the steady motion nor at the "
            "end of the start-up, so that it follows upon no other regime and stands by itself."
        )
        return self.t(text, begin=self.page.num(begin, 5))

    def reached(self, key: str) -> Markup:
        """The angle at which a value is reached, degrees."""
        of = self.value(key)
        degrees = float(np.degrees(of.at or 0.0))
        return self.page.said(Cell(self.page.num(degrees, 5), Ref(of.key, by="at_deg")))

    @property
    def constants(self) -> list[str]:
        """Of the motor and of the resistances, as they enter the formulas."""
        rubbing = [
            f"{key}_res{k}"
            for k in range(1, len(self.found.given.resistances) + 1)
            for key in ("M", "c", "omega")
        ]
        return [key for key in (*CONSTANTS, *rubbing, "M_brake") if key in self.s]

    def of_parts(self) -> list[dict[str, Any]]:
        """The columns of the parts, for a "where" list: their numbers differ by the index of the part."""
        table = self.table("parts")
        keys = ["J", "i", "m", "r", "M", "F", "eta"]
        return [
            self.page.explained(f"part {key}", table[key], table[key].unit) for key in keys if self._has(key)
        ]

    def friction(self) -> Markup | None:
        """What is said of the friction of the pairs; None where none is stated."""
        text = friction_told(self.found.whole.machine)
        named = {
            name: key for name, key in (("power", "P_fr"), ("share", "P_fr_share")) if f"%({name})s" in text
        }
        return self.t(text, **{name: self.number(key) for name, key in named.items()}) if text else None

    def following(self) -> Markup:
        """How the regimes follow one another."""
        joined = self.found.joined
        assert joined is not None  # asked for only where there is one
        names = [one.name for one in joined.stretches]
        said = []
        if "settling" in names:
            text = N_(
                "After the start-up the machine is driven on until its speed is within %(within)s %% of the steady one."
            )
            varying = N_(
                "After the start-up the machine is driven on until its speed is within %(within)s %% of the steady one "
                "at the same position, and to the end of that cycle."
            )
            even = self.found.even
            said.append(self.t(text if even else varying, within=self.page.num(100 * SETTLED)))
        if self.found.even and "steady" in names:
            text = N_("For %(t)s s it then moves steadily.")
            said.append(self.t(text, t=self.page.shown(self.table("regimes"), "t", names.index("steady"))))
        elif "steady" in names:
            text = N_("Of the steady motion %(n)s cycles are taken.")
            said.append(self.t(text, n=self.number("cycles")))
        if "coast" in names:
            said.append(self.t(N_("The run-down begins at the speed that the machine then has.")))
        return self.page.listed(said, " ")

    def joined_caption(self) -> Markup:
        """With the numbers of the regimes."""
        table = self.table("regimes")
        told = {
            "start": N_("start-up"),
            "settling": N_("transition to the steady motion"),
            "steady": N_("steady motion"),
            "coast": N_("run-down"),
        }
        names = [
            self.page.listed([roman(k), self.t(told[key])], " – ")
            for k, key in enumerate(table["regime"].values[:-1], 1)
        ]
        return self.t(N_("Tachogram of the machine: %(regimes)s"), regimes=self.page.listed(names))

    # ------------------------------------------------------------ tables

    def parts_table(self) -> Table:
        table, page = self.table("parts"), self.page
        names = [page.word(text, table, "part", row) for row, text in enumerate(table["part"].values)]
        keys = ["i", "eta", *(key for key in ("J", "M", "m", "r", "F") if self._has(key)), "J_red", "M_red"]
        heads = [self.t("Part"), *(page.head(table[key].symbol(), table[key].unit) for key in keys)]
        rows = [[names[row], *(page.cell(table, key, row) for key in keys)] for row in range(len(table))]
        return worded(
            self.t("Parts of the machine reduced to the main shaft"), heads, rows, (6, *(2 for _ in keys))
        )

    def _has(self, key: str) -> bool:
        return any(one == one and one for one in self.table("parts")[key].values)

    def characteristics(self) -> Table:
        """Every sixth row."""
        table = self.table("characteristics")
        columns = [self._every(table, column.key, 6) for column in table.columns]
        return numeric(self.t("Characteristics of the motor and of the resistances"), columns[0], columns[1:])

    def _every(self, table: Any, key: str, step: int) -> Column:
        whole = self.page.column(table, key)
        return Column(whole.head, whole.cells[::step])

    def cycle_table(self) -> Table:
        table = self.table("cycle_table")
        columns = self.columns("cycle_table", leave=("position", "phi"))
        return numeric(self.t("Steady motion"), self.page.positions(table), columns)

    def run_table(self, name: str, caption: Any) -> Table:
        return self.numeric(caption, name)

    def works(self) -> Table:
        table, page = self.table("works"), self.page
        keys = [column.key for column in table.columns[1:]]
        heads = {
            "A_start": self.t("Start-up, %(unit)s", unit=page.unit("J")),
            "A_steady": self.t("Cycle of the steady motion, %(unit)s", unit=page.unit("J")),
            "A_coast": self.t("Run-down, %(unit)s", unit=page.unit("J")),
        }
        rows = []
        for row, key in enumerate(table["acting"].values):
            cells = [self._work(table, of, row) for of in keys]
            rows.append([page.word(self.acting(key), table, "acting", row), *cells])
        shares = (5, *(2 for _ in keys))
        return worded(
            self.t("Balance of works"), [self.t("What acts"), *(heads[key] for key in keys)], rows, shares
        )

    def _work(self, table: Any, key: str, row: int) -> Cell:
        largest = max(abs(one) for one in table[key].values if one == one)
        return self.page.cell(table, key, row, scale=largest or 1.0)

    def acting(self, key: str) -> Markup:
        """What acts, in words."""
        fixed = {
            MOTOR: N_("motor"),
            BRAKE: N_("brake"),
            PAIRS: N_("friction in the kinematic pairs"),
            LOST: N_("more losses in the gears by the acceleration"),
            "sum": N_("sum"),
            "gained": N_("change of the kinetic energy"),
        }
        if key in fixed:
            return self.t(fixed[key])
        given, of = self.found.given, self.found.whole.machine
        for load, _ in of.moments if of else ():
            if load.key == key:
                return self.page.message(load.meaning)
        kind, index = key.rstrip("0123456789"), int(key[len(key.rstrip("0123456789")) :]) - 1
        if kind == "weight":
            return self.t(N_("weight: %(name)s"), name=given.parts[index].name)
        if kind == "part":
            return self.t(N_("resistance: %(name)s"), name=given.parts[index].name)
        if kind == "spring":
            return self.t(N_("spring %(number)s"), number=index + 1)
        if kind == "torsion":
            return self.t(N_("torsion spring %(number)s"), number=index + 1)
        name = given.resistances[index].name
        return (
            self.t(N_("resistance: %(name)s"), name=name)
            if name
            else self.t(N_("resistance of the main shaft"))
        )

    def regimes(self) -> Table:
        """A column for each regime, numbered as on the chart, and one for all together."""
        table, page = self.table("regimes"), self.page
        heads = {
            "start": self.t("Start-up"),
            "settling": self.t("Transition"),
            "steady": self.t("Steady motion"),
            "coast": self.t("Run-down"),
        }
        names = [
            page.listed([f"{roman(k)}.", heads[key]], " ") if key in heads else self.t("In all")
            for k, key in enumerate(table["regime"].values, 1)
        ]
        rows = []
        for column in table.columns[1:]:
            if column.key == "phi":
                continue  # told in turns
            size = float(np.abs(column.numbers()).max()) or 1.0
            cells = [page.cell(table, column.key, k, scale=size) for k in range(len(table))]
            noun = page.listed([page.message(column.meaning), page.head(column.symbol(), column.unit)])
            rows.append([noun, *cells])
        heading, shares = [self.t("Quantity"), *names], (6, *(3 for _ in names))
        return worded(self.t("Regimes of the machine one after another"), heading, rows, shares)

    def of_all(self, key: str) -> Markup:
        """A number of all regimes together, in running text."""
        table = self.table("regimes")
        return self.page.shown(table, key, len(table) - 1)

    # ------------------------------------------------------------ drawings

    def characteristics_graph(self) -> Graph:
        return draw.characteristics(self.found, self.page)

    def cycle_graph(self) -> Graph:
        return draw.cycle(self.found, self.page)

    def run_graph(self, name: str) -> Graph:
        return draw.run(self.found, name, self.page)

    def joined_graph(self) -> Graph:
        return draw.joined(self.found, self.page)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        lines = []
        if self.found.start is not None:
            text = N_(
                "The start-up of the machine takes %(t)s s, in which the main shaft turns %(turns)s times."
            )
            lines.append(self.t(text, t=self.number("t_start"), turns=self.number("turns_start")))
        if self.found.steady is not None and not self.found.even:
            text = N_(
                "In steady motion the mean angular velocity of the main shaft is %(omega)s rad/s, and the "
                "coefficient of speed fluctuation is %(delta)s."
            )
            omega, delta = self.number("omega_m"), self.number("delta")
            lines.append(self.t(text, omega=omega, delta=delta))
        if self.found.uniformly:
            text = N_(
                "Under its constant moments the main shaft has the angular acceleration %(epsilon)s rad/s²."
            )
            lines.append(self.t(text, epsilon=self.number("epsilon")))
        if self.found.coast is not None:
            text = N_("The run-down of the machine takes %(t)s s.")
            lines.append(self.t(text, t=self.number("t_coast")))
        joined = self.found.joined
        if joined is not None and {"start", "coast"} <= {one.name for one in joined.stretches}:
            text = N_(
                "From the start to the end of the run-down the main shaft turns %(turns)s times in %(t)s s."
            )
            lines.append(self.t(text, turns=self.of_all("turns"), t=self.of_all("t")))
        return lines


def _sample(found: Found) -> int:
    """The position that is written out: of the force plan where there is one, else the second."""
    positions = found.moving.kinematics.positions if found.moving else None
    asked = (*positions.force_plan, *positions.plans) if positions else ()
    return asked[0] if asked else 1
