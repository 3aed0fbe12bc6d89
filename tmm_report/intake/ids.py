"""Names for outputs made of foreign names: legal in a folder of every system, and no two alike in any of them."""

from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Iterable, Sequence

LENGTH = 60
_HASHES = (0, 8, 16, 40)  # hexadecimal digits of the hash that is appended, by how often a name was taken
_RESERVED = {"con", "prn", "aux", "nul", "conin", "conout"}
_RESERVED |= {f"{port}{number}" for port in ("com", "lpt") for number in range(10)}


def safe(name: str) -> str:
    """The name with letters and digits of any alphabet and `._-` kept, all else `_`; at most `LENGTH` characters.

    It begins with neither dot nor dash, ends with no dot, and is no device of Windows.
    """
    composed = unicodedata.normalize("NFC", name[: 4 * LENGTH])
    kept = "".join(c if c.isalnum() or c in "._-" else "_" for c in composed)
    kept = kept.lstrip(".-")[:LENGTH].rstrip(".") or "_"
    return "_" + kept[: LENGTH - 1].rstrip(".") if _folded(kept).partition(".")[0] in _RESERVED else kept


def unique(names: Sequence[tuple[str, str]]) -> list[str]:
    """A safe name for each (name, what it is told apart by); the second parts differ.

    Names that Windows or macOS would take for one another get a short hash of the second part, each of them, so
    that nobody's name depends on the order.
    """
    level = [0] * len(names)
    made = [safe(name) for name, _ in names]
    while taken := _alike(made):
        if all(level[index] == len(_HASHES) - 1 for index in taken):
            raise ValueError("two names have the same second part")
        for index in taken:
            level[index] = min(level[index] + 1, len(_HASHES) - 1)
            made[index] = _hashed(*names[index], _HASHES[level[index]])
    return made


def _alike(names: Iterable[str]) -> list[int]:
    """Indexes of all names that another one equals, whatever case and composition."""
    first: dict[str, int] = {}
    found: set[int] = set()
    for index, name in enumerate(names):
        other = first.setdefault(_folded(name), index)
        if other != index:
            found |= {index, other}
    return sorted(found)


def _hashed(name: str, key: str, digits: int) -> str:
    digest = hashlib.sha256(key.encode("utf-8", "surrogatepass")).hexdigest()[:digits]
    return f"{safe(name)[: LENGTH - digits - 1]}-{digest}"


def _folded(name: str) -> str:
    """What file systems that ignore case and composition may compare; it takes rather more for alike than they do."""
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", name).upper().casefold())
