"""A pair of wheels in mesh: three pairs of teeth, the line of action, the arcs of contact, circles and dimensions."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

from tmm_report.chapters.gears.spur.draw.action import (
    ROUND,
    centres,
    clearance,
    line_of_action,
    pressure_angle,
)
from tmm_report.chapters.gears.spur.draw.sheet import FAR, Num, Sheet, between, circles, teeth
from tmm_report.chapters.gears.spur.draw.sheet import turning as moving
from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.figures.dimensions import arc_span, span
from tmm_report.figures.drawing import DASHED, NORMAL, THIN, Arc, Drawing, Pen, line, polyline
from tmm_report.figures.schemes.marks import turning

ARC = (Pen(0.8, "blue"), Pen(0.8, "red"))
INTO = (10.0, 20.0, 30.0)  # under the root circle: angle of a tooth, of contact, arrow of rotation, mm


def mesh_drawing(mesh: Mesh, names: tuple[str, str], num: Num, title: str = "") -> Drawing:
    """The pair with three pairs of teeth in mesh, one of them touching in the pitch point."""
    sheet = Sheet(mesh, names, num)
    for i in (0, 1):
        circles(sheet, i)
        teeth(sheet, i)
        _contact_arc(sheet, i)
        _dimensions(sheet, i)
        _rotation(sheet, i)
    centres(sheet)
    clearance(sheet)
    line_of_action(sheet)
    pressure_angle(sheet)
    return Drawing(tuple(sheet.items), title, moves=moving(sheet)).labelled(sheet.tags)


def _contact_arc(sheet: Sheet, i: int) -> None:
    """Flanks at the beginning and the end of contact, the arc of the working circle between them and its angle."""
    mesh = sheet.mesh
    ends = []
    for end in "AB":
        place = mesh.place(end)
        radii = between(mesh.wheels[i].junction, mesh.wheels[i].tip)
        sheet.items.append(
            polyline(map(complex, mesh.flank(i, radii, place)), replace(DASHED, colour=ARC[i].colour))
        )
        ends.append(sheet.angle(i, mesh.on_working_circle(i, place)))
    radius, turn = mesh.radius(mesh.pair.d_w, i), cmath.phase(sheet.up(i))
    low, high = sorted(ends)
    sheet.items.append(Arc(mesh.centre(i), radius, turn + low, turn + high, ARC[i]))
    value = math.degrees(float(mesh.pair.eps) * mesh.wheels[i].pitch_angle)
    _angle(sheet, i, low, high, INTO[1], ("φ", "γ" + sheet.names[i], f"{sheet.num(value)}°"))


def _angle(sheet: Sheet, i: int, low: float, high: float, into: float, label: tuple[str, str, str]) -> None:
    """An angle at the centre of a wheel, shown by radii from the working circle to an arc in the body of the wheel."""
    mesh, out = sheet.mesh, sheet.outer(i)
    working, arc = mesh.radius(mesh.pair.d_w, i), mesh.radius(mesh.pair.d_f, i) - out * into
    for angle in (low, high):
        sheet.items.append(line(sheet.at(i, working, angle), sheet.at(i, arc - 2 * out, angle), THIN))
    _arc_arrows(sheet, i, arc, low, high)
    base, sub, value = label
    middle = sheet.at(i, arc, (low + high) / 2)
    sheet.tag(base, sub, middle, -out * sheet.up(i), value)


def _arc_arrows(sheet: Sheet, i: int, radius: float, low: float, high: float) -> None:
    turn = cmath.phase(sheet.up(i))
    sheet.items += arc_span(sheet.mesh.centre(i), radius, turn + low, turn + high)


# --- dimensions ---


def _dimensions(sheet: Sheet, i: int) -> None:
    """Height and pitch of the teeth, thickness on the pitch circle, angle of a tooth, sense of rotation."""
    mesh, pair, name = sheet.mesh, sheet.mesh.pair, sheet.names[i]
    tip, root = mesh.radius(pair.d_a, i), mesh.radius(pair.d_f, i)
    free = 1 if i == mesh.small else -1  # the side opposite to the labels of the circles
    edge = 0.97 * _towards_side(sheet, i, max(tip, root), free)
    into = -sheet.outer(i) * sheet.up(i)
    sheet.items += span(sheet.at(i, tip, edge), sheet.at(i, root, edge))
    sheet.tag("h", name, sheet.at(i, root, edge), into - free / 2, sheet.num(float(pair.height[i]) * 1e3))
    _thickness(sheet, i, -free)
    flanks = sorted(sheet.angle(i, mesh.on_working_circle(i, tooth=k)) for k in (0, 1))
    _angle(
        sheet,
        i,
        flanks[0],
        flanks[1],
        INTO[0],
        ("τ", name, f"{sheet.num(math.degrees(mesh.wheels[i].pitch_angle))}°"),
    )


def _towards_side(sheet: Sheet, i: int, radius: float, side: int) -> float:
    """Angle of the end of a circle on the right (+1) or left (−1) of the sheet, rad."""
    half = sheet.side(i, radius)
    return max((half, -half), key=lambda angle: side * sheet.at(i, radius, angle).real)


def _thickness(sheet: Sheet, i: int, side: int) -> None:
    """Thickness along the pitch circle of the outermost tooth on the left (−1) or right (+1)."""
    mesh, pair = sheet.mesh, sheet.mesh.pair
    radius, wheel = mesh.radius(pair.d, i), mesh.wheels[i]
    if not wheel.base < float(pair.d[i]) / 2 < max(wheel.tip, wheel.root):
        return
    half = float(pair.s[i] / pair.d[i])
    turn = mesh.turn(i) - cmath.phase(sheet.up(i))
    three = [turn + k * wheel.pitch_angle for k in ((0, 1) if wheel.internal else (-1, 0, 1))]
    middle = max(three, key=lambda angle: side * sheet.at(i, radius, angle).real)
    _arc_arrows(sheet, i, radius, middle - half, middle + half)
    into = -sheet.outer(i) * sheet.up(i)
    sheet.tag("s", sheet.names[i], sheet.at(i, radius, middle), into, sheet.num(float(pair.s[i]) * 1e3))


def _rotation(sheet: Sheet, i: int) -> None:
    """The sense of rotation: round the centre where that is seen, else in the body of the wheel."""
    mesh = sheet.mesh
    sense = mesh.sense * (1 if i == mesh.small or mesh.pair.internal else -1)
    radius, middle, sweep = ROUND, -math.pi / 2, 2.4
    if abs(mesh.centre(i)) > FAR:
        radius = mesh.radius(mesh.pair.d_f, i) - sheet.outer(i) * INTO[2]
        middle, sweep = cmath.phase(sheet.up(i)), 16 / radius
    sheet.items += turning(mesh.centre(i), radius, middle - sense * sweep / 2, sense * sweep, NORMAL)
    away = cmath.exp(1j * middle)
    sheet.tag("ω", sheet.names[i], mesh.centre(i) + radius * away, away)
