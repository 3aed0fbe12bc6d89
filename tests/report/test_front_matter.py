"""What stands before and behind the chapters: list of symbols, introduction, conclusions, references."""

from __future__ import annotations

import re

import pytest
from markupsafe import Markup
from notes import VARIANTS
from notes import note as note_of

from tmm_report import render, solve
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.problems import Message
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.text import number
from tmm_report.report import _conclusions
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, joined, numeric, worded
from tmm_report.report.part import Failed, Part
from tmm_report.report.symbol_list import SymbolList


def page() -> Page:
    return Page(Html(), Translator("en"), Numbering())


def words(markup) -> str:
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", markup)).strip()


# --- list of symbols ---


def velocity(point: str) -> tuple[Symbol, Message, str]:
    return Symbol("v", point), Message("velocity of point %(of)s", {"of": point}), "m/s"


def lines(*symbols) -> list[tuple[str, str]]:
    gathered = SymbolList()
    for one in symbols:
        gathered.add(*one)
    return [(words(line.symbols), words(line.meaning)) for line in gathered.lines(page())]


def test_points_of_one_meaning_are_one_line():
    assert lines(velocity("A"), velocity("B"), velocity("A")) == [("v A , v B", "velocity of point A, B")]


def test_of_many_points_the_first_and_the_last_are_named():
    assert lines(*map(velocity, "ABCDE")) == [("v A , v B , …, v E", "velocity of point i")]


def test_where_two_names_differ_letters_stand_for_them():
    reactions = [
        (Symbol("R", i + j), Message("reaction of link %(a)s on link %(b)s", {"a": i, "b": j}), "N")
        for i, j in ("01", "12", "23")
    ]
    assert lines(*reactions) == [("R 01 , R 12 , R 23", "reaction of link i on link j")]


def test_signs_of_a_line_stand_as_in_an_index_whatever_comes_first_in_the_note():
    masses = [(Symbol("m", k), Message("mass of link %(of)s", {"of": k}), "kg") for k in ("10", "2", "1")]
    assert lines(*masses) == [("m 1 , m 2 , m 10", "mass of link 1, 2, 10")]


def test_latin_letters_stand_before_greek_ones():
    plain = [(Symbol(base), Message(base), "") for base in ("omega", "v", "alpha", "M", "a")]
    assert [symbol for symbol, _ in lines(*plain)] == ["a", "M", "v", "α", "ω"]


def test_a_fuller_wording_stands_for_the_shorter_one():
    diameter = Symbol("d", "a")
    found = lines(
        (diameter, Markup("tip diameter"), "m"), (diameter, Message("tip diameter of wheel 1"), "m")
    )
    assert found == [("d a", "tip diameter of wheel 1")]


def test_a_letter_with_two_meanings_stands_once_with_the_sections_that_mean_it():
    gathered = SymbolList()
    gathered.add(Symbol("m"), Message("module"), "mm", "9.2")
    gathered.add(Symbol("m"), Message("mass of the flywheel"), "kg", "7")
    gathered.add(Symbol("m", "2"), Message("mass of link %(of)s", {"of": "2"}), "kg", "1")
    found = [(words(line.symbols), words(line.meaning), line.unit) for line in gathered.lines(page())]
    assert found == [
        ("m", "module, mm (section 9.2); mass of the flywheel, kg (section 7)", ""),
        ("m 2", "mass of link 2", "kg"),
    ]


def test_what_is_said_more_closely_of_a_thing_is_the_thing():
    moment = Message("balancing moment")
    other = Message("%(of)s by the power balance", {"of": moment})
    assert lines((Symbol("M"), moment, "N·m"), (Symbol("M"), other, "N·m")) == [("M", "balancing moment")]


def test_names_in_words_stand_each_in_a_line():
    def force(at, name):
        return Symbol("P", at), Message("force on point %(at)s: %(name)s", {"at": at, "name": name}), "N"

    assert lines(force("B", "gas pressure"), force("D", "feed force")) == [
        ("P B", "force on point B: gas pressure"),
        ("P D", "force on point D: feed force"),
    ]


