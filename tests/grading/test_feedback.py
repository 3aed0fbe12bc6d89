"""The page that a student gets back: every number with its mark, causes first, no answers, nothing breaks out."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
from conftest import read, unread
from payloads import PAYLOADS

from tmm_report.commands.grade.feedback import SECTIONS, feedback
from tmm_report.commands.grade.legend import MARKS
from tmm_report.course import LEVER, OTHERS
from tmm_report.grading.model import Answered, Answers, Asked, Cause, Judged, Marked, MarkedColumn, Rule
from tmm_report.i18n import Translator
from tmm_report.problems import Message, Problem
from tmm_report.quantity.text import number
from tmm_report.results import tables

EN = Translator("en")
RIGHT = {Rule.LIMIT, Rule.FLOOR, Rule.ZERO, Rule.EXACT}


def column(
    table: str, key: str, values: Sequence[float], rules: Mapping[int, Rule], texts: Mapping[int, str] = {}
) -> MarkedColumn:
    """A column of the compressor answered with `values`; its cells are right but for `rules`, of equal worth."""
    found = next(t for t in tables(unread(read("compressor"))) if t.name == table)
    right = np.array(found[key].values, dtype=float)
    rows = tuple(map(str, found["position"].values))
    asked = Asked(table, found[key].quantity, right, rows, "kinematics", by_position=True)
    mine = np.array(values, dtype=float)
    said = tuple(texts.get(k, "" if np.isnan(x) else number(x, 4)) for k, x in enumerate(mine))
    decided = tuple(rules.get(k, Rule.LIMIT) for k in range(len(mine)))
    answered = Answered(mine, np.array([bool(text) for text in said]), said, ("",) * len(said))
    total = mine + right
    delta = 200 * (mine - right) / np.where(total == 0, 1.0, total)
    points = np.array([1.0 if rule in RIGHT | {Rule.CARRIED} else 0.0 for rule in decided])
    carried = tuple("v_BA" if rule is Rule.CARRIED else "" for rule in decided)
    judged = Judged(delta, decided)
    return MarkedColumn(asked, answered, judged, decided, carried, points, np.ones(len(mine)))


def right(table: str, key: str) -> np.ndarray:
    found = next(t for t in tables(unread(read("compressor"))) if t.name == table)
    return np.array(found[key].values, dtype=float)


def work(*columns: MarkedColumn, **changes) -> Marked:
    points = sum(float(one.points.sum()) for one in columns)
    worth = sum(float(one.worth.sum()) for one in columns)
    answered = {one.asked.name: one.answered for one in columns if one.answered is not None}
    title = {"student": "Иванов И. И.", "group": "М-21", "variant": "1", "topic": "Компрессор"}
    made = Marked(
        "ivanov", title, "ru", Answers("ivanov", answered), {c.asked.name: c for c in columns}, (), (), points, worth
    )  # fmt: skip
    return replace(made, **changes)


@pytest.fixture(scope="module")
def marked() -> Marked:
    v, a, s = right("rates_table", "v_B"), right("rates_table", "a_B"), right("outputs_table", "S_B")
    wrong, carried = v.copy(), a.copy()
    wrong[[3, 5]] = v[3] * 1.3, -v[5]
    carried[4] = a[4] * 1.2
    gap = s * 1000
    gap[2] = np.nan
    speeds = column("rates_table", "v_B", wrong, {3: Rule.OFF, 5: Rule.SIGN, 0: Rule.ZERO, 1: Rule.FLOOR})
    rates = column("rates_table", "a_B", carried, {4: Rule.CARRIED})
    way = column("outputs_table", "S_B", gap, dict.fromkeys(range(13), Rule.OFF) | {2: Rule.NO_ANSWER})
    lost = column("rates_table", "v_C", np.full(13, np.nan), dict.fromkeys(range(13), Rule.NO_ANSWER))
    left_out = replace(lost, answered=None)
    what = Message("%(column)s: millimetres given for metres", {"column": "S_B"})
    cause = Cause("mm for m", (("outputs_table", "S_B"),), what)
    made = work(speeds, rates, left_out, way)
    return replace(made, causes=(cause,), would=(made.points + 12.0,))


class Page(HTMLParser):
    """The cells of a page with their classes, its words, and all its elements."""

    def __init__(self, html: bytes):
        super().__init__()
        self.cells: list[tuple[str, str]] = []
        self.elements: list[str] = []
        self.attributes: set[str] = set()
        self._cell = False
        self.feed(html.decode())
        self.text = " ".join(re.sub(r"<style>.*?</style>|<[^>]*>", " ", html.decode(), flags=re.S).split())

    def handle_starttag(self, tag, attrs):
        self.elements.append(tag)
        self.attributes |= {name for name, _ in attrs}
        self._cell = tag == "td" or (self._cell and tag in ("b", "small"))
        if tag == "td":
            self.cells.append((dict(attrs).get("class") or "", ""))

    def handle_endtag(self, tag):
        self._cell = self._cell and tag != "td"

    def handle_data(self, data):
        if self._cell:
            self.cells[-1] = (self.cells[-1][0], self.cells[-1][1] + data)


def test_each_number_stands_as_it_was_written_with_its_mark(marked):
    cells = Page(feedback(marked, EN)).cells
    column = marked.columns["rates_table", "v_B"]
    for k, rule in enumerate(column.rules):
        kind, sign = MARKS[rule]
        assert (kind, column.answered.texts[k] + sign) in cells


def test_colour_is_never_the_only_difference():
    """Marks of different colours have different signs."""
    signs: dict[str, str] = {}
    for kind, sign in MARKS.values():
        assert signs.setdefault(sign, kind) == kind


def with_another_solution(marked: Marked) -> Marked:
    """The same answers with the same marks, but other numbers would have been right."""

    def other(one: MarkedColumn) -> MarkedColumn:
        judged = replace(one.judged, delta=one.judged.delta + 1.7)
        return replace(one, asked=replace(one.asked, values=3 * one.asked.values + 1), judged=judged)

    return replace(marked, columns={name: other(one) for name, one in marked.columns.items()})


def test_nothing_of_the_solution_is_given_away(marked):
    """The page is the same, to the byte, whatever would have been right and however far off a number is."""
    another = with_another_solution(marked)
    assert feedback(marked, EN) == feedback(another, EN)
    assert feedback(marked, EN, answers=True) != feedback(another, EN, answers=True)


def test_with_answers_the_expected_value_and_the_difference_stand_in_the_cell(marked):
    html = feedback(marked, EN, answers=True).decode()
    asked = marked.columns["rates_table", "v_B"].asked
    assert f"<small>= {number(asked.values[3], decimal='.')}</small><small>δ = 26.1 %</small>" in html


def test_causes_come_first_with_the_points_without_them(marked):
    page = Page(feedback(marked, EN))
    causes, tables = page.text.index("millimetres given for metres"), page.text.index("Marks in the tables")
    assert causes < tables
    assert f"Without this mistake: {marked.points + 12:g} of {marked.worth:g} points." in page.text
    assert "Kinematic analysis by the analytical method" in page.text[causes:tables]


def test_neither_the_factor_of_a_scale_nor_whose_variant_it_is_reaches_the_student(marked):
    for kind in ("scale", "variant"):
        what = Message("%(columns)s: secret %(detail)s", {"columns": "S_B", "detail": "1.37"})
        cause = replace(marked.causes[0], kind=kind, what=what, detail="petrov")
        given = replace(marked, causes=(cause,))
        page = feedback(given, EN).decode()
        assert "secret" not in page and "1.37" not in page and "petrov" not in page
        assert "secret 1.37" in feedback(given, EN, answers=True).decode()


def test_a_cause_that_would_bring_no_points_promises_none(marked):
    page = Page(feedback(replace(marked, would=(marked.points,)), EN))
    assert "Without this mistake" not in page.text


def test_what_no_cause_explains_is_listed_by_positions_with_the_command_to_ask(marked):
    page = Page(feedback(marked, EN))
    assert "wrong, positions: 3, 5" in page.text
    assert "tmm-report explain variant.yaml v_B 3" in page.text


def test_a_column_left_out_is_named_and_takes_no_place_in_the_tables(marked):
    html = feedback(marked, EN).decode()
    speeds = next(t for t in html.split("<section>") if "rates_table" in t)
    assert "Left out" in speeds
    assert speeds.count("<th title=") == 2


def test_carried_forward_says_from_what(marked):
    html = feedback(marked, EN).decode()
    assert "follows rightly from the own wrong value of v_BA" in html


def test_the_legend_explains_the_marks_that_occur_and_no_others(marked):
    legend = re.search(r"<dl.*?</dl>", feedback(marked, EN, limit=7.5, reading=0.5).decode(), re.S)
    assert legend is not None
    for rule in (Rule.LIMIT, Rule.FLOOR, Rule.ZERO, Rule.CARRIED, Rule.OFF, Rule.SIGN, Rule.NO_ANSWER):
        assert f">{MARKS[rule].sign}</dt>" in legend[0]
    assert MARKS[Rule.EXACT].sign not in legend[0]
    assert "7.5\N{NO-BREAK SPACE}%" in legend[0] and "0.5\N{NO-BREAK SPACE}mm" in legend[0]


def test_a_table_with_a_limit_of_its_own_says_so(marked):
    html = feedback(marked, EN, limit={"rates_table": 2.0, "outputs_table": 3.0}.__getitem__).decode()
    assert "within the limit of 3, 2\N{NO-BREAK SPACE}%" in html


def test_a_work_without_a_mistake_speaks_of_none():
    fine = work(column("rates_table", "v_B", right("rates_table", "v_B"), {}))
    page = Page(feedback(fine, EN))
    assert "What went wrong" not in page.text and "explain" not in page.text
    assert "Points: 13 of 13 (100 %)" in page.text


def test_notes_on_the_file_stand_at_the_end(marked):
    note = Problem(Message("no column %(key)s", {"key": "v_Q"}), file="ivanov.csv", line=3)
    answers = replace(marked.answers, notes=(note,))
    page = Page(feedback(replace(marked, answers=answers), EN))
    assert page.text.endswith("ivanov.csv:3: no column v_Q")


def test_hostile_text_is_text():
    """In the title, in the cells, in the notes: every element and attribute of the page is the page's own."""
    everything = " ¶ ".join(PAYLOADS.values())
    honest = work(column("rates_table", "v_B", right("rates_table", "v_B"), {3: Rule.OFF}))
    texts = dict(enumerate(PAYLOADS.values()))
    cells = column("rates_table", "v_B", right("rates_table", "v_B"), {3: Rule.OFF}, texts)
    note = Problem(Message("no column %(key)s", {"key": everything}), file=everything)
    cause = Cause("sign", (("rates_table", "v_B"),), Message("%(x)s", {"x": everything}))
    hostile = replace(
        work(cells),
        title=dict.fromkeys(("student", "group", "variant", "topic"), everything),
        answers=Answers("x", {}, notes=(note,)),
        causes=(cause,),
        would=(14.0,),
    )
    fair = replace(honest, causes=(replace(cause, what=Message("sign")),), would=(14.0,))
    one, other = Page(feedback(hostile, EN)), Page(feedback(fair, EN))
    assert set(one.elements) <= set(other.elements) | {"ul", "li"}
    assert one.attributes == other.attributes
    assert "&lt;script&gt;alert(document.cookie)&lt;/script&gt;" in feedback(hostile, EN).decode()
    assert "cycler.__init__" in one.text


