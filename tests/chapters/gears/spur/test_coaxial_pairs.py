"""Two pairs that lead back to one axis: the second has the centre distance of the first."""

import math

import pytest

from tmm_report import course, loading
from tmm_report.chapters.gears.drive.places import placed
from tmm_report.problems import ProblemError

TEXT = "language: en\ndrive:\n  speed: 1000 rpm\n  stages:\n{}"
FIRST = "kind: spur, module: 3 mm, teeth: [20, 60], centre_distance: 121 mm, shift: [0.3, rest]"
SECOND = "kind: spur, module: 4 mm, teeth: [18, 42], mesh: external, coaxial: true"


def solved(*stages):
    return course.solve(loading.loads(TEXT.format("".join(f"    - {{{stage}}}\n" for stage in stages)))).drive


def test_the_second_pair_has_the_distance_of_the_first():
    drive = solved(FIRST, SECOND)
    one, two = (stage.pair for stage in drive.stages)
    assert float(two.a_w) == float(one.a_w) == 0.121
    assert float(two.backlash) == pytest.approx(0, abs=1e-15)  # the shifts fill it
    inv = [math.tan(a) - a for a in (math.acos(120 / 121 * math.cos(math.radians(20))), math.radians(20))]
    assert float(two.x_sum) == pytest.approx(
        60 * (inv[0] - inv[1]) / (2 * math.tan(math.radians(20))), rel=1e-12
    )


def test_a_distance_that_follows_from_shifts_is_taken_over():
    free = FIRST.replace("centre_distance: 121 mm, shift: [0.3, rest]", "mesh: external, shift: [0.3, 0.1]")
    one, two = (stage.pair for stage in solved(free, SECOND).stages)
    assert float(two.a_w) == float(one.a_w) != 0.12


def test_input_and_output_lie_on_one_axis():
    """Of the scheme and of the diagrams of velocities; without the word the axes go on."""
    for stages, there in (
        ((FIRST, SECOND), 0.0),
        ((FIRST, SECOND.replace("coaxial: true", "centre_distance: 121 mm")), -0.242),
    ):
        _, axes = placed(solved(*stages).stages)
        assert axes["1"] == 0 and axes["2"] == axes["3"] == pytest.approx(-0.121)
        assert axes["4"] == pytest.approx(there, abs=1e-15)


def test_stated_too_the_distance_must_agree():
    assert float(solved(FIRST, f"{SECOND}, centre_distance: 121 mm").stages[1].pair.a_w) == 0.121
    third = "kind: spur, module: 4 mm, teeth: [18, 42], mesh: external, coaxial: true"
    _, axes = placed(solved(FIRST, SECOND, third).stages)
    assert axes["6"] == pytest.approx(-0.121)  # back again from the main axis


SLIPS = {
    (SECOND,): ("stages.0.coaxial", "no pair stands before"),
    (FIRST, f"{SECOND}, centre_distance: 125 mm"): ("stages.1.centre_distance", "not that of the pair before, 121 mm"),
    (FIRST, SECOND.replace("true", "yes please")): ("stages.1.coaxial", "write true or false"),
    (FIRST, SECOND.replace("coaxial", "coaxal")): ("stages.1.coaxal", "coaxial"),
    (FIRST, SECOND.replace("[18, 42]", "[18, 90]")): ("stages.1", "base circles of the wheels overlap"),
}  # fmt: skip


@pytest.mark.parametrize("stages", SLIPS, ids=range(len(SLIPS)))
def test_slips(stages):
    place, text = SLIPS[stages]
    with pytest.raises(ProblemError) as told:
        solved(*stages)
    assert place in str(told.value) and text in str(told.value)
