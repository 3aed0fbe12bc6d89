"""What a variant may state of its balancing, and what is said of it where it is wrong."""

import re

import pytest
from conftest import read
from notes import VARIANTS

from tmm_report import course, loading
from tmm_report.problems import ProblemError


def text_of(name: str, block: str) -> str:
    """A variant with this block of balancing in place of its own."""
    text = VARIANTS.joinpath(f"{name}.yaml").read_text("utf-8")
    bare = re.sub(r"\n(balancing|harmonics|flywheel|vibration):[^\n]*(\n+ [^\n]*)*", "", text)
    return f"{bare}\nbalancing:\n{block}\n"


def solved_with(name: str, block: str) -> course.Results:
    return course.solve(loading.loads(text_of(name, block)))


def problems(name: str, block: str) -> list[tuple[str, str]]:
    with pytest.raises(ProblemError) as error:
        solved_with(name, block)
    return [(problem.key, problem.text()) for problem in error.value.problems]


def test_units_and_defaults():
    given = loading.loads(
        text_of("crank_rocker", "  counterweights: {1: {distance: 4 cm}, 3: {mass: 500 g}}")
    ).balancing
    assert given.counterweights["1"].distance == pytest.approx(0.04)
    assert given.counterweights["3"].mass == pytest.approx(0.5)
    assert given.ways == ("full", "substituted", "optimum") and given.part == 0.5


def test_rotors_stated_are_rotors_asked_for():
    given = loading.loads(text_of("compressor", "  rotors: {first: 60 mm, second: 40 mm}")).balancing
    assert given.ways[-1] == "rotors" and given.radii == pytest.approx({1: 0.06, 2: 0.04})


def test_every_missing_counterweight_is_told_with_its_methods():
    found = problems("compressor", "  counterweights: {4: {distance: 60 mm}}")
    assert [re.findall(r"link (\w+) needs", text)[0] for _, text in found] == ["2", "1"]
    assert "full, substituted, optimum_rms, optimum_max" in found[1][1]
    assert all(key == "balancing.counterweights" and "distance: 60 mm" in text for key, text in found)


@pytest.mark.parametrize(
    ("block", "key", "words"),
    [
        ("  counterweights: {1: {}}", "balancing.counterweights.1", "neither a mass nor a distance"),
        (
            "  counterweights: {1: {mass: 2 kg, distance: 60 mm}}",
            "balancing.counterweights.1",
            "one of them follows from the other",
        ),
        ("  counterweights: {1: {distance: 0}}", "balancing.counterweights.1.distance", "greater than zero"),
        ("  counterweights: {1: {mass: 0 kg}}", "balancing.counterweights.1.mass", "greater than zero"),
        ("  counterweights: {1: {mass: 60 mm}}", "balancing.counterweights.1.mass", "is a length"),
        ("  counterweights: {7: {mass: 2 kg}}", "balancing.counterweights.7", "there is no link 7"),
        ("  counterweights: {0: {mass: 2 kg}}", "balancing.counterweights.0", "the frame does not move"),
        (
            "  methods: [optimum]\n  counterweights: {1: {mass: 2 kg}, 2: {mass: 2 kg}}",
            "balancing.counterweights.2",
            "not pivoted to the frame",
        ),
        ("  stated: {2: {mass: 2 kg, distance: 6 cm}}", "balancing.stated.2", "not pivoted to the frame"),
        ("  about: B", "balancing.about", "moves"),
        ("  about: Z", "balancing.about", "Z"),
        ("  methods: [rotors]", "balancing.rotors", "radii"),
        ("  part: 1.5", "balancing.part", "0 … 1"),
        ("  methods: [all]", "balancing.methods.0", "all"),
    ],
)
def test_a_wrong_value_is_told_where_it_stands(block, key, words):
    found = problems("crank_rocker", block)
    assert any(one == key and words in text for one, text in found), found


def test_nothing_heavy_is_told():
    text = text_of("crank_rocker", "  counterweights: {1: {mass: 2 kg}}").split("\nloads:")[0]
    light = re.sub(r"\b(mass|mass_centre): [^,}\n]*,? ?", "", text)
    with pytest.raises(ProblemError) as error:
        loading.loads(light + "\nbalancing: {counterweights: {1: {distance: 60 mm}}}\n")
    assert "no link has a mass" in str(error.value)


def test_a_heavy_link_that_only_turns_about_its_centre_leaves_nothing_to_balance():
    text = text_of("crank_rocker", "  methods: [optimum]\n  counterweights: {1: {distance: 40 mm}}")
    text = re.sub(r"mass: [\d.]+ kg", "mass: 0 kg", text)
    text = text.replace(
        "1: {points: {O: 0, A: 60 mm},", "1: {points: {O: 0, A: 60 mm}, mass: 2 kg, mass_centre: O,"
    )
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    assert "no link with a mass is accelerated" in str(error.value)


def test_full_balance_alone_where_guides_forbid_it_is_explained():
    block = "  methods: [full]\n  counterweights: {1: {distance: 60 mm}, 2: {distance: 60 mm}, 3: {distance: 60 mm}}"
    [(key, text)] = problems("piston_pump", block)
    assert key == "balancing.methods" and "no path of pivots joins links 5" in text


@pytest.mark.exhaustive
def test_without_a_mechanism_the_block_is_out_of_place():
    with pytest.raises(ProblemError) as error:
        loading.loads("eccentric: {module: 2 mm, teeth: [34, 60, 136]}\nbalancing: {part: 0.4}\n")
    assert any("no lever mechanism" in problem.text() for problem in error.value.problems)


def test_a_rocking_driver_is_told():
    """What only swings has no turn over which shaking is judged."""
    text = text_of("crank_rocker", "  methods: [optimum]\n  counterweights: {1: {distance: 40 mm}}")
    text = text.replace("rotation: clockwise", "rotation: clockwise\n    range: 60 deg")
    text = re.sub(r"zero: \{[^}]*\}", "zero: {angle: 40 deg}", text)
    text = re.sub(r"plans: \[[^]]*\], force_plan: \[[^]]*\]", "plans: [2], force_plan: 2", text)
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    assert "makes no full turn" in str(error.value)


def test_summary_says_what_is_left():
    [line] = solved_with(
        "crank_rocker", "  counterweights: {1: {distance: 4 cm}, 2: {distance: 6 cm}, 3: {mass: 6 kg}}"
    ).balancing.summary()
    assert "99.698 N; 0 % of it" in str(line)


def test_ready_variants_state_it():
    assert read("compressor").balancing is not None and read("crank_rocker").balancing is not None
