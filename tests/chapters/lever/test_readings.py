"""A student's own numbers at home: any quantity by positions, with units; a wrong one is named, with its cause."""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from pathlib import Path

import pytest
import yaml
from conftest import read
from notes import VARIANTS, render
from typer.testing import CliRunner

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "page"))
from note import read as page_of

from tmm_report import course, loading
from tmm_report.cli import app
from tmm_report.judging.asked import POSITION
from tmm_report.problems import ProblemError
from tmm_report.results import tables as results_tables

TEXT = (VARIANTS / "compressor.yaml").read_text("utf-8")


def own(readings: dict) -> course.Results:
    """The compressor with these readings, solved."""
    data = yaml.safe_load(TEXT)
    data.pop("drive")
    return course.solve(
        loading.loads(yaml.safe_dump(data | {"readings": readings}, allow_unicode=True), "v.yaml")
    )


def wrong(readings: dict) -> dict[str, str]:
    """Name -> what is said of each wrong one."""
    return {one.written: one.problem.text() for one in own(readings).lever.readings.wrong}


def test_the_guides_numbers_are_right():
    found = course.solve(read("compressor")).lever.readings
    assert sum(map(len, found.rows.values())) == 44 and not found.wrong and not found.causes
    assert found.worst < 0.02


@pytest.mark.parametrize("name", ["compressor", "cam_press", "jaw_crusher"])
def test_the_structure_which_is_not_asked_has_nothing_by_positions(name):
    tables = course.room("structure", "quantities").tables(course.solve(read(name)).lever.structure)
    assert not any(POSITION in table for table in tables)


def test_any_quantity_by_positions_may_be_read_in_any_unit():
    readings = {
        7: {
            "R_12": "5,086 кН",
            "M_bal": 164.3,
            "w_2": "351.3 rpm",
            "S_B": "190.8 mm",
            "F_I2": 1935.5,
            "ω4": 26.52,
        }
    }
    assert wrong(readings) == {}


@pytest.mark.parametrize(
    ("readings", "said"),
    [
        ({"v_B": 4444}, "millimetres given for metres"),
        ({"v_B": -4.444}, "the sign is opposite"),
        ({"w_2": 351.3, "w_4": 253.3}, "rpm given for rad/s"),
        ({"G_2": 1.5}, "mass given for weight"),
        ({"v_B": 5.0}, "differs from the analytical value by 11.8 %"),
        ({"V_B": 4.444}, "the sign is opposite"),
    ],
)
def test_a_wrong_number_is_named_with_its_likely_cause(readings, said):
    found = wrong({7: readings})
    assert set(found) == set(readings) and all(said in text for text in found.values()), found


def test_what_cannot_be_meant_is_refused_all_at_once_with_its_place():
    with pytest.raises(ProblemError) as error:
        own({7: {"v_b": 1, "v_Q": 2, "a_B": "3 mm", "a_D": "many"}})
    told = [problem.text() for problem in error.value.problems]
    assert len(told) == 1 and "a_D" in told[0]  # what cannot be read stops before anything is solved
    with pytest.raises(ProblemError) as error:
        own({7: {"v_b": 1, "v_Q": 2, "a_B": "3 mm"}})
    told = [problem.text() for problem in error.value.problems]
    assert len(told) == 3 and any("write one of V_B, v_B" in text for text in told)


def test_readings_draw_no_plans():
    assert [drawn.position for drawn in own({3: {"v_B": 12.566}}).lever.plans.drawn] == [6, 7]


def test_the_terminal_names_each_with_its_line_and_ends_with_1(tmp_path):
    file = tmp_path / "v.yaml"
    file.write_text(
        TEXT[: TEXT.index("\nreadings:")] + "\nreadings:\n  7: {v_B: 4.444, v_D: 6818}\n", "utf-8"
    )
    line = file.read_text("utf-8").split("\n").index("  7: {v_B: 4.444, v_D: 6818}") + 1
    done = CliRunner().invoke(
        app, ["solve", str(file), "-o", str(tmp_path / "out"), "--format", "json", "--lang", "en"]
    )
    assert done.exit_code == 1
    assert f":{line}:19: readings.7.v_D: differs from the analytical value" in done.output
    assert "millimetres given for metres" in done.output and "readings.7.v_B" not in done.output


@pytest.mark.exhaustive
def test_the_note_has_them_beside_the_plans_without_a_verdict():
    """In the rows of their quantities, with their differences; who is right, `grade` and the terminal say."""
    results = own({7: {"v_B": 4444, "v_D": 6.818}})
    for language in ("en", "ru"):
        note = render(results, "html", language)["note.html"].decode()
        assert "millimetres given for metres" not in note and "миллиметр" not in note
        assert note.count('data-t="readings_7"') == 4  # own value and difference
        rows = [row for row in re.findall(r"<tr>.*?</tr>", note, re.S) if 'data-t="readings_7"' in row]
        keys = [
            set(re.findall(r'data-q="(\w+)" data-k="7" data-t="(?:comparison|readings)_7"', row))
            for row in rows
        ]
        assert keys == [{"v_B"}, {"v_D"}]
    silent = replace(results.lever, readings=None)
    assert "readings_7" not in render(replace(results, lever=silent), "html")["note.html"].decode()


