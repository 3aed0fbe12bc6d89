"""A folder that came from elsewhere, with lists and links made to lead astray: nothing outside of it is touched."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest
from notes import VARIANTS
from told import Told

from tmm_report.commands import whole
from tmm_report.commands.batch import run, summary
from tmm_report.commands.files import write
from tmm_report.commands.talk import Linked, unwritable
from tmm_report.commands.whole import LIST, NEW, PART, put
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.running import journal

fcntl = pytest.importorskip("fcntl")  # a system with pipes, links and locks
SET = {"note.html": b"html", "note.tex": b"tex", "figures/figure1.tex": b"1"}
AWAY = ("figures/thesis.tex", "thesis.tex")


@pytest.fixture
def outside(tmp_path) -> Path:
    """A folder of somebody's own, with a list as if it were a note's."""
    folder = tmp_path / "outside"
    (folder / "figures").mkdir(parents=True)
    for name in AWAY:
        (folder / name).write_bytes(b"thesis")
    (folder / LIST).write_text(listed(AWAY))
    return folder


@pytest.fixture
def folder(tmp_path) -> Path:
    (tmp_path / "note" / "own").mkdir(parents=True)
    return tmp_path / "note"


def listed(
    files: Sequence[str], goes: Sequence[object] = (), keeps: Mapping[str, object] | None = None
) -> str:
    digest = whole._digest(b"thesis")
    data = {"files": {name: [digest, ""] for name in files}, "goes": list(goes), "keeps": keeps or {}}
    return json.dumps(data)


def tree(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


@pytest.mark.parametrize("name", [NEW, PART, f"{NEW}/figures", LIST])
@pytest.mark.parametrize("target", [".", "figures", "thesis.tex", "nowhere"])
def test_a_link_in_place_of_what_waits_is_taken_away(folder, outside, name, target):
    before = tree(outside)
    if "/" in name:
        (folder / NEW).mkdir()
        (folder / NEW / LIST).write_text(listed(AWAY))
    (folder / name).symlink_to(outside / target)
    if name == LIST and (outside / target).is_dir():
        with pytest.raises(IsADirectoryError):
            put(folder, SET)
    else:
        put(folder, SET)
        found = tree(folder)
        assert found.pop(LIST) and found == SET
        assert not any(path.is_symlink() for path in folder.rglob("*"))
    assert tree(outside) == before


@pytest.mark.parametrize("waits", [False, True])
def test_figures_that_are_a_link_are_refused_by_name(folder, outside, waits):
    before = tree(outside)
    (folder / "figures").symlink_to(outside)
    (folder / LIST).write_text(listed(["figures/thesis.tex"]))
    if waits:
        (folder / NEW).mkdir()
        (folder / NEW / LIST).write_text(listed(["a.txt"], ["figures/thesis.tex"]))
    with pytest.raises(NotADirectoryError) as error:
        put(folder, SET)
    assert tree(outside) == before and not (folder / "note.tex").exists()
    [problem] = unwritable(folder, error.value).problems
    assert str(problem.text()).startswith(f"cannot write into {folder / 'figures'}: Not a directory")


@pytest.mark.parametrize(
    "goes, keeps",
    [
        (["../outside/thesis.tex"], {}),
        (["/etc/hostname"], {}),
        (["\ud800"], {}),
        (["x" * 5000], {}),
        (["own"], {}),
        ([[1], None, {}], {}),
        ([], {"note.tex": ["x"]}),
        ([".."], {"note.tex": "../outside/thesis.tex"}),
        ([NEW], {"note.tex": LIST}),
    ],
    ids=str,
)
def test_a_plan_made_up_by_others_stops_nothing(folder, outside, goes, keeps):
    before = tree(outside)
    (folder / NEW).mkdir()
    (folder / NEW / LIST).write_text(listed(["a.txt"], goes, keeps))
    put(folder, SET)
    found = tree(folder)
    assert found.pop(LIST) and found == SET
    assert (folder / "own").is_dir() and tree(outside) == before


@pytest.mark.parametrize("name", [NEW, PART])
def test_a_file_under_a_name_of_ours_is_taken_away(folder, name):
    (folder / name).write_text("x")
    put(folder, SET)
    assert not (folder / name).exists() and (folder / "note.tex").read_bytes() == b"tex"


def test_a_list_that_is_a_pipe_or_a_folder_keeps_nobody_waiting(folder):
    os.mkfifo(folder / LIST)
    put(folder, SET)
    (folder / LIST).unlink()
    (folder / LIST).mkdir()
    with pytest.raises(IsADirectoryError):
        put(folder, {"note.tex": b"new"})
    assert (folder / "note.tex").read_bytes() == b"tex" and not (folder / NEW).exists()


def test_a_file_too_large_to_be_ours_is_kept_unread(folder):
    with (folder / "note.tex").open("wb") as stream:
        stream.truncate(1 << 40)
    assert put(folder, SET).kept == {"note.tex": "note.tex.bak"}
    assert (folder / "note.tex.bak").stat().st_size == 1 << 40


def test_a_run_that_goes_on_is_waited_for_and_one_that_ended_is_not(folder, monkeypatch):
    monkeypatch.setattr(whole, "WAITS", 2)
    other = os.open(folder, os.O_RDONLY)
    fcntl.flock(other, fcntl.LOCK_EX)
    with pytest.raises(BlockingIOError) as error:
        put(folder, SET)
    assert error.value.errno == errno.EWOULDBLOCK and not (folder / "note.tex").exists()
    [problem] = unwritable(folder, error.value).problems
    assert problem.text() == f"another run is writing into {folder}"
    os.close(other)
    put(folder, SET)
    assert (folder / "note.tex").read_bytes() == b"tex"


@pytest.mark.parametrize("name", ["figures", "figures/deeper"])
def test_files_are_written_through_no_link_below_the_folder(folder, outside, name):
    before = tree(outside)
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).symlink_to(outside)
    with pytest.raises(Linked) as error:
        write(folder, {"note.tex": b"tex", f"{name}/thesis.tex": b"1"})
    assert tree(outside) == before and tree(folder).keys() <= {f"{name}/{away}" for away in tree(outside)}
    [problem] = unwritable(folder, error.value).problems
    assert f"{folder / name} is a link" in problem.text()


@pytest.mark.parametrize("name", [run.JOURNAL, run.PARTS])
def test_a_batch_neither_keeps_its_journal_nor_makes_its_folders_through_a_link(folder, outside, name):
    target = outside / "thesis.tex" if name == run.JOURNAL else outside
    (folder / name).symlink_to(target)
    before = tree(outside)
    for resume in (False, True):
        with pytest.raises(ProblemError, match="is a link: nothing is written through it"):
            run.run([str(VARIANTS / "scotch_yoke.yaml")], folder, "json", None, Told(), jobs=1, resume=resume)
    assert tree(outside) == before and (folder / name).is_symlink()


def test_a_batch_does_not_write_through_links_either(folder, outside):
    before = tree(outside)
    lines = folder / "journal.jsonl"
    lines.write_bytes(b"")
    for name in (f".{summary.FILE}.part", f".{lines.name}.part"):
        (folder / name).symlink_to(outside / "thesis.tex")
    summary.write(lines, folder, Translator("en"))
    journal.rewrite(lines, [])
    assert tree(outside) == before and not any(path.is_symlink() for path in folder.iterdir())
