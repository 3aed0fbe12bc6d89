"""What a department states in a file beside its variants: merged below them, its mistakes told as its own."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

import pytest
from notes import VARIANTS
from typer.testing import CliRunner

from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.cli import app
from tmm_report.commands.batch.inputs import inputs
from tmm_report.commands.batch.work import loaded
from tmm_report.commands.check.run import samples
from tmm_report.commands.gallery.run import variants
from tmm_report.loading import load
from tmm_report.problems import ProblemError
from tmm_report.profiles import shipped, stated
from tmm_report.variant.department import KEYS, NAMES

STATED = """title: {ministry: Министерство, teacher: Петров П. П., year: 2030, lines: [Факультет]}
note: {depth: short, omit: [flywheel]}
profile: dstu
decimal_sign: point
language: en
"""
FOUR_BAR = """language: ru
title: {student: Иванов И. И., year: 2026}
mechanism:
  frame: {O: [0, 0], C: [0.2, 0.02]}
  links: {1: {points: {O: 0, A: 60 mm}}, 2: {points: {A: 0, B: 180 mm}}, 3: {points: {C: 0, B: 120 mm}}}
  driver: {link: 1, speed: 60 rpm, rotation: clockwise, zero: {point: B, extreme: left}}
  assembly: {B: left of A-C}
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "a.yaml").write_text(FOUR_BAR, encoding="utf-8")
    (tmp_path / "department.yaml").write_text(STATED, encoding="utf-8")
    return tmp_path


def told(file: Path) -> str:
    with pytest.raises(ProblemError) as error:
        load(file)
    return str(error.value)


@pytest.mark.parametrize("page", ["department", "profile"])
def test_what_the_documentation_writes_is_read(folder, page):
    docs = (VARIANTS.parent / "docs" / f"{page}.md").read_text("utf-8")
    written = re.findall(r"```yaml\n(.*?)```", docs, re.DOTALL)
    assert written
    for text in written:
        (folder / "department.yaml").write_text(text, encoding="utf-8")
        assert load(folder / "a.yaml").title.student == "Иванов И. И."


@pytest.mark.parametrize("name", NAMES)
def test_a_variant_goes_before_its_department_key_by_key(folder, name):
    (folder / "department.yaml").rename(folder / name)
    found = load(folder / "a.yaml")
    assert (found.title.student, found.title.teacher, found.title.year) == (
        "Иванов И. И.",
        "Петров П. П.",
        "2026",
    )
    assert (
        found.title.lines == ("Факультет",)
        and found.note.depth == "short"
        and found.note.omit == ("flywheel",)
    )
    assert found.profile == shipped("dstu") and found.language == "ru" and found.decimal_sign == "point"


def test_the_departments_profile_is_the_base_of_the_variants(folder):
    (folder / "a.yaml").write_text(FOUR_BAR + "profile: {margins: {left: 40 mm}}\n", encoding="utf-8")
    assert load(folder / "a.yaml").profile == stated("dstu", {"margins": {"left": "40 mm"}})


def test_drawing_is_for_variants_with_a_mechanism(folder):
    (folder / "department.yaml").write_text("drawing: {accuracy: 0.1 mm}\n", encoding="utf-8")
    (folder / "r.yaml").write_text((VARIANTS / "rotor.yaml").read_text("utf-8"), encoding="utf-8")
    assert load(folder / "a.yaml").lever.drawing.accuracy == 1e-4 != Drawing().accuracy
    assert load(folder / "r.yaml").lever is None


