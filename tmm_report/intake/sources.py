"""Where files from outside come from: files, folders, patterns, ZIP archives; each found once, named, read later.

A `Source` holds no content, so that a million of them can be listed and handed to other processes.
"""

from __future__ import annotations

import glob
import os
import re
from collections import Counter
from collections.abc import Collection, Iterable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tmm_report.intake import archive, ids
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass
from tmm_report.yamlread import file_label, opened, stream

BYTES = archive.MEMBER  # of one file
DEEPEST = 4  # folders of one within another, of a student's

_ITSELF = Message(N_("name the folder itself"))
_MOODLE = (
    "_assignsubmission_"  # what Moodle puts behind "name_number" of a folder, or of a file, of submissions
)
_TYPED = f"{_MOODLE}onlinetext"  # of what was typed into Moodle's own page
ATTEMPT = re.compile(r"(?:attempt|try|попытка|спроба|сдача)[\s_.№#-]*([0-9]{1,3})", re.IGNORECASE)
"""A folder of one attempt."""
_SAVE = Message(N_("save it as .xlsx or .csv"))
_CURES = {
    **dict.fromkeys((".xls", ".xlsm", ".xlsb", ".ods", ".numbers", ".tsv", ".txt"), _SAVE),
    **dict.fromkeys(archive.ARCHIVES, Message(N_("make it a ZIP"))),
    ".zip": Message(N_("name the archive itself")),
}
_FILL_IN = Message(N_("fill in the sheet that `tmm-report grade --template` writes"))

_NO_SHEET = mistake(N_("the folder holds no sheet"), right=_FILL_IN)


@dataclass(frozen=True, slots=True)
class Source:
    """A file from outside. `id`: a safe name for what is made of it, no other source's. `group`: the id of whom it
    belongs to: several files in a student's folder share it. `name`: of the file within `place`, a folder or a ZIP
    archive; its end says what kind of file it is. `owner`: whose it is, as the folder or the file is called; `within`:
    its name in the owner's folder.
    """

    id: str
    group: str
    place: str
    name: str
    member: archive.Member | None = None
    owner: str = ""
    within: str = ""

    @property
    def label(self) -> str:
        """How messages name it: `answers/ivanov.csv`, `answers.zip:ivanov.csv`."""
        return _label(self.place, self.name, self.member is not None)

    def read(self) -> bytes:
        """Its content, at most `BYTES`. Raises ProblemError with the file, never follows a link or waits."""
        if self.member is None:
            return opened(Path(self.place, self.name), self.label, BYTES)
        with stream(self.place, file_label(self.place)) as packed:
            return archive.content(packed, self.member, self.label)


@dataclass(frozen=True, slots=True)
class Unread:
    """What somebody handed in and cannot be taken: whose it is, and why. `other`: it is of another kind than what is
    asked for, a report beside the sheet, and is missed only where there is nothing else. `empty`: there was nothing."""

    owner: str
    problem: Problem
    other: bool = False
    empty: bool = False


@dataclass(frozen=True)
class Handed:
    """What students handed in. `unread`: of theirs, in the order of the places; `refused`: whole places, of nobody.
    `typed`: how many typed something into Moodle."""

    sources: list[Source]
    unread: list[Unread]
    refused: list[Unread]
    typed: int = 0


class _Found(NamedTuple):
    """A file before it has an id. `owner`: as its folder or its stem names it, among those of `scope`."""

    place: str
    name: str
    scope: str
    owner: str
    member: archive.Member | None = None
    within: str = ""


def sources(places: Iterable[str | Path], suffixes: Collection[str]) -> tuple[list[Source], list[Problem]]:
    """The files with one of the suffixes (".yaml", in any case) at the places, and what was refused there.

    A place is a file, a folder (its files, and those in the folders of students directly in it), a pattern with
    `*?[]`, or a ZIP archive (likewise). A file found twice counts once. Files come in the order of the places, of one
    place in the order of their names.
    """
    search = _searched(places, suffixes)
    return _named(list(search.found.values())), search.problems


