"""The blocks `title`, `language` and `decimal_sign` of a variant."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import Field

from tmm_report.chapters.title.given import Title
from tmm_report.languages import DEFAULT, DecimalSign, language
from tmm_report.problems import Problem
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


class Block(model.Block):
    """The title page, and how the note is written."""

    AS_WRITTEN = frozenset({"title"})

    title: TitleModel = Field(default_factory=TitleModel)
    language: Annotated[str, CODE] = Field(default=DEFAULT, description="of the note")
    decimal_sign: DecimalSign | None = Field(default=None, description="left out, it follows the language")


class Given(TypedDict):
    title: Title
    language: str
    decimal_sign: DecimalSign


def given(read: Read) -> Given:
    block = read.block(Block)
    return {
        "title": Title(**block.title.model_dump()),
        "language": block.language,
        "decimal_sign": block.decimal_sign or language(block.language).decimal,
    }


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()
