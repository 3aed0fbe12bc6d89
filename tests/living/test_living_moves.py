"""Gears and cams that move: wheels roll upon one another without sliding, teeth do not cut into one another, and the
cam stays under its follower."""

from __future__ import annotations

import base64
import cmath
import math
from functools import cache
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import solved
from test_living_data import data, page
from test_living_page import opened, run

from tmm_report.chapters.gears.drive.draw.sketch import CLEAR
from tmm_report.chapters.gears.eccentric.draw.assembled import assembled
from tmm_report.chapters.gears.eccentric.draw.path import path_drawing
from tmm_report.chapters.gears.eccentric.solve.paper import path_scale
from tmm_report.chapters.gears.train.draw.scheme import scheme
from tmm_report.course import Results
from tmm_report.figures.drawing import Drawing, Moving
from tmm_report.living.moves import moved
from tmm_report.results import tables


def moves(name: str) -> dict[str, Any]:
    return data(name)["moves"]


def meshes(name: str) -> list[dict[str, Any]]:
    return [one for one in moves(name).values() if all("pitch" in part for part in one["parts"])]


@pytest.mark.parametrize("name", ["hoist_drive", "compressor", "shaper_project"])
def test_a_pair_in_mesh_rolls_tooth_by_tooth(name):
    """Pitches go by as fast on one wheel as on the other, in opposite senses where both have their teeth outside."""
    assert meshes(name)
    for mesh in meshes(name):
        one, other = mesh["parts"]
        assert one["rate"] / one["pitch"] == pytest.approx(-other["rate"] / other["pitch"], rel=1e-9)
        apart = math.dist(one["centre"], other["centre"])
        assert apart * other["pitch"] / (one["pitch"] + other["pitch"]) == pytest.approx(
            math.hypot(*one["centre"]), rel=1e-3
        )


@pytest.mark.parametrize("name", ["hoist_drive", "compressor"])
def test_a_planetary_stage_rolls_without_sliding(name):
    """Where a satellite touches a central wheel both have one velocity: from the radii that are drawn."""
    anchor, stage = next(
        (anchor, one) for anchor, one in moves(name).items() if any("about" in part for part in one["parts"])
    )
    shapes = figure(name, anchor)
    by_radius = [(part, drawn_radius(part, shapes)) for part in stage["parts"] if "pitch" not in part]
    satellites = [(part, r) for part, r in by_radius if "about" in part]
    central = [(part, r) for part, r in by_radius if "about" not in part and r is not None]
    checked = 0
    for part, radius in satellites:
        arm = math.hypot(*part["centre"])
        for wheel, own in central:
            outside = abs(arm - radius - own) < 0.02 * arm
            inside = abs(arm + radius - own) < 0.02 * arm
            if radius and (outside or inside):
                reach = arm + (radius if inside else -radius)
                point = part["about"] * arm + part["rate"] * (reach - arm)
                assert point == pytest.approx(wheel["rate"] * reach, rel=2e-2, abs=2e-3), (
                    part["rate"],
                    wheel["rate"],
                )
                checked += 1
    assert checked >= 4


def figure(name: str, anchor: str) -> ElementTree.Element:
    """The elements of a figure of the note."""
    text = page(name)
    begins = text.index("<svg", text.index(f'id="{anchor}"'))
    drawn = ElementTree.fromstring(text[begins : text.index("</svg>", begins) + 6]).find("{*}g")
    assert drawn is not None
    return drawn


def drawn_radius(part: dict[str, Any], shapes: ElementTree.Element) -> float | None:
    """Of the working circle, which has dots and dashes, among the note's own shapes; None of a part without one."""
    circles = [s for k in part.get("same", ()) if (s := shapes[k]).tag.endswith("circle")]
    if "about" in part:
        centres = [(float(c.attrib["cx"]), -float(c.attrib["cy"])) for c in circles]
        assert centres and all(math.dist(one, part["centre"]) < 0.01 for one in centres)
    return next((float(c.attrib["r"]) for c in circles if "stroke-dasharray" in c.attrib), None)


def marks(name: str) -> list[dict[str, Any]]:
    return [part for one in moves(name).values() for part in one["parts"] if "rise" in part]


