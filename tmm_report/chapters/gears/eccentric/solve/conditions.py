"""The conditions of the chosen set of an eccentric epicyclic mechanism."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.gears.eccentric.given import RING, SUN, Given
from tmm_report.chapters.gears.eccentric.solve.satellites import Neighbours, Satellite
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.mechanics.gears.pair_sizes import least_teeth


def conditions(
    given: Given,
    sun: int,
    ring: int,
    e: float,
    satellites: tuple[Satellite, ...],
    neighbours: tuple[Neighbours, ...],
) -> Iterator[Condition]:
    """In the order of the note."""
    m, rack = given.module, given.rack
    for s in satellites:
        yield Condition("assembly", s.wheel, abs(s.residue), given.slack - ecc.EXACT, least=False)
    for pair in neighbours:
        yield Condition("neighbourhood", pair.wheels, pair.gap, given.clearance, "mm")
    apart = float(ecc.tips_apart(sun, ring, e, m, rack.ha))
    yield Condition("tips", f"{SUN}–{RING}", apart, 0.0, "mm")
    for wheel, z in {SUN: sun, **{s.wheel: s.teeth for s in satellites}}.items():
        yield Condition("undercut", wheel, z, least_teeth(rack))
    for s in satellites:
        yield Condition("root", s.wheel, s.curvature, 0.0, "mm")
        yield Condition("fouling", s.wheel, float(ecc.tips_in_hand(ring, s.teeth, m, rack)), 0.0, "mm")
