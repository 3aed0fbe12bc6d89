"""Gears that no ready variant has: what is printed of them stands in the results, as of the ready ones."""

import json
from functools import cache
from pathlib import Path

import pytest
from exhaustive import many
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans

from tmm_report import solve
from tmm_report.loading import loads

SUN = "kind: planetary, scheme: sun-ring, module: 5 mm, input: sun"
TWO = "kind: planetary, module: 4 mm, satellites: [2, 4], fixed: wheel3"
DRIVES = {
    "differential, two modules": [
        f"{SUN}, ratio: 6.56, satellites: 3, teeth: [20, 46, 112], output: carrier, "
        "second: {member: ring, speed: 500 rpm}",
        "kind: planetary, module: [5 mm, 4 mm], satellites: [2, 4], scheme: external-internal, ratio: 12, "
        "input: wheel1, output: carrier, fixed: wheel3",
    ],
    "opened by shift, ordinary": [
        f"{SUN}, ratio: 6.56, satellites: [2, 5], tolerance: 5 %, teeth: [20, 46, 110], coaxiality: shift, "
        "output: carrier, fixed: ring",
        f"{SUN}, ratio: -5.6, satellites: 3, output: ring, fixed: carrier",
    ],
    "two rows alike": [
        f"{TWO}, scheme: external-external, ratio: -20, input: carrier, output: wheel1",
        f"{TWO}, scheme: internal-internal, ratio: 40, input: carrier, output: wheel1",
    ],
    "a ring whose tips foul the root, contact beyond the line of action": [
        "kind: spur, ratio: 2.5, module: 2 mm, teeth: [24, 60], shift: [0.3, 0.3], tip_shortening: false",
        "kind: spur, ratio: -1, module: 10 mm, teeth: [10, 10], shift: [0, 0]",
    ],
    "pinion cutters, stated and usual, tips cut down, put together axially": [
        "kind: spur, ratio: 3, module: 3 mm, teeth: [25, 75], shift: [0.4, 0.5], cutter: {z0: 20, x0: 0.1}",
        "kind: spur, ratio: -2, module: 3 mm, teeth: [20, 40], shift: [0.3, 0.2], cutter: {z0: 25}, helix: 12 deg",
        "kind: spur, ratio: -2, module: 3 mm, teeth: [14, 28], centre_distance: 65 mm, shift: limit, cutter: {z0: 25}",
        "kind: spur, ratio: 1.4, module: 3 mm, teeth: [25, 35], shift: [0, 0], rack: {ha*: 0.8}, helix: 15 deg",
    ],
    "measured as stated, with tables for the drawings; of a ring, of one that is helical, on a narrow face": [
        "kind: spur, ratio: -2.4, module: 5 mm, teeth: [13, 31], centre_distance: 112 mm, shift: rule, "
        "inspection: {span: [2, 4], chords: [66 mm, 157 mm], pins: [9 mm, 8.5 mm], drawing_tables: true}",
        "kind: spur, ratio: 3, mesh: internal, module: 3 mm, teeth: [25, 75], shift: [0.4, 0.5], "
        "inspection: {chords: [77 mm, 226 mm], drawing_tables: true}",
        "kind: spur, ratio: 3, mesh: internal, module: 3 mm, teeth: [21, 63], shift: [0, 0], helix: 12 deg, "
        "inspection: {drawing_tables: true}",
        "kind: spur, module: 3 mm, teeth: [20, 40], centre_distance: 101 mm, shift: [0.2, rest], helix: 25 deg, "
        "width: 8 mm, rack: {c*: 0.3}, inspection: {drawing_tables: true}",
    ],
    "backlash: stated, by the rack, by a span, guaranteed, of the axes, by its grade alone": [
        "kind: spur, module: 4 mm, teeth: [17, 34], mesh: external, shift: [0.25, 0], "
        "inspection: {drawing_tables: true}, "
        "backlash: {grade: 8-B, thinning: [0.06 mm, 0.09 mm], tolerance: 0.05 mm, axes: 0.04 mm, guaranteed: 0.12 mm}",
        "kind: spur, module: 3 mm, teeth: [20, 40], centre_distance: 101 mm, helix: 25 deg, rack: {c*: 0.3}, "
        "backlash: {by: rack, thinning: 0.1 mm, tolerance: [0.05 mm, 0.08 mm], axes: 0.05 mm}",
        "kind: spur, mesh: internal, ratio: 3, module: 3 mm, teeth: [25, 75], shift: [0.4, 0.5], "
        "backlash: {by: span, thinning: 0.05 mm}, inspection: {drawing_tables: true}",
        "kind: spur, mesh: internal, ratio: 3, module: 3 mm, teeth: [21, 63], shift: [0, 0], helix: 12 deg, "
        "backlash: {guaranteed: 0.1 mm, axes: 0.03 mm, tolerance: 0.05 mm}, inspection: {drawing_tables: true}",
        "kind: spur, module: 4 mm, teeth: [20, 41], mesh: external, shift: [0, 0], backlash: {axes: 0.05 mm}",
        "kind: spur, module: 4 mm, teeth: [20, 42], mesh: external, shift: [0, 0], backlash: {grade: 7-6-6-Ba}, "
        "inspection: {drawing_tables: true}",
    ],
    "stated tips": [
        "kind: spur, module: 5 mm, teeth: [13, 31], centre_distance: 112 mm, shift: [0.42, rest], "
        "tip_diameters: [78.5 mm, 164 mm], quality: {}",
        "kind: spur, module: 3 mm, teeth: [25, 75], mesh: internal, shift: [0.4, 0.5], "
        "tip_diameters: [82.5 mm, 222.5 mm]",
    ],
    "quality over shifts and distances: external, internal, helical, without a shift that is allowed": [
        "kind: spur, module: 4 mm, teeth: [12, 25], centre_distance: 76 mm, shift: [0.5, rest], "
        "quality: {x1: [0.3, 0.5, 0.7], least_tip: 0.25, centre_distances: [75 mm, 76 mm, 77 mm]}",
        "kind: spur, mesh: internal, ratio: 3, module: 3 mm, teeth: [25, 75], shift: [0.4, 0.5], "
        "quality: {sliding: size}",
        "kind: spur, mesh: internal, ratio: 0.33333333, module: 3 mm, teeth: [75, 25], shift: [0.5, 0.4], quality: {}",
        "kind: spur, module: 3 mm, teeth: [20, 40], centre_distance: 101 mm, helix: 25 deg, rack: {c*: 0.3}, "
        "quality: {sliding: mate, centre_distances: [100.5 mm, 101 mm]}",
        "kind: spur, module: 4 mm, teeth: [8, 9], shift: [0.3, 0.3], quality: {x1: [0.2, 0.3], least_tip: 0.4}",
    ],
    "rounded shifts, pointed teeth": [
        "kind: spur, ratio: -2, module: 6 mm, centre_distance: 130 mm, teeth: [14, 28], shift: [0.18, 0.559]",
        "kind: spur, ratio: -2, module: 3 mm, teeth: [12, 24], shift: [1.2, 0.2]",
    ],
    "a fast pair, any scheme, a ring that drives": [
        "kind: spur, ratio: -2, module: 2.5 mm, teeth: [42, 84], shift: [0.2, 0]",
        f"{TWO}, scheme: any, ratio: 9, input: wheel1, output: carrier",
        "kind: spur, ratio: 0.33333333, module: 4 mm, teeth: [60, 20], shift: [1.0, 0.4], sliding_limit: 2",
    ],
}
ECCENTRICS = {
    "no middle satellite": "ratio: 4, eccentricity: 17 mm, backlash: 0.4 mm, load: {moment: 12 N*m}",
    "crowded": "ratio: 4, eccentricity: 18 mm, t: 16, clearance: 1 mm, speed: 100 rpm, "
    "load: {moment: -50 N*m, on: ring, meshes: 300 N/um, axes: 100 N/um}",
    "undercut": "teeth: [14, 40, 76]",
    "sets near the ratio, paths, masses": "ratio: 4, eccentricity: 17 mm, rack: {ha*: 0.8, c*: 0.3}, tolerance: 3 %, "
    "width: 20 mm, density: 7800 kg/m^3, points: {A: {radius: 100 mm}, B: {wheel: sun, radius: 6 mm, angle: 40 deg}}",
}
TRAINS = {
    "a car's axle on a curve": "car_differential_on_a_curve",
    "two suns and a held one": "two_suns_compound_planet",
    "3K": "reducer_3k",
    "two inputs": "steering_two_inputs",
    "idlers": "reversing_train_with_idlers",
    "closed, with a drum": "drum_closed_differential",
}
SOUGHT = """train:
  name: 3K
  wheels: {a: [15, 30], g: [15, 40], b: [40, 110], e: [40, 110]}
  carriers: {H: g}
  meshes: [a-g, g-b internal, g-e internal]
  input: a
  output: e
  fixed: b
  satellites: [3, 4]
  find: {ratio: 90, tolerance: 2 %, shifted: 2}
  efficiency: {external: 0.97, internal: 0.98}
  output_power: 300 W
"""
TOGETHER = """train:
  wheels: {a: 30, p: 20, b: 70, a': 24, q: 30, b': 84, c: 40, r: 20, f: 80}
  carriers: {C: p, D: q, E: r}
  meshes: [a-p, p-b internal, a'-q, q-b' internal, c-r, r-f internal]
  joined: [[C, c], [D, E]]
  input: a
  output: b
  fixed: f
  speed: 1000 rpm
  torque: 10 N*m
  module: 2 mm
  satellites: 2
  efficiency: {external: 0.98, internal: 0.99}
"""
LOOP = """train:
  wheels: {1: 20, 2: 40, 3: 100, 1': 30, 4: 30, 5: 90, 6: 20, 7: 12, 8: 20}
  carriers: {H: [2, 7]}
  meshes: [1-2, 2-3 internal, 1'-4, 4-5 internal, 6-7 bevel, 7-8 bevel]
  joined: [[3, 5]]
  input: 1
  output: [6, 8]
  speed: 1000 rpm
  speeds: {6: -105 rpm}
  torque: 10 N*m
  efficiency: {external: 0.98, internal: 0.99, bevel: 0.97}
"""
STATEMENTS = Path(__file__).parents[2] / "statements"
TEXTS = {
    name: "drive:\n  speed: 3000 rpm\n  torque: 10 N*m\n  stages:\n"
    + "".join(f"    - {{{stage}}}\n" for stage in stages)
    for name, stages in DRIVES.items()
} | {name: f"eccentric: {{{block}, module: 2 mm}}\n" for name, block in ECCENTRICS.items()}
TEXTS |= {
    name: (STATEMENTS / f"{file}.yaml").read_text("utf-8").replace("language: en\n", "")
    for name, file in TRAINS.items()
} | {"3K whose teeth are sought": SOUGHT, "rows solved together": TOGETHER, "two outputs behind a loop": LOOP}


QUICK = ("two rows alike", "3K", "two inputs", "rounded shifts, pointed teeth", "no middle satellite")
CASES = many(sorted(TEXTS, key=lambda name: name not in QUICK), len(QUICK))


@cache
def made(name: str):
    """The note and results.json."""
    found = solve(loads("language: en\n" + TEXTS[name]))
    return read(render(found, "html")["note.html"].decode()), json.loads(
        render(found, "json")["results.json"]
    )


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CASES)
def test_marked_numbers_are_those_of_the_results(name):
    note, document = made(name)
    assert len(note.marked) > (100 if name in TRAINS else 200)
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)])


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CASES)
def test_every_printed_number_is_marked(name):
    wrong(list(unmarked(made(name)[0])))
