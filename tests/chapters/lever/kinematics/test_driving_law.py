"""A driving link that moves by a law of the time: rates, forces and drawings by a second way each; what is refused."""

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.mechanics.calculus.roots import slope
from tmm_report.problems import ProblemError

TEXT = """
mechanism:
  frame: {O: [0, 0], C: [0.4 m, 0.1 m], E: [0.4 m, 0.5 m]}
  guides: {g: {through: E, angle: 20 deg}}
  links:
    1: {points: {O: [0, 0], A: [100 mm, 0]}, mass: 2 kg, mass_centre: A, inertia: 0.09 kg*m^2}
    2: {points: {A: [0, 0], B: [450 mm, 0]}, mass: 1.5 kg, inertia: m*l^2/12}
    3: {points: {C: [0, 0], B: [300 mm, 0]}, mass: 2 kg, inertia: m*l^2/12}
    4: {points: {B: [0, 0], D: [500 mm, 0]}, mass: 1 kg, inertia: m*l^2/12}
    5: {points: {D: [0, 0]}, slides: g, mass: 4 kg, mass_centre: D}
  driver: {link: 1, law: {LAW}}
  assembly: {B: left of A-C, D: right}
loads:
  gravity: 9.81 m/s^2
  forces: [{at: D, direction: against motion, constant: 300 N}]
"""
LAWS = {
    "harmonic": "speed: 12 rad/s, harmonic: {amplitude: 0.15 rad, phase: 20 deg}",
    "clockwise": "speed: -12 rad/s, harmonic: {amplitude: 0.15 rad, frequency: 24 rad/s}",
    "rocker": "angle: 60 deg, harmonic: {amplitude: 35 deg, frequency: 8 rad/s}",
    "accelerated": "speed: 5 rad/s, acceleration: 4 rad/s^2",
    "slowing": "speed: 9 rad/s, acceleration: -4 rad/s^2, angle: 30 deg, time: 1 s",
    "polynomial": "polynomial: [0, 6, -2], time: 2 s, angle: 20 deg",
    "angles": "angles: [[0 s, 0 deg], [0.2 s, 70 deg], [0.4 s, 120 deg], [0.7 s, 200 deg], [1 s, 360 deg]]",
    "open angles": "angles: [[0 s, 10 deg], [0.2 s, 70 deg], [0.4 s, 120 deg], [0.7 s, 100 deg], [1 s, 30 deg]]",
    "phases": "phases: [{rise: 150 deg, law: sine}, {dwell: 30 deg}, {return: 180 deg, law: polynomial}], "
    "swing: 60 deg, time: 1 s",
}
every = pytest.mark.parametrize("law", LAWS)
_found = {}


def variant(law, text=TEXT):
    return loading.loads(text.replace("LAW", LAWS.get(law, law)))


def found(law):
    if law not in _found:
        _found[law] = course.solve(variant(law)).lever
    return _found[law]


def told(law, text=TEXT):
    with pytest.raises(ProblemError) as caught:
        course.solve(variant(law, text))
    return [f"{problem.key}: {problem.text()}" for problem in caught.value.problems]


@every
def test_rates_are_derivatives_by_the_time(law):
    """Of places and angles, taken at other times: no rate takes part in it."""
    kinematics = found(law).kinematics
    cycle, omega = kinematics.cycle, kinematics.omega
    theta = np.array([0.3, 0.9, 1.4, 2.2, 2.9, 3.3, 4.1, 5.0, 5.8])
    theta = theta[np.min(np.abs(theta[:, None] - np.array([*cycle.breaks, -9.0])), axis=1) > 0.02]
    motion, step = cycle.motion(theta), 2e-3
    for point in ("A", "B", "D"):
        for part in (np.real, np.imag):
            places = slope(lambda x, p=point, part=part: part(cycle.motion(x).place(p)), theta, step) * omega
            rates = (
                slope(lambda x, p=point, part=part: part(cycle.motion(x).velocity(p)), theta, step) * omega
            )
            sizes = np.abs(motion.velocity(point)).max(), np.abs(motion.acceleration(point)).max()
            assert places == pytest.approx(part(motion.velocity(point)), abs=1e-8 * sizes[0])
            assert rates == pytest.approx(part(motion.acceleration(point)), abs=1e-8 * sizes[1])
    for link in "1234":
        w = motion.angular_velocity(link)
        turned = (
            slope(lambda x, k=link: np.unwrap(np.angle(cycle.motion(x).turn(k))), theta[:1], step) * omega
        )
        assert turned == pytest.approx(w[:1], abs=1e-8 * np.abs(w).max())