def handed(places: Iterable[str | Path], suffixes: Collection[str]) -> Handed:
    """The same of what students handed in: their folders with all that is in them, a learning platform's among these;
    whatever of theirs cannot be taken is known by its owner."""
    search = _searched(places, suffixes, owned=True)
    refused = [Unread("", problem, empty=problem in search.nothing) for problem in search.problems]
    return Handed(_named(list(search.found.values())), search.unread, refused, len(search.typed))


def _searched(places: Iterable[str | Path], suffixes: Collection[str], owned: bool = False) -> _Search:
    search = _Search(tuple(sorted(suffix.lower() for suffix in suffixes)), owned)
    for place in places:
        search.place(str(Path(place)))
    return search


class _Search:
    """What was found so far, by where it really is, and what was refused. `owned`: students' own folders are searched
    to their depth, and what is refused in them is theirs."""

    def __init__(self, suffixes: tuple[str, ...], owned: bool):
        self.suffixes = suffixes
        self.owned = owned
        self.found: dict[tuple[str, str], _Found] = {}
        self.problems: list[Problem] = []
        self.unread: list[Unread] = []
        self.typed: set[str] = set()
        self.nothing: list[Problem] = []

    def place(self, place: str) -> None:
        """Look at one place. A link to a folder is followed where the user names it himself, and only there."""
        matches = [place] if os.path.lexists(place) else []
        if not matches and glob.has_magic(place):
            matches = sorted(glob.glob(place))
        if not matches:
            self.refuse(place, mistake(N_("there is no such file or folder")), empty=True)
        for match in matches:
            before = len(self.found), len(self.problems), len(self.unread)
            self.folder(match) if os.path.isdir(match) else self.file(match)
            after = len(self.found), len(self.problems), len(self.unread)
            if before == after and not self.known(match):
                self.refuse(
                    match, mistake(N_("there is no file %(kinds)s here"), kinds=self.kinds), empty=True
                )

    @property
    def kinds(self) -> str:
        return ", ".join(f"*{suffix}" for suffix in self.suffixes)

    def wanted(self, name: str) -> bool:
        """Whether the name has a suffix asked for, and is not what Macs and offices leave beside files."""
        last = name.rpartition("/")[2]
        return last.lower().endswith(self.suffixes) and not last.startswith(("._", "~$"))

    def refuse(
        self, place: str, problem: Problem, owner: str = "", other: bool = False, empty: bool = False
    ) -> None:
        """Of a student's own, what is refused is told with his work."""
        told = replace(problem, file=problem.file or file_label(Path(place).as_posix()))
        if self.owned and owner:
            self.unread.append(Unread(_owner(owner), told, other, empty))
        elif not other:
            self.problems.append(told)
            self.nothing += [told] if empty else []

    def pass_over(self, place: str, name: str, owner: str) -> None:
        """A file of another kind than those asked for."""
        if not self.owned or name.startswith((".", "~$")):
            return
        if _TYPED in place:
            self.typed.add(owner)
            problem = mistake(N_("text typed into Moodle is not read"), right=_FILL_IN)
        else:
            end = Path(name).suffix.lower()
            text = N_("this is none of %(kinds)s")
            problem = mistake(text, right=_CURES.get(end, _FILL_IN), kinds=self.kinds)
        self.refuse(place, problem, owner, other=True)

    def known(self, place: str) -> bool:
        """Whether the place was named before, so that it has nothing new."""
        real = os.path.abspath(place)
        return any(key[0] == real or key[0].startswith(real + os.sep) for key in self.found)

    def add(self, found: _Found) -> None:
        inside = found.name if found.member else ""
        where = found.place if found.member else os.path.join(found.place, found.name)
        self.found.setdefault((os.path.abspath(where), inside), found)

    def file(self, place: str) -> None:
        """A place that is no folder."""
        path = Path(place)
        if self.wanted(path.name):
            self.entry(place, str(path.parent), path.name, str(path.parent), path.stem)
        elif path.name.lower().endswith(".zip"):
            self.archive(place)
        elif path.name.lower().endswith(archive.ARCHIVES):
            self.refuse(place, mistake(N_("this archive is not read"), right=Message(N_("make it a ZIP"))))
        else:
            self.refuse(place, mistake(N_("the file is none of %(kinds)s"), kinds=self.kinds))

    def folder(self, place: str, scope: str = "", under: str = "") -> None:
        """Files of a folder, and of the folders in it: those are of a student each, or of one attempt of all."""
        scope = scope or place
        for entry in self.entries(place):
            if entry.name.startswith(".") and not self.wanted(entry.name):
                continue
            if not entry.is_dir(follow_symlinks=False) or self.wanted(entry.name):
                self.child(entry, place, scope, Path(entry.name).stem, under)
            elif self.owned and not under and ATTEMPT.fullmatch(entry.name):
                self.folder(entry.path, scope, f"{entry.name}/")
            else:
                self.student(scope, entry, under)

    def student(self, scope: str, folder: os.DirEntry[str], under: str = "") -> None:
        """A student's folder. One without a sheet is told where nothing else is told of it."""
        before = len(self.found), len(self.unread), len(self.problems)
        self.inside(folder.path, scope, folder.name, under, 1)
        if self.owned and before == (len(self.found), len(self.unread), len(self.problems)):
            self.refuse(folder.path, _NO_SHEET, folder.name, other=True, empty=True)

    def inside(self, folder: str, scope: str, owner: str, under: str, depth: int) -> None:
        """What is in a student's folder, or in one within it."""
        for entry in self.entries(folder):
            deeper = self.owned and entry.is_dir(follow_symlinks=False) and not self.wanted(entry.name)
            if not deeper:
                self.child(entry, folder, scope, owner, under)
            elif _MOODLE in entry.name:  # all submissions, in a folder around them
                self.student(scope, entry, under)
            elif depth < DEEPEST and not entry.name.startswith((".", "__MACOSX")):
                self.inside(entry.path, scope, owner, f"{under}{entry.name}/", depth + 1)

    def child(self, entry: os.DirEntry[str], place: str, scope: str, owner: str, under: str = "") -> None:
        """What lies in a folder: taken by its suffix; archives are told of, all else is passed over."""
        if self.wanted(entry.name):
            self.entry(entry.path, place, entry.name, scope, owner, under)
        elif entry.name.lower().endswith(archive.ARCHIVES):
            right = _CURES[".zip" if entry.name.lower().endswith(".zip") else ".7z"]
            text = N_("an archive in a folder is not opened")
            self.refuse(entry.path, mistake(text, right=right), owner)
        elif entry.is_symlink() and entry.is_dir():
            self.refuse(entry.path, mistake(N_("the folder is a link"), right=_ITSELF), owner)
        else:
            self.pass_over(entry.path, entry.name, owner)

    def entry(self, path: str, place: str, name: str, scope: str, owner: str, under: str = "") -> None:
        fault = _fault(path)
        if fault:
            self.refuse(path, fault, owner)
        else:
            self.add(_Found(place, name, scope, _owner(owner), None, f"{under}{name}"))

    def entries(self, folder: str) -> list[os.DirEntry[str]]:
        try:
            with os.scandir(folder) as found:
                return sorted(found, key=lambda entry: entry.name)
        except OSError as error:
            reason = os.strerror(error.errno or 0)
            self.refuse(folder, mistake(N_("the folder cannot be read: %(reason)s"), reason=reason))
            return []

    def archive(self, place: str) -> None:
        file = file_label(Path(place).as_posix())
        passed: list[str] = []
        try:
            with stream(place, file) as packed:
                members, problems = archive.members(packed, file, self.wanted, passed=passed)
        except ProblemError as error:
            self.problems += error.problems
            return
        refused = [(problem.file.removeprefix(f"{file}:"), problem) for problem in problems]
        names = [member.name for member in members]
        around = _around([*names, *(name for name in passed if name.count("/") > name.endswith("/"))])
        for member in sorted(members, key=lambda member: member.name):
            owner, within = _whose(member.name, around)
            self.add(_Found(place, member.name, f"{place}:", _owner(owner), member, within))
        for name, problem in refused:
            self.refuse(place, problem, _whose(name, around)[0])
        self.rest(file, passed, [*names, *(name for name, _ in refused)], around)

    def rest(self, file: str, passed: list[str], taken: list[str], around: str) -> None:
        """The files of an archive that were not asked for, and the folders of those who have nothing else."""
        others = [name for name in passed if not name.endswith("/")]
        for name in others:
            self.pass_over(f"{file}:{name}", name.rpartition("/")[2], _whose(name, around)[0])
        told = {_whose(name, around)[0] for name in (*taken, *others)}
        for name in passed:
            owner = _whose(f"{name}.", around)[0]
            if name.endswith("/") and name != around and owner not in told:
                told.add(owner)
                self.refuse(f"{file}:{name}", _NO_SHEET, owner, other=True, empty=True)


