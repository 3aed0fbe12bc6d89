"""Notes of ready variants, made once a test run, and the programs that look at them."""

from __future__ import annotations

import os
import pickle
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NoReturn
from unittest.mock import patch

import pytest
from conftest import ALL_FILES, STATEMENTS, read, solved
from once import once

from tmm_report import render as of_depth
from tmm_report.commands.files import for_typst
from tmm_report.course import Depth, Results
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.i18n import Translator
from tmm_report.living import static as still
from tmm_report.report.formats import Html, drawing_of

VARIANTS = Path(__file__).parent.parent / "variants"
NAMES = sorted(path.stem for path in ALL_FILES)
SOME = (
    "shaper_project", "compressor", "forging_machine_wear", "governor_porter", "piston_pump", "eccentric",
    "jack_and_belt", "hoist_differential", "engine_balance", "rotor", "valve_cam", "winch_drive", "grain_screen",
    "locomotive_diesel", "cam_press", "slider_crank_offset", "steam_hammer", "knuckle_press", "shaper_synthesis",
    "conveyor_drive",
)  # fmt: skip
"""Notes that say nine tenths of what all say: what is dear to read, and by templates alike, is read in these."""
STATED = {  # statements of textbooks, and how their notes are asked for
    path.stem: path.stem if path in STATEMENTS else f"statements/{path.stem}"
    for path in sorted(Path(__file__).parent.joinpath("statements").glob("*.yaml"))
    if not path.stem.endswith(".answers")
}
Asked = set[tuple[str, str | None]]


def render(
    results: Results, fmt: str = "html", language: str | None = None, depth: Depth = "full"
) -> dict[str, bytes]:
    """The note that says all, or the numbers: what a shorter one leaves out is judged, too."""
    if fmt == "typst":
        return {"note.typst": for_typst(results, language, depth)}
    return of_depth(results, fmt, language, depth)


def static(page: str) -> str:
    """A note in HTML as it is where scripts are off: without what moves it on the screen."""
    found = still(page)
    assert found != page and page.count("<script") == found.count("<script") + 2, (
        "the living page stands behind the text of a note"
    )
    return found


def note(name: str, fmt: str, language: str | None = None, depth: Depth | None = "full") -> dict[str, bytes]:
    """Files of the note of a ready variant or a statement; in its own language where none is stated; of no `depth`:
    as it is made by itself."""
    variant = read(name)
    return rendered(name, fmt, language or variant.language, depth or variant.note.depth)


def rendered(name: str, fmt: str, language: str, depth: Depth) -> dict[str, bytes]:
    return _rendered(name, fmt, language, depth)[0]


def asked_by(name: str, fmt: str, language: str | None = None) -> Asked:
    """The texts that such a note asks a translator for: by their English words in every language."""
    return _rendered(name, fmt, language or read(name).language, "full")[1]


def drawn(name: str, language: str | None = None, depth: Depth = "full") -> dict[str, Drawing]:
    """The drawings of such a note, its graphs among them, by their anchors, before they are written in any format."""
    found: dict[str, Drawing] = pickle.loads(
        _rendered(name, "html", language or read(name).language, depth)[2]
    )
    return found


@once
def _rendered(name: str, fmt: str, language: str, depth: Depth) -> tuple[dict[str, bytes], Asked, bytes]:
    """Files, what was asked for, and the drawings of a page, pickled: few readers of a note want them."""
    results, found, picture = solved(name), {}, Html.picture

    def noted(self: Html, picture_: Drawing | Graph, anchor: str, *caption: Any) -> Any:
        found[anchor] = drawing_of(picture_)
        return picture(self, picture_, anchor, *caption)

    with asking() as asked, patch.object(Html, "picture", noted):
        files = render(results, fmt, language, depth)
    return files, asked, pickle.dumps(found)


@contextmanager
def asking() -> Iterator[Asked]:
    """Texts, and their contexts, that a translator is asked for meanwhile."""
    found: Asked = set()

    def noting(name: str, text_at: int, context_at: int | None = None) -> Any:
        translate = getattr(Translator, name)

        def noted(self, *args):
            found.add((args[text_at], None if context_at is None else args[context_at]))
            return translate(self, *args)

        return patch.object(Translator, name, noted)

    with noting("gettext", 0), noting("ngettext", 0), noting("pgettext", 1, 0):
        yield found


def program(*names: str) -> str:
    """Path of the first of these programs that is installed; without one the test is skipped, but never in CI."""
    found = next((path for path in map(shutil.which, names) if path), None)
    if found is None:
        absent(f"none of {', '.join(names)} is installed")
    return found


def absent(reason: str) -> NoReturn:
    """Something that a test needs is not there: it is skipped, but never in CI."""
    if os.environ.get("CI"):
        pytest.fail(reason)
    pytest.skip(reason)
