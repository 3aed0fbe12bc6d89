"""Hostile files among a year's answers: each is refused with its reason, the others get their marks, in bounded time
and memory; nobody changes another's marks."""

from __future__ import annotations

import csv
import json
import os
import resource
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest
from notes import VARIANTS

ATTACKS = Path(__file__).parents[1] / "intake" / "attacks"
GOOD = "7: {v_B: 4.444, v_D: 6.818}\n"
RUBRIC = "positions: [7]\ntables: {rates_table: {columns: [v_B, v_D]}}\n"
MEMORY = 1 << 30  # bytes that any process of the run may ask for, with numpy and all libraries
SECONDS = 240

TEXTS = {
    "alias_bomb": "a: &a [x,x,x,x,x,x,x,x,x]\n"
    + "".join(f"{chr(98 + k)}: &{chr(98 + k)} [{','.join(['*' + chr(97 + k)] * 9)}]\n" for k in range(8)),
    "merge_bomb": "a: &a {x: 1}\n"
    + "".join(f"b{k}: &{chr(98 + k)} {{<<: [{','.join(['*' + chr(97 + k)] * 9)}]}}\n" for k in range(8)),
    "recursive": "&a {self: *a}\n",
    "deep_list": "[" * 25_000,
    "deep_block": "- " * 50_000,
    "deep_map": "{a: " * 20_000,
    "huge_int": "7: {v_B: " + "9" * 100_001 + "}\n",
    "huge_hex": "7: {v_B: 0x" + "f" * 100_000 + "}\n",
    "sexagesimal": "7: {v_B: 1" + ":59" * 60_000 + "}\n",
    "nan": "7: {v_B: .nan, v_D: .inf}\n",
    "overflow": "7: {v_B: 1e999, v_D: -1e999}\n",
    "twice": "7: {v_B: 1}\n7: {v_B: 4.444}\n",
    "python": "!!python/object/apply:os.system ['touch PWNED']\n",
    "tag": "7: {v_B: !!float abc}\n",
    "many_keys": "\n".join(f"k{k}: 1" for k in range(25_000)),
    "many_rows": "7: {" + ", ".join(f"v_{k}: 1" for k in range(9_000)) + "}",
    "huge_scale": "scales: {mu_v: 1e8, mu_a: 1e300}\n7: {v_B: 0, v_D: 0}\n",
    "own_marks": "points: 100\nweight: 1000\nrubric: {points: 1}\nstudent: somebody else\nid: good\n"
    "variant: good\n7: {v_B: 1}\n",
    "zeros": "rates_table: {7: {v_A: 0, v_B: 0, v_D: 0, v_BA: 0}}\n",
    "empty": "",
    "list": "- 1\n- 2\n",
    "controls": '7: {v_B: "\\e[31m4.444\\u202e"}\n',
    "formula": "7: {v_B: '=1+1', '=HYPERLINK(\"http://evil\")': 3}\n",
    "html": "7: {'<script>alert(1)</script>': 3, v_B: '</td><script>alert(2)</script>'}\n",
}
FILES = {
    "cp1251": ("yaml", "7: {v_B: 4,444} # положение".encode("cp1251")),
    "utf16": ("yaml", GOOD.encode("utf-16")),
    "zero_byte": ("yaml", b"7: {v_B: 4.4\x0044}"),
    "huge": ("yaml", b"7: {v_B: 1}\n#" + b"x" * 5_000_000),
    "huge_field": ("csv", b"position,v_B\n7," + b"4" * 140_000 + b"\n"),
    "ragged": ("csv", b"position,v_B\n7,4.444,5,6\n8\n"),
    "million": ("csv", b"position,v_B\n" + b"7,4.4\n" * 100_000),
    "wide": ("csv", b"position," + b"v_B," * 20_000 + b"\n7," + b"4," * 20_000 + b"\n"),
}  # fmt: skip


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """One run over all of them: its folder, and what it printed."""
    folder = tmp_path_factory.mktemp("year")
    for name in ("variants", "answers"):
        (folder / name).mkdir()
    (folder / "rubric.yaml").write_text(RUBRIC, "utf-8")
    (folder / "secret.yaml").write_text("7: {v_B: 4.444}\nsecret: root:x:0:0\n", "utf-8")
    text = (VARIANTS / "compressor.yaml").read_text("utf-8")
    variant = text[: text.index("\nloads:")] + "\npositions: {table: 12}\n"
    answers = folder / "answers"
    ids = ["good", *TEXTS, *FILES, "link", "pipe", "folder", "bytes"]
    for name, content in TEXTS.items():
        (answers / f"{name}.yaml").write_text(content, "utf-8", newline="")
    for name, (suffix, content) in FILES.items():
        (answers / f"{name}.{suffix}").write_bytes(content)
    for file in sorted(ATTACKS.iterdir()):
        if file.suffix in (".csv", ".xlsx"):
            shutil.copy(file, answers)
            ids.append(file.stem)
    (answers / "good.yaml").write_text(GOOD, "utf-8")
    os.symlink(folder / "secret.yaml", answers / "link.yaml")
    os.mkfifo(answers / "pipe.yaml")
    (answers / "folder.yaml").mkdir()
    with open(os.fsencode(answers) + b"/iv\xff.yaml", "wb") as stream:
        stream.write(GOOD.encode())
    for id in ids:
        (folder / "variants" / f"{id}.yaml").write_text(variant, "utf-8")
    return folder, graded(folder, "marks")


