"""A main link that slides: closed forms, own integration in t, another coordinate, works, what cannot be."""

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tmm_report import course, loading
from tmm_report.problems import ProblemError
from tmm_report.results import tables

SLIDER = """
travel:
  from: {begin} m
  to: {end} m
  mass: 25 kg
"""

BOOM = (Path(__file__).parents[3] / "cases" / "explain" / "boom_by_cylinder.yaml").read_text("utf-8")


def travel(more: str, begin: float = 0.0, end: float = 0.4):
    return course.solve(loading.loads(SLIDER.format(begin=begin, end=end) + more)).travel


def told(text: str) -> ProblemError:
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    return error.value


# ---------------------------------------------------------------- closed forms


@pytest.mark.parametrize("speed", [0.0, 1.5])
@pytest.mark.parametrize(("begin", "end"), [(0.0, 0.4), (0.3, -0.1)])
def test_constant_mass_and_force(speed, begin, end):
    """v = √(v₀² + 2 F s/m), t by the mean speed, whichever way it goes."""
    found = travel(f"  speed: {speed} m/s\n  driving: [{{constant: 500 N}}]\n", begin, end)
    v = math.sqrt(speed**2 + 2 * 500 * 0.4 / 25)
    assert found.s.number("v_end") == pytest.approx(v, rel=1e-12)
    assert found.s.number("t_end") == pytest.approx(2 * 0.4 / (v + speed), rel=1e-12)
    assert found.s.number("a") == pytest.approx(20.0, rel=1e-12)
    assert found.place[[0, -1]] == pytest.approx([begin, end], abs=1e-14)
    assert found.v == pytest.approx(np.sqrt(speed**2 + 40 * found.x), rel=1e-12)


def test_a_wheel_and_the_slope_under_a_fall():
    """A mass on an incline that turns a pulley: a = g sin α m/(m + J/r²)."""
    found = travel("  rise: -30 deg\n  wheels: [{inertia: 0.05 kg*m^2, radius: 80 mm}]\n")
    a = 25 * 9.81 * 0.5 / (25 + 0.05 / 0.08**2)
    assert found.s.number("a") == pytest.approx(a, rel=1e-12)
    assert found.s.number("v_end") == pytest.approx(math.sqrt(2 * a * 0.4), rel=1e-12)


def test_friction_stops_it_on_the_way():
    """x = m v²/(2 F), on an edge of the pieces of the integral, too."""
    found = travel("  speed: 1 m/s\n  resistance: [{constant: 100 N}]\n")
    assert found.stops and found.v[-1] == 0
    assert found.s.number("way") == pytest.approx(0.125, rel=1e-12)
    assert found.s.number("t_end") == pytest.approx(0.25, rel=1e-12)


def test_a_force_that_ends_on_the_way():
    """A jump of the force by the place: the work up to it, and no more."""
    found = travel(
        "  driving: [{by_place: [[0 m, 500 N], [0.131 m, 500 N], [0.131 m, 0 N], [0.4 m, 0 N]]}]\n"
    )
    v = math.sqrt(2 * 500 * 0.131 / 25)
    assert found.s.number("v_end") == pytest.approx(v, rel=1e-12)
    assert found.s.number("t_end") == pytest.approx(2 * 0.131 / v + (0.4 - 0.131) / v, rel=1e-10)


def test_a_spring_is_a_quarter_of_a_harmonic():
    """From rest at the greatest deflection to the middle: v = A ω, t = π/(2ω)."""
    found = travel("  springs: [{stiffness: 2 kN/m, free: 0.4 m}]\n")
    omega = math.sqrt(2000 / 25)
    assert found.s.number("v_end") == pytest.approx(0.4 * omega, rel=1e-10)
    assert found.s.number("t_end") == pytest.approx(math.pi / 2 / omega, rel=1e-9)
    assert found.v == pytest.approx(omega * np.sqrt(0.4**2 - (0.4 - found.x) ** 2), rel=1e-7, abs=1e-9)


