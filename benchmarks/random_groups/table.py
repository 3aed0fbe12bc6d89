"""The table of a run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from benchmarks.random_groups.judge import Verdict

KINDS = ("full turn", "no return", "gap", "no way back", "undecided")
HEAD = (
    "| family | drawn | full turn | no return | gap | no way back | undecided | links apart | off the branch | "
    "end of gap, rad | ms each |",
    "|---|---|---|---|---|---|---|---|---|---|---|",
)


def markdown(verdicts: Sequence[Verdict]) -> str:
    """Rows by family: of each kind how many are right of how many there are; then what is wrong, by name."""
    families = dict.fromkeys(v.family for v in verdicts)
    rows = [_row(name, [v for v in verdicts if v.family == name]) for name in families]
    wrong = Counter(name for v in verdicts for name in v.wrong)
    told = "\n".join(f"| {name} | {count} |" for name, count in wrong.most_common())
    return "\n".join([*HEAD, *rows, _row("all", verdicts), "", "| wrong | times |", "|---|---|", told])


def _row(name: str, verdicts: Sequence[Verdict]) -> str:
    cells = [name, str(len(verdicts))]
    for kind in KINDS:
        of = [v for v in verdicts if v.kind == kind]
        right = sum(not v.wrong for v in of)
        cells.append("–" if not of else f"{right} of {len(of)}" if kind != "undecided" else str(len(of)))
    for name in ("residual", "strays"):
        cells.append(f"{max(getattr(v, name) for v in verdicts):.0e}")
    cells.append(f"{max(v.end for v in verdicts):.0e}")
    cells.append(f"{1e3 * float(np.median([v.seconds for v in verdicts])):.0f}")
    return "| " + " | ".join(cells) + " |"
