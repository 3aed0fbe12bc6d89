"""What the blocks of a variant are made of, and what the room of a block offers the reader."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, ClassVar, Literal, Protocol, TypeVar, get_args, get_origin

from pydantic import BaseModel, ConfigDict, model_validator

from tmm_report.problems import N_, Message, Problem
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.variant.russian import english
from tmm_report.variant.russian import words as russian_words
from tmm_report.yamlread import Path


class Model(BaseModel):
    """A mapping of the file: other keys than its fields are mistakes."""

    model_config = ConfigDict(
        extra="forbid", allow_inf_nan=False, hide_input_in_errors=True, defer_build=True, frozen=True
    )

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {}
    """Keys that one may look for here, with what to say of each: what they ask for is not offered."""

    @model_validator(mode="before")
    @classmethod
    def words_in_russian(cls, data: Any) -> Any:
        """Value words may be written in Russian."""
        if not isinstance(data, dict) or all(_plain(value) for value in data.values()):
            return data
        words = _words_of(cls)
        return {key: _in_english(value, words.get(key, frozenset())) for key, value in data.items()}


def one_of(model: Any, names: tuple[str, ...], text: str) -> Any:
    """A model that states one of these keys. Raises WrongValue, with the text, where it states none or several."""
    if sum(getattr(model, name) is not None for name in names) != 1:
        raise WrongValue(Message(text), Message(N_("exactly one of: %(words)s"), {"words": ", ".join(names)}))
    return model


def _plain(value: object) -> bool:
    """Whether there is no Russian word in a value, in a list of them, or in what says the kind of a mapping."""
    if isinstance(value, list):
        return all(_plain(one) for one in value)
    if isinstance(value, dict):
        return _plain(value.get("kind"))
    return not isinstance(value, str) or value.isascii()


def _in_english(value: Any, words: Collection[str]) -> Any:
    """A value word, or the kind of a mapping: by that its form is chosen, before it is read."""
    if isinstance(value, list):
        return [_in_english(one, words) for one in value]
    if isinstance(value, dict) and not _plain(value):
        return {**value, "kind": english(value["kind"], russian_words())}
    return english(value, words)


@cache
def _words_of(model: type[Model]) -> Mapping[str, frozenset[str]]:
    """By the keys of a mapping the words that may stand there."""
    found = {}
    for name, field in model.model_fields.items():
        words = frozenset(_words(field.annotation)) | frozenset(
            one for part in field.metadata for one in _words(part)
        )
        if words:
            found[field.alias or name] = words
    return found


def _words(of: Any) -> Iterator[str]:
    if get_origin(of) is Literal:
        yield from (word for word in get_args(of) if isinstance(word, str))
    elif words := getattr(of, "become", None):  # values.Words
        yield from words
    else:
        for part in (*get_args(of), *getattr(of, "__metadata__", ())):
            yield from _words(part)


class Block(Model):
    """The keys of a variant that one chapter owns, as fields."""

    AS_WRITTEN: ClassVar[frozenset[str]] = frozenset()
    """Keys whose mapping holds texts: a number there stays as it was written, group 21.10 is not 21.1."""
    HOLES: ClassVar[frozenset[Path]] = frozenset()
    """Lists in which a wrong item leaves a hole, None, so that the others keep their numbers."""
    ALONE: ClassVar[bool] = False
    """Whether a variant may have this block and no lever mechanism."""
    ONE_SIZE: ClassVar[bool] = False
    """Whether the lengths of the block are of one order of magnitude: one far from the others is odd."""


B = TypeVar("B", bound=Block)


@dataclass(frozen=True, eq=False)
class Read:
    """A variant as it was read: each chapter's block, and beside it the plain data of the file.

    A part that is wrong in itself is missing from the blocks and its path is in `broken`. Names are therefore taken
    from `data`, right or wrong: a point whose length is mistyped is still a known point.
    """

    data: Mapping[str, Any]
    broken: frozenset[Path]
    blocks: Mapping[type[Block], Block]
    doubts: tuple[Problem, ...] = ()
    """What looks odd in a variant without mistakes, with its places."""

    def block(self, kind: type[B]) -> B:
        """A chapter's block; of what the file leaves out, the default."""
        found = self.blocks.get(kind)
        return found if isinstance(found, kind) else kind.model_construct()

    @property
    def alone(self) -> bool:
        """Whether the file has a block that is a variant without a lever mechanism."""
        return any(key in self.data for block in self.blocks if block.ALONE for key in block.model_fields)

    def says(self, path: Path, word: str) -> bool:
        """Whether the file has a word at a path, itself or its Russian twin."""
        found: Any = self.data
        for key in path:
            found = found.get(key) if isinstance(found, Mapping) else None
        found = english(found, (word,))
        return isinstance(found, str) and found.strip() == word

    def is_broken(self, key: str) -> bool:
        """Whether something is wrong under a key of the file."""
        return any(path[:1] == (key,) for path in self.broken)


class Room(Protocol):
    """What `chapters.<name>.block` offers."""

    @property
    def Block(self) -> type[Block]: ...

    def given(self, read: Read) -> Mapping[str, object]:
        """What the chapter is given, SI, by the names of the fields of the course's record."""

    def mistakes(self, read: Read) -> Iterator[Problem]:
        """What the parts that are right in themselves say wrong about one another."""

    # def doubts(self, read: Read) -> Iterator[Problem]
    #     a room may have it: what looks odd in a variant without mistakes and is solved all the same


@dataclass(frozen=True, eq=False)
class Rooms:
    """The rooms of all blocks. `others`: how those are loaded that most files do without, by the key of their block."""

    usual: Sequence[Room]
    others: Mapping[str, Callable[[], Room]]

    def owning(self, keys: set[str]) -> list[Room]:
        """The rooms that a file with these keys needs; all of them where nobody owns a key, to find the nearest."""
        rest = keys - {key for room in self.usual for key in room.Block.model_fields}
        if not rest <= self.others.keys():
            return self.all()
        return [*self.usual, *(load() for key, load in self.others.items() if key in rest)]

    def keys(self) -> set[str]:
        """All keys that may stand at the top of a file."""
        return {key for room in self.usual for key in room.Block.model_fields} | self.others.keys()

    def all(self) -> list[Room]:
        return [*self.usual, *(load() for load in self.others.values())]
