"""The JSON Schema of the format, made from the models, for editors to complete and check a variant with.

What the keys mean in a language stands in templates/locale/<language>/format.yaml, English -> translation; a language
without that file has the English.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

from pydantic import create_model
from pydantic.json_schema import GenerateJsonSchema

from tmm_report import yamlread
from tmm_report.quantity.text import unit_text
from tmm_report.resources import data_root
from tmm_report.variant.model import Block

DIALECT = "https://json-schema.org/draft/2020-12/schema"

MEASURED = (
    "{name}: SI ({unit}) or text with a unit"  # how `values.quantity` describes what has no words of its own
)
_MEASURED = re.compile(r"(?P<name>.+): SI \((?P<unit>.+?)\) or text with a unit(?:; (?P<limits>.+))?")
_UNIT = re.compile(r"[A-Za-z]+(?:/[A-Za-z]+)?$")


class _Schema(GenerateJsonSchema):
    """Without `null`: an empty key is a mistake, what is absent is left out."""

    def nullable_schema(self, schema: Any) -> Any:
        return self.generate_inner(schema["schema"])

    def default_schema(self, schema: Any) -> Any:
        made = super().default_schema(schema)
        return {key: value for key, value in made.items() if key != "default" or value not in (None, {}, [])}

    def dict_schema(self, schema: Any) -> Any:
        made = super().dict_schema(schema)
        return {**made, "additionalProperties": False} if "patternProperties" in made else made

    def model_schema(self, schema: Any) -> Any:
        made = super().model_schema(schema)
        return {**made, "title": schema["cls"].__name__.removesuffix("Model")}


def schema_of(blocks: Iterable[type[Block]], about: str) -> dict[str, Any]:
    """Draft 2020-12, keys as they are written in the file; `about`: what a variant is, in a sentence."""
    model = create_model("VariantModel", __base__=tuple(reversed([*blocks])), __doc__=about)
    return {"$schema": DIALECT, **model.model_json_schema(by_alias=True, schema_generator=_Schema)}


@cache
def meanings(language: str) -> Mapping[str, str]:
    """English description -> what it is in the language; empty where there is no such file."""
    file = data_root() / "templates" / "locale" / language / "format.yaml"
    found: Mapping[str, str] = yamlread.loads(file.read_bytes(), file.name).data if file.is_file() else {}
    return found


def meaning(text: str, language: str) -> str:
    """A description of the schema in a language, as it is where that has no word for it."""
    known, text = meanings(language), " ".join(text.split())
    if text in known or not known or (match := _MEASURED.fullmatch(text)) is None:
        return known.get(text, text)
    unit = unit_text(match["unit"], language)
    said = known[MEASURED].format(name=known[match["name"]], unit=unit)
    return f"{said}; {limits(match['limits'], language)}" if match["limits"] else said


def limits(text: str, language: str) -> str:
    """A range with its unit, "0 … 5 mm"."""
    known = meanings(language)
    return known.get(text) or (
        _UNIT.sub(lambda found: unit_text(found[0], language), text) if known else text
    )


def translated(node: Any, language: str) -> Any:
    """A schema whose descriptions are in the language."""
    if isinstance(node, list):
        return [translated(one, language) for one in node]
    if not isinstance(node, dict):
        return node
    return {
        key: meaning(one, language)
        if key == "description" and isinstance(one, str)
        else translated(one, language)
        for key, one in node.items()
    }
