"""One headless Chromium opens all pages that the tests look at, once a run: it is told what to do through pipes.

Its DevTools protocol, https://chromedevtools.github.io/devtools-protocol: JSON messages that end in a zero byte.
"""

from __future__ import annotations

import base64
import json
import os
import select
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import matplotlib
import pytest
from conftest import read
from notes import NAMES, note, program, render
from once import once

from tmm_report import solve
from tmm_report.commands.assemblies.page import page
from tmm_report.commands.assemblies.ways import find
from tmm_report.course import Results
from tmm_report.i18n import Translator
from tmm_report.languages import LANGUAGES
from tmm_report.loading import loads
from tmm_report.profiles import shipped

OPTIONS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-extensions",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
    "--remote-debugging-pipe",
]  # fmt: skip
SECONDS = 120  # a browser that says nothing for so long has failed
Message = dict[str, Any]


def a_note(name: str, language: str) -> bytes:
    return note(name, "html", language)["note.html"]


def a_wide_note(language: str) -> bytes:
    """Of a variant with long names, long numbers and more columns than a page holds."""
    return render(wide_results(), "html", language)["note.html"]


@once
def wide_results() -> Results:
    return solve(loads((CASES / "wide.yaml").read_text(encoding="utf-8")))


CASES = Path(__file__).parent / "cases" / "mechanics"
PAGES: dict[str, Callable[[], bytes]] = {
    "compressor-ru": lambda: a_note("compressor", "ru"),
    "compressor-en": lambda: a_note("compressor", "en"),
    "shaper-ru": lambda: a_note("shaper", "ru"),
    "hoist_drive-ru": lambda: a_note("hoist_drive", "ru"),
    "assemblies": lambda: page(find(read("press")), Translator("en"))["assemblies.html"],
    "wide-ru": lambda: a_wide_note("ru"),
    "wide-en": lambda: a_wide_note("en"),
}
PRINTED = {"compressor-ru", "compressor-en", "assemblies"}
QUICK, QUICK_PRINTED = {"compressor-ru", "assemblies"}, {"crank_rocker-ru", "wide-ru"}
FONTS = Path(matplotlib.get_data_path()) / "fonts" / "ttf"  # the same on every machine
PIXELS = 96 / 25.4  # CSS pixels of 1 mm

# What the page itself can tell, in CSS pixels.
MEASURES = """
document.fonts.ready.then(() => {
  const box = e => { const r = e.getBoundingClientRect(); return [r.width, r.height]; };
  const right = e => e.getBoundingClientRect().right;
  const all = s => [...document.querySelectorAll(s)];
  const broken = all('a[href^="#"]').filter(a => !document.getElementById(decodeURIComponent(a.hash.slice(1))));
  return {
    maths: all("math").map(box), figures: all("figure svg").map(box),
    inText: all("figure svg").filter(s => !s.closest(".sheet")).map(box), tables: all("table").map(box),
    images: all("img").length, broken: broken.map(a => a.hash), fonts: [...document.fonts].map(f => f.status),
    page: document.documentElement.scrollWidth, shown: document.documentElement.clientWidth,
    errors: all("merror, parsererror").length, lang: document.documentElement.lang,
    overlong: all("math").filter(m => right(m) > right(m.closest("section, main, body")) + 1).length,
  };
})
"""


@dataclass(frozen=True)
class Seen:
    """A page as the browser shows it: its measures, what it asked for, what the console said, the page printed."""

    text: str
    measures: dict[str, Any]
    asked: list[str]
    console: list[str]
    pdf: bytes


