"""Scenes in which methods fail, as `tmm-report solve` answers them: right, or told. None is wrong without a word.

The truth is of closed formulas in many digits (`benchmarks/failures/truth.py`).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from exhaustive import many

from benchmarks.failures import columns
from benchmarks.failures.judge import NONE, REFUSED, RIGHT, WRONG, judged
from benchmarks.failures.truth import KINDS
from benchmarks.near_singular.scenes import SCENES as SCENES_NEAR
from benchmarks.near_singular.scenes import turned
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.mechanism import Assembly, Driver, Guide, Link, Mechanism, Slide, ZeroAngle

QUICK = [
    "near dead 12", "nearer dead", "rod = crank", "parallelogram", "kite", "10 pm", "short rod", "narrow gap", "jam",
    "limit", "merging", "corner", "beside a corner", "parallel guides", "parallel between", "tangent slot",
    "pin past pivot", "pin through pivot", "micrometres", "kilometres", "long links",
]  # fmt: skip
TOLD = {
    "10 pm": "4 digits remain", "short rod": "cannot reach guide", "narrow gap": "cannot reach guide",
    "jam": "do not meet", "limit": "do not meet", "parallel guides": "are parallel", "parallel between": "are parallel",
    "nearer dead": "digits remain", "tangent slot": "digits remain",
}  # fmt: skip


@pytest.mark.parametrize("name", many(QUICK, 9))
def test_right_or_told(name):
    cell = columns.ours(name)
    assert cell.verdict in (RIGHT, REFUSED), cell.text
    if cell.verdict == REFUSED:
        assert "told" in cell.word, cell.text


@pytest.mark.parametrize("name", TOLD)
def test_the_console_says_it(name):
    assert any(TOLD[name] in line for line in columns.solved(name).lines)


def test_what_runs_away_between_two_positions_has_no_extremes():
    """All positions exist, but between them the joint goes to infinity: no stroke, no greatest velocity, no moment."""
    lever = columns.solved("parallel between").results.lever
    (travel,) = lever.kinematics.travels
    assert np.isfinite(travel.S).all() and np.isfinite(lever.kinetostatics.table.balancing).all()
    for extreme in (travel.near, travel.far, *travel.V_extremes, *travel.a_extremes):
        assert np.isnan(extreme.value)
    assert np.isnan(travel.stroke) and not lever.kinetostatics.bounded
    assert np.degrees(lever.kinematics.cycle.poles) == pytest.approx([170.0, 350.0])


def test_each_parallel_position_is_told_once():
    (one,) = columns.solved("parallel guides").kinematics.closest
    assert np.degrees(one.parallel) == pytest.approx([0.0, 180.0], abs=1e-9)


def test_a_harmless_scene_has_nothing_to_tell():
    assert columns.ours("harmless").verdict == RIGHT and not columns.words(columns.solved("harmless"))


def test_the_judge_sees_a_wrong_number():
    found = columns.of_motion(columns.solved("harmless").kinematics.table)
    found["velocity", "B"] = np.where(
        np.arange(13) == 4, found["velocity", "B"] + 1e-4, found["velocity", "B"]
    )
    assert judged(columns.exact("harmless"), found, KINDS).verdict == WRONG


@pytest.mark.exhaustive
def test_the_judge_sees_another_assembly():
    """The parallelogram 10 pm off goes on as an antiparallelogram; what goes straight on is wrong."""
    straight = columns.of_motion(columns.solved("parallelogram").kinematics.table)
    assert judged(columns.exact("10 pm"), straight, KINDS).verdict == WRONG


@pytest.mark.exhaustive
def test_the_judge_sees_a_position_that_is_none_and_a_gap_not_told():
    found = columns.of_motion(columns.solved("harmless").kinematics.table)
    assert judged(columns.exact("short rod"), found, ("velocity",)).verdict == WRONG
    made_up = columns.of_motion(columns.solved("short rod").kinematics.table)
    assert judged(columns.exact("short rod"), made_up, ("velocity",), "gap told").verdict == RIGHT
    made_up["velocity", "B"] = np.nan_to_num(made_up["velocity", "B"], nan=1.0)
    assert judged(columns.exact("short rod"), made_up, ("velocity",), "gap told").verdict == WRONG
    table = columns.of_motion(columns.solved("narrow gap").kinematics.table)
    assert judged(columns.exact("narrow gap"), table, KINDS).verdict == WRONG
    assert judged(columns.exact("narrow gap"), table, KINDS, "gap told").verdict == RIGHT


def test_what_finds_nothing_is_not_right():
    assert judged(columns.exact("harmless"), {}, KINDS).verdict == NONE


def test_rates_in_a_corner_are_no_numbers():
    found = columns.of_motion(columns.solved("kite").kinematics.table)
    assert judged(columns.exact("kite"), found, KINDS).verdict == RIGHT
    found["velocity", "B"] = np.nan_to_num(found["velocity", "B"])
    assert judged(columns.exact("kite"), found, KINDS).verdict == WRONG


@pytest.mark.parametrize("ratio", [2.0, 1.05])
def test_a_group_behind_a_change_point_has_its_own_digits(ratio):
    """A slider-crank hung on the rocker of a parallelogram: there the limit of the rocker's motion is enough, however
    fast the slider is. ω₃ = ω₁, so its velocity is that of a crank of the same length."""
    mechanism, _ = SCENES_NEAR["parallelogram"].build(0.0, 0)
    a, f = 0.1, 0.3
    links = [
        *mechanism.links.values(),
        Link("4", {"B": 0j, "D": ratio * a + 0j}),
        Link("5", {"D": 0j}),
    ]
    guide = Guide("g", "0", f + 0j, turned(1.5))
    stated = Mechanism(
        {link.name: link for link in links}, Driver("1", 1.0), {"g": guide}, (Slide("5", "g"),),
        (Assembly("B", 1), Assembly("D", 1)),
    )  # fmt: skip
    cycle = cycle_of(assemble(replace(stated, driver=replace(stated.driver, zero=ZeroAngle(1.0)))))
    found = cycle.motion(np.array([np.pi - 1.0]))
    z = a * np.exp(1j * np.pi) / turned(1.5)
    root = np.sqrt((ratio * a) ** 2 - z.imag**2)
    v = -z.imag - z.imag * z.real / root
    assert (found.velocity("D")[0] / turned(1.5)).real == pytest.approx(v, rel=1e-10)
    assert found.angular_velocity("3")[0] == pytest.approx(1.0, abs=1e-10)


def test_a_swing_is_told_what_it_needs_and_no_more():
    """A and C of the four-bar that jams come 7.2 m apart over a turn, over its swing as the cosine rule says."""
    driver = columns.SCENES["limit"].variant["mechanism"]["driver"]
    angle = driver["zero"]["angle"] + driver["range"]
    apart = np.sqrt(3**2 + 4.2**2 - 2 * 3 * 4.2 * np.cos(angle))
    said = f"together the links need at least {1e3 * apart:.6g} mm"
    assert any(said in line for line in columns.solved("limit").lines)
