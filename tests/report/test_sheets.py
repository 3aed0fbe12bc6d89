"""Pictures on paper at their own size: which page or sheet holds one, where it comes, that none is reduced."""

from __future__ import annotations

import re
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markupsafe import Markup
from pdf_words import pages

from tmm_report.commands.pdf import compiled
from tmm_report.figures.drawing import Drawing, line
from tmm_report.i18n import Translator
from tmm_report.profiles import NAMES, shipped
from tmm_report.report.formats import Html, Tex
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.report.paper.rows import Kept, on_sheets, together
from tmm_report.report.paper.sheets import CAPTION, USUAL, Paper

TITLE = SimpleNamespace(topic="", student="")
SIZES = st.tuples(st.floats(1, 1200), st.floats(1, 1200))


def across(size: float, tall: float = 0.0) -> Drawing:
    """A line as long as a size, mm, over another line."""
    return Drawing((line(0, complex(size)), line(0, complex(0, tall))), margin=0.0)


@pytest.mark.parametrize(
    ("size", "name"),
    [
        ((258, 150), "a3"), ((257, 151), "a3"), ((375, 242), "a3"), ((200, 300), "a3tall"),
        ((500, 200), "a4x3"), ((500, 300), "a2"), ((300, 500), "a2tall"), ((700, 500), "a1"), ((500, 700), "a1tall"),
    ],
)  # fmt: skip
def test_the_smallest_sheet_that_holds_a_picture(size, name):
    assert USUAL.sheet_of(size).name == name and USUAL.percent(size) == 100


def test_what_the_text_holds_stands_in_it():
    assert USUAL.page == (165.0, 228.0) and USUAL.sheet_of(USUAL.page) is None and USUAL.fits(USUAL.page)
    assert USUAL.sheet_of((10.0, 229.0)) is not None and not USUAL.turns((10.0, 229.0))


@pytest.mark.parametrize("size", [(166, 10), (257, 150), (200, 100)])
def test_what_its_page_holds_sideways_has_no_sheet(size):
    assert USUAL.turns(size) and not USUAL.fits(size) and USUAL.sheet_of(size) is None


@given(SIZES)
def test_only_what_no_sheet_holds_is_reduced(size):
    sheet = USUAL.sheet_of(size)
    held = USUAL.fits(size) or USUAL.turns(size) or any(one.holds(size) for one in USUAL.sheets)
    assert (USUAL.percent(size) == 100) == held
    if not held:
        share = USUAL.percent(size) / 100
        assert size[0] * share <= sheet.field[0] and size[1] * share <= sheet.field[1] - CAPTION


@pytest.mark.parametrize("name", NAMES)
def test_the_style_of_a_note_has_the_sheets_of_its_profile(name):
    """Margins of the style and room of the pictures are found apart: they leave the same of the paper."""
    page = Page(Html(), Translator("en"), Numbering(), profile=shipped(name))
    style = template("profile.css.j2").render(page=page, frames=None)
    margins, paper = shipped(name).margins, Paper(shipped(name).margins, shipped(name).text)
    above, right, below, left = map(
        float, re.search(r"@page \{\s*margin: (\S+)mm (\S+)mm (\S+)mm (\S+)mm", style).groups()
    )
    assert (left, right, above, below) == (margins.left, margins.right, margins.top, margins.bottom)
    assert paper.page[0] == 210 - left - right and paper.page[1] < 297 - above - below
    for sheet in paper.sheets:
        size = re.search(
            rf"@page {sheet.name} \{{ size: (\d+)mm (\d+)mm; margin: (\d+)mm (\d+)mm (\d+)mm (\d+)mm", style
        )
        wide, tall, above, right, below, left = map(float, size.groups())
        assert (wide, tall) == (sheet.wide, sheet.tall) and (left, above) == sheet.corner
        assert (wide - left - right, tall - above - below) == sheet.field
        assert f".{sheet.name} {{ page: {sheet.name}; width: {sheet.field[0]:g}mm" in style
        assert (above, below) == (margins.top, margins.bottom)
    size = re.search(r"\.sideways > div \{ width: ([\d.]+)mm; height: ([\d.]+)mm", style).groups()
    assert tuple(map(float, size)) == pytest.approx((paper.sideways[0] - 1, paper.width))


