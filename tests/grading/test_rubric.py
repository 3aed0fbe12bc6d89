"""A rubric: its mistakes told all at once, its weights as shares on every level, what is asked without one."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import solved
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.grading.expected import expected
from tmm_report.grading.rubric import Rubric, loads, unmatched, worth
from tmm_report.problems import ProblemError


@pytest.fixture(scope="module")
def asked():
    return expected(solved("compressor"))


def shares(text: str, asked) -> dict[tuple[str, str], float]:
    return {name: float(cells.sum()) for name, cells in worth(loads(text), asked, True).items()}


def test_without_a_rubric_the_templates_tables_share_the_points(asked):
    found = worth(Rubric(), asked, True)
    assert sum(cells.sum() for cells in found.values()) == pytest.approx(100)
    tables = {name[0] for name in found}
    assert {"outputs_table", "rates_table", "reactions_table", "balancing_table", "stage2_wheels"} <= tables
    assert ("rates_table", "v_B") in found and ("rates_table", "v_B_x") not in found
    # the last position is the first again, and is not asked
    assert found["rates_table", "v_B"][12] == 0 < found["rates_table", "v_B"][11]


def test_weights_share_level_by_level(asked):
    found = shares(
        "chapters: {kinematics: 3, kinetostatics: 1}\ntables:\n  rates_table: {columns: {v_B: 2, v_D: 1}, weight: 2}\n"
        "  outputs_table: {columns: [S_B]}\n  balancing_table: {columns: [M_bal], cells: {7: 12}}\n",
        asked,
    )
    assert found == pytest.approx(
        {("rates_table", "v_B"): 100 / 3, ("rates_table", "v_D"): 50 / 3, ("outputs_table", "S_B"): 25,
         ("balancing_table", "M_bal"): 25}
    )  # fmt: skip
    cells = worth(loads("tables: {balancing_table: {cells: {7: 12}}}"), asked, True)[
        "balancing_table", "M_bal"
    ]
    assert cells[7] == pytest.approx(12 * cells[6])


def test_positions_of_a_table_go_before_those_of_the_work(asked):
    found = worth(
        loads("positions: [1, 7]\ntables: {rates_table: {positions: [3]}, outputs_table: 1}"), asked, True
    )
    assert np.flatnonzero(found["rates_table", "v_B"]).tolist() == [3]
    assert np.flatnonzero(found["outputs_table", "S_B"]).tolist() == [1, 7]


def test_single_numbers_are_asked_by_name(asked):
    assert shares("values: {H_B: 3, drive_u: 1}\ntables: {}", asked) == pytest.approx(
        {("", "H_B"): 75, ("", "drive_u"): 25}
    )


@pytest.mark.exhaustive
@given(points=st.floats(1, 1000), weights=st.lists(st.floats(0.1, 10), min_size=3, max_size=3))
def test_all_cells_together_are_worth_the_points(points, weights):
    asked = expected(solved("compressor"))
    a, b, c = weights
    text = f"points: {points}\ntables: {{rates_table: {a}, outputs_table: {b}}}\nvalues: {{H_B: {c}}}"
    assert sum(shares(text, asked).values()) == pytest.approx(points)


def test_all_mistakes_of_a_rubric_are_told_at_once():
    text = "pints: 50\nlimit: 5\ntables:\n  rates_table: {colums: [v_B], weight: -1}\nsigns: maybe\nreading: 1 m\n"
    with pytest.raises(ProblemError) as error:
        loads(text, "r.yaml")
    told = [problem.text() for problem in error.value.problems]
    assert len(told) == 6
    assert "r.yaml:1:1: pints: unknown key pints; did you mean points?" in told


def test_what_no_variant_has_is_named(asked):
    found = unmatched(
        loads("values: [H_B, H_Z]\ntables: {rates_table: {columns: [v_B, v_Z]}, nothing: 1}"), asked.keys()
    )
    assert found == {"H_Z", "rates_table.v_Z", "nothing"}
