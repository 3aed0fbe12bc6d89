"""Assignments typed as their collections print them: the answers come out to the digits of independent solvers."""

import json
from functools import cache
from pathlib import Path

import pytest
import yaml

from tmm_report import loading, render, solve

HERE = Path(__file__).parent
NAMES = sorted(path.name.removesuffix(".answers.yaml") for path in HERE.glob("*.answers.yaml"))
DIGITS = 1e-9
TABLES = (
    "positions_table",
    "outputs_table",
    "rates_table",
    "loads_table",
    "ties_table",
    "reactions_table",
    "balancing_table",
    "stroke_table",
    "drive_table",
    "mesh_table",
    "rolling_table",
    "cam_motion_k_table",
    "cam_profile_k",
    "drive_stages",
    "drive_sought",
    "drive_shafts",
    "stage1_quality",
    "stage1_wheels",
    "stage1_inspection",
    "stage1_limits",
    "cam_motion_table",
    "cam_profile",
)


@cache
def found(name: str) -> dict:
    variant = loading.load(HERE / f"{name}.yaml")
    return json.loads(render(solve(variant), "json")["results.json"])


@cache
def answers(name: str) -> dict:
    return yaml.load((HERE / f"{name}.answers.yaml").read_text("utf-8"), yaml.CSafeLoader)


def columns(document: dict, table: str) -> dict[str, list]:
    return {column["key"]: column["values"] for column in document["tables"][table]["columns"]}


@pytest.mark.parametrize("name", NAMES)
def test_single_numbers(name):
    values = {one["key"]: one["value"] for one in found(name)["values"]}
    asked = answers(name)["values"]
    assert {key: values[key] for key in asked} == pytest.approx(asked, rel=DIGITS)


ANGLE = 1e-5  # degrees: an extreme is flat, so that its angle is found to half of its digits


@pytest.mark.parametrize("name", [name for name in NAMES if "at_deg" in answers(name)])
def test_angles_at_which_they_are_reached(name):
    angles = {one["key"]: one["at_deg"] for one in found(name)["values"] if "at_deg" in one}
    asked = answers(name)["at_deg"]
    assert {key: angles[key] for key in asked} == pytest.approx(asked, abs=ANGLE)


@pytest.mark.parametrize("name", [name for name in NAMES if "columns" in answers(name)])
def test_whole_columns(name):
    for table, asked in answers(name)["columns"].items():
        of = columns(found(name), table)
        for key, numbers in asked.items():
            assert of[key] == pytest.approx(numbers, rel=DIGITS, abs=1e-15), (table, key)


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
    """Numbers at the times or angles that the statement asks for, between the positions."""
    document = found(name)
    there = [one for one in document["tables"] if one.endswith("_at")]
    table = {key: column for one in there for key, column in columns(document, one).items()}
    for row, (instant, asked) in enumerate(answers(name)["instants"].items()):
        assert table["t" if name in BY_TIME else "phi"][row] == pytest.approx(float(instant))
        assert {key: table[key][row] for key in asked} == pytest.approx(asked, rel=DIGITS)


@pytest.mark.parametrize("name", [name for name in NAMES if "rows" in answers(name)])
def test_rows(name):
    """Numbers of tables whose rows have names: of a member, of a mesh."""
    document = found(name)
    for table, named in answers(name)["rows"].items():
        ((key, rows),) = named.items()
        there = columns(document, table)
        for row, asked in rows.items():
            of = there[key].index(row)
            assert {column: there[column][of] for column in asked} == pytest.approx(asked, rel=DIGITS)


BY_TIME = (
    "uneven_crank", "slider_drives", "tipper_by_cylinder", "excavator_bucket", "four_bar_run_up",
    "shears_by_polynomial", "slotted_link_by_table",
)  # fmt: skip
