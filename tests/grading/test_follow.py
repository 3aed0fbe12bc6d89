"""What follows from a student's own numbers is what a mechanism with these numbers would really do.

The oracle is the solver itself: a mechanism turned faster, stood elsewhere, with other masses or loads is solved, some
of its numbers are given as a student's, and what follows of them in the right mechanism is compared with the rest.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import FILES, examples, read, solved, stating
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from tmm_report import course
from tmm_report.chapters.lever.kinetostatics.quantities import positions as say
from tmm_report.grading.follow import carried
from tmm_report.mechanics.lever import motion as motions
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.vector_equations import moving_points, named_values, relations, turning_links
from tmm_report.results import tables

NO_ANSWER = ("position", "phi", "lever_disagreement", "power_disagreement")
ASKED = [f"{x}_table" for x in ("outputs", "positions", "rates", "loads", "reactions", "balancing", "powers")]
CHECKS = ("M_power",)  # a derivative by differences: it has fewer digits
few = settings(max_examples=examples(60), suppress_health_check=list(HealthCheck))


@cache
def columns(results):
    """All numbers by positions that a student may be asked for, by key."""
    found = {}
    for table in tables(results):
        if table.name in ASKED:
            found |= {column.key: np.asarray(column.values, dtype=float) for column in table.columns}
    return {
        key: values
        for key, values in found.items()
        if key not in NO_ANSWER and not key.startswith(("sin_", "digits_"))
    }


def sizes(right):
    """Key -> a size of which rounding is a part: the greatest of its letter in the mechanism."""
    of = {}
    for key, values in right.items():
        letter = key.split("_")[0]
        of[letter] = max(of.get(letter, 0.0), np.nanmax(np.abs(values), initial=0.0))
    for faster, slower in (
        ("e", "w"),
        ("epsilon", "omega"),
    ):  # of a link that turns evenly rounding alone is left
        if faster in of:
            of[faster] = max(of[faster], of[slower] ** 2)
    return {key: of[key.split("_")[0]] for key in right}


def gap(key, one, other):
    """By how much columns differ; angles on the circle."""
    turn = {"phi": 360, "alpha": 360, "psi": 2 * np.pi}.get(key.split("_")[0])
    difference = one - other
    return np.abs(difference if turn is None else (difference + turn / 2) % turn - turn / 2)


def disagreements(follows, wanted, within=1e-9):
    """Keys and sources of what follows otherwise than is wanted."""
    size, found = sizes(wanted), []
    for key, alternatives in follows.items():
        for follow in alternatives:
            if key in wanted and key not in CHECKS:
                small = blurred(key, wanted)
                missed = gap(key, follow.values, wanted[key]) > within * max(size[key], 1e-12)
                if (missed & ~small).any():
                    found.append((key, follow.sources))
    return found


def blurred(key, wanted):
    """Where rounding decides: the angle of a reaction that is next to nothing, and where it acts in its guide."""
    force = wanted.get("R_" + key.split("_", 1)[-1])
    if key.startswith(("alpha_", "x_")) and force is not None:
        return force < 1e-6 * max(sizes(wanted)["R_" + key.split("_", 1)[-1]], 1e-12)
    return np.zeros(len(wanted[key]), dtype=bool)


def answered(follows, keys):
    """Those of the keys that follow from something."""
    return {key for key in keys if follows.get(key)}


def parts(right, *letters):
    """Columns of these letters by components, without the magnitudes that these say again."""
    chosen = {key: values for key, values in right.items() if key.split("_")[0] in letters}
    return {key: values for key, values in chosen.items() if f"{key}_x" not in chosen}


def alone(name):
    """The mechanism with its loads: of other numbers no reading holds, and on no scale of the drawing need they fit."""
    return stating(read(name), friction=None, reduction=False, readings={}, drawing=course.Drawing())


def faster(name, factor):
    """The variant driven at another angular velocity, solved."""
    variant = alone(name)
    mechanism = variant.lever.mechanism
    driver = replace(mechanism.driver, omega=mechanism.driver.omega * factor)
    return course.solve(stating(variant, mechanism=replace(mechanism, driver=driver)))


def heavier(name, links, factor):
    """The variant with other masses and moments of inertia of some links, solved."""
    variant = alone(name)
    mechanism = variant.lever.mechanism
    heavy = {
        link: replace(of, mass=of.mass * factor, inertia=of.inertia * factor**2) if link in links else of
        for link, of in mechanism.links.items()
    }
    return course.solve(stating(variant, mechanism=replace(mechanism, links=heavy)))


# ---------------------------------------------------------------- right numbers


NAMES = [*(path.stem for path in FILES), "sprung_screen"]
levers = st.sampled_from(NAMES)
every_lever = pytest.mark.parametrize("name", NAMES)


@every_lever
def test_from_right_numbers_follow_the_right_numbers(name):
    right = columns(solved(name))
    follows = carried(solved(name), right)
    assert not disagreements(follows, right)
    silent = right.keys() - answered(follows, right) - {"t"}
    # what is given to begin with follows from nothing, nor does the time
    first = ("w_", "e_", "G_", "P_", "M_", "phi_")
    assert all(key.startswith(first) for key in silent), silent


@pytest.mark.exhaustive
@few
@given(name=levers, data=st.data())
def test_from_any_part_of_them_too(name, data):
    right = columns(solved(name))
    keys = data.draw(st.lists(st.sampled_from(sorted(right)), min_size=1, max_size=12, unique=True))
    holes = data.draw(st.lists(st.booleans(), min_size=len(right["w_1"]), max_size=len(right["w_1"])))
    own = {key: np.where(holes, np.nan, right[key]) for key in keys}
    assert not disagreements(carried(solved(name), own), right)


@every_lever
def test_magnitudes_stand_for_vectors_in_the_directions_that_follow(name):
    right = columns(solved(name))
    own = {key: np.abs(values) for key, values in right.items() if not key.endswith(("_x", "_y"))}
    own = {key: values for key, values in own.items() if key.split("_")[0] in ("v", "a", "w", "e", "F", "R")}
    follows = carried(solved(name), own)
    assert not disagreements(follows, right)
    assert answered(follows, ["M_bal"])


# ---------------------------------------------------------------- numbers of another mechanism


@pytest.mark.exhaustive
@few
@example(name="compressor", factor=5.0)  # its forces leave the paper at the scale that it states
@given(name=levers, factor=st.floats(0.2, 5))
def test_velocities_of_a_faster_mechanism_lead_to_its_accelerations_and_forces(name, factor):
    right, other = columns(solved(name)), columns(faster(name, factor))
    follows = carried(solved(name), parts(other, "v", "w"))
    assert not disagreements(follows, other)
    wanted = {key for key in right if key.split("_")[0] in ("a", "e", "F", "R")} | {"M_bal"}
    assert answered(follows, wanted) >= {key for key in wanted if right[key].any()}


def driver(name):
    return read(name).lever.mechanism.driver.link


@every_lever
def test_so_do_its_velocities_by_magnitudes(name):
    other = columns(faster(name, 1.5))
    own = {
        key: np.abs(v)
        for key, v in other.items()
        if key.startswith(("v_", "w_")) and key[-2:] not in ("_x", "_y")
    }
    assert not disagreements(carried(solved(name), own), other)


@every_lever
def test_its_angular_velocity_alone_leads_to_all_its_motion(name):
    other, link = columns(faster(name, 0.7)), driver(name)
    follows = carried(solved(name), {f"w_{link}": other[f"w_{link}"]})
    assert not disagreements(follows, other)
    wanted = {key for key in other if key.split("_")[0] in ("v", "a")}
    assert answered(follows, wanted) == wanted


@every_lever
def test_normal_accelerations_of_a_faster_mechanism_lead_to_the_tangential_ones(name):
    """The bends are all that is known of the plan, beside the accelerations of the driving link's points."""
    found, other = solved(name).lever.kinematics, columns(faster(name, 1.3))
    points = [point for point, link in found.linkage.carriers.items() if link == driver(name)]
    for relation in relations(found.linkage):
        points += [b.start for b in relation.branches if b.start is not None and b.link == driver(name)]
    own = {f"a_{p}_{axis}": other[f"a_{p}_{axis}"] for p in points for axis in "xy" if f"a_{p}" in other}
    own |= {key: other[key] for key in other if key.startswith("a_") and key.endswith(("_n", "_k"))}
    follows = carried(solved(name), own)
    for key in other:
        if key.startswith("a_") and key.endswith(("_t", "_r", "_t_x", "_r_y")):
            assert any(not disagreements({key: [one]}, other) for one in follows[key]), key


