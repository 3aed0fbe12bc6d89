"""note.html -> PDF by an installed Chromium, with what its print leaves out: page numbers in the contents, the author.

No browser knows the page of what a link leads to while it lays a page out (`target-counter` of CSS: Chromium 156 has it
not). So the note is printed twice: the first PDF says on which page each heading stands, the second has it printed.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from collections.abc import Mapping
from html import unescape
from pathlib import Path

from tmm_report.commands.pdf import run_alone
from tmm_report.living import static

BROWSERS = (
    "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge", "microsoft-edge",
)  # fmt: skip
OPTIONS = (
    "--headless", "--disable-gpu", "--no-first-run", "--disable-extensions", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--no-pdf-header-footer", "--generate-pdf-document-outline",
)  # fmt: skip
TIMES = (
    3  # numbers that move a heading to another page would be printed anew; they stand in lines of their own
)


class NoBrowser(Exception):
    """There is no Chromium on this machine."""


class PrintFailed(Exception):
    """The browser stopped, or printed what is no PDF of a note; the text says what is known."""


def print_pdf(note: bytes) -> bytes:
    """The note as the browser prints it. Raises NoBrowser, PrintFailed, or OSError where there is no place to do it.

    The page loads nothing (its Content-Security-Policy) and, without what is for the screen alone, runs nothing: what
    a script did meanwhile would be printed. The browser has a profile of its own, and is stopped with all its children
    when its time is up.
    """
    note = static(note.decode()).encode()
    found: Mapping[str, int] = {}
    for _ in range(TIMES):
        pdf = printed(with_pages(note, found))
        before, found = found, pages(pdf)
        if found == before:
            break
    return described(pdf, _author(note))


def _author(note: bytes) -> str:
    """As the note itself names him; a browser leaves him out."""
    found = re.search('<meta name="author" content="([^"]*)">', note.decode())
    return unescape(found[1]) if found else ""


def printed(html: bytes) -> bytes:
    """The note as the browser prints it by itself; raises as `print_pdf` does."""
    program = next((path for path in map(shutil.which, BROWSERS) if path), None)
    if program is None:
        raise NoBrowser
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        folder = Path(place)
        (folder / "note.html").write_bytes(html)
        command = [
            program,
            *OPTIONS,
            f"--user-data-dir={folder / 'profile'}",
            f"--print-to-pdf={folder / 'note.pdf'}",
        ]
        if getattr(os, "geteuid", lambda: 1)() == 0:
            command.append("--no-sandbox")  # Chromium does not start for root with it
        log = run_alone([*command, (folder / "note.html").as_uri()], place, PrintFailed)
        try:
            return (folder / "note.pdf").read_bytes()
        except FileNotFoundError:
            raise PrintFailed(log[-2000:]) from None


# --- the contents

_LINE = re.compile(r'(<p class="level\d"><a href="#([^"]+)">.*?</a>)(?=</p>)', re.S)


def with_pages(html: bytes, found: Mapping[str, int]) -> bytes:
    """The note with the pages of its headings in the lines of the contents."""
    head, nav, rest = html.decode().partition('<nav class="contents">')
    lines, end, rest = rest.partition("</nav>")

    def numbered(line: re.Match[str]) -> str:
        page = found.get(line[2])
        return line[1] if page is None else f'{line[1]}<span class="page">{page}</span>'

    return "".join((head, nav, _LINE.sub(numbered, lines), end, rest)).encode()


# --- the PDF, as Skia writes it: a table of references, objects that are not packed


def pages(pdf: bytes) -> dict[str, int]:
    """Anchor -> page, from 1, of what the links of the note lead to. Raises PrintFailed for another PDF."""
    root = _object(pdf, _reference(_trailer(pdf)[0], b"Root"))
    order = {number: k for k, number in enumerate(_leaves(pdf, _reference(root, b"Pages")), 1)}
    named = re.findall(rb"/(\S+) \[(\d+) 0 R /XYZ", _object(pdf, _reference(root, b"Dests")))
    return {name.decode(): order[int(number)] for name, number in named if int(number) in order}


def _leaves(pdf: bytes, number: int) -> list[int]:
    """The pages under a node of their tree, in order."""
    node = _object(pdf, number)
    kids = re.search(rb"/Kids \[([^\]]*)\]", node)
    if kids is None:
        return [number]
    return [leaf for kid in re.findall(rb"(\d+) 0 R", kids[1]) for leaf in _leaves(pdf, int(kid))]


def described(pdf: bytes, author: str) -> bytes:
    """The PDF with its author, and without the clock: the same note gives the same bytes."""
    pdf = _renumbered(pdf)
    record, table = _trailer(pdf)
    start, end = _span(pdf, _reference(record, b"Info"))
    title = re.search(rb"/Title (<[0-9A-F]*>|\((?:\\.|[^\\)])*\))", pdf[start:end])
    lines = [b"/Title " + title[1]] if title else []
    lines += [b"/Author <FEFF" + author.encode("utf-16-be").hex().upper().encode() + b">"] if author else []
    body = b"<<" + b"\n".join([*lines, b"/Producer (Skia/PDF)"]) + b">>\n"
    longer = len(body) - (end - start)

    def moved(line: re.Match[bytes]) -> bytes:
        at = int(line[1])
        return b"%010d" % (at + longer if at > start else at) + line[2]

    references = re.sub(rb"(\d{10})( \d{5} n )", moved, pdf[table:])
    references = re.sub(rb"(?<=startxref\n)\d+", lambda at: b"%d" % (int(at[0]) + longer), references)
    return pdf[:start] + body + pdf[end:table] + references


_ELEMENT = re.compile(rb"(?<=[\[ ]\(node)\d{8}(?=\))")


def _renumbered(pdf: bytes) -> bytes:
    """With its elements numbered from 1: the browser's own numbers differ from one run to the next by what else it did
    meanwhile."""
    order = {one: b"%08d" % k for k, one in enumerate(sorted(set(_ELEMENT.findall(pdf))), 1)}
    return _ELEMENT.sub(lambda one: order[one[0]], pdf)


def _trailer(pdf: bytes) -> tuple[bytes, int]:
    """Its record, and where the table of references begins."""
    found = re.search(rb"trailer\n(<<.*?>>)\nstartxref\n(\d{1,15})\n%%EOF", pdf[-4096:], re.S)
    if found is None:
        raise PrintFailed("not a PDF as Chromium prints it")
    return found[1], int(found[2])


def _reference(record: bytes, key: bytes) -> int:
    found = re.search(rb"/" + key + rb" (\d+) 0 R", record)
    if found is None:
        raise PrintFailed(f"the PDF has no {key.decode()}")
    return int(found[1])


_HEAD, _ENTRY, _LENGTH = re.compile(rb"xref\n0 \d+\n"), re.compile(rb"(\d{10}) \d{5} n \n"), 20


def _span(pdf: bytes, number: int) -> tuple[int, int]:
    """Where the body of an object begins and ends: by the table, since a stream may hold what looks like an object."""
    table = _HEAD.match(pdf, _trailer(pdf)[1])
    entry = _ENTRY.match(pdf, table.end() + _LENGTH * number) if table else None
    head = re.compile(rb"%d 0 obj\n" % number).match(pdf, int(entry[1])) if entry else None
    if head is None:
        raise PrintFailed(f"the PDF has no object {number}")
    return head.end(), pdf.index(b"endobj", head.end())


def _object(pdf: bytes, number: int) -> bytes:
    start, end = _span(pdf, number)
    return pdf[start:end]
