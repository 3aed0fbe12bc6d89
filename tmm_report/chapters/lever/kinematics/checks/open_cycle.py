"""Where the mechanism cannot be assembled over part of the cycle, in words: which group, for which angles, the cure.

Angles here are those of turn from position 0, rad, over one cycle.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.checks.cure_of_length import cause
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.high_class.newton import Run
from tmm_report.mechanics.lever.singular import Critical, swept
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.records import dataclass

Array = Any
Interval = tuple[float, float]
FULL_TURN = 2 * np.pi
LEAST_PLACES, MOST_PLACES = 2, 10
ZERO = 1e-9  # rad: a group followed from within this of position 0 is followed from there
MOST = 6  # angles that are told one by one
LEAP = 1e-6  # of unit vectors: a link that turns by more in a corner jumps


@dataclass(frozen=True)
class Gap:
    """A group that cannot be assembled over part of the cycle: why, and what would cure it.

    `intervals`: without the group; one across position 0 goes on beyond a turn. `jam`: of a group above class II, where
    the mechanism jams and what lies beyond; None of a dyad, whose ends of intervals say it.
    """

    group: str  # label
    links: tuple[str, ...]
    intervals: tuple[Interval, ...]
    why: Message
    cure: Message
    jam: Message | None = None

    @property
    def path(self) -> tuple[str, ...]:
        """The link that is too short or too long, in the file."""
        return ("mechanism", "links", self.links[0])

    @property
    def text(self) -> Message:
        """E.g. "rod AB = 50 mm cannot reach guide x for 30° < φ < 150°; it needs at least 100 mm"."""
        if self.jam is not None:
            return Message("%(jam)s; %(cure)s", {"jam": self.jam, "cure": self.cure})
        return Message(
            N_("%(why)s for %(where)s (φ is the angle of rotation from position 0); %(cure)s"),
            {"why": self.why, "where": angles(self.intervals), "cure": self.cure},
        )

    @property
    def problem(self) -> Problem:
        """The group that cannot be assembled at all, or at no position of the table, as a mistake."""
        if sum(end - start for start, end in self.intervals) >= FULL_TURN - 1e-9:
            return mistake(N_("%(why)s at any position"), self.path, self.cure, why=self.why)
        text = N_("no position of the table, or none of the diagrams, exists: %(why)s for %(where)s")
        return mistake(text, self.path, self.cure, why=self.why, where=angles(self.intervals))


def gaps(cycle: Cycle) -> tuple[Gap, ...]:
    """Every group that cannot be assembled over part of the cycle, or does not come back after a turn."""
    found = []
    for critical in cycle.critical:
        intervals = tuple(sorted(_turned_intervals(cycle, critical)))
        jam = _jam(cycle, critical, intervals)
        if intervals or jam:
            why, cure = cause(_swept(cycle, critical), bool(intervals))
            group = critical.group
            found.append(Gap(group.group.label, group.links, intervals, why, cure, jam))
        elif poles := _turned_poles(cycle, critical):
            found.append(_runaway(critical, poles))
        elif (corner := _leap(cycle, critical)) is not None:
            found.append(_leaping(critical, corner))
    return tuple(found)


def _swept(cycle: Cycle, critical: Critical) -> Critical:
    """What a driving link that turns over a part of a turn asks of the lengths: nothing beyond its range."""
    if cycle.law is not None:
        low, high = cycle.law.reach
        return critical if high - low >= FULL_TURN else swept(cycle.linkage, critical, low, high)
    if cycle.closed:
        return critical
    return swept(cycle.linkage, critical, *sorted((cycle.zero, cycle.zero + cycle.sense * cycle.sweep)))


RUNAWAY = N_(
    "at the angle of rotation φ = %(angles)s the guides of group %(group)s (links %(links)s) are parallel and "
    "its links run away"
)


def _turned_poles(cycle: Cycle, critical: Critical) -> list[float]:
    """Where guides of a dyad are parallel, within the cycle; what is only just beyond a turn is position 0."""
    turned = cycle.turned_at(critical.parallel)
    turned = np.where(FULL_TURN - turned < ZERO, 0.0, turned)
    return sorted(turned[turned <= cycle.sweep].tolist())


def _runaway(critical: Critical, poles: list[float]) -> Gap:
    """A dyad that exists beside these angles, but goes to infinity towards them: no mechanism goes through that."""
    group = critical.group.group.label
    values = {
        "group": group,
        "links": ", ".join(critical.group.links),
        "angles": listed_angles(np.array(poles)),
    }
    why, cure = (
        Message(RUNAWAY, values),
        Message(N_("other directions of the guides keep it away from there")),
    )
    return Gap(group, critical.group.links, (), why, cure, jam=why)


LEAPS = N_(
    "at the angle of rotation φ = %(angle)s two joints of group %(group)s (links %(links)s) fall together, and "
    "its two assemblies meet: kept in the stated one its links jump there, and gone through smoothly they would "
    "begin the next turn in the other. Extremes are sought on both sides of the jump"
)


def _leap(cycle: Cycle, critical: Critical) -> float | None:
    """The angle of turn of the corner in which links of the group jump to other places, within the cycle; None where
    there is none: in other corners they only turn back."""
    corner = getattr(critical.group, "corner", None)
    if corner is None:
        return None
    turned = float(cycle.turned_at([corner])[0])
    turned = 0.0 if FULL_TURN - turned < ZERO else turned
    if turned > cycle.sweep:
        return None
    before, after = (cycle.beside(np.array([turned]), side) for side in (-1, 1))
    jumps = [abs(after.turn(link) - before.turn(link))[0] for link in critical.group.links]
    return float(turned) if max(jumps) > LEAP else None


def _leaping(critical: Critical, corner: float) -> Gap:
    group, links = critical.group.group.label, ", ".join(critical.group.links)
    why = Message(LEAPS, {"group": group, "links": links, "angle": listed_angles(np.array([corner]))})
    cure = Message(N_("other lengths of links %(links)s keep away from it"), {"links": links})
    return Gap(group, critical.group.links, (), why, cure, jam=why)


def _turned_intervals(cycle: Cycle, critical: Critical) -> Iterator[Interval]:
    """Intervals without the group, within the cycle; one across position 0 goes on beyond a turn."""
    if cycle.law is not None:
        yield from _phases_within(cycle, critical)
        return
    for first, last in critical.gaps:
        width = last - first
        if width >= FULL_TURN - 1e-12:
            yield 0.0, cycle.sweep
            continue
        start = np.mod((first if cycle.sense > 0 else -last) - cycle.sense * cycle.zero, FULL_TURN)
        if cycle.closed:
            yield float(start), float(start + width)
            continue
        for low in (start, start - FULL_TURN):
            a, b = max(low, 0.0), min(low + width, cycle.sweep)
            if a < b:
                yield float(a), float(b)


def _phases_within(cycle: Cycle, critical: Critical) -> Iterator[Interval]:
    """The same of a driving link that moves by a law of the time: it may come back to an angle."""
    ends = np.unique(np.concatenate([[0.0], cycle.turned_at(np.ravel(critical.gaps)), [cycle.sweep]]))
    middles = cycle.phi((ends[:-1] + ends[1:]) / 2)
    lost = [
        any(np.mod(phi - first, FULL_TURN) < last - first for first, last in critical.gaps) for phi in middles
    ]
    start: float | None = None
    for k, missing in enumerate([*lost, False]):
        if missing and start is None:
            start = float(ends[k])
        if not missing and start is not None:
            yield start, float(ends[k])
            start = None


# ---------------------------------------------------------------- intervals as people write them


def angles(intervals: tuple[Interval, ...]) -> Message:
    """ "30.00° < φ < 150.00°"; several, or the two parts of one across position 0, joined by "and"."""
    parts = [part for interval in intervals for part in _parts(*interval)]
    said = _joined(*parts[-2:]) if len(parts) > 1 else Message("%(part)s", {"part": parts[0]})
    for part in reversed(parts[:-2]):
        said = Message("%(first)s, %(rest)s", {"first": part, "rest": said})
    return said


def _joined(first: str, last: str) -> Message:
    return Message(N_("%(first)s and %(last)s"), {"first": first, "last": last})


def _parts(start: float, end: float) -> list[str]:
    """The interval as inequalities: two where it goes over position 0."""
    a, b = float(np.degrees(start)), float(np.degrees(end))
    if b <= 360 + 1e-9:
        places = _places(b - a)
        last = f"{b:.{places}f}°" if b < 360 - 1e-9 else "360°"
        return [f"{a:.{places}f}° < φ < {last}" if a else f"0° ≤ φ < {last}"]
    places = _places(min(360 - a, b - 360))
    return [f"{a:.{places}f}° < φ < 360°", f"0° ≤ φ < {b - 360:.{places}f}°"]


def _places(width: float) -> int:
    """Decimals by which both ends of an interval, degrees, differ, in two digits of its width."""
    needed = 1 - int(np.floor(np.log10(max(width, 1e-12))))
    return min(max(LEAST_PLACES, needed), MOST_PLACES)


def listed_angles(turned: Array) -> str:
    """Angles, rad, in degrees; of many the first."""
    said = [f"{x:.2f}°" for x in np.degrees(turned)]
    return ", ".join(said if len(said) <= MOST else [*said[:MOST], "…"])


def angle(turned: float, beside: float) -> str:
    """An angle, rad, in degrees, so that it differs from one `beside` it, rad."""
    return f"{np.degrees(turned):.{_places(np.degrees(abs(turned - beside)))}f}°"


# ---------------------------------------------------------------- groups above class II


def _jam(cycle: Cycle, critical: Critical, intervals: tuple[Interval, ...]) -> Message | None:
    """Where the mechanism jams in the sense of rotation, and what lies behind position 0."""
    run = getattr(critical, "run", None)
    if run is None:
        return None
    group = critical.group.group.label
    if not intervals:
        return None if run.returns else Message(ELSEWHERE, {"group": group})
    where = {"group": group, "where": angles(intervals)}
    if run.forward is None or any(run.blocked) or not cycle.closed or _elsewhere(cycle, run):
        return Message(LOST, where)
    limit = angle(run.forward, FULL_TURN)
    if not run.overlaps:
        return Message(JAMS, {**where, "limit": limit})
    if run.backward is None:
        return Message(ANOTHER_ALL_ROUND, {**where, "limit": limit})
    end = angle(FULL_TURN - run.backward, run.forward)
    return Message(ANOTHER, {**where, "limit": limit, "back": f"{np.degrees(run.backward):.2f}°", "end": end})


def _elsewhere(cycle: Cycle, run: Run) -> bool:
    """Whether a group is followed from the sketch, and not from position 0, which it cannot be brought to."""
    return abs(np.angle(np.exp(1j * (run.zero - cycle.zero)))) > ZERO


LOST = N_("group %(group)s cannot be assembled for %(where)s (φ is the angle of rotation from position 0)")
JAMS = N_(
    "turned in the sense of rotation the mechanism jams at φ = %(limit)s: group %(group)s cannot be assembled "
    "for %(where)s (φ is the angle of rotation from position 0)"
)
ANOTHER = N_(
    "turned in the sense of rotation the mechanism jams at φ = %(limit)s, where group %(group)s comes to its "
    "limit: the positions beyond, %(where)s, are left out (φ is the angle of rotation from position 0). Turned "
    "back from position 0 it can go by %(back)s, as far as φ = %(end)s, but turning on it never comes there"
)
ANOTHER_ALL_ROUND = N_(
    "turned in the sense of rotation the mechanism jams at φ = %(limit)s, where group %(group)s comes to its "
    "limit: the positions beyond, %(where)s, are left out (φ is the angle of rotation from position 0). Turned "
    "back from position 0 it can go more than a turn, but turning on it never comes there"
)
ELSEWHERE = N_(
    "after a full turn group %(group)s is in another assembly than at position 0: the motion does not repeat with the "
    "turn, and only the first turn is given"
)