def standing(name, shift):
    """Places and rates of the mechanism turned on by an angle, by the keys of the results."""
    found = solved(name).lever.kinematics
    motion = motions.solve(found.linkage, found.table.phi + shift)
    places = {}
    for point in moving_points(found.linkage):
        places |= {f"x_{point}": motion.place(point).real, f"y_{point}": motion.place(point).imag}
    angles = {f"phi_{link}": np.degrees(np.angle(motion.turn(link))) for link in turning_links(found.linkage)}
    rates = {}
    for key, values in named_values(motion).items():
        if np.iscomplexobj(values):
            rates |= {key: np.abs(values), f"{key}_x": values.real, f"{key}_y": values.imag}
        else:
            rates[key] = values
    return places, angles, rates


@pytest.mark.exhaustive
@few
@given(name=levers, shift=st.floats(-0.5, 0.5))
def test_places_of_other_positions_lead_to_the_velocities_there(name, shift):
    places, angles, rates = standing(name, shift)
    follows = carried(solved(name), places | angles)
    assert not disagreements(follows, places | angles | rates, within=1e-6)
    wanted = {key for key in rates if key[0] in "va"}
    assert answered(follows, wanted) == wanted


@every_lever
@pytest.mark.parametrize("shift", (-0.5, 0.3))
def test_the_angle_of_the_driving_link_leads_to_all_places(name, shift):
    places, angles, rates = standing(name, shift)
    link = f"phi_{driver(name)}"
    follows = carried(solved(name), {link: angles[link]})
    assert not disagreements(follows, places | angles | rates, within=1e-6)
    for key, values in places.items():
        assert (np.isfinite(follows[key][0].values) == np.isfinite(values)).all(), key


