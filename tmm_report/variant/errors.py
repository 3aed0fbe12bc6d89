"""pydantic's errors -> Problems: the path in the file's own words, what is wrong, what would be right."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity.units import WrongValue
from tmm_report.yamlread import Path

_TEXTS = {
    "dict_type": N_("keys with values are expected here"),
    "model_type": N_("keys with values are expected here"),
    "model_attributes_type": N_("keys with values are expected here"),
    "list_type": N_("a list in square brackets is expected here"),
    "tuple_type": N_("a list in square brackets is expected here"),
    "string_type": N_("a word is expected here"),
    "too_short": N_("too few values: %(min_length)s expected, %(actual_length)s found"),
    "too_long": N_("too many values: %(max_length)s expected"),
    "string_too_long": N_("the key is longer than %(max_length)s characters"),
    "string_pattern_mismatch": N_("a number of a position is expected as the key"),
    "shape": N_("this has another form than expected here"),
}


Roots = Callable[[], Iterable[type[BaseModel]]]
"""The blocks of the format, all of them: asked for only where a message names known keys, as some are slow to load."""


def problems(error: ValidationError, data: Any, roots: Roots) -> list[Problem]:
    """One Problem for each of the errors that validating `data` gave."""
    return [_problem(one, data, roots) for one in error.errors(include_url=False)]


def near(word: str, known: Sequence[str]) -> Message | None:
    """`did you mean ...?` with the nearest known word, or the list of known words, or nothing."""
    if nearest := difflib.get_close_matches(word, known, 1, 0.6):
        return Message(N_("did you mean %(near)s?"), {"near": nearest[0]})
    return Message(N_("known: %(words)s"), {"words": shown(", ".join(known), 200)}) if known else None


def _problem(error: Any, data: Any, roots: Roots) -> Problem:
    path = data_path(error["loc"], data, error["type"] == "missing")
    kind, context = error["type"], error.get("ctx", {})
    cause = context.get("error")
    if isinstance(cause, WrongValue):
        return Problem(cause.wrong, cause.right, path)
    if kind == "missing":
        return _missing(path, roots)
    if kind == "extra_forbidden":
        right = near(str(path[-1]), sorted(_fields(path[:-1], roots)))
        return mistake(N_("unknown key %(key)s"), path, right, key=shown(path[-1]))
    if kind == "literal_error":
        return _not_a_word(error, path)
    right = Message(error["msg"]) if kind == "shape" else None
    if kind in _TEXTS:
        return mistake(_TEXTS[kind], path, right, **context)
    return mistake(N_("the value does not fit: %(reason)s"), path, reason=shown(error["msg"], 120))


def _missing(path: Path, roots: Roots) -> Problem:
    if isinstance(path[-1], int):
        return mistake(N_("a value of the list is missing"), path[:-1])
    examples = getattr(_fields(path[:-1], roots).get(path[-1]), "examples", None)
    right = (
        Message(N_("for example, %(example)s"), {"example": f"{path[-1]}: {examples[0]}"})
        if examples
        else None
    )
    return mistake(N_("the key %(key)s is missing"), path, right, key=path[-1])


def _not_a_word(error: Any, path: Path) -> Problem:
    words = re.findall(r"'([^']*)'", error["ctx"]["expected"])
    given = error["input"]
    quoted = shown(given) if isinstance(given, str | int | float) else "[…]"
    right = Message(N_("one of: %(words)s"), {"words": ", ".join(words)})
    return mistake(N_("%(value)s is not a word known here"), path, right, value=quoted)


def data_path(loc: Sequence[str | int], data: Any, missing: bool = False) -> Path:
    """pydantic's location without its own marks (tags of unions, "[key]"): the path in the data."""
    path: list[str | int] = []
    for index, part in enumerate(loc):
        found = isinstance(part, str) and isinstance(data, dict) and part in data
        found |= isinstance(part, int) and isinstance(data, list) and part < len(data)
        if found:
            data = data[part]
        if found or (missing and index == len(loc) - 1):
            path.append(part)
    return tuple(path)


def _fields(path: Path, roots: Roots) -> dict[str, Any]:
    """Names (as written in the file) -> fields that the models allow at the path."""
    models = list(roots())
    for part in path:
        fields = [field for model in models for name, field in _named(model) if name == part]
        if fields:  # else a key of a mapping or an index: the same models lie under it
            models = [inner for field in fields for inner in _models(field.annotation)]
    return {name: field for model in models for name, field in _named(model)}


def _named(model: type[BaseModel]) -> Iterator[tuple[str, Any]]:
    return ((field.alias or name, field) for name, field in model.model_fields.items())


def _models(annotation: Any) -> Iterator[Any]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for argument in get_args(annotation):
        yield from _models(argument)
