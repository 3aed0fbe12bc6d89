"""The note on the screen, by Chromium's own trace: sizes, when it answers, frames while the mechanism plays.

    python -m benchmarks.living [NAME ...]        # ready variants; prints the table of docs/living.md

`answers`: CPU seconds of the page's process until it does. A frame is a DrawFrame of the compositor. `busy`: what the
main thread has to do for one, ms of CPU: 60 a second leave it 16.7. The page is measured as it begins, and with the
figures that follow in sight and all vectors shown.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests" / "living")]

from test_living_page import opened, run  # noqa: E402

from tmm_report import load, render, solve  # noqa: E402

SECONDS = 4
CATEGORIES = "devtools.timeline,disabled-by-default-devtools.timeline.frame,toplevel"
IN_SIGHT = """
(() => {
  for (const box of document.querySelectorAll('.choices input')) if (!box.checked) box.click();
  document.querySelector('.readings').open = true;
  document.getElementById(Object.keys(known.loads ?? known.moves ?? {})[0])?.scrollIntoView();
})()
"""


def main(names: list[str]) -> None:
    print(
        "| variant | file, kB | script, kB | data, kB | answers, s | frames a second | busy, ms | all in sight |"
    )
    print("|---|---|---|---|---|---|---|---|")
    for name in names:
        page = render(solve(load(ROOT / "variants" / f"{name}.yaml")), "html")["note.html"].decode()
        data, script = (len(one.encode()) / 1e3 for one in re.findall(r"<script.*?</script>", page, re.S))
        with opened(page) as talk:
            answers = answered(talk)
            still = played(talk)
            run(talk, IN_SIGHT)
            full = played(talk)
        row = (name, f"{len(page.encode()) / 1e3:.0f}", f"{script:.0f}", f"{data:.0f}", f"{answers:.2f}")
        both = f"{still[0]:.1f} | {still[1]:.1f}", f"{full[0]:.1f}, {full[1]:.1f} ms"
        print("| " + " | ".join((*row, *both)) + " |")


def answered(talk: Any) -> float:
    """CPU seconds of the process of a page until it answers: the clock tells of the other processes, too."""
    run(talk, "0")
    talk.ask("Performance.enable")
    metrics = {one["name"]: one["value"] for one in talk.ask("Performance.getMetrics")["metrics"]}
    return float(metrics["ProcessTime"])


def played(talk: Any) -> tuple[float, float]:
    """Frames a second, and ms of the main thread for one, while the mechanism plays."""
    run(talk, "play(); new Promise(done => setTimeout(done, 300))")
    talk.events.clear()
    talk.ask(
        "Tracing.start",
        traceConfig={"includedCategories": CATEGORIES.split(",")},
        transferMode="ReportEvents",
    )
    run(talk, f"new Promise(done => setTimeout(done, {SECONDS * 1000}))")
    talk.ask("Tracing.end")
    talk.wait_for("Tracing.tracingComplete")
    run(talk, "stop()")
    events = [one for part in talk.of("Tracing.dataCollected") for one in part["params"]["value"]]
    drawn = sorted(one["ts"] for one in events if one["name"] == "DrawFrame")
    main_thread = {one["tid"] for one in events if one["name"] == "FireAnimationFrame"}
    tasks = [
        e["tdur"] for e in events if e["name"].endswith("RunTask") and e["tid"] in main_thread and "tdur" in e
    ]
    span = (drawn[-1] - drawn[0]) / 1e6
    return (len(drawn) - 1) / span, sum(tasks) / 1e3 / len(drawn)


if __name__ == "__main__":
    main(sys.argv[1:] or ["compressor", "hay_press", "hoist_drive", "valve_cam", "punch_press"])
