"""Letters that look alike and are not the same: in names, keys, words, units and numbers."""

from __future__ import annotations

import pytest
from mistyped import lines, said

from tmm_report.quantity.typed.alike import latin, readings, skeleton
from tmm_report.variant.errors import near


@pytest.mark.parametrize(
    ("right", "wrong", "place", "words"),
    [
        ("2: {points: {A: 0", "2: {points: {А: 0", "12:18", ("А (Cyrillic) and A (Latin) on line 11",)),
        ("A: 0.1 м", "А: 0.1 м", "11:24", ("А (Cyrillic) and A (Latin) on line 12",)),
        ("left of A-C", "left of A-С", "20:14", ("С (Cyrillic) and C (Latin) on line 6",)),
        ("x: {through", "х: {through", "9:5", ("х (Cyrillic) and x (Latin) on line 15",)),
        ("at: D", "at: Ｄ", "24:7", ("look alike",)),
        ("C: 0, B: 0.28", "C: 0, В: 0.28", "13:24", ("В (Cyrillic) and B (Latin)",)),
        ("S4: 0.175", "Ѕ4: 0.175", "14:35", ("S4 (Latin) on line 14",)),
        ("mass: 4 кг", "mаss: 4 кг", "12:46", ("unknown key mаss", "the Cyrillic letter а")),
        ("loads:", "lоads:", "21:1", ("unknown key lоads", "the Cyrillic letter о")),
        ("  driver:", "  drivеr:", "16:3", ("unknown key drivеr", "the Cyrillic letter е")),
        ("direction: left", "direction: lеft", "25:7", ("write left", "the Cyrillic letter е")),
        ("extreme: right", "extreme: rіght", "19:22", ("write right", "the Cyrillic letter і")),
        ("90 мм", "9О мм", "26:7", ("write 90 мм", "the digit 0")),
        ("90 мм", "З0 мм", "26:7", ("write 30 мм", "the digit 3")),
        ("90 мм", "90 mм", "26:7", ("write 90 мм", "the Cyrillic letter м")),
        ("0.8 МПа", "0.8 MПa", "30:43", ("write 0.8 МПа", "the Latin letter M")),
        ("link: 1", "link: l", "17:5", ("write 1", "the digit 1", "the Latin letter l")),
    ],
)  # fmt: skip
def test_a_letter_that_only_looks_right_is_named(right, wrong, place, words):
    (line,) = lines((right, wrong))
    assert line.startswith(place + ":"), line
    for word in words:
        assert word in line


def test_both_places_are_told_and_nothing_that_follows():
    (problem,) = said(("2: {points: {A: 0", "2: {points: {А: 0"))
    assert (problem.line, problem.column, problem.wrong.values["line"]) == (12, 18, 11)


def test_names_in_one_script_are_nobodys_business():
    text = [("A: 0.1", "Ж: 0.1"), ("{A: 0,", "{Ж: 0,"), ("left of A-C", "left of Ж-C")]
    assert said(*text) == []


@pytest.mark.parametrize("word", ["helix", "by_position", "O1"])
def test_no_suggestion_is_the_word_itself(word):
    told = near(word, [word, "other"])
    assert told is not None
    assert word not in told.render(str)


def test_what_looks_alike_is_told_by_its_letters_not_by_its_look():
    told = near("O1", ["01", "A"])
    assert told is not None
    assert told.render(str) == "write 01, with the digit 0 and not the Latin letter O"


def test_folding_leaves_latin_text_as_it_is():
    assert latin("left of A-C") == "left of A-C"
    assert latin("Ａ1") == "A1"
    assert skeleton("О1") == skeleton("0l") == skeleton("OI")
    assert "100 Н" in readings("100 H")