@every
def test_the_balancing_moment_three_ways(law):
    forces = found(law).kinetostatics
    assert forces.worst_lever < 1e-12
    assert forces.worst_power < 1e-9
    kinetic = found(law).kinematics.table
    assert np.abs(kinetic.angular_acceleration("1")).max() > 1  # J ε of the driving link takes part


@every
def test_energy_is_kept_over_a_law_that_repeats(law):
    forces = found(law).kinetostatics
    repeats = found(law).kinematics.cycle.law.returns
    assert (forces.works is not None) == repeats
    if repeats:
        assert abs(forces.works.whole) < 1e-9 * forces.works.size
        assert forces.works.balancing.whole > 0


@every
def test_analogues_do_not_depend_on_the_law(law):
    """S′ω and S″ω² + S′ε are the rates by the time; S′ is the same at the same angle, whatever law brings it there."""
    from tmm_report.chapters.lever.kinematics.quantities import tables

    book = {table.name: table for table in tables(found(law).kinematics)}
    outputs, rates = book["outputs_table"], book["rates_table"]
    first, second = (book["analogues_table"][key].values for key in ("dS_D", "ddS_D"))
    w, e = (rates[f"{letter}_1"].values for letter in "we")
    size = np.abs(outputs["A_D"].values).max()
    assert outputs["V_D"].values == pytest.approx(first * w, abs=1e-12 * np.abs(first * w).max())
    assert outputs["A_D"].values == pytest.approx(second * w**2 + first * e, abs=1e-12 * size)
    turned = found(law).kinematics.cycle.phi(found(law).kinematics.turned)
    uniform = course.solve(loading.loads(TEXT.replace("law: {LAW}", "speed: 1 rad/s"))).lever.kinematics
    there = uniform.cycle.motion(turned - uniform.cycle.zero)
    along = found(law).kinematics.travels[0].output.direction
    assert first == pytest.approx((there.velocity("D") * np.conj(along)).real, abs=1e-12)


@every
def test_plans_show_both_parts_of_the_pins_acceleration(law):
    plans = found(law).plans
    assert plans.drawn and plans.worst < 5.0
    for drawn in plans.drawn:
        values = {one.key: one for one in drawn.comparison}
        e = found(law).kinematics.table.angular_acceleration("1")[drawn.position]
        assert ("a_AO_t" in values) == (abs(e) > 1e-9)
        if "a_AO_t" in values:
            w = found(law).kinematics.table.angular_velocity("1")[drawn.position]
            assert values["a_AO_n"].graph == pytest.approx(w**2 * 0.1, rel=1e-3)
            assert values["a_AO_t"].graph == pytest.approx(abs(e) * 0.1, rel=1e-3)


def test_equal_steps_are_equal_times():
    accelerated = found("accelerated").kinematics
    phi = np.unwrap(np.angle(accelerated.table.turn("1")))
    t = (np.sqrt(25 + 16 * np.pi) - 5) / 4 * np.arange(13) / 12
    assert phi == pytest.approx(5 * t + 2 * t**2, abs=1e-12)
    assert accelerated.table.angular_velocity("1") == pytest.approx(5 + 4 * t)


SHORT = TEXT.replace("[450 mm, 0]", "[150 mm, 0]")


def test_a_swing_within_the_limits_needs_no_more_of_the_lengths():
    lever = course.solve(
        variant("angle: 200 deg, harmonic: {amplitude: 5 deg, frequency: 8 rad/s}", TEXT)
    ).lever
    assert not lever.kinematics.gaps
    near = "angle: 20 deg, harmonic: {amplitude: 15 deg, frequency: 8 rad/s}"
    assert not course.solve(variant(near, SHORT)).lever.kinematics.gaps


def test_a_swing_beyond_the_limits_is_told_with_its_phases():
    far = "angle: 100 deg, harmonic: {amplitude: 60 deg, frequency: 8 rad/s}"
    kinematics = course.solve(variant(far, SHORT)).lever.kinematics
    gap = kinematics.gaps[0]
    inside = np.array([(a + b) / 2 for a, b in gap.intervals])
    assert not kinematics.cycle.motion(inside).closes.any()
    ends = np.array([end for interval in gap.intervals for end in interval])
    assert (
        kinematics.cycle.motion(ends + 1e-6).closes.any()
        and not kinematics.cycle.motion(ends + 1e-6).closes.all()
    )


