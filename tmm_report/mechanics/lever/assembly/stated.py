"""Which assembly each group takes: stated in words or signs, or by a rough sketch; never guessed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.assembly.all_roots import assemblies
from tmm_report.mechanics.lever.assembly.swings import with_middles
from tmm_report.mechanics.lever.assur_groups import KIND_NAMES, ROMAN, Group, Structure, decompose
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad, group_of
from tmm_report.mechanics.lever.dyads import Dyad, State, reach
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.loop_equations import Loops
from tmm_report.mechanics.lever.mechanism import FRAME, Assembly, Mechanism, pick
from tmm_report.mechanics.lever.motion import Linkage, drive, known_motion, positions
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
PATH = ("mechanism", "assembly")
MERGING = 3e-5  # closeness to a singular position below which a sketch does not tell two assemblies apart
CLEAR = (
    0.1  # a direction word must make at least this cosine with the guide, or it does not tell the sides apart
)


def assemble(mechanism: Mechanism) -> Linkage:
    """Decompose a mechanism and choose the assembly of every group. Raises ProblemError with all mistakes."""
    structure = decompose(mechanism)
    dyads = {g: group_of(mechanism, g) for g in structure.groups if g.kind is not None}
    problems = list(_unmatched(mechanism, list(dyads.values())))
    signs = {g: _stated_sign(mechanism, d, problems) for g, d in dyads.items()}
    linkage = _by_sketch(structure, dyads, signs, problems)
    if problems:
        raise ProblemError(problems)
    return _measured(linkage)


def _measured(linkage: Linkage) -> Linkage:
    """Dyads of kind 3 with their greatest distance over the cycle, by which they are near a singular position."""
    if all(group.group.kind != 3 for group in linkage.groups):
        return linkage
    s = positions(linkage, np.linspace(0, 2 * np.pi, 72, endpoint=False))
    groups = []
    for group in linkage.groups:
        if isinstance(group, Dyad) and not isinstance(group, CamDyad) and group.kind == 3:
            size = np.nanmax(np.atleast_1d(reach(s, group)), axis=-1, keepdims=bool(linkage.axes))
            group = replace(group, size=size if np.all(size > 0) else None)
        groups.append(group)
    return replace(linkage, groups=tuple(groups))


def keys_of(d: Dyad) -> list[str]:
    """The names by which a variant may speak of a dyad: its inner joint, or its links either way round."""
    return [d.inner.name, f"{d.a}-{d.b}", f"{d.b}-{d.a}"]


def _unmatched(mechanism: Mechanism, dyads: list[Dyad]) -> Iterator[Problem]:
    known = [key for d in dyads if d.two_roots for key in keys_of(d)[:2]]
    right = Message(N_("groups with two assemblies: %(keys)s"), {"keys": ", ".join(known) or "—"})
    for stated in mechanism.assembly:
        if not any(d.two_roots and stated.key in keys_of(d) for d in dyads):
            yield mistake(
                N_("%(key)s names no group with two assemblies"), (*PATH, stated.key), right, key=stated.key
            )
    for d in dyads:
        keys = [a.key for a in mechanism.assembly if d.two_roots and a.key in keys_of(d)]
        for key in keys[1:]:
            text = N_("the assembly of group %(group)s is stated twice: by %(one)s and by %(key)s")
            once = Message(N_("leave one of the two"))
            yield mistake(text, (*PATH, key), once, group=d.group.label, one=keys[0], key=key)


def _stated_sign(mechanism: Mechanism, d: Dyad, problems: list[Problem]) -> int | None:
    """The root that the variant states for a dyad; +1 where there is one root; None where nothing is stated."""
    if not d.two_roots:
        return 1
    stated = next((a for a in mechanism.assembly if a.key in keys_of(d)), None)
    if stated is None:
        return None
    sign = _sign(mechanism, d, stated)
    if sign is None:
        problems.append(_unclear(d, stated))
    return sign or 1


def _sign(mechanism: Mechanism, d: Dyad, stated: Assembly) -> int | None:
    """±1 of a stated choice; None where it does not tell this dyad's roots apart."""
    choice = stated.choice
    if isinstance(choice, int):
        return choice
    if isinstance(choice, tuple):
        side, *line = choice
        ends = [d.outer_a.name, d.outer_b.name]
        if d.kind != 1 or sorted(line) != sorted(ends):
            return None
        return (1 if side == "left" else -1) * (1 if line == ends else -1)
    if d.kind != 2 or d.carrier_b != FRAME:
        return None
    cosine = dot(np.ravel(d.outer_b.along[FRAME])[0], choice)
    return None if abs(cosine) < CLEAR else (1 if cosine > 0 else -1)


