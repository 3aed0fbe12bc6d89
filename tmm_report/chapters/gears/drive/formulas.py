"""Formulas of a gear drive as a whole: in symbols, in numbers, with their value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from operator import mul

from tmm_report.chapters.gears.drive.quantities import book
from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.mechanics.gears.trains import Member, Mesh
from tmm_report.quantity.formula import PI, Expr, Formula, Number, Var
from tmm_report.quantity.part import Part


class DriveFormulas:
    """What the template prints of the drive. Members are named as in the scheme; `prefix`: of the results' names."""

    def __init__(self, found: Found, prefix: str):
        self.found, self.plans = found, found.plans
        self.of = Part(prefix, book(found, prefix))
        self.speeds_of = self.of.table("speeds")
        self.place = {member.name: row for row, member in enumerate(found.train.members)}

    # ------------------------------------------------------------ variables

    def omega(self, name: str) -> Var:
        return self.speeds_of.var("omega", self.place[name])

    def omega_is(self, name: str, expression: Expr) -> Formula:
        return self.speeds_of.formula("omega", self.place[name], expression)

    def z(self, name: str) -> Var:
        return self.speeds_of.var("z", self.place[name])

    def s(self, name: str) -> Var:
        """The segment of a member in the plan of angular velocities, mm, signed."""
        return self.of.table("segments").var("s", self.place[name], digits=7)

    def of_stage(self, key: str, number: int, digits: int | None = None) -> Var:
        """The ratio `u` of a stage by the teeth, that required, or the efficiency `eta`; stages count from 0."""
        return self.of.table("stages").var(key, number, digits=digits)

    def _over_stages(self, key: str, digits: int | None = None) -> Expr:
        """The product over the stages."""
        factors: list[Expr] = [self.of_stage(key, number, digits) for number in range(len(self.found.stages))]
        return reduce(mul, factors)

    # ------------------------------------------------------------ ratio

    def wanted_ratio(self) -> Formula:
        return self.of["u_required"].formula(self._over_stages("u_required"))

    def ratio(self) -> Formula:
        return self.of["u_teeth"].formula(self._over_stages("u"))

    def deviation(self) -> Formula:
        found, wanted = self.of["u_teeth"].var(digits=5), self.of["u_required"].var(digits=5)
        return self.of["delta_u"].formula((found - wanted) / wanted * Number(100), digits=3)

    # ------------------------------------------------------------ speeds

    def input_speed(self) -> Formula:
        n = self.speeds_of.var("n", self.place[self.found.input])
        return self.omega_is(self.found.input, PI * n / 30)

    def speeds(self, number: int) -> list[Formula]:
        """A stage's input as the output of the stage before, its output, its satellites."""
        stages = self.found.stages
        stage = stages[number]
        return [*self._coupled(stages[:number], stage), self._output(number), *self._satellites(stage)]

    def _coupled(self, before: Sequence[Stage], stage: Stage) -> list[Formula]:
        return [self.omega_is(stage.input, self.omega(before[-1].output))] if before else []

    def _output(self, number: int) -> Formula:
        stage = self.found.stages[number]
        if stage.second:
            return self._differential(number)
        return self.omega_is(stage.output, self.omega(stage.input) / self.of_stage("u", number))

    def basic(self, number: int) -> Var:
        """u_13^(H) of a planetary stage: its ratio with the carrier stopped."""
        return self.of.book[f"stage{number + 1}_u_basic"].var()

    def _differential(self, number: int) -> Formula:
        """ω1 = u ω3 + (1 − u) ωH, solved for the output."""
        stage = self.found.stages[number]
        wheels = [m.name for m in stage.members if m.kind in ("wheel", "ring")]
        one, three = wheels[0], wheels[-1]
        carrier = next(m.name for m in stage.members if m.kind == "carrier")
        w1, w3, wh, u = self.omega(one), self.omega(three), self.omega(carrier), self.basic(number)
        expression: dict[str, Expr] = {
            one: u * w3 + (1 - u) * wh,
            three: (w1 - (1 - u) * wh) / u,
            carrier: (w1 - u * w3) / (1 - u),
        }
        return self.omega_is(stage.output, expression[stage.output])

    def _satellites(self, stage: Stage) -> Iterator[Formula]:
        """By Willis from the first mesh of each satellite: ω2 = ωH ∓ (ω1 − ωH) z1/z2."""
        done: set[str] = set()
        for mesh in stage.meshes:
            satellite, wheel = self._apart(mesh)
            if satellite.kind == "satellite" and satellite.body not in done:
                done.add(satellite.body)
                carried, driving = self.omega(mesh.carrier), self.omega(wheel.name)
                turned = (driving - carried) * self.z(wheel.name) / self.z(satellite.name)
                yield self.omega_is(satellite.name, carried + turned if mesh.internal else carried - turned)

    def _apart(self, mesh: Mesh) -> tuple[Member, Member]:
        one, other = self.found.train.by_name[mesh.i], self.found.train.by_name[mesh.j]
        return (one, other) if one.kind == "satellite" else (other, one)

    # ------------------------------------------------------------ diagrams

    def laid_off(self) -> Formula:
        """The size of the velocity of the first spot."""
        arm = self.of["arm"].var(size=True)
        return self.of["v"].formula(self.omega(self.found.input) * arm, size=True)

    def laid_segment(self) -> Formula:
        return self.of["laid"].formula(self.of["v"].var(size=True) / self.of["mu_v"].var())

    def pole(self) -> Formula:
        of = self.of
        return of["h"].formula(of["mu_v"].var() / (of["mu_l"].var() * of["mu_omega"].var()))

    def work_ratio(self) -> Formula:
        return self.of["u"].formula(self.omega(self.found.input) / self.omega(self.found.output))

    def graph_ratio(self) -> Formula:
        read = self.s(self.found.input) / self.s(self.found.output)
        return self.of["u_graph"].formula(read, digits=6)

    def graph_error(self) -> Formula:
        """(g − a)/(½ (g + a)), %, of the ratio at work."""
        g, a = self.of["u_graph"].var(digits=6), self.of["u"].var(digits=6)
        return self.of["error"].formula((g - a) / (Number(0.5) * (g + a)) * Number(100), digits=3)

    # ------------------------------------------------------------ the link that is turned

    def input_torque(self) -> Formula:
        """That which gives the mean balancing moment of the driving link at the output."""
        over = abs(self.of["u_teeth"].var(digits=5)) * self.of["eta"].var(digits=5)
        return self.of["T_mean"].formula(self.of["M_mean"].var() / over)

    def peak(self) -> Formula:
        return self.of["peak"].formula(self.of["M_greatest"].var() / self.of["M_mean"].var())

    # ------------------------------------------------------------ efficiency

    def efficiency(self) -> Formula:
        return self.of["eta"].formula(self._over_stages("eta", digits=4), digits=4)
