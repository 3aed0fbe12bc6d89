"""What the note says of a drive from its machine back to the motor: every word beside the number that it is of."""

import re

import pytest
from notes import render
from test_drive_power import DRUM, MOTORS, OPEN, PAIR, solve, values

from tmm_report import course, loading
from tmm_report.chapters.gears.drive.quantities import tables
from tmm_report.chapters.gears.drive.view import DriveView
from tmm_report.i18n import Translator
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

BELT = {"kind": "belt", "ratio": 2, "driving": "100 mm", "driven": "200 mm", "efficiency": 0.94}
TWO = OPEN | {"teeth": [22, "rest"], "efficiency": 0.96}
MACHINE = DRUM | {"efficiency": 0.9}
LOSSES = {"bearings": 0.99, "coupling": 0.98}


def shown(found):
    return DriveView(found, Page(Html(), Translator("en"), Numbering()), "drive").power_view


def note(keys, stages="{kind: spur, teeth: [20, 60], efficiency: 0.97}"):
    text = f"language: en\ndrive: {{{keys}, stages: [{stages}]}}\n"
    return render(course.solve(loading.loads(text)), "html")["note.html"].decode()


def of_rows(text):
    """The rows of which a text has numbers of a table."""
    return [int(row) for row in re.findall(r'data-k="(\d+)"', str(text))]


def test_the_losses_stand_beside_their_parts():
    found = solve(BELT, OPEN, TWO, output=MACHINE, motors=MOTORS, ratio_range=[25, 30], **LOSSES)
    rows = [[str(cell) for cell in row] for row in shown(found).losses_table().parts[0].rows]
    assert rows == [
        ["stage 1–2", "0.94", "1"], ["stage 3–4", "0.97", "1"], ["stage 5–6", "0.96", "1"],
        ["pairs of bearings", "0.99", "4"], ["couplings", "0.98", "1"],
        ["working member of the machine", "0.90", "1"],
    ]  # fmt: skip


def test_the_motors_stand_beside_their_loads():
    found = solve(BELT, OPEN, TWO, output=DRUM, motors=MOTORS, ratio_range=[25, 30])
    rows = shown(found).motors_table().parts[0].rows
    needed, turns = 2720 / (0.94 * 0.97 * 0.96), 60 * 0.85 / (3.14159265 * 0.315)
    for row, (name, power, speed) in zip(rows, MOTORS, strict=True):
        assert str(row[0]) == name
        own, n = float(power.split()[0]), float(speed.split()[0])
        assert [float(cell) for cell in row[1:5]] == pytest.approx(
            [own, n, n / turns, needed / 1000 / own], rel=1e-3
        )


@pytest.mark.parametrize(
    ("stages", "split", "said"),
    [
        ([OPEN, TWO], "equal", "divided equally"),
        ([OPEN, TWO], {"slow": 0.88}, "so that the slow stage has"),
        ([OPEN, TWO], {"fast": 1.2}, "so that the fast stage has"),
        ([OPEN, TWO], {"step": 1.25}, "each stage has"),
        ([OPEN, PAIR], "equal", "falls to the one stage"),
    ],
)
def test_the_rule_is_told_that_divides_the_ratio(stages, split, said):
    assert said in str(shown(solve(*stages, output=DRUM, motors=[MOTORS[3]], split=split)).rule)


def test_stated_teeth_are_told_apart_from_those_that_are_sought():
    view = shown(solve(OPEN, OPEN | {"teeth": ["rest", 70]}, output=DRUM, motors=[MOTORS[3]]))
    wheels = view.table("sought")["wheel"].values
    assert [wheels[row] for row in of_rows(view.stated_teeth())] == ["1", "4"]
    assert [wheels[row] for row in of_rows(view.rounded())] == ["2", "3"]


def test_the_formulas_are_of_the_shaft_that_is_named():
    text = note("speed: 90 rpm, output: {power: 2 kW}")
    rows = of_rows(text.partition("For shaft 1:")[2].partition("The other shafts")[0])
    assert set(rows) == {0, 1}  # from those of the one before


@pytest.mark.parametrize("at", ["after bearings", "before bearings"])
@pytest.mark.parametrize("by", ["required", "rated"])
def test_it_is_told_where_the_powers_are_and_with_which_they_begin(at, by):
    text = note(
        f"motors: [[m, 3 kW, 90 rpm]], output: {{power: 2 kW}}, bearings: 0.99, shafts: {{at: {at}, by: {by}}}"
    )
    assert ("before the loss in its own bearings" in text) == (at == "before bearings")
    assert ("counted from the rated power" in text) == (by == "rated")
    assert ("counted from the power needed" in text) == (by == "required")


@pytest.mark.parametrize("stated", [True, False])
def test_the_usual_range_is_told_where_none_is_stated(stated):
    motors = ", ".join(f"[{', '.join(one)}]" for one in MOTORS)
    drum = "output: {force: 3.2 kN, speed: 0.85 m/s, diameter: 315 mm}"
    asked = ", ratio_range: [10, 60]" if stated else ""
    open_ = "{kind: spur, teeth: [20, rest]}"
    text = note(f"motors: [{motors}], {drum}{asked}", f"{open_}, {open_}")
    assert ("is the product of the usual ones" in text) == (not stated)


def test_the_overload_is_told_in_per_cent():
    made = {
        one.key: one.value
        for one in values(PAIR, output=DRUM, motors=[["m", "3 kW", "154 rpm"]], overload="5 %")
    }
    assert made["drive_overload"] == pytest.approx(5)


def test_the_forces_in_the_teeth_are_told_of_the_driving_wheel_first():
    found = solve(PAIR, PAIR, speed="900 rpm", output={"power": "2 kW"})
    (loaded,) = (table for table in tables(found) if table.name == "drive_mesh_loads")
    assert list(loaded["mesh"].values) == ["1-2", "3-4"]
    forces = loaded["F_t"].values
    assert forces[1] / forces[0] == pytest.approx(3 * 0.97)
