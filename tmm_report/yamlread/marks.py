"""Letters with marks upon them in their composed form."""

from __future__ import annotations

import unicodedata
from itertools import groupby

MARKS = 30  # in a row upon one letter


def composed(text: str) -> str:
    """The composed form (NFC) of a text of any length.

    Raises ValueError where more than `MARKS` marks follow one another: to put n of them in order takes n² steps.
    """
    if len(text) > 10 * MARKS and not text.isascii():
        runs = (sum(1 for _ in run) for is_mark, run in groupby(text, _is_mark) if is_mark)
        if any(length > MARKS for length in runs):
            raise ValueError("marks")
    return unicodedata.normalize("NFC", text)


def _is_mark(char: str) -> bool:
    return unicodedata.category(char).startswith("M")
