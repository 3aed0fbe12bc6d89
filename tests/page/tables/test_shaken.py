"""Shaking and balancing of the results: inertia forces by masses and accelerations, counterweights by their moments,
harmonics by their orders; diagrams by the columns that they show. Nothing of the program is used."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from conftest import path_of
from curves import Curve, curves, is_graph
from note import Note, text_of
from pages import table_of, value_of
from printed import unit
from reading import LEVERS, html, results, wrong

CLOSE = 1e-9
STATES = {name: path_of(name).read_text("utf-8") for name in LEVERS}
BALANCED = [name for name, text in STATES.items() if "\nbalancing:" in text]
HARMONIC = [name for name, text in STATES.items() if "\nharmonics:" in text]


def texts(document: dict[str, Any], name: str, key: str) -> list[str]:
    columns = document["tables"][name]["columns"]
    return next(column["values"] for column in columns if column["key"] == key)


def differs(
    what: str, one: np.ndarray, other: np.ndarray, size: float = 0.0, close: float = CLOSE
) -> Iterator[str]:
    size = size or float(np.nanmax(np.abs(other), initial=0.0)) or 1.0
    for k in np.flatnonzero(np.abs(np.asarray(one) - other) > close * size):
        yield f"{what}, row {k}: {np.asarray(one)[k]:.8g}, should be {other[k]:.8g}"


# ---------------------------------------------------------------- the shaking


def inertia(document: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """−Σ m a_S, and −Σ (r × m a_S + J ε) about the origin, at the positions."""
    masses, rates = table_of(document, "masses"), table_of(document, "rates_table")
    places = table_of(document, "positions_table")
    links, centres = (texts(document, "masses", key) for key in ("link", "mass_centre"))
    still = np.zeros(len(rates["position"]))
    force, moment = still + 0j, still.copy()
    for link, centre, m, J in zip(links, centres, masses["m"], masses["J"], strict=True):
        if f"a_{centre}_x" in rates:
            part = -m * (rates[f"a_{centre}_x"] + 1j * rates[f"a_{centre}_y"])
            place = places[f"x_{centre}"] + 1j * places[f"y_{centre}"]
            force, moment = force + part, moment + (place.conjugate() * part).imag
        if math.isfinite(J):
            moment = moment - J * rates.get(f"e_{link}", still)
    return force, moment


@pytest.mark.parametrize("name", BALANCED)
def test_shaking_is_the_inertia_of_the_links(name):
    document = results(name)
    table, (force, moment) = table_of(document, "shaking_table"), inertia(document)
    found = [*differs("F_x", table["F_shake_x"], force.real, np.abs(force).max())]
    found += differs("F_y", table["F_shake_y"], force.imag, np.abs(force).max())
    found += [*differs("F", table["F_shake"], np.abs(force)), *differs("M", table["M_shake"], moment)]
    wrong(found)


# ---------------------------------------------------------------- counterweights


@pytest.mark.parametrize("name", BALANCED)
def test_counterweights_meet_the_masses(name):
    """U = −Σ m r, m ρ = U, at its angle."""
    document = results(name)
    table = table_of(document, "counterweights")
    ways, links = (texts(document, "counterweights", key) for key in ("method", "link"))
    U = table["U_x"] + 1j * table["U_y"]
    found = [*differs("U", table["U"], np.abs(U)), *differs("m ρ", table["m_c"] * table["rho"], np.abs(U))]
    found += differs("β", np.exp(1j * table["beta"]), U / np.abs(U))
    masses = table_of(document, "counterweight_masses")
    rows = list(
        zip(*(texts(document, "counterweight_masses", key) for key in ("method", "link")), strict=True)
    )
    for k, of in enumerate(zip(ways, links, strict=True)):
        met = [row for row, other in enumerate(rows) if other == of]
        if met:
            total = -sum(masses["m"][row] * (masses["x"][row] + 1j * masses["y"][row]) for row in met)
            found += differs(f"masses of {of}", np.array([total]), U[k : k + 1])
    wrong(found)


@pytest.mark.parametrize("name", BALANCED)
def test_a_counterweight_on_the_driving_link_adds_its_centrifugal_force(name):
    """Of the ways that put one on that link alone; every way leaves what its row of the comparison says."""
    document = results(name)
    before, after = table_of(document, "shaking_table"), table_of(document, "balanced_table")
    weights, cases = table_of(document, "counterweights"), table_of(document, "balancing_cases")
    omega, found = value_of(document, "omega"), []
    ways = texts(document, "balancing_cases", "method")
    for k, way in enumerate(texts(document, "counterweights", "method")):
        n = ways.index(way)
        if texts(document, "counterweights", "method").count(way) == 1 and way.startswith("optimum"):
            added = [after[f"F_shake_{n}_{axis}"] - before[f"F_shake_{axis}"] for axis in "xy"]
            found += differs(way, np.hypot(*added), np.full(len(added[0]), weights["U"][k] * omega**2))
    for n in range(1, len(ways)):
        greatest, reached = cases["F_max"][n], np.abs(after[f"F_shake_{n}"]).max()
        if reached > greatest * (1 + CLOSE) + 1e-9 * cases["F_max"][0]:
            found.append(f"way {n} reaches {reached:.6g}, its greatest is {greatest:.6g}")
    found += differs("left", cases["left"], cases["F_max"] / cases["F_max"][0])
    found += differs("left of M", cases["M_left"], cases["M_max"] / cases["M_max"][0])
    wrong(found)


@pytest.mark.parametrize("name", BALANCED)
def test_least_means_and_maxima_are_least(name):
    document = results(name)
    cases, ways = table_of(document, "balancing_cases"), texts(document, "balancing_cases", "method")
    if "optimum_rms" in ways:
        rms, most = (ways.index(f"optimum_{kind}") for kind in ("rms", "max"))
        assert cases["F_rms"][rms] <= cases["F_rms"][most] and cases["F_max"][most] <= cases["F_max"][rms]
    if "full" in ways:
        assert cases["F_max"][ways.index("full")] < CLOSE * cases["F_max"][0]


@pytest.mark.parametrize("name", BALANCED)
def test_substituted_masses_keep_what_they_must(name):
    document, found = results(name), []
    if "substituted_masses" not in document["tables"]:
        return
    t = table_of(document, "substituted_masses")
    a, b = np.hypot(t["a"], t["off"]), np.hypot(t["b"], t["off"])
    found += [
        *differs("mass", t["m_A"] + t["m_B"], t["m"]),
        *differs("centre", t["m_A"] * t["a"], t["m_B"] * t["b"]),
    ]
    found += differs("rest", t["J_rest"], t["J"] - t["m_A"] * a**2 - t["m_B"] * b**2)
    known = np.isfinite(t["m_S3"])
    found += differs("three", (t["m_A3"] + t["m_B3"] + t["m_S3"])[known], t["m"][known])
    found += differs("J", (t["m_A3"] * t["a"] ** 2 + t["m_B3"] * t["b"] ** 2)[known], t["J"][known])
    wrong(found)


@pytest.mark.parametrize("name", BALANCED)
def test_rotors_are_as_strong_as_the_harmonics_against_which_they_turn(name):
    document, found = results(name), []
    rotors, harmonics = table_of(document, "lanchester_rotors"), table_of(document, "shaking_harmonics")
    omega = value_of(document, "omega")
    for order, product, alpha in zip(rotors["order"], rotors["mr"], rotors["alpha"], strict=True):
        row, side = int(abs(order)) - 1, "with" if order > 0 else "against"
        size = harmonics[f"F_{side}"][row]
        found += differs(f"rotor {order}", np.array([product * (order * omega) ** 2]), np.array([size]))
        if math.isfinite(alpha):
            turned = np.exp(1j * (alpha - harmonics[f"alpha_{side}"][row]))
            found += differs(f"angle of rotor {order}", np.array([turned]), np.array([-1 + 0j]), close=1e-6)
    wrong(found)


@pytest.mark.parametrize("name", BALANCED)
def test_wheels_and_weights_in_antiphase_add_their_moments(name):
    """−Σ J i ε of the wheels, ± U (kω)² d sin(kφ + α) of two weights a distance apart; their forces are nothing."""
    document = results(name)
    ways, after = texts(document, "balancing_cases", "method"), table_of(document, "balanced_table")
    rates, omega, found = table_of(document, "rates_table"), value_of(document, "omega"), []
    if "inertia" not in ways:
        return
    n = ways.index("inertia")
    ready = [k for k in range(1, n) if np.abs(after[f"F_shake_{k}"] - after[f"F_shake_{n}"]).max() < 1e-9]
    wheels = table_of(document, "geared_inertia")
    added = sum(
        -J * i * rates[f"e_{link}"]
        for link, J, i in zip(
            texts(document, "geared_inertia", "link"), wheels["J"], wheels["i"], strict=True
        )
    )
    near = [np.abs(after[f"M_shake_{k}"] + added - after[f"M_shake_{n}"]).max() for k in ready]
    if not near or min(near) > CLOSE * np.abs(added).max():
        found.append(f"the wheels take something else: {near}")
    if "couples" in ways:
        pairs, m = table_of(document, "antiphase_weights"), ways.index("couples")
        turned = math.copysign(1, omega) * after["phi"]
        sizes = pairs["m"] * pairs["r"] * (pairs["order"] * omega) ** 2 * pairs["d"]
        moments = [
            size * np.sin(k * turned + alpha)
            for size, k, alpha in zip(sizes, pairs["order"], pairs["alpha"], strict=True)
        ]
        of = after[f"M_shake_{n}"] + sum(moments)
        found += differs("weights", after[f"M_shake_{m}"], of, np.abs(after[f"M_shake_{n}"]).max())
        found += differs("amplitude", pairs["M"], sizes)
        harmonics = table_of(document, "moment_harmonics")
        rows = [int(k) - 1 for k in pairs["order"]]
        found += differs("taken", harmonics["M_after"][rows], np.zeros(len(rows)), harmonics["M"].max())
    wrong(found)


@pytest.mark.parametrize("name", BALANCED)
def test_harmonics_of_sliders_by_the_known_series(name):
    """A₂ = λ + λ³/4 + 15λ⁵/128 + 35λ⁷/512 + …, of sliders on the line of the crank's pivot."""
    document, found = results(name), []
    for table in (key for key in document["tables"] if key.startswith("slider_harmonics_")):
        slider, columns = table.removeprefix("slider_harmonics_"), table_of(document, table)
        lam = value_of(document, f"slider_lambda_{slider}")
        found += differs(
            "λ", np.array([value_of(document, f"slider_lambda_L_{slider}")]), np.array([1 / lam])
        )
        size = np.hypot(columns["A"], columns.get("B", 0 * columns["A"]))
        force = value_of(document, f"slider_m_B_{slider}") * value_of(document, f"slider_r_{slider}")
        found += differs("F", columns["F"], size * force * value_of(document, "omega") ** 2)
        found += differs(
            "U_I", np.array([value_of(document, f"slider_U_I_{slider}")]), np.array([size[0] * force / 2])
        )
        found += differs(
            "U_II", np.array([value_of(document, f"slider_U_II_{slider}")]), np.array([size[1] * force / 8])
        )
        if "A_one" in columns:
            series = lam + lam**3 / 4 + 15 * lam**5 / 128 + 35 * lam**7 / 512
            found += differs("A₂", columns["A"][1:2], np.array([series]), close=1e-3 * lam**2)
            found += differs("c", (columns["c"] * columns["order"] ** 2 / lam)[1:], columns["A"][1:])
            for short in ("one", "two"):
                error = columns[f"A_{short}"] / columns["A"] - 1
                found += differs(f"miss_{short}", columns[f"miss_{short}"], error, 1.0)
        forces = table_of(document, f"slider_forces_{slider}")
        assert (
            np.abs(forces["F_second"]).max()
            < np.abs(forces["F_first"]).max()
            < np.abs(forces["F_slider"]).max()
        )
    wrong(found)


