"""How the notes of all ready variants read: sources, words (references, scales: `tests/lint/test_shipped_notes.py`)."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from contextlib import suppress
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

import pytest
from conftest import solved
from exhaustive import many
from notes import note
from spoken import EVERY, LAID_OUT, notes_in

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "page"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
from messages import merged, messages
from note import read, text_of

from tmm_report import render
from tmm_report.i18n import Translator
from tmm_report.languages import DEFAULT, LANGUAGES
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.text import UNITS, unit_text
from tmm_report.report.sources import SOURCES, Cited

CHAPTERS = Path(__file__).resolve().parents[2] / "templates" / "chapters"
QUICK = ["compressor-ru", "governor_servo-en"]
NOTES, WORDED = (notes_in(languages, QUICK) for languages in (LAID_OUT, EVERY))
JOINER = "\N{WORD JOINER}"
# a note after another, each read once
each = pytest.mark.parametrize("name", many(NOTES, len(QUICK)), scope="module")
in_every_language = pytest.mark.parametrize("name", many(WORDED, len(QUICK)), scope="module")


@lru_cache(maxsize=2)
def page(name: str) -> Element:
    variant, _, language = name.rpartition("-")
    return read(note(variant, "html", language)["note.html"].decode()).root


@each
def test_every_note_cites_its_sources_within_its_sentences(name):
    root = page(name)
    cited = [node for node in root.iter("a") if (node.get("href") or "").startswith("#source")]
    assert cited and not [node for node in root.iter("p") if text_of(node).strip().startswith("[")]


@in_every_language
def test_sources_cited_together_are_parted_as_in_the_language(name):
    variant, _, language = name.rpartition("-")
    text = note(variant, "html", language)["note.html"].decode()
    between = re.findall(r"</a>([^<]+)<a href=\"#source", text)
    sign = {"ru": ";", "en": ",", "uk": ",", "kk": ";"}[language]
    assert {one for one in between if one.strip() in (",", ";")} <= {f"{sign}\N{NO-BREAK SPACE}"}
    assert between or name not in QUICK


@each
def test_sources_are_numbered_in_the_order_in_which_the_text_cites_them(name):
    """Whatever was put off into an appendix; those that are cited together stand in order."""
    variant, _, language = name.rpartition("-")
    text = note(variant, "html", language)["note.html"].decode()
    numbers = [int(one) for one in re.findall(r'href="#source(\d+)"', text)]
    assert list(dict.fromkeys(numbers)) == list(range(1, max(numbers) + 1))
    for group in re.findall(r"\[(<a href=\"#source.*?)\]", text):
        together = [int(one) for one in re.findall(r"#source(\d+)", group)]
        assert together == sorted(set(together))


def test_sources_of_what_was_put_off_come_behind_those_of_the_text():
    cited = Cited("; ")
    put_off, text = (cited.mark(names, str) for names in (["wear", "rack"], ["balancing", "rack"]))
    assert cited.order(f"[{text}]") == ["balancing", "rack", "wear"]
    assert cited.resolved(f"[{text}] [{put_off}]") == "[1; 2] [2; 3]"


@in_every_language
def test_no_line_ends_between_a_number_and_its_unit(name):
    """By GOST 2.105; in cells, too, but those of the methods and their settings."""
    language = name.rpartition("-")[2]
    words = (unit_text(unit, language) for unit in UNITS if unit != "A")  # which begins headings, too
    units = "|".join([*words, "%", "°"])
    texts = [text_of(node) for node in page(name).iter() if node.tag in ("p", "li", "figcaption", "td")]
    assert len(texts) > 20
    parted = [text for text in texts if re.search(rf"\d (?:{units})(?!\w)", text)]
    settings = rf"[\w ]+, [\d.,]+ {unit_text('mm', language)}"
    assert not [text for text in parted if not re.fullmatch(settings, text)]


@in_every_language
def test_no_line_ends_within_a_unit_or_within_the_name_of_a_stage(name):
    """As a browser would end it behind a slash and behind a hyphen before a letter."""
    variant, _, language = name.rpartition("-")
    text = note(variant, "html", language)["note.html"].decode()
    words = re.sub(r"<(svg|math|table|script|style|h[1-6])\b.*?</\1>|<[^>]*>", " ", text, flags=re.S)
    units = rf"(?<![\w./-])(?:рад|об|айн|м|кг|Н|rad|rev|m|kg|N)/{JOINER}?(?:с|мин|хв|м|рад|s|min|m|rad)(?!\w)"
    found = re.findall(rf"{units}|\d['′]?-{JOINER}?H\b", words)
    assert not [one for one in found if JOINER not in one] and (found or name not in QUICK)


def test_every_source_is_cited_by_a_template():
    said = "".join(path.read_text("utf-8") for path in CHAPTERS.rglob("*.j2"))
    cited = " ".join(re.findall(r"m\.(?:by|cite)\((.*?)\)", said))
    assert set(re.findall(r'"(\w+)"', cited)) == set(SOURCES)


_NAME, _INITIALS = r"[А-ЯЁ][а-яё]+(?:-[А-ЯЁ][а-яё]+)?", r"[А-ЯЁ][а-яё]?\. [А-ЯЁ]\."
_AUTHOR, _EDITED = rf"{_NAME} {_INITIALS}", rf"под ред\. {_INITIALS} {_NAME}"
_TITLE, _IN_ENGLISH = r"[А-ЯЁ][^.:;/–]+[^ .:;/–]", r"[A-Z][^.:;/–]+[^ .:;/–]"
_PLACE, _YEAR = r"(?:М\.|Л\.|[А-ЯЁ][а-яё]+)", r"(?:19|20)\d\d"
_PRINTED = rf"\. – {_PLACE}(?: ; {_PLACE})? : [А-ЯЁ][а-яё]+(?: школа)?, {_YEAR}\. – \d+ с\."
_GOST, _ISO = r"ГОСТ \d+–(?:\d\d|\d{4})(?: \(ISO \d+:\d{4}\))?", r"ISO \d+-\d+:\d{4}"
FORMS = {  # by GOST R 7.0.5
    "a book of up to three authors": rf"{_AUTHOR}(?:, {_AUTHOR}){{0,2}} {_TITLE}(?: : пер\. с англ)?{_PRINTED}",
    "a book under its title": rf"{_TITLE} / (?:{_INITIALS} {_NAME} \[и др\.\] ; )?{_EDITED}{_PRINTED}",
    "an article": r"[A-Z][a-z]+ (?:[A-Z]\. )+"
    rf"{_IN_ENGLISH} // {_IN_ENGLISH}\. – {_YEAR}\. – Vol\. \d+\. – P\. \d+–\d+\.",
    "a standard": rf"(?:{_GOST}|{_ISO})(?:\. (?:[А-ЯЁ][а-яё ]+|Часть \d+))+\.",
}


@pytest.mark.parametrize("source", SOURCES)
def test_a_source_has_the_form_of_its_kind(source):
    text = Translator("ru").gettext(SOURCES[source])
    spaced = text.replace("\N{NO-BREAK SPACE}", " ")
    assert len([kind for kind, form in FORMS.items() if re.fullmatch(form, spaced)]) == 1, text


@pytest.mark.parametrize("language", [row.code for row in LANGUAGES.values() if row.alphabet])
@pytest.mark.parametrize("source", SOURCES)
def test_no_line_of_a_source_begins_with_a_sign_or_parts_a_number_from_what_it_counts(source, language):
    text = Translator(language).gettext(SOURCES[source])
    assert not re.search(r" (?:[:;]|//|с\.)|(?:Vol|P|[А-Я])\. (?:\d|[А-Я]\.)", text)


@pytest.mark.parametrize("source", SOURCES)
def test_a_ukrainian_and_a_kazakh_note_call_a_source_as_it_was_published(source):
    """A Russian book under its Russian title, a standard in English under its English one."""
    title, ru = SOURCES[source], Translator("ru").gettext(SOURCES[source])
    published = title if "(in Russian)" not in title else ru
    words = set(re.findall(r"[^\W\d_]{4,}", published)) - {"Москва", "Moscow"}
    for language in ("uk", "kk"):
        assert words <= set(re.findall(r"[^\W\d_]{4,}", Translator(language).gettext(title)))


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("source", SOURCES)
def test_a_source_has_the_same_numbers_in_every_language_and_ends_with_a_stop(source, language):
    both = SOURCES[source], Translator(language).gettext(SOURCES[source])
    one, other = (sorted(re.findall(r"\d+", text)) for text in both)
    assert one == other and all(text.endswith(".") for text in both)


WRONG = {  # what the terms of the course are not called: ISO 1122 and IFToMM in English, usage in Russian
    "en": r"swing centre|frequency of rotation|height of the head|active means|The calculation follows|insensitivity"
    r"|(?i:working (?:diameter|circle)|shortening of the tip|coefficient of non-uniformity|thickness of the tooth)"
    r"|(?i:\bsatellites?\b(?![:)]))"  # but the key of a variant is called so
    r"|(?i:\bplans? of (?:velocit|accel|forces|angular)|\b(?:force|velocity|acceleration) plans?\b|graph-analytical)"
    r"|(?i:vector contour|\bangles? of turn\b|reversed motion|\b(?:turning|sliding) pairs?\b|forces of inertia)"
    r"|(?i:\bhands? on\b|in the pitch point|on the (?:mean|average)\b(?! )|\bin hand\b|isodrome of|error of rounding)"
    r"|(?i:add up to nothing|is wanting|\ball over its\b|\bat the most\b|\bis nil\b)"
    r"|(?i:derivatives? [^.:;%]* by the angle)",
    "ru": r"активное средство|амортизатор|коэффициент\w* виброизоляции|Расчёт ведётся|Формула строения"
    r"|(?i:демпфирование лежит|частота оборотов)|—|^[xy] точки|одни пары стойки|оставляет из них|^Покоя$",
    "uk": r"(?i:слідуюч|являється|співпада|на протязі|по відношенню до|передаточн|окружност|в якості|так як\b)"
    r"|(?i:зчеплення зуб|плече кулачка|повзунець|степінь рухомості)|—|\b[Пп]ри (?:цьому куті|цьому ході|куті)",
    "kk": r"(?i:ползун|шатун|коромысло|звено|сермер|программа|алыстау|жылдамдықтар? көпбұрыш)|—",
}


@pytest.mark.parametrize("language", LANGUAGES)
def test_wrong_words_do_not_come_back(language):
    """In no text of the program, whatever note says it; English is read by the Russian catalogue."""
    row = LANGUAGES[language]
    catalogue = merged(DEFAULT if row.ids else language, None if row.messages else "note")
    said = [form for entry in messages(catalogue) for form in _forms(entry, language)]
    assert len(said) > 5000
    assert not [text for text in said if re.search(WRONG[language], text)]


def _forms(entry: Any, language: str) -> tuple[str, ...]:
    text = entry.id if language == "en" else entry.string
    return (text,) if isinstance(text, str) else tuple(text or ())


SCALE = re.compile(r"<math><msub><mi>μ</mi>.*?<mn [^>]*data-t=\"picture\"[^>]*>([\d.]+)</mn>")
ROUND = (1.0, 1.25, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0)


@pytest.mark.parametrize(
    "name",
    ["governor_porter", "governor_servo", "governor_spring", "locomotive_diesel", "forging_machine_wear"],
)
def test_curves_stand_at_round_scales(name):
    """A ruler reads them: over a lift, a time, a speed and a frequency as over a turn."""
    text = note(name, "html", "en")["note.html"].decode()
    captions = " ".join(re.findall(r"<figcaption>(.*?)</figcaption>", text, re.S))
    scales = [float(one) for one in SCALE.findall(captions)]
    assert len(scales) > 6
    assert not [one for one in scales if not any(f"{one:e}".startswith(f"{r:e}"[:8]) for r in ROUND)]


def test_a_symbol_of_a_sentence_is_that_of_the_formulas():
    """`sym("T_1")` in a template prints its own letters: where a quantity of the chapter has this key, they are its."""
    other = []
    for template in CHAPTERS.rglob("*.j2"):
        named = set(re.findall(r'\bsym\("([^"]+)"\)', template.read_text("utf-8")))
        for key, declared in _declared(template.relative_to(CHAPTERS).with_suffix("").parts):
            if key in named and math_symbol(key) != declared:
                other.append((template.stem, key))
    # the clearance coefficient c* there, beside the coefficient c of the equation for whole numbers of teeth
    assert other == [("eccentric", "c")]


@pytest.mark.parametrize("name", ["hoist_drive", "compressor"])
def test_a_heading_has_the_rank_of_its_number(name):
    """In an appendix, too, where a part of a section begins as one: A.1 looks as 2.1 does."""
    root = read(render(solved(name), "html", "en", "course")["note.html"].decode()).root
    headings = [node for node in root.iter() if node.tag in ("h1", "h2", "h3")]
    numbers = [
        (node.tag, re.match(r"(?:\d+|[A-Z])(?:\.\d+)*(?= )", text_of(node).strip())) for node in headings
    ]
    found = [(tag, number[0]) for tag, number in numbers if number]
    assert any(number.startswith("A.") for _, number in found)
    assert not [number for tag, number in found if int(tag[1]) != number.count(".") + 1]


def _declared(chapter: tuple[str, ...]) -> Iterator[tuple[str, Symbol]]:
    """Keys and symbols of single numbers and columns that a chapter, or the one that it is a part of, declares."""
    for deep in range(2, len(chapter) + 1):
        with suppress(ModuleNotFoundError):
            sheets = vars(import_module(".".join(["tmm_report.chapters", *chapter[:deep], "values"])))
            for sheet in sheets.values():
                if isinstance(sheet, type) and sheet.__module__.endswith(".values"):
                    for key, one in vars(sheet).items():
                        if isinstance(one, Q) and one.quantity.symbol is not None:
                            yield key, one.quantity.symbol
