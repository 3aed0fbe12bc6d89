"""What the comparison of methods found, as JSON and as CSV."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Iterator
from typing import Any

from tmm_report.commands.methods.measured import All
from tmm_report.i18n import Translator


def rows(found: All) -> Iterator[dict[str, Any]]:
    for family in found.families:
        for k, one in enumerate(family.rows):
            yield {
                "family": family.key,
                "method": one.method.key,
                "count": one.count,
                "counts": list(family.counts(one)),
                "ms": _known(1e3 * one.seconds),
                "errors": {kind: _known(error) for kind, error in one.errors.items()},
                "front": k in family.front,
                "broken": one.broken,
            }


def _known(x: float) -> float | None:
    return x if math.isfinite(x) else None


def as_json(found: All, tr: Translator) -> dict[str, bytes]:
    """Every trial, what is refused and why, what is chosen."""
    counted = found.counted
    data = {
        "accuracy": found.accuracy,
        "auto": found.auto,
        "trials": list(rows(found)),
        "refused": {
            family.key: {method.key: why.render(tr.gettext) for method, why in family.refused}
            for family in found.families
        },
        "cheapest": {
            family.key: family.best.method.key if family.best else None for family in found.families
        },
        "positions": None
        if counted is None
        else {
            "accuracy": counted.accuracy,
            "counts": list(counted.counts),
            "errors": {key: list(row) for key, row in counted.errors.items()},
            "recommended": counted.recommended,
        },
    }
    return {"methods.json": (json.dumps(data, ensure_ascii=False, allow_nan=False, indent=1) + "\n").encode()}


def as_csv(found: All) -> dict[str, bytes]:
    """A row for each trial and kind of quantity."""
    out = io.StringIO()
    table = csv.writer(out, lineterminator="\n")
    table.writerow(("family", "method", "count", "ms", "quantity", "error", "front"))
    for row in rows(found):
        for kind, error in row["errors"].items() or {"": None}.items():
            table.writerow(
                (
                    row["family"],
                    row["method"],
                    row["count"],
                    row["ms"],
                    kind,
                    "" if error is None else error,
                    int(row["front"]),
                )
            )
    return {"methods.csv": out.getvalue().encode()}
