"""What is given of a press, as the block states it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import Distance, Name, Positive, Side, quantity


@dataclass(frozen=True)
class Press:
    """A press: a slider that works before one of its dead points."""

    slider: Annotated[Name, Field(description="the link that presses, on a fixed guide")]
    extreme: Annotated[Side, Field(description="side of the dead point before which it works")]
    torque: Annotated[
        Annotated[float, quantity("moment", 1e-12)] | None,
        Field(description="permitted on the driving link", examples=["10 kN*m"]),
    ] = None
    rated: Annotated[
        Annotated[float, quantity("force", 1e-12)] | None,
        Field(description="force of the slider", examples=["1 MN"]),
    ] = None
    within: Annotated[
        Positive | None,
        Field(description="of the dead point, the slider counts as standing still", examples=["2 mm"]),
    ] = None
    working: Annotated[
        tuple[Distance, Distance] | None,
        Field(description="part of the stroke, by the path left", examples=[["30 mm", 0]]),
    ] = None
