"""The note: escaping, numbering, references, tables that fit, names of links, both languages."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import astuple, replace
from functools import cache
from html import unescape

import pytest
from conftest import solved as results
from exhaustive import many
from jinja2 import Template
from markupsafe import Markup
from notes import NAMES, note, static

from tmm_report.chapters.lever.structure.naming import link_name
from tmm_report.i18n import Translator
from tmm_report.note import render
from tmm_report.report.formats import Html, Tex, tex_escape
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, environment
from tmm_report.report.paper.layout import Column, Part, folded, numeric, worded
from tmm_report.report.paper.lines import pieces
from tmm_report.report.paper.sheets import USUAL
from tmm_report.report.sources import SOURCES

HOSTILE = '</p><script>alert(1)</script> \\input{/etc/passwd} {{ 7*7 }} {% raw %} 100% & $x^2$ #1 a_b ~ "q"'


@cache
def html(name: str, language: str = "ru") -> str:
    return note(name, "html", language)["note.html"].decode()


@cache
def tex(name: str, language: str = "ru") -> str:
    return note(name, "tex", language)["note.tex"].decode()


def page(form=Html, language="en") -> Page:
    return Page(form(), Translator(language), Numbering())


def prose(text: str) -> str:
    """The words of an HTML note, without mathematics, drawings and style."""
    text = re.sub(
        r"<style.*?</style>|<math.*?</math>|<svg.*?</svg>|<script.*?</script>", " ", text, flags=re.S
    )
    return unescape(re.sub(r"<[^>]+>", " ", text.replace("<wbr/>", "")))


# --- escaping ---


@cache
def hostile(fmt: str) -> str:
    found = results("crank_rocker")
    title = replace(found.variant.title, topic=HOSTILE, student=HOSTILE, city=HOSTILE)
    return render(replace(found, variant=replace(found.variant, title=title)), fmt, Translator("ru"))[
        f"note.{fmt}"
    ].decode()


@pytest.mark.exhaustive
def test_user_text_stays_text_in_html():
    text = static(hostile("html"))
    assert "<script" not in text and "&lt;script&gt;" in text
    assert "{{ 7*7 }}" in text and "\\input{/etc/passwd}" in text


@pytest.mark.exhaustive
def test_user_text_stays_text_in_latex():
    text = hostile("tex")
    escaped = r"\textbackslash{}input\{/etc/passwd\} \{\{ 7*7 \}\} \{\% raw \%\} 100\% \& "
    escaped += r"\$x\textasciicircum{}2\$ \#1 a\_b"
    assert text.count(escaped) >= 3 and "\\input{/etc" not in text and "&lt;" not in text


@pytest.mark.parametrize(("form", "shown"), [(Html, "a &amp; 5% <b>x</b>"), (Tex, "a \\& 5\\% <b>x</b>")])
def test_message_is_escaped_and_only_markup_is_trusted(form, shown):
    assert page(form).t("%(name)s & 5%% %(mark)s", name="a", mark=Markup("<b>x</b>")) == shown


def test_value_with_a_percent_sign_is_not_a_format():
    assert page().t("%(a)s", a="%(b)s") == "%(b)s"


@pytest.mark.parametrize(("form", "shown"), [(Html, "a&amp;b"), (Tex, "a\\&b")])
def test_literal_in_a_template_is_escaped_for_its_format(form, shown):
    assert environment().from_string('{{ "a&b" }}').render(page=page(form)) == shown


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("−5 м/с²", "$-$5 м/с$^{2}$"),
        ("1,5·10⁻⁵", "1,5$\\cdot$10$^{-5}$"),
        ("II₂", "II$_{2}$"),
        ("ω", "$\\omega$"),
        ("日", "?"),
    ],
)
def test_signs_that_latex_sets_in_math_mode(text, shown):
    assert tex_escape(text) == shown


# --- numbering ---


def test_sections_and_formulas_are_numbered_by_chapter():
    numbers = Numbering()
    places = [numbers.section("A"), numbers.section("B", 2), numbers.take("formula"), numbers.section("C", 2)]
    places += [
        numbers.section("D", 3),
        numbers.section("E"),
        numbers.take("formula"),
        numbers.section("F", 2),
    ]
    assert [place.number for place in places] == ["1", "1.1", "1.1", "1.2", "1.2.1", "2", "2.1", "2.1"]


def test_forward_reference_is_put_in_at_the_end():
    numbers = Numbering()
    later = numbers.place("fig:x")
    assert numbers.place("fig:x") == later and numbers.place("fig:y") != later
    place, other = numbers.take("figure", "fig:x"), numbers.unnumbered("References", "sec:fig:y")
    assert numbers.place("fig:x") == place
    text = f"<a href='#{later.anchor}'>{later.number}</a> {numbers.place('sec:fig:y').anchor}"
    numbers.places["fig:y"] = other
    assert numbers.resolved(text) == f"<a href='#{place.anchor}'>{place.number}</a> {other.anchor}"


def test_reference_to_what_never_comes_is_a_mistake():
    numbers = Numbering()
    numbers.place("fig:x")
    with pytest.raises(ValueError, match=r"not in the note: \['fig:x'\]"):
        numbers.resolved("")


@pytest.mark.parametrize("form", [Html, Tex])
def test_mark_of_a_forward_reference_passes_every_format_and_cannot_be_guessed(form):
    first, second = Numbering().place("fig:x"), Numbering().place("fig:x")
    assert first != second and len(first.number) > 32
    for mark in first:
        assert page(form).text(mark) == mark


def test_templates_are_rendered_once(monkeypatch):
    rendered = Counter()
    render_template = Template.render

    def counted(self, *args, **given):
        rendered[self.name] += 1
        return render_template(self, *args, **given)

    monkeypatch.setattr(Template, "render", counted)
    render(results("crank_rocker"), "html", Translator("ru"))
    assert rendered["chapters/lever/kinematics.j2"] == 1 and set(rendered.values()) == {1}


def test_two_things_with_one_label_are_a_mistake():
    numbers = Numbering()
    numbers.take("figure", "x")
    with pytest.raises(ValueError, match="labelled 'x'"):
        numbers.take("table", "x")


def test_symbol_is_explained_once():
    numbers = Numbering()
    items = [
        {"id": "a", "symbol": "a", "meaning": "arm"},
        {"id": "b", "symbol": "b", "meaning": "width"},
        {"id": "a", "symbol": "a", "meaning": "arm"},
        {"id": "arm of a lever", "symbol": "a", "meaning": "arm"},
        {"id": "a of a body", "symbol": "a", "meaning": "acceleration"},
    ]
    assert [item["id"] for item in numbers.fresh(items)] == ["a", "b", "a of a body"]
    assert numbers.fresh(items) == []


@pytest.mark.exhaustive
def test_both_formats_have_the_same_numbers():
    for kind in (
        r"Рисунок (\d+)",
        r"Таблица (\d+)",
    ):  # sheets stand among the tables where their page is full
        assert re.findall(kind, html("shaper")) == re.findall(kind, tex("shaper"))
    assert re.findall(r'class="number">\(([\d.]+)\)', html("shaper")) == re.findall(
        r"\\NoteFormula\{[^}]+\}\{([^}]+)\}", tex("shaper")
    )


# --- tables and formulas that fit ---


@pytest.mark.parametrize("count", [1, 7, 8, 13, 40])
def test_wide_table_is_cut_and_loses_nothing(count):
    columns = [Column(f"c{k}", ["−1234,5", "0"]) for k in range(count)]
    parts = numeric("x", Column("n", ["0", "1"]), columns).parts
    assert [head for part in parts for head in part.head if head != "n"] == [c.head for c in columns]
    assert all(part.head[0] == "n" and sum(part.shares) <= 1 for part in parts)
    assert all(share * USUAL.width > 1.86 * 7 for part in parts for share in part.shares[1:])


def test_table_of_words_is_as_wide_as_the_page_and_breaks_no_head():
    (part,) = worded("x", ["Обозначение", "b"], [["1", "2"]], (1, 20)).parts
    assert sum(part.shares) == pytest.approx(1) and part.shares[0] * USUAL.width > 11 * 2


def test_latex_formula_is_cut_only_outside_brackets():
    assert pieces(r"a=\frac{b +c}{d} +e -\left(f =g\right) =\{ +h") == [
        r"a=\frac{b +c}{d}", "+e", r"-\left(f =g\right)", r"=\{", "+h",
    ]  # fmt: skip


# --- words ---

LINKS = {
    "compressor": ["crank", "connecting rod", "slider", "connecting rod", "slider"],
    "crank_rocker": ["crank", "connecting rod", "rocker"],
    "shaper": ["crank", "block of the slotted link", "slotted link", "connecting rod", "slider"],
    "slider_crank_offset": ["crank", "connecting rod", "slider"],
    "scotch_yoke": ["crank", "block of the slotted link", "translating slotted link"],
}


@pytest.mark.parametrize("name", LINKS)
def test_links_are_named_by_their_motion(name):
    lever = results(name).lever
    links = lever.given.mechanism.moving
    assert [link_name(lever.structure, lever.kinematics.diagram, link).name for link in links] == LINKS[name]


def test_conclusions_have_the_actual_figures():
    text = prose(html("compressor"))
    found = results("compressor")
    low, high = found.lever.kinetostatics.extremes
    for value in (low.value, high.value):
        assert page(language="ru").num(value) in text.split("Заключение")[-1]
    assert "I(0,1) → II₂(2,3) → II₂(4,5)" in text.split("Заключение")[-1]


def own_words(name: str) -> list[str]:
    """Texts of the variant's author: the title page and the names of the loads, the longest first."""
    variant = results(name).variant
    loads = (
        (*variant.lever.loads.forces, *variant.lever.loads.moments)
        if variant.lever and variant.lever.loads
        else ()
    )
    texts = [text for text in astuple(variant.title) if isinstance(text, str)]
    own = {*texts, *(load.name for load in loads)}
    if (found := results(name).find) is not None:  # what is sought is named by its keys in the file
        own.update(one.name for one in found.given.unknowns)
    return sorted(own - {""}, key=len, reverse=True)


