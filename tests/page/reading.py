"""Notes and results of the ready variants as the tests of the page read them, once a run.

PAGE_VARIANTS="compressor press" in the environment looks at these variants alone.
"""

from __future__ import annotations

import json
import os
from functools import cache
from typing import Any

from conftest import FILES, STATEMENTS
from conftest import LEVERS as MECHANISMS
from conftest import read as variant
from exhaustive import many
from note import Note, read
from notes import NAMES, drawn, note

from tmm_report.figures.drawing import Drawing

READ = [*NAMES, *(path.stem for path in STATEMENTS)]
CHOSEN = [name for name in READ if name in os.environ.get("PAGE_VARIANTS", " ".join(READ)).split()]
ENGLISH = [name for name in ("compressor", "press", "hoist_drive", "eccentric") if name in CHOSEN]
LEVERS = [path.stem for path in (*MECHANISMS, *STATEMENTS) if path.stem in CHOSEN]
LINKAGES = [path.stem for path in (*FILES, *STATEMENTS) if path.stem in CHOSEN]
"""Those of links of constant lengths: a link that replaces a cam pair is another one in every position."""


def in_both(names: list[str]) -> list[Any]:
    """Parameters of a test: variants in their own language, and those that are read in English, too."""
    return [(name, "") for name in names] + many([(name, "en") for name in ENGLISH if name in names])


BOTH = in_both(CHOSEN)


def language(name: str, other: str = "") -> str:
    """The variant's own language unless another is asked for."""
    return other or variant(name).language


@cache
def html(name: str, other: str = "", depth: str = "full") -> Note:
    return read(note(name, "html", language(name, other), depth)["note.html"].decode())


def tex(name: str, other: str = "") -> str:
    """note.tex, whose figures are files of their own."""
    return note(name, "tex", language(name, other))["note.tex"].decode()


@cache
def drawings(name: str, depth: str = "full") -> dict[str, Drawing]:
    """The drawings of a note by their anchors, before they are written in any format."""
    return drawn(name, depth=depth)


@cache
def results(name: str, other: str = "") -> dict[str, Any]:
    return json.loads(note(name, "json", language(name, other))["results.json"])


def wrong(found: list[str]) -> None:
    """One assertion for all that is wrong, in words."""
    assert not found, f"{len(found)} wrong:\n" + "\n".join(found[:200])
