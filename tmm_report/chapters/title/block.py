"""The blocks `title`, `assignment`, `note`, `language`, `decimal_sign` and `words` of a variant."""

from collections.abc import Iterator
from difflib import get_close_matches
from typing import Annotated, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.title.given import Assignment, Note, Title
from tmm_report.chapters.title.pieces import PIECES
from tmm_report.languages import DEFAULT, DecimalSign, language
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.language import CODE
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import MAP, SCALAR, Reads, by_shape, free_text
from tmm_report.wording.terms import Rewording, plain, usual

MOST, LONGEST = 60, 60  # own words, letters of one
WORDS = "the department's own words for terms of the glossary"


def _word(value: object) -> str:
    text = free_text(value)
    if not text or len(text) > LONGEST or not any(char.isalpha() for char in text):
        raise WrongValue(
            Message(N_("a word of at most %(count)s letters is expected here"), {"count": LONGEST})
        )
    return text


Term = Annotated[str, Field(max_length=LONGEST)]
Word = Annotated[str, Reads(_word, {"type": "string", "maxLength": LONGEST})]
Own = Annotated[
    Annotated[Word, Tag(SCALAR)] | Annotated[dict[Word, Word], Field(max_length=MOST), Tag(MAP)],
    by_shape(N_("a word, or its forms: {slider: block, sliders: blocks}")),
]


class Block(model.Block):
    """The title page, and how the note is written."""

    AS_WRITTEN = frozenset({"title", "assignment"})

    title: Stated[Title] = Field(default_factory=Title)
    assignment: Stated[Assignment] | None = None
    note: Stated[Note] = Field(default_factory=Note)
    language: Annotated[str, CODE] = Field(default=DEFAULT, description="of the note")
    decimal_sign: DecimalSign | None = Field(default=None, description="left out, it follows the language")
    words: dict[Term, Own] | None = Field(default=None, max_length=MOST, description=WORDS)


class Given(TypedDict):
    title: Title
    assignment: Assignment | None
    note: Note
    language: str
    decimal_sign: DecimalSign
    words: Rewording | None


def given(read: Read) -> Given:
    block = read.block(Block)
    return {
        "title": block.title,
        "assignment": block.assignment,
        "note": block.note,
        "language": block.language,
        "decimal_sign": block.decimal_sign or language(block.language).decimal,
        "words": _rewording(block) if block.words else None,
    }


def _rewording(block: Block) -> Rewording:
    stated = {_term(term, block.language): own for term, own in (block.words or {}).items()}
    return Rewording(
        block.language,
        tuple(
            (term, own if isinstance(own, str) else tuple(own.items()))
            for term, own in stated.items()
            if term
        ),
    )


def _term(said: str, code: str) -> str:
    """A term of the glossary by its English or by its usual word; "" for one that it has not."""
    words = usual(code)
    named = {plain(word).casefold(): term for term, word in words.items()} | {term: term for term in words}
    return named.get(said.strip().casefold().replace("_", " "), "")


def mistakes(read: Read) -> Iterator[Problem]:
    """Words that the glossary has not; pieces that no note has, or that are to stand in two places."""
    yield from _unknown_words(read.block(Block))
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


def _unknown_words(block: Block) -> Iterator[Problem]:
    for said in block.words or ():
        if not _term(said, block.language):
            near = (
                get_close_matches(said.casefold(), usual(block.language), 3, 0.5)
                or [*usual(block.language)][:5]
            )
            right = Message(N_("for example %(example)s"), {"example": ", ".join(near)})
            text = N_("the glossary has no term %(name)s")
            yield mistake(text, ("words", said), right, name=shown(said))
