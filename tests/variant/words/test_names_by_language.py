"""A name that a variant gives in several languages stands in each note in its own."""

from __future__ import annotations

import json
import pickle
import re
from collections.abc import Iterator

import pytest
import yaml
from conftest import ALL_FILES, FILES, solved
from exhaustive import many
from notes import NAMES, note, render

from tmm_report import load, solve
from tmm_report.i18n import Translator
from tmm_report.languages import LANGUAGES
from tmm_report.problems import N_, Called, Message, ProblemError

SOURCE = next(file for file in FILES if file.stem == "crank_rocker").read_text("utf-8")
CYRILLIC = re.compile("[\u0400-\u04ff]")
TITLE = ("institution", "department", "topic", "student", "teacher", "group", "city")
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
KNOWN = ", ".join(LANGUAGES)
TEXT = re.compile(r">([^<]*)<")


def written(tmp_path, topic: str, load_name: str):
    text, topics = re.subn(r"(?ms)^  topic: .*?(?=^  \w)", f"  topic: {topic}\n", SOURCE)
    text, names = re.subn(r"(?ms)^    - name: .*?(?=^      \w)", f"    - name: {load_name}\n", text, count=1)
    assert topics == names == 1
    file = tmp_path / "my.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def pages(file) -> dict[str, str]:
    results = solve(load(file))
    return {code: render(results, "html", code)["note.html"].decode() for code in LANGUAGES}


def test_each_note_has_its_own(tmp_path):
    file = written(tmp_path, "{ru: Привод, en: The drive}", "{ru: вес груза, en: weight of the load}")
    found = pages(file)
    assert "The drive" in found["en"] and "weight of the load" in found["en"]
    assert "Привод" in found["ru"] and "вес груза" in found["ru"]
    assert "The drive" not in found["ru"] and "weight of the load" not in found["ru"]
    assert "вес груза" not in found["en"] and ">Привод<" not in found["en"]
    tex = render(solve(load(file)), "tex", "en")["note.tex"].decode()
    assert "weight of the load" in tex and "вес груза" not in tex
    numbers = json.loads(render(solve(load(file)), "json", "en")["results.json"])
    assert "weight of the load" in json.dumps(numbers, ensure_ascii=False)


TIES = """loads:
  springs:
    - {name: {ru: пружина, en: coil}, between: [B, O], stiffness: 200 N/m, free_length: 50 mm}
  dampers:
    - {name: {ru: гаситель, en: absorber}, between: [E, C], viscosity: 20 N*s/m}
  torsion_springs:
    - {name: {ru: торсион, en: twisted bar}, links: [3, 0], stiffness: 5 N*m/rad, preload: 2 N*m}
"""


def test_springs_and_dampers_have_theirs(tmp_path):
    file = tmp_path / "my.yaml"
    file.write_text(SOURCE.replace("loads:\n", TIES, 1), encoding="utf-8")
    found = pages(file)
    for ru, en in (("пружина", "coil"), ("гаситель", "absorber"), ("торсион", "twisted bar")):
        assert ru in found["ru"] and en not in found["ru"]
        assert en in found["en"] and ru not in found["en"]


def test_without_the_note_s_language_it_stands_as_given(tmp_path):
    found = pages(written(tmp_path, "{en: The drive}", "вес груза"))
    assert "The drive" in found["ru"] and "вес груза" in found["en"]


@pytest.mark.parametrize(
    ("name", "en", "ru"),
    [
        ("{ru: вес, eo: pezo}", f"a text by languages: eo is none of them; known: {KNOWN}", "языка eo нет"),
        ("{kк: вес}", "kк is none of them; write kk, with the Latin letter k", "там латинская буква k"),
        ("{en: [1, 2]}", "a text is expected here", "здесь нужен текст"),
        ("{en: {ru: x}}", "a text is expected here", "здесь нужен текст"),
        ("[вес]", "a text is expected here", "здесь нужен текст"),
        ("{en: " + "x" * 201 + "}", "the text is longer than 200 characters", "длиннее 200"),
    ],
)
def test_what_is_no_name(tmp_path, name, en, ru):
    with pytest.raises(ProblemError) as raised:
        load(written(tmp_path, "Привод", name))
    (problem,) = raised.value.problems
    assert en in problem.text() and ru in problem.text(Translator("ru").gettext)
    inner = "of them" in en  # the language itself is wrong
    assert problem.line and problem.path[-1 - inner] == "name"


def texts_of_ready_variants() -> Iterator[tuple[str, str, dict[str, str]]]:
    """File, key, the text by languages; one that has no letter but Latin ones needs no language."""

    def walk(value: object, key: str) -> Iterator[tuple[str, dict[str, str]]]:
        if isinstance(value, dict) and value.keys() & LANGUAGES.keys():
            yield key, value
        elif isinstance(value, dict):
            for inner, one in value.items():
                yield from walk(one, str(inner))
        elif isinstance(value, list):
            for one in value:
                yield from walk(one, key)
        elif key in TITLE or key == "name":
            yield key, dict.fromkeys(LANGUAGES if not CYRILLIC.search(str(value)) else ["ru"], str(value))

    for file in ALL_FILES:
        for key, text in walk(yaml.load(file.read_text("utf-8"), LOADER), ""):
            yield file.stem, key, text


def test_the_texts_of_ready_variants_are_in_every_language_by_its_letters():
    """Of words that are no names of persons, places or groups Kazakh has its own, too."""
    found = [*texts_of_ready_variants()]
    assert len(found) > 500
    assert [text for *text, by in found if [*by] != [*LANGUAGES]] == []
    odd = {
        (file, key, code, text)
        for file, key, by in found
        for code, text in by.items()
        if {*CYRILLIC.findall(text.lower())} - {*LANGUAGES[code].alphabet}
    }
    assert odd == set()
    same = {
        by["ru"]
        for _, key, by in found
        if key in TITLE[:3] and CYRILLIC.search(by["ru"]) and by["kk"] == by["ru"]
    }
    assert same == set()


def test_a_name_says_itself_and_is_told_from_one_that_begins_alike():
    one, other = Called({"ru": "вес", "en": "weight"}), Called({"ru": "вес", "en": "load"})
    assert one == "вес" and one != other and {one: 1}.get(other) is None
    again = pickle.loads(pickle.dumps(one))
    assert again == one and again.by == one.by
    said = Message(N_("force on point %(name)s"), {"name": one})
    assert said.render(Translator("en").gettext) == "force on point weight"
    assert said.render(Translator("ru").gettext).endswith("вес")


@pytest.mark.parametrize("name", many(NAMES, 3))
def test_the_english_note_of_a_ready_variant_is_english(name):
    page = note(name, "html", "en")["note.html"].decode()
    assert solved(name).variant.title.topic
    texts = TEXT.findall(page[page.index("<main>") :])
    assert len(texts) > 100 and not [text for text in texts if CYRILLIC.search(text)]


@pytest.mark.parametrize(
    ("language", "topic", "line"), [("ru", "Насос", "Факультет"), ("en", "Pump", "Faculty")]
)
def test_results_name_the_title_in_the_language_of_their_meanings(tmp_path, language, topic, line):
    lines = "\n  lines: [{ru: Факультет, en: Faculty}]\n  signed: [{role: {ru: Факультет, en: Faculty}}]"
    file = written(tmp_path, "{ru: Насос, en: Pump}" + lines, "force")
    title = json.loads(render(solve(load(file)), "json", language)["results.json"])["title"]
    assert (title["topic"], title["lines"]) == (topic, [line])
    assert title["signed"] == [{"role": line, "name": ""}]
