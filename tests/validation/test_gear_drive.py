"""The published two-stage gear drive: every printed number of its spur pair 4-5, to its printed digits.

Source: a coursework guide's own example (see gear_drive_printed.yaml). Numbers are compared as text: the program's
value, rounded half up to the printed decimals, must be the printed number. No cell needs a tolerance. All wrong cells
are reported together.

ERRATA, beside those in the file, each checked below:
- the active part of the line of action: the guide prints AB = 23.676 mm, and from its own radii of curvature 28.403 +
  49.066 − 53.676 it is 23.793 mm, which its contact ratio 23.793 : 17.713 = 1.3432 and its AC = 6.080 mm need too;
- x4 = (17 − z4)/17 "excludes undercut" by the guide; the exact limit is 0.1812, so the tooth is undercut by a trace.
"""

import math
from collections.abc import Iterator
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

import numpy as np
import pytest
import yaml

from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.mechanics.gears.involute import inv

# every scalar stays text, so that 97.250 keeps its last zero
PRINTED = yaml.load(Path(__file__).with_name("gear_drive_printed.yaml").read_text("utf-8"), yaml.BaseLoader)
INPUT, SPUR = PRINTED["input"], PRINTED["spur"]

Cell = tuple[str, float, str]  # where, the program's value, the printed text
ERRATA = {"AB": "23.793"}


@pytest.fixture(scope="module")
def found() -> spur.Found:
    return spur.solve(
        spur.Given(
            ratio=float(INPUT["u45"]),
            module=1e-3 * float(INPUT["m_spur"]),
            centre_distance=1e-3 * float(INPUT["a_w"]),
            rack=spur.Rack(
                math.radians(float(INPUT["alpha_deg"])), float(INPUT["ha_star"]), float(INPUT["c_star"])
            ),
            wheels=("4", "5"),
        )
    )


def rounded(value: float, text: str) -> Decimal:
    """`value` rounded half up to as many decimals as the printed text has."""
    step = Decimal(1).scaleb(Decimal(text).as_tuple().exponent)
    return Decimal(f"{value:.12g}").quantize(step, ROUND_HALF_UP)


def teeth_cells(found: spur.Found) -> Iterator[Cell]:
    yield "z_sum_bound", found.teeth.choice.bound, SPUR["z_sum_bound"]
    for i, wheel in enumerate("45"):
        yield f"z{wheel}", found.teeth.z[i], SPUR[f"z{wheel}"]
        yield f"x{wheel}", (found.pair.x1, found.pair.x2)[i], SPUR[f"x{wheel}"]
        yield f"pitch angle {wheel}", 360 / found.teeth.z[i], SPUR["tooth_pitch_angle_deg"][i]


def angle_cells(found: spur.Found) -> Iterator[Cell]:
    alpha_w = found.pair.alpha_w
    yield "alpha_w rad", alpha_w, SPUR["alpha_w_rad"]
    yield "alpha_w deg", np.degrees(alpha_w), SPUR["alpha_w_deg"]
    yield "inv alpha_w", inv(alpha_w), SPUR["inv_alpha_w"]
    yield "inv alpha", inv(found.pair.rack.alpha), SPUR["inv_alpha"]
    yield "x_sum", found.pair.x_sum, SPUR["x_sum"]
    yield "fillet", found.pair.rack.fillet, SPUR["fillet_radius"].split()[0]


def dimension_cells(found: spur.Found) -> Iterator[Cell]:
    pair = found.pair
    yield "pitch", 1e3 * pair.p, SPUR["pitch"]
    yield "base pitch", 1e3 * pair.p_b, SPUR["base_pitch"]
    lengths = ("d", "d_b", "d_w", "d_f", "d_a", "s", "s_b", "s_a", "s_w", "rho_a", "rho_p")
    for key in lengths:
        for i, wheel in enumerate("45"):
            yield f"{key} {wheel}", 1e3 * getattr(pair, key)[i], SPUR[key][i]
    for i, wheel in enumerate("45"):
        yield f"alpha_a {wheel}", pair.alpha_a[i], SPUR["alpha_a_rad"][i]


def mesh_cells(found: spur.Found) -> Iterator[Cell]:
    pair, zones, at = found.pair, SPUR["zones"], found.path.points
    yield "N1N2", 1e3 * pair.line, SPUR["N1N2"]
    yield "contact ratio", pair.eps, SPUR["contact_ratio"]
    yield "two pairs", 100 * pair.two_pairs, SPUR["two_pair_share_percent"]
    yield "AB", 1e3 * (at["B"] - at["A"]), zones["AB"]
    yield "BC", 1e3 * (at["B"] - at["C"]), zones["BC_and_AD"]
    yield "AD", 1e3 * (at["D"] - at["A"]), zones["BC_and_AD"]
    yield "AC", 1e3 * (at["C"] - at["A"]), zones["AC_and_BD"]
    yield "BD", 1e3 * (at["B"] - at["D"]), zones["AC_and_BD"]
    printed = SPUR["specific_sliding"]
    for i, wheel in enumerate("45"):
        yield f"sliding tip {wheel}", pair.tip_sliding[i], printed[f"tip{wheel}"]
        yield f"sliding root {wheel}", pair.root_sliding[i], printed[f"root{wheel}"]


def wrong(cells: Iterator[Cell], known: dict[str, str]) -> list[str]:
    """The cells that differ from the print; `known` errata must differ just so."""
    found, seen = [], set()
    for where, value, text in cells:
        seen.add(where)
        expected = known.get(where, text)
        if rounded(float(value), expected) != Decimal(expected):
            found.append(f"{where}: {value:.8g}, printed {text}")
    return found + [f"{where}: not compared" for where in known.keys() - seen]


@pytest.mark.parametrize(
    "cells, known",
    [(teeth_cells, {}), (angle_cells, {}), (dimension_cells, {}), (mesh_cells, ERRATA)],
    ids=lambda part: getattr(part, "__name__", ""),
)
def test_every_printed_number(found, cells, known):
    assert wrong(cells(found), known) == []


def test_the_erratum_is_one():
    """The printed AB contradicts the printed radii of curvature, pitch and contact ratio; ours agrees with them."""
    from_radii = sum(map(float, SPUR["rho_a"])) - float(SPUR["N1N2"])
    assert from_radii == pytest.approx(float(ERRATA["AB"]), abs=1e-9)
    assert float(SPUR["zones"]["AB"]) != pytest.approx(from_radii, abs=0.1)
    assert from_radii / float(SPUR["base_pitch"]) == pytest.approx(float(SPUR["contact_ratio"]), abs=1e-4)


def test_undercut_by_the_rule_and_exactly(found):
    """0.17647 by the rule, 0.18116 exactly: wheel 4 alone misses its condition, by 0.00469."""
    assert found.rule_shifts[0] == pytest.approx(3 / 17)
    assert found.pair.x_min[0] == pytest.approx(0.18116, abs=5e-6)
    (missed,) = found.failed
    assert (missed.key, missed.wheel) == ("undercut", "4")
    assert missed.margin == pytest.approx(3 / 17 - 0.18115555, abs=1e-8)
    assert 0 < found.starts[0] < 0.05e-3 < found.pair.rho_p[0]


def test_the_limits_of_the_guide_are_met(found):
    """s_a ≥ 0.3 m = 1.8 mm, contact ratio ≥ 1.05."""
    limits = {(c.key, c.wheel): c for c in found.conditions}
    assert limits["pointing", "4"].limit == pytest.approx(1.8e-3)
    assert limits["contact", ""].limit == 1.05
    assert limits["contact", ""].margin == pytest.approx(0.29325, abs=1e-5)
