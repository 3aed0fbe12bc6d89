"""By what wheels are measured: gear sheets of courses to their digits, what is taken where nothing is stated, slips."""

import json
import math
import re
from dataclasses import replace

import pytest
from notes import render
from test_spur_stage import CASES, FREE

from tmm_report import course, loading
from tmm_report.chapters.gears.spur.given import Inspection
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.problems import ProblemError

DIGITS = 1e-9

# An own gear sheet: the form of GOST 16532, answers in mm and degrees by independent solvers. Heights are counted from
# the tips, which are cut down by Δy m.
SHEET = """
kind: spur, module: 5 mm, teeth: [13, 31], centre_distance: 112 mm, shift: [0.42, rest]
"""
ASKED = {
    "span_rule": (2.54449474244, 3.95467863414),
    "span_teeth": (3, 4),
    "W": (39.2484875981, 53.8532030331),
    "rho_W": (19.624243799, 26.9266015165),
    "s_c": (8.28509429086, 6.95407579895),
    "h_c": (5.46293332688, 3.63446170118),
    "s_y": (9.35010691464, 7.87192442495),
    "h_y": (7.30870291578, 5.00001161846),
}
ON_WORKING_CIRCLE = {"s_y": 9.05844311226, "h_y": 6.6912155423}

# Own numbers: wheels over pins, rings between them; z, x, module and pin in mm; a pin's own profile angle, diameters.
PINS = {
    "even": ((24, 0.0, 4, 7), (24.2007636815, 98.9025791498, 105.90257915, 96.2450471179)),
    "odd": ((17, 0.25, 4, 7.5), (29.4428587375, 73.3758573855, 80.5628489137, 69.9945859738)),
    "big": ((45, -0.12, 2.5, 4.5), (22.1980691758, 114.177907595, 118.608353498, 112.554906651)),
    "ring, even": ((60, 0.0, 4, 7), (17.6028845912, 236.605160683, 229.605160683, None)),
    "ring, odd": ((55, 0.35, 3, 5), (20.3997329146, 165.424083015, 160.356621887, None)),
}


def variant(stage):
    line = " ".join(stage.split())
    return f"language: en\ndrive:\n  speed: 1000 rpm\n  stages:\n    - {{{line}}}\n"


def table(stage):
    results = json.loads(render(course.solve(loading.loads(variant(stage))), "json")["results.json"])
    return {one["key"]: one["values"] for one in results["tables"]["stage1_inspection"]["columns"]}


def in_mm(key, value):
    return value if key in ("span_rule", "span_teeth", "alpha_D") else 1e3 * value


def test_the_sheet_of_a_pair():
    found = table(SHEET)
    wrong = {
        (key, i): (in_mm(key, found[key][i]), asked)
        for key, both in ASKED.items()
        for i, asked in enumerate(both)
        if not math.isclose(in_mm(key, found[key][i]), asked, rel_tol=DIGITS)
    }
    assert wrong == {}


def test_the_chord_of_another_circle():
    found = table(SHEET + ", inspection: {chords: [66.1818181818182 mm, 155 mm]}")
    assert {key: 1e3 * found[key][0] for key in ON_WORKING_CIRCLE} == pytest.approx(
        ON_WORKING_CIRCLE, rel=DIGITS
    )


@pytest.mark.parametrize("name", PINS)
def test_measurement_over_pins(name):
    (z, x, module, pin), asked = PINS[name]
    mate = f"mesh: internal, ratio: {z / 20}, teeth: [20, {z}], shift: [{x}, {x}]"
    if "ring" not in name:
        mate = f"ratio: -1, teeth: [{z}, {z}], shift: [{-x}, {x}]"
    found = table(f"kind: spur, module: {module} mm, {mate}, inspection: {{pins: [{pin} mm, {pin} mm]}}")
    have = [in_mm(key, found[key][1]) for key in ("alpha_D", "d_D", "M", "d_k")]
    assert have[: 4 - (asked[3] is None)] == pytest.approx(asked[: 4 - (asked[3] is None)], rel=DIGITS)


