"""Two catalogues of texts: what a note, a feedback or a statistic says stands in `note`, found without the other."""

from __future__ import annotations

import gettext
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from unittest.mock import patch

import pytest
from batching import Heard, here
from catalogues import messages as tool
from catalogues import texts
from conftest import read, solved
from exhaustive import many
from notes import NAMES, SOME, STATED, VARIANTS, Asked, asked_by, asking, render

from tmm_report import i18n, load, solve
from tmm_report.commands.grade import run as grade
from tmm_report.i18n import Translator, catalogue, folder, said
from tmm_report.languages import FALLBACK, LANGUAGES, Language
from tmm_report.sheets import composed
from tmm_report.sheets.pictures import figures

ROOT = Path(__file__).resolve().parents[2]
CLASS = ROOT / "tests" / "cases" / "class"
QUICK = ["compressor", "press", "punch_press"]


def of(domain: str) -> Asked:
    """Ids and contexts of the texts of a catalogue."""
    return {
        (one.id if isinstance(one.id, str) else one.id[0], one.context)
        for one in tool()["messages"](tool()["merged"]("ru", domain))
    }


@pytest.fixture
def asked() -> Iterator[Asked]:
    """What a test has a translator asked for."""
    with asking() as found:
        yield found


def strangers(asked: Asked) -> list[str]:
    """Sentences and words that were asked for and do not stand in `note`: neither letters of an index nor what has no
    word beside its values."""
    lost = {text for text, context in asked - of("note") if context is None} - {"id"}
    return sorted(text for text in lost if re.search(r"[^\W\d_]", re.sub(r"%\(\w+\)\w", "", text)))


@pytest.mark.parametrize("name", many([*QUICK, *sorted({*NAMES} - {*QUICK})], len(QUICK)))
def test_what_a_note_says_stands_in_note(name, asked):
    figures(solved(name), Translator("ru"))
    assert strangers(asked.union(*(asked_by(name, fmt, "ru") for fmt in ("html", "tex", "json")))) == []
    assert len(asked_by(name, "html", "ru")) > 50  # the shortest note asks for some hundred


@pytest.mark.exhaustive
def test_some_notes_say_nearly_all():
    """A chapter more, and one of its notes belongs to them."""
    said = {name: asked_by(name, "html", "ru") for name in NAMES}
    assert len(set().union(*(said[name] for name in SOME))) > 0.9 * len(set().union(*said.values()))


@pytest.mark.parametrize("name", QUICK)
def test_what_a_sheet_says_stands_in_note(name, asked):
    """Its frame and title block, too: the same on all."""
    assert composed(solved(name), Translator("ru"))
    assert {"Mass", "Drawn by"} <= {text for text, _ in asked} and strangers(asked) == []


@pytest.mark.parametrize("name", many([*STATED.values()], 3))
def test_what_the_note_of_a_statement_says_stands_in_note(name, asked):
    """LaTeX asks for what the page does and for signs of an index, as the notes of ready variants do."""
    figures(solved(name), Translator(read(name).language))
    assert strangers(asked.union(*(asked_by(name, fmt) for fmt in ("html", "json")))) == []
    assert len(asked_by(name, "html")) > 50


def test_doubts_stand_in_note(asked, tmp_path):
    """What was solved all the same is told under the initial data."""
    text = (VARIANTS / "compressor.yaml").read_text("utf-8")
    doubtful = re.sub(r", inertia: [^,}]*", "", text)
    assert doubtful != text
    file = tmp_path / "odd.yaml"
    file.write_text(doubtful, "utf-8")
    results = solve(load(file))
    assert results.variant.doubts
    render(results, "html", "ru")
    assert strangers(asked) == []
    assert {one.said.values["wrong"].text for one in results.variant.doubts if one.right} <= {
        t for t, _ in asked
    }


def test_a_file_that_tells_doubts_belongs_to_note():
    domain = tool()["domain"]
    files = [
        *(ROOT / "tmm_report" / "chapters").rglob("*.py"),
        *(ROOT / "tmm_report" / "variant").rglob("*.py"),
    ]
    telling = [file for file in files if re.search(r"\bdoubt\(|doubt=True", file.read_text("utf-8"))]
    assert len(telling) > 10
    assert [file for file in telling if domain(file.relative_to(ROOT).as_posix()) != "note"] == []


