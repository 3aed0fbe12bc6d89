"""`solve --watch`: each save is a round; the open page follows in place; mistakes stand there for old numbers."""

from __future__ import annotations

import math
import os
import re
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest
from browser import NavigatedError, Talk, browser
from notes import VARIANTS, note
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands import watch
from tmm_report.problems import Message, Problem, ProblemError

SHAPER = (VARIANTS / "shaper.yaml").read_text("utf-8")
WRONG = re.sub(r"speed: \d+ rpm", "speed: 70 rpmm", SHAPER)
OTHER = re.sub(r"speed: \d+ rpm", "speed: 70 rpm", SHAPER)
SECONDS = 180


def run(*arguments: object):
    return CliRunner().invoke(app, [str(a) for a in arguments], env={"LANG": "C", "LC_ALL": "C"})


def until(holds) -> None:
    end = time.monotonic() + SECONDS
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.02)


class Watching:
    """The command in a process of its own."""

    def __init__(self, folder: Path, *options: str):
        self.file, self.note = folder / "my.yaml", folder / "my-note"
        self.file.write_text(SHAPER, encoding="utf-8")
        command = [
            sys.executable,
            "-m",
            "tmm_report",
            "solve",
            "my.yaml",
            "--watch",
            "--lang",
            "en",
            *options,
        ]
        env = os.environ | {"PYTHONPATH": str(Path(watch.__file__).parents[2]), "PYTHONUNBUFFERED": "1"}
        self.log = folder / "log"
        with self.log.open("w") as log:
            self.process = subprocess.Popen(command, cwd=folder, env=env, stdout=log, stderr=log)

    def round(self, number: int) -> str:
        """What was said, once a round is over."""
        until(lambda: self.process.poll() is None and self.said().count("up to date") >= number)
        return self.said()

    def said(self) -> str:
        return self.log.read_text("utf-8")

    def page(self) -> str:
        return (self.note / watch.PAGE).read_text("utf-8")

    def end(self) -> int:
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(SECONDS)


@pytest.fixture
def watching(tmp_path):
    one = Watching(tmp_path)
    yield one
    if one.process.poll() is None:
        one.process.kill()
        one.process.wait()


def test_each_save_is_a_round_and_ctrl_c_ends_cleanly(watching):
    watching.round(1)
    assert watching.page().count("<svg") > 10
    first = (watching.note / "note.html").read_bytes()
    watching.file.write_text(WRONG, encoding="utf-8")
    assert re.search(r"my\.yaml:\d+:\d+: mechanism\.driver\.speed: unknown unit rpmm", watching.round(2))
    page = watching.page()
    assert "<svg" not in page and "<td" not in page and "unknown unit rpmm" in page  # no old numbers
    assert (watching.note / "note.html").read_bytes() == first
    watching.file.write_text(OTHER, encoding="utf-8")
    said = watching.round(3)
    assert watching.page().count("<svg") > 10 and (watching.note / "note.html").read_bytes() != first
    assert len(re.findall(r"^\d+\.\d\d s; ", said, re.M)) == 3
    assert watching.end() == 0
    assert "no longer watching my.yaml" in watching.said() and "Traceback" not in watching.said()
    left = {path.name for path in watching.note.iterdir()}
    assert left == {"note.html", ".tmm-report.json"}


def test_a_file_that_is_gone_for_a_moment_is_waited_for(watching):
    watching.round(1)
    watching.file.rename(watching.file.with_suffix(".bak"))
    time.sleep(0.5)
    assert watching.process.poll() is None and watching.said().count("up to date") == 1
    watching.file.write_text(OTHER, encoding="utf-8")
    assert "No such file" not in watching.round(2)


def test_what_the_department_states_is_watched_too(watching):
    watching.round(1)
    before = len(watching.page())
    (watching.file.parent / "department.yaml").write_text("note: {depth: short}\n", encoding="utf-8")
    watching.round(2)
    assert len(watching.page()) < 0.9 * before


def test_what_takes_longer_is_made_behind_the_page(tmp_path, monkeypatch):
    """The page shows the note before another format is begun; a save in between ends the round there."""
    (tmp_path / "my.yaml").write_text(SHAPER, encoding="utf-8")
    folder, begun, saves = tmp_path / "o", [], [OTHER]

    def pause(seconds: float) -> None:
        if seconds == watch.PAUSE:  # nothing is left to do
            raise KeyboardInterrupt

    def step(said) -> None:
        text = str(said)
        begun.append((text, (folder / watch.PAGE).exists()))
        if "tex" in text and saves:
            (tmp_path / "my.yaml").write_text(saves.pop(), encoding="utf-8")

    talk = Heard()
    talk.stage = step
    monkeypatch.setattr(watch.time, "sleep", pause)
    monkeypatch.setattr("tmm_report.commands.by_typst.typeset", lambda source: b"%PDF " + source[:0])
    monkeypatch.setattr("tmm_report.commands.printing.print_pdf", lambda note: b"%PDF printed")
    watch.run(
        tmp_path / "my.yaml", folder, "tex,json", "en", talk,
        pdf="typst", print_it=True, combinations_too=True,
    )  # fmt: skip
    ways = "writing html|writing tex"
    round_ = f"{ways}|writing json|compiling the PDF|printing the note"
    assert "|".join(text for text, _ in begun) == f"{ways}|{round_}"  # the first round ended at the save
    assert [there for _, there in begun] == [False] + [True] * 6
    left = {path.name for path in folder.iterdir()}
    assert left >= {"note.html", "note.tex", "results.json", "note.pdf", "note-print.pdf"}
    assert watch.PAGE not in left and b"70" in (folder / "note.tex").read_bytes()


