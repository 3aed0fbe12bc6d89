"""The guide's gear drive as a whole: planetary stage 1-2-3-H, then the pair 4-5; every printed number of it.

The scales mu_v = 0.2 and mu_omega = 2.5 are the round ones; the segments 128 and 9.697 mm belong to a plan drawn so
that the first is 128 mm.
"""

from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

import numpy as np
import pytest
import yaml

from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.block import DriveModel, build

PRINTED = yaml.load(Path(__file__).with_name("gear_drive_printed.yaml").read_text("utf-8"), yaml.BaseLoader)
GIVEN, WHOLE, SPEEDS = PRINTED["input"], PRINTED["planetary"], PRINTED["speeds"]


def solve(accuracy=1e-5, **more):
    stages = [
        {
            "kind": "planetary",
            "scheme": "sun-ring",
            "ratio": GIVEN["u13H_stage_planetary"],
            "module": GIVEN["m_planetary"] + " mm",
            "satellites": WHOLE["satellites"],
            "teeth": WHOLE["z"],
            "input": "sun",
            "output": "carrier",
            "fixed": "ring",
            "efficiency": GIVEN["eta_H"],
        },
        {
            "kind": "spur",
            "ratio": GIVEN["u45"],
            "module": GIVEN["m_spur"] + " mm",
            "centre_distance": GIVEN["a_w"] + " mm",
        },
    ]
    speed = GIVEN["input_speed_rpm"] + " rpm"
    return drive.solve(build(DriveModel.model_validate({"speed": speed, "stages": stages, **more}), accuracy))


@pytest.fixture(scope="module")
def found():
    return solve()


def rounded(value: float, text: str) -> Decimal:
    """`value` rounded half up to as many decimals as the printed text has."""
    step = Decimal(1).scaleb(Decimal(text).as_tuple().exponent)
    return Decimal(f"{value:.12g}").quantize(step, ROUND_HALF_UP)


def test_every_printed_number_of_the_whole_drive(found):
    plans = found.plans
    cells = {
        "u15": (found.ratio, WHOLE["u15"]),
        "u15 designed": (found.wanted, "-13.12"),
        "u1H": (found.stages[0].ratio, WHOLE["u_1H"]),
        "efficiency of the planetary stage": (found.stages[0].efficiency, WHOLE["efficiency"]),
        "omega1": (found.speed["1"], SPEEDS["omega1"]),
        "velocity of the pitch point": (found.speed["1"] * plans.spots[0].y, SPEEDS["v_pitch_point"]),
        "mu_v": (plans.velocity_scale, SPEEDS["mu_v"]),
        "mu_omega": (plans.angular_scale, SPEEDS["mu_omega"]),
    }
    wrong = {where: cell for where, cell in cells.items() if rounded(*cell) != Decimal(cell[1])}
    assert not wrong


def test_the_segments_of_the_graphical_ratio():
    """Drawn so that the segment of wheel 1 is 128 mm and read to 0.001 mm, as the guide's."""
    first, last = PRINTED["graph_checks"]["u15_segments"]
    plans = solve(accuracy=1e-6, scales={"angular": 100 * np.pi / float(first)}).plans
    assert [rounded(abs(plans.segment(name)), text) for name, text in (("1", first), ("5", last))] == [
        Decimal(first),
        Decimal(last),
    ]
    assert rounded(plans.ratio("1", "5"), WHOLE["u15"]) == Decimal(WHOLE["u15"])


def test_the_ratio_is_within_the_allowed_deviation(found):
    assert 0.01 <= found.given.tolerance <= 0.04  # the guide: 1..4 %
    assert found.deviation == pytest.approx(0.08 / 13.12, rel=1e-9) and found.within
