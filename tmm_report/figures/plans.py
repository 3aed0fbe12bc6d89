"""Plans of velocities, accelerations and forces: vectors and vertices come in mm of paper, drawn as given.

Vectors that lie upon one another are drawn side by side, each between thin ticks that lead to its true ends.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Literal

from tmm_report.figures.aside import Segment, asides, lie_upon, same_way
from tmm_report.figures.drawing import (
    DASHED,
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Drawing,
    Item,
    Pen,
    Planned,
    Tag,
    dot,
    line,
    together,
)
from tmm_report.figures.lettering import Part, Parts, joined, symbol, width
from tmm_report.figures.primitives import heights
from tmm_report.records import dataclass

Style = Literal[
    "absolute", "relative", "component", "coriolis", "construction", "force", "inertia", "reaction"
]

PENS: Mapping[Style, Pen] = {
    "absolute": THICK,
    "relative": NORMAL,
    "component": replace(DASHED, colour="blue"),
    "coriolis": replace(DASHED, colour="green", dash=(0.8, 0.8)),
    "construction": Pen(0.15, "grey", (1.6, 1.0)),
    "force": Pen(0.5),
    "inertia": Pen(0.5, "blue"),
    "reaction": Pen(0.5, "red"),
}

BEYOND = 8.0  # how far a construction line runs past both its ends, mm
LETTERS, BESIDE = 2.8, 0.7  # size of the letters of a vector, and how far they stand from it, mm
TICK = 0.7  # how far a tick runs past a vector that is drawn aside, mm


@dataclass(frozen=True)
class PlanVector:
    """One vector of a plan, mm of paper; `of`: key of its quantity. A construction line (a known direction) has no
    arrowhead."""

    start: complex
    end: complex
    label: Part | None = None
    style: Style = "relative"
    of: str = ""


@dataclass(frozen=True)
class _Placed:
    """A vector where it is drawn: `aside` mm to the left of its line. `side`: 1, its letters are best on the left, or
    -1."""

    vector: PlanVector
    aside: float
    side: int

    @property
    def by(self) -> complex:
        along = self.vector.end - self.vector.start
        return 1j * self.aside * along / abs(along)


def plan(
    vectors: Sequence[PlanVector],
    vertices: Mapping[str, complex],
    note: str | Parts = "",
    title: str = "",
    pole: str = "",
    scale: float = 0.0,
) -> Drawing:
    """The plan drawn as given, mm; vectors of no length are left out.

    Of vectors that lie upon one another the thickest, then the longest, keeps the line, the others stand beside it.
    `vertices` are lettered once, coinciding ones together ("b, p"); the one named `pole` gets a larger dot.
    `note`, the scale, goes under the drawing. `scale`: what 1 mm stands for, SI, where the page is to redraw it.
    """
    seen = _side_by_side([vector for vector in vectors if abs(vector.end - vector.start) > 1e-3])
    # thin lines first: a component must not hide the vector it lies on
    items: list[Item] = [tick for one in seen for tick in _ticks(one)]
    items += [_drawn(one) for one in sorted(seen, key=lambda one: PENS[one.vector.style].width)]
    items += [dot(place, 0.8 if name == pole else 0.45) for name, place in vertices.items()]
    tags = _vertex_tags(vertices) + [_vector_tag(one, one.vector.label) for one in seen if one.vector.label]
    shown = (
        Planned(tuple((one.of, one.start, one.end) for one in vectors if one.of), scale) if scale else None
    )
    return Drawing(tuple(items), title, plan=shown).labelled(tags).noted(note)


def _side_by_side(vectors: Sequence[PlanVector]) -> list[_Placed]:
    """All in their order; construction lines stay where they are."""
    arrows = [vector for vector in vectors if vector.style != "construction"]
    first = sorted(arrows, key=lambda v: (-PENS[v.style].width, -round(abs(v.end - v.start), 2)))
    lines = [(vector.start, vector.end) for vector in first]
    found = asides(lines, [_room(vector) for vector in first])
    placed = {
        id(vector): _Placed(vector, aside, _side(aside, i, lines, found))
        for i, (vector, aside) in enumerate(zip(first, found, strict=True))
    }
    return [placed.get(id(vector)) or _Placed(vector, 0.0, 1) for vector in vectors]


def _side(aside: float, i: int, lines: Sequence[Segment], asides: Sequence[float]) -> int:
    """Letters stand on the side to which a vector is moved, of one on its line on the side that is free."""
    if aside:
        return 1 if aside > 0 else -1
    beside = [
        other * same_way(line, lines[i])
        for line, other in zip(lines, asides, strict=True)
        if lie_upon(line, lines[i])
    ]
    return -1 if max(beside, default=0.0) > 0 <= min(beside) else 1


def _room(vector: PlanVector) -> float:
    """What the letters of a vector need across it, mm."""
    if vector.label is None:
        return 0.0
    along = (vector.end - vector.start) / abs(vector.end - vector.start)
    wide, tall = width((vector.label,), LETTERS), LETTERS * sum(heights((vector.label,)))
    return wide * abs(along.imag) + tall * abs(along.real) + 2 * BESIDE


def _ticks(one: _Placed) -> list[Item]:
    """From the true ends of a vector drawn aside across its own."""
    if not one.aside:
        return []
    across = one.by * (1 + TICK / abs(one.aside))
    return [line(end, end + across, THIN) for end in (one.vector.start, one.vector.end)]


def _drawn(one: _Placed) -> Item:
    vector, pen = one.vector, PENS[one.vector.style]
    if vector.style != "construction":
        return Arrow(vector.start + one.by, vector.end + one.by, pen, of=vector.of, aside=one.aside)
    beyond = BEYOND * (vector.end - vector.start) / abs(vector.end - vector.start)
    return line(vector.start - beyond, vector.end + beyond, pen)


def _vertex_tags(vertices: Mapping[str, complex]) -> list[Tag]:
    """A vertex is best lettered on the outer side of the plan."""
    if not vertices:
        return []
    middle = sum(vertices.values()) / len(vertices)
    tags = []
    for names, place in together(vertices):
        out = place - middle
        tags.append(
            Tag(joined([symbol(name) for name in names]), (place,), prefer=out / abs(out) if out else 0j)
        )
    return tags


def _vector_tag(one: _Placed, label: Part) -> Tag:
    """Beside the vector, on the side to which it is moved."""
    vector = one.vector
    along = vector.end - vector.start
    start = vector.start + one.by
    anchors = tuple(start + along * share for share in (0.42, 0.58, 0.25, 0.75))
    side = 1j * one.side * along / abs(along)
    return Tag((label,), anchors, gap=BESIDE, prefer=side, size=LETTERS, colour=PENS[vector.style].colour)
