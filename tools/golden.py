"""Rewrite the regression set: `python tools/golden.py [variant ...]` after a change that is meant to change numbers.

tests/golden/<variant>.json holds the key numbers of each ready variant, by rows. A file is rewritten only where a
row differs by more than the tolerance, and every such number is printed; files of variants that are gone are removed.
tests/golden/<variant>.<language>.txt holds the text of some notes, a line for each paragraph, row and formula, and
<variant>.numbers what their results.json calls its numbers; what changed in them is printed as a diff.
"""

from __future__ import annotations

import difflib
import json
import math
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from tmm_report import load, render, solve
from tmm_report.course import Results, Variant
from tmm_report.languages import FALLBACK, LANGUAGES
from tmm_report.results import tables, values

ROOT = Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "golden"
TOLERANCE = 1e-9  # of the largest number of a row
NOTHING = 1e-15  # SI: what is left where larger numbers cancel, another on every processor
ROUNDING = (
    "disagreement",
    "overlap",
    "clearance",
    "works_sum",
    "balance_error",
    "potential_error",
    "_residual",
    "cam_recovered",
)
INTEGRATED = re.compile(r"dynamics_\w+_(start|coast)")
ROUGH = (
    1e-7  # of those: steps are chosen by the last digits of exp and sin, which every processor has its own
)
DIGITS = 13  # written; the rest is rounding errors, which differ from machine to machine

Row = str | list[float | None]


def key_numbers(results: Results) -> dict[str, Row]:
    """Rows of key numbers: SI, degrees for angles of position 0; None for what does not exist."""
    structure = {"structure": results.lever.structure.formula} if results.lever else {}
    return {**structure, **_single(results), **_series(results)}


def _single(results: Results) -> dict[str, Row]:
    """Single numbers; the least and the greatest of a quantity make one row, so that they share their scale."""
    rows: dict[str, list[float | None]] = {}
    scales = _scales(results)
    for value in values(results):
        # how well the drawings and the checks agree is rounding: their limits are tested elsewhere
        if not value.key.startswith("delta") and not value.key.endswith(ROUNDING):
            key = value.key.removesuffix("_min").removesuffix("_max")
            rows.setdefault(key, []).append(_kept(value.value, scales.get(key, 0.0)))
    return dict(rows)


def _scales(results: Results) -> dict[str, float]:
    """What a motion with the output's stroke has for velocity and acceleration: beside it, rounding errors are 0."""
    if not results.lever:
        return {}
    omega = abs(results.lever.kinematics.omega)
    return {
        f"{letter}_{travel.output.name}": travel.stroke * omega**power
        for travel in results.lever.kinematics.travels
        for power, letter in enumerate("SVA")
    }


def _series(results: Results) -> dict[str, Row]:
    """The balancing moment and the efficiency at the table positions; the greatest reactions of the cycle."""
    columns = {table.name: {c.key: c.values for c in table.columns} for table in tables(results)}
    rows: dict[str, Row] = {}
    for table, key in (("balancing_table", "M_bal"), ("friction_table", "P_fr"), ("friction_table", "eta")):
        if table in columns:
            rows[f"{key} at the positions"] = [_kept(x) for x in columns[table][key]]
    for key, sizes in columns.get("reactions_diagram", {}).items():
        if key.startswith("R_") and key[-2:] not in ("_x", "_y"):
            rows[f"{key} at most"] = [_kept(float(np.nanmax(sizes)))]
    return rows


def _kept(x: float, scale: float = 0.0) -> float | None:
    """A number as it is written: rounded, rounding errors beside the scale made 0, None for nan."""
    if abs(x) <= TOLERANCE * scale:
        return 0.0
    return float(f"{x:.{DIGITS - 1}e}") + 0.0 if math.isfinite(x) else None


def differences(old: Mapping[str, Row], new: Mapping[str, Row]) -> list[str]:
    """Every row that came, went or changed its length, and every number that is off, in words."""
    found = [f"{key}: is no more, was {old[key]}" for key in old if key not in new]
    for key, row in new.items():
        was = old.get(key)
        if was is None:
            found.append(f"{key}: is new, {row}")
        elif isinstance(row, str) or isinstance(was, str) or len(row) != len(was):
            found += [f"{key}: is {row}, was {was}"] if row != was else []
        else:
            found += list(_wrong(key, was, row))
    return found


def _wrong(key: str, was: list[float | None], row: list[float | None]) -> Iterator[str]:
    scale = max((abs(x) for x in (*was, *row) if x is not None), default=0.0)
    for i, (old, new) in enumerate(zip(was, row, strict=True)):
        if old is None or new is None:
            if old is not new:
                yield f"{key}[{i}]: is {new}, was {old}"
        elif abs(new - old) > max((ROUGH if INTEGRATED.fullmatch(key) else TOLERANCE) * scale, NOTHING):
            yield f"{key}[{i}]: is {new!r}, was {old!r}: off by {abs(new - old) / scale:.1e} of the row's largest"


