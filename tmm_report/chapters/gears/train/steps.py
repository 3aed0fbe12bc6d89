"""The numbers of a compound train with the expressions that the note prints of them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import reduce
from operator import mul

from tmm_report.chapters.gears.train.solve.train import Found, shares
from tmm_report.chapters.gears.train.values import (
    Assembly,
    Branch,
    Case,
    Distance,
    Flowing,
    Load,
    Member,
    Neighbours,
    OfMesh,
    OfRow,
    Ratio,
    Values,
    letters,
    ratio_symbol,
)
from tmm_report.mechanics.gears.compound.rows import Link, Row, Step, by_steps, row_ratio
from tmm_report.quantity.formula import PI, Expr, Number, Var
from tmm_report.quantity.sheet import Computed, Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated


def whole(found: Found) -> Numbers:
    """The numbers of the train, made once."""
    return next(iter(_whole(found)))


@tabulated
def _whole(found: Found) -> Iterator[Numbers]:
    yield Numbers(found)


def _product(factors: Sequence[Expr]) -> Expr:
    return reduce(mul, factors)


class Numbers:
    """`s`: the single numbers; `members`, `loads`, `flows` by name, `rows` by the row as it is turned in the formula,
    `ratios` by body, `meshes` in the order of the train; `branches` by member."""

    def __init__(self, found: Found):
        self.found, self.train = found, found.train
        self.s = Values(letters(found.input, found.output, None if found.single else ("", "")))
        self.members = {m.name: Member("train_speeds", k, m.name) for k, m in enumerate(self.train.members)}
        self.meshes = [self._mesh(k) for k in range(len(self.train.meshes))]
        self.rows: dict[tuple[str, str, str], OfRow] = {}
        self.turned: list[Row] = []
        self.ratios: dict[str, Ratio] = {}
        self.order: list[str] = []  # members whose speeds have formulas, as they are found
        self._given()
        self._steps()
        self._satellites()
        self._ends()
        self._torques()
        self._outside()
        self._inside()
        self._conditions()
        self._cases()
        self._plans()

    # ------------------------------------------------------------ what is given

    def _mesh(self, k: int) -> OfMesh:
        mesh, flow = self.train.meshes[k], self.found.flow
        made = OfMesh("train_meshes", k, ratio_index(mesh.i, mesh.j))
        made.N, made.N_fr = float(flow.loads.mesh_power[k]), float(flow.loads.loss[k])
        made.eta, made.way = flow.train.meshes[k].efficiency, flow.way[k]
        made.F_t = self._force(k)
        return made

    def _force(self, k: int) -> float | None:
        """2 T/(m z k) on one of k satellites, of a mesh with parallel axes whose module is stated."""
        found, mesh = self.found, self.train.meshes[k]
        stated = found.given.module is not None or mesh.i in found.given.modules
        if not stated or not found.built.flat[k]:
            return None
        sharing = found.conditions.k if mesh.carrier else 1
        torque = abs(float(found.flow.loads.mesh_torque[k]))
        return torque / (found.places.radius[mesh.i] * sharing) if sharing else None

    def _given(self) -> None:
        found, s, given = self.found, self.s, self.found.given
        for m in self.train.members:
            row, omega = self.members[m.name], found.speed[m.name]
            row.z = m.teeth
            tilted = found.built.tilted(m.name)
            row.n = None if tilted else omega * 30 / math.pi
            if m.carried_by:
                about = omega - found.speed[m.carried_by]
                row.n_rel = about * 30 / math.pi
        s.freedom = self.train.freedom
        s.locking = given.locking
        if given.find:
            s.u_wanted, s.tolerance = given.find.ratio, 100 * given.find.tolerance
        if given.rope:
            s.D, s.F = given.rope.drum, abs(given.rope.force)
        if road := given.road:
            s.v_car, s.D_wheel, s.R, s.B = road.speed, road.wheel, road.radius, road.track or None
        if found.sought:
            s.combinations = found.sought.candidates.examined
            s.solutions = sum(n for reason, n in found.sought.candidates.counts.items() if not reason)

    def joined(self, name: str) -> str:
        """The other members of its shaft."""
        body = self.train.by_name[name].body
        return ", ".join(m.name for m in self.train.members if m.body == body and m.name != name)

    # ------------------------------------------------------------ the kinematic formula

    def z(self, name: str) -> Var:
        return self.members[name].z

    def row(self, row: Row) -> OfRow:
        """The numbers of a row, turned as it is needed."""
        key = (row.a, row.b, row.carrier)
        if key not in self.rows:
            made = OfRow("train_rows", len(self.rows), other=self._called(row))
            self.rows[key] = made
            self.turned.append(row)
            made.u = Computed(self._by_teeth(row), float(row_ratio(self.train, row)))
            etas = [(self.meshes[link.mesh], self._exponent(link)) for link in row.links]
            expression: Expr = made.u
            for mesh, x in etas:
                expression = (
                    expression * mesh.eta if x > 0 else expression / mesh.eta if x < 0 else expression
                )
            made.u_loss = Computed(expression, self.found.weighted(row))
        return self.rows[key]

    def _called(self, row: Row) -> dict[str, Q]:
        symbol = self.symbol_of(row)
        starred = ratio_symbol(*self.ends_of(row), self.carrier_of(row), star=True)
        return {"u": OfRow.u.called(symbol), "u_loss": OfRow.u_loss.called(starred)}

    def ends_of(self, row: Row) -> tuple[str, str]:
        return row.links[0].i, row.links[-1].j

    def carrier_of(self, row: Row) -> str:
        return self.train.meshes[row.links[0].mesh].carrier

    def symbol_of(self, row: Row) -> Symbol:
        return ratio_symbol(*self.ends_of(row), self.carrier_of(row))

    def _exponent(self, link: Link) -> int:
        way = self.found.flow.way[link.mesh]
        return way if link.forth else -way

    def _by_teeth(self, row: Row) -> Expr:
        """± the teeth of the driven wheels by those of the driving ones; what stands on both sides is left out."""
        above, below = [link.j for link in row.links], [link.i for link in row.links]
        for name in [name for name in above if name in below]:
            above.remove(name)
            below.remove(name)
        value = _product([self.z(name) for name in above]) / _product([self.z(name) for name in below])
        return value if float(row_ratio(self.train, row)) > 0 else -value

    def _u(self, row: Row) -> Expr:
        """With more digits where its difference from 1 has few of them."""
        number = float(row_ratio(self.train, row))
        near = max(0, math.ceil(-math.log10(max(abs(1 - number), 1e-9))))
        return self.row(row)["u"].var(digits=6 + near)

    def _steps(self) -> None:
        """Ratios to the output, then the ratio of the train; or the speeds one after another."""
        found = self.found
        for row in found.rows:
            if found.steps is None:
                self.row(row)
        if found.steps is None:
            self._all_given()
        elif found.basis:
            self._ratios(found.steps)
        else:
            self._one_by_one(found.steps)

    def _speed(self, body: str, expression: Expr | None) -> Expr:
        """The speed of a body: given without an expression; 0 needs none."""
        row, number = self.members[body], self.found.speed[body]
        row.omega = number if expression is None else Computed(expression, number)
        if expression is not None:
            self.order.append(body)
        return row.omega

    def _all_given(self) -> None:
        """All speeds as they are solved together; the ratio by those of both ends."""
        found = self.found
        for body in self.train.bodies:
            if not found.built.tilted(body):
                self._speed(body, None)
        if found.single and found.runs:
            one, other = (self.members[found.built.body(name)] for name in (found.input, found.output))
            self.s.u = Computed(one.omega / other.omega, found.ratio)

    def _ratios(self, steps: Sequence[Step]) -> None:
        """All speeds are in proportion: u of every body to the basis, the ratio of the train by them."""
        found, s, basis = self.found, self.s, self.found.basis
        one, other = found.built.body(found.input), found.built.body(found.output)

        def keep(step: Step, value: Expr) -> Expr:
            number = found.speed[step.body] / found.speed[basis]
            if step.body == one and basis == other:
                s.u = Computed(value, number)
                return s.u
            made = Ratio("train_ratios", len(self.ratios), other={
                "u": Ratio.u.called(ratio_symbol(step.body, basis))
            })  # fmt: skip
            self.ratios[step.body] = made
            made.u = Computed(value, number)
            return made["u"].var(digits=7)

        by_steps(steps, {basis: Number(1)}, self._u, found.still, basis, keep)
        if basis != other:
            above = Number(1) if basis == one else self.ratios[one]["u"].var(digits=7)
            s.u = Computed(above / self.ratios[other]["u"].var(digits=7), found.ratio)
        if one == other:
            s.u = 1.0
        self._speed(one, PI * self.members[one].n / 30)
        if other != one:
            self._speed(other, self.members[one].omega / s["u"].var(digits=7))
        if basis not in (one, other):
            self._speed(basis, self.members[one].omega / self.ratios[one]["u"].var(digits=7))
        for body, ratio in self.ratios.items():
            if body not in (one, other):
                self._speed(body, ratio["u"].var(digits=7) * self.members[basis].omega)
        for body in found.still:
            self._speed(body, None)

    def _one_by_one(self, steps: Sequence[Step]) -> None:
        """From the stated speeds, those of every body in turn."""
        found = self.found
        reached = {step.body for step in steps}
        start: dict[str, Expr] = {}
        for row in found.rows:
            for body in row.bodies:
                if body not in reached and body not in start:
                    if body in found.still:
                        start[body] = self._speed(body, None)
                    else:
                        start[body] = self._speed(body, self._stated(body))
        by_steps(steps, start, self._u, found.still, keep=lambda step, value: self._speed(step.body, value))

    def _stated(self, body: str) -> Expr:
        """By the stated frequency, or of a car's wheel by its road."""
        found, s = self.found, self.s
        road = found.given.road
        if road is None or body not in (found.built.body(name) for name in found.given.output):
            return PI * self.members[body].n / 30
        turned = 2 * s.v_car / s.D_wheel
        if road.radius is None or not road.track:
            return turned
        share = s.B / (2 * s.R)
        outer = body == found.built.body(found.given.output[0])
        return turned * (1 + share) if outer else turned * (1 - share)

    # ------------------------------------------------------------ satellites and idlers

    def _satellites(self) -> None:
        """By Willis from the first mesh of each with what is known: ω_2 = ω_H ∓ (ω_1 − ω_H) z_1/z_2."""
        waiting = [
            m.body
            for m in self.train.members
            if "omega" not in self.members[m.body] and "omega_rel" not in self.members[m.name]
        ]
        progress = True
        while waiting and progress:
            progress = False
            for body in list(dict.fromkeys(waiting)):
                if self._by_mesh(body):
                    waiting = [other for other in waiting if other != body]
                    progress = True
        for m in self.train.members:
            row = self.members[m.name]
            if m.name != m.body and not self.found.built.tilted(m.name):
                row.omega = self.found.speed[m.name]
            if m.carried_by and "omega_rel" not in row:
                row.omega_rel = self.found.speed[m.name] - self.found.speed[m.carried_by]

    def _by_mesh(self, body: str) -> bool:
        found = self.found
        for mesh in self.train.meshes:
            for own, mate in ((mesh.i, mesh.j), (mesh.j, mesh.i)):
                if self.train.by_name[own].body != body:
                    continue
                known = self.members[self.train.by_name[mate].body]
                carrier = self.train.by_name[mesh.carrier].body if mesh.carrier else ""
                if "omega" not in known or (carrier and "omega" not in self.members[carrier]):
                    continue
                size = self.z(mate) / self.z(own)
                if not carrier or not found.speed[carrier]:
                    value: Expr = known.omega * size
                    self._turns(body, value if mesh.internal else -value, bool(carrier))
                    return True
                about = (known.omega - self.members[carrier].omega) * size
                if found.built.tilted(own):
                    self._turns(body, about if mesh.internal else -about, True)
                    return True
                carried = self.members[carrier].omega
                self._speed(body, carried + about if mesh.internal else carried - about)
                return True
        return False

    def _turns(self, body: str, value: Expr, about: bool) -> None:
        """About the carrier where the axis lies across, or the carrier stands."""
        carrier = self.train.by_name[body].carried_by
        if about and carrier and self.found.built.tilted(body):
            number = self.found.speed[body] - self.found.speed[carrier]
            self.members[body].omega_rel = Computed(value, number)
            self.order.append(body)
        else:
            self._speed(body, value)

    # ------------------------------------------------------------ torques

    def _ends(self) -> None:
        s, found = self.s, self.found
        if not found.single or not found.runs:
            return
        if found.given.find:
            wanted = s["u_wanted"].var(digits=6)
            s.delta_u = Computed(
                (s["u"].var(digits=7) - wanted) / wanted * Number(100), 100 * (found.deviation or 0.0)
            )

    def _torques(self) -> None:
        """Of one input and one output: u* by the rows with their losses, the efficiency, both torques; the powers."""
        s, found = self.s, self.found
        loads = found.flow.loads
        s.P_lost = found.flow.lost
        ends = (*found.given.input, *found.given.output)
        s.P_circulating = max(found.flow.circulating(found.built.body(name)) for name in ends) or None
        if not found.single or not found.runs:
            s.P_supplied, s.P_taken = loads.supplied, loads.supplied - found.flow.lost
            supplied = found.flow.supplied
            s.eta = Computed(s.P_taken / s.P_supplied, found.efficiency) if supplied else None
            self._differential()
            return
        if found.lossy:
            s.u_loss = Computed(self._with_losses(), found.force_ratio) if found.steps else found.force_ratio
            s.eta = (
                found.efficiency
                if found.locks
                else Computed(s["u_loss"].var(digits=7) / s["u"].var(digits=7), found.efficiency)
            )
            s.eta_back = found.back
        one, other = float(loads.torque[found.input]), float(loads.torque[found.output])
        ratio = (s["u_loss"] if found.lossy else s["u"]).var(digits=7)
        given = found.given
        omega_in, omega_out = (
            self.members[found.built.body(name)].omega for name in (found.input, found.output)
        )
        if given.rope is not None:
            s.T_out = Computed(self._against(s.F * s.D / 2), other)
            s.v = Computed(abs(omega_out) * s.D / 2, abs(found.speed[found.output]) * given.rope.drum / 2)
        if given.output_torque is not None or given.output_power is not None:
            s.T_out = other
        if "T_out" in s:
            s.T_in = Computed(-s.T_out / ratio, one)
        else:
            s.T_in = one
            s.T_out = Computed(-ratio * s.T_in, other)
        s.P_in = Computed(s.T_in * omega_in / 1000, float(loads.power[found.input]))
        s.P_out = Computed(-s.T_out * omega_out / 1000, -float(loads.power[found.output]))

    def _against(self, size: Expr) -> Expr:
        return -size if self.found.speed[self.found.output] > 0 else size

    def _with_losses(self) -> Expr:
        """The ratio of the train by the same steps, every row with its losses."""
        found, basis = self.found, self.found.basis
        one, other = found.built.body(found.input), found.built.body(found.output)
        assert found.steps is not None

        def ratio(row: Row) -> Expr:
            made = self.row(row)
            near = max(0, math.ceil(-math.log10(max(abs(1 - made["u_loss"].value), 1e-9))))
            return made["u_loss"].var(digits=6 + near)

        speed = by_steps(found.steps, {basis: Number(1)}, ratio, found.still, basis)
        return speed[one] if basis == other else speed[one] / speed[other]

    def _differential(self) -> None:
        """What friction loses where two outputs turn apart."""
        found, s = self.found, self.s
        if found.given.locking is None:
            return
        s.P_differential = found.flow.lost - found.free.lost

    # ------------------------------------------------------------ tables of torques and powers

    def _outside(self) -> None:
        """External torques of what is driven, held or taken from."""
        found = self.found
        names = list(dict.fromkeys(found.built.outer))
        self.loads: dict[str, Load] = {}
        for k, name in enumerate(n for n in names if n in found.flow.loads.torque):
            row = Load("train_loads", k, name)
            self.loads[name] = row
            row.T_0, row.N_0 = float(found.ideal.loads.torque[name]), float(found.ideal.loads.power[name])
            row.T, row.N = float(found.flow.loads.torque[name]), float(found.flow.loads.power[name])
            if found.given.locking is not None:
                row.T_free = float(found.free.loads.torque[name])
            if found.given.road is not None and name in found.given.output:
                arm = found.given.road.wheel / 2
                row.F = abs(row["T"].value) / arm
                if found.given.locking is not None:
                    row.F_free = abs(row["T_free"].value) / arm

    def _inside(self) -> None:
        """What the meshes give to every member; branches of the power at shafts of several members."""
        found = self.found
        self.flows: dict[str, Flowing] = {}
        largest = max(abs(one) for one in found.flow.member.values())
        for name in self.train.by_name:
            if found.flow.meets(name):
                row = Flowing("train_flow", len(self.flows), name)
                tilted = found.built.tilted(name)
                row.T = _clean(found.flow.member[name], largest)
                row.N = None if tilted else _clean(found.flow.power(name), found.flow.supplied)
                self.flows[name] = row
        self.branches: dict[str, Branch] = {}
        ends = [found.built.body(name) for name in (*found.given.input, *found.given.output)]
        for body in dict.fromkeys(ends):
            ideal, real = shares(found.ideal, body), shares(found.flow, body)
            for name, share in ideal.items():
                row_ = Branch("train_branches", len(self.branches), name)
                row_.share_0, row_.share = share, real.get(name)
                self.branches[name] = row_

    # ------------------------------------------------------------ conditions

    def _conditions(self) -> None:
        of = self.found.conditions
        self.distances = []
        for k, one in enumerate(of.coaxial):
            row = Distance("train_distances", k)
            row.a, row.a_other, row.gap = one.one, one.other, one.gap
            self.distances.append(row)
        self.assembly = []
        for k, each in enumerate(of.assembly):
            made = Assembly("train_assembly", k)
            made.k, made.C = each.k, each.number
            self.assembly.append(made)
        self.neighbours = []
        for k, crowd in enumerate(of.neighbours):
            near = Neighbours("train_neighbours", k)
            near.k, near.gap = crowd.k, crowd.gap
            self.neighbours.append(near)

    def _plans(self) -> None:
        s, plans = self.s, self.found.plans
        s.mu_l = self.found.places.scale
        if plans is not None:
            s.mu_v, s.mu_omega = plans.velocity, plans.angular
            s.h = Computed(s.mu_v / (s.mu_l * s.mu_omega), plans.pole)

    def _cases(self) -> None:
        self.cases: list[tuple[int, str, Case]] = []
        for number, speed in enumerate(self.found.cases, 1):
            for m in self.train.members:
                if m.name == m.body and not self.found.built.tilted(m.name):
                    row = Case("train_cases", len(self.cases), m.name)
                    row.omega, row.n = speed[m.name], speed[m.name] * 30 / math.pi
                    self.cases.append((number, m.name, row))


def _clean(number: float, beside: float) -> float:
    """What is rounding is 0."""
    return number if abs(number) > 1e-9 * beside else 0.0


def ratio_index(one: str, other: str) -> str:
    return ratio_symbol(one, other).sub
