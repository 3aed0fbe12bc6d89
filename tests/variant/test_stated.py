"""A record whose annotations are the format of the file: what is read, what is refused, what an editor is told."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Annotated

import pytest
from pydantic import TypeAdapter, ValidationError

from tmm_report.problems import Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.variant.stated import Stated, model_of

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import Length, PositiveMass, whole


@dataclass(frozen=True)
class Ball:
    """One of the balls."""

    mass: Annotated[PositiveMass, Field(description="of one", examples=["2 kg"])]
    radius: Length = 0.25

    def __post_init__(self) -> None:
        if self.radius > 10:
            raise WrongValue(Message("too far"))


@dataclass(frozen=True)
class Balls:
    """The balls."""

    first: Ball
    others: list[Ball] = field(default_factory=list)
    count: Annotated[int, whole(1, 12)] = 2
    name: str | None = None


READ = TypeAdapter(Stated[Balls])


def test_what_validation_makes_is_the_record_with_its_defaults():
    found = READ.validate_python({"first": {"mass": "2 kg"}, "others": [{"mass": 1, "radius": "30 mm"}]})
    assert found == Balls(Ball(2.0, 0.25), [Ball(1.0, 0.03)], 2, None)
    assert isinstance(found, Balls) and isinstance(found.first, Ball)


@pytest.mark.parametrize(
    ("written", "place"),
    [
        ({}, ("first",)),
        ({"first": {"mass": "-2 kg"}}, ("first", "mass")),
        ({"first": {"mass": 1, "weight": 2}}, ("first", "weight")),
        ({"first": {"mass": 1}, "count": 13}, ("count",)),
        ({"first": {"mass": 1}, "others": [{"mass": 1, "radius": "20 m"}]}, ("others", 0)),
    ],
)
def test_what_does_not_fit_is_refused_where_it_stands(written, place):
    with pytest.raises(ValidationError) as error:
        READ.validate_python(written)
    assert [one["loc"] for one in error.value.errors()] == [place]


def test_an_editor_is_told_what_the_annotations_say():
    ball = model_of(Ball).model_json_schema()
    assert ball["title"] == "Ball" and ball["description"] == "One of the balls."
    assert ball["properties"]["mass"]["description"] == "of one" and ball["required"] == ["mass"]
    assert ball["additionalProperties"] is False
