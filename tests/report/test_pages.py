"""Pages of the notes of ready variants in print: no more than a department takes, or than they have come to."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from notes import note, program, render, static
from once import once
from pdf_words import pages
from typesetting import set_by_tex

from benchmarks.pages import Chapter, chapters, fills, read_words
from tmm_report import solve
from tmm_report.commands.printing import printed
from tmm_report.loading import loads

MOST = {  # pages of the text and of the appendices, MB of the HTML
    ("compressor", "course"): (55, 30, 1.2),
    ("compressor", "short"): (30, 2, 0.54),
    ("four-bar", "course"): (14, 3, 0.34),
    ("punch_press", "course"): (10, 2, 0.35),
}

FULL = 2 / 3  # of a page, between its margins: the least but the last of a chapter
FILLED = [("compressor", "short", "html"), ("compressor", "course", "html"), ("compressor", "course", "tex"),
          ("compressor", "full", "html"), ("hoist_drive", "course", "html"), ("shaper", "course", "html")]  # fmt: skip

FOUR_BAR = """
language: ru
title: {topic: Кривошипно-коромысловый механизм}
mechanism:
  frame: {O: [0, 0], C: [200 mm, 20 mm]}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 180 mm}}
    3: {points: {C: 0, B: 120 mm}}
  driver: {link: 1, speed: 180 rpm, rotation: clockwise}
  assembly: {B: left of A-C}
"""


def html_of(name: str, depth: str) -> bytes:
    if name == "four-bar":
        return render(solve(loads(FOUR_BAR)), "html", depth=depth)["note.html"]
    return note(name, "html", depth=depth)["note.html"]


@once
def set_once(name: str, depth: str, of: str = "html") -> tuple[bytes, list[Chapter], int]:
    """The PDF of a note, its chapters, and the number of its pages."""
    program("chromium"), program("pdftotext")
    html = html_of(name, depth)
    pdf = set_by_tex(note(name, "tex", depth=depth))[1] if of == "tex" else printed(html)
    return pdf, *chapters_of(html, pdf)


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "depth"), MOST)
def test_a_note_takes_no_more_pages_than_it_may(name, depth):
    text, appendices, size = MOST[name, depth]
    _, found, count = set_once(name, depth)
    apart = [int(one.start) for one in found if one.appendix]
    of_text = min(apart, default=count)
    assert of_text <= text and count - of_text <= appendices
    assert bool(apart) == bool(appendices)
    # what moves it has its own bound, in tests/living
    assert len(static(html_of(name, depth).decode()).encode()) <= 1e6 * size


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "depth", "of"), FILLED)
def test_no_page_within_a_chapter_is_less_than_two_thirds_full(name, depth, of):
    pdf, found, _ = set_once(name, depth, of)
    fill = [fill for chapter in found for fill in chapter.fill]
    assert len(fill) > 10 and np.mean(fill) > 0.9
    assert min(fill) >= FULL
    assert not lying_over(pdf)
    if depth != "full":  # whose colons also stand before formulas within a line
        assert not announcing(pdf)


@pytest.mark.exhaustive
def test_a_page_half_empty_is_seen():
    program("chromium"), program("pdftotext")
    html = html_of("compressor", "short")
    head, mark, rest = html.partition(b'<h2 id="section4.2">')
    broken = head + b'<div style="break-before: page"></div>' + mark + rest
    assert min(fill for one in chapters_of(html, printed(broken))[0] for fill in one.fill) < FULL


def announcing(pdf):
    """Pages whose text ends with a colon, so that what it announces is on another one."""
    found = []
    for number, page in enumerate(pages(pdf), 1):
        body = [one for one in page.words if one.below < page.tall * 0.945]  # above the page's number
        if body and max(body, key=lambda one: (round(one.below), one.right)).text.endswith(":"):
            found.append(number)
    return found


@pytest.mark.exhaustive
def test_what_a_colon_announces_on_the_next_page_is_seen():
    program("chromium"), program("pdftotext")
    html = html_of("compressor", "short")
    apart = html.replace(b'<div class="formula"', b'<div style="break-before: page" class="formula"')
    assert announcing(printed(apart))


def lying_over(pdf):
    """Words of the text that stand in one place with others: number of the page and both."""
    found = []
    for number, page in enumerate(pages(pdf), 1):
        words = [one for one in page.words if len(one.text) > 3 and one.text.isalpha()]
        boxes = np.array([one[:4] for one in words]).reshape(-1, 4).T
        left, above, right, below = (
            np.subtract.outer(side, other) for side, other in zip(boxes, boxes[[2, 3, 0, 1]], strict=True)
        )
        wide, tall = np.minimum(-left, right), np.minimum(-above, below)  # of what two have in common
        least = 0.2 * np.minimum.outer(boxes[3] - boxes[1], boxes[3] - boxes[1])
        for i, k in np.argwhere((wide > 0.7) & (tall > least)):
            if i < k:
                found.append((number, words[i].text, words[k].text))
    return found


@pytest.mark.exhaustive
def test_words_that_lie_over_others_are_seen():
    program("chromium"), program("pdftotext")
    html = html_of("punch_press", "short")
    pushed = html.replace(b"</style>", b"h2 + p { margin-top: -2em !important; }</style>", 1)
    assert not lying_over(printed(html)) and lying_over(printed(pushed))


def chapters_of(html: bytes, pdf: bytes) -> tuple[list[Chapter], int]:
    with TemporaryDirectory() as folder:
        file = Path(folder, "note.pdf")
        file.write_bytes(pdf)
        words = read_words(file)
        return list(chapters(html, words, fills(file, Path(folder)))), len(words)
