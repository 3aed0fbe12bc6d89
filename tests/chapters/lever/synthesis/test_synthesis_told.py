"""What is told of a synthesis: what no linkage does, what the mechanism may take of it, and whose motion is asked."""

import pytest
from catalogues import LATIN_UNIT
from synthesised import MECHANISMS

from tmm_report import course, loading
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError

RUSSIAN = Translator("ru").gettext
CRANK = "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m"
TOLD = {
    "{}": ("synthesis", "the kind of the linkage must be stated by one key"),
    "{slider_crank: {stroke: 1 m, ratio: 4}, dwell: {}}": ("synthesis.dwell.crank", "missing"),
    "{slider_crank: {ratio: 4}}": ("synthesis.slider_crank", "the stroke must be stated once"),
    "{slider_crank: {mean_speed: 1 m/s, ratio: 4}}": ("synthesis.slider_crank", "go together"),
    "{slider_crank: {stroke: 1 m, mean_speed: 1 m/s, speed: 60 rpm, ratio: 4}}": (
        "synthesis.slider_crank.speed", "one follows from the two others; stroke, alone or with"),
    "{slotted_link: {stroke: 1 m, K: 1.5, frame: 1 m, pressure_angle: 9 deg, transmission: 80 deg}}": (
        "synthesis.slotted_link.transmission", "make 90° together"),
    "{slotted_link: {stroke: 1 m, crank: 1 m, frame: 1 m, rod_ratio: 2}}": (
        "synthesis.slotted_link.crank", "turning_guide is such a mechanism; less than 1000 mm"),
    "{slotted_link: {stroke: 1 m, K: 1.5, swing: 1 rad, rod_ratio: 2}}": (
        "synthesis.slotted_link", "K or swing, with crank or frame; or crank and frame"),
    "{turning_guide: {stroke: 1 m, K: 1.5, frame: 1 m, rod_ratio: 2, transmission: 70 deg}}": (
        "synthesis.turning_guide.transmission", "comes to 30°"),
    "{slider_crank: {stroke: 1 m}}": ("synthesis.slider_crank", "nothing says how long the rod is"),
    "{slider_crank: {stroke: 1 m, K: 1.2, ratio: 3, offset: 1 cm}}": (
        "synthesis.slider_crank.ratio", "its ratio follows"),
    "{slider_crank: {stroke: 1 m, K: 1.2, ratio: 3, offset_ratio: 1}}": (
        "synthesis.slider_crank.K", "follows from the ratios"),
    "{slider_crank: {stroke: 1 m, ratio: 3, offset_ratio: 2.5}}": (
        "synthesis.slider_crank.offset_ratio", "at most 2 with this ratio"),
    "{slider_crank: {stroke: 120 mm, K: 1.5, pressure_angle: 20 deg}}": (
        "synthesis.slider_crank.pressure_angle", "the least is"),
    "{slider_crank: {stroke: 120 mm, K: 1.2, ratio: 4, pressure_angle: 20 deg}}": (
        "synthesis.slider_crank.pressure_angle", "more than the permitted 20°"),
    "{slider_crank: {stroke: 120 mm, K: 12}}": ("synthesis.slider_crank.K", "1 … 10"),
    f"{{{CRANK}, crank: 170 mm}}}}": ("synthesis.crank_rocker.crank", "less than 165.382 mm"),
    f"{{{CRANK}, crank: 1 mm}}}}": ("synthesis.crank_rocker.crank", "assembled anew"),
    f"{{{CRANK}, rod: 3 m}}}}": ("synthesis.crank_rocker.rod", "less than"),
    f"{{{CRANK}, frame: 3 m}}}}": ("synthesis.crank_rocker.frame", "this distance between the pivots"),
    f"{{{CRANK}, frame: 1 m, rod: 1 m}}}}": ("synthesis.crank_rocker.frame", "stated once"),
    f"{{{CRANK}, crank_at: down}}}}": ("synthesis.crank_rocker.crank_at", "lies that way"),
    "{crank_rocker: {swing: 60 deg, rocker: 0.3 m, crank: 0.1 m}}": ("synthesis.crank_rocker.crank", "half the chord"),
    "{crank_rocker: {swing: 60 deg, rocker: 0.3 m, frame: 0.2 m}}": (
        "synthesis.crank_rocker.frame", "more than 300 mm"),
    "{slotted_link: {stroke: 1 m, K: 1, frame: 1 m, rod: 1 m}}": ("synthesis.slotted_link.K", "different times"),
    "{slotted_link: {stroke: 1 m, K: 1.5, rod: 1 m}}": ("synthesis.slotted_link", "exactly one of: frame, crank"),
    "{slotted_link: {stroke: 1 m, K: 1.5, frame: 1 m, rod: 1 mm}}": ("synthesis.slotted_link.rod", "too short"),
    "{turning_guide: {stroke: 1 m, K: 1.5, frame: 1 m, rod_ratio: 2, pressure_angle: 20 deg}}": (
        "synthesis.turning_guide.pressure_angle", "comes to 30°"),
    "{function: {y: sinh x, x: [1, 2], crank_from: 0, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.y", "log10 x, ln x"),
    "{function: {y: x^2, x: [-1, 1], crank_from: 0, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "equal ones at its ends"),
    "{function: {y: x^2, x: [0, 1], crank_from: 0, crank_turn: 3, rocker_from: 0, rocker_turn: 3, frame: 1 m}}": (
        "synthesis.function", "other angles"),
    "{body: {positions: [[0, 0, 0], [1, 0, 0], [2, 0, 0]], points: [[0, 0], [1, 1]]}}": (
        "synthesis.body.points", "infinitely far"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1], [2, 1, 0]], points: [[0, 0], [0, 0]]}}": (
        "synthesis.body.points", "at one place"),
    "{body: {positions: [[0, 0, 0]], points: [[0, 0], [0, 1]]}}": ("synthesis.body.positions", "2 expected, 1 found"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1]], points: [[0, 0], [0, 1]]}}": (
        "synthesis.body", "the crank must be stated"),
    "{slider_crank: {stroke: 120 mm, ratio: 4}, round: 300 mm}": ("synthesis.round", "at most 60 mm"),
    "{crank_rocker: {K: 1.1, swing: 40 deg, rocker: 300 mm, crank: 102 mm}, round: 140 mm}": (
        "synthesis.round", "no longer goes through its motion"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1]], points: [[0, 0], [0, 1]], crank: 0.4}}": (
        "synthesis.body.crank", "at least 500 mm"),
    "{body: {positions: [[0, 0, 0], [0, 0, 1]], points: [[0, 0], [0, 1]], crank: 0.4}}": (
        "synthesis.body.points", "at one place in both positions"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1], [2, 1, 0]], points: [[0, 0], [0, 1]], rocker: 1}}": (
        "synthesis.body.rocker", "leave it out, or state two positions"),
    "{body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], points: [[0, 0], [80 mm, 20 mm]], crank: 60 mm, "
    "rocker: 60 mm, rocker_pivot: right}}": ("synthesis.body", "another length of the crank, another side"),
    "{body: {positions: [[76 mm, 69 mm, 0 deg], [18 mm, -93 mm, -21 deg], [59 mm, -17 mm, -26 deg]], "
    "points: [[10 mm, 41 mm], [35 mm, -25 mm]]}}": ("synthesis.body.positions", "the order 2, 3, 1"),
    "{body: {positions: [[-26 mm, -6 mm, -13 deg], [21 mm, -64 mm, 30 deg], [39 mm, 7 mm, -35 deg]], "
    "points: [[-35 mm, 38 mm], [29 mm, 62 mm]]}}": ("synthesis.body", "its links do not meet"),
    "{crank_rocker: {swing: 60 deg, rocker: 200 mm, K: 1.3, frame: 600 mm}}": (
        "synthesis.crank_rocker.frame", "from some 200 mm to 298.753 mm"),
    "{crank_rocker: {swing: 60 deg, rocker: 200 mm, K: 1.3, frame: 300 mm}}": (
        "synthesis.crank_rocker.frame", "beyond: true"),
    "{function: {pairs: [[50 deg, 35 deg], [35 deg, 45 deg], [80 deg, 60 deg]], frame: 1 m}}": (
        "synthesis.function.pairs", "in the order"),
    "{function: {pairs: [[30 deg, 40 deg], [50 deg, 60 deg], [80 deg, 90 deg]], frame: 1 m}}": (
        "synthesis.function", "infinitely long"),
    "{slider_crank: {stroke: 120 mm, K: 3.2}}": ("synthesis.slider_crank.K", "less than 3"),
    "{slider_crank: {stroke: 120 mm, K: 1.6, ratio: 19}}": (
        "synthesis.slider_crank.ratio", "at most 6.95263 with this time ratio"),
    "{slider_crank: {stroke: 120 mm, K: 1.2, offset: 450 mm}}": (
        "synthesis.slider_crank.offset", "at most 408.682 mm"),
    "{slotted_link: {stroke: 400 mm, K: 2.2, frame: 420 mm, rod: 33 mm}}": (
        "synthesis.slotted_link.rod", "turns back before the slotted link does; a rod longer than"),
    "{dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [125 mm, 125 mm], "
    "angles: [140 deg, 220 deg, 180 deg]}}": ("synthesis.dwell.angles", "in another order"),
    "{dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [-150 mm, 75 mm], "
    "angles: [30 deg, 90 deg, 150 deg]}}": ("synthesis.dwell.angles", "stand across the slide line"),
    "{function: {y: ln x, x: [2, 1], crank_from: 0, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "goes upwards"),
    "{function: {y: x^-3, x: [-1, 2], crank_from: 1, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "no finite values"),
    "{function: {y: tan x, x: [0, 2], crank_from: 1, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "no finite values"),
    "{function: {y: exp x, x: [0, 800], crank_from: 1, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "no finite values"),
    "{function: {y: x, x: [0, 3], crank_from: 0.2, crank_turn: 1, rocker_from: 0.7, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function", "infinitely long"),
    "{dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [0, 0], angles: [0, 0, 1]}}": (
        "synthesis.dwell.angles", "one line"),
    "{dwell: {crank: 50 mm, coupler: 20 mm, rocker: 20 mm, frame: 200 mm, point: [0, 0], angles: [0, 1, 2]}}": (
        "synthesis.dwell.crank", "cannot turn round"),
}  # fmt: skip


