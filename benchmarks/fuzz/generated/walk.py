"""Data drawn from the schema: keys there or not, alternatives and enum values by chance, names that the variant has."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from random import Random
from typing import Any

from benchmarks.fuzz.generated.after import AFTER
from benchmarks.fuzz.generated.numbers import SIZES
from benchmarks.fuzz.generated.rules import APART, NAMED, NEEDS, ONE, RARE, SETS, SIZED
from benchmarks.fuzz.generated.schema import Schema, branches, by_language, is_number, part, short, whole

DEEP = 4
BARE = {
    "mm": 1e-3,
    "deg": math.pi / 180,
    "rpm": math.pi / 30,
    "N": 1,
    "N*m": 1,
    "kg": 1,
    "kg*m^2": 1,
    "kN": 1e3,
}
WORDS = ("main", "ротор", "A & B", "50 %", "x_1", "«сито»", "a<b", "1")


@dataclass
class Names:
    """What the variant's mechanism has, by what a key may name: points, links, guides, …"""

    of: dict[str, Sequence[str]] = field(default_factory=dict)
    axes: dict[str, Sequence[str]] = field(default_factory=dict)  # extremes of the points of sliders
    positions: int = 12
    turns: int = 1
    partial: bool = False

    @property
    def mechanism(self) -> bool:
        return bool(self.of)


