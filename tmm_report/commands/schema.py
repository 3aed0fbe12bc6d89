"""`tmm-report schema`: the format of a variant for editors."""

from __future__ import annotations

import json
from pathlib import Path

from tmm_report.commands.talk import Talk, unwritable, written
from tmm_report.loading import schema

DIALECT = "https://json-schema.org/draft/2020-12/schema"
BEGINS = f'{{\n  "$schema": "{DIALECT}"'


def text(language: str) -> str:
    """The JSON Schema, indented; its descriptions are in the language."""
    return json.dumps(schema(language), ensure_ascii=False, indent=2)


def run(output: Path, language: str, talk: Talk) -> bool:
    """Write it to a file. Raises ProblemError."""
    from tmm_report.commands.files import write

    try:
        write(output.parent, {output.name: f"{text(language)}\n".encode()})
    except OSError as error:
        raise unwritable(output.parent, error) from None
    talk.tell(written(output))
    return True
