"""How a note looks by its profile: its pages are read and measured, as the browser, LaTeX and Typst print them."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from browser import browser, laid_out, opened, sheet
from conftest import read, solved
from notes import VARIANTS, program
from once import once
from pdf_words import Page, pages
from typesetting import set_by_tex, set_by_typst

from tmm_report import render
from tmm_report.commands.files import for_typst
from tmm_report.languages import LANGUAGES
from tmm_report.loading import loads
from tmm_report.problems import ProblemError
from tmm_report.profiles import NAMES, data, merged, shipped, stated
from tmm_report.report.paper.punctuation import joined
from tmm_report.report.paper.sheets import USUAL, Paper

NAME = "crank_rocker"
ODD = stated("gost", {"margins": {"left": "37 mm", "right": "21 mm"}, "text": {"size": 13}})  # of no standard
PROFILES = {**{name: shipped(name) for name in NAMES}, "odd": ODD}
each = pytest.mark.parametrize("name", PROFILES)


OTHERS = {"none": None, "kazakh": stated("kz", {"language": "kk"})}


@cache
def note(name: str, fmt: str = "html", language: str = "ru", depth: str = "short") -> dict[str, bytes]:
    results = solved(NAME)
    results = replace(results, variant=replace(results.variant, profile={**PROFILES, **OTHERS}[name]))
    if fmt == "typst":
        return {"note.typst": for_typst(results, language, depth)}
    return render(results, fmt, language, depth)


def html(name: str, language: str = "ru", depth: str = "short") -> str:
    return note(name, "html", language, depth)["note.html"].decode()


def captions(text: str, kind: str) -> list[str]:
    tag = {"figure": r"<figcaption>(.*?)</figcaption>", "table": r'<p class="caption">(.*?)</p>'}[kind]
    return [re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", one)) for one in re.findall(tag, text, re.S)]


# --- the data


def test_the_usual_profile_is_that_of_the_standard():
    """GOST 7.32-2017, 6.1.1, 6.2.1, 6.3.1, 6.5, 6.6, 6.8."""
    gost = shipped()
    assert gost == shipped("gost") and Paper(gost.margins, gost.text) == USUAL
    assert (gost.margins.left, gost.margins.right, gost.margins.top, gost.margins.bottom) == (30, 15, 20, 20)
    assert gost.text.size >= 12 and gost.text.spacing == 1.5 and gost.text.indent == 12.5
    assert gost.headings.structural.align == "centre" and gost.headings.structural.capitals
    assert gost.word("figure", "ru") == "Рисунок {n} — {title}" and gost.where.lines
    assert html("gost") == note("none")["note.html"].decode()


@pytest.mark.parametrize("name", NAMES)
def test_a_shipped_profile_is_what_a_variant_may_state(name):
    """Every value of its file, as a variant's own; nothing is left to chance: every language has every word."""
    text = (VARIANTS / f"{NAME}.yaml").read_text("utf-8")
    written = dict(data(name))
    assert loads(f"{text}\nprofile: {dumped({'base': 'plain', **written})}\n").profile == shipped(name)
    words = {language: set(own) for language, own in shipped(name).words.items()}
    assert set(LANGUAGES) <= set(words) and len(set(map(frozenset, words.values()))) == 1


