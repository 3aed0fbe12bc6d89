"""The reference of a variant's format, made from the JSON Schema: every key with its meaning, unit, default, example.

A page for each block at the top of a file; of each map of keys a table. A map that stands in several places is told
where it is met first, and the others refer to it. Examples are what the ready variants have there, else the schema's.
"""

from __future__ import annotations

import html
import json
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from tmm_report.languages import LANGUAGES
from tmm_report.quantity.units import WrongValue, between

Schema = Mapping[str, Any]
Say = Callable[[str], str]
ANY, ITEM = "<name>", "[]"  # steps of a path: any name, any item of a list
LONGEST = 90  # letters of an example in a cell
WHOLE, FLAG = "whole number", "true or false"  # among the words of a page


@dataclass(frozen=True)
class Words:
    """What a page says in its language; `meaning` translates the descriptions of the schema, `called` are the words
    that stand for an English key."""

    head: tuple[str, ...]
    one_of: str
    list_of: str
    required: str
    see: str
    also: str
    title: str
    about: str
    language: str = "en"
    name: str = "<name>"
    meaning: Say = str
    limits: Say = str
    unit: Say = str
    called: Say = lambda key: ""


ENGLISH = Words(
    head=("key", "what it is", "unit", "default", "example"),
    one_of="one of",
    list_of="a list",
    required="*required*",
    see="see",
    also="The same keys stand in",
    title="Every key of the format",
    about="Made from the schema that `tmm-report schema` prints. A number without a unit is in the unit of the column, "
    "which is SI; a text with any other unit of the same kind is converted ([how](../variant.md)). What stands "
    "*in italics* under “default” is not a value; “—” there says that the key may be left out. `<name>` stands for a "
    "name that you give.",
)


@dataclass
class Table:
    """A map of keys: where it stands first, and where else."""

    name: str
    path: tuple[str, ...]
    keys: Schema
    required: frozenset[str]
    about: str
    also: list[tuple[str, ...]] = field(default_factory=list)

    @property
    def page(self) -> str:
        return self.path[0] if self.path else "index"

    @property
    def anchor(self) -> str:
        return re.sub(r"[^a-z0-9]+", "-", self.name.removeprefix("tmm_report__chapters__").lower()).strip("-")

    def holds(self, data: Mapping[str, Any]) -> bool:
        """Whether a map of a variant is one of this kind."""
        fixed = {key: node["const"] for key, node in self.keys.items() if "const" in node}
        return data.keys() <= self.keys.keys() and all(
            data.get(key, word) == word for key, word in fixed.items()
        )

    @property
    def link(self) -> str:
        return f"{self.page}.md#{self.anchor}"


def written(path: tuple[str, ...], name: str = ANY) -> str:
    """As a path is told: `mechanism.links.<name>.points`, `cam.phases[]`."""
    return ".".join(path).replace(f".{ITEM}", ITEM).replace(ANY, name)


