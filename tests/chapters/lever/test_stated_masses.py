"""Masses and moments of inertia stated by lengths and other masses: `30 kg/m`, `0.3*m2`, `m*l^2/12`."""

import json
import math
import re

import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results

from tmm_report import solve
from tmm_report.loading import loads
from tmm_report.mechanics.lever.stated_masses import LengthOf, MassOf, PerLength, dimension, worked
from tmm_report.problems import ProblemError
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import closed

TEXT = """language: {language}
mechanism:
  frame: {{O: [0, 0], C: [200 mm, 20 mm]}}
  links:
    1: {{points: {{O: 0, A: 60 mm}}, inertia: 0.004 kg*m^2}}
    2: {{points: {{A: 0, B: 180 mm, D: [100 mm, 20 mm]}}, mass: {rod}, mass_centre: D, inertia: {of_rod}}}
    3: {{points: {{C: 0, B: 120 mm{centre}}}, mass: {rocker}, inertia: {of_rocker}{named}}}
  driver: {{link: 1, speed: 180 rpm}}
  assembly: {{B: left of A-C}}
loads: {{gravity: 9.81 m/s^2, moments: [{{on: 3, direction: against motion, constant: 25 N*m}}]}}
"""
SAID = {
    "rod": "12 kg/m * l_AB", "of_rod": "0.17·m·l_AB²", "rocker": "0.7*m2", "of_rocker": "ml²/12",
    "centre": "", "named": "",
}  # fmt: skip
# the same worked out by hand
ROD, ROCKER = 12 * 0.18, 0.7 * 12 * 0.18
NUMBERS = {
    "rod": f"{ROD!r} kg", "of_rod": f"{0.17 * ROD * 0.18**2!r} kg*m^2", "rocker": f"{ROCKER!r}",
    "of_rocker": f"{ROCKER * 0.12**2 / 12!r}", "centre": ", S3: 60 mm", "named": ", mass_centre: S3",
}  # fmt: skip


def text(language: str = "en", **other: str) -> str:
    return TEXT.format(language=language, **SAID | other)


def tables(variant: str) -> dict[str, dict[str, list]]:
    document = json.loads(render(solve(loads(variant)), "json")["results.json"])
    return {
        name: {column["key"]: column["values"] for column in table["columns"]}
        for name, table in document["tables"].items()
    }


def test_the_results_are_those_of_the_numbers_that_it_comes_to():
    stated, plain = tables(text()), tables(TEXT.format(language="en", **NUMBERS))
    assert list(stated) == list(plain)
    assert stated["masses"].pop("q") == [None, 12, None]
    for name, table in plain.items():
        for key, values in table.items():
            same = [
                x if isinstance(x, str) or x is None else pytest.approx(x, rel=1e-12, abs=1e-12)
                for x in values
            ]
            assert stated[name][key] == same, f"{name}.{key}"


def test_about_another_point_it_is_brought_to_the_mass_centre():
    masses = tables(text(of_rocker="{value: m*l^2/3, about: C}"))["masses"]
    assert masses["J_about"][2] == pytest.approx(ROCKER * 0.12**2 / 3, rel=1e-14)
    assert masses["J"][2] == pytest.approx(ROCKER * 0.12**2 / 12, rel=1e-13)


@pytest.mark.parametrize(
    ("length", "metres"),
    [
        ("l_BD", math.hypot(0.08, 0.02)),
        ("l_DB", math.hypot(0.08, 0.02)),
        ("l_OC", math.hypot(0.2, 0.02)),
        ("l3", 0.12),
    ],
)
def test_any_segment_of_a_link_or_of_the_frame_may_be_named(length, metres):
    variant = text(rod=f"12 kg/m * {length}")
    masses = tables(variant)["masses"]
    assert masses["m"][1] == pytest.approx(12 * metres, rel=1e-14)
    found = solve(loads(variant))
    note = read(render(found, "html")["note.html"].decode())
    document = json.loads(render(found, "json")["results.json"])
    wrong(
        [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_results(note), *unmarked(note)]
    )


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_note_works_them_out(language):
    variant = text(language, of_rocker="{value: m*l^2/3, about: C}")
    found = solve(loads(variant))
    note = read(render(found, "html")["note.html"].decode())
    document = json.loads(render(found, "json")["results.json"])
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)])
    wrong([*unmarked(note), *wrong_results(note)])
    plain = render(found, "tex")["note.tex"].decode()
    for formula in ("m_{2}=q_{2}\\cdot l_{AB}", "m_{3}=0", "\\frac{m_{3}\\cdot l_{CB}^{2}}{3}"):
        assert formula in plain
    assert ("S$_{3}$ between C and B" if language == "en" else "S$_{3}$ между C и B") in plain


# ---------------------------------------------------------------- the grammar

SIZES = {PerLength: 12.0, MassOf: 2.5, LengthOf: 0.3}
ATOMS = st.sampled_from(["m2", "l_AB", "l", "2", "0.17", "m", "3.5"])
EXPRESSIONS = st.recursive(
    ATOMS,
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from(["+", "-", "*", "/"]), inner).map(
            lambda of: f"({of[0]} {of[1]} {of[2]})"
        ),
        st.tuples(inner, st.integers(1, 3)).map(lambda of: f"({of[0]})^{of[1]}"),
    ),
    max_leaves=5,
)


