"""The blocks `title`, `assignment`, `note`, `language` and `decimal_sign` of a variant."""

from collections.abc import Iterator
from typing import Annotated, Literal, TypedDict

from pydantic import Field

from tmm_report.chapters.title.given import Assignment, Note, Title
from tmm_report.chapters.title.pieces import PIECES, Depth
from tmm_report.languages import DEFAULT, DecimalSign, language
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.language import CODE, TitleLine
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Text, whole

Lines = Annotated[list[TitleLine], Field(max_length=40)]


class SignerModel(Model):
    """A line to sign on: what the person is, and the name."""

    role: TitleLine
    name: TitleLine = ""


class TitleModel(Model):
    """The title page. Every field is free text."""

    ministry: TitleLine = ""
    institution: TitleLine = ""
    department: TitleLine = ""
    lines: Lines = Field(default_factory=list, description="free lines under the department")
    designation: TitleLine = Field(default="", description="of the document, such as ТММ.05.12.000 ПЗ")
    course: TitleLine = ""
    topic: TitleLine = ""
    student: TitleLine = ""
    group: TitleLine = ""
    variant: TitleLine = ""
    teacher: TitleLine = ""
    city: TitleLine = ""
    year: TitleLine = ""
    signed: Annotated[list[SignerModel], Field(max_length=10)] = Field(
        default_factory=list, description="who signs it beside the student and the teacher"
    )


class AssignmentModel(Model):
    """The assignment sheet, behind the title page."""

    approved: SignerModel | None = Field(default=None, description="who approves it")
    issued: TitleLine = Field(default="", description="date")
    due: TitleLine = Field(default="", description="date")
    data: Lines = Field(default_factory=list, description="what is given, an item each")
    contents: Lines = Field(default_factory=list, description="of the note; left out, its chapters")
    sheets: Lines = Field(default_factory=list, description="of the drawings, an item each")


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
    plans: Annotated[int, whole(1, 36)] | None = Field(
        default=None,
        description="how many positions have their plans drawn and worked out; the others stand in tables alone",
    )
    symbols: Literal["where", "list"] | None = Field(
        default=None, description="letters explained under their formulas alone, or listed in front, too"
    )


class Block(model.Block):
    """The title page, and how the note is written."""

    AS_WRITTEN = frozenset({"title", "assignment"})

    title: TitleModel = Field(default_factory=TitleModel)
    assignment: AssignmentModel | None = None
    note: NoteModel = Field(default_factory=NoteModel)
    language: Annotated[str, CODE] = Field(default=DEFAULT, description="of the note")
    decimal_sign: DecimalSign | None = Field(default=None, description="left out, it follows the language")


class Given(TypedDict):
    title: Title
    assignment: Assignment | None
    note: Note
    language: str
    decimal_sign: DecimalSign


def given(read: Read) -> Given:
    block = read.block(Block)
    return {
        "title": _title(block.title),
        "assignment": _assignment(block.assignment) if block.assignment else None,
        "note": _note(block.note),
        "language": block.language,
        "decimal_sign": block.decimal_sign or language(block.language).decimal,
    }


def _title(stated: TitleModel) -> Title:
    texts = stated.model_dump(exclude={"lines", "signed"})
    return Title(**texts, lines=tuple(stated.lines), signed=tuple(map(_signer, stated.signed)))


def _signer(stated: SignerModel) -> tuple[str, str]:
    return stated.role, stated.name


def _assignment(stated: AssignmentModel) -> Assignment:
    approved = _signer(stated.approved) if stated.approved else None
    lists = {name: tuple(getattr(stated, name)) for name in ("data", "contents", "sheets")}
    return Assignment(approved, stated.issued, stated.due, **lists)


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
