"""Plans of groups above class II: guides on every kind of link, contours, links that turn as known ones do."""

from dataclasses import replace

import numpy as np
import pytest
from conftest import stating
from test_drawn_values import drawn, force_errors, plan_errors

from tmm_report import solve
from tmm_report.i18n import Translator
from tmm_report.loading import loads

TRIAD = """\
mechanism:
  frame: {O: [0, 0], E: [300 mm, 0], F: [100 mm, -200 mm]}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: {A: 0, B: 200 mm, S2: 100 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.007}
    3: {points: {B: 0, C: 120 mm, D: [60 mm, -80 mm], S3: [60 mm, -30 mm]}, mass: 3 kg, mass_centre: S3, inertia: 0.01}
    4: {points: {E: 0, C: 150 mm}, mass: 1.5 kg, inertia: 0.003, mass_centre: C}
    5: {points: {F: 0, D: 160 mm}}
  driver: {link: 1, speed: 100 rpm}
  sketch: {A: [0, 50 mm], B: [190 mm, 100 mm], C: [300 mm, 150 mm], D: [220 mm, 20 mm]}
loads:
  moments: [{on: 4, constant: 20 N*m, direction: against motion}]
"""

# the ternary link carries the guide of a block with a fixed pivot
BLOCK = """\
mechanism:
  frame: {O: [0, 0], E: [300 mm, 20 mm], F: [100 mm, -200 mm]}
  guides: {g: {through: B, angle: 5 deg, link: 3}}
  links:
    1: {points: {O: 0, A: 30 mm}}
    2: {points: {A: 0, B: 200 mm, S2: 100 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.007}
    3: {points: {B: 0, D: [60 mm, -80 mm], S3: [60 mm, -30 mm]}, mass: 3 kg, mass_centre: S3, inertia: 0.01}
    4: {points: [E], slides: g}
    5: {points: {F: 0, D: 160 mm}}
  driver: {link: 1, speed: 100 rpm}
  sketch: {A: [0, 30 mm], B: [190 mm, 60 mm], D: [240 mm, -20 mm]}
loads:
  moments: [{on: 5, constant: 20 N*m, direction: against motion}]
"""

# the ternary link itself slides on a rocking guide
ROCKING_GUIDE = """\
mechanism:
  frame: {O: [0, 0], E: [300 mm, 20 mm], F: [100 mm, -200 mm]}
  guides: {g: {through: E, link: 4}}
  links:
    1: {points: {O: 0, A: 30 mm}}
    4: {points: {E: 0, S4: 50 mm}, mass: 1 kg, mass_centre: S4, inertia: 0.002}
    2: {points: {A: 0, B: 200 mm, S2: 100 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.007}
    3:
      points: {B: 0, D: [60 mm, -80 mm], S3: [60 mm, -30 mm]}
      slides: {guide: g, at: B, angle: 185 deg}
      mass: 3 kg
      mass_centre: S3
      inertia: 0.01
    5: {points: {F: 0, D: 160 mm}}
  driver: {link: 1, speed: 100 rpm}
  sketch: {A: [0, 30 mm], B: [190 mm, 60 mm], D: [240 mm, -20 mm]}
loads:
  moments: [{on: 5, constant: 20 N*m, direction: against motion}]
"""

# a contour, one of whose links slides on the driving link and turns with it
ON_THE_CRANK = """\
mechanism:
  frame: {O: [0, 0], G: [300 mm, 0]}
  guides: {g: {through: A, angle: 70 deg, link: 1}}
  links:
    1: {points: {O: 0, A: 15 mm}}
    2:
      points: {B: 0, P: [10 mm, -70 mm], S2: [10 mm, -30 mm]}
      slides: {guide: g, at: B, angle: 90 deg}
      mass: 2 kg
      mass_centre: S2
      inertia: 0.001
    3: {points: {B: 0, C: 206 mm, S3: 80 mm}, mass: 3 kg, mass_centre: S3, inertia: 0.01}
    4: {points: {P: 0, D: 257 mm}}
    5: {points: {G: 0, C: [-60 mm, 80 mm], D: [-30 mm, -75 mm], S5: [-20 mm, 10 mm]}, mass: 1.5 kg, mass_centre: S5}
  driver: {link: 1, speed: 100 rpm, range: 12 deg, zero: {angle: -10 deg}}
  sketch: {A: [15 mm, 0], B: [35 mm, 60 mm], C: [240 mm, 80 mm], P: [21 mm, -13 mm], D: [270 mm, -75 mm]}
loads:
  moments: [{on: 5, constant: 20 N*m, direction: against motion}]
"""

# the guide is in the group, and what slides in it is the crank
IN_THE_GUIDE = """\
mechanism:
  frame: {O: [0, 0], E: [300 mm, 0], F: [100 mm, -200 mm]}
  guides: {g: {through: B, link: 2}}
  links:
    1: {points: {O: 0, A: 25 mm}, slides: {guide: g, at: A, angle: 40 deg}}
    2: {points: {B: 0, P: 40 mm, Q: [100 mm, 30 mm]}, mass: 2 kg, mass_centre: P, inertia: 0.001}
    3: {points: {B: 0, C: 220 mm, D: [160 mm, -80 mm], S3: [60 mm, -30 mm]}, mass: 3 kg, mass_centre: S3, inertia: 0.01}
    4: {points: {E: 0, C: 150 mm}, mass: 1.5 kg, inertia: 0.003, mass_centre: C}
    5: {points: {F: 0, D: 260 mm}}
  driver: {link: 1, speed: 100 rpm, range: 25 deg, zero: {angle: 115 deg}}
  sketch: {A: [0, 25 mm], B: [40 mm, 60 mm], C: [260 mm, 140 mm], D: [220 mm, 10 mm]}
loads:
  moments: [{on: 4, constant: 20 N*m, direction: against motion}]
"""

