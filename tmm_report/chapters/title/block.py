"""The blocks `title`, `note`, `language` and `decimal_sign` of a variant."""

from collections.abc import Iterator
from typing import Annotated, Literal, TypedDict

from pydantic import Field

from tmm_report.chapters.title.given import Note, Title
from tmm_report.chapters.title.pieces import PIECES, Depth
from tmm_report.languages import DEFAULT, DecimalSign, language
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.language import CODE
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Text


class TitleModel(Model):
    """The title page. Every field is free text."""

    institution: Text = ""
    department: Text = ""
    course: Text = ""
    topic: Text = ""
    student: Text = ""
    group: Text = ""
    variant: Text = ""
    teacher: Text = ""
    city: Text = ""
    year: Text = ""


Pieces = Annotated[list[Text], Field(max_length=100)]


class NoteModel(Model):
    """How much the note says: what is not printed stands in the results all the same."""

    depth: Depth = Field(
        default="course",
        description="short: what a sheet needs; course: the usual note, with appendices; full: all that is found",
    )
    body: Pieces = Field(
        default_factory=list, description="pieces, or chapters, whose pieces stand in the text"
    )
    appendix: Pieces = Field(
        default_factory=list, description="pieces, or chapters, whose pieces stand in an appendix"
    )
    omit: Pieces = Field(default_factory=list, description="pieces, or chapters, whose pieces are left out")
    plans: int | None = Field(
        default=None,
        ge=1,
        le=36,
        description="how many positions have their plans drawn and worked out; the others stand in tables alone",
    )
    symbols: Literal["where", "list"] | None = Field(
        default=None, description="letters explained under their formulas alone, or listed in front, too"
    )


class Block(model.Block):
    """The title page, and how the note is written."""

    AS_WRITTEN = frozenset({"title"})

    title: TitleModel = Field(default_factory=TitleModel)
    note: NoteModel = Field(default_factory=NoteModel)
    language: Annotated[str, CODE] = Field(default=DEFAULT, description="of the note")
    decimal_sign: DecimalSign | None = Field(default=None, description="left out, it follows the language")


class Given(TypedDict):
    title: Title
    note: Note
    language: str
    decimal_sign: DecimalSign


def given(read: Read) -> Given:
    block = read.block(Block)
    return {
        "title": Title(**block.title.model_dump()),
        "note": _note(block.note),
        "language": block.language,
        "decimal_sign": block.decimal_sign or language(block.language).decimal,
    }


def _note(stated: NoteModel) -> Note:
    listed = None if stated.symbols is None else stated.symbols == "list"
    return Note(
        stated.depth, tuple(stated.body), tuple(stated.appendix), tuple(stated.omit), listed, stated.plans
    )


def mistakes(read: Read) -> Iterator[Problem]:
    """Pieces that no note has, or that are to stand in two places."""
    stated = read.block(Block).note
    known = {*PIECES, *(name.split(".")[0] for name in PIECES)}
    seen = set[str]()
    for key in ("body", "appendix", "omit"):
        for k, name in enumerate(getattr(stated, key)):
            if name not in known:
                chapter = name.split(".")[0]
                near = sorted(one for one in known if one.split(".")[0] == chapter) or sorted(
                    {one.split(".")[0] for one in known}
                )
                right = Message(N_("one of: %(words)s"), {"words": ", ".join(near)})
                yield mistake(N_("the note has no piece %(name)s"), ("note", key, k), right, name=name)
            elif name in seen:
                right = Message(N_("name it once"))
                yield mistake(
                    N_("the piece %(name)s is to stand in two places"), ("note", key, k), right, name=name
                )
            seen.add(name)
