"""Assignments typed as their collections print them: the answers come out to the digits of independent solvers."""

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import yaml

from tmm_report import course, render
from tmm_report.chapters.lever.kinetostatics.solve import positions as kinetostatics
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import stated
from tmm_report.mechanics.lever.vector_equations import named_values

HERE = Path(__file__).parent
NAMES = sorted(path.name.removesuffix(".answers.yaml") for path in HERE.glob("*.answers.yaml"))
DIGITS = 1e-9
TABLES = (
    "positions_table",
    "outputs_table",
    "rates_table",
    "loads_table",
    "reactions_table",
    "balancing_table",
)


@cache
def found(name: str) -> dict:
    variant = course.load(HERE / f"{name}.yaml")
    return json.loads(render(course.solve(variant), "json")["results.json"])


def answers(name: str) -> dict:
    return yaml.safe_load((HERE / f"{name}.answers.yaml").read_text("utf-8"))


def columns(document: dict, table: str) -> dict[str, list]:
    return {column["key"]: column["values"] for column in document["tables"][table]["columns"]}


@pytest.mark.parametrize("name", NAMES)
def test_single_numbers(name):
    values = {one["key"]: one["value"] for one in found(name)["values"]}
    asked = answers(name)["values"]
    assert {key: values[key] for key in asked} == pytest.approx(asked, rel=DIGITS)


@pytest.mark.parametrize("name", NAMES)
def test_masses(name):
    table = columns(found(name), "masses") if "masses" in answers(name) else {}
    for key, asked in answers(name).get("masses", {}).items():
        of = dict(zip(table["link"], table[key], strict=True))
        assert {link: of[str(link)] for link in asked} == pytest.approx(asked, rel=DIGITS)


@pytest.mark.parametrize("name", NAMES)
def test_positions(name):
    document = found(name)
    there = (one for one in TABLES if one in document["tables"])
    table = {key: column for one in there for key, column in columns(document, one).items()}
    for position, asked in answers(name).get("positions", {}).items():
        assert {key: table[key][position] for key in asked} == pytest.approx(asked, rel=DIGITS)


@pytest.mark.parametrize("name", [name for name in NAMES if "instants" in answers(name)])
def test_instants(name):
    """At times between the positions: angles in degrees, sizes of vectors, moments with their sign."""
    lever = course.solve(course.load(HERE / f"{name}.yaml")).lever
    kinematics, loads = lever.kinematics, lever.kinetostatics.given
    for time, asked in answers(name)["instants"].items():
        turned = np.array([time * abs(kinematics.omega)])
        motion = kinematics.cycle.motion(turned)
        forces = kinetostatics.at(loads, motion, turned, stated(loads, kinematics, motion, turned))
        there = {key: np.abs(x) if np.iscomplexobj(x) else x for key, x in named_values(motion).items()}
        there["phi_1"], there["M_bal"] = np.degrees(motion.phi), forces.balancing
        assert {key: there[key][0] for key in asked} == pytest.approx(asked, rel=DIGITS)
