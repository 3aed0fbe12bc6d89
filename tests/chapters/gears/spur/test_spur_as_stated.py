"""Pairs as gear sheets state them: one shift and the centre distance, teeth without a ratio."""

import math

import pytest
from test_spur_stage import FREE, GUIDE, replace

from tmm_report import course, loading
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.problems import ProblemError

TEXT = "language: en\ndrive:\n  speed: 1000 rpm\n  stages:\n    - {{kind: spur, module: 5 mm, {}}}\n"


def load(stage):
    return loading.loads(TEXT.format(stage))


def pair(stage):
    return course.solve(load(stage)).drive.stages[0].pair


# ---------------------------------------------------------------- shifts

PAIRS = [("[13, 31]", 112), ("[31, 13]", 112), ("[20, 60]", 101), ("[60, 20]", 101)]


@pytest.mark.parametrize(("teeth", "distance"), PAIRS)
@pytest.mark.parametrize("i", [0, 1])
def test_the_other_shift_follows_from_the_centre_distance(teeth, distance, i):
    """No backlash is left, whichever wheel is stated; and both together, stated, are the same pair."""
    shifts = ["rest", "rest"]
    shifts[i] = "0.25"
    one = pair(f"teeth: {teeth}, centre_distance: {distance} mm, shift: [{shifts[0]}, {shifts[1]}]")
    assert (one.x1, one.x2)[i] == 0.25
    assert one.backlash == pytest.approx(0.0, abs=1e-15)
    mesh = "internal" if one.internal else "external"
    both = pair(f"teeth: {teeth}, shift: [{float(one.x1)!r}, {float(one.x2)!r}], mesh: {mesh}")
    assert both.a_w == pytest.approx(distance * 1e-3, rel=1e-12)


def test_the_rest_is_not_told_as_a_changed_shift():
    assert spur.solve(replace(GUIDE, teeth=(14, 28), shift=(0.2, math.nan))).doubts == ()


SLIPS = {
    "teeth: [13, 31], shift: [0.42, rest]": "shift.1: without a centre distance no shift is left over",
    "teeth: [13, 31], centre_distance: 112 mm, shift: [rest, rest]": "shift: only one shift can be the rest",
    "teeth: [13, 31], centre_distance: 112 mm, shift: [0.42, all]": "shift.1: all is not a number",
    "teeth: [13, 31], centre_distance: 112 mm, shift: [rest, 7]": "shift.1: 7 is out of range",
    "centre_distance: 112 mm": "neither the ratio nor the teeth are stated",
    "teeth: [20, 20], mesh: internal": "teeth: a ring cannot have as many teeth as its pinion",
}


@pytest.mark.parametrize("stage", SLIPS)
def test_slips(stage):
    with pytest.raises(ProblemError) as told:
        course.solve(load(stage))
    assert len(told.value.problems) == 1
    assert SLIPS[stage] in str(told.value)


# ---------------------------------------------------------------- teeth without a ratio

SENSES = {
    "teeth: [13, 31]": (-31 / 13, True),
    "teeth: [20, 20]": (-1.0, False),  # no ring has as many teeth as its pinion
    "teeth: [13, 31], mesh: external": (-31 / 13, False),
    "teeth: [20, 60], mesh: internal": (3.0, False),
    "teeth: [13, 31], centre_distance: 112 mm": (-31 / 13, False),
    "teeth: [20, 60], centre_distance: 101 mm": (3.0, False),
    "teeth: [60, 20], centre_distance: 101 mm": (1 / 3, False),
    "teeth: [20, 60], centre_distance: 205 mm, helix: 12 deg": (-3.0, False),
}


@pytest.mark.parametrize("stage", SENSES)
def test_teeth_without_a_ratio(stage):
    """The sense is asked about only where nothing else says it."""
    ratio, asked = SENSES[stage]
    variant = load(stage)
    assert course.solve(variant).drive.stages[0].ratio == pytest.approx(ratio, rel=1e-15)
    assert [("external or internal?" in doubt.text()) for doubt in variant.doubts] == [True] * asked


def test_a_ratio_that_is_not_stated_is_not_given():
    found = spur.solve(replace(FREE, ratio=math.nan))
    assert found.given.by_teeth
    assert found.wanted == found.ratio == -2.0


# ---------------------------------------------------------------- stated tips

PAIR = "teeth: [13, 31], centre_distance: 112 mm, shift: [0.42, rest]"
RING = "teeth: [25, 75], mesh: internal, shift: [0.4, 0.5]"


def test_stated_tips_are_those_of_the_pair():
    """Contact ratio of a sheet's own diameters by the textbook's formula; usual ones, stated, change nothing."""
    one, two = 78.5, 164.0
    found = pair(f"{PAIR}, tip_diameters: [{one} mm, {two} mm]")
    alpha = math.radians(20)
    alpha_w = math.acos(110 * math.cos(alpha) / 112)
    turned = [13 * (math.tan(math.acos(65 * math.cos(alpha) / one)) - math.tan(alpha_w))]
    turned.append(31 * (math.tan(math.acos(155 * math.cos(alpha) / two)) - math.tan(alpha_w)))
    assert float(found.eps) == pytest.approx(sum(turned) / (2 * math.pi), rel=1e-12)
    assert [1e3 * float(d) for d in found.d_a] == pytest.approx([one, two], rel=1e-15)
    for stage in (PAIR, RING):
        usual = pair(stage)
        same = pair(f"{stage}, tip_diameters: [{float(usual.d_a[0])!r}, {float(usual.d_a[1])!r}]")
        assert float(same.eps) == pytest.approx(float(usual.eps), rel=1e-12)
        assert same.s_a == pytest.approx(usual.s_a, rel=1e-9) and same.clearance == pytest.approx(
            usual.clearance
        )


TIP_SLIPS = {
    f"{PAIR}, tip_diameters: [90 mm, 164 mm]": ("tip_diameters.0", "to 81.44 mm"),
    f"{PAIR}, tip_diameters: [78 mm, 140 mm]": ("tip_diameters.1", "from 142.56 to 167.3 mm"),
    f"{PAIR}, tip_diameters: [78 mm, 164]": ("tip_diameters.1", "164 mm?"),
    f"{PAIR}, tip_diameters: [78 mm]": ("tip_diameters", "missing"),
    f"{PAIR}, tip_diameter: [78 mm, 164 mm]": ("tip_diameter", "tip_diameters"),
    f"{RING}, tip_diameters: [125 mm, 380 mm]": ("tip_diameters", "do not reach each other"),
}


@pytest.mark.parametrize("stage", TIP_SLIPS)
def test_slips_of_stated_tips(stage):
    place, text = TIP_SLIPS[stage]
    with pytest.raises(ProblemError) as told:
        course.solve(load(stage))
    assert f".{place}" in str(told.value) and text in str(told.value)


def test_a_ring_whose_tips_run_into_its_pinion_is_told():
    usual = pair(RING)
    least = 2 * float(usual.a_w) + float(usual.d_f[0])
    pair(f"{RING}, tip_diameters: [{float(usual.d_a[0])!r}, {least + 1e-4!r}]")
    with pytest.raises(ProblemError, match=r"tip_diameters\.1"):
        pair(f"{RING}, tip_diameters: [{float(usual.d_a[0])!r}, {least - 1e-4!r}]")