@pytest.mark.exhaustive
@few
@given(name=levers, factor=st.floats(0.3, 3))
def test_loads_of_heavier_links_lead_to_their_reactions(name, factor):
    links = read(name).lever.mechanism.moving
    other = columns(heavier(name, links, factor))
    follows = carried(solved(name), parts(other, "F", "G") | couples(other))
    wanted = {key: other[key] for key in other if key.split("_")[0] in ("R", "alpha", "N")} | {
        "M_bal": other["M_bal"]
    }
    assert not disagreements({key: follows[key] for key in wanted}, wanted)
    assert answered(follows, ["M_bal", "M_lever"])


def couples(other):
    return {key: values for key, values in other.items() if key.startswith("M_I")}


@pytest.mark.exhaustive
@few
@given(name=levers, factor=st.floats(0.3, 3))
def test_reactions_of_the_last_group_lead_to_those_before_it(name, factor):
    """Only the last group is heavier: by its outer reactions alone the rest is found."""
    last = solved(name).lever.kinematics.linkage.groups[-1]
    other = columns(heavier(name, last.links, factor))
    own = {}
    for pair in last.group.outer:
        key = say.reaction(*pair.links).key
        own |= {f"{key}_{axis}": other[f"{key}_{axis}"] for axis in "xy"}
        if pair.kind == "P":
            key = say.guide_moment(*pair.links).key
            own[key] = other[key]
    follows = carried(solved(name), own)
    inner = {say.reaction(*pair.links).key for pair in last.group.inner}
    wanted = {
        key: v
        for key, v in other.items()
        if key.startswith("R_") and key[:-2] not in inner and key not in inner
    }
    outer = {say.reaction(*pair.links).key for pair in last.group.outer}
    wanted = {key: v for key, v in wanted.items() if key not in outer and key[:-2] not in outer}
    wanted["M_bal"] = other["M_bal"]
    assert not disagreements({key: follows[key] for key in wanted}, wanted)
    assert answered(follows, ["M_bal"])


# ---------------------------------------------------------------- a whole work with one mistake


def unexplained(name, own, wanted):
    """Keys of a student's work that do not follow, by one way at least, from the rest of it."""
    follows = carried(solved(name), own)
    return {
        key
        for key in own
        if key in wanted
        and not any(not disagreements({key: [one]}, wanted, within=1e-6) for one in follows[key])
    }


