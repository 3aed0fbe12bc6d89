"""The fit of a pair as it is stated: limits of the measured sizes, backlash, what is left open, slips."""

import json
import math
import re
from dataclasses import replace

import pytest
from notes import render
from test_spur_stage import CASES, FREE

from tmm_report import course, loading
from tmm_report.chapters.gears.spur.given import Backlash, Inspection
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.problems import ProblemError

PAIR = "kind: spur, module: 4 mm, teeth: [17, 34], mesh: external, shift: [0.25, 0]"
TEXT = "language: en\ndrive:\n  speed: 1000 rpm\n  stages:\n    - {{{}}}\n"


def results(stage):
    return json.loads(render(course.solve(loading.loads(TEXT.format(stage))), "json")["results.json"])


def limits(document):
    """By wheel and size: nominal, with the least thinning and with the greatest, mm."""
    table = {one["key"]: one["values"] for one in document["tables"]["stage1_limits"]["columns"]}
    rows = zip(*(table[key] for key in ("wheel", "size", "nominal", "first", "second")), strict=True)
    return {(wheel, size): [1e3 * x for x in numbers] for wheel, size, *numbers in rows}


def numbers(document):
    return {one["key"].removeprefix("stage1_"): one["value"] for one in document["values"]}


def note(stage, language="en"):
    page = render(course.solve(loading.loads(TEXT.format(stage))), "html", language)["note.html"].decode()
    return re.sub(r"<[^>]+>", " ", page).replace("\N{NO-BREAK SPACE}", " ")


def test_measurement_over_pins_falls_as_a_sheet_says():
    """Teeth thinner by 0.06 mm on the pitch circle; the number is of an independent solver."""
    found = limits(
        results(f"{PAIR}, inspection: {{pins: [7.5 mm, 7 mm]}}, backlash: {{thinning: [0.06 mm, 0]}}")
    )
    nominal, thinner, _ = found["1", "M"]
    assert nominal - thinner == pytest.approx(0.114493509809, rel=1e-9)
    assert found["2", "M"][0] == found["2", "M"][1]


@pytest.mark.parametrize("name", ["free", "internal", "helical", "internal, helical"])
def test_sizes_of_thinned_teeth(name):
    """Each size as that of a wheel with a lesser shift; chords, to the first order, lose what the teeth do."""
    given = {**CASES, "free": FREE}[name]
    thin = 0.05e-3
    found = spur.solve(
        replace(given, backlash=Backlash(thinning=thin, tolerance=thin), inspection=Inspection())
    )
    sizes = {(one.i, one.size): one for one in found.backlash.limits}
    for i, sign in enumerate(found.pair.signs):
        assert sizes[i, "s"].nominal - sizes[i, "s"].least == pytest.approx(thin, rel=1e-9)
        assert sizes[i, "s"].nominal - sizes[i, "s"].most == pytest.approx(2 * thin, rel=1e-9)
        if (i, "W") in sizes:
            fall = sign * (sizes[i, "W"].nominal - sizes[i, "W"].least)
            assert fall == pytest.approx(thin * math.cos(found.pair.rack.alpha), rel=1e-9)
        assert sizes[i, "s_c"].nominal - sizes[i, "s_c"].least == pytest.approx(thin, rel=5e-2)
        assert sizes[i, "s_c"].nominal - sizes[i, "s_c"].most == pytest.approx(2 * thin, rel=5e-2)
        assert sizes[i, "s_y"].nominal - sizes[i, "s_y"].least == pytest.approx(thin, rel=1e-1)
        assert sign * (sizes[i, "M"].nominal - sizes[i, "M"].least) > thin
    assert ((1, "W") in sizes) == (name != "internal, helical")


def test_chords_are_measured_at_the_nominal_height():
    """On the pitch circle the constant chord of thinner teeth falls by the square of a cosine of what they lose; where
    the caliper stands, by all of it."""
    found = limits(results(f"{PAIR}, backlash: {{thinning: 0.1 mm}}"))
    alpha = math.radians(20)
    for wheel, x in (("1", 0.25), ("2", 0.0)):
        nominal, thinner, _ = found[wheel, "s_c"]
        assert nominal == pytest.approx(4 * (math.pi / 2 * math.cos(alpha) ** 2 + x * math.sin(2 * alpha)))
        assert nominal - thinner == pytest.approx(0.1, rel=2e-3)


def test_what_the_two_lengths_are_of():
    """Teeth, shift of the rack, span: the same teeth stated in three ways."""
    alpha = math.radians(20)
    e = 0.06 / (2 * math.tan(alpha)), 0.06 * math.cos(alpha)
    ways = ("thinning: 0.06 mm", f"by: rack, thinning: {e[0]!r} mm", f"by: span, thinning: {e[1]!r} mm")
    found = [limits(results(f"{PAIR}, backlash: {{{way}}}")) for way in ways]
    for key, row in found[0].items():
        assert found[1][key] == pytest.approx(row, rel=1e-12) and found[2][key] == pytest.approx(
            row, rel=1e-12
        )


