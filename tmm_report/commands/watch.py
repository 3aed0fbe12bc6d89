"""`tmm-report solve --watch`: solves again whenever the variant is saved, and keeps an open page up to date.

The page is a file beside the note, `live.html`: the note, or the mistakes in its place. A script in it asks another
file, `live.js`, which round was written last, and loads the page anew where it stood. No server, so that nobody else
can reach it; both files go when the watch ends.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from tmm_report.commands import solve
from tmm_report.commands.files import write
from tmm_report.commands.talk import Talk, unwritable
from tmm_report.languages import DEFAULT
from tmm_report.loading import stated
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.resources import allowed, data_root
from tmm_report.variant.department import NAMES, TEMPLATES

PAGE, ROUND = "live.html", "live.js"
PAUSE = 0.1  # s, between two looks at the file
SETTLED = 0.05  # s, in which a file that is being written does not change any more
FORMATS = "html"  # that of the page alone, unless others are asked for
_POLICY = re.compile(rb'(<meta http-equiv="Content-Security-Policy" content=")([^"]*)(")')

Stamp = tuple[tuple[int, int] | None, ...]


def run(
    variant: Path,
    folder: Path | None,
    formats: str,
    language: str | None,
    talk: Talk,
    *,
    depth: str | None = None,
    combinations_too: bool = False,
    pdf: str | None = None,
    print_it: bool = False,
    open_note: bool = False,
) -> bool:
    """Solve until Ctrl-C. What else is asked for is made after the page is shown, at each round. Raises ProblemError
    for what no saving can mend: options, a file that is not there."""
    solve.chosen(formats), solve.depth_of(depth), stated(variant)
    solve.see_known(pdf)
    folder = folder or solve.usual_folder(variant)
    live = Live(folder)
    seen: Stamp | None = None
    hasty = _Hasty(talk, lambda: _stamps(variant) != seen)

    def solved() -> None:
        solve.run(
            variant,
            folder,
            formats,
            language,
            hasty,
            depth=depth,
            combinations_too=combinations_too,
            pdf=pdf,
            print_it=print_it,
            shown=live.show,
        )

    try:
        while True:
            now = _settled(variant)
            if now[0] is None or now == seen:  # gone while an editor puts the new one in its place
                time.sleep(PAUSE)
                continue
            seen = now
            if not _round(solved, live, language, talk):
                seen = None
            if open_note and live.number:
                solve.opened(folder / PAGE)
                open_note = False
    except KeyboardInterrupt:
        talk.tell(Message(N_("no longer watching %(file)s"), {"file": variant}))
        return True
    finally:
        for name in (PAGE, ROUND):
            with suppress(OSError):
                (folder / name).unlink()


def _settled(variant: Path) -> Stamp:
    """When the variant, and what its department states, was written, once they are written whole."""
    while True:
        before = _stamps(variant)
        time.sleep(SETTLED)
        if _stamps(variant) == before:
            return before


def _stamps(variant: Path) -> Stamp:
    return tuple(map(_stamp, [variant, *(variant.parent / name for name in (*NAMES, *TEMPLATES))]))


def _stamp(file: Path) -> tuple[int, int] | None:
    try:
        found = file.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


class Live:
    """The page in its folder, and the number of the page that stands there."""

    def __init__(self, folder: Path):
        self.folder, self.number = folder, 0

    def show(self, page: bytes) -> None:
        """Raises ProblemError where it cannot be written."""
        self.number += 1
        files = {PAGE: live(page, self.number), ROUND: f"tmmReportRound({self.number});\n".encode()}
        try:
            write(self.folder, files)
        except OSError as error:
            raise unwritable(self.folder, error) from None


class _Saved(Exception):
    """The variant was saved while a round of it was going on: what is left of the round is of old numbers."""


class _Hasty:
    """The talk of a round that goes no further once the variant has changed."""

    def __init__(self, talk: Talk, changed: Callable[[], bool]):
        self.speak, self.tell, self.warn = talk.speak, talk.tell, talk.warn
        self.talk, self.changed = talk, changed

    def stage(self, doing: Message) -> None:
        if self.changed():
            raise _Saved
        self.talk.stage(doing)


def _round(solved: Callable[[], None], live: Live, language: str | None, talk: Talk) -> bool:
    """Solve once, which shows the page: the note, or the mistakes in its place. Whether it came to its end."""
    began = time.perf_counter()
    try:
        solved()
    except _Saved:
        return False
    except ProblemError as error:
        said = language or error.language or DEFAULT
        talk.speak(said)
        for problem in error.problems:
            talk.warn(problem)
        live.show(mistakes(error, said))
    text = N_("%(seconds)s s; %(page)s is up to date; waiting for the file to be saved, Ctrl-C ends")
    talk.tell(Message(text, {"seconds": f"{time.perf_counter() - began:.2f}", "page": live.folder / PAGE}))
    return True


def mistakes(error: ProblemError, language: str) -> bytes:
    """A page with the mistakes in place of the note."""
    from tmm_report.i18n import Translator
    from tmm_report.report.formats import Html
    from tmm_report.report.numbering import Numbering
    from tmm_report.report.page import Page, template

    form = Page(Html(), Translator(language), Numbering())
    lines = [problem.text(form.tr.gettext) for problem in error.problems]
    return template("mistakes.html.j2").render({"page": form, "t": form.t}, lines=lines).encode()


def live(page: bytes, number: int) -> bytes:
    """The page with its round and with the script that looks for the next one; the page's own policy allows it, by its
    hash, and files beside it, from which the script learns the round."""
    script = (data_root() / "templates" / "live.js").read_bytes()
    source = f"{allowed(script)} file:".encode()

    def with_script(policy: re.Match[bytes]) -> bytes:
        rules = [rule.strip() for rule in policy[2].split(b";")]
        others = [rule for rule in rules if rule and not rule.startswith(b"script-src ")]
        own = next((rule for rule in rules if rule.startswith(b"script-src ")), b"script-src")
        meta = b'<meta name="tmm-report-round" content="%d">' % number
        return b"".join((policy[1], b"; ".join([*others, own + b" " + source]), policy[3], b">\n", meta[:-1]))

    page = _POLICY.sub(with_script, page, count=1)
    head, end, rest = page.rpartition(b"</body>")
    return b"".join((head, b"<script>", script, b"</script>\n", end, rest))
