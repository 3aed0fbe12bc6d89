"""Wheels and racks in a linkage against a solver that shares no code: all constraints at once, by scipy, and all
equations of equilibrium at once, by least squares, on random geared mechanisms."""

import numpy as np
import pytest
from scipy.optimize import least_squares

from tmm_report import course, loading

G = 9.81


def five_bar(rng):
    """Two cranks coupled by wheels, with or without an idler, their rods in C: (text, numbers)."""
    a, whole = 0.4 * rng.uniform(0.8, 1.2), int(rng.choice([1, 2, 3]))
    internal = bool(rng.integers(2)) and whole > 1
    l1, l2 = 0.05 * rng.uniform(0.8, 1.4, 2)
    l3, l4 = 0.45 * rng.uniform(0.9, 1.1, 2)
    d = {
        "a": a, "ratio": whole, "sense": 1 if internal else -1, "l1": l1, "l2": l2, "l3": l3, "l4": l4,
        "phase": rng.uniform(-3, 3), "alpha": np.radians(rng.uniform(0, 30)),
        "omega": rng.uniform(5, 20) * rng.choice([-1, 1]), "m": rng.uniform(1, 5, 4),
        "J": rng.uniform(0.001, 0.02, 4), "P": complex(*rng.uniform(-300, 300, 2)), "M": rng.uniform(-20, 20),
    }  # fmt: skip
    angle = np.degrees(np.angle(d["P"]))
    text = f"""language: en
mechanism:
  frame: {{O1: [0, 0], O2: [{a}, 0]}}
  links:
    1: {{points: {{O1: 0, A: {l1}}}, mass: {d["m"][0]}, mass_centre: A, inertia: {d["J"][0]}}}
    2: {{points: {{O2: 0, B: {l2}}}, mass: {d["m"][1]}, mass_centre: B, inertia: {d["J"][1]}}}
    3: {{points: {{A: 0, C: {l3}}}, mass: {d["m"][2]}, mass_centre: C, inertia: {d["J"][2]}}}
    4: {{points: {{B: 0, C: {l4}}}, mass: {d["m"][3]}, mass_centre: B, inertia: {d["J"][3]}}}
  wheels:
    - {{links: [1, 2], ratio: {1 / whole}, mesh: {"internal" if internal else "external"}, phase: {d["phase"]},
        pressure_angle: {d["alpha"]}}}
  driver: {{link: 1, speed: {d["omega"]}}}
  assembly: {{C: left of A-B}}
loads:
  gravity: {G}
  forces: [{{at: C, direction: {angle} deg, constant: {abs(d["P"])} N, on: "3"}}]
  moments: [{{on: 2, direction: counter-clockwise, constant: {d["M"]} N*m}}]
positions: {{table: 12}}
"""
    return text, d


def pose(d, phi):
    """Angles of links 2, 3 and 4 by the constraints alone, each a root of all of them."""
    phi2 = d["phase"] + d["sense"] * d["ratio"] * phi
    A, B = d["l1"] * np.exp(1j * phi), d["a"] + d["l2"] * np.exp(1j * phi2)

    def gap(q):
        z = A + d["l3"] * np.exp(1j * q[0]) - B - d["l4"] * np.exp(1j * q[1])
        return [z.real, z.imag]

    x = least_squares(gap, [1.0, 2.1], xtol=1e-15, ftol=1e-15, gtol=1e-15).x
    return np.array([phi, phi2, *x]), A, B, A + d["l3"] * np.exp(1j * x[0])


def rates(d, phi):
    """Velocities and accelerations of A, B, C and of the angles by central differences of the poses."""
    h = 1e-3
    rows = []
    for k in (-2, -1, 0, 1, 2):
        q, *points = pose(d, phi + k * h)
        rows.append([*np.unwrap(q), *points])
    rows = np.array(rows, complex)
    rows[:, :4] = np.unwrap(rows[:, :4].real, axis=0)
    first = (rows[0] - 8 * rows[1] + 8 * rows[3] - rows[4]) / (12 * h)
    second = (-rows[0] + 16 * rows[1] - 30 * rows[2] + 16 * rows[3] - rows[4]) / (12 * h * h)
    w = d["omega"]
    return rows[2], first * w, second * w * w


