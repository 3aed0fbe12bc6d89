"""ZIP archives from outside: listed and read in memory under limits; nothing is ever unpacked to a disk.

The directory of an archive is read once. A `Member` holds all that is needed to read its file later, in another
process too, so that a thousand files do not cost a thousand readings of the directory.
"""

from __future__ import annotations

import io
import re
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import replace
from typing import Any, BinaryIO

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.records import dataclass
from tmm_report.yamlread import composed

MEMBER = 5 * 2**20
TOTAL = 200 * 2**20
RATIO = 100
MEMBERS = 20_000
ARCHIVES = (".zip", ".7z", ".rar", ".tar", ".tgz", ".gz", ".bz2", ".xz", ".zst")

_DIRECTORY = 4 * 2**20  # bytes of an archive's directory: 200 for each of MEMBERS
_SMALL = 64 * 1024  # so small a file is harmless, however well it is packed
_UTF8_FLAG, _ENCRYPTED_FLAGS = 0x800, 0x2041
_LOCAL = struct.Struct("<4s22x2H")  # of a member's own head: signature, lengths of name and extra field
_METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
_BROKEN = (
    zipfile.BadZipFile, NotImplementedError, struct.error, ValueError, OverflowError, EOFError, OSError,
)  # fmt: skip
_MAKE_ZIP = Message(N_("make an ordinary ZIP archive"))


@dataclass(frozen=True, slots=True)
class Member:
    """A file in an archive: its name with `/` between folders, and where and how it is packed."""

    name: str
    offset: int
    packed: int
    size: int
    method: int
    crc: int


def members(
    stream: BinaryIO,
    file: str,
    wanted: Callable[[str], bool] = lambda name: True,
    *,
    each: int = MEMBER,
    total: int = TOTAL,
    passed: list[str] | None = None,
) -> tuple[list[Member], list[Problem]]:
    """The files of an archive whose names are wanted, and what was refused of it; `file` names it in messages. Names
    that are not wanted, those of folders among them, are added to `passed`.

    Refused are names that lead elsewhere, links, archives, what is encrypted, larger than `each` bytes or packed
    too well. Raises ProblemError for an archive that cannot be read, or is larger than `total` altogether.
    """
    found: dict[str, Member] = {}
    problems: list[Problem] = []
    for info in _directory(stream, file):
        name = _name(info)
        fault = _fault(info, name, wanted, each) or (_TWIN if name in found else None)
        if fault:
            problems.append(replace(fault, file=f"{file}:{shown(name, 200)}"))
        elif wanted(name) and not name.endswith("/"):
            found[name] = Member(
                name, info.header_offset, info.compress_size, info.file_size, info.compress_type, info.CRC
            )
        elif passed is not None and not _junk(name):
            passed.append(name)
    if sum(member.size for member in found.values()) > total:
        raise _refused(
            file, N_("the files of the archive are larger than %(limit)s MB"), limit=total // 2**20
        )
    return list(found.values()), problems


_TWIN = mistake(N_("the archive holds this name twice"), right=Message(N_("keep one")))


def content(stream: BinaryIO, member: Member, file: str) -> bytes:
    """The bytes of a member; `file` names it in messages. Never more than the archive's directory said.

    Raises ProblemError where the archive does not hold what its directory said.
    """
    try:
        stream.seek(member.offset)
        signature, name, extra = _LOCAL.unpack(stream.read(_LOCAL.size))
        stream.seek(name + extra, io.SEEK_CUR)
        data = _unpacked(stream.read(member.packed), member)
    except (struct.error, zlib.error, ValueError, OverflowError, OSError):
        signature, data = b"", b""
    if signature != b"PK\3\4" or len(data) != member.size or zlib.crc32(data) != member.crc:
        raise _refused(file, N_("the archive is broken here"))
    return data


def _unpacked(data: bytes, member: Member) -> bytes:
    if member.method == zipfile.ZIP_STORED:
        return data
    return zlib.decompressobj(-zlib.MAX_WBITS).decompress(data, member.size + 1)


