"""View of a compound gear train."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property, reduce
from operator import mul
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.train.draw.diagrams import diagrams
from tmm_report.chapters.gears.train.draw.scheme import scheme
from tmm_report.chapters.gears.train.given import LOADS
from tmm_report.chapters.gears.train.quantities import tables
from tmm_report.chapters.gears.train.solve.mistakes import known_names
from tmm_report.chapters.gears.train.solve.train import Found
from tmm_report.chapters.gears.train.steps import whole
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.gears.compound.rows import Row, row_ratio
from tmm_report.mechanics.gears.compound.search import Reason
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import PI, Expr, Formula, Var, sin
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.paper.layout import Cell, worded
from tmm_report.report.part import Failed, Part

SCHEME = N_("Kinematic scheme of the gear train")
SHOWN = 10  # solutions of the search
KINDS = {"external": N_("external"), "internal": N_("internal"), "bevel": N_("bevel")}
REASONS = {
    Reason.ACCEPTED: N_("all conditions are met"),
    Reason.COAXIALITY: N_("coaxiality, or teeth out of range"),
    Reason.RATIO: N_("the ratio is missed"),
    Reason.INTERFERENCE: N_("interference in an internal mesh"),
    Reason.ASSEMBLY: N_("the satellites cannot be put in"),
    Reason.NEIGHBOURHOOD: N_("neighbouring satellites touch"),
}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("gears/train", TrainView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The scheme at a glance, for a list of many."""
    return scheme(found, str(page.t(SCHEME)))


