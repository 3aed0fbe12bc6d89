"""What a student states amiss or leaves out, and is told: once, by name, with what to write instead."""

from __future__ import annotations

import pytest
from mistyped import PUMP, lines, typed
from notes import render

from tmm_report import loading, solve

DRIVE = "drive:\n  speed: 1000 rpm\n  stages: [{kind: spur, %s, teeth: [20, 60], module: 2 mm}]\n"


# --- a moment of inertia: not stated, and not of such a link


def test_a_turning_link_with_a_mass_and_no_inertia_is_told():
    (line,) = lines((", inertia: 0.0533", ""))
    assert "mechanism.links.2.mass: warning: link 2 turns and has a mass and no moment of inertia" in line
    assert "inertia: 0" in line


@pytest.mark.parametrize(
    "slips",
    [
        [(", inertia: 0.0533", ", inertia: 0")],  # meant so
        [("mass: 4 кг", "mass: 0"), (", inertia: 0.0533", "")],
        [("inertia: 0.0533", "inertia: 0.053")],
    ],
)
def test_what_is_meant_without_inertia_is_not_told(slips):
    assert lines(*slips) == []


def test_the_inertia_of_the_driving_link_is_asked_only_where_its_speed_changes():
    text = typed((", inertia: 0.000833", ""))
    assert lines(text=text) == []
    (line,) = lines(text=text + "\nreduction: true\n")
    assert "mechanism.links.1.mass" in line


@pytest.mark.parametrize("times", [300, 1000, 1e4, 1 / 1000])
@pytest.mark.parametrize("length", [0.1, 0.28])
def test_an_inertia_is_judged_by_its_own_link(times, length):
    mass = 4.0
    rod = mass * length**2 / 12
    text = f"""
mechanism:
  frame: {{O: [0, 0], C: [{2.2 * length}, 0], P: [0, 0.3]}}
  guides: {{x: {{through: P}}}}
  links:
    1: {{points: {{O: 0, A: {length / 2}}}}}
    2: {{points: {{A: 0, B: {2 * length}}}}}
    3: {{points: {{C: 0, B: {1.4 * length}, S: {length / 2}}}, mass: {mass}, mass_centre: S, inertia: {rod * times}}}
    4: {{points: {{B: 0, E: 1.8}}, mass: 10, mass_centre: E, inertia: 2}}
    5: {{points: [E], slides: x, mass: 10}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{B: left of A-C, E: right}}
loads: {{gravity: 0}}
"""
    (line,) = lines(text=text)
    assert "mechanism.links.3.inertia: warning" in line
    assert "radius of gyration" in line
    assert "did you mean 4" not in line  # the mass is that of such a link
    assert lines(text=text.replace(str(rod * times), str(rod * 2))) == []


@pytest.mark.exhaustive
def test_a_note_without_moments_of_inertia_speaks_of_none():
    text = typed((", inertia: 0.0533", ""))
    while ", inertia: " in text:
        head, rest = text.split(", inertia: ", 1)
        cut = min(rest.index(mark) for mark in "},")
        text = head + rest[cut:]
    note = render(solve(loading.loads(text)), "html", "en")
    note = note if isinstance(note, str) else str(note)
    assert "Dimensions and masses of the links" in note
    assert "moments of inertia about the axes" not in note
    assert "Inertia forces and couples" not in note


# --- a pair of wheels whose ratio has no sign


@pytest.mark.parametrize("ratio", ["ratio: 3", "ratio: '3'"])
def test_a_ratio_without_a_sign_is_asked_about(ratio):
    found = lines(text=DRIVE % ratio)
    assert len(found) == 1
    assert "drive.stages.0.ratio: warning: is the pair external or internal?" in found[0]
    assert "write ratio: -3 for an external pair, or mesh: internal" in found[0]


@pytest.mark.parametrize(
    ("stated", "ratio"),
    [
        ("ratio: -3", -3),
        ("ratio: 3, mesh: external", -3),
        ('ratio: "3", mesh: external', -3),
        ("ratio: -3, mesh: external", -3),
        ("ratio: 3, mesh: internal", 3),
    ],
)
def test_a_pair_said_in_a_word_is_not_asked_about(stated, ratio):
    variant = loading.loads(DRIVE % stated)
    assert variant.doubts == ()
    assert variant.drive.stages[0].ratio == ratio


def test_an_internal_pair_has_no_minus():
    (line,) = lines(text=DRIVE % "ratio: -3, mesh: internal")
    assert "its ratio has no minus; either ratio: 3 or mesh: external" in line


# --- what is not offered is refused by its name