@pytest.mark.parametrize("text", TOLD, ids=[f"{key}-{n}" for n, (key, _) in enumerate(TOLD.values())])
def test_what_cannot_be_is_told(text):
    path, words = TOLD[text]
    told = problems(f"synthesis: {text}\n")
    assert any(problem.key == path and words in problem.text() for problem in told), [
        one.text() for one in told
    ]
    assert not [one for one in told if LATIN_UNIT.search(one.sentence(RUSSIAN))]


def problems(text):
    with pytest.raises(ProblemError) as caught:
        loading.loads(f"language: en\n{text}")
    return caught.value.problems


ONE = MECHANISMS["slider_crank"].format()


def test_the_mechanism_takes_what_there_is():
    (told,) = problems(
        ONE.replace("A: synthesis.crank", "A: 100 mm").replace("synthesis.offset", "0").lstrip()
    )
    assert told.key == "mechanism.links.2.points.B" and "there is no synthesis" in told.text()
    wrong = ONE.replace("B: synthesis.rod", "B: synthesis.rocker")
    (told,) = problems(f"synthesis: {{slider_crank: {{stroke: 120 mm, ratio: 4}}}}\n{wrong}")
    assert told.key == "mechanism.links.2.points.B"
    assert "one of synthesis.crank, synthesis.rod, synthesis.offset" in told.text()