def test_viscous_resistance_alone():
    """v = v₀ − b x/m, t = −(m/b) ln(v/v₀)."""
    found = travel("  speed: 3 m/s\n  resistance: [{viscous: 40 N*s/m}]\n")
    v = 3 - 40 * 0.4 / 25
    assert found.s.number("v_end") == pytest.approx(v, rel=1e-8)
    assert found.s.number("t_end") == pytest.approx(-25 / 40 * math.log(v / 3), rel=1e-8)


def test_the_square_of_the_speed():
    """m v dv/dx = F − c v²: v² = (F/c)(1 − exp(−2 c x/m))."""
    found = travel("  driving: [{constant: 600 N}]\n  resistance: [{square: {force: 300 N, speed: 2 m/s}}]\n")
    c = 300 / 4
    assert found.v == pytest.approx(
        np.sqrt(600 / c * (1 - np.exp(-2 * c * found.x / 25))), rel=1e-6, abs=1e-8
    )


def test_a_force_that_grows_by_the_time_waits_for_the_resistance():
    """F = 200 t beside 40 N: it starts at 0.2 s, then m x = 200 τ³/6."""
    found = travel("  driving: [{by_time: [[0, 0 N], [2 s, 400 N]]}]\n  resistance: [{constant: 40 N}]\n")
    assert found.waits and found.t[0] == pytest.approx(0.2, rel=1e-9)
    tau = (6 * 25 * 0.4 / 200) ** (1 / 3)
    assert found.s.number("t_end") == pytest.approx(0.2 + tau, rel=1e-8)
    assert found.s.number("v_end") == pytest.approx(200 * tau**2 / 2 / 25, rel=1e-8)


# ---------------------------------------------------------------- own integration in t


MIXED = """
  speed: 0.3 m/s
  rise: 20 deg
  wheels: [{inertia: 0.02 kg*m^2, radius: 60 mm}]
  driving:
    - {by_place: [[0 m, 800 N], [0.15 m, 800 N], [0.4 m, 300 N]]}
    - {by_time: [[0 s, 0 N], [0.1 s, 120 N]]}
    - {by_speed: [[0 m/s, 200 N], [3 m/s, 0 N]]}
  resistance:
    - {viscous: 60 N*s/m}
    - {constant: 30 N}
  springs: [{stiffness: 700 N/m, free: 0.1 m}]
"""


def test_all_kinds_of_forces_by_an_integration_of_our_own():
    found = travel(MIXED)
    m = 25 + 0.02 / 0.06**2

    def rate(t, y):
        x, v = y
        force = np.interp(x, [0, 0.15, 0.4], [800, 800, 300]) + np.interp(t, [0, 0.1], [0, 120])
        force += np.interp(v, [0, 3], [200, 0]) - 60 * v - 30 - 700 * (x - 0.1)
        return [v, (force - 25 * 9.81 * math.sin(math.radians(20))) / m]

    arrived = lambda t, y: y[0] - 0.4  # noqa: E731
    arrived.terminal = True
    own = solve_ivp(rate, (0, 5), [0, 0.3], events=arrived, method="DOP853", rtol=1e-11, atol=1e-12, dense_output=True,
                    max_step=2e-3)  # fmt: skip
    assert found.s.number("t_end") == pytest.approx(own.t[-1], rel=1e-6)
    assert found.s.number("v_end") == pytest.approx(own.y[1, -1], rel=1e-6)
    x, v = own.sol(found.t)
    assert found.x == pytest.approx(x, rel=1e-5, abs=1e-8)
    assert found.v == pytest.approx(v, rel=1e-5)
    assert found.motion.error < 1e-8 and found.s.number("residual") < 1e-6


def test_works_make_the_kinetic_energy():
    found = travel(MIXED)
    gained = (25 + 0.02 / 0.06**2) * (found.v[-1] ** 2 - 0.09) / 2
    assert sum(found.motion.works.values()) == pytest.approx(gained, rel=1e-7)
    works = found.motion.works
    assert works["force1"] == pytest.approx(800 * 0.15 + 550 * 0.25, rel=1e-10)
    assert works["force5"] == pytest.approx(-30 * 0.4, rel=1e-10)
    assert works["spring1"] == pytest.approx(-700 * (0.3**2 - 0.1**2) / 2, rel=1e-10)
    assert works["weight"] == pytest.approx(-25 * 9.81 * math.sin(math.radians(20)) * 0.4, rel=1e-10)


