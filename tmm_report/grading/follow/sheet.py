"""A student's numbers as vectors, angles and signed values, and what each of them would be: the list of `Follow`s.

Plans give magnitudes: a magnitude is a vector along the direction that follows from the student's other numbers; an
angular rate without signs has the sign that follows. Components, where given, come first.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.grading.follow.known import Known, first
from tmm_report.records import dataclass

Array = Any
NOTHING = 1e-9  # of the greatest of the column: a vector without direction


@dataclass(frozen=True, eq=False)
class Follow:
    """What a quantity would be, rightly computed from the student's own numbers: (P,), nan where none of them is
    his. `sources`: the keys of these numbers, sorted."""

    values: Array
    sources: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Other:
    """Another number that says the same of a vector: its value along a direction, or its angle.

    `of`: vector -> number; `vector`: (number, the vector so far) -> vector. `before`: it comes before the magnitude
    and is taken together with it.
    """

    key: str
    of: Callable[[Array], Array]
    vector: Callable[[Array, Array], Array]
    before: bool = False


@dataclass(frozen=True, eq=False)
class Names:
    """Keys of a vector's magnitude ("" for none) and components, and what else says it."""

    size: str
    x: str
    y: str
    other: Other | None = None


def names(key: str, other: Other | None = None) -> Names:
    return Names(key, f"{key}_x", f"{key}_y", other)


@dataclass(frozen=True, eq=False)
class Same:
    """Another key of a number: `of`: this number -> that; `back`: that -> this."""

    key: str
    of: Callable[[Array], Array] = lambda x: x
    back: Callable[[Array], Array] = lambda x: x


