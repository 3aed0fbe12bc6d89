"""Chapter 1, structure: links, pairs, mobility, Assur groups and the class of the mechanism."""

from __future__ import annotations

from functools import cached_property

from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.lever.assembly.stated import assemble, keys_of
from tmm_report.mechanics.lever.assur_groups import (
    Alternative,
    Group,
    Pair,
    alternatives,
    mobility,
    with_cylinder_held,
)
from tmm_report.mechanics.lever.assur_groups import Structure as Decomposed
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Structure:
    """Found by `solve`. `groups` stand in the order of assembly; they are detached from the last one on. Where there
    are cam pairs they are those of the mechanism in which a link replaces each of them."""

    linkage: Linkage
    moving_links: int
    lower_pairs: int
    higher_pairs: int
    mobility: int
    groups: tuple[Group, ...]
    pairs: tuple[Pair, ...]
    formula: str
    mechanism_class: int

    @property
    def cams(self) -> tuple[Cam, ...]:
        return self.linkage.mechanism.cams

    def counted(self, group: Group) -> tuple[int, int, int]:
        """Links, lower and higher pairs of a group as it is built: a cam pair leaves one unknown reaction."""
        put = {cam.name for cam in self.cams}
        links = [link for link in group.links if link not in put]
        lower = [pair for pair in (*group.outer, *group.inner) if not put & set(pair.links)]
        return len(links), len(lower), len(group.links) - len(links)

    @property
    def doubts(self) -> tuple[Problem, ...]:
        """A sketch that nothing asks."""
        mechanism, dyads = self.linkage.mechanism, [g for g in self.linkage.groups if isinstance(g, Dyad)]
        stated = {one.key for one in mechanism.assembly}
        asked = any(d.two_roots and not stated & set(keys_of(d)) for d in dyads)
        if mechanism.driver.stroke is not None:  # it may tell on which side what drives begins
            return ()
        if not mechanism.sketch or asked or len(dyads) < len(self.linkage.groups):
            return ()
        text = N_("the sketch has no effect: every group has one assembly or is stated in the key assembly")
        return (doubt(text, ("mechanism", "sketch"), Message(N_("leave one of the two"))),)

    @cached_property
    def by_cylinder(self) -> tuple[Group, ...]:
        """Of a driving cylinder the groups that hang on the frame while its length is held; none where they cannot be
        told apart, or something else drives."""
        mechanism = self.linkage.mechanism
        stroke = mechanism.driver.stroke
        if stroke is None or stroke.slides or mechanism.meshes:
            return ()
        try:
            return with_cylinder_held(mechanism, stroke.ends, stroke.by)
        except ProblemError:
            return ()

    @cached_property
    def alternatives(self) -> list[Alternative]:
        """What the groups would be if another link drove."""
        return alternatives(self.linkage.mechanism)


def _pairs(structure: Decomposed) -> tuple[Pair, ...]:
    """The pairs as they are built: without those of the links that replace cam pairs, with the cam pairs themselves."""
    cams = structure.mechanism.cams
    put = {cam.name for cam in cams}
    lower = [pair for pair in structure.pairs if not put & set(pair.links)]
    return (*lower, *(Pair("H", cam.name, (cam.cam, cam.follower), {}) for cam in cams))


def solve(mechanism: Mechanism) -> Structure:
    """Raises ProblemError where the mechanism has W ≠ 1 or an unstated assembly."""
    linkage = assemble(mechanism)
    structure = linkage.structure
    return Structure(
        linkage=linkage,
        moving_links=len(mechanism.real.moving),
        lower_pairs=sum(pair.kind != "H" for pair in structure.pairs) - 2 * len(mechanism.cams),
        higher_pairs=len(mechanism.cams) + len(mechanism.meshes),
        mobility=mobility(mechanism),
        groups=structure.groups,
        pairs=_pairs(structure),
        formula=structure.formula,
        mechanism_class=structure.mechanism_class,
    )