# ---------------------------------------------------------------- a tipper, by the angle of its body

TIPPER = """
mechanism:
  frame: {O: [0, 0], A: [1.5 m, -0.4 m]}
  guides: {axis: {through: A, link: 1}}
  links:
    1: {points: {A: 0, S1: 0.30 m}, mass: 40 kg, mass_centre: S1, inertia: 3.0 kg*m^2}
    2: {points: {B: 0, S2: [-0.35 m, 0]}, mass: 25 kg, mass_centre: S2, inertia: 1.5 kg*m^2, slides: axis}
    3: {points: {O: 0, B: 1.0 m, S3: [1.2216 m, 0.4446 m]}, mass: 800 kg, mass_centre: S3, inertia: 600 kg*m^2}
  driver:
    cylinder: [A, B]
    stroke: {from: 1.10 m, accelerations: [[0.4 s, 0.375 m/s^2], [2.6 s, 0]]}
  assembly: {B: left of O-A}
loads:
  gravity: 9.81 m/s^2
positions: {table: 12}
travel:
  driving:
    - {name: oil, by_place: [[1.10 m, 9 kN], [1.30 m, 7 kN], [1.52 m, 5 kN]]}
  resistance:
    - {name: throttle, viscous: 4 kN*s/m}
"""
A_, R = 1.5 - 0.4j, 1.0


def _of_angle(phi):
    """Places of the mass centres and directions of the cylinder and the body, by the angle of the body."""
    pin = R * np.exp(1j * phi)
    along = (pin - A_) / np.abs(pin - A_)
    places = [A_ + 0.30 * along, pin - 0.35 * along, (1.2216 + 0.4446j) * np.exp(1j * phi)]
    return places, np.abs(pin - A_), along


def _energies(phi, h=1e-5):
    """Moment of inertia and its derivative, potential and its derivative, dl/dφ: by differences of places alone."""

    def inertia(x):
        (low, _, away), (high, _, on) = _of_angle(x - h), _of_angle(x + h)
        rates = [(b - a) / (2 * h) for a, b in zip(low, high, strict=True)]
        turn = np.angle(on / away) / (2 * h)
        moving = sum(m * abs(v) ** 2 for m, v in zip((40, 25, 800), rates, strict=True))
        return moving + (3.0 + 1.5) * turn**2 + 600

    def potential(x):
        return 9.81 * sum(m * z.imag for m, z in zip((40, 25, 800), _of_angle(x)[0], strict=True))

    big = 1e-3
    slope = (inertia(phi + big) - inertia(phi - big)) / (2 * big)
    pull = (potential(phi + h) - potential(phi - h)) / (2 * h)
    length = (_of_angle(phi + h)[1] - _of_angle(phi - h)[1]) / (2 * h)
    return inertia(phi), slope, pull, length


def test_a_tipper_by_the_angle_of_its_body():
    """Lagrange's equation in φ, all by differences of the geometry: dynamics of another coordinate, code of our own."""
    found = course.solve(loading.loads(TIPPER)).travel
    base = abs(A_)
    begin = np.angle(A_) + math.acos((R**2 + base**2 - 1.1**2) / (2 * R * base))
    assert _of_angle(begin)[1] == pytest.approx(1.1, rel=1e-12)

    def rate(t, y):
        phi, omega = y
        inertia, slope, pull, grows = _energies(phi)
        length = _of_angle(phi)[1]
        force = np.interp(length, [1.10, 1.30, 1.52], [9e3, 7e3, 5e3]) - 4e3 * grows * omega
        return [omega, (force * grows - pull - slope * omega**2 / 2) / inertia]

    arrived = lambda t, y: _of_angle(y[0])[1] - 1.52  # noqa: E731
    arrived.terminal = True
    own = solve_ivp(rate, (0, 10), [begin, 0], events=arrived, rtol=1e-9, atol=1e-10, dense_output=True)
    assert found.s.number("t_end") == pytest.approx(own.t[-1], rel=1e-5)
    phi, omega = own.sol(found.t)
    assert found.place == pytest.approx(_of_angle(phi)[1], rel=1e-6)
    assert found.v == pytest.approx(
        [_energies(a)[3] * b for a, b in zip(phi, omega, strict=True)], rel=1e-4, abs=1e-6
    )
    assert found.motion.error < 1e-8


