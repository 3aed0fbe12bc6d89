"""A variant's YAML text -> course.Variant, or every mistake of the file at once."""

from __future__ import annotations

import os
from copy import deepcopy
from dataclasses import replace
from typing import Any

from pydantic import ValidationError

from tmm_report import course, languages, yamlread
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.resources import data_root
from tmm_report.variant import build, checks, errors
from tmm_report.variant.models import LeverModel
from tmm_report.yamlread import Document, Path, file_label, located

__all__ = ["load", "loads", "locate", "new", "schema"]


def load(path: str | os.PathLike[str]) -> course.Variant:
    """Read a variant's file. Raises ProblemError with all the mistakes of the file."""
    soft: list[Problem] = []
    return _variant(yamlread.read(path, soft), file_label(path), soft)


def loads(text: str | bytes, file: str = "") -> course.Variant:
    """The variant that a text states; `file` is its name for messages. Raises ProblemError."""
    soft: list[Problem] = []
    return _variant(yamlread.loads(text, file, soft), file, soft)


def locate(problem: Problem, variant: course.Variant) -> Problem:
    """A problem met after reading, with the file, line and column of its key or the nearest key around it."""
    texts = {tuple(map(str, path)): place for path, place in variant.places.items()}
    path = tuple(map(str, problem.path))  # a solver may call link 2 a number
    depth = next(n for n in range(len(path), -1, -1) if path[:n] in texts or not n)
    return located(problem, {problem.path[:depth]: texts.get(path[:depth], (1, 1))}, variant.file)


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of the format, for editors."""
    from tmm_report.variant.editor import schema_of  # only `tmm-report schema` needs it
    from tmm_report.variant.whole import VariantModel

    return schema_of(VariantModel)


def new(language: str) -> str:
    """A commented starting variant in the language. Raises ProblemError for a language that there is not."""
    return (data_root() / "templates" / "new" / f"{languages.language(language).code}.yaml").read_text(
        "utf-8"
    )


def _variant(document: Document, file: str, soft: list[Problem]) -> course.Variant:
    problems, data = list(soft), document.data
    if not isinstance(data, dict):
        right = Message(N_("start from the one that `tmm-report new` writes"))
        problems.append(mistake(N_("the file has no variant"), right=right))
        raise ProblemError([located(problem, document.places, file) for problem in problems])
    data, empty = _without_empty(_raw_title(document), ())
    problems += empty
    model, wrong = _validated(data)
    reported = {problem.path for problem in problems}
    problems += [problem for problem in wrong if problem.path not in reported]
    if model is not None:
        problems += checks.check(model, data, [problem.path for problem in problems])
    if problems or model is None:
        found = [located(problem, document.places, file) for problem in problems]
        raise ProblemError(sorted(found, key=lambda problem: (problem.line or 0, problem.column or 0)))
    made = build.variant(model, document.places, file, checks.has_mechanism(document.data))
    if type(model) is LeverModel:
        return made
    from tmm_report.variant.whole import gears_of

    return replace(made, **gears_of(model))


def _raw_title(document: Document) -> dict[str, Any]:
    """The data with the title's numbers as they were written: group 21.10 is not 21.1."""
    title = document.data.get("title")
    if not isinstance(title, dict):
        return document.data
    raw = {key: document.raw.get(("title", key), value) for key, value in title.items()}
    return {**document.data, "title": raw}


def _without_empty(value: Any, path: Path) -> tuple[Any, list[Problem]]:
    """The data without the keys that have no value, and a Problem for each."""
    problems: list[Problem] = []
    items = list(value.items() if isinstance(value, dict) else enumerate(value))
    kept: dict[Any, Any] = {}
    for key, item in items:
        if item is None:
            right = Message(N_("write the value or take the key out"))
            problems.append(mistake(N_("there is no value here"), (*path, key), right))
        elif isinstance(item, dict | list):
            kept[key], inner = _without_empty(item, (*path, key))
            problems += inner
        else:
            kept[key] = item
    return (kept if isinstance(value, dict) else [kept.get(index) for index, _ in items]), problems


def _validated(data: dict[str, Any]) -> tuple[LeverModel | None, list[Problem]]:
    """The model of what is right in itself, and the mistakes of what is not.

    What is wrong is taken out and the rest validated again: a part that cannot do without it goes with it.
    """
    problems: list[Problem] = []
    rest, model = data, _model_of(data)
    for attempt in range(yamlread.DEPTH + 2):
        try:
            return model.model_validate(rest), problems
        except ValidationError as error:
            found = errors.problems(error, rest)
        if attempt == 0:
            problems, rest = found, deepcopy(data)
        for path in dict.fromkeys(problem.path for problem in found):
            _prune(rest, path)
    return None, problems


def _model_of(data: dict[str, Any]) -> type[LeverModel]:
    """The lever's part of the format where the file has nothing else: the gears' part takes time to load."""
    if set(data) <= set(LeverModel.model_fields):
        return LeverModel
    from tmm_report.variant.whole import VariantModel

    return VariantModel


def _prune(data: dict[str, Any], path: Path) -> None:
    """Take out what is at the path: a key, or the list that the item is in. What lacks a key goes itself.

    A load leaves a hole, so that the other loads keep their numbers.
    """
    inside: Any = data
    for part in path[:-1]:
        if inside is None or (isinstance(inside, dict) and part not in inside):
            return  # gone with another mistake
        inside = inside[part]
    if path[:2] in (("loads", "forces"), ("loads", "moments")) and len(path) == 3:
        inside[path[-1]] = None
    elif isinstance(inside, dict) and path and path[-1] in inside:
        del inside[path[-1]]
    elif path:
        _prune(data, path[:-1])
