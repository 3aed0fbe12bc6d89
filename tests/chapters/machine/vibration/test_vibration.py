"""Vibration: closed forms against the integrated equation of motion, energy over a period, two masses against matrices,
the sum over the harmonics against the integral under the mechanism's own force, and what cannot be solved."""

import math
import re

import numpy as np
import pytest
from conftest import examples, read, solved
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import VARIANTS

from tmm_report import course, loading
from tmm_report.chapters.machine.vibration import quantities
from tmm_report.mechanics.calculus import ode
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body
from tmm_report.problems import ProblemError

ZETAS = st.floats(0.0, 3.0)
ETAS = st.floats(0.05, 6.0)
PRESS = Body(400.0, 250e3, 1500.0)


def integrated(body: Body, force, t, place=0.0, speed=0.0, **form):
    """x at the times `t` from the equation of motion itself."""

    def rate(time, y):
        return [y[1], (force(time, y[1]) - body.damping * y[1] - body.stiffness * y[0]) / body.inertia]

    return ode.integrate(rate, [place, speed], (0.0, float(t[-1])), method="DOP853", **form).at(t)[0]


def vibration(text: str, alone: bool = True) -> course.Results:
    return course.solve(loading.loads("vibration:\n" + text if alone else text)).vibration


MACHINE = "  mass: 400 kg\n  stiffness: 250 kN/m\n  force: 600 N\n  speed: 90 rad/s\n"


# --- one mass


@pytest.mark.parametrize("zeta", [0.0, 0.05, 0.7, 1.0, 1.0 + 1e-7, 2.5])
def test_motion_from_the_start_is_that_of_the_integrated_equation(zeta):
    """No damping, little of it, the critical one and more."""
    body = Body(400.0, 250e3, 2 * zeta * math.sqrt(400.0 * 250e3))
    t, omega = np.linspace(0.0, 1.2, 60), 31.0
    wave = complex(vib.steady(body, omega, 600.0))
    ours = vib.motion(body, t, omega, wave, 0.002, -0.1)
    theirs = integrated(body, lambda time, _: 600 * math.sin(omega * time), t, 0.002, -0.1)
    assert np.allclose(ours, theirs, rtol=0, atol=1e-8 * abs(theirs).max())


def test_free_motion_without_damping_is_a_sine_and_keeps_its_energy():
    body, t = Body(2.0, 18.0), np.linspace(0.0, 40.0, 4001)
    x = vib.free(body, t, 0.03, 0.12)
    assert np.allclose(x, 0.03 * np.cos(3 * t) + 0.04 * np.sin(3 * t), rtol=0, atol=1e-14)
    assert abs(x).max() == pytest.approx(0.05, rel=1e-5)


def test_critically_damped_motion_crosses_zero_once_at_most_and_is_the_limit_from_both_sides():
    t = np.linspace(0.0, 4.0, 400)
    lines = [vib.free(Body(1.0, 9.0, 6 * (1 + step)), t, 1.0, -8.0) for step in (-1e-7, 0.0, 1e-7)]
    assert np.allclose(lines[1], np.exp(-3 * t) * (1 - 5 * t), rtol=0, atol=1e-14)
    assert np.allclose(lines, lines[1], rtol=0, atol=1e-6)
    assert np.count_nonzero(np.diff(np.sign(lines[1]))) == 1


def test_overdamped_motion_does_not_overflow_however_stiff_its_damper():
    x = vib.free(Body(1.0, 1.0, 1e6), np.array([0.0, 1.0, 1e6]), 1.0, 0.0)
    assert np.allclose(x, [1.0, 1.0, math.exp(-1)], rtol=1e-5)


def test_at_resonance_without_damping_the_amplitude_grows_with_the_time():
    body, t = Body(2.0, 18.0), np.linspace(0.0, 30.0, 50)
    theirs = integrated(body, lambda time, _: 5 * math.sin(3 * time), t)
    assert np.allclose(vib.resonant(body, t, 5.0), theirs, rtol=0, atol=1e-8)


@given(ETAS, st.floats(0.001, 3.0))
def test_the_damper_takes_all_the_work_of_the_force(eta, zeta):
    """π F A sin ψ a period against π b ω A², in parts of π F²/c."""
    size = vib.magnification(eta, zeta)
    assert size * math.sin(vib.lag(eta, zeta)) == pytest.approx(2 * zeta * eta * size**2, rel=1e-9)


