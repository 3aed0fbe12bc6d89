"""A cam that stands alone: as the pair of a lever mechanism, phase by phase, and what is told of it amiss."""

import json
import math

import numpy as np
import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.problems import ProblemError

LAW = "phases: [{rise: 110 deg, law: %s}, {dwell: 30 deg}, {return: 120 deg, law: polynomial}, {dwell: rest}]"
PAIRED = LAW.replace("rest", "100 deg")


def alone(cam: str) -> course.Results:
    return course.solve(loading.loads(f"cam: {{{cam}}}"))


def pair(cam: str, follower: str, sense: str, frame: str = "") -> course.Results:
    """The same cam in a mechanism of two links."""
    return course.solve(
        loading.loads(f"""
mechanism:
  frame: {{O: [0, 0]{frame}}}
  guides: {{y: {{through: Q, angle: 90 deg}}}}
  links:
    1: {{points: {{O: 0}}}}
    2: {follower}
  driver: {{link: 1, speed: 10 rad/s, rotation: {sense}, zero: {{angle: 0 deg}}}}
  cams: {{k: {{follower: 2, {cam}}}}}
positions: {{table: 24}}
""")
    )


def numbers(results: course.Results) -> tuple[dict, dict]:
    found = json.loads(render(results, "json")["results.json"])
    tables = {
        name: {one["key"]: one["values"] for one in table["columns"]}
        for name, table in found["tables"].items()
    }
    return {one["key"]: (one["value"], one.get("at_deg")) for one in found["values"]}, tables