class Reference:
    """All tables of a schema, in the order in which a file has them. `ready`: variants as data, for examples."""

    def __init__(self, schema: Schema, ready: Mapping[str, Any], words: Words = ENGLISH):
        self.schema, self.words = schema, words
        self.ready = {name: _said(data, words.language) for name, data in ready.items()}
        self.tables: dict[str, Table] = {}
        for key, node in schema["properties"].items():
            self._walk(node, (key,))

    def rows(self) -> Iterator[tuple[tuple[str, ...], str]]:
        """Path and Markdown of every key: what a test looks through."""
        for key, node in self.schema["properties"].items():
            yield (key,), self._row(key, node, (key,))
        for table in self.tables.values():
            for key, node in table.keys.items():
                path = (*table.path, key)
                yield path, self._row(key, node, path, table)

    def pages(self) -> dict[str, str]:
        """File name -> Markdown."""
        lines = {"index": [f"# {self.words.title}", "", self.words.about, "", *self._head()]}
        for key, node in self.schema["properties"].items():
            page = f"{key}.md" if any(one.page == key for one in self.tables.values()) else ""
            lines["index"].append(self._row(key, node, (key,), link=page))
        for table in self.tables.values():
            at = lines.setdefault(table.page, [f"# `{table.page}`"])
            at += ["", f"## `{self._told(table.path)}` {{ #{table.anchor} }}", ""]
            at += [self.words.meaning(table.about), ""] if table.about else []
            at += (
                [f"{self.words.also} {', '.join(f'`{self._told(one)}`' for one in table.also)}.", ""]
                if table.also
                else []
            )
            at += self._head()
            for key, node in table.keys.items():
                at.append(self._row(key, node, (*table.path, key), table))
        return {f"{name}.md": "\n".join([*rows, ""]) for name, rows in lines.items()}

    def _told(self, path: tuple[str, ...]) -> str:
        return written(path, self.words.name)

    # --- the tree of the schema

    def _walk(self, node: Schema, path: tuple[str, ...]) -> None:
        """All maps that may stand at a place before those within them."""
        new = []
        for name, one, at in self._maps(node, path):
            known = self.tables.get(name)
            if known is None:
                required = frozenset(one.get("required", ()))
                self.tables[name] = Table(name, at, one["properties"], required, one.get("description", ""))
                new.append(self.tables[name])
            elif at != known.path and at not in known.also and not _within(at, known.path):
                known.also.append(at)
        for table in new:
            for key, inner in table.keys.items():
                self._walk(inner, (*table.path, key))

    def _maps(self, node: Schema, path: tuple[str, ...]) -> Iterator[tuple[str, Schema, tuple[str, ...]]]:
        """The maps of keys that may stand at a place, each with its name; a text by languages is none."""
        if "$ref" in node:
            name = node["$ref"].rpartition("/")[2]
            yield name, self.schema["$defs"][name], path
            return
        for one in (*node.get("anyOf", ()), *node.get("oneOf", ())):
            yield from self._maps(one, path)
        items = node.get("items")
        for one in (*((items,) if items else ()), *node.get("prefixItems", ())):
            yield from self._maps(one, (*path, ITEM))
        for one in _named(node):
            yield from self._maps(one, (*path, ANY))

    # --- a row

    def _head(self) -> list[str]:
        head = self.words.head
        return [f"| {' | '.join(head)} |", f"|{'---|' * len(head)}"]

    def _row(
        self, key: str, node: Schema, path: tuple[str, ...], table: Table | None = None, link: str = ""
    ) -> str:
        called = self.words.called(key)
        name = f"[`{key}`]({link})" if link else f"`{key}`"
        cells = [
            f"{name}{f' ({called})' if called else ''}",
            self._meaning(node, path),
            self._units(node),
            self.words.required if table and key in table.required else self._default(node),
            self._example(node, path, table),
        ]
        return f"| {' | '.join(cell.replace('|', '&#124;') for cell in cells)} |"

    def _meaning(self, node: Schema, path: tuple[str, ...]) -> str:
        said = _plain(self.words.meaning(text)).removesuffix(".") if (text := self._described(node)) else ""
        extra = []
        if words := list(dict.fromkeys(self._choices(node))):
            extra.append(
                f"{self.words.one_of} {', '.join(f'`{word}`' for word in words)}"
                if len(words) > 1
                else f"`{words[0]}`"
            )
        if limits := self._range(node):
            extra.append(self.words.limits(limits))
        if node.get("type") == "array" and "items" in node:
            extra.append(self.words.list_of)
        inner = dict.fromkeys(name for name, _, _ in self._maps(node, path))
        links = [
            f"[`{self._told(table.path)}`]({table.link})" for name in inner if (table := self.tables[name])
        ]
        extra += [f"{self.words.see} {', '.join(dict.fromkeys(links))}"] if links else []
        return "; ".join([part for part in (said, *extra) if part])

    def _described(self, node: Schema) -> str:
        if text := node.get("description"):
            return " ".join(str(text).split())
        if "$ref" in node:
            return self._described(self.schema["$defs"][node["$ref"].rpartition("/")[2]])
        parts = (
            node.get("items"),
            *node.get("oneOf", ()),
            *node.get("anyOf", ()),
            *_named(node),
        )
        return next((text for one in parts if one and (text := self._described(one))), "")

    def _choices(self, node: Schema) -> Iterator[str]:
        yield from map(_literal, node.get("enum", ()))
        if "const" in node:
            yield _literal(node["const"])
        if node.get("type") == "boolean":
            yield from ("true", "false")
        for one in (*node.get("anyOf", ()), *node.get("oneOf", ())):
            yield from self._choices(one)
        if isinstance(items := node.get("items"), Mapping):
            yield from self._choices(items)

    def _range(self, node: Schema) -> str:
        if "minimum" in node or "maximum" in node:
            return f"{node.get('minimum', '…')} … {node.get('maximum', '…')}"
        found = node.get("x-range") or next(
            (text for one in self._alternatives(node) if (text := self._range(one))), ""
        )
        return "" if found and found in self._described(node) else str(found)

    def _alternatives(self, node: Schema) -> tuple[Schema, ...]:
        items = node.get("items")
        return (*node.get("anyOf", ()), *node.get("oneOf", ()), *((items,) if items else ()))

    def _units(self, node: Schema) -> str:
        """Of a number its unit, of a list of pairs those of both."""
        found = dict.fromkeys(self._unit_names(node))
        return ", ".join(self.words.unit(name) for name in found if name != "1") or (
            "1" if "1" in found else ""
        )

    def _unit_names(self, node: Schema) -> Iterator[str]:
        if unit := node.get("x-unit"):
            yield from unit.split(", ")
            return
        for one in (
            *self._alternatives(node),
            *node.get("prefixItems", ()),
            *_named(node),
        ):
            yield from self._unit_names(one)

    def _default(self, node: Schema) -> str:
        return f"`{_literal(node['default'])}`" if node.get("default") not in (None, "") else "—"

    def _example(self, node: Schema, path: tuple[str, ...], table: Table | None = None) -> str:
        found = (one for one in self._used(path, table) if one not in (0, "0", ""))
        used = next((one for one in found if self._fits(one, node)), None)
        if used is not None and not isinstance(used, dict | list):
            return f"`{_cut(_literal(used))}`"
        for one in node.get("examples", ()):
            return f"`{_cut(_literal(one))}`"
        if used is not None:
            return f"`{_cut(_literal(used))}`"
        if node.get("type") == "array":
            return self._made(node)
        if node.get("type") == "object" and (inner := _named(node)):
            return f"`{{1: {self._example(inner[0], ()).strip('`')}}}`"
        for one in (
            node,
            *self._alternatives(node),
            *_named(node),
            *node.get("prefixItems", ()),
        ):
            if examples := one.get("examples"):
                return f"`{_cut(_literal(examples[0]))}`"
        if words := list(self._choices(node)):
            return f"`{words[0]}`"
        return self._made(node)

    def _used(self, path: tuple[str, ...], table: Table | None) -> Iterator[Any]:
        """What ready variants have at a place, in a map of the table's kind."""
        for data in self.ready.values() if path else ():
            for around in _at(data, path[:-1]):
                if isinstance(around, dict) and (table is None or table.holds(around)):
                    yield from _at(around, path[-1:])

    def _fits(self, value: Any, node: Schema) -> bool:
        """Whether a number with a unit is in one of the node's: a force in place of a pressure is not."""
        asked = [name for name in self._unit_names(node) if name != "1"]
        if (
            not asked
            or not isinstance(value, str)
            or (found := re.fullmatch(r"[-−\d.,]+ ([^ ]+)", value)) is None
        ):
            return True
        return any(_measures(found[1], name) for name in asked)

    def _made(self, node: Schema) -> str:
        """Of a whole number its least, of a text dots, of a map its keys."""
        if node.get("type") == "integer":
            return f"`{node.get('default', node.get('minimum', 1))}`"
        if node.get("type") == "array":
            items = node.get("prefixItems") or (node["items"],) * max(1, node.get("minItems", 1))
            return f"`[{', '.join(self._example(one, ()).strip('`') for one in items)}]`"
        keys = [
            name
            for _, one, _ in self._maps(node, ())
            for name in one.get("required", ()) or list(one["properties"])[:2]
        ]
        return f"`{{{', '.join(f'{key}: …' for key in dict.fromkeys(keys))}}}`" if keys else "`…`"


