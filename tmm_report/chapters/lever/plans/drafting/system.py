"""A group above class II in a plan: constructed through a special point where that can be, else all its vector
equations are solved together, and the plan is drawn from that.

Every branch leads from one joint to the next, z_end = z_start + bend + x·direction, where x is the angular rate of its
link or the sliding rate along its guide. Where two branches end in one point a contour closes: two linear equations.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.plans.drafting import special
from tmm_report.chapters.lever.plans.drafting.branch import (
    Line,
    angular,
    bend,
    bends,
    close,
    coinciding,
    length,
    line_from,
    rate_key,
    terms,
)
from tmm_report.chapters.lever.plans.drafting.lead import similar
from tmm_report.chapters.lever.plans.drafting.plan import Projections, Special, Step
from tmm_report.chapters.lever.plans.drafting.sheet import Image, Sheet
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.vector_equations import Branch, System, turns_with
from tmm_report.quantity.formula import Formula, Term, VectorEquation
from tmm_report.quantity.written import segment_of
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class _Way:
    """A branch on the scheme: world place of its start, m, and its arm, m, or its guide's direction."""

    branch: Branch
    place: complex
    arm: complex


def step(sheet: Sheet, system: System) -> Step:
    """Draw a group's part of the plan."""
    before = _known(sheet, system)
    vertices = [point for point in system.vertices if not sheet.has(point)]
    ways = [_way(sheet, system, branch) for branch in system.branches]
    projections, constructed, ready = _found(sheet, system, ways)
    lines = []
    for way in ways:
        line, formulas = ready.get(way.branch) or _line(sheet, way)
        lines.append(line)
        before += formulas + _known_rate(sheet, system, line)
    after = [sheet.read_point(point) for point in vertices]
    for line in lines:
        after += close(sheet, line, sheet.vertices[sheet.letter(line.branch.end)])
    after += _rates(sheet, system, lines)
    _place_links(sheet, system, lines)
    points = [f for link in system.group.links for f in similar(sheet, link, lines)]
    return Step(
        system.group.group, tuple(vertices), tuple(_equations(sheet, system, vertices)), tuple(before),
        tuple(after), tuple(points), projections, constructed,
    )  # fmt: skip


Ready = dict[Branch, tuple[Line, list[Formula]]]


def _found(
    sheet: Sheet, system: System, ways: list[_Way]
) -> tuple[Projections | None, Special | None, Ready]:
    """Letter the vertices: constructed through a special point, or put where the equations say. Of a construction also
    the lines that are drawn already."""
    of = {way.branch: way for way in ways}
    found = special.basis(sheet, system, {branch: way.arm for branch, way in of.items()})
    if found is None:
        return _solve(sheet, system, ways), None, {}
    ready = {leg.branch: _line(sheet, of[leg.branch]) for leg in found.legs if not leg.on_basis}
    return None, special.construct(sheet, found, ready), ready


# ---------------------------------------------------------------- the scheme


def _pairs(system: System) -> tuple[Pair, ...]:
    return (*system.group.group.outer, *system.group.group.inner)


def _known(sheet: Sheet, system: System) -> list[Formula]:
    """What is known before the group is solved: links that turn as known ones do, fixed points, and points of known
    links that coincide with a joint of the group."""
    for link, source in turns_with(system.group).items():
        if source is not None and source not in system.group.links:
            sheet.alike[link] = source
    for point in sheet.linkage.mechanism.links[FRAME].points:
        sheet.letters[point] = sheet.pole
    found = []
    for branch in system.branches:
        if not branch.turns and branch.link not in system.group.links:
            found += coinciding(sheet, branch, branch.link, sheet.place(branch.end))
    return found


def _way(sheet: Sheet, system: System, branch: Branch) -> _Way:
    if branch.arm is not None:
        start, end = (sheet.place(joint) for joint in branch.arm)
        return _Way(branch, start, sheet.drawn(end - start, "".join(branch.arm)))
    pair = next(p for p in _pairs(system) if p.name == branch.guide and branch.link in p.links)
    along = complex(np.ravel(sheet.motion.state.u[branch.link] * pair.along[branch.link])[0])
    return _Way(branch, sheet.place(branch.end), along)


