"""The published worked examples of machines in motion, and how a found number is held against them.

An output counts as right where it is the recomputed one to its digits; where the source did not err, it must round to
(or be cut to) the digits that are printed.
"""

from __future__ import annotations

from decimal import ROUND_DOWN, ROUND_HALF_UP, Decimal
from functools import cache
from pathlib import Path
from typing import Any

import yaml

FILE = Path(__file__).with_name("motion_cases.yaml")
DIGITS = 6e-7  # of a number that is given with seven figures


@cache
def every() -> dict[str, dict[str, Any]]:
    return {one["id"]: one for one in yaml.load(FILE.read_text("utf-8"), yaml.CSafeLoader)}


def case(name: str) -> dict[str, Any]:
    """Inputs of an example, `printed`, `recomputed`, `status` by output."""
    return every()[name]


def agrees(name: str, **found: float) -> None:
    """Raises AssertionError with every output that is not the published one."""
    of = case(name)
    assert found, "nothing is compared"
    wrong = [line for key, value in found.items() for line in _wrong(of, key, float(value))]
    assert not wrong, f"{name}: " + "; ".join(wrong)


def _wrong(of: dict[str, Any], key: str, value: float) -> list[str]:
    known = of["recomputed"]
    assert key in known or key in of["printed"], f"{key} is no output of the example: {sorted(known)}"
    lines = []
    if key in known and not abs(value - known[key]) <= DIGITS * abs(known[key]) + 1e-12:
        lines.append(f"{key} = {value:.8g}, recomputed {known[key]:.8g}")
    status = of.get("status", {}).get(key)
    if status in ("exact", "truncated") and not _prints_as(value, of["printed"][key], status):
        lines.append(f"{key} = {value:.8g}, printed {of['printed'][key]}")
    return lines


def _prints_as(value: float, printed: str, status: str) -> bool:
    """Whether the value has the printed digits, rounded, or cut where the source cuts."""
    unit = Decimal(printed).normalize() if "e" in printed.lower() else Decimal(printed)
    step = Decimal(1).scaleb(Decimal(printed).as_tuple().exponent)  # type: ignore[arg-type]
    exact = Decimal(repr(value))
    roundings = [ROUND_HALF_UP] if status == "exact" else [ROUND_DOWN, ROUND_HALF_UP]
    # a value within the digits of its own recomputation of a half may go either way
    near = [exact, exact * (1 + Decimal(DIGITS)), exact * (1 - Decimal(DIGITS))]
    return any(one.quantize(step, how) == unit.quantize(step) for one in near for how in roundings)
