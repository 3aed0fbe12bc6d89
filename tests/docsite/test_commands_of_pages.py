"""Every command line of the documentation is run, in a folder that has what such folders have; it ends as it should.

A teacher's afternoon, and the first hour word for word, have tests of their own that look at what comes out."""

from __future__ import annotations

import shutil
from pathlib import Path
from unittest.mock import patch

import pytest
import typer
from batching import here
from notes import VARIANTS
from pages_of_docs import PAGES, ROOT, commands
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands.batch import run as batch
from tmm_report.commands.grade import run as grade

WRITTEN = [page for page in PAGES if commands(page)]
WALKED = {"docs/afternoon.md", "docs/ru/afternoon.md", "docs/hour.md", "docs/ru/hour.md"}
APART = {  # parsed here, and run by the tests of these commands
    "verify": "tests/commands/test_verify.py",
    "--cluster": "tests/running",
}
DEAR = ("methods", "--pdf")  # run where they stand first, parsed elsewhere
PROGRAMS = {"--print": ("chromium", "google-chrome")}
GROUP = "id;student;group\na1;Иванов И. И.;М-21\na2;Петров П. П.;М-21\n"
ANSWERS = "S_B: [0, 0.0176, 0.0628]\nvalues: {H_B: 200 mm}\n"


def test_pages_that_have_commands_are_found():
    assert {"README.md", "docs/grading.md", "docs/index.md", "docs/batch.md", "docs/year.md"} <= {*WRITTEN}
    assert sum(len(commands(page)) for page in WRITTEN) > 70


@pytest.mark.parametrize("page", WRITTEN)
def test_every_command_is_one_with_its_options(page):
    """As the command line reads it, without running it."""
    group = typer.main.get_group(app)
    for arguments in commands(page):
        name, *rest = arguments
        assert name in group.commands, arguments
        group.commands[name].make_context(name, [*rest])


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    """What a course has in its folder."""
    place = tmp_path_factory.mktemp("scene")
    compressor = VARIANTS / "compressor.yaml"
    for name in (
        "my.yaml",
        "variant.yaml",
        "variants/a1.yaml",
        "variants/a2.yaml",
        "folder/a.yaml",
        "samples/one.yaml",
    ):
        (place / name).parent.mkdir(exist_ok=True)
        shutil.copy(compressor if name != "samples/one.yaml" else VARIANTS / "rotor.yaml", place / name)
    ranges = (ROOT / "docs/examples/compressor.ranges.yaml").read_text("utf-8")
    for name in ("ranges.yaml", "compressor.ranges.yaml", "template.ranges.yaml"):
        (place / name).write_text(
            ranges.replace("../../variants/compressor.yaml", str(compressor)), encoding="utf-8"
        )
    shutil.copy(ROOT / "docs/examples/rubric.yaml", place / "rubric.yaml")
    (place / "group.csv").write_text(GROUP, encoding="utf-8")
    (place / "answers").mkdir()
    for id in ("a1", "a2"):
        (place / "answers" / f"{id}.yaml").write_text(ANSWERS, encoding="utf-8")
    for made in (
        [
            "assign",
            "ranges.yaml",
            "--students",
            "group.csv",
            "-o",
            "assignments.csv",
            "--variants",
            "handout",
        ],
        ["check", "samples", "--update"],
        ["solve", "my.yaml"],
    ):
        assert run(made, place).exit_code in (0, 1)  # 1: samples that were not stored before
    return place


def run(arguments: list[str], folder: Path):
    """In this process alone: the pool of others is tested in tests/batches."""
    with (
        pytest.MonkeyPatch.context() as changed,
        patch.object(batch, "over", here),
        patch.object(grade, "over", here),
    ):
        changed.chdir(folder)
        changed.setattr("webbrowser.open", lambda address: True)
        return CliRunner().invoke(app, arguments, env={"LANG": "C", "LC_ALL": "C"})


def prepared(arguments: list[str], folder: Path) -> list[str]:
    """A command as it is run here: what it writes anew is not there yet; a watch, which never ends, is one round."""
    if arguments[0] == "new" and len(arguments) > 1:
        (folder / arguments[1]).unlink(missing_ok=True)
    if arguments[0] in ("batch", "gallery") and "-o" in arguments:
        shutil.rmtree(folder / arguments[arguments.index("-o") + 1], ignore_errors=True)
    quick = ["--quick"] if arguments[0] == "methods" else []
    return [one for one in arguments if one != "--watch"] + quick


def once(pages: list[str]) -> list[str]:
    """Without pages whose commands another has, too, one after another: translations, as a rule."""
    kept: list[str] = []
    for page in sorted(pages, key=lambda page: -len(commands(page))):
        if not any(stand_in(commands(page), commands(other)) for other in kept):
            kept.append(page)
    return [page for page in pages if page in kept]


def stand_in(few: list[list[str]], many: list[list[str]]) -> bool:
    return any(many[k : k + len(few)] == few for k in range(len(many)))


def elsewhere(arguments: list[str], page: str) -> bool:
    """Whether the tests of a command, or another page, run one of its kind."""
    first = {one: next(p for p in WRITTEN if any(one in other for other in commands(p))) for one in DEAR}
    return any(one in arguments for one in APART) or any(
        one in arguments and first[one] != page for one in DEAR
    )


def test_no_command_is_left_out_that_no_other_page_has():
    pages = {"a": [["x"], ["y"]], "b": [["w"], ["x"], ["y"]], "c": [["w"], ["y"]], "d": [["x"], ["y"]]}
    with patch(f"{__name__}.commands", pages.__getitem__):
        assert once(["a", "b", "c", "d"]) == ["b", "c"]
    assert {tuple(one) for page in WRITTEN for one in commands(page)} == {
        tuple(one) for page in {*once(WRITTEN)} for one in commands(page)
    }


@pytest.mark.exhaustive
@pytest.mark.parametrize("page", once([page for page in WRITTEN if page not in WALKED]))
def test_every_command_does_what_it_is_written_for(page, scene, tmp_path):
    shutil.copytree(scene, tmp_path, dirs_exist_ok=True)
    for arguments in commands(page):
        lacking = [
            one for one, names in PROGRAMS.items() if one in arguments and not any(map(shutil.which, names))
        ]
        if lacking or elsewhere(arguments, page):
            continue
        done = run(prepared(arguments, tmp_path), tmp_path)
        assert done.exit_code == 0, (arguments, done.output[-500:], done.exception)
