"""Printed numbers of cams: peaks of laws, a tangent cam, constants of the modified trapezoid, a course project's table.

ERRATA (see cam_printed.yaml): Sarkar's ill. 5 as worked by its companion prints cm/s² as m/s²; the worked answer of a
GATE question puts the whole lift into half the phase; a course project's velocities and accelerations are half of what
its displacements say, and its cam is not convex. Companions count with π = 3.141 and round up: a unit of the last
digit.
"""

import math
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
import yaml

from tmm_report.mechanics.cams.arcs import ArcLaw, Outline, Slider
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases
from tmm_report.mechanics.cams.shapes import modified_trapezoid, named
from tmm_report.mechanics.cams.sizes.least_face import under_face

FILE = Path(__file__).with_name("cam_printed.yaml")
RECORDS = {one["id"]: one for one in yaml.safe_load(FILE.read_text(encoding="utf-8"))}
LAWS = {"cosine": "cosine", "constant_acceleration": "parabolic"}
FINE = np.linspace(0, FULL_TURN, 7201)


def unit(text):
    """Of the last printed digit."""
    return 10.0 ** Decimal(text).as_tuple().exponent


def agrees(ours, text, units=1.0):
    return abs(ours - float(text)) <= units * unit(text)


def peaks(given):
    """Greatest velocities and accelerations of rise and return, m/s, m/s²."""
    shape, w = named(LAWS[given["law"]]), given["rpm"] * math.pi / 30
    rise, back = (Phase(way, math.radians(given[f"{way}_deg"]), shape) for way in ("rise", "return"))
    rest = Phase("dwell", (FULL_TURN - rise.angle - back.angle) / 2)
    law = Phases((rise, rest, back, rest), given["h_mm"] / 1e3)
    _, first, second = law.of(FINE)
    up = first > 1e-12
    down = first < -1e-12
    return {
        "v_rise_m_s": w * first.max(), "v_return_m_s": -w * first.min(),
        "a_rise_m_s2": w**2 * np.abs(second[up]).max(), "a_return_m_s2": w**2 * np.abs(second[down]).max(),
    }  # fmt: skip


def tangent(given):
    """The start of the lift of a tangent cam; nose and distance have no part in it."""
    r1, w = given["r1_mm"] / 1e3, given["rpm"] * math.pi / 30
    law = ArcLaw(Outline(r1, 0.4 * r1, 1.2 * r1), Slider(0.0, given["rr_mm"] / 1e3))
    return {"a_start_m_s2": w**2 * float(law.of(np.array(0.0))[2])}


def constants(_):
    """f = c1 t − c2 sin 4πt; c3 t² − c4 t + c5; c6 t − c2 sin(4πt − π) − c7; −c3 t² + c8 t − c9; c10 + c1 t + …"""
    shape = modified_trapezoid()
    (f1, d1, _), (f2, d2, b2), (_, d3, _), (f4, d4, _), (f5, _, _) = (
        shape.of(np.array(t)) for t in (1 / 16, 1 / 4, 3 / 8, 1 / 2, 3 / 4)
    )
    c1 = float(shape.of(np.array(1 / 8))[1])
    c2, c3, c6 = (c1 / 16 - f1) / math.sin(math.pi / 4), b2 / 2, d3
    c4 = 2 * c3 / 4 - d2
    _, slope, _ = shape.of(np.array(3 / 4))
    c8 = slope + 1.5 * c3
    assert d1 == pytest.approx(c1 - 4 * math.pi * c2 * math.cos(math.pi / 4))
    assert d4 == pytest.approx(c6 + 4 * math.pi * c2 * math.cos(0))
    found = [c1, c2, c3, c4, f2 - c3 / 16 + c4 / 4, c6, c6 / 2 - f4, c8, c8 * 0.75 - c3 * 0.5625 - f5, 1 - c1]
    return {f"c{k}": float(c) for k, c in enumerate(found, 1)}


def factors(_):
    def greatest(name):
        _, slope, bend = named(name).of(np.linspace(0, 1, 100001))
        return float(slope.max()), float(bend.max())

    return {
        "mod_trap_a": greatest("modified_trapezoid")[1], "cycloid_a": greatest("sine")[1],
        "cosine_a": greatest("cosine")[1], "p345_v": greatest("polynomial")[0],
        "p345_a": greatest("polynomial")[1],
    }  # fmt: skip


def pump(given):
    """How far a return is down at angles of it, its derivatives; the base circle that its convexity asks."""
    angle, shape = math.radians(given["phase_deg"]), named("parabolic")
    law = Phases(
        (Phase("rise", FULL_TURN - angle, named("sine")), Phase("return", angle, shape)), given["h_m"]
    )
    at = np.radians(given["angles_deg"]) + FULL_TURN - angle
    at[-1] -= 1e-7  # the table's last row is the end of the phase
    S, first, second = law.of(at)
    down = given["h_m"] - S
    need = under_face(law, 0.0).asked.b
    return {
        "s1": down[0], "s2": down[1], "s3": down[2], "ds1": -first[0], "ds2": -first[1], "dds": -second[0],
        "r0_convex_m": need,
    }  # fmt: skip


KINDS = {
    "law_peaks": peaks, "tangent_cam_start": tangent, "modified_trapezoid_constants": constants,
    "peak_factors": factors, "const_acc_table": pump,
}  # fmt: skip


@pytest.mark.parametrize("record", RECORDS.values(), ids=RECORDS)
def test_record(record):
    ours = KINDS[record["kind"]](record["inputs"])
    wrong = {
        key: text
        for key, text in record["printed"].items()
        if not agrees(ours[key], text, record.get("tol_units", 1.0))
    }
    if record["expect"] == "match":
        assert not wrong
    else:
        assert wrong  # the print is wrong, and not all of ours is what it says
    for key, text in record["recomputed"].items():
        assert ours[key] == pytest.approx(float(text), rel=1e-5, abs=1e-9), key
