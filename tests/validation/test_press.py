"""The published crank press with twin rods (a diploma thesis): its printed digits out of the general class IV solver
and, separately, out of the closed forms of its parallelogram.

ERRATA. The thesis prints R01y = 39.34692 N at 90°, with the crank's own inertia force of the wrong sign; it is
38.69092. It parts R23 from R24 by the moments on link 2 about its mass centre with an arm of 0.198/2 m where half of
CE, 0.135/2 m, belongs; their sum is right. Its text speaks of a force of 50 kN, its law begins with 43 982 N.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from conftest import read, stating

from tmm_report import course
from tmm_report.chapters.lever.kinematics.given import Positions
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.mechanics.calculus.laws import ByAngle
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.stated import assemble

# crank angle, deg: phi3, rad; slider's distance, m; analogues w3 and v5
ROWS = {
    90: (1.570796327, 0.2045294045, 0.2162162162, 0.0),
    91: (1.574569829, 0.2045341796, 0.2161848246, 0.0005471784528),
    92: (1.578342235, 0.2045485044, 0.2160906553, 0.001094321675),
    93: (1.582112451, 0.2045723782, None, None),
}
MOMENTS = {90: 0.0, 91: -0.02641107710, 92: -0.05281920897}


@pytest.fixture(scope="module")
def press():
    """Every degree, no technological load."""
    variant = read("press")
    positions = Positions(table=360, diagram=36, plans=(), force_plan=())
    return course.solve(stating(variant, positions=positions, loads=Loads(gravity=-9.8j), friction=None))


def test_structure(press):
    assert press.lever.structure.formula == "I(0,1) → IV2(2,3,4,5)"
    (slider,) = [t for t in press.lever.kinematics.travels if t.output.kind == "slider"]
    assert slider.stroke == pytest.approx(0.080, abs=1e-12)


@pytest.mark.parametrize("angle", ROWS)
def test_kinematics(press, angle):
    k, motion = angle - 90, press.lever.kinematics.table
    phi3, s5, w3, v5 = ROWS[angle]
    assert np.angle(motion.turn("3")[k]) == pytest.approx(phi3, abs=1e-9)
    assert -motion.place("S5")[k].imag == pytest.approx(s5, abs=1e-10)
    if w3 is not None:
        assert motion.angular_velocity("3")[k] / 10 == pytest.approx(w3, abs=1e-10)
        assert abs(motion.velocity("S5")[k]) / 10 == pytest.approx(v5, abs=2e-11)


def test_closed_forms_of_the_parallelogram(press):
    """Link 2 only translates; the slider is that of an offset slider-crank, e = 0 in the middle plane."""
    motion = press.lever.kinematics.table
    phi = motion.phi
    drop = np.sqrt(0.09**2 - 0.0675**2)
    psi = np.arccos(-0.04 * np.cos(phi) / 0.185)  # the rods lean by the crank's displacement across the guide
    y = 0.04 * np.sin(phi) - drop - 0.185 * np.sin(psi)
    np.testing.assert_allclose(motion.place("S5").imag, y, atol=1e-13)
    w = -0.04 * np.sin(phi) / (0.185 * np.sin(psi))
    np.testing.assert_allclose(np.abs(motion.angular_velocity("3")), np.abs(10 * w), atol=1e-11)
    np.testing.assert_allclose(motion.angular_velocity("2"), 0, atol=1e-11)


@pytest.mark.parametrize("angle", MOMENTS)
def test_balancing_moment(press, angle):
    assert press.lever.kinetostatics.table.balancing[angle - 90] == pytest.approx(MOMENTS[angle], abs=2e-9)


def test_reactions(press):
    """Those that do not hang on where the mass centre of link 2 is, and the corrected reaction of the frame."""
    force = press.lever.kinetostatics.table.statics.force
    assert force("1", "0")[0].imag == pytest.approx(38.69092, abs=1e-5)
    assert force("1", "0")[1].imag == pytest.approx(38.69226, abs=1e-5)
    assert force("1", "0")[1].real == pytest.approx(-0.000972, abs=1e-6)
    assert force("2", "1")[0].imag == pytest.approx(37.41172433, abs=1e-8)
    assert (force("5", "3") + force("5", "4"))[0].imag == pytest.approx(25.32648649, abs=1e-8)
    assert force("5", "0")[1].real == pytest.approx(0.1033822909, abs=2e-9) or abs(
        force("5", "0")[1].real
    ) == pytest.approx(0.1033822909, abs=2e-9)


HEIGHT = math.sqrt(
    0.09**2 - 0.0675**2
)  # of the triangle of link 2: its mass centre is a third of it above CE
SUMS = {90: (0.0, 37.41172433, -32.90512434), 91: (-0.006695957755, 37.41301256, -32.90593919)}
"""Printed: R12x and R12y as they act on link 2, R23y + R24y."""
ARM, PRINTED_ARM = 0.135, 0.198  # m: CE, and what the thesis's program has in its place


def split(press, angle: int, arm: float) -> tuple[complex, complex]:
    """R23 and R24, the forces of links 3 and 4 on link 2, from the printed reaction R12 and the printed sum.

    Both rods move alike, so that their forces differ along the rod alone; the moments about the mass centre of link 2,
    which does not turn, give by how much: (R23x + R24x) h/3 − R12x 2h/3 = (R23y − R24y) arm/2.
    """
    x, _, sum_y = SUMS[angle]
    own = press.lever.kinetostatics.table.loading.inertia["2"][angle - 90].real
    whole = complex(-x - own, sum_y)
    rod = press.lever.kinematics.table.turn("3")[angle - 90]
    apart = 2 / arm * (whole.real * HEIGHT / 3 - x * 2 * HEIGHT / 3)
    half = rod / rod.imag * apart / 2
    return whole / 2 + half, whole / 2 - half


@pytest.mark.parametrize("angle", SUMS)
def test_reactions_of_the_twin_rods_apart(press, angle):
    """By the right arm; with the thesis's own the parts are others, the sum is the same."""
    force = press.lever.kinetostatics.table.statics.force
    found = [force("2", rod)[angle - 90] for rod in ("3", "4")]
    assert sum(found).imag == pytest.approx(SUMS[angle][2], abs=2e-8)
    np.testing.assert_allclose(
        found, split(press, angle, ARM), atol=2e-6
    )  # S2 is stated to a hundredth of a mm
    printed = split(press, angle, PRINTED_ARM)
    assert sum(printed) == pytest.approx(sum(found), abs=1e-7)
    if angle > 90:
        ratio = (printed[0] - printed[1]) / (found[0] - found[1])
        assert ratio == pytest.approx(ARM / PRINTED_ARM, abs=1e-4) and abs(printed[0] - found[0]) > 3e-3


