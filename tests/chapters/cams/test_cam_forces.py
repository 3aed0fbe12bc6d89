"""Forces of a cam that stands alone, through the file: against the closed formulas, the balance of power over a turn,
springs that hold and no more; slips at their keys."""

import math

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.cams.cam_forces import quantities as q
from tmm_report.mechanics.cams.stated_profile import ByProfile
from tmm_report.problems import ProblemError
from tmm_report.results import tables

LAW = (
    "phases: [{rise: 110 deg, law: sine}, {dwell: 30 deg}, {return: 90 deg, law: polynomial}, {dwell: rest}]"
)
SLIDING = f"roller: 12 mm, pitch_base: 50 mm, offset: 8 mm, lift: 30 mm, speed: 240 rpm, {LAW}"
FLAT = f"follower: flat, base: 60 mm, lift: 20 mm, speed: 240 rpm, {LAW}"
KNIFE = f"follower: knife, base: 50 mm, lift: 20 mm, speed: 240 rpm, {LAW}"
SWINGING = (
    "roller: 10 mm, base: 40 mm, swing: 18 deg, arm: 120 mm, centre_distance: 130 mm, side: with, "
    f"speed: 300 rpm, {LAW}"
)
CHOSEN = f"roller: chosen, base: smallest, lift: 20 mm, {LAW}"
POLAR = (
    "roller: 8 mm, speed: 200 rpm, profile: {polar: [[0 deg, 30 mm], [40 deg, 31 mm], [80 deg, 35 mm], "
    "[120 deg, 41 mm], [160 deg, 45 mm], [200 deg, 44 mm], [240 deg, 40 mm], [280 deg, 35 mm], [320 deg, 31 mm]]}"
)
PIN = "pin: {radius: 4 mm, friction: 0.1}"
GUIDE = "guide: {length: 90 mm, overhang: 60 mm, friction: 0.1}"


def solved(cam: str, more: str = ""):
    return course.solve(loading.loads(f"cam: {{{cam}, {more}}}"))


def found(cam: str, more: str = ""):
    return solved(cam, more).cam_forces


def numbers(results) -> dict:
    return {one.key: one for one in q.values(results.cam_forces)}


def columns(results, name: str) -> dict:
    table = next(one for one in q.tables(results.cam_forces) if one.name == name)
    return {one.key: np.asarray(one.values) for one in table.columns}


def test_force_and_moment_are_those_of_the_closed_formulas():
    """N = Q/(cos α − f(1 + 2b/c)|sin α|) of a rise, with + of a return; T₀ = Q s′; Q part by part."""
    results = solved(
        SLIDING, f"mass: 2.4 kg, gravity: 9.81, load: 200 N, spring: {{rate: 2 kN/m, preload: 60 N}}, {GUIDE}"
    )
    own = columns(results, "cam_forces_table")
    motion = next(
        one for one in course.room("cam", "quantities").tables(results.cam) if one.name == "cam_motion_table"
    )
    s, first, second, alpha = (
        np.asarray(motion[key].values) for key in ("cam_S", "cam_S1", "cam_S2", "cam_alpha")
    )
    omega = 240 * math.pi / 30
    Q = 200 + 2.4 * 9.81 + 60 + 2000 * s + 2.4 * omega**2 * second
    assert own["cam_needed"] == pytest.approx(Q, rel=1e-12)
    a = np.radians(alpha)
    N = Q / (np.cos(a) - np.sign(first) * 0.1 * (1 + 2 * 60 / 90) * np.abs(np.sin(a)))
    assert own["cam_N"] == pytest.approx(N, rel=1e-10)
    assert own["cam_T0"] == pytest.approx(Q * first, rel=1e-10, abs=1e-12)
    lean = 0.1 * (1 + 2 * 60 / 90) * np.abs(np.sin(a)) * N * np.abs(first)
    assert own["cam_T_guide"] == pytest.approx(lean, rel=1e-9, abs=1e-12)
    assert own["cam_T"] == pytest.approx(Q * first + lean, rel=1e-9, abs=1e-9)
    jam = numbers(results)["cam_alpha_jam"].value
    assert math.tan(math.radians(jam)) == pytest.approx(90 / (0.1 * (90 + 120)), rel=1e-12)


@pytest.mark.parametrize(
    ("cam", "more"),
    [
        (SLIDING, f"mass: 2.4 kg, load: {{rise: 400 N, return: 60 N}}, spring: smallest, {GUIDE}, {PIN}"),
        (FLAT, f"mass: 1 kg, load: 500 N, face_friction: 0.1, {GUIDE}"),
        (KNIFE, f"mass: 1 kg, load: 500 N, face_friction: 0.1, {GUIDE}"),
        (SWINGING, f"inertia: 0.004 kg*m^2, moment: 20 N*m, pivot: {{diameter: 20 mm, friction: 0.1}}, {PIN}"),
    ],
)  # fmt: skip
def test_the_work_of_a_turn_is_that_of_the_load_and_of_friction(cam, more):
    results = solved(cam, more)
    own, forces = numbers(results), results.cam_forces
    assert not forces.jams and not forces.leaves and forces.sound
    given = (
        (400 - 60) * 0.03 if "return: 60 N" in more else 0.0
    )  # what the load takes going out and gives coming back
    assert own["cam_work"].value == pytest.approx(given + own["cam_work_fr"].value, rel=1e-8)
    assert own["cam_work_fr"].value > 0
    assert own["cam_disagreement"].value < 1e-12


