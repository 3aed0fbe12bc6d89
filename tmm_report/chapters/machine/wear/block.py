"""The block `wear` of a variant."""

from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Any, Literal, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.lever.structure.block import FRAME, names, stated, without
from tmm_report.chapters.machine.wear.given import PARTS, POSITIONS, SECTORS, Coefficient, Faces, Given
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    LIST,
    MAP,
    SCALAR,
    Density,
    Length,
    Name,
    Positive,
    Pressure,
    WearCoefficient,
    by_shape,
    quantity,
    whole,
)
from tmm_report.yamlread import Path

Cycles = Annotated[float, quantity("number", 1.0, 1e15, "1 … 10¹⁵")]
Hours = Annotated[float, quantity("time", 1e-9)]
Arc = Annotated[float, quantity("angle", 1e-3, 3.1415926536, "0 … 180 deg")]
Rows = Annotated[list[tuple[Pressure, WearCoefficient]], Field(min_length=2, max_length=200)]
_HINT = N_("a number, 2e-15 1/Pa, or a table [[pressure, coefficient], …]")
Single = Annotated[Annotated[WearCoefficient, Tag(SCALAR)] | Annotated[Rows, Tag(LIST)], by_shape(_HINT)]


class TwoFaces(Model):
    """Of the lower and of the upper face; of an upright guide, of the right and of the left one."""

    lower: Single
    upper: Single


Side = Annotated[
    Annotated[WearCoefficient, Tag(SCALAR)] | Annotated[Rows, Tag(LIST)] | Annotated[TwoFaces, Tag(MAP)],
    by_shape(N_("a number, a table, or {lower, upper}")),
]


class Sides(Model):
    """Of the slider and of the guide."""

    slider: Side
    guide: Side


class Halves(Model):
    """Of the journal and of the bushing."""

    journal: Single
    bushing: Single


AnySides = Annotated[
    Annotated[WearCoefficient, Tag(SCALAR)] | Annotated[Rows, Tag(LIST)] | Annotated[Sides, Tag(MAP)],
    by_shape(N_("a number, a table, or {slider, guide}")),
]
AnyHalves = Annotated[
    Annotated[WearCoefficient, Tag(SCALAR)] | Annotated[Rows, Tag(LIST)] | Annotated[Halves, Tag(MAP)],
    by_shape(N_("a number, a table, or {journal, bushing}")),
]


def _coefficient(written: Any) -> Coefficient:
    if isinstance(written, list):
        return Coefficient(tuple(k for _, k in written), tuple(p for p, _ in written))
    return Coefficient((float(written),))


def _side(written: Any) -> tuple[Coefficient, Coefficient]:
    lower, upper = (written.lower, written.upper) if isinstance(written, TwoFaces) else (written, written)
    return _coefficient(lower), _coefficient(upper)


def _faces(written: Any) -> Faces:
    slider, guide = (written.slider, written.guide) if isinstance(written, Sides) else (written, written)
    return Faces(_side(slider), _side(guide))


class RunningInModel(Model):
    """The first stage of wear."""

    wear: Positive = Field(description="by which running in wears more than steady wear would")
    time: Hours = Field(description="its time constant")


class GuideModel(Model):
    """A slider on a fixed guide."""

    guide: Name = Field(description="its name")
    slider: Name | None = Field(default=None, description="its link, where several slide on the guide")
    length: Positive = Field(description="of the slider", examples=["300 mm"])
    width: Positive = Field(description="of the faces", examples=["120 mm"])
    middle: Length = Field(default=0.0, description="of the slider, from its point on the guide, along it")
    cycles: Cycles = Field(examples=["1e6"])
    coefficient: AnySides = Field(description="of wear, at the pressure of the central reaction")
    couple: AnySides | None = Field(
        default=None, description="at the pressure of the moment; left out, as of the central reaction"
    )
    parts: Annotated[int, whole(4, 1000)] = Field(
        default=PARTS, description="into how many the face is divided along the guide"
    )
    density: Density | None = Field(default=None, description="for the mass worn off")
    limit: Positive | None = Field(default=None, description="of the wear: then the life follows")
    running_in: RunningInModel | None = None

    @property
    def faces(self) -> tuple[Faces, Faces]:
        """Coefficients at the pressure of the central reaction, and of its moment."""
        return _faces(self.coefficient), _faces(self.coefficient if self.couple is None else self.couple)