def test_primes_of_a_greek_letter_leave_it_among_the_greek_ones():
    plain = [(Symbol(base), Message(base), "") for base in ("psi′", "omega", "rho", "x")]
    assert [words(symbol)[0] for symbol, _ in lines(*plain)] == ["x", "ρ", "ψ", "ω"]


def test_segments_name_themselves():
    assert lines((Symbol("pb", kind="segment"), Message("length of a vector"), "mm")) == []


# --- the note as a whole ---


@pytest.fixture(scope="module")
def note() -> str:
    return note_of("rotor", "html")["note.html"].decode()


def test_what_stands_in_front_comes_before_the_chapters(note):
    heads = [words(head) for head in re.findall(r"<h1[^>]*>(.*?)</h1>", note, re.DOTALL)]
    assert heads[:3] == ["Содержание", "Перечень обозначений", "Введение"]
    assert heads[-2:] == ["Заключение", "Список использованных источников"]
    contents = [words(line) for line in re.findall(r'<p class="level1">(.*?)</p>', note)]
    assert contents == heads[1:]


def test_every_source_is_cited_and_every_citation_has_its_source(note):
    cited = {int(n) for n in re.findall(r'href="#source(\d+)"', note)}
    listed = {int(n) for n in re.findall(r'id="source(\d+)"', note)}
    assert cited == listed and listed == set(range(1, len(listed) + 1))


def test_sources_are_numbered_as_they_are_first_cited(note):
    seen = list(dict.fromkeys(int(n) for n in re.findall(r'href="#source(\d+)"', note)))
    assert seen == sorted(seen)


@pytest.mark.parametrize("name", ["rotor", "crank_rocker"])
def test_the_introduction_names_the_chapters(name):
    """A note of one chapter has no list of one."""
    note = note_of(name, "html")["note.html"].decode()
    introduction = note[note.index('id="section-introduction"') :].partition("<h1")[0]
    listed = [words(item).rstrip(".;") for item in re.findall(r"<li>(.*?)</li>", introduction)]
    chapters = [words(h) for h in re.findall(r"<h1[^>]*>(.*?)</h1>", note) if re.match(r"\s*\d", words(h))]
    told = [f"«{title}» (раздел {n})" for n, title in (c.split(" ", 1) for c in chapters)]
    assert listed == (told if len(told) > 1 else [])


def test_what_failed_comes_first_in_the_conclusions():
    def view(*said: str) -> object:
        return type("View", (), {"conclusions": lambda self: list(said)})()

    parts = [Part("a", view(Markup("found"))), Part("b", view(Failed("failed"), Markup("found too")))]
    assert _conclusions(parts) == ["failed", "found", "found too"]


# --- tables ---


def cell(text: str, full: str, key: str = "h") -> Cell:
    return Cell(text, Ref(key, 0, "arms"), full, lambda n: number(float(text), 5, ".", n, keep_zeros=True))


def column_of(table, number: int) -> list[str]:
    return [row[number] for row in table.parts[0].rows]


def test_zeros_at_the_end_stand_under_longer_decimals():
    rows = [["R", cell("27.4", "27.400")], ["P", cell("74.92", "74.920")], ["G", cell("5", "5.0000")]]
    assert column_of(worded("arms", ["force", "arm"], rows, [1, 1]), 1) == ["27.40", "74.92", "5.00"]


def test_decimals_are_those_of_the_largest():
    rows = [["R", cell("27.418", "27.418")], ["P", cell("274.92", "274.92")], ["G", cell("5.1234", "5.1234")]]
    assert column_of(worded("arms", ["force", "arm"], rows, [1, 1]), 1) == ["27.42", "274.92", "5.12"]


