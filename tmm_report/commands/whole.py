"""A set of files put into a folder as a whole: whenever the program is stopped, there is the old or the new set.

Beside the files stands a list of what was written, `.tmm-report.json`. New files and their list are first made in a
folder `.tmm-report.part`; when it is complete it is renamed `.tmm-report.new`. From that moment on the new set holds:
its files go to their places, its list last. Stopped before, the old set stands untouched; stopped after, the next run
(of any variant into this folder) first finishes what was begun. Nothing else in the folder is touched, and nothing
outside of it, whatever lists and links a folder from elsewhere holds.

What the user has changed since is known by the list; it is kept beside, as note.tex.bak.
"""

from __future__ import annotations

import errno
import json
import os
import shutil
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import field
from hashlib import sha256
from pathlib import Path, PurePosixPath
from time import sleep

from tmm_report.records import dataclass

LIST = ".tmm-report.json"
PART = ".tmm-report.part"
NEW = ".tmm-report.new"
MOST = 4 << 20  # bytes of a list that is read
LARGEST = 64 << 20  # bytes of a file that is looked into; none of a set is as large
LONGEST = 200  # bytes of a name
WAIT, WAITS = 0.05, 200  # s between two looks whether another run has done; it takes milliseconds


@dataclass(frozen=True)
class Entry:
    """A file of a set: the digest of its content, and that of what it was made from."""

    digest: str
    source: str


@dataclass(frozen=True)
class Plan:
    """What is to be done when a new set takes the place of the old one, by names under the folder.

    `entries`: the list of the set. `keeps`: what the user changed, and the name under which it is kept. `goes`: files
    of the old set that have no place in the new one.
    """

    entries: Mapping[str, Entry]
    keeps: Mapping[str, str] = field(default_factory=dict)
    goes: Sequence[str] = ()


@dataclass(frozen=True)
class Put:
    """`kept`: what the user had changed, by the name under which it stands now. `left`: files of earlier runs, of
    another variant or version, that were not asked for and stay."""

    kept: Mapping[str, str]
    left: Sequence[str]


def put(folder: Path, files: Mapping[str, bytes], source: str = "") -> Put:
    """Write a set; `source` tells what it is made from. Raises OSError, the folder being as it was; BlockingIOError
    where another run does not come to its end."""
    made = _missing(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with alone(folder):
            finish(folder)
            return _put(folder, files, source)
    except BaseException:
        for one in made:  # what was made for nothing
            with suppress(OSError):
                one.rmdir()
        raise


def finish(folder: Path) -> None:
    """Finish what a run that was stopped had begun, or take it away. Raises OSError."""
    begun = _plan(folder / NEW / LIST) if _own(folder / NEW) else Plan({})
    if begun.entries:
        _see_free(folder, [name for name in begun.entries if (folder / NEW / name).is_file()], begun)
        _apply(folder, begun)
    for name in (NEW, PART):  # a set that is in its place, or was never complete
        _away(folder / name)


def _put(folder: Path, files: Mapping[str, bytes], source: str) -> Put:
    old = _plan(folder / LIST).entries
    new = {name: Entry(_digest(content), source) for name, content in files.items()}
    stays = {name: entry for name, entry in old.items() if name not in new}
    goes = [name for name in stays if _same_kind(name, new)]
    keeps = _kept(folder, old, new, goes)
    left = {name: entry for name, entry in stays.items() if name not in goes and (folder / name).is_file()}
    plan = Plan({**left, **new}, keeps, goes)
    _see_free(folder, [*files, LIST], plan)
    _stage(folder, files, plan)
    os.rename(folder / PART, folder / NEW)
    try:
        _apply(folder, plan)
    except KeyboardInterrupt:
        _apply(folder, plan)
        raise
    return Put(keeps, [name for name, entry in left.items() if entry.source != source])


def _same_kind(name: str, new: Mapping[str, Entry]) -> bool:
    """Whether a file would have been written anew if it still belonged to the set: a figure, a table."""
    own = PurePosixPath(name)
    return len(own.parts) > 1 and any(own.suffix == PurePosixPath(other).suffix for other in new)


# ---------------------------------------------------------------- what the user has changed


def _kept(
    folder: Path, old: Mapping[str, Entry], new: Mapping[str, Entry], goes: Sequence[str]
) -> dict[str, str]:
    """The files that the user has changed and that are replaced or go, each with a free name to keep it under.

    Of a file that is on no list nobody knows; one at the top of the folder counts as changed, a figure does not.
    """
    names = [*new, *goes]
    found = {}
    for name in names:
        here = folder / name
        if not here.is_file() or (name not in old and "/" in name):
            continue
        digest = _digest(here.read_bytes()) if here.stat().st_size <= LARGEST else ""
        if digest not in {entry.digest for entry in (old.get(name), new.get(name)) if entry is not None}:
            found[name] = _free(folder, f"{name}.bak")
    return found


def _free(folder: Path, name: str) -> str:
    """The name, with the first number behind it that makes it one that nothing has."""
    names = (name, *(f"{name}{number}" for number in range(2, 10_000)))
    return next((one for one in names if not os.path.lexists(folder / one)), f"{name}10000")


# ---------------------------------------------------------------- the steps


def _see_free(folder: Path, files: Sequence[str], plan: Plan) -> None:
    """See that every file can take its place, before anything is moved. Raises OSError."""
    device = folder.stat().st_dev
    for parent in {folder / part for name in (*files, *plan.goes, *plan.keeps) for part in _above(name)}:
        if os.path.lexists(parent) and (parent.is_symlink() or not parent.is_dir()):  # a link leads elsewhere
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(parent))
    for target in (folder / name for name in files):
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
        if target.parent.is_dir() and target.parent.stat().st_dev != device:
            raise OSError(errno.EXDEV, os.strerror(errno.EXDEV), str(target))
        if sys.platform == "win32" and target.exists():  # one that is open elsewhere cannot be replaced there
            target.open("r+b").close()