def _fault(path: str) -> Problem | None:
    """Why an entry of a folder cannot be a source."""
    try:
        os.path.basename(path).encode("utf-8")
    except UnicodeEncodeError:
        return mistake(N_("the file's name is not in UTF-8"), right=Message(N_("rename the file")))
    if os.path.islink(path):
        return mistake(N_("the file is a link"), right=Message(N_("name the file itself")))
    if os.path.isdir(path):
        return mistake(N_("this is a folder"))
    return None if os.path.isfile(path) else mistake(N_("this is not a regular file"))


def _whose(name: str, around: str) -> tuple[str, str]:
    """Of a file in an archive, whose it is and its name in his folder; a folder around all of them, which packing a
    folder gives, is nobody's name."""
    path = (name[len(around) :] if name.startswith(around) else name).split("/")
    marked = next((k for k, part in enumerate(path[:-1]) if _MOODLE in part), None)
    first = int(len(path) > 1 and ATTEMPT.fullmatch(path[0]) is not None)  # of all students
    if marked is None and len(path) == first + 1:
        return Path(path[first]).stem, "/".join(path)
    at = first if marked is None else marked
    return path[at], "/".join([*path[:at], *path[at + 1 :]])


def _around(names: list[str]) -> str:
    """The folder, with its `/`, in which all files of an archive lie; "" for a single file or a submission's folder."""
    first = {name.partition("/")[0] for name in names}
    if len(first) != 1 or len(names) < 2 or not all("/" in name for name in names):
        return ""
    (folder,) = first
    return "" if _MOODLE in folder else f"{folder}/"


