"""Random mechanisms whose driving link moves by random laws of the time, against a solver that shares no code: places
by plain triangles, rates by differences in time alone, the driving moment from the energy."""

import numpy as np
import pytest

from tmm_report import course, loading

SEEDS = range(24)
STEP = 2e-4  # s
WEIGHTS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
G = 9.81


def rate(of, t):
    """d/dt of a function of times by nine points."""
    offsets = np.arange(-4, 5) * STEP
    return sum(weight * of(t + offset) for weight, offset in zip(WEIGHTS, offsets, strict=True)) / STEP


def law(random):
    """The text of a law, its angle by the time and how long it goes."""
    kind = random.integers(3)
    if kind == 0:
        w, size = random.uniform(4, 14), random.uniform(0.05, 0.5)
        text = f"speed: {w!r} rad/s, harmonic: {{amplitude: {size!r} rad, frequency: {2 * w!r} rad/s}}"
        return text, lambda t: w * t + size * np.sin(2 * w * t), 2 * np.pi / w
    if kind == 1:
        middle, size, w = random.uniform(0.6, 2.2), random.uniform(0.2, 0.7), random.uniform(3, 9)
        text = f"angle: {middle!r} rad, harmonic: {{amplitude: {size!r} rad, frequency: {w!r} rad/s, phase: 0.4 rad}}"
        return text, lambda t: middle + size * np.sin(w * t + 0.4), 2 * np.pi / w
    a, b, c = random.uniform(1, 4), random.uniform(-1, 2), random.uniform(-0.5, 0.5)
    text = f"angle: 0.3 rad, polynomial: [{a!r}, {b!r}, {c!r}], time: 1.2 s"
    return text, lambda t: 0.3 + a * t + b * t**2 + c * t**3, 1.2


def slider_crank(random):
    r, rod, e = random.uniform(0.05, 0.12), random.uniform(0.3, 0.6), random.uniform(-0.02, 0.02)
    text = f"""
  frame: {{O: [0, 0], E: [0, {e!r} m]}}
  guides: {{x: {{through: E}}}}
  links:
    1: {{points: {{O: [0, 0], A: [{r!r} m, 0]}}, mass: 3 kg, mass_centre: A, inertia: 0.02 kg*m^2}}
    2:
      points: {{A: [0, 0], B: [{rod!r} m, 0], S: [{rod / 2!r} m, 0]}}
      mass: 2 kg
      mass_centre: S
      inertia: 0.05 kg*m^2
    3: {{points: {{B: [0, 0]}}, slides: x, mass: 5 kg, mass_centre: B}}
  assembly: {{B: right}}"""

    def places(phi):
        A = r * np.exp(1j * phi)
        B = A.real + np.sqrt(rod**2 - (e - A.imag) ** 2) + 1j * e
        return A, B, np.angle(B - A)

    return text, places, lambda phi: ((3, places(phi)[0]), (2, sum(places(phi)[:2]) / 2), (5, places(phi)[1]))


def four_bar(random):
    r, rod, rocker, d = random.uniform(0.05, 0.1), random.uniform(0.3, 0.4), random.uniform(0.25, 0.35), 0.36
    text = f"""
  frame: {{O: [0, 0], C: [{d!r} m, 0]}}
  links:
    1: {{points: {{O: [0, 0], A: [{r!r} m, 0]}}, mass: 3 kg, mass_centre: A, inertia: 0.02 kg*m^2}}
    2:
      points: {{A: [0, 0], B: [{rod!r} m, 0], S: [{rod / 2!r} m, 0]}}
      mass: 2 kg
      mass_centre: S
      inertia: 0.05 kg*m^2
    3: {{points: {{C: [0, 0], B: [{rocker!r} m, 0]}}, mass: 5 kg, mass_centre: B, inertia: 0.01 kg*m^2}}
  assembly: {{B: left of A-C}}"""

    def places(phi):
        A = r * np.exp(1j * phi)
        way = d - A
        along = (np.abs(way) ** 2 + rod**2 - rocker**2) / (2 * np.abs(way))
        B = A + way / np.abs(way) * (along + 1j * np.sqrt(rod**2 - along**2))
        return A, B, np.angle(B - A)

    return text, places, lambda phi: ((3, places(phi)[0]), (2, sum(places(phi)[:2]) / 2), (5, places(phi)[1]))


@pytest.mark.parametrize("seed", SEEDS)
def test_motion_and_moment(seed):
    random = np.random.default_rng(seed)
    stated, angle, period = law(random)
    of_frame, places, masses = (slider_crank, four_bar)[seed % 2](random)
    text = f"mechanism:{of_frame}\n  driver: {{link: 1, law: {{{stated}}}}}\n"
    loads = "loads:\n  forces: [{at: B, direction: left, constant: 200 N}]\npositions: {at: [TIMES]}\n"
    times = np.array([0.13, 0.41, 0.77]) * period
    lever = course.solve(
        loading.loads(text + loads.replace("TIMES", ", ".join(f"{float(t)!r} s" for t in times)))
    ).lever
    motion, forces = lever.kinematics.asked, lever.kinetostatics.asked

    def at(t):
        return places(angle(t))

    assert motion.phi == pytest.approx(angle(times), abs=1e-12)
    for index, point in enumerate("AB"):
        own = [rate(lambda t, i=index: at(t)[i], times)]
        own.append(rate(lambda t, i=index: rate(lambda u, i=i: at(u)[i], t), times))
        assert motion.place(point) == pytest.approx(at(times)[index], abs=1e-12)
        assert motion.velocity(point) == pytest.approx(own[0], abs=1e-8 * np.abs(own[0]).max())
        assert motion.acceleration(point) == pytest.approx(own[1], abs=1e-6 * np.abs(own[1]).max())
    turning = [(0.02, lambda t: angle(t)), (0.05, lambda t: at(t)[2])]
    if seed % 2:
        turning.append((0.01, lambda t: np.angle(at(t)[1] - 0.36)))

    def energy(t):
        moving = sum(
            m * np.abs(rate(lambda u, k=k: masses(angle(u))[k][1], t)) ** 2 / 2
            for k, (m, _) in enumerate(masses(angle(t)))
        )
        spinning = sum(J * rate(of, t) ** 2 / 2 for J, of in turning)
        return moving + spinning + sum(m * G * z.imag for m, z in masses(angle(t)))

    pushed = -200 * rate(lambda t: at(t)[1], times).real
    moment = (rate(energy, times) - pushed) / rate(angle, times)
    assert forces.balancing == pytest.approx(moment, rel=1e-5, abs=1e-5 * np.abs(moment).max())
