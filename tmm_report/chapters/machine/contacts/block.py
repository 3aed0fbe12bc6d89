"""The block `contacts` of a variant."""

from collections.abc import Iterator
from typing import Annotated, Any, TypedDict

from pydantic import Discriminator, Field, Tag

from tmm_report.chapters.machine.contacts import given as state
from tmm_report.problems import N_, Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated


def _kind(value: Any) -> str:
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    return f"<{kind}>"


AnyContact = Annotated[
    Annotated[Stated[state.Incline], Tag("<incline>")]
    | Annotated[Stated[state.Wedge], Tag("<wedge>")]
    | Annotated[Stated[state.Sliders], Tag("<sliders>")]
    | Annotated[Stated[state.Trial], Tag("<trial>")]
    | Annotated[Stated[state.Screw], Tag("<screw>")]
    | Annotated[Stated[state.Pivot], Tag("<pivot>")]
    | Annotated[Stated[state.Belt], Tag("<belt>")]
    | Annotated[Stated[state.BeltDrive], Tag("<belt drive>")]
    | Annotated[Stated[state.Wheel], Tag("<wheel>")]
    | Annotated[Stated[state.Journal], Tag("<journal>")]
    | Annotated[Stated[state.Crank], Tag("<crank>")],
    Discriminator(
        _kind,
        custom_error_type="shape",
        custom_error_message=N_(
            "begin with kind: incline, wedge, sliders, trial, screw, pivot, belt, belt drive, wheel, journal or crank"
        ),
    ),
]


class Block(model.Block):
    """Friction in single pairs: planes, wedges, screws, pivots, belts, wheels."""

    ALONE = True
    HOLES = frozenset({("contacts",)})

    # None: the hole of a pair that is wrong in itself
    contacts: list[AnyContact | None] | None = Field(
        default=None, description="friction in single pairs", min_length=1, max_length=40
    )


class Given(TypedDict):
    contacts: state.Given | None


def given(read: Read) -> Given:
    written = read.block(Block).contacts
    items = tuple(one for one in written or () if one)
    return {"contacts": state.Given(items) if written else None}


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()
