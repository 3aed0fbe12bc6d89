"""What is odd in the loads and is solved all the same: masses without loads, loads that are nothing or never met."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tmm_report.chapters.lever.kinetostatics.block.models import LoadsModel
from tmm_report.chapters.lever.structure import block as structure
from tmm_report.chapters.lever.structure.block import ASKED
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.variant.model import Read

TURN = 2 * math.pi
WEIGHED = (
    "balancing",
    "dynamics",
    "flywheel",
    "travel",
)  # chapters that use the masses of the links without any loads


def doubts(written: LoadsModel | None, read: Read) -> Iterator[Problem]:
    heavy = _heavy(read)
    if written is None:
        if heavy and not _weighed(read):
            text = N_("the links have masses and there is no block loads: no force analysis is made")
            yield doubt(text, ("mechanism", "links", *heavy), ASKED)
        return
    ties = [*written.springs, *written.dampers, *written.torsion_springs]
    if not (heavy or written.forces or written.moments or ties):
        text = N_("nothing acts on the mechanism: no link has a mass, no force and no moment is stated")
        right = Message(N_("masses of the links, forces or moments; without them all reactions are zero"))
        yield doubt(text, ("loads",), right)
    yield from _never_met(written, read)


def _weighed(read: Read) -> bool:
    """Whether another chapter uses the masses: of vibration one that the mechanism's own forces shake."""
    of: Any = read.data.get("vibration")
    return any(key in read.data for key in WEIGHED) or (isinstance(of, Mapping) and "mechanism" in of)


def _heavy(read: Read) -> tuple[str, str] | None:
    """The first link with a mass or a moment of inertia, and which of them the file states of it."""
    for name, link in read.block(structure.Block).mechanism.links.items():
        if link.mass or link.inertia:
            return name, "mass" if link.mass else "inertia"
    return None


def _never_met(written: LoadsModel, read: Read) -> Iterator[Problem]:
    """Angles of a law beyond those by which the driving link turns."""
    swept = structure.swept(read)
    if swept >= TURN - 1e-12:
        return
    for key, loads in (("forces", written.forces), ("moments", written.moments)):
        for index, load in enumerate(loads):
            angles = [angle for angle, _ in load.by_angle or ()] if load else []
            beyond = [k for k, angle in enumerate(angles) if angle > swept * (1 + 1e-9)]
            # one beyond is needed for the line to it, and a law of one point is the same at all angles
            if len(beyond) > 1 or (beyond and len(angles) > 1 and angles[-2] >= swept):
                text = N_(
                    "the driving link turns by %(range)s deg only: what the law says beyond has no effect"
                )
                told = f"{math.degrees(swept):.6g}"
                yield doubt(text, ("loads", key, index, "by_angle", beyond[-1], 0), range=told)
