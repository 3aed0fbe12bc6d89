"""What is printed as a velocity is the rate of what is printed as a displacement, and so on; by the printed rows alone.

A rate is a difference of rows to the fourth order; how far it may be off is told by the difference to the second one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Note
from pages import Series, by_law, columns, table_of, value_of
from reading import LEVERS, LINKAGES, html, results, wrong

CHAINS = [("S", "V", "a"), ("ψ", "ω", "ε")]


def rate(values: np.ndarray, step: float, closed: bool, angle: bool) -> tuple[np.ndarray, np.ndarray]:
    """Rate of equally spaced values and its estimated error; nan at the ends of an open row."""
    gain = np.diff(values)
    if angle:
        gain = np.angle(np.exp(1j * gain))  # a full turn is none
    if not closed:
        gain = np.concatenate([[math.nan] * 2, gain, [math.nan] * 2])
    before, after = np.roll(gain, 1), gain
    near = (before + after) / (2 * step)
    far = (np.roll(gain, 2) + before + after + np.roll(gain, -1)) / (4 * step)
    better, error = (4 * near - far) / 3, np.abs(near - far)
    error = np.fmax.reduce([np.roll(error, k) for k in (-2, -1, 0, 1, 2)])
    if closed:
        return np.append(better, better[0]), np.append(error, error[0])
    return better[2:-1], error[2:-1]


def not_rates(name: str, of: Series, printed: Series, step: float, closed: bool) -> Iterator[str]:
    """Rows at which a column is not the rate of another."""
    found, error = rate(of.values, step, closed, of.unit in ("°", "rad"))
    off = error + of.half * 2.5 / step + printed.half
    for k in np.flatnonzero(np.abs(printed.values - found) > off):
        yield f"{name}[{k}] is {printed.values[k]:.6g}, the rate of the rows is {found[k]:.6g} ± {off[k]:.2g}"


def step_and_closed(document: dict[str, Any], table: str) -> tuple[float, bool]:
    """Time between the rows, s; whether the last row is the first again."""
    phi = table_of(document, table)["phi"]
    turned = abs(math.remainder(phi[1] - phi[0], 2 * math.pi))
    count = len(phi) - 1
    closed = math.isclose(count * turned, 2 * math.pi, rel_tol=1e-9)
    if not by_law(document):
        return turned / abs(value_of(document, "omega")), closed
    ends = table_of(document, "rates_table")["w_1"][[0, -1]]
    return value_of(document, "law_time") / count, closed and math.isclose(*ends, rel_tol=1e-9, abs_tol=1e-9)


def wrong_outputs(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """S, V, a of sliders and psi, omega, epsilon of rockers in the table of the note."""
    step, closed = step_and_closed(document, "outputs_table")
    found, seen = columns(note), 0
    for chain in CHAINS:
        for symbol, entries in found.items():
            base, _, sub = symbol.partition("_")
            if base != chain[0]:
                continue
            for (of, to), (table, _) in zip(((0, 1), (1, 2)), [entries[0]] * 2, strict=True):
                one = next((s for t, s in found.get(f"{chain[of]}_{sub}", []) if t is table), None)
                other = next((s for t, s in found.get(f"{chain[to]}_{sub}", []) if t is table), None)
                if one is not None and other is None:  # a column of noughts is left out, the table says so
                    other = Series(np.zeros(len(one.values)), np.zeros(len(one.values)), "")
                if one is None or other is None:
                    yield f"{chain[of]}_{sub} and {chain[to]}_{sub} do not stand in one table"
                    continue
                seen += 1
                yield from not_rates(f"{chain[to]}_{sub}", one, other, step, closed)
    if not seen:
        yield "no outputs are printed"


def wrong_links(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """Angular accelerations of links are the rates of their angular velocities."""
    step, closed = step_and_closed(document, "rates_table")
    found = columns(note)
    for symbol, entries in found.items():
        base, _, link = symbol.partition("_")
        if base == "ω" and f"ε_{link}" in found:
            speed, acceleration = entries[-1][1], found[f"ε_{link}"][-1][1]
            if len(speed.values) == len(acceleration.values) >= len(table_of(document, "rates_table")["phi"]):
                yield from not_rates(f"ε_{link}", speed, acceleration, step, closed)


@pytest.mark.parametrize("name", LEVERS)
def test_printed_rates_are_rates(name):
    note, document = html(name), results(name)
    wrong([*wrong_outputs(note, document), *wrong_links(note, document)])


# --- results.json ---


def exact(table: dict[str, np.ndarray], key: str) -> Series:
    """A column of the results; noise is what is small beside all columns of its kind."""
    scale = max(
        np.nanmax(np.abs(values), initial=0.0) for other, values in table.items() if other[:2] == key[:2]
    )
    return Series(table[key], np.full(len(table[key]), 1e-9 * scale), "")


def wrong_vectors(document: dict[str, Any]) -> Iterator[str]:
    """The size of every vector is that of its components."""
    for name in document["tables"]:
        table = table_of(document, name)
        for key, size in table.items():
            if f"{key}_x" in table and f"{key}_y" in table:
                x, y = table[f"{key}_x"], table[f"{key}_y"]
                off = np.abs(np.hypot(x, y) - np.abs(size)) > 1e-9 * max(
                    1e-9, np.nanmax(np.abs(size), initial=0.0)
                )
                unlike = (np.isnan(x) != np.isnan(size)) | (np.isnan(y) != np.isnan(size))
                yield from (
                    f"{name}.{key}[{k}] is not the size of x and y" for k in np.flatnonzero(off | unlike)
                )


def wrong_motion(document: dict[str, Any]) -> Iterator[str]:
    """Velocities of points are the rates of places, accelerations of velocities; angles likewise."""
    step, closed = step_and_closed(document, "rates_diagram")
    places, rates = table_of(document, "positions_diagram"), table_of(document, "rates_diagram")
    for key in places:
        base, _, point = key.partition("_")
        speed, acceleration = f"v_{point}_{base}", f"a_{point}_{base}"
        if base in ("x", "y") and speed in rates:
            yield from not_rates(speed, exact(places, key), exact(rates, speed), step, closed)
            yield from not_rates(acceleration, exact(rates, speed), exact(rates, acceleration), step, closed)
        elif base == "phi" and f"w_{point}" in rates:
            turned, turning = exact(places, key)._replace(unit="rad"), exact(rates, f"w_{point}")
            yield from not_rates(f"w_{point}", turned, turning, step, closed)
            yield from not_rates(f"e_{point}", turning, exact(rates, f"e_{point}"), step, closed)


def wrong_relative(document: dict[str, Any]) -> Iterator[str]:
    """v_BA is v_B - v_A; its normal and tangential accelerations add up to a_B - a_A."""
    rates = table_of(document, "rates_table")

    def vector(key: str) -> np.ndarray:
        return (
            rates[f"{key}_x"] + 1j * rates[f"{key}_y"]
            if f"{key}_x" in rates
            else np.zeros(len(rates["phi"])) + 0j
        )

    points = sorted((key[2:-2] for key in rates if key.startswith("v_") and key.endswith("_x")), key=len)
    for pair in points:
        for one in points:
            other = pair.removeprefix(one)
            if (
                pair.startswith(one)
                and other in points
                and f"a_{pair}_n" in rates
                and f"a_{pair}_k" not in rates
            ):
                yield from _unlike(
                    f"v_{pair}", vector(f"v_{pair}"), vector(f"v_{one}") - vector(f"v_{other}")
                )
                sums = vector(f"a_{pair}_n") + vector(f"a_{pair}_t")
                yield from _unlike(f"a_{pair}", sums, vector(f"a_{one}") - vector(f"a_{other}"))


def wrong_coriolis(document: dict[str, Any]) -> Iterator[str]:
    """The size of a Coriolis acceleration is 2 ω v with the angular velocity of a link."""
    rates = table_of(document, "rates_table")
    for key, found in rates.items():
        pair = key.removeprefix("a_").removesuffix("_k")
        if key == f"a_{pair}_k" and f"v_{pair}" in rates:
            turning = [np.abs(values) for name, values in rates.items() if name.startswith("w_")]
            if not any(
                np.allclose(found, 2 * w * rates[f"v_{pair}"], atol=1e-8 * found.max()) for w in turning
            ):
                yield f"{key} is not 2 ω v_{pair} of any link"


def _unlike(name: str, one: np.ndarray, other: np.ndarray) -> Iterator[str]:
    scale = max(1e-6, float(np.nanmax(np.abs(one), initial=0.0)))
    for k in np.flatnonzero(np.abs(one - other) > 1e-8 * scale):
        yield f"{name}[{k}] is {one[k]:.6g}, by the points {other[k]:.6g}"


@pytest.mark.parametrize("name", LINKAGES)
def test_motion_in_the_results_agrees_with_itself(name):
    document = results(name)
    wrong(
        [
            *wrong_vectors(document),
            *wrong_motion(document),
            *wrong_relative(document),
            *wrong_coriolis(document),
        ]
    )
