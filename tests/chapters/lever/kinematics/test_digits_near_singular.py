"""Near singular positions fewer digits remain: as many as are told, and the checks may differ by no more."""

from __future__ import annotations

import re

import numpy as np
import pytest
from typer.testing import CliRunner

from tmm_report.chapters.lever.kinematics.checks.digits_left import COST, PRINTED, digits_left, rounding
from tmm_report.cli import app
from tmm_report.course import doubts, solve
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.note import render
from tmm_report.results import tables

L = np.longdouble
FOUR_BAR = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [0.3, 0]}
  links:
    1: {points: {O: 0, A: 0.1}}
    2: {points: {A: 0, B: 0.3, S2: 0.12}, mass: 1.5, mass_centre: S2, inertia: 0.002}
    3: {points: {C: 0, B: ROCKER, S3: 0.05}, mass: 0.8, mass_centre: S3, inertia: 0.001}
  driver: {link: 1, speed: 10, rotation: counter-clockwise, zero: {angle: ZERO deg}}
  assembly: {B: left of A-C}
loads:
  gravity: 9.81
  moments: [{on: 3, direction: clockwise, constant: 5}]
"""


def stated(beside: float, zero: float = 30.0) -> str:
    return FOUR_BAR.replace("ROCKER", repr(0.1 + beside)).replace("ZERO", str(zero))


def rates(phi, rocker):
    """ω₃ and ε₃ in extended precision, from the closure's derivatives: ω₁ = 10."""
    p, q, d, omega = L(0.3), L(rocker), L(0.3), L(10)
    phi = phi.astype(L)
    A = L(0.1) * (np.cos(phi) + 1j * np.sin(phi))
    AC = d - A
    far = np.abs(AC)
    x = (far**2 + p**2 - q**2) / (2 * far)
    B = A + AC * (x + 1j * np.sqrt((p - x) * (p + x))) / far
    AB, CB = B - A, B - d

    def solved(known):  # x·iAB − y·iCB = known
        area = (np.conj(1j * AB) * (-1j * CB)).imag
        return (np.conj(known) * (-1j * CB)).imag / area, (np.conj(1j * AB) * known).imag / area

    w2, w3 = solved(-1j * omega * A)
    _, e3 = solved(omega**2 * A + w2**2 * AB - w3**2 * CB)
    return w3, e3


@pytest.mark.skipif(np.finfo(L).eps > 1e-18, reason="no extended precision on this machine")
@pytest.mark.parametrize("beside", [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, -1e-9 + 2e-9, 1e-10, 3e-11, 1e-12])
def test_as_many_digits_are_right_as_are_told(beside):
    k = solve(loads(stated(beside))).lever.kinematics
    motion = k.diagram
    label = motion.linkage.groups[0].group.label
    told = 10.0 ** -digits_left(motion.sines[label])
    right = rates(motion.phi, 0.1 + beside)
    for ours, wanted in zip(
        (motion.angular_velocity("3"), motion.angular_acceleration("3")), right, strict=True
    ):
        assert (np.abs(ours - wanted) <= told * np.abs(wanted) + 1e-13 * np.abs(wanted).max()).all()


def test_far_from_singular_positions_nearly_all_digits_remain():
    assert digits_left(np.array([1.0, 0.5, 1e-3, 0.0])).tolist() == [14, 14, 8, 0]
    found = solve(loads(stated(0.15))).lever
    assert found.kinematics.near == () and found.kinetostatics.agrees and not found.kinetostatics.strained
    assert rounding(found.kinematics.table).max() < 100 * COST


@pytest.mark.parametrize("beside", [1e-8, 1e-9, 7e-10])
def test_a_position_near_a_change_point_is_named_with_its_digits(beside):
    found = solve(loads(stated(beside)))
    lever = found.lever
    (near,) = lever.kinematics.near
    assert near.positions == (5, 11) and near.digits >= PRINTED
    assert np.degrees(near.turned) == pytest.approx([150, 330])
    assert lever.kinetostatics.agrees and lever.kinetostatics.strained
    (doubt,) = doubts(found)
    assert "positions 5, 11" in doubt.text() and f"{near.digits} digits remain" in doubt.text()
    (table,) = (table for table in tables(found) if table.name == "positions_table")
    (digits,) = (column.values for column in table.columns if column.key.startswith("digits_"))
    assert min(digits[5], digits[11]) == near.digits and digits[2] > 12


@pytest.mark.parametrize("zero, positions", [(35, False), (30, True)])
def test_positions_of_the_diagram_alone_are_told_by_their_angles(zero, positions):
    """From 35° the diagrams, not the table, come within 5° of 180°: none is near; from 30° both have it."""
    k = solve(
        loads(stated(1e-9, zero).replace("loads:", "positions: {diagram: 36}\nloads:"))
    ).lever.kinematics
    assert bool(k.near) == positions
    k = solve(loads(stated(1e-9, 35).replace("loads:", "positions: {diagram: 72}\nloads:"))).lever.kinematics
    (near,) = k.near
    assert near.positions == () and "positions" not in str(near.text) and "145.00°, 325.00°" in str(near.text)


def test_where_fewer_digits_remain_than_are_printed_the_solution_fails(tmp_path):
    bad, good = tmp_path / "bad.yaml", tmp_path / "good.yaml"
    bad.write_text(stated(1e-11), "utf-8")
    good.write_text(stated(1e-9), "utf-8")
    runs = [
        CliRunner().invoke(app, ["solve", str(path), "-o", str(tmp_path / "note"), "--format", "json"])
        for path in (bad, good)
    ]
    assert [run.exit_code for run in runs] == [1, 0]
    assert "4 digits remain" in runs[0].output and "disagree by more than 1e-9" in runs[0].output
    assert "6 digits remain" in runs[1].output and "no more than rounding does" in runs[1].output


@pytest.mark.exhaustive
@pytest.mark.parametrize("beside, first", [(1e-9, False), (1e-11, True)])
def test_the_note_says_it_in_its_conclusions(beside, first):
    html = render(solve(loads(stated(beside))), "html", Translator("en"))["note.html"].decode()
    text = re.sub(r"<[^>]+>", "", re.sub(r"<(svg|style)\b.*?</\1>", "", html, flags=re.S))
    conclusions = text[text.rindex("Conclusions") :].split("\n", 1)[1].strip()
    told = "Near a singular position: at the angle of rotation φ = 150.00°, 330.00° (positions 5, 11)"
    assert told in conclusions and conclusions.startswith(told) == first
    assert text[text.rindex("Introduction") :].split("\n", 1)[1].strip().startswith(told) == first
