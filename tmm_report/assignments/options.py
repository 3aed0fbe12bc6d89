"""One parameter of the ranges file: where it stands in the template, and what may be drawn for it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

from tmm_report.assignments.keys import path_of, value_at
from tmm_report.assignments.model import Parameter, Template
from tmm_report.assignments.numbers import Cell, Written, dimension_of, written
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.quantity.text import for_example
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.variant.errors import near
from tmm_report.yamlread import Path

MANY = 10_000  # values of one parameter
PLACES = 40  # of one parameter in the template
NAME = r"[^\W\d_][\w'’]{0,19}"
RESERVED = ("id", "student", "group", "variant")  # other columns of the table

OWN = tuple(("title", key) for key in RESERVED)

_FORMS = {  # what says a parameter's values -> the keys that go with it
    "from": ("from", "to", "step"),
    "choose": ("choose",),
    "scale": ("scale",),
    "of": ("of", "times", "step"),
}


def parameter(
    name: str,
    stated: object,
    template: Template,
    before: Mapping[str, Parameter],
    path: Path,
    raw: Mapping[Path, str],
) -> Parameter:
    """The parameter stated at a path of the ranges file. `before`: those above it. Raises ProblemError."""
    if not isinstance(stated, dict):
        right = for_example("{key: …, from: 80 mm, to: 120 mm, step: 5 mm}")
        raise ProblemError([mistake(N_("keys with values are expected here"), path, right)])
    problems, paths = [*_named(name, path), *_known(stated, path)], tuple[Path, ...]()
    try:
        paths = _paths(stated, template, path)
    except ProblemError as error:
        problems += error.problems
    if problems:
        raise ProblemError(problems)
    return _FOUND[_form(stated)](_Stated(name, stated, template, before, path, raw, paths))


def _named(name: str, path: Path) -> Iterator[Problem]:
    if not re.fullmatch(NAME, name) or name.lower() in RESERVED:
        right = Message(
            N_("a letter, then letters, digits and ', at most 20; not %(words)s"),
            {"words": ", ".join(RESERVED)},
        )
        yield mistake(N_("%(value)s is not a name"), path, right, value=shown(name))


def _form(stated: Mapping[str, Any]) -> str:
    return next((form for form in _FORMS if form in stated), "")


def _known(stated: Mapping[str, Any], path: Path) -> Iterator[Problem]:
    """What is wrong of its keys alone."""
    form = _form(stated)
    if not form:
        right = Message(N_("one of: %(words)s"), {"words": "from … to … step, choose, scale, of … times"})
        yield mistake(N_("nothing says which values it takes"), path, right)
        return
    allowed = ("key", "keys", *_FORMS[form])
    for key in stated:
        if key not in allowed:
            near_by = near(key, allowed)
            yield mistake(N_("unknown key %(key)s"), (*path, key), near_by, key=shown(key))
    for key in _FORMS[form]:
        if stated.get(key) is None and not (form == "of" and key == "step"):
            yield mistake(N_("the key %(key)s is missing"), path, key=key)


def _paths(stated: Mapping[str, Any], template: Template, path: Path) -> tuple[Path, ...]:
    """Where it stands in the template. Raises ProblemError."""
    given = stated.get("keys", [stated["key"]] if "key" in stated else [])
    if ("key" in stated) == ("keys" in stated) or not isinstance(given, list) or not 0 < len(given) <= PLACES:
        right = Message(N_("for example, %(example)s"), {"example": "key: mechanism.links.1.points.A"})
        raise ProblemError([mistake(N_("one key, or a list of keys, is expected here"), path, right)])
    found, problems = [], list[Problem]()
    for n, dotted in enumerate(given):
        here = (*path, "key") if "key" in stated else (*path, "keys", n)
        try:
            found.append(path_of(dotted if isinstance(dotted, str) else "", template.data))
            if found[-1] in OWN:
                text = N_("%(key)s is each student's own already")
                problems.append(mistake(text, here, key=shown(dotted)))
        except ProblemError as error:
            problems += [replace(problem, path=here) for problem in error.problems]
    if problems:
        raise ProblemError(problems)
    return tuple(dict.fromkeys(found))


# ---------------------------------------------------------------- its values


@dataclass(frozen=True, eq=False)
class _Stated:
    """A parameter as it is written, its keys known and its places found."""

    name: str
    stated: Mapping[str, Any]
    template: Template
    before: Mapping[str, Parameter]
    path: Path
    raw: Mapping[Path, str]
    paths: tuple[Path, ...]

    def number(self, *keys: str | int, dimension: str | None = None) -> Written:
        """A number with its unit. Raises ProblemError with its place."""
        here, value = (*self.path, *keys), self.stated
        for key in keys:
            value = value[key]  # type: ignore[index]
        plain = isinstance(value, int | float) and not isinstance(value, bool)
        try:
            return written(Decimal(self.raw.get(here, repr(value))) if plain else value, dimension)
        except WrongValue as error:
            raise ProblemError([Problem(error.wrong, error.right, here)]) from None

    def dimension(self) -> str | None:
        """What the template's value measures; None where it has no unit. Raises ProblemError where it is no number."""
        units = set()
        for path in self.paths:
            try:
                units.add(written(self.template.written(path)).unit)
            except WrongValue:
                text = N_("%(key)s of the template is not a number")
                raise self.wrong(text, key=shown(".".join(map(str, path)), 120)) from None
        return next((name for unit in sorted(units) if (name := dimension_of(unit))), None)

    def single(self) -> None:
        """Raises ProblemError where the template has a list or keys in its place."""
        for path in self.paths:
            if isinstance(value_at(self.template.data, path), dict | list):
                text = N_("%(key)s of the template is not a single value")
                raise self.wrong(text, key=shown(".".join(map(str, path)), 120))

    def wrong(self, text: str, *keys: str | int, right: Message | None = None, **values: Any) -> ProblemError:
        return ProblemError([mistake(text, (*self.path, *keys), right, **values)])


