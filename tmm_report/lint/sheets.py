"""Pages of the PDFs, as Poppler prints them small: those with next to nothing on them."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.lint.made import PDFS, Made
from tmm_report.problems import N_, Message, Problem

PROGRAM = "pdftoppm"
TALL = 300  # dots: the longer side of a page
FOOT = 0.06  # of the page: there stands its number
LEAST = 0.03  # of the page: what one line of text and its number take
SECONDS, PAGES = 60, 500


def empty(made: Made) -> Iterator[Problem]:
    """Pages whose ink, apart from the page's number, is less than two lines high."""
    for name in made.files.keys() & {*PDFS}:
        for number, page in enumerate(_pages(made.files[name]), 1):
            rows = np.flatnonzero((page < 200).any(axis=1)[: int(len(page) * (1 - FOOT))])
            if len(rows) < LEAST * len(page):
                wrong = Message(N_("page %(number)s is all but empty"), {"number": number})
                yield made.found("empty", name, None, wrong)


def unseen(made: Made) -> bool:
    """Whether there are pages that no program at hand can look at."""
    return bool(made.files.keys() & {*PDFS}) and shutil.which(PROGRAM) is None


def _pages(pdf: bytes) -> Iterator[Any]:
    """Grey pictures of the pages (rows, columns). What Poppler cannot read has none."""
    import subprocess  # only a PDF needs it

    program = shutil.which(PROGRAM)
    if program is None:
        return
    command = [program, "-gray", "-scale-to", str(TALL), "-l", str(PAGES), "-"]
    try:
        done = subprocess.run(command, input=pdf, capture_output=True, timeout=SECONDS)
    except (subprocess.TimeoutExpired, OSError):
        return
    data, at = done.stdout, 0
    while head := _HEAD.match(data, at):
        wide, high = int(head[1]), int(head[2])
        if len(data) < head.end() + wide * high:
            return
        yield np.frombuffer(data, np.uint8, wide * high, head.end()).reshape(high, wide)
        at = head.end() + wide * high


_HEAD = re.compile(rb"P5\n(\d{1,4}) (\d{1,4})\n255\n")