@given(ZETAS)
def test_all_dampings_hand_on_the_whole_force_at_root_two(zeta):
    assert vib.transmissibility(math.sqrt(2), zeta) == pytest.approx(1.0, rel=1e-12)


@given(st.floats(0.01, 0.7))
def test_the_peak_is_higher_than_its_surroundings(zeta):
    eta, height = vib.peak(zeta)
    assert height == pytest.approx(1 / (2 * zeta * math.sqrt(1 - zeta**2)), rel=1e-9)
    assert all(vib.magnification(eta + step, zeta) <= height for step in (-1e-3, 1e-3))


@given(st.floats(0.005, 0.99), ZETAS)
def test_the_chosen_frequency_ratio_gives_the_wanted_force_ratio(wanted, zeta):
    eta = vib.eta_for(wanted, zeta)
    assert eta > math.sqrt(2) * (1 - 1e-12)
    assert vib.transmissibility(eta, zeta) == pytest.approx(wanted, rel=1e-9)


@given(st.floats(0.02, 0.9), st.floats(1.5, 8.0))
def test_the_largest_allowed_damping_gives_the_wanted_force_ratio(wanted, eta):
    zeta = vib.zeta_for(wanted, eta)
    if vib.transmissibility(eta, 0.0) > wanted:
        assert math.isnan(zeta)
    else:
        assert vib.transmissibility(eta, zeta) == pytest.approx(wanted, rel=1e-6)


# --- dry friction


@pytest.mark.exhaustive
def test_dry_friction_by_the_closed_form_is_what_the_integrated_motion_settles_to():
    body, omega, force, friction = Body(400.0, 250e3), 40.0, 600.0, 120.0
    sought = vib.dry_exact(body, omega, force, friction)

    # the sign is rounded off over a thousandth of the largest speed, as a step of time cannot follow a jump
    def push(time, speed):
        return force * math.sin(omega * time) - friction * math.tanh(speed / (1e-3 * sought * omega))

    # a little viscous damping lets the free part die away
    damped = body._replace(damping=60.0)
    t = np.linspace(0.0, 13.0, 8001)
    x = integrated(damped, push, t, relative=1e-7, absolute=1e-10)
    settled = abs(x[-700:]).max()
    assert settled == pytest.approx(sought, rel=0.02)
    assert vib.dry_amplitude(body, omega, force, friction) == pytest.approx(sought, rel=0.02)


def test_little_dry_friction_changes_little_and_too_much_holds_the_machine():
    free = 600 / 250e3 * vib.magnification(1.6, 0.0)
    omega = 1.6 * PRESS.natural
    bare = PRESS._replace(damping=0.0)
    assert vib.dry_amplitude(bare, omega, 600.0, 1e-6) == pytest.approx(free, rel=1e-9)
    assert vib.dry_exact(bare, omega, 600.0, 1e-6) == pytest.approx(free, rel=1e-9)
    assert math.isnan(vib.dry_amplitude(bare, omega, 600.0, 500.0))


def test_equivalent_damper_takes_the_work_of_the_friction():
    found = vibration(MACHINE + "  friction: 200 N\n")
    assert math.pi * found.s.get("equivalent") * found.omega * found.s.get("dry") ** 2 == pytest.approx(
        4 * 200 * found.s.get("dry"), rel=1e-12
    )


# --- two masses


@given(st.floats(0.01, 3.0), st.floats(0.1, 5.0), st.floats(0.0, 400.0), st.floats(0.5, 30.0))
def test_two_masses_answer_as_their_matrices_do(share, stiff, damping, omega):
    first, second = Body(3.0, 900.0, 7.0), Body(3.0 * share, 900.0 * stiff, damping)
    c = np.array([[900 * (1 + stiff), -900 * stiff], [-900 * stiff, 900 * stiff]])
    b = np.array([[7 + damping, -damping], [-damping, damping]])
    m = np.diag([3.0, 3.0 * share])
    theirs = np.linalg.solve(c - m * omega**2 + 1j * omega * b, [2.0, 5.0])
    assert np.allclose(vib.pair(first, second, omega, (2.0, 5.0)), theirs, rtol=1e-9)
    squares = np.linalg.eigvals(np.linalg.solve(m, c))
    assert np.allclose(vib.pair_natural(first, second), np.sqrt(np.sort(squares.real)), rtol=1e-9)


def test_a_base_too_heavy_to_move_leaves_the_machine_as_on_the_ground():
    stated = "  damping_ratio: 0.1\n  foundation: {mass: 1e11 kg, stiffness: 1e12 N/m}\n"
    found = vibration(MACHINE + stated)
    assert found.force * abs(found.stood.machine) == pytest.approx(found.s.get("amplitude"), rel=1e-6)
    assert found.stood.grounded < 1e-3 < found.s.number("ratio")


