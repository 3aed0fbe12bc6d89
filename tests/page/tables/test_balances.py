"""Rotors and engines of the results: products that close, forces by the angles and places of the cylinders; the drawn
polygons at the scales of their captions.
"""

from __future__ import annotations

import cmath
from typing import Any

import numpy as np
import pytest
from captions import figures
from conftest import path_of
from reading import CHOSEN, html, results
from vectors import vectors

CLOSE = 1e-9


def stating(key: str) -> list[str]:
    return [name for name in CHOSEN if f"\n{key}:" in path_of(name).read_text("utf-8")]


ROTORS, ENGINES = stating("rotor"), stating("engine")


def columns(document: dict[str, Any], name: str) -> dict[str, list[Any]]:
    return {column["key"]: column["values"] for column in document["tables"][name]["columns"]}


def numbers(document: dict[str, Any], name: str) -> dict[str, np.ndarray]:
    """The columns of numbers; what is missing is nan."""
    found = columns(document, name)
    texts = [key for key, values in found.items() if any(isinstance(one, str) for one in values)]
    return {key: np.array(values, dtype=float) for key, values in found.items() if key not in texts}


def value(document: dict[str, Any], key: str) -> float:
    return next(one["value"] for one in document["values"] if one["key"] == key)


def turned(sizes: np.ndarray, degrees: np.ndarray) -> np.ndarray:
    return sizes * np.exp(1j * np.radians(degrees))


# --- rotors


@pytest.mark.parametrize("name", ROTORS)
def test_products_of_masses_and_weights_close(name):
    document = results(name)
    masses, weights = (numbers(document, f"rotor_{of}") for of in ("masses", "corrections"))
    known = np.isfinite(masses["m"])
    assert masses["D"][known] == pytest.approx(masses["m"][known] * masses["r"][known])
    products, added = turned(masses["D"], masses["alpha"]), turned(weights["D"], weights["alpha"])
    couples = masses.get("J_xz", 0.0) + 1j * masses.get("J_yz", 0.0)
    size = np.sum(np.abs(products))
    assert abs(np.sum(products) + np.sum(added)) < CLOSE * size
    moments = np.sum(products * masses["z"] + couples) + np.sum(added * weights["z"])
    assert abs(moments) < CLOSE * size or len(added) == 1
    assert weights["D"] == pytest.approx(weights["m"] * weights["r"])
    assert turned(1.0, weights["beta"]) == pytest.approx(turned(1.0, weights["alpha"]))
    assert weights["D_x"] + 1j * weights["D_y"] == pytest.approx(added)
    whole = products * (masses["z"] - weights["z"][0]) + couples
    assert masses["M"] == pytest.approx(np.abs(whole))
    assert value(document, "rotor_M_x") + 1j * value(document, "rotor_M_y") == pytest.approx(np.sum(whole))


@pytest.mark.parametrize("name", ROTORS)
def test_forces_on_the_bearings_hold_the_shaft(name):
    """Both forces and those of the unbalances: no force and no couple is left; so with the weights as made."""
    document = results(name)
    masses, weights, bearings = (
        numbers(document, f"rotor_{of}") for of in ("masses", "corrections", "bearings")
    )
    omega, couples = value(document, "rotor_omega"), masses.get("J_xz", 0.0) + 1j * masses.get("J_yz", 0.0)
    before = turned(bearings["R_before"], bearings["psi"]) / omega**2
    products = turned(masses["D"], masses["alpha"])
    size = np.sum(np.abs(products))
    assert abs(np.sum(products) - np.sum(before)) < CLOSE * size
    assert abs(np.sum(products * masses["z"] + couples) - np.sum(before * bearings["z"])) < CLOSE * size
    made = turned(weights["m_made"] * weights["r_made"], weights["beta_made"])
    left = np.sum(products) + np.sum(made)
    assert value(document, "rotor_left_D") == pytest.approx(abs(left))
    moment = np.sum(products * masses["z"] + couples) + np.sum(made * weights["z"])
    span = bearings["z"][1] - bearings["z"][0]
    second = (moment - left * bearings["z"][0]) / span
    assert bearings["D_made"] == pytest.approx(np.abs([left - second, second]))
    assert bearings["R_made"] == pytest.approx(bearings["D_made"] * omega**2)
    assert value(document, "rotor_D_per") == pytest.approx(
        value(document, "rotor_mass") * value(document, "rotor_G") / 1000 / omega
    )