def test_thinned_teeth_lower_the_measurement():
    """Thinned by 0.06 mm on the pitch circle, which is a lesser shift, the wheel measures less over its pins."""

    def over(x):
        return (
            spur.solve(
                replace(
                    FREE,
                    module=4e-3,
                    teeth=(17, 34),
                    shift=(x, 0.0),
                    inspection=Inspection(pins=(7.5e-3, 7e-3)),
                )
            )
            .inspected[0]
            .gauge.over(7.5e-3)
        )

    thinner = 0.25 - 0.06 / (2 * 4 * math.tan(math.radians(20)))
    assert 1e3 * (over(0.25) - over(thinner)) == pytest.approx(0.114493509809, rel=1e-8)


# ---------------------------------------------------------------- what is taken where nothing is stated


@pytest.mark.parametrize("name", CASES)
def test_what_is_taken_lies_on_the_teeth(name):
    for of in spur.solve(CASES[name]).inspected:
        g = of.gauge
        assert (of.span is None) == (not g.spannable)
        assert of.span is None or g.active[0] < g.span_touches(of.span) < g.active[1]
        assert of.pin is not None and g.pin_fits(of.pin)
        assert of.circles[0] <= of.circle <= of.circles[1]


def test_the_number_of_teeth_is_the_nearest_that_fits():
    """By the rule 3.7 teeth, but on a narrow face fewer."""
    helical = replace(CASES["helical"], helix=math.radians(30), shift="rule")
    free = spur.solve(replace(helical, width=None)).inspected[1]
    assert free.span == round(free.gauge.rule) > 2
    length = float(free.gauge.span(free.span) * math.sin(free.gauge.beta_b))
    narrow = spur.solve(replace(helical, width=length - 1e-6)).inspected[1]
    assert narrow.span == free.span - 1 and narrow.moved
    assert spur.solve(replace(helical, width=length + 1e-6)).inspected[1].span == free.span
    none = spur.solve(replace(helical, width=2e-3)).inspected[1]
    assert none.span is None and none.why_no_span == "narrow"


def test_the_span_touches_what_works():
    """By the rule 8.26 teeth: 8 would touch the involutes under the active profile; of an undercut wheel the rule
    gives nothing."""
    of = spur.solve(replace(FREE, teeth=(12, 80), ratio=-80 / 12, shift=(1.1, -0.6))).inspected[1]
    assert round(of.gauge.rule) == 8 and 8 in of.gauge.spans(of.gauge.involute)
    assert of.span == 9 and of.moved
    undercut = spur.solve(replace(FREE, shift=(-0.6, 0.5))).inspected[0]
    assert math.isnan(undercut.gauge.rule) and undercut.span == 2 and undercut.moved


def test_a_helical_ring_has_no_span():
    ring = spur.solve(CASES["internal, helical"]).inspected[1]
    assert ring.span is None and ring.why_no_span == "helical ring"


def test_a_pin_that_fits_is_sought():
    """Between high teeth 1.7 modules would not stand out of the tips."""
    of = spur.solve(replace(FREE, rack=Rack(math.radians(20), 1.25, 0.25), shift=(0.5, 0.1))).inspected[0]
    assert not of.gauge.pin_fits(1.7 * 6e-3)
    assert of.pin > 1.7 * 6e-3 and of.gauge.pin_fits(of.pin)
    assert not of.gauge.pin_fits(of.pin - 0.02 * 6e-3)


def test_a_pitch_circle_under_the_root_gives_way():
    of = spur.solve(replace(FREE, teeth=(40, 40), ratio=-1.0, shift=(1.4, -0.6))).inspected[0]
    assert of.gauge.of("d") < of.gauge.of("d_f")
    assert of.circle == pytest.approx(of.gauge.of("d") + 2 * 1.4 * 6e-3)


# ---------------------------------------------------------------- the note


def note(stage, language="en"):
    results = course.solve(loading.loads(variant(stage)))
    page = render(results, "html", language)["note.html"].decode()
    return re.sub(r"<[^>]+>", "", page).replace("\N{NO-BREAK SPACE}", " ")