def test_along_the_stated_motion_the_needed_force_brings_that_motion():
    """The force that the reduction finds for a stroke drives the machine as the stroke says: a uniform one here."""
    text = TIPPER.split("travel:")[0].replace(
        "accelerations: [[0.4 s, 0.375 m/s^2], [2.6 s, 0]]", "speed: 0.15 m/s, to: 1.52 m"
    )
    text = text.replace("{table: 12}", "{table: 120}") + "reduction: true\n"
    reduced = course.solve(loading.loads(text)).lever.translation.table
    points = ", ".join(f"[{s:.12g} m, {f:.12g} N]" for s, f in zip(reduced.s, reduced.needed, strict=True))
    found = course.solve(
        loading.loads(f"{text}travel:\n  speed: 0.15 m/s\n  driving: [{{by_place: [{points}]}}]\n")
    ).travel
    assert found.v == pytest.approx(np.full(len(found.v), 0.15), rel=1e-3)
    assert found.s.number("t_end") == pytest.approx(0.42 / 0.15, rel=1e-4)


def test_a_slider_that_drives_a_crank_goes_back_too():
    """Way and forces the other way round: energies of the mechanism at both ends."""
    text = """
mechanism:
  frame: {O: [0, 0], E: [0, 50 mm]}
  guides: {x: {through: E, angle: 0 deg}}
  links:
    1: {points: {O: 0, A: 0.20 m}, inertia: 0.06 kg*m^2}
    2: {points: {A: 0, B: 0.45 m}}
    3: {points: [B], mass: 4 kg, slides: x}
  driver: {slider: 3, stroke: {from: 0.35 m, to: 0.60 m, speed: 1.2 m/s}}
  assembly: {A: left of O-B}
travel:
  from: 0.60 m
  to: 0.35 m
  driving: [{constant: 80 N}]
"""
    found = course.solve(loading.loads(text)).travel

    def crank(s, h=1e-6):  # dφ/ds by the law of cosines
        def phi(x):
            far = math.hypot(x, 0.05)
            return math.atan2(0.05, x) + math.acos((0.2**2 + far**2 - 0.45**2) / (2 * 0.2 * far))

        return (phi(s + h) - phi(s - h)) / (2 * h)

    mass = [4 + 0.06 * crank(s) ** 2 for s in found.place]
    assert found.mass == pytest.approx(mass, rel=1e-6)
    assert found.v == pytest.approx(np.sqrt(2 * 80 * found.x / mass), rel=1e-5, abs=1e-7)
    assert found.place[[0, -1]] == pytest.approx([0.60, 0.35], abs=1e-12)


# ---------------------------------------------------------------- what cannot be


@pytest.mark.parametrize(
    ("more", "path", "wrong"),
    [
        ("  driving: [{constant: 5 N}]\n  resistance: [{constant: 40 N}]\n", ("travel",), "does not move"),
        ("  speed: 0.5 m/s\n  resistance: [{viscous: 4000 N*s/m}]\n", ("travel",), "creeps"),
        ("", ("travel",), "nothing moves the main link"),
        ("  driving: [{constant: 5 N, viscous: 3 N*s/m}]\n", ("travel", "driving", 0), "stated by one law"),
        ("  driving: [{constant: -5 N}]\n", ("travel", "driving", 0, "constant"), ""),
        ("  speed: -1 m/s\n", ("travel", "speed"), ""),
        (
            "  driving: [{by_place: [[0.2 m, 5 N], [0.1 m, 6 N]]}]\n",
            ("travel", "driving", 0, "by_place"),
            "ascend",
        ),
        ("  rise: 120 deg\n", ("travel", "rise"), ""),
    ],
)
def test_what_is_wrong_is_told_at_its_place(more, path, wrong):
    error = told(SLIDER.format(begin=0, end=0.4) + more)
    assert [one.path[: len(path)] for one in error.problems] == [path]
    assert wrong in str(error)


