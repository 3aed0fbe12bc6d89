"""A template filled in for one student: the text of a complete variant, from parts that are made once for all."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping

from tmm_report.assignments.emit import Piece, pieces, scalar
from tmm_report.assignments.model import Parameter, Template
from tmm_report.assignments.numbers import Cell
from tmm_report.records import dataclass
from tmm_report.yamlread import Path

TITLE = ("student", "group", "variant")
"""What of the title page is each student's own."""


@dataclass(frozen=True, eq=False)
class Form:
    """The template's text with holes for the parameters and for the student."""

    template: Template
    parts: tuple[Piece, ...]

    def text(
        self, parameters: Iterable[Parameter], cells: Mapping[str, Cell], person: Mapping[str, str]
    ) -> bytes:
        """The variant with these values; of a person of the template's group, or of none, it keeps the template's,
        which may be named in several languages.

        Raises WrongValue or ValueError for a value that cannot stand in its place.
        """
        texts: dict[Path, str] = {}
        for parameter in parameters:
            texts |= parameter.texts(cells[parameter.name], self.template)
        texts |= {("title", key): _text(person.get(key, "")) for key in TITLE}
        if person.get("group", "") in ("", self.template.group):
            texts["title", "group"] = self._group()
        return "".join(part if isinstance(part, str) else texts[part] for part in self.parts).encode()

    def _group(self) -> str:
        """The template's group, by languages as it may be."""
        stated = self.template.title.get("group")
        by_language = isinstance(stated, dict)
        return json.dumps(stated, ensure_ascii=False) if by_language else _text(self.template.group)


def form(template: Template, parameters: Iterable[Parameter]) -> Form:
    """The form in which all these parameters are written."""
    title = {**template.title, **{key: "" for key in TITLE if key not in template.title}}
    data = {"title": title, **{key: value for key, value in template.data.items() if key != "title"}}
    holes = {path for parameter in parameters for path in parameter.paths}
    holes |= {("title", key) for key in TITLE}
    return Form(template, tuple(pieces(data, template.raw, holes)))


def _text(text: str) -> str:
    """A text of the title page; the page takes a number as it is written."""
    return text if re.fullmatch("[0-9]{1,9}", text) else scalar(text)
