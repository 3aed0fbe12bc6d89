"""Loading schemes and Zhukovsky's lever in all positions, by the laws that they stand for: what acts on the links of a
scheme is in equilibrium, and so is the lever about its pole."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import solved
from exhaustive import many
from test_living_data import ORDERED, data, known, page, vertices
from test_living_page import number, opened, run

from tmm_report import load, render, solve
from tmm_report.living.loads import _across


def vector(found, key):
    x, y = (np.array(one, float) for one in found["cycle"]["vectors"][key])
    return x + 1j * y


def carried(found, link, x, y):
    """Place of what a link carries, mm, at the positions."""
    of = found["mechanism"]["links"].get(link)
    if of is None:
        return np.full(len(found["cycle"]["at"]), complex(x, y))
    pose = [np.array(one, float) for one in of["pose"]]
    return pose[0] + 1j * pose[3] + np.exp(1j * pose[6]) * complex(x, y)


def place(found, point):
    link, x, y, *_ = found["mechanism"]["points"][point]
    return carried(found, link, x, y)


def acts_at(found, at):
    if isinstance(at, str):
        return place(found, at)
    if at[0] == "":
        known = {key: where for key, where, _ in found["mechanism"]["forces"]}
        return acts_at(found, known[at[1]])
    return np.array(at[0], float) + 1j * np.array(at[1], float)


def schemes(found):
    return {anchor: one for anchor, one in found.get("loads", {}).items() if "links" in one}


def levers(found):
    return {anchor: one for anchor, one in found.get("loads", {}).items() if "sides" in one}


@pytest.mark.parametrize("name", many(ORDERED, 3))
def test_what_a_scheme_shows_is_in_equilibrium_in_every_position(name):
    """Forces and their moments about the origin, with the couples: to the digits that are sent."""
    in_equilibrium(data(name))


def test_a_cylinder_holds_the_link_that_it_moves():
    """The force along the stroke is among those of a scheme, and its number stands over it."""
    variant = load(Path(__file__).with_name("loader.yaml"))
    found = known(render(solve(variant), "html")["note.html"].decode())
    held = [one for one in schemes(found).values() if "F_stroke" in [key for key, *_ in one["forces"]]]
    assert [one["moment"] for one in held] == ["F_stroke"]
    in_equilibrium(found)


CASES = Path(__file__).parent.parent / "cases" / "explain"
CYLINDERS = (Path(__file__).with_name("loader.yaml"), CASES / "boom_by_cylinder.yaml")


@pytest.mark.parametrize("file", CYLINDERS, ids=lambda file: file.stem)
def test_a_plan_moves_to_what_is_constructed_in_another_position(file):
    """Parts of reactions and the force of a cylinder among its vectors: within what a reading errs."""
    stated = file.read_text("utf-8").partition("friction:")[0]
    stated = re.sub("plans: .*", "plans: [2, 6], force_plan: [2, 6]}", stated)
    found = known(render(solve(load(stated)), "html", depth="full")["note.html"].decode())
    plans = [one for one in found["plans"].values() if any(key[0] in "GFR" for key, *_ in one["arrows"])]
    half = len(plans) // 2
    assert len(plans) == 2 * half >= 4
    for one, other in zip(plans[:half], plans[half:], strict=True):
        assert [key for key, *_ in one["arrows"]] == [key for key, *_ in other["arrows"]]
        nodes, at = vertices(found, one), other["position"]
        assert len(nodes) == len(one["at"]) == len(other["at"]) and at != one["position"]
        begin = (
            complex(*other["at"][other["begin"]]) - nodes[one["begin"]][at] * one["scale"] / other["scale"]
        )
        sizes = [abs(complex(*z) - complex(*other["at"][other["begin"]])) for z in other["at"]]
        for n, z in enumerate(other["at"]):
            moved = nodes[n][at] * one["scale"] / other["scale"] + begin
            assert abs(moved - complex(*z)) < 0.02 * max(sizes) + 0.3, n


def test_parts_of_a_reaction_are_those_of_every_position():
    """The tangential one is across its arm and has the moment of the whole reaction about the other end."""
    found = data("compressor")
    for key, end, about in (("R_12", "A", "B"), ("R_24", "C", "D")):
        whole, part, arm = (
            vector(found, key),
            vector(found, f"{key}_t"),
            place(found, end) - place(found, about),
        )
        largest = np.max(np.abs(whole)) * np.abs(arm)
        assert np.max(np.abs((arm.conj() * part).real) / largest) < 1e-3
        assert np.max(np.abs((arm.conj() * (whole - part)).imag) / largest) < 1e-3


def in_equilibrium(found):
    assert schemes(found)
    metre = found["mechanism"]["scale"]  # m/mm
    for anchor, scheme in schemes(found).items():
        forces = [(vector(found, key), acts_at(found, at) * metre) for key, at, *_ in scheme["forces"]]
        couples = sum((np.array(found["cycle"]["turning"][key], float) for key, *_ in scheme["couples"]), 0.0)
        largest = max(float(np.nanmax(np.abs(force))) for force, _ in forces)
        total = sum(force for force, _ in forces)
        # one link of several: what its neighbours do is among the reactions, so that this holds for it, too
        assert np.nanmax(np.abs(total)) < 3e-4 * largest, anchor
        arms = max(float(np.nanmax(np.abs(at))) for _, at in forces)
        moment = sum((at.conj() * force).imag for force, at in forces) + couples
        assert np.nanmax(np.abs(moment)) < 2e-3 * largest * arms, anchor


@pytest.mark.parametrize("name", many(ORDERED, 3))
def test_the_lever_is_in_equilibrium_about_its_pole_in_every_position(name):
    """Zhukovsky's theorem: forces in the ends of the turned velocities, the balancing force with them."""
    found = data(name)
    for anchor, lever in levers(found).items():
        turn = complex(*lever["turn"])

        def end(point, turn=turn):
            return turn * vector(found, f"v_{point}") if point else 0j

        moments = []
        for key, ends, *_ in lever["forces"]:
            for sense, point in zip((1, -1), ends, strict=False):
                moments.append((np.conj(end(point)) * sense * vector(found, key)).imag)
        omega = solved(name).lever.kinematics.omega
        assert (
            lever["turn"][0] == 0 and lever["turn"][1] * float(np.ravel(omega)[0]) < 0
        )  # against the rotation
        largest = max(float(np.nanmax(np.abs(one))) for one in moments)
        assert np.nanmax(np.abs(sum(moments))) < 2e-3 * largest, anchor


