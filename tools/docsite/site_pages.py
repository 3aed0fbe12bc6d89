"""The pages of the documentation site, gathered from the repository: docs/, the guides, and what is generated.

A link to a file that is no page of the site loses its address and keeps its words: the site stands without the
repository.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

import theory_formulas as formulas
from format_reference import ENGLISH, Reference, Words
from russian_reference import RUSSIAN

from tmm_report.loading import schema
from tmm_report.yamlread import read

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
REPOSITORY, PAGES, LEFT = "README.md", "docs", (".py", ".pyc")
GUIDES = {  # page -> its file outside docs/
    "contributing.md": "CONTRIBUTING.md",
    "changes.md": "CHANGELOG.md",
    "program.md": "tmm_report/README.md",
    "benchmarks.md": "benchmarks/README.md",
}
WORDS: Mapping[str, Words] = {"en": ENGLISH, "ru": RUSSIAN}
NOTE = "compressor"  # the ready variant whose note stands in the site
_LINK = re.compile(r"(?P<words>!?\[(?:[^\[\]]|\[[^\]]*\])*\])\((?P<to>[^()\s]+)\)")
_CODE = re.compile(r"^(```|~~~).*?^\1\s*$", re.M | re.S)


def gathered(language: str) -> dict[str, bytes]:
    """File of the site -> content: Markdown with its links set right, and what the pages show."""
    home = DOCS if language == "en" else DOCS / language
    sources = {_name(file, home): file for file in sorted(home.rglob("*")) if _belongs(file, home)}
    if language != "en":
        sources["site.css"] = DOCS / "site.css"
    else:
        sources |= {page: ROOT / file for page, file in GUIDES.items()}
    made = {f"format/{name}": text for name, text in _reference(language).items()}
    made_files = {f"notes/{NOTE}.html": formulas.note(NOTE, language, None).encode()}
    known = {*sources, *made, *made_files}
    places = {file.resolve(): page for page, file in sources.items()}
    found = made_files
    for page, file in sources.items():
        if file.suffix == ".md":
            text = relinked(file.read_text("utf-8"), file, page, places, known)
            found[page] = formulas.filled(text, language).encode()
        else:
            found[page] = file.read_bytes()
    return found | {page: text.encode() for page, text in made.items()}


def _belongs(file: Path, home: Path) -> bool:
    """Every file of docs/, but for those of other languages, which are sites of their own."""
    others = {code for code in WORDS if code != "en"} if home == DOCS else set()
    return file.is_file() and file.relative_to(home).parts[0] not in others


def _name(file: Path, home: Path) -> str:
    """A README is the page of its folder."""
    name = file.relative_to(home)
    return (name.with_name("index.md") if name.name == "README.md" else name).as_posix()


def _reference(language: str) -> dict[str, str]:
    ready = {file.stem: read(file).data for file in sorted((ROOT / "variants").glob("*.yaml"))}
    return Reference(schema(), ready, WORDS[language]).pages()


def relinked(text: str, file: Path, page: str, places: Mapping[Path, str], known: set[str]) -> str:
    """Links of a file as they lead from its page; code is left as it is."""

    def set_right(found: re.Match[str]) -> str:
        to, _, anchor = found["to"].partition("#")
        if not to or re.match(r"[a-z]+:", to) or re.fullmatch(r"(?:\.\./)+[\w/]+\.html", to):
            return found[0]  # also a page of the English site
        target = places.get((file.parent / to).resolve())
        if target is None:  # what is generated has its place in the site alone
            here = os.path.normpath(PurePosixPath(page).parent / to)
            target = here if here in known else None
        if target is None:
            return found["words"].removeprefix("!")[1:-1]
        way = os.path.relpath(target, PurePosixPath(page).parent)
        return f"{found['words']}({way}{'#' if anchor else ''}{anchor})"

    parts, end = [], 0
    for code in _CODE.finditer(text):
        parts += [_LINK.sub(set_right, text[end : code.start()]), code[0]]
        end = code.end()
    return "".join([*parts, _LINK.sub(set_right, text[end:])])
