"""Whose a work is: by the names of its files and folders alone, never by its text, so that nobody hands in for another.

A name is first an id; of a learning platform's submission, `Name Surname_12345`, first the number that the teacher's
list knows, then the id, then the student's name: whatever its order, ё or е, hyphens and initials.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Collection, Iterable, Mapping

from tmm_report.grading.handed_in.attempts import unnumbered
from tmm_report.grading.year.gradebook import Roster
from tmm_report.problems import N_, Message, Problem, mistake, shown

_NUMBERED = re.compile(r"(.*)_([0-9]{1,15})")
_PART = re.compile(
    r"(.+)-(?:values|[^-]*_[^-]*)"
)  # ivanov-values.csv, ivanov-stage1_wheels.csv: parts of one sheet
_WORDS = re.compile(r"[^\W\d_]+")
_MARKS = str.maketrans("", "", "\u0301'’ʼ`´")  # an accent, apostrophes: O'Brien, OBrien
_ID = Message(N_("put the number behind the name into the column moodle_id of the roster"))


def folded(name: str) -> str:
    """Names that Windows or macOS would take for one are one."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", name).casefold())


def whose(
    owners: Iterable[str], ids: Collection[str], roster: Roster, names: Callable[[], Mapping[str, str]]
) -> tuple[dict[str, str], dict[str, Problem]]:
    """Owner, as a file or a folder is called -> id of his variant; and why one belongs to none, where it might.

    `names`: id -> the student's name; it is asked for only where ids and numbers do not tell.
    """
    found = _Whose(ids, roster)
    left = [owner for owner in dict.fromkeys(owners) if not found.take(owner)]
    problems = found.by_names(left, names()) if left else {}
    return found.known, problems


class _Whose:
    def __init__(self, ids: Collection[str], roster: Roster):
        self.ids = {folded(id): id for id in ids}
        self.numbers: dict[str, str] = {}
        for id, about in roster.items():
            if (number := re.search(r"[0-9]+$", about.get("moodle_id", ""))) and folded(id) in self.ids:
                self.numbers.setdefault(number[0], self.ids[folded(id)])
        self.known: dict[str, str] = {}

    def take(self, owner: str) -> bool:
        """Whether an owner is known by an id, or by the number behind his name."""
        submission = _NUMBERED.fullmatch(owner)
        id = self.ids.get(folded(owner)) or (submission and self.numbers.get(submission[2]))
        tried = [submission[1]] if submission else []
        tried += [unnumbered(owner), *(part[1] for part in (_PART.fullmatch(owner),) if part)]
        id = id or next((self.ids[folded(name)] for name in tried if folded(name) in self.ids), None)
        if id:
            self.known[owner] = id
        return bool(id)

    def by_names(self, owners: Iterable[str], names: Mapping[str, str]) -> dict[str, Problem]:
        """Know what is left by the students' names; what could be several students', or is a second work of one whom
        it names alike, is told."""
        numbered = {id for owner, id in self.known.items() if _NUMBERED.fullmatch(owner)}
        listed = [(id, words(name)) for id, name in names.items() if id not in numbered and words(name)]
        problems: dict[str, Problem] = {}
        taken: dict[str, list[str]] = {}
        for owner in owners:
            ids = self.meant(owner, listed)
            if len(ids) == 1:
                taken.setdefault(ids[0], []).append(owner)
            elif ids:
                text = N_("%(name)s may be any of %(ids)s")
                listed_ = ", ".join(shown(id) for id in ids[:5])
                problems[owner] = mistake(text, right=_ID, name=shown(owner), ids=listed_)
        for id, several in taken.items():
            if len(several) > 1:
                text = N_("works of two students, or of one twice: %(names)s")
                told = mistake(text, right=_ID, names=", ".join(shown(owner) for owner in several[:5]))
                problems |= dict.fromkeys(several, told)
            else:
                self.known[several[0]] = id
        return problems

    @staticmethod
    def meant(owner: str, listed: Iterable[tuple[str, tuple[str, ...]]]) -> list[str]:
        """Ids of those whom a name can mean: who is called so, else whose name it shortens or is shortened by."""
        submission = _NUMBERED.fullmatch(owner)
        said = submission[1] if submission else unnumbered(owner)
        found: list[str] = []
        while not found and said:
            given = words(said)
            found = [id for id, name in listed if name == given]
            found = found or [id for id, name in listed if _shortens(given, name) or _shortens(name, given)]
            said = said.partition("-")[2]  # Moodle puts a group before the name: М-31-Иванов Иван
        return found


def number(owner: str) -> str:
    """The number behind a submission's name, "" where there is none."""
    submission = _NUMBERED.fullmatch(owner)
    return submission[2] if submission else ""


def words(name: str) -> tuple[str, ...]:
    """The words of a name, in one order: `Иванова-Ёлкина Анна`, `анна иванова елкина`."""
    plain = unicodedata.normalize("NFKC", name).casefold().replace("ё", "е")
    return tuple(sorted(_WORDS.findall(unicodedata.normalize("NFKC", plain.translate(_MARKS)))))


def _shortens(short: tuple[str, ...], name: tuple[str, ...]) -> bool:
    """Whether every word of a name stands in another, some as initials, and two at least, one of them in full."""
    if len(short) < 2 or len(short) > len(name):
        return False
    left = list(name)
    full = [word for word in short if len(word) > 1]
    for word in full:
        if word not in left:
            return False
        left.remove(word)
    for initial in short:
        if len(initial) == 1:
            fits = next((word for word in left if word.startswith(initial)), None)
            if fits is None:
                return False
            left.remove(fits)
    return bool(full)