def test_no_mass_no_end_and_no_way_are_told():
    assert "nothing in the machine has a mass" in str(told("travel: {to: 1 m, driving: [{constant: 5 N}]}\n"))
    assert "not said where the motion ends" in str(told("travel: {mass: 1 kg, driving: [{constant: 5 N}]}\n"))
    assert "ends where it begins" in str(told("travel: {mass: 1 kg, to: 0 m, driving: [{constant: 5 N}]}\n"))


@pytest.mark.parametrize(
    ("old", "new", "path", "wrong"),
    [
        ("travel:\n", "travel:\n  to: 1.9 m\n", ("travel", "to"), "beyond the stroke of the mechanism"),
        (
            "gravity: 9.81 m/s^2\n",
            "gravity: 9.81 m/s^2\n  forces: [{at: B, direction: down, by_time: [[0, 5 N], [3 s, 9 N]]}]\n",
            ("loads", "forces", 0),
            "travel looks for another",
        ),
        (
            "gravity: 9.81 m/s^2\n",
            "gravity: 9.81 m/s^2\n  dampers: [{between: [O, S1], viscosity: 100 N*s/m}]\n",
            ("loads", "dampers", 0),
            "a damper among the loads",
        ),
    ],
)
def test_of_a_mechanism(old, new, path, wrong):
    error = told(TIPPER.replace(old, new))
    assert [one.path for one in error.problems] == [path]
    assert wrong in str(error)


TURNS = """
mechanism:
  frame: {O: [0, 0]}
  links:
    1: {points: {O: 0, A: 0.1 m}, inertia: 0.05 kg*m^2}
  driver: {link: 1, speed: 20 rad/s}
travel: {driving: [{constant: 5 N}]}
"""


def test_a_mechanism_whose_driving_link_turns_has_dynamics():
    error = told(TURNS)
    assert [one.path for one in error.problems] == [("travel",)]
    assert "its driving link turns" in str(error) and "dynamics in place of travel" in str(error)


def test_a_main_link_that_would_turn_back_at_once_is_said_not_to_move(recwarn):
    """No step of the integration gets beyond the beginning; nothing of the library's own is told."""
    text = """
travel:
  {mass: 110.7 kg, to: 1.2 m, from: 109 mm, rise: 20 deg, gravity: 9.81 m/s^2, driving: [{viscous: 8.98 N*s/m}],
   springs: [{stiffness: 586 N/m, free: 400 mm}]}
"""
    with pytest.raises(ProblemError, match="does not move"):
        course.solve(loading.loads(text))
    assert not recwarn.list


def test_a_torsion_spring_among_the_loads_works_by_its_energy():
    """c/2 of the square of what is left to its free angle, which counts from position 0 of the stated motion; the angle
    of the boom by the theorem of cosines."""
    spring = "  torsion_springs: [{links: [1, 0], stiffness: 60 N*m/rad, free_angle: 10 deg}]\n"
    variant = loading.loads(BOOM.replace("  forces:\n", spring + "  forces:\n", 1))
    found = course.solve(variant)
    works = next(table for table in tables(found) if table.name == "travel_works")
    by_name = dict(zip(works["acting"].values, works["A"].values, strict=True))
    stated = variant.lever.mechanism.driver.stroke.law.at(np.zeros(1))[0][0]
    ends = np.array([stated, 0.5, 0.64])
    pin, far = abs(0.5 + 0.15j), 0.5
    phi = np.arccos((pin**2 + far**2 - ends**2) / (2 * pin * far))  # but for what is constant
    left = math.radians(10) - (phi[1:] - phi[0])
    assert by_name["M_k1,1"] == pytest.approx(30 * (left[0] ** 2 - left[1] ** 2), rel=1e-9)
