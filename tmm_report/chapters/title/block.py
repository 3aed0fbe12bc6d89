"""The blocks `title`, `assignment`, `note`, `language` and `decimal_sign` of a variant."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import Field

from tmm_report.chapters.title.given import Assignment, Note, Title
from tmm_report.chapters.title.pieces import PIECES
from tmm_report.languages import DEFAULT, DecimalSign, language
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.language import CODE
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated


class Block(model.Block):
    """The title page, and how the note is written."""

    AS_WRITTEN = frozenset({"title", "assignment"})

    title: Stated[Title] = Field(default_factory=Title)
    assignment: Stated[Assignment] | None = None
    note: Stated[Note] = Field(default_factory=Note)
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
        "title": block.title,
        "assignment": block.assignment,
        "note": block.note,
        "language": block.language,
        "decimal_sign": block.decimal_sign or language(block.language).decimal,
    }


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
