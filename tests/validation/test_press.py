"""The published crank press with twin rods (a diploma thesis): its printed digits out of the general class IV solver
and, separately, out of the closed forms of its parallelogram.

ERRATUM: the thesis prints R01y = 39.34692 N at 90°, with the crank's own inertia force of the wrong sign;
it is 38.69092.
"""

from dataclasses import replace

import numpy as np
import pytest
from conftest import read, stating

from tmm_report import course
from tmm_report.chapters.kinematics.given import Positions
from tmm_report.chapters.kinetostatics.loads import Loads
from tmm_report.mechanics import motion
from tmm_report.mechanics.assembly import assemble

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
