"""Drawings in millimetres of paper: a frozen tuple of primitives, written as SVG and as TikZ.

1 unit is 1 mm, so the printed length of a segment is its drawn length; x to the right, y up; a place is one
complex number. The arrowheads are filled polygons, so nothing needs an id.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from itertools import chain
from typing import NamedTuple

import numpy as np

from tmm_report.figures.lettering import Part, Parts, Scale, xml_text
from tmm_report.figures.placing import placed
from tmm_report.figures.primitives import (
    AXIS,
    COLOURS,
    DASHED,
    HEAD,
    NORMAL,
    TEXT,
    THICK,
    THIN,
    Arc,
    Arrow,
    Box,
    Circle,
    Item,
    Path,
    Pen,
    Tag,
    Text,
    dot,
    hatching,
    line,
    polygon,
    polyline,
    tikz_colour,
    tikz_point,
    with_places,
    written,
)
from tmm_report.figures.thinning import thinned
from tmm_report.records import dataclass

__all__ = [
    "AXIS",
    "COLOURS",
    "DASHED",
    "FONTS",
    "HEAD",
    "NORMAL",
    "TEXT",
    "THICK",
    "THIN",
    "Acting",
    "Acts",
    "Arc",
    "Arrow",
    "Box",
    "Circle",
    "Drawing",
    "Item",
    "Moves",
    "Moving",
    "Path",
    "Pen",
    "Planned",
    "Tag",
    "Text",
    "dot",
    "hatching",
    "line",
    "polygon",
    "polyline",
    "shapes",
    "svg",
    "tikz",
    "together",
]


class Planned(NamedTuple):
    """The vectors of a plan: key of the quantity, start and end, mm; `scale`: what 1 mm stands for, SI."""

    vectors: tuple[tuple[str, complex, complex], ...]
    scale: float


class Acting(NamedTuple):
    """A force or a couple as it is drawn: key of its quantity, where it acts, mm, its letter and colour; `on`: what it
    acts on, a link, or of the lever a point; `pair`: of a pair of forces, what the other acts on."""

    key: str
    at: complex
    letter: Part | None
    colour: str
    on: str = ""
    pair: str = ""


class Acts(NamedTuple):
    """What a loading scheme shows beside its links, which are drawn at `scale`, m/mm, in a table position. Of
    Zhukovsky's lever, which has no links, `sides` are the keys of the velocities, at `scale`, (m/s)/mm, that its plan
    shows, and `turn` is by what it is turned."""

    position: int
    scale: float
    forces: tuple[Acting, ...]
    couples: tuple[Acting, ...] = ()
    links: tuple[str, ...] = ()
    sides: tuple[str, ...] = ()
    turn: complex = 0j


class Moving(NamedTuple):
    """What moves of a drawing: `items`, about `centre` as member `of` of a drive turns, in the `sense` that is drawn, 0
    where that is the member's own; the centre about the origin as member `about` does. `pitch`: of teeth, rad, of which
    one is drawn; those in the middle of the sheet, `half` mm wide to either side, are seen. `rise`: of a mark on a
    wheel seen from the side, where it is about the axis at first, mm: how far in front of it, and, as the imaginary
    part, how far along `across`. It is seen in front of the axis; of a wheel of which one half is drawn, on its `side`.
    Without a member: `turns`, rad, and `ways`, mm, at the angles `at` of a cycle, rad."""

    items: tuple[Item, ...]
    centre: complex = 0j
    of: str = ""
    sense: int = 0
    about: str = ""
    pitch: float = 0.0
    half: float = 0.0
    rise: complex = 0j
    across: complex = 1j
    side: int = 0
    at: tuple[float, ...] = ()
    turns: tuple[float, ...] = ()
    ways: tuple[complex, ...] = ()


class Moves(NamedTuple):
    """The moving parts of a drawing, and its items, `still`, that they take the place of; `bare`: and its letters.
    `speed`: of the members, rad/s, where they are not the drive's; `once`: the one that turns once in a cycle, "": the
    crank where they turn that, else the fastest."""

    parts: tuple[Moving, ...]
    still: tuple[Item, ...]
    bare: bool = False
    speed: Mapping[str, float] | None = None
    once: str = ""


@dataclass(frozen=True)
class Drawing:
    """Primitives in the order they are drawn, mm of paper; `title` is read aloud to who cannot see it."""

    items: tuple[Item, ...]
    title: str = ""
    margin: float = field(default=1.0, kw_only=True)
    scales: tuple[Scale, ...] = field(default=(), kw_only=True)  # of its axes, where it has some
    plan: Planned | None = field(default=None, kw_only=True)  # of a plan, what it shows
    acts: Acts | None = field(default=None, kw_only=True)  # of a loading scheme
    moves: Moves | None = field(default=None, kw_only=True)

    @cached_property
    def box(self) -> Box:
        """Left, bottom, right and top of all items with the margin, mm."""
        corners = chain.from_iterable([item.corners() for item in self.items])
        places = np.array(list(corners) or [0j], complex)
        (left, right), (bottom, top) = ((float(x.min()), float(x.max())) for x in (places.real, places.imag))
        return left - self.margin, bottom - self.margin, right + self.margin, top + self.margin

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        left, bottom, right, top = self.box
        return right - left, top - bottom

    def moved(self, by: complex) -> Drawing:
        return replace(self, items=tuple(item.moved(by) for item in self.items))

    def labelled(self, tags: Sequence[Tag]) -> Drawing:
        """The drawing with each tag on a clear place beside its anchor, or led to it by a thin line."""
        texts, leaders = placed(tags, self.items)
        return replace(self, items=(*self.items, *leaders, *texts))

    def noted(self, *notes: str | Parts) -> Drawing:
        """The drawing with lines of text under its left end; empty ones are left out."""
        left, bottom, _, _ = self.box
        rows: list[Parts] = [(note,) if isinstance(note, str) else note for note in notes if note]
        texts = [Text(complex(left + self.margin, bottom - (2 + 5 * i)), row) for i, row in enumerate(rows)]
        return replace(self, items=(*self.items, *texts))


def together(places: Mapping[str, complex], within: float = 0.5) -> list[tuple[list[str], complex]]:
    """Names grouped where their places coincide `within` mm: [(names, place of the first)]."""
    groups: list[tuple[list[str], complex]] = []
    for name, place in places.items():
        for names, at in groups:
            if abs(place - at) <= within:
                names.append(name)
                break
        else:
            groups.append(([name], place))
    return groups


# --- SVG ---

FONTS = "'Note Serif','Note Math','Times New Roman','Liberation Serif','DejaVu Serif',serif"
DRAWN = 'fill="none" stroke-linecap="round" stroke-linejoin="round"'
FAR = 1000.0  # mm: TeX knows no length over 5.7 m, and a browser counts in single precision


def near_origin(drawing: Drawing) -> Drawing:
    """A drawing of a mechanism that stands far from its axes' origin, moved to it."""
    left, bottom, right, top = drawing.box
    far = max(abs(left), abs(bottom), abs(right), abs(top)) > FAR
    return drawing.moved(-complex(left, bottom)) if far else drawing


