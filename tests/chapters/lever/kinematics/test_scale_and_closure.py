"""Every ready variant: its joints meet all round, and its size (micrometres, kilometres) changes no digit."""

from dataclasses import replace

import numpy as np
import pytest

from tmm_report.chapters.lever.kinematics.solve import positions as kinematics
from tmm_report.chapters.lever.structure import solve as structure
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.forces import reactions as statics


def scaled(m, factor: float):
    """The mechanism `factor` times as large, of the same masses."""
    links = {
        name: replace(
            link,
            points={p: at * factor for p, at in link.points.items()},
            inertia=link.inertia * factor**2,
        )
        for name, link in m.links.items()
    }
    return replace(
        m,
        links=links,
        guides={n: replace(g, through=g.through * factor) for n, g in m.guides.items()},
        slides=tuple(replace(s, through=s.through * factor) for s in m.slides),
        sketch={p: at * factor for p, at in m.sketch.items()},
    )


def size_of(m) -> float:
    """The largest length of a link, m."""
    places = [np.array([*link.points.values()]) for link in m.links.values() if link.points]
    return max(float(np.abs(at[:, None] - at).max()) for at in places)


def test_joints_meet_all_round(results):
    m, s = results.variant.lever.mechanism, results.lever.kinematics.diagram.state
    worst = 0.0
    for point in m.point_names:
        places = [s.world(link, m.links[link].points[point]) for link in m.links_at(point)]
        worst = max([worst, *(np.nanmax(np.abs(place - places[0])) for place in places)])
    for slide in m.slides:
        guide = m.guides[slide.guide]
        gap = s.world(slide.link, slide.through) - s.world(guide.link, guide.through)
        worst = max(worst, np.nanmax(np.abs(cross(s.u[guide.link] * guide.direction, gap))))
    assert worst < 1e-13 * size_of(m)


@pytest.mark.parametrize("factor", [1e-6, 1e3])  # a metre becomes a micrometre, a kilometre
def test_size_changes_no_digit(results, factor):
    usual = results.lever.kinematics.diagram
    other = kinematics.solve(
        results.variant.lever.positions, structure.solve(scaled(results.variant.lever.mechanism, factor))
    ).diagram
    assert other.linkage.structure.formula == usual.linkage.structure.formula
    digits = 1e-11 / min(1.0, *(np.nanmin(sine) for sine in usual.sines.values()))
    for values in ("places", "velocities", "accelerations"):
        expected = getattr(usual, values)
        size = np.nanmax(np.abs(expected))
        found = getattr(other, values) / factor / size
        np.testing.assert_allclose(found, expected / size, rtol=0, atol=digits)
    forces = [statics.solve(x, statics.inertia_and_gravity(x, 0j)).balancing for x in (usual, other)]
    size = np.nanmax(np.abs(forces[0]), initial=1e-300)
    found = forces[1] / factor**2 / size
    np.testing.assert_allclose(found, forces[0] / size, rtol=0, atol=10 * digits)
