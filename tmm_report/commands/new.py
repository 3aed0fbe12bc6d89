"""`tmm-report new`: a commented starting variant of a kind, or a ready one to change; beside it the editors' schema."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from pathlib import Path

from tmm_report.commands.examples import KINDS, kind_in_english, named, ready
from tmm_report.commands.talk import Talk, failure, reason, written
from tmm_report.languages import DEFAULT, LANGUAGES, stated_in
from tmm_report.problems import N_, Message, shown
from tmm_report.variant import new

SCHEMA = "variant.schema.json"
FIRST = f"# yaml-language-server: $schema={SCHEMA}\n"
_LANGUAGE = re.compile(r"^language:[ ]*\w+", re.M)
_SAID = rf'({"|".join(LANGUAGES)}): ("[^"\n]*"|[^",{{}}\n]+)'  # a text in one language: its code, the text
_BY_LANGUAGES = re.compile(rf"\{{{_SAID}(?:,\s+{_SAID})*\}}|\n(?: +{_SAID}\n)+")
FIRST_KIND = next(iter(KINDS))


def run(
    file: Path,
    language: str,
    talk: Talk,
    like: str | None = None,
    kind: str | None = None,
    lang: str | None = None,
) -> bool:
    """Write it where there is no file yet. `like`: the ready variant that is copied; `lang`: the language that the copy
    shall have in place of its own. Raises ProblemError."""
    if like is not None and kind is not None:
        raise failure(N_("--like and --kind: name one of them"))
    kind = kind_in_english(kind, ()) if kind is not None else None
    if kind is not None and kind not in KINDS:
        raise failure(
            N_("--kind: unknown %(words)s; known: %(known)s"), words=shown(kind), known=", ".join(KINDS)
        )
    text = new(language, kind or FIRST_KIND) if like is None else _copy(like, lang)
    _made(file, FIRST + text)
    beside = _schema_beside(file, language, talk)
    talk.tell(written(*([file, beside] if beside else [file])))
    return True


def place(file: Path | None, output: Path | None, like: str | None) -> Path:
    """Where it is written: as it is named, once; by default as the variant it is a copy of. Raises ProblemError."""
    if file is not None and output is not None:
        raise failure(N_("%(file)s and -o: name the file once"), file=shown(file, 200))
    stated = file or output
    if stated is not None:
        return stated
    return Path("variant.yaml" if like is None else named(ready(), like).file.name)


def _copy(like: str, lang: str | None) -> str:
    """The text of a ready variant in one language, by default its own. Raises ProblemError."""
    text = named(ready(), like).file.read_text("utf-8")
    own = partial(_in_one, code=lang or stated_in(text) or DEFAULT)
    text = _BY_LANGUAGES.sub(own, text)
    return text if lang is None else _LANGUAGE.sub(f"language: {lang}", text, count=1)


def _in_one(found: re.Match[str], code: str) -> str:
    """Of a text by languages that of one; whole where it has none in that."""
    said = dict(re.findall(_SAID, found[0])).get(code)
    if said is None:
        return found[0]
    return f" {said}\n" if found[0].startswith("\n") else said


def _made(file: Path, text: str) -> None:
    """Write a file that there is not yet. Raises ProblemError."""
    try:
        with file.open("x", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
    except FileExistsError:
        raise failure(N_("%(file)s exists already; choose another name"), file=file) from None
    except OSError as error:
        raise failure("%(file)s: %(reason)s", file=file, reason=error.strerror) from None


def _schema_beside(file: Path, language: str, talk: Talk) -> Path | None:
    """The schema that the file's first line names: written beside it, or there already."""
    from tmm_report.commands.schema import text

    place = file.parent / SCHEMA
    return place if kept(place, partial(text, language), talk) else None


def kept(place: Path, text: Callable[[], str], talk: Talk) -> bool:
    """Write a schema where there is none, or an older one of ours; whether it was written. What somebody else made is
    left, and so said."""
    from tmm_report.commands.files import write

    try:
        if place.is_symlink() or (place.exists() and not _is_ours(place)):
            talk.warn(
                Message(N_("%(file)s is not a schema of this program: it is left as it is"), {"file": place})
            )
            return False
        write(place.parent, {place.name: text().encode() + b"\n"})
    except OSError as error:
        talk.warn(Message("%(file)s: %(reason)s", {"file": place, "reason": reason(error)}))
        return False
    return True


def _is_ours(place: Path) -> bool:
    """Whether a file begins as the schemas that this program writes."""
    from tmm_report.commands.schema import BEGINS

    if not place.is_file():
        return False
    with place.open("rb") as stream:
        return stream.read(len(BEGINS)) == BEGINS.encode()
