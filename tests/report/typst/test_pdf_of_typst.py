"""The PDF that Typst's wheel makes: it says what the other notes say, may be kept, and a student's text stays text."""

from __future__ import annotations

import json
import re
import subprocess
from collections import Counter
from dataclasses import replace
from datetime import date
from functools import cache

import pytest
from conftest import solved
from exhaustive import many
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import SOME, note, program
from payloads import PAYLOADS
from typesetting import by_typst, set_by_typst

from tmm_report.chapters.title.given import Assignment, Signer, Title
from tmm_report.commands.files import for_typst
from tmm_report.report.dates import UNDATED, dated
from tmm_report.report.formats.typst import typst_escape
from tmm_report.report.paper.measure import known_letters

OWN = {
    "read": '#read("/etc/passwd")', "code": "#{panic()} ] ) ); } #eval(\"1\")", "comment": "*/ // /* x",
    "import": '#import "@preview/cetz:0.3.0"', "image": '#image("/etc/passwd")', "label": "<opening> @figure1.1",
    "mathematics": "$ x^2 $ #sym.arrow", "raw": "`raw` ```x```", "strong": "*a* _b_ ~ -- --- ... 1. = \\u{41}",
    "mark": 'tail: "" /*9.9*/ /*table*/', "string": '\\" + panic() + "',
}  # fmt: skip
BEGIN = ("007. one", "= head", "- item", "+ item", "/ a: b", "#let", "12.", "\\", "2025-01-01")


@cache
def text_of(pdf: bytes, *options: str) -> str:
    command = [program("pdftotext"), *options, "-", "-"]
    return subprocess.run(command, input=pdf, capture_output=True, check=True).stdout.decode()


def packed(text: str) -> str:
    """Without what a line may be broken at."""
    return "".join(text.replace("\N{ZERO WIDTH SPACE}", "").split())


# --- the document


def test_it_may_be_kept():
    """PDF/A-2u: said so, with its title, author and date, every face in it with its letters; a bookmark a section."""
    pdf = by_typst("compressor", "ru")
    info = subprocess.run([program("pdfinfo"), "-meta", "-"], input=pdf, capture_output=True).stdout.decode()
    assert "<pdfaid:part>2</pdfaid:part>" in info and "<pdfaid:conformance>U</pdfaid:conformance>" in info
    assert "Двухцилиндровый воздушный компрессор" in info and "Иванов И. И." in info and "2026-01-01" in info
    fonts = subprocess.run([program("pdffonts"), "-"], input=pdf, capture_output=True).stdout.decode()
    rows = [re.findall(r"\s(yes|no)(?=\s)", row) for row in fonts.splitlines()[2:]]
    assert len(rows) == 4 and all(row == ["yes"] * 3 for row in rows)


def bookmarked(head: str) -> str:
    """A heading; behind the letter of an appendix its bookmark has a stop."""
    return re.sub(r"(?<=^Приложение\w)\.", "", packed(head))


def test_every_section_has_its_bookmark_and_its_line_of_the_contents():
    pdf, html = by_typst("compressor", "ru"), note("compressor", "html", "ru")["note.html"].decode()
    marks = [bytes.fromhex(one.decode()).decode("utf-16") for one in re.findall(rb"/Title ?<(\w+)>", pdf)]
    heads = [re.sub("<[^>]+>", "", one) for one in re.findall(r"<h[12][^>]*>(.*?)</h[12]>", html)][1:]
    marks.remove("Двухцилиндровый воздушный компрессор")  # the title of the document itself
    assert sorted(bookmarked(one) for one in marks) == sorted(map(bookmarked, heads))
    text = text_of(pdf)
    first, last = text.index("СОДЕРЖАНИЕ"), text.index("ВВЕДЕНИЕ", text.index("ВВЕДЕНИЕ") + 5)
    assert all(packed(one).lower() in packed(text[first:last]).lower() for one in heads)


@pytest.mark.parametrize("name", many(SOME, 2))
def test_it_prints_every_number_of_the_other_note(name):
    """In its text, tables and formulas, each as often at least."""
    html = note(name, "html", "en")["note.html"].decode().partition("<main>")[2].partition("</main>")[0]
    html = re.sub(
        r'<svg.*?</svg>|<script.*?</script>|<template.*?</template>|<math class="again".*?</math>',
        " ",
        html,
        flags=re.S,
    )
    wanted = Counter(re.findall(r"\d+\.\d+", re.sub(r"<[^>]+>", " ", html)))
    found = Counter(re.findall(r"\d+\.\d+", text_of(by_typst(name, "en"))))
    powers = Counter(
        {word: sum(found[f"{word}{k}"] for k in range(2, 6)) for word in wanted}
    )  # read as a digit more
    missing = wanted - found - powers
    assert len(wanted) > 10 and not missing


