"""Schemes of the notes: groups apart at the scale that they state, working strokes where the positions say."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterator
from itertools import combinations

import numpy as np
import pytest
from captions import figures
from conftest import solved
from reading import LEVERS, drawings, html, wrong

from tmm_report.chapters.lever.kinematics.solve.working_stroke import working_of
from tmm_report.course import LeverFound
from tmm_report.figures.drawing import THICK, Arc, Drawing, Path
from tmm_report.figures.schemes.strokes import BAND
from tmm_report.mechanics.lever.mechanism import FRAME


def lever(name: str) -> LeverFound:
    found = solved(name).lever
    assert found is not None
    return found


def bars(drawing: Drawing) -> list[float]:
    """Lengths of the thick bars, mm."""
    lines = [item.strokes[0] for item in drawing.items if isinstance(item, Path) and item.pen == THICK]
    return [abs(line[1] - line[0]) for line in lines if len(line) == 2]


def arms(found: LeverFound) -> list[float]:
    """Between any two joints of the driving link, m; none for a cam."""
    mechanism = found.given.mechanism
    points = {} if mechanism.cams else mechanism.links[mechanism.driver.link].points
    joints = [complex(z) for p, z in points.items() if len(mechanism.links_at(p)) > 1]
    return [abs(one - other) for one, other in combinations(joints, 2)]


@pytest.mark.parametrize("depth", ["full", "short"])
@pytest.mark.parametrize("name", LEVERS)
def test_the_driving_link_apart_is_at_the_scale_of_its_figure(name, depth):
    """It is the link that stands alone among the groups, a bar from joint to joint."""
    told = re.compile("structural groups|структурные группы")
    stated = [one for one in figures(html(name, depth=depth), "μ_l") if told.search(one[1])]
    lengths = [length / mu for length in arms(lever(name)) for _, _, mu in stated]
    drawn = [bar for anchor, _, _ in stated for bar in bars(drawings(name, depth)[anchor])]
    missing = [mm for mm in lengths if all(abs(bar - mm) > 0.01 for bar in drawn)]
    wrong([f"no bar of {lengths} mm among {drawn}"] if lengths and len(missing) == len(lengths) else [])


def within(arc: Arc, direction: float) -> bool:
    """Whether a direction, rad, meets an arc; the arrowhead, of 2.5 mm, reaches over its end by 0.7 of its length."""
    sense = math.copysign(1.0, arc.end - arc.start)
    reach = abs(arc.end - arc.start) + 0.7 * 2.5 / arc.radius
    return (sense * (direction - arc.start) + 1e-5) % (2 * math.pi) <= reach + 2e-5


def wrong_strokes(name: str, drawing: Drawing) -> Iterator[str]:
    found = lever(name)
    table, count = found.kinematics.table, found.kinematics.distinct
    mechanism = found.given.mechanism
    points = mechanism.links[mechanism.driver.link].points
    fixed = next(p for p in points if p in mechanism.links[FRAME].points)
    far = max(
        (p for p in points if len(mechanism.links_at(p)) > 1), key=lambda p: abs(points[p] - points[fixed])
    )
    places = np.broadcast_to(table.place(far) - table.place(fixed), table.shape)
    directions = [cmath.phase(complex(z)) for z in places[:count]]
    drawn = [item for item in drawing.items if isinstance(item, Arc) and item.pen == BAND]
    strokes = list(working_of(found).values())
    if len(drawn) != len(strokes):
        yield f"{len(drawn)} arcs for {len(strokes)} working strokes"
    for arc, stroke in zip(drawn, strokes, strict=False):
        seen = {k for k, direction in enumerate(directions) if within(arc, direction)}
        if seen != {k % count for k in stroke.positions}:
            yield f"the stroke of {stroke.output} goes over {sorted(seen)}, by its positions {stroke.positions}"


def swings(name: str) -> bool:
    """Whether the driving link moves by a law there and back: arcs of its angles would lie over one another."""
    driver = lever(name).given.mechanism.driver
    return driver.law is not None and not driver.goes_round


@pytest.mark.parametrize("name", LEVERS)
def test_working_strokes_go_over_their_positions(name):
    anchors = [
        anchor
        for anchor, caption, _ in figures(html(name), "μ_l")
        if "12" in caption or "полож" in caption.lower()
    ]
    with_arcs = [
        drawings(name)[a]
        for a in anchors
        if a in drawings(name) and any(isinstance(i, Arc) and i.pen == BAND for i in drawings(name)[a].items)
    ]
    strokes = working_of(lever(name))
    wrong(
        [text for drawing in with_arcs for text in wrong_strokes(name, drawing)]
        if with_arcs or not strokes or swings(name)
        else ["no arcs"]
    )
