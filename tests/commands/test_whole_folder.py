"""A note in its folder: the old set or the new one, whenever the program dies; what the user changed is kept."""

from __future__ import annotations

import errno
import json
import os
import random
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tmm_report.commands import whole
from tmm_report.commands.whole import LIST, NEW, PART, finish, put

OLD = {
    "note.html": b"old html",
    "note.tex": b"old tex",
    "figures/figure1.tex": b"1",
    "figures/figure2.tex": b"2",
}
FRESH = {"note.html": b"new html", "note.tex": b"new tex", "figures/figure1.tex": b"one"}
STEPS = ("rename", "replace", "unlink", "mkdir", "rmdir")


def tree(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file())
    found = {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}
    return {name: content for name, content in found.items() if name != LIST}


class Killed(BaseException):
    """What no handler of the program's catches, as a kill is."""


def dying(monkeypatch, after: int) -> list[str]:
    """The program dies at one of its changes of the folder: nothing that it would do then is done."""
    done: list[str] = []

    def counted(name: str, original):
        def change(*arguments, **named):
            if len(done) >= after:
                raise Killed
            done.append(name)
            return original(*arguments, **named)

        return change

    for name in STEPS:
        monkeypatch.setattr(os, name, counted(name, getattr(os, name)))
    monkeypatch.setattr(whole.shutil, "rmtree", counted("rmtree", whole.shutil.rmtree))
    return done


def test_killed_at_any_step_the_next_run_finds_the_old_or_the_new_set(tmp_path, monkeypatch):
    seen = set()
    for step in range(100):
        folder = tmp_path / str(step)
        put(folder, OLD, "old")
        (folder / "mine.txt").write_bytes(b"mine")
        (folder / "note.tex").write_bytes(b"edited")
        with monkeypatch.context() as patch:
            done = dying(patch, step)
            try:
                put(folder, FRESH, "new")
                ended = True
            except Killed:
                ended = False
        if "rename" not in done:  # the step from which the new set holds
            assert {**OLD, "note.tex": b"edited"}.items() <= tree(folder).items()
        finish(folder)
        found = tree(folder)
        assert found.pop("mine.txt") == b"mine"
        seen.add(tuple(sorted(found)))
        kept = found.pop("note.tex.bak", None)
        assert (found, kept) in (({**OLD, "note.tex": b"edited"}, None), (FRESH, b"edited"))
        assert not (folder / PART).exists() and not (folder / NEW).exists()
        if ended:
            break
    assert ended and step > 8 and len(seen) == 2


def test_figures_that_no_longer_belong_to_the_note_go_and_other_files_stay(tmp_path):
    put(tmp_path, {**OLD, "results.json": b"{}"}, "old")
    (tmp_path / "figures" / "own.tex").write_bytes(b"own")
    done = put(tmp_path, FRESH, "new")
    assert tree(tmp_path) == {**FRESH, "results.json": b"{}", "figures/own.tex": b"own"}
    assert done.left == ["results.json"] and not done.kept
    assert put(tmp_path, FRESH, "old").left == []  # of the same state of the variant


@pytest.mark.parametrize("name", ["note.tex", "note.html", "figures/figure1.tex", "figures/figure2.tex"])
def test_what_was_edited_is_kept_beside_and_numbered(tmp_path, name):
    put(tmp_path, OLD)
    for text, kept in ((b"first", f"{name}.bak"), (b"second", f"{name}.bak2")):
        (tmp_path / name).write_bytes(text)
        assert put(tmp_path, FRESH).kept == {name: kept}
        assert (tmp_path / kept).read_bytes() == text
        assert (tmp_path / name).is_file() == (name in FRESH)
        put(tmp_path, OLD)
    assert put(tmp_path, OLD).kept == {}


def test_a_note_without_a_list_counts_as_edited_and_its_figures_do_not(tmp_path):
    (tmp_path / "figures").mkdir()
    for name, content in OLD.items():
        (tmp_path / name).write_bytes(content)
    assert put(tmp_path, FRESH).kept == {"note.html": "note.html.bak", "note.tex": "note.tex.bak"}
    assert (tmp_path / "figures" / "figure1.tex").read_bytes() == b"one"


@pytest.mark.parametrize(
    "text",
    ["", "[]", "{", '{"files": 3}', '{"files": {"a": 1}}', '{"files": {"../x.tex": ["0", ""]}}', "\0" * 50],
)
def test_a_list_that_is_not_ours_says_nothing(tmp_path, text):
    outside, folder = tmp_path / "x.tex", tmp_path / "note"
    outside.write_bytes(b"outside")
    folder.mkdir()
    (folder / LIST).write_text(text)
    put(folder, FRESH)
    assert tree(folder) == FRESH and outside.read_bytes() == b"outside"


def test_a_list_that_climbs_takes_nothing_away(tmp_path):
    (tmp_path / "x.tex").write_bytes(b"outside")
    folder = tmp_path / "note"
    (folder / NEW).mkdir(parents=True)
    (folder / NEW / LIST).write_text(
        json.dumps({"files": {"note.tex": ["0", ""]}, "goes": ["../x.tex"], "keeps": {"note.tex": "../y"}})
    )
    finish(folder)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["note", "x.tex"]


def test_a_full_disk_leaves_the_old_set(tmp_path, monkeypatch):
    put(tmp_path, OLD)
    original = Path.write_bytes

    def full(self, content):
        if b"tex" in content:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(self))
        return original(self, content)

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OSError, match="No space"):
        put(tmp_path, FRESH)
    with pytest.raises(OSError, match="No space"):
        put(tmp_path / "deep" / "new", FRESH)
    assert tree(tmp_path) == OLD and not (tmp_path / "deep").exists() and not (tmp_path / PART).exists()


def test_a_folder_or_a_file_in_the_way_leaves_the_old_set(tmp_path):
    put(tmp_path, {"note.tex": b"old"})
    (tmp_path / "note.html").mkdir()
    (tmp_path / "figures").write_bytes(b"a file")
    for files in (FRESH, {"note.tex": b"x", "figures/figure1.tex": b"one"}):
        with pytest.raises(OSError):
            put(tmp_path, files)
    assert tree(tmp_path) == {"note.tex": b"old", "figures": b"a file"}


CHILD = """
import sys
from pathlib import Path
from tmm_report.commands.whole import put
folder, k = Path(sys.argv[1]), 0
print("ready", flush=True)
while True:
    k += 1
    figures = {f"figures/f{n}.tex": b"%d" % k * 2000 for n in range(8 + k % 3)}
    put(folder, {"note.html": b"%d" % k * 2000, "note.tex": b"%d" % k * 2000, **figures}, str(k))
"""


@pytest.mark.exhaustive
@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_killed_at_random_moments_the_folder_is_of_one_piece(tmp_path):
    moments = random.Random(12)
    for _ in range(6):
        child = subprocess.Popen([sys.executable, "-c", CHILD, str(tmp_path)], stdout=subprocess.PIPE)
        assert child.stdout is not None and child.stdout.readline() == b"ready\n"
        child.stdout.close()
        with pytest.raises(subprocess.TimeoutExpired):
            child.wait(moments.uniform(0.02, 0.1))
        child.send_signal(signal.SIGKILL)
        child.wait()
        finish(tmp_path)
        found = tree(tmp_path)
        assert len(set(found.values())) == 1 and len(found) in (10, 11, 12)
        assert not [name for name in found if ".part" in name or name.startswith(".")]