SLIDES, SWINGS = "{points: [B], slides: y}", "{points: {C: 0, B: 120 mm}}"
SAME = {
    "roller": (
        "roller: 9 mm, base: 40 mm, lift: 22 mm, offset: 8 mm",
        "roller: {at: B, radius: 9 mm}, base: 40 mm, lift: 22 mm", SLIDES, ", Q: [%s8 mm, 0]", "",
    ),
    "knife on the other side": (
        "follower: knife, base: 40 mm, lift: 22 mm, offset: -8 mm",
        "roller: {at: B}, base: 40 mm, lift: 22 mm", SLIDES, ", Q: [%s-8 mm, 0]", "",
    ),
    "flat": (
        "follower: flat, base: 60 mm, lift: 22 mm",
        "flat: {at: B}, base: 60 mm, lift: 22 mm", SLIDES, ", Q: [0, 0]", "",
    ),
    "lever": (
        "roller: 9 mm, base: 40 mm, swing: 16 deg, arm: 120 mm, centre_distance: 130 mm, side: with",
        "roller: {at: B, radius: 9 mm}, base: 40 mm, swing: 16 deg", SWINGS, ", Q: [1, 0], C: [%s-130 mm, 0]", "left",
    ),
    "flat lever": (
        "follower: flat, base: 40 mm, swing: 9 deg, centre_distance: 130 mm, face_offset: 6 mm, side: with",
        "flat: {at: B, angle: 0 deg}, base: 40 mm, swing: 9 deg",
        "{points: {C: 0, B: [120 mm, %s-6 mm]}}", ", Q: [1, 0], C: [%s-130 mm, 0]", "left",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SAME)
@pytest.mark.parametrize("sense", ["counter-clockwise", "clockwise"])
def test_alone_it_is_as_in_a_mechanism(name, sense):
    """Key by key, of all that both have: the places of guide and pivot are those of a drawing by hand."""
    own, paired, follower, frame, side = SAME[name]
    sign = "" if sense == "counter-clockwise" else "-"
    sides = {"left": "left" if not sign else "right"}

    def signed(text: str) -> str:
        return text.replace("%s", sign).replace("--", "")

    law = f"side: {sides[side]}, {PAIRED % 'cosine'}" if side else PAIRED % "cosine"
    values, tables = numbers(alone(f"{own}, rotation: {sense}, positions: 24, {LAW % 'cosine'}"))
    theirs, others = numbers(pair(f"{paired}, {law}", signed(follower), sense, signed(frame)))
    named = {key.removesuffix("_k"): value for key, value in theirs.items() if key.endswith("_k")}
    common = values.keys() & named.keys()
    assert {"cam_base", "cam_lift", "cam_alpha_rise", "cam_alpha_return", "cam_rho"} <= common
    for key in common:
        assert values[key][0] == pytest.approx(named[key][0], rel=1e-10, abs=1e-13), key
        assert (values[key][1] is None) == (named[key][1] is None), key
    for table, twin in (("cam_motion_table", "cam_motion_k_table"), ("cam_profile", "cam_profile_k")):
        for key, column in others[twin].items():
            own_column = np.array(tables[table][key.removesuffix("_k")], dtype=float)
            assert own_column == pytest.approx(np.array(column, dtype=float), rel=1e-12, abs=1e-12), (
                table,
                key,
            )


def test_signed_pressure_angles_are_the_ends_over_closed_phases():
    results = alone(f"roller: 10 mm, base: 40 mm, lift: 30 mm, offset: 15 mm, {LAW % 'uniform'}")
    values, _ = numbers(results)
    (one,) = results.cam.cams
    e, s0, h = 15e-3, math.sqrt(50e-3**2 - 15e-3**2), 30e-3
    slope = h / math.radians(110)
    at = np.linspace(0, 1, 200001)
    alpha = np.degrees(np.arctan((slope - e) / (s0 + h * at)))  # by the formula of a translating roller
    assert values["cam_alpha_rise_max"] == pytest.approx((alpha.max(), 0.0), rel=1e-9)
    assert values["cam_alpha_rise_min"] == pytest.approx((alpha.min(), 110.0), rel=1e-9)
    assert values["cam_alpha_rise"][0] == pytest.approx(np.abs(alpha).max(), rel=1e-9)
    fall = np.linspace(140, 260, 100001)
    back = np.degrees(one.at(np.radians(fall)).alpha)
    assert values["cam_alpha_return_min"][0] == pytest.approx(back.min(), abs=1e-6)
    assert values["cam_alpha_return_max"][0] == pytest.approx(back[:-1].max(), abs=1e-2)


def test_a_phase_by_equal_parts_ends_with_its_own_derivatives():
    h, beta = 24e-3, math.radians(90)
    _, tables = numbers(
        alone("roller: 8 mm, base: 40 mm, lift: 24 mm, phases: [{rise: 90 deg, law: parabolic, divisions: 6}, "
              "{dwell: equal}, {return: 120 deg, law: cosine, divisions: 4}, {dwell: equal}]")
    )  # fmt: skip
    rise, back = tables["cam_divisions_1"], tables["cam_divisions_3"]
    tau = np.arange(7) / 6
    s = np.where(tau < 0.5, 2 * tau**2, 1 - 2 * (1 - tau) ** 2) * h
    assert rise["cam_S"] == pytest.approx(s, abs=1e-15)
    assert rise["cam_S2"] == pytest.approx(np.where(tau < 0.5 - 1e-9, 4, -4) * h / beta**2)
    assert rise["phi"] == pytest.approx(15 * np.arange(7))
    assert back["phi"] == pytest.approx(165 + 30 * np.arange(5)) and back["part"] == [0, 1, 2, 3, 4]
    share = np.arange(5) / 4  # the two dwells are equal: 75 degrees each
    assert back["cam_S2"] == pytest.approx(
        -(math.pi**2) * h / 2 / math.radians(120) ** 2 * np.cos(math.pi * share)
    )


def test_without_dwells_under_a_flat_face_with_harmonic_motion_the_cam_is_a_circle():
    values, tables = numbers(
        alone("follower: flat, base: 25 mm, lift: 50 mm, positions: 36, "
              "phases: [{rise: 180 deg, law: cosine}, {dwell: 0 deg}, {return: 180 deg, law: cosine}, {dwell: 0}]")
    )  # fmt: skip
    x, y = (np.array(tables["cam_profile"][key]) for key in ("cam_x", "cam_y"))
    assert x**2 + (y + 25e-3) ** 2 == pytest.approx(np.full(x.shape, 50e-3**2))
    assert values["cam_face"][0] == pytest.approx(50e-3)
    assert len(tables["cam_phases"]["number"]) == 2  # the dwells of no angle are none


def test_a_speed_makes_velocities_and_accelerations():
    _, tables = numbers(alone(f"roller: 8 mm, base: 40 mm, lift: 24 mm, speed: -150 rpm, {LAW % 'sine'}"))
    motion, omega = tables["cam_motion_table"], 150 * math.pi / 30
    assert motion["cam_v"] == pytest.approx(omega * np.array(motion["cam_S1"]))
    assert motion["cam_a"] == pytest.approx(omega**2 * np.array(motion["cam_S2"]))
    turned = np.radians(motion["phi"])
    t, near = turned / omega, 1e-5
    (one,) = alone(f"roller: 8 mm, base: 40 mm, lift: 24 mm, speed: -150 rpm, {LAW % 'sine'}").cam.cams
    inner = slice(1, 4)
    rate = (one.at(omega * (t + near)).S - one.at(omega * (t - near)).S) / (2 * near)
    assert motion["cam_v"][inner] == pytest.approx(rate[inner], rel=1e-6)


SIDES = [
    ("counter-clockwise", "against", 1), ("counter-clockwise", "right", 1), ("counter-clockwise", "with", -1),
    ("counter-clockwise", "left", -1), ("clockwise", "against", 1), ("clockwise", "left", 1), ("clockwise", "with", -1),
    ("clockwise", "right", -1),
]  # fmt: skip


@pytest.mark.parametrize(("sense", "side", "sign"), SIDES)
def test_the_side_of_an_offset_in_words(sense, side, sign):
    """Against the rotation the surface comes up there, so that the offset lessens the angle of the rise."""
    results = alone(
        f"roller: 8 mm, base: 40 mm, lift: 24 mm, offset: 9 mm, side: {side}, rotation: {sense}, {LAW % 'sine'}"
    )
    assert numbers(results)[0]["cam_offset"][0] == pytest.approx(sign * 9e-3)


def test_both_meanings_of_the_base_circle():
    own = numbers(alone(f"roller: 8 mm, base: 40 mm, lift: 24 mm, {LAW % 'sine'}"))
    pitch = numbers(alone(f"roller: 8 mm, pitch_base: 48 mm, lift: 24 mm, {LAW % 'sine'}"))
    assert own[0]["cam_pitch_base"][0] == pytest.approx(48e-3)
    assert {key: x[0] for key, x in own[0].items()} == pytest.approx(
        {key: x[0] for key, x in pitch[0].items()}
    )


SIZES = "base: 40 mm, lift: 20 mm"
BAD = [
    (f"{SIZES}, {LAW % 'sine'}", "cam", "how the follower touches"),
    (f"follower: roller, {SIZES}, {LAW % 'sine'}", "cam", "radius of the roller is missing"),
    (f"follower: flat, roller: 5 mm, {SIZES}, {LAW % 'sine'}", "cam", "one of them"),
    (f"roller: 5 mm, pitch_base: 40 mm, {SIZES}, {LAW % 'sine'}", "cam", "stated twice"),
    (f"roller: 5 mm, pitch_base: 4 mm, lift: 20 mm, {LAW % 'sine'}",
     "cam.pitch_base", "larger than the least radius"),
    (f"roller: 5 mm, {SIZES}, offset: free, {LAW % 'sine'}", "cam.offset", "smallest cam"),
    (f"roller: 5 mm, {SIZES}, side: with, {LAW % 'sine'}", "cam.side", "passes on no side"),
    (f"roller: 5 mm, {SIZES}, offset: -5 mm, side: with, {LAW % 'sine'}", "cam.offset", "twice"),
    (f"roller: 5 mm, base: 40 mm, swing: 20 deg, arm: 90 mm, {LAW % 'sine'}", "cam", "distance between the pivots"),
    (f"roller: 5 mm, base: 40 mm, swing: 20 deg, centre_distance: 90 mm, {LAW % 'sine'}",
     "cam", "length of the swinging"),
    (f"roller: 5 mm, base: 40 mm, swing: 20 deg, arm: 90 mm, centre_distance: 90 mm, {LAW % 'sine'}",
     "cam", "the side"),
    (f"roller: 5 mm, base: 40 mm, swing: 20 deg, arm: 90 mm, centre_distance: 90 mm, side: with, offset: 5 mm, "
     f"{LAW % 'sine'}", "cam.offset", "no offset"),
    (f"follower: flat, {SIZES}, face_offset: 5 mm, {LAW % 'sine'}", "cam.face_offset", "swings"),
    (f"roller: 5 mm, {SIZES}, speed: 0 rpm, {LAW % 'sine'}", "cam.speed", "does not turn"),
    (f"roller: 5 mm, {SIZES}, speed: -5 rpm, rotation: clockwise, {LAW % 'sine'}", "cam.speed", "twice"),
    (f"roller: 5 mm, {SIZES}, phases: [{{rise: 200 deg, law: sine}}, {{return: 200 deg, law: sine}}, {{dwell: rest}}]",
     "cam.phases", "nothing of the turn is left"),
    (f"roller: 5 mm, {SIZES}, phases: [{{rise: 200 deg, law: sine}}, {{return: 100 deg, law: sine}}]",
     "cam.phases", "make 300"),
    (f"roller: 5 mm, base: 40 mm, {LAW % 'sine'}", "cam", "lift is missing"),
    ("roller: 5 mm, profile: {tangent: {base: 30 mm, nose: 40 mm, lift: 8 mm}}", "cam.profile", "above zero"),
    ("roller: 5 mm, profile: {tangent: {base: 30 mm, nose: 9 mm}}", "cam.profile.tangent", "2 of these sizes"),
    ("roller: 5 mm, profile: {arcs: {base: 30 mm, nose: 9 mm, lift: 8 mm}}", "cam.profile.arcs", "3 of these sizes"),
    ("roller: 5 mm, profile: {arcs: {base: 30 mm, nose: 9 mm, lift: 8 mm, distance: 29 mm}}",
     "cam.profile.arcs", "make the third"),
    ("roller: 5 mm, profile: {arcs: {base: 30 mm, nose: 9 mm, lift: 8 mm, flank: 25 mm}}",
     "cam.profile", "less curved"),
    ("roller: 5 mm, profile: {arcs: {base: 30 mm, nose: 9 mm, lift: 8 mm, half_angle: 20 deg}}",
     "cam.profile", "hollow"),
    ("roller: 5 mm, profile: {tangent: {base: 30 mm, nose: 9 mm, half_angle: 100 deg}}", "cam.profile", "do not meet"),
    ("follower: flat, profile: {tangent: {base: 30 mm, nose: 9 mm, lift: 8 mm}}", "cam.profile", "jumps"),
    ("roller: 5 mm, arm: 20 mm, centre_distance: 90 mm, side: with, profile: {tangent: {base: 30 mm, nose: 9 mm, "
     "lift: 8 mm}}", "cam.profile", "does not reach"),
    ("roller: 5 mm, lift: 8 mm, profile: {tangent: {base: 30 mm, nose: 9 mm, lift: 8 mm}}", "cam.lift", "follows"),
    (f"roller: 5 mm, base: 40 mm, swing: 20 deg, arm: 90 mm, centre_distance: free, side: with, {LAW % 'sine'}",
     "cam.centre_distance", "smallest cam"),
    (f"roller: 5 mm, base: smallest, swing: 20 deg, arm: 90 mm, centre_distance: 80 mm, side: against, {LAW % 'sine'}",
     "cam.base", "no cam keeps"),
    (f"roller: 5 mm, base: smallest, swing: 150 deg, arm: 90 mm, centre_distance: free, side: with, "
     f"return_angle_limit: 30 deg, {LAW % 'sine'}", "cam.base", "no place of the cam's axis"),
]  # fmt: skip


@pytest.mark.parametrize(("cam", "path", "words"), BAD)
def test_a_mistake_is_told_at_its_key(cam, path, words):
    with pytest.raises(ProblemError) as raised:
        loading.loads(f"cam: {{{cam}}}")
    told = [(".".join(map(str, p.path)), p.wrong.text % p.wrong.values) for p in raised.value.problems]
    assert any(where == path and words in text for where, text in told), told


def test_it_stands_beside_a_mechanism_that_has_nothing_to_do_with_it():
    text = """
language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links: {1: {points: {O: 0, A: 50 mm}}, 2: {points: {A: 0, B: 200 mm}}, 3: {points: [B], slides: x}}
  driver: {link: 1, speed: 10 rad/s}
  assembly: {B: right}
cam: {roller: 8 mm, base: 40 mm, lift: 24 mm, %s}
""" % (LAW % "sine")
    results = course.solve(loading.loads(text))
    assert results.lever.cams is None and results.cam.cams
    assert [name for name, _ in course.chapters(results)][-1] == "cam"
    note = render(results, "html")["note.html"].decode()
    assert "Cam mechanism" in note and "Kinematic" in note
