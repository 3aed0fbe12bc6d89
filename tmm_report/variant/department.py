"""What a department states for all of its variants, in a file beside them; a variant's own keys go before it.

The file stands in the folder of the variant, `department.yaml` or `кафедра.yaml`; none is looked for anywhere else.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from tmm_report import yamlread
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.profiles import merged
from tmm_report.records import dataclass
from tmm_report.yamlread import Document, OfFile

NAMES = ("department.yaml", "кафедра.yaml")
TEMPLATES = ("department.j2", "кафедра.j2")
LARGEST = 32 * 1024  # bytes of a template
KEYS = ("title", "assignment", "note", "profile", "drawing", "language", "decimal_sign", "words")


@dataclass(frozen=True)
class Department:
    """The text of its file, and how messages name that; the text and the name of its template, where it has one."""

    text: bytes
    file: str
    template: tuple[bytes, str] | None = None

    @property
    def told(self) -> bytes:
        """All that a note depends on."""
        return self.text + (self.template[0] if self.template else b"")


def beside(variant: str | os.PathLike[str]) -> Department | None:
    """The department's file in the folder of a variant; None: it has none. Raises ProblemError for one that cannot be
    read, or for two."""
    path = Path(os.fspath(variant))
    text, template = _one(path.parent, NAMES, yamlread.BYTES), _one(path.parent, TEMPLATES, LARGEST)
    if path.name in NAMES or (text is None and template is None):
        return None
    return Department(*(text or (b"", "")), template)


def _one(folder: Path, names: tuple[str, ...], largest: int) -> tuple[bytes, str] | None:
    """The text of the one file of these names, and how messages name it."""
    found = [folder / name for name in names if os.path.lexists(folder / name)]
    if len(found) > 1:
        right = Message(N_("keep one of them"))
        wrong = mistake(
            N_("two files state what the department wants: %(files)s"), right=right, files=", ".join(names)
        )
        raise ProblemError([replace(wrong, file=yamlread.file_label(folder))])
    if not found:
        return None
    label = yamlread.file_label(found[0])
    return yamlread.opened(found[0], label, largest), label


def is_one(name: str) -> bool:
    """Whether a file of this name is a department's and no variant."""
    return name in NAMES


def read(department: Department) -> Document:
    """Its file as data with places. Raises ProblemError for what is no YAML, and for keys that are a variant's own."""
    if not department.text.strip():
        return Document({})
    document = yamlread.loads(department.text, department.file)
    if not isinstance(document.data, dict):
        wrong = mistake(N_("keys with values are expected here"))
        raise ProblemError([yamlread.located(wrong, document.places, department.file)])
    right = Message(N_("a department states: %(keys)s"), {"keys": ", ".join(KEYS)})
    foreign = [
        mistake(N_("%(key)s belongs to a variant, not to its department"), (key,), right, key=key)
        for key in document.data
        if key not in KEYS
    ]
    if foreign:
        raise ProblemError([yamlread.located(one, document.places, department.file) for one in foreign])
    return document


def under(document: Document, department: Document, file: str) -> Document:
    """A variant over what its department states; mistakes of that keep the department's file and place."""
    if not isinstance(document.data, dict):
        return document
    own: Mapping[str, Any] = department.data
    if "mechanism" not in document.data:  # plans are drawn of a mechanism alone
        own = {key: value for key, value in own.items() if key != "drawing"}
    theirs = document.data
    if isinstance(own.get("profile"), str) and isinstance(theirs.get("profile"), dict):
        own = {**own, "profile": {"base": own["profile"]}}

    def foreign(found: Mapping[Any, Any]) -> dict[Any, Any]:
        return {path: value for path, value in found.items() if path not in document.places}

    places = {path: OfFile(place, file) for path, place in foreign(department.places).items()}
    return Document(
        merged(own, theirs),
        {**places, **document.places},
        {**foreign(department.raw), **document.raw},
        {**foreign(department.commas), **document.commas},
    )