def _directory(stream: BinaryIO, file: str) -> list[zipfile.ZipInfo]:
    """What the archive says of its files, directories of whole files alone; too many are not even listed."""
    try:
        with zipfile.ZipFile(_Sparing(stream)) as archive:  # type: ignore[arg-type]
            found = archive.infolist()
    except _TooMuch:
        raise _refused(file, N_("the archive holds more than %(limit)s files"), limit=MEMBERS) from None
    except _BROKEN:
        raise _refused(file, N_("this is not a ZIP archive, or it is broken"), _MAKE_ZIP) from None
    if len(found) > MEMBERS:
        raise _refused(file, N_("the archive holds more than %(limit)s files"), limit=MEMBERS)
    return found


class _TooMuch(Exception):
    """More was to be read at once than a directory of MEMBERS files takes."""


class _Sparing:
    """A stream of which zipfile, which reads a directory at once whatever its size, gets no more than it should."""

    def __init__(self, stream: BinaryIO):
        self.seek, self.tell, self.stream = stream.seek, stream.tell, stream

    def read(self, size: int = -1) -> bytes:
        if size > _DIRECTORY:
            raise _TooMuch
        return self.stream.read(size if size >= 0 else _DIRECTORY)


def _fault(info: zipfile.ZipInfo, name: str, wanted: Callable[[str], bool], each: int) -> Problem | None:
    """Why a member is refused, if it is: leaving the archive first, whatever kind of file it would be."""
    if _climbs(name):
        return mistake(N_("the name leads out of the archive"))
    if _special(info):
        return mistake(N_("the file is a link"), right=Message(N_("pack the file itself")))
    if name.lower().endswith(ARCHIVES) and not _junk(name):
        return mistake(N_("an archive within an archive is not opened"), right=Message(N_("pack its files")))
    if not wanted(name.rstrip("/")):
        return None
    return mistake(N_("this is a folder")) if name.endswith("/") else _packing(info, each)


def _packing(info: zipfile.ZipInfo, each: int) -> Problem | None:
    if info.flag_bits & _ENCRYPTED_FLAGS:
        return mistake(N_("the file is encrypted"), right=Message(N_("pack it without a password")))
    if info.compress_type not in _METHODS:
        return mistake(N_("the file is packed in an unusual way"), right=_MAKE_ZIP)
    if info.file_size > each or info.compress_size > each + _SMALL:
        return mistake(N_("the file is larger than %(limit)s kB"), limit=each // 1024)
    if info.file_size > max(_SMALL, RATIO * info.compress_size):
        return mistake(N_("the file is packed more than %(limit)s times, as no honest one is"), limit=RATIO)
    return None


def _climbs(name: str) -> bool:
    return bool(re.match(r"/|[A-Za-z]:", name)) or ".." in name.split("/") or "\0" in name


def _special(info: zipfile.ZipInfo) -> bool:
    """A link, a pipe, a device: what Unix notes of a file in the upper half of its attributes."""
    kind = stat.S_IFMT(info.external_attr >> 16)
    return kind not in (0, stat.S_IFREG, stat.S_IFDIR)


def _junk(name: str) -> bool:
    """What a Mac packs beside each file."""
    return name.startswith("__MACOSX/") or name.rpartition("/")[2].startswith("._")


def _name(info: zipfile.ZipInfo) -> str:
    """The member's name, composed, `/` between folders; names without the mark of UTF-8 are read as they may be."""
    name = info.orig_filename
    if not info.flag_bits & _UTF8_FLAG:
        name = _guessed(name.encode("cp437", "replace"))
    name = name.replace("\\", "/")
    try:
        return composed(name)
    except ValueError:  # such a name is nobody's: it is not worth the time to compose it
        return name


def _guessed(name: bytes) -> str:
    """UTF-8 without the mark (Macs), letters of DOS (a Russian Windows) or of Windows, else as zipfile has it."""
    for encoding in ("utf-8", "cp866", "cp1251"):
        try:
            text = name.decode(encoding)
        except UnicodeDecodeError:
            continue
        if encoding == "utf-8" or _russian(text):
            return text
    return name.decode("cp437")


def _russian(text: str) -> bool:
    """Whether all beyond ASCII are Russian letters, and no word mixes them with Latin ones."""
    beyond = re.sub(r"[\x00-\x7f]|№", "", text)
    return bool(re.fullmatch("[А-Яа-яЁё]+", beyond)) and not re.search(
        "[A-Za-z][А-яЁё]|[А-яЁё][A-Za-z]", text
    )


def _refused(file: str, text: str, right: Message | None = None, **values: Any) -> ProblemError:
    return ProblemError([replace(mistake(text, (), right, **values), file=file)])
