"""Numbers of sections, formulas, tables and figures, given by us and written explicitly in every format."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple


class Place(NamedTuple):
    """Where a numbered thing stands: its number as printed ("2.1") and its anchor, safe in every format."""

    number: str
    anchor: str


class Section(NamedTuple):
    """A line of the contents; `level` 1 for a chapter."""

    place: Place
    title: str
    level: int


UNKNOWN = Place("?", "unknown")


@dataclass
class Numbering:
    """Counts one pass over the templates. `known`: label -> place from the pass before, for forward references.

    Figures and tables are numbered through, formulas by chapter. An anchor is made of kind and number alone, so
    that nothing a user wrote gets into it.
    """

    known: Mapping[str, Place] = field(default_factory=dict)
    places: dict[str, Place] = field(default_factory=dict)
    sections: list[Section] = field(default_factory=list)
    missing: set[str] = field(default_factory=set)
    _counts: dict[Hashable, int] = field(default_factory=dict)
    _explained: set[Hashable] = field(default_factory=set)

    def section(self, title: str, level: int = 1, label: str = "") -> Place:
        """The next section of a level: 1, 2, ...; 2.1, 2.2, ..."""
        above = self.sections[-1].place.number.split(".")[: level - 1] if level > 1 else []
        number = ".".join([*above, str(self._next(("section", *above)))])
        place = self._keep(label, Place(number, f"section{number}"))
        self.sections.append(Section(place, title, level))
        return place

    def unnumbered(self, title: str, label: str) -> Place:
        """A chapter without a number, as conclusions and references are."""
        place = self._keep(label, Place("", f"section-{label.rpartition(':')[2]}"))
        self.sections.append(Section(place, title, 1))
        return place

    def take(self, kind: str, label: str = "") -> Place:
        """The next number of a kind: "figure", "table", "formula"."""
        if kind != "formula":
            number = str(self._next(kind))
        else:
            chapter = self.sections[-1].place.number.split(".")[0] if self.sections else "0"
            number = f"{chapter}.{self._next((kind, chapter))}"
        return self._keep(label, Place(number, f"{kind}{number}"))

    def place(self, label: str) -> Place:
        """The place of a label, also of one that comes later; in the first pass an unknown one is noted."""
        found = self.places.get(label) or self.known.get(label)
        if found is None:
            self.missing.add(label)
        return found or UNKNOWN

    def fresh(self, items: Iterable[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
        """Those of a "where" list's items that have not been explained before, by their "id"."""
        new = []
        for item in items:
            if item["id"] not in self._explained:
                self._explained.add(item["id"])
                new.append(item)
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
