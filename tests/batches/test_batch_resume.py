"""A batch that was stopped goes on where it was, and ends with the bytes of one that nobody disturbed."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import batch_chores
import pytest
from batching import Heard, batch, mixed, statuses, student, tree, write
from exhaustive import many

from tmm_report.commands.batch import progress
from tmm_report.commands.batch import run as command
from tmm_report.problems import ProblemError
from tmm_report.running.journal import Journal, read

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals")


@pytest.fixture
def source(tmp_path) -> Path:
    return mixed(tmp_path / "variants")


def counted(monkeypatch) -> list[str]:
    """Ids of the variants that are worked on."""
    done: list[str] = []
    keep = command._Batch._keep
    monkeypatch.setattr(
        command._Batch, "_keep", lambda self, task, found: (done.append(task.id), keep(self, task, found))
    )
    return done


@pytest.mark.exhaustive
def test_a_folder_with_a_run_is_not_written_over(source, tmp_path):
    batch([source], tmp_path / "out")
    before = tree(tmp_path / "out")
    with pytest.raises(ProblemError, match="holds a run already; --resume"):
        batch([source], tmp_path / "out")
    assert tree(tmp_path / "out") == before


@POSIX
def test_a_second_run_in_the_same_folder_is_told_to_wait(source, tmp_path):
    (tmp_path / "out").mkdir()
    with Journal(tmp_path / "out" / "journal.jsonl"), pytest.raises(ProblemError, match="another run"):
        batch([source], tmp_path / "out", resume=True)


@pytest.mark.exhaustive
def test_resuming_a_finished_run_does_nothing_again(source, tmp_path, monkeypatch):
    batch([source], tmp_path / "out")
    before, done = tree(tmp_path / "out"), counted(monkeypatch)
    batch([source], tmp_path / "out", resume=True)
    assert done == [] and tree(tmp_path / "out") == before


@pytest.mark.exhaustive
def test_only_what_is_new_or_changed_is_done(source, tmp_path, monkeypatch):
    batch([source], tmp_path / "out")
    write(source, aaa=student("New"), boris=student("Changed"))
    done = counted(monkeypatch)
    batch([source], tmp_path / "out", resume=True)
    assert sorted(done) == ["aaa", "boris"]
    batch([source], tmp_path / "other")
    assert tree(tmp_path / "out") == tree(tmp_path / "other")


@pytest.mark.exhaustive
@pytest.mark.parametrize("changed", many([{"formats": "json,csv"}, {"version": "9"}, {"language": "ru"}], 2))
def test_other_options_or_another_program_do_it_anew(source, tmp_path, monkeypatch, changed):
    batch([source], tmp_path / "out")
    done = counted(monkeypatch)
    if "version" in changed:
        monkeypatch.setattr("tmm_report.commands.batch.inputs.__version__", changed.pop("version"))
    batch([source], tmp_path / "out", resume=True, **changed)
    assert len(done) == 6


@pytest.mark.exhaustive
def test_a_lost_folder_or_a_cut_file_is_made_anew(source, tmp_path, monkeypatch):
    batch([source], tmp_path / "out")
    before = tree(tmp_path / "out")
    (tmp_path / "out" / "anna" / "results.json").unlink()
    (tmp_path / "out" / "vera" / "results.json").write_bytes(b"{")
    done = counted(monkeypatch)
    batch([source], tmp_path / "out", resume=True)
    assert sorted(done) == ["anna", "vera"] and tree(tmp_path / "out") == before


@pytest.mark.exhaustive
def test_a_torn_journal_loses_one_variant(source, tmp_path, monkeypatch):
    batch([source], tmp_path / "out")
    before, journal = tree(tmp_path / "out"), tmp_path / "out" / "journal.jsonl"
    journal.write_bytes(journal.read_bytes()[:-40])
    done = counted(monkeypatch)
    batch([source], tmp_path / "out", resume=True)
    assert done == ["vera"] and tree(tmp_path / "out") == before


@pytest.mark.exhaustive
def test_a_variant_that_turned_wrong_has_no_old_note(source, tmp_path):
    batch([source], tmp_path / "out")
    write(source, anna="nonsense: 1")
    batch([source], tmp_path / "out", resume=True)
    assert not (tmp_path / "out" / "anna").exists()
    assert statuses(tmp_path / "out")["anna"] == "wrong"


@pytest.mark.exhaustive
def test_folders_of_variants_that_are_gone_stay_but_are_not_listed(source, tmp_path):
    batch([source], tmp_path / "out")
    (source / "anna.yaml").unlink()
    batch([source], tmp_path / "out", resume=True)
    assert (tmp_path / "out" / "anna" / "results.json").is_file()
    assert "anna" not in statuses(tmp_path / "out")


PATHS = os.pathsep.join(
    str(Path(__file__).parents[k]) for k in range(3)
)  # of this room, the tests, the program
BATCH = """
import sys
from pathlib import Path
from tmm_report.commands.batch.run import run
from batching import Heard
if __name__ == "__main__":
    run([sys.argv[1]], Path(sys.argv[2]), "json", "en", Heard(), jobs=2, resume=True)
