"""What is told of a cam pair that cannot be, and of which key."""

import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

LAW = "phases: [{rise: 100 deg, law: sine}, {dwell: 30 deg}, {return: 120 deg, law: polynomial}, {dwell: 110 deg}]"
ROLLER = "roller: {at: B, radius: 8 mm}"


def variant(cam: str, more: str = "") -> str:
    return f"""
mechanism:
  frame: {{O: [0, 0], C: [100 mm, 0]}}
  guides: {{y: {{through: O, angle: 90 deg}}}}
  links:
    1: {{points: {{O: 0}}}}
    2: {{points: {{B: 0}}, slides: y}}
  driver: {{link: 1, speed: 10 rad/s}}
  cams: {{k: {{{cam}}}}}
{more}"""


def told(cam: str, more: str = "") -> list[tuple[str, str]]:
    with pytest.raises(ProblemError) as raised:
        loading.loads(variant(cam, more))
    return [(".".join(map(str, p.path)), p.wrong.text % p.wrong.values) for p in raised.value.problems]


SIZES = f"follower: 2, {ROLLER}, base: 40 mm, lift: 20 mm"
GOOD = f"follower: 2, {ROLLER}, base: 40 mm, lift: 20 mm, {LAW}"
BAD = [
    (f"{SIZES}, phases: [{{rise: 100 deg, law: sine}}, {{return: 100 deg, law: sine}}]",
     "mechanism.cams.k.phases", "make 200°"),
    (f"{SIZES}, phases: [{{return: 180 deg, law: sine}}, {{rise: 180 deg, law: sine}}]",
     "mechanism.cams.k.phases", "take turns"),
    (
        "follower: 2, roller: {at: B, radius: 20 mm}, base: 10 mm, lift: 20 mm, "
        "phases: [{rise: 40 deg, law: sine}, {return: 40 deg, law: sine}, {dwell: 280 deg}]",
        "mechanism.cams.k.base",
        "undercut",
    ),
    (f"follower: 2, flat: {{at: B}}, base: 12 mm, lift: 20 mm, {LAW}", "mechanism.cams.k.base", "convex"),
    (f"follower: 2, {ROLLER}, base: 40 mm, swing: 20 deg, {LAW}", "mechanism.cams.k.swing", "a lift"),
    (f"follower: 2, {ROLLER}, base: 40 mm, {LAW}", "mechanism.cams.k", "lift is missing"),
    (f"follower: 2, {ROLLER}, lift: 20 mm, {LAW}", "mechanism.cams.k", "base is missing"),
    (f"follower: 3, {ROLLER}, base: 40 mm, lift: 20 mm, {LAW}", "mechanism.cams.k.follower", "no link 3"),
    (f"follower: 1, {ROLLER}, base: 40 mm, lift: 20 mm, {LAW}", "mechanism.cams.k.follower", "cannot be the follower"),
    (f"follower: 2, cam: 2, {ROLLER}, base: 40 mm, lift: 20 mm, {LAW}", "mechanism.cams.k.cam", "driving link"),
    (f"follower: 2, roller: {{at: D}}, base: 40 mm, lift: 20 mm, {LAW}", "mechanism.cams.k.roller", "point D"),
    (f"follower: 2, {ROLLER}, flat: {{at: B}}, base: 40 mm, lift: 20 mm, {LAW}", "mechanism.cams.k", "one way"),
    (f"follower: 2, {ROLLER}, base: 40 mm, lift: 20 mm", "mechanism.cams.k", "one way"),
    (f"follower: 2, {ROLLER}, base: 40 mm, lift: 20 mm, phases: [{{dwell: 360 deg, law: sine}}]",
     "mechanism.cams.k.phases.0", "a dwell has none"),
    (f"follower: 2, {ROLLER}, centre: O, base: 40 mm, lift: 20 mm, {LAW}", "mechanism.cams.k", "also called O"),
    ("follower: 2, roller: {at: B}, profile: {circle: {radius: 10 mm, at: [20 mm, 0]}}",
     "mechanism.cams.k.profile", "outside"),
    (f"follower: 2, {ROLLER}, base: 10 mm, profile: {{circle: {{radius: 10 mm, at: [5 mm, 0]}}}}",
     "mechanism.cams.k.base", "follows"),
    ("follower: 2, roller: {at: B}, profile: {polar: [[0, 10 mm], [90 deg, 20 mm]]}",
     "mechanism.cams.k.profile", "at least 8"),
    (f"follower: 2, {ROLLER}, base: 40 mm, lifts: [[0 deg, 0 mm], [90 deg, 20 mm]]",
     "mechanism.cams.k.lifts", "at least 8"),
]  # fmt: skip


@pytest.mark.parametrize(("cam", "path", "words"), BAD)
def test_a_mistake_is_told_at_its_key(cam, path, words):
    assert any(where == path and words in text for where, text in told(cam)), told(cam)


def test_the_right_one_is_read():
    assert loading.loads(variant(GOOD)).lever.mechanism.cams[0].name == "k"


def test_a_swinging_follower_needs_its_side():
    text = variant(f"follower: 2, {ROLLER}, base: 40 mm, swing: 20 deg, {LAW}").replace(
        "2: {points: {B: 0}, slides: y}", "2: {points: {C: 0, B: 90 mm}}"
    )
    with pytest.raises(ProblemError) as raised:
        loading.loads(text)
    assert "side" in raised.value.problems[0].wrong.text


def test_a_link_too_many_is_told_with_higher_pairs():
    text = variant(GOOD).replace("slides: y}", "slides: y}\n    3: {points: {B: 0, E: 50 mm}}")
    with pytest.raises(ProblemError) as raised:
        course.solve(loading.loads(text))
    assert raised.value.problems[0].wrong.values["higher"] == 1
