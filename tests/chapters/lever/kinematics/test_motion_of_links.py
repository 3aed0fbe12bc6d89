"""Motion of driven links and analogues: printed references, differences, limits of assembly, working strokes."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from conftest import read, solved
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.lever.initial_data import quantities as given
from tmm_report.chapters.lever.kinematics import quantities as q
from tmm_report.chapters.lever.kinematics.solve import analogues
from tmm_report.chapters.lever.kinematics.solve import positions as kinematics
from tmm_report.chapters.lever.kinematics.solve.strokes import bounded
from tmm_report.chapters.lever.kinematics.solve.working_stroke import working_of, working_strokes
from tmm_report.chapters.lever.structure import solve as structure
from tmm_report.quantity.model import Book

JAM = """
language: en
mechanism:
  frame: {O: [0, 0], C: [4200 mm, 0]}
  links:
    1: {points: {O: 0, A: 3000 mm}}
    2: {points: {A: 0, B: 1000 mm}}
    3: {points: {C: 0, B: 2000 mm}}
  driver: {link: 1, speed: 10 rad/s, rotation: counter-clockwise, zero: {angle: 0 deg}}
  assembly: {B: left of A-C}
allow_partial: ALLOWED
"""


def moved(variant: course.Variant, omega: float | None = None) -> kinematics.Kinematics:
    mechanism = variant.lever.mechanism
    if omega is not None:
        mechanism = replace(mechanism, driver=replace(mechanism.driver, omega=omega))
    return kinematics.solve(variant.lever.positions, structure.solve(mechanism))


def test_the_rods_of_the_compressor_as_the_guide_prints_them():
    """Greatest ω2 41.888, ε2 5583.1, ω4 30.403, ε4 3937.5 (rad/s, rad/s²), at dead centres and at 90° from them."""
    values = Book.of((), q.values(solved("compressor").lever.kinematics)).values
    for key, size in (("V_2", 41.888), ("A_2", 5583.1), ("V_4", 30.403), ("A_4", 3937.5)):
        low, high = values[f"{key}_min"], values[f"{key}_max"]
        assert (-low.value, high.value) == (pytest.approx(size, rel=2e-5), pytest.approx(size, rel=2e-5))
        step = 180 if key[0] == "V" else 90
        assert math.degrees(high.at) % step == pytest.approx(0, abs=1e-6)


def test_analogues_of_the_press_as_the_thesis_prints_them():
    """φ1 = 90°, 91°, 92°: w3 0.2162162162, 0.2161848246, 0.2160906553; v5 0, 0.0005471784528, 0.001094321675."""
    lever = read("press").lever
    found = replace(lever, positions=replace(lever.positions, table=360))
    motion = kinematics.solve(found.positions, structure.solve(found.mechanism))
    table = {c.key: np.asarray(c.values) for c in next(iter(analogues.tables(motion))).columns}
    start = round(90 - math.degrees(motion.cycle.zero)) % 360
    assert np.abs(table["dpsi_3"][[start, start + 1, start + 2]]) == pytest.approx(
        [0.2162162162, 0.2161848246, 0.2160906553], abs=5e-11
    )
    slider = next(key for key in table if key.startswith("dS_"))
    assert np.abs(table[slider][[start, start + 1, start + 2]]) == pytest.approx(
        [0.0, 0.0005471784528, 0.001094321675], abs=5e-11
    )


@pytest.mark.parametrize("name", ["shaper", "v_engine", "loom", "scotch_yoke"])
def test_analogues_are_differences_of_the_displacements(name):
    found = moved(read(name))
    step = 1e-4
    for travel in analogues.moving(found):
        here, ahead, behind = (
            travel.output.rates(found.cycle.motion(found.turned + h))[0] for h in (0.0, step, -step)
        )
        slope = np.angle(np.exp(1j * (ahead - behind))) if travel.output.kind == "rocker" else ahead - behind
        first = travel.V / abs(found.omega)
        size = np.max(np.abs(first)) + 1e-12
        assert np.max(np.abs(slope / (2 * step) - first)) < 1e-5 * size
        assert len(here) == len(first)


def test_analogues_are_the_rates_at_unit_speed_and_do_not_know_the_sense_of_time():
    fast, slow = moved(read("whitworth")), moved(read("whitworth"), omega=1.0)
    one, other = (
        {c.key: np.asarray(c.values) for c in next(iter(analogues.tables(x))).columns} for x in (fast, slow)
    )
    assert one["t"][-1] == pytest.approx(2 * math.pi / abs(fast.omega))
    for key in one:
        if key.startswith("d"):
            assert np.allclose(one[key], other[key], atol=1e-12)
    for travel in slow.travels:
        assert np.allclose(travel.V, other[analogues.analogues_of(travel.output)[0].key])


def test_a_link_that_turns_round_is_counted_on():
    found = moved(read("conveyor"))
    turned = next(travel for travel in (*found.travels, *found.links) if travel.output.name == "3")
    assert abs(turned.diagram_S[-1]) == pytest.approx(2 * math.pi)
    assert np.max(np.abs(np.diff(turned.diagram_S))) < 1


def test_a_link_in_translation_has_no_motion_of_its_own():
    found = moved(read("press"))
    assert [travel.output.name for travel in found.links] == ["3", "4"]


@pytest.mark.parametrize("allowed", ["true", "false"])
def test_towards_a_limit_rates_grow_without_bound_and_are_no_extremes(allowed):
    results = course.solve(loading.loads(JAM.replace("ALLOWED", allowed)))
    found = results.lever.kinematics
    for travel in (*found.travels, *found.links):
        for ends in (travel.V_extremes, travel.a_extremes):
            assert any(math.isnan(end.value) and math.isnan(end.turned) for end in ends)
        assert math.isfinite(travel.near.value) and math.isfinite(travel.far.value)
    note = render(results, "html")["note.html"].decode()
    concluded = note[note.rindex("Conclusions</h1>") :]
    assert (
        "Towards the limit position the angular velocity" in concluded and "grow without bound" in concluded
    )
    assert concluded.index("do not meet") < concluded.index("swing of link")
    assert ("must be checked" in concluded) == (allowed == "false")


def test_a_bounded_rate_of_a_mechanism_with_limits_keeps_its_extremes():
    """The driving link's own points go round evenly whatever the group beyond them does."""
    found = course.solve(loading.loads(JAM.replace("ALLOWED", "true"))).lever.kinematics
    limits = found.cycle.limits
    assert len(limits) == 2
    low, high = found.cycle.extremes(lambda m: m.velocity("A").real, lambda m: m.acceleration("A").real)
    assert -30 - 1e-9 <= low.value < high.value <= 30 + 1e-9
    assert bounded(found.cycle, lambda m: m.velocity("A").real, (low, high)) == (low, high)


