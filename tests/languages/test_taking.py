"""Translations are taken in where they are right, and told where they are not."""

from __future__ import annotations

import json
import runpy
import shutil
import sys

import pytest
from babel.messages.catalog import Catalog
from catalogues import TOOLS, messages

from tmm_report.languages import LANGUAGES, Language
from tmm_report.report.sources import SOURCES

FOREIGN = Language(
    "qaa",
    "reserved",
    "comma",
    babel="nonesuch",
    messages=False,
    plurals="nplurals=1; plural=0;",
    alphabet="абвгдеі",
)


@pytest.fixture
def tool(monkeypatch, tmp_path):
    messages()
    monkeypatch.setitem(LANGUAGES, "qaa", FOREIGN)
    tool = runpy.run_path(str(TOOLS / "wording" / "take.py"))
    monkeypatch.setattr(sys.modules["messages"], "LOCALE", tmp_path / "locale")
    yield tool, tmp_path
    shutil.rmtree(tmp_path)


def take(tool, capsys, **given: object) -> tuple[int, str]:
    take, folder = tool
    file = folder / "some.json"
    file.write_text(json.dumps({key.replace("__", "\x04"): said for key, said in given.items()}), "utf-8")
    code = take["main"]("qaa", [str(file)])
    return code, capsys.readouterr().out


def test_what_is_right_is_kept_and_the_rest_counted(tool, capsys):
    code, told = take(tool, capsys, **{"Contents": "абв", "unit__kg": "кг".replace("к", "а")})
    assert code == 1 and "0 are wrong" in told
    lost, every = (int(word) for word in told.split(": ")[-1].split(" are")[0].split(" of "))
    assert every - lost == 2 and every > 5000
    code, told = take(tool, capsys, Position="вг")
    assert f"qaa: {lost - 1} of {every} are missing" in told, "what was taken before is there still"


def test_a_standard_published_in_english_keeps_its_title(tool, capsys):
    titles = [text for text in SOURCES.values() if "(in Russian)" not in text]
    assert titles
    _, told = take(tool, capsys, **{title: title for title in titles})
    assert "0 are wrong" in told, told
    others = [text for text in SOURCES.values() if text.startswith("GOST")]
    assert others
    _, told = take(tool, capsys, **{title: title for title in others})
    assert told.count("left in English") == len(others)


@pytest.mark.parametrize(
    ("id", "said", "told"),
    [
        ("Driving link %(link)s", "Жетекші %(link)s-буын", []),
        ("Driving link %(link)s", "Жетекші %(link)s-шатун", ["driving link"]),
        ("Driving link", "Жетекші буынның", []),
        ("Slider-crank", "Кривошипті-сырғымалы", []),
        ("The crank", "Кривошип", ["crank"]),
        (SOURCES["rack"], "ГОСТ 13755–2015", []),
    ],
)
def test_a_thing_called_otherwise_is_told(id, said, told):
    tool = messages()
    terms = {
        "driving link": ["жетекші буын|"],
        "crank": ["айналша|қ"],
        "rack": ["рейка|"],
        "involute": ["эвольвент|а"],
    }
    file = "tmm_report/report/sources.py" if id in SOURCES.values() else "some.j2"
    catalogue = Catalog("kk")
    catalogue.add(id, said, locations=[(file, 0)])
    found = [text for text in tool["misnamed"](catalogue, terms) if "is in no text" not in text]
    assert [text.split("'")[1] for text in found] == told


WRONG = {
    "values": ("Student: %(name)s", "абв: %(nom)s"),
    "values: ['%(name)s'] became []": ("Student: %(name)s", "абв"),
    "letters of another language: ы": ("Contents", "абвы"),
    "letters of another language: аbв": ("Contents", "аbв"),
    "empty": ("Contents", " "),
    "spaces at the ends": ("Contents", "абв "),
    "markup: [] became ['<b>', '</b>']": ("Contents", "<b>абв</b>"),
    "no such text": ("No text of this program", "абв"),
    "2 forms, and 1 are needed": ("Contents", ["а", "б"]),
    "left in English": ("Ways to assemble the mechanism", "Ways to assemble the mechanism"),
}


@pytest.mark.parametrize("what", WRONG)
def test_what_is_wrong_is_told_and_left_out(tool, capsys, what):
    id, said = WRONG[what]
    code, told = take(tool, capsys, **{id: said})
    assert code == 1 and what in told and id in told, told
    lost, every = (int(word) for word in told.split("qaa: ")[-1].split(" are")[0].split(" of "))
    assert lost == every