def read(name: str) -> dict[str, Row]:
    """The golden rows of a variant; none where it has no file."""
    file = GOLDEN / f"{name}.json"
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}


def write(name: str, rows: Mapping[str, Row]) -> None:
    """One row a line, so that a change shows in its own line."""
    lines = [f"{_json(key)}: {_json(row)}" for key, row in rows.items()]
    GOLDEN.mkdir(exist_ok=True)
    text = "{\n" + ",\n".join(lines) + "\n}\n"
    (GOLDEN / f"{name}.json").write_text(text, encoding="utf-8", newline="\n")


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def refresh(file: Path) -> list[str]:
    """Compare one variant with its golden file and rewrite that where they differ: what changed."""
    rows = key_numbers(solve(load(file)))
    old = read(file.stem)
    changed = differences(old, rows)
    if changed:
        write(file.stem, rows)
    return changed if old else [f"new: {len(rows)} rows"]


READ_IN_ALL = (  # together all chapters; a test counts them
    "compressor", "press", "hoist_drive", "eccentric", "cam_press", "tram_start", "machine_train", "engine_balance",
    "governor_porter", "governor_servo", "jack_and_belt", "locomotive_diesel", "forging_machine_wear", "grain_screen",
    "rotor", "slider_crank_offset", "shaper_synthesis", "function_generator", "press_flywheel", "governor_spring",
    "descent_brake", "steam_hammer", "knuckle_press", "piston_pump", "hacksaw", "valve_cam", "hoist_differential",
)  # fmt: skip
READ_IN_ITS_OWN = ("crank_rocker",)
CALLED_IN = FALLBACK  # one is enough: the notes hold the translations
APPROVED = [code for code, row in LANGUAGES.items() if row.messages]
"""The languages whose texts are approved: the others say the same by their catalogues, which are tested as such."""


def languages(variant: Variant) -> list[str]:
    """Those in which the text of the variant's note is approved."""
    name = Path(variant.file).stem
    if name in READ_IN_ALL:
        return APPROVED
    return [variant.language] if name in READ_IN_ITS_OWN else []


def refresh_text(file: Path) -> list[str]:
    """Compare the text of a variant's notes with the approved one and rewrite that: what changed."""
    sys.path[:0] = [str(ROOT / "tests" / "page")]
    from note import read as read_note  # the reader of the tests
    from note import steady

    told: list[str] = []
    results = solve(load(file))
    for language in languages(results.variant):
        page = render(results, "html", language, "full")["note.html"].decode()
        lines, target = read_note(page).words, GOLDEN / f"{file.stem}.{language}.txt"
        old = target.read_text("utf-8").splitlines() if target.is_file() else []
        changed = list(
            difflib.unified_diff(
                steady(old), steady(lines), f"{target.name}, approved", "now", lineterm="", n=0
            )
        )
        if changed or not target.is_file():
            target.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
        told += changed
    return told


def called(document: Mapping[str, Any]) -> list[str]:
    """What results.json calls its numbers: key, symbol, unit, meaning, each once, and what its tables are."""
    tables = document["tables"]
    columns = (one for table in tables.values() for one in table["columns"])
    numbers = [*document["values"], *columns]
    said = [
        " | ".join(str(one.get(part, "")) for part in ("key", "symbol", "unit", "meaning")) for one in numbers
    ]
    return list(dict.fromkeys([*said, *(f"{name}: {table['meaning']}" for name, table in tables.items())]))


def refresh_called(file: Path) -> list[str]:
    """Of the variants whose notes are read in all languages: what changed in the words of results.json."""
    target = GOLDEN / f"{file.stem}.numbers"
    if file.stem not in READ_IN_ALL:
        return []
    lines = called(json.loads(render(solve(load(file)), "json", CALLED_IN)["results.json"]))
    old = target.read_text("utf-8").splitlines() if target.is_file() else []
    target.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
    return list(difflib.unified_diff(old, lines, f"{target.name}, approved", "now", lineterm="", n=0))


def main(names: list[str]) -> int:
    files = sorted((ROOT / "variants").glob("*.yaml"))
    for file in files:
        if not names or file.stem in names:
            for line in [*refresh(file), *refresh_text(file), *refresh_called(file)]:
                print(f"{file.stem}: {line}")
    for stale in sorted(GOLDEN.glob("*.json")):
        if stale.stem not in {file.stem for file in files}:
            stale.unlink()
            print(f"{stale.stem}: removed, there is no such variant")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
