"""Letters that no face of the note has: they are lost, or another font's stands in their place."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from tmm_report.lint.made import Made, line_at
from tmm_report.lint.page import said
from tmm_report.problems import N_, Message, Problem
from tmm_report.report.paper.measure import known_letters

LOST = "\N{REPLACEMENT CHARACTER}"


def glyphs(made: Made) -> Iterator[Problem]:
    """Letters that the HTML's own faces have not, that pdflatex did not find, or that were lost before."""
    yield from _of_page(made)
    if made.tex is not None and LOST in made.tex:
        line = line_at(made.tex, made.tex.index(LOST))
        yield made.found(
            "glyph", "note.tex", line, Message(N_("a letter was lost: %(sign)s"), {"sign": LOST})
        )
    if made.log is not None:
        for one in {match[0]: match for match in _MISSING.finditer(made.log)}.values():
            wrong = Message(N_("TeX has no letter %(sign)s in the font %(font)s"), one.groupdict())
            yield made.found("glyph", "note.log", line_at(made.log, one.start()), wrong)


_MISSING = re.compile(
    r"Missing character: There is no (?P<sign>.{1,20}?) (?:\([^)]*\) )?in font (?P<font>[\w./-]{1,40})"
)


def _of_page(made: Made) -> Iterator[Problem]:
    page = made.page
    if page is None:
        return
    known = known_letters()
    foreign = {sign for text in page.root.itertext() for sign in text} - known
    foreign = {
        sign for sign in foreign if not sign.isspace() and unicodedata.category(sign) != "Cf"
    }  # unseen
    if not foreign:
        return
    told, anchor = set[str](), ""
    for node in page.root.iter():
        anchor = node.get("id") or anchor
        for sign in foreign.intersection((node.text or "") + (node.tail or "")) - told:
            told.add(sign)
            name = unicodedata.name(sign, f"U+{ord(sign):04X}")
            values = {"sign": sign, "name": name, "what": page.name(anchor) or said(node)[:40]}
            wrong = Message(N_("no font of the note has the letter %(sign)s (%(name)s), at %(what)s"), values)
            yield made.found("glyph", "note.html", made.line(anchor), wrong)
