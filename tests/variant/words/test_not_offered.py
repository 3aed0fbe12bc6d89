"""What textbooks have and the program lacks is known: it is not offered, and what is nearest is named."""

import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TEXT = """language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links: {1: {points: {O: 0, A: 1}}, 2: {points: {A: 0, B: 3}}, 3: {points: [B], slides: x}}
  driver: {link: 1, speed: 1}
  assembly: {B: right}
loads:
  forces: [{at: B, direction: left, constant: 1}]
  moments: [{on: 2, direction: clockwise, constant: 1}]
"""
SLIPS = {
    "mechanism.driver.acceleration": ("speed: 1}", "speed: 1, acceleration: 2}", "if not uniformly, stands under law"),
    "mechanism.driver.link": ("link: 1,", "link: 3,", "a driving slider is stated with its stroke"),
    "mechanism.gears": ("  assembly:", "  gears: []\n  assembly:", "mechanism.wheels"),
    "mechanism.belts": ("  assembly:", "  belts: []\n  assembly:", "a stage of the block drive, kind: belt"),
    "mechanism.links.3.rolls": ("slides: x", "slides: x, rolls: x", "mechanism.rolling"),
    "mechanism.springs": ("  assembly:", "  springs: []\n  assembly:", "loads.springs"),
    "mechanism.links.3.rack": ("slides: x", "slides: x, rack: {module: 4 mm}", "mechanism.racks"),
    "mechanism.links.3.teeth": ("slides: x", "slides: x, teeth: 20", "mechanism.wheels"),
    "loads.spring": ("loads:\n", "loads:\n  spring: {}\n", "stand in lists"),
    "loads.torsional_springs": ("loads:\n", "loads:\n  torsional_springs: []\n", "in the list torsion_springs"),
    "loads.torsional_dampers": ("loads:\n", "loads:\n  torsional_dampers: []\n", "that turn links are not offered"),
    "loads.moments.0.by_velocity": ("clockwise, constant: 1", "clockwise, by_velocity: [[0, 1]]", "by the speed"),
    "gears": ("loads:\n", "gears: [20, 40]\nloads:\n", "stages of the block drive"),
}  # fmt: skip


@pytest.mark.parametrize("key", SLIPS)
def test_what_is_not_offered_says_so(key):
    right, wrong, words = SLIPS[key]
    assert TEXT.count(right) == 1
    with pytest.raises(ProblemError) as caught:
        loading.loads(TEXT.replace(right, wrong))
    told = {problem.key: problem.text() for problem in caught.value.problems}
    assert words in told[key]


STAGE = "drive: {{speed: 1000 rpm, stages: [{{kind: {}, ratio: 20}}]}}"
NAMED = {
    STAGE.format("worm gear"): ("drive.stages.0", "kind: worm"),
    STAGE.format("червяк"): ("drive.stages.0", "kind: worm"),
    STAGE.format("mitre"): ("drive.stages.0", "kind: bevel"),
    STAGE.format("hypoid"): (
        "drive.stages.0",
        "the nearest stages of the block drive are kind: bevel and kind: worm",
    ),
    STAGE.format("v_belt"): ("drive.stages.0", "kind: belt"),
    STAGE.format("roller chain"): ("drive.stages.0", "kind: chain"),
    STAGE.format("idler"): ("drive.stages.0", "kind: train"),
    STAGE.format("wave gear"): ("drive.stages.0", "kind: planetary"),
    STAGE.format("волновая"): ("drive.stages.0", "kind: planetary"),
    STAGE.format("rack and pinion"): ("drive.stages.0", "mechanism.racks"),
    STAGE.format("variator"): ("drive.stages.0", "kind: friction"),
    STAGE.format("дифференциал"): ("drive.stages.0", "kind: planetary"),
    "synthesis: {geneva: {slots: 6}}": ("synthesis.geneva", "has dwells"),
    "synthesis: {six_bar: {}}": ("synthesis.six_bar", "slotted_link, turning_guide and dwell only"),
    "synthesis: {cam: {}}": ("synthesis.cam", "mechanism.cams"),
    "synthesis: {path: {}}": ("synthesis.path", "positions of a body are"),
    "synthesis: {whitworth: {}}": ("synthesis.whitworth", "did you mean turning_guide?"),
    "synthesis: {crank_slider: {}}": ("synthesis.crank_slider", "did you mean slider_crank?"),
    "contacts: [{kind: clutch}]": ("contacts.0", "contacts, kind: pivot"),
    "contacts: [{kind: band brake}]": ("contacts.0", "contacts, kind: belt"),
    "contacts: [{kind: screw jack}]": ("contacts.0", "kind: screw"),
    "governor: {kind: hartnell}": ("governor.kind", "bell_crank"),
    "governor: {porter: {}}": ("governor.porter", "are arms"),
    "dynamics: {motor: {stepper: {}}, parts: [{name: a, inertia: 1}]}": (
        "dynamics.motor.stepper",
        "by_speed",
    ),
    "dynamics: {motor: {kind: asynchronous}, parts: [{name: a, inertia: 1}]}": (
        "dynamics.motor.kind",
        "induction",
    ),
    "dynamics: {clutch: {}, parts: [{name: a, inertia: 1}]}": ("dynamics.clutch", "on and off of a regime"),
    "мальтийский механизм: {}": ("мальтийский механизм", "Geneva wheels are not offered"),
    "motor: {moment: 30 N*m}": ("motor", "dynamics: {motor: {…}}"),
    "двигатель: {moment: 30 N*m}": ("двигатель", "dynamics: {motor: {…}}"),
    "ratchets: []": ("ratchets", "ratchets are not offered"),
    "cardan: {}": ("cardan", "law of the driving link"),
    "spatial_linkage: {}": ("spatial_linkage", "all links move in one plane"),
}