def balancing(d, phi):
    """M_bal by virtual work: no reaction, no force in the teeth is in it."""
    _, v, a = rates(d, phi)
    (vA, vB, vC), (aA, aB, aC) = v[4:], a[4:]
    m, J = d["m"], d["J"]

    def power(force, velocity):
        return (force * np.conj(velocity)).real

    total = power(d["P"], vC) + d["M"] * v[1].real
    for mass, velocity, acceleration in zip(m, (vA, vB, vC, vB), (aA, aB, aC, aB), strict=True):
        total += power(mass * (-1j * G - acceleration), velocity)
    total -= sum(J[k] * a[k].real * v[k].real for k in range(4))
    return -total / d["omega"]


def statics(d, phi):
    """All reactions at once: 12 equations of 4 links; unknown R01, R02, R13, R24, R34, the teeth's F_t and M_bal."""
    x, _, acc = rates(d, phi)
    A, B, C = x[4:]
    aA, aB, aC = acc[4:]
    m, J = d["m"], d["J"]
    # wheels: where their circles touch, and the force that i·(unit to the right) along F_t has with its radial part
    r1 = d["a"] * d["ratio"] / (d["ratio"] + 1) if d["sense"] < 0 else d["a"] * d["ratio"] / (d["ratio"] - 1)
    P = complex(r1)
    inertia = {
        1: (m[0] * (-1j * G - aA), A, -J[0] * acc[0].real), 2: (m[1] * (-1j * G - aB), B, -J[1] * acc[1].real + d["M"]),
        3: (m[2] * (-1j * G - aC) + d["P"], C, -J[2] * acc[2].real), 4: (m[3] * (-1j * G - aB), B, -J[3] * acc[3].real),
    }  # fmt: skip

    def solved(flank):
        """On wheel 2 the teeth give F (i − flank·…tan α): the flank that F's sign presses."""
        M, b = np.zeros((12, 12)), np.zeros(12)
        places = [(0j, 1, 0), (d["a"] + 0j, 2, 0), (A, 3, 1), (B, 4, 2), (C, 4, 3)]
        for k, link in enumerate((1, 2, 3, 4)):
            force, at, couple = inertia[link]
            b[3 * k : 3 * k + 3] = -force.real, -force.imag, -(np.conj(at) * force).imag - couple
        for n, (at, plus, minus) in enumerate(places):
            for sign, link in ((1, plus), (-1, minus)):
                if link:
                    for c, e in enumerate((1 + 0j, 1j)):
                        M[3 * link - 3 : 3 * link, 2 * n + c] = (
                            sign * e.real, sign * e.imag, sign * (np.conj(at) * e).imag
                        )  # fmt: skip
        apart = (
            1.0 if d["sense"] < 0 else -1.0
        )  # external: wheel 2 is pushed to the right, inside a ring 1 to the left
        line = 1j + flank * apart * np.tan(d["alpha"])
        for sign, link in ((1, 2), (-1, 1)):
            M[3 * link - 3 : 3 * link, 10] = (
                sign * line.real,
                sign * line.imag,
                sign * (np.conj(P) * line).imag,
            )
        M[2, 11] = 1.0
        return np.linalg.solve(M, b)

    x = solved(1)
    return x if x[10] >= 0 else solved(-1)


@pytest.mark.parametrize("seed", range(24))
def test_geared_five_bar_at_random(seed):
    text, d = five_bar(np.random.default_rng(seed))
    found = course.solve(loading.loads(text)).lever
    motion, forces = found.kinematics.table, found.kinetostatics
    assert forces.worst_lever < 1e-9 and forces.worst_power < 1e-9
    for k in (0, 3, 7):
        phi = float(motion.phi[k])
        x, v, a = rates(d, phi)
        assert motion.place("C")[k] == pytest.approx(x[6], abs=1e-9)
        assert motion.velocity("C")[k] == pytest.approx(v[6], rel=1e-6, abs=1e-7)
        assert motion.acceleration("C")[k] == pytest.approx(a[6], rel=1e-4, abs=1e-3)
        assert motion.angular_velocity("2")[k] == pytest.approx(
            d["sense"] * d["ratio"] * d["omega"], rel=1e-12
        )
        scale = float(forces.table.scale[k])
        assert forces.table.balancing[k] == pytest.approx(balancing(d, phi), abs=1e-5 * scale)
        alone = statics(d, phi)
        size = np.abs(alone[:11]).max()
        for n, (by, on) in enumerate((("0", "1"), ("0", "2"), ("1", "3"), ("2", "4"), ("3", "4"))):
            force = np.ravel(forces.table.statics.force(on, by) + 0 * motion.phi)[k]
            assert force == pytest.approx(complex(*alone[2 * n : 2 * n + 2]), abs=1e-5 * size)
        assert forces.table.balancing[k] == pytest.approx(alone[11], abs=1e-5 * scale)