def _above(name: str) -> Sequence[str]:
    """The folder of a file under the folder, if it is in one."""
    return name.split("/")[:-1]


def _stage(folder: Path, files: Mapping[str, bytes], plan: Plan) -> None:
    """Make the new set and its plan in a folder of its own. Raises OSError."""
    part = folder / PART
    part.mkdir()  # and no other one
    try:
        for name, content in {**files, LIST: _text(plan)}.items():
            target = part / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise


def _apply(folder: Path, plan: Plan) -> None:
    """Give the staged files their places. Stopped anywhere, it goes on where it was: what is moved is not staged
    any more. Raises OSError."""
    staged = folder / NEW
    for name in plan.entries:
        if (staged / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            _keep(folder, name, plan)
            os.replace(staged / name, folder / name)
    for name in plan.goes:
        if (folder / name).is_dir():
            continue
        _keep(folder, name, plan)
        (folder / name).unlink(missing_ok=True)
        with suppress(OSError):  # the user's own files are in it
            (folder / name).parent.rmdir()
    with suppress(FileNotFoundError):  # all was done already
        os.replace(staged / LIST, folder / LIST)
    shutil.rmtree(staged, ignore_errors=True)


def _keep(folder: Path, name: str, plan: Plan) -> None:
    """Move what the user has changed out of the way, unless that is done."""
    if name in plan.keeps and not os.path.lexists(folder / plan.keeps[name]):
        with suppress(FileNotFoundError):
            os.rename(folder / name, folder / plan.keeps[name])


# ---------------------------------------------------------------- the list


def _text(plan: Plan) -> bytes:
    """As it stands in the folder; what it says to keep and to take away is done by then."""
    files = {name: [one.digest, one.source] for name, one in sorted(plan.entries.items())}
    data = {"files": files, "keeps": dict(plan.keeps), "goes": list(plan.goes)}
    return (json.dumps({key: value for key, value in data.items() if value}, indent=0) + "\n").encode()


def _plan(path: Path) -> Plan:
    """What a list says; nothing, where there is none or it is not one of ours."""
    if not path.is_file():  # one of no end, a pipe
        return Plan({})
    try:
        with path.open("rb") as stream:
            data = json.loads(stream.read(MOST))
        entries = {name: Entry(*map(str, pair)) for name, pair in data.get("files", {}).items()}
        plan = Plan(entries, dict(data.get("keeps", {})), list(data.get("goes", ())))
    except (OSError, ValueError, TypeError, AttributeError, RecursionError):
        return Plan({})
    names = [*entries, *plan.goes, *plan.keeps, *plan.keeps.values()]
    return plan if all(map(_inside, names)) else Plan({})


def _inside(name: object) -> bool:
    """Whether a name is one under the folder: of letters, at most two deep, that leads nowhere else, none of the
    hidden ones that are the program's own."""
    if not isinstance(name, str) or not name.isprintable() or len(name.encode()) > LONGEST:
        return False
    parts = name.split("/")
    return len(parts) <= 2 and not any(
        part.startswith(".") or not part or set(part) & set('\\:<>|"?*') for part in parts
    )


def _own(staged: Path) -> bool:
    """Whether a folder is one that was made here: no link, and none in it."""
    return not staged.is_symlink() and not any(path.is_symlink() for path in staged.rglob("*"))


def _away(path: Path) -> None:
    """Remove a folder, or what stands under its name."""
    if path.is_symlink() or path.is_file():
        path.unlink()
    else:
        shutil.rmtree(path, ignore_errors=True)


def _digest(content: bytes) -> str:
    return sha256(content).hexdigest()


# ---------------------------------------------------------------- the folder


def _missing(folder: Path) -> list[Path]:
    """The folders that have to be made, the innermost first."""
    found = []
    for one in (folder, *folder.parents):
        if os.path.lexists(one):
            break
        found.append(one)
    return found


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """No other run puts a set into the folder meanwhile, where the system can see to it; a lock ends with its run.
    Raises BlockingIOError where another one goes on for long."""
    if sys.platform == "win32":
        yield
        return
    import fcntl

    handle = os.open(folder, os.O_RDONLY)
    try:
        for left in range(WAITS, -1, -1):
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if not left:
                    raise
                sleep(WAIT)
            except OSError:  # a network drive may know no locks
                break
        yield
    finally:
        os.close(handle)