# ---------------------------------------------------------------- the equations solved


def _solve(sheet: Sheet, system: System, ways: list[_Way]) -> Projections:
    """Rates that close the contours; the vertices are lettered where they put them."""
    unknown = _unknown(sheet, system, ways)
    reached, closing = _walk(sheet, system, ways, list(unknown))
    rows = [
        (point, axis, part(gap)) for point, gap in closing for axis, part in (("x", np.real), ("y", np.imag))
    ]
    A = np.array([row[1:] for *_, row in rows])
    right = -np.array([row[0] for *_, row in rows])
    # moments of arms and cosines of guides differ by orders of magnitude: columns are brought to one size
    size = np.linalg.norm(A, axis=0)
    x = np.linalg.solve(A / size, right) / size
    for point, form in reached.items():
        sheet.absolute(point, sheet.pen.place(complex(form @ np.array([1.0, *x])) / sheet.scale))
    table = tuple((p, axis, tuple(map(float, row[1:])), -float(row[0])) for p, axis, row in rows)
    return Projections(tuple(unknown.values()), table, tuple(map(float, x)))


def _unknown(sheet: Sheet, system: System, ways: list[_Way]) -> dict[str, str]:
    """Links whose rotation is unknown, of those that turn alike the first, and guides -> key of the rate."""
    letter = "w" if sheet.kind == "v" else "e"
    links = {link: f"{letter}_{link}" for link, source in turns_with(system.group).items() if source is None}
    return links | {way.branch.pair: rate_key(sheet, way.branch) for way in ways if not way.branch.turns}


def _root(system: System, link: str) -> str:
    """The link of the group that turns alike and is the first to do so, or a known link."""
    sources = turns_with(system.group)
    while sources.get(link) is not None:
        link = str(sources[link])
    return link


def _walk(
    sheet: Sheet, system: System, ways: list[_Way], names: list[str]
) -> tuple[dict[str, Array], list[tuple[str, Array]]]:
    """Points reached branch by branch, and the contours that close there.

    A point is a row: its known velocity or acceleration, then the coefficients of the unknown rates; complex, SI.
    """
    reached: dict[str, Array] = {}
    closing = []
    waiting = list(ways)
    while waiting:
        way = next(w for w in waiting if _place_of(sheet, w.branch.start, reached, names) is not None)
        waiting.remove(way)
        end = _place_of(sheet, way.branch.start, reached, names) + _own(sheet, system, way, names)
        known = _place_of(sheet, way.branch.end, reached, names)
        if known is None:
            reached[way.branch.end] = end
        else:
            closing.append((way.branch.end, end - known))
    return reached, closing


def _place_of(sheet: Sheet, point: str | None, reached: dict[str, Array], names: list[str]) -> Array:
    """A point's row: reached, drawn before, or fixed; None where it is not known yet."""
    if point in reached:
        return reached[point]
    if point is not None and not sheet.has(point):
        return None
    z = sheet.vertices[sheet.letter(point)] if point else 0j
    return np.array([z * sheet.scale, *[0j] * len(names)])


def _own(sheet: Sheet, system: System, way: _Way, names: list[str]) -> Array:
    """What a branch adds to its start."""
    row = np.zeros(1 + len(names), dtype=complex)
    root = _root(system, way.branch.link)
    if way.branch.turns and root not in names:  # turns as a known link does
        row[0] = sheet.images[root].turn * sheet.scale * way.arm
        return row
    name, direction = (root, 1j * way.arm) if way.branch.turns else (way.branch.pair, way.arm)
    row[1 + names.index(name)] = direction
    if bends(sheet, way.branch):
        row[0] = bend(sheet, way.branch, way.arm)
    return row


# ---------------------------------------------------------------- the plan drawn


