"""Spur stage of a drive: teeth, shifts, dimensions and quality of one pair of wheels, with every condition's margin.

From the centre distance, the module and the ratio to the shifts, or from the shifts to the centre distance; external
and internal pairs, straight and helical teeth. Artobolevsky, Theory of mechanisms and machines, ch. 22.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

from tmm_report.chapters.gears.spur.given import EQUAL, Given
from tmm_report.chapters.gears.spur.solve import backlash, inspection, quality
from tmm_report.chapters.gears.spur.solve.conditions import BY_ASSEMBLY, conditions_of
from tmm_report.chapters.gears.spur.solve.contour import Contour, contour_of
from tmm_report.chapters.gears.spur.solve.cutter import Cut, cutters_of
from tmm_report.chapters.gears.spur.solve.inspection import Measured, measured
from tmm_report.chapters.gears.spur.solve.mesh import Mesh, Proof, round_scale
from tmm_report.chapters.gears.spur.solve.mistakes import check, check_pair, check_teeth
from tmm_report.chapters.gears.spur.solve.motion import WIDEST, Motion, motion_of, sliding_limit
from tmm_report.chapters.gears.spur.solve.path import Path, path_of
from tmm_report.chapters.gears.spur.solve.phase import Phase, phase_of
from tmm_report.chapters.gears.spur.solve.readings import Reading, read_off
from tmm_report.chapters.gears.spur.solve.sizes import ROUNDED, Teeth, choose_shifts, choose_teeth
from tmm_report.chapters.gears.spur.words import CONDITIONS
from tmm_report.mechanics.gears import meshing, shift_sharing, trains
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.mechanics.gears.meshing import Pair, Rack
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt
from tmm_report.records import dataclass

__all__ = ["EQUAL", "Condition", "Found", "Given", "Rack", "solve"]


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `pair`: all dimensions; `path`: the line of action; `conditions`: in the order of the note;
    `mesh`: as it is drawn, `readings`: off that drawing; `motion`: at the speed of the drive, None where that is not
    known."""

    given: Given
    teeth: Teeth
    pair: Pair
    path: Path
    conditions: tuple[Condition, ...]
    mesh: Mesh
    readings: tuple[Reading, ...]
    contour: Contour
    motion: Motion | None = None

    fixed: tuple[str, ...] = ()  # members that stand still, and a second input: none in this stage
    second: None = None

    @property
    def name(self) -> str:
        return self.given.name or "-".join(self.given.wheels)

    @property
    def input(self) -> str:
        return self.given.wheels[0]

    @property
    def output(self) -> str:
        return self.given.wheels[1]

    @property
    def wanted(self) -> float:
        """The ratio that the assignment asks for."""
        return self.given.ratio

    @property
    def ratio(self) -> float:
        """ω_in/ω_out with the chosen teeth."""
        return float(self.pair.ratio)

    @property
    def efficiency(self) -> float:
        return self.given.efficiency

    @property
    def members(self) -> tuple[trains.Member, ...]:
        radii, places = self.pair.d_w, (0.0, float(self.pair.a_w))
        return tuple(
            trains.Member(name, "wheel" if sign > 0 else "ring", z, float(d) / 2, place)
            for name, sign, z, d, place in zip(
                self.given.wheels, self.pair.signs, self.teeth.z, radii, places, strict=True
            )
        )

    @property
    def meshes(self) -> tuple[trains.Mesh, ...]:
        return (
            trains.Mesh(*self.given.wheels, internal=self.given.internal, efficiency=self.given.efficiency),
        )

    @property
    def angles(self) -> tuple[float | None, ...]:
        """The operating angle of pressure of its mesh, rad."""
        return (float(self.pair.alpha_w),)

    @property
    def shares(self) -> int:
        return 1

    @property
    def sized(self) -> bool:
        return True

    @cached_property
    def starts(self) -> tuple[float, float]:
        """Radii of curvature where the involutes really begin, m."""
        return float(self.pair.starts[0]), float(self.pair.starts[1])

    # ------------------------------------------------------------ what is said of the pair

    @cached_property
    def cut_short(self) -> bool:
        """Whether the contact is shorter than between the tip circles."""
        return bool(self.pair.cut_short)

    def late(self, i: int) -> bool:
        """Whether contact at the root of wheel i ends before the other wheel's tip circle: where its involute begins,
        or where a tooth of the other comes to a point."""
        rho_m, rho_p = float(self.pair.rho_m[i]), float(self.pair.rho_p[i])
        return abs(rho_p - rho_m) > 1e-9 * float(self.pair.m)

    @property
    def failed(self) -> tuple[Condition, ...]:
        """Conditions that are not met and whose cure is other numbers."""
        return tuple(c for c in self.conditions if not c.met and c.key not in BY_ASSEMBLY)

    @property
    def axially(self) -> bool:
        """Whether the pinion cannot be put into its ring radially."""
        return any(c.key == "radial" and not c.met for c in self.conditions)

    @property
    def altered(self) -> bool:
        """Whether stated shifts were rounded, and one was changed to fill the centre distance."""
        stated = self.given.shift
        taken = float(self.pair.x1), float(self.pair.x2)
        return (
            isinstance(stated, tuple)
            and not self.given.rests
            and max(abs(a - b) for a, b in zip(stated, taken, strict=True)) > 1e-9
        )

    @property
    def sound(self) -> bool:
        """Whether every condition is met, if only by the rule of the course."""
        return all(self.met_by_rule(condition) for condition in self.failed)

    @property
    def doubts(self) -> tuple[Problem, ...]:
        """Stated shifts that were changed."""
        stated = self.given.shift
        if not self.altered or not isinstance(stated, tuple):
            return ()
        taken = float(self.pair.x1), float(self.pair.x2)
        text = N_("the shifts %(stated)s do not fill the centre distance exactly: %(taken)s are taken")
        right = Message(N_("leave out centre_distance to have the shifts taken as they are stated"))
        values = {
            key: ", ".join(f"{x:.6g}" for x in both) for key, both in (("stated", stated), ("taken", taken))
        }
        return (doubt(text, ("shift",), right, **values),)

    def summary(self) -> list[Message]:
        """What is wrong, a line each; nothing where all conditions are met."""
        if not self.failed and not self.axially:
            return []
        text = N_("gear pair %(name)s: conditions not met: %(failed)s")
        if self.sound:
            text = N_(
                "gear pair %(name)s: conditions met by the rule of the course alone, and not exactly: %(failed)s; that "
                "is no failure, and the exit code does not change"
            )
        said = [Message(text, {"name": self.name, "failed": len(self.failed)})] if self.failed else []
        for condition in self.failed:
            what = {"name": self.name, "what": Message(CONDITIONS[condition.key], {"wheel": condition.wheel})}
            by_rule = self.met_by_rule(condition)
            known = N_("gear pair %(name)s: %(what)s: met by the rule only")
            said.append(Message(known if by_rule else N_("gear pair %(name)s: %(what)s: not met"), what))
        if self.axially:
            text = N_(
                "gear pair %(name)s: the pinion is put into the ring axially, radially its teeth do not pass"
            )
            said.append(Message(text, {"name": self.name}))
        return said

    def met_by_rule(self, condition: Condition) -> bool:
        """Whether a wheel that is undercut, exactly, is not by the rule of the course."""
        least = self.rule_shifts[self.given.wheels.index(condition.wheel)] if condition.wheel else 0.0
        rounding = ROUNDED if isinstance(self.given.shift, tuple) else 1e-9
        return condition.key == "undercut" and condition.value >= least - rounding

    @property
    def loose(self) -> bool:
        """Whether the shifts leave backlash at the given distance."""
        return bool(self.pair.backlash > 1e-6 * self.pair.m)

    @property
    def beyond(self) -> bool:
        """Whether the contact passes an end of the line of action, where the sliding has no bound."""
        return bool(min(self.pair.rho_p) <= 0)

    @property
    def sliding_scale(self) -> float:
        """What 1 mm of an ordinate of the graph of specific sliding stands for: round."""
        return round_scale(max(abs(float(x)) for x in (*self.pair.root_sliding, *self.pair.tip_sliding)))

    @property
    def two_zones(self) -> bool:
        """Whether one and two pairs of teeth take turns."""
        return bool(1 < self.pair.eps < 2)

    @property
    def apart(self) -> bool:
        """Whether the outlines of the teeth share no area but that of rounding."""
        return self.proof.overlap < 1e-6 * self.pair.m**2

    @cached_property
    def phase(self) -> Phase | None:
        """With two pairs of teeth in contact; None where there is no such time."""
        return phase_of(self.pair, self.path)

    @cached_property
    def inspected(self) -> tuple[Measured, Measured]:
        """By what both wheels are measured."""
        return measured(self.given, self.pair)

    @cached_property
    def backlash(self) -> backlash.Found | None:
        """With teeth thinned and axes apart, where it is asked for."""
        return backlash.backlash_of(self.given, self.pair, self.inspected)

    @cached_property
    def quality(self) -> quality.Found | None:
        """Over the division of the shifts and over the centre distance, where it is asked for."""
        return quality.quality_of(self.given, self.teeth, self.pair)

    # ------------------------------------------------------------ pinion cutters

    @cached_property
    def cutters(self) -> tuple[Cut, ...]:
        """How wheels are cut by the stated pinion cutter; where none is, a ring by a usual one, to compare."""
        return cutters_of(self.pair)

    @property
    def cut_wheels(self) -> list[int]:
        return [cut.wheel for cut in self.cutters]

    def cut_by(self, i: int) -> bool:
        """Whether wheel i is cut by a pinion cutter."""
        return i in self.cut_wheels

    # ------------------------------------------------------------ numbers beside those of the pair

    @cached_property
    def rule_shifts(self) -> tuple[float, float]:
        """Least shifts by the course's rule (17 − z)/17."""
        return tuple(float(shift_sharing.rule_shift(z, self.pair.rack, self.pair.beta)) for z in self.teeth.z)  # type: ignore[return-value]

    @cached_property
    def involutes(self) -> tuple[float, float]:
        """Involute functions of the profile angle (in the transverse section) and of the operating one."""
        return float(inv(self.pair.t.alpha)), float(inv(self.pair.alpha_w))

    @cached_property
    def needed(self) -> float:
        """The sum of shifts that fills the distance without backlash."""
        p = self.pair
        return float(meshing.shift_sum(p.z1, p.z2, p.m, p.rack, p.beta, p.a_w, p.internal))

    @property
    def proof(self) -> Proof:
        """By the outlines over a full pitch."""
        return self.mesh.proof