@pytest.mark.parametrize("name", ["cam_press"])
def test_what_replaces_a_cam_pair_lies_along_its_force(name):
    """From the centre of curvature to where the follower is met: a link without mass between two joints."""
    found, checked = data(name), 0
    for scheme in schemes(found).values():
        for (xs, ys), met, _ in scheme["rods"]:
            along = acts_at(found, met) - (np.array(xs, float) + 1j * np.array(ys, float))
            key = next(key for key, *_ in scheme["forces"] if re.fullmatch(r"R_.*k", key))
            force = vector(found, key)
            there = np.abs(force) > 1e-3 * np.nanmax(np.abs(force))
            assert np.nanmax(np.abs((along.conj() * force).imag / np.abs(along * force))[there]) < 5e-3
            checked += there.sum()
    assert checked > 20


def test_most_schemes_of_a_note_move():
    found = data("compressor")
    assert len(schemes(found)) == 3 and len(levers(found)) == 1
    driver = [one for one in schemes(found).values() if one["moment"]]
    assert [one["links"] for one in driver] == [["1"]]


LOADS = """
(async () => {
  const found = [];
  const out = (figure, live) => {
    const room = figure.querySelector('svg').getBoundingClientRect();
    const seen = [...live.querySelectorAll('text, path')].filter(x => x.checkVisibility());
    const boxes = seen.map(x => x.getBoundingClientRect()).filter(r => r.width);
    const apart = r => Math.max(room.left - r.left, r.right - room.right, room.top - r.top, r.bottom - room.bottom);
    return boxes.filter(r => apart(r) > 1).length;
  };
  for (const [anchor, load] of Object.entries(known.loads)) {
    const figure = document.getElementById(anchor);
    figure.scrollIntoView();
    await new Promise(done => setTimeout(done, 300));
    const note = figure.querySelector('svg > g');
    const svg = figure.querySelector('svg');
    const shape = () => ['viewBox', 'width', 'height'].map(x => svg.getAttribute(x)).join();
    const at = (load.position + 5) % last;
    show(cycle.at[at]);
    const live = figure.querySelector('.loads');
    const moved = shape();
    const one = {
      anchor, at, hidden: getComputedStyle(note).visibility, out: out(figure, live),
      told: figure.querySelector('.over').textContent,
      arrows: [...live.querySelectorAll('g[data-q]')].filter(g => g.style.display !== 'none').map(
        g => [g.dataset.q, g.firstChild.getAttribute('d'), g.lastChild.getAttribute('d')]),
      points: [...live.querySelectorAll('circle[data-point]')].map(
        c => [c.dataset.point, Number(c.getAttribute('cx')), Number(c.getAttribute('cy'))]),
    };
    show(cycle.at[load.position]);
    one.noted = [getComputedStyle(note).visibility, live.style.display];
    dispatchEvent(new Event('beforeprint'));
    one.print = [getComputedStyle(note).visibility, moved !== shape()];
    dispatchEvent(new Event('afterprint'));
    found.push(one);
  }
  return found;
})()
"""


