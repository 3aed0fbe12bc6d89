"""Marks as files: CSV and XLSX for the teacher; what Moodle, Canvas and Gradescope import.

    files = gradebook(digests, Translator("ru"), roster)     # {"marks.csv": b"...", "moodle.csv": ..., ...}

The works stand by their ids, whatever their order before. Nothing here says what would have been right.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from tmm_report.grading.model import HELD, RIGHT, Digest, Rule
from tmm_report.grading.year.words import attempt_text, cause_text, override_text, state_text
from tmm_report.i18n import Translator
from tmm_report.intake.writing import csv_bytes, xlsx_bytes
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

Roster = Mapping[str, Mapping[str, str]]
"""id -> what the teacher's list says of the student: "name", "email", "moodle_id", "canvas_id", "section"."""

Row = Sequence[str | float | int | None]
Name = tuple[str, str]
PLACES = 2  # decimals of points
_RIGHT = frozenset(map(str, RIGHT))
_WRONG = frozenset((str(Rule.OFF), str(Rule.SIGN)))


@dataclass(frozen=True)
class Count:
    """How many cells were right, carried forward, wrong, without an answer."""

    right: int = 0
    carried: int = 0
    wrong: int = 0
    missing: int = 0

    @property
    def asked(self) -> int:
        return self.right + self.carried + self.wrong + self.missing


@dataclass(frozen=True, eq=False)
class Line:
    """What the gradebook keeps of one work; its cells are let go."""

    digest: Digest  # without cells
    columns: Mapping[Name, Count]
    total: Count

    @property
    def marked(self) -> bool:
        return self.digest.marked

    @property
    def points(self) -> float | None:
        return round(self.digest.mark, PLACES) if self.marked else None

    @property
    def worth(self) -> float | None:
        return round(self.digest.worth, PLACES) if self.digest.worth else None

    @property
    def percent(self) -> float | None:
        if not self.marked or not self.digest.worth:
            return None
        return round(100 * self.digest.mark / self.digest.worth, 1)


def line(digest: Digest) -> Line:
    """A work as the gradebook keeps it."""
    rules: dict[Name, list[str]] = {}
    for (table, key, _), (_, rule) in digest.cells.items():
        rules.setdefault((table, key), []).append(str(rule))
    columns = {name: _count(some) for name, some in rules.items()}
    total = _count([rule for some in rules.values() for rule in some])
    return Line(replace(digest, cells={}, right={}), columns, total)


def _count(rules: Sequence[str]) -> Count:
    return Count(
        sum(rule in _RIGHT for rule in rules),
        rules.count(str(Rule.CARRIED)),
        sum(rule in _WRONG for rule in rules),
        rules.count(str(Rule.NO_ANSWER)),
    )


def gradebook(
    digests: Iterable[Digest], tr: Translator, roster: Roster | None = None, title: str = "TMM"
) -> dict[str, bytes]:
    """File name -> content. `title`: the column of Canvas; "name (12345)" finds an assignment by its number."""
    lines = sorted((line(digest) for digest in digests), key=lambda one: one.digest.id)
    names, marks = roster or {}, table(lines, tr)
    return {
        "marks.csv": csv_bytes(marks, tr.decimal),
        "marks.xlsx": xlsx_bytes(
            {tr.gettext(N_("marks")): marks, tr.gettext(N_("columns")): by_columns(lines, tr)}
        ),
        "moodle.csv": csv_bytes(moodle(lines, tr, names), "."),
        "canvas.csv": csv_bytes(canvas(lines, names, title), "."),
        **{f"gradescope/{one.digest.id}/results.json": gradescope(one, tr) for one in lines},
    }


# ---------------------------------------------------------------- for the teacher

HEADS = (
    "id",
    N_("student"),
    N_("group"),
    N_("variant"),
    N_("points"),
    N_("out of"),
    "%",
    N_("right"),
    N_("carried forward"),
    N_("wrong"),
    N_("no answer"),
    N_("likely causes"),
    N_("points reckoned"),
    N_("remark"),
)


def table(lines: Sequence[Line], tr: Translator) -> list[Row]:
    """The sheet of marks, its head first. A work that could not be marked has no points but the reasons."""
    return [[tr.gettext(head) for head in HEADS], *(_marks(one, tr) for one in lines)]


def _marks(one: Line, tr: Translator) -> Row:
    digest, total = one.digest, one.total
    whose = [digest.id, digest.student, digest.group, digest.variant]
    remark = "; ".join(message.render(tr.gettext) for message in _remarks(digest))
    if not digest.judged:
        mark = [one.points, one.worth, one.percent] if one.marked else [None] * 3
        return [*whose, *mark, *[None] * 4, "; ".join(digest.failed), None, remark]
    causes = "; ".join(cause_text(cause, private=True).render(tr.gettext) for cause in digest.causes)
    counts = [total.right, total.carried, total.wrong, total.missing]
    reckoned = round(digest.points, PLACES) if digest.override is not None else None
    return [*whose, one.points, one.worth, one.percent, *counts, causes, reckoned, remark]


def _remarks(digest: Digest) -> Iterator[Message]:
    """What is to be known of a mark: why there is none, who set it, of which attempt it is, what it is without."""
    if (state := state_text(digest)) is not None:
        yield state
    if digest.override is not None:
        yield override_text(digest.override)
    if (attempt := attempt_text(digest)) is not None:
        yield attempt
    for text in digest.missed:
        yield Message("%(text)s", {"text": text})


