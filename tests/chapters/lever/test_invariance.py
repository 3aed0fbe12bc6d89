"""Names and the place of the drawing on the sheet change no result; for every ready variant."""

import cmath
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import examples, read, stating, unread
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from tmm_report import course
from tmm_report.chapters.lever.friction.given import Friction
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.course import Results, Variant
from tmm_report.mechanics.lever.mechanism import FRAME, Assembly, ZeroAngle

few = settings(
    max_examples=examples(4),
    phases=[Phase.explicit, Phase.generate],  # a whole course project a try: nothing to gain from shrinking
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
NAMES = [*"ABCDEFGHKLMNOPQRSTUVWXYZnkpπ", "S2", "A'", "Ж"]


def numbers(found: Results) -> dict[str, np.ndarray]:
    """What a note says, without names and directions: signed scalars and magnitudes of vectors.

    The first word of a key is the kind of quantity: v, a, w, e, moment, reaction...
    """
    out = {}
    for index, t in enumerate(found.lever.kinematics.travels):
        out |= {
            f"travel-{key} {index}": np.asarray(getattr(t, key))
            for key in ("S", "V", "a", "stroke", "diagram_S")
        }
        out[f"extremes {index}"] = np.array([x.value for x in (t.near, t.far, *t.V_extremes, *t.a_extremes)])
        out[f"ratio {index}"] = np.asarray(t.time_ratio or 0.0)
    for index, (key, value) in enumerate(found.lever.kinematics.diagram_values.items()):
        out[f"{key[0]} {index}"] = np.abs(value) if np.iscomplexobj(value) else value
    forces = found.lever.kinetostatics
    assert forces is not None and found.lever.friction is not None
    for solved in (forces.table, forces.diagram):
        out[f"moment {len(solved.turned)}"] = solved.balancing
        for index, reaction in enumerate(solved.statics.reactions.values()):
            out[f"reaction {index} {len(solved.turned)}"] = np.abs(reaction.force)
            out[f"moment {index} {len(solved.turned)}"] = np.asarray(reaction.moment)
    out["friction"] = found.lever.friction.diagram.total
    out["efficiency"] = found.lever.friction.diagram.efficiency
    return out


def drawn(found: Results) -> list[tuple[float, float]]:
    """Values of all plans with the value of 1 reading step."""
    assert found.lever.force_plans is not None
    pictures = (*found.lever.plans.drawn, *found.lever.force_plans.drawn)
    return [(c.graph, c.floor) for picture in pictures for c in picture.comparison]


def renamed(v: Variant, points: dict[str, str], links: dict[str, str], guides: dict[str, str]) -> Variant:
    m = v.lever.mechanism
    joints = points | guides

    def group(key: str) -> str:
        return joints.get(key) or "-".join(links[part] for part in key.split("-"))

    def choice(one):
        return (one[0], points[one[1]], points[one[2]]) if isinstance(one, tuple) else one

    zero = m.driver.zero
    if not isinstance(zero, ZeroAngle):
        zero = replace(zero, point=points.get(zero.point), link=links.get(zero.link))
    mechanism = replace(
        m,
        links={
            links[n]: replace(
                link,
                name=links[n],
                points={points[p]: at for p, at in link.points.items()},
                mass_centre=points.get(link.mass_centre),
            )
            for n, link in m.links.items()
        },
        driver=replace(m.driver, link=links[m.driver.link], zero=zero),
        guides={guides[n]: replace(g, name=guides[n], link=links[g.link]) for n, g in m.guides.items()},
        slides=tuple(replace(s, link=links[s.link], guide=guides[s.guide]) for s in m.slides),
        assembly=tuple(Assembly(group(a.key), choice(a.choice)) for a in m.assembly),
        sketch={points[p]: at for p, at in m.sketch.items()},
    )
    loads = Loads(
        v.lever.loads.gravity,
        tuple(replace(f, at=points[f.at]) for f in v.lever.loads.forces),
        tuple(replace(x, on=links[x.on]) for x in v.lever.loads.moments),
    )
    friction = Friction(
        v.lever.friction.pivots,
        v.lever.friction.guides,
        {joints[n]: r for n, r in v.lever.friction.joints.items()},
    )
    scales = v.lever.drawing.force
    scales = {group(key): x for key, x in scales.items()} if isinstance(scales, dict) else scales
    drawing = replace(v.lever.drawing, force=scales)
    press = v.lever.press and replace(v.lever.press, slider=links[v.lever.press.slider])
    translation = v.lever.translation and links[v.lever.translation]
    named = stating(
        v, mechanism=mechanism, loads=loads, friction=friction, drawing=drawing, readings={},
        press=press, translation=translation,
    )  # fmt: skip
    return replace(named, **dict.fromkeys(course.OTHERS))  # they name links by the names of before


def moved(v: Variant, angle: float, shift: complex) -> Variant:
    """The whole drawing turned about the origin and shifted, with gravity, loads, guides, words and sketch."""
    m, u = v.lever.mechanism, cmath.rect(1.0, angle)
    frame = m.links[FRAME]

    def turned(direction):
        return direction * u if isinstance(direction, complex) else direction

    zero = m.driver.zero
    if isinstance(zero, ZeroAngle):
        zero = ZeroAngle(zero.angle + angle)
    elif zero.point is not None:
        zero = replace(zero, direction=zero.direction * u)
    gear = m.driver.gear and replace(m.driver.gear, at=m.driver.gear.at + angle)
    fixed = {n: g for n, g in m.guides.items() if g.link == FRAME}
    mechanism = replace(
        m,
        links={
            **m.links,
            FRAME: replace(frame, points={p: at * u + shift for p, at in frame.points.items()}),
        },
        driver=replace(m.driver, zero=zero, gear=gear),
        guides=m.guides
        | {n: replace(g, through=g.through * u + shift, direction=g.direction * u) for n, g in fixed.items()},
        assembly=tuple(Assembly(a.key, turned(a.choice)) for a in m.assembly),
        sketch={p: at * u + shift for p, at in m.sketch.items()},
    )
    forces = []
    for f in v.lever.loads.forces:
        diagram = f.by_displacement and replace(f.by_displacement, zero=f.by_displacement.zero * u)
        stroke = f.stroke and replace(f.stroke, zero=f.stroke.zero * u)
        forces.append(replace(f, direction=turned(f.direction), by_displacement=diagram, stroke=stroke))
    loads = Loads(v.lever.loads.gravity * u, tuple(forces), v.lever.loads.moments)
    return stating(v, mechanism=mechanism, loads=loads, readings={})


@cache
def plain(v: Variant) -> Results:
    """Solved with scales that do not depend on the size of the drawing on the sheet."""
    found = unread(v)
    scales = Drawing(v.lever.drawing.accuracy, found.lever.plans.length_scale, found.lever.plans.velocity_scale,
                     found.lever.plans.acceleration_scale, v.lever.drawing.force)  # fmt: skip
    return course.solve(stating(v, readings={}, drawing=scales))


def fresh(draw, old: list[str], pool: list[str]) -> dict[str, str]:
    return dict(zip(old, draw(st.permutations(pool)), strict=False))


@few
@given(data=st.data())
def test_names_change_no_result(variant, data):
    m = variant.lever.mechanism
    points = fresh(data.draw, m.point_names, NAMES)
    links = {FRAME: FRAME} | fresh(data.draw, m.moving, [str(n) for n in range(1, 16)])
    guides = fresh(data.draw, list(m.guides), ["x", "v", "z1", "Q9"])
    before, after = unread(variant), course.solve(renamed(variant, points, links, guides))
    assert [g.kind for g in after.lever.structure.groups] == [g.kind for g in before.lever.structure.groups]
    expected, found = numbers(before), numbers(after)
    assert expected.keys() == found.keys()
    for key, value in expected.items():
        np.testing.assert_array_equal(found[key], value, err_msg=key)
    assert drawn(after) == drawn(before)


def test_a_point_may_be_called_as_the_end_of_a_bend_is():
    """k2 is the end of a Coriolis acceleration in the plan, and here also the point of link 2 under joint k."""
    variant = read("hacksaw")
    m = variant.lever.mechanism
    points = {point: "k" if point == "A" else point for point in m.point_names}
    links = {**{link: link for link in (FRAME, *m.moving)}, "3": "2", "2": "3"}
    after = course.solve(renamed(variant, points, links, {guide: guide for guide in m.guides}))
    assert drawn(after) == drawn(unread(variant))


@pytest.mark.exhaustive
@few
@given(angle=st.floats(-3, 3), x=st.floats(-0.3, 0.3), y=st.floats(-0.3, 0.3))
def test_place_of_the_drawing_changes_no_result(variant, angle, x, y):
    before = plain(variant)
    scaled = stating(variant, drawing=before.variant.lever.drawing)
    after = course.solve(moved(scaled, angle, complex(x, y)))
    expected, found = numbers(before), numbers(after)
    assert expected.keys() == found.keys()
    omega = abs(before.lever.kinematics.omega)
    for key, value in expected.items():
        alike = [np.abs(x).max() for other, x in expected.items() if other.split()[0] == key.split()[0]]
        # what is zero is rounding beside the largest of its kind, or beside what the driving link has
        size = max(*alike, {"w": omega, "e": omega**2}.get(key[0], 0.0)) or 1.0
        np.testing.assert_allclose(found[key] / size, value / size, rtol=0, atol=1e-9, err_msg=key)
    # by computer the plan is drawn exactly, so only the last digit read may differ
    for (mine, floor), (other, _) in zip(drawn(after), drawn(before), strict=True):
        assert abs(mine - other) <= 3 * floor + 1e-12
