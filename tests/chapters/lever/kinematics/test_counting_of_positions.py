"""How many positions the table of a mechanism needs: the exact is what ever finer tables come to."""

import numpy as np
import pytest
from conftest import ALL_FILES, solved

from tmm_report import course, loading
from tmm_report.chapters.lever.methods.counting import Tables, counting, wanted
from tmm_report.chapters.lever.moving import Moving

ERRORS = {"velocity", "acceleration", "moment", "work", "inertia_mean", "inertia", "unevenness"}


def moving(name):
    lever = solved(name).lever
    return Moving(lever.kinematics, lever.kinetostatics, lever.friction)


@pytest.mark.parametrize(
    "name", ["compressor", "shaper", "press", "engine_four_stroke", "cam_press", "elliptic_trammel"]
)
def test_ever_finer_tables_come_to_what_is_called_exact(name):
    for one in wanted(moving(name)):
        assert one.key in ERRORS
        assert one.error(7200) < 3e-3, one.key
        assert one.error(7200) < one.error(12) + 1e-9, one.key


@pytest.mark.parametrize("name", ["compressor", "engine_four_stroke", "quick_return", "cam_press"])
def test_the_balancing_moment_of_a_table_is_that_by_groups(name):
    """By the balance of powers, clockwise and counter-clockwise."""
    lever = solved(name).lever
    own = Tables(moving(name)).balancing(lever.kinematics.positions.table)
    exact = lever.kinetostatics.table.balancing
    assert own == pytest.approx(exact, abs=1e-9 * np.abs(exact).max())


def test_the_swing_of_the_excess_work_is_what_mertsalov_sizes_a_flywheel_by():
    """With the friction of the pairs, which is among the resistances of both."""
    assert solved("compressor").flywheel.sides.machine.rubs
    one = swing(moving("compressor"))
    assert one.exact[0] == pytest.approx(sized_by(solved("compressor")), rel=1e-9)
    assert one.error(720) < 1e-3


@pytest.mark.exhaustive
def test_the_friction_that_a_flywheel_leaves_out_is_left_out_of_the_counting():
    text = next(path for path in ALL_FILES if path.stem == "compressor").read_text("utf-8")
    assert text.count("\nflywheel:") == 1 and "\nmethods:" not in text
    without = course.solve(
        loading.loads(text.replace("\nflywheel:", "\nmethods: true\nflywheel:\n  friction: false"))
    )
    lever = without.lever
    bare = Moving(lever.kinematics, lever.kinetostatics)
    assert swing(bare).exact[0] == pytest.approx(sized_by(without), rel=1e-9)
    assert swing(bare).exact[0] < 0.99 * swing(moving("compressor")).exact[0]
    assert lever.methods.counted.errors == counting(bare).errors != counting(moving("compressor")).errors


def swing(of):
    return next(one for one in wanted(of) if one.key == "unevenness")


def sized_by(results):
    """The swing of the first group's energy by which Mertsalov's method sizes the flywheel, J."""
    method = results.flywheel.methods["mertsalov"]
    return method.upper.cut - method.lower.cut


def test_the_accuracy_of_the_variant_says_how_many_are_enough():
    rough, usual, fine = (counting(moving("compressor"), accuracy) for accuracy in (0.2, None, 1e-6))
    assert rough.recommended == 12
    assert usual.recommended in (24, 36, 72)
    assert fine.recommended is None
    assert usual.errors == rough.errors == fine.errors
    assert set(usual.errors) == ERRORS


def test_a_swing_has_no_machine_and_a_mechanism_without_loads_no_moments():
    assert set(counting(moving("elliptic_trammel")).errors) == {"velocity", "acceleration", "moment"}
    alone = solved("crank_rocker").lever.kinematics
    found = counting(Moving(alone, None)).errors
    assert (
        {"velocity", "acceleration"} <= set(found) <= {"velocity", "acceleration", "inertia_mean", "inertia"}
    )


def test_where_positions_are_missing_nothing_is_counted():
    text = """
mechanism:
  frame: {O: [0, 0], D: [300 mm, 0]}
  links:
    1: {points: {O: 0, A: 200 mm}}
    2: {points: {A: 0, B: 200 mm}}
    3: {points: {D: 0, B: 200 mm}}
  driver: {link: 1, period: 1 s}
  assembly: {B: left of A-D}
"""
    found = course.solve(loading.loads(text)).lever
    assert found.kinematics.gaps
    assert counting(Moving(found.kinematics, found.kinetostatics)) is None
