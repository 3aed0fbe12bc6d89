"""Two pairs of teeth in contact, and how the point of one profile that touches a point of the other is found."""

from __future__ import annotations

import cmath
from dataclasses import replace

import numpy as np

from tmm_report.chapters.gears.spur.draw.action import centres, line_of_action
from tmm_report.chapters.gears.spur.draw.sheet import ACTIVE, Num, Sheet, circles, teeth, turning
from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.chapters.gears.spur.solve.phase import Phase
from tmm_report.figures.drawing import DASHED, Arc, Drawing, dot


def phase_drawing(mesh: Mesh, phase: Phase, names: tuple[str, str], num: Num, title: str = "") -> Drawing:
    """The pair where it touches in K1 and K2; t1 and t2, the conjugate points that will touch in T."""
    ways = {name: rho - mesh.places["P"] for name, rho in phase.points.items()}
    following = next(k for k in (-1, 1) if _touches(mesh, 0, ways, k))
    sheet = Sheet(mesh, names, num, ways["K1"], (min(-1, 2 * following), max(1, 2 * following)))
    for i in (0, 1):
        circles(sheet, i)
        teeth(sheet, i)
    centres(sheet)
    at = {name: mesh.length(way) * mesh.along for name, way in ways.items()}
    for i in (0, 1):
        _conjugate(sheet, i, float(phase.radii[i][-1]), at["T"])
    line_of_action(sheet, at)
    return Drawing(tuple(sheet.items), title, moves=turning(sheet)).labelled(sheet.tags)


def _touches(mesh: Mesh, i: int, ways: dict[str, float], tooth: int) -> bool:
    """Whether a tooth of wheel i is in contact in K2 when tooth 0 is in K1."""
    at = mesh.length(ways["K2"]) * mesh.along
    radius = np.array([abs(at - mesh.centre(i)) / mesh.mm])
    return bool(abs(mesh.flank(i, radius, ways["K1"], tooth)[0] - at) < 0.05)


def _conjugate(sheet: Sheet, i: int, radius: float, touch: complex) -> None:
    """The point of a profile at `radius`, m, and the arc about the centre of its wheel on which it goes to `touch`."""
    mesh = sheet.mesh
    point = complex(mesh.flank(i, np.array([radius]), sheet.way)[0])
    start, end = (cmath.phase(z - mesh.centre(i)) for z in (point, touch))
    end = start + (end - start + np.pi) % (2 * np.pi) - np.pi
    pen = replace(DASHED, colour=ACTIVE[i].colour)
    sheet.items += [Arc(mesh.centre(i), mesh.length(radius), start, float(end), pen), dot(point, 0.9)]
    sheet.tag("t", str(i + 1), point, (point - touch) / max(abs(point - touch), 1e-9))
