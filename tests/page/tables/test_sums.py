"""Columns that are sums, products and quotients of others are so as they are printed; lever mechanisms."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Cell, Note, Table, symbol_text
from pages import (
    BALANCING,
    Series,
    by_law,
    by_positions,
    columns,
    driving_speed,
    last_number,
    table_of,
    turned_link,
    value_of,
)
from printed import Printed
from reading import LEVERS, LINKAGES, html, results, wrong
from statics import Scheme, scheme

Rows = dict[str, np.ndarray]
TOTAL = ("Sum", "Сумма")
SEGMENTS = ("Segment, mm", "Отрезок, мм")


def sized(cell: Cell) -> Printed:
    """The number of a cell that must be one."""
    assert cell.printed is not None, cell.text
    return cell.printed


def balancing(note: Note) -> list[Series]:
    found = columns(note)
    return [column for symbol in BALANCING for _, column in found.get(symbol, [])]


# --- powers and the balancing moment ---


def wrong_powers(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """The last row is the sum of the others; the balancing moment gives what the loads take."""
    tables = [t for t in note.tables if t.rows and t.rows[-1][0].text in TOTAL and len(t.heads) == 2]
    if not tables:
        yield "no table of powers"
    for table in tables:
        *parts, total = [sized(row[1]) for row in table.rows]
        off = total.half + sum(part.half for part in parts)
        if abs(total.value - sum(part.value for part in parts)) > off:
            yield f"{table.caption}: the sum is {sum(part.value for part in parts):.6g}, not {total.value}"
        k = last_number(table.caption)
        omega = driving_speed(document, k)
        for moment in balancing(note):
            power, error = moment.values[k] * omega, moment.half[k] * abs(omega) + total.half
            if abs(power + total.value) > error:
                yield f"{table.caption}: the balancing moment gives {power:.6g} W to {total.value} W"


def wrong_parts(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """The power of each load is that of its force on its point or of its couple on its link."""
    loads, rates = table_of(document, "loads_table"), table_of(document, "rates_table")
    drawn = scheme(document["name"])
    for table in note.tables:
        if not (table.rows and table.rows[-1][0].text in TOTAL and len(table.heads) == 2):
            continue
        k = last_number(table.caption)
        for row in table.rows[:-1]:
            printed, power = sized(row[1]), 0.0
            for symbol in _symbols(row[0]):
                power += _power(symbol, loads, rates, drawn, k)
            if abs(power - printed.value) > printed.result_off + 1e-9:
                yield f"{table.caption}: {row[0].text} gives {power:.6g} W, not {printed.value}"


def _power(symbol: str, loads: Rows, rates: Rows, drawn: Scheme, k: int) -> float:
    kind, _, of = symbol.partition("_")
    if kind == "M":
        couple = loads[symbol] if symbol in loads else loads[f"{symbol},1"]
        return float(couple[k] * rates[f"w_{turned_link(of.removeprefix('I'))}"][k])
    tied = kind == "F" and "," in of  # of a spring or damper, on its point
    point = (
        of.split(",")[1 if tied else 0] if kind == "P" or tied else drawn.mass_centres[of.removeprefix("I")]
    )
    moving = f"v_{point}_x" in rates
    return (
        sum(float(loads[f"{symbol}_{axis}"][k] * rates[f"v_{point}_{axis}"][k]) for axis in "xy")
        if moving
        else 0.0
    )


def wrong_balance(note: Note) -> Iterator[str]:
    """All methods print one moment."""
    first, *others = balancing(note)
    for other in others:
        for k in np.flatnonzero(np.abs(first.values - other.values) > first.half + other.half):
            yield f"balancing moments of position {k}: {first.values[k]} and {other.values[k]}"


# --- friction ---


def wrong_friction(note: Note, document: dict[str, Any]) -> Iterator[str]:
    found = columns(note)
    parts = [one for s, e in found.items() if re.fullmatch(r"P_(тр|fr).+", s) for _, one in e]
    total = next((e[0][1] for s, e in found.items() if s in ("P_тр", "P_fr")), None)
    drive = next((e[-1][1] for s, e in found.items() if re.fullmatch(r"P_\d+", s)), None)
    if total is None:
        return
    both = sum(part.values for part in parts)
    off = total.half + sum(part.half for part in parts)
    for k in np.flatnonzero(np.abs(both - total.values) > off):
        yield f"P_fr[{k}] is {total.values[k]}, its parts make {both[k]:.6g}"
    if drive is None:
        yield "no power of the driver"
        return
    moment, omega = balancing(note)[0], value_of(document, "omega")
    count = min(len(moment.values), len(drive.values))
    power = np.abs(moment.values[:count] * omega)  # of the driver or, where it brakes, of the loads
    for k in np.flatnonzero(
        np.abs(power - drive.values[:count]) > drive.half[:count] + moment.half[:count] * abs(omega)
    ):
        yield f"P_drive[{k}] is {drive.values[k]}, M omega is {power[k]:.6g}"
    yield from wrong_efficiency(found["η"][0][1], drive, total)


def wrong_rubbing(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """What a pivot loses: coefficient, reaction, half the diameter, relative angular velocity."""
    table = next(
        (t for t in note.tables if len(t.heads) == 5 and t.heads[4].text.endswith((", m", ", м"))), None
    )
    reactions, rates = table_of(document, "reactions_table"), table_of(document, "rates_table")
    lost = table_of(document, "friction_table")
    for row in table.rows if table else ():
        one, other = row[0].text.split("–")
        if row[4].printed is None or not np.isfinite(row[4].printed.value):
            continue
        size = reactions.get(f"R_{one}{other}", reactions.get(f"R_{other}{one}"))
        turning = rates.get(f"w_{other}", 0.0) - (rates.get(f"w_{one}", 0.0) if one != "0" else 0.0)
        by_law = row[3].text == "f(v)"
        speed = sized(row[4]).value / 2 * np.abs(turning)
        coefficient = by_sliding(document, row[1].text, speed) if by_law else sized(row[3]).value
        power = coefficient * size * sized(row[4]).value / 2 * np.abs(turning)
        found = lost[f"P_fr_{one}-{other}"]
        for k in np.flatnonzero(np.abs(found - power) > 1e-4 * np.nanmax(power, initial=0.0) + 1e-9):
            yield f"P_fr_{one}-{other}[{k}] is {found[k]:.6g}, f R d/2 omega is {power[k]:.6g}"


def by_sliding(document: dict[str, Any], name: str, speed: np.ndarray) -> np.ndarray:
    """The coefficient of a pair that depends on its velocity of sliding, by the laws of the initial data."""
    for table in ("friction_points", "friction_stribeck"):
        texts = document["tables"].get(table, {"columns": [{"values": []}]})["columns"][0]["values"]
        rows = [k for k, names in enumerate(texts) if name in names.split(", ")]
        if rows:
            own = {key: values[rows] for key, values in table_of(document, table).items()}
            break
    if "v" in own:
        return np.interp(speed, own["v"], own["f"])
    fall = np.exp(-((speed / own["v_s"]) ** own["n"]))
    return own["f_k"] * (1 - fall) + own["f_s"] * fall + own["k_v"] * speed


def wrong_efficiency(eta: Series, drive: Series, total: Series) -> Iterator[str]:
    """What would be driven without losses to what is needed with them."""
    size = np.abs(drive.values)
    for k in np.flatnonzero(eta.known & (size > 0)):
        expected = size[k] / (size[k] + total.values[k])
        off = eta.half[k] + 2 * (drive.half[k] + total.half[k]) / size[k]
        if abs(eta.values[k] - expected) > off:
            yield f"eta[{k}] is {eta.values[k]}, of the powers {expected:.5g}"


@pytest.mark.parametrize("name", LINKAGES)
def test_powers_balance(name):
    note, document = html(name), results(name)
    found = [*wrong_powers(note, document), *wrong_parts(note, {**document, "name": name})]
    wheels = {"mesh_table", "rolling_table"} & {*document["tables"]}
    if not (by_law(document) or wheels):  # friction is found of a uniformly turning driving link alone
        found += [*wrong_friction(note, document), *wrong_rubbing(note, document)]
    wrong([*found, *wrong_balance(note)])


# --- plans ---


def scales(note: Note) -> dict[str, set[float]]:
    """The scales that the note states; diagrams and a drive have some of their own beside those of the plans."""
    found: dict[str, set[float]] = {}
    for formula in note.formulas:
        if formula.symbol.startswith("μ") and formula.result is not None:
            found.setdefault(formula.symbol, set()).add(formula.result.value)
    return found


def wrong_segments(note: Note) -> Iterator[str]:
    """A vector of a plan is its segment times the scale."""
    scale, seen = scales(note), 0
    for table in (one for one in note.tables if one.heads[1].text in SEGMENTS):
        for row in table.rows:
            symbol, segment, value = next(iter(_symbols(row[0])), ""), row[1], sized(row[2])
            if segment.text == "—":
                if symbol[0] in "va" and value.value:
                    yield f"{table.caption}: {symbol} has no segment"
                continue
            mu, mm = scale[f"μ_{symbol[0] if symbol[0] in 'va' else 'F'}"], sized(segment)
            seen += 1
            if all(abs(value.value - mm.value * x) > value.result_off + mm.half * x for x in mu):
                yield f"{table.caption}: {symbol} is {value.value} by {mm.value} mm and {mu}"
    if not seen:
        yield "no segments are printed"


def wrong_differences(note: Note) -> Iterator[str]:
    """Of two values beside each other, the difference in per cent of their mean."""
    for table in note.tables:
        measured = table.heads[1].text in SEGMENTS
        columns = (
            [(2, 3, 4), (5, 3, 6)] if measured else [(1, 2, 3)]
        )  # the other way, the exact one, the difference
        if not measured and (len(table.heads) != 4 or not _per_cent(table, 3)):
            continue
        for row in table.rows:
            for one in (one for one in columns if max(one) < len(row)):
                assert _per_cent(table, one[2])
                yield from _wrong_difference(table, row, one)


def _per_cent(table: Table, j: int) -> bool:
    return "%" in (table.heads[j].unit_text, table.heads[j].text[-1:])


def _wrong_difference(table: Table, row: list[Cell], at: tuple[int, int, int]) -> Iterator[str]:
    graph, analytic, delta = (row[j].printed for j in at)
    if graph is None or analytic is None or delta is None or not np.isfinite(delta.value):
        return
    if at[0] == 5 and graph.value * analytic.value < 0:  # read without its sense
        analytic = analytic._replace(value=abs(analytic.value))
    mean = 0.5 * (graph.value + analytic.value)
    expected = 100 * (graph.value - analytic.value) / mean if mean else 0.0
    off = 110 * (graph.result_off + analytic.result_off) / abs(mean) if mean else 0.0
    half = 0.5 * 10.0 ** -max(2, delta.places) if delta.value == 0 else delta.half
    plain = abs(abs(delta.value) - abs(expected)) if "drawing" in _way(table) else abs(delta.value - expected)
    if plain > half + off + 1e-9:
        yield f"{table.caption}: {row[0].text} differs by {expected:.4g} %, not {delta.value}"


def _way(table: Table) -> str:
    """Readings off a drawing print the size of their difference."""
    return "drawing" if re.search("drawing|чертеж", table.heads[1].text + table.caption) else "plan"


def wrong_arms(note: Note) -> Iterator[str]:
    """An arm is what is measured times the scale of lengths."""
    scale = scales(note).get("μ_l", set())
    for table in note.tables:
        units = [head.unit_text or head.text.rsplit(", ", 1)[-1] for head in table.heads]
        if units[2:] in (["mm", "m"], ["мм", "м"]):
            for row in table.rows:
                drawn, arm = sized(row[2]), sized(row[3])
                if all(abs(arm.value - drawn.value * mu) > arm.result_off + 0.005 * mu for mu in scale):
                    yield f"{table.caption}: {row[0].text} {arm.value} m, {drawn.value} mm by {scale}"


@pytest.mark.parametrize("name", LEVERS)
def test_plans_give_what_is_printed(name):
    note = html(name)
    wrong([*wrong_segments(note), *wrong_differences(note), *wrong_arms(note)])


# --- extremes ---


def wrong_extremes(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """No row of a table is beyond the printed extremes, and those are reached within the turn."""
    found, seen = columns(note), 0
    phi = table_of(document, "outputs_table")["phi"]
    step = abs(math.degrees(math.remainder(phi[1] - phi[0], 2 * math.pi)))
    for table in note.tables:
        if len(table.heads) != 5 or table.heads[2].text != table.heads[4].text or by_positions(table):
            continue
        for row in table.rows:
            symbol = next(iter(_symbols(row[0])), "")
            if symbol not in found or any(cell.printed is None for cell in row[1:]):
                continue
            seen += 1
            column = found[symbol][0][1]
            unit = 1.0 if column.unit != "°" else np.pi / 180
            low, high = sized(row[1]), sized(row[3])
            if np.nanmin(column.values) < (low.value - low.half) * unit - column.half.max():
                yield f"{table.caption}: {row[0].text} goes below {low.value}"
            if np.nanmax(column.values) > (high.value + high.half) * unit + column.half.max():
                yield f"{table.caption}: {row[0].text} goes above {high.value}"
            yield from _misplaced(table, row, column, unit, step)
    if not seen:
        yield "no extremes are printed"


def _misplaced(table: Table, row: list[Cell], column: Series, unit: float, step: float) -> Iterator[str]:
    """An extreme at the angle of a position is that position's value."""
    for value, angle in ((sized(row[1]), sized(row[2])), (sized(row[3]), sized(row[4]))):
        k = angle.value / step
        if abs(k - round(k)) < 1e-6 and round(k) < len(column.values):
            off = value.half * unit + column.half[round(k)] + 1e-9
            if abs(column.values[round(k)] - value.value * unit) > off:
                yield f"{table.caption}: {row[0].text} is not {value.value} at {angle.value}°"


def _symbols(cell: Cell) -> list[str]:
    return [symbol_text(math) for math in cell.node.iter("math")]


@pytest.mark.parametrize("name", LEVERS)
def test_extremes_bound_the_rows(name):
    wrong(list(wrong_extremes(html(name), results(name))))