def test_the_working_stroke_is_that_of_the_load_or_the_longer_one():
    strokes = working_of(solved("shaper").lever)
    cutting = strokes["D"]
    assert cutting.by == "load" and strokes["3"].by == "longer"
    assert math.degrees(cutting.last - cutting.first) == pytest.approx(
        360 * strokes_ratio(solved("shaper")) / (1 + strokes_ratio(solved("shaper")))
    )
    assert cutting.positions[0] == 0 and cutting.positions == tuple(range(len(cutting.positions)))


def strokes_ratio(results: course.Results) -> float:
    return next(t for t in results.lever.kinematics.travels if t.output.name == "D").time_ratio


def test_the_load_decides_against_the_longer_stroke():
    found = moved(read("shaper"))
    travel = next(t for t in found.travels if t.output.name == "D")
    push = {travel.output.link: -np.where(travel.diagram_V < 0, 1.0, 0.0)}
    against = working_strokes(found, push)["D"]
    assert against.by == "load" and against.ends == ("max", "min")
    assert working_strokes(found, {})["D"].ends == ("min", "max")
    assert working_strokes(found, {travel.output.link: 0 * travel.diagram_V})["D"].by == "longer"


def test_the_period_and_the_drawn_lengths_are_written_out():
    lever = solved("compressor").lever
    values = {value.key: value for value in given.values(lever)}
    assert abs(values["omega"].value) == pytest.approx(2 * math.pi / values["T_turn"].value)
    scale = values["mu_l"].value
    for ends, metres in given.segments(lever.given.mechanism):
        assert values[f"drawn_{ends}"].value * scale == pytest.approx(metres)
    assert not any(value.key == "T_turn" for value in given.values(solved("shaper").lever))
