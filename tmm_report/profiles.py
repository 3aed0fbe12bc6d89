"""How the note looks on paper: margins, letters, headings, captions, numbers. One record, read by macros and style.

A profile is a data file of `templates/profiles`; a variant names one, or takes one as its base and states otherwise
what its department wants otherwise. What a standard says, and what is only usual, stands in the files.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any, Literal, get_args

from tmm_report import yamlread
from tmm_report.languages import FALLBACK, LANGUAGES
from tmm_report.quantity import units
from tmm_report.records import dataclass
from tmm_report.resources import data_root

Align = Literal["left", "indent", "centre"]
Count = Literal["through", "section"]
Place = Literal["bottom centre", "bottom right", "top centre", "top right"]
Dash = Literal["long", "short"]
Base = Literal["gost", "plain", "dstu", "kz"]
DEFAULT: Base = "gost"
A4 = (210.0, 297.0)  # mm
BINDING, EDGE = 20.0, 5.0  # mm: from the frame to the edges of the sheet, at the left and at the others
# mm: the frame, what GOST 2.105 (3.6) leaves between it and the text, and below the title block of form 2a
WITHIN_FRAME = {"left": BINDING + 3, "right": EDGE + 3, "top": EDGE + 10, "bottom": EDGE + 15 + 10}
NAMES: tuple[Base, ...] = get_args(Base)


@dataclass(frozen=True)
class Margins:
    """mm."""

    left: float
    right: float
    top: float
    bottom: float

    @property
    def left_of_a4(self) -> tuple[float, float]:
        """Width and height of the text on a page."""
        return A4[0] - self.left - self.right, A4[1] - self.top - self.bottom


@dataclass(frozen=True)
class Text:
    """Size of the letters, pt; distance of the lines in sizes of the letters; indent of a paragraph and what stands
    between two of them, mm."""

    size: float
    spacing: float
    indent: float
    gap: float


@dataclass(frozen=True)
class Heading:
    align: Align
    capitals: bool
    new_page: bool = False


@dataclass(frozen=True)
class Headings:
    """`structural`: contents, introduction, conclusions, references, the word of an appendix."""

    structural: Heading
    section: Heading
    subsection: Heading


@dataclass(frozen=True)
class Captions:
    """Where the captions stand: that of a figure below it, that of a table above it."""

    figure: Align
    table: Align


@dataclass(frozen=True)
class Numbers:
    """Whether numbers go through the note or begin with that of the section."""

    figures: Count
    tables: Count
    formulas: Count

    def through(self, kind: str) -> bool:
        """Of a "figure", "table" or "formula"."""
        found: Count = getattr(self, f"{kind}s")
        return found == "through"


@dataclass(frozen=True)
class Where:
    """How letters are explained under a formula: each on a line of its own, from the indent of a paragraph."""

    lines: bool
    indent: bool


@dataclass(frozen=True)
class Profile:
    """`words`: by language those of the note; `language`: whose words stand, None: those of the note's language."""

    margins: Margins
    text: Text
    dash: Dash
    headings: Headings
    captions: Captions
    numbers: Numbers
    where: Where
    page_number: Place
    signatures: bool
    frames: bool  # and title blocks, in which the numbers of the pages stand
    words: Mapping[str, Mapping[str, str]]
    language: str | None = None

    def word(self, name: str, language: str) -> str:
        """One of them in a language; in English where the profile does not know it."""
        own = self.words.get(self.language or language, {})
        return own.get(name, self.words[FALLBACK][name])

    @property
    def dash_sign(self) -> str:
        return {"long": "—", "short": "–"}[self.dash]

    @property
    def above(self) -> bool:
        """Whether the number of a page stands above the text."""
        return self.page_number.startswith("top")

    @property
    def aside(self) -> bool:
        """Whether it stands at the right margin, not in the middle."""
        return self.page_number.endswith("right")


@cache
def data(name: str) -> Mapping[str, Any]:
    """The file of a shipped profile as plain data."""
    path = data_root() / "templates" / "profiles" / f"{name}.yaml"
    found: Mapping[str, Any] = yamlread.loads(path.read_bytes(), path.name).data
    return found


def stated(base: str, otherwise: Mapping[str, Any]) -> Profile:
    """A shipped profile, in which what is stated otherwise stands for what its file says."""
    return _record(merged(data(base), otherwise))


@cache
def shipped(name: str = DEFAULT) -> Profile:
    return _record(data(name))


def usual(code: str) -> str:
    """The name of the profile that goes with a language."""
    return LANGUAGES[code].profile if code in LANGUAGES else DEFAULT


def merged(under: Mapping[str, Any], over: Mapping[str, Any]) -> dict[str, Any]:
    """Data of which what is in `over` goes before, key by key however deep."""
    both = {key: under[key] for key in under.keys() & over.keys()}
    inner = {
        key: merged(value, over[key])
        for key, value in both.items()
        if isinstance(value, Mapping) and isinstance(over[key], Mapping)
    }
    return {**under, **over, **inner}


def _record(found: Mapping[str, Any]) -> Profile:
    headings = {kind: Heading(**one) for kind, one in found["headings"].items()}
    text = {**found["text"], **{name: _mm(found["text"][name]) for name in ("indent", "gap")}}
    margins = {side: _mm(size) for side, size in found["margins"].items()}
    if found["frames"]:
        margins = {side: max(size, WITHIN_FRAME[side]) for side, size in margins.items()}
    made = {
        "margins": Margins(**margins),
        "text": Text(**text),
        "headings": Headings(**headings),
        "captions": Captions(**found["captions"]),
        "numbers": Numbers(**found["numbers"]),
        "where": Where(**found["where"]),
    }
    return Profile(**{**found, **made})


def _mm(size: Any) -> float:
    """A length as a profile writes it, in mm: 12.5 mm is 12.5."""
    return round(1e3 * units.parse(size, "length"), 6)


def filled(template: str, values: Mapping[str, Any]) -> list[Any]:
    """A word of the note in pieces, with the values in the places of their names in braces: {n}, {title}, {letter}."""
    pieces = re.split(r"\{(\w+)\}", template)
    return [values[piece] if k % 2 else piece for k, piece in enumerate(pieces) if piece]
