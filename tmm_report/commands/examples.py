"""`tmm-report examples`: the ready variants, a line each; with --open their schemes in the browser."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from tmm_report.commands.talk import Talk, failure, unwritable, written
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.records import dataclass
from tmm_report.resources import data_root
from tmm_report.variant.russian import english_key
from tmm_report.yamlread import read

KINDS = {
    "lever": ("mechanism",),
    "cam": ("cam", "mechanism.cams"),
    "drive": ("drive", "train", "eccentric"),
    "flywheel": ("flywheel",),
}
"""Kind -> the blocks that make a variant one of it."""
NO_KINDS = {"title", "language", "decimal_sign", "mechanism", "positions", "drawing", "accuracy", "method"}
"""Blocks that say nothing of what a variant is about."""


@dataclass(frozen=True)
class Example:
    """A ready variant: its file, what it is about by language, the blocks that it states."""

    file: Path
    topics: Any
    blocks: tuple[str, ...]

    @property
    def name(self) -> str:
        return self.file.stem

    def topic(self, language: str) -> str:
        """In the language, or in that in which it is given."""
        by = self.topics if isinstance(self.topics, dict) else {}
        return str(by.get(language) or next(iter(by.values()), self.topics))

    def is_a(self, kind: str) -> bool:
        """Whether it is of a kind; the name of a block is one, too."""
        return any(block in self.blocks for block in KINDS[kind]) if kind in KINDS else kind in self.blocks


def run(
    names: Sequence[str], kind: str | None, output: Path | None, open_page: bool, talk: Talk, language: str
) -> bool:
    """Tell the list, or draw it; whether all could be drawn. Raises ProblemError."""
    found = chosen(ready(), names, kind)
    if not open_page and output is None:
        for line in lines(found, language):
            talk.tell(line)
        return True
    place = output or Path(tempfile.mkdtemp(prefix="tmm-report-")) / "examples.html"
    good = _drawn(found, place, talk, language)
    if open_page:
        import webbrowser

        webbrowser.open(place.resolve().as_uri())
    return good


def ready() -> list[Example]:
    """The ready variants, by name."""
    return [_example(file) for file in sorted((data_root() / "variants").glob("*.yaml"))]


def _example(file: Path) -> Example:
    stated = read(file).data
    inner = [f"mechanism.{key}" for key in stated.get("mechanism", ())]
    return Example(file, stated.get("title", {}).get("topic", file.stem), (*stated, *inner))


def chosen(every: Sequence[Example], names: Sequence[str] = (), kind: str | None = None) -> list[Example]:
    """Those of the names, all of them by default, that are of a kind. Raises ProblemError."""
    wanted = [named(every, name) for name in names] or every
    if kind is None:
        return list(wanted)
    kind = kind_in_english(kind, (block for one in every for block in one.blocks))
    found = [one for one in wanted if one.is_a(kind)]
    if not found and not any(one.is_a(kind) for one in every):
        blocks = {block for one in every for block in one.blocks if "." not in block} - NO_KINDS
        known = ", ".join(dict.fromkeys([*KINDS, *sorted(blocks)]))
        raise failure(N_("--kind: unknown %(words)s; known: %(known)s"), words=shown(kind), known=known)
    return found


def kind_in_english(word: str, every: Iterable[str]) -> str:
    """A kind, or one of the blocks, for its Russian word: кулачок, маховик; what is none of them as it is."""
    if word.casefold().startswith(("рычаг", "рычаж")):
        return "lever"
    return english_key(word, {*KINDS, *every}) or word


def named(every: Sequence[Example], name: str) -> Example:
    """The ready variant of a name, with or without the end of its file. Raises ProblemError."""
    found = next((one for one in every if name in (one.name, one.file.name)), None)
    if found is None:
        from difflib import get_close_matches

        wrong = Message(N_("there is no ready variant %(name)s"), {"name": shown(name)})
        right = Message(N_("tmm-report examples lists them"))
        if nearest := get_close_matches(name, [one.name for one in every], 1):
            right = Message(N_("did you mean %(near)s?"), {"near": nearest[0]})
        raise ProblemError([Problem(wrong, right)])
    return found


def lines(found: Sequence[Example], language: str) -> list[str]:
    """A line each: name and what it is about."""
    wide = max((len(one.name) for one in found), default=0)
    return [f"{one.name:{wide}}  {one.topic(language)}" for one in found]


def _drawn(found: Sequence[Example], place: Path, talk: Talk, language: str) -> bool:
    """Write a page with the scheme of each; whether there is one of each."""
    from tmm_report.commands.files import write
    from tmm_report.commands.gallery.page import schemes
    from tmm_report.commands.gallery.run import entry
    from tmm_report.i18n import Translator

    entries = []
    for k, one in enumerate(found, 1):
        doing = {"file": one.file.name, "number": k, "count": len(found)}
        talk.stage(Message(N_("solving %(file)s, %(number)s of %(count)s"), doing))
        entries.append((one.name, one.topic(language), entry(one.file)))
    try:
        write(place.parent, {place.name: schemes(entries, Translator(language))})
    except OSError as error:
        raise unwritable(place.parent, error) from None
    talk.tell(written(place))
    return not any(one.problems for _, _, one in entries)