def test_a_mistake_of_the_synthesis_is_told_once():
    (told,) = problems(f"synthesis: {{slider_crank: {{stroke: 120 mm, ratio: 0.4}}}}\n{ONE}")
    assert told.key == "synthesis.slider_crank.ratio"
    (told,) = problems(f"synthesis: {{slider_crank: {{stroke: 120 mm}}}}\n{ONE}")
    assert told.key == "synthesis.slider_crank"


def test_places_and_directions_may_be_taken():
    wrong = ONE.replace("P: [0, synthesis.offset]", "P: [0, l_OA]").replace(
        "{through: P}", "{through: P, angle: synthesis.turn}"
    )
    told = {
        one.key: one.text()
        for one in problems(f"synthesis: {{slider_crank: {{stroke: 120 mm, ratio: 4}}}}\n{wrong}")
    }
    assert "places in the frame follow from no links" in told["mechanism.frame.P.1"]
    assert "the synthesis finds no turn" in told["mechanism.guides.x.angle"]


def test_a_demand_of_one_of_several_sliders_is_asked_about():
    text = "language: en\nsynthesis: {slider_crank: {stroke: 120 mm, ratio: 4}}\n" + ONE
    other = "4: {points: {A: 0, E: synthesis.rod}}, 5: {points: [E], slides: x}"
    more = text.replace("3: {points: [B], slides: x}", f"3: {{points: [B], slides: x}}, {other}")
    more = more.replace("{B: right}", "{B: right, E: left}")
    assert any("several links" in one.text() for one in course.doubts(course.solve(loading.loads(more))))
    named = more.replace("ratio: 4}}", "ratio: 4}, output: E}")
    found = course.solve(loading.loads(named))
    assert not course.doubts(found) and found.synthesis.s.number("stroke_met") == pytest.approx(
        0.12, rel=1e-9
    )
