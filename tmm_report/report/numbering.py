"""Numbers of sections, formulas, tables and figures, given by us and written explicitly in every format."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field
from secrets import token_hex
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.profiles import Numbers, shipped
from tmm_report.records import dataclass

DRAWINGS = "appendix:drawings"  # the label of their appendix


class Place(NamedTuple):
    """Where a numbered thing stands: its number as printed ("2.1") and its anchor, safe in every format."""

    number: str
    anchor: str

    @property
    def rank(self) -> int:
        """Of the heading of a section: 3 of "2.1.4", but 2 of "A.1", where a part of a section is an appendix's own."""
        return self.number.count(".") + 1


class Section(NamedTuple):
    """A line of the contents; `level` 1 for a chapter."""

    place: Place
    title: str
    level: int
    appendix: bool = False


@dataclass
class Appendix:
    """What is cut out of a chapter, behind all: `head`: its letter and the chapter's title; `pieces`: its text."""

    head: Section
    sections: list[Section]
    pieces: list[Markup]

    @classmethod
    def of(cls, letter: str, anchor: str, title: str) -> Appendix:
        """`anchor`: with which all anchors within it begin: of plain letters, whatever the letter."""
        head = Section(Place(letter, anchor), title, 1, True)
        return cls(head, [head], [])