def _said(value: Any, language: str) -> Any:
    """What a variant states, with a text by languages in one of them."""
    if isinstance(value, list):
        return [_said(one, language) for one in value]
    if not isinstance(value, dict):
        return value
    return (
        value[language]
        if {*value} == {*LANGUAGES}
        else {key: _said(one, language) for key, one in value.items()}
    )


def _measures(given: str, wanted: str) -> bool:
    try:
        return between(given, wanted) > 0
    except WrongValue:
        return False


def _named(node: Schema) -> tuple[Schema, ...]:
    """What stands under names of one's own."""
    other = node.get("additionalProperties")
    return (*node.get("patternProperties", {}).values(), *((other,) if isinstance(other, dict) else ()))


def _within(path: tuple[str, ...], other: tuple[str, ...]) -> bool:
    """Whether a place is in a map of keys that may hold itself."""
    return len(path) > len(other) and path[: len(other)] == other


def _at(data: Any, path: tuple[str, ...]) -> Iterator[Any]:
    if not path:
        yield data
        return
    step, *rest = path
    inner: list[Any] = []
    if step == ANY and isinstance(data, dict):
        inner = list(data.values())
    elif step == ITEM and isinstance(data, list):
        inner = data
    elif isinstance(data, dict) and step in data:
        inner = [data[step]]
    for one in inner:
        yield from _at(one, tuple(rest))


def _literal(value: Any) -> str:
    """As it is written in YAML on one line."""
    match value:
        case bool():
            return str(value).lower()
        case dict():
            return f"{{{', '.join(f'{key}: {_literal(one)}' for key, one in value.items())}}}"
        case list() | tuple():
            return f"[{', '.join(map(_literal, value))}]"
        case float():
            return f"{value:.6g}"
        case str() if re.search(r"[,{}\[\]#:]", value) and not value.startswith(("[", "{")):
            return json.dumps(value, ensure_ascii=False)
    return str(value)


def _cut(text: str) -> str:
    text = " ".join(text.replace("`", "'").split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"


def _plain(text: str) -> str:
    """A description as Markdown: nothing of it is markup."""
    return re.sub(
        r"([*_\[\]<>{}\\])",
        lambda found: html.escape(found[1]) if found[1] in "<>" else f"\\{found[1]}",
        text,
    )
