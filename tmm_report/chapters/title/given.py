"""What the blocks state of the title page and the assignment sheet, and of how much the note says."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.chapters.title.pieces import PIECES, Depth, Stand
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant import values
    from tmm_report.variant.language import TitleLine
    from tmm_report.variant.values import Text


@dataclass(frozen=True)
class Signer:
    """A line to sign on: what the person is, and the name."""

    role: TitleLine
    name: TitleLine = ""


@dataclass(frozen=True)
class Title:
    """The title page. Every field is free text; what is empty is left out of it."""

    ministry: TitleLine = ""
    institution: TitleLine = ""
    department: TitleLine = ""
    lines: Annotated[
        tuple[TitleLine, ...], Field(max_length=40, description="free lines under the department")
    ] = ()
    designation: Annotated[TitleLine, Field(description="of the document, such as ТММ.05.12.000 ПЗ")] = ""
    course: TitleLine = ""
    topic: TitleLine = ""
    student: TitleLine = ""
    group: TitleLine = ""
    variant: TitleLine = ""
    teacher: TitleLine = ""
    city: TitleLine = ""
    year: TitleLine = ""
    signed: Annotated[
        tuple[Signer, ...],
        Field(max_length=10, description="who signs it beside the student and the teacher"),
    ] = ()


@dataclass(frozen=True)
class Assignment:
    """The assignment sheet, behind the title page."""

    approved: Annotated[Signer | None, Field(description="who approves it")] = None
    issued: Annotated[TitleLine, Field(description="date")] = ""
    due: Annotated[TitleLine, Field(description="date")] = ""
    data: Annotated[
        tuple[TitleLine, ...], Field(max_length=40, description="what is given, an item each")
    ] = ()
    contents: Annotated[
        tuple[TitleLine, ...], Field(max_length=40, description="of the note; left out, its chapters")
    ] = ()
    sheets: Annotated[
        tuple[TitleLine, ...], Field(max_length=40, description="of the drawings, an item each")
    ] = ()


@dataclass(frozen=True)
class Note:
    """How much the note says: what is not printed stands in the results all the same."""

    depth: Annotated[
        Depth,
        Field(
            description="short: what a sheet needs; course: the usual note, with appendices; full: all that is found"
        ),
    ] = "course"
    body: Annotated[
        tuple[Text, ...],
        Field(max_length=100, description="pieces, or chapters, whose pieces stand in the text"),
    ] = ()
    appendix: Annotated[
        tuple[Text, ...],
        Field(max_length=100, description="pieces, or chapters, whose pieces stand in an appendix"),
    ] = ()
    omit: Annotated[
        tuple[Text, ...],
        Field(max_length=100, description="pieces, or chapters, whose pieces are left out"),
    ] = ()
    symbols: Annotated[
        Literal["where", "list"] | None,
        Field(description="letters explained under their formulas alone, or listed in front, too"),
    ] = None
    plans: Annotated[
        Annotated[int, values.whole(1, 36)] | None,
        Field(
            description="how many positions have their plans drawn and worked out; the others stand in tables alone",
        ),
    ] = None

    def stand(self, piece: str) -> Stand:
        """Where a piece of the note stands: what is stated of itself, else of its chapter, else by the depth."""
        stated: tuple[tuple[Stand, tuple[str, ...]], ...]
        stated = ("body", self.body), ("appendix", self.appendix), ("omit", self.omit)
        for name in (piece, piece.split(".")[0]):
            for stand, names in stated:
                if name in names:
                    return stand
        if piece == "plans.others" and self.plans is not None:
            return "omit"
        return "body" if self.depth == "full" else getattr(PIECES[piece], self.depth)

    @property
    def listed(self) -> bool:
        """Whether there is a list of symbols."""
        return self.depth == "full" if self.symbols is None else self.symbols == "list"

    @property
    def every(self) -> bool:
        """Whether every formula is worked out, not only one of each kind."""
        return self.depth == "full"

    @property
    def whole(self) -> bool:
        """Whether nothing is left out."""
        return self.depth == "full" and not self.omit
