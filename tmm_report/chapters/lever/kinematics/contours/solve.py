"""The analytical method written out: the driving link, then the contour of every group, at one table position.

What the formulas give is checked against the solver's own motion: two ways to every number.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.contours import dyads as contour_dyads
from tmm_report.chapters.lever.kinematics.contours import high_class as contour_systems
from tmm_report.chapters.lever.kinematics.contours import translating as contour_translating
from tmm_report.chapters.lever.kinematics.contours import wheels
from tmm_report.chapters.lever.kinematics.contours.dyads import Written
from tmm_report.chapters.lever.kinematics.contours.known import Pose
from tmm_report.chapters.lever.kinematics.contours.terms import WrittenSystem
from tmm_report.chapters.lever.kinematics.contours.translating import Translating
from tmm_report.chapters.lever.kinematics.contours.worked import CONSTANTS, TABLE, Bench
from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.lever.assur_groups import Group
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Table, plain, text_column
from tmm_report.records import dataclass

CONTOURS = Message(N_("numbers of the closed loops of the groups"))
CONSTANT = Message(N_("constant numbers of the closed loops of the groups"))


@dataclass(frozen=True, eq=False)
class Contours:
    """All that is written out at position `index`. `driving`: points of the driving link; `led`, `meshed`: rates of the
    links that meshes with it and with links of the groups move; `other`: one of the other points of the links, and
    `alike` those that are found likewise."""

    index: int
    bench: Bench
    driving: list[Formula]
    groups: tuple[Written | WrittenSystem | Translating, ...]
    other: list[Formula] = field(default_factory=list)
    alike: tuple[str, ...] = ()
    led: list[Formula] = field(default_factory=list)
    meshed: list[Formula] = field(default_factory=list)

    @property
    def slotted(self) -> list[str]:
        """Links on fixed guides that carry guides of others: they do not turn."""
        pairs = [pair for pair in self.bench.linkage.structure.pairs if pair.kind == "P"]
        fixed = [pair.other(FRAME) for pair in pairs if FRAME in pair.links]
        return [
            link for link in fixed if any(link in pair.links and FRAME not in pair.links for pair in pairs)
        ]


def contours(found: Kinematics, index: int) -> Contours:
    """The contours of all groups with their numbers at a table position."""
    with np.errstate(invalid="ignore", divide="ignore"):
        bench = Bench(found, index)
        done = _driver(bench)
        driving = bench.taken()
        led = wheels.rates(bench, found.linkage.structure.wheels)
        groups, meshed = [], []
        for group in found.linkage.groups:
            _joints(bench, group.group, done)
            before = bench.taken()
            written = _written(bench, group)
            if written is not None:
                written.points[:0] = before
                groups.append(written)
            done |= {pair.name for pair in group.group.inner if pair.kind == "R"}
            meshed += wheels.rates(bench, group.group.wheels)
        other, alike = _others(bench, done, any(one.points for one in groups))
    return Contours(index, bench, driving, tuple(groups), other, alike, led, meshed)


def _written(bench: Bench, group: Any) -> Written | WrittenSystem | Translating | None:
    """None of a group whose position is no contour of constant lengths: its links' poses are taken as found."""
    if type(group) is Dyad:
        return contour_translating.write(bench, group) or contour_dyads.write(bench, group)
    if isinstance(group, HigherGroup):
        return contour_translating.write(bench, group) or contour_systems.write(bench, group)
    for link in group.links:
        bench.take_pose(link)
    return None


def _driver(bench: Bench) -> set[str]:
    """The driving link: its pose, and its points that are joints."""
    driver, pair = bench.mechanism.driver.link, bench.linkage.structure.driver_pair
    angle = bench.of_table("positions_table", q.angle(driver), np.angle(bench.motion.turn(driver)))
    bench.poses[driver] = Pose(
        bench.spot(pair.name), complex(pair.at[driver]), angle, 0.0, bench.w(driver), bench.e(driver)
    )
    joints = [p for p in bench.mechanism.links[driver].points if len(bench.mechanism.links_at(p)) > 1]
    carried = {cam.centre for cam in bench.mechanism.cams}  # these move on the cam
    written = [point for point in joints if point in bench.moving and point not in carried]
    for point in written:
        bench.point_of(driver, point)
    return set(written)


def _joints(bench: Bench, group: Group, done: set[str]) -> None:
    """The outer pivots of a group that are points of links found before and were not yet written out."""
    for pair in group.outer:
        if pair.kind != "R" or pair.name in done or pair.name not in bench.moving:
            continue
        carrier = bench.linkage.carriers[pair.name]
        if carrier in bench.poses:
            bench.point_of(carrier, pair.name)
            done.add(pair.name)


def _others(bench: Bench, done: set[str], shown: bool) -> tuple[list[Formula], tuple[str, ...]]:
    """One of the points that no contour needs, written out, unless such a point of a link was `shown` before; the
    names of the rest."""
    carriers = bench.linkage.carriers
    rest = [p for p in bench.moving_order if p not in done and carriers[p] in bench.poses]
    carried = {cam.centre for cam in bench.mechanism.cams}
    rest = [p for p in rest if p not in carried and _apart(bench, p)]
    turning = (p for p in rest if bench.poses[carriers[p]].w is not None)
    first = None if shown else next(turning, None)
    if first is None:
        return [], tuple(rest)
    bench.point_of(carriers[first], first)
    return bench.taken(), tuple(p for p in rest if p != first)


def _apart(bench: Bench, point: str) -> bool:
    """Whether a point is another one than that by which its link's place is told."""
    link = bench.linkage.carriers[point]
    return abs(bench.mechanism.links[link].points[point] - bench.poses[link].origin) > 0


# ---------------------------------------------------------------- numbers


def tables(found: Kinematics) -> Iterator[Table]:
    """The numbers of the contours at the table positions, and their constants."""
    bench = contours(found, 0).bench
    columns = [quantity.column(values) for quantity, values in bench.columns.values()]
    yield Table(TABLE, CONTOURS, (*q.where(found.turned, found.by_law), *columns))
    if bench.constants:
        yield _constants(bench)


def _constants(bench: Bench) -> Table:
    """One row a number: its key finds it."""
    rows = list(bench.constants.items())
    values = [np.degrees(value) if of.unit == "deg" else value for _, (of, value) in rows]
    return Table(
        CONSTANTS,
        CONSTANT,
        (
            text_column("key", Message(N_("quantity")), [key for key, _ in rows]),
            text_column("unit", Message(N_("its unit")), [of.unit for _, (of, _) in rows]),
            plain("value", "", Message(N_("its value")), [float(value) for value in values]),
        ),
    )