def graded(folder: Path, output: str) -> subprocess.CompletedProcess[str]:
    command = [
        sys.executable,
        "-m",
        "tmm_report",
        "grade",
        "variants",
        "answers",
        "-o",
        output,
        "--rubric",
        "rubric.yaml",
        "--lang",
        "en",
    ]
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, timeout=SECONDS, errors="replace",
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)),
    )  # fmt: skip


def marks(folder: Path) -> dict[str, dict[str, str]]:
    text = (folder / "marks" / "marks.csv").read_text("utf-8-sig")
    return {row["id"]: row for row in csv.DictReader(text.splitlines())}


REFUSED = (
    "alias_bomb", "merge_bomb", "recursive", "deep_list", "deep_block", "deep_map", "huge_int", "python", "tag",
    "many_keys", "zero_byte", "huge", "huge_field", "wide", "X01_entity_bomb", "X02_xxe",
)  # fmt: skip
pytestmark = [
    pytest.mark.exhaustive,  # of one file: tests/intake, grading/test_answers.py
    pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="links, pipes and limits of a POSIX system"),
]


def test_the_run_ends_with_marks_for_everybody_whose_file_can_be_read(run):
    folder, done = run
    assert done.returncode in (0, 1) and "Traceback" not in done.stderr, done.stderr[-3000:]
    found = marks(folder)
    assert float(found["good"]["points"]) == 100
    assert set(found) == {path.stem for path in (folder / "variants").iterdir()}


@pytest.mark.parametrize("name", [*TEXTS, *FILES])
def test_a_hostile_file_earns_nothing_that_it_does_not_say(run, name):
    row = marks(run[0])[name]
    earned = {"twice": 0, "utf16": 0, "cp1251": 0, "ragged": 50, "million": 0}
    points = float(row["points"] or 0)
    assert points <= earned.get(name, 0) or (name == "million" and points <= 50), row


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_refused_is_refused_with_its_reason(run, name):
    folder, _ = run
    said = marks(folder)[name]["likely causes"]
    assert said.startswith(f"answers/{name}."), said
    assert len(said) < 600 and "root:" not in said


def test_links_pipes_and_folders_are_named_and_never_opened(run):
    folder, done = run
    assert "iv" in done.stderr and "more: see marks.csv" in done.stderr  # which tells of everybody
    found = marks(folder)
    for name in ("link", "pipe", "folder"):
        assert f"answers/{name}.yaml: " in found[name]["likely causes"] and not found[name]["points"], name
    everything = (
        done.stdout
        + done.stderr
        + "".join(path.read_text("utf-8", "replace") for path in (folder / "marks").rglob("*.html"))
    )
    assert "root:x" not in everything


def test_nobody_changes_anothers_marks_or_his_own_weight(run):
    folder, _ = run
    row = marks(folder)["own_marks"]
    assert float(row["points"]) == 0 and float(row["out of"]) == 100
    assert float(marks(folder)["huge_scale"]["points"]) == 0 and float(marks(folder)["zeros"]["points"]) == 0


def test_nothing_is_written_outside_the_folder_and_nothing_is_run(run):
    folder, _ = run
    assert sorted(path.name for path in folder.iterdir()) == [
        "answers",
        "marks",
        "rubric.yaml",
        "secret.yaml",
        "variants",
    ]
    assert not list(folder.rglob("PWNED*"))
    assert stat.S_ISFIFO((folder / "answers" / "pipe.yaml").lstat().st_mode)


def test_what_students_write_is_text_in_every_page_and_sheet(run):
    folder, done = run
    for page in (folder / "marks").rglob("*.html"):
        text = page.read_text("utf-8")
        assert "<script>alert" not in text and "\x1b" not in text and "\u202e" not in text, page
    assert "\x1b" not in done.stdout + done.stderr and "\u202e" not in done.stdout + done.stderr
    for sheet in (folder / "marks").glob("*.csv"):
        for row in csv.reader(sheet.read_text("utf-8-sig").splitlines()):
            assert not [cell for cell in row if cell[:1] in "=+@\t" and cell and cell != "+"], (sheet, row)
    for result in (folder / "marks" / "gradescope").rglob("results.json"):
        json.loads(result.read_text("utf-8"))


def test_the_same_input_gives_the_same_marks_to_the_byte(run):
    folder, _ = run
    graded(folder, "again")
    names = sorted(
        str(path.relative_to(folder / "marks")) for path in (folder / "marks").rglob("*") if path.is_file()
    )
    again = sorted(
        str(path.relative_to(folder / "again")) for path in (folder / "again").rglob("*") if path.is_file()
    )
    assert names == again and len(names) > 30
    differ = [
        name
        for name in names
        if (folder / "marks" / name).read_bytes() != (folder / "again" / name).read_bytes()
    ]
    shutil.rmtree(folder / "again")
    assert not differ