def _line(sheet: Sheet, way: _Way) -> tuple[Line, list[Formula]]:
    start = way.branch.start
    z = sheet.vertices[sheet.letter(start)] if start else 0j
    return line_from(sheet, way.branch, way.place, way.arm, z)


def _known_rate(sheet: Sheet, system: System, line: Line) -> list[Formula]:
    """Relative velocity or tangential acceleration in a link that turns as a known one does, and its segment."""
    branch = line.branch
    if not _turns_as_known(sheet, system, branch):
        return []
    key, source = rate_key(sheet, branch), sheet.rate(branch.link)
    if sheet.values[source] == 0:
        sheet.nothing(key)
        return []
    rate = sheet.number(source, sheet.values[source])
    value = sheet.write(key, rate * length(sheet, branch, line.arm))
    ends = sheet.laid[key] = line.letter + sheet.letter(branch.end)
    laid = sheet.worked.laid_off(segment_of(ends), sheet.number(key, value.written) / sheet.mu)
    sheet.segment(line.letter, sheet.letter(branch.end))
    return [value, laid]


def _turns_as_known(sheet: Sheet, system: System, branch: Branch) -> bool:
    return branch.turns and _known_root(system, branch.link) and branch.link in sheet.turning


def _rates(sheet: Sheet, system: System, lines: list[Line]) -> list[Formula]:
    """Angular rates, one for all links that turn alike."""
    found = []
    measured: dict[str, str] = {}
    for line in lines:
        root = _root(system, line.branch.link)
        if line.branch.turns and root in system.group.links and root not in measured:
            measured[root] = line.branch.link
            found += angular(sheet, line)
    for link in system.group.links:
        source = measured.get(_root(system, link), link)
        if source != link:
            sheet.alike[link] = source
    return found


def _place_links(sheet: Sheet, system: System, lines: list[Line]) -> None:
    """Images of the links: those with two joints drawn, then those that turn as they do."""
    for line in lines:
        if line.branch.turns and line.branch.link in sheet.turning and line.branch.link not in sheet.images:
            z = sheet.vertices[sheet.letter(line.branch.end)]
            sheet.images[line.branch.link] = Image(line.z_start, line.place, (z - line.z_start) / line.arm)
    for link in system.group.links:
        point = next((p for p in sheet.linkage.mechanism.links[link].points if sheet.has(p)), None)
        if link not in sheet.images and point is not None:
            z = sheet.vertices[sheet.letter(point)]
            turn = sheet.images[sheet.alike[link]].turn
            sheet.images[link] = Image(z, sheet.place(point), turn)


def _equations(sheet: Sheet, system: System, found: list[str]) -> list[VectorEquation]:
    """One equation a point: as many sides as branches end there, the point's own vector first. `found`: points that are
    not known before."""
    equations = []
    for point in system.vertices:
        sides = {b: _side(sheet, system, b, found) for b in system.branches if b.end == point}
        own = next((b for b, side in sides.items() if b.start is None and len(side) == 1), None)
        first = sides.pop(own) if own else _vector(sheet, point, found)
        equations.append(VectorEquation([first, *sides.values()]))
    return equations


def _vector(sheet: Sheet, point: str, found: list[str]) -> list[Term]:
    """A point's own vector; nothing for a fixed one."""
    if sheet.letter(point) == sheet.pole:
        return []
    return [Term(sheet.symbol(f"{sheet.kind}_{point}"), 0 if point in found else 2)]


def _side(sheet: Sheet, system: System, branch: Branch, found: list[str]) -> list[Term]:
    """A branch with what is known before the group is solved: not the motion of the group's own points."""
    side = terms(sheet, branch, 2 if _turns_as_known(sheet, system, branch) else 1)
    if branch.turns and sheet.values.get(rate_key(sheet, branch)) == 0 and _known_root(system, branch.link):
        side = side[:-1]
    if branch.start in found:
        side[0] = Term(side[0].symbol)
    return side


def _known_root(system: System, link: str) -> bool:
    return _root(system, link) not in system.group.links