class PivotModel(Model):
    """A turning pair."""

    pivot: Name = Field(description="its point")
    journal: Name = Field(description="the link whose journal it is")
    bushing: Name | None = Field(
        default=None, description="the other link, where more than two share the point"
    )
    diameter: Positive
    width: Positive = Field(description="of the bushing, along its axis")
    arc: Arc = Field(default=3.1415926535897931, description="angle over which the two touch")
    law: Literal["cosine", "uniform"] = Field(default="cosine", description="of the pressure over the arc")
    sectors: Annotated[int, whole(8, 360)] = Field(
        default=SECTORS, description="into how many the surface is divided around"
    )
    cycles: Cycles
    coefficient: AnyHalves
    density: Density | None = None
    limit: Positive | None = None

    @property
    def half_arc(self) -> float:
        return self.arc / 2

    @property
    def members(self) -> tuple[Coefficient, Coefficient]:
        """Coefficients of journal and bushing."""
        k = self.coefficient
        journal, bushing = (k.journal, k.bushing) if isinstance(k, Halves) else (k, k)
        return _coefficient(journal), _coefficient(bushing)


class WearModel(Model):
    """Wear of guides and pivots."""

    positions: Annotated[int, whole(24, 2880)] = Field(
        default=POSITIONS, description="of the cycle, over which it is summed"
    )
    guides: list[GuideModel] = Field(default=[], max_length=10)
    pivots: list[PivotModel] = Field(default=[], max_length=20)


class Block(model.Block):
    """Wear of the pairs."""

    wear: WearModel | None = Field(default=None, description="wear of the pairs")


class Taken(TypedDict):
    wear: Given | None


def given(read: Read) -> Taken:
    return {"wear": read.block(Block).wear}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "wear")
        return
    written = read.block(Block).wear
    if written is None:
        return
    if "loads" not in read.data:
        right = Message(N_("give the mechanism its loads: without reactions nothing wears"))
        yield mistake(N_("the wear follows from the reactions, and there are no loads"), ("wear",), right)
    if not written.guides and not written.pivots:
        right = Message(N_("list guides or pivots"))
        yield mistake(N_("nothing says which pairs wear"), ("wear",), right)
    for index, guide in enumerate(written.guides):
        yield from _of_guide(guide, ("wear", "guides", index), read)
    for index, pivot in enumerate(written.pivots):
        yield from _of_pivot(pivot, ("wear", "pivots", index), read)


def _of_guide(written: GuideModel, path: Path, read: Read) -> Iterator[Problem]:
    known = names(read.data)
    if written.guide not in known.guides:
        text = N_("there is no guide %(name)s")
        yield mistake(text, (*path, "guide"), near(written.guide, list(known.guides)), name=written.guide)
    for key in ("coefficient", "couple"):
        yield from _rising(getattr(written, key), (*path, key))


def _of_pivot(written: PivotModel, path: Path, read: Read) -> Iterator[Problem]:
    known = names(read.data)
    if written.pivot not in known.all_points:
        text = N_("there is no pivot at a point %(name)s")
        right = near(written.pivot, list(known.all_points))
        yield mistake(text, (*path, "pivot"), right, name=written.pivot)
    else:
        links = [link for link, points in known.points.items() if written.pivot in points]
        for key in ("journal", "bushing"):
            link = getattr(written, key)
            if link is not None and link not in links and not (link == FRAME and FRAME in links):
                text = N_("link %(link)s has no pivot at %(name)s")
                right = near(link, links)
                yield mistake(text, (*path, key), right, link=link, name=written.pivot)
    yield from _rising(written.coefficient, (*path, "coefficient"))


def _rising(written: Any, path: Path) -> Iterator[Problem]:
    """Tables go by ascending pressure."""
    if isinstance(written, list) and any(a[0] >= b[0] for a, b in pairwise(written)):
        yield mistake(N_("the pressures of the table must ascend"), path)
    if isinstance(written, Model):
        for key in type(written).model_fields:
            yield from _rising(getattr(written, key), (*path, key))
