"""Every row of the README's table of exit codes, and streams and places that fail: one line, no traceback."""

from __future__ import annotations

import errno
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from batching import GAP
from exhaustive import many
from notes import VARIANTS
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands import pdf, solve

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="descriptors")
ROCKER = VARIANTS / "crank_rocker.yaml"
LIGHT = ("--format", "json", "--lang", "en")
GEARS = """\
drive:
  speed: 1000 rpm
  stages:
    - {{kind: spur, ratio: -1, module: 2 mm, teeth: [{0}, {0}], shift: [0, 0]}}
"""
COMPRESSOR = (VARIANTS / "compressor.yaml").read_text("utf-8")
MOTOR = VARIANTS / "drum_motor.yaml"


def run(*arguments: object):
    names = {"LANG": "C", "LC_ALL": "C"}
    done = CliRunner().invoke(app, [str(a) for a in arguments], env=names)
    assert done.exception is None or isinstance(done.exception, SystemExit), done.exception
    return done


def variant(folder: Path, text: str) -> Path:
    file = folder / "variant.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def changed(folder: Path, *edits: tuple[str, str]) -> Path:
    """The crank-rocker with something else in it."""
    text = ROCKER.read_text("utf-8")
    for old, new in edits:
        text, count = re.subn(old, new, text, count=1)
        assert count == 1, old
    return variant(folder, text)


# ---------------------------------------------------------------- 0


def test_0_done_and_every_check_held(tmp_path):
    assert run("solve", ROCKER, "-o", tmp_path / "out", *LIGHT).exit_code == 0


def test_0_a_condition_that_is_met_by_the_rule_of_the_course_alone(tmp_path):
    done = run("solve", VARIANTS / "compressor.yaml", "-o", tmp_path / "out", *LIGHT)
    assert "met by the rule only" in done.output and done.exit_code == 0
    assert "the exit code does not change" in done.output and "conditions not met" not in done.output


# ---------------------------------------------------------------- 1


def test_1_conditions_of_a_gear_pair_are_not_met(tmp_path):
    done = run("solve", variant(tmp_path, GEARS.format(10)), "-o", tmp_path / "out", *LIGHT)
    assert done.exit_code == 1 and "conditions not met" in done.output
    assert (tmp_path / "out" / "results.json").is_file()


def test_1_a_mechanism_that_does_not_close_all_round_unless_it_is_meant_so(tmp_path):
    done = run("solve", variant(tmp_path, GAP), "-o", tmp_path / "out", *LIGHT)
    assert done.exit_code == 1 and "error: " in done.output
    assert (tmp_path / "out" / "results.json").is_file()
    own = re.sub(r"\nreadings:.*?(?=\n\S|\Z)", "\n", GAP, flags=re.DOTALL)
    meant = variant(tmp_path, own + "\nallow_partial: true\n")
    assert run("solve", meant, "-o", tmp_path / "out", *LIGHT).exit_code == 0


def test_1_a_wrong_reading(tmp_path):
    file = variant(tmp_path, COMPRESSOR.replace("v_A: 12.566, v_B: 0,", "v_A: 25, v_B: 0,"))
    done = run("solve", file, "-o", tmp_path / "out", *LIGHT)
    assert done.exit_code == 1 and "v_A" in done.output


@pytest.mark.exhaustive
def test_1_no_pdf(tmp_path, monkeypatch):
    def none(name: str) -> None:
        return None

    monkeypatch.setattr(pdf.shutil, "which", none)
    monkeypatch.setitem(sys.modules, "typst", None)
    done = run("solve", ROCKER, "-o", tmp_path, *LIGHT, "--pdf")
    assert done.exit_code == 1 and "no PDF" in done.output and (tmp_path / "results.json").is_file()


@pytest.mark.exhaustive
def test_1_no_place_for_temporary_files_costs_the_pdf_alone(tmp_path, monkeypatch):
    def full(files):
        raise FileNotFoundError(errno.ENOENT, "No usable temporary directory found")

    monkeypatch.setattr(pdf, "found", lambda: "pdflatex")
    monkeypatch.setattr(pdf, "compiled", full)
    done = run("solve", ROCKER, "-o", tmp_path, *LIGHT, "--pdf")
    assert done.exit_code == 1 and "no PDF: No usable temporary directory" in done.output
    assert (tmp_path / "results.json").is_file()


@pytest.mark.exhaustive
def test_1_a_batch_with_a_variant_to_be_looked_at(tmp_path):
    (tmp_path / "in").mkdir()
    variant(tmp_path / "in", GEARS.format(10))
    done = run("batch", tmp_path / "in", "-o", tmp_path / "out", "--format", "json", "--jobs", 1)
    assert done.exit_code == 1


# ---------------------------------------------------------------- 2


