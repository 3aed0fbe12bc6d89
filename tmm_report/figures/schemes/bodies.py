"""The look of a mechanism's links: which bars, plates and blocks a link is drawn with, in its own axes, mm.

A link carrying a guide is a bar over the travel used; a link sliding on a guide is a block on it. Where a block
would hide another one, or the link itself carries a guide (a yoke), the link is a rod in a fixed bushing instead.
"""

from __future__ import annotations

import cmath
import warnings
from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.figures.schemes.cams import ends
from tmm_report.figures.schemes.wheels import circles, racks
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Mechanism, Slide
from tmm_report.records import dataclass

BLOCK = complex(4.5, 2.5)  # half length and half height of a slider block, mm
PAST = 3.0  # how far a guide runs past the block at the end of its travel, mm
FLOATS = 4.0  # mm: a mass centre farther from its link is tied to it
NEAR = 0.2  # points closer than this are one point on paper, mm

Bar = tuple[complex, complex]
Weld = tuple[complex, complex, complex]


def number(value: Any) -> complex:
    """A scalar of a mechanism; of an array (V, 1) the first variant is drawn."""
    return complex(np.ravel(value)[0])


@dataclass(frozen=True, eq=False)
class Motion:
    """A mechanism in its drawn positions, mm of paper.

    `places`: world place of each point, complex (P,), m; `turns`: unit direction of each link's x axis, (P,);
    `mu`: scale, m/mm. Positions that do not assemble are nan.
    """

    mechanism: Mechanism
    places: Mapping[str, np.ndarray]
    turns: Mapping[str, np.ndarray]
    mu: float

    @cached_property
    def count(self) -> int:
        return max((len(np.ravel(turn)) for turn in self.turns.values()), default=1)

    @cached_property
    def axes(self) -> dict[str, np.ndarray]:
        """Direction of each link's axes, (P,), the frame's included."""
        whole = np.ones(self.count, complex)
        return {name: whole * self.turns.get(name, 1.0) for name in self.mechanism.links}

    @cached_property
    def origins(self) -> dict[str, np.ndarray]:
        """Place of the origin of each link's axes, (P,), mm; nan where nothing tells it."""
        found = {FRAME: np.zeros(self.count, complex)}
        for name in self.mechanism.moving:
            known = [p for p in self.mechanism.links[name].points if p in self.places]
            if known:
                local = number(self.mechanism.links[name].points[known[0]])
                found[name] = (np.asarray(self.places[known[0]]) - self.axes[name] * local) / self.mu
        for name in self.mechanism.moving:
            if name not in found:
                found[name] = self._met(name, found)
        return found

    def _met(self, name: str, known: Mapping[str, np.ndarray]) -> np.ndarray:
        """Origin of a link without points: it is where the lines allowed by its two prismatic pairs cross."""
        lines = []
        for slide in self.mechanism.slides:
            guide = self.mechanism.guides[slide.guide]
            other = guide.link if slide.link == name else slide.link
            if name not in (guide.link, slide.link) or other not in known:
                continue
            on_other, on_self = (guide, slide) if slide.link == name else (slide, guide)
            shift = known[other] + self.axes[other] * number(on_other.through) / self.mu
            along = self.axes[other] * number(on_other.direction)
            lines.append((shift - self.axes[name] * number(on_self.through) / self.mu, along))
        if len(lines) < 2:
            return np.full(self.count, np.nan + 0j)
        (c1, d1), (c2, d2) = lines[:2]
        return c1 + d1 * (d2.conj() * (c2 - c1)).imag / (d2.conj() * d1).imag

    def at(self, link: str, local: complex) -> np.ndarray:
        """World place, (P,), mm, of a place given in a link's axes, mm."""
        return self.origins[link] + self.axes[link] * local

    def local(self, link: str, point: str) -> complex:
        """A point's place in its link's axes, mm."""
        return number(self.mechanism.links[link].points[point]) / self.mu

    def travel(self, slide: Slide) -> tuple[float, float]:
        """Least and greatest distance of the slide's through-point along its guide, from the guide's own, mm."""
        guide = self.mechanism.guides[slide.guide]
        place = self.at(slide.link, number(slide.through) / self.mu) - self.origins[guide.link]
        along = place * self.axes[guide.link].conj() - number(guide.through) / self.mu
        reach = (along * number(guide.direction).conjugate()).real
        reach = reach[np.isfinite(reach)]
        return (float(reach.min()), float(reach.max())) if len(reach) else (0.0, 0.0)

    def on_guide(self, guide: Guide, distance: float) -> complex:
        """A place on a guide, in the axes of the link that carries it, mm."""
        return number(guide.through) / self.mu + number(guide.direction) * distance


@dataclass(frozen=True)
class Body:
    """A link in its own axes, mm: thick bars, the corners of a stiff plate, its blocks as (centre, direction),
    and the corners where two bars are one piece as (place, a place on each bar); of a cam pair the outline of the cam,
    the follower's rollers as (centre, radius)."""

    bars: tuple[Bar, ...] = ()
    plate: tuple[complex, ...] = ()
    blocks: tuple[tuple[complex, complex], ...] = ()
    welds: tuple[Weld, ...] = ()
    outlines: tuple[tuple[complex, ...], ...] = ()
    rollers: tuple[tuple[complex, float], ...] = ()