def test_crank_about_its_pivot_and_its_mass_centre(press):
    """The printed 100.9e-6 kg m² is about O: 35.3e-6 about S1, by Steiner."""
    crank = press.lever.given.mechanism.links["1"]
    assert crank.stated == ("O", 100.9e-6)
    assert crank.inertia == pytest.approx(35.3e-6, abs=1e-12)


def test_law_of_the_load_is_the_thesis_s_own():
    """72 000 N/rad · (3π/2 − φ1) from 235° to 270°, nothing elsewhere."""
    law = read("press").lever.loads.forces[0].law
    assert isinstance(law, ByAngle)
    begins, ends = np.radians([235 - 90, 270 - 90])  # position 0 is at φ1 = 90°
    np.testing.assert_allclose(law.angles, (0, begins, begins, ends), atol=1e-12)
    np.testing.assert_allclose(law.values, (0, 0, 72000 * (ends - begins), 0), atol=1)


@pytest.mark.parametrize(
    ("values", "greatest"), [((0, 0, 43982, 0), 1187.28), ((0, 0, 50e3, 50e3, 0), 1350.0)]
)
def test_greatest_moment_is_just_after_the_jump_of_the_load(values, greatest):
    """Under the thesis's law, and under 50 kN throughout: the diagram positions miss it by a fifth."""
    variant = read("press")
    angles = np.radians([0, 145, 145, 180, 180][: len(values)])
    force = replace(variant.lever.loads.forces[0], by_angle=list(zip(angles, values, strict=True)))
    found = course.solve(stating(variant, loads=replace(variant.lever.loads, forces=(force,)), friction=None))
    _, high = found.lever.kinetostatics.extremes
    assert high.value == pytest.approx(greatest, abs=0.05)
    assert math.degrees(high.turned) == pytest.approx(145, abs=1e-9) and high.side == 1
    forces = found.lever.kinetostatics
    assert np.nanmax(forces.diagram.balancing) < 0.9 * high.value


@pytest.mark.exhaustive
def test_crank_as_long_as_the_rods_passes_its_double_change_points():
    """Two changes fall together at 0 and 180°, where the singular value only touches zero: no endless small steps."""
    mechanism = read("press").lever.mechanism
    crank = mechanism.links["1"]
    long = replace(crank, points={**crank.points, "B": 0.185 + 0j})
    linkage = assemble(replace(mechanism, links={**mechanism.links, "1": long}))
    branch = linkage.groups[-1].branches[0]
    assert branch.limits == (None, None) and branch.returns
    np.testing.assert_allclose(branch.changes, (np.pi, 2 * np.pi), atol=1e-5)
    slider = motion.solve(linkage, np.linspace(0.0, 2 * np.pi, 361) + 1e-4).place("S5")
    assert np.abs(np.diff(slider)).max() < 0.185 * (2 * np.pi / 360)