def test_machine_on_a_base_that_gives_way_balances_all_forces():
    """The exciting force, both inertia forces and what reaches the ground."""
    found = solved("locomotive_diesel").vibration
    stood, w = found.stood, found.omega
    inertia = w**2 * (found.body.inertia * stood.machine + stood.base.inertia * stood.under)
    assert 1 + inertia == pytest.approx(complex(vib.through(stood.base, w) * stood.under), rel=1e-9)


# --- absorbers


def test_tuned_absorber_stops_the_machine_and_its_springs_carry_the_force():
    found = vibration(MACHINE + "  absorber: {mass: 40 kg}\n")
    tuned = found.absorbed.tuned
    assert tuned.work == 0
    assert tuned.hung.stiffness * tuned.swing == pytest.approx(1.0, rel=1e-12)
    low, high = found.absorbed.natural
    assert low < min(found.natural, 90.0) and max(found.natural, 90.0) < high


def test_the_table_of_absorbers_by_the_two_equations_of_motion():
    found = vibration(MACHINE + "  damping_ratio: 0.03\n  absorber: {mass: 40 kg}\n")
    (table,) = [one for one in quantities.tables(found) if one.name == "vibration_absorbers"]
    keys = ("inertia", "stiffness", "damping", "omega", "force")
    mass, stiffness, damping, omega, force = (found.s.number(key) for key in keys)
    columns = ("absorber", "absorber_stiffness", "absorber_damping", "amplitude", "absorber_swing")
    for own, c, b, machine, absorber in zip(*(table[key].values for key in columns), strict=True):
        hung, held = c + 1j * omega * b, stiffness + 1j * omega * damping
        rows = [[held + hung - omega**2 * mass, -hung], [-hung, hung - omega**2 * own]]
        moved = np.abs(np.linalg.solve(np.array(rows), [force, 0.0]))
        assert (machine, absorber) == pytest.approx(tuple(moved), rel=1e-9, abs=1e-12)


@given(st.floats(0.02, 1.0))
@settings(max_examples=examples(30))
def test_best_damping_of_the_absorber_has_its_neighbours_worse(mu):
    """Around the closed form nothing is better by more than its known shortfall, a few hundredths of a per cent."""
    main = Body(1.0, 1.0)
    best = vib.best_absorber(main, mu)
    over = np.linspace(0.3, 1.6, 1301)
    height = vib.greatest(main, best, over)[1]
    assert height == pytest.approx(math.sqrt(1 + 2 / mu), rel=0.02)
    for stiff, damping in ((1.06, 1.0), (0.94, 1.0), (1.0, 1.25), (1.0, 0.8)):
        other = Body(best.inertia, best.stiffness * stiff, best.damping * damping)
        assert vib.greatest(main, other, over)[1] > height * (1 - 2e-3)


@given(st.floats(0.05, 2.0))
@settings(max_examples=examples(30))
def test_best_damper_without_a_spring_by_search(mu):
    main = Body(1.0, 1.0)
    damper = vib.lanchester(main, mu)
    eta = math.sqrt(2 / (2 + mu))  # where the curves of all dampings cross
    over = eta * np.linspace(0.5, 1.5, 4001)
    height = vib.greatest(main, damper, over)[1]
    assert height == pytest.approx(1 + 2 / mu, rel=1e-6)
    for more in (0.97, 1.03):
        other = Body(damper.inertia, 0.0, damper.damping * more)
        assert vib.greatest(main, other, over)[1] > height


def test_cleared_range_holds_no_natural_frequency():
    for stiffness in ("200 kN/m", "3240 kN/m", "9 MN/m"):
        text = (
            MACHINE.replace("250 kN/m", stiffness)
            + "  damping_ratio: 0.01\n  absorber: {clear: [0.8, 1.2]}\n"
        )
        low, high = vibration(text).absorbed.natural
        assert low <= 0.8 * 90 * (1 + 1e-12) and high >= 1.2 * 90 * (1 - 1e-12), stiffness
        assert min(abs(low / 72 - 1), abs(high / 108 - 1)) < 1e-9


# --- the mechanism's own force


@pytest.fixture(scope="module")
def shaken():
    text = VARIANTS.joinpath("piston_pump.yaml").read_text(encoding="utf-8")
    own = (
        "vibration: {mass: 200 kg, isolators: 4, stiffness: 3 kN/m, damping_ratio: 0.2, mechanism: 30 deg}\n"
    )
    return course.solve(loading.loads(text + own))