def bodies(motion: Motion) -> dict[str, Body]:
    """The look of every moving link; the same in all positions."""
    return {name: _body(motion, name) for name in motion.mechanism.moving}


def held_at(body: Body, centre: complex) -> tuple[complex, ...]:
    """Of a mass centre that would float beside its link, in its axes, mm: the places to which it is tied, both ends of
    the nearest bar or edge, the nearer one of a bar in line with it, or the block; none of one on the link."""
    plate = body.plate
    edges = list(zip(plate, (*plate[1:], *plate[:1]), strict=True))
    if body.outlines or (plate and all(((b - a).conjugate() * (centre - a)).imag >= 0 for a, b in edges)):
        return ()
    ends = [*body.bars, *edges, *((at, at) for at, _ in body.blocks)]
    nearest = min(ends, key=lambda bar: abs(_apart(bar, centre)), default=(centre, centre))
    if abs(_apart(nearest, centre)) <= FLOATS:
        return ()
    one, other = sorted(nearest, key=lambda end: abs(end - centre))
    straight = abs(((other - one).conjugate() * (centre - one)).imag) <= NEAR * abs(other - one)
    return (one,) if straight else (one, other)


def _apart(bar: Bar, place: complex) -> complex:
    """From the nearest place of a bar, which may be a point."""
    return place - (bar[0] if bar[0] == bar[1] else _foot(bar, place))


def is_rod(motion: Motion, slide: Slide) -> bool:
    """Whether the slide is drawn as a rod in a fixed bushing and not as a block on a guide."""
    mechanism = motion.mechanism
    if mechanism.guides[slide.guide].link != FRAME:
        return False
    carries = any(guide.link == slide.link for guide in mechanism.guides.values())
    centre = motion.at(slide.link, number(slide.through) / motion.mu)
    others = [s for s in mechanism.slides if s is not slide and mechanism.guides[s.guide].link != FRAME]
    return carries or any(_same(centre, motion.at(s.link, number(s.through) / motion.mu)) for s in others)


def _same(one: np.ndarray, other: np.ndarray) -> bool:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # all nan: never the same
        return bool(np.nanmax(abs(one - other)) < BLOCK.imag)


def bushing(motion: Motion, slide: Slide) -> float:
    """Where along its fixed guide the bushing of a rod stands, clear of the link's travel, mm."""
    low, high = motion.travel(slide)
    clear = PAST + 2 * BLOCK.real
    return high + clear if _rod_side(motion, slide) > 0 else low - clear


def _rod_side(motion: Motion, slide: Slide) -> int:
    """A rod runs to the side on which the link has its farthest point on it, else along the guide."""
    through, along = number(slide.through) / motion.mu, number(slide.direction)
    offsets = [
        (motion.local(slide.link, p) - through) / along for p in motion.mechanism.links[slide.link].points
    ]
    far = max((z.real for z in offsets if abs(z.imag) < NEAR), key=abs, default=0.0)
    return -1 if far < -NEAR else 1


def _body(motion: Motion, name: str) -> Body:
    slides = [slide for slide in motion.mechanism.slides if slide.link == name]
    rods = [_rod(motion, slide) for slide in slides if is_rod(motion, slide)]
    blocks = [(number(s.through) / motion.mu, number(s.direction)) for s in slides if not is_rod(motion, s)]
    rails = [rail for guide in motion.mechanism.guides.values() if (rail := _rail(motion, guide, name))]
    cams = ends(motion.mechanism, name, motion.mu)
    rails += cams.faces
    rails += racks(motion, name)
    outlines = (*cams.outlines, *circles(motion.mechanism, name, motion.mu))
    nodes = _nodes(motion, name) + [centre for centre, _ in blocks]
    bars, welds = _framework(rails + rods, nodes)
    hull = [] if bars else _hull(nodes)
    if len(hull) > 2 and (pivot := _pivot(motion, name)) is not None:
        bars, welds, hull = *_spokes(pivot, nodes), []
    if len(hull) == 2:
        bars = [(hull[0], hull[1])]
    plate = tuple(hull) if len(hull) > 2 else ()
    return Body(tuple(bars), plate, tuple(blocks), tuple(welds), outlines, cams.rollers)


def _pivot(motion: Motion, name: str) -> complex | None:
    """Where the driver turns about the frame, in its own axes, mm; None for any other link."""
    mechanism = motion.mechanism
    fixed = [p for p in mechanism.links[name].points if p in mechanism.links[FRAME].points]
    return motion.local(name, fixed[0]) if name == mechanism.driver.link and fixed else None