@dataclass(eq=False)
class Sheet:
    """`given`: key -> the student's numbers, (P,), nan where he gave none; `found`: what follows, in the order of
    computation; `wanted`: of which keys alone, None for all."""

    given: Mapping[str, Array]
    wanted: Container[str] | None = None
    found: dict[str, list[Known]] = field(default_factory=dict)

    def without(self, given: Mapping[str, Array]) -> Sheet:
        """The same list of what follows, to be gone on with from other numbers."""
        return Sheet(given, self.wanted, self.found)

    def gives(self, *keys: str) -> bool:
        return any(key in self.given for key in keys)

    # ------------------------------------------------------------ vectors

    def vector(self, of: Names, right: Array, *choices: Known) -> Known:
        """The student's own vector, else the first of `choices` that is his; each of these is noted as a follow."""
        self._mention(of.size, of.x, of.y, of.other.key if of.other else "")
        computed = first(right, choices)
        own = self.own_vector(of, computed.value)
        for known in (*choices, *own):
            self._note_vector(of, known)
        return first(computed.value, [*own, computed]) if own else computed

    def own_vector(self, of: Names, computed: Array) -> list[Known]:
        """The vector as the student states it, by each of the ways in which he does; the surest first."""
        size = self._by_size(of, computed)
        ways = [self._by_parts(of, size.value if size else computed), size]
        if of.other and of.other.key in self.given:
            ways.insert(1 if of.other.before else 2, self._by_other(of, of.other, size, computed))
        return [way for way in ways if way is not None]

    def _by_size(self, of: Names, computed: Array) -> Known | None:
        if of.size not in self.given:
            return None
        size, length = np.abs(self.given[of.size]), np.abs(computed)
        some = length > NOTHING * np.nanmax(length, initial=0.0)
        told = np.isfinite(size) & np.isfinite(length)
        value = np.where(told & some, computed * (size / length), computed)
        return Known(value, told & np.isfinite(value), frozenset([of.size]))

    def _by_parts(self, of: Names, so_far: Array) -> Known | None:
        keys = [key for key in (of.x, of.y) if key in self.given]
        if not keys:
            return None
        x, y = (
            np.where(np.isfinite(part), part, rest) if (part := self.given.get(key)) is not None else rest
            for key, rest in ((of.x, np.real(so_far)), (of.y, np.imag(so_far)))
        )
        told = np.logical_or.reduce([np.isfinite(self.given[key]) for key in keys])
        return Known(x + 1j * y, told & np.isfinite(x + y), frozenset(keys))

    def _by_other(self, of: Names, other: Other, size: Known | None, computed: Array) -> Known:
        joined = size if size is not None and other.before else Known(computed)
        value = other.vector(self.given[other.key], joined.value)
        return Known(value, np.isfinite(value), joined.sources | {other.key})

    def _note_vector(self, of: Names, known: Known) -> None:
        if known.sources:
            ways: list[tuple[str, Callable[[Array], Array]]] = [
                (of.size, np.abs),
                (of.x, np.real),
                (of.y, np.imag),
            ]
            if of.other:
                ways.append((of.other.key, of.other.of))
            for key, say in ways:
                if key and (self.wanted is None or key in self.wanted):
                    self.note(key, Known(say(known.value), known.told, known.sources))

    # ------------------------------------------------------------ numbers

    def number(self, key: str, right: Array, *choices: Known, same: Same | None = None) -> Known:
        """The student's own number, else the first of `choices` that is his; each of these is noted as a follow."""
        self._mention(key, same.key if same else "")
        computed = first(right, choices)
        own = self.own_number(key, computed.value, same)
        for known in (*choices, *own):
            self.note(key, known)
            if same and known.sources:
                self.note(same.key, Known(same.of(known.value), known.told, known.sources))
        return first(computed.value, [*own, computed]) if own else computed

    def own_number(self, key: str, computed: Array, same: Same | None = None) -> list[Known]:
        """The number as the student states it; a column without a negative number says magnitudes, whose signs are
        those computed."""
        found = []
        for name, back in ((key, None), (same.key, same.back) if same else ("", None)):
            if name in self.given:
                value = self.given[name] if back is None else back(self.given[name])
                if not (self.given[name] < 0).any():
                    value = np.abs(value) * np.where(computed < 0, -1.0, 1.0)
                found.append(Known(value, np.isfinite(value), frozenset([name])))
        return found

    def turn(self, key: str, right: Array, *choices: Known, same: Same | None = None) -> Known:
        """A direction, unit complex, whose angle the student states in degrees."""
        self._mention(key, same.key if same else "")
        computed = first(right, choices)
        own = self._own_turn(key, same)
        for known in (*choices, *own):
            if known.sources:
                self.note(key, Known(np.degrees(np.angle(known.value)), known.told, known.sources))
                if same:
                    self.note(same.key, Known(same.of(known.value), known.told, known.sources))
        return first(computed.value, [*own, computed]) if own else computed

    def _own_turn(self, key: str, same: Same | None) -> list[Known]:
        found = []
        if key in self.given:
            value = np.exp(1j * np.radians(self.given[key]))
            found.append(Known(value, np.isfinite(value), frozenset([key])))
        if same and same.key in self.given:
            value = same.back(self.given[same.key])
            found.append(Known(value, np.isfinite(value), frozenset([same.key])))
        return found

    # ------------------------------------------------------------ what follows

    def note(self, key: str, known: Known) -> None:
        """Keep what a quantity would be, unless it was made of the quantity itself or is kept already."""
        if known.sources and key not in known.sources and (self.wanted is None or key in self.wanted):
            kept = self.found.setdefault(key, [])
            if not any(one.sources == known.sources and _alike(one, known) for one in kept):
                kept.append(known)

    def _mention(self, *keys: str) -> None:
        """Keep the place of keys in the order of computation."""
        for key in keys:
            if key and (self.wanted is None or key in self.wanted):
                self.found.setdefault(key, [])

    def follows(self) -> dict[str, tuple[Follow, ...]]:
        return {key: tuple(map(_follow, kept)) for key, kept in self.found.items()}


def _follow(known: Known) -> Follow:
    some = known.told & np.isfinite(known.value)
    return Follow(np.where(some, known.value, np.nan), tuple(sorted(known.sources)))


def _alike(one: Known, other: Known) -> bool:
    """Whether two numbers are the same but for rounding."""
    gap = np.abs(one.value - other.value)
    same = (gap <= 1e-9 * np.abs(one.value)) | ~one.told
    return bool((same & (one.told == other.told)).all())


def column(values: Sequence[float] | Array) -> Array:
    """A student's numbers as an array; infinite ones are none."""
    numbers = np.asarray(values, dtype=float)
    return np.where(np.isfinite(numbers), numbers, np.nan)