def dumped(value: object) -> str:
    """Data on one line of YAML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {dumped(one)}" for key, one in value.items()) + "}"
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value)


def test_what_is_stated_goes_before_the_base_and_leaves_the_rest():
    text = (VARIANTS / f"{NAME}.yaml").read_text("utf-8")
    found = loads(
        f"{text}\nprofile: {{base: dstu, margins: {{left: 3 cm}}, page_number: внизу по центру}}\n"
    ).profile
    base = shipped("dstu")
    assert found == replace(base, margins=replace(base.margins, left=30.0), page_number="bottom centre")
    assert merged({"a": {"b": 1, "c": 2}}, {"a": {"b": 3}}) == {"a": {"b": 3, "c": 2}}


@pytest.mark.parametrize(
    ("written", "key", "said"),
    [
        ("foo", "profile", "gost, plain, dstu, kz"),
        ("{margins: {left: 80 mm, right: 60 mm}}", "profile.margins", "70 mm of the page"),
        ("{margins: {left: 90 mm}}", "profile.margins.left", "0 … 80 mm"),
        ("{text: {size: 40}}", "profile.text.size", "8 … 20"),
        ("{words: {ru: {figure: '{n.__class__} {title}'}}}", "profile.words.ru.figure", "{n}, {title} once"),
        ("{words: {ru: {continued: Продолжение}}}", "profile.words.ru.continued", "{n} once"),
        ("{words: {ru: {where: 'где {n}'}}}", "profile.words.ru.where", "no braces"),
        ("{language: de}", "profile.language", "no words of the language de"),
        ("{margin: {left: 30 mm}}", "profile.margin", "margins"),
    ],
)
def test_a_mistake_is_told_with_its_key_and_cure(written, key, said):
    text = (VARIANTS / f"{NAME}.yaml").read_text("utf-8")
    with pytest.raises(ProblemError) as told:
        loads(f"{text}\nprofile: {written}\n", "v.yaml")
    assert f": {key}: " in str(told.value) and said in str(told.value)


# --- the text


@each
@pytest.mark.parametrize("language", LANGUAGES)
def test_captions_are_written_by_their_template(name, language):
    profile = PROFILES[name]
    text = html(name, language, "course")
    for kind in ("figure", "table"):
        before, after = profile.word(kind, language).split("{n}")
        pattern = re.escape(before) + r"([\d.А-ЯA-Z]+)" + re.escape(after.replace("{title}", "")) + r"\S"
        found = [re.match(pattern, one) for one in captions(text, kind)]
        later = [
            re.escape(profile.word(one, language)).replace(r"\{n\}", r"[\d.А-ЯA-Z]+")
            for one in ("continued", "last")
        ]
        left = [one for one, match in zip(captions(text, kind), found, strict=True) if match is None]
        assert all(re.fullmatch("|".join(later), one) for one in left)
        numbers = [match[1] for match in found if match and match[1][0].isdigit()]
        assert len(numbers) > 5 and ("." in "".join(numbers)) == (not profile.numbers.through(kind))
        if profile.numbers.through(kind):
            assert numbers == [str(k + 1) for k in range(len(numbers))]


def test_the_number_goes_before_the_word_in_kazakh():
    text = note("kazakh")["note.html"].decode()
    assert captions(text, "figure")[0].startswith("1.1-сурет – ") and captions(text, "table")[0].startswith(
        "1.1-кесте – "
    )
    assert "МАЗМ" not in text and ">Мазмұны<" in text and "мұндағы" in text and "где " not in explained(text)


def explained(text: str) -> str:
    return " ".join(re.findall(r'<p class="where">(.*?)</p>', text, re.S))


@each
def test_there_is_one_dash_between_words(name):
    text = re.sub(r"<(style|svg|script).*?</\1>", "", html(name), flags=re.S)
    other = {"—": "–", "–": "—"}[PROFILES[name].dash_sign]
    assert len(re.findall(rf"\s{PROFILES[name].dash_sign}\s", text)) > 20 and not re.search(
        rf"\s{other}\s", text
    )
    body = note(name, "tex")["note.tex"].decode().partition("\\begin{document}")[2]
    other = {"—": r"(--|–)", "–": r"(---|—)"}[PROFILES[name].dash_sign]
    assert not re.search(rf"[^&\s]\s{other}\s[^&\\\s]", body)


def test_signs_of_a_word_stand_as_they_are_written():
    text = "\\end{NoteTable}\n\n\\NoteWhere где $a$"
    assert joined(text, "tex", "где", "$\\varepsilon$", "—") == text.replace("где", "$\\varepsilon$")


@pytest.mark.parametrize(
    ("fmt", "formula", "explained"),
    [
        ("html", '<p>x is {}</p>\n<p class="where"><span class="item">where x</span></p>', "<math>3</math>"),
        ("tex", "x is {}\n\n\\NoteWhere where x", "$3$"),
        ("typst", "x is {}\n\n#note-where([where ])x", '$display("3")$/*5.962*/'),
    ],
)
def test_an_explanation_goes_on_behind_a_formula_and_begins_anew_behind_words(fmt, formula, explained):
    def read(text: str) -> str:
        return (
            joined(formula.format(text), fmt, "where", "Here", "—")
            .replace("\N{WORD JOINER}", "")
            .replace("])", "")
        )

    behind = read(explained + ".")
    assert explained + "," in behind and "where x" in behind
    words = read("a word.")
    assert "a word." in words and "Here x" in words and "where x" not in words


# --- on paper


@once
def by_browser() -> dict[str, bytes]:
    with TemporaryDirectory(ignore_cleanup_errors=True) as place, browser(Path(place)) as talk:
        return {
            name: opened(talk, Path(place), name, html(name).encode(), print_it=True).pdf for name in PROFILES
        }


@cache
def printed(name: str, fmt: str) -> bytes:
    if fmt == "typst":
        return set_by_typst(note(name, "typst")["note.typst"])
    return by_browser()[name] if fmt == "html" else set_by_tex(note(name, "tex"), whole=True)[1]


@cache
def words(name: str, fmt: str) -> list[Page]:
    return pages(printed(name, fmt))


FORMATS = [(name, fmt) for fmt in ("html", "typst") for name in PROFILES] + [
    pytest.param(name, "tex", marks=pytest.mark.exhaustive) for name in PROFILES
]


@pytest.mark.parametrize(("name", "fmt"), FORMATS)
def test_the_text_stands_between_the_margins(name, fmt):
    margins = PROFILES[name].margins
    found = [own for wide, _, own in words(name, fmt)[1:] if round(wide) == 210]
    text = [
        one for own in found for one in own if margins.top <= one.above and one.below < 297 - margins.bottom
    ]
    assert len(text) > 400
    assert min(one.left for one in text) == pytest.approx(margins.left, abs=0.5)
    assert max(one.right for one in text) == pytest.approx(210 - margins.right, abs=0.7)


@pytest.mark.parametrize(("name", "fmt"), FORMATS)
def test_pages_are_numbered_where_the_profile_has_it_and_the_title_is_not(name, fmt):
    profile = PROFILES[name]
    for k, (wide, tall, own) in enumerate(words(name, fmt), 1):
        outside = [
            one
            for one in own
            if (
                one.below < profile.margins.top
                if profile.above
                else one.above > tall - profile.margins.bottom
            )
        ]
        if round(wide) != 210:
            continue
        if k == 1:
            assert not outside
            continue
        (number,) = outside
        middle = (profile.margins.left + wide - profile.margins.right) / 2
        assert number.text == str(k)
        if profile.aside:
            assert number.right == pytest.approx(wide - profile.margins.right, abs=0.6)
        else:
            assert (number.left + number.right) / 2 == pytest.approx(middle, abs=1)


@pytest.mark.parametrize(("name", "fmt"), FORMATS)
def test_a_heading_of_a_structural_part_stands_as_the_profile_has_it(name, fmt):
    profile, head = PROFILES[name], PROFILES[name].headings.structural
    title = profile.word("introduction", "ru")
    title = title.upper() if head.capitals else title
    found = [(k, one) for k, (*_, own) in enumerate(words(name, fmt)) for one in own if one.text == title]
    k, box = found[-1]
    left, right = profile.margins.left, 210 - profile.margins.right
    if head.align == "centre":
        assert (box.left + box.right) / 2 == pytest.approx((left + right) / 2, abs=1)
    else:
        assert box.left == pytest.approx(left, abs=1)
    above = [one for one in words(name, fmt)[k][2] if profile.margins.top < one.below < box.above - 1]
    assert not (head.new_page and above)


@pytest.mark.parametrize(("name", "fmt"), FORMATS)
def test_the_scale_is_true_on_paper(name, fmt):
    """The bar that the introduction says is 100 mm is measured on the printed page."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "note.pdf").write_bytes(printed(name, fmt))
        command = [
            program("pdftoppm"),
            "-r",
            "254",
            "-gray",
            "-l",
            "5",
            f"{folder}/note.pdf",
            f"{folder}/page",
        ]
        subprocess.run(command, check=True)
        lengths = [run for file in sorted(Path(folder).glob("page-*.pgm")) for run in runs(file)]
    assert any(length == pytest.approx(1000, abs=6) for length in lengths)