@every_lever
def test_a_wrong_angular_velocity_explains_all_that_comes_after_it(name):
    """All that the faster mechanism does, in magnitudes, as it is read from plans; places are right."""
    right, other = columns(solved(name)), columns(faster(name, 1.4))
    own = {key: np.abs(other[key]) for key in other if not key.endswith(("_x", "_y"))}
    own = {key: values for key, values in own.items() if key.split("_")[0] in ("v", "a", "w", "e", "F", "R")}
    own |= couples(other) | {"M_bal": other["M_bal"]}
    wrong = {key: other[key] for key in own if not np.allclose(own[key], np.abs(right[key]), 1e-6)}
    assert unexplained(name, own, wrong) <= {f"w_{driver(name)}"}


@every_lever
def test_a_wrong_start_explains_all_velocities_and_accelerations(name):
    """The whole motion is that of positions turned on by 20°."""
    places, angles, rates = standing(name, np.radians(20))
    own = places | angles | {key: np.abs(rates[key]) for key in rates if not key.endswith(("_x", "_y"))}
    lost = unexplained(name, own, places | angles | rates)
    link = driver(name)
    assert lost <= {f"phi_{link}", f"w_{link}", f"e_{link}"}


# ---------------------------------------------------------------- what does not follow


@pytest.mark.exhaustive
@few
@given(name=levers, data=st.data())
def test_nothing_follows_from_itself(name, data):
    right = columns(solved(name))
    keys = data.draw(st.lists(st.sampled_from(sorted(right)), min_size=1, unique=True))
    for key, alternatives in carried(solved(name), {key: right[key] for key in keys}).items():
        for follow in alternatives:
            assert key not in follow.sources and set(follow.sources) <= set(keys)


@every_lever
def test_nothing_follows_from_no_answer(name):
    empty = np.full(len(columns(solved(name))["w_1"]), np.nan)
    follows = carried(solved(name), dict.fromkeys(columns(solved(name)), empty))
    assert not any(follows.values())


@every_lever
def test_what_is_told_of_one_position_stays_there(name):
    right, own = columns(solved(name)), {}
    for key in ("w_1", "v_A", "phi_1"):
        if key in right:
            own[key] = np.where(np.arange(len(right[key])) == 3, right[key] * 1.1, np.nan)
    for alternatives in carried(solved(name), own).values():
        for follow in alternatives:
            assert not np.isfinite(np.delete(follow.values, 3)).any()


@every_lever
def test_forces_say_nothing_of_the_motion(name):
    right = columns(solved(name))
    own = {key: 1.2 * values for key, values in right.items() if key[0] in "FRNGP"}
    follows = carried(solved(name), own)
    motion = {key for key in right if key.split("_")[0] in ("v", "a", "w", "e", "V", "A", "S", "y", "phi")}
    assert not answered(follows, motion)


def test_the_second_group_says_nothing_of_the_first(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"v_D": 1.2 * right["v_D"], "a_D": 1.2 * right["a_D"]})
    assert not answered(follows, ["v_B", "v_BA", "w_2", "a_B", "e_2", "F_I2", "F_I3", "v_S2"])
    assert answered(follows, ["v_S4", "a_S4", "F_I4", "F_I5", "R_24", "R_12", "M_bal"])


# ---------------------------------------------------------------- as students write


def test_a_wrong_relative_velocity_is_carried_to_the_angular_velocity_and_the_normal_acceleration(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"v_BA": 1.3 * right["v_BA"]})
    assert np.allclose(follows["w_2"][0].values, 1.3 * right["w_2"])
    assert np.allclose(follows["a_BA_n"][0].values, 1.69 * right["a_BA_n"])
    assert follows["a_BA_n"][0].sources == ("v_BA",)


def test_an_angular_velocity_that_belies_the_relative_one_has_its_own_normal_acceleration(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"v_BA": right["v_BA"], "w_2": 2 * right["w_2"]})["a_BA_n"]
    found = {follow.sources: follow.values for follow in follows}
    assert np.allclose(found["v_BA",], right["a_BA_n"])
    assert np.allclose(found["w_2",], 4 * right["a_BA_n"])


def test_an_angular_velocity_without_signs_turns_as_it_follows(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"w_2": np.abs(right["w_2"])})
    assert np.allclose(follows["v_BA_x"][0].values, right["v_BA_x"])


def test_an_angular_velocity_with_signs_keeps_them(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"w_2": -right["w_2"]})
    assert np.allclose(follows["v_BA_x"][0].values, -right["v_BA_x"])