@pytest.mark.parametrize("name", NAMES)
def test_russian_note_has_no_english_words(name):
    text = prose(html(name))
    for source in ("freudenstein", "berkof"):  # stay as they were published
        printed = Translator("ru").gettext(SOURCES[source]).replace(" – ", " — ")  # the dash of the profile
        text = text.replace(printed, " ")
    for own in own_words(name):
        text = text.replace(own, " ")
    assert set(re.findall(r"[A-Za-z]{4,}", text)) <= {"RRRR", "VIII", "LSODA"}


LESS = {
    "no friction": {"friction": None},
    "no forces": {"kinetostatics": None, "force_plans": None, "friction": None},
    "no plans": {"plans": replace(results("shaper").lever.plans, drawn=(), singular=(0, 6))},
    "no force plans": {"force_plans": replace(results("shaper").lever.force_plans, drawn=())},
}


@pytest.mark.exhaustive
@pytest.mark.parametrize("fmt", ["html", "tex"])
@pytest.mark.parametrize("less", many(LESS, 2))
def test_what_was_not_solved_is_left_out(less, fmt):
    found = results("shaper")
    whole = len(re.findall(r"Таблица \d+ ", note("shaper", fmt, "ru")[f"note.{fmt}"].decode()))
    text = render(replace(found, lever=replace(found.lever, **LESS[less])), fmt, Translator("ru"))[
        f"note.{fmt}"
    ].decode()
    assert "Заключение" in text and len(re.findall(r"Таблица \d+ ", text)) < whole


