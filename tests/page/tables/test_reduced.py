"""Reduced moments of the results: energy link by link, power load by load, the balancing moment that follows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from conftest import path_of
from pages import table_of, turned_link
from reading import LEVERS, results, wrong
from statics import scheme

CLOSE = 1e-9  # of the largest value of a column
REDUCED = [name for name in LEVERS if "\nreduction:" in path_of(name).read_text("utf-8")]


def differ(name: str, one: np.ndarray, other: np.ndarray, close: float = CLOSE) -> Iterator[str]:
    for k in np.flatnonzero(np.abs(one - other) > close * np.abs(other).max()):
        yield f"{name} at position {k} is {one[k]:.6g}, by the rates {other[k]:.6g}"


def energies(document: dict[str, Any], omega: np.ndarray | float) -> Iterator[tuple[str, np.ndarray]]:
    """Twice the kinetic energy of each link by the square of the driver's angular velocity."""
    columns = {c["key"]: c["values"] for c in document["tables"]["masses"]["columns"]}
    rates = table_of(document, "rates_table")
    still = np.zeros(len(rates["position"]))
    for link, m, centre, J in zip(*(columns[key] for key in ("link", "m", "mass_centre", "J")), strict=True):
        turning = rates.get(f"w_{link}", still)
        yield link, ((m or 0) * rates.get(f"v_{centre}", still) ** 2 + (J or 0) * turning**2) / omega**2


def powers(document: dict[str, Any], name: str) -> Iterator[tuple[str, np.ndarray]]:
    """Power of each weight and stated load."""
    loads, rates, drawn = table_of(document, "loads_table"), table_of(document, "rates_table"), scheme(name)
    still = np.zeros(len(rates["position"]))
    tied: dict[str, np.ndarray] = {}
    for key in loads:
        kind, _, sub = key.partition("_")
        of = turned_link(sub) if kind == "M" else sub.split(",")[0]
        if kind in ("G", "P") and key + "_x" in loads:
            point = drawn.mass_centres[of] if kind == "G" else of
            yield key, sum(loads[f"{key}_{axis}"] * rates.get(f"v_{point}_{axis}", still) for axis in "xy")
        elif kind == "M" and not sub.startswith("I"):
            yield key, loads[key] * rates[f"w_{of}"]
        elif (
            kind == "F" and "," in sub and key + "_x" in loads
        ):  # of a spring or damper, on one of its points
            at = sub.split(",")[1]
            part = sum(loads[f"{key}_{axis}"] * rates.get(f"v_{at}_{axis}", still) for axis in "xy")
            tied[f"F_{of}"] = tied.get(f"F_{of}", still) + part
    yield from tied.items()


def wrong_plans(document: dict[str, Any], driver: str) -> Iterator[str]:
    """The reduced moment of inertia by the ratios that were read off the plans, beside the one of the table."""
    if "reduction_plans" not in document["tables"]:
        return
    plans, exact = table_of(document, "reduction_plans"), table_of(document, "reduced_inertia_table")["I_red"]
    columns = {c["key"]: c["values"] for c in document["tables"]["masses"]["columns"]}
    read = np.zeros(len(plans["position"]))
    for link, m, centre, J in zip(*(columns[key] for key in ("link", "m", "mass_centre", "J")), strict=True):
        turning = 1.0 if link == driver else plans.get(f"u_{link}_{driver}", np.zeros(1))
        read = read + (m or 0) * plans.get(f"vq_{centre}", np.zeros(1)) ** 2 + (J or 0) * turning**2
    yield from differ("I_red_graph", plans["I_red_graph"], read)
    yield from differ("I_red", plans["I_red"], exact[plans["position"].astype(int)])


