"""Pictures on paper at their own size: which sheet holds one, where it comes, that nothing is turned or reduced."""

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
from tmm_report.report.paper.rows import Kept, laid
from tmm_report.report.paper.sheets import CAPTION, USUAL, Paper

TITLE = SimpleNamespace(topic="", student="")
SIZES = st.tuples(st.floats(1, 1200), st.floats(1, 1200))


def across(size: float, tall: float = 0.0) -> Drawing:
    """A line as long as a size, mm, over another line."""
    return Drawing((line(0, complex(size)), line(0, complex(0, tall))), margin=0.0)


@pytest.mark.parametrize(
    ("size", "name"),
    [
        ((166, 100), "a4"), ((261, 150), "a4"), ((261, 151), "a3"), ((375, 242), "a3"), ((200, 300), "a3tall"),
        ((500, 200), "a4x3"), ((500, 300), "a2"), ((300, 500), "a2tall"), ((700, 500), "a1"), ((500, 700), "a1tall"),
    ],
)  # fmt: skip
def test_the_smallest_sheet_that_holds_a_picture(size, name):
    assert USUAL.sheet_of(size).name == name and USUAL.percent(size) == 100


def test_what_the_text_holds_stands_in_it():
    assert USUAL.page == (165.0, 228.0) and USUAL.sheet_of(USUAL.page) is None and USUAL.fits(USUAL.page)
    assert USUAL.sheet_of((10.0, 229.0)) is not None


@given(SIZES)
def test_only_what_no_sheet_holds_is_reduced(size):
    sheet = USUAL.sheet_of(size)
    held = USUAL.fits(size) or any(one.holds(size) for one in USUAL.sheets)
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
        turned = sheet.name == "a4"
        assert (above, below) == ((margins.left, margins.right) if turned else (margins.top, margins.bottom))


# --- HTML


def figure(name: str) -> Markup:
    return Markup(f"<figure>{name}</figure>")


def test_figures_wait_behind_sheets_and_keep_the_order():
    form = Html()
    assert form.placed(figure("0"), across(100)) == figure("0")  # nothing waits
    assert form.placed(figure("1"), across(200)) == form.placed(figure("2"), across(400)) == ""
    assert form.placed(figure("3"), across(100)) == ""  # the text goes on
    assert re.findall(r'sheet (\w+)|<figure>(\d)', form.due()) == [
        ("a4", ""), ("", "1"), ("a4x3", ""), ("", "2"), ("", "3")
    ]  # fmt: skip
    assert form.due() == ""


def test_a_sheet_takes_as_many_figures_as_it_holds():
    form = Html()
    for k, tall in enumerate((60, 60, 60)):
        form.placed(figure(str(k)), across(200, tall))
    assert [sheet.count("<figure>") for sheet in form.due().split('<div class="sheet')[1:]] == [2, 1]


def test_a_figure_that_the_text_holds_shares_a_sheet():
    form = Html()
    for size in ((200, 60), (100, 60), (100, 60)):
        form.placed(figure(str(size)), across(*size))
    first, second = form.due().split("</div>")[:2]
    assert first.startswith('<div class="sheet a4">') and first.count("<figure>") == 2
    assert second.strip().startswith("<figure>")  # what the sheet does not hold stands in the text


def test_gathered_figures_stand_side_by_side_in_their_order():
    form = Html()
    form.gather()
    for wide, tall in ((70, 90), (80, 20), (60, 30), (60, 205), (20, 10)):
        assert form.placed(figure(str(wide)), across(wide, tall)) == ""
    rows = [row.split("</div></div>")[0] for row in form.due().split('<div class="row">')[1:]]
    assert [re.findall(r"<figure>(\d+)", row) for row in rows] == [["70", "80"]] and not form.gathers
    assert form.placed(figure("1"), across(100)) == figure("1")  # after the heading they stand where they are


@given(st.lists(st.tuples(st.floats(10, 300), st.floats(10, 220)), min_size=1, max_size=9))
def test_no_figure_is_lost_and_none_wider_than_its_paper(sizes):
    blocks = laid((Kept(k, size) for k, size in enumerate(sizes)), USUAL)
    rows = [row for block in blocks for row in block]
    assert [one.figure for row in rows for one in row.figures] == list(range(len(sizes)))
    for block in blocks:
        sheet = block[0].sheet
        assert all(row.sheet == sheet for row in block) and (sheet or len(block) == 1)
        if len(block) > 1:
            assert sum(row.tall for row in block) <= sheet.field[1]
    for row in rows:
        assert len(row.figures) == 1 or row.wide <= USUAL.width


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
    text = template("report.tex.j2").render(given | {"m": m, "head": "", "body": body, "frames": None})
    return {"note.tex": text.encode(), **page.form.files}


def printed(files: dict[str, bytes]) -> list[tuple[float, float, list[str]]]:
    """Width and height of each page, mm, and its words."""
    found = pages(compiled(files)["note.pdf"])
    return [(round(page.wide), round(page.tall), [word.text for word in page.words]) for page in found]


@pytest.mark.exhaustive
def test_figures_of_latex_stand_side_by_side(tmp_path):
    form = Tex()
    form.gather()
    for k, size in enumerate(((60, 40), (70, 20), (160, 20))):
        assert (
            form.placed(
                f"figure{k}", Markup(f"No{k}"), form.picture(across(*size), f"figure{k}"), across(*size)
            )
            == ""
        )
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
def test_a_sheet_of_latex_follows_the_page_that_comes_to_it_and_pages_are_numbered_through(tmp_path):
    found = printed(note((100, 20), (250, 20), (200, 50), (400, 100), (100, 20), (300, 300)))
    assert [page[:2] for page in found] == [
        (210, 297), (210, 297), (297, 210), (630, 297), (210, 297), (594, 420)
    ]  # fmt: skip
    assert [page[2][-1] for page in found] == [str(k) for k in range(1, 7)]
    figures = [re.findall(r"Figure (\d)", " ".join(words)) for *_, words in found]
    assert figures == [[], ["1"], ["2", "3"], ["4"], ["5"], ["6"]]