@pytest.mark.parametrize("name", ["hoist_drive", "conveyor_drive"])
def test_marks_of_wheels_from_the_side_pass_one_another_as_fast(name):
    """Those of two wheels in mesh, at their pitch lines; each wheel has a mark in front of its axis and one behind."""
    speeds = next(t for t in tables(solved(name)) if t.name == "drive_speeds")
    omega = dict(zip(map(str, speeds["member"].values), speeds["omega"].numbers(), strict=True))
    largest = max(map(abs, omega.values()))
    found: dict[float, list[complex]] = {}
    for part in marks(name):
        found.setdefault(round(part["rate"], 9), []).append(complex(*part["rise"]))
    assert all(sum(rises) == 0 for rises in found.values())
    pair = next(
        stage for stage in solved(name).drive.stages if type(stage).__module__.endswith("spur.solve.pair")
    )
    ones = [omega[member] / largest for member in (pair.input, pair.output)]
    fast = [rate * min(abs(r) + CLEAR for r in found[round(rate, 9)]) for rate in ones]
    assert any(
        rate * (abs(r) + CLEAR) == pytest.approx(-other * (abs(q) + CLEAR), rel=2e-3)
        for rate, other in [ones]
        for r in found[round(rate, 9)]
        for q in found[round(other, 9)]
    ), fast


def turning(drawing: Drawing, results: Results) -> list[tuple[Moving, dict[str, Any]]]:
    """The parts of a picture, and what the script is told of each."""
    assert drawing.moves is not None
    return list(zip(drawing.moves.parts, moved({"figure": drawing}, results)["figure"]["parts"], strict=True))


TRAINS = ["drum_closed_differential", "reducer_3k", "reversing_train_with_idlers", "steering_two_inputs"]
TRAINS += ["two_suns_compound_planet", "car_differential_on_a_curve"]


@pytest.mark.parametrize("name", TRAINS)
def test_every_member_of_a_train_shows_how_it_turns(name):
    """As fast as its table has it, of a satellite across its carrier's axis about that; one mark is in sight at any
    time, of a wheel with parallel axes at its rim."""
    results = solved(f"statements/{name}")
    speeds, train = next(t for t in tables(results) if t.name == "train_speeds"), results.train
    parts, checked = turning(scheme(train), results), 0
    omega = {}
    for k, member in enumerate(map(str, speeds["member"].values)):
        key = "omega_rel" if train.built.tilted(member) else "omega"
        omega[member] = float(speeds[key].numbers()[k])
    largest = max(map(abs, omega.values()))
    for member in (member for member in omega if omega[member]):
        own = [told for part, told in parts if part.of == member]
        (rate,) = {told["rate"] * largest for told in own}
        assert abs(rate) == pytest.approx(abs(omega[member])), member
        assert member in train.built.bevel or rate * omega[member] > 0, member
        for angle in (1.0, 2.0, 3.0, 4.0, 5.0):
            now = [(complex(*told["rise"]) * cmath.exp(1j * angle), told.get("side", 0)) for told in own]
            assert any(z.real > 0 and (not side or side * z.imag > 0) for z, side in now), (member, angle)
        if member in train.places.radius and member not in train.built.bevel:
            apart = abs(abs(complex(*own[0]["rise"])) - train.places.radius[member] / train.places.scale)
            assert apart < 1.01 * CLEAR
        checked += 1
    assert checked >= 3


def test_bevel_wheels_of_a_train_roll_on_one_another():
    """Where two touch both go to the reader or away from him as fast: of the differential as its case has it."""
    results = solved("statements/car_differential_on_a_curve")
    parts, case = turning(scheme(results.train), results), results.train.speed["H"]
    largest = max(map(abs, results.train.speed.values()))
    for across, other, right, carried in (("1", "2", 1, 0.0), ("4", "3", -1, case), ("4", "5", 1, case)):
        one, two = (next(told for part, told in parts if part.of == name) for name in (across, other))
        ways = right * one["rate"] * abs(complex(*one["rise"]))
        assert one["across"] == [1.0, 0.0] and two["across"] == [0.0, 1.0]
        assert (two["rate"] - carried / largest) * abs(complex(*two["rise"])) == pytest.approx(ways, rel=1e-6)