def test_what_a_class_gets_back_stands_in_note(asked, tmp_path):
    """Feedback, marks and statistics, with files that cannot be read."""
    works = tmp_path / "answers"
    shutil.copytree(CLASS / "answers", works)
    (works / "st03.yaml").write_text("7: {v_B: !!python/name:os 1}\n", "utf-8")
    (works / "st05.xlsx").write_bytes(b"PK")
    (works / "st10.yaml").write_text("7: {v_B: 1", "utf-8")
    (works / "st21.yaml").write_text("7: {v_B: 4 lb}\n77: {v_B: 2}\nstranger: {v_B: 2}\n", "utf-8")
    (works / "st22.xlsx").unlink()
    (works / "st30.yaml").write_text("", "utf-8")
    with patch.object(grade, "over", here):
        grade.run(
            [str(CLASS / "handout")],
            [str(works)],
            tmp_path / "marks",
            "ru",
            "ru",
            Heard(),
            rubric=CLASS / "rubric.yaml",
        )
    assert len(list((tmp_path / "marks").rglob("*.html"))) > 25
    assert len(asked) > 120 and strangers(asked) == []


# ---------------------------------------------------------------- a text is found from either, the other is read late


def test_a_catalogue_is_whole_and_no_text_stands_in_both():
    note, messages = of("note"), of("messages")
    every = {(one if isinstance(one, str) else one[0], context) for _, one, context in texts()}
    assert note | messages == every and not note & messages
    assert {context for _, context in messages} == {None}, "words in a context are of the note"


def test_a_text_is_found_from_either():
    note = gettext.translation("note", folder(), ["ru"])
    messages = gettext.translation("messages", folder(), ["ru"])
    for text, own, other in (("Contents", note, messages), ("stopped", messages, note)):
        assert own.gettext(text) != text == other.gettext(text)
        assert Translator("ru").gettext(text) == said("ru", text) == own.gettext(text)


LATE = """
import os, sys
from gettext import GNUTranslations
read = []
parse = GNUTranslations._parse
def noted(self, file):
    read.append(os.path.basename(file.name))
    return parse(self, file)
GNUTranslations._parse = noted
{}
print(*read)
"""


@pytest.mark.parametrize(
    ("run", "read"),
    [
        ("from tmm_report import load, render, solve\nrender(solve(load(sys.argv[1])))", "note.mo"),
        ("from tmm_report.i18n import said\nsaid('ru', 'stopped')", "messages.mo"),
        (
            "from tmm_report.i18n import said\nsaid('ru', 'stopped'), said('ru', 'Contents')",
            "messages.mo note.mo",
        ),
    ],
)
def test_a_catalogue_is_read_when_it_is_asked(run, read):
    command = [sys.executable, "-c", LATE.format(run), str(VARIANTS / "crank_rocker.yaml")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, env={"PYTHONPATH": str(ROOT)})
    assert done.stdout == read + "\n", done.stderr


# ---------------------------------------------------------------- a language that only notes speak


@pytest.fixture
def of_notes(monkeypatch, tmp_path):
    """A language with a catalogue of notes alone."""
    monkeypatch.setitem(
        LANGUAGES, "qaa", Language("qaa", "reserved", "comma", babel="nonesuch", messages=False)
    )
    shutil.copytree(folder(), tmp_path / "locale")
    there = tmp_path / "locale" / "qaa" / "LC_MESSAGES"
    there.mkdir(parents=True)
    shutil.copy(folder() / "ru" / "LC_MESSAGES" / "note.mo", there)
    monkeypatch.setattr(i18n, "folder", lambda: tmp_path / "locale")
    catalogue.cache_clear()
    yield
    catalogue.cache_clear()


@pytest.mark.parametrize(
    ("system", "heard"), [("ru_RU.UTF-8", "остановлено"), ("C", "stopped"), ("qaa", "stopped")]
)
def test_its_messages_come_in_the_systems_language(of_notes, monkeypatch, system, heard):
    monkeypatch.setenv("LC_ALL", system)
    assert said("qaa", "stopped") == Translator("qaa").gettext("stopped") == heard
    assert Translator("qaa").gettext("Contents") == Translator("ru").gettext("Contents")
    assert FALLBACK == "en"
