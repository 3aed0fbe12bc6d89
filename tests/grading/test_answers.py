"""A student's files as numbers: names, units and signs as people write them, in three formats; what is odd is noted."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from conftest import solved
from notes import VARIANTS

from tmm_report.grading.expected import expected, reversed_reactions
from tmm_report.grading.handed_in.answers import NOTES, read
from tmm_report.grading.rubric import Rubric
from tmm_report.intake.writing import csv_bytes, xlsx_bytes


@pytest.fixture(scope="module")
def asked():
    return expected(solved("compressor"))


def answers(text: str | bytes, asked, name: str = "ivanov.yaml"):
    content = text.encode() if isinstance(text, str) else text
    return read([(name, content)], "ivanov", asked, reversed_reactions(solved("compressor")))


def number(found, key: str, row: int = 7, table: str = "rates_table") -> float:
    return float(found.columns[table, key].values[row])


@pytest.mark.parametrize(
    "line",
    ["7: {v_B: 4.444}", "7: {vB: 4.444}", "7: {v_B: '4,444 м/с'}", "7: {v_B: 444.4 cm/s}", "v_B: {7: 4.444}",
     "rates_table: {7: {v_B: 4.444}}", "rates_table: {v_B: {7: 4.444}}", "v_B: [~, ~, ~, ~, ~, ~, ~, 4.444]",
     "7: {v_B: 4444}\nunits: {v_B: mm/s}", "'7': {v_B: '4.444'}", "7: {'v_{B}': 4.444}"],
)  # fmt: skip
def test_one_answer_may_be_written_in_many_ways(line, asked):
    found = answers(line, asked)
    assert number(found, "v_B") == pytest.approx(4.444) and not found.notes
    assert np.isnan(number(found, "v_B", 6)) and not found.columns["rates_table", "v_B"].given[6]


@pytest.mark.parametrize(("name", "key"), [("ω2", "w_2"), ("w2", "w_2"), ("ε_4", "e_4"), ("omega_2", "w_2")])
def test_a_symbol_names_its_quantity(name, key, asked):
    assert number(answers(f"7: {{{name}: 1}}", asked), key) == 1


def test_the_reaction_turned_round_is_the_same_reaction(asked):
    found = answers("7: {R_54: 278.55, R42: 2003}", asked)
    assert number(found, "R_45", table="reactions_table") == 278.55
    assert number(found, "R_24", table="reactions_table") == 2003


def test_rpm_are_turned_into_radians_and_wrong_units_are_noted(asked):
    found = answers("7: {w_2: 351.3 об/мин, v_B: 4.4 mm, a_B: 1089 furlongs}", asked)
    assert number(found, "w_2") == pytest.approx(36.788, abs=1e-3)
    assert number(found, "v_B") == 4.4
    assert [note.key or str(note.wrong).split(":")[0] for note in found.notes] == ["v_B", "a_B"]


ROWS = [
    ["position", "v_B, м/с", "w_2 (rad/s)", "R_54, kN"],
    [6, 0, -41.887, None],
    [7, "4,444", "−36,790", 0.27855],
]


@pytest.mark.parametrize("kind", ["csv", "csv with a decimal comma", "xlsx"])
def test_sheets_say_what_yaml_says(kind, asked):
    content = (
        xlsx_bytes({"speeds": ROWS}) if kind == "xlsx" else csv_bytes(ROWS, "," if "comma" in kind else ".")
    )
    found = answers(content, asked, f"ivanov.{kind[:4].strip()}")
    assert number(found, "v_B") == 4.444 and number(found, "v_B", 6) == 0
    assert number(found, "w_2") == -36.79
    assert number(found, "R_45", table="reactions_table") == pytest.approx(278.55)
    assert np.isnan(number(found, "R_45", 6, "reactions_table")) and not found.notes


def test_a_sheet_of_single_numbers_has_a_line_a_quantity(asked):
    rows = [
        ["величина", "значение", "ед."],
        ["H_B", 200, "мм"],
        ["mu_v", "0,075", ""],
        ["drive_u", -13.2, ""],
    ]
    found = answers(csv_bytes(rows, ","), asked, "ivanov.csv")
    assert number(found, "H_B", 0, "") == pytest.approx(0.2)
    assert number(found, "drive_u", 0, "") == -13.2 and found.scales == {"mu_v": 0.075}


def test_wheels_are_rows_of_their_table(asked):
    found = answers('stage2_wheels: {"4": {z: 14, d: 84 mm}, "5": {z: 28}}', asked)
    assert found.columns["stage2_wheels", "z"].values.tolist() == [14, 28]
    assert number(found, "d", 0, "stage2_wheels") == pytest.approx(0.084)


def test_what_is_odd_is_noted_with_its_place_and_the_rest_is_read(asked):
    text = "7:\n  v_B: 4.444\n  v_Q: 1\n  w_2: about 36\n  v_D: 6.8\n99: {v_B: 1}\nv_C: {7: [1]}\n"
    found = answers(text, asked)
    told = [(note.line, str(note.wrong)) for note in found.notes]
    assert [line for line, _ in told] == [7, 3, 4, 6]
    assert "v_Q is not asked" in told[1][1] and "about 36 is not a number" in told[2][1]
    assert "no row 99" in told[3][1]
    assert number(found, "v_B") == 4.444 and number(found, "v_D") == 6.8
    assert np.isnan(number(found, "w_2")) and found.columns["rates_table", "w_2"].given[7]


def test_of_an_answer_given_twice_the_first_counts(asked):
    found = answers("7: {v_B: 1}\nrates_table: {7: {v_B: 2}}\n", asked)
    assert number(found, "v_B") == 1 and "twice" in str(found.notes[0].wrong)


def test_a_file_that_cannot_be_read_is_noted_and_the_others_count(asked):
    files = [("a.yaml", b"7: [v_B"), ("b.csv", csv_bytes(ROWS, ".")), ("c.yaml", b"- 1")]
    found = read(files, "ivanov", asked, reversed_reactions(solved("compressor")))
    assert number(found, "v_B") == 4.444
    assert {note.file for note in found.notes} == {"a.yaml", "c.yaml"}


@pytest.mark.exhaustive
def test_thousands_of_wrong_lines_are_counted_not_told(asked):
    rows = [["key", "value"], *([f"nothing{k}", k] for k in range(500))]
    found = answers(csv_bytes(rows, "."), asked, "ivanov.csv")
    assert len(found.notes) == NOTES + 1 and not found.columns


@pytest.mark.parametrize("value", [".nan", ".inf", "-.inf", "1e999", "0x7", "1:30", "=1+1", "'; DROP TABLE'"])
def test_what_is_no_number_is_no_answer(value, asked):
    found = answers(f"7: {{v_B: {value}}}", asked)
    assert np.isnan(number(found, "v_B")) and found.notes


@pytest.mark.parametrize("scale", ["0", "-1", "1e12", ".nan", "x"])
def test_a_scale_that_is_none_is_noted(scale, asked):
    found = answers(f"scales: {{mu_v: {scale}}}", asked)
    assert not found.scales and len(found.notes) == 1


HOSTILE = """
import random, resource, sys
from tmm_report import load, solve
from tmm_report.grading.handed_in.answers import NOTES, read
from tmm_report.grading.expected import expected
from tmm_report.intake.writing import csv_bytes, xlsx_bytes