SLIPS = {
    "speed: 5 rad/s": "is not stated in one way",
    "acceleration: 5 rad/s^2, harmonic: {amplitude: 5 deg}": "is not stated in one way",
    "acceleration: 0": "an acceleration of 0 is constant speed",
    "speed: 5 rad/s, acceleration: -4 rad/s^2": "stops after 1.25 s, having turned 179.049°",
    "harmonic: {amplitude: 5 deg}": "the harmonic needs the key frequency",
    "harmonic: {amplitude: 0, frequency: 1 rad/s}": "a harmonic without an amplitude is none",
    "speed: 5 rad/s, harmonic: {amplitude: 5 deg, frequency: 3.1 rad/s}": "no whole number of turns",
    "polynomial: [1, 2]": "the law polynomial needs the key time",
    "polynomial: [0], time: 1 s": "the driving link does not move",
    "polynomial: [40], time: 1 s": "goes over more than 2 turns",
    "angles: [[0, 0], [1, 1], [0.5, 2], [2, 2]]": "must ascend, from 0 on",
    "angles: [[0, 0], [1, 1]]": "4",
    "angles: [[0, 0], [1, 1], [1.5, 2], [2, 2]], time: 2 s": "time is nothing of the law angles",
    "phases: [{rise: 180 deg, law: sine}, {return: 180 deg, law: sine}], swing: 40 deg": "needs the key time",
    "phases: [{rise: 180 deg, law: sine}, {return: 90 deg, law: sine}], swing: 40 deg, time: 1 s": "270° and not 360°",
    "phases: [{rise: 180 deg, law: sine}, {return: 180 deg, law: sine}], time: 1 s": "needs the key swing",
}


@pytest.mark.parametrize("law", SLIPS)
def test_slips(law):
    (line,) = told(law)
    assert line.startswith("mechanism.driver.law")
    assert SLIPS[law] in line


@pytest.mark.parametrize("key", ["speed: 5 rad/s", "rotation: clockwise", "turns: 2", "range: 90 deg"])
def test_what_the_law_says_itself_is_not_stated_beside_it(key):
    (line,) = told("rocker", TEXT.replace("{link: 1,", f"{{link: 1, {key},"))
    assert line.startswith("mechanism.driver")


@pytest.mark.parametrize(
    "block",
    [
        "flywheel: {delta: 0.05, mean_speed: 5 rad/s}",
        "friction: {joints: {coefficient: 0.1, diameter: 20 mm}}",
        "reduction: {link: 4}",
        "methods: true",
        "method: auto",
    ],
)
def test_what_reckons_with_uniform_rotation_is_refused(block):
    assert any("a uniformly turning driving link" in line for line in told("rocker", TEXT + block + "\n"))


def test_a_change_point_within_the_law_is_refused():
    text = TEXT.replace("C: [0.4 m, 0.1 m]", "C: [0.45 m, 0]").replace("B: [300 mm, 0]", "B: [100 mm, 0]")
    (line,) = told("harmonic", text)
    assert "goes through a change point" in line


GEARED = """
mechanism:
  frame: {O: [0, 0], P: [0, -45 mm]}
  guides: {x: {through: P}}
  links:
    1: {points: {O: [0, 0]}, inertia: 0.02 kg*m^2}
    2: {points: {B: [0, 0]}, mass: 3 kg, mass_centre: B, slides: x}
  racks: [{slider: 2, wheel: 1, radius: 45 mm, phase: 40 deg}]
  driver: {link: 1, law: {LAW}}
loads:
  forces: [{at: B, direction: right, constant: 80 N}]
"""