def test_guaranteed_backlash_thins_the_teeth():
    found = numbers(results(f"{PAIR}, backlash: {{guaranteed: 0.12 mm, axes: 0.04 mm, tolerance: 0.05 mm}}"))
    assert found["j_n_least"] == pytest.approx(0.12e-3, rel=1e-9)
    assert found["thin_1"] == found["thin_2"] and found["field_1"] == pytest.approx(0.05e-3)
    assert found["j_n_most"] > found["j_n_least"]
    wide = numbers(
        results(
            f"{PAIR.replace('17, 34', '18, 34')}, centre_distance: 106.2 mm, backlash: {{guaranteed: 0.1 mm}}"
        )
    )
    assert wide["thin_1"] == 0 and wide["j_n_least"] > 0.1e-3  # the distance leaves more already


def test_enough_or_not_is_said():
    stated = "tolerance: 0.05 mm, axes: 0.04 mm, guaranteed: 0.12 mm"
    assert "less than the guaranteed" in note(f"{PAIR}, backlash: {{thinning: [0.06 mm, 0.09 mm], {stated}}}")
    wide = "thinning: [0.06 mm, 0.06 mm], tolerance: 0.09 mm, axes: 0.01 mm, guaranteed: 0.12 mm"
    assert "the teeth must be thinner, or" in note(f"{PAIR}, backlash: {{{wide}}}")  # the thinnest have more
    assert "no less than the guaranteed" in note(
        f"{PAIR}, backlash: {{thinning: [0.07 mm, 0.09 mm], {stated}}}"
    )
    assert "заклинило" in note(f"{PAIR}, backlash: {{axes: 0.05 mm}}", "ru")
    assert "would jam" not in note(f"{PAIR}, backlash: {{thinning: 0.06 mm}}")


def test_numbers_of_the_norm_are_left_open():
    """Of a grade alone nothing is found: neither limits nor backlash; each field is to be filled in."""
    stage = f"{PAIR}, backlash: {{grade: 8-В}}"  # a Cyrillic letter, as Russian keyboards write it
    document = results(stage)
    assert "stage1_limits" not in document["tables"]
    assert not {"j_n_least", "thin_1", "guaranteed"} & set(numbers(document))
    page = note(stage)
    fields = page[page.index("Fit of pair 1-2 ") :]
    assert fields.count("to be filled in") == 6 and "8-B" in fields


def test_drawings_have_grade_and_deviations():
    asked = "inspection: {drawing_tables: true}"
    bare = note(f"{PAIR}, {asked}")
    whole = note(
        f"{PAIR}, {asked}, backlash: {{grade: 7-6-6-Ba, thinning: [0.06 mm, 0.09 mm], tolerance: 0.05 mm}}"
    )
    assert bare.count("to be filled in") == 2 * 3 + 1 and "7-6-6-Ba" not in bare
    tables = whole[whole.index("for the drawing of wheel 1") : whole.index("Fit of pair")]
    one, two = tables.split("for the drawing of wheel 2")[:2]
    assert re.search(r"−0.056\s*mm;\s*−0.103", one) and re.search(r"−0.085\s*mm;\s*−0.132", two)
    assert "7-6-6-Ba" in one and "7-6-6-Ba" in two


# ---------------------------------------------------------------- slips

SLIPS = {
    "grade: 8": ("grade", "8-B"),
    "grade: 13-B": ("grade", "degrees from 1 to 12"),
    "grade: 8-K": ("grade", "a fit A, B, C, D, E or H"),
    "thinning: 0.06": ("thinning", "0.06 mm?"),
    "thinning: [0.06 mm]": ("thinning", "missing"),
    "thinning: -0.06 mm": ("thinning", "0 … 5 mm"),
    "thinning: 1.2 mm": ("thinning", "more than a quarter of the module"),
    "thinning: 0.6 mm, tolerance: [0.1 mm, 0.6 mm]": ("thinning", "wheel 2 would be thinner by 1.2 mm"),
    "tolerance: 0.05 mm": ("tolerance", "state thinning"),
    "axes: 1.5 mm": ("axes", "more than a quarter"),
    "guaranteed: 2 mm": ("guaranteed", "more than a quarter"),
    "by: arc": ("by", "thickness"),
    "fit: B": ("fit", "unknown key"),
    "thining: 0.06 mm": ("thining", "thinning"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_slips_are_told_at_their_place(slip):
    place, text = SLIPS[slip]
    with pytest.raises(ProblemError) as told:
        course.solve(loading.loads(TEXT.format(f"{PAIR}, backlash: {{{slip}}}")))
    assert len(told.value.problems) == 1
    assert f"backlash.{place}" in str(told.value) and text in str(told.value)


def test_inside_a_helical_ring_no_span_is_thinned():
    with pytest.raises(ProblemError, match=r"backlash.by: inside a helical ring"):
        spur.solve(replace(CASES["internal, helical"], backlash=Backlash(thinning=5e-5, by="span")))
