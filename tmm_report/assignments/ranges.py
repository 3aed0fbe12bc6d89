"""The ranges file: a template and the parameters that differ from student to student, with all its mistakes at once."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path as File
from typing import Any

from tmm_report import yamlread
from tmm_report.assignments.conditions import condition, mentions
from tmm_report.assignments.model import Bound, Condition, Parameter, Ranges, Template
from tmm_report.assignments.options import parameter
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.quantity.text import for_example
from tmm_report.quantity.units import WrongValue, parse
from tmm_report.variant.errors import near
from tmm_report.yamlread import Document, Path

KEYS = ("template", "parameters", "conditions", "least_closeness", "require")
MANY = 60  # parameters


def is_ranges(document: Document) -> bool:
    """Whether a file is a ranges file, and not a variant."""
    data = document.data
    return isinstance(data, dict) and "parameters" in data and "mechanism" not in data


def template_of(document: Document, path: str | os.PathLike[str]) -> Template:
    """A variant's text as a template. Its readings are one student's own: they are left out. Raises ProblemError."""
    if not isinstance(document.data, dict):
        right = Message(N_("start from the one that `tmm-report new` writes"))
        problem = mistake(N_("the file has no variant"), right=right)
        raise ProblemError([yamlread.located(problem, document.places, yamlread.file_label(path))])
    data = {key: value for key, value in document.data.items() if key != "readings"}
    return Template(data, File(path), document.raw)


def read(path: str | os.PathLike[str]) -> Ranges:
    """The ranges and the template that they name, beside them. Raises ProblemError with all mistakes of the file."""
    return of_document(yamlread.read(path), path)


def of_document(document: Document, path: str | os.PathLike[str]) -> Ranges:
    """The ranges that a read file states; `path`: where it lies. Raises ProblemError."""
    file, problems = yamlread.file_label(path), list[Problem]()
    data = document.data if isinstance(document.data, dict) else {}
    unknown = (key for key in data if key not in KEYS)
    problems += [mistake(N_("unknown key %(key)s"), (k,), near(k, KEYS), key=shown(k)) for k in unknown]
    template = _template(data.get("template"), File(path).parent, problems)
    parameters = _parameters(data.get("parameters"), template, document, problems) if template else ()
    ranges = Ranges(
        template or Template({}, File()),
        parameters,
        tuple(_conditions(data, parameters, problems)) if parameters else (),
        _closeness(data.get("least_closeness"), problems),
        tuple(_bounds(data.get("require"), document, problems)),
        file,
    )
    if problems:
        raise ProblemError(_sorted(problems, document, file))
    return ranges


def _sorted(problems: list[Problem], document: Document, file: str) -> list[Problem]:
    """With their places, in the order of the file; those of the template after them."""
    found = [p if p.file else yamlread.located(p, document.places, file) for p in problems]
    return sorted(found, key=lambda p: (p.file != file, p.line or 0, p.column or 0))


def _template(name: object, folder: File, problems: list[Problem]) -> Template | None:
    if not isinstance(name, str) or not name.strip():
        right = Message(N_("for example, %(example)s"), {"example": "template: compressor.yaml"})
        problems.append(mistake(N_("the key %(key)s is missing"), ("template",), right, key="template"))
        return None
    try:
        path = folder / name
        return template_of(yamlread.read(path), path)
    except ProblemError as error:
        # a file that cannot be opened is a mistake of the name, others are mistakes of the template
        problems += [p if p.line is not None else _named(p, name) for p in error.problems]
        return None


def _named(problem: Problem, name: str) -> Problem:
    wrong = Message("%(name)s: %(what)s", {"name": shown(name, 120), "what": problem.wrong})
    return replace(problem, wrong=wrong, path=("template",), file="")


# ---------------------------------------------------------------- parameters


def _parameters(
    data: object, template: Template, document: Document, problems: list[Problem]
) -> tuple[Parameter, ...]:
    if not isinstance(data, dict) or not data or len(data) > MANY:
        right = for_example("OA: {key: mechanism.links.1.points.A, from: 80 mm, to: 120 mm, step: 5 mm}")
        text = N_("from 1 to %(most)s parameters by their names are expected here")
        problems.append(mistake(text, ("parameters",), right, most=MANY))
        return ()
    found: dict[str, Parameter] = {}
    for name, stated in data.items():
        path = ("parameters", name)
        try:
            one = parameter(name, stated, template, found, path, document.raw)
        except ProblemError as error:
            problems += error.problems
        else:
            problems += _twice(one, found.values(), path)
            found[name] = replace(one, place=document.places.get(path))
    return tuple(found.values())


def _twice(one: Parameter, others: Any, path: Path) -> Iterator[Problem]:
    """Places of the template that two parameters would write, one within the other or the same."""
    for other in others:
        for a, b in ((a, b) for a in one.paths for b in other.paths):
            if a[: len(b)] == b[: len(a)]:
                text = N_("%(key)s is already written by %(other)s")
                yield mistake(text, path, key=".".join(map(str, a)), other=other.name)


# ---------------------------------------------------------------- what is asked of a variant


def _conditions(data: Any, parameters: tuple[Parameter, ...], problems: list[Problem]) -> Iterator[Condition]:
    """Those of parameters that are wrong themselves are passed over."""
    broken = set(data["parameters"] or ()) - {one.name for one in parameters}
    for n, text in enumerate(_list(data.get("conditions"), "conditions", "AB > 2*OA", problems)):
        try:
            yield condition(text, {p.name: p for p in parameters})
        except WrongValue as error:
            if not mentions(text, broken):
                problems.append(Problem(error.wrong, error.right, ("conditions", n)))


def _list(data: object, key: str, example: str, problems: list[Problem]) -> list[Any]:
    if data is None or (isinstance(data, list) and len(data) <= MANY):
        return data or []
    right = Message(N_("for example, %(example)s"), {"example": f'{key}: ["{example}"]'})
    problems.append(mistake(N_("a list in square brackets is expected here"), (key,), right))
    return []


def _closeness(value: object, problems: list[Problem]) -> float | None:
    if value is None:
        return None
    try:
        number = parse(value, "number")
        if 0 <= number < 1:
            return number
        text = N_("%(value)s is out of range: %(name)s from %(limits)s is expected")
        values = {"value": shown(value), "name": Message(N_("a plain number")), "limits": "0 … 1"}
        raise WrongValue(Message(text, values))
    except WrongValue as error:
        problems.append(Problem(error.wrong, error.right, ("least_closeness",)))
        return None


def _bounds(data: object, document: Document, problems: list[Problem]) -> Iterator[Bound]:
    """Limits of results; whether the template has such results is seen when it is solved."""
    stated: Mapping[str, object] = data if isinstance(data, dict) else {}
    if data is not None and not stated:
        problems.append(mistake(N_("keys with values are expected here"), ("require",)))
    for key, limits in stated.items():
        path = ("require", key)
        if isinstance(limits, list) and len(limits) == 2 and limits != [None, None]:
            yield Bound(key, limits[0], limits[1], document.places.get(path))
        else:
            right = for_example(f"{shown(key)}: [150 mm, 260 mm]")
            problems.append(mistake(N_("the least and the greatest value are expected here"), path, right))
