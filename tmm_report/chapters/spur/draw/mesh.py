"""A pair of wheels in mesh: three pairs of teeth, the line of action, the arcs of contact, circles and dimensions.

All places come from `Mesh` in millimetres of paper, the pitch point at 0.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tmm_report.chapters.spur.mesh import Mesh
from tmm_report.figures.dimensions import arc_span, span, spread
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THIN,
    Arc,
    Drawing,
    Item,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.figures.marks import turning

Array = Any
Num = Callable[[float], str]

TEETH = Pen(0.5)
ACTIVE = (Pen(1.0, "blue"), Pen(1.0, "red"))  # working flanks of wheels 1 and 2
CONTACT = Pen(0.9, "green")  # the active part of the line of action
ARC = (Pen(0.8, "blue"), Pen(0.8, "red"))
SMALL = 2.8  # height of the lettering of dimensions, mm
LETTER = 4.3  # mm between the lines of a column of labels
EDGE = 1.0  # how far circles run past the teeth, mm
INTO = (9.0, 17.0, 25.0)  # under the root circle: angle of a tooth, of contact, arrow of rotation, mm
ROUND = 6.0  # radius of an arrow round a centre, mm
FAR = 95.0  # a centre farther than this from the pitch point is not drawn, mm


@dataclass
class Sheet:
    """What is drawn so far. `names`: numbers of the wheels; `num` prints a length in mm or an angle in degrees."""

    mesh: Mesh
    names: tuple[str, str]
    num: Num
    items: list[Item] = field(default_factory=list)
    tags: list[Tag] = field(default_factory=list)

    @property
    def half_width(self) -> float:
        return EDGE + self.mesh.length(1.5 * float(self.mesh.pair.p_w))

    def outer(self, i: int) -> int:
        """−1 for a ring, whose metal lies beyond its root circle."""
        return -1 if self.mesh.wheels[i].internal else 1

    def up(self, i: int) -> complex:
        """From the centre of a wheel to the pitch point."""
        return -self.mesh.centre(i) / abs(self.mesh.centre(i))

    def at(self, i: int, radius: float, angle: float) -> complex:
        """On a circle of wheel i, `angle` counter-clockwise from the pitch point, rad."""
        return self.mesh.centre(i) + radius * self.up(i) * cmath.exp(1j * angle)

    def angle(self, i: int, z: complex) -> float:
        return cmath.phase((z - self.mesh.centre(i)) / self.up(i))

    def side(self, i: int, radius: float) -> float:
        """Half the angle of a circle that keeps within the width of the sheet, rad."""
        return math.asin(min(0.95, self.half_width / radius))

    def tag(
        self, base: str, sub: str, at: complex, prefer: complex = 0j, value: str = "", colour: str = "black"
    ) -> None:
        parts: Parts = (Symbol(base, sub), f" = {value}") if value else (Symbol(base, sub),)
        self.tags.append(Tag(parts, (at,), prefer=prefer, size=SMALL, gap=0.8, colour=colour))


def mesh_drawing(mesh: Mesh, names: tuple[str, str], num: Num, title: str = "") -> Drawing:
    """The pair with three pairs of teeth in mesh, one of them touching in the pitch point."""
    sheet = Sheet(mesh, names, num)
    for i in (0, 1):
        _circles(sheet, i)
        _teeth(sheet, i)
        _contact_arc(sheet, i)
        _dimensions(sheet, i)
        _rotation(sheet, i)
    _centres(sheet)
    _line_of_action(sheet)
    drawn = Drawing(tuple(sheet.items), title).labelled(sheet.tags)
    return replace(drawn, items=tuple(_plated(drawn.items)))


def _plated(items: Sequence[Item]) -> Iterator[Item]:
    """Lines are broken at the lettering of a dimension: there is a white plate under every number."""
    yield from (item for item in items if not isinstance(item, Text))
    for text in (item for item in items if isinstance(item, Text)):
        if len(text.parts) > 1:
            x0, y0, x1, y1 = text.box
            corners = (complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1))
            yield polygon(corners, None, "white", 0.8)
        yield text


# --- circles ---


def _circles(sheet: Sheet, i: int) -> None:
    """Tip, working, pitch, base and root circles, lettered in a column: on the left for the wheel below."""
    pair, name = sheet.mesh.pair, sheet.names[i]
    rows = [
        ("a", pair.d_a, THIN),
        ("w", pair.d_w, AXIS),
        ("", pair.d, AXIS),
        ("b", pair.d_b, THIN),
        ("f", pair.d_f, THIN),
    ]
    column = []
    for index, diameters, pen in rows:
        radius = sheet.mesh.radius(diameters, i)
        if index == "" and abs(radius - sheet.mesh.radius(pair.d_w, i)) < 0.2:
            continue  # the working circle is the pitch circle
        half = sheet.side(i, radius)
        middle = cmath.phase(sheet.up(i))
        sheet.items.append(Arc(sheet.mesh.centre(i), radius, middle - half, middle + half, pen))
        left = -1 if i == sheet.mesh.small else 1
        end = max((sheet.at(i, radius, turn * half) for turn in (-1, 1)), key=lambda z: left * z.real)
        column.append((end, (Symbol("r", index + name), f" = {sheet.num(float(diameters[i]) / 2 * 1e3)}")))
    _column(sheet, column, -1 if i == sheet.mesh.small else 1)


def _column(sheet: Sheet, rows: Sequence[tuple[complex, Parts]], side: int) -> None:
    """Labels beside the ends of circles, spread so far that none covers another, each with its leader."""
    rows = sorted(rows, key=lambda row: row[0].imag)
    heights = spread([end.imag for end, _ in rows], LETTER)
    edge = side * (sheet.half_width + 3.5)
    for (end, parts), y in zip(rows, heights, strict=True):
        sheet.items.append(polyline((end, complex(edge, y)), THIN))
        sheet.items.append(Text(complex(edge + side, y), parts, SMALL, 1 if side < 0 else -1))


# --- teeth ---


def _teeth(sheet: Sheet, i: int) -> None:
    """Three teeth of a wheel (of a ring, the teeth round three spaces), their working flanks thick."""
    mesh, wheel = sheet.mesh, sheet.mesh.wheels[i]
    outline, count = mesh.outline(i), len(wheel.outline) // wheel.z
    sheet.items.append(
        polyline(map(complex, np.take(outline, range(-count, 2 * count + 1), mode="wrap")), TEETH)
    )
    for tooth in (-1, 0, 1):
        flank = mesh.flank(i, _between(*_active_radii(mesh, i)), tooth=tooth)
        sheet.items.append(polyline(map(complex, flank), ACTIVE[i]))


def _between(start: float, end: float) -> Array:
    return np.linspace(start, end, 24)


def _active_radii(mesh: Mesh, i: int) -> tuple[float, float]:
    """Radii between which the flank of a wheel touches the other, m."""
    rho = [abs(mesh.points[end] - mesh.points[f"N{i + 1}"]) / mesh.mm for end in "AB"]
    return tuple(math.hypot(mesh.wheels[i].base, r) for r in rho)  # type: ignore[return-value]


def _contact_arc(sheet: Sheet, i: int) -> None:
    """Flanks at the beginning and the end of contact, the arc of the working circle between them and its angle."""
    mesh = sheet.mesh
    ends = []
    for end in "AB":
        place = mesh.place(end)
        radii = _between(mesh.wheels[i].junction, mesh.wheels[i].tip)
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
    teeth = [turn + k * wheel.pitch_angle for k in ((0, 1) if wheel.internal else (-1, 0, 1))]
    middle = max(teeth, key=lambda angle: side * sheet.at(i, radius, angle).real)
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


# --- centres and the line of action ---


def _centres(sheet: Sheet) -> None:
    """The line of centres and the centres on it, as far as they are seen, and the radii to N1 and N2."""
    mesh = sheet.mesh
    for i in (0, 1):
        centre, foot = mesh.centre(i), mesh.points[f"N{i + 1}"]
        name = sheet.names[i]
        seen = abs(centre) <= FAR
        if seen:
            sheet.items += [line(0, centre, AXIS), line(centre, foot, THIN), dot(centre)]
            sheet.tag("O", name, centre, 1 + 0j)
            continue
        height = abs(mesh.radius(mesh.pair.d_w, i) - mesh.radius(mesh.pair.d_f, i))
        end = -sheet.outer(i) * sheet.up(i) * (height + INTO[2] + 8)
        short = foot + (centre - foot) * min(1.0, 25.0 / abs(centre - foot))
        sheet.items += [line(0, end, AXIS), line(foot, short, THIN)]
    _clearance(sheet)


def _clearance(sheet: Sheet) -> None:
    mesh, pair = sheet.mesh, sheet.mesh.pair
    i = mesh.small
    tip = mesh.centre(i) + mesh.radius(pair.d_a, i) * sheet.up(i)
    root = mesh.centre(1 - i) + mesh.radius(pair.d_f, 1 - i) * sheet.up(1 - i)
    if float(pair.clearance[i]) > 0:
        sheet.items += span(tip, root)
        sheet.tag("c", "", (tip + root) / 2, 1 + 0j, sheet.num(float(pair.clearance[i]) * 1e3))


def _line_of_action(sheet: Sheet) -> None:
    mesh = sheet.mesh
    points, along = mesh.points, mesh.along
    places = sorted(points.values(), key=lambda z: (z * along.conjugate()).real)
    sheet.items += [
        line(places[0] - 4 * along, places[-1] + 4 * along, NORMAL),
        line(points["A"], points["B"], CONTACT),
    ]
    _pressure_angle(sheet)
    normal = 1j * along
    for name, z in points.items():
        sheet.items.append(dot(z, 0.75))
        sheet.tag(name[0], name[1:], z, normal if name in "ACDB" else -normal)


def _pressure_angle(sheet: Sheet) -> None:
    """The operating pressure angle: at the centre below, or on the common tangent in the pitch point."""
    mesh = sheet.mesh
    alpha, centre = float(mesh.pair.alpha_w), mesh.centre(mesh.small)
    body = mesh.radius(mesh.pair.d_f, mesh.small) - INTO[1]
    vertex, start, radius = centre, math.pi / 2 - alpha, max(0.4 * body, ROUND + 3)
    if abs(centre) > FAR:
        foot = max(mesh.points["N1"], mesh.points["N2"], key=abs)
        vertex, radius = 0j, max(0.78 * abs(foot), 0.6 * sheet.half_width)
        start = math.pi - alpha if foot.real < 0 else -alpha
        sheet.items.append(line(0, math.copysign(radius + 3, foot.real), THIN))
    sheet.items += arc_span(vertex, radius, start, start + alpha)
    middle = vertex + cmath.rect(radius, start + alpha / 2)
    sheet.tag("α", "w", middle, (middle - vertex) / radius, f"{sheet.num(math.degrees(alpha))}°")
