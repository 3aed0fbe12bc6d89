"""What stands in a file, value by value, with the type that the blocks give it: names, numbers with dimensions, words.

The file's plain data and the models' annotations are walked together; where a type is one of several, the arm is
taken that the shape of what is written, or the union's own discriminator, tells.
"""

from __future__ import annotations

import types
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel, Discriminator, Tag

from tmm_report.variant.values import Named, Reads
from tmm_report.yamlread import Path

UNIONS = (Union, types.UnionType)


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


def leaves(models: Iterable[type[BaseModel]], data: Any) -> Iterator[Leaf]:
    """Those of the keys that the blocks own; what stands in no block, or in another shape, is passed over."""
    for model in models:
        yield from _of_model(model, data, ())


def _of_model(model: type[BaseModel], data: Any, path: Path) -> Iterator[Leaf]:
    if not isinstance(data, dict):
        return
    fields = {field.alias or name: field for name, field in model.model_fields.items()}
    for key, field in fields.items():
        if key in data:
            yield from _of(field.annotation, (*field.metadata, field.discriminator), data[key], (*path, key))
    for key in data if path else ():  # at the top of the file other blocks have their keys
        if key not in fields:
            yield Leaf((*path, key), key, None, is_key=True, known=tuple(fields))


def _of(annotation: Any, metadata: tuple[Any, ...], data: Any, path: Path) -> Iterator[Leaf]:
    """What a type says of a value."""
    if get_origin(annotation) is Annotated:
        inner, *more = get_args(annotation)
        yield from _of(inner, (*more, *metadata), data, path)
    elif (reads := _reads(metadata)) is not None:
        if not isinstance(data, dict | list):
            yield Leaf(path, data, reads)
    elif get_origin(annotation) in UNIONS:
        arm = _arm(annotation, metadata, data)
        yield from _of(arm, (), data, path) if arm is not None else ()
    elif isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield from _of_model(annotation, data, path)
    else:
        yield from _inside(get_origin(annotation), get_args(annotation), data, path)


def _reads(metadata: tuple[Any, ...]) -> Reads | None:
    for one in metadata:
        if isinstance(one, Reads):
            return one
    return None


def _inside(origin: Any, arguments: tuple[Any, ...], data: Any, path: Path) -> Iterator[Leaf]:
    """The keys and values of a mapping, the items of a list."""
    if origin is dict and isinstance(data, dict):
        for key, value in data.items():
            yield from _key(arguments[0], key, (*path, key))
            yield from _of(arguments[1], (), value, (*path, key))
    elif origin in (list, tuple) and isinstance(data, list):
        for index, value in enumerate(data):
            kind = arguments[0] if origin is list else arguments[min(index, len(arguments) - 1)]
            yield from _of(kind, (), value, (*path, index))


def _key(annotation: Any, key: str, path: Path) -> Iterator[Leaf]:
    _, *metadata = get_args(annotation) or (annotation,)
    if reads := next((one for one in metadata if isinstance(one, Reads | Named)), None):
        yield Leaf(path, key, reads, is_key=True)


def _arm(annotation: Any, metadata: tuple[Any, ...], data: Any) -> Any:
    """The member of a union that is meant by what is written."""
    arms = [arm for arm in get_args(annotation) if arm is not type(None)]
    told = next((one for one in metadata if isinstance(one, Discriminator)), None)
    if told is not None and callable(told.discriminator):
        tag = told.discriminator(data)
        return next((arm for arm in arms if any(one.tag == tag for one in _tags(arm))), None)
    return next((arm for arm in arms if _fits(arm, data)), None)


def _tags(annotation: Any) -> list[Tag]:
    if get_origin(annotation) is not Annotated:
        return []
    return [one for one in get_args(annotation)[1:] if isinstance(one, Tag)]


def _fits(annotation: Any, data: Any) -> bool:
    """Whether what is written has the shape of the type."""
    while get_origin(annotation) is Annotated:
        annotation, *metadata = get_args(annotation)
        if any(isinstance(one, Reads) for one in metadata):
            return not isinstance(data, dict | list)
    if get_origin(annotation) in UNIONS:
        return any(_fits(arm, data) for arm in get_args(annotation) if arm is not type(None))
    if isinstance(data, dict):
        is_model = isinstance(annotation, type) and issubclass(annotation, BaseModel)
        return is_model or get_origin(annotation) is dict
    if isinstance(data, list):
        return get_origin(annotation) in (list, tuple)
    return get_origin(annotation) not in (dict, list, tuple)
