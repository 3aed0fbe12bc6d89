"""Springs and dampers of a mechanism in its schemes: between points of the links, or a point and a fixed place."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Literal

import numpy as np

from tmm_report.figures.drawing import NORMAL, Item, Pen, Tag, line
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.schemes.bodies import Motion
from tmm_report.figures.springs import dashpot, zigzag
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.records import dataclass

HALF = 1.6  # half width of a spring and of a damper, mm
ASIDE = 5.0  # between two of them that have the same ends, mm
PITCH = 3.5  # of a coil in the middle of the motion, mm
COILS = (3, 9)  # the fewest and the most of a spring

End = str | complex  # a point of the mechanism, or a fixed place, m


@dataclass(frozen=True)
class Tie:
    """`name`: as its letter has it, c1 or b2, "" of none; `links`: those that take its force, the frame none."""

    kind: Literal["spring", "damper"]
    ends: tuple[End, End]
    name: str = ""
    links: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Ties:
    """Those of a mechanism in one of its drawn positions."""

    motion: Motion
    position: int
    every: Sequence[Tie]

    def items(self, links: Sequence[str] | None = None, pen: Pen = NORMAL) -> list[Item]:
        """Of all, or of those that act on some links."""
        return [item for tie in self._of(links) for item in self._drawn(tie, pen)]

    def far(self, links: Sequence[str]) -> list[complex]:
        """The ends, of those that act on some links, which lie on others, mm."""
        own = {point for link in links for point in self.motion.mechanism.links[link].points}
        ends = [(end, self.places[end][self.position]) for tie in self._of(links) for end in tie.ends]
        return [complex(place) for end, place in ends if end not in own]

    def tags(self) -> Iterator[Tag]:
        for tie in self._of(None):
            start, end = self._ends(tie)
            by = self._aside(tie) * 1j * (end - start) / abs(end - start)
            if tie.name:
                spots = tuple(start + by + share * (end - start) for share in (0.5, 0.35, 0.65))
                yield Tag((Symbol(tie.name[0], tie.name[1:]),), spots, gap=HALF + 0.8)

    @property
    def fixed(self) -> list[complex]:
        """The fixed places at which some are held, mm."""
        held = [
            self.places[end][self.position]
            for tie in self._of(None)
            for end in tie.ends
            if self._is_fixed(end)
        ]
        return list(dict.fromkeys(complex(one) for one in held))

    def _is_fixed(self, end: End) -> bool:
        return not isinstance(end, str) or end in self.motion.mechanism.links[FRAME].points

    @cached_property
    def places(self) -> dict[End, np.ndarray]:
        """Of every end in all positions, (P,), mm."""
        ends = dict.fromkeys(end for tie in self.every for end in tie.ends)
        return {end: self._of_end(end) for end in ends}

    def _of_end(self, end: End) -> np.ndarray:
        if not isinstance(end, str):
            return np.full(self.motion.count, complex(end) / self.motion.mu)
        link = self.motion.mechanism.links_at(end)[0]
        return self.motion.at(link, self.motion.local(link, end))

    def _ends(self, tie: Tie) -> tuple[complex, complex]:
        start, end = (complex(self.places[one][self.position]) for one in tie.ends)
        return start, end

    def _of(self, links: Sequence[str] | None) -> list[Tie]:
        """Those that are wanted and have a line in this position."""
        wanted = [tie for tie in self.every if links is None or set(tie.links) & set(links)]
        return [tie for tie in wanted if abs(np.subtract(*self._ends(tie))) > HALF]

    def _lengths(self, tie: Tie) -> np.ndarray:
        """Over the motion, without positions that do not assemble, mm."""
        lengths = np.abs(self.places[tie.ends[1]] - self.places[tie.ends[0]])
        return lengths[np.isfinite(lengths)]

    def _aside(self, tie: Tie) -> float:
        """How far it stands from the line of its ends, to the left from the first to the second, mm: several of the
        same ends stand side by side."""
        same = [one for one in self.every if set(one.ends) == set(tie.ends)]
        by = ASIDE * (same.index(tie) - (len(same) - 1) / 2)
        return by if same[0].ends == tie.ends else -by

    def _drawn(self, tie: Tie, pen: Pen) -> Iterator[Item]:
        start, end = self._ends(tie)
        by = self._aside(tie) * 1j * (end - start) / abs(end - start)
        lengths = self._lengths(tie)
        least, most = float(lengths.min()), float(lengths.max())
        if by:
            yield line(start, start + by, pen)
            yield line(end, end + by, pen)
        if tie.kind == "spring":
            coils = min(max(round((least + most) / 2 / PITCH), COILS[0]), COILS[1])
            yield from zigzag(start + by, end + by, coils, HALF, 0.15 * least, pen)
        else:
            yield from dashpot(start + by, end + by, least, most, HALF, pen)