@pytest.mark.exhaustive
@pytest.mark.parametrize("fmt", ["html", "tex"])
def test_same_results_give_the_same_bytes(fmt):
    assert render(results("shaper"), fmt, Translator("ru"), "full") == note("shaper", fmt, "ru")


def test_what_several_chapters_ask_for_is_made_once_a_note():
    shown = page()
    first = shown.once(list, "ab")
    assert first is shown.once(list, "ab") and first == ["a", "b"]
    assert shown.once(list, "cd") == ["c", "d"] and page().once(list, "ab") is not first


@pytest.mark.parametrize("count", [10, 13, 24])
def test_a_tall_narrow_table_stands_in_halves(count):
    rows = [[str(k), f"F{k}"] for k in range(count)]
    part = folded(Part(["k", "F"], rows, [0.1, 0.2]))
    assert part.head == ["k", "F", "k", "F"] and len(part.shares) == 4
    halves = [row[:2] for row in part.rows], [row[2:] for row in part.rows]
    assert [row for half in halves for row in half if row[0]] == rows
    assert len(part.rows) == -(-count // 2)


@pytest.mark.parametrize(("count", "share"), [(9, 0.1), (12, 0.25)])
def test_a_short_or_wide_table_stands_whole(count, share):
    part = Part(["k", "F"], [["", ""]] * count, [share, share])
    assert folded(part) is part