# Where a printed page has an element beyond its text, and a formula or a word against its measured width, ems.
IN_PRINT = """
document.fonts.ready.then(() => {
  const main = document.querySelector("main").getBoundingClientRect();
  const all = s => [...document.querySelectorAll(s)];
  const size = e => parseFloat(getComputedStyle(e).fontSize);
  const outside = e => e.right > main.right + 0.5 || e.left < main.left - 0.5;
  const seen = e => !e.closest("svg, .sheet") && (e.localName === "math" || !e.closest("math"));
  const wide = all("main *").filter(e => seen(e) && outside(e.getBoundingClientRect()));
  const maths = all(".formula math:not(.again)").map(e => [e.outerHTML, e.getBoundingClientRect().width / size(e)]);
  const drawn = all("figure svg").map(e => [e.getAttribute("width"), parseFloat(getComputedStyle(e).width)]);
  return {text: main.width, wide: wide.map(e => e.outerHTML.slice(0, 200)), maths, drawn};
})
"""


@once
def in_print(quick: bool) -> dict[str, dict[str, Any]]:
    """Notes laid out for print: a small and a wide one; or all other ready variants', and the other wide one."""
    notes = {f"{name}-{read(name).language}": partial(a_note, name, read(name).language) for name in NAMES}
    makers = notes | {f"wide-{language}": partial(a_wide_note, language) for language in LANGUAGES}
    chosen = {name: make for name, make in makers.items() if (name in QUICK_PRINTED) == quick}
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder, browser(Path(folder)) as talk, sheet(talk):
        place = Path(folder) / "note.html"
        return {name: laid_out(talk, place, make(), text_of(name)) for name, make in chosen.items()}


def text_of(name: str) -> float:
    """The width of the text by the profile of the note's language, mm."""
    return shipped(LANGUAGES[name.rpartition("-")[2]].profile).margins.left_of_a4[0]


@contextmanager
def sheet(talk: Talk) -> Iterator[None]:
    """One window for notes laid out for print, one after another: a window is dearer than a small note."""
    target = talk.ask("Target.createTarget", url="about:blank", width=1000, height=1200, newWindow=True)
    talk.session = talk.ask("Target.attachToTarget", **target, flatten=True)["sessionId"]
    talk.ask("Page.enable")
    talk.ask("Emulation.setEmulatedMedia", media="print")
    yield
    talk.session = None
    talk.ask("Target.closeTarget", **target)


def laid_out(talk: Talk, file: Path, content: bytes, width: float) -> dict[str, Any]:
    """On a `sheet`; `width`: of the text of the page, mm."""
    file.write_bytes(content)
    talk.ask(
        "Emulation.setDeviceMetricsOverride",
        width=round(width * PIXELS),
        height=1200,
        deviceScaleFactor=1,
        mobile=False,
    )
    talk.events.clear()
    talk.ask("Page.navigate", url=file.as_uri())
    talk.wait_for("Page.loadEventFired")
    found = talk.ask("Runtime.evaluate", expression=IN_PRINT, awaitPromise=True, returnByValue=True)
    return found["result"]["value"]


@once
def printed_without_fonts(name: str, language: str) -> bytes:
    """A note printed where no font is installed."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as place:
        folder = Path(place)
        (folder / "fonts").mkdir()
        with browser(folder, folder / "fonts") as talk:
            return opened(talk, folder, name, a_note(name, language), print_it=True).pdf


def seen(name: str) -> Seen:
    return _seen(name in QUICK)[name]


@once
def _seen(quick: bool) -> dict[str, Seen]:
    """The pages that quick tests look at, or all others."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder, browser(Path(folder)) as talk:
        return {
            name: opened(talk, Path(folder), name, make(), name in PRINTED)
            for name, make in PAGES.items()
            if (name in QUICK) == quick
        }


