"""Letters of a note by its list of symbols: what each stands for, and in which section."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from html import unescape

from tmm_report.i18n import Translator
from tmm_report.languages import LANGUAGES

# What textbooks write alike in chapters of which each explains its own: T of an energy, of a torque, of a period; m of
# a mass and of a module; n of links, of revolutions, of damping; N of a power and of a number; A of a work and of an
# amplitude; φ of whatever turns; α of the basic rack and of the pressure of a cam; by number that of a link or a wheel.
CUSTOMARY = {*"TmnNAsxφαβγηθωεfbk", "A2", "di", "xi", "ρ4", "ω4", "s5", "Fдв"}
SINGLE = {Translator(language).gettext("Friction in single pairs") for language in LANGUAGES}
SECTION = re.compile(r"\((?:section|раздел) ([\d.]+)\)")


def listed(html: str) -> list[tuple[list[str], list[str]]]:
    """The letters of each line of the list, as they are marked up, and what they stand for."""
    start = html.index('<div class="symbols">')
    lines = re.findall(r"<p>(.*?)</p>", html[start : html.index("</div>", start)], re.DOTALL)
    halves = (re.split(r"\s[–—]\s", line, maxsplit=1) for line in lines)
    return [(re.findall(r"<math.*?</math>", head), plain(said).split("; ")) for head, said in halves]


def plain(markup: str) -> str:
    return re.sub(r"\s+", " ", unescape(re.sub(r"<[^>]+>", "", markup))).strip()


def faults(html: str) -> Iterator[str]:
    """Letters that stand in two lines, and those of which one chapter makes two things; in the chapter of single pairs,
    which are problems apart, one of its sections."""
    lines = listed(html)
    heads = Counter(letter for letters, _ in lines for letter in letters)
    yield from (f"{plain(letter)} stands in {count} lines" for letter, count in heads.items() if count > 1)
    titles = re.findall(r"<h1[^>]*>(.*?)</h1>", html, re.DOTALL)
    numbered = (plain(title).partition(" ") for title in titles)
    single = {number for number, _, title in numbered if title in SINGLE}
    for (letter, *_), said in lines:
        where = [number for one in said for number in SECTION.findall(one)]
        chapters = [number.split(".")[0] for number in where]
        rooms = where if {*chapters} <= single else chapters
        if len(set(rooms)) < len(rooms):
            yield f"{plain(letter)}: {'; '.join(said)}"
        elif len({*chapters}) > 1 and plain(letter) not in CUSTOMARY:
            yield f"{plain(letter)} is not customary for all of: {'; '.join(said)}"
