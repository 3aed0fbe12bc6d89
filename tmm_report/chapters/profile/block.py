"""The block `profile` of a variant: the name of a shipped profile, or what a department wants otherwise than it."""

import re
from collections.abc import Iterator
from functools import partial
from typing import Annotated, TypedDict

from pydantic import Field, Tag

from tmm_report import profiles
from tmm_report.languages import DEFAULT as LANGUAGE
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.profiles import Align, Base, Count, Dash, Place, Profile
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import MAP, SCALAR, Flag, Reads, by_shape, free_text, quantity

Margin = Annotated[float, quantity("length", 0.0, 0.08, "0 … 80 mm")]
Indent = Annotated[float, quantity("length", 0.0, 0.05, "0 … 50 mm")]
Gap = Annotated[float, quantity("length", 0.0, 0.02, "0 … 20 mm")]
Size = Annotated[float, quantity("number", 8.0, 20.0, "8 … 20")]
Spacing = Annotated[float, quantity("number", 1.0, 3.0, "1 … 3")]
Code = Annotated[str, Field(pattern="^[a-z]{2,3}$", examples=["kk"])]
LEAST = (120.0, 180.0)  # mm: width and height of the text


class MarginsModel(Model):
    """Margins of a page."""

    left: Margin | None = None
    right: Margin | None = None
    top: Margin | None = None
    bottom: Margin | None = None


class LettersModel(Model):
    """Letters and paragraphs of the text."""

    size: Size | None = Field(default=None, description="of the letters, pt")
    spacing: Spacing | None = Field(default=None, description="between lines, in sizes of the letters")
    indent: Indent | None = Field(default=None, description="of the first line of a paragraph")
    gap: Gap | None = Field(default=None, description="between paragraphs")


class SubheadingModel(Model):
    """How the heading of a subsection stands."""

    align: Align | None = Field(
        default=None, description="at the left, from the indent of a paragraph, or in the middle"
    )
    capitals: Flag | None = Field(default=None, description="whether it is written in capitals")


class HeadingModel(SubheadingModel):
    """How a heading stands."""

    new_page: Flag | None = Field(default=None, description="whether it begins a page")


class HeadingsModel(Model):
    """How headings of each level stand."""

    structural: HeadingModel | None = Field(
        default=None, description="contents, introduction, conclusions, references"
    )
    section: HeadingModel | None = None
    subsection: SubheadingModel | None = None


class CaptionsModel(Model):
    """Where the captions of figures and tables stand."""

    figure: Align | None = Field(default=None, description="of a figure")
    table: Align | None = Field(default=None, description="of a table")


class NumbersModel(Model):
    """Whether numbers go through the note or begin anew in each section."""

    figures: Count | None = Field(default=None, description="of figures")
    tables: Count | None = Field(default=None, description="of tables")
    formulas: Count | None = Field(default=None, description="of formulas")


class WhereModel(Model):
    """How letters are explained under a formula."""

    lines: Flag | None = Field(default=None, description="each letter on a line of its own")
    indent: Flag | None = Field(default=None, description="from the indent of a paragraph")


def _template(value: object, slots: tuple[str, ...]) -> str:
    """A word of the note with the names of what is put into it, in braces."""
    text = free_text(value)
    found = re.findall(r"\{(.*?)\}", text)
    if sorted(found) == sorted(slots) and text.count("{") == text.count("}") == len(slots):
        return text
    told = {"value": shown(text), "slots": ", ".join(f"{{{slot}}}" for slot in slots)}
    if not slots:
        raise WrongValue(Message(N_("%(value)s: nothing is put into this word, so it has no braces"), told))
    wrong = Message(N_("%(value)s must have each of %(slots)s once and no other braces"), told)
    raise WrongValue(wrong, Message(N_("for example %(example)s"), {"example": _example(slots)}))


def _example(slots: tuple[str, ...]) -> str:
    return " ".join(["…", *(f"{{{slot}}}" for slot in slots)])


def _word(*slots: str) -> Reads:
    return Reads(
        partial(_template, slots=slots),
        {
            "type": "string",
            "maxLength": 200,
            "description": "as it stands in the note",
            "examples": [_example(slots)],
        },
    )


Titled = Annotated[str, _word("n", "title")]
Numbered = Annotated[str, _word("n")]
Lettered = Annotated[str, _word("letter")]
Plain = Annotated[str, _word()]


class WordsModel(Model):
    """What is put into them stands in braces."""

    figure: Titled | None = None
    table: Titled | None = None
    continued: Numbered | None = None
    last: Numbered | None = None
    appendix: Lettered | None = None
    contents: Plain | None = None
    symbols: Plain | None = None
    introduction: Plain | None = None
    conclusions: Plain | None = None
    references: Plain | None = None
    assignment: Plain | None = None
    where: Plain | None = None
    here: Plain | None = None


class NoteProfileModel(Model):
    """What stands otherwise than in the profile `base`."""

    base: Base | None = Field(default=None, description="left out, that of the variant's language")
    margins: MarginsModel | None = None
    text: LettersModel | None = None
    dash: Dash | None = Field(default=None, description="between the number of a caption and its title")
    headings: HeadingsModel | None = None
    captions: CaptionsModel | None = None
    numbers: NumbersModel | None = None
    where: WhereModel | None = None
    page_number: Place | None = Field(default=None, description="where it stands")
    signatures: Flag | None = Field(
        default=None, description="a line to sign on behind each name of the title page"
    )
    frames: Flag | None = Field(
        default=None, description="frames and title blocks of GOST 2.104 (forms 2 and 2a) on the pages"
    )
    language: Code | None = Field(
        default=None, description="whose words stand; left out, those of the note's language"
    )
    words: dict[Code, WordsModel] | None = Field(
        default=None, description="captions and other words, by language"
    )


Stated = Annotated[
    Annotated[Base, Tag(SCALAR)] | Annotated[NoteProfileModel, Tag(MAP)],
    by_shape(N_("gost, plain, dstu, kz, or {base: gost, margins: {left: 25 mm}}")),
]


class Block(model.Block):
    """How the note looks on paper."""

    profile: Stated | None = None


class Given(TypedDict):
    profile: Profile | None


def given(read: Read) -> Given:
    stated = read.block(Block).profile
    return {"profile": _made(stated, read) if stated is not None else None}


def _made(stated: Base | NoteProfileModel, read: Read) -> Profile:
    if isinstance(stated, str):
        return profiles.shipped(stated)
    base = stated.base or profiles.usual(str(read.data.get("language", LANGUAGE)))
    return profiles.stated(base, stated.model_dump(exclude={"base"}, exclude_none=True))


def mistakes(read: Read) -> Iterator[Problem]:
    """Margins that leave no room for the text; a language without words."""
    stated = read.block(Block).profile
    if stated is None or isinstance(stated, str):
        return
    made = _made(stated, read)
    if made.language is not None and made.language not in made.words:
        known = Message(N_("known: %(words)s"), {"words": ", ".join(made.words)})
        yield mistake(
            N_("the profile has no words of the language %(code)s"),
            ("profile", "language"),
            known,
            code=shown(made.language),
        )
    for left, least in zip(made.margins.left_of_a4, LEAST, strict=True):
        if left < least:
            text = N_("the margins leave %(left)s mm of the page for the text")
            right = Message(N_("at least %(least)s mm must be left"), {"least": f"{least:g}"})
            yield mistake(text, ("profile", "margins"), right, left=f"{left:g}")
