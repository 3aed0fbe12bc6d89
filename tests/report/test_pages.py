"""Pages of the notes of ready variants in print: no more than a department takes, or than they have come to."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from conftest import read
from notes import program, static
from pdf_words import pages
from typesetting import set_by_tex

from benchmarks.pages import chapters, fills, read_words
from tmm_report import render, solve
from tmm_report.commands.printing import printed
from tmm_report.loading import loads

MOST = {  # pages of the text and of the appendices, MB of the HTML
    ("compressor", "course"): (55, 30, 1.2),
    ("compressor", "short"): (30, 2, 0.53),
    ("four-bar", "course"): (14, 3, 0.34),
    ("punch_press", "course"): (10, 2, 0.35),
}

FULL, APART = (
    2 / 3,
    0.55,
)  # of a page, between its margins: the least but the last of a chapter; of an appendix, where
# figures follow one another and little text fills what is left between them
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


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "depth"), MOST)
def test_a_note_takes_no_more_pages_than_it_may(name, depth):
    program("chromium"), program("pdftotext")
    text, appendices, size = MOST[name, depth]
    html = render(solve(loads(FOUR_BAR) if name == "four-bar" else read(name)), "html", depth=depth)[
        "note.html"
    ]
    with TemporaryDirectory() as folder:
        pdf = Path(folder, "note.pdf")
        pdf.write_bytes(printed(html))
        words, filled = read_words(pdf), fills(pdf, Path(folder))
    apart = [int(one.start) for one in chapters(html, words, filled) if one.appendix]
    of_text = min(apart, default=len(words))
    assert of_text <= text and len(words) - of_text <= appendices
    assert bool(apart) == bool(appendices)
    assert (
        len(static(html.decode()).encode()) <= 1e6 * size
    )  # what moves it has its own bound, in tests/living


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "depth", "of"), FILLED)
def test_no_page_within_a_chapter_is_less_than_two_thirds_full(name, depth, of):
    program("chromium"), program("pdftotext")
    results = solve(read(name))
    html = render(results, "html", depth=depth)["note.html"]
    pdf = set_by_tex(render(results, "tex", depth=depth))[1] if of == "tex" else printed(html)
    found = chapters_of(html, pdf)
    fill = [fill for chapter in found for fill in chapter.fill]
    assert len(fill) > 10 and np.mean(fill) > 0.9
    assert all(fill >= (APART if one.appendix else FULL) for one in found for fill in one.fill)
    assert not lying_over(pdf)


@pytest.mark.exhaustive
def test_a_page_half_empty_is_seen():
    program("chromium"), program("pdftotext")
    html = render(solve(read("compressor")), "html", depth="short")["note.html"]
    head, mark, rest = html.partition(b'<h2 id="section4.2">')
    broken = head + b'<div style="break-before: page"></div>' + mark + rest
    assert min(fill for one in chapters_of(html, printed(broken)) for fill in one.fill) < FULL


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
    html = render(solve(read("punch_press")), "html", depth="short")["note.html"]
    pushed = html.replace(b"</style>", b"h2 + p { margin-top: -2em !important; }</style>", 1)
    assert not lying_over(printed(html)) and lying_over(printed(pushed))


def chapters_of(html, pdf):
    with TemporaryDirectory() as folder:
        file = Path(folder, "note.pdf")
        file.write_bytes(pdf)
        return list(chapters(html, read_words(file), fills(file, Path(folder))))
