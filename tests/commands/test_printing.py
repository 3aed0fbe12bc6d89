"""`--print`: what the PDF of a browser has beside its pages: contents with page numbers, title, author, bookmarks."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from conftest import solved
from notes import VARIANTS, note, program
from once import once
from typer.testing import CliRunner
from typesetting import set_by_tex

from tmm_report import render
from tmm_report.cli import app
from tmm_report.commands import printing
from tmm_report.commands.printing import NoBrowser, PrintFailed, described, pages, print_pdf, with_pages

NAME = "punch_press"


@once
def printed() -> bytes:
    program(*printing.BROWSERS)
    return print_pdf(render(solved(NAME), "html", "ru")["note.html"])


@once
def set_in_latex() -> bytes:
    return set_by_tex(render(solved(NAME), "tex", "ru"), whole=True)[1]


def told(command: str, pdf: bytes, *options: str) -> str:
    """What a program of Poppler says of a PDF; nothing is wrong with it."""
    with TemporaryDirectory() as place:
        file = Path(place) / "note.pdf"
        file.write_bytes(pdf)
        done = subprocess.run(
            [program(command), *options, str(file), *(["-"] if command == "pdftotext" else [])],
            capture_output=True,
        )
    assert done.returncode == 0 and done.stderr == b"", done.stderr
    return done.stdout.decode()


def test_the_contents_name_the_pages_on_which_the_headings_stand():
    """Read off the printed pages by another program."""
    sheets = [
        [" ".join(line.split()) for line in page.splitlines()]
        for page in told("pdftotext", printed(), "-layout").split("\f")
    ]
    listed = [
        match
        for line in sheets[1]
        if (match := re.fullmatch(r"(.*?\S) (\d+)", line)) and not re.fullmatch(r"\d+", match[1])
    ]
    assert len(listed) > 8
    for line in listed:
        title, number = line[1], int(line[2])
        assert any(
            one.startswith(re.sub(r"(?<=ПРИЛОЖЕНИЕ А).*", "", title)[:40]) for one in sheets[number - 1]
        ), line[0]
    assert [int(line[2]) for line in listed] == sorted(int(line[2]) for line in listed)
    assert "СОДЕРЖАНИЕ" in sheets[1]


@pytest.mark.parametrize("pdf", [printed, pytest.param(set_in_latex, marks=pytest.mark.exhaustive)])
def test_the_pdf_has_its_title_its_author_and_bookmarks(pdf):
    title = solved(NAME).variant.title
    said = told("pdfinfo", pdf())
    assert re.search(rf"^Title: +{re.escape(title.topic)}$", said, re.M)
    assert re.search(rf"^Author: +{re.escape(title.student)}$", said, re.M)
    marks = re.findall(r'<item page="\d+">(.*?)</item>', told("pdftohtml", pdf(), "-xml", "-i", "-stdout"))
    wanted = {"Введение", "1 Маховик", "Заключение", "Список использованных источников"}
    assert set(map(str.casefold, wanted)) <= set(map(str.casefold, marks))


def test_the_same_note_gives_the_same_bytes_and_every_reference_leads_to_its_object():
    pdf = printed()
    assert print_pdf(render(solved(NAME), "html", "ru")["note.html"]) == pdf
    assert b"CreationDate" not in pdf
    table = pdf[int(re.findall(rb"startxref\n(\d+)", pdf)[-1]) :]
    assert table.startswith(b"xref\n")
    for number, (at, kind) in enumerate(re.findall(rb"(\d{10}) \d{5} ([nf]) \n", table)):
        assert kind == b"f" or pdf[int(at) :].startswith(b"%d 0 obj" % number)


def test_no_script_is_printed(monkeypatch):
    """Of the living page: what it does at the time would be in the PDF, and another number of every element."""
    given = []
    monkeypatch.setattr(printing, "printed", lambda html: given.append(html) or plain)
    plain = pdf_of(b"<<>>", b"<</Pages 3 0 R\n/Dests 4 0 R>>", b"<<>>", b"<<>>")
    made = note(NAME, "html")["note.html"]
    print_pdf(made)
    assert b"<script" in made and given and not any(b"<script" in one for one in given)


def test_a_page_without_contents_or_of_another_program_is_told():
    assert with_pages(b"<p>no contents</p>", {"section1": 3}) == b"<p>no contents</p>"
    lines = b'<p class="level1"><a href="#a">A</a></p><p class="level1"><a href="#b">B</a></p>'
    nav = b'<nav class="contents">' + lines + b"</nav>"
    assert with_pages(nav, {"a": 7}).count(b'<span class="page">7</span>') == 1
    for pdf in (b"", b"%PDF-1.4\n", b"%PDF-1.4\ntrailer\n<</Root 1 0 R>>\nstartxref\n0\n%%EOF"):
        with pytest.raises(PrintFailed):
            pages(pdf)
        with pytest.raises(PrintFailed):
            described(pdf, "A")


def pdf_of(*objects: bytes) -> bytes:
    """A PDF of these objects, the first of them its Info and the second its Root."""
    written, places = b"%PDF-1.4\n", []
    for number, one in enumerate(objects, 1):
        places.append(len(written))
        written += b"%d 0 obj\n%b\nendobj\n" % (number, one)
    table = b"xref\n0 %d\n0000000000 65535 f \n" % (len(objects) + 1)
    table += b"".join(b"%010d 00000 n \n" % at for at in places)
    trailer = b"trailer\n<</Size %d\n/Root 2 0 R\n/Info 1 0 R>>\nstartxref\n%d\n%%%%EOF"
    return written + table + trailer % (len(objects) + 1, len(written))


def test_elements_have_numbers_of_their_own_whatever_the_browser_gave_them():
    def of(first: int, title: bytes = b"A") -> bytes:
        head = b"/ID (node%08d)" % first
        cell = b"/A [<</Headers [(node%08d) (node%08d)]>>]\n/ID (node%08d)" % (first, first + 3, first + 7)
        said = b"<</Title (%b)\n/Alt (see node00000810)>>" % title
        return pdf_of(said, b"<<>>", b"<<%b>>" % head, b"<</ID (node%08d)>>" % (first + 3), b"<<%b>>" % cell)

    assert described(of(809), "A") == described(of(1240), "A") != described(of(809, b"B"), "A")
    assert described(of(809), "A").count(b"(node00000001)") == 2


def test_what_looks_like_an_object_within_a_stream_is_none():
    false = b"<</Kids [6 0 R 5 0 R]>>"
    pdf = pdf_of(
        b"<</Title (A)\n/Creator (4 0 obj)>>",
        b"<</Pages 4 0 R\n/Dests 7 0 R>>",
        b"<</Length 60>> stream\n4 0 obj\n%b\nendobj\nxref\n0 9\nendstream" % false,
        b"<</Kids [5 0 R 6 0 R]>>",
        b"<<>>",
        b"<<>>",
        b"<</one [5 0 R /XYZ 0 0 0]\n/two [6 0 R /XYZ 0 0 0]>>",
    )
    assert pages(pdf) == {"one": 1, "two": 2}
    assert pages(described(pdf, "A long name of an author")) == {"one": 1, "two": 2}


def test_without_a_browser_the_note_is_written_and_that_is_said(tmp_path, monkeypatch):
    monkeypatch.setattr(printing.shutil, "which", lambda name: None)
    with pytest.raises(NoBrowser):
        print_pdf(b"")
    done = CliRunner().invoke(
        app, ["solve", str(VARIANTS / "rotor.yaml"), "-o", str(tmp_path / "n"), "--print", "--lang", "en"]
    )
    assert done.exit_code == 1 and "no Chromium" in done.output
    assert (tmp_path / "n" / "note.html").is_file() and not (tmp_path / "n" / "note-print.pdf").exists()


def test_a_browser_that_stops_is_told(tmp_path, monkeypatch):
    stopped = tmp_path / "chromium"
    stopped.write_text("#!/bin/sh\necho broken >&2\nexit 3\n")
    stopped.chmod(0o755)
    monkeypatch.setattr(printing.shutil, "which", lambda name: str(stopped))
    with pytest.raises(PrintFailed, match="broken"):
        print_pdf(b"<p></p>")