def _spokes(pivot: complex, nodes: Sequence[complex]) -> tuple[list[Bar], list[Weld]]:
    """A crank of several throws: a bar from its pivot to each, one piece with the next."""
    throws = sorted((z for z in nodes if abs(z - pivot) > NEAR), key=lambda z: cmath.phase(z - pivot))
    return [(pivot, z) for z in throws], [(pivot, one, other) for one, other in pairwise(throws)]


def _nodes(motion: Motion, name: str) -> list[complex]:
    """Points the link is drawn through: all but a mass centre that is no joint."""
    link = motion.mechanism.links[name]
    joints = [p for p in link.points if p != link.mass_centre or len(motion.mechanism.links_at(p)) > 1]
    return [motion.local(name, p) for p in joints]


def _rail(motion: Motion, guide: Guide, name: str) -> Bar | None:
    """The bar of a guide carried by the link, over the travel of all that slides on it."""
    users = [slide for slide in motion.mechanism.slides if slide.guide == guide.name]
    if guide.link != name or not users:
        return None
    spans = [motion.travel(slide) for slide in users]
    margin = BLOCK.real + PAST
    low, high = min(low for low, _ in spans) - margin, max(high for _, high in spans) + margin
    return motion.on_guide(guide, low), motion.on_guide(guide, high)


def _rod(motion: Motion, slide: Slide) -> Bar:
    """The rod reaches through its bushing in every position."""
    low, high = motion.travel(slide)
    start, side = number(slide.through) / motion.mu, _rod_side(motion, slide)
    length = (high - low) + 3 * BLOCK.real + 2 * PAST
    return start, start + side * number(slide.direction) * length


def _framework(bars: Sequence[Bar], nodes: Sequence[complex]) -> tuple[list[Bar], list[Weld]]:
    """Bars stretched to the nodes on their lines, tied to each other and to the nodes off them, with welds."""
    if not bars:
        return [], []
    grown = [_stretched(bar, nodes) for bar in bars]
    loose = [node for node in nodes if all(_off(bar, node) > NEAR for bar in grown)]
    ties = [(_nearest(grown, node), node) for node in loose]
    ties += [(_nearest(grown[:1], bar[0]), bar[0]) for bar in grown[1:] if not _touch(grown[0], bar)]
    welds = [(foot, _far_end(_owner(grown, foot), foot), tip) for foot, tip in ties if abs(tip - foot) > NEAR]
    welds += [
        (bar[0], _far_end(grown[0], bar[0]), bar[1]) for bar in grown[1:] if _off(grown[0], bar[0]) <= NEAR
    ]
    return grown + [tie for tie in ties if abs(tie[1] - tie[0]) > NEAR], welds


def _stretched(bar: Bar, nodes: Sequence[complex]) -> Bar:
    start, unit = bar[0], (bar[1] - bar[0]) / abs(bar[1] - bar[0])
    along = [(node - start) / unit for node in nodes]
    reach = [0.0, abs(bar[1] - start), *(z.real for z in along if abs(z.imag) <= NEAR)]
    return start + min(reach) * unit, start + max(reach) * unit


def _foot(bar: Bar, node: complex) -> complex:
    """The nearest place of a bar to a node."""
    along = bar[1] - bar[0]
    share = ((node - bar[0]) / along).real
    return bar[0] + min(max(share, 0.0), 1.0) * along


def _off(bar: Bar, node: complex) -> float:
    return abs(node - _foot(bar, node))


def _owner(bars: Sequence[Bar], node: complex) -> Bar:
    return min(bars, key=lambda bar: _off(bar, node))


def _nearest(bars: Sequence[Bar], node: complex) -> complex:
    return _foot(_owner(bars, node), node)


def _far_end(bar: Bar, node: complex) -> complex:
    return max(bar, key=lambda end: abs(end - node))


def _touch(one: Bar, other: Bar) -> bool:
    """Whether two bars meet or cross."""
    if min(_off(one, other[0]), _off(one, other[1]), _off(other, one[0]), _off(other, one[1])) <= NEAR:
        return True
    sides = [((p - b[0]) / (b[1] - b[0])).imag for b, q in ((one, other), (other, one)) for p in q]
    return sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0


def _hull(nodes: Sequence[complex]) -> list[complex]:
    """Corners of the convex hull, counter-clockwise; two for points of one line, one or none for fewer."""
    points = sorted(
        {complex(round(z.real, 4), round(z.imag, 4)) for z in nodes}, key=lambda z: (z.real, z.imag)
    )
    if len(points) < 3:
        return points
    lower, upper = _chain(points), _chain(points[::-1])
    return lower[:-1] + upper[:-1]


def _chain(points: Sequence[complex]) -> list[complex]:
    chain: list[complex] = []
    for point in points:
        while len(chain) > 1 and _bend(chain[-2], chain[-1], point) <= NEAR:
            chain.pop()
        chain.append(point)
    return chain


def _bend(a: complex, b: complex, c: complex) -> float:
    """How far b stands to the right of the line from a to c, mm: a convex corner of a counter-clockwise hull."""
    return -((c - a).conjugate() * (b - a)).imag / abs(c - a)