class TrainView(ChapterView):
    own = True

    def __init__(self, found: Found, page: Page):
        self.found, self.made = found, whole(found)
        super().__init__(page, self.made.s, tables(found))

    # ------------------------------------------------------------ what is given

    def names(self, names: Sequence[str]) -> Markup:
        return self.page.listed(names)

    @property
    def title(self) -> str:
        return self.found.given.name or ""

    def given_table(self) -> layout.Table:
        """Wheels and carriers: teeth, axis, what they turn with."""
        table = self.table("speeds")
        heads = [self.t("Member"), self.page.head(table["z"].symbol()), self.t("Axis"), self.t("Turns with")]
        rows = []
        for row, m in enumerate(self.found.train.members):
            teeth: Any = Cell(str(m.teeth), table.ref("z", row)) if m.teeth else "—"
            axis = self.t("on carrier %(name)s", name=m.carried_by) if m.carried_by else self.t("fixed")
            alike = self.page.word(self.made.joined(m.name) or "—", table, "with", row)
            rows.append([self.page.word(m.name, table, "member", row), teeth, axis, alike])
        return worded(self.t("Members of the gear train"), heads, rows, [14, 14, 30, 30])

    def meshes(self) -> Markup:
        """1–2 (external), 2–3 (internal)."""
        pairs = [(f"{pair.i}–{pair.j}", self.t(KINDS[pair.kind])) for pair in self.found.given.meshes]
        return self.page.listed(self.t("%(mesh)s (%(kind)s)", mesh=mesh, kind=kind) for mesh, kind in pairs)

    def rpm(self, name: str) -> Markup:
        return self.page.value(self.made.members[name]["n"].var())

    @property
    def stated(self) -> list[str]:
        """Members whose speeds are known besides those that are held and the wheels of a car."""
        given = self.found.given
        road = given.output if given.road else ()
        return [n for n in known_names(given) if n not in given.fixed and n not in road]

    def known(self) -> Markup:
        return self.page.listed(self.rpm(name) for name in self.stated)

    @property
    def loaded(self) -> bool:
        """Whether a load is stated."""
        return any(getattr(self.found.given, key) is not None for key in LOADS)

    # ------------------------------------------------------------ the search

    def ranges(self) -> Markup:
        given = self.found.given
        return self.page.listed(
            self.t(
                "%(symbol)s from %(low)s to %(high)s",
                symbol=self.page.sym(Symbol("z", name)),
                low=one.low,
                high=one.high,
            )
            for name, one in given.wheels.items()
            if not one.stated
        )

    def rejected(self) -> layout.Table:
        table = self.table("rejected")
        rows: list[list[Any]] = [
            [
                self.page.word(self.t(REASONS[Reason[name.upper()]]), table, "reason", row),
                Cell(str(int(table["count"].values[row])), table.ref("count", row)),
            ]
            for row, name in enumerate(table["reason"].values)
        ]
        total = self.value("combinations")
        rows.append([self.t("in all"), Cell(str(int(total.value)), total.ref())])
        caption = self.t("Sets of teeth by the first condition that fails")
        return worded(caption, [self.t("Condition"), self.t("Sets")], rows, (4, 1))

    def solutions(self) -> layout.Table:
        table, page = self.table("solutions"), self.page
        whole_ = [c.key for c in table.columns if c.key == "place" or c.key.startswith("z_") or c.key == "k"]
        rows = [
            [
                *(Cell(str(int(table[key].values[row])), table.ref(key, row)) for key in whole_),
                page.cell(table, "u", row),
                page.cell(table, "delta_u", row, places=2),
                page.cell(table, "D", row, digits=4),
            ]
            for row in range(min(SHOWN, len(table)))
        ]
        heads = [self.t("No."), *(page.head(table[key].symbol()) for key in whole_[1:])]
        heads += [
            page.head(table["u"].symbol()),
            page.head(table["delta_u"].symbol(), "%"),
            page.head(table["D"].symbol()),
        ]
        caption = self.t(
            "The best sets of teeth; D is the diameter that the train fills, in modules of the first wheel"
        )
        return worded(caption, heads, rows, [1] * len(heads))

    # ------------------------------------------------------------ conditions

    def distances(self) -> layout.Table:
        table, page = self.table("distances"), self.page
        rows = [
            [
                page.word(table["mesh"].values[row], table, "mesh", row),
                page.cell(table, "a", row),
                page.word(table["other"].values[row], table, "other", row),
                page.cell(table, "a_other", row),
                page.cell(table, "gap", row, digits=4),
            ]
            for row in range(len(table))
        ]
        millimetres = page.head(Symbol("a"), "mm")
        heads = [
            self.t("Mesh"),
            millimetres,
            self.t("Mesh"),
            millimetres,
            self.t("Difference of the sums of teeth"),
        ]
        return worded(self.t("Coaxiality"), heads, rows, (2, 2, 2, 2, 3))

    def distance_formulas(self) -> list[Definition]:
        """m (z_1 + z_2)/2 of each mesh that the condition names, in symbols."""
        found, done = [], set()
        for one in self.found.conditions.coaxial:
            for k in (one.pair.first, one.pair.other):
                if k not in done:
                    done.add(k)
                    mesh = self.found.train.meshes[k]
                    i, j = (Var(Symbol("z", name), 1.0) for name in (mesh.i, mesh.j))
                    total: Expr = j - i if mesh.internal else i + j
                    found.append(Definition(Symbol("a", f"{mesh.i},{mesh.j}"), Var("m", 1.0) * total / 2))
        return found

    def assembly(self) -> layout.Table:
        table, page = self.table("assembly"), self.page
        rows = [
            [
                page.word(table["row"].values[row], table, "row", row),
                Cell(str(int(table["k"].values[row])), table.ref("k", row)),
                page.cell(table, "C", row),
                self.t("whole") if one.met else self.t("not whole"),
            ]
            for row, one in enumerate(self.found.conditions.assembly)
        ]
        heads = [self.t("Row"), page.head(table["k"].symbol()), page.head(Symbol("C")), self.t("Number")]
        return worded(self.t("Condition of assembly"), heads, rows, (2, 1, 2, 2))

    def neighbours(self) -> layout.Table:
        table, page = self.table("neighbours"), self.page
        rows = [
            [
                page.word(table["satellite"].values[row], table, "satellite", row),
                Cell(str(int(table["k"].values[row])), table.ref("k", row)),
                page.cell(table, "gap", row),
                self.t("free") if one.met else self.t("they touch"),
            ]
            for row, one in enumerate(self.found.conditions.neighbours)
        ]
        heads = [
            self.t("Satellites"),
            page.head(table["k"].symbol()),
            page.head(Symbol("Delta"), "mm"),
            self.t("Neighbours"),
        ]
        return worded(self.t("Condition of neighbourhood"), heads, rows, (2, 1, 2, 2))

    def assembly_formula(self) -> Definition:
        """C of the first row."""
        row = self.found.conditions.assembly[0].row
        sign = 1 if float(row_ratio(self.found.train, row)) > 0 else -1
        above, below = (
            self._all([end[k] for end in ((link.i, link.j) for link in row.links)]) for k in (0, 1)
        )
        number = below - above if sign > 0 else below + above
        return Definition(Symbol("C"), abs(number) / (Var("k", 1.0) * Var("D", 1.0)))

    def _all(self, names: Sequence[str]) -> Expr:
        return reduce(mul, (Var(Symbol("z", name), 1.0) for name in names))

    def gap_formula(self) -> Definition:
        """2 a_w sin(π/k) − m (z + 2)."""
        turned = sin(PI / Var("k", 1.0))
        tip = Var("m", 1.0) * (Var("z", 1.0) + 2)
        return Definition(Symbol("Delta"), 2 * Var("a_w", 1.0) * turned - tip)

    @property
    def coaxial(self) -> bool:
        return all(one.met for one in self.found.conditions.coaxial)

    @property
    def module_stated(self) -> bool:
        return self.found.given.module is not None or bool(self.found.given.modules)

    @property
    def possible(self) -> list[int]:
        return list(self.found.conditions.possible())

    # ------------------------------------------------------------ speeds

    def willis(self) -> list[Definition]:
        """The definition of the ratio of every row."""
        return [self._willis(row) for row in self.made.turned]

    def _willis(self, row: Row) -> Definition:
        one, other = (Var(Symbol("omega", name), 1.0) for name in self.made.ends_of(row))
        above: Expr = one
        below: Expr = other
        if carrier := self.made.carrier_of(row):
            moving = Var(Symbol("omega", carrier), 1.0)
            above, below = one - moving, other - moving
        return Definition(self.made.symbol_of(row), above / below)

    def rows(self) -> list[Formula]:
        return [row.formula("u") for row in self.made.rows.values()]

    def ratios(self) -> list[Formula]:
        found = [ratio.formula("u", digits=7) for ratio in self.made.ratios.values()]
        return [*found, *([self.formula("u", digits=7)] if self.s.has_formula("u") else [])]

    def speeds(self) -> list[Formula]:
        """In the order in which they are found."""
        return [
            self.made.members[name].formula(
                "omega" if self.made.members[name].has_formula("omega") else "omega_rel"
            )
            for name in self.made.order
        ]

    def speeds_table(self) -> layout.Table:
        table, page = self.table("speeds"), self.page
        carried = any(m.carried_by for m in self.found.train.members)
        keys = ["omega", "n", *(["omega_rel", "n_rel"] if carried else [])]
        rows = [
            [
                page.word(m.name, table, "member", row),
                *(page.cell(table, key, row) if key in self.made.members[m.name] else "—" for key in keys),
            ]
            for row, m in enumerate(self.found.train.members)
        ]
        plain = {
            "omega": Symbol("omega"),
            "n": Symbol("n"),
            "omega_rel": Symbol("omega", "", "(H)"),
            "n_rel": Symbol("n", "", "(H)"),
        }
        heads = [self.t("Member"), *(page.head(plain[key], table[key].unit) for key in keys)]
        return worded(self.t("Speeds of all the members of the train"), heads, rows, [2, *[2] * len(keys)])

    @property
    def tilted(self) -> list[str]:
        return [m.name for m in self.found.train.members if self.found.built.tilted(m.name)]

    def symbols(self) -> list[dict[str, Any]]:
        items = [
            (
                "train:u",
                "u_ik",
                self.t(
                    "ratio of the speeds of members i and k; above, in brackets, the carrier that is stopped"
                ),
                "",
            ),
            ("train:omega", "omega_i", self.t("angular velocity of member i"), "rad/s"),
            ("train:n", "n_i", self.t("its frequency of rotation"), "rpm"),
            ("train:z", "z_i", self.t("number of teeth of wheel i"), ""),
        ]
        return [{"id": key, "symbol": s, "meaning": meaning, "unit": unit} for key, s, meaning, unit in items]

    def cases_table(self) -> layout.Table:
        table, page = self.table("cases"), self.page
        rows = [
            [
                Cell(str(int(table["case"].values[row])), table.ref("case", row)),
                page.word(name, table, "member", row),
                page.cell(table, "omega", row),
                page.cell(table, "n", row),
            ]
            for row, name in enumerate(table["member"].values)
        ]
        heads = [
            self.t("Motion"),
            self.t("Member"),
            page.head(Symbol("omega"), "rad/s"),
            page.head(Symbol("n"), "rpm"),
        ]
        return worded(self.t("Speeds in the other motions"), heads, rows, (1, 1, 2, 2))

    def cases(self) -> list[Markup]:
        """What is known of each."""
        return [
            self.page.listed(self.page.value(self._case(number, name)) for name in case)
            for number, case in enumerate(self.found.given.cases, 1)
        ]

    def _case(self, number: int, name: str) -> Var:
        body = self.found.built.body(name)
        row = next(row for k, member, row in self.made.cases if k == number and member == body)
        return row["n"].var()

    # ------------------------------------------------------------ torques

    def loss_rows(self) -> list[Formula]:
        return [row.formula("u_loss") for row in self.made.rows.values()]

    def torque_formulas(self) -> list[Formula]:
        return (
            self.formulas("T_out", "T_in") if self.s.has_formula("T_in") else self.formulas("T_in", "T_out")
        )

    def meshes_table(self) -> layout.Table:
        table, page = self.table("meshes"), self.page
        rows = [
            [
                page.word(f"{mesh.i}–{mesh.j}", table, "mesh", row),
                page.word(mesh.carrier or "—", table, "carrier", row),
                page.word(table["driving"].values[row] or "—", table, "driving", row),
                page.cell(table, "N", row, size=True),
                page.cell(table, "N_fr", row, digits=4),
                page.cell(table, "eta", row, digits=4),
            ]
            for row, mesh in enumerate(self.found.train.meshes)
        ]
        plain = (Symbol("N"), Symbol("N", "fr"), Symbol("eta"))
        heads = [
            *(self.t(text) for text in (N_("Mesh"), N_("Carrier"), N_("Driving wheel"))),
            *(page.head(s, unit) for s, unit in zip(plain, ("W", "W", ""), strict=True)),
        ]
        return worded(
            self.t("Flow of the power through the meshes of the train"), heads, rows, [12, 14, 22, 18, 18, 16]
        )

    def loads_table(self) -> layout.Table:
        keys = [
            key for key in ("T_0", "N_0", "T_free", "T", "N", "F_free", "F") if key in self.table("loads")
        ]
        if not self.found.lossy:
            keys = [key for key in keys if key not in ("T", "N")]
        names = {
            "T_0": N_("Torque without losses, N·m"), "N_0": N_("Power without losses, W"),
            "T_free": N_("Torque without friction in the differential, N·m"),
            "T": N_("Torque, N·m"), "N": N_("Power, W"),
            "F_free": N_("Force without friction in the differential, N"), "F": N_("Tractive force, N"),
        }  # fmt: skip
        return self._of_members(
            "loads", keys, names, self.t("External torques and powers of the train"), self.made.loads
        )

    def flow_table(self) -> layout.Table:
        names = {"T": N_("Torque of the meshes, N·m"), "N": N_("Power from the meshes, W")}
        return self._of_members(
            "flow", ["T", "N"], names, self.t("What the meshes give to every member"), self.made.flows
        )

    def _of_members(
        self, name: str, keys: Sequence[str], names: dict[str, str], caption: Any, rows: dict[str, Any]
    ) -> layout.Table:
        table, page = self.table(name), self.page
        cells = [
            [
                page.word(member, table, "member", k),
                *(page.cell(table, key, k, digits=5) if key in row else "—" for key in keys),
            ]
            for k, (member, row) in enumerate(rows.items())
        ]
        heads = [self.t("Member"), *(self.t(names[key]) for key in keys)]
        return worded(caption, heads, cells, [2, *[3] * len(keys)])

    def branches_table(self) -> layout.Table:
        table, page = self.table("branches"), self.page
        rows = [
            [
                page.word(table["shaft"].values[k], table, "shaft", k),
                page.word(name, table, "member", k),
                page.cell(table, "share_0", k),
                *([page.cell(table, "share", k)] if self.found.lossy else []),
            ]
            for k, name in enumerate(self.made.branches)
        ]
        heads = [self.t("Shaft"), self.t("Through member"), self.t("Share without losses")]
        heads += [self.t("Share with losses")] if self.found.lossy else []
        return worded(
            self.t("Shares of the power through the branches"), heads, rows, [2, 3, 3, 3][: len(heads)]
        )

    # ------------------------------------------------------------ pictures

    @cached_property
    def scheme(self) -> Drawing:
        return scheme(self.found, str(self.t(SCHEME)))

    @cached_property
    def diagrams(self) -> Drawing | None:
        return diagrams(self.found, str(self.t("Diagrams of linear and angular velocities of the train")))

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        return [*self._failures(), self.page.listed(self._found(), " ")]

    def _failures(self) -> Iterator[Markup]:
        found, of = self.found, self.found.conditions
        if found.locks:
            yield Failed(self.t("The gear train locks itself: it cannot be driven from its input."))
        if not all(one.shiftable for one in of.coaxial):
            yield Failed(
                self.t(
                    "The wheels of the gear train are not coaxial with these modules, and profile shift does not make "
                    "it up."
                )
            )
        if of.stated and not all(one.met for one in of.assembly):
            yield Failed(self.t("The stated number of satellites cannot be put in at equal angles."))
        if of.stated and not all(one.met for one in of.neighbours):
            yield Failed(self.t("Neighbouring satellites of the gear train touch."))

    def _found(self) -> Iterator[Markup]:
        found = self.found
        if found.single and found.runs:
            yield self.t("The ratio of the gear train is %(ratio)s.", ratio=self.sized("u"))
            if found.lossy and not found.locks:
                yield self.t("Its efficiency is %(eta)s.", eta=self.number("eta", digits=4))
            if found.locks_back:
                yield self.t("It cannot be driven from its output: it locks itself.")
        else:
            ends = dict.fromkeys((*found.given.input, *found.given.output))
            speeds = self.page.listed(self.rpm(name) for name in ends)
            yield self.t("The inputs and outputs of the gear train turn at %(speeds)s.", speeds=speeds)
            if found.lossy and "eta" in self.s:
                yield self.t("Its efficiency is %(eta)s.", eta=self.number("eta", digits=4))
        if circulating := self.s.get("P_circulating"):
            del circulating
            yield self.t(
                "Power of %(power)s circulates in the closed loop.",
                power=self.measured("P_circulating", digits=4),
            )
