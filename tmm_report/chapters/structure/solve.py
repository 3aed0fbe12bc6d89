"""Chapter 1, structure: links, pairs, mobility, Assur groups and the class of the mechanism."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from tmm_report.mechanics.assembly import assemble
from tmm_report.mechanics.mechanism import Mechanism
from tmm_report.mechanics.motion import Linkage
from tmm_report.mechanics.structure import Alternative, Group, Pair, alternatives, mobility


@dataclass(frozen=True, eq=False)
class Structure:
    """Found by `solve`. `groups` stand in the order of assembly; they are detached from the last one on."""

    linkage: Linkage
    moving_links: int
    lower_pairs: int
    higher_pairs: int
    mobility: int
    groups: tuple[Group, ...]
    pairs: tuple[Pair, ...]
    formula: str
    mechanism_class: int

    @cached_property
    def alternatives(self) -> list[Alternative]:
        """What the groups would be if another link drove."""
        return alternatives(self.linkage.mechanism)


def solve(mechanism: Mechanism) -> Structure:
    """Raises ProblemError where the mechanism has W ≠ 1 or an unstated assembly."""
    linkage = assemble(mechanism)
    structure = linkage.structure
    return Structure(
        linkage=linkage,
        moving_links=len(mechanism.moving),
        lower_pairs=len(structure.pairs),
        higher_pairs=0,
        mobility=mobility(mechanism),
        groups=structure.groups,
        pairs=tuple(structure.pairs),
        formula=structure.formula,
        mechanism_class=structure.mechanism_class,
    )
