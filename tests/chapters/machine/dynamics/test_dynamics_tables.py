"""The tables of the machine in motion worked again from their own columns, as a reader would."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import solved

from tmm_report.chapters.machine.dynamics import quantities
from tmm_report.quantity.model import Book

NAMES = ("hoist_start", "piston_pump")


@pytest.fixture(params=NAMES)
def book(request):
    found = solved(request.param).dynamics
    return Book.of(quantities.tables(found), quantities.values(found))


@pytest.fixture
def pump():
    found = solved("piston_pump").dynamics
    return Book.of(quantities.tables(found), quantities.values(found))


def columns(book, name):
    table = book.tables[f"dynamics_{name}"]
    return {
        c.key: np.array([math.nan if isinstance(x, str) else x for x in c.values], float)
        for c in table.columns
    }


def value(book, key):
    return book[f"dynamics_{key}"].value


def test_each_part_is_reduced_by_its_own_row(book):
    of = {key: np.nan_to_num(numbers) for key, numbers in columns(book, "parts").items()}
    assert of["J_red"] == pytest.approx(of["J"] * of["i"] ** 2 + of["m"] * of["r"] ** 2)
    resisting = of["M"] * of["i"] + of["F"] * of["r"]
    assert of["M_red"] == pytest.approx(np.where(resisting > 0, resisting / of["eta"], resisting * of["eta"]))
    assert value(book, "J_parts") == pytest.approx(of["J_red"].sum())
    assert value(book, "M_parts") == pytest.approx(of["M_red"].sum())


def test_the_characteristic_is_kloss_s_formula_on_the_main_shaft(book):
    of = columns(book, "characteristics")
    i, eta = (
        value(book, key) if f"dynamics_{key}" in book.values else 1.0 for key in ("i_motor", "eta_motor")
    )
    slip = 1 - of["omega"] * i / value(book, "omega_0")
    ratio = slip / value(book, "s_cr")
    assert of["s"] == pytest.approx(slip)
    moment = i * 2 * value(book, "M_max") / (ratio + 1 / ratio)
    assert of["M_dr"] == pytest.approx(np.where(moment > 0, moment * eta, moment / eta))


def test_the_cycle_obeys_the_equation_of_motion_row_by_row(pump):
    of = columns(pump, "cycle_table")
    assert of["J"] == pytest.approx(of["I_red"] + value(pump, "J_parts"))
    assert of["M_res"] == pytest.approx(of["M_fr"] - of["M_red"])
    assert of["M"] == pytest.approx(of["M_dr"] - of["M_res"])
    assert of["epsilon"] == pytest.approx((of["M"] - of["J_slope"] * of["omega"] ** 2 / 2) / of["J"])
    assert of["omega"] == pytest.approx(np.sqrt(2 * (value(pump, "T_0") + of["A"]) / of["J"]))
    assert of["M_fr"] == pytest.approx(6.0 + solved("piston_pump").lever.friction.table.reduced, rel=1e-5)
    slip = 1 - of["omega"] * value(pump, "i_motor") / value(pump, "omega_0")
    ratio = slip / value(pump, "s_cr")
    moment = 2 * value(pump, "M_max") / (ratio + 1 / ratio)
    assert of["M_dr"] == pytest.approx(value(pump, "i_motor") * value(pump, "eta_motor") * moment)


def test_time_and_work_of_the_cycle_are_the_running_integrals_of_their_columns(pump):
    of = columns(pump, "cycle_diagram")
    angle = np.radians(of["phi"])

    def running(y):
        return np.concatenate([[0.0], np.cumsum((y[1:] + y[:-1]) / 2 * np.diff(angle))])

    assert of["t"] == pytest.approx(running(1 / of["omega"]), abs=2e-3 * value(pump, "T_cycle"))
    assert of["A"] == pytest.approx(running(of["M"]), abs=0.05 * np.ptp(of["A"]))
    assert of["t"][-1] == pytest.approx(value(pump, "T_cycle"))


def test_the_extremes_give_the_mean_speed_and_the_non_uniformity(pump):
    low, high = (value(pump, key) for key in ("omega_min", "omega_max"))
    assert value(pump, "omega_m") == pytest.approx((low + high) / 2)
    assert value(pump, "delta") == pytest.approx(2 * (high - low) / (high + low))
    omega = columns(pump, "cycle_diagram")["omega"]
    assert low <= omega.min() < 1.002 * low and high >= omega.max() > 0.998 * high


@pytest.mark.parametrize("name", ["start", "coast"])
def test_a_regime_is_the_motion_that_its_columns_say(book, name):
    of = columns(book, f"{name}_diagram")
    t, omega = of["t"], of["omega"]
    assert np.gradient(omega, t, edge_order=2)[3:-3] == pytest.approx(
        of["epsilon"][3:-3], abs=0.03 * np.abs(of["epsilon"]).max()
    )
    travelled = np.concatenate([[0.0], np.cumsum((omega[1:] + omega[:-1]) / 2 * np.diff(t))])
    assert of["phi"] - of["phi"][0] == pytest.approx(travelled, abs=2e-3 * travelled[-1])
    if "dynamics_J" in book.values:
        assert of["epsilon"] * value(book, "J") == pytest.approx(of["M_dr"] - of["M_res"])
    for key, column in (("t", "t"), ("omega", "omega"), ("phi", "phi")):
        assert value(book, f"{key}_{name}") == pytest.approx(of[column][-1])
    assert value(book, f"turns_{name}") == pytest.approx(of["phi"][-1] / (2 * math.pi))
    rows = columns(book, name)
    assert len(rows["t"]) == 13
    assert all(rows[key] == pytest.approx(of[key][::10]) for key in rows)


@pytest.mark.parametrize("name", ["start", "coast"])
def test_the_work_of_a_regime_is_that_of_its_moments(book, name):
    of = columns(book, f"{name}_diagram")
    power = (of["M_dr"] - of["M_res"]) * of["omega"]
    work = float(np.sum((power[1:] + power[:-1]) / 2 * np.diff(of["t"])))
    table = book.tables["dynamics_works"]
    works = dict(zip(table["acting"].values, columns(book, "works")[f"A_{name}"], strict=True))
    assert works["sum"] == pytest.approx(work, rel=0.01) and works["gained"] == pytest.approx(work, rel=0.01)
    driving = of["M_dr"] * of["omega"]
    if name == "start":
        done = float(np.sum((driving[1:] + driving[:-1]) / 2 * np.diff(of["t"])))
        assert works["motor"] == pytest.approx(done, rel=0.01) and works["motor"] > 0


def test_the_mean_power_is_the_work_of_the_motor_in_the_time_of_a_cycle(pump):
    table = pump.tables["dynamics_works"]
    works = dict(zip(table["acting"].values, columns(pump, "works")["A_steady"], strict=True))
    assert value(pump, "P") == pytest.approx(works["motor"] / value(pump, "T_cycle"))


def test_the_even_motion_is_where_the_moments_are_in_balance():
    found = solved("hoist_start").dynamics
    hoist = Book.of(quantities.tables(found), quantities.values(found))
    omega = value(hoist, "omega_m")
    slip = (1 - omega / value(hoist, "omega_0")) / value(hoist, "s_cr")
    fan = value(hoist, "M_res1") * (omega / value(hoist, "omega_res1")) ** 2
    resisting = value(hoist, "M_parts") + fan
    assert 2 * value(hoist, "M_max") / (slip + 1 / slip) == pytest.approx(resisting)
    assert value(hoist, "M_steady") == pytest.approx(resisting)
    assert value(hoist, "P") == pytest.approx(resisting * omega)
    assert value(hoist, "T_steady") == pytest.approx(value(hoist, "J") * omega**2 / 2)
    assert value(hoist, "omega_start") == pytest.approx(0.98 * omega)
