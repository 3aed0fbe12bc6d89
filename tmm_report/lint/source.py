"""What the LaTeX of a note says: the same steps as the HTML, by the commands that only the templates write."""

from __future__ import annotations

import re
from typing import NamedTuple

from tmm_report.lint.page import Step, between


class Source(NamedTuple):
    """`lines`: of the anchors that stand there, and of the first references to others."""

    steps: list[Step]
    lines: dict[str, int]


_ANCHOR = r"[\w.-]+"
_STEPS = re.compile(
    rf"\\hyperlink\{{(?P<said>{_ANCHOR})\}}\{{[^{{}}]*\}}(?P<on>--|–)?"
    rf"|\\begin\{{Note(?:Figure|Drawing|InRow)\}}(?:\{{[\d.]+mm\}})?\{{(?P<figure>{_ANCHOR})\}}"
    rf"\{{(?P<caption>[^{{}}]{{1,40}}?)(?: (?:--|—|–)|\. )"
    rf"|\\hypertarget\{{(?P<table>table{_ANCHOR})\}}\{{\}}%\s*(?P<head>[^\n]*(?:\n\\NoteLongCaption[^\n]*)?)"
    rf"|\\NoteFormula\{{(?P<formula>{_ANCHOR})\}}\{{(?P<number>[^{{}}]*)\}}"
    rf"|\\Note(?:Section|Subsection|Subsubsection)\{{(?P<section>{_ANCHOR})\}}\{{(?P<which>[^{{}}]*)\}}"
)
_NAME = re.compile(r"\{([^{}]{1,40}?)(?: (?:---?|—|–)|\.) ")


def read(tex: str) -> Source:
    start = max(tex.find("\\begin{document}"), 0)
    found, last = Source([], {}), ("", 0)
    line, at = 1, 0
    for match in _STEPS.finditer(tex, start):
        line, at = line + tex.count("\n", at, match.start()), match.start()
        if target := match["said"]:
            inner, last = between(target, last, bool(match["on"]))
            found.lines.setdefault(target, line)
            found.steps.extend(Step(False, one) for one in (*inner, target))
            continue
        kind = next(name for name in ("figure", "table", "formula", "section") if match[name])
        found.lines[match[kind]] = line
        found.steps.append(Step(True, match[kind], _named(match, kind)))
    return found


def _named(match: re.Match[str], kind: str) -> str:
    if kind == "table":
        name = _NAME.search(match["head"])
        return name[1] if name else ""
    text = match[{"figure": "caption", "formula": "number", "section": "which"}[kind]]
    return f"({text})" if kind == "formula" else text
