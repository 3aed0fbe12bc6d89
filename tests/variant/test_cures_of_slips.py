"""Each slip of a student's is told once, where it is, with what to write instead."""

from __future__ import annotations

import pytest
from mistyped import lines, said

MACHINE = "flywheel, a block of its own at the top of the file: flywheel: {delta: 1/30}"


@pytest.mark.parametrize(
    ("right", "wrong", "key", "cure"),
    [
        ("speed: 90 об/мин", "speed: 90 об/мин\n    delta: 1/30", "mechanism.driver.delta", MACHINE),
        ("loads:\n", "delta: 1/30\nloads:\n", "delta", MACHINE),
        ("  assembly:", "  gravity: 9.81\n  assembly:", "mechanism.gravity", "it belongs into loads"),
        ("loads:\n", "coefficient: 1\nloads:\n", "coefficient", "friction.pivots, friction.guides"),
        ("loads:\n", "table: 12\nloads:\n", "table", "positions: {table: 12}"),
        ("mechanism:\n", "Mechanism:\n", "Mechanism", "did you mean mechanism?"),
        ("mechanism:\n", "механизм:\n", "механизм", "keys are English words: mechanism"),
        ("mechanism:\n", "меканізм:\n", "меканізм", "known: accuracy, allow_partial"),
    ],
)
def test_a_key_in_a_wrong_place_is_one_mistake_with_the_right_place(right, wrong, key, cure):
    (problem,) = said((right, wrong))
    assert problem.key == key
    assert cure in problem.text()


def test_a_missing_key_that_is_there_misspelt_is_told_once():
    friction = "friction:\n  pivots: {coefficient: 0.1, diametr: 30 mm}\nloads:\n"
    (line,) = lines(("loads:\n", friction))
    assert line.endswith("friction.pivots.diametr: unknown key diametr; did you mean diameter?")


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("  driver:", "  drivr:", "mechanism.drivr: unknown key drivr; did you mean driver?"),
        ("  driver:", "  привод:", "mechanism.привод: unknown key привод; keys are English words: driver"),
        (
            "mass_centre: S3",
            "mas_centre: S3",
            "links.3.mas_centre: unknown key mas_centre; did you mean mass_centre?",
        ),
    ],
)
def test_a_part_that_every_mechanism_has_under_another_name_is_told_once(right, wrong, told):
    (line,) = lines((right, wrong))
    assert line.endswith(told)


def test_a_missing_key_beside_an_unknown_one_that_is_another_is_told_too():
    friction = "friction:\n  pivots: {coefficient: 0.1, lubricant: oil}\nloads:\n"
    assert len(lines(("loads:\n", friction))) == 2


@pytest.mark.parametrize(
    ("right", "wrong", "cure"),
    [
        ("inertia: 0.0533", "inertia: 5.33*10^-2", "write 5.33e-2"),
        ("inertia: 0.0533", "inertia: 5.33·10⁻² кг·м²", "write 5.33e-2 кг·м²"),
        ("B: 0.4 м", "B: 1 400 мм", "write 1400 мм"),
        ("speed: 90 об/мин", "speed: 90 rpm.", "write 90 rpm"),
        ("speed: 90 об/мин", "speed: 90 об/мин // холостой ход", "a comment begins with a space and #"),
        ("speed: 90 об/мин", "speed: 90 об/мин# ход", "a comment begins with a space and #"),
        ("[380 мм, -120 мм]", "[380 мм; -120 мм]", "write a comma"),
        ("{point: D, extreme: right}", "{angle: 30 кк.}", "for example, 20 deg"),
    ],
)
def test_a_number_written_in_another_way_is_told_with_its_usual_form(right, wrong, cure):
    (line,) = lines((right, wrong))
    assert line.endswith(cure)


def test_a_percentage_without_its_sign_is_told_with_it():
    drive = "drive:\n  speed: 1500 rpm\n  tolerance: 4\n  stages: [{kind: spur, ratio: 2, module: 3 mm}]\n"
    (line,) = lines(("loads:\n", drive + "loads:\n"))
    assert line.endswith("did you mean 4 %?")


def test_degrees_without_a_unit_are_told_in_degrees():
    moment = "  moments: [{name: M, on: 1, direction: clockwise, by_angle: [[0, 1], [90, 2]]}]\n"
    (line,) = lines(("loads:\n", "loads:\n" + moment))
    assert line.endswith("did you mean 90 deg?")


@pytest.mark.parametrize(
    ("right", "wrong", "place", "other"),
    [
        (
            "{O: 0, A: 0.1 м",
            "{0: 0, A: 0.1 м",
            "mechanism.links.1.points.0",
            "with the Latin letter O and not the digit 0",
        ),
        (
            "    O: [0, 0]",
            "    0: [0, 0]",
            "mechanism.frame.0",
            "with the Latin letter O and not the digit 0",
        ),
    ],
)
def test_a_zero_for_the_letter_in_a_point_is_told_and_nothing_that_follows_from_it(
    right, wrong, place, other
):
    (problem,) = said((right, wrong))
    assert problem.key == place
    assert other in problem.text()


def test_the_head_of_a_block_that_lost_its_indent_is_told_at_the_head():
    (line,) = lines(("  driver:\n", "driver:\n"))
    assert "the line is indented by 0 spaces" in line
    assert line.split(":")[0] == "16"


def test_a_sentence_that_lost_its_sign_of_a_comment_is_told_as_such():
    (line,) = lines(("loads:\n", "все размеры в метрах\nloads:\n"))
    assert line.endswith("write key: value, or begin it with #")
