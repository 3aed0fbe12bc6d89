"""Formulas of a gear drive as a whole: in symbols, in numbers, with their value."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from tmm_report.chapters.drive.plans import Spot
from tmm_report.chapters.drive.solve import Found
from tmm_report.mechanics.trains import Member, Mesh
from tmm_report.quantity.formula import Expr, Formula, Number, Var
from tmm_report.quantity.symbols import Symbol, both, segment

RAD_PER_SECOND = "rad/s"


class DriveFormulas:
    """What the template prints of the drive. Members are named as in the scheme."""

    def __init__(self, found: Found):
        self.found, self.plans = found, found.plans

    # ------------------------------------------------------------ variables

    def ratio_symbol(self, one: str, other: str, sup: str = "") -> Symbol:
        return Symbol("u", both(one, other), sup)

    def omega(self, name: str) -> Var:
        return Var(Symbol("omega", name), self.found.speed[name], RAD_PER_SECOND)

    def z(self, name: str) -> Var:
        return Var(Symbol("z", name), self.found.train.by_name[name].teeth)

    def s(self, name: str) -> Var:
        """The segment of a member in the plan of angular velocities, mm, signed."""
        return Var(Symbol("s", name), self.plans.segment(name), "mm", digits=7)

    def stage_ratio(self, stage: Any, wanted: bool = False) -> Var:
        """The stage's ratio by the teeth, or the one wanted, with a prime."""
        symbol = self.ratio_symbol(stage.input, stage.output, "′" if wanted else "")
        return Var(symbol, stage.wanted if wanted else stage.ratio)

    # ------------------------------------------------------------ ratio

    def _whole(self, wanted: bool) -> Formula:
        product: Expr = self.stage_ratio(self.found.stages[0], wanted)
        for stage in self.found.stages[1:]:
            product = product * self.stage_ratio(stage, wanted)
        return Formula(self._whole_symbol(wanted), product)

    def _whole_symbol(self, wanted: bool = False) -> Symbol:
        return self.ratio_symbol(self.found.input, self.found.output, "′" if wanted else "")

    def wanted_ratio(self) -> Formula:
        return self._whole(wanted=True)

    def ratio(self) -> Formula:
        return self._whole(wanted=False)

    def deviation(self) -> Formula:
        found = Var(self._whole_symbol(), self.found.geared, digits=5)
        wanted = Var(self._whole_symbol(wanted=True), self.found.wanted, digits=5)
        return Formula("delta_u", (found - wanted) / wanted * Number(100), "%", digits=3)

    # ------------------------------------------------------------ speeds

    def input_speed(self) -> Formula:
        name = self.found.input
        n = Var(Symbol("n", name), self.found.speed[name] * 30 / math.pi, "rpm")
        return Formula(Symbol("omega", name), Var("pi", math.pi) * n / 30, RAD_PER_SECOND)

    def speeds(self, number: int) -> list[Formula]:
        """A stage's input as the output of the stage before, its output, its satellites."""
        stages = self.found.stages
        stage = stages[number]
        return [*self._coupled(stages[:number], stage), self._output(stage), *self._satellites(stage)]

    def _coupled(self, before: Sequence[Any], stage: Any) -> list[Formula]:
        shaft = Symbol("omega", stage.input)
        return [Formula(shaft, self.omega(before[-1].output), RAD_PER_SECOND)] if before else []

    def _output(self, stage: Any) -> Formula:
        if stage.second:
            return self._differential(stage)
        result = Symbol("omega", stage.output)
        return Formula(result, self.omega(stage.input) / self.stage_ratio(stage), RAD_PER_SECOND)

    def basic(self, stage: Any) -> Var:
        """u_13^(H) of a planetary stage: its ratio with the carrier stopped."""
        one, three, carrier = self._central(stage)
        ratio = 1.0
        for mesh in stage.meshes:
            u = self.found.train.ratio(mesh)
            ratio *= u if mesh.i == one or mesh.j == three else 1 / u
        return Var(self.ratio_symbol(one, three, f"({carrier})"), ratio)

    def _central(self, stage: Any) -> tuple[str, str, str]:
        """Wheels 1 and 3 and the carrier."""
        wheels = [m.name for m in stage.members if m.kind in ("wheel", "ring")]
        return wheels[0], wheels[-1], next(m.name for m in stage.members if m.kind == "carrier")

    def _differential(self, stage: Any) -> Formula:
        """ω1 = u ω3 + (1 − u) ωH, solved for the output."""
        one, three, carrier = self._central(stage)
        w1, w3, wh, u = self.omega(one), self.omega(three), self.omega(carrier), self.basic(stage)
        expression: dict[str, Expr] = {
            one: u * w3 + (1 - u) * wh,
            three: (w1 - (1 - u) * wh) / u,
            carrier: (w1 - u * w3) / (1 - u),
        }
        return Formula(Symbol("omega", stage.output), expression[stage.output], RAD_PER_SECOND)

    def _satellites(self, stage: Any) -> Iterator[Formula]:
        """By Willis from the first mesh of each satellite: ω2 = ωH ∓ (ω1 − ωH) z1/z2."""
        done: set[str] = set()
        for mesh in stage.meshes:
            satellite, wheel = self._apart(mesh)
            if satellite.kind == "satellite" and satellite.body not in done:
                done.add(satellite.body)
                carried, driving = self.omega(mesh.carrier), self.omega(wheel.name)
                turned = (driving - carried) * self.z(wheel.name) / self.z(satellite.name)
                result = Symbol("omega", satellite.name)
                yield Formula(result, carried + turned if mesh.internal else carried - turned, RAD_PER_SECOND)

    def _apart(self, mesh: Mesh) -> tuple[Member, Member]:
        one, other = self.found.train.by_name[mesh.i], self.found.train.by_name[mesh.j]
        return (one, other) if one.kind == "satellite" else (other, one)

    # ------------------------------------------------------------ diagrams

    @property
    def first(self) -> Spot:
        """The spot whose velocity is laid off first: of the input member, farthest from its axis."""
        name = self.found.input
        spots = [spot for spot in self.plans.spots if name in spot.members]
        return max(spots, key=lambda spot: abs(spot.y - self.plans.axes[name]))

    def laid_off(self) -> Formula:
        """The velocity of the first spot; along the axis v is positive to the right."""
        name, spot = self.found.input, self.first
        arm = Var(Symbol("r", name), spot.y - self.plans.axes[name], "m")
        return Formula(Symbol("v", spot.name), self.omega(name) * arm, "m/s")

    def laid_segment(self) -> Formula:
        name, spot = self.found.input, self.first
        v = Var(Symbol("v", spot.name), self.found.speed[name] * (spot.y - self.plans.axes[name]), "m/s")
        size = abs(v) if v.number < 0 else v
        return Formula(segment(f"{spot.name}{spot.name.lower()}"), size / self.mu_v, "mm")

    @property
    def mu_v(self) -> Var:
        return Var("mu_v", self.plans.velocity_scale, "(m/s)/mm")

    @property
    def mu_l(self) -> Var:
        return Var("mu_l", self.plans.length_scale, "m/mm")

    @property
    def mu_omega(self) -> Var:
        return Var("mu_omega", self.plans.angular_scale, "(rad/s)/mm")

    def pole(self) -> Formula:
        return Formula("h", self.mu_v / (self.mu_l * self.mu_omega), "mm")

    def _at_work(self, sup: str = "") -> Symbol:
        """u of the input and the output; i of a differential, whose u is that with the second input at rest."""
        symbol = self.ratio_symbol(self.found.input, self.found.output, sup)
        return replace(symbol, base="i") if self.found.differential else symbol

    def work_ratio(self) -> Formula:
        return Formula(self._at_work(), self.omega(self.found.input) / self.omega(self.found.output))

    def graph_ratio(self) -> Formula:
        read = self.s(self.found.input) / self.s(self.found.output)
        return Formula(self._at_work("gr"), read, digits=6)

    def graph_error(self) -> Formula:
        """(g − a)/(½ (g + a)), %, of the ratio at work."""
        read = self.plans.ratio(self.found.input, self.found.output)
        g = Var(self._at_work("gr"), read, digits=6)
        a = Var(self._at_work(), self.found.ratio, digits=6)
        return Formula("delta", (g - a) / (Number(0.5) * (g + a)) * Number(100), "%", digits=3)

    # ------------------------------------------------------------ efficiency

    def efficiency(self) -> Formula:
        product: Expr = self._eta(self.found.stages[0])
        for stage in self.found.stages[1:]:
            product = product * self._eta(stage)
        return Formula("eta", product, digits=4)

    def _eta(self, stage: Any) -> Var:
        symbol = self.ratio_symbol(stage.input, stage.output)
        return Var(Symbol("eta", symbol.sub), stage.efficiency, digits=4)
