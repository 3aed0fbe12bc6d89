"""The numbers of a drive from the machine back to the motor with the expressions that the note prints of them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import reduce
from operator import mul

from tmm_report.chapters.gears.drive.power.plan import RPM, Link
from tmm_report.chapters.gears.drive.power.solve import Found
from tmm_report.chapters.gears.drive.power.values import Shaft, Sought, Values
from tmm_report.mechanics.machine.power_chain import PER_KILOWATT
from tmm_report.quantity.formula import PI, Expr, Number, sqrt
from tmm_report.quantity.sheet import Computed, Row
from tmm_report.quantity.text import roman


class Steps:
    """`s`: the single numbers; `shafts`: a row each; `sought`: of the wheels whose teeth the division gives, by their
    names. `stages`: the drive's rows of its stages, with ratio and efficiency; `wheels`: the names of each stage's
    driving and driven wheel; `moment`: of the driving link, for whose sake the drive is, in a formula."""

    def __init__(
        self,
        found: Found,
        prefix: str,
        stages: Sequence[Row],
        wheels: Sequence[tuple[str, str]],
        moment: Expr | None = None,
    ):
        self.found, self.plan, self.stages = found, found.plan, stages
        self.s = Values(prefix=prefix)
        self.shafts = [Shaft(f"{prefix}_shafts", k, roman(k) or "0") for k in range(len(found.power))]
        self._machine(moment)
        self._losses()
        self._motor()
        self._ratios()
        self.sought = self._teeth(prefix, wheels)
        self.walk()
        self._reached()
        self._allowed()

    # ------------------------------------------------------------ what is needed

    def _machine(self, moment: Expr | None) -> None:
        """Speed, torque and useful power of the machine; of the driving link by its moment."""
        s, machine, need = self.s, self.found.given.machine, self.plan.need
        if machine is not None:
            s.force, s.D_out, s.t_out = machine.force, machine.diameter, machine.pitch
            s.z_out = machine.teeth
            s.v_out = machine.speed.value if machine.speed is not None and machine.speed.linear else None
        s.n_motor = self.plan.speed * RPM
        if need.omega is not None and need.wanted:
            s.n_out = Computed(self._turns(), need.omega * RPM) if "v_out" in s else need.omega * RPM
            s.omega_out = PI * s.n_out / 30
        elif need.omega is not None:
            whole = reduce(mul, (abs(row["u"].var(digits=5)) for row in self.stages))
            s.omega_out = PI * s.n_motor / (30 * whole)
        if "force" in s:
            s.T_out = s.force * self._round() / 2
        elif machine is not None and machine.torque is not None:
            s.T_out = machine.torque
        if moment is not None:
            s.P_out = Computed(moment * s.omega_out / 1000, need.power)
        elif "force" in s and "v_out" in s:
            s.P_out = s.force * s.v_out
        elif "T_out" in s and "omega_out" in s:
            s.P_out = s.T_out * s.omega_out / 1000
        elif need.power is not None:
            s.P_out = need.power
            if "omega_out" in s:
                s.T_out = 1000 * s.P_out / s.omega_out

    def _round(self) -> Expr:
        """The diameter at which the force pulls, mm: of a sprocket z t/π."""
        s = self.s
        return s.D_out if "D_out" in s else s.z_out * s.t_out / PI

    def _turns(self) -> Expr:
        """n, rpm, of the velocity: 60 000 v/(π D), of a sprocket 60 000 v/(z t)."""
        s = self.s
        return 60000 * s.v_out / (PI * s.D_out if "D_out" in s else s.z_out * s.t_out)

    def _losses(self) -> None:
        s, given, plan = self.s, self.found.given, self.plan
        if given.bearings.efficiency < 1 and any(plan.pairs):
            s.eta_bearings = given.bearings.efficiency
        if given.couplings is not None:
            s.eta_coupling = given.couplings.efficiency
        if given.machine is not None and given.machine.efficiency < 1:
            s.eta_out = given.machine.efficiency
        parts: list[Expr] = [row["eta"].var() for row in self.stages]
        if "eta_bearings" in s:
            parts.append(_times(s["eta_bearings"].var(), sum(plan.pairs)))
        if "eta_coupling" in s:
            count = sum(link.kind == "coupling" for link in plan.links)
            parts.append(_times(s["eta_coupling"].var(), count))
        if "eta_out" in s:
            parts.append(s["eta_out"].var())
        s.eta_total = Computed(reduce(mul, parts), plan.eta)

    def _motor(self) -> None:
        s, plan, motor = self.s, self.plan, self.found.motor
        if plan.required is not None:
            s.P_req = s.P_out / s["eta_total"].var(digits=5)
        if motor is None:
            return
        s.P_motor, s.overload = motor.power, 100 * self.found.given.overload
        if plan.range is not None:
            s.u_low, s.u_high = plan.range
        if plan.required is not None:
            s.load_factor = s.P_req / s.P_motor

    # ------------------------------------------------------------ ratios

    def _ratios(self) -> None:
        s, plan = self.s, self.plan
        if plan.u is not None:
            s.u_total = s.n_motor / s.n_out
        if plan.rest is None or plan.shares is None:
            return
        stated = [abs(row["u_required"].var()) for k, row in enumerate(self.stages) if k not in plan.shares]
        if stated:
            s.u_rest = s.u_total / reduce(mul, stated)
        rule = self.found.given.split
        if rule is not None:
            s.factor = next(one for one in (rule.slow, rule.fast, rule.step) if one is not None)
        self._shares(list(plan.shares), plan.shares)

    def _shares(self, order: Sequence[int], shares: Mapping[int, float]) -> None:
        """The ratio of every stage that had none, as its row has it: with the sense of its pair."""
        s, rule = self.s, self.found.given.split
        rest = s["u_rest" if "u_rest" in s else "u_total"].var(digits=5)
        if len(order) == 1:
            self._share(order[0], rest, shares)
        elif len(order) == 2:
            step = rule.step if rule else 1.0
            first = order[0] if step is not None or (rule and rule.fast is not None) else order[1]
            root = sqrt(Number(step) * rest) if step not in (None, 1.0) else sqrt(rest)
            factor = 1.0 if step is not None or rule is None else rule.slow or rule.fast or 1.0
            self._share(first, root if factor == 1.0 else Number(factor) * root, shares)
            other = order[1] if first == order[0] else order[0]
            self._share(other, rest / abs(self.stages[first]["u_required"].var(digits=5)), shares)
        else:
            for k in order:
                self.stages[k].put("u_required", self._signed(k, shares[k]))

    def _share(self, stage: int, expression: Expr, shares: Mapping[int, float]) -> None:
        sign = self._signed(stage, 1.0)
        found = expression if sign > 0 else -expression
        self.stages[stage].put("u_required", Computed(found, sign * shares[stage]))

    def _signed(self, stage: int, size: float) -> float:
        return math.copysign(size, self.stages[stage].number("u"))

    def _teeth(self, prefix: str, wheels: Sequence[tuple[str, str]]) -> dict[str, Sought]:
        """Both wheels of every stage whose teeth the division gives: the stated number, and the other one."""
        plan = self.plan
        rows: dict[str, Sought] = {}
        for k, exact in (plan.exact or {}).items():
            stated = 0 if plan.stages[k].teeth[0] else 1
            for place in (stated, 1 - stated):
                name = wheels[k][place]
                row = rows[name] = Sought(f"{prefix}_sought", len(rows), name)
                row.z = (plan.teeth or {})[k][place]
            u = abs(self.stages[k]["u_required"].var(digits=5))
            z = rows[wheels[k][stated]].z
            rows[wheels[k][1 - stated]].z_exact = Computed(z * u if stated == 0 else z / u, exact)
        return rows

    # ------------------------------------------------------------ shafts

    def walk(self) -> None:
        """Power, speed and torque of every shaft from those of the one before."""
        found, s = self.found, self.s
        received = found.given.shafts.at == "before bearings"
        base = s["P_motor" if found.rated else "P_req"].var("kW", digits=5)
        for k, row in enumerate(self.shafts):
            power: Expr = base
            if k:
                link = self.plan.links[k - 1]
                power = self.shafts[k - 1]["P"].var("kW", digits=5) * self._eta(link)
                row.n = Computed(self._slower(k - 1, link), found.omega[k] * RPM)
            else:
                row.n = Computed(s["n_motor"].var(), found.omega[0] * RPM)
            bearing = k - 1 if received else k
            if bearing >= 0 and "eta_bearings" in s and self.plan.pairs[bearing]:
                power = power * _times(s["eta_bearings"].var(), self.plan.pairs[bearing])
            row.P = Computed(power, float(found.power[k]))
            row.omega = PI * row.n / 30
            row.T = Computed(self._torque(row), float(found.torque[k]))

    def _torque(self, row: Shaft) -> Expr:
        power = row["P"].var("kW", digits=5)
        if self.found.given.shafts.torque == 9550:
            return Number(PER_KILOWATT) * power / row["n"].var(digits=5)
        return Number(1000) * power / row["omega"].var(digits=5)

    def _eta(self, link: Link) -> Expr:
        if link.kind == "coupling":
            return self.s["eta_coupling"].var()
        return self.stages[link.stage]["eta"].var()

    def _slower(self, before: int, link: Link) -> Expr:
        n = self.shafts[before]["n"].var(digits=5)
        return n if link.kind == "coupling" else n / abs(self.stages[link.stage]["u"].var(digits=5))

    # ------------------------------------------------------------ what comes of it

    def _reached(self) -> None:
        """The machine's speed with this drive, and its deviation."""
        s, found = self.s, self.found
        n = self.shafts[-1]["n"].var(digits=6)
        if "D_out" in s or "z_out" in s:
            around = PI * s.D_out if "D_out" in s else s.z_out * s.t_out
            s.v_actual = n * around / 60000
        if found.deviation is None or found.given.machine is None or found.given.machine.speed is None:
            return
        got, wanted = (s["v_actual"].var(digits=6), s.v_out) if "v_out" in s else (n, s.n_out)
        s.delta_n = Computed((got - wanted) / wanted * Number(100), 100 * found.deviation)

    def _allowed(self) -> None:
        s, found = self.s, self.found
        if found.motor is None:
            return
        s.P_allowed = s.P_motor * s["eta_total"].var(digits=5)
        power = s["P_allowed"].var("kW", digits=5)
        s.T_allowed = Number(1000) * power / self.shafts[-1]["omega"].var(digits=5)
        if "v_actual" in s:
            s.F_allowed = power / s["v_actual"].var(digits=5)


def _times(eta: Expr, count: int) -> Expr:
    return eta if count == 1 else eta**count
