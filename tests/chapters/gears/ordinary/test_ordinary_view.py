"""What the note says of an ordinary stage: which numbers are given, which are taken and how; its tables."""

import re

import pytest
from test_drive import PLANETARY, solve
from test_ordinary import BEVEL, CHAIN, OPEN, RINGED, TRAIN, WORM, V

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