CHAIN = """language: en
mechanism:
  frame: {O: [0, 0], D: [300 mm, 0], E: [300 mm, 180 mm], F: [300 mm, 260 mm], G: [300 mm, 300 mm]}
  guides: {x: {through: G}}
  links:
    1: {points: {O: 0, A: 70 mm}}
    2: {points: {A: 0, B: 280 mm}, mass: 2 kg, inertia: m*l^2/12}
    3: {points: {D: 0, B: 200 mm}, mass: 2 kg, inertia: m*l^2/12}
    4: {points: {E: 0, H: 40 mm}, mass: 1 kg, mass_centre: H, inertia: 0.01 kg*m^2}
    5: {points: {F: 0}, inertia: 0.01 kg*m^2}
    6: {points: {J: 0}, mass: 3 kg, slides: x}
  wheels:
    - {links: [3, 4], teeth: [70, 40], phase: 30 deg}
    - {links: [5, 4], ratio: 1.3}
  racks:
    - {wheel: 5, slider: 6, radius: 30 mm, phase: 20 deg, pressure_angle: 25 deg}
  driver: {link: 1, speed: 100 rpm}
  assembly: {B: left of A-D}
loads:
  gravity: 9.81 m/s^2
  forces: [{at: J, direction: against motion, constant: 300 N}]
positions: {table: 12}
"""


@pytest.fixture(scope="module")
def chain():
    return course.solve(loading.loads(CHAIN)).lever


def test_a_rocker_turns_a_pinion_an_idler_and_a_rack_in_fixed_ratios(chain):
    """Ratios that are no whole numbers: of a swing the angles are told from its middle."""
    s = chain.kinematics.diagram.state
    swing = np.unwrap(np.angle(s.u["3"]))
    for link, ratio in (("4", -70 / 40), ("5", 70 / 40 * 1.3)):
        turned = np.unwrap(np.angle(s.u[link]))
        assert turned - turned[0] == pytest.approx(ratio * (swing - swing[0]), abs=1e-12)
    way = chain.kinematics.diagram.place("J").real
    turned = np.unwrap(np.angle(s.u["5"]))
    assert np.abs(way - way[0]) == pytest.approx(0.03 * np.abs(turned - turned[0]), abs=1e-12)


def test_a_chain_of_wheels_holds_power_and_lever(chain):
    forces = chain.kinetostatics
    assert chain.structure.formula == "I(0,1) → II2(2,3) → z(4) → z(5) → z(6)"
    assert forces.worst_lever < 1e-12 and forces.worst_power < 1e-9


def test_the_forces_of_the_teeth_do_no_work(chain):
    """Both wheels of a mesh have one velocity in the pitch point, so its force has no power."""
    motion, found = chain.kinematics.table, chain.kinetostatics.table.statics
    for wheel in chain.structure.linkage.structure.coupled:
        force, at = found.reactions[wheel.contact.key].force, wheel.mesh.touches(motion.state)
        ends = [motion.state.velocity(x, at - motion.state.r[x]) for x in (wheel.link, wheel.by)]
        along = ends[0] - ends[1]
        size = np.nanmax(np.abs(force)) * np.nanmax(np.abs(ends[0]))
        assert np.nanmax(np.abs((np.conj(force) * along).real)) < 1e-12 * size
        # that pressed flank: the teeth push, they never pull their own wheel towards the other
        out = wheel.mesh.outward(wheel.link)
        assert np.all((np.conj(force) * out).real * (1 if wheel.slides else -1) >= -1e-9 * np.abs(force))


def test_plans_read_what_is_computed(chain):
    assert 0 < chain.plans.worst < 1.0
    assert any(one.key == "w_5" for one in chain.plans.drawn[0].comparison)


def test_moments_of_the_teeth_are_those_of_the_force_about_each_axis(chain):
    from tmm_report.chapters.lever.kinetostatics.quantities.wheels import moments_of

    solved = chain.kinetostatics.table
    for wheel in chain.structure.linkage.structure.coupled:
        force = solved.statics.reactions[wheel.contact.key].force
        for link, moment in moments_of(wheel, solved):
            arm = wheel.mesh.touches(solved.motion.state) - wheel.mesh.axes[wheel.mesh.links.index(link)]
            by_force = (np.conj(arm) * (force if link == wheel.link else -force)).imag
            assert moment == pytest.approx(by_force, rel=1e-12, abs=1e-9)
