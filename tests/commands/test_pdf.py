"""`solve --pdf`: which program makes the PDF, and what is said where there is none."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from notes import VARIANTS, absent
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands import by_typst, pdf

ROCKER = VARIANTS / "crank_rocker.yaml"


@pytest.fixture
def without_tex(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))


@pytest.fixture
def without_typst(monkeypatch):
    monkeypatch.setitem(sys.modules, "typst", None)


@pytest.fixture
def with_typst():
    try:
        import typst  # noqa: F401
    except ImportError:
        absent("the wheel typst is not installed")


def run(folder: Path, *words: object):
    return CliRunner().invoke(
        app, ["solve", *map(str, words), "-o", str(folder), "--format", "json", "--lang", "en"]
    )


@pytest.mark.parametrize("words", [(ROCKER, "--pdf"), ("--pdf", ROCKER), ("--pdf", "typst", ROCKER)])
def test_typst_makes_it_where_there_is_no_tex(tmp_path, without_tex, with_typst, words):
    done = run(tmp_path / "out", *words)
    assert done.exit_code == 0, done.output
    assert (tmp_path / "out" / "note.pdf").read_bytes().startswith(b"%PDF-1.7")
    assert not (tmp_path / "out" / "note.log").exists()


def test_typst_makes_it_where_it_is_named(tmp_path, with_typst, monkeypatch):
    monkeypatch.setattr(pdf, "compiled", None)  # would fail
    assert run(tmp_path / "out", ROCKER, "--pdf=typst").exit_code == 0
    assert b"Typst" in (tmp_path / "out" / "note.pdf").read_bytes()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--pdf",), ["neither pdflatex nor Typst", "pip install 'tmm-report[pdf]'"]),
        (("--pdf", "typst"), ["Typst is not installed", "pip install 'tmm-report[pdf]'"]),
        (("--pdf", "tex"), ["pdflatex is not installed", "texlive-lang-cyrillic", "MiKTeX"]),
    ],
)
def test_where_there_is_none_it_says_what_to_install(tmp_path, without_tex, without_typst, words, said):
    done = run(tmp_path / "out", ROCKER, *words)
    assert done.exit_code == 1 and all(one in done.output for one in said), done.output
    assert (tmp_path / "out" / "results.json").is_file() and not (tmp_path / "out" / "note.pdf").exists()


def test_a_program_that_is_not_known(tmp_path):
    done = run(tmp_path / "out", ROCKER, "--pdf=word")
    assert done.exit_code == 2 and "--pdf: unknown word; known: tex, typst" in done.output
    assert not (tmp_path / "out").exists()


def test_what_typst_says_when_it_stops_is_told(tmp_path, monkeypatch):
    def stops(source: bytes) -> bytes:
        raise by_typst.TypstFailed("unknown variable: x\nerror: unknown variable: x")

    monkeypatch.setattr(by_typst, "typeset", stops)
    done = run(tmp_path / "out", ROCKER, "--pdf", "typst")
    assert done.exit_code == 1 and "Typst stopped" in done.output and "unknown variable: x" in done.output


def test_it_reads_nothing_outside_its_empty_folder(with_typst):
    """Though a text did get into the code."""
    for name in ("/etc/hostname", str(ROCKER), "../../../etc/hostname"):
        with pytest.raises(by_typst.TypstFailed):
            by_typst.typeset(
                f'#set document(date: datetime(year: 2025, month: 1, day: 1))\n#read("{name}")'.encode()
            )
    with pytest.raises(by_typst.TypstFailed):
        by_typst.typeset(b'#import "@local/any:0.1.0"')


def test_a_note_without_a_pdf_imports_nothing_of_it(tmp_path):
    code = (
        "import sys\nfrom tmm_report.cli import main\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "print([name for name in sys.modules if 'typst' in name])"
    )
    command = [sys.executable, "-c", code, "solve", str(ROCKER), "-o", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=Path(__file__).parents[2])
    assert done.stdout.splitlines()[-1] == "[]", done.stdout + done.stderr
