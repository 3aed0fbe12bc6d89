"""Which links of a group turn alike, and between which joints their angular velocity can be read off a plan."""

from __future__ import annotations

from typing import Any

from tmm_report.mechanics.lever.assur_groups import Group
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.records import dataclass

Array = Any
Joint = tuple[str, complex]  # a link and a place in its axes


@dataclass(frozen=True)
class Turning:
    """Links that are joined by guides. `ends`: the two joints whose relative motion shows their turning; None where
    they turn with a known link, or have but one joint."""

    links: tuple[str, ...]
    ends: tuple[Joint, Joint] | None


def turning(linkage: Linkage, group: Group) -> list[Turning]:
    """The links of a group by their turning, in the order of the group."""
    pairs = (*group.outer, *group.inner)
    sets: list[set[str]] = [{link} for link in group.links]
    for pair in pairs:
        if pair.kind == "P":
            joined = [one for one in sets if one & set(pair.links)]
            rest = [one for one in sets if not one & set(pair.links)]
            sets = [*rest, set(pair.links).union(*joined)]
    found = [
        Turning(links, _ends(linkage, group, links) if len(links) == len(one) else None)
        for one in sets
        for links in [tuple(link for link in group.links if link in one)]
    ]
    return sorted(found, key=lambda one: group.links.index(one.links[0]))


def _ends(linkage: Linkage, group: Group, links: tuple[str, ...]) -> tuple[Joint, Joint] | None:
    """Of one link its farthest joints; of several the outermost joints of two of them."""
    joints = [
        (link, complex(pair.at[link]))
        for link in links
        for pair in (*group.outer, *group.inner)
        if pair.kind == "R" and link in pair.links
    ]
    if len(links) == 1:
        both = [(one, other) for one in joints for other in joints]
        ends = max(both, key=lambda two: abs(two[1][1] - two[0][1]), default=None)
        return ends if ends is not None and ends[0][1] != ends[1][1] else None
    firsts = {link: next((joint for joint in joints if joint[0] == link), None) for link in links}
    held = [joint for joint in firsts.values() if joint is not None]
    return (held[0], held[-1]) if len(held) > 1 else None