def _steps(stated: _Stated) -> Parameter:
    """Values from one to another by equal steps."""
    dimension, problems = stated.dimension(), list[Problem]()
    numbers = []
    for key in _FORMS["from"]:
        try:
            numbers.append(stated.number(key, dimension=dimension))
        except ProblemError as error:
            problems += error.problems
    if problems:
        raise ProblemError(problems)
    low, high, step = numbers
    _ordered(stated, low, high, step)
    count = int(min((high.number - low.number) / step.number, Decimal(MANY))) + 1
    if count > MANY:
        raise stated.wrong(N_("these are more than %(most)s values"), "step", most=MANY)
    options = tuple(low.number + n * step.number for n in range(count))
    return Parameter(stated.name, stated.paths, low.unit, options)


def _ordered(stated: _Stated, low: Written, high: Written, step: Written) -> None:
    """Raises ProblemError where a range has two units, no step forward or no end after its beginning."""
    for key, number in (("to", high), ("step", step)):
        if number.unit != low.unit:
            right = Message(N_("write it in %(unit)s"), {"unit": shown(low.unit)}) if low.unit else None
            raise stated.wrong(N_("the unit is another than that of from"), key, right=right)
    if step.number <= 0:
        raise stated.wrong(N_("the step must be greater than zero"), "step")
    if high.number < low.number:
        raise stated.wrong(N_("it ends before it begins"), "to")


def _choice(stated: _Stated) -> Parameter:
    """One of a list: numbers of one unit, or whatever is written."""
    items = _items(stated, "choose")
    if any(isinstance(item, dict | list) or item is None for item in items):
        raise stated.wrong(N_("single values are expected here"), "choose")
    stated.single()
    numbers = [_number(stated, "choose", n) for n in range(len(items))]
    units = {number.unit for number in numbers if number}
    if all(numbers) and len(units) == 1:
        dimension = stated.dimension()
        for n in range(len(items)):
            stated.number("choose", n, dimension=dimension)
        return Parameter(
            stated.name,
            stated.paths,
            units.pop(),
            _different(stated, "choose", [n.number for n in numbers if n]),
        )
    words = [stated.raw.get((*stated.path, "choose", n), str(item)) for n, item in enumerate(items)]
    return Parameter(stated.name, stated.paths, "", _different(stated, "choose", words))


def _number(stated: _Stated, *keys: str | int) -> Written | None:
    try:
        return stated.number(*keys)
    except ProblemError:
        return None


def _items(stated: _Stated, key: str) -> list[Any]:
    items = stated.stated[key]
    if not isinstance(items, list) or not 0 < len(items) <= MANY:
        raise stated.wrong(N_("a list in square brackets is expected here"), key)
    return items


def _different(stated: _Stated, key: str, cells: list[Any]) -> tuple[Cell, ...]:
    for n, cell in enumerate(cells if len(set(cells)) < len(cells) else ()):
        if cell in cells[:n]:
            raise stated.wrong(N_("%(value)s stands in the list twice"), key, n, value=shown(cell))
    return tuple(cells)


def _factors(stated: _Stated) -> Parameter:
    """What the template has there, multiplied."""
    numbers = [stated.number("scale", n, dimension="number") for n in range(len(_items(stated, "scale")))]
    options = _different(stated, "scale", [number.number for number in numbers])
    found = Parameter(stated.name, stated.paths, "", options, scales=True)
    try:
        found.texts(Decimal(1), stated.template)
    except WrongValue as error:
        right = Message(N_("name a number, a list of numbers or a list of pairs"))
        raise ProblemError([Problem(error.wrong, right, (*stated.path, "scale"))]) from None
    return found


def _following(stated: _Stated) -> Parameter:
    """So many times another parameter, in its unit."""
    base = stated.before.get(str(stated.stated["of"]))
    if base is None or base.scales or not base.numeric:
        known = [name for name, one in stated.before.items() if one.numeric and not one.scales]
        right = near(str(stated.stated["of"]), known)
        raise stated.wrong(N_("no parameter of numbers above this one has this name"), "of", right=right)
    times = stated.number("times", dimension="number").number
    step = stated.number("step", dimension=dimension_of(base.unit)) if "step" in stated.stated else None
    if step and (step.number <= 0 or step.unit != base.unit):
        right = Message(N_("write it in %(unit)s"), {"unit": shown(base.unit)}) if base.unit else None
        raise stated.wrong(N_("the step must be greater than zero"), "step", right=right)
    stated.dimension()
    return Parameter(
        stated.name, stated.paths, base.unit, of=base.name, times=times, step=step.number if step else None
    )


_FOUND: Mapping[str, Callable[[_Stated], Parameter]] = {
    "from": _steps,
    "choose": _choice,
    "scale": _factors,
    "of": _following,
}
