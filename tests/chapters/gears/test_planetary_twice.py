"""Every formula of a planetary stage against mechanics/gears/planetary, which finds the same in other ways."""

import math

import numpy as np
import pytest
from notes import VARIANTS
from test_planetary_stage import SINGLE, STAGES, TWO, given
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.gears.planetary.equations import (
    coaxiality,
    deviation,
    efficiency,
    neighbourhood,
    ring_tip,
)
from tmm_report.chapters.gears.planetary.quantities.stage import book
from tmm_report.chapters.gears.planetary.solve.stage import Found, solve
from tmm_report.chapters.gears.planetary.steps import stage
from tmm_report.mechanics.gears import involute
from tmm_report.mechanics.gears.planetary.stage import ROWS
from tmm_report.mechanics.gears.trains import Train, speeds

MORE = {
    "helical": {**SINGLE, "helix": "12 deg", "teeth": [20, 46, 112]},
    "helical, two modules": {
        **TWO, "helix": "10 deg", "scheme": "external-internal", "ratio": 12, "module": ["5 mm", "4 mm"],
        "input": "wheel1", "output": "carrier",
    },
    "stated distance": {**SINGLE, "teeth": [20, 46, 112], "centre_distance": "167 mm"},
    "stated shifts": {**SINGLE, "teeth": [20, 46, 112], "shift": [0.2, 0.1, 0.4]},
    "from the ring": {**SINGLE, "ratio": 1.18, "input": "ring", "satellites": [2, 4]},
    "to the ring": {**SINGLE, "ratio": 0.85, "input": "carrier", "output": "ring", "satellites": [2, 4]},
    "back": {**SINGLE, "ratio": -0.18, "input": "ring", "output": "sun", "satellites": [2, 4]},
}  # fmt: skip
ALL = {**STAGES, **MORE}


@pytest.mark.parametrize("name", ALL)
def test_every_formula_agrees_with_the_second_way(name):
    assert told(solve(given(**ALL[name]))) == []


@pytest.mark.parametrize("name", ["compressor", "drum_motor", "hoist_drive"])
def test_every_formula_of_a_ready_variant(name):
    stages = course.solve(loading.load(VARIANTS / f"{name}.yaml")).drive.stages
    assert [told(one) for one in stages if isinstance(one, Found)] == [[]]


def told(found):
    made = stage(found, "stage1")
    wrong = disagreements(made.s, _ways(found), formed=True)
    for wheel, row in zip(found.scheme.wheels, made.rows, strict=True):
        wrong += disagreements(
            row, {key: 1e3 * found.sizes.diameters[key][wheel] for key in ("d_w", "d_a")}, formed=True
        )
    for row, mesh in enumerate(made.meshes):
        wrong += disagreements(mesh, _of_mesh(found, row), formed=True)
    return wrong


def _ways(found):
    """In the units of the formulas; the ratios by the speeds of the train, Willis' equations solved together."""
    task, given_ = found.given.task, found.given
    one, three, carrier = (given_.member(member) for member in ("wheel1", "wheel3", "carrier"))
    train, held = Train(found.members, found.meshes), given_.member(task.held)
    stopped = speeds(train, {one: 1.0, carrier: 0.0})
    turned = speeds(train, {found.input: 1.0, held: 0.0})
    distances = 1e3 * found.sizes.centre_distance
    ways = {
        "u_basic": 1 / stopped[three], "u": 1 / turned[found.output], "a_w": distances,
        "least_teeth": 2 * task.rack.ha / math.sin(task.rack.alpha) ** 2, "assembly": found.assembly_number,
        "usual_assembly": found.usual_assembly, "force": abs(found.forces[0] / found.torques["wheel1"]),
        "alpha": task.rack.alpha, "ha": task.rack.ha,
    }  # fmt: skip
    return (
        ways
        | dict(zip(("m_I", "m_II"), (1e3 * m for m in task.modules), strict=True))
        | {"m": 1e3 * task.modules[0]}
    )


def _of_mesh(found, row):
    sizes, of, crown = found.sizes, found.rows, row + 1
    angle, base = float(sizes.angles[row]), float(sizes.diameters["d_b"][crown])
    # the working circle of the crown turns with the base circle: d_b = d_w cos α_w
    ways = {"a": 1e3 * sizes.pitch_distances[row], "alpha_w": math.acos(base / float(sizes.working[crown]))}
    profile = found.given.task.rack.alpha
    ways["x_sum"] = of.teeth[row] * (involute.inv(angle) - involute.inv(profile)) / (2 * math.tan(profile))
    central = float(sizes.diameters["d_b"][ROWS[row][0]]) / 2
    cut = 2 * math.hypot(central, of.line[row] + of.start[row])
    return ways | {"rho_l": 1e3 * of.start[row], "d_a_cut": 1e3 * cut, "z_least": of.least[row]}


@pytest.mark.parametrize("name", ALL)
def test_what_stands_beside_the_sheet_agrees_with_what_was_found(name):
    found = solve(given(**ALL[name]))
    made, of = stage(found, "stage1"), book(found, "stage1")
    assert efficiency(made).value == pytest.approx(found.motion.efficiency)
    assert deviation(made).value == pytest.approx(of["stage1_delta_u"].value)
    apart = neighbourhood(made)
    assert apart.holds and apart.left.value - apart.right.value == pytest.approx(1e3 * found.gap)
    assert (coaxiality(made).sign == "=" and coaxiality(made).holds) or found.shifted
    relations = [apart, coaxiality(made), *(ring_tip(made, row) for row in found.rows.rings)]
    assert all(relation.holds for relation in relations[2:])
    sides = [side for relation in relations for side in (relation.left, relation.right)]
    there = [_at(of, side.ref) for side in sides]
    assert [side.value for side in sides] == pytest.approx(there)


def _at(of, ref):
    """The number that a reference finds in the results."""
    if not ref.table:
        return of[ref.key].number(ref.unit)
    return of.tables[ref.table][ref.key].number(ref.row, ref.unit)


def test_columns_are_of_all_rows():
    found = solve(given(**STAGES["external-internal"]))
    table = book(found, "stage1").tables["stage1_rows"]
    assert np.isnan(table["z_least"].values[0]) and table["d_w"].symbol(1).sub == "w2'"
