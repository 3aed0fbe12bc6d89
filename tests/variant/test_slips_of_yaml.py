"""Slips of the pen that break YAML, or are good YAML and mean something else: the place and the cure."""

from __future__ import annotations

import pytest
from mistyped import lines, said

LINK = "    3: {points: {C: 0"


def test_the_pump_itself_has_neither_mistakes_nor_doubts():
    assert said() == []


@pytest.mark.parametrize(
    ("right", "wrong", "place", "words"),
    [
        (LINK, LINK[1:], "13:4", ("indented by 3 spaces", "indent it by 4, as line 12")),
        (LINK, " " + LINK, "13:6", ("indented by 5 spaces", "indent it by 4, as line 12")),
        ("    speed: 90", "   speed: 90", "18:4", ("indented by 3 spaces", "as line 17")),
        ("    speed: 90", "      speed: 90", "18:7", ("deeper than line 17", "indent it by 4")),
        ("    speed: 90", "\tspeed: 90", "18:1", ("a tab", "with spaces")),
        ("    speed: 90", "\u00a0\u00a0\u00a0 speed: 90", "18:1", ("U+00A0", "ordinary spaces")),
        ("S2: 0.2 м}", "S2: 0.2 м", "12:8", ("the { opened here is not closed before line 13", "end of line 12")),
        ("S4: 0.175 м}", "S4: 0.175 м", "14:8", ("not closed before line 15", "close it with }")),
        ("[380 мм, -120 мм]", "[380 мм, -120 мм", "6:8", ("the [ opened here", "close it with ]")),
        ("[0.951, 0], [1, 0]]", "[0.951, 0], [1, 0]", "30:15", ("the [ opened here", "end of line 30")),
        ("[380 мм, -120 мм]", "[380 мм, -120 мм}", "6:24", ("} stands here", "[ is open since line 6, column 8")),
        ("through: Q}", "through: Q}}", "9:20", ("this } closes nothing", "take it out")),
        ("language: ru", 'language: "ru', "2:11", ('the quote " opened here', "close it")),
        ("{topic: Механизм", "{topic: 'Механизм", "1:16", ("the quote ' opened here", "close it")),
        ("- name: сила", "- name: 'си'ла", "23:17", ("behind its closing quote", "write ''")),
        ("speed: 90 об", "speed 90 об", "18:5", ("a colon is missing", "write speed: 90 об/мин")),
        ("  driver:\n", "  driver\n", "16:3", ("a colon is missing", "write driver:")),
        ("speed: 90 об", "speed:90 об", "18:5", ("a space is missing", "write speed: 90 об/мин")),
        ("speed: 90 об", "speed = 90 об", "18:5", ("by a colon and a space", "write speed: 90 об/мин")),
        ("O: [0, 0]", "O:[0, 0]", "5:5", ("a space is missing", "write O: [0, 0]")),
        ("points: {O: 0", "points:{O: 0", "11:15", ("a space is missing after the colon",)),
        ("- name: сила", "- name: сила: F", "23:17", ("a second colon in the value of name", "into quotes")),
        ("topic: Механизм", "topic: Механизм: ", "1:24", ("a second colon", "the text needs quotes")),
        ("A: 0.1 м, S1", "A: 0.1 м S1", "11:35", ("a comma is missing before S1",)),
        ("A: 0.1 м, S1", "A: 0.1 м; S1", "11:36", ("; parts nothing", "write a comma")),
        ("    - name", "    -name", "23:6", ("a space is missing after -",)),
        ("      at: D\n", "    at: D\n", "24:5", ("the list begun on line 23", "- and a space", "by 6")),
        ("- name: сила", "- name: *сила", "23:13", ("cannot begin with *", "into quotes")),
        ("title: {", "a line of text\ntitle: {", "1:1", ("a colon is missing",)),
        ("- name: сила", "- name: @сила", "23:13", ("cannot begin with @", "into quotes")),
    ],
)  # fmt: skip
def test_a_slip_is_told_with_its_place_and_its_cure(right, wrong, place, words):
    (line,) = lines((right, wrong))
    assert line.startswith(place + ":"), line
    for word in words:
        assert word in line


@pytest.mark.parametrize(
    ("right", "wrong", "place", "words"),
    [
        ("B: 0.4 м", "B: 0,4 м", "12:24: mechanism.links.2.points.B", "write 0.4 м or '0,4 м'"),
        ("inertia: 0.0533}", "inertia: 0,0533}", "12:75: mechanism.links.2.inertia", "write 0.0533 or '0,0533'"),
        ("B: 0.28 м", "B: 0,28", "13:24: mechanism.links.3.points.B", "write 0.28 or '0,28'"),
        ("{point: D, extreme: right}", "{angle: 30,5 deg}", "19:12: mechanism.driver.zero.angle", "30.5 deg"),
        ("mass: 4 кг", "mass:4 кг", "12:46: mechanism.links.2.mass", "write mass: 4 кг"),
        ("mass: 4 кг", "mass 4 кг", "12:46: mechanism.links.2.mass", "write mass: 4 кг"),
        ("Механизм плунжерного", "Механизм, плунжерного", "1:9: title.topic", "'Механизм, плунжерного насоса'"),
        ("[380 мм, -120 мм]", "[0,38, -0,12]", "6:5: mechanism.frame.C", "write [0.38, -0.12]"),
        ("[380 мм, -120 мм]", "[380,5 мм, -120 мм]", "6:5: mechanism.frame.C", "write [380.5 мм, -120 мм]"),
        ("[0.05, 0.8 МПа]", "[0,05, 0,8 МПа]", "30:36: ", "write [0.05, 0.8 МПа]"),
    ],
)  # fmt: skip
def test_what_a_comma_or_a_missing_space_makes_inside_brackets_is_told_as_such(right, wrong, place, words):
    (line,) = lines((right, wrong))
    assert line.startswith(place)
    assert words in line


def test_every_decimal_comma_is_told_and_nothing_that_follows_from_it():
    slips = [("A: 0.1 м", "A: 0,1 м"), ("S1: 0.05 м", "S1: 0,05 м"), ("S2: 0.2 м", "S2: 0,2 м")]
    assert [line.split(": ")[1] for line in lines(*slips)] == [
        f"mechanism.links.{key}" for key in ("1.points.A", "1.points.S1", "2.points.S2")
    ]


def test_lists_that_fit_are_never_taken_for_decimal_commas():
    assert said(("loads:", "positions: {plans: [1,5, 7]}\nloads:")) == []


def test_a_list_of_blocks_without_dashes_is_told_how_it_begins():
    text = "      name: сила полезного сопротивления"
    assert (
        "begin each item with - and a space" in lines(("    - name: сила полезного сопротивления", text))[0]
    )
