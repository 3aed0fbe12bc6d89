"""A student's text reaches HTML, LaTeX, CSV, JSON, figures and the terminal, and breaks out of none of them."""

from __future__ import annotations

import json
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest
from notes import VARIANTS, program, render, static
from payloads import PAYLOADS
from typer.testing import CliRunner

from tmm_report import load, solve
from tmm_report.chapters.title.given import Signer, Title
from tmm_report.cli import app


@pytest.fixture(scope="module")
def hostile():
    """The compressor and an eccentric mechanism with every payload in each text of theirs: title, loads, stages."""
    variant = load(VARIANTS / "compressor.yaml")
    everything = " ¶ ".join(PAYLOADS.values())
    texts = {name: everything for name, text in vars(Title()).items() if isinstance(text, str)}
    title = Title(**texts, lines=(everything,), signed=(Signer(everything, everything),))
    assert variant.lever.loads is not None
    forces = tuple(replace(force, name=everything) for force in variant.lever.loads.forces)
    assert variant.drive is not None
    planetary, spur = variant.drive.stages
    drive = replace(
        variant.drive, stages=(replace(planetary, title=everything), replace(spur, name=everything))
    )
    eccentric = replace(load(VARIANTS / "eccentric.yaml").eccentric, name=everything)
    loads = replace(variant.lever.loads, forces=forces)
    lever = replace(variant.lever, loads=loads)
    return solve(replace(variant, title=title, lever=lever, drive=drive, eccentric=eccentric))


@pytest.fixture(scope="module")
def page(hostile) -> str:
    return static(render(hostile, "html")["note.html"].decode())


def test_html_shows_it_as_text(page):
    for opening in ("<script", "<img", "<foreignObject", 'onmouseover="', "onerror=alert(1)>"):
        assert opening not in page
    body = re.sub(r"<!doctype[^>]*>", "", page, flags=re.I)
    assert "&lt;script&gt;alert(document.cookie)&lt;/script&gt;" in body
    assert "cycler.__init__" in body and "%(name)s %s %d" in body


def test_figures_stay_well_formed(page):
    figures = re.findall(r"<svg\b.*?</svg>", page, re.S)
    assert len(figures) > 5
    for figure in figures:
        ElementTree.fromstring(figure)


@pytest.mark.exhaustive
def test_latex_prints_it_literally(hostile, tmp_path):
    """Compiled with everything allowed that a careless user might allow, nothing is read, written or run."""
    files = render(hostile, "tex")
    for name, content in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    before = {path.name for path in tmp_path.iterdir()}
    command = [program("pdflatex"), "-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "note.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=300)
    assert done.returncode == 0, done.stdout.decode("utf-8", "replace")[-1500:]
    new = {path.name for path in tmp_path.iterdir()} - before
    assert {Path(name).suffix for name in new} <= {".aux", ".log", ".pdf", ".out", ".toc"}
    text = subprocess.run(
        [program("pdftotext"), "note.pdf", "-"], cwd=tmp_path, capture_output=True, check=True
    )
    words = "".join(text.stdout.decode().split())
    assert "root:" not in words and "uid=" not in words
    for literal in (
        "\\input{/etc/passwd}",
        "^^5cinput",
        "\\write18{touchPWNED}",
        "\\def\\x{\\x}\\x",
        "50%&#1_x^{~}$5\\",
    ):
        assert literal in words, literal
    assert "{{cycler.__init__" in words and "alert(document.cookie)" in words


def test_csv_and_json_keep_text_as_text(hostile):
    for content in render(hostile, "csv").values():
        assert not re.search(r'(^|[;,]|\r\n)"?[=+@\t]', content.decode("utf-8-sig"))
    document = json.loads(render(hostile, "json")["results.json"])
    assert document["title"]["student"] == " ¶ ".join(PAYLOADS.values())


def test_terminal_gets_no_control_characters(tmp_path):
    path = tmp_path / "bad\x1b[31m\u202ename.yaml"
    path.write_text(
        'mechanism: {links: {"1\\e[2J": {}}, "a\\u202eb": 1}\n"x\\nOK: done": 1\n', encoding="utf-8"
    )
    done = CliRunner().invoke(app, ["solve", str(path)])
    assert done.exit_code == 2
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]", done.output)
    assert not re.search("^OK: done", done.output, re.M)


@pytest.mark.parametrize("name", ["[bold red].yaml", "-o.yaml", "ж" * 60 + ".yaml", "a\nb.yaml"])
def test_odd_file_names(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_bytes((VARIANTS / "compressor.yaml").read_bytes())
    done = CliRunner().invoke(app, ["solve", "--format", "json", "--", name])
    assert done.exit_code == 0, done.output
    assert len(list(tmp_path.glob("*/results.json"))) == 1
