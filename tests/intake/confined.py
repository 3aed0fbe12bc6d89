"""Attacks are run in a process of their own, with its memory and its time limited."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

BEFORE = """
import sys
from tmm_report.intake import archive, cells, delimited, sheets, sources, writing
from tmm_report.problems import ProblemError

def limit(name, value):
    try:
        import resource
    except ImportError:  # Windows
        return
    resource.setrlimit(getattr(resource, name), (value, value))

def own():
    import resource
    with open("/proc/self/statm") as stream:
        return int(stream.read().split()[0]) * resource.getpagesize()

if sys.platform == "linux":
    limit("RLIMIT_AS", own() + {memory})
    limit("RLIMIT_CPU", {seconds} + 10)  # the imports have taken some
"""
MEMORY = 200 * 2**20


def confined(program: str, *args: str | Path, memory: int = MEMORY, seconds: int = 5) -> str:
    """What a program prints within so many bytes and CPU seconds; `sources`, `sheets` and the like are imported."""
    code = BEFORE.format(memory=memory, seconds=seconds) + program
    done = subprocess.run(
        [sys.executable, "-X", "utf8", "-c", code, *map(str, args)],
        capture_output=True,
        encoding="utf-8",
        timeout=300,
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stderr[-2000:]
    return done.stdout