def test_shaking_force_is_the_rate_of_the_momentum(shaken):
    """By the exact derivative of a periodic function, from velocities alone."""
    of, cycle = shaken.vibration.shaking, shaken.lever.kinematics.cycle
    motion = cycle.motion(of.turned[:-1])
    links = [link for link in motion.linkage.mechanism.links.values() if link.mass and link.mass_centre]
    along = np.exp(1j * math.pi / 6)
    momentum = sum(
        link.mass * np.real(motion.velocity(link.mass_centre) * along.conjugate()) for link in links
    )
    spectrum = np.fft.rfft(momentum) * 1j * np.arange(len(momentum) // 2 + 1)
    spectrum[-1] = 0
    rate = np.fft.irfft(spectrum, len(momentum)) * of.omega
    assert np.allclose(of.force[:-1], -rate, rtol=0, atol=1e-8 * abs(of.force).max())


def test_sum_over_the_harmonics_is_the_integrated_steady_motion(shaken):
    found = shaken.vibration
    of, body = found.shaking, found.body
    period = 2 * math.pi / of.omega
    start = of.moved[0], float(np.gradient(of.moved[:3], of.turned[1] / of.omega, edge_order=2)[0])

    def force(time, _):
        return np.interp(time % period, of.turned / of.omega, of.force)

    t = of.turned / of.omega
    x = integrated(body, force, t, *start, relative=1e-7, absolute=1e-12, longest=period / 200)
    assert np.allclose(x, of.moved, rtol=0, atol=1e-3 * abs(of.moved).max())


def test_printed_harmonics_add_up_to_the_force_and_to_the_motion(shaken):
    found = shaken.vibration
    of = found.shaking
    waves = [a * np.cos(k * of.turned - p) for k, a, p in zip(of.orders, of.sizes, of.phases, strict=True)]
    assert abs(sum(waves) - of.force).max() < 2e-3 * abs(of.force).max()
    table = next(t for t in quantities.tables(found) if t.name == "vibration_harmonics")
    psi = vib.lag(table["eta"].values, found.zeta)
    moved = sum(
        a * np.cos(k * of.turned - p - lag)
        for k, a, p, lag in zip(of.orders, table["amplitude"].values, of.phases, psi, strict=True)
    )
    assert np.allclose(moved, of.moved, rtol=0, atol=1e-3 * abs(of.moved).max())


def test_force_on_the_base_is_the_shaking_force_less_the_inertia_of_the_machine(shaken):
    found = shaken.vibration
    of = found.shaking
    spectrum = np.fft.rfft(of.moved[:-1]) * -((np.arange(len(of.moved) // 2 + 1) * of.omega) ** 2)
    inertia = found.body.inertia * np.fft.irfft(spectrum, len(of.moved) - 1)
    assert np.allclose(of.force[:-1] - inertia, of.handed[:-1], rtol=0, atol=1e-8 * abs(of.force).max())


# --- the chapter


def test_unbalance_shakes_with_the_square_of_the_speed():
    text = MACHINE.replace("force: 600 N", "unbalance: {mass: 2 kg, radius: 30 mm}")
    found = vibration(text)
    assert found.force == pytest.approx(2 * 0.03 * 90**2)
    table = next(t for t in quantities.tables(found) if t.name == "vibration_response")
    far = vibration(text.replace("90 rad/s", "9000 rad/s"))
    assert far.s.get("amplitude") == pytest.approx(
        2 * 0.03 / 400, rel=1e-3
    )  # the mass centre stays where it is
    row = list(table["eta"].values).index(round(found.eta, 12))
    assert table["amplitude"].values[row] == pytest.approx(found.s.get("amplitude"), rel=1e-9)


@pytest.mark.parametrize("kind", ["force: 600 N", "base: 2 mm", "unbalance: {mass: 2 kg, radius: 30 mm}"])
@pytest.mark.parametrize("damping", ["0", "0.3", "1", "1.7"])
def test_motion_of_the_chapter_satisfies_its_equation(kind, damping):
    text = MACHINE.replace("force: 600 N", kind) + f"  damping_ratio: {damping}\n"
    found = vibration(text + "  start: {displacement: 3 mm, velocity: 0.2 m/s}\n")
    w, body = found.omega, found.body

    def push(time, _):
        if found.given.base is None:
            return found.force * math.sin(w * time)
        z = found.given.base
        return body.stiffness * z * math.sin(w * time) + body.damping * z * w * math.cos(w * time)

    t = np.linspace(0.0, min(found.lasting, 0.5), 40)
    ours = vib.motion(body, t, w, found.phasor, 0.003, 0.2)
    assert np.allclose(ours, integrated(body, push, t, 0.003, 0.2), rtol=0, atol=1e-8)
    assert np.interp(t, found.times, found.motion) == pytest.approx(ours, abs=2e-4)
    assert found.motion[0] == pytest.approx(0.003, abs=1e-12)
    one, other = found.s.number("C1"), found.s.number("C2")
    wave = found.s.get("amplitude") * np.sin(w * t - found.s.get("lag"))
    decays = np.exp(-found.s.get("decay") * t)
    swing = {
        "under": lambda: (np.cos((found.s.get("damped") or 0) * t), np.sin((found.s.get("damped") or 0) * t)),
        "critical": lambda: (1.0, t),
        "over": lambda: (np.cosh((found.s.get("root") or 0) * t), np.sinh((found.s.get("root") or 0) * t)),
    }[found.kind]()
    assert np.allclose(decays * (one * swing[0] + other * swing[1]) + wave, ours, rtol=0, atol=1e-9)


def test_tables_of_responses_say_what_the_machine_would_do_then():
    """Each row is the machine itself at that speed, or with that damping."""
    text = (
        MACHINE.replace("force: 600 N", "unbalance: {mass: 2 kg, radius: 30 mm}") + "  damping_ratio: 0.2\n"
    )
    tables = {table.name: table for table in quantities.tables(vibration(text))}
    response, dampings = tables["vibration_response"], tables["vibration_dampings"]
    for row in (3, 7):
        speed = float(response["omega"].values[row])
        there = vibration(text.replace("90 rad/s", f"{speed!r} rad/s"))
        assert response["amplitude"].values[row] == pytest.approx(there.s.number("amplitude"), rel=1e-9)
        assert response["on_base"].values[row] == pytest.approx(there.s.number("on_base"), rel=1e-9)
        assert response["lag"].values[row] == pytest.approx(there.s.number("lag"), rel=1e-9)
    for zeta, beta, handed in zip(*(dampings[key].values for key in ("zeta", "beta", "ratio")), strict=True):
        there = vibration(text.replace("damping_ratio: 0.2", f"damping_ratio: {zeta}"))
        assert beta == pytest.approx(there.s.number("amplitude") / there.s.number("static"), rel=1e-9)
        assert handed == pytest.approx(there.s.number("ratio"), rel=1e-9)


def test_chosen_stiffness_gives_the_wanted_force_ratio():
    found = solved("locomotive_diesel").vibration
    assert found.s.get("ratio") == pytest.approx(0.08, rel=1e-12)
    assert found.body.stiffness == pytest.approx(found.s.get("needed_stiffness"), rel=1e-12)
    assert found.s.get("on_base") == pytest.approx(
        abs(complex(vib.through(found.body, found.omega) * found.phasor)), rel=1e-12
    )


@pytest.mark.parametrize(
    "shaken",
    [
        "mass: 3\n  force: 9 N",
        "mass: 3\n  base: 1 mm",
        "inertia: 3\n  moment: 9",
        "inertia: 3\n  base: 1 deg",
    ],
)
def test_chosen_stiffness_without_damping_gives_the_wanted_ratio(shaken):
    found = vibration(f"  {shaken}\n  speed: 90 rad/s\n  transmissibility: 0.2\n")
    s = found.s
    assert s.number("ratio_z" if "base" in s else "ratio") == pytest.approx(0.2, rel=1e-12)
    assert s.number("eta") == pytest.approx(math.sqrt(6), rel=1e-12)  # 1/(η² - 1) = 0.2
    assert s.get("zeta") == s.get("damping") == 0.0 and "most_damping" not in s


def test_a_disc_on_a_shaft_is_the_same_arithmetic_in_other_units():
    text = "  inertia: 400 kg*m^2\n  stiffness: 250e3 N*m/rad\n  moment: 600 N*m\n  speed: 90 rad/s\n"
    disc, machine = vibration(text), vibration(MACHINE)
    assert disc.s.get("amplitude") == machine.s.get("amplitude")
    units = {value.key: value.unit for value in quantities.values(disc)}
    assert units["vibration_amplitude"] == "rad" and units["vibration_on_base"] == "N·m"
    assert "vibration_sag" not in units


def test_infinite_values_stand_in_no_table():
    found = vibration(MACHINE + "  absorber: {mass: 40 kg}\n")
    for table in quantities.tables(found):
        for column in table.columns:
            if column.key != "kind":
                assert not np.isinf(np.asarray(column.values, float)).any(), (table.name, column.key)
    assert read("locomotive_diesel").vibration.isolators == 12


# --- what cannot be


def complaint(text: str) -> list[tuple[str, str]]:
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    return [(".".join(map(str, problem.path)), str(problem.wrong)) for problem in error.value.problems]


def test_resonance_without_damping_is_explained():
    (place, text), *rest = complaint("vibration:\n" + MACHINE.replace("90 rad/s", "25 rad/s"))
    assert (place, rest) == ("vibration", [])
    assert "resonance without damping" in text and "without bound" in text
    vibration(MACHINE.replace("90 rad/s", "25 rad/s") + "  damping_ratio: 0.01\n")


def test_resonance_of_a_higher_harmonic_is_found():
    text = VARIANTS.joinpath("piston_pump.yaml").read_text(encoding="utf-8")
    stiffness = 200 * (3 * 90 * math.pi / 30) ** 2
    own = f"vibration: {{mass: 200 kg, stiffness: {stiffness!r}, mechanism: right}}\n"
    ((_, said),) = complaint(text + own)
    assert "harmonic 3" in said


@pytest.mark.parametrize(
    ("lines", "place", "words"),
    [
        ("  mass: 4 kg\n  stiffness: 9 N/m\n", "vibration", "must be stated once"),
        (MACHINE + "  base: 1 mm\n", "vibration", "must be stated once"),
        ("  mass: 4 kg\n  force: 3 N\n  speed: 3 rad/s\n", "vibration", "how stiff"),
        (
            "  mass: 4 kg\n  force: 3 N\n  stiffness: 3 N/m\n",
            "vibration",
            "frequency of the excitation is missing",
        ),
        ("  mass: 4 kg\n  stiffness: 9 N/m\n  mechanism: up\n", "vibration.mechanism", "no mechanism"),
        (MACHINE + "  damping: 3\n  damping_ratio: 1\n", "vibration.damping_ratio", "stated twice"),
        (MACHINE + "  friction: 590 N\n", "vibration.friction", "more work"),
        (
            MACHINE.replace("force: 600 N", "base: 1 mm") + "  friction: 1 N\n",
            "vibration.friction",
            "sinusoidal",
        ),
        (MACHINE + "  absorber: {}\n", "vibration.absorber", "one statement"),
        (MACHINE + "  absorber: {clear: [1.1, 1.2]}\n", "vibration.absorber.clear", "between the two parts"),
        (MACHINE + "  transmissibility: 1.5\n", "vibration.transmissibility", "out of range"),
        (MACHINE + "  foundation: {mass: 4 kg}\n", "vibration.foundation.stiffness", "missing"),
        (
            "  inertia: 4 kg*m^2\n  moment: 3 N*m\n  stiffness: 3 N/m\n  speed: 1\n",
            "vibration.stiffness",
            "N/m",
        ),
    ],
)
def test_a_mistake_is_told_with_its_place(lines, place, words):
    told = complaint("vibration:\n" + lines)
    assert any(where == place and words in said for where, said in told), told


def test_friction_at_resonance_and_a_ringing_base_are_told():
    at = MACHINE.replace("90 rad/s", "25 rad/s") + "  damping_ratio: 0.1\n  friction: 50 N\n"
    assert any("does not bound" in said for _, said in complaint("vibration:\n" + at))
    low, _ = vib.pair_natural(Body(900.0, 1e6), Body(400.0, 250e3))
    rings = (
        MACHINE.replace("90 rad/s", f"{float(low)!r} rad/s")
        + "  foundation: {mass: 900 kg, stiffness: 1e6 N/m}\n"
    )
    assert [place for place, _ in complaint("vibration:\n" + rings)] == ["vibration.foundation"]


def test_a_mechanism_without_masses_shakes_nothing():
    text = VARIANTS.joinpath("conveyor.yaml").read_text(encoding="utf-8")
    light = re.sub(r"\b(mass|mass_centre|inertia): [^,}\n]*,? ?", "", text.split("\nloads:")[0])
    own = "\nvibration: {mass: 200 kg, stiffness: 3 kN/m, mechanism: right}\n"
    assert complaint(light + own) == [
        ("vibration.mechanism", "the mechanism does not shake its frame in this direction")
    ]
