"""What the models allow at a path of the file, whichever of several forms is written there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, Any, get_args, get_origin

from pydantic import BaseModel

from tmm_report.variant.leaves import UNIONS
from tmm_report.yamlread import Path

Models = Iterable[type[BaseModel]]

DEEP = 3  # levels of blocks in which a key is looked for


def forms_at(path: Path, roots: Models) -> list[type[BaseModel]]:
    """The models that may stand at the path."""
    models = list(roots)
    for part in path:
        fields = [field for model in models for name, field in fields_of(model) if name == part]
        if fields:  # else a key of a mapping or an index: the same models lie under it
            models = [inner for field in fields for inner in _models(field.annotation)]
    return models


def fields_at(path: Path, roots: Models) -> dict[str, Any]:
    """Names (as written in the file) -> fields that the models allow at the path."""
    return {name: field for model in forms_at(path, roots) for name, field in fields_of(model)}


def fields_of(model: type[BaseModel]) -> Iterator[tuple[str, Any]]:
    """A model's fields by their names in the file."""
    return ((field.alias or name, field) for name, field in model.model_fields.items())


def own_keys(field: Any) -> set[str]:
    """The keys that stand right under a field, not in a list or a mapping of names."""
    return {name for model in _direct(field.annotation) for name, _ in fields_of(model)}


def homes(key: str, models: Models, around: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """The blocks, by their paths, right under which a key is known; not those in lists and mappings of names."""
    for model in models:
        for name, field in fields_of(model):
            if name == key and around:
                yield around
            if len(around) < DEEP:
                yield from homes(key, _direct(field.annotation), (*around, name))


def _models(annotation: Any) -> Iterator[Any]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for argument in get_args(annotation):
        yield from _models(argument)


def _direct(annotation: Any) -> Iterator[Any]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    elif get_origin(annotation) is Annotated:
        yield from _direct(get_args(annotation)[0])
    elif get_origin(annotation) in UNIONS:
        for arm in get_args(annotation):
            yield from _direct(arm)
