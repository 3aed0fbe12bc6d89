"""How much a note says: its pieces stand in the text, in appendices or nowhere, and what refers to them follows."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from conftest import read, solved
from notes import VARIANTS
from notes import note as whole
from spoken import LAID_OUT

from tmm_report import render
from tmm_report.chapters.title.given import Note
from tmm_report.chapters.title.pieces import DEPTHS, PIECES
from tmm_report.course import Results
from tmm_report.loading import loads
from tmm_report.problems import ProblemError
from tmm_report.report.numbering import Appendix, Numbering

TEMPLATES = Path(__file__).parents[2] / "templates" / "chapters"
NAMES = ("compressor", "cam_press", "hoist_drive", "punch_press")
NUMBERED = re.compile(
    r'<(?:figure|div)[^>]* id="(figure|table|formula)(-appendix\d+\.|-drawings\.|)([\d.]+)"'
)


@cache
def text(name: str, depth: str, language: str = "en") -> str:
    return whole(name, "html", language, depth)["note.html"].decode()


def noted(results: Results, **note) -> str:
    variant = replace(results.variant, note=Note(**note))
    return render(replace(results, variant=variant), "html", "en")["note.html"].decode()


def heads(note: str) -> list[str]:
    return [
        re.sub(r"<[^>]*>", " ", head).strip() for head in re.findall(r"<h[123][^>]*>(.*?)</h[123]>", note)
    ]


def marked(note: str) -> set[str]:
    return set(re.findall(r'data-q="([^"]+)"', note))


def test_the_templates_name_every_piece_and_no_other():
    said = "".join(path.read_text("utf-8") for path in TEMPLATES.rglob("*.j2"))
    named = {
        name for call in re.findall(r"m\.piece\((.*?)\)", said) for name in re.findall(r'"(\w[\w.]*)"', call)
    }
    assert named == set(PIECES)
    assert all((TEMPLATES.parent.parent / "tmm_report/chapters").rglob(name.split(".")[0]) for name in PIECES)


def test_the_documentation_lists_every_piece():
    docs = (TEMPLATES.parents[1] / "docs" / "variant.md").read_text("utf-8")
    for name, piece in PIECES.items():
        assert f"| `{name}` | {piece.meaning} | {piece.short} | {piece.course} |\n" in docs


@pytest.mark.parametrize("language", LAID_OUT)
@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("name", NAMES)
def test_every_link_leads_somewhere_and_nothing_is_left_of_marks(name, depth, language):
    note = text(name, depth, language)
    assert not re.search(r"later[0-9a-f]{32}", note)
    anchors = re.findall(r' id="([^"]+)"', note)
    assert len(anchors) == len(set(anchors))
    assert set(re.findall(r'href="#([^"]+)"', note)) <= set(anchors)


@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("name", NAMES)
def test_numbers_follow_one_another_in_the_text_and_in_each_appendix(name, depth):
    """Sheets stand behind the text that comes to them, but the figures keep their order."""
    found: dict[tuple[str, str], list[str]] = {}
    for kind, appendix, number in NUMBERED.findall(text(name, depth)):
        chapter = number.split(".")[0] if kind == "formula" and not appendix else ""
        found.setdefault((kind + appendix, chapter), []).append(number.split(".")[-1])
    assert found
    for numbers in found.values():
        assert numbers == [str(k) for k in range(1, len(numbers) + 1)]


@pytest.mark.parametrize("name", NAMES)
def test_a_shorter_note_says_nothing_else(name):
    short, course, full = (marked(text(name, depth)) for depth in DEPTHS)
    assert short <= full and course <= full
    apart = [
        head
        for depth in ("short", "full")
        for head in heads(text(name, depth))
        if head.startswith("Appendix")
    ]
    assert all(head.endswith("Drawings") for head in apart)


def test_the_usual_note_of_a_compressor_is_shorter_and_has_appendices():
    course, full = heads(text("compressor", "course")), heads(text("compressor", "full"))
    assert [head for head in course if head.startswith("Appendix")]
    assert "List of symbols" in full and "List of symbols" not in course
    assert sum("Velocity polygon" in head for head in full) > sum(
        "Velocity polygon" in head for head in course
    )


def test_a_piece_goes_where_it_is_told_to():
    results = solved("crank_rocker")
    title = "Analogues of velocities and accelerations"

    def places(**note) -> list[str]:
        return [
            head.removesuffix(title).strip() for head in heads(noted(results, **note)) if head.endswith(title)
        ]

    assert places(depth="course") == ["A.2"]
    assert places(depth="course", omit=("kinematics.analogues",)) == []
    assert places(depth="short", body=("kinematics",)) == places(depth="full") != []
    assert places(depth="full", appendix=("kinematics.analogues",)) == ["A.1"]
    kept = places(depth="full", appendix=("kinematics",), body=("kinematics.analogues",))
    assert len(kept) == 1 and not kept[0].startswith("A")


@pytest.mark.parametrize(("note", "count"), [
    ({}, 1), ({"plans": 2}, 2), ({"plans": 30}, 2), ({"depth": "full"}, 2), ({"depth": "full", "plans": 1}, 1),
    ({"depth": "short", "plans": 2}, 2), ({"plans": 1, "body": ("plans.others",)}, 2),
])  # fmt: skip
def test_as_many_positions_have_their_plans_worked_out_as_is_said(note, count):
    results = solved("crank_rocker")
    found = [head for head in heads(noted(results, **note)) if "Velocity polygon" in head]
    assert len(found) == count and any(head.endswith(f"position {results.lever.sample}") for head in found)


def test_the_other_positions_are_compared_in_tables_alone():
    results = solved("crank_rocker")
    told = re.compile("Comparison of the methods, (position .*?)</p>")
    captions = {depth: " ".join(told.findall(text("crank_rocker", depth))) for depth in DEPTHS}
    assert {depth: found.count("position ") for depth, found in captions.items()} == {
        "short": 1,
        "course": len(results.lever.plans.drawn),
        "full": len(results.lever.plans.drawn),
    }


@pytest.mark.parametrize("name", ["crank_rocker", "compressor"])
def test_positions_that_share_a_table_stand_on_the_sides_that_its_caption_tells(name):
    results = solved(name)
    one, other = (drawn.position for drawn in results.lever.plans.drawn[:2])
    note = noted(replace(results, lever=replace(results.lever, readings=None)), depth="course")
    head = f"Comparison of the methods, position {one} (left) and position {other} (right)"
    assert note.count(head) == 1
    table = note[note.index(head) : note.index("</table>", note.index(head))]
    rows = [re.findall(r'<td[^>]*data-k="(\d+)"', row) for row in table.split("<tr>")[2:]]
    assert len(rows) > 9 and {len(row) for row in rows} == {
        6,
        8,
    }  # some have a segment, which is read off a plan
    assert all(row == sorted(row, key=[str(one), str(other)].index) for row in rows)
    assert all(row.count(str(one)) == row.count(str(other)) for row in rows)


def test_an_appendix_of_nothing_is_none():
    """A scotch yoke has no link whose angles a table could give."""
    note = noted(solved("scotch_yoke"), depth="full", appendix=("kinematics.angles",))
    assert not [head for head in heads(note) if "Appendix" in head]


def test_headings_keep_their_ranks_in_an_appendix():
    """A piece cut out of a section begins as one; what stood beside its heading stands beside it there, too."""
    numbering = Numbering()
    numbering.section("Gears")
    numbering.section("A pair", 2)
    appendix = Appendix.of("A", "appendix1", "Gears")
    with numbering.within(appendix):
        numbers = [numbering.section("one", 3), numbering.section("its part", 4), numbering.section("two", 3)]
    with numbering.within(appendix):
        numbers += [numbering.section("three", 2), numbering.section("its part", 3)]
    assert [place.number for place in numbers] == ["A.1", "A.1.1", "A.2", "A.3", "A.3.1"]
    assert numbering.section("Another pair", 2).number == "1.2"


def test_letters_are_listed_where_it_is_asked():
    results = solved("crank_rocker")
    assert "List of symbols" in heads(noted(results, depth="short", symbols="list"))
    assert "List of symbols" not in heads(noted(results, depth="full", symbols="where"))


def test_the_text_does_not_rely_on_what_an_appendix_explains():
    """Letters are explained in the text as if there were no appendices."""
    results = solved("compressor")
    apart = tuple(name for name, piece in PIECES.items() if piece.course == "appendix")

    def explained(note: str) -> list[str]:
        body = note.split('<h1 class="appendix"')[0]
        return re.findall(r'<p class="where">(.*?)</p>', body, re.S)

    with_them, without = noted(results, depth="course"), noted(results, depth="course", omit=apart)
    assert explained(with_them) == explained(without)
    assert len(re.findall(r'<p class="where">', with_them)) > len(explained(with_them))


WRONG = {
    "no such piece": (
        "omit: [kinematics.analogs]",
        "the note has no piece kinematics.analogs",
        "kinematics.analogues",
    ),
    "no such chapter": ("appendix: [dragons]", "the note has no piece dragons", "kinematics"),
    "in two places": ("{body: [balancing], omit: [balancing]}", "to stand in two places", "once"),
    "no such depth": ("depth: deep", "", "course"),
    "no plan": ("plans: 0", "", ""),
    "plans by a word": ("plans: all", "", ""),
}


@pytest.mark.parametrize("slip", WRONG)
def test_slips(slip):
    written, wrong, right = WRONG[slip]
    block = f"note: {written}" if written.startswith("{") else f"note: {{{written}}}"
    with pytest.raises(ProblemError) as error:
        loads((VARIANTS / "crank_rocker.yaml").read_text("utf-8") + f"\n{block}\n")
    (problem,) = error.value.problems
    assert wrong in str(problem.wrong) and right in str(problem.right)
    assert problem.path[0] == "note"


def test_what_a_variant_states_is_read():
    assert read("compressor").note == Note()
    more = "\nnote: {depth: short, body: [plans], omit: [spur.contour], symbols: list}\n"
    found = loads((VARIANTS / "crank_rocker.yaml").read_text("utf-8") + more).note
    assert found == Note("short", ("plans",), (), ("spur.contour",), "list")
    assert found.stand("plans.others") == "body" and found.stand("spur.contour") == "omit"
