"""What the keys of the format mean, in a language: the descriptions of the JSON Schema, translated.

They stand in templates/locale/<language>/format.yaml, English -> translation; a language without that file has the
English.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

from tmm_report import yamlread
from tmm_report.quantity.text import unit_text
from tmm_report.resources import data_root

MEASURED = (
    "{name}: SI ({unit}) or text with a unit"  # how `values.quantity` describes what has no words of its own
)
_MEASURED = re.compile(r"(?P<name>.+): SI \((?P<unit>.+?)\) or text with a unit(?:; (?P<limits>.+))?")
_UNIT = re.compile(r"[A-Za-z]+(?:/[A-Za-z]+)?$")


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
