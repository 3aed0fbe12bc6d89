"""The page of the gallery: an entry for every variant, as Markdown, and its scheme as SVG."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from urllib.parse import quote

from markupsafe import Markup

from tmm_report.course import LeverFound, Results, summary
from tmm_report.figures.drawing import Drawing, polygon, svg
from tmm_report.i18n import Translator
from tmm_report.mechanics.lever.assur_groups import ROMAN
from tmm_report.mechanics.lever.cycle import Extreme, larger
from tmm_report.note import picture as drawing_of
from tmm_report.problems import Message, Problem, in_language
from tmm_report.records import dataclass
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template


@dataclass(frozen=True, eq=False)
class Entry:
    """One variant of the gallery: what was found, and what is wrong with it.

    `problems`: the mistakes that stop it, or where it cannot be assembled though it is meant to go all round.
    """

    file: Path
    results: Results | None = None
    problems: tuple[Problem, ...] = ()

    @property
    def name(self) -> str:
        return self.file.stem

    @property
    def picture(self) -> str:
        return f"{self.name}.svg"

    def topic(self, tr: Translator) -> str:
        """What it is about, on one line."""
        stated = self.results.variant.title.topic if self.results is not None else ""
        return " ".join(in_language(stated, tr.gettext).split()) or self.name

    @property
    def mistake(self) -> Problem:
        """The first mistake, by its place in the file."""
        return replace(self.problems[0], file="")

    @property
    def anchor(self) -> str:
        """Where the entry's heading is, as sites that show Markdown make it."""
        return re.sub(r"[^\w -]", "", self.name.lower()).replace(" ", "-")

    @property
    def lever(self) -> LeverFound | None:
        """What was found, if there is a lever mechanism in it."""
        return self.results.lever if self.results is not None else None

    @property
    def class_(self) -> str:
        return ROMAN[self.lever.structure.mechanism_class] if self.lever is not None else ""

    @property
    def gaps(self) -> list[Message]:
        """Over which part of the cycle it cannot be assembled, and what would cure it."""
        return [gap.text for gap in self.lever.kinematics.gaps] if self.lever is not None else []

    @property
    def gears(self) -> list[Message]:
        """What was found of its gears."""
        return [*summary(self.results)] if self.results is not None else []

    @cached_property
    def balancing(self) -> Extreme | None:
        """The balancing moment that is greatest by magnitude, N m."""
        found = self.lever.kinetostatics if self.lever is not None else None
        return larger(found.extremes) if found is not None and found.bounded else None

    @cached_property
    def worst(self) -> float | None:
        """The power of ten under which all checks of the balancing moment disagree, relative; 0: they agree exactly.

        Rounding errors differ from machine to machine, their order of magnitude hardly.
        """
        found = self.lever.kinetostatics if self.lever is not None else None
        if found is None:
            return None
        worst = max(found.worst_lever, found.worst_power)
        return 10.0 ** math.ceil(math.log10(worst)) if worst > 0 else 0.0


class Markdown(Html):
    """Text of a Markdown page: what could be markup there, or HTML, stands as it is written."""

    def escape(self, text: str) -> Markup:
        return super().escape(re.sub(r"[\\`*\[\]#|~$]|(?<!\w)_|_(?!\w)", r"\\\g<0>", text))


def picture(entry: Entry, tr: Translator) -> dict[str, bytes]:
    """The scheme as the note draws it, on white, by its name; nothing for what is not solved."""
    if entry.results is None:
        return {}
    drawn = replace(drawing_of(entry.results, Page(Html(), tr, Numbering())), title=entry.topic(tr))
    return {entry.picture: (svg(_on_white(drawn)) + "\n").encode()}


def _on_white(drawing: Drawing) -> Drawing:
    """Black lines must be seen on a dark page too."""
    left, bottom, right, top = drawing.box
    corners = [complex(left, bottom), complex(right, bottom), complex(right, top), complex(left, top)]
    return replace(drawing, items=(polygon(corners, None, "white"), *drawing.items), margin=0.0)


def schemes(entries: Sequence[tuple[str, str, Entry]], tr: Translator) -> bytes:
    """A page of HTML with the scheme of each: its name, what it is about, what was found of it."""
    form = Page(Html(), tr, Numbering())
    shown = [
        {"name": name, "topic": topic, "drawing": Markup(b"".join(picture(one, tr).values()).decode())}
        for name, topic, one in entries
    ]
    return template("examples.html.j2").render({"page": form, "t": form.t}, examples=shown).encode()


def page(entries: Sequence[Entry], folder: Path, tr: Translator) -> bytes:
    """The page that stands in `folder`."""
    form = Page(Markdown(), tr, Numbering())
    given = {"page": form, "t": form.t, "num": form.num, "unit": form.unit, "pi": math.pi, "folder": folder}
    text = template("gallery.md.j2").render(given, entries=entries, link=lambda file: _link(file, folder))
    return (text.strip() + "\n").encode()


def _link(file: Path, folder: Path) -> Markup:
    """The way from the folder to a file as an address."""
    try:
        way = os.path.relpath(file.resolve(), folder.resolve())
    except ValueError:  # on another drive of Windows
        return Markup(file.resolve().as_uri())
    return Markup(quote(Path(way).as_posix()))
