"""What the script of a note knows, against the solver, the results and the sizes that it may have."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import zlib
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import LEVERS, read, solved
from exhaustive import many
from notes import note, static
from payloads import PAYLOADS

from tmm_report import render, solve
from tmm_report.chapters.lever.schemes import schemes_of
from tmm_report.figures.schemes.view import view_of
from tmm_report.i18n import Translator
from tmm_report.living import as_json
from tmm_report.living.cycle import cycle_of
from tmm_report.living.mechanism import BETWEEN, OPEN, Poses, _hermite, _seen
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

NAMES = [path.stem for path in LEVERS]
QUICK = [name for name in ("compressor", "cam_press", "quick_return") if name in NAMES]
ORDERED = [*QUICK, *(name for name in NAMES if name not in QUICK)]


@cache
def page(name: str) -> str:
    return note(name, "html", depth=None)["note.html"].decode()


def known(text: str) -> dict:
    found = json.loads(
        re.findall(r'<script type="application/json" id="living">(.*?)</script>', text, re.S)[-1]
    )
    return found | {"told": json.loads(zlib.decompress(base64.b64decode(found["told"]), -zlib.MAX_WBITS))}


@cache
def data(name: str) -> dict:
    return known(page(name))


@pytest.mark.parametrize("name", many(ORDERED, 3))
def test_links_go_between_positions_as_the_solver_has_them(name):
    """The polynomial of the fifth degree against the mechanism solved at the places between, mm of paper."""
    results = solved(name)
    cycle = cycle_of(results)
    schemes = schemes_of(results.lever, Page(Html(), Translator("en"), Numbering()))
    view = view_of(schemes.mechanism, *_seen(schemes.mechanism, cycle), schemes.scale, 0)
    poses = Poses(cycle, view)
    if not poses.smooth.any():
        pytest.skip("it has no way between positions")
    h = np.diff(cycle.turned)
    found = {link: [_hermite(one, cycle.turned) for one in poses.of[link]] for link in poses.of}
    for row, share in enumerate(BETWEEN):
        motion = cycle.kinematics.cycle.motion(cycle.turned[:-1] + share * h)
        for link, (x, y, angle) in found.items():
            for point, at in view.mechanism.links[link].points.items():
                local = complex(np.ravel(at)[0])
                drawn = x[row] + 1j * y[row] + np.exp(1j * angle[row]) * local / schemes.scale
                true = motion.place(point) / schemes.scale
                assert np.max(np.abs(drawn - true)[poses.smooth]) < 2 * OPEN, (link, point)


@pytest.mark.parametrize("name", many(ORDERED, 3))
def test_most_mechanisms_move_between_their_positions(name):
    """Those that do not are few, and stand still only where they have no positions."""
    found, lever = data(name), solved(name).lever
    assert found["mechanism"]["links"].keys() == {n for n in lever.given.mechanism.real.links if n != "0"}
    closes = cycle_of(solved(name)).merged(lever.kinematics.table.closes, lever.kinematics.diagram.closes)
    together = np.logical_and(closes[:-1], closes[1:])
    assert np.sum(found["mechanism"]["smooth"]) >= 0.9 * together.sum()
    assert len(found["mechanism"]["smooth"]) == len(found["cycle"]["at"]) - 1


@pytest.mark.parametrize("name", many(ORDERED, 3))
def test_columns_are_those_of_the_tables_at_the_numbered_positions(name):
    results = solved(name)
    cycle, said = cycle_of(results), data(name)["cycle"]
    assert said["columns"]
    for table, columns in said["columns"].items():
        for one in columns:
            column = cycle.pairs[table][0][one["key"]]
            want = column.numbers(column.quantity.printed)
            values = np.array([np.nan if x is None else x for x in one["values"]])
            got, largest = values[said["numbered"]], np.nanmax(np.abs(values), initial=0.0)
            assert np.allclose(got, want, rtol=0, atol=5e-6 * largest + 1e-12, equal_nan=True), (
                table,
                one["key"],
            )


def vertices(found: dict, plan: dict) -> dict[int, np.ndarray]:
    """Where the vertices of a plan are in all positions, mm, as the script has them."""
    nodes = {plan["begin"]: np.full(len(found["cycle"]["at"]), complex(*plan["at"][plan["begin"]]))}
    for end, start, key, sense in plan["ways"]:
        x, y = (np.array(one, float) for one in found["cycle"]["vectors"][key])
        nodes[end] = nodes[start] + sense * (x + 1j * y) / plan["scale"]
    return nodes


def test_plans_are_redrawn_by_the_velocities_of_the_motion():
    """The plan of velocities of the compressor: its vertices lie from the pole as the points move."""
    lever, found = solved("compressor").lever, data("compressor")
    scale, diagram = lever.plans.velocity_scale, lever.kinematics.diagram
    plan = next(one for one in found["plans"].values() if any(key == "v_A" for key, *_ in one["arrows"]))
    nodes, checked = vertices(found, plan), 0
    for key, start, end in plan["arrows"]:
        point = key.removeprefix("v_")
        if point not in found["mechanism"]["points"]:
            continue
        assert np.allclose(nodes[end] - nodes[start], diagram.velocity(point) / scale, atol=1e-2), key
        checked += 1
    assert checked >= 4


@pytest.mark.parametrize("name", many(["compressor", "press", "shaper", "quick_return"], 1))
def test_force_plans_close_in_every_position(name):
    """From the vertex where a reaction of the table begins to where it ends: its size by the scale of the plan."""
    found = data(name)
    reactions = solved(name).lever.kinetostatics.diagram.statics.reactions
    checked = 0
    for plan in found["plans"].values():
        nodes = vertices(found, plan)
        for key, start, end in plan["arrows"]:
            if not (match := re.fullmatch(r"R_(\d)(\d)", key)) or not {start, end} <= nodes.keys():
                continue
            force = next(
                reactions[k].force
                for k in (f"{match[1]}-{match[2]}", f"{match[2]}-{match[1]}")
                if k in reactions
            )
            long = np.abs(nodes[end] - nodes[start])
            position = plan["position"]
            assert np.allclose(
                long / long[position], np.abs(force) / abs(force[position]), rtol=0.02, atol=0.02
            ), key
            checked += 1
    assert checked


def test_a_cursor_has_the_numbers_of_the_results():
    lever, found = solved("compressor").lever, data("compressor")
    moment = lever.kinetostatics.diagram.balancing
    curves = [c["values"] for chart in found["charts"].values() for p in chart["panels"] for c in p["curves"]]
    columns = {
        f"{name}.{c['key']}": c["values"] for name, of in found["cycle"]["columns"].items() for c in of
    }
    values = (np.array(columns[c] if isinstance(c, str) else c, float) for c in curves)
    near = [c for c in values if np.allclose(c, moment, rtol=1e-3, atol=1e-3 * np.max(np.abs(moment)))]
    assert near, "the diagram of the balancing moment has no cursor with its numbers"


def test_script_and_data_have_their_size():
    """Of the compressor, which has 36 positions: 250 kB for script and data, 1.5 MB for all."""
    text = page("compressor")
    assert len(text.encode()) < 1.5e6
    scripts = re.findall(r"<script.*?</script>", text, re.S)
    assert len(scripts) == 2 and sum(len(one.encode()) for one in scripts) < 250e3


def test_the_policy_allows_this_script_and_no_other():
    text = page("compressor")
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)[1]
    script = text.rpartition("<script>")[2].partition("</script>")[0]
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert re.search(r"script-src ([^;]*)", policy)[1] == f"'sha256-{digest}'"
    assert "default-src 'none'" in policy


def test_names_of_a_variant_end_no_block():
    """Every payload in the names of the loads: the block stays one, and is read as what was written."""
    everything = " ".join(PAYLOADS.values()) + ' </script><script>alert(1)</script> "&<!--'
    variant = read("compressor")
    forces = tuple(replace(one, name=everything) for one in variant.lever.loads.forces)
    loads = replace(variant.lever.loads, forces=forces)
    hostile = render(solve(replace(variant, lever=replace(variant.lever, loads=loads))), "html")[
        "note.html"
    ].decode()
    told = known(hostile)["told"]["texts"]
    assert any("</script>" in one for one in told), "the name is in the data"
    block = hostile.partition(' id="living">')[2].partition("</script>")[0]
    assert not set("<>&") & set(block)
    assert "<script" not in static(hostile)
    assert json.loads(as_json({"x": everything})) == {"x": everything}


def test_results_alone_pay_for_no_page():
    """results.json is made without a module of the living page."""
    import subprocess
    import sys

    code = (
        "import sys; from tmm_report import load, render, solve;"
        "render(solve(load('variants/crank_rocker.yaml')), 'json');"
        "assert not [m for m in sys.modules if 'tmm_report.living' in m]"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("name", ["hoist_drive", "rotor"])
def test_a_variant_without_a_lever_mechanism_has_contents_and_no_motion(name):
    found = data(name)
    assert "mechanism" not in found and found["told"]["texts"]