"""


def started(tmp_path: Path, source: Path, output: Path) -> subprocess.Popen:
    script = tmp_path / "batch.py"
    script.write_text(BATCH)
    return subprocess.Popen(
        [sys.executable, str(script), str(source), str(output)],
        env={**os.environ, "PYTHONPATH": PATHS},
        stderr=subprocess.PIPE,
        start_new_session=True,
    )


@pytest.fixture
def thirty(tmp_path) -> Path:
    return write(tmp_path / "thirty", **{f"v{k:02}": student(f"S{k}") for k in range(24)})


@pytest.mark.exhaustive
@POSIX
def test_a_run_that_is_killed_goes_on_and_ends_with_the_same_bytes(thirty, tmp_path):
    batch([thirty], tmp_path / "undisturbed")
    moments = random.Random(9)
    for _ in range(4):
        running = started(tmp_path, thirty, tmp_path / "out")
        time.sleep(moments.uniform(0.3, 2.5))
        os.killpg(running.pid, signal.SIGKILL)
        running.communicate()
    batch([thirty], tmp_path / "out", resume=True)
    assert tree(tmp_path / "out") == tree(tmp_path / "undisturbed")


@pytest.mark.exhaustive
@POSIX
def test_ctrl_c_says_how_to_go_on(thirty, tmp_path):
    running = started(tmp_path, thirty, tmp_path / "out")
    journal = tmp_path / "out" / "journal.jsonl"
    end = time.monotonic() + 180
    while not (journal.exists() and journal.stat().st_size):
        assert time.monotonic() < end
        time.sleep(0.01)
    os.killpg(running.pid, signal.SIGINT)
    _, said = running.communicate(timeout=180)
    assert running.returncode != 0 and said.decode().count("Traceback") == 1
    done = len(list(read(journal)))
    assert done > 0
    batch([thirty], tmp_path / "out", resume=True)
    batch([thirty], tmp_path / "undisturbed")
    assert tree(tmp_path / "out") == tree(tmp_path / "undisturbed")


def test_stopping_is_told_with_what_is_done(thirty, tmp_path, monkeypatch):
    monkeypatch.setattr(command, "work", batch_chores.trivial)
    talk = Heard()
    done = progress.Progress.done

    def interrupted(self):
        done(self)
        if self.made == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr(progress.Progress, "done", interrupted)
    with pytest.raises(KeyboardInterrupt):
        batch([thirty], tmp_path / "out", talk=talk)
    assert talk.warned == ["stopped; variants done: 3. --resume goes on from here"]
    assert len(list(read(tmp_path / "out" / "journal.jsonl"))) == 3


MEMORY = """
import sys
from pathlib import Path
from tmm_report.commands.batch import run as command
import batch_chores, batching, resource
from tmm_report.commands.batch.inputs import Given, Task
from tmm_report.running.journal import digest
if __name__ == "__main__":
    n = int(sys.argv[1])
    tasks = (Task(k, f"v{k}", f"v{k}", b"x" * 100_000, digest(str(k))) for k in range(n))
    command.inputs = lambda *_: Given(tasks, n)
    command.work = batch_chores.trivial
    command.run([], Path(sys.argv[2]), "json", "en", batching.Heard(), jobs=1)
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


@pytest.mark.exhaustive
@POSIX
def test_memory_is_flat_however_many_variants(tmp_path):
    """300 MB of variants pass through a process that grows by a tenth of that at most."""
    (tmp_path / "memory.py").write_text(MEMORY)

    def peak(count: int) -> int:
        done = subprocess.run(
            [sys.executable, str(tmp_path / "memory.py"), str(count), str(tmp_path / f"out{count}")],
            env={**os.environ, "PYTHONPATH": PATHS},
            capture_output=True,
            text=True,
            check=True,
        )
        return int(done.stdout) * (1 if sys.platform == "darwin" else 1024)

    assert peak(3000) - peak(300) < 30e6
