"""Mistakes planted in students' works, and whether they are named."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest
from exhaustive import many
from planted import LIMIT, MAKERS, VARIANTS, Work, World, asked_of, handed_in, honest, planted

from tmm_report import course, loading
from tmm_report.grading.expected import expected
from tmm_report.grading.model import Answered, Answers, Cause, Name
from tmm_report.judging.diagnose import diagnose, prepared
from tmm_report.judging.judge import judge

OUTPUTS, RATES, FORCES, REACTIONS = "outputs_table", "rates_table", "loads_table", "reactions_table"
ROWS = np.arange(13) < 12


@cache
def world() -> World:
    return World.made(("compressor", "shaper", "jaw_crusher"), others=3)


@cache
def everyone():
    return prepared({id: one for family in world().variants.values() for id, one in family.items()})


def own():
    return world().variants["compressor"]["compressor-00"]


def causes(numbers: Mapping[Name, np.ndarray], rows=ROWS, **how) -> list[Cause]:
    """What is found in exact numbers of the compressor, some of which were changed."""
    return found(handed_in("one", numbers, rows), **how)


def found(answers: Answers, magnitudes: bool = False, **how) -> list[Cause]:
    judged = {
        name: judge(own()[name], one.values, one.given, limit=LIMIT, magnitudes=magnitudes)
        for name, one in answers.columns.items()
    }
    return diagnose(answers, own(), judged, limit=LIMIT, **how)


def exact(*names: Name) -> dict[Name, np.ndarray]:
    return {name: own()[name].values for name in names or asked_of(own())}


def cause_of(work: Work) -> list[Cause]:
    return diagnose(work.answers, work.expected, work.judged(), limit=LIMIT, others=everyone())


def is_named(work: Work, found: list[Cause]) -> bool:
    """Whether the planted mistakes are named, each on the columns it hit and on none where it was not made."""
    return len(found) == len(work.plants) and all(
        any(
            cause.kind == plant.kind
            and (cause.detail == plant.detail or plant.detail == "")
            and len(plant.names & set(cause.names)) > len(plant.names) / 2
            and plant.among.issuperset(cause.names)
            for cause in found
        )
        for plant in work.plants
    )


# ---------------------------------------------------------------- many works


@pytest.mark.exhaustive
@pytest.mark.parametrize("kind", many(MAKERS, 3))
def test_nearly_every_planted_mistake_is_named(kind):
    rng = np.random.default_rng(list(MAKERS).index(kind))
    works = [planted(world(), rng, kind) for _ in range(10)]
    assert sum(is_named(work, cause_of(work)) for work in works) >= 9


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "kinds", [("mm for m", "swapped"), ("sign", "rpm for rad/s"), ("scale", "power of ten")]
)
def test_two_mistakes_in_different_columns_are_both_named(kinds):
    rng = np.random.default_rng(3)
    works = [planted(world(), rng, *kinds) for _ in range(8)]
    assert sum(is_named(work, cause_of(work)) for work in works) >= 7


@pytest.mark.exhaustive
def test_honest_works_are_right_and_nobody_is_accused():
    rng = np.random.default_rng(4)
    for work in [planted(world(), rng) for _ in range(20)]:
        assert all(one.ok[work.answers.columns[name].given].all() for name, one in work.judged().items())
        assert cause_of(work) == []


@pytest.mark.exhaustive
def test_numbers_without_sense_get_no_explanation():
    rng = np.random.default_rng(5)
    accused = 0
    for _ in range(40):
        numbers = honest(own(), asked_of(own()), rng)
        for name in rng.choice(len(numbers), 3, replace=False):
            asked = own()[list(numbers)[name]]
            numbers[asked.name] = rng.uniform(-1, 1, 13) * asked.largest
        accused += sum(len(cause.names) for cause in causes(numbers, others=everyone()))
    assert accused <= 1


@pytest.mark.exhaustive
def test_undoing_a_named_mistake_gives_the_marks_he_would_have_had():
    rng = np.random.default_rng(6)
    for kind in MAKERS:
        work = planted(world(), rng, kind)
        for cause in cause_of(work):
            assert cause.explains >= 0.75 and set(cause.mended) == set(cause.names)
            for name, values in cause.mended.items():
                given = work.answers.columns[name].given
                judged = judge(work.expected[name], values, np.isfinite(values), limit=LIMIT)
                assert judged.ok[given].mean() >= 0.7, (kind, name)
                assert np.isfinite(values).sum() <= given.sum()


# ---------------------------------------------------------------- one mistake at a time


def test_a_sign_and_a_power_of_ten_in_one_column_are_two_causes():
    name = (OUTPUTS, "V_B")
    found = causes(exact() | {name: own()[name].values * -10})
    assert {(cause.kind, cause.names) for cause in found} == {("sign", (name,)), ("power of ten", (name,))}


@pytest.mark.exhaustive
def test_numbers_that_scatter_show_no_scale():
    rng = np.random.default_rng(8)
    for _ in range(20):
        numbers = {name: one * rng.choice([0.92, 1.08], 13) for name, one in exact().items()}
        assert not causes(numbers)


def test_radii_given_for_diameters():
    asked = expected(course.solve(loading.load(VARIANTS / "hoist_drive.yaml")))
    names = [n for n in asked if n[0].endswith("_wheels") and n[1].split("_")[0] == "d"]
    columns = {}
    for name in names:
        given = np.isfinite(asked[name].values)
        columns[name] = Answered(asked[name].values / 2, given, ("",) * len(given), ("",) * len(given))
    judged = {n: judge(asked[n], one.values, one.given, limit=LIMIT) for n, one in columns.items()}
    (cause,) = diagnose(Answers("one", columns), asked, judged, limit=LIMIT)
    assert names and cause.kind == "radius for diameter" and set(cause.names) == set(names)


def test_millimetres_for_metres_in_all_strokes_are_one_cause():
    names = [(OUTPUTS, "S_B"), (OUTPUTS, "S_D")]
    (cause,) = causes(exact() | {name: own()[name].values * 1e3 for name in names})
    assert (cause.kind, cause.names, cause.explains) == ("mm for m", tuple(names), 1.0)
    assert str(cause.what) == "S_B, S_D: millimetres given for metres"


def test_a_column_that_is_right_is_never_touched():
    """A crank that turns evenly is the same at every position."""
    (cause,) = causes({name: np.roll(one[:-1], -1)[[*range(12), 0]] for name, one in exact().items()})
    assert (cause.kind, cause.detail) == ("shifted", "+1")
    assert {(RATES, "v_A"), (RATES, "a_A"), (RATES, "w_1"), (FORCES, "G_2")}.isdisjoint(cause.names)
    assert "further" in str(cause.what)


def test_positions_counted_backwards_are_told_by_the_columns_that_are_not_symmetric():
    backwards = -np.arange(13) % 12
    (cause,) = causes({name: one[backwards] for name, one in exact().items()})
    assert cause.kind == "reversed" and (OUTPUTS, "V_B") in cause.names


def test_a_crank_turned_the_other_way_changes_the_signs_of_velocities_besides():
    backwards = -np.arange(13) % 12
    shaper = world().variants["shaper"]["shaper-00"]
    names = [(OUTPUTS, key) for key in ("S_D", "V_D", "A_D")]
    turned = {name: shaper[name].values[backwards] * (-1 if name[1] == "V_D" else 1) for name in names}
    answers = handed_in("one", turned, ROWS)
    judged = {name: judge(shaper[name], one.values, one.given) for name, one in answers.columns.items()}
    (cause,) = diagnose(answers, shaper, judged)
    assert (cause.kind, cause.detail, set(cause.names)) == ("reversed", "rotation", set(names))
    assert cause.mended[names[1]][:12] == pytest.approx(shaper[names[1]].values[:12], rel=1e-3, abs=1e-3)


def test_in_a_symmetric_mechanism_velocities_alone_say_the_opposite_sign():
    (cause,) = causes(exact() | {(OUTPUTS, "V_B"): -own()[OUTPUTS, "V_B"].values})
    assert (cause.kind, cause.names) == ("sign", ((OUTPUTS, "V_B"),))


def test_shifted_numbers_go_back_to_their_rows_and_the_last_row_is_the_first_again():
    names = [(OUTPUTS, "A_B"), (OUTPUTS, "V_B"), (OUTPUTS, "S_B"), ("balancing_table", "M_bal")]
    right = exact(*names)
    late = {name: one[(np.arange(13) - 2) % 12] for name, one in right.items()}
    (cause,) = causes(late, rows=np.ones(13, dtype=bool))
    assert cause.detail == "-2"
    for name in names:
        assert cause.mended[name] == pytest.approx(right[name], rel=1e-3, abs=1e-3)
    (cause,) = causes(late)
    assert np.isnan(cause.mended[names[0]]).tolist() == [False] * 12 + [True]


def test_a_unit_is_seen_in_a_column_that_is_shifted_with_all_the_others():
    stroke = (OUTPUTS, "S_B")
    late = {name: one[(np.arange(13) + 1) % 12] for name, one in exact().items()}
    shift, unit = causes(late | {stroke: late[stroke] * 1e3})
    assert (shift.kind, unit.kind, unit.names) == ("shifted", "mm for m", (stroke,))
    assert unit.mended[stroke][:12] == pytest.approx(own()[stroke].values[:12], rel=1e-3, abs=1e-6)


def test_swapped_columns_need_each_other():
    one, other = (OUTPUTS, "A_B"), (OUTPUTS, "A_D")
    (cause,) = causes(exact() | {one: own()[other].values, other: own()[one].values})
    assert cause.kind == "swapped" and str(cause.what) == "the columns a_B and a_D are swapped"
    assert cause.mended[one] == pytest.approx(
        np.where(ROWS, own()[one].values, np.nan), rel=1e-3, nan_ok=True
    )
    assert causes(exact() | {one: own()[other].values}) == []


def test_the_normal_component_for_the_tangential_one():
    normal, tangential = (RATES, "a_BA_n"), (RATES, "a_BA_t")
    (cause,) = causes(exact() | {tangential: own()[normal].values})
    assert (cause.kind, cause.names) == ("component", (tangential,))
    assert str(cause.what) == "a_BA_t: normal component given for the tangential one"
    (cause,) = causes(exact() | {tangential: own()[normal].values, normal: own()[tangential].values})
    assert cause.names == (normal, tangential)


def test_rpm_is_not_taken_for_a_power_of_ten_nor_mass_for_one():
    (cause,) = causes(exact() | {(RATES, "w_2"): own()[RATES, "w_2"].values * 30 / np.pi})
    assert (cause.kind, str(cause.what)) == ("rpm for rad/s", "ω_2: rpm given for rad/s")
    (cause,) = causes(exact() | {(FORCES, "G_2"): own()[FORCES, "G_2"].values / 9.81})
    assert cause.kind == "mass for weight"


def test_whose_numbers_they_are():
    family = world().variants["compressor"]
    for id in sorted(family)[1:]:
        (cause,) = causes({name: family[id][name].values for name in exact()}, others=everyone())
        assert (cause.kind, cause.detail) == ("variant", id)
        assert str(cause.what).endswith(f"the numbers of variant {id}")


def test_nobody_elses_numbers_are_seen_where_there_is_nobody_else():
    family = world().variants["compressor"]
    theirs = {name: family["compressor-01"][name].values for name in exact()}
    assert all(cause.kind != "variant" for cause in causes(theirs, others={"me": own()}))


def test_two_causes_never_explain_the_same_column():
    rng = np.random.default_rng(8)
    for _ in range(10):
        work = (
            planted(world(), rng, "shifted", "mm for m")
            if rng.random() < 0
            else planted(world(), rng, "variant")
        )
        names = [name for cause in cause_of(work) for name in cause.names]
        assert len(names) == len(set(names))


def test_magnitudes_with_another_mistake_are_compared_as_magnitudes():
    name = (OUTPUTS, "V_B")
    answers = handed_in("one", {name: np.abs(own()[name].values) * 1e3}, ROWS)
    (cause,) = found(answers, magnitudes=True)
    assert cause.kind == "mm for m"


# ---------------------------------------------------------------- few cells


def single(values: Mapping[Name, float]) -> Answers:
    one = np.array([True])
    return Answers(
        "one", {name: Answered(np.array([x]), one, (str(x),), ("",)) for name, x in values.items()}
    )


def test_one_number_shows_a_unit_or_a_sign_but_never_a_free_factor():
    stroke, speed = own()["", "H_B"].values[0], own()["", "omega"].values[0]
    (cause,) = found(single({("", "H_B"): stroke * 1e3}))
    assert cause.kind == "mm for m" and cause.mended["", "H_B"] == pytest.approx([stroke])
    (cause,) = found(single({("", "omega"): -speed}))
    assert cause.kind == "sign"
    assert found(single({("", "H_B"): stroke * 1.37})) == []
    assert found(single({("", "H_B"): stroke * 1e3 * 1.04})) == []  # not near enough for a single number


def test_two_positions_of_a_plan_show_that_their_neighbours_were_drawn():
    names = [(RATES, key) for key in ("v_BA", "v_D", "w_2", "v_S4")]
    drawn = np.isin(np.arange(13), (6, 7))
    (cause,) = causes(
        {name: np.roll(own()[name].values[:-1], -1)[[*range(12), 0]] for name in names}, rows=drawn
    )
    assert (cause.kind, cause.detail, set(cause.names)) == ("shifted", "+1", set(names))


def test_rows_that_were_left_out_are_no_evidence():
    name = (OUTPUTS, "V_B")
    few = np.isin(np.arange(13), (1, 3, 4, 8, 10))
    (cause,) = causes({name: -own()[name].values}, rows=few)
    assert cause.kind == "sign" and np.isnan(cause.mended[name][~few]).all()


def test_nothing_answered_is_nothing_wrong():
    empty = handed_in("one", exact((OUTPUTS, "V_B")), np.zeros(13, dtype=bool))
    assert found(empty) == [] and found(Answers("one", {})) == []


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("number", [1e308, -1e308, 5e-324, 0.0, np.inf])
def test_numbers_out_of_all_bounds_are_wrong_and_nothing_more(number):
    names = [(OUTPUTS, "V_B"), (OUTPUTS, "S_B"), (RATES, "v_A"), (REACTIONS, "R_12"), (REACTIONS, "alpha_12")]
    one = np.array([True])
    answers = Answers(
        "one",
        {
            **{name: Answered(np.full(13, number), ROWS, ("",) * 13, ("",) * 13) for name in names},
            ("", "H_B"): Answered(np.array([number]), one, ("",), ("",)),
        },
    )
    assert found(answers, others=everyone()) == []


def test_a_name_of_a_variant_is_shown_without_what_could_harm_a_terminal():
    family = world().variants["compressor"]
    theirs = {name: family["compressor-01"][name].values for name in exact()}
    (cause,) = causes(theirs, others={"a\x1b[31m": family["compressor-01"]})
    assert cause.detail == "a\x1b[31m" and "\x1b" not in str(cause.what)
