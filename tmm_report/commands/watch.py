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
    open_note: bool = False,
) -> bool:
    """Solve until Ctrl-C. Raises ProblemError for what no saving can mend: options, a file that is not there."""
    solve.chosen(formats), solve.depth_of(depth), stated(variant)
    folder = folder or solve.usual_folder(variant)
    names = formats if "html" in formats else f"{formats},html"

    def solved() -> None:
        solve.run(variant, folder, names, language, talk, depth=depth)

    seen, number = None, 0
    try:
        while True:
            now = _settled(variant)
            if now[0] is None or now == seen:  # gone while an editor puts the new one in its place
                time.sleep(PAUSE)
                continue
            seen, number = now, number + 1
            _round(solved, folder, number, language, talk)
            if open_note and number == 1:
                solve.opened(folder / PAGE)
    except KeyboardInterrupt:
        talk.tell(Message(N_("no longer watching %(file)s"), {"file": variant}))
        return True
    finally:
        for name in (PAGE, ROUND):
            with suppress(OSError):
                (folder / name).unlink()


def _settled(variant: Path) -> Stamp:
    """When the variant, and what its department states, was written, once they are written whole."""
    files = [variant, *(variant.parent / name for name in (*NAMES, *TEMPLATES))]
    while True:
        before = tuple(map(_stamp, files))
        time.sleep(SETTLED)
        if tuple(map(_stamp, files)) == before:
            return before


def _stamp(file: Path) -> tuple[int, int] | None:
    try:
        found = file.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def _round(solved: Callable[[], None], folder: Path, number: int, language: str | None, talk: Talk) -> None:
    """Solve once and write the page: the note, or the mistakes."""
    began = time.perf_counter()
    try:
        solved()
        page = (folder / "note.html").read_bytes()
    except ProblemError as error:
        said = language or error.language or DEFAULT
        talk.speak(said)
        for problem in error.problems:
            talk.warn(problem)
        page = mistakes(error, said)
    try:
        write(folder, {PAGE: live(page, number), ROUND: f"tmmReportRound({number});\n".encode()})
    except OSError as error:
        raise unwritable(folder, error) from None
    text = N_("%(seconds)s s; %(page)s is up to date; waiting for the file to be saved, Ctrl-C ends")
    talk.tell(Message(text, {"seconds": f"{time.perf_counter() - began:.2f}", "page": folder / PAGE}))


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
