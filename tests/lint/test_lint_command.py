"""`tmm-report lint FOLDER` as its user meets it: exit codes, words in both languages; the end of a solve."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

import pytest
from notes import VARIANTS, note
from offences import HTML, LOG, OFFENCES
from told import Told
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands.lint import after_solve
from tmm_report.commands.pdf import compiled

NAME = "governor_spring"


def run(*arguments: object):
    return CliRunner().invoke(app, [str(a) for a in arguments], env={"LANG": "C", "LC_ALL": "C"})


def put(folder: Path, files: dict[str, bytes]) -> Path:
    for name, content in files.items():
        if "/" not in name:
            (folder / name).write_bytes(content)
    return folder


@pytest.fixture
def folder(tmp_path) -> Path:
    return put(tmp_path, note(NAME, "html", "ru") | note(NAME, "tex", "ru"))


def test_0_nothing_to_mend(folder):
    done = run("lint", folder)
    assert done.exit_code == 0 and "norm control: nothing to mend" in done.output
    assert "no results.json" in done.output and "no note.log" in done.output


def test_1_what_is_to_be_mended_by_file_line_and_key(folder):
    scale = next(one for one in OFFENCES if one.check == "scale")
    put(folder, scale.plant({HTML: (folder / HTML).read_bytes()}))
    done = run("lint", folder, "--lang", "ru")
    line = next(line for line in done.output.splitlines() if ": scale: " in line)
    assert done.exit_code == 1 and line.startswith(f"{folder / HTML}:")
    assert "Рисунок 2" in line and "нормоконтроль: замечаний: 1" in done.output


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("", b"", "is not a folder"),
        ("other.txt", b"", "there is neither note.html nor note.tex"),
        (HTML, b"<html><main><p></main>", f"{HTML}:1: this is not a note"),
        (HTML, b"<main>" + b"<div>" * 5000 + b"</div>" * 5000 + b"</main>", "this is not a note"),
        (HTML, b"<main>&nothing;</main>", "this is not a note"),
        (HTML, b'<!DOCTYPE x [<!ENTITY a "aa">]><main>&a;</main>', "this is not a note"),
        (HTML, b"GIF89a", "this is not a note"),
    ],
)
def test_2_what_is_no_note(tmp_path, name, content, said):
    place = tmp_path / "note"
    if name:
        place.mkdir()
        (place / name).write_bytes(content)
    done = run("lint", place)
    assert done.exit_code == 2 and said in done.output and "Traceback" not in done.output


@pytest.mark.parametrize("content", [b"{", b"[]", b'{"values": 3, "tables": {}}', b"[" * 100_000])
def test_2_results_of_something_else(folder, content):
    (folder / "results.json").write_bytes(content)
    done = run("lint", folder)
    assert done.exit_code == 2 and "results.json: this is not a results.json" in done.output


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes")
def test_2_pipes_and_links_are_not_opened(folder, tmp_path):
    (folder / HTML).unlink()
    os.mkfifo(folder / HTML)
    assert run("lint", folder).exit_code == 2
    (folder / HTML).unlink()
    (folder / HTML).symlink_to(folder / "note.tex")
    assert run("lint", folder).exit_code == 2


HOSTILE = [
    '{"values": [{"key": "z"}, 3, {"value": []}], "tables": {"a": 3}}',
    '{"values": [], "tables": {"governor_equilibrium": {"columns": [{"key": "z", "values": 7}, 5]}}}',
    '{"values": [], "tables": {"governor_equilibrium": {"columns": [{"key": "position", "values": [[]]}]}}}',
    '{"values": [{"key": [], "value": 1}], "tables": {}}',
]


@pytest.mark.parametrize("document", HOSTILE)
def test_results_that_only_look_like_ours_break_nothing(folder, document):
    (folder / "results.json").write_text(document)
    done = run("lint", folder)
    assert done.exit_code in (0, 2) and "Traceback" not in done.output, done.exception


FORGED = (
    ('viewBox="', 'viewBox="x '), (' width="', ' width="1e999mm'), (' r="', ' r="nan'), (' d="M', ' d="M9 A L'),
    (' d="M', ' d="M1e99 1A1e99 1 0 1 1 9e98 1e-99L1 2A0 0 0 0 0 0 0L9 9M'),
    (' x="', ' x="∞'), ('font-size="3.2"', 'font-size="9e99"'), ('data-k="', 'data-k="٣'),
    ('id="figure', 'id="figure٣'), ("</td>", "·10⁹⁹</td>"), ("</mn>", "0" * 400 + "</mn>"), ("<tr>", "<tr><td/>"),
)  # fmt: skip


def test_forged_attributes_break_nothing(folder):
    text = (folder / HTML).read_text("utf-8")
    for old, new in FORGED:
        assert old in text
        (folder / HTML).write_text(text.replace(old, new), "utf-8")
        done = run("lint", folder)
        assert done.exit_code in (0, 1), (old, done.exception)


@pytest.mark.exhaustive
def test_a_solve_ends_with_the_norm_control(tmp_path):
    done = run("solve", VARIANTS / f"{NAME}.yaml", "-o", tmp_path / "out", "--lang", "en")
    assert done.exit_code == 0 and "norm control: nothing to mend" in done.output
    done = run("solve", VARIANTS / f"{NAME}.yaml", "-o", tmp_path / "out", "--format", "json")
    assert "norm control" not in done.output


def test_the_end_of_a_solve_counts_and_says_how_to_see(tmp_path):
    files = note(NAME, "html", "ru")
    scale = next(one for one in OFFENCES if one.check == "scale")
    talk = Told()
    after_solve(scale.plant(files), tmp_path / "out", talk)
    place = tmp_path / "out"
    assert talk.lines == [f"norm control: to mend: 1; to see them: tmm-report lint {place}"]


@pytest.mark.exhaustive
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no pdflatex")
def test_the_log_of_a_pdf_is_kept_for_the_control(tmp_path):
    """What is over the margin in the LaTeX alone is seen in its log, and in nothing else."""
    files = note("function_generator", "tex", "en")
    wide = files["note.tex"].replace(b"\\end{document}", b"\\noindent\\rule{200mm}{1mm}\\end{document}")
    made = compiled(files | {"note.tex": wide})
    assert made.keys() == {LOG, "note.pdf"}
    done = run("lint", put(tmp_path, files | {"note.tex": wide} | made))
    told = [line for line in done.output.splitlines() if "note.log:" in line]
    assert done.exit_code == 1 and len(told) == 1
    points = re.search(r": margin: a box is ([\d.]+) pt", told[0])
    assert points and float(points[1]) == pytest.approx((200 - 165) / 25.4 * 72.27, abs=0.01)
