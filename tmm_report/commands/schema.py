"""`tmm-report schema`: the format of a variant for editors."""

from __future__ import annotations

import json

from tmm_report.loading import schema


def text() -> str:
    """The JSON Schema, indented."""
    return json.dumps(schema(), ensure_ascii=False, indent=2)
