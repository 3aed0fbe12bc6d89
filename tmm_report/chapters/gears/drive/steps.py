"""The numbers of a gear drive as a whole with the expressions that the note prints of them.

Speeds and loads are found by Willis' equations of all meshes together; here they follow one from another.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterator, Sequence
from functools import reduce
from operator import mul

from tmm_report.chapters.gears.drive.power.steps import Steps as PowerSteps
from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.chapters.gears.drive.values import Member, OfStage, Segment, Values, letters
from tmm_report.chapters.gears.ordinary import solve as ordinary
from tmm_report.chapters.gears.planetary.quantities.stage import book
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.mechanics.gears import trains
from tmm_report.quantity.formula import PI, Expr, Number, Var
from tmm_report.quantity.sheet import Computed
from tmm_report.quantity.symbols import both
from tmm_report.quantity.tabulated import tabulated


def whole(found: Found, prefix: str) -> Whole:
    """The numbers of a drive, made once; every name begins with `prefix`."""
    return next(iter(_wholes(found, prefix)))


@tabulated
def _wholes(found: Found, prefix: str) -> Iterator[Whole]:
    yield Whole(found, prefix)


class Whole:
    """`s`: the single numbers; `stages`: a row each; `members` and `segments` of the plan, by the names of members;
    `power`: from the machine back to the motor, None where nothing is asked of them."""

    def __init__(self, found: Found, prefix: str):
        self.found, self.s = found, Values(letters(found), prefix)
        names = [member.name for member in found.train.members]
        self.stages = tuple(
            OfStage(f"{prefix}_stages", row, both(stage.input, stage.output))
            for row, stage in enumerate(found.stages)
        )
        self.members = {
            name: Member(f"{prefix}_speeds", row, dict.fromkeys(("z", "omega", "n"), name))
            for row, name in enumerate(names)
        }
        self.segments = {name: Segment(f"{prefix}_segments", row, name) for row, name in enumerate(names)}
        self._given()
        self._crank()
        self.power = self._power(prefix)
        self.turned = [self._speeds(number) for number in range(len(found.stages))]
        self._ratios()
        self._asked()
        self._plans()

    def _given(self) -> None:
        found = self.found
        self.s.tolerance, self.s.losses = 100 * found.given.tolerance, found.losses
        for of, stage in zip(self.stages, found.stages, strict=True):
            of.u, of.eta = stage.ratio, stage.efficiency
            if of.row not in self._divided:
                of.u_required = stage.wanted
        for member, row in zip(found.train.members, self.members.values(), strict=True):
            omega = found.speed[member.name]
            row.z, row.n = member.teeth, omega * 30 / math.pi
            row.omega_rel = omega - (found.speed[member.carried_by] if member.carried_by else 0.0)
        for name, segment in self.segments.items():
            segment.s = found.plans.segment(name)

    @property
    def _divided(self) -> Container[int]:
        """Stages whose ratio is what the drive's power side leaves them."""
        shafts = self.found.power
        return () if shafts is None else shafts.plan.shares or ()

    def _power(self, prefix: str) -> PowerSteps | None:
        found = self.found
        if found.power is None:
            return None
        wheels = [(stage.input, stage.output) for stage in found.stages]
        moment = None
        if found.power.given.machine is None and found.moments is not None:
            moment = abs(self.s.M_greatest) if found.power.given.peak else self.s.M_mean
        return PowerSteps(found.power, prefix, self.stages, wheels, moment)

    # ------------------------------------------------------------ speeds

    def omega(self, name: str) -> Var:
        """Given of the members that are held or driven besides; of others found before."""
        row = self.members[name]
        if "omega" not in row:
            row.omega = self.found.speed[name]
        return row.omega

    def _turns(self, name: str, expression: Expr) -> str:
        self.members[name].omega = Computed(expression, self.found.speed[name])
        return name

    def _speeds(self, number: int) -> list[str]:
        """Of a stage in their order: its input as the output of the stage before, its output, its satellites."""
        stage = self.found.stages[number]
        before = self.omega(self.found.stages[number - 1].output) if number else None
        own = PI * self.members[stage.input].n / 30 if before is None else before
        names = [self._turns(stage.input, own), self._turns(stage.output, self._output(number))]
        names += [self._turns(satellite, turned) for satellite, turned in self._satellites(stage)]
        names += [self._turns(idler, turned) for idler, turned in self._idlers(stage)]
        for member in stage.members:
            self.omega(member.name)
        return names if number else names[1:]

    def _output(self, number: int) -> Expr:
        stage = self.found.stages[number]
        if isinstance(stage, planetary.Found) and stage.second:
            return self._differential(stage, f"stage{number + 1}")
        return self.omega(stage.input) / self.stages[number].u

    def _differential(self, stage: planetary.Found, prefix: str) -> Expr:
        """ω1 = u ω3 + (1 − u) ωH, solved for the output."""
        u = book(stage, prefix)[f"{prefix}_u_basic"].var()
        one, three, carrier = (stage.given.member(member) for member in ("wheel1", "wheel3", "carrier"))
        if stage.output == one:
            return u * self.omega(three) + (1 - u) * self.omega(carrier)
        if stage.output == three:
            return (self.omega(one) - (1 - u) * self.omega(carrier)) / u
        return (self.omega(one) - u * self.omega(three)) / (1 - u)

    def _satellites(self, stage: Stage) -> Iterator[tuple[str, Expr]]:
        """By Willis from the first mesh of each satellite: ω2 = ωH ∓ (ω1 − ωH) z1/z2."""
        done: set[str] = set()
        for mesh in stage.meshes:
            satellite, wheel = self._apart(mesh)
            if satellite.kind == "satellite" and satellite.body not in done:
                done.add(satellite.body)
                carried, driving = self.omega(mesh.carrier), self.omega(wheel.name)
                turned = (driving - carried) * self.members[wheel.name].z / self.members[satellite.name].z
                yield satellite.name, carried + turned if mesh.internal else carried - turned

    def _idlers(self, stage: Stage) -> Iterator[tuple[str, Expr]]:
        """By the teeth, each from the wheel that drives it."""
        for mesh in stage.meshes:
            if mesh.j != stage.output and not mesh.carrier and isinstance(stage, ordinary.Found):
                turned = self.omega(mesh.i) * self.members[mesh.i].z / self.members[mesh.j].z
                yield mesh.j, turned if mesh.internal else -turned

    def _apart(self, mesh: trains.Mesh) -> tuple[trains.Member, trains.Member]:
        one, other = self.found.train.by_name[mesh.i], self.found.train.by_name[mesh.j]
        return (one, other) if one.kind == "satellite" else (other, one)

    # ------------------------------------------------------------ ratio, efficiency

    def _over_stages(self, key: str) -> Expr:
        """The product over the stages."""
        factors: Sequence[Expr] = [row[key].var() for row in self.stages]
        return reduce(mul, factors)

    def _ratios(self) -> None:
        s, found = self.s, self.found
        s.u_required = Computed(self._over_stages("u_required"), found.wanted)
        s.u_teeth = Computed(self._over_stages("u"), found.geared)
        teeth, required = s["u_teeth"].var(digits=5), s["u_required"].var(digits=5)
        s.delta_u = Computed((teeth - required) / required * Number(100), 100 * found.deviation)
        one, other = self.omega(found.input), self.omega(found.output)
        s.u = Computed(one / other, found.ratio) if found.differential and found.runs else found.ratio
        series = not found.locks and not found.differential and len(found.stages) > 1
        s.eta = Computed(self._over_stages("eta"), found.efficiency) if series else found.efficiency

    # ------------------------------------------------------------ diagrams

    @property
    def readable(self) -> bool:
        """Whether the output turns, and its segment is long enough for a ratio."""
        return self.found.runs and bool(self.found.plans.segment(self.found.output))

    def _plans(self) -> None:
        s, found, plans = self.s, self.found, self.found.plans
        s.mu_l, s.mu_v, s.mu_omega = plans.length_scale, plans.velocity_scale, plans.angular_scale
        s.h = Computed(s.mu_v / (s.mu_l * s.mu_omega), plans.pole)
        s.step, s.arm, s.v = plans.accuracy, found.arm, found.speed[found.input] * found.arm
        s.laid = s["v"].var(size=True) / s.mu_v
        if not self.readable:
            s.u_graph, s.error = found.graphical, found.graphical_error
            return
        one, other = (self.segments[name]["s"].var(digits=7) for name in (found.input, found.output))
        s.u_graph = Computed(one / other, found.graphical)
        g, a = s["u_graph"].var(digits=6), s["u"].var(digits=6)
        s.error = Computed((g - a) / (Number(0.5) * (g + a)) * Number(100), found.graphical_error)

    def laid_off(self) -> Expr:
        """The size of the velocity of the first spot."""
        return self.omega(self.found.input) * self.s["arm"].var(size=True)

    # ------------------------------------------------------------ the link that is turned

    def _crank(self) -> None:
        """The moments of the link that the drive turns."""
        s, moments = self.s, self.found.moments
        if moments is None:
            return
        if moments.friction is not None and not math.isnan(moments.friction):
            s.M_fr = moments.friction
        s.M_mean, s.M_greatest, s.M_angle = moments.mean, moments.greatest, math.degrees(moments.angle)

    def _asked(self) -> None:
        """The torques at the input that overcome them."""
        s, moments = self.s, self.found.moments
        if self.found.asked and moments is not None:
            over = abs(s["u_teeth"].var(digits=5)) * s["eta"].var(digits=5)
            s.T_mean = Computed(s.M_mean / over, self.found.given.torque)
            s.peak = Computed(s.M_greatest / s.M_mean, moments.peak)