asked = expected(solve(load(sys.argv[1])))
of = random.Random(1)
keys = [key for _, key in asked]
def near():
    return of.choice(keys) + "".join(of.choices("abωφ₁²", k=3))
def sheet(width, rows):
    return [["k", *(near() for _ in range(width))], *[["1", *["1"] * width]] * rows]
def nonsense():
    return [["k", *("".join(of.choices("abωφ₁²vBd", k=60)) for _ in range(119))], [1] * 120]
files = {
    "near.xlsx": xlsx_bytes({f"s{n}": sheet(119, 1) for n in range(15)}),
    "far.xlsx": xlsx_bytes({f"s{n}": nonsense() for n in range(15)}),
    "short.xlsx": xlsx_bytes({f"s{n}": [["k", *map(str, range(119))], *[["1"]] * 990] for n in range(5)}),
    "keys.csv": csv_bytes([["key", "value", "unit"], *[[near() * 9, 1, near() * 9] for _ in range(600)]], "."),
    "rows.yaml": ("v_B: {" + ", ".join(f"{near()}: 1" for _ in range(2500)) + "}").encode(),
}
with open("/proc/self/statm") as stream:
    own = int(stream.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (own + 300 * 2**20,) * 2)
for name, content in files.items():
    begun = int(resource.getrusage(resource.RUSAGE_SELF).ru_utime)
    most = resource.getrlimit(resource.RLIMIT_CPU)[1]
    resource.setrlimit(resource.RLIMIT_CPU, (begun + 15, most))  # a machine with others on it is slow
    found = read([(name, content)], "ivanov", asked)
    assert len(found.notes) <= NOTES + 1
    print(name)
