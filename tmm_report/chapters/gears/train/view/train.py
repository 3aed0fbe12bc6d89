"""View of a compound gear train."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property, reduce
from operator import mul
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.train.draw.diagrams import beside, diagrams
from tmm_report.chapters.gears.train.draw.scheme import scheme
from tmm_report.chapters.gears.train.solve.mistakes import known_names
from tmm_report.chapters.gears.train.solve.train import Found
from tmm_report.chapters.gears.train.view.tables import TrainTables
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.gears.compound.rows import Row, row_ratio
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import PI, Expr, Formula, Var, sin
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.kinds import parted
from tmm_report.report.page import Page
from tmm_report.report.part import Failed, Part

SCHEME = N_("Kinematic scheme of the gear train")
KINDS = {"external": N_("external"), "internal": N_("internal"), "bevel": N_("bevel")}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("gears/train", TrainView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The scheme at a glance, for a list of many."""
    return scheme(found, str(page.t(SCHEME)))


class TrainView(TrainTables):
    # ------------------------------------------------------------ what is given

    @property
    def title(self) -> str:
        return self.found.given.name or ""

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

    # ------------------------------------------------------------ conditions

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

    def unsized(self) -> Markup | str:
        """What is said of wheels whose module is not stated."""
        given = self.found.given
        wheels = [] if given.module is not None else [one for one in given.wheels if one not in given.modules]
        if not given.modules and wheels:
            return self.t("No module is stated: the distances are those of a module of 1 mm.")
        text = N_("The module of wheels %(wheels)s is not stated, and is taken as 1 mm.")
        return self.t(text, wheels=self.names(wheels)) if wheels else ""

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

    @cached_property
    def speeds(self) -> tuple[list[Formula], list[Formula]]:
        """In the order in which they are found: the first of each kind, and the others."""
        members = (self.made.members[name] for name in self.made.order)
        keys = ("omega", "omega_rel")
        found = (next(m.formula(key) for key in keys if m.has_formula(key)) for m in members)
        return parted(found)

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
            ("train:n", "n_i", self.t("its rotational speed"), "rpm"),
            ("train:z", "z_i", self.t("number of teeth of wheel i"), ""),
        ]
        return [{"id": key, "symbol": s, "meaning": meaning, "unit": unit} for key, s, meaning, unit in items]

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

    # ------------------------------------------------------------ pictures

    @cached_property
    def scheme(self) -> Drawing:
        return scheme(self.found, str(self.t(SCHEME)))

    @cached_property
    def diagrams(self) -> Drawing | None:
        return diagrams(self.found, str(self.t("Diagrams of linear and angular velocities of the train")))

    @cached_property
    def beside(self) -> bool:
        """Whether the scheme stands beside the diagrams."""
        return beside(self.found)

    def of_diagrams(self) -> Markup:
        """What they are called below them."""
        text = N_(
            "Diagrams of linear and angular velocities of the train: %(length)s, %(velocity)s, %(angular)s"
        )
        if self.beside:
            text = N_(
                "Kinematic scheme of the gear train, diagrams of linear and angular velocities: %(length)s, "
                "%(velocity)s, %(angular)s"
            )
        scales = {"length": "mu_l", "velocity": "mu_v", "angular": "mu_omega"}
        return self.t(text, **{name: self.sized(key) for name, key in scales.items()})

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        return [*self._failures(), self.page.listed(self._found(), " ")]

    def _failures(self) -> Iterator[Markup]:
        found, of = self.found, self.found.conditions
        if found.locks:
            yield Failed(self.t("The gear train is self-locking: it cannot be driven from its input."))
        if not all(one.shiftable for one in of.coaxial):
            yield Failed(
                self.t(
                    "The wheels of the gear train are not coaxial with these modules, and profile shift does not make "
                    "it up."
                )
            )
        if of.stated and not all(one.met for one in of.assembly):
            yield Failed(self.t("The stated number of planet gears cannot be put in at equal angles."))
        if of.stated and not all(one.met for one in of.neighbours):
            yield Failed(self.t("Neighbouring planet gears of the gear train touch."))

    def _found(self) -> Iterator[Markup]:
        found = self.found
        if found.single and found.runs:
            yield self.t("The ratio of the gear train is %(ratio)s.", ratio=self.sized("u"))
            if found.lossy and not found.locks:
                yield self.t("Its efficiency is %(eta)s.", eta=self.number("eta"))
            if found.locks_back:
                yield self.t("It cannot be driven from its output: it locks itself.")
        else:
            ends = dict.fromkeys((*found.given.input, *found.given.output))
            speeds = self.page.listed(self.rpm(name) for name in ends)
            yield self.t("The inputs and outputs of the gear train turn at %(speeds)s.", speeds=speeds)
            if found.lossy and "eta" in self.s:
                yield self.t("Its efficiency is %(eta)s.", eta=self.number("eta"))
        if self.knows("P_circulating"):
            yield self.t(
                "Power of %(power)s circulates in the closed loop.",
                power=self.measured("P_circulating"),
            )