@pytest.mark.parametrize(
    "text", NAMED, ids=[f"{key}-{n}".replace(" ", "_") for n, (key, _) in enumerate(NAMED.values())]
)
def test_what_textbooks_have_is_known_by_its_name(text):
    key, words = NAMED[text]
    with pytest.raises(ProblemError) as caught:
        loading.loads(f"language: en\n{text}\n")
    told = {problem.key: problem.text() for problem in caught.value.problems}
    assert words in told[key]


ONE_SLIP = (
    "governor: {kind: hartnell}",
    "governor: {type: porter, balls: {mass: 1 kg}}",
    "motor: {moment: 30 N*m}",
)


@pytest.mark.parametrize("text", ONE_SLIP)
def test_one_slip_is_told_once(text):
    with pytest.raises(ProblemError) as caught:
        loading.loads(f"language: en\n{text}\n")
    assert len(caught.value.problems) == 1


def test_a_governor_of_no_kind_is_still_told():
    with pytest.raises(ProblemError, match="nothing says what kind of governor it is"):
        loading.loads("language: en\ngovernor: {balls: {mas: 1 kg}}\n")


IN_THE_MECHANISM = {
    "mechanism.driver.solenoid": ("link: 1,", "solenoid: 3, link: 1,", "stated by its stroke"),
    "mechanism.driver.universal_joint": ("speed: 1}", "speed: 1, universal_joint: {}}", "law of the driving link"),
    "mechanism.cams.K.groove": ("  assembly:", "  cams: {K: {groove: 1}}\n  assembly:", "of a cam alone"),
    "mechanism.cams.K.mushroom": ("  assembly:", "  cams: {K: {mushroom: 1}}\n  assembly:", "flat: {at: B}"),
    "mechanism.cams.K.knife": ("  assembly:", "  cams: {K: {knife: 1}}\n  assembly:", "a roller with radius: 0"),
    "mechanism.wheels.0.mesh": (
        "  assembly:", "  wheels: [{links: [1, 2], ratio: 2, mesh: bevel}]\n  assembly:", "kind: bevel"),
}  # fmt: skip


@pytest.mark.parametrize("key", IN_THE_MECHANISM)
def test_what_a_mechanism_has_not_is_known_by_its_name(key):
    right, wrong, words = IN_THE_MECHANISM[key]
    with pytest.raises(ProblemError) as caught:
        loading.loads(TEXT.replace(right, wrong))
    told = {problem.key: problem.text() for problem in caught.value.problems}
    assert words in told[key]


def test_a_ratio_without_a_sign_is_asked_about():
    text = "language: en\ndrive: {speed: 1000 rpm, stages: [{kind: spur, ratio: 3, teeth: [20, 60], module: 2 mm}]}\n"
    asked = [one.text() for one in course.doubts(course.solve(loading.loads(text)))]
    assert any("is the pair external or internal?" in one and "ratio: -3" in one for one in asked), asked


def test_the_text_itself_is_right():
    assert loading.loads(TEXT).lever is not None
