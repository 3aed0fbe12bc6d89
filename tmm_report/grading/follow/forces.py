"""Forces from accelerations, reactions from forces, the balancing moment from reactions, powers from both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.course import room
from tmm_report.grading.follow.known import Known, derived, derived_together
from tmm_report.grading.follow.places import Group, Poses
from tmm_report.grading.follow.rates import Rates
from tmm_report.grading.follow.sheet import Names, Other, Sheet, names
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever import from_read_values
from tmm_report.mechanics.lever.dyads import Dyad, State
from tmm_report.mechanics.lever.forces.reactions import Load, Reaction
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Loading

Array = Any


@dataclass(eq=False)
class Forces:
    """`on`: link -> what loads it, as Known without values; `rest`: link -> its load with the reactions of the groups
    already solved; `forces`: by keys of the reactions, of their first link on the second."""

    sheet: Sheet
    poses: Poses
    velocities: Rates
    accelerations: Rates
    found: Kinetostatics
    on: dict[str, list[Known]] = field(default_factory=dict)
    rest: dict[str, Load] = field(default_factory=dict)
    forces: dict[str, Known] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.say: Any = room("kinetostatics", "quantities.positions")
        self.solver: Any = room("kinetostatics", "solve.positions")
        self.lengths: Any = room("kinetostatics", "solve.lengths")
        self.ties: Any = room("kinetostatics", "ties")
        self.state: State = self.poses.state()
        loads = self._loads()
        self._resultants(loads)
        for group in reversed(self.poses.motion.linkage.groups):
            self._group(group)
        powers = self._powers(loads)
        self._moment(powers)

    # ------------------------------------------------------------ loads

    def _loads(self) -> Loads:
        right, given = self.found.table.loading, self.found.given
        inertia = {link: self._inertia(link, force) for link, force in right.inertia.items()}
        couples = {link: self._couple(link, couple) for link, couple in right.couples.items()}
        gravity = {link: self._stated(self.say.weight(link).key, f) for link, f in right.gravity.items()}
        stated = zip(self.say.forces(given.forces), given.forces, right.forces, strict=True)
        forces = [
            self._pulled(of.key, one, f) if isinstance(one, self.ties.End) else self._stated(of.key, f)
            for of, one, f in stated
        ]
        moments = [
            self.sheet.number(of.key, f)
            for of, f in zip(self.say.moments(given.moments), right.moments, strict=True)
        ]
        return Loads(gravity, inertia, couples, forces, moments)

    def _stated(self, key: str, right: Array) -> Known:
        """A force that is given: the student's own, by components or along its right direction."""
        return self.sheet.vector(names(key), right)

    def _pulled(self, key: str, end: Any, right: Array) -> Known:
        """The force of a spring or damper on one of its points, by the student's places and velocities."""
        motion, law = self._motion, self.lengths.law_of(end.tie, self.found.kinematics)
        one, other = end.at, end.way.point
        carriers = motion.linkage.carriers
        apart = motion.place(other) - motion.place(one)
        size = np.nanmax(np.abs(self.poses.motion.places))

        def by_motion(slow: Array, fast: Array, _: Array) -> Array:
            return self.lengths.along(self.lengths.between(apart, fast - slow, size), law)[0]

        moving = tuple(sorted({carriers[one], carriers[other]} & set(motion.linkage.mechanism.moving)))
        speeds = self.velocities.of(one), self.velocities.of(other)
        return self.sheet.vector(
            names(key), right, derived(right, by_motion, *speeds, self.poses.known(moving))
        )

    @property
    def _motion(self) -> Any:
        """At the student's places."""
        return replace(self.poses.motion, state=self.state, _arms={})

    def _inertia(self, link: str, right: Array) -> Known:
        mass, centre = self.poses.link(link).mass, str(self.poses.link(link).mass_centre)
        acceleration = self.accelerations.of(centre)
        by_mass = derived(right, lambda a: -mass * a, acceleration)
        return self.sheet.vector(names(self.say.inertia_force(link).key), right, by_mass)

    def _couple(self, link: str, right: Array) -> Known:
        inertia = self.poses.link(link).inertia
        by_rate = derived(right, lambda e: -inertia * e, self.accelerations.links[link])
        return self.sheet.number(self.say.inertia_couple(link).key, right, by_rate)

    def _resultants(self, loads: Loads) -> None:
        motion, given = self._motion, self.found.given
        self.rest = self.solver.resultants(given, motion, loads.values(self.found.table.loading))
        self.on = {link: [] for link in self.rest}
        for part in (loads.gravity, loads.inertia, loads.couples):
            for link, known in part.items():
                self.on[link].append(known)
        for force, known in zip(given.forces, loads.forces, strict=True):
            self.on[self.solver.loaded_link(motion, force)].append(known)
        for moment, known in zip(given.moments, loads.moments, strict=True):
            self.on[moment.on].append(known)

    # ------------------------------------------------------------ reactions

    def _group(self, group: Group) -> None:
        """Reactions of a group under the student's loads, the reactions of the groups on it among them."""
        pairs = [*group.group.outer, *group.group.inner]
        if isinstance(group, Dyad):
            pairs = [group.outer_a, group.outer_b, group.inner]
        right = [self._right(pair.key) for pair in pairs]
        carriers = {pair.links[0] for pair in pairs}
        inputs = [known for link in group.links for known in self.on[link]]
        inputs.append(self.poses.known(tuple(sorted({*group.links, *carriers}))))
        rights = [part for one in right for part in (one.force, one.moment)]

        def balanced(*_: Array) -> list[Array]:
            solved = {r.pair.key: r for r in from_read_values.balance(self.state, group, self.rest)}
            found = [solved[pair.key] for pair in pairs]
            return [part for one in found for part in (one.force, one.moment + np.zeros(self._shape))]

        parts = derived_together(rights, balanced, *inputs)
        own = self._named(group, right, parts[::2], inputs)
        for reaction, force, moment in zip(right, own, parts[1::2], strict=True):
            self._keep(group, reaction, force, self._guide(reaction, force, moment))

    @property
    def _shape(self) -> tuple[int, ...]:
        return self.poses.motion.shape

    def _right(self, key: str) -> Reaction:
        reaction, zero = self.found.table.statics.reactions[key], np.zeros(self._shape)
        return replace(reaction, force=reaction.force + zero, moment=reaction.moment + zero)

    def _named(
        self, group: Group, right: Sequence[Reaction], solved: Sequence[Known], inputs: Sequence[Known]
    ) -> list[Known]:
        """The student's own reactions; those of a dyad also by its force polygons."""
        found: list[Known] = []
        for k, (reaction, known) in enumerate(zip(right, solved, strict=True)):
            polygon = self._polygons(group, reaction, k, found, inputs) if isinstance(group, Dyad) else []
            found.append(
                self.sheet.vector(self._reaction(*reaction.pair.links), reaction.force, *polygon, known)
            )
        return found

    def _polygons(
        self, d: Dyad, reaction: Reaction, k: int, before: Sequence[Known], inputs: Sequence[Known]
    ) -> list[Known]:
        """The second outer reaction by the first, and the inner one by each, from the equilibrium of forces."""
        a, b = self.rest[d.a].force, self.rest[d.b].force
        loads = [Known(0.0, one.told, one.sources) for one in inputs]
        if k == 0:
            return []
        if k == 1:
            return [derived(reaction.force, lambda r, *_: -(a + b + r), before[0], *loads)]
        sign = 1 if reaction.pair.links[1] == d.a else -1
        by_a = derived(reaction.force, lambda r, *_: -sign * (a + r), before[0], *loads)
        by_b = derived(reaction.force, lambda r, *_: sign * (b + r), before[1], *loads)
        return [by_a, by_b]

    def _reaction(self, by: str, on: str) -> Names:
        angle = Other(
            self.say.reaction_angle(by, on).key,
            lambda force: np.degrees(np.angle(force)) % 360,
            lambda degrees, so_far: np.abs(so_far) * np.exp(1j * np.radians(degrees)),
            before=True,
        )
        return names(self.say.reaction(by, on).key, angle)

    def _guide(self, reaction: Reaction, force: Known, moment: Known) -> Known:
        """The moment in a guide, and where along it the normal force alone would act."""
        if reaction.along is None:
            return moment
        pair = reaction.pair
        moment = self.sheet.number(self.say.guide_moment(*pair.links).key, reaction.moment, moment)
        along = self._along(reaction)
        right = reaction.offset + np.zeros(self._shape)
        offset = derived(right, lambda m, r, t: m / cross(t, r), moment, force, along)
        self.sheet.number(self.say.guide_offset(*pair.links, pair.name).key, right, offset)
        return moment

    def _along(self, reaction: Reaction) -> Known:
        carrier = reaction.pair.other(reaction.pair.slider)
        u, along = self.poses.u[carrier], reaction.pair.along[carrier]
        return Known(u.value * along + np.zeros(self._shape), u.told, u.sources)

    def _keep(self, group: Group, right: Reaction, force: Known, moment: Known) -> None:
        """Pass an outer reaction on to the link on which the group hangs."""
        self.forces[right.pair.key] = force
        carrier = right.pair.links[0]
        if carrier in self.rest and carrier not in group.links:
            s, pair = self.state, right.pair
            link = pair.slider or pair.links[1]
            acting = replace(right, force=force.value, moment=moment.value, at=s.world(link, pair.at[link]))
            self.rest[carrier] = from_read_values.passed_on(s, self.rest[carrier], acting)
            self.on[carrier] += [force, moment]

    # ------------------------------------------------------------ the balancing moment

    def _moment(self, power: Known) -> None:
        linkage, table = self.poses.motion.linkage, self.found.table
        link, pair = linkage.mechanism.driver.link, linkage.structure.driver_pair
        load, inputs = self.rest[link], [*self.on[link], self.poses.known((link,))]
        gear, omega = linkage.mechanism.driver.gear, linkage.mechanism.driver.omega
        pushed = gear.force(-load.moment, omega) if gear else 0.0
        force = derived(self._right(pair.key).force, lambda *_: -load.force - pushed, *inputs)
        self.sheet.vector(self._reaction(*pair.links), self._right(pair.key).force, force)
        speed = self.velocities.links[link]
        lever = derived(table.lever, lambda n, w: -n / w, power, speed)
        moment = derived(table.balancing, lambda *_: -load.moment, *inputs)
        if linkage.mechanism.driver.stroke is not None:  # no moment acts on the link to which it is reduced
            moment = lever
        known = self.sheet.number(self.say.BALANCING_MOMENT.key, table.balancing, moment, lever)
        if (stroke := linkage.mechanism.driver.stroke) is not None:
            transfer = stroke.transfer(stroke.law.of_phase(table.motion.phase)[0])
            force = derived(table.statics.driving, lambda m: m * transfer, known)
            self.sheet.number(self.say.ALONG_STROKE.key, table.statics.driving, force)
        self.sheet.number(self.say.BY_LEVER.key, table.lever, lever)
        self.sheet.number(self.say.BY_POWER.key, table.power, lever)

    def _powers(self, loads: Loads) -> Known:
        """The powers of the loads, and their sum."""
        rows, right = self._rows(loads), self.found.table.powers
        found = [
            self.sheet.number(self.say.power(of).key, right[k], row)
            for k, (of, row) in enumerate(zip(self.say.loads_of_powers(self.found), rows, strict=True))
        ]
        total = np.sum(right, axis=0)
        by_rows = derived(total, lambda *powers: np.sum(powers, axis=0), *found)
        return self.sheet.number(self.say.TOTAL_POWER.key, total, by_rows)

    def _rows(self, loads: Loads) -> list[Known]:
        right, v, w = iter(self.found.table.powers), self.velocities.of, self.velocities.links
        given, links = self.found.given, self.poses.link
        rows = [
            derived(
                next(right), lambda f, g, v: dot(f + g, v), f, loads.gravity[x], v(str(links(x).mass_centre))
            )
            for x, f in loads.inertia.items()
        ]
        forces = zip(given.forces, loads.forces, strict=True)
        rows += [derived(next(right), dot, f, v(stated.at)) for stated, f in forces]
        rows += [derived(next(right), np.multiply, c, w[x]) for x, c in loads.couples.items()]
        moments = zip(given.moments, loads.moments, strict=True)
        return rows + [derived(next(right), np.multiply, c, w[stated.on]) for stated, c in moments]


@dataclass(frozen=True, eq=False)
class Loads:
    """Loads of `kinetostatics.solve.Loading` as they are the student's."""

    gravity: dict[str, Known]
    inertia: dict[str, Known]
    couples: dict[str, Known]
    forces: Sequence[Known]
    moments: Sequence[Known]

    def values(self, right: Loading) -> Loading:
        return replace(
            right,
            gravity={link: known.value for link, known in self.gravity.items()},
            inertia={link: known.value for link, known in self.inertia.items()},
            couples={link: known.value for link, known in self.couples.items()},
            forces=tuple(known.value for known in self.forces),
            moments=tuple(known.value for known in self.moments),
        )