def svg(drawing: Drawing, title: str = "") -> str:
    """The drawing as one `svg` element of its size in mm; no ids, no scripts, nothing fetched.

    `title`: of one that has none.
    """
    drawing = near_origin(drawing)
    left, bottom, right, top = drawing.box
    wide, tall = written(right - left), written(top - bottom)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{wide}mm" height="{tall}mm"'
        f' viewBox="{written(left)} {written(-top)} {wide} {tall}">'
    )
    style = f'<g {DRAWN} font-family="{FONTS}" font-size="{TEXT}">'
    places: list[complex] = []
    body = _body(drawing.items, places)
    texts = "".join([item.svg(places) for item in drawing.items if isinstance(item, Text)])
    drawn = with_places(f'{body}<g fill="#000000">{texts}</g>', places)
    title = drawing.title or title
    title = f"<title>{xml_text(title)}</title>" if title else ""
    return f"{head}{title}{style}{drawn}</g></svg>"


def shapes(items: Sequence[Item]) -> str:
    """What stands in a drawing's group with the attributes DRAWN, but for its letters."""
    places: list[complex] = []
    return with_places(_body(items, places), places)


def _body(items: Sequence[Item], places: list[complex]) -> str:
    return "".join([item.svg(places) for item in thinned(items) if not isinstance(item, Text)])


# --- TikZ ---


def tikz(drawing: Drawing) -> str:
    """The drawing as a `tikzpicture`; the document loads tikz, amsmath and fonts for its letters."""
    drawing = near_origin(drawing)
    left, bottom, right, top = drawing.box
    corners = tikz_point(complex(left, bottom)), tikz_point(complex(right, top))
    box = rf"\useasboundingbox {corners[0]} rectangle {corners[1]};"
    colours = [rf"\definecolor{{{tikz_colour(name)}}}{{HTML}}{{{code}}}" for name, code in COLOURS.items()]
    font = r"\providecommand{\drawingfont}[1]{\fontsize{#1}{#1}\selectfont}"
    options = "x=1mm,y=1mm,line cap=round,line join=round,every node/.style={inner sep=0pt,outer sep=0pt}"
    lines = [item.tikz() for item in thinned(drawing.items) if not isinstance(item, Text)]
    texts = [item.tikz() for item in drawing.items if isinstance(item, Text)]
    return "\n".join(
        [rf"\begin{{tikzpicture}}[{options}]", font, *colours, box, *lines, *texts, r"\end{tikzpicture}", ""]
    )
