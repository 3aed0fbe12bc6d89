"""The planetary stage as a chapter: what it offers the drive, what a user is told, what the note prints."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pydantic import ValidationError

from tmm_report.chapters.gears.planetary.block import PlanetaryModel, build
from tmm_report.chapters.gears.planetary.draw import front
from tmm_report.chapters.gears.planetary.quantities import search as listing
from tmm_report.chapters.gears.planetary.quantities import stage as tables
from tmm_report.chapters.gears.planetary.solve.stage import Found, solve
from tmm_report.chapters.gears.planetary.view.stage import PlanetaryView
from tmm_report.figures.drawing import svg
from tmm_report.i18n import Translator
from tmm_report.mechanics.gears import trains
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.planetary.search import Reason
from tmm_report.mechanics.gears.planetary.stage import EXTERNAL
from tmm_report.mechanics.gears.tooth_outlines import external, over_pitch, ring
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.report.paper.sheets import USUAL

SINGLE = {
    "kind": "planetary",
    "ratio": 6.56,
    "module": "5 mm",
    "satellites": 3,
    "input": "sun",
    "output": "carrier",
}
TWO = {"kind": "planetary", "module": "4 mm", "satellites": [2, 4]}
STAGES = {
    "sun-ring": SINGLE,
    "teeth": {**SINGLE, "teeth": [20, 46, 112], "fixed": "ring"},
    "shift": {**SINGLE, "teeth": [20, 45, 112], "coaxiality": "shift"},
    "ring shifted": {**SINGLE, "teeth": [20, 46, 110], "coaxiality": "shift", "satellites": [2, 5], "tolerance": "5 %"},
    "differential": {**SINGLE, "second": {"member": "ring", "speed": "-500 rpm"}},
    "external-external": {**TWO, "scheme": "external-external", "ratio": -20, "input": "carrier", "output": "wheel1"},
    "external-internal": {
        **TWO, "scheme": "external-internal", "ratio": 12, "module": ["5 mm", "4 mm"],
        "input": "wheel1", "output": "carrier",
    },
    "internal-internal": {**TWO, "scheme": "internal-internal", "ratio": 40, "input": "carrier", "output": "wheel1"},
    "ordinary": {**SINGLE, "ratio": -5.6, "output": "ring", "fixed": "carrier"},
}  # fmt: skip


def given(**block):
    single = block.get("scheme", "sun-ring") == "sun-ring"
    return build(
        PlanetaryModel.model_validate(block), ("1", "2", "3", "H") if single else ("1", "2", "2'", "3", "H")
    )


@cache
def solved(name: str) -> Found:
    return solve(given(**STAGES[name]))


@pytest.fixture(params=STAGES)
def found(request) -> Found:
    return solved(request.param)


def test_members_and_meshes_make_a_train_of_the_same_ratio_and_efficiency(found):
    train = trains.Train(found.members, found.meshes)
    held = found.given.member(found.given.task.held)
    speed = trains.speeds(train, {found.input: 1.0, held: 0.0})
    assert float(speed[found.output]) == pytest.approx(1 / found.ratio, rel=1e-9)
    loads = trains.loads(train, speed, {found.input: 1.0}, (held, found.output))
    assert float(loads.efficiency) == pytest.approx(found.efficiency, rel=1e-9)
    torque = found.torques
    assert float(loads.torque[held]) == pytest.approx(torque[found.given.task.held], rel=1e-9)
    assert sum(torque.values()) == pytest.approx(0, abs=1e-9)


def test_the_rolling_circles_of_the_members_touch(found):
    """Radii and distances of what the drive draws: the circles of each mesh have one point in common."""
    by = {member.name: member for member in found.members}
    arm = by[found.given.member("carrier")].radius
    for mesh, row in zip(found.meshes, (0, 1), strict=True):
        central = by[mesh.i if row == 0 else mesh.j]
        satellite = by[mesh.j if row == 0 else mesh.i]
        if found.scheme.single and found.shifted and row == 1:
            continue  # one crown rolls on two circles; the member carries that of the first mesh
        sign = -1 if mesh.internal else 1
        assert abs(central.radius + sign * satellite.radius) == pytest.approx(arm, rel=1e-9)


def test_the_satellites_share_the_moment_alike(found):
    one, _ = found.forces
    moment = one * found.satellites * float(found.sizes.working[0]) / 2
    assert moment == pytest.approx(abs(found.torques["wheel1"]), rel=1e-12)


def test_a_differential_has_two_inputs():
    found = solved("differential")
    assert found.fixed == () and found.second == ("3", pytest.approx(-500 * np.pi / 30))
    assert found.ratio == pytest.approx(solved("sun-ring").ratio)  # with the ring at rest
    assert solved("sun-ring").fixed == ("3",)


# --- mistakes


@pytest.mark.parametrize(
    ("more", "wrong", "right"),
    [
        ({"ratio": 30}, "no teeth give the ratio 30 within 4 % with 3", "from 2.388 to 12.71, the nearest is"),
        ({"ratio": -3}, "no teeth give the ratio -3", "the nearest is"),
        ({"satellites": 7}, "with 7 planet gears", "for example, teeth [17, 37, 91] with 3 planet gears do"),
        ({"teeth": [21, 46, 112]}, "different centre distances, 167.5 mm and 165 mm", "coaxiality: shift makes up"),
        ({"teeth": [15, 46, 130]}, "different centre distances", "for example, teeth [17, 37, 91]"),
        ({"teeth": [20, 48, 116], "ratio": 6.1}, "the ratio 6.8, further than 4 % from 6.1", "for example"),
        ({"teeth": [15, 34, 83]}, "the wheel with 15 teeth is undercut", "at least 17 teeth"),
        (
            {"teeth": [17, 19, 55], "ratio": 4.2},
            "the planet gear and of the ring interfere: [17, 19, 55]", "for example",
        ),
        ({"teeth": [20, 46, 112], "satellites": 4}, "4 planet gears overlap by 6.6", "there is room for 3"),
        ({"teeth": [21, 47, 115]}, "3 equally spaced planet gears cannot be assembled", "2, 4, 8 planet gears can"),
    ],
)  # fmt: skip
def test_what_a_user_is_told(more, wrong, right):
    with pytest.raises(ProblemError) as error:
        solve(given(**{**SINGLE, **more}))
    text = str(error.value)
    assert wrong in text and right in text
    assert all("\n" not in problem.text() for problem in error.value.problems)


def test_all_conditions_that_fail_are_told_at_once():
    with pytest.raises(ProblemError) as error:
        solve(given(**{**SINGLE, "teeth": [15, 30, 75], "satellites": 4, "ratio": 9}))
    texts = [problem.text() for problem in error.value.problems]
    assert len(texts) == 4  # ratio 6, undercut, no room, 90/4


def test_every_mistake_of_given_teeth_says_what_would_work():
    """Also where no teeth at all give the ratio, so that there is no example of teeth."""
    block = {**TWO, "scheme": "external-external", "input": "carrier", "output": "wheel1", "ratio": -10000}
    teeth = {"teeth": [40, 39, 40, 41], "coaxiality": "shift", "external_teeth": [30, 50]}
    with pytest.raises(ProblemError) as error:
        solve(given(**block, **teeth))
    assert all(problem.right is not None for problem in error.value.problems)


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"teeth": [20, 46.5, 112]}, "46.5"),
        ({"teeth": [20, 46]}, "too_short"),
        ({"teeth": [20, 46, 46, 112]}, "3 numbers of teeth, not 4"),
        ({"teeth": [5, 46, 112]}, "5 is out of range"),
        ({"output": "sun"}, "one member has two parts"),
        ({"fixed": "carrier"}, "one member has two parts"),
        ({"fixed": "ring", "second": {"member": "ring", "speed": 1}}, "both fixed and driven"),
        ({"scheme": "external-external"}, "has no sun"),
        ({"module": ["5 mm", "4 mm"]}, "one module"),
        ({"satellites": [5, 2]}, "range from 5 to 2 is empty"),
        ({"ratio": 0}, "no planetary stage has the ratio 0"),
    ],
)
def test_bad_blocks(more, told):
    with pytest.raises(ValidationError) as error:
        PlanetaryModel.model_validate({**SINGLE, **more})
    assert told in str(error.value) + str([e["type"] for e in error.value.errors()])


# --- the note


def rendered(found: Found, language: str = "en") -> str:
    page = Page(Html(), Translator(language), Numbering())
    names = ("t", "math", "sym", "value", "num", "unit", "listed")
    shared = {"page": page, **{name: getattr(page, name) for name in names}}
    shared["m"] = template("macros.html.j2").make_module(shared)
    page.numbering.section("Gears")
    view = PlanetaryView(found, page, "drive1")
    return page.numbering.resolved(template("chapters/gears/planetary.j2").render({**shared, "view": view}))


def plain(text: str) -> str:
    return re.sub(r"\s+", "", re.sub(r"<[^>]*>", "", text))


def test_the_note_of_every_kind_of_stage(found):
    text = re.sub(r"(?:Table|Figure)\d+—", "", plain(rendered(found)))
    assert "—" not in text and "∞" not in text  # what is not a number
    for teeth in found.teeth:
        assert str(teeth) in text


def test_the_conditions_are_printed_as_in_the_guide():
    text = plain(rendered(solved("teeth")))
    assert "z1+z2=20+46=66=z3−z2=112−46=66" in text
    assert "285.79" in text and "mm>da2=240" in text
    assert "20+112344" in text or "C=z1+z3k=20+1123=44" in text
    assert "=0.983" in text


def test_rejected_and_accepted_make_up_all(found):
    page = Page(Html(), Translator("en"), Numbering())
    reasons = PlanetaryView(found, page, "x").reasons()
    counts = [int(count) for count in re.findall(r"\(<span[^>]*>(\d+)</span>\)", reasons)]
    assert sum(counts) == found.candidates.examined and len(counts) == reasons.count(";") + 1


# --- the picture


def test_the_picture_is_true_to_scale(found):
    drawing, mm = front(found, "stage"), 1 / found.scale
    circles = {round(item.radius, 6) for item in drawing.items if hasattr(item, "radius")}
    wheels = (0, 1, 3) if found.scheme.single else (0, 1, 2, 3)
    for values in (found.sizes.trimmed, found.sizes.working):
        for wheel in wheels:
            assert round(float(values[wheel]) / 2 * mm, 6) in circles
    assert USUAL.fits(drawing.size)
    assert svg(drawing).count("<circle") > 2 * found.satellites


# --- tables


def test_the_list_of_all_candidates():
    found = solve(given(**SINGLE))
    table = listing.candidates(found)
    rows = list(listing.listing(table))
    assert len(rows) == 1 + found.candidates.examined
    accepted = [row for row in rows[1:] if row.endswith("accepted")]
    assert len(accepted) == len(found.ranking) and rows[1:][: len(accepted)] == accepted
    assert [int(word) for word in rows[1].split()[:4]] == [found.teeth[i] for i in (0, 1, 3)] + [
        found.satellites
    ]
    verdicts = next(column for column in table.columns if column.key == "verdict").values
    assert np.sum(verdicts == Reason.RATIO) == found.candidates.count(Reason.RATIO) > 0


def test_tables_have_columns_of_one_length(found):
    for table in tables.tables(found, "stage1"):
        assert len({len(column.values) for column in table.columns}) == 1
    numbers = {value.key: value.value for value in tables.values(found, "stage1")}
    assert numbers["stage1_u"] == found.ratio and numbers["stage1_gap"] > 0


def test_a_rack_whose_teeth_come_to_a_point_is_refused():
    stage = given(**SINGLE)
    with pytest.raises(ProblemError) as caught:
        solve(replace(stage, task=replace(stage.task, rack=Rack(np.radians(35), 2.0))))
    assert [problem.path for problem in caught.value.problems] == [("rack",)]


def test_another_choice_of_satellites_only_changes_what_depends_on_them():
    stage = given(**SINGLE)
    more = solve(replace(stage, task=replace(stage.task, satellites=(2, 3, 4))))
    few = solve(stage)
    for reason in (Reason.RATIO, Reason.COAXIALITY, Reason.UNDERCUT, Reason.INTERFERENCE):
        assert more.candidates.count(reason) == few.candidates.count(reason)


@pytest.mark.parametrize("name", ["teeth", "external-internal", "internal-internal"])
def test_drawn_teeth_of_ring_and_satellite_do_not_overlap(name):
    """Of full height the tips of the ring would cut into the satellites' fillets; as trimmed they do not."""
    found = solved(name)
    sizes, task = found.sizes, found.given.task
    for row, wheel, crown in ((0, 0, 1), (1, 3, 2)):
        if task.scheme.rows[row] == EXTERNAL:
            continue
        m, x = task.modules[row], sizes.shifts
        satellite = external(found.teeth[crown], m, float(x[crown]), task.rack)
        outer = ring(found.teeth[wheel], m, float(x[wheel]), task.rack, tip=float(sizes.trimmed[wheel]) / 2)
        overlaps, _ = over_pitch(satellite, outer, float(sizes.centre_distance), 8)
        assert overlaps.max() < 1e-12