# ---------------------------------------------------------------- harmonics of the motion


@pytest.mark.parametrize("name", HARMONIC)
def test_sums_of_the_harmonics_are_the_outputs_to_what_is_left(name):
    """S, V and a of sliders at the positions of the table."""
    document, found = results(name), []
    content, outputs = table_of(document, "harmonic_content"), table_of(document, "outputs_table")
    phi, left = (
        outputs["phi"],
        dict(
            zip(
                texts(document, "harmonics_left", "motion"),
                table_of(document, "harmonics_left")["left"],
                strict=True,
            )
        ),
    )
    for kind, key in (("S", "S"), ("V", "V"), ("a", "A")):
        for column in (c for c in content if c.startswith(f"A_{kind}_")):
            point = column.removeprefix(f"A_{kind}_")
            if f"{key}_{point}" not in outputs:
                continue
            at = np.nan_to_num(content[f"alpha_{kind}_{point}"])
            total = sum(A * np.cos(k * phi - at[k]) for k, A in enumerate(content[column]))
            values = outputs[f"{key}_{point}"]
            allowed = left[f"{kind}_{point}"] * np.abs(values - content[column][0]).max() * 1.5 + 1e-9
            found += differs(column, total, values, 1.0, allowed)
    wrong(found)


@pytest.mark.parametrize("name", HARMONIC)
def test_waves_are_straight_between_the_ends_of_a_link(name):
    """A e^{iα} of every harmonic is linear in ξ."""
    document, found = results(name), []
    for table in (key for key in document["tables"] if key.startswith("wave_")):
        columns = table_of(document, table)
        xi, sizes = columns["xi"], [c for c in columns if c.startswith("A_")]
        largest = max(columns[c].max() for c in sizes)
        for column in sizes:
            wave = columns[column] * np.exp(1j * np.nan_to_num(columns[column.replace("A_", "alpha_")]))
            straight = wave[0] + xi * (wave[-1] - wave[0])
            found += differs(f"{table} {column}", wave, straight, largest)
    wrong(found)