# --- HTML


def figure(name: str) -> Markup:
    return Markup(f"<figure>{name}</figure>")


SHOWN = r'class="(sheet \w+|sideways|row|appendix)|<figure>(\w+)'


def test_large_drawings_stand_behind_all_and_the_text_goes_on():
    form = Html()
    assert form.placed(figure("0"), across(100)) == figure("0")
    assert form.placed(figure("1"), across(300)) == form.placed(figure("2"), across(400, 200)) == ""
    assert form.placed(figure("3"), across(100)) == figure("3") and form.due() == ""
    found = form.sheets(Markup('<h1 class="appendix">'))
    assert re.findall(SHOWN, found) == [
        ("sheet a3", ""), ("appendix", ""), ("", "1"), ("sheet a4x3", ""), ("", "2")
    ]  # fmt: skip


def test_what_stands_sideways_shares_a_page_and_keeps_the_order():
    form = Html()
    for name, size in (("0", (200, 60)), ("1", (250, 60)), ("2", (200, 60)), ("3", (100, 60))):
        assert form.placed(figure(name), across(*size)) == ""
    assert re.findall(SHOWN, form.due()) == [
        ("sideways", ""), ("", "0"), ("", "1"), ("sideways", ""), ("", "2"), ("", "3")
    ]  # fmt: skip
    assert form.placed(figure("4"), across(100)) == figure("4")


def test_the_first_drawing_leaves_room_for_the_heading():
    tall = 297 - 40 - CAPTION  # what an A3 holds
    form = Html()
    assert form.percent(across(375, tall)) == 100
    form.placed(figure("0"), across(375, tall))
    form.placed(figure("1"), across(375, tall))
    assert re.findall(SHOWN, form.sheets(Markup(""))) == [
        ("sheet a2", ""), ("", "0"), ("sheet a3", ""), ("", "1")
    ]  # fmt: skip


def test_a_sheet_takes_as_many_figures_as_it_holds():
    form = Html()
    for k in range(4):
        form.placed(figure(str(k)), across(300, 90))
    assert [sheet.count("<figure>") for sheet in form.sheets(Markup("")).split('<div class="sheet')[1:]] == [
        2,
        2,
    ]


def test_gathered_figures_stand_side_by_side_in_their_order():
    form = Html()
    form.gather()
    for wide, tall in ((70, 90), (80, 20), (60, 30), (60, 205), (20, 10)):
        assert form.placed(figure(str(wide)), across(wide, tall)) == ""
    rows = [row.split("</div></div>")[0] for row in form.due().split('<div class="row">')[1:]]
    assert [re.findall(r"<figure>(\d+)", row) for row in rows] == [["70", "80"]] and not form.gathers
    assert form.placed(figure("1"), across(100)) == figure("1")  # after the heading they stand where they are


@given(st.lists(st.tuples(st.floats(10, 257), st.floats(10, 150)), min_size=1, max_size=9))
def test_no_figure_is_lost_and_none_wider_than_its_page(sizes):
    rows = together((Kept(k, size) for k, size in enumerate(sizes)), USUAL)
    assert [one.figure for row in rows for one in row.figures] == list(range(len(sizes)))
    for row in rows:
        assert len(row.figures) == 1 or row.sideways or row.wide <= USUAL.width
        assert row.sideways or all(USUAL.fits(one.size) for one in row.figures)
        if row.sideways:
            assert sum(one.size[1] + CAPTION for one in row.figures) <= USUAL.width + 1e-9