@pytest.mark.parametrize(
    ("kind", "nearest"), [("hypoid", "are kind: bevel and kind: worm"), ("sprocket", "kind: chain")]
)
def test_a_stage_of_another_kind_is_named(kind, nearest):
    (line,) = lines(text=f"drive:\n  speed: 1440 rpm\n  stages: [{{kind: {kind}, ratio: 20}}]\n")
    assert f"there is no kind: {kind}; " in line and nearest in line


@pytest.mark.parametrize("key", ["acceleration", "epsilon"])
def test_an_acceleration_of_the_driving_link_is_named(key):
    (line,) = lines(("speed: 90 об/мин", f"speed: 90 об/мин\n    {key}: 5"))
    assert "stands under law" in line


def test_a_driving_slider_is_named():
    found = lines(("    link: 1\n", "    link: 5\n"))
    assert any("link 5 slides: a driving slider is stated with its stroke" in line for line in found)


@pytest.mark.parametrize("speed", ["-600 rpm", "-15", "-15 рад/с", "−600 об/мин"])
def test_a_negative_speed_is_clockwise_and_has_no_other_rotation(speed):
    text = PUMP.replace("speed: 90 об/мин", f"speed: {speed}")
    driver = loading.loads(text).lever.mechanism.driver
    assert driver.omega < 0
    positive = text.replace(f"speed: {speed}", f"speed: {speed[1:]}\n    rotation: clockwise")
    assert driver.omega == loading.loads(positive).lever.mechanism.driver.omega
    (line,) = lines(("speed: 90 об/мин", f"speed: {speed}\n    rotation: clockwise"))
    assert "the sense of rotation is stated twice" in line


def test_the_frame_is_not_offered_as_a_driving_link():
    (line,) = lines(("    link: 1\n", "    link: 9\n"))
    assert line.endswith("known: 1, 2, 3, 4, 5") or "did you mean" in line
    assert " 0" not in line.split("driver.link:")[1]


# --- names, brackets, keys


def test_the_character_that_may_not_stand_in_a_name_is_named():
    found = lines(text=PUMP.replace("S2", "Центр_2"))
    assert any("Центр_2 is not a name: «_» may not stand in one" in line for line in found)


def test_a_name_that_is_too_long_is_told_so():
    (line,) = lines(("Q: [0, 140 мм]", "Q: [0, 140 мм]\n    ТочкаОпорыКрышки: [0, 0]"))
    assert "it has 16 letters" in line


@pytest.mark.parametrize("written", ["(0, 140 мм)", "0, 140 мм", "0 мм, 140 мм", "(0 мм, -140 мм)"])
@pytest.mark.parametrize("form", ["{{O: [0, 0], Q: {0}}}", "\n    O: [0, 0]\n    Q: {0}"])
def test_coordinates_without_square_brackets_are_shown_with_them(written, form):
    text = (
        "mechanism:\n  frame: "
        + form.format(written)
        + "\n  links: {1: {points: {O: 0, A: 1}}}\n  driver: {link: 1, speed: 5}\n"
    )
    found = lines(text=text)
    inner = written.strip("()")
    assert any(f"[{inner}]" in line and "square brackets" in line for line in found), found


def test_too_many_values_are_not_told_of_a_decimal_comma():
    law = "by_position: [" + ",".join("1" * 13) + "]"
    force = "loads:\n  forces:\n    - {name: F, at: D, direction: left, " + law + "}\n"
    (line,) = lines(text=PUMP[: PUMP.index("loads:")] + force)
    assert "13 values, 12 positions" in line
    assert "comma" not in line


def test_keys_in_another_language_are_told_once():
    (line, *_) = lines(text="тақырып: {тема: Т}\nтетік: {стойка: 1}\nжүктемелер: []\n")
    assert "keys are English words, and these are not: тақырып, тетік, жүктемелер" in line


def test_keys_in_russian_are_told_with_the_english_ones():
    found = lines(text="заголовок: {тема: Т}\nмеханизм: {стойка: 1}\nнагрузки: []\n")
    assert [line.rsplit(": ", 1)[1] for line in found[:3]] == ["title", "mechanism", "loads"]


def test_all_lengths_in_bare_millimetres_are_told_beside_a_mistake():
    slips = [("[380 мм, -120 мм]", "[380, -120]"), ("140 мм", "140")]
    slips += [
        (metres, bare)
        for metres, bare in (("0.1 м", "100"), ("0.4 м", "400"), ("0.28 м", "280"), ("0.35 м", "350"))
    ]
    found = lines(*slips, text=PUMP + "\ndrawing: {accuracy: 0.1}\n")
    assert len(found) == 2
    assert "a bare number is in metres; did you mean 100 мм?" in found[0]
    assert "drawing.accuracy" in found[1]