def wrong_reduction(document: dict[str, Any], name: str) -> Iterator[str]:
    if "reduced_inertia_table" not in document["tables"]:  # a stroke drives
        return
    inertia = table_of(document, "reduced_inertia_table")
    rates, driver = table_of(document, "rates_table"), scheme(name).driver
    omega, epsilon = rates[f"w_{driver}"], rates.get(f"e_{driver}", 0.0)  # by a law they vary
    parts = dict(energies(document, omega))
    for link, part in parts.items():
        yield from differ(f"I_{link}", inertia[f"I_{link}"], part)
    yield from differ("I_red", inertia["I_red"], sum(parts.values()))  # type: ignore[arg-type]
    yield from wrong_plans(document, scheme(name).driver)
    if "reduced_moment_table" in document["tables"]:
        moment, work = table_of(document, "reduced_moment_table"), dict(powers(document, name))
        for key, power in work.items():
            yield from differ(f"M_red_{key}", moment[f"M_red_{key}"], power / omega)
        yield from differ("M_red", moment["M_red"], sum(work.values()) / omega)
        balancing = inertia["I_red"] * epsilon + omega**2 * inertia["I_red_slope"] / 2 - moment["M_red"]
        yield from differ("M_bal", table_of(document, "balancing_table")["M_bal"], balancing, 1e-7)


@pytest.mark.parametrize("name", REDUCED)
def test_reduced_moments(name):
    wrong(list(wrong_reduction(results(name), name)))


def derivative(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """dy/dx at the inner places, by parabolas."""
    before, after = np.diff(x)[:-1], np.diff(x)[1:]
    with np.errstate(invalid="ignore"):  # where the link turns back two places are one
        left, right = np.diff(y)[:-1] / before, np.diff(y)[1:] / after
        return (left * after + right * before) / (before + after)


def wrong_translation(document: dict[str, Any], name: str) -> Iterator[str]:
    """Reduced mass and force by the rates and loads of the results; the equation of motion beside the reactions."""
    if "reduced_mass_table" not in document["tables"]:
        return
    mass, force = table_of(document, "reduced_mass_table"), table_of(document, "reduced_force_table")
    v, known = mass["v"], np.isfinite(mass["m_red"]) & (np.abs(mass["v"]) > 0)
    assert known.sum() > len(v) / 2
    parts = dict(energies(document, 1.0))
    v = v[known]
    for link, part in parts.items():
        yield from differ(f"m_red_{link}", mass[f"m_red_{link}"][known], part[known] / v**2)
    yield from differ("m_red", mass["m_red"][known], sum(parts.values())[known] / v**2)  # type: ignore[index]
    work = dict(powers(document, name))
    for key, power in work.items():
        yield from differ(f"F_red_{key}", force[f"F_red_{key}"][known], power[known] / v, 1e-8)
    yield from differ("F_red", force["F_red"][known], sum(work.values())[known] / v, 1e-8)  # type: ignore[index]
    rates, driver = table_of(document, "rates_table"), scheme(name).driver
    balancing = table_of(document, "balancing_table")["M_bal"] * rates[f"w_{driver}"]
    yield from differ("F_dr", force["F_dr"][known], balancing[known] / v, 1e-7)
    of, a = mass["m_red"][known] * mass["a"][known], mass["m_red_slope"][known] * v**2 / 2
    yield from differ("F_dr", force["F_dr"][known], of + a - force["F_red"][known])
    fine = table_of(document, "reduced_mass_diagram")
    values = {one["key"]: one["value"] for one in document["values"]}
    for key, most in (("m_red_min", np.nanmin), ("m_red_max", np.nanmax)):
        if key in values and abs(values[key] - most(fine["m_red"])) > CLOSE * values[key]:
            yield f"{key} is {values[key]}, of the diagram {most(fine['m_red'])}"
    slope, off = fine["m_red_slope"][1:-1], derivative(fine["s"], fine["m_red"])
    smooth = np.isfinite(slope) & np.isfinite(off)
    if np.quantile(np.abs(off - slope)[smooth], 0.7) > 0.1 * np.abs(slope[smooth]).max():
        yield "m_red_slope is not the derivative of m_red"


def wrong_places(document: dict[str, Any], name: str) -> Iterator[str]:
    """The stroke is where the link is: its speed is how fast the place grows over the positions."""
    if "reduced_mass_diagram" not in document["tables"]:
        return
    fine = table_of(document, "reduced_mass_diagram")
    times = table_of(document, "outputs_diagram")["t"]
    for key, of in (("v", "s"), ("a", "v")):
        size = np.abs(fine[key]).max()
        if np.quantile(np.abs(derivative(times, fine[of]) - fine[key][1:-1]), 0.8) > 0.05 * size:
            yield f"{key} is not the derivative of {of}"


@pytest.mark.parametrize("name", REDUCED)
def test_reduced_mass_and_force(name):
    wrong([*wrong_translation(results(name), name), *wrong_places(results(name), name)])