def _owner(name: str) -> str:
    """Whose a folder or a file is, without what Moodle appends."""
    return name.partition(_MOODLE)[0] or name


def _named(found: list[_Found]) -> list[Source]:
    """Sources with ids: the owner's for one's only file, with the file's name behind it where there are several."""
    shared = Counter((item.scope, item.owner) for item in found)
    owners = list(shared)
    several = [item for item in found if shared[item.scope, item.owner] > 1]
    names = [(owner, f"{Path(scope).as_posix()}/{owner}") for scope, owner in owners]
    names += [(f"{item.owner}-{_tail(item)}", _key(item)) for item in several]
    made = ids.unique(names)
    groups = dict(zip(owners, made, strict=False))
    own = dict(zip(several, made[len(owners) :], strict=True))
    return [_source(item, groups[item.scope, item.owner], own.get(item)) for item in found]


def _source(item: _Found, group: str, own: str | None) -> Source:
    return Source(own or group, group, item.place, item.name, item.member, item.owner, item.within)


def _tail(item: _Found) -> str:
    """What tells one's several files apart: the name, of files named after their owner the suffix."""
    path = Path(item.name)
    return path.suffix[1:] if path.stem == item.owner else path.name


def _key(item: _Found) -> str:
    if item.member is not None:  # a//b and a/b are two names there
        return f"file {Path(item.place).as_posix()}/{item.name}"
    return "file " + Path(item.place, item.name).as_posix()


def _label(place: str, name: str, packed: bool) -> str:
    folder = Path(place)
    with suppress(ValueError):
        return file_label(f"{folder.as_posix()}:{name}" if packed else (folder / name).as_posix())
    return file_label(name)
