"""The tool of the translations as the tests use it: the program and its templates are read for texts once a run."""

from __future__ import annotations

import re
import runpy
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from once import once

LATIN_UNIT = re.compile(
    r"(?:[0-9⁶]|\)s) (?:[mkM]?[mgNWJ]|M?Pa|Hz|deg|rad|rpm|s|min|h)(?![a-z_:(])"
)  # behind a number
TOOLS = Path(__file__).resolve().parent.parent / "tools"


@once
def texts() -> tuple[Any, ...]:
    return runpy.run_path(str(TOOLS / "wording" / "texts.py"))["extracted"]()


@cache
def messages() -> dict[str, Any]:
    """Names of tools/messages.py."""
    pytest.importorskip("babel")
    sys.path.insert(0, str(TOOLS))
    tool = runpy.run_path(str(TOOLS / "messages.py"))
    tool["merged"].__globals__["extracted"] = tool["extracted"] = texts
    return tool