@settings(max_examples=examples(200))
@given(EXPRESSIONS)
def test_a_statement_is_worth_what_its_letters_make(written):
    """Against Python's own reading of the same text."""
    if len(written) > closed.LONGEST:
        return
    own = re.sub(r"m2|m", "2.5", re.sub(r"l_AB|l", "0.3", written)).replace("^", "**")
    try:
        value = eval(own)
        assert worked(closed._read(written), lambda letter: SIZES[type(letter)]) == pytest.approx(
            value, rel=1e-12
        )
    except ZeroDivisionError:
        with pytest.raises(ZeroDivisionError):
            worked(closed._read(written), lambda letter: SIZES[type(letter)])


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("ml²/12", 2.5 * 0.09 / 12), ("0,17 m l_AB²", 0.17 * 2.5 * 0.09), ("1/12 m l^2", 2.5 * 0.09 / 12),
        ("m·(l_AB/2)²", 2.5 * 0.0225), ("m_2*l2**2/3", 2.5 * 0.09 / 3), ("2 m2 l l_AB", 2 * 2.5 * 0.09),
        ("m*(90 mm)^2/2", 2.5 * 0.0081 / 2), ("0.5 m (0,04 m)^2", 0.5 * 2.5 * 0.0016), ("m*(2 in)^2", 2.5 * 0.0508**2),
        ("-m*l^2 + m*(60 см)²", 2.5 * (0.36 - 0.09)), ("0.5*m2*12 in*l", 0.5 * 2.5 * 0.3048 * 0.3),
        ("м·l²/12", 2.5 * 0.09 / 12), ("(m + m2)*l^2/3", 5 * 0.09 / 3),
    ],
)  # fmt: skip
def test_moments_of_inertia_as_they_are_printed(written, value):
    found = closed.inertia(written)
    assert dimension(found) == closed.INERTIA
    assert worked(found, lambda letter: SIZES[type(letter)]) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("30 kg/m", 30 * 0.3), ("30 кг/м", 30 * 0.3), ("3 g/mm", 3 * 0.3), ("0,03 т/м * l_AB", 30 * 0.3),
        ("m2/4", 2.5 / 4), ("0,3·m₂", 0.3 * 2.5), ("m2 + 2 m3", 3 * 2.5), ("30 kg/m (l_AB + l_BC)", 30 * 0.6),
        ("0.3*m2 + 6 kg", 0.3 * 2.5 + 6), ("2 кг/м * l_AB + 1,5 кг", 2 * 0.3 + 1.5), ("6 kg - m2", 6 - 2.5),
    ],
)  # fmt: skip
def test_masses_as_they_are_printed(written, value):
    found = closed.mass(written)
    sizes = lambda letter: letter.value if isinstance(letter, PerLength) else SIZES[type(letter)]  # noqa: E731
    assert worked(found, sizes) == pytest.approx(value, rel=1e-14)


@settings(max_examples=examples(200))
@given(st.text(alphabet="ml2_AB+-*/^() .,0127eкгkg/m²·", max_size=80))
def test_any_text_is_read_or_refused(written):
    for reads in (closed.mass, closed.inertia):
        try:
            found = reads(written)
        except WrongValue:
            continue
        assert dimension(found) in (closed.MASS, closed.INERTIA)
        try:
            size = worked(found, lambda letter: SIZES[type(letter)])
        except (ZeroDivisionError, OverflowError):
            continue
        assert isinstance(size, float | int) and not math.isnan(size)


# ---------------------------------------------------------------- mistakes

NO_MASS = "its letters multiply to something else"
MISTAKES = [
    ("rocker", "4*m9", "there is no link 9", "m2"),
    ("rocker", "4*m3", "the mass of link 3 is stated by itself", "0.3*m2"),
    ("rocker", "m2/0", "this comes to inf kg", ""),
    ("rocker", "m2-m2*2", "this comes to -2.16 kg", ""),
    ("rocker", "m2 +", "m2 + cannot be worked out", "m*l^2/12"),
    ("rocker", "m2*l", NO_MASS, "0.3*m2"),
    ("rocker", "m2^9", "m2^9 cannot be worked out", "m*l^2/12"),
    ("rocker", "2 kg/m*l + 3 kg/m*l", "has two masses of a metre", "30 kg/m"),
    ("rocker", "5 m", "5 m is a length", "1.5 kg"),
    ("rocker", "2 kgg", "unknown unit kgg", "1.5 kg"),
    ("rocker", "60 kg/m*l_AX", "no link has two points whose names make AX", "l_CB"),
    ("rod", "12 kg/m*l1*1e14", "which no link has", ""),
    ("of_rod", "m*l", NO_MASS, "0.17*m*l_AB^2"),
    ("of_rod", "12 kg/m*l^3", "the mass of a metre belongs to the mass", "m*l^2/12"),
    ("of_rod", "m*l_OX^2", "no link has two points whose names make OX", "l_AB"),
    (
        "of_rocker",
        "{value: m*l^2/40, about: C}",
        "would make the moment of inertia about the mass centre negative",
        "",
    ),
]