def test_a_rocker_drives_a_rack():
    """x = ∓r (φ − φ₀), and the moment of the teeth, inertia among it, is that of the force on the rack."""
    lever = course.solve(variant("rocker", GEARED)).lever
    t = np.arange(13) / 12 * 2 * np.pi / 8
    phi = np.radians(60 + 35 * np.sin(8 * t))
    speed, spin = np.radians(35) * 8 * np.cos(8 * t), -np.radians(35) * 64 * np.sin(8 * t)
    motion = lever.kinematics.table
    moved = motion.place("B").real
    sign = np.sign(moved[3] - moved[0]) * np.sign(phi[3] - phi[0])
    assert moved == pytest.approx(sign * 0.045 * (phi - np.radians(40)), abs=1e-12)
    assert motion.velocity("B").real == pytest.approx(sign * 0.045 * speed, abs=1e-12)
    assert motion.acceleration("B").real == pytest.approx(sign * 0.045 * spin, abs=1e-11)
    moment = 0.02 * spin + sign * 0.045 * (3 * sign * 0.045 * spin - 80)
    assert lever.kinetostatics.table.balancing == pytest.approx(moment, abs=1e-10)


def test_a_crank_that_goes_round_drives_no_rack():
    (line,) = told("harmonic", GEARED)
    assert "the rack on link 2 runs away" in line


@pytest.mark.parametrize("law", [name for name in LAWS if "angle:" not in LAWS[name]])
@pytest.mark.parametrize("zero", ["point: D, extreme: right", "link: 3, extreme: clockwise"])
def test_a_law_begins_in_an_extreme_position(law, zero):
    """There the output stands with a driving link that turns uniformly; what goes on differs by the law alone."""
    begun = TEXT.replace("LAW}", f"LAW}}, zero: {{{zero}}}")
    moving = course.solve(variant(law, begun)).lever.kinematics
    uniform = course.solve(loading.loads(begun.replace("law: {LAW}", "speed: 12 rad/s"))).lever.kinematics
    angle = moving.cycle.law.of_phase(0.0)[0]
    assert np.cos(angle - uniform.cycle.zero) == pytest.approx(1.0, abs=1e-15)
    plain = found(law).kinematics.cycle.law
    theta = np.linspace(0.0, 6.0, 7)
    for own, other in zip(moving.cycle.law.of_phase(theta)[1:], plain.of_phase(theta)[1:], strict=True):
        assert own == pytest.approx(other, rel=1e-12, abs=1e-12)
    motion = moving.cycle.motion(np.zeros(1))
    rate = motion.velocity("D") if "point" in zero else motion.angular_velocity("3")
    assert np.abs(rate) == pytest.approx([0.0], abs=1e-9)


def test_where_a_law_begins_is_stated_once_and_is_there():
    twice = TEXT.replace("LAW}", "LAW}, zero: {angle: 5 deg}")
    assert any("stated twice, by zero" in one for one in told("slowing", twice))
    begun = variant("accelerated", twice).lever.mechanism.driver.law
    assert float(begun.of_phase(0.0)[0]) == pytest.approx(np.radians(5), rel=1e-15)
    nowhere = TEXT.replace("LAW}", "LAW}, zero: {point: A, extreme: right}").replace(
        "A: [100 mm, 0]", "A: [1e-12, 0]"
    )
    assert told("accelerated", nowhere)
    unknown = TEXT.replace("LAW}", "LAW}, zero: {point: Z, extreme: right}")
    assert [one.split(":")[0] for one in told("accelerated", unknown)] == ["mechanism.driver.zero.point"]


@pytest.mark.parametrize("swing", [80, -80])
def test_phases_may_end_where_they_lift_to(swing):
    """The turn of a shaft from one rest to another: 10u³ − 15u⁴ + 6u⁵, either way."""
    law = f"angle: 60 deg, phases: [{{rise: 360 deg, law: polynomial}}], swing: {swing} deg, time: 0.8 s"
    motion = found(law)
    u = np.linspace(0, 1, 13)
    turned = np.radians(60 + swing * (10 * u**3 - 15 * u**4 + 6 * u**5))
    assert motion.kinematics.cycle.law.of_phase(2 * np.pi * u)[0] == pytest.approx(turned, rel=1e-13)
    assert not motion.kinematics.cycle.closed
    backwards = "angle: 60 deg, phases: [{return: 360 deg, law: polynomial}], swing: 80 deg, time: 0.8 s"
    assert any("beginning with a rise;" in f"{one};" for one in told(backwards))


def test_a_law_of_a_mechanism_that_is_not_assembled_yet_may_be_looked_at():
    text = TEXT.replace("LAW}", "LAW}, zero: {link: 3, extreme: clockwise}").replace("B: left of A-C, ", "")
    with pytest.raises(ProblemError, match="can be assembled in two ways"):
        course.solve(variant("accelerated", text))
