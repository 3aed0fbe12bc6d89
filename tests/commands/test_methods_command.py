"""`tmm-report methods`: every method is run, refused in words or told to have failed, and the cheapest is named."""

from __future__ import annotations

import csv
import io
import json
import re
from functools import cache
from pathlib import Path

import pytest
from conftest import read
from notes import VARIANTS
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.mechanics.rivals.motion.every import MOTIONS

STATEMENTS = Path(__file__).parents[1] / "statements"
ENVIRONMENT = {"LANG": "C", "LC_ALL": "C"}


def run(*arguments: object):
    return CliRunner().invoke(app, ["methods", *map(str, arguments)], env=ENVIRONMENT)


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Files of the crank-rocker, and what was said."""
    folder = tmp_path_factory.mktemp("methods")
    variant = VARIANTS / "crank_rocker.yaml"
    done = run(
        variant, "-o", folder, "--quick", "--lang", "en", "--format", "html,json,csv", "--accuracy", "1e-4"
    )
    assert done.exit_code == 0, done.output
    return {path.name: path.read_text("utf-8") for path in folder.glob("methods.*")}, done.output


@cache
def data(text: str):
    return json.loads(text)


def errors(made, method: str, family: str = "motion") -> dict[int, dict[str, float]]:
    rows = data(made[0]["methods.json"])["trials"]
    return {row["count"]: row["errors"] for row in rows if (row["family"], row["method"]) == (family, method)}


@pytest.mark.exhaustive
def test_every_method_is_either_run_or_refused(made):
    found = data(made[0]["methods.json"])
    ran = {row["method"] for row in found["trials"] if row["family"] == "motion"}
    assert ran | set(found["refused"]["motion"]) == {method.key for method in MOTIONS}
    assert (
        "parallelogram" in found["refused"]["motion"]
        and "refused: closed form of the parallelogram" in made[1]
    )


@pytest.mark.exhaustive
def test_the_closed_form_is_right_to_rounding_against_forty_digits(made):
    for count, own in errors(made, "groups").items():
        assert max(own.values()) < 1e-14, count
    assert max(errors(made, "groups", "forces")[36].values()) < 1e-13


@pytest.mark.exhaustive
def test_differences_err_as_their_order_says(made):
    """Three times as many positions: a ninth of the error."""
    by_count = errors(made, "differences")
    for kind in ("velocity", "acceleration"):
        assert 6 < by_count[12][kind] / by_count[36][kind] < 13
    assert by_count[12]["place"] < 1e-14


@pytest.mark.exhaustive
def test_the_cheapest_holds_the_accuracy_that_was_asked(made):
    found = data(made[0]["methods.json"])
    assert found["accuracy"] == 1e-4
    best = found["cheapest"]["motion"]
    assert max(max(errors(made, best)[count].values()) for count in (12, 36)) <= 1e-4
    assert re.search(
        r"The cheapest that holds the relative error (0.0001|1·10⁻⁴): .* ms, its error is", made[1]
    )
    assert "method: auto takes" in made[1]


@pytest.mark.exhaustive
def test_the_page_has_a_chart_for_each_quantity_and_nothing_from_elsewhere(made):
    page = made[0]["methods.html"]
    assert page.count("<svg") == 3 + 2 + 1 + 1  # motion, forces, work, numbers of positions
    assert not re.search(r"""(src|href)=["'](?!#)""", page)
    assert "<script" not in page


@pytest.mark.exhaustive
def test_the_table_has_a_row_for_each_error(made):
    rows = list(csv.DictReader(io.StringIO(made[0]["methods.csv"])))
    trials = data(made[0]["methods.json"])["trials"]
    assert len(rows) == sum(max(1, len(row["errors"])) for row in trials)
    assert {row["quantity"] for row in rows} == {
        "place", "velocity", "acceleration", "reaction", "moment", "work",
    }  # fmt: skip


@pytest.mark.exhaustive
def test_the_numbers_of_positions_are_recommended_by_the_accuracy(made):
    positions = data(made[0]["methods.json"])["positions"]
    assert positions["accuracy"] == 1e-4 and positions["counts"] == [12, 24, 36, 72, 100]


def test_gears_alone_have_their_involutes_compared(tmp_path):
    done = run(VARIANTS / "hoist_drive.yaml", "-o", tmp_path, "--quick", "--lang", "en", "--format", "json")
    assert done.exit_code == 0, done.output
    found = json.loads((tmp_path / "methods.json").read_text())
    own = [row for row in found["trials"] if row["method"] == "series_and_halley"]
    assert {row["family"] for row in found["trials"]} == {"involute"}
    assert all(row["errors"]["angle"] < 1e-15 for row in own) and found["positions"] is None


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--accuracy", "2"), "--accuracy: 2 is out of range; a relative error from 1e-15 to 0.5"),
        (("--accuracy", "good"), "--accuracy"),
        (("--format", "pdf"), "--format: unknown pdf; known: html, json, csv"),
        (("--lang", "xx"), "--lang"),
    ],
)
def test_a_wrong_option_is_told_and_nothing_is_written(arguments, said, tmp_path):
    done = run(VARIANTS / "crank_rocker.yaml", "-o", tmp_path / "m", *arguments)
    assert done.exit_code == 2 and said in done.output
    assert not (tmp_path / "m").exists()


def test_a_variant_without_rivals_is_told_so(tmp_path):
    done = run(VARIANTS / "rotor.yaml", "-o", tmp_path / "m", "--lang", "en")
    assert done.exit_code == 2 and "the variant has nothing that several methods find" in done.output


def test_a_mistake_of_the_variant_has_its_line(tmp_path):
    file = tmp_path / "bad.yaml"
    file.write_text((VARIANTS / "crank_rocker.yaml").read_text("utf-8") + "\nmethod: newtom\n", "utf-8")
    done = run(file, "-o", tmp_path / "m", "--lang", "en")
    last = file.read_text("utf-8").count("\n")
    assert done.exit_code == 2
    assert f"{last}:" in done.output and "newtom is no method; did you mean newton?" in done.output


def test_what_is_stated_of_methods_does_not_change_what_is_compared():
    """The closed form is measured even where the variant takes another method."""
    assert read("grain_screen").lever.way is not None


@pytest.mark.parametrize("name", ["rocker_by_law", "slider_drives"])
def test_a_law_of_the_driving_link_is_refused_in_words(name):
    done = run(STATEMENTS / f"{name}.yaml", "--lang", "en")
    assert (
        done.exit_code == 2
        and "uniformly turning driving link" in done.output
        and "mechanism.driver" in done.output
    )