def test_no_control_or_direction_character_of_a_cell_reaches_the_page():
    cells = column(
        "rates_table", "v_B", right("rates_table", "v_B"), {}, {0: "1\u202e2\x1b[31m", 1: "9" * 200}
    )
    html = feedback(work(cells), EN).decode()
    assert "\u202e" not in html and "\x1b" not in html and "9" * 50 not in html


def test_wide_tables_are_parted_into_what_a_sheet_holds():
    keys = ("v_A", "a_A", "v_B", "a_B", "v_C", "a_C", "v_D", "a_D", "v_S2", "a_S2")
    marked = work(*(column("rates_table", key, right("rates_table", key), {}) for key in keys))
    html = feedback(marked, EN).decode()
    widths = [table.count("<th title=") for table in html.split("<table>")[1:]]
    assert sum(widths) == len(keys) and max(widths) <= 7


def test_same_work_same_bytes_and_in_the_language_asked_for(marked):
    assert feedback(marked, EN) == feedback(marked, EN)
    assert 'lang="ru"' in feedback(marked, Translator("ru")).decode()


def test_every_chapter_says_where_in_the_note_it_stands():
    assert {*LEVER, *OTHERS, "initial_data", "spur", "planetary"} - set(SECTIONS) <= {"title", "readings"}
