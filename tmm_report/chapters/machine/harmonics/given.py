"""What is given of harmonics of the motion of points and links, as the block states it."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Annotated

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import Name, whole


@dataclass(frozen=True)
class Harmonics:
    """Harmonics of the motion of points and links."""

    highest: Annotated[Annotated[int, whole(1, 24)], Field(description="highest order")] = 4
    points: Annotated[
        list[Name],
        Field(max_length=12, description="points beside the outputs", examples=[["S2"]]),
    ] = field(default_factory=list)
    links: Annotated[
        Annotated[list[Name], Field(max_length=8)] | None,
        Field(
            description="along which the wave of the motion is followed; left out, all that turn without a fixed pivot",
            examples=[["2"]],
        ),
    ] = None
    steps: Annotated[Annotated[int, whole(2, 50)], Field(description="equal parts of a link")] = 10


Given = Harmonics
