"""Which root each dyad takes: stated in words or signs, or by a rough sketch; never guessed."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.mechanics.dyads import Dyad, State, dyad, place
from tmm_report.mechanics.mechanism import FRAME, Assembly, Mechanism
from tmm_report.mechanics.motion import Linkage, drive
from tmm_report.mechanics.planar import dot
from tmm_report.mechanics.structure import KIND_NAMES, Structure, decompose
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

PATH = ("mechanism", "assembly")
CLEAR = (
    0.1  # a direction word must make at least this cosine with the guide, or it does not tell the sides apart
)


def assemble(mechanism: Mechanism) -> Linkage:
    """Decompose a mechanism and choose the root of every dyad. Raises ProblemError with all mistakes."""
    structure = decompose(mechanism)
    _refuse_higher_classes(structure)
    dyads = [dyad(mechanism, group) for group in structure.groups]
    problems = list(_unmatched(mechanism, dyads))
    signs = [_stated_sign(mechanism, d, problems) for d in dyads]
    dyads = _by_sketch(mechanism, structure, dyads, signs, problems)
    if problems:
        raise ProblemError(problems)
    return Linkage(structure, tuple(dyads))


def _refuse_higher_classes(structure: Structure) -> None:
    text = N_(
        "links %(links)s form an Assur group of class %(cls)s: groups above class II are not solved yet"
    )
    higher = [group for group in structure.groups if group.group_class > 2]
    if higher:
        from tmm_report.mechanics.structure import ROMAN

        path = ("mechanism", "links")
        raise ProblemError(
            [
                mistake(text, (*path, g.links[0]), links=", ".join(g.links), cls=ROMAN.get(g.group_class, ""))
                for g in higher
            ]
        )


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
    mechanism: Mechanism,
    structure: Structure,
    dyads: list[Dyad],
    signs: list[int | None],
    problems: list[Problem],
) -> list[Dyad]:
    """Dyads with their roots; those not stated take the root nearer to the sketch."""
    angle = _sketch_angle(mechanism, structure)
    state = drive(Linkage(structure, ()), np.array([angle or 0.0]))
    chosen = []
    for d, sign in zip(dyads, signs, strict=True):
        if sign is None and angle is not None:
            sign = _nearer(mechanism, state, d)
        if sign is None:
            problems.append(_not_stated(mechanism, d, angle))
        d = dyad(mechanism, d.group, sign or 1)
        with np.errstate(invalid="ignore", divide="ignore"):
            place(state, d)
        chosen.append(d)
    return chosen


def _not_stated(mechanism: Mechanism, d: Dyad, angle: float | None) -> Problem:
    key = keys_of(d)[0]
    if mechanism.sketch and angle is None:
        text = N_("the sketch has no moving point of driving link %(link)s, so its position is not known")
        return mistake(text, ("mechanism", "sketch"), Message(N_("add one")), link=mechanism.driver.link)
    text = N_("group %(group)s can be assembled in two ways and the variant does not say which (key %(key)s)")
    return mistake(
        text, PATH if mechanism.assembly else ("mechanism",), how_to_state(d), group=d.group.label, key=key
    )


def _sketch_angle(mechanism: Mechanism, structure: Structure) -> float | None:
    """Angle of the driving link in the sketch, rad."""
    pair = structure.driver_pair
    for point, at in mechanism.links[mechanism.driver.link].points.items():
        if point in mechanism.sketch and point != pair.name:
            arm = np.ravel(at - pair.at[mechanism.driver.link])[0]
            return float(np.angle((mechanism.sketch[point] - np.ravel(pair.at[FRAME])[0]) / arm))
    return None


def _nearer(mechanism: Mechanism, state: State, d: Dyad) -> int | None:
    """The root whose points lie nearer to their sketched places; None where the sketch does not tell."""
    misses = {}
    for sign in (1, -1):
        trial = State(*({**part} for part in (state.o, state.r, state.u)))
        with np.errstate(invalid="ignore", divide="ignore"):
            place(trial, dyad(mechanism, d.group, sign))
        misses[sign] = sum(
            abs(np.ravel(trial.world(link, at))[0] - mechanism.sketch[point]) ** 2
            for link in (d.a, d.b)
            for point, at in mechanism.links[link].points.items()
            if point in mechanism.sketch
        )
    if not np.isfinite(misses[1] + misses[-1]) or np.isclose(misses[1], misses[-1], rtol=1e-6):
        return None
    return 1 if misses[1] < misses[-1] else -1