def test_wheels_of_an_eccentric_mechanism_roll_about_their_stopped_axes():
    """Teeth go by as fast on each, those of the sun against the others, at the speeds of the table."""
    results = solved("eccentric")
    found, speeds = results.eccentric, next(t for t in tables(results) if t.name == "eccentric_speeds")
    row = list(speeds["stopped"].values).index("H")
    teeth = {"1": found.sun, "3": found.ring} | {s.wheel: s.teeth for s in found.satellites}
    centres = {"1": 0j, "3": found.e + 0j} | {s.wheel: s.centre for s in found.satellites}
    parts = turning(assembled(found), results)
    assert sorted(part.of for part, _ in parts) == sorted(teeth) and len(teeth) >= 5
    for part, told in parts:
        assert told["rate"] * found.given.speed == pytest.approx(speeds[f"omega_{part.of}"].numbers()[row])
        sense = 1 if part.of == "1" else -1
        assert told["rate"] * teeth[part.of] == pytest.approx(sense * found.sun)
        assert complex(*told["centre"]) == pytest.approx(centres[part.of] * 1e3 * found.scale, abs=1e-3)
        assert "about" not in told and told["same"]


def test_points_of_an_eccentric_mechanism_go_along_their_paths():
    """Through the places of the table, each time that the axes have turned by a position."""
    results = solved("eccentric")
    for path in results.eccentric.paths:
        ((part, told),) = turning(path_drawing(results.eccentric, path), results)
        mm, axis = 1e3 * path_scale(path), complex(*told["centre"])
        start = complex(part.items[-1].centre)
        for theta, place in zip(path.theta, path.places, strict=True):
            orbit, own = cmath.exp(1j * told["about"] * theta), cmath.exp(1j * told["rate"] * theta)
            assert axis * orbit + (start - axis) * own == pytest.approx(place * mm, abs=1e-3)
    assert len(results.eccentric.paths) == 2


def test_the_cycle_turns_the_fastest_shaft_once():
    speeds = next(t for t in tables(solved("hoist_drive")) if t.name == "drive_speeds")
    omega = dict(zip(speeds["member"].values, speeds["omega"].numbers(), strict=True))
    rates = sorted({abs(part["rate"]) for one in meshes("hoist_drive") for part in one["parts"]})
    assert rates == pytest.approx(sorted(abs(omega[name] / omega["1"]) for name in ("1", "2")))


def test_a_cam_goes_round_as_its_follower_goes_by_the_table():
    (cam,) = moves("valve_cam").values()
    turning, follower, _ = cam["parts"]
    table = next(t for t in tables(solved("valve_cam")) if t.name == "cam_motion_diagram")
    lift = table["cam_S"].numbers() / 0.002  # mm at 0.002 m/mm
    way = np.array(follower["ways"][1], float) + lift[0]
    assert np.allclose(way, lift, atol=2e-3)
    assert abs(turning["turns"][-1] - turning["turns"][0]) == pytest.approx(360)


SEEN = """
(async () => {
  const found = {};
  for (const anchor of Object.keys(known.moves)) {
    const figure = document.getElementById(anchor);
    figure.scrollIntoView();
    await new Promise(done => setTimeout(done, 300));
    const still = known.moves[anchor].still.map(k => figure.querySelector('svg > g').children[k]);
    const shape = () => figure.querySelector('svg').outerHTML;
    const note = shape();
    const shown = [];
    for (const at of %s) {
      show(at);
      const parts = [...figure.querySelectorAll('.turning > *')].filter(x => x.style.display !== 'none');
      shown.push(parts.map(x => {
        const m = x.transform.baseVal.consolidate()?.matrix;
        return m ? [m.a, m.b, m.e, m.f] : [1, 0, 0, 0];
      }));
    }
    const hidden = still.every(x => getComputedStyle(x).visibility === 'hidden');
    const live = figure.querySelector('.turning');
    dispatchEvent(new Event('beforeprint'));
    live.remove();
    const print = shape() === note;
    dispatchEvent(new Event('afterprint'));
    show(cycle.at[home]);
    found[anchor] = {shown, hidden, print, back: shape() === note};
  }
  return found;
})()
"""


@cache
def seen(name: str) -> dict[str, Any]:
    with opened(page(name)) as talk:
        return run(talk, SEEN % [5, 47, 101])


@pytest.mark.parametrize("name", ["hoist_drive", "valve_cam"])
def test_pictures_move_and_come_back(name):
    assert seen(name).keys() == moves(name).keys()
    for one in seen(name).values():
        assert one["hidden"] and one["print"] and one["back"]
        assert one["shown"][0] != one["shown"][1]


