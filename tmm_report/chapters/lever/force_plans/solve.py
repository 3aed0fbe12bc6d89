"""Chapter 3, graph-analytical method: force plans of the groups and of the driving link at the positions asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from tmm_report.chapters.lever.force_plans.drafting import ForceDrawn, draw
from tmm_report.chapters.lever.force_plans.lever import Lever, levers
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.chapters.lever.plans.solve import Plans
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.mechanism import Driver
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class ForcePlans:
    """Found by `solve`. `doubts`: scales stated for groups that the mechanism does not have."""

    drawn: tuple[ForceDrawn, ...]
    singular: tuple[int, ...]
    levers: tuple[Lever, ...] = ()
    doubts: tuple[Problem, ...] = ()

    @property
    def worst(self) -> float:
        """Largest |delta| of all reactions and moments, %."""
        return max(
            (abs(c.delta) for d in self.drawn for c in d.comparison if c.delta is not None), default=0.0
        )


def offered(driver: Driver) -> bool:
    """Whether plans go as far as what drives: a stroke whose link no triangle follows has none."""
    return driver.stroke is None or isinstance(driver.stroke, Triangle)


def solve(
    drawing: Drawing, positions: Sequence[int], found: Kinetostatics, plans: Plans
) -> ForcePlans | None:
    """None where force plans are not `offered`."""
    if not offered(found.kinematics.linkage.mechanism.driver):
        return None
    lost = (*found.kinematics.singular, *found.kinematics.missing)
    regular = [k for k in positions if k not in lost]
    drawn = tuple(draw(found, k, plans.length_scale, drawing) for k in regular)
    singular = tuple(k for k in positions if k not in regular)
    return ForcePlans(drawn, singular, levers(found, drawn, plans), tuple(_idle(drawing, found)))


def _idle(drawing: Drawing, found: Kinetostatics) -> Iterator[Problem]:
    """Scales of the forces stated for what has no plan of its own."""
    if not isinstance(drawing.force, Mapping):
        return
    groups = _planned(found.kinematics.linkage)
    for key in drawing.force:
        if set(key.split("-")) not in [set(group.split("-")) for group in groups]:
            text = N_("no force polygon is of %(name)s: its scale has no effect")
            right = Message(N_("known: %(words)s"), {"words": ", ".join(groups)})
            yield doubt(text, ("drawing", "scales", "force", key), right, name=key)


def _planned(linkage: Linkage) -> list[str]:
    """The links of each plan, joined by hyphens."""
    stroke = linkage.mechanism.driver.stroke
    own = {*stroke.by} if stroke is not None else set()
    groups = ["-".join(group.links) for group in linkage.groups if not own & {*group.links}]
    groups += [wheel.link for wheel in linkage.structure.coupled] + [linkage.mechanism.driver.link]
    held = [group.links for group in linkage.groups if own & {*group.links}]
    if stroke is not None and held:
        others = [link for link in held[0] if link not in own]
        groups += [*others, stroke.by[0]] if stroke.slides else ["-".join(held[0]), stroke.takes[0].link]
    return groups
