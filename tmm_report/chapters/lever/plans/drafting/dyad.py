"""A dyad in a plan: its vector equation is solved by crossing the lines of its two unknown vectors."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.lever.plans.drafting.branch import Line, angular, close, coinciding, line_from, terms
from tmm_report.chapters.lever.plans.drafting.lead import similar
from tmm_report.chapters.lever.plans.drafting.plan import Step
from tmm_report.chapters.lever.plans.drafting.sheet import Image, Sheet
from tmm_report.mechanics.calculus.vectors import resolve
from tmm_report.mechanics.lever.dyads import Dyad, Side, sides
from tmm_report.mechanics.lever.vector_equations import Branch, Relation, turns_with
from tmm_report.quantity.formula import Formula, Term, VectorEquation


def step(sheet: Sheet, r: Relation) -> Step:
    """Draw a dyad's part of the plan."""
    both = zip((r.left, r.right), sides(sheet.motion.state, r.dyad), strict=True)
    (left, of_left), (right, of_right) = (_line(sheet, branch, side) for branch, side in both)
    x, _ = resolve(right.z_bend - left.z_bend, left.direction, -right.direction)
    z = sheet.vertex(r.vertex, sheet.pen.place(left.z_bend + x * left.direction))
    after = [f for line in (left, right) for f in close(sheet, line, z)]
    sheet.absolute(r.vertex, z)
    if f"{sheet.kind}_{r.vertex}" not in sheet.values:
        after.insert(0, sheet.read_point(r.vertex))
    after += [f for line in (left, right) for f in angular(sheet, line)]
    _place_links(sheet, r.dyad, left, right, z)
    points = [f for link in r.dyad.links for f in similar(sheet, link, (left, right))]
    return Step(
        r.dyad.group, (r.vertex,), (_equation(sheet, r),), (*of_left, *of_right), tuple(after), tuple(points)
    )


def _line(sheet: Sheet, branch: Branch, side: Side) -> tuple[Line, list[Formula]]:
    """Draw the known part of a branch: its start, and in accelerations its normal or Coriolis part."""
    start = sheet.world(np.ravel(side.joint)[0])
    arm = complex(np.ravel(side.e)[0])
    if branch.arm is not None:
        arm = sheet.drawn(sheet.world(start + arm / 1j) - start, "".join(branch.arm))
    formulas = coinciding(sheet, branch, side.carrier, start)
    z = sheet.images[side.carrier].of(start)
    if branch.start is not None:
        z = sheet.vertices[sheet.letter(branch.start)]
    line, bend = line_from(sheet, branch, start, arm, z)
    return line, formulas + bend


def _place_links(sheet: Sheet, d: Dyad, left: Line, right: Line, z: complex) -> None:
    """Images of both links, so that any point of theirs follows by similarity."""
    images = sheet.images
    vertex = left.place + left.arm if left.branch.turns else left.place

    def turned(line: Line) -> Image:
        return Image(line.z_start, line.place, (z - line.z_start) / line.arm)

    turn_a, turn_b = (images[c].turn for c in (d.carrier_a, d.carrier_b))
    if d.kind <= 3:
        images[d.a] = turned(left)
    if d.kind == 1:
        images[d.b] = turned(right)
    elif d.kind == 3:
        images[d.b] = Image(right.z_start, right.place, images[d.a].turn)
    elif d.kind == 2:
        images[d.b] = Image(z, vertex, turn_b)
    elif d.kind == 4:
        images[d.a], images[d.b] = Image(z, vertex, turn_a), Image(z, vertex, turn_b)
    else:
        images[d.a] = Image(right.z_start, right.place, turn_b)
        images[d.b] = Image(z, vertex, turn_b)
    sheet.alike |= {link: source for link, source in turns_with(d).items() if source is not None}


def _equation(sheet: Sheet, r: Relation) -> VectorEquation:
    """Vertex = left side = right side; a side that is the vertex's own vector, of known direction, comes first."""
    both = [terms(sheet, branch) for branch in (r.left, r.right)]
    own = [side for side in both if len(side) == 1]
    first = own[:1] or [[Term(sheet.symbol(f"{sheet.kind}_{r.vertex}"))]]
    return VectorEquation([*first, *(side for side in both if side is not first[0])])
