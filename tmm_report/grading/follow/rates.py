"""Velocities and accelerations from the student's places and from those of his rates that come before them.

Both are the vector equations of the groups, start + bend + relative = vertex; accelerations alone have a bend, the
normal or Coriolis part (see `mechanics.relations`). So there is one `Rates` for both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.grading.follow.known import Known, derived, derived_together, first
from tmm_report.grading.follow.places import Poses
from tmm_report.grading.follow.scheme import Group, Scheme
from tmm_report.grading.follow.sheet import Names, Other, Same, Sheet, names
from tmm_report.grading.follow.together import solved_together
from tmm_report.mechanics.calculus.vectors import components, dot, dual
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.vector_equations import Branch, turns_with
from tmm_report.records import dataclass

Array = Any
STILL = Known(0j)


@dataclass(eq=False)
class Rates:
    """`points`: velocities or accelerations of points; `links`: angular ones, + counter-clockwise; `spins`: what turns
    an arm into the motion of its end about its start, iω or iε − ω²; `relatives`: by key of the relative velocity."""

    letter: str
    sheet: Sheet
    scheme: Scheme
    poses: Poses
    values: Mapping[str, Array]
    velocities: Rates | None = None
    points: dict[str, Known] = field(default_factory=dict)
    links: dict[str, Known] = field(default_factory=dict)
    spins: dict[str, Known] = field(default_factory=dict)
    relatives: dict[str, Known] = field(default_factory=dict)
    bends: dict[str, Known] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.links[FRAME], self.spins[FRAME] = Known(0.0), STILL
        self._driver()
        for group, branches in self.scheme.steps:
            self._group(group, branches)

    @property
    def motion(self) -> Motion:
        return self.poses.motion

    # ------------------------------------------------------------ what the numbers are called

    def _names(self, point: str) -> Names:
        key = f"{self.letter}_{point}"
        travel = next((t for t in self.poses.travels if t.slider and t.name == point), None)
        if travel is None:
            return names(key)
        along = travel.direction + 0j

        def vector(number: Array, so_far: Array) -> Array:
            if not (number < 0).any():
                number = np.abs(number) * np.where(dot(along, so_far) < 0, -1.0, 1.0)
            return number * along

        return names(key, Other(f"{self.letter.upper()}_{point}", lambda v: dot(along, v), vector))

    def _same(self, link: str) -> Same | None:
        travel = next((t for t in self.poses.travels if not t.slider and t.name == link), None)
        if travel is None:
            return None
        sign, key = float(np.real(travel.direction)), "omega" if self.letter == "v" else "epsilon"
        return Same(f"{key}_{link}", lambda w: sign * w, lambda number: sign * number)

    def _rate_key(self, link: str) -> str:
        return f"{'w' if self.letter == 'v' else 'e'}_{link}"

    def relative_key(self, branch: Branch) -> str:
        return branch.v_key if self.letter == "v" else branch.a_key("t" if branch.turns else "r")

    def right(self, point: str) -> Array:
        """The right motion of a point, which may be one that just coincides with a joint."""
        key = f"{self.letter}_{point}"
        if key in self.values:
            return self.values[key]
        return self.motion.velocity(point) if self.letter == "v" else self.motion.acceleration(point)

    def right_rate(self, link: str) -> Array:
        return (self.motion.angular_velocity if self.letter == "v" else self.motion.angular_acceleration)(
            link
        )

    def of(self, point: str | None) -> Known:
        """The motion of a point; of a fixed one none."""
        return STILL if point is None else self.points.get(point, STILL)

    # ------------------------------------------------------------ links and their points

    def _driver(self) -> None:
        link = self.motion.linkage.mechanism.driver.link
        pivot = self.scheme.bases[link]
        self._turn(link, self._by_pins(link, pivot) if self.velocities is None else [])
        for point in self.poses.first_of(link):
            choices = [self.on_link(link, point)]
            if (
                self.velocities is not None and self.motion.phase is None
            ):  # else it has a tangential part, too
                arm, speed = self.poses.arm(link, pivot, point), self.velocities.points[point]
                choices.append(derived(self.right(point), _towards_start, speed, arm))
            self._point(point, choices)

    def _by_pins(self, link: str, pivot: str) -> Iterator[Known]:
        """The driving link's angular velocity by the velocities of its points that the student states."""
        for point in self.poses.first_of(link):
            right = self.right(point)
            for own in self.sheet.own_vector(self._names(point), right):
                yield derived(self.right_rate(link), _turning, own, self.poses.arm(link, pivot, point))

    def _turn(self, link: str, choices: Iterable[Known]) -> None:
        """A link's angular velocity or acceleration, and its spin."""
        rate = Known(self.right_rate(link))
        if link in self.poses.turning:
            rate = self.sheet.number(self._rate_key(link), rate.value, *choices, same=self._same(link))
        self.links[link] = rate
        if self.velocities is None:
            self.spins[link] = derived(1j * rate.value, lambda w: 1j * w, rate)
        else:
            right = self.motion.state.ie[link] + np.zeros(self.motion.shape)
            speed = self.velocities.links[link]
            self.spins[link] = derived(right, lambda w, e: 1j * e - w * w, speed, rate)

    def on_link(self, link: str, point: str) -> Known:
        """The motion of a link's point by that of the link's base."""
        base = self.scheme.bases[link]
        arm = self.poses.arm(link, self.scheme.joint(base), self.scheme.joint(point))
        return derived(
            self.right(point), lambda v, spin, d: v + spin * d, self.of(base), self.spins[link], arm
        )

    def _point(self, point: str, choices: Sequence[Known]) -> None:
        self.points[point] = self.sheet.vector(self._names(point), self.right(point), *choices)

    def _rest(self, link: str, branches: Sequence[Branch]) -> None:
        """Points of a link beside its joints in the group: by its turning, or divided as the link is."""
        turning = [branch for branch in branches if branch.turns and branch.link == link]
        for point in self.poses.first_of(link):
            if point not in self.points:
                divided = [one for branch in turning for one in self._divided(branch, point)]
                self._point(point, [*divided, self.on_link(link, point)])

    def _divided(self, branch: Branch, point: str) -> list[Known]:
        """By similarity: between start and vertex of a branch, and along its relative motion from the start."""
        assert branch.arm is not None
        ratio = derived_ratio(
            self.poses.arm(branch.link, branch.arm[0], self.scheme.joint(point)),
            self.poses.arm(branch.link, *branch.arm),
        )
        right, start = self.right(point), self.of(branch.start)
        bend = self.bends.get(branch.pair, STILL)
        relative = self.relatives[branch.v_key]
        return [
            derived(right, lambda a, b, part: a + (b - a) * part, start, self.of(branch.end), ratio),
            derived(right, lambda a, n, t, part: a + (n + t) * part, start, bend, relative, ratio),
        ]

    # ------------------------------------------------------------ groups

    def _group(self, group: Group, branches: tuple[Branch, ...]) -> None:
        for branch in branches:
            if branch.start is not None and branch.link not in group.links:
                self._start(branch.link, branch.start)
        if self.velocities is not None:
            for branch in branches:
                if branch.has_bend:
                    self.bends[branch.pair] = self._bend(branch, self.velocities)
        found = self._equation(group, branches)
        own = {link: self._own_rate(link, branches, found) for link in group.links}
        for same in _by_vertices(branches, set(self.points)):
            self._vertex(same, found, own)
        for link, source in turns_with(group).items():
            choices = self._rates_of(link, branches, found) if source is None else [self.links[source]]
            self._turn(link, choices)
        for link in group.links:
            self._rest(link, branches)

    def _start(self, link: str, point: str) -> None:
        """A point of a known guide that coincides with a joint."""
        if point not in self.points and point in self.scheme.coinciding:
            before = [b for _, branches in self.scheme.steps for b in branches if b.v_key in self.relatives]
            turning = [branch for branch in before if branch.turns and branch.link == link]
            divided = [one for branch in turning for one in self._divided(branch, point)]
            self._point(point, [*divided, self.on_link(link, point)])

    def _bend(self, branch: Branch, velocities: Rates) -> Known:
        """Normal acceleration by the relative or by the angular velocity, or Coriolis acceleration."""
        key, relative = branch.a_key("n" if branch.turns else "k"), velocities.relatives[branch.v_key]
        right, rate = self.values[key], velocities.links[branch.link]
        if branch.arm is None:
            return self.sheet.vector(
                names(key), right, derived(right, lambda v, w: 2j * w * v, relative, rate)
            )
        arm = self.poses.arm(branch.link, *branch.arm)
        by_rate = derived(right, lambda w, d: -w * w * d, rate, arm)
        return self.sheet.vector(names(key), right, derived(right, _towards_start, relative, arm), by_rate)

    def _equation(self, group: Group, branches: tuple[Branch, ...]) -> Mapping[str, Known]:
        """Relative motions by keys of relative velocities, vertices and angular rates by theirs, from the group's own
        equations alone."""
        if isinstance(group, Dyad):
            return self._plan(*branches)
        return solved_together(self, group, branches)

    def _plan(self, left: Branch, right: Branch) -> Mapping[str, Known]:
        """The plan of a dyad: both branches meet in the vertex."""
        vertex = self.right(left.end)
        rights = [vertex, *(self.right_relative(branch) for branch in (left, right))]
        sides = [part for b in (left, right) for part in (self.of(b.start), self._bend_of(b), self._along(b))]
        together = derived_together(rights, _meeting, *sides)
        keys = (f"{self.letter}_{left.end}", self.relative_key(left), self.relative_key(right))
        # of a fixed start the relative motion is the vertex's own: it comes last, and is the same
        return dict(zip(keys, together, strict=True))

    def _bend_of(self, branch: Branch) -> Known:
        return self.bends.get(branch.pair, STILL) if branch.has_bend else STILL

    def right_relative(self, branch: Branch) -> Array:
        key = self.relative_key(branch)
        return self.values[key] if key in self.values else self.right(branch.end)

    def _along(self, branch: Branch) -> Known:
        """Direction of a branch's unknown vector."""
        if branch.arm is not None:
            arm = self.poses.arm(branch.link, *branch.arm)
            return Known(1j * arm.value, arm.told, arm.sources)
        link, along = self.scheme.guide(branch)
        u = self.poses.u[link]
        return Known(u.value * along, u.told, u.sources)

    # ------------------------------------------------------------ numbers of a group

    def _own_rate(self, link: str, branches: Sequence[Branch], found: Mapping[str, Known]) -> Known | None:
        """The student's angular rate of a link; None where he gives none."""
        same = self._same(link)
        if not self.sheet.gives(self._rate_key(link), same.key if same else ""):
            return None
        choices = self._by_equations(link, branches, found)
        computed = choices[0].value if choices else self.right_rate(link)
        return first(computed, self.sheet.own_number(self._rate_key(link), computed, same))

    def _vertex(
        self, branches: Sequence[Branch], found: Mapping[str, Known], own: Mapping[str, Known | None]
    ) -> None:
        """The branches that meet in a vertex, then the vertex."""
        end, sums = branches[0].end, []
        for branch in branches:
            if self._is_vertex(branch):
                sums += self._back(branch, own)
            else:
                relative = self._relative(branch, found, own)
                parts = self.of(branch.start), self._bend_of(branch), relative
                sums.append(derived(self.right(end), lambda a, n, t: a + n + t, *parts))
        equation = found.get(f"{self.letter}_{end}")
        self._point(end, [*sums, *([equation] if equation else [])])
        for branch in branches:
            if self._is_vertex(branch):
                self.relatives[branch.v_key] = self.points[end]

    def _is_vertex(self, branch: Branch) -> bool:
        """Whether the relative motion is the vertex's own: its start is fixed, and it has no bend."""
        return self.relative_key(branch) == f"{self.letter}_{branch.end}"

    def _relative(self, branch: Branch, found: Mapping[str, Known], own: Mapping[str, Known | None]) -> Known:
        key, right = self.relative_key(branch), self.right_relative(branch)
        known = self.sheet.vector(names(key), right, *self._back(branch, own), found[key])
        self.relatives[branch.v_key] = known
        return known

    def _back(self, branch: Branch, own: Mapping[str, Known | None]) -> list[Known]:
        """The relative motion by the link's angular rate, where the student states it."""
        rate = own.get(branch.link)
        if rate is None or branch.arm is None:
            return []
        arm = self.poses.arm(branch.link, *branch.arm)
        return [derived(self.right_relative(branch), lambda w, d: 1j * w * d, rate, arm)]

    def _rates_of(self, link: str, branches: Sequence[Branch], found: Mapping[str, Known]) -> list[Known]:
        """A link's angular rate by its relative motions, the student's own first."""
        right, own = self.right_rate(link), []
        for branch in branches:
            if branch.arm is not None and branch.link == link:
                arm = self.poses.arm(link, *branch.arm)
                own.append(derived(right, _turning, self.relatives[branch.v_key], arm))
        return own + self._by_equations(link, branches, found)

    def _by_equations(self, link: str, branches: Sequence[Branch], found: Mapping[str, Known]) -> list[Known]:
        """A link's angular rate by the group's own equations alone."""
        if f"link {link}" in found:
            return [found[f"link {link}"]]
        arms = [(b, self.poses.arm(link, *b.arm)) for b in branches if b.arm is not None and b.link == link]
        right = self.right_rate(link)
        return [derived(right, _turning, found[self.relative_key(b)], arm) for b, arm in arms]


# ---------------------------------------------------------------- formulas


def _towards_start(v: Array, arm: Array) -> Array:
    """v²/l against the arm."""
    return -(np.abs(v / arm) ** 2) * arm


def _turning(v: Array, arm: Array) -> Array:
    return (v / (1j * arm)).real


def derived_ratio(part: Known, whole: Known) -> Known:
    return derived(part.value / whole.value, lambda a, b: a / b, part, whole)


def _meeting(a: Array, n: Array, e: Array, b: Array, m: Array, f: Array) -> list[Array]:
    """a + n + x·e = b + m + y·f: the sum, x·e and y·f."""
    x, y = components(b + m - a - n, *dual(e, f))
    return [a + n + x * e, x * e, y * f]


def _by_vertices(branches: Sequence[Branch], known: set[str]) -> list[list[Branch]]:
    """Branches that end in the same point, in an order in which their starts are known."""
    waiting, found = list(branches), []
    while waiting:
        ready = (b for b in waiting if b.start is None or b.start in known)
        end = next(ready, waiting[0]).end
        found.append([branch for branch in waiting if branch.end == end])
        waiting = [branch for branch in waiting if branch.end != end]
        known.add(end)
    return found