def check_asked(given: Given, chosen: Teeth, pair: Pair) -> None:
    """Raises ProblemError with all that is asked of the pair and does not suit it."""
    problems = [
        *inspection.mistakes_of(given, pair),
        *backlash.mistakes_of(given, pair),
        *quality.mistakes_of(given, chosen, pair),
    ]
    if problems:
        raise ProblemError(problems)


def solve(given: Given) -> Found:
    """Raises ProblemError with every mistake and what would work."""
    check(given)
    chosen = choose_teeth(given)
    check_teeth(given, chosen)
    pair = choose_shifts(given, chosen)
    check_pair(given, pair)
    check_asked(given, chosen, pair)
    path = path_of(pair)
    limit = given.sliding_limit or WIDEST
    conditions = tuple(conditions_of(pair, given.wheels, limit))
    mesh = Mesh(pair, path.points)
    readings = read_off(mesh, given.accuracy)
    return Found(given, chosen, pair, path, conditions, mesh, readings, contour_of(pair, limit))


def moving(found: Found, speed: float) -> Found:
    """The stage with wheel 1 turning at `speed`, rad/s: its velocities, and the sliding that they allow."""
    motion = motion_of(found.pair, speed, found.path.at.rho, found.path.mates)
    limit = found.given.sliding_limit or sliding_limit(motion.pitch)
    conditions = tuple(conditions_of(found.pair, found.given.wheels, limit))
    contour = (
        found.contour if limit == (found.given.sliding_limit or WIDEST) else contour_of(found.pair, limit)
    )
    return replace(found, motion=motion, conditions=conditions, contour=contour)
