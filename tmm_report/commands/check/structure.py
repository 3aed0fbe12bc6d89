"""The structure of a note as lines: headings, captions, heads of columns, labels of formulas.

What it says in numbers is compared elsewhere; what it looks like is not compared.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from html.parser import HTMLParser

HEADINGS = {"h1": "# ", "h2": "## ", "h3": "### "}


def lines(html: str) -> list[str]:
    """The structure of a note.

    "# 2 Structural analysis", "Table 4 – Velocities", "| Position | v_B, m/s |", "Figure 3 – Scheme", "(4.12)".
    """
    reader = _Reader()
    reader.feed(html)
    reader.close()
    return reader.lines


def diff(old: Sequence[str], new: Sequence[str]) -> list[str]:
    """What changed, as a unified diff without its file names; empty where nothing did."""
    return list(difflib.unified_diff(old, new, lineterm="", n=1))[2:]


def changed(found: Sequence[str]) -> int:
    """How many lines a diff takes out or puts in."""
    return sum(line.startswith(("+", "-")) for line in found)


class _Reader(HTMLParser):
    """Goes through the note once; the contents repeat the headings and are passed over."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.lines: list[str] = []
        self._end = ""  # the tag that ends what is being read; "" while nothing is
        self._front = ""
        self._text: list[str] = []
        self._head: list[str] = []
        self._contents = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "nav":
            self._contents = True
        elif not self._end and not self._contents:
            front = _front(tag, dict(attrs).get("class") or "")
            if front is not None:
                self._end, self._front, self._text = tag, front, []

    def handle_data(self, data: str) -> None:
        if self._end:
            self._text.append(data)

    def handle_endtag(self, tag: str) -> None:
        if tag == "nav":
            self._contents = False
        elif tag == "tr" and self._head:
            self.lines.append(f"| {' | '.join(self._head)} |")
            self._head = []
        elif tag == self._end:
            self._end = ""
            text = " ".join("".join(self._text).split())
            if tag == "th":
                self._head.append(text)
            else:
                self.lines.append(self._front + text)


def _front(tag: str, kind: str) -> str | None:
    """What stands in front of the line that an element makes; None of one that makes none."""
    if tag in HEADINGS:
        return HEADINGS[tag]
    wanted = tag in ("th", "figcaption") or (tag, kind) in (("p", "caption"), ("div", "number"))
    return "" if wanted else None