def test_it_has_the_same_bytes_again():
    source = note("hoist_drive", "typst", "ru")["note.typst"]
    assert set_by_typst(source) == set_by_typst(source)


def test_its_date_is_that_of_the_assignment():
    results = solved("crank_rocker")
    sheet = Assignment(issued="выдано 05.09.2025 г.", due="20.12.2025")
    for assignment, year, day in ((sheet, "2024", date(2025, 9, 5)), (None, "2024", date(2024, 1, 1))):
        title = replace(results.variant.title, year=year)
        variant = replace(results.variant, title=title, assignment=assignment)
        source = for_typst(replace(results, variant=variant), "ru").decode()
        assert f"datetime(year: {day.year}, month: {day.month}, day: {day.day})" in source


def test_dates_as_they_are_written():
    assert dated("не позже", "2024-03-07") == date(2024, 3, 7) and dated("31.02.2025") == date(2025, 1, 1)
    assert dated("", "осень", "к 1 мая 2023") == date(2023, 1, 1)
    assert dated() == dated("00.00.0000", "123456") == UNDATED


@pytest.mark.parametrize("name", ["compressor", "press"])
def test_a_picture_stands_in_a_place_of_its_own_size(name):
    """Typst enlarges a picture until it covers its place, and cuts what is over."""
    source = note(name, "typst", "ru")["note.typst"].decode()
    drawn = re.findall(
        r'width=\\"([\d.]+)mm\\" height=\\"([\d.]+)mm\\".*?</svg>", "[^\n]*?", ([\d.]+)mm, ([\d.]+)mm\);',
        source,
    )
    assert len(drawn) == source.count("#note-picture(") > 5
    for sizes in drawn:
        own, place = (float(sizes[0]), float(sizes[1])), (float(sizes[2]), float(sizes[3]))
        assert place[0] / own[0] == pytest.approx(place[1] / own[1], abs=2e-4) and place[0] <= own[0] + 0.002


# --- a student's text


def test_a_students_text_is_printed_and_not_run():
    """In the title, in loads and in names of people; nothing is read, and no line begins a list or a heading."""
    results = solved("compressor")
    everything = " ¶ ".join([*PAYLOADS.values(), *OWN.values()])
    texts = {name: everything for name, text in vars(Title()).items() if isinstance(text, str)}
    title = Title(**texts, lines=BEGIN, signed=(Signer(everything, BEGIN[0]),))
    loads = results.variant.lever.loads
    forces = tuple(replace(force, name=everything) for force in loads.forces)
    lever = replace(results.variant.lever, loads=replace(loads, forces=forces))
    sheet = Assignment(data=BEGIN, issued=everything)
    own = "{% block introduction %}{% for one in title.lines %}{{ m.p(one) }}{% endfor %}{% endblock %}"
    template = own.encode(), "department.j2"
    variant = replace(results.variant, title=title, lever=lever, assignment=sheet, template=template)
    printed = packed(text_of(set_by_typst(for_typst(replace(results, variant=variant), "en"))))
    assert "root:" not in printed
    for literal in (*PAYLOADS.values(), *OWN.values(), *BEGIN):
        assert packed(literal) in printed, literal
    assert printed.count("007.one") == 4  # on the title page, in the assignment, by a signature, in the text


known = st.text(
    st.sampled_from(sorted(known_letters() - set("\u00ad")) + list("#$*_`@<>\\[]{}/~=-+.\"'") * 9)
)


@settings(deadline=None)
@given(st.lists(known, min_size=5, max_size=20))
def test_any_text_is_printed_as_it_is(texts):
    source = "\n".join(f'#metadata([#"";{typst_escape(text)}])<t>' for text in texts)
    typst = pytest.importorskip("typst")
    said = typst.query(source.encode(), "<t>", field="value", ignore_system_fonts=True)

    def plain(content):
        if "children" in content:
            return "".join(map(plain, content["children"]))
        return {"space": " "}.get(content["func"], content.get("text", ""))

    assert [" ".join(plain(one).split()) for one in json.loads(said)] == [" ".join(t.split()) for t in texts]


def test_letters_that_no_face_has_are_told_as_missing():
    """No PDF/A may have them."""
    assert typst_escape("漢字 \x00\u202e😀") == "?? ???"