# ---------------------------------------------------------------- diagrams


def drawn(note: Note, letter: str) -> Iterator[Curve]:
    """The curves of the diagrams whose first axis has this letter alone."""
    for figure in note.root.iter("figure"):
        svg = note.drawings[figure.get("id") or ""]
        caption = figure.find("figcaption")
        if is_graph(svg) and caption is not None and text_of(caption):
            found = curves(svg)
            if found and found[0].axis.letter == letter:
                yield from found


def shown(curve: Curve, phi: np.ndarray) -> np.ndarray:
    """In SI at angles of turn, degrees."""
    order = np.argsort(curve.turned, kind="stable")
    of = unit(curve.axis.unit)
    assert of is not None
    return of.factor * np.interp(phi, curve.turned[order], curve.values[order])


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", BALANCED)
def test_diagrams_show_columns_of_the_results(name):
    """Each curve of F and M is one of the shaking, before or after; the first of both is that of before."""
    document, found = results(name), []
    before, after = table_of(document, "shaking_diagram"), table_of(document, "balanced_diagram")
    phi = np.degrees(before["phi"])
    columns = {"F": [before["F_shake"]], "M": [before["M_shake"]]}
    for letter, kept in columns.items():
        kept += [after[key] for key in after if key.removeprefix(f"{letter}_shake_").isdigit()]
    for slider in (
        key.removeprefix("slider_forces_") for key in document["tables"] if key.startswith("slider_forces_")
    ):
        table = table_of(document, f"slider_forces_{slider}")
        columns[f"slider {slider}"] = [table[key] for key in ("F_slider", "F_first", "F_second")]
    seen: dict[str, int] = {"F": 0, "M": 0}
    for curve in drawn(html(name), "F"):
        letter = curve.axis.letter
        grids = [(phi, columns[letter])]
        if letter == "F":
            grids += [
                (np.degrees(table_of(document, "shaking_table")["phi"]), columns[key])
                for key in columns
                if key.startswith("slider")
            ]
        height = max(np.abs(column).max() for _, kept in grids for column in kept)
        near = min(np.abs(shown(curve, at) - column).max() for at, kept in grids for column in kept)
        if near > 1e-3 * height:
            found.append(f"a curve of {letter} is {near:.3g} off all columns")
        if not seen[letter] and np.abs(shown(curve, phi) - columns[letter][0]).max() > 1e-3 * height:
            found.append(f"the first curve of {letter} is not that of before")
        seen[letter] += 1
    assert min(seen.values()) > 0
    wrong(found)
