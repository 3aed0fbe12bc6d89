"""What the steps of a solution are in one mechanism: branches of its equations, and the points that stand for links."""

from __future__ import annotations

from tmm_report.mechanics.calculus.vectors import is_zero
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import Scalar
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.lever.vector_equations import Branch, Relation, System, relations
from tmm_report.records import dataclass

Group = Dyad | HigherGroup


@dataclass(frozen=True, eq=False)
class Scheme:
    """`steps`: the groups in the order of assembly with their branches; `coinciding`: a point that just coincides with
    a joint -> that joint; `bases`: link -> the point, fixed or a vertex, by which its motion is told."""

    linkage: Linkage
    steps: tuple[tuple[Group, tuple[Branch, ...]], ...]
    coinciding: dict[str, str]
    bases: dict[str, str]

    def joint(self, point: str) -> str:
        """The named point where a point is."""
        return self.coinciding.get(point, point)

    def guide(self, branch: Branch) -> tuple[str, Scalar]:
        """A link that has the guide of a sliding branch, and the guide's direction in that link's axes."""
        pairs = [p for p in self.linkage.structure.pairs if p.kind == "P" and p.name == branch.guide]
        pair = next((p for p in pairs if branch.link in p.links), pairs[0])
        link = branch.link if branch.link in pair.links else pair.links[0]
        return link, pair.along[link]


def scheme(linkage: Linkage) -> Scheme:
    named, points = relations(linkage), set(linkage.mechanism.point_names)
    coinciding = {known: joint for relation in named for known, joint in _coinciding(relation, points)}
    driver = linkage.mechanism.driver.link
    bases = {driver: linkage.structure.driver_pair.name}
    for group, relation in zip(linkage.groups, named, strict=True):
        for link in group.links:
            bases[link] = _base(linkage, group, link, relation)
    steps = tuple(zip(linkage.groups, (relation.branches for relation in named), strict=True))
    return Scheme(linkage, steps, coinciding, bases)


def _coinciding(relation: Relation | System, named: set[str]) -> list[tuple[str, str]]:
    found = []
    for branch in relation.branches:
        if branch.arm is not None and branch.end != branch.arm[1]:
            found.append((branch.end, branch.arm[1]))
    if isinstance(relation, Relation) and relation.dyad.kind == 5:
        found.append((relation.vertex, relation.dyad.outer_a.name))
    where = dict(found)
    for branch in relation.branches:
        if branch.guide is not None and branch.start is not None and branch.start not in named:
            where.setdefault(
                branch.start, where.get(branch.end, branch.end)
            )  # a point of the guide at the joint
    return list(where.items())


def _base(linkage: Linkage, group: Group, link: str, relation: Relation | System) -> str:
    """The named point at the link's reference point; where there is none, a vertex on the link."""
    points, pair = linkage.mechanism.links[link].points, group.references[link]
    at = next((p for p, place in points.items() if is_zero(place - pair.at[link])), None)
    if at is not None and pair.kind == "R":
        return at
    if isinstance(relation, Relation):
        return relation.vertex
    return next(iter(branch.end for branch in relation.branches if branch.end in points), at or "")