def by_columns(lines: Sequence[Line], tr: Translator) -> list[Row]:
    """The sheet of columns: of every work and column the share of right cells, %; empty where it was not asked."""
    names = list(dict.fromkeys(name for one in lines for name in one.columns))
    heads = [" ".join(filter(None, (table, key))) for table, key in names]
    rows: list[Row] = [["id", tr.gettext(N_("student")), *heads]]
    for one in lines:
        judged = one.columns if one.digest.judged else {}
        shares = [_share(judged.get(name, Count())) for name in names]
        rows.append([one.digest.id, one.digest.student, *shares])
    return rows


def _share(count: Count) -> float | None:
    return round(100 * count.right / count.asked, 1) if count.asked else None


# ---------------------------------------------------------------- for learning platforms

MOODLE = (
    "Identifier",
    "Full name",
    "ID number",
    "Email address",
    "Grade",
    "Maximum Grade",
    "Last modified (grade)",
    "Feedback comments",
)


def moodle(lines: Sequence[Line], tr: Translator, roster: Roster) -> list[Row]:
    """Moodle's grading worksheet, which its grade import reads, too: by email or ID number.

    "Participant 123" finds a student where the roster says his number in the assignment.
    """
    return [list(MOODLE), *(_moodle(one, tr, roster.get(one.digest.id, {})) for one in lines)]


def _moodle(one: Line, tr: Translator, known: Mapping[str, str]) -> Row:
    number = known.get("moodle_id", "")
    identifier = f"Participant {number}" if number.isdecimal() else number
    name, email = known.get("name") or one.digest.student, known.get("email", "")
    return [
        identifier, name, one.digest.id, email, one.points, one.worth, "", _harmless(" ".join(said(one, tr)))
    ]  # fmt: skip


CANVAS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
_POINTS = "Points Possible"


def canvas(lines: Sequence[Line], roster: Roster, title: str) -> list[Row]:
    """Canvas's gradebook with one assignment, and its row of the points possible.

    The row is known by its words alone: a student who is called so would change what the assignment is worth, and
    goes by his id. Works that could not be marked are left empty, which changes no grade.
    """
    worth = max((one.worth or 0.0 for one in lines), default=0.0)
    rows: list[Row] = [[*CANVAS, title], [f"    {_POINTS}", *[""] * 4, worth]]
    for one in lines:
        known = roster.get(one.digest.id, {})
        name = known.get("name") or one.digest.student or one.digest.id
        name = one.digest.id if _POINTS in name else name
        login = known.get("email") or ""
        section = known.get("section") or one.digest.group
        rows.append([name, known.get("canvas_id", ""), one.digest.id, login, section, one.points])
    return rows


def gradescope(one: Line, tr: Translator) -> bytes:
    """results.json of Gradescope's autograder: a test for every column."""
    columns = one.columns.items() if one.digest.judged else ()
    tests = [_test(one, name, count, tr) for name, count in columns if count.asked]
    document = {
        **({"score": one.points} if one.marked else {}),  # a score of 0 would be a mark
        "output": "\n".join(said(one, tr)),
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "tests": tests,
    }
    return (json.dumps(document, ensure_ascii=False, allow_nan=False, indent=1) + "\n").encode()


def _test(one: Line, name: Name, count: Count, tr: Translator) -> dict[str, object]:
    """One column; its points are said where the digest knows them."""
    table, key = name
    points, worth = one.digest.columns.get(name, (math.nan, math.nan))
    known = {"score": round(points, PLACES), "max_score": round(worth, PLACES)} if worth == worth else {}
    causes = [cause_text((kind, detail, ())) for kind, detail, keys in one.digest.causes if key in keys]
    sentences = [_counted(count).render(tr.gettext), *(cause.render(tr.gettext) for cause in causes)]
    return {
        **known,
        "status": "passed" if count.right + count.carried == count.asked else "failed",
        "name": f"{key} ({table})" if table else key,
        "output": "\n".join(sentences),
        "output_format": "text",
        "visibility": "visible",
    }


def said(one: Line, tr: Translator) -> list[str]:
    """What a student reads beside his mark: how many cells of each kind, and the likely causes, without numbers."""
    digest = one.digest
    by_hand = [] if digest.override is None else [_sentence(override_text(digest.override), tr)]
    if (state := state_text(digest)) is not None:
        reasons = [] if digest.state == HELD else list(digest.failed)
        return by_hand or [*([_sentence(state, tr)] if digest.state else ()), *reasons]
    attempt = attempt_text(digest)
    causes = [Message(N_("Likely cause: %(cause)s."), {"cause": cause_text(c)}) for c in digest.causes]
    messages = [message.render(tr.gettext) for message in (_counted(one.total), *causes)]
    return [*by_hand, *([_sentence(attempt, tr)] if attempt else ()), *messages]


def _sentence(message: Message, tr: Translator) -> str:
    text = message.render(tr.gettext)
    return f"{text[:1].upper()}{text[1:]}."


def _counted(count: Count) -> Message:
    values = {"right": count.right, "carried": count.carried, "wrong": count.wrong, "missing": count.missing}
    text = N_("Right: %(right)s; carried forward: %(carried)s; wrong: %(wrong)s; no answer: %(missing)s.")
    return Message(text, values)


def _harmless(text: str) -> str:
    """Text for a field that is shown as HTML: its brackets in a form that is no markup."""
    return text.replace("&", "＆").replace("<", "‹").replace(">", "›")