@given(st.lists(st.tuples(st.floats(258, 800), st.floats(10, 500)), min_size=1, max_size=9))
def test_no_drawing_is_lost_and_each_is_on_a_sheet_that_holds_it(sizes):
    found = on_sheets((Kept(k, size) for k, size in enumerate(sizes)), USUAL)
    assert [one.figure for drawings in found for one in drawings.figures] == list(range(len(sizes)))
    for sheet, figures in found:
        if len(figures) > 1:
            assert sum(one.size[1] + CAPTION for one in figures) <= sheet.field[1] + 1e-9
        assert all(sheet.holds(one.size) or USUAL.percent(one.size) < 100 for one in figures)


def test_a_picture_is_drawn_at_its_size_and_never_turned():
    svg = Html().picture(across(300, 5), "figure1")
    assert 'width="300mm" height="5mm"' in svg and "rotate" not in svg
    assert Tex().picture(across(300, 5), "figure1") == "\\input{figures/figure1.tex}"


# --- LaTeX


def note(*sizes: tuple[float, float]) -> dict[str, bytes]:
    """Text with a figure of each size behind each paragraph."""
    page = Page(Tex(), Translator("en"), Numbering())
    given = {"page": page, "title": TITLE} | {
        name: getattr(page, name) for name in ("t", "math", "sym", "unit", "listed")
    }
    m = template("macros.tex.j2").make_module(given)
    body = [m.p("Text.") + m.figure(across(*size), f"of {size[0]} mm") for size in sizes]
    drawings = page.numbering.close(page.tr.letters)
    body.append(
        page.form.due()
        + page.form.sheets(m.appendix(drawings.head, on_sheet=True) if drawings else Markup(""))
    )
    text = template("report.tex.j2").render(given | {"m": m, "head": "", "body": body, "frames": None})
    return {"note.tex": page.numbering.resolved(text).encode(), **page.form.files}


def printed(files: dict[str, bytes]) -> list[tuple[float, float, list[str]]]:
    """Width and height of each page, mm, and its words."""
    found = pages(compiled(files)["note.pdf"])
    return [(round(page.wide), round(page.tall), [word.text for word in page.words]) for page in found]


@pytest.mark.exhaustive
def test_figures_of_latex_stand_side_by_side(tmp_path):
    form = Tex()
    form.gather()
    for k, size in enumerate(((60, 40), (70, 20), (160, 20))):
        made = f"figure{k}", Markup(f"No{k}"), form.picture(across(*size), f"figure{k}")
        assert form.placed(made, across(*size)) == ""
    body = form.due()
    assert body.count("begin{NoteInRow}") == 2 and body.count("begin{NoteFigure}") == 1
    given = {"page": Page(Tex(), Translator("en"), Numbering()), "title": TITLE, "head": "", "body": [body]}
    given |= {name: getattr(given["page"], name) for name in ("t", "math", "sym", "unit", "listed")}
    m = template("macros.tex.j2").make_module(given)
    text = template("report.tex.j2").render(given | {"m": m, "frames": None})
    found = printed({"note.tex": text.encode(), **form.files})
    assert [[word for word in words if word.startswith("No")] for *_, words in found if "No0" in words] == [
        ["No0", "No1", "No2"]
    ]


@pytest.mark.exhaustive
def test_drawings_of_latex_follow_the_text_and_pages_are_numbered_through():
    found = printed(note((100, 20), (250, 20), (200, 50), (400, 100), (100, 20), (300, 300)))
    assert [page[:2] for page in found] == [(210, 297), (210, 297), (210, 297), (630, 297), (594, 420)]
    assert all({page[2][0], page[2][-1]} & {str(k)} for k, page in enumerate(found, 1))
    figures = [re.findall(r"Figure ([\d.A]+)", " ".join(words)) for *_, words in found]
    assert [sorted(names) for names in figures] == [[], ["1"], ["2", "3", "4"], ["A.1"], ["A.2"]]
