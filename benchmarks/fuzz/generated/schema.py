"""The schema of the format: its parts by short names, and what of it a variant uses."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from tmm_report.languages import LANGUAGES
from tmm_report.loading import schema

Mark = tuple[str, ...]
Schema = dict[str, Any]
TOP = "Variant"


@cache
def whole() -> Schema:
    return schema()


def part(name: str) -> Schema:
    """A part by its short name: ShuntModel, dynamics.Spring; `TOP`: the whole."""
    return whole() if name == TOP else whole()["$defs"][_long()[name]]


@cache
def short(ref: str) -> str:
    """Of a part's reference or long name; a name that several chapters use is headed by that of the chapter."""
    name = ref.rsplit("/", 1)[-1]
    found = re.fullmatch(
        r"tmm_report__chapters__(?:lever__|gears__|machine__)?(\w+?)__(?:block|given|ties)(?:__\w+?)?__(\w+?)",
        name,
    )
    return f"{found[1]}.{found[2]}" if found else name


@cache
def _long() -> dict[str, str]:
    return {short(name): name for name in whole()["$defs"]}


def branches(schema: Schema) -> list[Schema]:
    """The alternatives of a value; those of a number, bare or with its unit, are one."""
    found = schema.get("oneOf") or schema.get("anyOf") or []
    return [] if found and is_number(schema) else found


def by_language(schema: Schema) -> bool:
    """Whether a value is a text, or one of each language."""
    found = schema.get("anyOf", ())
    return len(found) == 2 and set(found[1].get("properties", ())) == set(LANGUAGES)


def is_number(schema: Schema) -> bool:
    kinds = schema.get("anyOf", ())
    return len(kinds) == 2 and kinds[0].get("type") == "number" and kinds[1].get("type") == "string"


# ---------------------------------------------------------------- what there is


@cache
def every() -> frozenset[Mark]:
    """A mark for every key of every part, every alternative and every enum value."""
    return frozenset(_every(TOP, whole(), set()))


def _every(where: str, schema: Schema, been: set[str]) -> Iterator[Mark]:
    if "$ref" in schema:
        name = short(schema["$ref"])
        if name not in been:
            been.add(name)
            yield from _every(name, part(name), been)
        return
    for value in schema.get("enum", ()):
        yield where, "=", str(value)
    for k, one in enumerate(branches(schema)):
        yield where, "|", str(k)
        yield from _every(where, one, been)
    for key, inner in schema.get("properties", {}).items():
        yield where, key
        yield from _every(f"{where}.{key}", inner, been)
    for inner in _inner(schema):
        yield from _every(where, inner, been)


def _inner(schema: Schema) -> Iterator[Schema]:
    """Of the items of lists and of mappings whose keys are names."""
    yield from schema.get("prefixItems", ())
    yield from (schema[key] for key in ("items", "additionalProperties") if isinstance(schema.get(key), dict))
    yield from schema.get("patternProperties", {}).values()


# ---------------------------------------------------------------- what data has


def used(data: Any, where: str = TOP, schema: Schema | None = None) -> Iterator[Mark]:
    """The marks of what a variant's data has."""
    schema = whole() if schema is None else schema
    if "$ref" in schema:
        yield from used(data, short(schema["$ref"]), part(short(schema["$ref"])))
        return
    if "enum" in schema and data in schema["enum"]:
        yield where, "=", str(data)
    for k, one in enumerate(branches(schema)):
        if _fits(data, one):
            yield where, "|", str(k)
            yield from used(data, where, one)
            break
    if isinstance(data, dict):
        keys = schema.get("properties", {})
        for key, inner in data.items():
            if key in keys:
                yield where, key
                yield from used(inner, f"{where}.{key}", keys[key])
            else:
                for one in _inner({k: v for k, v in schema.items() if k != "items"}):
                    yield from used(inner, where, one)
    elif isinstance(data, list):
        of = schema.get("prefixItems") or [schema.get("items") or {}] * len(data)
        for inner, one in zip(data, of, strict=False):
            yield from used(inner, where, one)


def _fits(data: Any, schema: Schema) -> bool:
    """Whether the data has the shape of this alternative."""
    if "$ref" in schema:
        schema = part(short(schema["$ref"]))
    if "enum" in schema:
        return data in schema["enum"]
    if "const" in schema:
        return data == schema["const"]
    if inner := branches(schema):
        return any(_fits(data, one) for one in inner)
    if isinstance(data, dict):
        keys, names = (
            schema.get("properties"),
            schema.get("patternProperties") or schema.get("additionalProperties"),
        )
        if set(schema) == {"required"}:  # which keys there must be, and no more
            return set(schema["required"]) <= set(data)
        if keys is None:
            return bool(names)
        constant = all(data.get(key) == one["const"] for key, one in keys.items() if "const" in one)
        return constant and set(data) <= set(keys) and set(schema.get("required", ())) <= set(data)
    if isinstance(data, list):
        if schema.get("type") != "array":
            return False
        of = schema.get("prefixItems") or [schema.get("items") or {}] * len(data)
        return len(of) == len(data) and all(_fits(one, inner) for one, inner in zip(data, of, strict=True))
    if isinstance(data, str) and "pattern" in schema and not re.search(schema["pattern"], data):
        return False
    kinds = schema.get("type", ["number", "string"])
    kind = "boolean" if isinstance(data, bool) else "string" if isinstance(data, str) else "number"
    return {"integer": "number"}.get(kinds, kinds) == kind if isinstance(kinds, str) else kind in kinds
