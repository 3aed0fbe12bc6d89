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
REDUCED = [name for name in LEVERS if "\nreduction: true" in path_of(name).read_text("utf-8")]


def differ(name: str, one: np.ndarray, other: np.ndarray, close: float = CLOSE) -> Iterator[str]:
    for k in np.flatnonzero(np.abs(one - other) > close * np.abs(other).max()):
        yield f"{name} at position {k} is {one[k]:.6g}, by the rates {other[k]:.6g}"


def energies(document: dict[str, Any], omega: float) -> Iterator[tuple[str, np.ndarray]]:
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
    inertia = table_of(document, "reduced_inertia_table")
    omega = table_of(document, "rates_table")[f"w_{scheme(name).driver}"][0]
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
        balancing = omega**2 * inertia["I_red_slope"] / 2 - moment["M_red"]
        yield from differ("M_bal", table_of(document, "balancing_table")["M_bal"], balancing, 1e-7)


@pytest.mark.parametrize("name", REDUCED)
def test_reduced_moments(name):
    wrong(list(wrong_reduction(results(name), name)))