def test_over_a_profile_of_points_what_springs_and_inertia_give_back_is_nothing():
    """The acceleration has its kinks where the follower is over a stated point, not at the angles of the points."""
    results = solved(POLAR, "mass: 1 kg, spring: {rate: 6 N/mm, preload: 60 N}, load: 50 N")
    own, forces = numbers(results), results.cam_forces
    assert own["cam_T_mean"].value == 0
    coarse = np.linspace(0, 2 * math.pi, 361)
    N, step = forces.loaded.at(coarse).N, coarse[1]
    near = [np.linspace(coarse[k] - step, coarse[k] + step, 1201) for k in (N.argmin(), N.argmax())]
    low, high = (forces.loaded.at(x).N for x in near)  # as fine as 200 000 a turn
    assert own["cam_N_min"].value == pytest.approx(low.min(), rel=1e-6)
    assert own["cam_N_max"].value == pytest.approx(high.max(), rel=1e-6)


def test_the_motion_over_a_profile_of_points_is_found_once(monkeypatch):
    """Each time it is sought among all points of the profile."""
    loaded = solved(POLAR, "mass: 1 kg, spring: {rate: 6 N/mm, preload: 60 N}, load: 50 N").cam_forces.loaded
    sought, own = [], ByProfile.of
    monkeypatch.setattr(ByProfile, "of", lambda self, phi: sought.append(np.size(phi)) or own(self, phi))
    loaded.whole(np.linspace(0, 2 * math.pi, 100))
    assert sought == [100]


@pytest.mark.parametrize(
    "asked", ["smallest", "{ratio: 0.4, reserve: 1.3}", "{rate: 4 kN/m, preload: smallest, reserve: 1.3}",
              "{preload: 40 N, rate: smallest}"],
)  # fmt: skip
def test_a_spring_that_is_found_holds_and_a_little_less_does_not(asked):
    forces = found(SLIDING, f"mass: 2.4 kg, spring: {asked}")
    reserve = 1.3 if "reserve" in asked else 1.0
    x = np.linspace(0, 2 * np.pi, 20001)
    one = forces.loaded
    held = one.spring.preload + one.spring.rate * one.lifted(x)[0] + reserve * one.parts(x).inertia
    assert held.min() == pytest.approx(0.0, abs=2e-3 * forces.springs[0].greatest)
    for other in forces.springs:
        holds = other.preload + other.rate * one.lifted(x)[0] + reserve * one.parts(x).inertia
        assert holds.min() > -1e-5 * other.greatest
        assert other.greatest == pytest.approx(other.preload + other.rate * one.lift, rel=1e-12)
    assert min(other.greatest for other in forces.springs) >= forces.springs[1].greatest * (1 - 1e-12)


def test_at_the_speed_of_lifting_off_the_follower_is_just_held():
    results = solved(SLIDING, "mass: 2.4 kg, load: 30 N, spring: {rate: 1 kN/m, preload: 20 N}")
    off = numbers(results)["cam_n_off"].value
    for speed, leaves in ((0.999 * off, False), (1.001 * off, True)):
        again = found(
            SLIDING.replace("240 rpm", f"{speed} rpm"),
            "mass: 2.4 kg, load: 30 N, spring: {rate: 1 kN/m, preload: 20 N}",
        )
        assert bool(again.leaves) == leaves


def test_the_pressure_is_that_of_the_radii_in_the_table_of_the_cam():
    results = solved(
        FLAT, "load: 500 N, contact: {width: 12 mm, cam: {young: 200 GPa, poisson: 0.25}, follower: bronze}"
    )
    own = columns(results, "cam_forces_table")
    phi = np.radians(own["phi"])
    rho = results.cam.cams[0].cam.own_radius(phi)
    bends = (1 - 0.25**2) / 200e9 + (1 - 0.33**2) / 110e9
    assert own["cam_sigma"] * 1e6 == pytest.approx(np.sqrt(500 / rho / (math.pi * 0.012 * bends)), rel=1e-10)


def test_a_groove_pulls_where_the_cam_alone_would_be_left():
    free = found(SLIDING, "mass: 2.4 kg")
    held = found(SLIDING, "mass: 2.4 kg, closure: groove, pin: {radius: 4 mm, friction: 0.1}")
    assert free.leaves and not free.sound and not held.leaves and held.sound
    assert held.pressing[0].value < 0