def runs(file: Path) -> list[int]:
    """The longest line of ink in each row of a picture of ten dots a millimetre, of rows that may have 100 mm of it."""
    _, size, _, body = file.read_bytes().split(b"\n", 3)
    wide, high = map(int, size.split())
    ink = np.frombuffer(body, np.uint8).reshape(high, wide) < 128
    ink = ink[ink.sum(axis=1) > 900]
    edges = np.diff(np.pad(ink, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    rows = [(np.flatnonzero(row > 0), np.flatnonzero(row < 0)) for row in edges if (row > 0).any()]
    return [int((ends - starts).max()) for starts, ends in rows]


def width_of(name: str) -> float:
    """Of the text of a page, mm."""
    return PROFILES[name].margins.left_of_a4[0]


@once
def by_window() -> dict[str, dict[str, Any]]:
    """Laid out for print at the profile's width."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as place, browser(Path(place)) as talk, sheet(talk):
        return {
            name: laid_out(
                talk, Path(place) / "note.html", note(name, depth="course")["note.html"], width_of(name)
            )
            for name in PROFILES
        }


@each
def test_every_picture_has_its_own_size_in_the_browser(name):
    """As wide on the page as it was drawn, and none beyond the text."""
    width, seen = width_of(name), by_window()[name]
    assert seen["text"] == pytest.approx(width * 96 / 25.4, abs=1) and seen["wide"] == []
    assert len(seen["drawn"]) > 8
    assert all(
        shown * 25.4 / 96 == pytest.approx(float(drawn.removesuffix("mm")), abs=0.1)
        for drawn, shown in seen["drawn"]
    )


def test_what_a_page_of_wide_margins_does_not_hold_stands_sideways():
    paper = Paper(ODD.margins, ODD.text)
    assert paper.width == 152 and paper.turns((160.0, 100.0)) and USUAL.fits((160.0, 100.0))
    assert paper.percent((160.0, 100.0)) == 100
    assert 'class="sideways"' in html("odd", depth="course")


def test_a_note_of_a_variant_that_states_nothing_is_of_the_standard():
    assert read(NAME).profile is None