def _unclear(d: Dyad, stated: Assembly) -> Problem:
    text = N_("this does not tell apart the two assemblies of group %(group)s (%(kind)s)")
    values = {"group": d.group.label, "kind": KIND_NAMES[d.kind]}
    return mistake(text, (*PATH, stated.key), how_to_state(d), **values)


def how_to_state(d: Dyad) -> Message:
    """What a variant may write to choose a dyad's root."""
    if d.kind == 1:
        text = N_(
            'write "left of %(a)s-%(c)s" or "right of %(a)s-%(c)s": on which side of that line %(b)s lies'
        )
        return Message(text, {"a": d.outer_a.name, "c": d.outer_b.name, "b": d.inner.name})
    if d.kind == 2:
        text = N_(
            'write "+" if %(b)s lies ahead of the perpendicular from %(a)s to guide %(g)s, along its direction, '
            'or "-"; on a fixed guide also left, right, up, down'
        )
        return Message(text, {"a": d.outer_a.name, "b": d.inner.name, "g": d.outer_b.name})
    text = N_('write "+" if %(c)s lies ahead of %(a)s along the direction of guide %(g)s, or "-"')
    return Message(text, {"a": d.outer_a.name, "c": d.outer_b.name, "g": d.inner.name})


def _by_sketch(
    structure: Structure,
    dyads: Mapping[Group, Dyad],
    signs: Mapping[Group, int | None],
    problems: list[Problem],
) -> Linkage:
    """The linkage, its groups in the assemblies stated; those not stated take the one nearest to the sketch."""
    mechanism = structure.mechanism
    angle = sketch_angle(mechanism, structure)
    linkage = Linkage(structure, ())
    state = drive(linkage, np.array([angle or 0.0]))
    for group in structure.groups:
        chosen: Dyad | HigherGroup | None
        if group in dyads:
            chosen = _dyad_by_sketch(mechanism, state, dyads[group], signs[group], angle, problems)
        else:
            chosen = _higher_by_sketch(linkage, state, group, angle, problems)
            if chosen is None:
                return linkage
        linkage = with_middles(replace(linkage, groups=(*linkage.groups, chosen)))
        chosen = linkage.groups[-1]
        with np.errstate(invalid="ignore", divide="ignore"):
            if isinstance(chosen, Dyad):
                chosen.place(state)
            elif not linkage.axes:
                chosen.loops.place(state, chosen.start[0][1][None])
                for wheel in chosen.group.wheels:
                    wheel.place(state)
    return linkage


def _dyad_by_sketch(
    mechanism: Mechanism,
    state: State,
    d: Dyad,
    sign: int | None,
    angle: float | None,
    problems: list[Problem],
) -> Dyad:
    if sign is not None:
        return group_of(mechanism, d.group, sign)
    sign = _nearer(mechanism, state, d) if angle is not None else None
    if sign is None:
        problem = _not_told(mechanism, state, d, angle)
        if problem not in problems:
            problems.append(problem)
    return replace(group_of(mechanism, d.group, sign or 1), told_at=angle)


# ---------------------------------------------------------------- groups above class II


def _higher_by_sketch(
    before: Linkage, state: State, group: Group, angle: float | None, problems: list[Problem]
) -> HigherGroup | None:
    """The assembly of a higher group nearest to the sketch, followed from there."""
    mechanism = before.mechanism
    loops = Loops(group)
    if before.axes:  # each variant has its own
        singles = [assemble(pick(mechanism, v)) for v in range(before.axes[0])]
        found = [single.groups[len(before.groups)] for single in singles]
        parts = [(g.start[0], g.known[0], g.loops, g.senses[0]) for g in found if isinstance(g, HigherGroup)]
        start, known, own, senses = zip(*parts, strict=True)
        return HigherGroup(group, loops, start, known, own, senses)
    wanted = [p for link in group.links for p in mechanism.links[link].points if p in mechanism.sketch]
    if angle is None or not wanted:
        wordless = _no_angle(mechanism) if mechanism.sketch and angle is None else None
        problem = wordless or _needs_sketch(group, mechanism)
        if problem not in problems:
            problems.append(problem)
        return None
    ways = assemblies(loops, state)
    if not len(ways):
        problems.append(_cannot_be_assembled(group, angle))
        return None
    misses = np.array([_miss(mechanism, state, group, loops, q) for q in ways])
    first, *others = np.argsort(misses)
    if others and np.isclose(misses[first], misses[others[0]], rtol=1e-6, atol=0):
        problems.append(_unclear_sketch(group))
    if not loops.closeness(state, ways[first][None])[0] > MERGING:
        problems.append(_singular_sketch(group, angle))
        return None
    sense = 1 if float(np.ravel(mechanism.driver.omega)[0]) > 0 else -1
    return HigherGroup(group, loops, ((angle, ways[first]),), (known_motion(before),), senses=(sense,))


