"""Where files from outside come from: files, folders, patterns, ZIP archives; each found once, named, read later.

A `Source` holds no content, so that a million of them can be listed and handed to other processes.
"""

from __future__ import annotations

import glob
import os
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tmm_report.intake import archive, ids
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass
from tmm_report.yamlread import file_label, opened, stream

BYTES = archive.MEMBER  # of one file

_ITSELF = Message(N_("name the folder itself"))
_MOODLE = (
    "_assignsubmission_"  # what Moodle puts behind "name_number" of a folder, or of a file, of submissions
)


@dataclass(frozen=True, slots=True)
class Source:
    """A file from outside. `id`: a safe name for what is made of it, no other source's. `group`: the id of whom it
    belongs to: several files in a student's folder share it. `name`: of the file within `place`, a folder or a ZIP
    archive; its end says what kind of file it is.
    """

    id: str
    group: str
    place: str
    name: str
    member: archive.Member | None = None

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


class _Found(NamedTuple):
    """A file before it has an id. `owner`: as its folder or its stem names it, among those of `scope`."""

    place: str
    name: str
    scope: str
    owner: str
    member: archive.Member | None = None


def sources(places: Iterable[str | Path], suffixes: Collection[str]) -> tuple[list[Source], list[Problem]]:
    """The files with one of the suffixes (".yaml", in any case) at the places, and what was refused there.

    A place is a file, a folder (its files, and those in the folders of students directly in it), a pattern with
    `*?[]`, or a ZIP archive (likewise). A file found twice counts once. Files come in the order of the places, of one
    place in the order of their names.
    """
    search = _Search(tuple(sorted(suffix.lower() for suffix in suffixes)))
    for place in places:
        search.place(str(Path(place)))
    return _named(list(search.found.values())), search.problems


class _Search:
    """What was found so far, by where it really is, and what was refused."""

    def __init__(self, suffixes: tuple[str, ...]):
        self.suffixes = suffixes
        self.found: dict[tuple[str, str], _Found] = {}
        self.problems: list[Problem] = []

    def place(self, place: str) -> None:
        """Look at one place. A link to a folder is followed where the user names it himself, and only there."""
        matches = [place] if os.path.lexists(place) else []
        if not matches and glob.has_magic(place):
            matches = sorted(glob.glob(place))
        if not matches:
            self.refuse(place, mistake(N_("there is no such file or folder")))
        for match in matches:
            before = len(self.found), len(self.problems)
            self.folder(match) if os.path.isdir(match) else self.file(match)
            if before == (len(self.found), len(self.problems)) and not self.known(match):
                self.refuse(match, mistake(N_("there is no file %(kinds)s here"), kinds=self.kinds))

    @property
    def kinds(self) -> str:
        return ", ".join(f"*{suffix}" for suffix in self.suffixes)

    def wanted(self, name: str) -> bool:
        """Whether the name has a suffix asked for, and is not what Macs and offices leave beside files."""
        last = name.rpartition("/")[2]
        return last.lower().endswith(self.suffixes) and not last.startswith(("._", "~$"))

    def refuse(self, place: str, problem: Problem) -> None:
        self.problems.append(replace(problem, file=problem.file or file_label(Path(place).as_posix())))

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

    def folder(self, place: str) -> None:
        """Files of a folder, and of the folders in it: those are of a student each."""
        for entry in self.entries(place):
            if entry.name.startswith(".") and not self.wanted(entry.name):
                continue
            if entry.is_dir(follow_symlinks=False) and not self.wanted(entry.name):
                self.student(place, entry)
            else:
                self.child(entry, place, place, Path(entry.name).stem)

    def student(self, scope: str, folder: os.DirEntry[str]) -> None:
        for entry in self.entries(folder.path):
            self.child(entry, folder.path, scope, folder.name)

    def child(self, entry: os.DirEntry[str], place: str, scope: str, owner: str) -> None:
        """What lies in a folder: taken by its suffix; archives are told of, all else is passed over."""
        if self.wanted(entry.name):
            self.entry(entry.path, place, entry.name, scope, owner)
        elif entry.name.lower().endswith(archive.ARCHIVES):
            right = Message(N_("name the archive itself"))
            self.refuse(entry.path, mistake(N_("an archive in a folder is not opened"), right=right))
        elif entry.is_symlink() and entry.is_dir():
            self.refuse(entry.path, mistake(N_("the folder is a link"), right=_ITSELF))

    def entry(self, path: str, place: str, name: str, scope: str, owner: str) -> None:
        fault = _fault(path)
        if fault:
            self.refuse(path, fault)
        else:
            self.add(_Found(place, name, scope, _owner(owner)))

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
        try:
            with stream(place, file) as packed:
                members, problems = archive.members(packed, file, self.wanted)
        except ProblemError as error:
            members, problems = [], error.problems
        self.problems += problems
        for found in _packed(place, sorted(members, key=lambda member: member.name)):
            self.add(found)


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


def _packed(place: str, members: list[archive.Member]) -> Iterator[_Found]:
    """The files of an archive; a folder around all of them, which packing a folder gives, is nobody's name."""
    around = _around([member.name for member in members])
    for member in members:
        path = member.name[len(around) :].split("/")
        owner = path[0] if len(path) > 1 else Path(path[0]).stem
        yield _Found(place, member.name, f"{place}:", _owner(owner), member)


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
    return Source(own or group, group, item.place, item.name, item.member)


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
