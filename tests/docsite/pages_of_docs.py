"""The pages of the documentation as tests read them: their fenced blocks, their command lines."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGES = {
    page.relative_to(ROOT).as_posix(): page.read_text("utf-8")
    for page in (
        *(
            ROOT / name
            for name in ("README.md", "CONTRIBUTING.md", "tmm_report/README.md", "benchmarks/README.md")
        ),
        *sorted((ROOT / "docs").rglob("*.md")),
    )
}
_FENCE = re.compile(r"^(?P<indent> *)```(?P<kind>\w*)\n(?P<text>.*?)^(?P=indent)```$", re.M | re.S)
_COMMAND = re.compile(r"^(?: {4}| *)(?:\$ )?(?:\.venv/bin/)?tmm-report (?P<rest>\S.*)$", re.M)


def blocks(page: str, *kinds: str) -> Iterator[str]:
    """The texts of a page's fenced blocks of some kinds, in their order."""
    yield from (found["text"] for found in _FENCE.finditer(PAGES[page]) if found["kind"] in kinds)


def commands(page: str) -> list[list[str]]:
    """The arguments of every command line of tmm-report on a line of its own, without what a comment says."""
    return [shlex.split(found["rest"], comments=True) for found in _COMMAND.finditer(PAGES[page])]