def test_it_is_looked_for_beside_the_variant_alone(folder):
    inner = folder / "inner"
    inner.mkdir()
    (inner / "a.yaml").write_text(FOUR_BAR, encoding="utf-8")
    assert load(inner / "a.yaml").title.teacher == ""


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        ("title:\n  teachr: A\n", "department.yaml:2:3: title.teachr: ", "teacher"),
        (
            "note: {depth: deep}\nprofile: {margins: {left: 300 mm}}\n",
            "department.yaml:2:21: profile.margins.left",
            "80 mm",
        ),
        ("language: ru\nmechanism: {}\n", "department.yaml:2:1: mechanism: ", ", ".join(KEYS)),
        ("note: [1\n", "department.yaml:", ""),
        ("- 1\n", "department.yaml:1:1", ""),
        ("drawing: {scales: {length: -1}}\n", "department.yaml:1:20", ""),
    ],
)
def test_its_mistakes_have_its_own_name_and_line(folder, text, line, said):
    (folder / "department.yaml").write_text(text, encoding="utf-8")
    found = told(folder / "a.yaml")
    assert line in found and said in found and "a.yaml" not in found.replace("department.yaml", "")


def test_a_mistake_of_the_variant_has_the_variants_line_still(folder):
    (folder / "a.yaml").write_text(FOUR_BAR + "profile: {text: {size: 100}}\n", encoding="utf-8")
    assert "a.yaml:8:18: profile.text.size" in told(folder / "a.yaml")


def test_what_only_the_two_together_do_wrong_is_told_where_it_was_stated_last(folder):
    (folder / "department.yaml").write_text("profile: {margins: {left: 75 mm}}\n", encoding="utf-8")
    (folder / "a.yaml").write_text(FOUR_BAR + "profile: {margins: {right: 70 mm}}\n", encoding="utf-8")
    assert "a.yaml:8:11: profile.margins: " in told(folder / "a.yaml")


def test_a_key_of_the_department_that_the_variant_makes_wrong_is_told_in_the_departments_file(folder):
    (folder / "department.yaml").write_text("note:\n  omit: [flywheel]\n", encoding="utf-8")
    (folder / "a.yaml").write_text(FOUR_BAR + "note: {body: [flywheel]}\n", encoding="utf-8")
    assert "department.yaml:2:10: note.omit" in told(folder / "a.yaml")


def test_two_files_or_a_link_are_refused(folder):
    (folder / "кафедра.yaml").write_text(STATED, encoding="utf-8")
    assert "department.yaml, кафедра.yaml" in told(folder / "a.yaml")
    (folder / "кафедра.yaml").unlink()
    (folder / "department.yaml").rename(folder / "elsewhere.yaml")
    (folder / "department.yaml").symlink_to(folder / "elsewhere.yaml")
    assert "department.yaml" in told(folder / "a.yaml")


def test_batch_reads_it_beside_its_variants_in_folders_and_archives(folder):
    with zipfile.ZipFile(folder / "z.zip", "w") as packed:
        for name in ("a.yaml", "department.yaml"):
            packed.write(folder / name, f"class/{name}")
        packed.writestr("other/a.yaml", FOUR_BAR)
    for place, teachers in (
        (folder, ["Петров П. П."]),
        (folder / "a.yaml", ["Петров П. П."]),
        (folder / "z.zip", ["Петров П. П.", ""]),
    ):
        tasks = list(inputs([str(place)], None, []).tasks)
        assert [loaded(task).title.teacher for task in tasks] == teachers


def test_a_changed_department_makes_a_task_anew(folder):
    def key() -> str:
        (task,) = inputs([str(folder)], None, []).tasks
        return task.key

    before = key()
    (folder / "department.yaml").write_text("language: ru\n", encoding="utf-8")
    assert key() != before


def test_it_is_no_variant_of_a_gallery_or_of_samples(folder):
    assert [file.name for file in variants(folder)] == ["a.yaml"] and [
        file.name for file in samples(folder)[0]
    ] == ["a.yaml"]
    (folder / "a.yaml").unlink()
    with pytest.raises(ProblemError):
        list(inputs([str(folder)], None, []).tasks)


def test_solve_writes_the_note_by_it(folder):
    done = CliRunner().invoke(
        app, ["solve", str(folder / "a.yaml"), "-o", str(folder / "n"), "--format", "html"]
    )
    assert done.exit_code == 0, done.output
    note = (folder / "n" / "note.html").read_text("utf-8")
    assert "Министерство" in note and "Рисунок 1.1 – " in note