def test_a_mark_is_seen_in_front_of_its_axis():
    """At a height that is its radius times the sine of the angle by which its wheel has turned."""
    checked = 0
    for anchor, one in moves("hoist_drive").items():
        parts = [part for part in one["parts"] if "rise" in part]
        for at, shown in zip((5, 47, 101), seen("hoist_drive")[anchor]["shown"], strict=True):
            turned = [
                (complex(*part["rise"]) * cmath.exp(1j * math.radians(part["rate"] * at)), part)
                for part in parts
            ]
            wanted = [-z.imag for z, part in turned if z.real > 0 and part.get("side", z.imag) * z.imag > 0]
            if parts:
                assert [part[3] for part in shown] == pytest.approx(wanted, abs=1e-3)
                checked += len(wanted)
    assert checked >= 9


@pytest.mark.parametrize("name", ["hoist_drive", "conveyor_drive"])
def test_every_member_of_a_drive_shows_how_it_turns(name):
    """From the side a mark at its rim, of a carrier at the pin of its satellites, as fast as the table has it; one of
    every member is in sight at any time."""
    drive, speeds = solved(name).drive, next(t for t in tables(solved(name)) if t.name == "drive_speeds")
    omega = dict(zip(map(str, speeds["member"].values), speeds["omega"].numbers(), strict=True))
    largest, checked = max(map(abs, omega.values())), 0
    for member in (member for stage in drive.stages for member in stage.members if omega[member.name]):
        radius, rate = member.radius / drive.plans.length_scale, omega[member.name] / largest
        own = [
            part
            for part in marks(name)
            if part["rate"] == pytest.approx(rate)
            and abs(abs(complex(*part["rise"])) - radius) < 1.01 * CLEAR
        ]
        for angle in (1.0, 2.0, 3.0, 4.0, 5.0):
            now = [(complex(*part["rise"]) * cmath.exp(1j * angle), part.get("side", 0)) for part in own]
            assert any(z.real > 0 and (not side or side * z.imag > 0) for z, side in now), (
                member.name,
                angle,
            )
        checked += 1
    assert checked >= 4


def test_the_cam_turns_by_the_angle_that_is_shown():
    (one,) = seen("valve_cam").values()
    sense = np.sign(moves("valve_cam")["figure3"]["parts"][0]["turns"][-1])
    for at, parts in zip((5, 47, 101), one["shown"], strict=True):
        a, b, *_ = parts[0]
        assert math.degrees(math.atan2(-b, a)) == pytest.approx(sense * at, abs=0.01)


ROLLER = """
(() => {
  const circles = [...document.querySelectorAll('.turning > *')[1].querySelectorAll('circle')];
  const boxes = circles.map(c => c.getBoundingClientRect()).sort((a, b) => b.width - a.width);
  const { x, y, width, height } = boxes[0];
  return [x, y, width, height];
})()
"""


def test_a_cam_keeps_touching_its_follower():
    """By the pixels: what the roller covers of the cam is its own edge, however the cam has turned."""
    import io

    from PIL import Image

    with opened(page("valve_cam")) as talk:
        for at in (30, 70, 200):
            into = "document.getElementById('figure3').scrollIntoView({block: 'center'});"
            run(talk, f"{into} new Promise(done => setTimeout(done, 300))")
            run(talk, f"show({at}); {into} new Promise(done => setTimeout(done, 300))")
            box = run(talk, ROLLER)
            shot = talk.ask("Page.captureScreenshot")["data"]
            image = np.asarray(Image.open(io.BytesIO(base64.b64decode(shot))).convert("RGB"), float)
            centre, radius = (box[0] + box[2] / 2, box[1] + box[3] / 2), box[2] / 2
            y, x = np.mgrid[: image.shape[0], : image.shape[1]]
            away = np.hypot(x - centre[0], y - centre[1])
            pale = image[..., 2] - image[..., 0] > 10  # the cam's body
            assert abs(away[pale].min() - radius) < 4, at


def test_print_has_nothing_of_what_moves():
    with opened(page("hoist_drive")) as talk:
        shown = f"document.getElementById('{next(iter(moves('hoist_drive')))}').scrollIntoView()"
        run(talk, f"{shown}; new Promise(done => setTimeout(done, 300))")
        run(talk, "show(5)")
        talk.ask("Emulation.setEmulatedMedia", media="print")
        found = run(
            talk,
            "[getComputedStyle(document.querySelector('.turning')).display, document.body.offsetHeight > 1e3]",
        )
    assert found == ["none", True]