def test_a_guide_that_jams_is_told_and_has_no_means():
    results = solved(SLIDING, "load: 100 N, guide: {length: 20 mm, overhang: 90 mm, friction: 0.4}")
    assert results.cam_forces.jams and not results.cam_forces.sound
    own = numbers(results)
    assert own["cam_share"].value < 0 and "cam_T_mean" not in own


def test_the_way_back_has_its_own_load():
    own = columns(solved(SLIDING, "load: {rise: 400 N, return: 60 N}"), "cam_forces_table")
    assert [float(x) for x in own["cam_load"][[0, 2, 4, 5, 7, 11, 12]]] == [400, 400, 400, 60, 60, 60, 400]


BAD = [
    (SLIDING, "moment: 5 N*m", "cam.moment", "follower that swings"),
    (SWINGING, "load: 5 N", "cam.load", "follower that slides"),
    (SWINGING, "guide: {length: 9 mm, overhang: 3 mm, friction: 0.1}", "cam.guide", "follower that slides"),
    (SLIDING, "face_friction: 0.1", "cam.face_friction", "does not slide"),
    (KNIFE, "pin: {radius: 3 mm, friction: 0.1}", "cam.pin", "has no pin"),
    (SLIDING, "pin: {radius: 12 mm, friction: 0.1}", "cam.pin", "as thick"),
    (CHOSEN, "pin: {diameter: 60 mm, friction: 0.1}", "cam.pin", "as thick"),
    (SLIDING, "pin: {friction: 0.1}", "cam.pin", "stated in one way"),
    (KNIFE, "load: 5 N, closure: groove", "cam.closure", "a roller between"),
    (KNIFE, "load: 5 N, contact: {width: 9 mm}", "cam.contact", "no width"),
    (SLIDING, "spring: {rate: 15 N/mm}", "cam.spring", "its preload"),
    (SLIDING, "spring: {rate: 15 N/mm, preload: 4 N, compression: 2 mm}", "cam.spring", "stated twice"),
    (SLIDING, "spring: {ratio: 0.4, rate: 15 N/mm}", "cam.spring", "leaves rate and preload"),
    (SLIDING, "spring: {rate: smallest, compression: 2 mm}", "cam.spring", "needs its rate"),
    (SLIDING, "spring: largest, mass: 1 kg", "cam.spring", "stated by its parts"),
    (SLIDING, "spring: smallest", "cam.spring", "nothing is stated"),
    (SLIDING.replace("speed: 240 rpm, ", ""), "mass: 1 kg", "cam", "needs the speed"),
    (SLIDING, "load: {rise: 4 N, constant: 5 N}", "cam.load", "by one law"),
    (SLIDING, "load: {forward: [[0, 4 N], [1, 5 N]]}", "cam.load", "one way alone"),
    (SLIDING, "load: 4 N, contact: {width: 9 mm, cam: copper}", "cam.contact.cam", "no such material"),
    (SLIDING, "at: [30 deg]", "cam.at", "nothing loads"),
]  # fmt: skip


@pytest.mark.parametrize(("cam", "more", "path", "words"), BAD)
def test_a_slip_is_told_at_its_key(cam, more, path, words):
    with pytest.raises(ProblemError) as raised:
        loading.loads(f"cam: {{{cam}, {more}}}")
    told = [(".".join(map(str, one.path)), one.wrong.text) for one in raised.value.problems]
    assert any(where == path and words in what for where, what in told), told


def test_a_preload_that_no_rate_makes_good_is_refused_in_words():
    with pytest.raises(ProblemError) as raised:
        found(
            KNIFE.replace("sine", "parabolic"),
            "mass: 2.4 kg, load: {rise: 0 N, return: -900 N}, spring: {preload: 40 N, rate: smallest}",
        )
    assert "no rate holds" in raised.value.problems[0].wrong.text


def test_forces_of_an_unsized_cam_take_the_smallest_and_say_so():
    read = loading.loads(f"cam: {{lift: 10 mm, speed: 300 rpm, mass: 1 kg, {LAW}}}")
    said = [one.wrong.text for one in read.doubts]
    assert any("no base circle" in text for text in said) and any("knife edge" in text for text in said)
    assert course.solve(read).cam_forces is not None


def test_every_table_has_its_results():
    results = solved(SLIDING, f"mass: 2.4 kg, load: 100 N, spring: smallest, {GUIDE}, at: [50 deg]")
    names = {table.name for table in tables(results)}
    assert {"cam_forces_table", "cam_forces_diagram", "cam_asked", "cam_force_ends", "cam_springs"} <= names


def test_a_journal_is_stated_by_its_radius_or_its_diameter():
    one, other = (
        columns(solved(SLIDING, f"load: 200 N, pin: {{{size}, friction: 0.1}}"), "cam_forces_table")[
            "cam_T_pin"
        ]
        for size in ("radius: 4 mm", "diameter: 8 mm")
    )
    assert one.max() > 0 and (one == other).all()