def test_each_row_has_the_number_of_its_own_position_and_their_difference():
    """Against the tables of the analytical method, which know nothing of readings."""
    results = course.solve(read("compressor"))
    tables = {table.name: table for table in results_tables(results)}
    rates, seen = tables["rates_table"], 0
    for k in (6, 7):
        table = tables[f"readings_{k}"]
        rows = zip(*(table[key].values for key in ("key", "graph", "analytic", "delta")), strict=True)
        for key, graph, analytic, delta in rows:
            assert analytic == pytest.approx(abs(float(rates[key].values[k])), rel=1e-12, abs=1e-9), (key, k)
            assert graph == abs(results.variant.lever.readings[k][key][0])
            if delta == delta:
                assert delta == pytest.approx(
                    200 * (graph - analytic) / (graph + analytic), rel=1e-6, abs=1e-9
                )
                seen += 1
    assert seen >= 34


@pytest.mark.exhaustive
def test_what_the_plans_are_compared_in_is_not_printed_again():
    """Values of the plans in their comparison, in its order; others with the analytical ones beside them."""
    results = own({7: {"w_2": 36.79, "M_bal": 164.3, "v_B": 4.444}, 3: {"v_B": 12.566}})
    note = render(results, "html", "en")["note.html"].decode()
    marks = [
        mark
        for mark in re.findall(r'data-q="(\w+)" data-k="(\d)" data-t="readings_\d" data-by="(\w+)"', note)
        if mark[2] != "delta"
    ]
    assert marks == [
        ("v_B", "7", "graph"), ("w_2", "7", "graph"), ("v_B", "3", "graph"), ("v_B", "3", "analytic"),
        ("M_bal", "7", "graph"), ("M_bal", "7", "analytic"),
    ]  # fmt: skip


@pytest.mark.exhaustive
def test_each_own_value_has_its_own_difference_and_the_others_a_dash():
    results = own({7: {"w_2": 36.79, "v_B": 5.0, "v_A": 12.566}})
    note = render(results, "html", "en")["note.html"].decode()
    table = next(
        one for one in page_of(note).tables if one.caption.endswith("Comparison of the methods, position 7")
    )
    said = {row[2].mark.key: (row[-2].text, row[-1].text) for row in table.rows}
    values = results.lever.kinematics.values
    for key, own_value in (("w_2", 36.79), ("v_B", 5.0), ("v_A", 12.566)):
        right = abs(values[key][7])
        difference = 200 * (own_value - right) / (own_value + right)
        assert float(said[key][0]) == own_value
        assert float(said[key][1].replace("−", "-")) == pytest.approx(difference, abs=0.0051)
    assert {key for key, cells in said.items() if cells == ("—", "—")} == set(said) - {"w_2", "v_B", "v_A"}


@pytest.mark.parametrize("name", ["ω2", "w_2", "omega_2", "w2"])
def test_an_angular_velocity_by_its_symbol_is_that_of_the_plans(name):
    """Not that of the diagrams of links, in which a number without its sign is wrong."""
    assert wrong({7: {name: 36.79}}) == {}


def test_a_number_without_its_sign_is_right_in_magnitude_and_said_to_be_no_more():
    found = own({7: {"w_2": 36.79, "w_4": 26.52, "v_B": 4.444}}).lever
    values = found.kinematics.values
    negative = {key for key in ("w_2", "w_4") if values[key][7] < 0}
    assert negative and {one.written for one in found.readings.unsigned} == negative


def test_readings_of_a_mechanism_with_wheels():
    """The wheels' own columns are among what may be read; a ratio upside down is told."""
    text = (VARIANTS.parent / "tests" / "statements" / "geared_five_bar.yaml").read_text("utf-8")
    lever = course.solve(loading.loads(text)).lever
    found = {column.key: column.values[7] for table in results_tables(course.solve(loading.loads(text)))
             for column in table.columns if column.key in ("F_n_12", "R_12", "w_2", "M_bal")
             and len(column.values) == 13}  # fmt: skip
    assert found["w_2"] == pytest.approx(-2 * lever.kinematics.omega)
    right = "".join(f", {key}: {value:.6g}" for key, value in found.items()).removeprefix(", ")
    own = course.solve(loading.loads(f"{text}\nreadings: {{7: {{{right}}}}}\n")).lever.readings
    assert len(own.rows[7]) == 4 and not own.wrong
    other = course.solve(
        loading.loads(f"{text}\nreadings: {{7: {{w_2: {found['w_2'] / 4:.6g}}}}}\n")
    ).lever.readings
    assert [one.written for one in other.wrong] == ["w_2"]
