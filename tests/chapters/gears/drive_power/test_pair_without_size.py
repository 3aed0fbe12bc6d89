"""A pair of wheels of which no module is stated: its ratio, its place in the train and in the diagrams, no forces."""

import pytest
from notes import render
from test_drive_power import DRUM, PAIR, PLANETARY, solve
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.gears.drive.quantities import tables

BARE = {"kind": "spur", "teeth": [22, 66], "efficiency": 0.97}
RING = {"kind": "spur", "teeth": [20, 75], "mesh": "internal"}


@pytest.mark.parametrize(
    "stage", [BARE, RING, BARE | {"ratio": 3, "teeth": [30, 91]}, RING | {"teeth": [75, 20]}]
)
@pytest.mark.parametrize("around", [[], [PAIR], [PLANETARY]])
def test_by_willis_and_as_the_diagrams_have_it(stage, around):
    found = solve(*around, stage, *around, speed="900 rpm")
    pair = found.stages[len(around)]
    one, two = pair.given.teeth
    ratio = two / one if pair.given.sense > 0 else -two / one
    assert found.speed[pair.input] / found.speed[pair.output] == pytest.approx(ratio, rel=1e-12) == pair.ratio
    assert disagreements(pair.s, {"u": ratio}) == []
    for row in found.plans.comparison:
        assert abs(row.graph - row.analytic) <= 0.5001 * row.floor, row.key


def test_the_sense_by_the_word_and_by_the_sign():
    for stated, sense in (
        ({"ratio": 3}, 1),
        ({"ratio": 3, "mesh": "external"}, -1),
        ({}, -1),
        ({"ratio": -3}, -1),
    ):
        pair = solve(BARE | stated, speed="9 rpm").stages[0]
        assert pair.given.sense == sense and pair.ratio == 3 * sense


def test_it_has_no_forces_and_others_of_the_drive_have():
    found = solve(PAIR, BARE, speed="900 rpm", output=DRUM)
    (loaded,) = (table for table in tables(found) if table.name == "drive_mesh_loads")
    assert list(loaded["mesh"].values) == ["1-2"]
    assert not [
        table for table in tables(solve(BARE, speed="900 rpm", output=DRUM)) if "mesh_loads" in table.name
    ]


def test_alone_it_is_asked_about_and_under_a_machine_it_is_not():
    text = "drive: {speed: 90 rpm, %s stages: [{kind: spur, teeth: [20, 60]}]}"
    asked, machine = loading.loads(text % ""), loading.loads(text % "output: {power: 2 kW}, ")
    (line,) = [problem.text() for problem in asked.doubts]
    assert "no module is stated" in line and not list(machine.doubts)


def test_what_names_a_size_is_a_pair_with_a_module():
    from tmm_report.problems import ProblemError

    with pytest.raises(ProblemError, match="module"):
        loading.loads("drive: {speed: 90 rpm, stages: [{kind: spur, teeth: [20, 60], shift: rule}]}")


@pytest.mark.parametrize("stage", [BARE, RING])
def test_its_note(stage):
    teeth = ", ".join(map(str, stage["teeth"]))
    mesh = f", mesh: {stage['mesh']}" if "mesh" in stage else ""
    text = f"drive: {{speed: 90 rpm, stages: [{{kind: spur, teeth: [{teeth}]{mesh}}}]}}\nlanguage: en\n"
    note = render(course.solve(loading.loads(text)), "html")["note.html"].decode()
    assert "No module is stated" in note and "nan" not in note
