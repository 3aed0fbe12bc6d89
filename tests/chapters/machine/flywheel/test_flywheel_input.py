"""What a variant may say of a flywheel, and what is told of what it may not."""

from __future__ import annotations

import re

import pytest
from conftest import read, solved

from tmm_report import course, loading, render
from tmm_report.problems import ProblemError

TABLE = "{table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}"
LEVER = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}, inertia: 0.02}
    2: {points: {A: 0, B: 300 mm, S: 100 mm}, mass: 2, mass_centre: S, inertia: 0.02}
    3: {points: [B], slides: x, mass: 3, mass_centre: B}
  driver: {link: 1, speed: 300 rpm, zero: {point: B, extreme: right}}
  assembly: {B: right}
"""
LOADS = "loads: {forces: [{at: B, direction: against motion, constant: 500 N}]}\n"


def told(text: str) -> str:
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    return "\n".join(problem.text() for problem in error.value.problems)


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ("delta: 0, speed: 10, resisting: " + TABLE, "infinitely heavy"),
        ("delta: -1/30, speed: 10, resisting: " + TABLE, "flywheel.delta"),
        ("delta: 1.5, speed: 10, resisting: " + TABLE, "no unevenness of a steady motion"),
        ("delta: 1/0, speed: 10, resisting: " + TABLE, "flywheel.delta"),
        ("speed: 10, resisting: " + TABLE, "stated in one way, here in 0; exactly one of: delta, speeds, wheel"),
        ("delta: 0.1, wheel: {inertia: 2}, speed: 10, resisting: " + TABLE, "here in 2"),
        ("delta: 0.1, resisting: " + TABLE, "mean speed of the machine is not stated"),
        ("delta: 0.1, speed: 10", "nothing for a flywheel to even out; one of: resisting, driving, areas, punch"),
        ("delta: 0.1, speed: 10, areas: {values: [1, -1]}, driving: {constant: 3}", "several ways: driving, areas"),
        ("delta: 0.1, speed: 10, areas: {values: [3, -1]}", "does not close: the areas make 2 J together"),
        ("delta: 0.1, speed: 10, driving: {constant: 3}, resisting: {constant: 5}",
         "driving moment gives 18.8496 J, the resisting one takes 31.4159 J"),
        ("delta: 0.1, speed: 10, driving: {mean: 3, harmonics: [{order: 0.5, sin: 2}]}",
         "order 0.5 does not repeat with a cycle of 1 turns"),
        ("delta: 0.1, speed: 10, driving: {constant: -3}", "over the cycle the driving moment takes work"),
        ("delta: 0.1, speed: 10, resisting: {constant: -3}", "over the cycle the resisting moment gives work"),
        ("delta: 0.1, speed: 10, resisting: {mean: 0, harmonics: [{order: 1, sin: 2}]}", "do no work over the cycle"),
        ("delta: 0.1, speed: 10, resisting: {constant: 4}", "excess moment is nothing all over the cycle"),
        ("delta: 0.1, speed: 10, resisting: {constant: 4, mean: 3}", "must be stated by one law"),
        ("delta: 0.1, speed: 10, resisting: {table: [[90 deg, 2], [0, 3]]}", "must ascend"),
        ("delta: 0.1, speed: 10, resisting: {table: [[0, 2], [400 deg, 3]]}", "400 deg is beyond the cycle of 1"),
        ("delta: 0.1, speed: 10, motor: {power: 1 kW, speed: 100}, resisting: " + TABLE,
         "the motor is too weak: the cycle takes 2 kW on average, the motor gives 1 kW"),
        ("delta: 0.1, speed: 10, shaft: motor, resisting: " + TABLE, "there is no motor"),
        ("delta: 0.1, speed: 10, disc: {}, rim: {}, resisting: " + TABLE, "several shapes: disc, rim"),
        ("wheel: {mass: 5}, speed: 10, resisting: " + TABLE, "mass and radius of gyration together"),
        ("wheel: {inertia: 0.01}, speed: 10, resisting: " + TABLE, "comes to a stand once a cycle"),
        ("speeds: [12, 10], resisting: " + TABLE, "the least and the greatest"),
        ("speeds: [10, 12], punch: {work: 5, period: 2, time: 2}", "nothing is left to store energy in"),
        ("speeds: [10, 12], turns: 2, punch: {work: 5, period: 2, time: 1}", "its turns follow from the speed"),
        ("speeds: [10, 12], inertia: {table: [[0, 1], [3, 2]]}, punch: {work: 5, period: 2, time: 1}",
         "no whole number of turns"),
        ("delta: 0.1, speed: 10, machine: piston compresor, resisting: " + TABLE, "not a word known here"),
    ],
)  # fmt: skip
def test_a_machine_alone_is_told_what_is_wrong_of_it(keys, words):
    assert words in told(f"flywheel: {{{keys}}}")


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("flywheel: {delta: 0.1}\n", "without loads there is nothing for a flywheel to even out"),
        (LOADS + "flywheel: {delta: 0.1, speed: 10, turns: 2}\n", "speed follows from the mechanism"),
        (LOADS + "flywheel: {speeds: [10, 12]}\n", "state delta in place of speeds"),
        ("loads: {gravity: 9.81}\nflywheel: {delta: 0.1}\n", "do no work over the cycle"),
        (LOADS + "flywheel: {delta: 0.1, motor: {power: 10 W, speed: 300 rpm}}\n", "the motor is too weak"),
    ],
)
def test_beside_a_mechanism_too(more, words):
    assert words in told(LEVER + more)


def test_a_mechanism_that_does_not_turn_round_has_no_steady_motion():
    text = (LEVER + LOADS).replace("speed: 300 rpm", "speed: 300 rpm, range: 90 deg")
    text = text.replace("zero: {point: B, extreme: right}", "zero: {angle: 30 deg}")
    assert "no full turn" in told(text + "flywheel: {delta: 0.1}\n")


def test_all_mistakes_are_told_at_once():
    text = told("flywheel: {delta: 0, disc: {}, rim: {}, shaft: motor, resisting: {constant: 1, mean: 2}}")
    assert len(text.splitlines()) >= 5


def test_works_that_differ_by_less_than_a_hundredth_are_closed_and_said_so():
    found = course.solve(loading.loads(
        "flywheel: {delta: 0.1, speed: 10, driving: {mean: 100, harmonics: [{order: 1, sin: 40}]}, "
        "resisting: {constant: 99.5}}"
    )).flywheel  # fmt: skip
    assert found.sides.spread == pytest.approx(0.5)
    assert found.cycle.panels.total(found.cycle.moment) == pytest.approx(0.0, abs=1e-10)


def test_the_ready_variants_state_what_a_textbook_does():
    assert read("punch_press").flywheel.delta == pytest.approx(1 / 30)
    assert read("compressor").flywheel.machine == "piston compressor"


def test_a_motor_beside_an_engine_that_drives_is_not_asked_for_its_power():
    found = course.solve(loading.loads(
        "flywheel: {delta: 0.1, speed: 10, driving: {mean: 100, harmonics: [{order: 1, sin: 40}]}, "
        "motor: {power: 1 W, speed: 50, inertia: 0.1}}"
    )).flywheel  # fmt: skip
    assert "P_need" not in found.s and found.cycle.own == pytest.approx(0.1 * 25)


def test_summary_says_the_inertia_and_the_measured_unevenness():
    (line,) = solved("compressor").flywheel.summary()
    assert "1.106" in str(line) and str(line).count("0.0125") == 2


METHODS = {
    "left out": ("", "Mertsalov", ("Wittenbauer", "Rerikh")),
    "one": ("methods: [rerikh]", "Rerikh", ("Mertsalov", "Wittenbauer")),
}


@pytest.mark.parametrize("case", METHODS)
def test_the_text_works_out_the_method_of_the_department_and_the_appendix_the_others(case):
    stated, chosen, others = METHODS[case]
    load = "resisting: {table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}"
    inertia = "inertia: {mean: 3, harmonics: [{order: 2, cos: 1}]}"
    text = f"flywheel: {{delta: 1/25, speed: 12, {load}, {inertia}, {stated}}}"
    results = course.solve(loading.loads(text))
    for depth, heads in (("course", ("1.2", "A.")), ("short", ("1.2", None)), ("full", ("1.", "1."))):
        note = render(results, "html", "en", depth)["note.html"].decode()
        said = [re.sub(r"<[^>]*>", "", one) for one in re.findall(r"<h2[^>]*>(.*?)</h2>", note)]
        for name, where in ((chosen, heads[0]), *((one, heads[1]) for one in others)):
            numbers = [one.split()[0] for one in said if name in one and "method" in one]
            assert len(numbers) == (where is not None)
            assert all(number.startswith(str(where)) for number in numbers)


def test_no_method_is_worked_out_for_a_stated_wheel():
    with pytest.raises(ProblemError) as error:
        loading.loads(
            "flywheel: {wheel: {inertia: 60}, speed: 12, methods: [rerikh], resisting: {constant: 5}}"
        )
    assert [problem.path for problem in error.value.problems] == [("flywheel", "methods")]
