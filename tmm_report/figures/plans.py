"""Plans of velocities, accelerations and forces: vectors and vertices come in mm of paper, drawn as given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from tmm_report.figures.drawing import (
    DASHED,
    NORMAL,
    THICK,
    Arrow,
    Drawing,
    Item,
    Pen,
    Tag,
    dot,
    line,
    together,
)
from tmm_report.figures.lettering import Part, Parts, joined, symbol

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


@dataclass(frozen=True)
class PlanVector:
    """One vector of a plan, mm of paper; `of`: key of its quantity. A construction line (a known direction) has no
    arrowhead."""

    start: complex
    end: complex
    label: Part | None = None
    style: Style = "relative"
    of: str = ""


def plan(
    vectors: Sequence[PlanVector],
    vertices: Mapping[str, complex],
    note: str | Parts = "",
    title: str = "",
    pole: str = "",
) -> Drawing:
    """The plan drawn as given, mm; vectors of no length are left out.

    `vertices` are lettered once, coinciding ones together ("b, p"); the one named `pole` gets a larger dot.
    `note`, the scale, goes under the drawing.
    """
    seen = [vector for vector in vectors if abs(vector.end - vector.start) > 1e-3]
    # thin lines first: a component must not hide the vector it lies on
    items: list[Item] = [_drawn(vector) for vector in sorted(seen, key=lambda v: PENS[v.style].width)]
    items += [dot(place, 0.8 if name == pole else 0.45) for name, place in vertices.items()]
    tags = _vertex_tags(vertices) + [_vector_tag(v, v.label) for v in seen if v.label is not None]
    return Drawing(tuple(items), title).labelled(tags).noted(note)


def _drawn(vector: PlanVector) -> Item:
    pen = PENS[vector.style]
    if vector.style != "construction":
        return Arrow(vector.start, vector.end, pen, of=vector.of)
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


def _vector_tag(vector: PlanVector, label: Part) -> Tag:
    along = vector.end - vector.start
    anchors = tuple(vector.start + along * share for share in (0.42, 0.58, 0.25, 0.75))
    return Tag(
        (label,), anchors, gap=0.7, prefer=1j * along / abs(along), size=2.8, colour=PENS[vector.style].colour
    )