@pytest.mark.parametrize("name", ROTORS)
@pytest.mark.parametrize(("letter", "scale"), [("D", "μ_D"), ("M", "μ_M")])
def test_polygons_of_rotors_are_drawn_at_their_scale(name, letter, scale):
    note, document = html(name), results(name)
    masses, weights = (numbers(document, f"rotor_{of}") for of in ("masses", "corrections"))
    names = columns(document, "rotor_masses")["name"]
    expected = dict(zip(names, turned(masses["D"], masses["alpha"]), strict=True))
    if letter == "M":
        couples = masses.get("J_xz", 0.0) + 1j * masses.get("J_yz", 0.0)
        whole = turned(masses["D"], masses["alpha"]) * masses["l"] + couples
        expected = dict(zip(names, whole, strict=True))
    [(anchor, _, mu)] = list(figures(note, scale))
    drawn = vectors(note.drawings[anchor])
    assert {one.key for one in drawn.shown} >= {f"{letter}_{name}" for name in names}
    for one in drawn.shown:
        key = one.key.partition("_")[2]
        if key in expected:
            assert abs(one.along - expected[key] / mu) < 0.08
    weight = dict(
        zip(
            columns(document, "rotor_corrections")["plane"],
            turned(weights["D"], weights["alpha"]),
            strict=True,
        )
    )
    closing = {"D": "I", "M": "II"}[letter]
    arm = 1.0 if letter == "D" else value(document, "rotor_L")
    along = next(one.along for one in drawn.shown if one.key == f"{letter}_{closing}")
    assert abs(along - weight[closing] * arm / mu) < 0.5


# --- engines


def pistons(document: dict[str, Any], phi: np.ndarray) -> np.ndarray:
    """Places of the masses of each cylinder from the axis of the shaft times their masses, (P, N), complex."""
    of = numbers(document, "engine_cylinders")
    r, l = value(document, "engine_r"), value(document, "engine_l")
    banks, cranks = np.radians(of["beta"]), np.radians(of["psi"])
    theta = phi[:, None] + cranks - banks
    piston = value(document, "engine_m") * 1j * np.exp(1j * banks)
    piston = piston * (r * np.cos(theta) + np.sqrt(l**2 - (r * np.sin(theta)) ** 2))
    pin = 1j * np.exp(1j * (phi[:, None] + cranks))
    return piston + pin * value(document, "engine_m_rot") * r


def forces(document: dict[str, Any], weighted: bool) -> tuple[np.ndarray, np.ndarray]:
    """Force and moment at the angles of the diagram by the second derivative, (P,); with the counterweights or not."""
    phi = 2 * np.pi * np.arange(720) / 720
    of = numbers(document, "engine_cylinders")
    carried = pistons(document, phi)
    if weighted:
        product = value(document, "engine_m_cw") * value(document, "engine_r_cw")
        carried = carried - 1j * np.exp(1j * (phi[:, None] + np.radians(of["psi"]))) * product
    orders = np.fft.fftfreq(720, 1 / 720)[:, None]
    inertia = value(document, "engine_omega") ** 2 * np.fft.ifft(
        orders**2 * np.fft.fft(carried, axis=0), axis=0
    )
    return np.sum(inertia, axis=1), inertia @ of["z"]