"""


@pytest.mark.exhaustive
@pytest.mark.skipif(sys.platform != "linux", reason="limits of a process as Linux has them")
def test_thousands_of_names_that_nobody_asked_for_cost_neither_memory_nor_time():
    done = subprocess.run(
        [sys.executable, "-X", "utf8", "-c", HOSTILE, str(VARIANTS / "compressor.yaml")],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    assert done.stdout.split() == ["near.xlsx", "far.xlsx", "short.xlsx", "keys.csv", "rows.yaml"]


# ---------------------------------------------------------------- sheets as courses and people lay them out

LAID = {
    "a title above": "Вариант 7, группа М-21;;\nposition;v_B;w_2\n6;0;-41,9\n7;4,444;-36,8\n",
    "positions from 01": "position;v_B;w_2\n06;0;-41,9\n07;4,444;-36,8\n",
    "words before the number": "Положение;v_B;w_2\nпол. 6;0;-41,9\n№ 7;4,444;-36,8\n",
    "a quantity a line": "Положение;6;7;8\nv_B, м/с;0;4,444;1\nω2, 1/с;-41,9;-36,8;2\n",
    "units under the head": "position;v_B;w_2\n;мм/с;1/с\n6;0;-41,9\n7;4444;-36,8\n",
    "a title above commas": "Вариант 7\nposition,v_B,w_2\n6,0,-41.9\n7,4.444,-36.8\n",
    "a comma in the title above commas": "Курсовая, вариант 7\nposition,v_B,w_2\n6,0,-41.9\n7,4.444,-36.8\n",
    "commas in the title above semicolons": "Курсовая, вариант 7, М-21\nposition;v_B;w_2\n6;0;-41,9\n7;4,444;-36,8\n",
    "whose it is in two cells": "Студент;Иванов И. И.\nГруппа;М-21\n\nposition;v_B;w_2\n6;0;-41,9\n7;4,444;-36,8\n",
    "a quantity a line under a title": "Таблица 1. Лист\nВеличина;6;7;8\nv_B, м/с;0;4,444;1\nω2, 1/с;-41,9;-36,8;2\n",
    "a quantity a line, commas": 'Таблица\nВеличина,6,7,8\n"v_B, м/с",0,4.444,1\n"ω2, 1/с",-41.9,-36.8,2\n',
    "a quantity a line, units beside": "Величина;Ед. изм.;6;7;8\nv_B;мм/с;0;4444;1\nω2;1/с;-41,9;-36,8;2\n",
    "a quantity a line, nothing above them": "Лист 1\n;6;7;8\nv_B;0;4,444;1\nω2;-41,9;-36,8;2\n",
    "a quantity a line, words": "Величина;пол. 6;пол. 7;№ 8\nv_B мм/с;0;4444;1\nω2;-41,9;-36,8;2\n",
    "a row of units with its name": "position;v_B;w_2\nЕд. изм.;мм/с;с^-1\n6;0;-41,9\n7;4444;-36,8\n",
    "units in the cells": "position;v_B;w_2\n6;0;−41,9 1/с\n7;4444 мм/с;−36,8 с⁻¹\n",
    "units in the cells, parted": "position;v_B;w_2\n6;0;−41,9 рад / с\n7;4444 мм / сек;-2,108484686E3 °/с\n",
    "units behind the names": "position;v_B мм/с;w_2 / (1/с)\n6;0;-41,9\n7;4444;-36,8\n",
    "a name before the position": "ФИО;№ положения;v_B;w_2\nИванов;6;0;-41,9\nИванов;7;4,444;-36,8\n",
}


@pytest.mark.parametrize("text", LAID.values(), ids=LAID)
def test_a_table_may_be_laid_out_in_many_ways(text, asked):
    found = answers(text, asked, "a.csv")
    assert number(found, "v_B") == pytest.approx(4.444) and number(found, "w_2") == pytest.approx(-36.8)
    assert not [note for note in found.notes if note.key or "row" in str(note.wrong)]


@pytest.mark.parametrize("text", ["М.ур, Н м", "M_bal (Н.м)", "M_bal [кгс·м]", "M_bal, кН·м", "M_bal, кНм"])
def test_a_moment_is_one_in_any_spelling(text, asked):
    number_ = {"кгс·м": 164.27 / 9.80665, "кН·м": 0.16427, "кНм": 0.16427}
    value = next((value for unit, value in number_.items() if unit in text), 164.27)
    head = text.replace("М.ур", "M_bal")
    found = answers(f"position;{head};v_B\n7;{value!r};1\n", asked, "a.csv")
    assert (
        number(found, "M_bal", 7, "balancing_table") == pytest.approx(164.27, rel=1e-12) and not found.notes
    )


@pytest.mark.parametrize("text", ["12 или 13", "4,4 да нет", "4 4 4", "1/2", "=1+1 м"])
def test_words_behind_a_number_make_it_none(text, asked):
    found = answers(f"position;v_B\n7;{text}\n", asked, "a.csv")
    assert np.isnan(number(found, "v_B"))


def test_of_two_columns_of_one_name_that_which_counts_is_meant(asked):
    """z of the wheels, and of the list of speeds, which a sheet of both names alike."""
    text = "row,z\n1,20\n2,30\n3,40\n"
    found = read([("all.csv", text.encode())], "x", asked, (), Rubric().asks)
    assert ("stage1_wheels", "z") in found.columns and ("drive_speeds", "z") not in found.columns


def test_n_is_a_speed_and_no_head_of_positions(asked):
    found = answers("row,z,n\n1,20,3000\n", asked, "drive_speeds.csv")
    assert number(found, "n", 0, "drive_speeds") == 3000 and not found.notes
