"""The guide's planetary stage 1-2-3-H: every printed number of it, from its teeth and from the search."""

from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

import numpy as np
import pytest
import yaml

from tmm_report.chapters.gears.planetary.block import PlanetaryModel, build
from tmm_report.chapters.gears.planetary.solve.stage import solve
from tmm_report.mechanics.gears import trains
from tmm_report.mechanics.gears.planetary import stage as p

PRINTED = yaml.load(Path(__file__).with_name("gear_drive_printed.yaml").read_text("utf-8"), yaml.BaseLoader)
GIVEN, STAGE = PRINTED["input"], PRINTED["planetary"]


def stage(**more):
    block = {
        "kind": "planetary",
        "ratio": GIVEN["u13H_stage_planetary"],
        "module": GIVEN["m_planetary"] + " mm",
        "satellites": STAGE["satellites"],
        "input": "sun",
        "output": "carrier",
        "fixed": "ring",
        "efficiency": GIVEN["eta_H"],
        **more,
    }
    return solve(build(PlanetaryModel.model_validate(block), ("1", "2", "3", "H")))


@pytest.fixture(scope="module")
def found():
    return stage(teeth=STAGE["z"])


def rounded(value: float, text: str) -> Decimal:
    """`value` rounded half up to as many decimals as the printed text has."""
    step = Decimal(1).scaleb(Decimal(text).as_tuple().exponent)
    return Decimal(f"{value:.12g}").quantize(step, ROUND_HALF_UP)


def test_every_printed_number_of_the_stage(found):
    s, k = found.sizes, found.satellites
    room, d_w = STAGE["neighbourhood"], STAGE["d_w"]
    cells = {
        "u_1H": (found.ratio, STAGE["u_1H"]),
        "d_w1": (1e3 * s.working[0], d_w[0]),
        "d_w2": (1e3 * s.working[1], d_w[1]),
        "d_w3": (1e3 * s.working[3], d_w[2]),
        "2 a_w": (2e3 * float(s.centre_distance), room["two_a_w"]),
        "chord": (2e3 * float(s.centre_distance) * np.sin(np.pi / k), room["chord"]),
        "d_a2": (1e3 * s.tip[1], room["tip_diameter_satellite"]),
        "C": (found.assembly_number, STAGE["assembly"]["c"]),
        "eta": (found.efficiency, STAGE["efficiency"]),
    }
    wrong = {
        name: cell for name, cell in cells.items() if rounded(float(cell[0]), cell[1]) != Decimal(cell[1])
    }
    assert not wrong
    assert p.teeth_sums(found.scheme, np.array(found.teeth)).tolist() == [66, 66]
    assert STAGE["coaxiality"].endswith("66 = 66")


def test_the_guides_teeth_are_among_the_solutions(found):
    z = found.candidates.teeth[:, found.ranking[found.chosen]]
    assert [int(z[i]) for i in (0, 1, 3)] == [int(teeth) for teeth in STAGE["z"]]
    free = stage()
    assert abs(free.deviation) <= 0.04 and free.sizes.overall <= found.sizes.overall


def test_efficiency_by_the_general_flow_of_power(found):
    train = trains.Train(found.members, found.meshes)
    speed = trains.speeds(train, {"1": 1.0, "3": 0.0})
    loads = trains.loads(train, speed, {"1": 1.0}, ("3", "H"))
    assert float(loads.efficiency) == pytest.approx(found.efficiency, rel=1e-12)
    assert float(loads.torque["3"]) == pytest.approx(found.torques["wheel3"], rel=1e-12)
