"""Every formula of a rotor against sums of vectors and against what the tables say by numpy."""

import numpy as np
import pytest
from notes import VARIANTS
from twice import disagreements, rows_disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.rotor.equations import ROWS
from tmm_report.chapters.machine.rotor.quantities import tables

MASSES = (
    "masses: [{mass: 2 kg, radius: 30 mm, angle: 70 deg, at: 50 mm}, "
    "{unbalance: 40 g*mm, angle: 200 deg, at: -20 mm}]"
)
DISC = "bodies: [{mass: 30 kg, eccentricity: 0.2 mm, angle: 300 deg, at: 90 mm, products: {xz: 0.002, yz: -0.001}}]"
ASKEW = "bodies: [{mass: 30 kg, at: 90 mm, tilt: {angle: 1 deg, towards: 40 deg, axial: 0.8, across: 0.5}}]"
ONE, TWO = (
    "planes: [{at: 0, radius: 80 mm}]",
    "planes: [{at: 10 mm, mass: 0.9 kg}, {at: 300 mm, radius: 80 mm}]",
)
TURNS = "bearings: [-30 mm, 400 mm], speed: 1500 rpm"
TEXTS = {
    "one": f"{MASSES}, {ONE}",
    "two": f"{MASSES}, {TWO}, {TURNS}, grade: 6.3, mass: 40 kg, centre: 0.1",
    "set askew": f"{ASKEW}, {TWO}, {TURNS}",
    "of bodies": f"{DISC}, {TWO}, bearings: [400 mm, -30 mm], speed: 20 rad/s, grade: 16",
    "backwards": f"{MASSES}, {DISC}, planes: [{{at: 300 mm, radius: 80 mm}}, {{at: 0, radius: 80 mm}}], mass: 70 kg",
    "in balance": "masses: [{mass: 1 kg, radius: 0, angle: 0, at: 0}], " + ONE,
}


def found_of(name):
    text = (
        f"rotor: {{{TEXTS[name]}}}"
        if name in TEXTS
        else (VARIANTS / f"{name}.yaml").read_text(encoding="utf-8")
    )
    return course.solve(loading.loads(text)).rotor


@pytest.mark.parametrize("name", [*TEXTS, "rotor"])
def test_every_formula_agrees_with_the_second_way(name):
    found = found_of(name)
    assert disagreements(found.s, _ways(found)) == []


@pytest.mark.parametrize("name", [*TEXTS, "rotor"])
def test_formulas_of_rows_agree_with_the_tables(name):
    found = found_of(name)
    named = [name for name in ROWS if found.given.bearings or name not in ("carried", "force")]
    if not found.given.speed:
        named = [name for name in named if name != "force"]
    formulas = [formula for name in named for formula in ROWS[name](found)]
    assert rows_disagreements(tables(found), formulas) == []


def _ways(found):
    """The pull of the shaft, and the moment with which it turns a plane over, in space at ω = 1 rad/s."""
    given = found.given
    pull, moment = np.zeros(3), np.zeros(3)
    for one in given.heavy:
        arm = one.mass * one.radius if getattr(one, "unbalance", None) is None else one.unbalance
        force = arm * np.array([np.cos(one.angle), np.sin(one.angle), 0.0])
        pull += force
        moment += np.cross([0.0, 0.0, one.at - given.planes[0].at], force)
        moment += [-one.couple.imag, one.couple.real, 0.0]
    size = np.hypot(*pull[:2])
    mass = given.mass or (np.sum([one.mass for one in given.heavy]) if found.masses is not None else None)
    ways = {
        "D_x": pull[0], "D_y": pull[1], "D": size, "alpha": np.arctan2(pull[1], pull[0]) % (2 * np.pi),
        "M_x": moment[1], "M_y": -moment[0], "M": np.linalg.norm(moment),
    }  # fmt: skip
    if mass:
        ways["e"] = size / mass
    if given.grade and given.speed:
        ways["D_per"] = mass * (1e-3 * given.grade / given.speed)  # the permissible eccentricity of all of it
    return ways