# on a translating guide, which has no Coriolis part
TRANSLATING_GUIDE = """\
mechanism:
  frame: {O: [0, 0], F: [100 mm, -200 mm]}
  guides: {x: {through: O}, s: {through: S3, angle: 90 deg, link: 3}, g: {through: G, angle: 60 deg, link: 3}}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: [A], slides: s}
    3: {points: {S3: 0, G: 150 mm}, slides: x, mass: 2 kg, mass_centre: S3}
    4: {points: [D], slides: g, mass: 1 kg, mass_centre: D}
    5: {points: {F: 0, D: 160 mm}}
  driver: {link: 1, speed: 100 rpm}
  assembly: {D: '+'}
loads:
  moments: [{on: 5, constant: 20 N*m, direction: against motion}]
"""

TEXTS = {
    "triad": TRIAD, "block": BLOCK, "rocking guide": ROCKING_GUIDE, "on the crank": ON_THE_CRANK,
    "in the guide": IN_THE_GUIDE, "translating guide": TRANSLATING_GUIDE,
}  # fmt: skip


@pytest.fixture(scope="module", params=TEXTS)
def found(request):
    return drawn(loads(TEXTS[request.param]), 1e-5)


def systems(found):
    """(force plan, its position) of every group above class II."""
    return [(plan, d.position) for d in found.lever.force_plans.drawn for plan in d.plans if plan.balances]


def test_plans_agree_with_the_analytical_values(found):
    assert len(found.lever.plans.drawn) == len(found.lever.force_plans.drawn) == 12
    wrong = {key: x for key, x in plan_errors(found).items() if not x <= 2}
    wrong |= {key: x for key, x in force_errors(found).items() if not x <= 4}
    assert not wrong


def test_every_value_is_compared(found):
    for d in found.lever.plans.drawn:
        assert {*d.velocity.per_mm, *d.acceleration.per_mm} == set(found.lever.kinematics.values)
    pairs = len(found.lever.structure.pairs)
    assert all(sum(c.key[0] == "R" for c in d.comparison) == pairs for d in found.lever.force_plans.drawn)


def test_contours_give_as_many_equations_as_unknowns(found):
    steps = [
        step for d in found.lever.plans.drawn for plan in (d.velocity, d.acceleration) for step in plan.steps
    ]
    for step in (step for step in steps if step.projections is not None):
        assert len(step.projections.rows) == len(step.projections.unknown) <= len(step.group.links)
        for _, _, row, right in step.projections.rows:
            assert np.dot(row, step.projections.solution) == pytest.approx(
                right, abs=1e-9 + 1e-9 * abs(right)
            )


def test_the_rates_read_off_are_those_of_the_solution(found):
    for d in found.lever.plans.drawn:
        for plan in (d.velocity, d.acceleration):
            for projections in (step.projections for step in plan.steps if step.projections):
                for key, value in zip(projections.unknown, projections.solution, strict=True):
                    step = plan.per_mm[key] * found.lever.plans.accuracy
                    assert plan.values[key] == pytest.approx(abs(value), abs=2 * step)


def test_the_forces_on_every_link_close_in_the_plan(found):
    for plan, position in systems(found):
        for balance in plan.balances:
            total = 0j
            for term in balance.forces.sides[0]:
                key = f"{term.symbol.base}_{term.symbol.sub}"
                stroke = next(s for s in plan.strokes if s.key == key)
                total += (stroke.start - stroke.end) if term.negative else (stroke.end - stroke.start)
            assert abs(total) < 0.05, (position, balance.link)


def test_the_forces_that_act_on_a_link_are_in_its_equations(found):
    for plan, _ in systems(found):
        pairs = [pair for pair in found.lever.structure.pairs if set(pair.links) & set(plan.links)]
        for balance in plan.balances:
            reactions = [t for t in balance.forces.sides[0] if t.symbol.base == "R"]
            assert len(reactions) == sum(balance.link in pair.links for pair in pairs)
            assert balance.moments.latex(Translator("en")).endswith("=0")


def test_a_contour_closes_on_one_common_point():
    """Class IV: reactions of the contour's pairs lead from one point, so none of them is drawn twice."""
    variant = loads(ON_THE_CRANK)
    plan, _ = systems(solve(stating(variant, positions=replace(variant.lever.positions, force_plan=(3,)))))[0]
    keys = [stroke.key for stroke in plan.strokes]
    assert len(keys) == len(set(keys))
    inner = [stroke for stroke in plan.strokes if stroke.key in ("R_23", "R_24", "R_35", "R_45")]
    assert len(inner) == 4
    ends = [{complex(np.round(z, 6)) for z in (s.start, s.end)} for s in inner]
    assert len(set.intersection(*ends)) == 1
