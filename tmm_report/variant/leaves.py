"""What stands in a file, value by value, with the type that the blocks give it: names, numbers with dimensions, words.

The file's plain data and the models' annotations are walked together; where a type is one of several, the arm is
taken that the shape of what is written, or the union's own discriminator, tells. How the values of a type are walked is
found out once for each model.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache, partial
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel, Discriminator, Tag

from tmm_report.records import dataclass
from tmm_report.variant.values import Named, Reads
from tmm_report.yamlread import Path

UNIONS = (Union, types.UnionType)
SCALAR, LIST, MAP = "scalar", "list", "map"


@dataclass(frozen=True, eq=False)
class Leaf:
    """A value, or a key of a mapping (`is_key`), and how it is read; `known`: of an unknown key, the known ones."""

    path: Path
    written: Any
    reads: Reads | Named | None
    is_key: bool = False
    known: Sequence[str] = ()

    @property
    def dimension(self) -> str:
        """What the number measures; "" of what is no number or measures nothing."""
        measures = isinstance(self.reads, Reads) and not self.is_key and _is_plain(self.written)
        return self.reads.dimension if measures and isinstance(self.reads, Reads) else ""

    @property
    def bounded(self) -> bool:
        """Whether the format states a range for the number."""
        return isinstance(self.reads, Reads) and self.reads.bounded

    @property
    def names(self) -> bool:
        """Whether it is a name, or is made of names."""
        return self.reads is not None and self.reads.names


def _is_plain(value: Any) -> bool:
    return isinstance(value, int | float | str) and not isinstance(value, bool)


Walk = Callable[[Any, Path], Iterator[Leaf]]


def leaves(models: Iterable[type[BaseModel]], data: Any) -> Iterator[Leaf]:
    """Those of the keys that the blocks own; what stands in no block, or in another shape, is passed over."""
    for model in models:
        yield from _of_model(model, data, ())


def _of_model(model: type[BaseModel], data: Any, path: Path) -> Iterator[Leaf]:
    if not isinstance(data, dict):
        return
    walks = _walks(model)
    for key, walk in walks.items():
        if key in data:
            yield from walk(data[key], (*path, key))
    for key in data if path else ():  # at the top of the file other blocks have their keys
        if key not in walks:
            yield Leaf((*path, key), key, None, is_key=True, known=tuple(walks))


@cache
def _walks(model: type[BaseModel]) -> dict[str, Walk]:
    """How the value of each key of a model is walked."""
    if not model.__pydantic_fields_complete__:  # it names a model that stands behind it
        model.model_rebuild()
    return {
        field.alias or name: _walk(field.annotation, (*field.metadata, field.discriminator))
        for name, field in model.model_fields.items()
    }


def _walk(annotation: Any, metadata: tuple[Any, ...] = ()) -> Walk:
    """How a value of a type is walked."""
    if get_origin(annotation) is Annotated:
        inner, *more = get_args(annotation)
        return _walk(inner, (*more, *metadata))
    if (reads := _reads(metadata)) is not None:
        return partial(_of_value, reads)
    if get_origin(annotation) in UNIONS:
        return partial(_of_union, *_members(annotation, metadata))
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return partial(_of_model, annotation)
    return _walk_inside(get_origin(annotation), get_args(annotation))


def _walk_inside(origin: Any, arguments: tuple[Any, ...]) -> Walk:
    """How the keys and values of a mapping, or the items of a list, are walked."""
    if origin is dict:
        return partial(_of_mapping, _reads_of_key(arguments[0]), _walk(arguments[1]))
    if origin in (list, tuple):
        return partial(_of_items, [_walk(kind) for kind in arguments if kind is not ...])
    return _of_nothing


def _of_nothing(data: Any, path: Path) -> Iterator[Leaf]:
    yield from ()


def _of_value(reads: Reads, data: Any, path: Path) -> Iterator[Leaf]:
    if not isinstance(data, dict | list):
        yield Leaf(path, data, reads)


def _of_mapping(reads: Reads | Named | None, walk: Walk, data: Any, path: Path) -> Iterator[Leaf]:
    for key, value in data.items() if isinstance(data, dict) else ():
        if reads is not None:
            yield Leaf((*path, key), key, reads, is_key=True)
        yield from walk(value, (*path, key))


def _of_items(walks: Sequence[Walk], data: Any, path: Path) -> Iterator[Leaf]:
    """Of a tuple each item has its own type, and what is beyond them the last."""
    for index, value in enumerate(data if isinstance(data, list) else ()):
        yield from walks[min(index, len(walks) - 1)](value, (*path, index))


def _reads(metadata: tuple[Any, ...]) -> Reads | None:
    return next((one for one in metadata if isinstance(one, Reads)), None)


def _reads_of_key(annotation: Any) -> Reads | Named | None:
    _, *metadata = get_args(annotation) or (annotation,)
    return next((one for one in metadata if isinstance(one, Reads | Named)), None)


# ---------------------------------------------------------------- unions


def _of_union(key: Callable[[Any], Any], walks: dict[Any, Walk], data: Any, path: Path) -> Iterator[Leaf]:
    yield from walks.get(key(data), _of_nothing)(data, path)


def _members(annotation: Any, metadata: tuple[Any, ...]) -> tuple[Callable[[Any], Any], dict[Any, Walk]]:
    """What tells which member of a union is meant by what is written, and how each is walked."""
    told = next((one.discriminator for one in metadata if isinstance(one, Discriminator)), None)
    walks: dict[Any, Walk] = {}
    for member in get_args(annotation):
        for name in _tags(member) if callable(told) else _shapes(member):
            walks.setdefault(name, _walk(member))
    return told if callable(told) else _shape, walks


def _tags(annotation: Any) -> list[str]:
    if get_origin(annotation) is not Annotated:
        return []
    return [one.tag for one in get_args(annotation)[1:] if isinstance(one, Tag)]


def _shape(data: Any) -> str:
    return MAP if isinstance(data, dict) else LIST if isinstance(data, list) else SCALAR


def _shapes(annotation: Any) -> set[str]:
    """The shapes that a value of the type may have."""
    if annotation is type(None):
        return set()
    while get_origin(annotation) is Annotated:
        annotation, *metadata = get_args(annotation)
        if _reads(tuple(metadata)) is not None:
            return {SCALAR}
    origin = get_origin(annotation)
    if origin in UNIONS:
        return {shape for member in get_args(annotation) for shape in _shapes(member)}
    if origin in (dict, list, tuple):
        return {MAP} if origin is dict else {LIST}
    is_model = isinstance(annotation, type) and issubclass(annotation, BaseModel)
    return {SCALAR, MAP} if is_model else {SCALAR}
