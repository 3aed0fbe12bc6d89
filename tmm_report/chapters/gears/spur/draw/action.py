"""The centres and the line of action of a pair on its sheet; what lies beyond its edge is pointed to."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from tmm_report.chapters.gears.spur.draw.sheet import FAR, Sheet
from tmm_report.figures.dimensions import HEAD, arc_span, head, span
from tmm_report.figures.drawing import AXIS, NORMAL, THIN, Pen, dot, line

CONTACT = Pen(0.9, "green")  # the active part of the line of action
BODY = 38.0  # how far the line of centres runs into the body of a wheel, mm
ROUND = 6.0  # radius of an arrow round a centre, mm


def centres(sheet: Sheet) -> None:
    """The line of centres and the centres on it, as far as they are seen, and the radii to N1 and N2."""
    mesh = sheet.mesh
    for i in (0, 1):
        centre, name = mesh.centre(i), f"N{i + 1}"
        foot = mesh.points[name]
        if abs(centre) <= FAR:
            sheet.items += [line(0, centre, AXIS), dot(centre)]
            sheet.tag("O", sheet.names[i], centre, 1 + 0j)
        else:
            height = abs(mesh.radius(mesh.pair.d_w, i) - mesh.radius(mesh.pair.d_f, i))
            sheet.items.append(line(0, -sheet.outer(i) * sheet.up(i) * (height + BODY), AXIS))
        if mesh.seen(name):
            far = min(1.0, 1.0 if abs(centre) <= FAR else 25.0 / abs(centre - foot))
            sheet.items.append(line(foot, foot + (centre - foot) * far, THIN))


def clearance(sheet: Sheet) -> None:
    """The radial clearance at the root of the wheel below."""
    mesh, pair = sheet.mesh, sheet.mesh.pair
    i = mesh.small
    tip = mesh.centre(i) + mesh.radius(pair.d_a, i) * sheet.up(i)
    root = mesh.centre(1 - i) + mesh.radius(pair.d_f, 1 - i) * sheet.up(1 - i)
    if float(pair.clearance[i]) > 0:
        sheet.items += span(tip, root)
        sheet.tag("c", "", (tip + root) / 2, 1 + 0j, sheet.num(float(pair.clearance[i]) * 1e3))


def line_of_action(sheet: Sheet, more: Mapping[str, complex] | None = None) -> None:
    """N1N2 as far as it is seen, its active part and its points; `more`: others on it, lettered first."""
    mesh = sheet.mesh
    points, along = mesh.points, mesh.along
    places = sorted(points.values(), key=lambda z: (z * along.conjugate()).real)
    start, end = _clipped(sheet, places[0] - 4 * along), _clipped(sheet, places[-1] + 4 * along)
    sheet.items += [line(start, end, NORMAL), line(points["A"], points["B"], CONTACT)]
    normal = 1j * along
    for name, z in (more or {}).items():
        sheet.items.append(dot(z, 0.9))
        sheet.tag(name[0], name[1:], z, -normal)
    for name, z in points.items():
        if mesh.seen(name):
            sheet.items.append(dot(z, 0.75))
            sheet.tag(name[0], name[1:], z, normal if name in "ACDB" else -normal)
        else:
            _pointed_to(sheet, name, min((start, end), key=lambda edge: abs(edge - z)), z)


def _clipped(sheet: Sheet, z: complex) -> complex:
    """A point of the line of action, or where that leaves the drawing."""
    share = sheet.mesh.reach / abs(z.real) if z.real else 1.0
    return z * min(1.0, share)


def _pointed_to(sheet: Sheet, name: str, edge: complex, z: complex) -> None:
    """An arrow at the edge of the drawing with the point's name and how far from the pitch point it lies."""
    inwards = -z / abs(z)
    sheet.items.append(head(edge, HEAD * inwards))
    far = sheet.num(abs(z) / sheet.mesh.mm * 1e3)
    sheet.tag(name[0], name[1:], edge, 1j * inwards)
    sheet.tag("P" + name[0], name[1:], edge + 14 * inwards, 1j * inwards, far)


def pressure_angle(sheet: Sheet) -> None:
    """The operating pressure angle: at the centre below, or on the common tangent in the pitch point."""
    mesh = sheet.mesh
    alpha, centre = float(mesh.pair.alpha_w), mesh.centre(mesh.small)
    vertex, start, radius = centre, math.pi / 2 - alpha, max(0.4 * abs(centre), ROUND + 3)
    if abs(centre) > FAR:
        foot = max(mesh.points["N1"], mesh.points["N2"], key=abs)
        vertex, radius = 0j, 0.9 * sheet.half_width
        start = math.pi - alpha if foot.real < 0 else -alpha
        sheet.items.append(line(0, math.copysign(radius + 3, foot.real), THIN))
    sheet.items += arc_span(vertex, radius, start, start + alpha)
    middle = vertex + cmath.rect(radius, start + alpha / 2)
    sheet.tag("α", "w", middle, (middle - vertex) / radius, f"{sheet.num(math.degrees(alpha))}°")