class Walk:
    """`fullness`: which part of the optional keys is there; `wild`: how often a rule is broken or a number is odd."""

    def __init__(self, random: Random, names: Names, fullness: float, wild: float):
        self.random, self.names, self.fullness, self.wild = random, names, fullness, wild
        self._deep = 0

    def tame(self) -> bool:
        return self.random.random() >= self.wild

    def part(self, name: str) -> Any:
        """A part of the schema by its short name."""
        return self._made(name, part(name))

    def key(self, name: str) -> Any:
        """The value of a key at the top of a variant."""
        return self.value(whole()["properties"][name], f"Variant.{name}")

    # ------------------------------------------------------------ values

    def value(self, schema: Schema, where: str) -> Any:
        if "$ref" in schema:
            name = short(schema["$ref"])
            return self._made(name, part(name))
        if "const" in schema:
            return schema["const"]
        if is_number(schema):
            return self.number(schema, where)
        if "enum" in schema:
            return self.random.choice(schema["enum"])
        if by_language(schema):
            return self._called(schema, where)
        if alternatives := branches(schema):
            if "const" in alternatives[-1]:
                odd = self.random.random() < 0.05
                return alternatives[-1]["const"] if odd else self.number(schema, where)
            texts = {str(one.get("type")) for one in alternatives} <= {"number", "string"}
            if texts:
                return self._text(schema, where)
            # the first of what nests in itself does not
            return self.value(
                alternatives[0] if self._deep > DEEP else self.random.choice(alternatives), where
            )
        kind = schema.get("type")
        if kind == "boolean":
            return self.random.random() < 0.5
        if kind == "integer":
            return self._whole(schema, where)
        if kind == "array":
            return self._list(schema, where)
        if kind == "object":
            return self._mapping(schema, where)
        return self._text(schema, where)

    def number(self, schema: Schema, where: str) -> Any:
        """A number with its unit: of the size that is usual there, else about that of the schema's example."""
        if not self.tame() and self.random.random() < 0.2:
            return self.random.choice((0, -1, 1e-9, 1e6, "0 deg", "-5 mm", "1e3 N"))
        if where in SIZES:
            low, high, unit = SIZES[where]
            return self._united(self.random.uniform(low, high), unit)
        example = str((schema.get("examples") or ["1"])[0])
        number, _, unit = example.partition(" ")
        if not re.fullmatch(r"[-+.\deE]+", number):
            return schema["examples"][0]
        return self._united(float(number) * 10 ** self.random.uniform(-0.3, 0.3), unit)

    def _united(self, number: float, unit: str) -> Any:
        shown = float(f"{number:.{self.random.choice((2, 3, 6))}g}")
        shown = int(shown) if shown == int(shown) else shown
        if unit in BARE and self.random.random() < 0.1:
            return float(f"{shown * BARE[unit]:.6g}")
        return f"{shown} {unit}" if unit else shown

    def _whole(self, schema: Schema, where: str) -> int:
        low, high = schema.get("minimum", 1), schema.get("maximum", 10)
        if where in SIZES:
            low, high = map(int, SIZES[where][:2])
        return self.random.randint(low, min(high, low + 12) if where not in SIZES else high)

    def _list(self, schema: Schema, where: str) -> list[Any]:
        if of := schema.get("prefixItems"):
            return [self.value(one, where) for one in of]
        low, high = schema.get("minItems", 0), schema.get("maxItems", 5)
        low, high = SIZED.get(where, (max(low, 1), min(high, max(low, 1) + 2)))
        item, count = schema["items"], self.random.randint(low, high)
        if "enum" in item:
            return self.random.sample(item["enum"], min(count, len(item["enum"])))
        found = [self.value(item, where) for _ in range(count)]
        return self._curve(found, where) if self.tame() else found

    def _curve(self, pairs: list[Any], where: str) -> list[Any]:
        """Pairs in ascending order."""
        if all(isinstance(one, list) and len(one) == 2 for one in pairs):
            return sorted(pairs, key=lambda pair: float(str(pair[0]).split(" ")[0]))
        return pairs

    def _mapping(self, schema: Schema, where: str) -> dict[str, Any]:
        inner = (
            next(iter(schema.get("patternProperties", {}).values()), None) or schema["additionalProperties"]
        )
        known = NAMED.get(where) or self._known(where.rsplit(".", 1)[-1]) or ["A", "B2", "Ж"]
        keys = self.random.sample(list(known), min(len(known), self.random.randint(1, 2)))
        return {key: self.value(inner, where) for key in keys}

    def _text(self, schema: Schema, where: str) -> Any:
        if where in NAMED:
            return self.random.choice(NAMED[where])
        key = where.rsplit(".", 1)[-1]
        if "pattern" in schema and (known := self._known(key)):
            return self.random.choice(list(known))
        if examples := schema.get("examples"):
            return self.random.choice(examples)
        return self.random.choice(WORDS)

    def _called(self, schema: Schema, where: str) -> Any:
        """A text, or one by languages; chance beside that of the rest, which a name does not change."""
        text, beside = self._text(schema, where), Random(f"{where} {self.random.getstate()[1][:2]}")
        languages = list(branches(schema)[1]["properties"])
        if beside.random() < 0.5:
            return text
        return dict.fromkeys(beside.sample(languages, beside.randint(1, len(languages))), text)

    def _known(self, key: str) -> Sequence[str]:
        return self.names.of.get(key, ())

    # ------------------------------------------------------------ parts

    def _made(self, name: str, schema: Schema) -> Any:
        if branches(schema) and "properties" not in schema:
            return self.value(schema, name)
        self._deep += 1
        made = {key: self.value(inner, f"{name}.{key}") for key, inner in self._chosen(name, schema).items()}
        self._deep -= 1
        if name in AFTER and self.tame():
            made = AFTER[name](made, self)
        return made

    def _chosen(self, name: str, schema: Schema) -> Mapping[str, Schema]:
        """The keys that are there."""
        every, needed = schema["properties"], set(schema.get("required", ()))
        there = {key for key in every if key in needed or self.random.random() < self._share(f"{name}.{key}")}
        if self.tame():
            for keys in ONE.get(name, ()):
                there = there - set(keys) | {self.random.choice(keys)}
            if name in SETS:
                sets, free = SETS[name], set(every) - {key for keys in SETS[name] for key in keys}
                there = there & free | set(self.random.choice(sets))
            for first, others in APART.get(name, ()):
                if first in there:
                    there -= set(others)
            for first, others in NEEDS.get(name, ()):
                if first in there:
                    there |= set(others)
        return {key: every[key] for key in every if key in there}

    def _share(self, where: str) -> float:
        return self.fullness * RARE.get(where, 1.0)
