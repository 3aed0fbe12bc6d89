"""Rows of measurement as tables of a page, and as the flat figures that are stored."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from benchmarks.peers.gears.scene import KINDS as GEAR_KINDS
from benchmarks.peers.judge import Row
from benchmarks.peers.scene import KINDS


def error(value: float | None) -> str:
    """An error to its order; what is not offered says so."""
    if value is None:
        return "not offered"
    if math.isnan(value):
        return "no value"
    return "0" if value == 0 else f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e+")


def ratio(value: float) -> str:
    """Two digits: more are noise."""
    if math.isnan(value):
        return ""
    return f"{value:.1f}" if value < 10 else f"{float(f'{value:.2g}'):.0f}"


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows)])


def levers(rows: Iterable[Row]) -> str:
    head = ("program", "setting", *KINDS, "time : ours")
    return markdown(head, (_lever(row) for row in rows))


def _lever(row: Row) -> tuple[str, ...]:
    if row.refused:
        return (row.peer, row.setting, f"refused: {row.refused}", *[""] * len(KINDS))
    return (row.peer, row.setting, *(error(row.errors[kind]) for kind in KINDS), ratio(row.ratio))


def gears(measured: Mapping[str, Mapping[str, Mapping[str, Any]]]) -> str:
    head = ("pair", "program", *GEAR_KINDS, "time : ours")
    rows = []
    for pair, found in measured.items():
        for name, row in found.items():
            if "missing" in row:
                rows.append((pair, name, f"not offered: {row['missing']}", *[""] * len(GEAR_KINDS)))
            else:
                judged = (error(row["errors"][kind]) for kind in GEAR_KINDS)
                rows.append((pair, name, *judged, ratio(row["ratio"])))
    return markdown(head, rows)


def cold(ratios: Mapping[str, float]) -> str:
    return markdown(("program", "cold start : ours"), ((key, ratio(value)) for key, value in ratios.items()))


def figures(
    rows: Iterable[Row], ratios: Mapping[str, float], gear: Mapping[str, Mapping[str, Mapping[str, Any]]]
) -> dict[str, float]:
    """Errors and ratios by name; what is not offered is left out."""
    found: dict[str, float] = {}
    for row in rows:
        found |= {f"{row.name}: {kind}": off for kind, off in row.errors.items() if off is not None}
        if not math.isnan(row.ratio):
            found[f"{row.name}: time to ours"] = row.ratio
    found |= {f"{key}: cold start to ours": value for key, value in ratios.items()}
    for pair, peers in gear.items():
        for name, judged in peers.items():
            offs = judged.get("errors", {})
            found |= {f"{pair}, {name}: {kind}": off for kind, off in offs.items() if off is not None}
            if "ratio" in judged:
                found[f"{pair}, {name}: time to ours"] = judged["ratio"]
    return found