@cache
def loads() -> list[dict[str, Any]]:
    with opened(page("compressor")) as talk:
        return run(talk, LOADS)


def test_loading_schemes_follow_the_position():
    """What is drawn points as the forces of the position do, from where they act, on links of their own lengths."""
    known = data("compressor")
    assert len(loads()) == 4
    for one in loads():
        load, at = known["loads"][one["anchor"]], one["at"]
        assert one["hidden"] == "hidden" and one["noted"] == ["visible", "none"] and one["out"] == 0
        assert one["print"] == ["visible", True]
        drawn = {key: (shaft, head) for key, shaft, head in one["arrows"] if shaft}
        checked = 0
        for key, *_ in load["forces"]:
            if key not in drawn:
                continue
            start = [float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", drawn[key][0])[:2]]
            tip = [float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", drawn[key][1])[:2]]
            way = complex(tip[0] - start[0], start[1] - tip[1])
            force = complex(*(known["cycle"]["vectors"][key][c][at] for c in (0, 1)))
            sense = -1 if key.startswith("F_M") else 1  # of a pair the second is the last that is drawn
            assert abs(way / abs(way) - sense * force / abs(force)) < 1e-3, key
            checked += 1
        assert checked >= 2


def test_links_of_a_loading_scheme_keep_their_lengths():
    known, mechanism = data("compressor"), solved("compressor").lever.given.mechanism.real
    for one in loads():
        load = known["loads"][one["anchor"]]
        places = {name: complex(x, y) for name, x, y in one["points"]}
        for link in load.get("links", ()):
            for (a, u), (b, v) in pairwise(mechanism.links[link].points.items()):
                long = abs(complex(u) - complex(v)) / known["mechanism"]["scale"] * load["by"]
                assert abs(places[a] - places[b]) == pytest.approx(long, abs=0.01)


def test_the_balancing_moment_goes_with_its_schemes():
    """Its number stands over the scheme of the driving link and over the lever."""
    column = next(c for c in data("compressor")["cycle"]["columns"]["balancing"] if c["key"] == "M_bal")
    told = [
        (one["at"], one["told"]) for one in loads() if data("compressor")["loads"][one["anchor"]]["moment"]
    ]
    assert len(told) == 2
    for at, text in told:
        shown = number(re.search(r"M.* = ([−\d,.]+) Н·м", text)[1])
        assert shown == pytest.approx(column["values"][at], rel=1e-4)


def test_a_couple_has_no_force_across_an_arm_without_length():
    """Told nobody: a cam at rest is round, and so it is where the mechanism cannot be assembled."""
    with np.errstate(all="raise"):
        force = _across(np.array([0j, complex("nan"), 2 + 0j]), np.array([0.0, 1.0, 6.0]))
    assert np.isnan(force[:2]).all() and force[2] == 3j
