"""A planetary stage of any scheme: the four judged as each would be alone, and the choice among them."""

from dataclasses import replace

import pytest

from tmm_report import loading
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.planetary.solve.schemes import WORTH, choose
from tmm_report.mechanics.gears.planetary.search import Task
from tmm_report.mechanics.gears.planetary.stage import SCHEMES
from tmm_report.problems import ProblemError

NAMES = ("1", "2", "2'", "3", "H")


def any_stage(ratio, input="wheel1", output="carrier", **changes):
    settings = {"satellites": (3,), "external": (12, 60), "rings": (20, 140), **changes}
    task = Task(SCHEMES["sun-ring"], ratio, (0.004, 0.004), input, output, **settings)
    return planetary.Given(task, NAMES, 0.96, any_scheme=True)


@pytest.fixture(scope="module")
def slow():
    return choose(any_stage(6.0))


@pytest.mark.exhaustive
def test_every_scheme_is_judged_as_it_would_be_alone(slow):
    for one in slow.judged:
        given = replace(any_stage(6.0), any_scheme=False, names=one.given.names)
        given = replace(given, task=replace(given.task, scheme=one.scheme))
        if one.teeth is None:
            with pytest.raises(ProblemError):
                planetary.solve(given)
            continue
        alone = planetary.solve(given)
        assert (one.teeth, one.satellites, one.solutions) == (
            alone.teeth,
            alone.satellites,
            len(alone.ranking),
        )
        assert one.efficiency == pytest.approx(alone.motion.efficiency) and one.ratio == pytest.approx(
            alone.ratio
        )
        assert one.overall == pytest.approx(float(alone.solutions.overall[0]))


def test_the_most_compact_of_the_efficient_ones_is_taken(slow):
    best = max(one.efficiency for one in slow.judged if one.works)
    rivals = [one for one in slow.judged if one.works and one.efficiency >= best - WORTH]
    assert slow.taken in rivals and slow.taken.overall == min(one.overall for one in rivals)
    assert len(rivals) >= 2  # or the choice would show nothing


def test_the_stage_is_that_of_the_scheme_taken():
    found = planetary.solve(any_stage(6.0))
    taken = found.choice.taken
    assert (found.scheme, found.teeth) == (taken.scheme, taken.teeth)
    assert found.given.names == (("1", "2", "3", "H") if taken.scheme.single else NAMES)
    assert {member.name for member in found.members} == set(found.given.names)


def test_an_inefficient_scheme_is_not_taken_for_its_size():
    """1 : 60 from the carrier: two external or two internal meshes are small and lose most of the power."""
    choice = choose(any_stage(60.0, "carrier", "wheel1", tolerance=0.04))
    small = min((one for one in choice.judged if one.teeth), key=lambda one: one.overall)
    assert choice.taken.efficiency >= max(one.efficiency for one in choice.judged if one.works) - WORTH
    assert choice.taken.efficiency >= small.efficiency - 1e-12 or small is choice.taken


def test_two_modules_leave_out_the_single_row():
    given = any_stage(9.0)
    choice = choose(replace(given, task=replace(given.task, modules=(0.004, 0.005))))
    assert not any(one.scheme.single for one in choice.judged) and len(choice.judged) == 3


def test_a_ratio_of_no_scheme_is_refused_with_what_would_work():
    with pytest.raises(ProblemError) as error:
        planetary.solve(any_stage(900.0))
    (problem,) = error.value.problems
    assert problem.path == ("ratio",) and "none of the schemes" in str(problem.wrong) and problem.right


STAGE = "{{kind: planetary, scheme: any, ratio: 9, module: 4 mm, {}, output: carrier}}"
TEXT = "drive: {{speed: 100 rpm, stages: [" + STAGE + "]}}"


@pytest.mark.parametrize(
    "more",
    ["input: wheel1, fixed: wheel3, teeth: [17, 50, 19, 86]", "input: sun, fixed: ring"],
)
def test_teeth_and_names_of_one_scheme_do_not_go_with_any(more):
    with pytest.raises(ProblemError) as error:
        loading.loads(TEXT.format(more))
    assert error.value.problems[0].right is not None