@dataclass
class Numbering:
    """Counts as the templates are rendered, once.

    Figures, tables and formulas are numbered through or by chapter, as the `scheme` has it. An anchor is made of
    kind and number alone, so that nothing a user wrote gets into it. What comes later than it is referred to is
    marked in the text and put in by `resolved`; a mark is letters and digits, which every format leaves as they
    are, and begins with a secret of this note's, so that no text of a user's is taken for one.
    """

    places: dict[str, Place] = field(default_factory=dict)
    sections: list[Section] = field(default_factory=list)
    appendices: list[Appendix] = field(default_factory=list)
    scheme: Numbers = field(default_factory=lambda: shipped().numbers)
    _awaited: dict[str, Place] = field(default_factory=dict)
    _secret: str = field(default_factory=lambda: f"later{token_hex(16)}")
    _counts: dict[Hashable, int] = field(default_factory=dict)
    _explained: set[Hashable] = field(default_factory=set)
    _front: int | None = None  # where the next section of what stands in front is put
    _appendix: Appendix | None = None  # that is being written
    _drawings: Appendix | None = None
    _raised: int | None = None  # by how many levels, as a piece cut out of a section begins there as one
    _explained_there: set[Hashable] = field(default_factory=set)

    def section(self, title: str, level: int = 1, label: str = "") -> Place:
        """The next section of a level: 1, 2, ...; 2.1, 2.2, ..."""
        written = self._appendix.sections if self._appendix else self.sections
        if self._appendix:
            self._raised = level - 2 if self._raised is None else self._raised
            level = max(2, level - self._raised)
        above = written[-1].place.number.split(".")[: level - 1] if level > 1 else []
        number = ".".join([*above, str(self._next(("section", *above)))])
        place = self._keep(label, Place(number, self._anchor("section", number)))
        written.append(Section(place, title, level))
        return place

    @contextmanager
    def within(self, appendix: Appendix) -> Iterator[None]:
        """A piece that is written within stands in the appendix: its sections, tables, figures and formulas are
        numbered by its letter, and what it explains is explained in the text again."""
        explained = self._explained
        self._appendix, self._raised, self._explained = appendix, None, self._explained_there | explained
        try:
            yield
        finally:
            self._explained_there |= self._explained
            self._appendix, self._explained = None, explained

    def unnumbered(self, title: str, label: str) -> Place:
        """A chapter without a number, as conclusions and references are."""
        place = self._keep(label, Place("", f"section-{label.rpartition(':')[2]}"))
        at = len(self.sections) if self._front is None else self._front
        self.sections.insert(at, Section(place, title, 1))
        if self._front is not None:
            self._front += 1
        return place

    @property
    def chapters(self) -> list[Section]:
        """The numbered chapters."""
        return [section for section in self.sections if section.level == 1 and section.place.number]

    @property
    def here(self) -> str:
        """The number of the chapter, or of its section, that is being written; "" before the first."""
        near = (one for one in reversed(self.sections) if one.level <= 2 and one.place.number)
        return next((one.place.number for one in near), "")

    def has(self, label: str) -> bool:
        return label in self.places

    def begin_front(self) -> None:
        """What is written now stands before all that is written already."""
        self._front = 0

    def end_front(self) -> None:
        self._front = None

    def take(self, kind: str, label: str = "") -> Place:
        """The next number of a kind: "figure", "table", "formula"."""
        if self._appendix:
            letter = self._appendix.head.place.number
            number = letter + f".{self._next((kind, letter))}"  # which may be a mark
        elif self.scheme.through(kind):
            number = str(self._next(kind))
        else:
            chapter = self.sections[-1].place.number.split(".")[0] if self.sections else "0"
            number = f"{chapter}.{self._next((kind, chapter))}"
        return self._keep(label, Place(number, self._anchor(kind, number)))

    def appendix(self, letters: str) -> Appendix:
        """That of the chapter that is being written, which may be new; called by the next of the letters."""
        title, number = self.chapters[-1].title, len(self.appendices)
        known = next((one for one in self.appendices if one.head.title == title), None)
        if known is None:
            known = Appendix.of(letters[number], f"appendix{number + 1}", title)
            self.appendices.append(known)
        return known

    def drawing(self, label: str, title: str) -> Place:
        """The number of a figure among the drawings; `title`: of their appendix, the last, whose letter comes later."""
        if self._drawings is None:
            self._drawings = Appendix.of(self.place(DRAWINGS).number, "drawings", title)
        before, self._appendix = self._appendix, self._drawings
        try:
            return self.take("figure", label)
        finally:
            self._appendix = before

    def close(self, letters: str) -> Appendix | None:
        """No other appendix comes: behind them that of the drawings, if there are any."""
        if self._drawings is not None:
            self.places[DRAWINGS] = Place(letters[len(self.appendices)], self._drawings.head.place.anchor)
            self.appendices.append(self._drawings)
        return self._drawings

    def _anchor(self, kind: str, number: str) -> str:
        if self._appendix is None:
            return f"{kind}{number}"
        letter, anchor = self._appendix.head.place
        return f"{kind}-{anchor}{number.removeprefix(letter)}"

    def place(self, label: str) -> Place:
        """The place of a label; of one that comes later, marks that stand for it until `resolved`."""
        if label in self.places:
            return self.places[label]
        if label not in self._awaited:
            mark = f"{self._secret}x{len(self._awaited)}"
            self._awaited[label] = Place(Markup(f"{mark}n"), Markup(f"{mark}a"))
        return self._awaited[label]

    def sentence(self, text: str) -> str:
        """A sentence that refers to what comes later between marks: it goes if that does not come."""
        if self._secret not in str(text):
            return text
        return Markup(f"{self._secret}b{text}{self._secret}e")

    def resolved(self, text: str, whole: bool = True) -> str:
        """The rendered text with the numbers and anchors of what came later in place of their marks. Of a note that is
        not `whole` the sentences go that refer to what was left out of it."""
        missing = {label: place for label, place in self._awaited.items() if label not in self.places}

        def refers(part: str) -> bool:
            return any(mark in part for place in missing.values() for mark in place)

        sentence = rf"{self._secret}b(.*?){self._secret}e"
        text = re.sub(sentence, lambda one: "" if not whole and refers(one[1]) else one[1], text, flags=re.S)
        if missing and (whole or refers(text)):
            raise ValueError(f"the templates refer to what is not in the note: {sorted(missing)}")
        pairs = [
            (self._awaited[label], self.places[label]) for label in self._awaited.keys() - missing.keys()
        ]
        marks = {mark: known for place, found in pairs for mark, known in zip(place, found, strict=True)}
        # twice, as the number of a drawing has in it the letter of its appendix, which comes later, too
        for _ in range(2):
            text = re.sub(rf"{self._secret}x\d+[na]", lambda mark: marks[mark[0]], text)
        return re.sub(r"<p>\s*</p>\n?", "", text)

    def fresh(self, items: Iterable[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
        """Those of a "where" list's items that have not been explained before, by their "id" or "kind", nor as the same
        symbol in the same words by another."""
        new = []
        for item in items:
            kind, says = item.get("kind", item["id"]), {item["id"], (item["symbol"], str(item["meaning"]))}
            if kind not in self._explained and says.isdisjoint(self._explained):
                self._explained.add(kind)
                new.append(item)
            self._explained |= says
        return new

    def _next(self, key: Hashable) -> int:
        self._counts[key] = self._counts.get(key, 0) + 1
        return self._counts[key]

    def _keep(self, label: str, place: Place) -> Place:
        if label in self.places:
            raise ValueError(f"two things in the note are labelled {label!r}")
        if label:
            self.places[label] = place
        return place