@pytest.mark.parametrize(("key", "written", "what", "cure"), MISTAKES)
def test_a_mistake_is_told_where_it_stands(key, written, what, cure):
    with pytest.raises(ProblemError) as told:
        loads(text(**{key: written}))
    (problem,) = told.value.problems
    assert what in str(problem.wrong) and cure in str(problem.right or "")
    assert problem.line == {"rod": 6, "of_rod": 6}.get(key, 7)


def test_masses_in_a_circle_are_told_once():
    with pytest.raises(ProblemError) as told:
        loads(text(rod="2*m3", rocker="m2/2"))
    (problem,) = told.value.problems
    assert "the masses of links 2, 3 are stated by one another" in str(problem.wrong) and problem.line == 6


def test_what_rests_on_a_broken_statement_is_not_told_again():
    with pytest.raises(ProblemError) as told:
        loads(text(rod="2*m7", rocker="m2/2"))
    (problem,) = told.value.problems
    assert "there is no link 7" in str(problem.wrong)


@pytest.mark.parametrize(
    ("points", "told"),
    [
        ("{C: 0, B: 120 mm, E: 50 mm}", "the link has a mass and no mass centre"),  # three points: no middle
        ("{C: 0, B: 120 mm}", ""),
    ],
)
def test_only_a_link_of_two_joints_has_its_mass_centre_in_the_middle(points, told):
    variant = text(rocker="2 kg", of_rocker="0.01").replace("{C: 0, B: 120 mm}", points)
    if not told:
        link = loads(variant).lever.mechanism.links["3"]
        assert link.mass_centre == "S3" and link.points["S3"] == pytest.approx(0.06)
        return
    with pytest.raises(ProblemError) as error:
        loads(variant)
    assert told in str(error.value)


def test_a_name_that_is_taken_leaves_the_mass_centre_to_be_stated():
    variant = text(rocker="2 kg", of_rocker="0.01").replace("D: [100", "S3: [100")
    with pytest.raises(ProblemError, match="the link has a mass and no mass centre"):
        loads(variant.replace("mass_centre: D", "mass_centre: S3"))


def test_a_load_may_act_at_the_middle():
    force = "forces: [{at: S3, direction: down, constant: 5 N}], moments"
    assert loads(text().replace("moments", force)).lever.loads.forces[0].at == "S3"


def test_a_weight_in_place_of_a_mass_is_told_with_the_mass():
    for weight, mass in (
        ("3 kgf", "a mass of 3 kg"),
        ("2 кгс", "a mass of 2 kg"),
        ("9.80665 N", "a mass of 1 kg"),
    ):
        with pytest.raises(ProblemError) as caught:
            loads(text(rod=weight, of_rod="0"))
        assert [problem.key for problem in caught.value.problems] == ["mechanism.links.2.mass"]
        assert mass in caught.value.problems[0].text()


def test_a_link_with_a_free_end_is_told_how_to_state_its_middle():
    free = text().replace(
        "C: [200 mm, 20 mm]}", "C: [200 mm, 20 mm]}\n  guides: {g: {through: C, link: 4}}", 1
    )
    free = free.replace(
        "  driver", "    4: {points: {C: 0, E: 90 mm}, mass: 3 kg}\n    5: {points: [B], slides: g}\n  driver"
    )
    with pytest.raises(ProblemError) as caught:
        loads(free)
    assert "S4: 0.5*l_CE in points, mass_centre: S4" in caught.value.problems[0].text()


# ---------------------------------------------------------------- a mass of a metre that no link has


@pytest.mark.parametrize(
    ("rod", "asked"),
    [
        ("30 kg/mm", "30 kg/m"), ("30 кг/мм * l_AB", "30 кг/м * l_AB"),
        ("12 t/m*(l_AB + l_BD)", "12 kg/m*(l_AB + l_BD)"),
        ("1200 kg/m", "1200 g/m"),
        ("5e-4 * 1 kg/m * l_AB", None), ("1 g/m", None), ("30 kg/m", None), ("3 g/mm", None), ("60 kg/m", None),
    ],
)  # fmt: skip
def test_a_mass_of_a_metre_that_no_link_has_is_asked_about(rod, asked):
    doubts = [one for one in loads(text(rod=rod)).doubts if one.key == "mechanism.links.2.mass"]
    assert [one.line for one in doubts] == ([] if asked is None else [6])
    for doubt in doubts:
        assert f"{rod} is odd: a metre has" in doubt.text()
        assert f"did you mean {asked}?" in doubt.text()


def test_it_is_judged_by_the_size_of_the_mechanism():
    large = text(rod="600 kg/m").replace("mm", "cm")  # a jaw crusher's links are of this size
    assert [one.key for one in loads(large).doubts if "a metre has" in one.text()] == []
    assert [one.key for one in loads(text(rod="600 kg/m")).doubts] == ["mechanism.links.2.mass"]
