"""What is given of harmonics of the motion of points and links."""

from __future__ import annotations

from tmm_report.records import dataclass


@dataclass(frozen=True)
class Given:
    """`highest`: order; `points`: whose places are resolved, beside the outputs; `links`: along which the wave of the
    motion is followed, in `steps` equal parts; None: all that turn and have no fixed pivot."""

    highest: int = 4
    points: tuple[str, ...] = ()
    links: tuple[str, ...] | None = None
    steps: int = 10
