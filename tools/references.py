"""Make the references of `tmm-report verify`: `python tools/references.py [variant ...]`.

tmm_report/verification/<variant>.json holds numbers of 40 digits of each ready variant, computed by another way than
the program's own: see mechanics/rivals/exact. Of the table positions those are kept that `kept` tells.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tmm_report import load, solve
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, rounding
from tmm_report.chapters.lever.kinetostatics.solve.acting_exact import acting
from tmm_report.course import LeverFound
from tmm_report.mechanics.lever.mechanism import ZeroAngle, ZeroExtreme
from tmm_report.mechanics.rivals import exact
from tmm_report.mechanics.rivals.exact import gears
from tmm_report.mechanics.rivals.exact.forces import forces
from tmm_report.mechanics.rivals.exact.numbers import DIGITS, Number, context, dot, point
from tmm_report.mechanics.rivals.exact.numbers import exact as number
from tmm_report.mechanics.rivals.exact.scheme import Body
from tmm_report.mechanics.rivals.exact.solving import solved
from tmm_report.resources import references_root

sys.path.insert(0, str(Path(__file__).resolve().parent))
from reference_values import judged_by, values

ROOT = Path(__file__).resolve().parent.parent
KEPT = 6  # positions of each variant
HEAVY = 0.5  # of the greatest balancing moment: as much is wanted among the positions kept
LIMIT = 1e-12
ANGLES = ("1e-9", "1e-5", "0.01", "0.1", "0.35", "0.5", "0.9", "1.3", "1.55", "1.5707")
INVOLUTES = ("1e-27", "1e-15", "1e-6", "0.001", "0.0149", "0.05", "0.3", "0.69", "0.71", "3.0", "1e3", "1e9")
NOTHING = 1e-12  # of the numbers of its kind: a row of smaller ones comes of rounded lengths, and is judged by the kind
Row = tuple[str, str, str, list[Any]]


def text_of(variant: Path) -> str:
    """The reference of a variant, a line for each row."""
    results = solve(load(variant))
    rows: list[Row] = []
    positions: list[int] = []
    limits: list[str] = []
    if results.lever is not None:
        positions = _with_load(results.lever, kept(results.lever.kinematics))
        limits = [f"{limit:.1e}" for limit in _limits(results.lever.kinematics)[positions]]
        rows = list(_rows(results.lever, positions))
    single = dict(values(results))
    singles = [
        [key, _text(value, context().mpf(0)), _short(abs(single.get(judged_by(key), value)))]
        for key, value in single.items()
    ]
    return _written({"positions": positions, "limits": limits}, {"rows": rows, "values": singles})


def text_of_involute() -> str:
    """The reference of the involute function and its inverse, from end to end."""
    found = [(f"inv({at})", gears.inv(float(at))) for at in ANGLES]
    found += [(f"arcinv({at})", gears.inverse(float(at))) for at in INVOLUTES]
    values = [[key, _text(value, context().mpf(0)), _short(abs(value))] for key, value in found]
    return _written({"positions": [], "limits": []}, {"rows": [], "values": values})


def kept(found: Kinematics) -> list[int]:
    """Table positions that are kept: spread over the cycle, and the one nearest to a singular position."""
    sines = [np.where(np.isfinite(sine), sine, 0.0) for sine in found.table.sines.values()]
    passed = [change for critical in found.cycle.critical for change in critical.changes]
    sines += [np.abs(np.sin((found.table.phi - change) / 2)) for change in passed]
    nearest = int(np.argmin(np.round(np.min(sines, axis=0), 6)))  # rounding must not choose between equals
    count = found.positions.table
    return sorted({nearest, *(k * count // KEPT + k % 2 for k in range(KEPT))})


def _with_load(lever: LeverFound, positions: list[int]) -> list[int]:
    """With the position of the greatest balancing moment, where all the others have less than half of it."""
    if lever.kinetostatics is None:
        return positions
    moments = np.abs(lever.kinetostatics.table.balancing)
    if moments[positions].max() >= HEAVY * moments.max():
        return positions
    return sorted({*positions, int(np.argmax(moments))})


def _limits(found: Kinematics) -> Any:
    """What rounding leaves at each position, but 1e-12 at least."""
    return np.maximum(rounding(found.table), LIMIT)


# ---------------------------------------------------------------- a lever mechanism


def _rows(lever: LeverFound, positions: Sequence[int]) -> Iterator[Row]:
    found, motion = lever.kinematics, lever.kinematics.table
    angles = _angles(found)
    yield "angle", "0", _short(2 * np.pi), [_text(angles[k], context().mpf(10) ** -DIGITS) for k in positions]
    solution = exact.motion(found.cycle, motion.phi)
    omega, size = abs(number(found.omega)), solution.scheme.size
    for power, (kind, of) in enumerate(
        (("place", Body.place), ("velocity", Body.velocity), ("acceleration", Body.acceleration))
    ):
        yield from _of_kind(
            kind, [(name, solution.row(name, of)) for name in solution.points], positions, size * omega**power
        )
    for power, kind, rate in ((1, "angular velocity", "w"), (2, "angular acceleration", "e")):
        rows = [
            (link, [None if pose is None else getattr(pose[link], rate) for pose in solution.poses])
            for link in solution.links
        ]
        yield from _of_kind(kind, rows, positions, omega**power)
    if lever.kinetostatics is None:
        return
    loads = acting(lever.kinetostatics.given, found, motion, solution, found.turned)
    balances = forces(solution, loads).balances
    for part, kind in enumerate(("reaction", "couple")):
        rows = [
            (pair.key, [None if b is None else b.reactions[pair.key][part] for b in balances])
            for pair in found.linkage.structure.pairs
            if part == 0 or pair.kind == "P"
        ]
        yield from _of_kind(kind, rows, positions, 0)
    yield from _of_kind("moment", [("M", [None if b is None else b.moment for b in balances])], positions, 0)


def _of_kind(
    kind: str, rows: Sequence[tuple[str, list[Number | None]]], positions: Sequence[int], usual: Number
) -> Iterator[Row]:
    """Rows of one kind, whose numbers are usually of such a size; what is nothing but rounding beside it is 0."""
    sizes = {name: max((abs(x) for x in row if x is not None), default=0) for name, row in rows}
    scale = max([usual, *sizes.values()])
    least = scale * context().mpf(10) ** -DIGITS
    for name, row in rows:
        largest = sizes[name] if sizes[name] > NOTHING * scale else scale
        yield (
            kind,
            name,
            _short(largest),
            [None if row[k] is None else _text(row[k], least) for k in positions],
        )


def _angles(found: Kinematics) -> list[Number]:
    """Exact angles of the driving link at the table positions, rad."""
    cycle, count = found.cycle, found.positions.table
    zero = _zero(found)
    with context().workdps(60):
        step = 2 * context().pi / count if cycle.closed else number(cycle.sweep) / count
        numbers = (k * cycle.turns % count if cycle.closed else k for k in range(count + 1))
        return [zero + cycle.sense * k * step for k in numbers]


def _zero(found: Kinematics) -> Number:
    """The exact angle of position 0: that stated, or where the point or link that it is an extreme of stands still."""
    cycle, driver = found.cycle, found.linkage.mechanism.driver
    match driver.zero:
        case ZeroAngle(angle):
            return number(angle)
        case ZeroExtreme() as stated:
            solution = exact.at(cycle, float(cycle.zero))
            phi, pose = number(float(cycle.zero)), solution.poses[0]
            assert pose is not None
            for _ in range(4):
                rate, second = _stands(solution, pose, stated)
                phi = phi - rate / second * number(driver.omega)
                start = {link: (body.r, body.u) for link, body in pose.items()}
                pose = solved(solution.scheme, phi, start)
                assert pose is not None
            return phi


def _stands(solution: exact.Exact, pose: Any, stated: ZeroExtreme) -> tuple[Number, Number]:
    """Rate of the coordinate that is extreme at position 0, and its derivative by time."""
    if stated.point is None:
        return pose[stated.link].w, pose[stated.link].e
    link = solution.linkage.arms[stated.point][0]
    at, along = point(solution.linkage.mechanism.links[link].points[stated.point]), point(stated.direction)
    return dot(pose[link].velocity(at), along), dot(pose[link].acceleration(at), along)


# ---------------------------------------------------------------- texts


def _text(value: Number, least: Number) -> Any:
    """A number, or a vector's components, to 40 digits."""
    if hasattr(value, "imag") and hasattr(value, "_mpc_"):
        return [_text(value.real, least), _text(value.imag, least)]
    return "0" if abs(value) <= least else context().nstr(value, DIGITS)


def _short(value: Any) -> str:
    return f"{float(value):.6e}" if value else "0"


def _written(head: dict[str, Any], lists: dict[str, Sequence[Any]]) -> str:
    members = [f'"{key}": {json.dumps(value)}' for key, value in head.items()]
    for key, items in lists.items():
        lines = ",\n".join(json.dumps(item, ensure_ascii=False, separators=(",", ":")) for item in items)
        members.append(f'"{key}": [\n{lines}\n]' if items else f'"{key}": []')
    return "{\n" + ",\n".join(members) + "\n}\n"


def main(names: Sequence[str]) -> None:
    with np.errstate(all="ignore"):
        for variant in sorted((ROOT / "variants").glob("*.yaml")):
            if not names or variant.stem in names:
                (references_root() / f"{variant.stem}.json").write_text(
                    text_of(variant), "utf-8", newline="\n"
                )
                print(variant.stem)
    if not names:
        (references_root() / "involute.json").write_text(text_of_involute(), "utf-8", newline="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
