"""What a run found: a file for each kind of finding, and the table of the whole."""

from __future__ import annotations

import re
import time
from collections import Counter
from pathlib import Path

from benchmarks.fuzz.judge import Outcome

EACH = 3  # texts kept of one finding
REASONS = 40  # of refusals told


class Report:
    def __init__(self, folder: Path, name: str):
        folder.mkdir(parents=True, exist_ok=True)
        self.folder, self.name, self.began = folder, name, time.monotonic()
        self.kinds: Counter[str] = Counter()
        self.findings: Counter[str] = Counter()
        self.words: Counter[str] = Counter()
        self.reasons: Counter[str] = Counter()
        self.seconds: list[float] = []
        self.megabytes: list[float] = []
        self.rendered = self.failed = 0

    def add(self, k: int, outcome: Outcome, text: str, how: str) -> None:
        wrong = outcome.finding
        self.kinds[outcome.kind if outcome.kind in ("solved", "refused") else "finding"] += 1
        self.rendered += outcome.rendered
        self.failed += not outcome.sound
        self.seconds.append(outcome.seconds)
        self.megabytes.append(outcome.megabytes)
        self.words.update(outcome.words)
        if outcome.kind == "refused":
            self.reasons[outcome.told] += 1
        self._told(k, outcome, text)
        if wrong:
            self.findings[wrong] += 1
            if self.findings[wrong] <= EACH:
                self._kept(k, wrong, outcome, text, how)
        if len(self.seconds) % 100 == 0:
            self.close()

    def _kept(self, k: int, wrong: str, outcome: Outcome, text: str, how: str) -> None:
        file = self.folder / (re.sub(r"[^\w.]+", "_", wrong)[:80] + f"_{k}")
        file.with_name(file.name + ".yaml").write_bytes(text.encode("utf-8", "surrogatepass"))
        said = f"case {k}: {how}\n{outcome.seconds:.1f} s, {outcome.megabytes:.0f} MB\n{outcome.told}"
        file.with_name(file.name + ".txt").write_text(said, encoding="utf-8", errors="replace")

    def _told(self, k: int, outcome: Outcome, text: str) -> None:
        """The first case of each thing that a page or a message says amiss."""
        for words in outcome.words:
            if self.words[words] == 1:
                file = self.folder / (re.sub(r"[^\w.]+", "_", words)[:60] + f"_{k}.yaml")
                file.write_bytes(text.encode("utf-8", "surrogatepass"))

    def close(self) -> None:
        """The table so far."""
        (self.folder / f"table{self.name}.md").write_text(self.table(), encoding="utf-8")

    def table(self) -> str:
        seconds, megabytes, count = sorted(self.seconds), sorted(self.megabytes), max(1, len(self.seconds))
        rows = [
            ("cases", len(self.seconds)), ("solved", self.kinds["solved"]), ("of them rendered", self.rendered),
            ("of them with a check that failed, exit code 1", self.failed),
            ("refused in words, exit code 2", self.kinds["refused"]), ("findings", sum(self.findings.values())),
            ("CPU time, s: median, 99 %, most", _spread(seconds)),
            ("memory, MB: median, 99 %, most", _spread(megabytes)),
            ("s a case", f"{(time.monotonic() - self.began) / count:.3f}"),
        ]  # fmt: skip
        told = ["| | |", "|---|---|", *(f"| {name} | {value} |" for name, value in rows), ""]
        told += [f"- {number} × {wrong}" for wrong, number in self.findings.most_common()]
        told += [f"- {number} × {words}" for words, number in self.words.most_common()]
        told += ["", f"refused most often (of {len(self.reasons)} reasons):", ""]
        told += [f"- {number} × {reason}" for reason, number in self.reasons.most_common(REASONS)]
        return "\n".join(told) + "\n"


def _spread(values: list[float]) -> str:
    if not values:
        return "—"
    return ", ".join(
        f"{values[min(len(values) - 1, int(share * len(values)))]:.3g}" for share in (0.5, 0.99, 1.0)
    )
