"""Frames and title blocks by GOST 2.104 on the pages of a note: what its style sheet and LaTeX put in.

frames = Frames(title, page)
frames.first, frames.following      # the blocks as drawings
frames.css("first", face)           # url("data:…")
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING
from urllib.parse import quote

from markupsafe import Markup

from tmm_report.figures.drawing import Drawing, svg, tikz
from tmm_report.figures.title_block import FIRST, NEXT, THICK, WIDE, Form, Said, first, following
from tmm_report.problems import N_
from tmm_report.profiles import A4, BINDING, EDGE
from tmm_report.report.paper.measure import letters
from tmm_report.report.paper.sheets import POINT
from tmm_report.report.part import Title

if TYPE_CHECKING:
    from tmm_report.report.numbering import Section
    from tmm_report.report.page import Page

LOWER = (
    FIRST.tall - NEXT.tall
)  # mm: by how much text of the first sheet ends higher than that of the next ones
LINE = 0.53  # mm: width of the frame, two dots of a browser, which knows no parts of them in a border
WORDS = {
    "Изм.": N_("Rev."), "Лист": N_("Sheet"), "№ докум.": N_("Doc. No."), "Подп.": N_("Sign."), "Дата": N_("Date"),
    "Лит.": N_("Let."), "Листов": N_("Sheets"),
}  # fmt: skip
ROLES = (N_("Drawn by"), N_("Checked by"), "", N_("Std. check"), N_("Approved by"))
# how departments call who signs a row, from the beginning of the word, in any of their languages
CALLED = {
    "Checked by": r"провер|перевір|тексер|check",
    "Tech. check": r"т(ех\w*?)?\W*(контр|бақыл)|tech\w*\W*(check|control)",
    "Std. check": r"н(орм\w*?)?\W*(контр|бақыл)|(norm|standard|std)\w*\W*(check|control)",
    "Approved by": r"утв|затв|бекіт|approv|зав\w*\W*каф|кафедра меңг|head\W.*(department|chair)",
}
Cell = tuple[float, float, float, float]


class Frames:
    """Frames of the sheets of one note, their title blocks and the places of their numbers."""

    line = LINE
    binding, edge, wide = BINDING, EDGE, WIDE
    lower = LOWER

    def __init__(self, title: Title, page: Page):
        self.title, self.page = title, page

    @cached_property
    def said(self) -> Said:
        name, t = self.page.name, self.page.tr.gettext
        own = [name(text) for text in (self.title.institution, self.title.group) if text]
        return Said(
            name(self.title.designation),
            name(self.title.topic),
            ", ".join(own),
            signers(self.title, self.page, ROLES),
            {word: t(text) for word, text in WORDS.items()},
        )

    @cached_property
    def first(self) -> Drawing:
        return first(self.said)

    @cached_property
    def following(self) -> Drawing:
        return following(self.said)

    def tikz(self, name: str) -> Markup:
        """A block, "first" or "following", as LaTeX reads it from a file of its own."""
        drawing: Drawing = getattr(self, name)
        file = f"figures/{name}.tex"
        self.page.form.files[file] = tikz(drawing).encode()
        return Markup(rf"\input{{{file}}}\unskip")

    def whole(self, name: str) -> Drawing:
        """A block with all of its outer lines, half of which stand outside its size."""
        return replace(getattr(self, name), margin=self.outside)

    @property
    def outside(self) -> float:
        """What of these lines stands outside, mm."""
        return THICK.width / 2

    def css(self, name: str, face: str) -> Markup:
        """A block as a picture of a style sheet, with the face of its letters, for a picture sees none of its page."""
        style = (
            f'<style>@font-face{{font-family:"Note Serif";src:url(data:font/woff2;base64,{face})}}</style>'
        )
        text = svg(self.whole(name)).replace("<g ", f"{style}<g ", 1)
        return Markup('url("data:image/svg+xml,' + quote(text, safe=" /:;=,@+()'!*-._~{}&") + '")')

    def frame(self, wide: float, tall: float) -> Cell:
        """The frame of a sheet with its line: left, top, width and height, mm."""
        half = LINE / 2
        return BINDING - half, EDGE - half, wide - BINDING - EDGE + LINE, tall - 2 * EDGE + LINE

    def size(self, form: Form) -> tuple[float, float]:
        """Width and height of the picture of a block: it has its lines whole."""
        return WIDE + THICK.width, form.tall + THICK.width

    @property
    def inside(self) -> float:
        """How far that picture stands inside the outer edge of the frame's line, mm."""
        return (LINE - THICK.width) / 2

    def number(self, wide: float) -> Cell:
        """Where the number of a sheet stands, from its lower left corner."""
        return _on_sheet(NEXT.number, wide)

    @property
    def number_first(self) -> Cell:
        return _on_sheet(FIRST.number, A4[0])

    @property
    def sheets_first(self) -> Cell:
        """Where the number of all sheets stands on the first one."""
        assert FIRST.sheets is not None
        return _on_sheet(FIRST.sheets, A4[0])

    @property
    def forms(self) -> tuple[Form, Form]:
        return FIRST, NEXT


def signers(title: Title, page: Page, roles: Sequence[str]) -> list[tuple[str, str]]:
    """(role, name) for each row of a title block. Of those who sign beside the student and the teacher each has the row
    of the role, the first one of another role the free row, "" among the roles."""
    name, t = page.name, page.tr.gettext
    rows = {role: (t(role) if role else "", "") for role in roles}
    for role, person in zip(ROLES, (title.student, title.teacher), strict=False):
        rows[role] = rows[role][0], name(person)
    for one in title.signed:
        own = name(one.role)
        named = [role for role, words in CALLED.items() if role in rows and re.match(words, own.casefold())]
        for role in (*named, ""):
            shown, taken = rows[role]
            if not taken and (role or not shown):
                rows[role] = shown or own, name(one.name)
                break
    return list(rows.values())


HEAD = 22.0  # mm: what the heading of the contents takes
SPACING = 1.2  # of the lines of the contents, in sizes of their letters
ASIDE = 35.0  # mm: what of a line is its indent, its number and that of its page


def lines_above_first(sections: Sequence[Section], page: Page) -> int:
    """How many lines of the contents the first sheet holds above its title block."""
    paper, size = page.form.paper, page.profile.text.size * POINT
    room = int((paper.height - LOWER - HEAD) / (SPACING * size))
    for number, section in enumerate(sections):
        room -= 1 + int(size * letters(section.title) / (paper.width - ASIDE))
        if room < 0:
            return number
    return len(sections)


def _on_sheet(cell: Cell, wide: float) -> Cell:
    left, bottom, width, height = cell
    return wide - EDGE - WIDE + left, EDGE + bottom, width, height