@pytest.mark.parametrize("name", ENGINES)
@pytest.mark.parametrize(("stage", "weighted"), [("before", False), ("after", True)])
def test_forces_over_a_turn_are_by_the_places_of_the_masses(name, stage, weighted):
    document = results(name)
    diagram, greatest = numbers(document, "engine_diagram"), numbers(document, "engine_greatest")
    size = value(document, "engine_unit") * value(document, "engine_count")
    for row, (letter, found) in enumerate(zip("FM", forces(document, weighted), strict=True)):
        drawn = diagram[f"{letter}_{stage}_x"] + 1j * diagram[f"{letter}_{stage}_y"]
        every = np.append(found[::10], found[0])
        assert np.abs(drawn - every).max() < CLOSE * size
        assert greatest[stage][row] == pytest.approx(np.abs(found).max(), rel=1e-4)


@pytest.mark.parametrize("name", ENGINES)
def test_orders_are_the_harmonics_of_the_reciprocating_masses(name):
    """Of the exact motion without counterweights; a textbook's coefficient is put in the place of the exact one."""
    document = results(name)
    table = numbers(document, "engine_orders")
    pins = 1j * np.exp(1j * np.radians(numbers(document, "engine_cylinders")["psi"]))
    own = (
        pins
        * value(document, "engine_m_rot")
        * value(document, "engine_r")
        * value(document, "engine_omega") ** 2
    )
    turning = {"F": np.sum(own), "M": own @ numbers(document, "engine_cylinders")["z"]}
    for letter, found in zip("FM", forces(document, False), strict=True):
        harmonics = np.fft.fft(found) / len(found)
        for row, k in enumerate(table["order"].astype(int)):
            share = table["c"][row] / table["c_exact"][row]
            ahead = abs(harmonics[k] - (turning[letter] if k == 1 else 0.0)) * abs(share)
            back = abs(harmonics[-k]) * abs(share)
            size = 1e-7 * value(document, "engine_unit")
            assert table[f"{letter}_forward"][row] == pytest.approx(ahead, rel=1e-6, abs=size)
            assert table[f"{letter}_backward"][row] == pytest.approx(back, rel=1e-6, abs=size)
            assert table[f"{letter}_max"][row] == pytest.approx(ahead + back, rel=1e-6, abs=size)
            assert table[f"{letter}_min"][row] == pytest.approx(abs(ahead - back), rel=1e-6, abs=2 * size)


@pytest.mark.parametrize("name", ENGINES)
def test_weights_of_the_remedies_balance_orders_1_and_2(name):
    document = results(name)
    table, omega = numbers(document, "engine_remedies"), value(document, "engine_omega")
    phi = np.radians(numbers(document, "engine_diagram")["phi"])
    diagram = numbers(document, "engine_diagram")
    size = value(document, "engine_unit") * value(document, "engine_count")
    of = columns(document, "engine_remedies")["of"]
    for letter, kind in (("F", "force"), ("M", "couple")):
        left = diagram[f"{letter}_orders_x"] + 1j * diagram[f"{letter}_orders_y"]
        for row in (row for row, one in enumerate(of) if one == kind):
            k = int(table["order"][row])
            for sense, key in ((1, "forward"), (-1, "backward")):
                angle = np.radians(np.nan_to_num(table[f"{key}_angle"][row]))
                left = left + table[key][row] * (k * omega) ** 2 * np.exp(1j * (angle + sense * k * phi))
        assert np.abs(left).max() < CLOSE * size


@pytest.mark.parametrize("name", ENGINES)
def test_direct_and_reverse_cranks_add_up_to_the_axes(name):
    """At any angle half the sum of both is the axis times the cosine of the crank's angle from it."""
    of = numbers(results(name), "engine_cylinders")
    for k in (1, 2):
        for beta, psi, direct, reverse in zip(
            of["beta"], of["psi"], of[f"direct_{k}"], of[f"reverse_{k}"], strict=True
        ):
            both = (cmath.exp(1j * np.radians(direct)) + cmath.exp(1j * np.radians(reverse))) / 2
            assert both == pytest.approx(
                cmath.exp(1j * np.radians(beta)) * np.cos(k * np.radians(psi - beta))
            )