@pytest.mark.parametrize("command", ["solve", "assemblies", "explain"])
def test_2_a_file_that_is_not_there(tmp_path, command):
    extra = ["v_B"] if command == "explain" else []
    assert run(command, tmp_path / "none.yaml", *extra).exit_code == 2


def test_2_mistakes_of_a_variant_and_nothing_is_written(tmp_path):
    file = changed(tmp_path, ("links:", "link:"))
    assert run("solve", file, "-o", tmp_path / "out").exit_code == 2 and not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", ROCKER, "--format", "odt"),
        ("solve", ROCKER, "--lang", "xx"),
        ("assign", "none.yaml"),
        ("new", ROCKER),
    ],
)
def test_2_a_wrong_command_line(arguments):
    assert run(*arguments).exit_code == 2


def test_2_a_variant_beyond_a_limit(tmp_path):
    file = changed(
        tmp_path, ("links:", "links:\n" + "\n".join(f"    x{k}: {{points: {{A: 0}}}}" for k in range(50)))
    )
    done = run("solve", file, "--lang", "en")
    assert done.exit_code == 2 and "53 entries are too many here: at most 40" in done.output


@pytest.mark.exhaustive
@pytest.mark.parametrize("command", ["solve", "assemblies"])
def test_2_a_place_that_cannot_be_written_to(tmp_path, command):
    (tmp_path / "file").write_text("mine")
    for place in (tmp_path / "file", tmp_path / "file" / "deeper", tmp_path / ("a" * 300)):
        done = run(command, ROCKER, "-o", place, "--lang", "en")
        assert (
            done.exit_code == 2
            and done.output.startswith("cannot write into")
            and done.output.count("\n") == 1
        )
    assert (tmp_path / "file").read_text() == "mine"


@pytest.mark.parametrize(
    "error, line", [(MemoryError(), "not enough memory"), (RecursionError(), "not enough memory")]
)
def test_2_what_does_not_fit_into_the_machine(tmp_path, monkeypatch, error, line):
    def fails(*arguments, **named):
        raise error

    monkeypatch.setattr(solve, "solve_variant", fails)
    done = run("solve", ROCKER, "-o", tmp_path / "out", "--lang", "en")
    assert done.exit_code == 2 and line in done.output and done.output.count("\n") == 1


@pytest.mark.exhaustive
def test_2_a_full_disk_keeps_the_old_note(tmp_path, monkeypatch):
    run("solve", ROCKER, "-o", tmp_path, *LIGHT)
    before = (tmp_path / "results.json").read_bytes()

    def full(self, content):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "write_bytes", full)
    done = run("solve", VARIANTS / "shaper.yaml", "-o", tmp_path, *LIGHT)
    assert done.exit_code == 2 and done.output.count("\n") == 1 and "No space" in done.output
    assert (tmp_path / "results.json").read_bytes() == before


@pytest.mark.exhaustive
@pytest.mark.parametrize("command", ["assemblies", "solve"])
def test_2_or_0_a_variant_without_a_lever(tmp_path, command):
    done = run(command, MOTOR, "-o", tmp_path / "out", "--lang", "en")
    if command == "solve":
        assert done.exit_code == 0
        return
    assert done.exit_code == 2 and done.output.count("\n") == 1 and "mechanism" in done.output
    assert "block mechanism" in done.output


# ---------------------------------------------------------------- 130


def test_130_stopped(tmp_path, monkeypatch):
    def stopped(*arguments, **named):
        raise KeyboardInterrupt

    monkeypatch.setattr(solve, "solve_variant", stopped)
    done = run("solve", ROCKER, "-o", tmp_path / "out", "--lang", "en")
    assert (done.exit_code, done.output) == (130, "stopped\n") and not (tmp_path / "out").exists()


# ---------------------------------------------------------------- streams

SHELL = [
    ("solve {0} -o {1} --format json --lang en >&-", 0, ""),
    ("solve {0} -o {1} --format json --lang en >&- 2>&- <&-", 0, ""),
    ("solve {0} -o {1} --format json --lang en | head -c 0", 0, ""),
    ("solve {0} -o {1} --format json --lang en >/dev/full", 1, "the standard output could not be written"),
    ("schema >/dev/full", 1, "the standard output could not be written"),
]


@pytest.mark.exhaustive
@POSIX
@pytest.mark.parametrize("line, code, said", many(SHELL, 2))
def test_closed_and_full_streams(tmp_path, line, code, said):
    if "/dev/full" in line and not Path("/dev/full").exists():
        pytest.skip("no /dev/full")
    words = line.format(ROCKER, tmp_path)
    command = f"set -o pipefail; {sys.executable} -m tmm_report {words}"
    done = subprocess.run(
        ["bash", "-c", command], capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}
    )
    assert done.returncode == code and done.stderr.count("\n") == bool(said) and said in done.stderr
    assert line.startswith("schema") or (tmp_path / "results.json").stat().st_size > 1000