def _miss(mechanism: Mechanism, state: State, group: Group, loops: Loops, q: Array) -> float:
    """Sum of squared distances of a group's points from their sketched places, m²."""
    trial = placed(state, loops, q)
    return _distance(mechanism, trial, group.links)


def placed(state: State, loops: Loops, q: Array) -> State:
    """A copy of the state, in one position, with the group's links in one of its assemblies."""
    trial = replace(state, o={**state.o}, r={**state.r}, u={**state.u})
    loops.place(trial, q[None])
    return trial


def _distance(mechanism: Mechanism, state: State, links: Sequence[str]) -> float:
    return sum(
        abs(np.ravel(state.world(link, at))[0] - mechanism.sketch[point]) ** 2
        for link in links
        for point, at in mechanism.links[link].points.items()
        if point in mechanism.sketch
    )


def _needs_sketch(group: Group, mechanism: Mechanism) -> Problem:
    text = N_(
        "group %(group)s of class %(cls)s can be assembled in several ways, and only a sketch says in which "
        "(key sketch)"
    )
    points = [
        p for link in group.links for p in mechanism.links[link].points if len(mechanism.links_at(p)) > 1
    ]
    right = Message(
        N_(
            "write rough places of its points (%(points)s) and of the driving link's in some one position; "
            "tmm-report assemblies lists all that exist"
        ),
        {"points": ", ".join(dict.fromkeys(points))},
    )
    path = ("mechanism", "sketch") if mechanism.sketch else ("mechanism",)
    return mistake(
        text, path, right, group=group.label, cls=ROMAN.get(group.group_class, str(group.group_class))
    )


def _cannot_be_assembled(group: Group, angle: float) -> Problem:
    text = N_(
        "group %(group)s cannot be assembled in the position of the sketch (driving link at %(angle).1f°)"
    )
    right = Message(
        N_("check the lengths of links %(links)s and the places of their joints, or sketch another position"),
        {"links": ", ".join(group.links)},
    )
    return mistake(text, ("mechanism", "sketch"), right, group=group.label, angle=float(np.degrees(angle)))


def _unclear_sketch(group: Group) -> Problem:
    text = N_("the sketch lies equally near to two assemblies of group %(group)s")
    right = Message(N_("add more points to it, or draw it more exactly"))
    return mistake(text, ("mechanism", "sketch"), right, group=group.label)


def _singular_sketch(group: Group, angle: float) -> Problem:
    text = N_(
        "two assemblies of group %(group)s meet in the position of the sketch (driving link at %(angle).4f°), and "
        "nothing tells in which of them the motion goes on"
    )
    right = Message(N_("sketch another position; position 0 must not be a singular one either"))
    return mistake(text, ("mechanism", "sketch"), right, group=group.label, angle=float(np.degrees(angle)))


def _no_angle(mechanism: Mechanism) -> Problem:
    text = N_("the sketch has no moving point of driving link %(link)s, so its position is not known")
    return mistake(text, ("mechanism", "sketch"), Message(N_("add one")), link=mechanism.driver.link)


def _not_told(mechanism: Mechanism, state: State, d: Dyad, angle: float | None) -> Problem:
    """Why neither words nor the sketch tell a dyad's root."""
    if mechanism.sketch and angle is None:
        return _no_angle(mechanism)
    before = [d.carrier_a, d.carrier_b]
    known = all(np.isfinite(state.r[link] + state.u[link]).all() for link in before)
    if angle is not None and known and not _closes(mechanism, state, d):
        return _cannot_be_assembled(d.group, angle)
    key = keys_of(d)[0 if d.inner.kind == "R" else 1]  # a guide is no key of a variant
    text = N_("group %(group)s can be assembled in two ways and the variant does not say which (key %(key)s)")
    path = PATH if mechanism.assembly else ("mechanism", "sketch") if mechanism.sketch else ("mechanism",)
    return mistake(text, path, how_to_state(d), group=d.group.label, key=key)


