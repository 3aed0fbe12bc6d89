"""The title page and the assignment sheet: what is written on them; and how much the note says."""

from __future__ import annotations

from tmm_report.chapters.title.pieces import PIECES, Depth, Stand
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Title:
    """The title page; empty fields are left out of it. `lines`: free ones under the department; `designation`: of the
    document; `signed`: who signs it beside the student and the teacher, role and name."""

    ministry: str = ""
    institution: str = ""
    department: str = ""
    lines: tuple[str, ...] = ()
    designation: str = ""
    course: str = ""
    topic: str = ""
    student: str = ""
    group: str = ""
    variant: str = ""
    teacher: str = ""
    city: str = ""
    year: str = ""
    signed: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Assignment:
    """The assignment sheet behind the title page. `data`: what is given; `contents`: of the note, else its chapters;
    `sheets`: of the drawings; `approved`: who approves it, role and name."""

    approved: tuple[str, str] | None = None
    issued: str = ""
    due: str = ""
    data: tuple[str, ...] = ()
    contents: tuple[str, ...] = ()
    sheets: tuple[str, ...] = ()


@dataclass(frozen=True)
class Note:
    """How much the note says. `body`, `appendix`, `omit`: pieces, or chapters, that stand elsewhere than at the
    `depth`; `symbols`: whether letters are explained under their formulas alone, or listed in front, too; `plans`: how
    many positions have their plans worked out, None: one, and those that a piece of the note lets in."""

    depth: Depth = "course"
    body: tuple[str, ...] = ()
    appendix: tuple[str, ...] = ()
    omit: tuple[str, ...] = ()
    symbols: bool | None = None
    plans: int | None = None

    def stand(self, piece: str) -> Stand:
        """Where a piece of the note stands: what is stated of itself, else of its chapter, else by the depth."""
        stated: tuple[tuple[Stand, tuple[str, ...]], ...]
        stated = ("body", self.body), ("appendix", self.appendix), ("omit", self.omit)
        for name in (piece, piece.split(".")[0]):
            for stand, names in stated:
                if name in names:
                    return stand
        if piece == "plans.others" and self.plans is not None:
            return "omit"
        return "body" if self.depth == "full" else getattr(PIECES[piece], self.depth)

    @property
    def listed(self) -> bool:
        """Whether there is a list of symbols."""
        return self.depth == "full" if self.symbols is None else self.symbols

    @property
    def every(self) -> bool:
        """Whether every formula is worked out, not only one of each kind."""
        return self.depth == "full"

    @property
    def whole(self) -> bool:
        """Whether nothing is left out."""
        return self.depth == "full" and not self.omit
