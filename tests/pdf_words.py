"""Where the words of a PDF stand, as Poppler's `pdftotext` reads them."""

from __future__ import annotations

import re
import subprocess
from typing import NamedTuple

from notes import program

POINT = 25.4 / 72  # mm
_PAGE = re.compile(r'<page width="([\d.]+)" height="([\d.]+)">(.*?)</page>', re.S)
_WORD = re.compile(r'<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">(.*?)</word>')


class Word(NamedTuple):
    """Its box from the upper left corner of the page, mm, and what it is."""

    left: float
    above: float
    right: float
    below: float
    text: str


class Page(NamedTuple):
    """mm."""

    wide: float
    tall: float
    words: list[Word]


def pages(pdf: bytes) -> list[Page]:
    command = [program("pdftotext"), "-bbox", "-", "-"]
    said = subprocess.run(command, input=pdf, capture_output=True, check=True).stdout.decode()
    return [
        Page(
            float(wide) * POINT,
            float(tall) * POINT,
            [Word(*(float(one) * POINT for one in box), text) for *box, text in _WORD.findall(body)],
        )
        for wide, tall, body in _PAGE.findall(said)
    ]
