"""Why a group cannot be assembled over part of the cycle, and the length that would cure it."""

from __future__ import annotations

from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.singular import Critical
from tmm_report.problems import N_, Message


def cause(critical: Critical, lost: bool = True) -> tuple[Message, Message]:
    """What cannot be reached, and the cure; of a group that is `lost` nowhere, how it would come back."""
    d = critical.group
    if not isinstance(d, Dyad):
        why = Message(N_("group %(group)s cannot be assembled"), {"group": d.group.label})
        links = {"links": ", ".join(d.links)}
        if not lost:
            return why, Message(
                N_(
                    "another of its assemblies, or other lengths of links %(links)s, may come back to where they began"
                ),
                links,
            )
        return why, Message(
            N_("beyond its limit positions the lengths of links %(links)s do not suffice"), links
        )
    low, high = critical.reach or (0.0, 0.0)
    return {1: _two_rods, 2: _rod_to_guide, 3: _guide_past_joint}[d.kind](d, low, high)


def _rod_to_guide(d: Dyad, low: float, high: float) -> tuple[Message, Message]:
    rod = d.outer_a.name + d.inner.name
    why = Message(
        N_("rod %(rod)s = %(length)s cannot reach guide %(guide)s"),
        {"rod": rod, "length": _length(abs(d.arm_a)), "guide": d.outer_b.name},
    )
    text = N_("joint %(a)s goes as far as %(need)s from its line: the rod needs at least %(need)s")
    return why, Message(text, {"a": d.outer_a.name, "need": _length(high)})


def _two_rods(d: Dyad, low: float, high: float) -> tuple[Message, Message]:
    a, b, c = d.outer_a.name, d.inner.name, d.outer_b.name
    p, q = abs(d.arm_a), abs(d.arm_b)
    why = Message(
        N_("links %(a)s%(b)s = %(p)s and %(c)s%(b)s = %(q)s do not meet"),
        {"a": a, "b": b, "c": c, "p": _length(p), "q": _length(q)},
    )
    # lengths that differ by less than this from what is needed print alike
    far, near = high > (p + q) * (1 + 1e-9), low < abs(p - q) * (1 - 1e-9)
    values = {"a": a, "c": c, "far": _length(high), "near": _length(low)}
    if far and near:
        text = N_(
            "the distance of joints %(a)s and %(c)s is from %(near)s to %(far)s: together the links need at least "
            "%(far)s, and they may differ by at most %(near)s"
        )
    elif near:
        text = N_("joints %(a)s and %(c)s come as near as %(near)s: the links may differ by at most %(near)s")
    else:
        text = N_(
            "joints %(a)s and %(c)s go as far as %(far)s apart: together the links need at least %(far)s"
        )
    return why, Message(text, values)


def _guide_past_joint(d: Dyad, low: float, high: float) -> tuple[Message, Message]:
    why = Message(
        N_("guide %(guide)s does not reach joint %(c)s"), {"guide": d.inner.name, "c": d.outer_b.name}
    )
    text = N_(
        "joints %(a)s and %(c)s come as near as %(near)s: the guide may pass them at a distance of at most %(near)s"
    )
    return why, Message(text, {"a": d.outer_a.name, "c": d.outer_b.name, "near": _length(low)})


def _length(metres: float) -> Message:
    """A length in the unit in which it is written: mm in a mechanism of ordinary size."""
    if 1e-5 <= metres < 100:
        return Message(N_("%(x).6g mm"), {"x": 1e3 * metres})
    return Message(N_("%(x).6g m"), {"x": metres})