def opened(talk: Talk, folder: Path, name: str, content: bytes, print_it: bool = False) -> Seen:
    file = folder / f"{name}.html"
    file.write_bytes(content)
    target = talk.ask("Target.createTarget", url="about:blank", width=1000, height=1200, newWindow=True)
    talk.session = talk.ask("Target.attachToTarget", **target, flatten=True)["sessionId"]
    talk.events.clear()
    for domain in ("Page", "Runtime", "Log", "Network"):
        talk.ask(f"{domain}.enable")
    talk.ask("Page.navigate", url=file.as_uri())
    talk.wait_for("Page.loadEventFired")
    measured = talk.ask("Runtime.evaluate", expression=MEASURES, awaitPromise=True, returnByValue=True)
    asked = [event["params"]["request"]["url"] for event in talk.of("Network.requestWillBeSent")]
    console = talk.of("Log.entryAdded", "Runtime.consoleAPICalled", "Runtime.exceptionThrown")
    pdf = printed(talk) if print_it else b""
    talk.session = None
    talk.ask("Target.closeTarget", **target)
    asked.remove(file.as_uri())
    said = [json.dumps(event["params"]) for event in console]
    return Seen(content.decode(), measured["result"]["value"], asked, said, pdf)


def printed(talk: Talk) -> bytes:
    sheet = talk.ask("Page.printToPDF", preferCSSPageSize=True, printBackground=True)
    return base64.b64decode(sheet["data"])


class NavigatedError(Exception):
    """The page that was asked went over to another before it could answer."""


@dataclass
class Talk:
    """Questions to the browser and its answers; what it tells unasked is kept as events."""

    to: int
    fro: int
    session: str | None = None
    events: list[Message] = field(default_factory=list)
    count: int = 0
    rest: bytes = b""

    def ask(self, method: str, **params: Any) -> Message:
        self.count += 1
        message: Message = {"id": self.count, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while (answer := self.heard()).get("id") != self.count:
            self.events.append(answer)
        if "navigated" in answer.get("error", {}).get("message", ""):
            raise NavigatedError(method)
        assert "result" in answer, (method, answer)
        return answer["result"]

    def heard(self) -> Message:
        parts = []
        while b"\0" not in self.rest:
            parts.append(self.rest)
            assert select.select([self.fro], [], [], SECONDS)[0], f"the browser is silent for {SECONDS} s"
            self.rest = os.read(self.fro, 1 << 20)
            assert self.rest, "the browser has gone"
        end, _, self.rest = self.rest.partition(b"\0")
        return json.loads(b"".join([*parts, end]))

    def wait_for(self, method: str) -> None:
        while not self.of(method):
            self.events.append(self.heard())

    def of(self, *methods: str) -> list[Message]:
        return [event for event in self.events if event["method"] in methods]


@contextmanager
def browser(folder: Path, fonts: Path = FONTS) -> Iterator[Talk]:
    """The browser, reading from its descriptor 3 and writing to 4. `fonts`: where it finds those that no page
    carries; a machine may have none."""
    path = program("chromium", "chromium-browser", "google-chrome")
    if not hasattr(os, "posix_spawn"):
        pytest.skip("the pipes to the browser are those of POSIX")
    (reads, to), (fro, writes) = os.pipe(), os.pipe()
    command = [path, *OPTIONS, f"--user-data-dir={folder / 'profile'}", "about:blank"]
    found = folder / "fonts.conf"
    found.write_text(f"<fontconfig><dir>{fonts}</dir><cachedir>{folder / 'cache'}</cachedir></fontconfig>")
    ends = [(os.POSIX_SPAWN_DUP2, reads, 3), (os.POSIX_SPAWN_DUP2, writes, 4)]
    silent = (os.POSIX_SPAWN_OPEN, 2, os.devnull, os.O_WRONLY, 0)
    process = os.posix_spawn(
        path, command, os.environ | {"FONTCONFIG_FILE": str(found)}, file_actions=[*ends, silent], setsid=True
    )
    os.close(reads)
    os.close(writes)
    try:
        yield (talk := Talk(to, fro))
        talk.ask("Browser.close")
    except BaseException:
        os.killpg(process, signal.SIGKILL)
        raise
    finally:
        os.waitpid(process, 0)
        os.close(to)
        os.close(fro)
