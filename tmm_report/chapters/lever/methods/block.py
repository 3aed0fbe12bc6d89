"""The keys `method`, `accuracy` and `methods` of a variant: by what method the motion is found, and how well."""

from collections.abc import Iterator
from typing import Annotated, Any, TypedDict

from pydantic import Field

from tmm_report.chapters.lever.kinematics.given import AUTO, Way
from tmm_report.chapters.lever.methods.given import Comparison
from tmm_report.chapters.lever.structure.block import stated, without
from tmm_report.mechanics.rivals.cost import CLOSED, NAMES
from tmm_report.problems import N_, Message, Problem, shown
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Read
from tmm_report.variant.values import Flag, Reads, quantity

CLOSED_FORM = "closed form"
WRITTEN = {
    CLOSED_FORM: CLOSED,
    **{name.replace("_", " "): name for name in NAMES if name != CLOSED},
    AUTO: AUTO,
}
"""As a variant writes it -> key of the method."""


def _method(value: Any) -> str:
    text = " ".join(value.replace("_", " ").split()).lower() if isinstance(value, str) else ""
    if text == CLOSED:
        return CLOSED
    if text not in WRITTEN:
        said = shown(value) if isinstance(value, str | int | float) else "[…]"
        wrong = Message(N_("%(value)s is no method"), {"value": said})
        raise WrongValue(wrong, near(text, list(WRITTEN)))
    return WRITTEN[text]


MethodName = Annotated[str, Reads(_method, {"type": "string", "enum": list(WRITTEN)})]
RelativeAccuracy = Annotated[float, quantity("number", 1e-12, 0.5, "1e-12 … 0.5")]


class Block(model.Block):
    """By what method the motion is found, and the comparison of methods."""

    method: MethodName | None = Field(
        default=None,
        description="by what method the motion of the positions is found; auto: the cheapest that holds the accuracy",
    )
    accuracy: RelativeAccuracy | None = Field(
        default=None,
        description="what the numbers of the note are to hold, relative to the largest value of each",
        examples=["1e-6"],
    )
    methods: Flag = Field(default=False, description="true: the chapter that compares methods")


class Given(TypedDict):
    way: Way | None
    methods: Comparison | None
    accuracy: float | None


def given(read: Read) -> Given:
    block = read.block(Block)
    way = Way(block.method, block.accuracy) if block.method is not None else None
    methods = Comparison(block.accuracy) if block.methods else None
    return {"way": way, "methods": methods, "accuracy": block.accuracy}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        for key in ("method", "accuracy", "methods"):
            yield from without(read, key)
