"""`explain`: what leads to a number, in the order of the note, and the number itself at the end."""

from __future__ import annotations

import re
from functools import cache, lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from batching import COMPRESSOR
from conftest import ALL_FILES, FILES, read, solved
from exhaustive import many
from told import Told

from tmm_report.commands.explain import target as explain_target
from tmm_report.commands.explain.derivation import Walk, derive
from tmm_report.commands.explain.listen import listen
from tmm_report.commands.explain.run import run, starts, written_out
from tmm_report.commands.explain.target import find
from tmm_report.commands.explain.text import lines
from tmm_report.commands.explain.way import Ways
from tmm_report.course import solve
from tmm_report.i18n import Translator
from tmm_report.note import parts
from tmm_report.problems import ProblemError
from tmm_report.quantity.formula import PI, Formula, Var
from tmm_report.report.plain import text
from tmm_report.results import tables, values

VARIANTS = Path(__file__).parents[2] / "variants"
ASKED = ("rates_table", "reactions_table", "balancing_table")
MARKUP = re.compile(r"[<>{}\\$&]|data-")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@cache
def told(name, quantity, position=None, language="en"):
    """What is said; of the compressor without its gears and flywheel, which nothing here asks for."""
    talk = Told()
    with TemporaryDirectory() as folder:
        file = VARIANTS / f"{name}.yaml"
        if name == "compressor":
            file = Path(folder) / file.name
            file.write_text(COMPRESSOR, "utf-8")
        run(file, quantity, position, language, talk)
    return talk.lines


def number_of(line):
    """The number behind the last sign of equality: −4,4437; 1,35·10⁻⁵; a dash is nan."""
    said = line.rsplit(" = ", 1)[1].split(" ")[0].rstrip("°%").replace(",", ".").replace("−", "-")
    size, _, power = said.partition("·10")
    return float("nan") if size == "—" else float(size) * 10.0 ** int(power.translate(_RAISED) or 0)