class Heard:
    """A command's talk, of which nothing is kept."""

    def speak(self, language): ...
    def stage(self, doing): ...
    def tell(self, line): ...
    def warn(self, line): ...


def test_what_no_saving_mends_is_told_at_once(tmp_path):
    assert run("solve", tmp_path / "none.yaml", "--watch").exit_code == 2
    (tmp_path / "my.yaml").write_text(SHAPER, encoding="utf-8")
    assert run("solve", tmp_path / "my.yaml", "--watch", "--format", "odt").exit_code == 2
    assert run("solve", tmp_path / "my.yaml", "--watch", "--depth", "deep").exit_code == 2
    assert run("solve", tmp_path / "my.yaml", "--watch", "--pdf=word").exit_code == 2
    assert {path.name for path in tmp_path.iterdir()} == {"my.yaml"}


def test_the_open_page_is_the_live_one(tmp_path, monkeypatch):
    shown, pauses = [], []
    monkeypatch.setattr("webbrowser.open", shown.append)

    def pause(seconds: float) -> None:
        pauses.append(seconds)
        if seconds == watch.PAUSE:
            raise KeyboardInterrupt

    monkeypatch.setattr(watch.time, "sleep", pause)
    (tmp_path / "my.yaml").write_text(SHAPER, encoding="utf-8")
    assert run("solve", tmp_path / "my.yaml", "-o", tmp_path / "o", "--watch", "--open").exit_code == 0
    assert shown == [(tmp_path / "o" / watch.PAGE).as_uri()] and pauses[-1] == watch.PAUSE


@pytest.mark.parametrize(
    "hostile", ["<script>alert(1)</script>", "<img src=x onerror=alert(1)>", "\x1b]0;x\x07"]
)
def test_a_mistake_breaks_out_of_no_page(hostile):
    error = ProblemError([Problem(Message("%(x)s", {"x": hostile}), file="my.yaml", line=1, column=2)])
    page = watch.live(watch.mistakes(error, "ru"), 1).decode()
    assert page.count("<script>") == 1 and "<img" not in page and "my.yaml:1:2" in page
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page)
    assert (
        policy
        and "default-src 'none'" in policy[1]
        and "unsafe-inline" not in policy[1].split("script-src")[1]
    )


# ---------------------------------------------------------------- in a browser

SHOWN = """({round: document.querySelector('meta[name="tmm-report-round"]')?.content, y: window.scrollY,
 top: document.getElementById(%r)?.getBoundingClientRect().top, mistakes: !!document.querySelector("[data-mistakes]"),
 ready: document.readyState})"""


def shown(talk: Talk, name: str) -> dict:
    """Nothing of a page that is just being left for the next round."""
    try:
        found = talk.ask("Runtime.evaluate", expression=SHOWN % name, returnByValue=True)
    except NavigatedError:
        return {}
    return found["result"].get("value") or {}


def loaded(talk: Talk, number: int) -> bool:
    now = shown(talk, "x")
    return now.get("round") == str(number) and now["ready"] == "complete"


def test_the_open_page_follows_and_stays_where_it_was(tmp_path):
    """Round 2 has a longer beginning; round 3 mistakes; round 4 the note again, where it stood."""
    page = note("shaper", "html", "en")["note.html"]
    longer = page.replace(b"<main>", b"<main><p>" + b"more<br>" * 40 + b"</p>", 1)
    error = ProblemError([Problem(Message("wrong"))])
    rounds = [page, longer, watch.mistakes(error, "en"), page]

    def put(number: int) -> None:
        (tmp_path / watch.PAGE).write_bytes(watch.live(rounds[number - 1], number))
        (tmp_path / watch.ROUND).write_text(f"tmmReportRound({number});\n")

    put(1)
    with browser(tmp_path) as talk:
        target = talk.ask("Target.createTarget", url="about:blank", width=1000, height=800, newWindow=True)
        talk.session = talk.ask("Target.attachToTarget", **target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            talk.ask(f"{domain}.enable")
        talk.ask("Page.navigate", url=(tmp_path / watch.PAGE).as_uri())
        until(
            lambda: shown(talk, "figure3").get("top") is not None and shown(talk, "x")["ready"] == "complete"
        )
        talk.ask(
            "Runtime.evaluate",
            expression="document.getElementById('figure3').scrollIntoView({behavior:'instant'})",
        )
        before = shown(talk, "figure3")
        assert before["round"] == "1" and before["y"] > 500
        for number, wrong in ((2, False), (3, True), (4, False)):
            put(number)
            until(partial(loaded, talk, number))
            now = shown(talk, "figure3")
            assert now["mistakes"] is wrong
            if not wrong:
                until(lambda: abs(shown(talk, "figure3").get("top", math.inf) - before["top"]) <= 2)
        asked = {
            e["params"]["request"]["url"].partition("?")[0] for e in talk.of("Network.requestWillBeSent")
        }
        assert {one for one in asked if not one.startswith("data:")} == {
            (tmp_path / name).as_uri() for name in (watch.PAGE, watch.ROUND)
        }
        console = [str(e["params"]) for e in talk.of("Log.entryAdded", "Runtime.exceptionThrown")]
        assert console == []
        talk.session = None
        talk.ask("Target.closeTarget", **target)
