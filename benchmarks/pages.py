"""Pages of the notes as they are printed, by chapter, and how full they are.

    python -m benchmarks.pages [NAME ...] [--depth short course full] [--of html bare tex] [--language ru|en]
                               [--chapters]

Notes of shipped variants: `html`, printed by a headless Chromium (as `solve --print` finds it), `bare`, by one that
finds no font but DejaVu, `tex`, set by pdflatex. The PDF is read with Poppler's `pdftotext` and `pdftoppm`. A
chapter's pages are counted in parts, from its heading to the next one; `fill` is the share of the room between a
page's margins down to the lowest ink, the last page of every chapter left out. Pages of the text and of the appendices
are told apart: 82 + 23.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple
from unittest.mock import patch

import numpy as np
from matplotlib import get_data_path

from tmm_report import load, render, solve
from tmm_report.commands.pdf import compiled
from tmm_report.commands.printing import printed
from tmm_report.course import DEPTHS, Results

VARIANTS = Path(__file__).parents[1] / "variants"
WORD = re.compile(r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="[\d.]+" yMax="[\d.]+">(.*?)</word>')
DOTS = 20  # an inch, at which ink is looked for
TOP = 0.12  # of a page: a heading that stands higher begins it
BELOW = 18.0  # mm from the lower edge: there stands the page's number


class Chapter(NamedTuple):
    """`start`, `end`: pages in parts; `fill`: of each of its whole pages but the last, 0 … 1."""

    title: str
    appendix: bool
    start: float
    end: float
    fill: list[float]


def read_words(pdf: Path) -> list[list[tuple[float, float, str]]]:
    """Of every page its words: x, y as a share of the height from above, text."""
    text = subprocess.run(["pdftotext", "-bbox", pdf, "-"], check=True, capture_output=True).stdout.decode()
    pages = re.findall(r'<page width="([\d.]+)" height="([\d.]+)">(.*?)</page>', text, re.S)
    return [
        [(float(x), float(y) / float(high), word) for x, y, word in WORD.findall(body)]
        for _, high, body in pages
    ]


def fills(pdf: Path, folder: Path) -> list[float]:
    """Of every page how far down its lowest ink is, as a share of the room between the margins."""
    subprocess.run(["pdftoppm", "-r", str(DOTS), "-gray", pdf, folder / "page"], check=True)
    found = []
    for file in sorted(folder.glob("page-*.pgm")):
        _, size, _, body = file.read_bytes().split(b"\n", 3)
        wide, high = map(int, size.split())
        ink = np.frombuffer(body, np.uint8).reshape(high, wide) < 200
        top, low = int(20 / 25.4 * DOTS), int(high - BELOW / 25.4 * DOTS)
        rows = np.flatnonzero(ink[top:low].any(axis=1))
        found.append(float(rows[-1] + 1) / (low - top) if rows.size else 0.0)
    return found


def chapters(
    html: bytes, words: list[list[tuple[float, float, str]]], filled: list[float]
) -> Iterator[Chapter]:
    """The chapters by their headings, as the contents lists them."""
    found = re.findall(r"<h1([^>]*)>(.*?)</h1>", html.decode(), re.S)
    titles = [re.sub(r"<[^>]*>", " ", title).strip() for _, title in found]
    starts, after = list[float](), float(len(words))
    for title in reversed(titles):  # from the end: the contents names them all before
        after = max((place for place in _places(words, title) if place <= after), default=after)
        starts.insert(0, after)
    apart = ["appendix" in classes for classes, _ in found]  # these begin a page, if on a sheet of their own
    begun = zip(apart[1:], starts[1:], strict=True)
    ends = [*(int(one) if alone or one % 1 < TOP else one for alone, one in begun), float(len(words))]
    for (classes, _), title, start, end in zip(found, titles, starts, ends, strict=True):
        whole = filled[int(start) : max(int(start), int(np.ceil(end)) - 1)]
        yield Chapter(title, "appendix" in classes, start, end, whole)


def _places(words: list[list[tuple[float, float, str]]], title: str) -> Iterator[float]:
    """Where a line of the text begins as a title does: page and share of it."""
    parts = title.casefold().split()[:4]  # a profile may print it in capitals
    for page, own in enumerate(words):
        texts = [word.casefold() for *_, word in own]
        for k in range(len(own) - len(parts) + 1):
            if texts[k : k + len(parts)] == parts and (k == 0 or own[k - 1][1] < own[k][1] - 1e-3):
                yield page + own[k][1]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("names", nargs="*", default=sorted(path.stem for path in VARIANTS.glob("*.yaml")))
    parser.add_argument("--language", default=None)
    parser.add_argument(
        "--depth", choices=DEPTHS, nargs="+", default=[None], help="left out: that of the variant"
    )
    parser.add_argument("--of", choices=("html", "bare", "tex"), nargs="+", default=["html"])
    parser.add_argument("--chapters", action="store_true", help="print the chapters too")
    options = parser.parse_args()
    print(f"{'':<40}{'pages':>8}{'fill':>7}{'least':>7}{'MB':>7}")
    for name in options.names:
        results = solve(load(VARIANTS / f"{name}.yaml"))
        for depth in options.depth:
            html = render(results, "html", options.language, depth)["note.html"]
            for of in options.of:
                called = " ".join([name, *([depth] if depth else ()), *([of] if of != "html" else ())])
                show(called, html, pdf_of(of, results, html, options.language, depth), options.chapters)


def pdf_of(of: str, results: Results, html: bytes, language: str | None, depth: str | None) -> bytes:
    if of == "tex":
        return compiled(render(results, "tex", language, depth))["note.pdf"]
    return printed_bare(html) if of == "bare" else printed(html)


def printed_bare(html: bytes) -> bytes:
    """The note as a browser prints it that finds no font but DejaVu, which matplotlib has."""
    fonts = Path(get_data_path(), "fonts", "ttf")
    with TemporaryDirectory() as place:
        config = Path(place, "fonts.conf")
        config.write_text(
            f"<fontconfig><dir>{fonts}</dir><cachedir>{place}/cache</cachedir></fontconfig>", "utf-8"
        )
        with patch.dict(os.environ, {"FONTCONFIG_FILE": str(config)}):
            return printed(html)


def show(called: str, html: bytes, pdf: bytes, each: bool) -> None:
    """A line of the note, and with `each` one of every chapter."""
    with TemporaryDirectory() as made:
        file = Path(made, "note.pdf")
        file.write_bytes(pdf)
        words, filled = read_words(file), fills(file, Path(made))
    found = list(chapters(html, words, filled))
    every = [one for chapter in found for one in chapter.fill]
    mean, least = (np.mean(every), min(every)) if every else (1.0, 1.0)
    text = min((int(one.start) for one in found if one.appendix), default=len(words))
    apart = f"{text} + {len(words) - text}" if text < len(words) else str(text)
    print(f"{called:<40}{apart:>8}{mean:7.2f}{least:7.2f}{len(html) / 1e6:7.2f}")
    for chapter in found if each else ():
        fill = f"{np.mean(chapter.fill):7.2f}{min(chapter.fill):7.2f}" if chapter.fill else ""
        print(f"  {chapter.title[:36]:<38}{chapter.end - chapter.start:8.1f}{fill}")


if __name__ == "__main__":
    main()
