"""What the note says of an ordinary stage: which numbers are given, which are taken and how; its tables."""

import math
import re

import pytest
from test_drive import PLANETARY, solve
from test_ordinary import (
    BEVEL,
    CHAIN,
    EVERY,
    LOCKED,
    OPEN,
    RINGED,
    TRAIN,
    WORM,
    V,
    turned_by_worm,
)  # fmt: skip

from tmm_report.chapters.gears.ordinary.quantities import TITLES
from tmm_report.chapters.gears.ordinary.view import OrdinaryView
from tmm_report.i18n import Translator
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page


def without(stage, *keys):
    return {key: value for key, value in stage.items() if key not in keys}


SAID = {
    "belt of a stated distance": (OPEN, "d1 d2 a", ""),
    "belt by the rule": (without(OPEN, "distance"), "d1 d2", "a"),
    "belt of a length of the row": (V, "d1 epsilon u_required a_about f k q phi", "d2 L a"),
    "belt by the rule, of a length of the row": (
        without(OPEN, "distance") | {"length": "standard"}, "d1 d2", "a_about L a",
    ),
    "belt by its length": (without(OPEN, "distance") | {"length": "1.5 m"}, "d1 d2", "a"),
    "chain": (CHAIN, "z1 u_required p a_about slack q", "z2 links"),
    "chain by the rule": (without(CHAIN, "distance", "mass"), "z1 u_required p slack", "z2 a_about links"),
    "bevel": (BEVEL, "z1 u_required sigma m_e alpha", "z2 psi"),
    "worm": (WORM, "z1 z2 m q phi k alpha", ""),
    "worm by its ratio": (without(WORM, "teeth") | {"ratio": 20}, "z1 u_required m q phi k alpha", "z2"),
    "train": (TRAIN, "z.0 z.1 z.2 z.3 m eta_mesh", ""),
    "train by its ratio": (RINGED, "z.0 z.1 m u_required eta_mesh", "z.2"),
}  # fmt: skip


def told(text):
    """The numbers of the results in a text, by their keys without that of the stage; of a table with their rows."""
    found = re.findall(r'data-q="(\w+)"([^>]*)', str(text))
    rows = [re.search(r'data-k="(\d+)"', more) for _, more in found]
    return {
        key.removeprefix("stage1_") + (f".{row[1]}" if row else "")
        for (key, _), row in zip(found, rows, strict=True)
    }


def view(stage):
    page = Page(Html(), Translator("en"), Numbering())
    return OrdinaryView(solve(stage, torque="25 N*m").stages[0], page, "stage1")


@pytest.mark.parametrize("name", SAID)
def test_what_is_stated_is_given_and_what_is_chosen_is_taken(name):
    stage, given, taken = SAID[name]
    shown = view(stage)
    assert told(shown.given_values()) == set(given.split())
    said = [told(text) for group in shown.groups() for text in group.taken]
    assert sorted(set().union(*said)) == sorted(taken.split()) and all(len(one) == 1 for one in said)


def test_the_teeth_of_a_train_are_whole_numbers_in_its_table():
    (part,) = view(RINGED).wheels_table().parts
    assert [str(row[1]) for row in part.rows] == ["20", "30", "80"]
    assert [row[1].ref.row for row in part.rows] == [0, 1, 2]


def test_a_missed_ratio_is_cured_by_what_the_stages_have():
    coarse = [BEVEL | {"ratio": 2.53}, BEVEL | {"ratio": 2.53}]
    (said,) = (one for one in solve(*coarse, tolerance="0.5 %").doubts if one.path == ("drive", "tolerance"))
    assert "diameters in the stages" in said.text() and "planetary" not in said.text()
    rough = [PLANETARY | {"ratio": 6.7}, PLANETARY | {"ratio": 6.7}]
    (said,) = (one for one in solve(*rough, tolerance="2 %").doubts if one.path == ("drive", "tolerance"))
    assert "tolerance: 1 % in the planetary stages" in said.text()


PAIRS = {
    "pair": {"kind": "spur", "teeth": [20, 60]},
    "ring": {"kind": "spur", "teeth": [20, 60], "mesh": "internal"},
}


@pytest.mark.parametrize("name", [*EVERY, *PAIRS])
def test_the_sense_is_told_in_words_as_it_is(name):
    """Of a worm by hand and place; of others both shafts turn in one sense, or not."""
    stage = {**EVERY, **PAIRS}[name]
    shown = view(stage)
    text = str(shown.introduced())
    if shown.found.kind == "worm":
        return
    opposite, same = "opposite sense" in text, "in the same sense" in text
    if "kind" in stage and stage["kind"] == "train":
        assert not opposite and not same and ("ring" in text) == (name == "ringed")
    else:
        assert (opposite, same) == (shown.found.given.sense < 0, shown.found.given.sense > 0)
    title = TITLES[shown.found.given.variety]
    assert ("inner" in title or "ring" in title) == (name in ("inner", "ring", "ringed"))
    assert ("one within the other" in text) == (name == "inner")


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("place", ["above", "below"])
def test_the_wheel_of_a_worm_is_told_to_turn_as_it_does(hand, place):
    text = str(view(WORM | {"hand": hand, "worm": place}).introduced())
    assert f"The thread is {hand}-handed, the worm lies {place} the wheel." in text
    assert ("the wheel turns counter-clockwise, too" in text) == (turned_by_worm(hand, place) > 0)
    assert ("the wheel turns clockwise" in text) == (turned_by_worm(hand, place) < 0)


def test_the_links_are_told_to_be_even():
    (said,) = (str(text) for group in view(CHAIN).groups() for text in group.taken if "links" in str(text))
    assert said.startswith("Taken, an even whole number")


@pytest.mark.parametrize(
    ("stage", "wrap", "least"),
    [
        (OPEN, "alpha1", 150),
        (OPEN | {"driven": "60 mm", "distance": "90 mm"}, "alpha2", 150),
        (OPEN | {"distance": "250 mm"}, "alpha1", 150),
        (V, "alpha1", 120),
        (V | {"driven": "400 mm", "ratio": 4, "distance": "260 mm", "length": None}, "alpha1", 120),
    ],
)
def test_the_lesser_wrap_is_judged_by_the_rule(stage, wrap, least):
    shown = view({key: value for key, value in stage.items() if value is not None})
    s = shown.found.s
    other = "alpha2" if wrap == "alpha1" else "alpha1"
    assert s.number(wrap) < s.number(other)
    (text,) = shown.verdicts()
    assert told(text) == {wrap}
    word = "more than" if s.number(wrap) * 180 / math.pi >= least else "less than"
    assert f"{word} the least value {least}° of the usual rule" in str(text)


def test_a_worm_is_told_to_lock_where_it_does():
    (runs,), (locks,) = view(WORM).verdicts(), view(LOCKED).verdicts()
    assert "is not self-locking" in str(runs) and "the worm is self-locking" in str(locks)
    assert told(runs) == told(locks) == {"gamma", "phi"}
