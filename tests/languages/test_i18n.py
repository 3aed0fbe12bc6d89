import gettext
import lzma
import re
from pathlib import Path

import pytest
from catalogues import messages

from tmm_report import i18n, languages
from tmm_report.i18n import DOMAINS, Translator, folder
from tmm_report.resources import data_root

ROOT = Path(__file__).resolve().parents[2]
LANGUAGES = [row.code for row in languages.LANGUAGES.values() if not row.ids]


@pytest.fixture(scope="module")
def tool():
    return messages()


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated_and_compiled(tool, language):
    domains = DOMAINS if languages.LANGUAGES[language].messages else ("note",)
    assert [text for domain in domains for text in tool["missing"](tool["merged"](language, domain))] == []
    stale = [
        entry.id
        for domain in domains
        for compiled in [gettext.translation(domain, folder(), [language])]
        for entry in tool["messages"](tool["merged"](language, domain))
        if not isinstance(entry.id, tuple) and _look_up(compiled, entry) != entry.string
    ]
    assert stale == [], "run python tools/messages.py"


def _look_up(compiled, entry):
    return compiled.pgettext(entry.context, entry.id) if entry.context else compiled.gettext(entry.id)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_keeps_the_named_values(tool, language):
    pattern = re.compile(r"%\(\w+\)[^a-z]*[a-z]")
    wrong = [
        entry.id
        for entry in tool["messages"](tool["merged"](language))
        if isinstance(entry.string, str)
        and entry.string
        and sorted(pattern.findall(entry.id)) != sorted(pattern.findall(entry.string))
    ]
    assert wrong == []


def test_the_extractor_sees_program_and_context(tool):
    found = {(message, context) for _, message, context in tool["extracted"]()}
    assert ("kg", "unit") in found and ("bal", "index") in found


def test_english_is_the_language_of_the_ids():
    assert Translator("en").gettext("Contents") == "Contents"
    assert Translator("en").ngettext("%d link", "%d links", 2) == "%d links"
    assert Translator("ru").gettext("") == ""


@pytest.mark.parametrize(
    ("translator", "sign"),
    [
        (Translator("ru"), ","),
        (Translator("en"), "."),
        (Translator("ru", "point"), "."),
        (Translator("en", "comma"), ","),
    ],
)
def test_decimal_sign_follows_the_language_unless_stated(translator, sign):
    assert translator.decimal == sign


def test_the_data_stand_where_the_program_looks():
    assert (data_root() / "templates" / "fonts" / "OFL.txt").is_file()
    assert (data_root() / "variants").is_dir()


def test_a_packed_catalogue_says_the_same(tmp_path, monkeypatch):
    """As a wheel has it."""
    file = folder() / "kk" / "LC_MESSAGES" / "note.mo"
    place = tmp_path / "kk" / "LC_MESSAGES"
    place.mkdir(parents=True)
    (place / "note.mo.xz").write_bytes(lzma.compress(file.read_bytes()))
    said = Translator("kk").gettext("crank")
    monkeypatch.setattr(i18n, "folder", lambda: tmp_path)
    assert i18n._read("kk", "note").gettext("crank") == said != "crank"