def test_formulas_and_drawing_tables_are_printed_where_they_are_asked_for():
    usual, asked = note(SHEET), note(SHEET + ", inspection: {drawing_tables: true}")
    for text in ("Sizes by which the teeth of pair 1-2 are measured", "constant chord"):
        assert text in usual and text in asked
    for text in ("the number taken gives the span", "Parameters of the teeth for the drawing of wheel 2"):
        assert text not in usual and text in asked
    assert (
        asked.count("to be filled in") == 2 * 3 + 1
    )  # accuracy, deviations, the other drawing; the sentence
    helical = note(
        SHEET.replace("112", "118").replace("[0.42, rest]", "rule")
        + ", helix: 15 deg, inspection: {drawing_tables: true}"
    )
    assert helical.count("to be filled in") == 2 * 4 + 1  # and the direction of the teeth
    other = note(SHEET + ", rack: {c*: 0.3}, inspection: {drawing_tables: true}")
    assert "GOST 13755" in asked and "GOST 13755" not in other.split("Parameters of the teeth")[1]


def cells(page, caption):
    """Of each row of the table: its places in the results, (key, row)."""
    start = page.index(caption)
    rows = page[start : page.index("</table>", start)].split("<tr>")
    marks = re.compile(r'data-q="(\w+)" data-k="(\d)"')
    return [found for row in rows if (found := [(key, int(k)) for key, k in marks.findall(row)])]


def test_each_wheel_has_its_own_numbers():
    """A column of the sizes is of the wheel that heads it, a drawing table of its wheel but for the mate's teeth."""
    results = course.solve(loading.loads(variant(SHEET + ", inspection: {drawing_tables: true}")))
    page = render(results, "html", "en")["note.html"].decode()
    sizes = cells(page, "Sizes by which the teeth of pair 1-2 are measured</p>")
    assert len(sizes) == 14 and all([k for _, k in row] == [0, 1] for row in sizes)
    for wheel in (0, 1):
        of = [mark for row in cells(page, f"for the drawing of wheel {wheel + 1}</p>") for mark in row]
        assert of == [(key, wheel) for key in ("z", "x", "span_teeth", "W", "d")] + [("z", 1 - wheel)]


def test_what_a_wheel_cannot_be_measured_by_is_said():
    ring = "kind: spur, mesh: internal, ratio: 3, module: 4 mm, teeth: [20, 60], helix: 10 deg, shift: [0, 0]"
    assert "Inside helical ring 2 there is no span" in note(ring)
    narrow = "kind: spur, ratio: -2, module: 4 mm, teeth: [20, 40], helix: 30 deg, width: 2 mm, shift: [0, 0]"
    assert "too narrow for a span" in note(narrow) and "слишком узок" in note(narrow, "ru")


# ---------------------------------------------------------------- slips

SLIPS = {
    "span: [9, 4]": ("span.0", "a span over 9 teeth of wheel 1 does not touch their involutes; from 1 to 3 teeth"),
    "chords: [66 mm, 100 mm]": ("chords.1", "does not cut the involutes of wheel 2; a diameter from 147.6"),
    "pins: [3 mm, 9 mm]": ("pins.0", "stand out of the tips; a diameter from"),
    "pins: [3 mm]": ("pins", "a value of the list is missing; for example, pins: [10 mm, 10 mm]"),
    "pins: [9, 9 mm]": ("pins.0", "did you mean 9 mm?"),
    "span: 3": ("span", "[3, 4]"),
    "rollers: [9 mm, 9 mm]": ("rollers", "pins"),
}  # fmt: skip


@pytest.mark.parametrize("slip", SLIPS)
def test_slips_are_told_at_their_place(slip):
    place, text = SLIPS[slip]
    with pytest.raises(ProblemError) as told:
        course.solve(loading.loads(variant(SHEET + f", inspection: {{{slip}}}")))
    assert len(told.value.problems) == 1
    assert f"inspection.{place}" in told.value.problems[0].text() and text in told.value.problems[0].text()


def test_several_slips_are_told_at_once():
    slips = ", inspection: {span: [9, 40], chords: [10 mm, 20 mm], pins: [1 mm, 1 mm]}"
    with pytest.raises(ProblemError) as told:
        course.solve(loading.loads(variant(SHEET + slips)))
    assert len(told.value.problems) == 6


def test_helical_slips():
    helical = replace(CASES["helical"], width=10e-3, inspection=Inspection(span=(2, 5)))
    with pytest.raises(ProblemError, match="too long for the face width"):
        spur.solve(helical)
    with pytest.raises(ProblemError, match="inside the helical ring 2 there is no span"):
        spur.solve(replace(CASES["internal, helical"], inspection=Inspection(span=(2, 3))))