def test_noughts_are_told_below_the_table():
    columns = [Column("v, m/s", ["0", "0"], "v"), Column("a, m/s²", ["0", "1"], "a"), Column("n", ["0", "0"])]
    table = numeric("rates", Column("k", ["0", "1"]), columns)
    assert (list(table.parts[0].head), table.nought) == (["k", "a, m/s²", "n"], ["v"])
    assert not numeric("rates", Column("k", ["0", "1"]), columns[:1]).nought


def test_noughts_are_told_of_joined_rows_too():
    columns = [Column("v, m/s", ["0"] * 4, "v"), Column("a, m/s²", ["1", "1", "1", "2"], "a")]
    table = numeric("rates", *joined(Column("k", ["0", "1", "2", "3"]), columns))
    assert (list(table.parts[0].head), column_of(table, 0), table.nought) == (
        ["k", "a, m/s²"],
        ["0–2", "3"],
        ["v"],
    )


def test_no_digit_is_added_that_was_not_computed():
    rows = [["R", cell("1234.5", "1234.5")], ["P", cell("0.12345", "0.12345")]]
    assert column_of(worded("arms", ["force", "arm"], rows, [1, 1]), 1) == ["1234.5", "0.12345"]


def test_different_quantities_keep_their_own_decimals():
    rows = [["m", cell("1.5", "1.5000", "m")], ["J", cell("0.0135", "0.013500", "J")]]
    assert column_of(worded("given", ["what", "value"], rows, [1, 1]), 1) == ["1.5", "0.0135"]


def test_a_column_of_dashes_is_left_out():
    rows = [["A", "—", "1"], ["B", "—", "—"]]
    table = worded("points", ["point", "x", "y"], rows, [1, 1, 1])
    assert list(table.parts[0].head) == ["point", "y"]
    columns = [Column("v", ["—", "—"]), Column("a", ["1", "—"])]
    assert list(numeric("rates", Column("k", ["0", "1"]), columns).parts[0].head) == ["k", "a"]


# --- title page and assignment sheet

FRONT = """
title:
  ministry: Министерство
  institution: Университет
  department: Кафедра ТММ
  lines: [Факультет, 2 курс]
  topic: Рычажный механизм
  designation: ТММ.05.12.000 ПЗ
  group: 21.10
  student: Иванов И. И.
  teacher: Петров П. П.
  signed: [{role: Нормоконтроль, name: Сидоров С. С.}]
  city: Самара
  year: 2026
assignment:
  approved: {role: Зав. кафедрой, name: Орлов О. О.}
  due: 01.10
  data: [длины звеньев]
  sheets: ["планы скоростей"]
"""
SAID = (
    "Министерство", "Университет", "Кафедра ТММ", "Факультет", "2 курс", "Пояснительная записка", "Рычажный механизм",
    "ТММ.05.12.000 ПЗ", "Студент группы 21.10", "Иванов И. И.", "Руководитель", "Петров П. П.", "Нормоконтроль",
    "Сидоров С. С.", "Самара 2026", "Задание на курсовой проект", "Утверждаю: Зав. кафедрой", "Орлов О. О.",
    "длины звеньев", "планы скоростей", "Срок сдачи: 01.10", "Петров П. П.", "Иванов И. И.", "Содержание",
)  # fmt: skip


@pytest.mark.parametrize("fmt", ["html", "tex"])
def test_title_page_and_assignment_sheet_say_what_is_stated_in_their_order(fmt):
    text = re.sub(r"title:\n(?:  .*\n)+", FRONT, (VARIANTS / "rotor.yaml").read_text("utf-8"))
    files = render(solve(loads(text)), fmt)
    note = files[f"note.{fmt}"].decode().partition("<body>" if fmt == "html" else "\\begin{document}")[2]
    at = 0
    for said in SAID:
        assert said in note[at:], said
        at = note.index(said, at)
    assert "Задание" not in note[at:]  # the contents do not list it


def test_without_an_assignment_there_is_no_sheet(note):
    assert "Задание на" not in note and 'class="front"' not in note