@pytest.fixture(autouse=True, scope="module")
def tables_once():
    """Hundreds of numbers of one variant are asked for, whose tables are the same for all."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(explain_target, "tables", lru_cache(4)(lambda results: list(tables(results))))
        yield


@cache
def heard(name, position, language):
    """The note in which one position is written out, and the results."""
    results = solve(written_out(read(name), position))
    tr = Translator(language)
    return results, Walk(listen(lambda page: list(parts(results, page)), results.variant.title, tr))


@cache
def asked(name, quantity, position):
    return find(heard(name, 2 if position is None else position, "ru")[0], quantity, position)


@lru_cache(4)
def ways(name, position):
    return Ways.of(heard(name, position, "ru")[0])


def explained(name, quantity, position, language):
    _, walk = heard(name, 2 if position is None else position, language)
    target = asked(name, quantity, position)
    way = ways(name, 2 if position is None else position).told(target)
    told = lines(target, walk.heard, derive(walk, starts(target)), way, False, Translator(language))
    return target, list(told)


# ---------------------------------------------------------------- every variant


IN_BOTH = ("compressor", "whitworth")


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("name", "language"),
    [(file.stem, "ru") for file in FILES] + many([(name, "en") for name in IN_BOTH]),
)
def test_every_velocity_reaction_and_moment_ends_in_its_number(name, language):
    position = 2
    results, _ = heard(name, position, "ru")
    for table in (table for table in tables(results) if table.name in ASKED):
        for column in table.columns[2:]:
            target, said = explained(name, f"{table.name}.{column.key}", position, language)
            assert target.quantity.key == column.key
            right, largest = column.values[position], np.nanmax(np.abs(column.values), initial=0.0)
            at = said.index(Translator(language).gettext("Value in the results:"))
            shown = number_of(said[at + 1])
            assert shown == pytest.approx(right, rel=6e-5, abs=1e-9 * largest, nan_ok=True), column.key
            assert not any(MARKUP.search(line) for line in said)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [file.stem for file in ALL_FILES])
def test_every_single_number_is_explained(name):
    results, _ = heard(name, 2, "ru")
    for value in values(results):
        target, told = explained(name, value.key, None, "ru")
        assert not any(MARKUP.search(line) for line in told)
        at = told.index(Translator("ru").gettext("Value in the results:"))
        assert number_of(told[at + 1]) == pytest.approx(target.value, rel=6e-5, nan_ok=True), value.key


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [file.stem for file in ALL_FILES])
def test_every_formula_of_a_note_is_plain_text_that_ends_in_its_value(name):
    _, walk = heard(name, 2, "ru")
    for spoken in walk.heard.formulas:
        line = text(spoken.item, Translator("ru"))
        assert not MARKUP.search(line) and "  " not in line
        assert line.count("(") == line.count(")")
        if isinstance(spoken.item, Formula) and " = " in line:
            expected = spoken.item.written
            shown = number_of(line)
            shown = np.radians(shown) if spoken.item.unit == "deg" else shown
            assert shown == pytest.approx(expected, rel=6e-5, abs=1e-9, nan_ok=True), line


# ---------------------------------------------------------------- what leads to what


def test_the_way_to_a_velocity_goes_from_the_crank_through_the_vector_equation():
    said = told("compressor", "v_B", 7)
    formulas = [line.strip().split(" ", 1)[1] for line in said if line.startswith("  (")]
    assert [line.split(" – ")[0] for line in formulas] == [
        "v_A = ω_1·l_OA = 125.66·0.1 = 12.566 m/s",
        "pa = ω_1·l_OA/μ_v = 125.66·0.1/0.075 = 167.55 mm",
        "v_B (∥x) = v_A + v_BA (⟂AB)",
        "v_B = pb·μ_v = 59.25·0.075 = 4.444 m/s",
    ]
    assert "4.3 Velocity polygon, position 7" in said
    assert "  v_B = 4.4437 m/s" in said
    assert "  l_OA = 0.1 m – length of segment OA" in said


def test_nothing_of_another_position_or_another_group_gets_in():
    said = "\n".join(told("compressor", "v_B", 7))
    assert "position 6" not in said and "v_D" not in said and "v_S2" not in said


def test_an_acceleration_stands_upon_its_normal_part_and_that_upon_the_velocity():
    said = "\n".join(told("compressor", "a_B", 7))
    order = [
        "v_A = ",
        "v_BA = ",
        "a_A = ",
        "a_B (∥x) = a_A + a_BA^n (∥BA) + a_BA^t (⟂AB)",
        "a_BA^n = v_BA²/l_AB",
        "a_B = ",
    ]
    places = [said.index(text) for text in order]
    assert places == sorted(places)


@pytest.mark.exhaustive
def test_the_moment_stands_upon_the_reactions_turned_round_and_the_inertia_forces():
    said = "\n".join(told("compressor", "M_ур", 7))
    for formula in ("F_I2 = m_2·a_S2", "R_24 = ", "R_12 = ", "M_bal = −R_21·h_R21", "m_2 = 1.5 kg"):
        assert formula in said
    assert "R_03 = L_R03" not in said


@pytest.mark.exhaustive
def test_the_equations_of_a_class_iv_group_are_told_together():
    said = "\n".join(told("press", "R35", 5))
    assert "R_23 + G_3 + F_I3 − R_35 = 0" in said and "R_35 = L_R35·μ_F" in said


@pytest.mark.exhaustive
def test_a_position_that_the_note_does_not_write_out_is_written_out():
    said = told("compressor", "v_B", 3)
    assert any(line.startswith("The note of the variant writes other positions out") for line in said)
    assert any(line.startswith("  v_B = pb·μ_v") for line in said)
    assert not any(line.startswith("  (") for line in said)


@pytest.mark.exhaustive
def test_a_component_is_explained_by_its_vector_and_an_output_by_its_point():
    assert any("v_B = pb·μ_v" in line for line in told("compressor", "v_B_x", 7))
    assert any("v_B = pb·μ_v" in line for line in told("compressor", "V_B", 7))
    assert "  V_B = −4.4437 m/s" in told("compressor", "V_B", 7)


@pytest.mark.exhaustive
def test_the_diameters_of_a_stage_are_told_wheel_by_wheel():
    said = told("hoist_drive", "stage1_wheels.d_w")
    assert "  1: d_w1 = 0.070988 m" in said and "  2: d_w2 = 0.17901 m" in said
    assert any("d_w1 = d_b1/cos(α_w)" in line for line in said)


@pytest.mark.exhaustive
def test_what_the_note_only_approaches_by_plans_is_said_to_be_found_analytically():
    assert any(line.startswith("Found analytically") for line in told("compressor", "v_B", 7))
    assert not any(line.startswith("Found ") for line in told("compressor", "eta", 7))
    assert any(line.startswith("  P_fr = P_fr,O + ") for line in told("compressor", "P_fr", 7))


def test_what_is_read_in_the_note_is_found_there():
    (line,) = [line for line in told("compressor", "v_B", 7) if line.startswith("In the note")]
    assert line.endswith("in results.json: tables.rates_table.v_B.") and re.search(r"tables \d+", line)


@pytest.mark.exhaustive
def test_the_language_and_its_decimal_sign_are_those_asked_for():
    assert any("4,444 м/с" in line for line in told("compressor", "v_B", 7, "ru"))
    assert any("M_ур = " in line for line in told("compressor", "M_bal", 7, "ru"))


@pytest.mark.parametrize(
    ("quantity", "position", "said"),
    [
        ("v_B", 13, "there is no position 13: the table has positions 0 to 12"),
        ("v_B", -1, "there is no position -1: the table has positions 0 to 12"),
        ("v_B", None, "v_B is found at positions: state which one; from 0 to 12"),
        ("H_B", 3, "H_B is one number for all positions; leave the position out"),
        ("v_Q", 3, "no quantity is called v_Q; the nearest: "),
        ("nowhere.v_B", 3, "the results have no table nowhere"),
        ("<b>\u202e", 3, "no quantity is called <b>\N{REPLACEMENT CHARACTER}"),
    ],
)
def test_what_cannot_be_explained_is_said_so(quantity, position, said):
    with pytest.raises(ProblemError) as caught:
        find(solved("compressor"), quantity, position)
    assert said in caught.value.problems[0].text()


@pytest.mark.exhaustive
def test_a_position_without_gears_positions_is_refused():
    with pytest.raises(ProblemError, match="leave the position out"):
        find(solved("eccentric"), "eccentric_e", 1)


@pytest.mark.exhaustive
def test_at_a_position_without_a_number_it_is_said_so():
    name, table, key, row = next(missing())
    talk = Told()
    assert not run(VARIANTS / f"{name}.yaml", f"{table}.{key}", row, "en", talk)
    assert any("not determined at this position" in line for line in talk.lines)


def missing():
    """Numbers that some variant has not."""
    for file in FILES:
        for table in (table for table in tables(solved(file.stem)) if table.name in ASKED):
            for column in table.columns[2:]:
                for row in np.flatnonzero(np.isnan(column.values)):
                    yield file.stem, table.name, column.key, int(row)


@pytest.mark.exhaustive
def test_the_same_question_has_the_same_answer():
    assert told.__wrapped__("crank_rocker", "R_12", 7) == told("crank_rocker", "R_12", 7)


@pytest.mark.exhaustive
def test_the_reaction_turned_round_is_explained_as_the_reaction_that_it_is():
    assert told("compressor", "R_54", 2) == told("compressor", "R_45", 2)


def test_a_formula_has_the_sign_of_half_a_turn():
    """By its name "pi" would be read as the point p of a link, as it is in an index."""
    half = Formula("omega", PI * Var("n", 600.0, "rpm") / 30, "rad/s")
    assert text(half, Translator("en")).startswith("ω = π·n/30 = ")