def sketch_angle(mechanism: Mechanism, structure: Structure) -> float | None:
    """Angle of the driving link in the sketch, rad."""
    pair = structure.driver_pair
    for point, at in mechanism.links[mechanism.driver.link].points.items():
        arm = np.ravel(at - pair.at[mechanism.driver.link])[0]
        if point in mechanism.sketch and abs(arm) > 0:  # a point at the pivot tells nothing
            return float(np.angle((mechanism.sketch[point] - np.ravel(pair.at[FRAME])[0]) / arm))
    return None


def _nearer(mechanism: Mechanism, state: State, d: Dyad) -> int | None:
    """The root whose points lie nearer to their sketched places; None where the sketch does not tell."""
    misses = {}
    for sign in (1, -1):
        trial = _with_root(mechanism, state, d.group, sign)
        misses[sign] = _distance(mechanism, trial, d.links)
    if not np.isfinite(misses[1] + misses[-1]) or np.isclose(misses[1], misses[-1], rtol=1e-6, atol=0):
        return None
    return 1 if misses[1] < misses[-1] else -1


def _closes(mechanism: Mechanism, state: State, d: Dyad) -> bool:
    trial = _with_root(mechanism, state, d.group, 1)
    return all(np.isfinite(trial.r[link] + trial.u[link]).all() for link in d.links)


def _with_root(mechanism: Mechanism, state: State, group: Group, sign: int) -> State:
    """A copy of the state with a dyad in one of its assemblies."""
    trial = replace(state, o={**state.o}, r={**state.r}, u={**state.u})
    with np.errstate(invalid="ignore", divide="ignore"):
        group_of(mechanism, group, sign).place(trial)
    return trial


# ---------------------------------------------------------------- all assemblies


@dataclass(frozen=True, eq=False)
class Way:
    """A way in which a mechanism can be put together: places of the points, m, and unit directions of the links."""

    places: Mapping[str, complex]
    turns: Mapping[str, complex]

    @property
    def closes(self) -> bool:
        return bool(np.isfinite([*self.places.values(), *self.turns.values()]).all())


def ways(mechanism: Mechanism, phi: float) -> Iterator[Way]:
    """Every way in which the whole mechanism can be put together with its driving link at `phi`, rad, one by one.

    The places of each are a sketch by which the variant can ask for it. Raises ProblemError, as `decompose` does.
    """
    structure = decompose(mechanism)
    start = drive(Linkage(structure, ()), np.array([phi]))
    return (_way(mechanism, state) for state in _states(mechanism, start, structure.groups))


def stated_way(mechanism: Mechanism, phi: float) -> Way:
    """The stated way, nan where it does not close at `phi`, rad. Raises ProblemError, as `assemble`."""
    return _way(mechanism, positions(assemble(mechanism), np.array([phi])))


def _states(mechanism: Mechanism, state: State, groups: Sequence[Group]) -> Iterator[State]:
    """One after another, and not all at once: their number doubles with every dyad."""
    if not groups:
        yield state
        return
    for way in _ways_of(mechanism, state, groups[0]):
        yield from _states(mechanism, way, groups[1:])


def _ways_of(mechanism: Mechanism, state: State, group: Group) -> Iterator[State]:
    if group.kind is None:
        loops = Loops(group)
        for q in assemblies(loops, state):
            yield placed(state, loops, q)
        return
    for sign in (1, -1) if group_of(mechanism, group).two_roots else (1,):
        trial = _with_root(mechanism, state, group, sign)
        if all(np.isfinite(trial.r[link] + trial.u[link]).all() for link in group.links):
            yield trial


def _way(mechanism: Mechanism, state: State) -> Way:
    places = {
        point: complex(np.ravel(state.world(link, at))[0])
        for link, body in mechanism.real.links.items()
        for point, at in body.points.items()
    }
    return Way(places, {link: complex(np.ravel(state.u[link])[0]) for link in mechanism.real.moving})
