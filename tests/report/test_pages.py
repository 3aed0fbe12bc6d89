"""Pages of the notes of ready variants in print: no more than a department takes, or than they have come to."""

from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from conftest import read
from notes import program, static

from benchmarks.pages import chapters, fills, read_words
from tmm_report import render, solve
from tmm_report.commands.printing import printed
from tmm_report.loading import loads

MOST = {  # pages of the text and of the appendices, MB of the HTML
    ("compressor", "course"): (55, 30, 1.2),
    ("compressor", "short"): (32, 0, 0.53),
    ("four-bar", "course"): (14, 3, 0.34),
    ("punch_press", "course"): (10, 2, 0.35),
}

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