def test_the_inertia_force_is_of_the_mass_by_the_own_acceleration(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"a_S2": 0.5 * right["a_S2"]})
    assert np.allclose(follows["F_I2"][0].values, 0.5 * right["F_I2"])


def test_the_velocity_of_a_slider_is_that_of_its_point_with_a_sign(compressor):
    right = columns(compressor)
    follows = carried(compressor, {"v_B": 0.9 * right["v_B"]})
    assert np.allclose(follows["V_B"][0].values, 0.9 * right["V_B"])
    follows = carried(compressor, {"V_B": 0.9 * right["V_B"]})
    assert np.allclose(follows["v_B"][0].values, 0.9 * right["v_B"])


def test_a_place_that_was_misspelt_leaves_room_for_work_from_the_right_place(compressor):
    """x_B is a slip of the pen, v_BA is wrong: accelerations are then found both ways."""
    right = columns(compressor)
    own = {"x_B": -3 * right["x_B"], "y_B": right["y_B"] + 0.1, "v_BA": 1.3 * right["v_BA"]}
    follows = carried(compressor, own)
    clean = carried(compressor, {"v_BA": own["v_BA"]})["a_B"][0]
    assert any(
        follow.sources == clean.sources and np.allclose(follow.values, clean.values)
        for follow in follows["a_B"]
    )


def test_where_a_number_is_missing_what_follows_stands_for_it(compressor):
    right = columns(compressor)
    third = np.arange(len(right["v_A"])) == 3
    own = {"v_A": 1.2 * right["v_A"], "v_BA": np.where(third, 2 * right["v_BA"], np.nan)}
    wanted = np.where(third, 4, 1.44) * right["a_BA_n"]
    assert np.allclose(carried(compressor, own)["a_BA_n"][0].values, wanted)


def test_the_rod_is_laid_off_from_where_the_student_has_its_joint(compressor):
    right = columns(compressor)
    own = {"x_A": 1.1 * right["x_A"], "y_A": 1.1 * right["y_A"]}
    follows = carried(compressor, own)
    length = np.hypot(right["x_B"] - right["x_A"], right["y_B"] - right["y_A"])
    found = [
        np.hypot(x.values - own["x_A"], y.values - own["y_A"])
        for x, y in zip(follows["x_B"], follows["y_B"], strict=True)
    ]
    assert found and all(np.allclose(one, length) for one in found)


def test_a_moment_in_a_guide_on_the_driving_link_is_balanced():
    right = columns(solved("tangent"))
    follow = carried(solved("tangent"), {"M_12": right["M_12"] + 5})["M_bal"][0]
    assert np.allclose(follow.values, right["M_bal"] + 5) and follow.sources == ("M_12",)


def test_only_what_is_wanted_is_kept(compressor):
    own = {"v_A": 1.2 * columns(compressor)["v_A"]}
    some, everything = carried(compressor, own, {"w_2", "M_bal", "V_B"}), carried(compressor, own)
    assert list(some) == [key for key in everything if key in ("w_2", "M_bal", "V_B")]
    for key, follows in some.items():
        assert [one.sources for one in follows] == [one.sources for one in everything[key]]


@every_lever
@pytest.mark.parametrize("number", (0.0, 1e-300, -1e300, 1e12))
def test_absurd_numbers_stop_nothing(name, number):
    own = {key: np.full(len(values), number) for key, values in columns(solved(name)).items()}
    for alternatives in carried(solved(name), own).values():
        for follow in alternatives:
            assert not np.isinf(follow.values).any()


def test_a_column_of_another_length_is_passed_over(compressor):
    assert not any(carried(compressor, {"v_A": np.ones(5), "w_2": np.array(3.0)}).values())


def test_unknown_keys_and_infinite_numbers_are_passed_over(compressor):
    right = columns(compressor)
    own = {"nonsense": right["v_B"], "v_A": np.full(len(right["v_A"]), np.inf), "v_BA_": right["v_BA"]}
    assert not any(carried(compressor, own).values())


def test_every_link_of_a_group_of_class_four_is_reached():
    press, driving = solved("press"), driver("press")
    follows = carried(press, {f"w_{driving}": 1.1 * columns(press)[f"w_{driving}"]})
    turning = set(turning_links(press.lever.kinematics.linkage)) - {FRAME, driving}
    assert answered(follows, [f"e_{link}" for link in turning]) == {f"e_{link}" for link in turning}
