"""Schemes of a mechanism: one position, all positions together, and its groups taken apart.

`places` maps each point to its world places, complex (P,), m; `turns` maps each link to the unit direction of its
x axis, complex (P,); `mu_l` is m of the mechanism per mm of paper, None: a standard scale that fits the page.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, product

import numpy as np

from tmm_report.figures import marks
from tmm_report.figures.bodies import BLOCK, NEAR, PAST, Body, Motion, bodies, bushing, is_rod, number
from tmm_report.figures.drawing import (
    THICK,
    THIN,
    Circle,
    Drawing,
    Item,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polygon,
    polyline,
    together,
)
from tmm_report.figures.lettering import Symbol, joined, symbol
from tmm_report.mechanics.mechanism import FRAME, Guide, Mechanism, Slide

PAGE = (168.0, 228.0)  # what a drawing may fill of a sheet, mm
GROUPS_PAGE = (168.0, 130.0)  # what the groups taken apart may fill
FAINT = Pen(0.18, "grey")
TRACE = Pen(0.22, "blue")
SMALL = 2.5  # height of the numbers of positions, mm
SEEN = 0.15  # the least angle that is marked, rad
LEADER = Pen(0.1, "blue")
AWAY = 2.6  # a number farther than this from its place is led to it by a line, mm

Arrays = Mapping[str, np.ndarray]
Group = tuple[str, Sequence[str]]  # its name as it is printed, its links ("0" with the driving link)


def scheme(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu_l: float | None = None,
    position: int = 0,
    zero: complex = 1.0,
    title: str = "",
) -> Drawing:
    """One position. `zero`: unit direction from which the driver's angle is counted in its sense of rotation."""

    def draw(mu: float) -> Drawing:
        view = _view(mechanism, places, turns, mu, position)
        items = (*view.plates(), *view.frame(), *view.links(), *view.rotation(), *view.angle(zero))
        tags = view.point_tags() + view.number_tags() + view.rotation_tags() + view.angle_tags(zero)
        return Drawing(items, title).labelled(tags)

    return draw(mu_l) if mu_l else draw(standard_scale(mechanism, places, turns))


def positions_scheme(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu_l: float | None = None,
    position: int = 0,
    paths: Arrays | None = None,
    traced: Sequence[str] = (),
    title: str = "",
) -> Drawing:
    """All positions, `position` drawn thick, the places of cranks, rockers and sliders numbered.

    `paths`: denser places of the points, complex (Q,), m, for their trajectories; `traced` names points to trace
    beside the coupler points, mass centres for example.
    """
    mu = mu_l or standard_scale(mechanism, places, turns)
    view = _view(mechanism, places, turns, mu, position)
    items = (*_superposed(view, paths or {}, traced), *view.rotation())
    drawing = Drawing(items, title).labelled(view.point_tags())
    for point in _labelled(view):
        drawing = _with_numbers(drawing, _position_tags(view, point))
    return drawing.labelled(view.number_tags() + view.rotation_tags())


def groups_apart(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    groups: Sequence[Group],
    position: int = 0,
    mu_l: float | None = None,
    title: str = "",
) -> Drawing:
    """The driving link and the Assur groups side by side, each over its name, outer joints as free halves."""

    def draw(mu: float) -> Drawing:
        view = _view(mechanism, places, turns, mu, position)
        return Drawing(_in_rows([_taken_off(view, name, links) for name, links in groups]), title)

    return draw(mu_l) if mu_l else draw(_fitting(_span(places) / PAGE[0], draw, GROUPS_PAGE))


# --- scales ---


def standard_scale(mechanism: Mechanism, places: Arrays, turns: Arrays) -> float:
    """The finest of the scales 1, 2, 2.5, 4, 5 x 10^n m/mm at which all positions fit the page."""
    page = (PAGE[0] - 2, PAGE[1] - 8)  # the rest is for lettering, left out here for speed

    def draw(mu: float) -> Drawing:
        view = _view(mechanism, places, turns, mu, 0)
        return Drawing(tuple(_superposed(view, places, ())))

    return _fitting(_span(places) / PAGE[1], draw, page)


def _fitting(least: float, draw: Callable[[float], Drawing], page: tuple[float, float]) -> float:
    """The least standard scale, m/mm, not under `least`, whose drawing fits the page."""
    power = math.floor(math.log10(least)) if least > 0 else -3
    scales = [digit * 10.0 ** (power + more) for more, digit in product(range(4), (1, 2, 2.5, 4, 5))]
    for mu in scales:
        if mu >= least and all(size <= room for size, room in zip(draw(mu).size, page, strict=True)):
            return float(f"{mu:.3g}")
    return float(f"{scales[-1]:.3g}")


def _span(places: Arrays) -> float:
    """The greater side of the box that holds all places, m."""
    every = np.concatenate([np.ravel(place) for place in places.values()])
    every = every[np.isfinite(every)]
    return float(max(np.ptp(every.real), np.ptp(every.imag))) if len(every) else 0.0


# --- one position ---


@dataclass(frozen=True, eq=False)
class View:
    """One position of a motion, seen as items of a drawing; links that do not assemble are left out."""

    motion: Motion
    position: int
    shapes: Mapping[str, Body]  # the same in all positions

    @property
    def mechanism(self) -> Mechanism:
        return self.motion.mechanism

    @cached_property
    def bodies(self) -> dict[str, Body]:
        """The links that assemble in this position."""
        return {name: body for name, body in self.shapes.items() if cmath.isfinite(self.at(name, 0))}

    @cached_property
    def points(self) -> dict[str, complex]:
        """World places of the points, mm."""
        owners = {point: self.mechanism.links_at(point)[0] for point in self.mechanism.point_names}
        places = {point: self.at(link, self.motion.local(link, point)) for point, link in owners.items()}
        return {point: place for point, place in places.items() if cmath.isfinite(place)}

    def at(self, link: str, local: complex) -> complex:
        return complex(self.motion.at(link, local)[self.position])

    def turn(self, link: str) -> complex:
        return complex(self.motion.axes[link][self.position])

    @cached_property
    def joints(self) -> dict[str, list[str]]:
        """Revolute joints: point -> its links."""
        links = {point: self.mechanism.links_at(point) for point in self.points}
        return {point: names for point, names in links.items() if len(names) > 1}

    @property
    def driver(self) -> str:
        return self.mechanism.driver.link

    @cached_property
    def pivot(self) -> complex:
        """The fixed point about which the driver turns."""
        return next((self.points[p] for p in self.mechanism.links[self.driver].points if self._fixed(p)), 0j)

    def _fixed(self, point: str) -> bool:
        return point in self.mechanism.links[FRAME].points and point in self.points

    # frame

    def frame(self) -> list[Item]:
        items: list[Item] = []
        for slide in self.mechanism.slides:
            guide = self.mechanism.guides[slide.guide]
            if guide.link == FRAME:
                items += self._fixed_slide(slide, guide)
        for point, names in self.joints.items():
            items += marks.support(self.points[point]) if FRAME in names else []
        guiding = [p for p in self.points if self._fixed(p) and p not in self.joints]
        return items + [item for p in guiding for item in marks.place(self.points[p])]

    def _fixed_slide(self, slide: Slide, guide: Guide) -> list[Item]:
        along = number(guide.direction)
        if is_rod(self.motion, slide):
            return marks.bushing(self.motion.on_guide(guide, bushing(self.motion, slide)), along)
        low, high = self.motion.travel(slide)
        margin = BLOCK.real + PAST
        ends = [self.motion.on_guide(guide, low - margin), self.motion.on_guide(guide, high + margin)]
        return marks.fixed_guide(ends[0], ends[1], self._hatched_side(guide)) + self._axis(guide, ends)

    def _axis(self, guide: Guide, ends: Sequence[complex]) -> list[Item]:
        """The axis of a fixed guide, drawn on to the fixed pivots that lie on it."""
        along, origin = number(guide.direction), ends[0]
        fixed = [place for point, place in self.points.items() if self._fixed(point)]
        offsets = [(place - origin) / along for place in fixed]
        reach = [z.real for z in offsets if abs(z.imag) < NEAR] + [0.0, ((ends[1] - origin) / along).real]
        return marks.axis(origin + min(reach) * along, origin + max(reach) * along)

    def _hatched_side(self, guide: Guide) -> complex:
        """The lower side of a guide; of an upright one the side away from the driver's pivot."""
        side = 1j * number(guide.direction)
        if abs(side.imag) > 0.1:
            return side if side.imag < 0 else -side
        away = self.motion.on_guide(guide, 0.0) - self.pivot
        return side if (away.conjugate() * side).real > 0 else -side

    # links

    def links(self, names: Sequence[str] | None = None) -> list[Item]:
        """The links drawn thick, with blocks, joints and mass centres."""
        chosen = [name for name in self.bodies if names is None or name in names]
        items = self.skeleton(THICK, chosen)
        for name in chosen:
            for centre, along in self.bodies[name].blocks:
                items += marks.block(self.at(name, centre), self.turn(name) * along, self.block)
        joints = [
            point for point, links in self.joints.items() if names is None or len(set(links) & set(names)) > 1
        ]
        items += [item for point in joints for item in self._joint(point)]
        centres = {self.mechanism.links[name].mass_centre for name in chosen}
        single = [p for name in chosen for p in self.mechanism.links[name].points if p not in self.joints]
        return items + [dot(self.points[p], 0.7 if p in centres else 0.5) for p in single if p in self.points]

    @cached_property
    def block(self) -> complex:
        """Half length and half height of the blocks, mm: shorter where two of them stand near each other."""
        centres = [self.at(name, place) for name, place in self._block_centres()]
        gaps = [gap for a, b in combinations(centres, 2) if (gap := abs(a - b)) > NEAR]
        room = max(0.5 * BLOCK.real, 0.45 * min(gaps, default=math.inf))
        return complex(min(BLOCK.real, room), BLOCK.imag)

    def plates(self, names: Sequence[str] | None = None) -> list[Item]:
        """The fill of stiff plates, to lie under everything else."""
        chosen = self.bodies if names is None else [name for name in names if name in self.bodies]
        corners = [[self.at(name, z) for z in self.bodies[name].plate] for name in chosen]
        return [polygon(plate, None, "pale", 0.6) for plate in corners if plate]

    def skeleton(self, pen: Pen, names: Sequence[str] | None = None) -> list[Item]:
        """Bars, outlines of plates and stiff corners of the links, one pen for all."""
        items: list[Item] = []
        for name in self.bodies if names is None else names:
            body = self.bodies[name]
            if body.plate:
                items.append(polygon([self.at(name, z) for z in body.plate], pen))
            items += [line(self.at(name, a), self.at(name, b), pen) for a, b in body.bars]
            if pen is THICK:
                welds = [tuple(self.at(name, z) for z in weld) for weld in body.welds]
                items += [item for corner, one, other in welds for item in marks.weld(corner, one, other)]
        return items

    def _joint(self, point: str) -> list[Item]:
        items = marks.joint(self.points[point])
        if any(abs(self.at(name, z) - self.points[point]) < NEAR for name, z in self._block_centres()):
            return items
        through = [u for name in self.joints[point] if name != FRAME and (u := self._passes(name, point))]
        return items + (marks.passing(self.points[point], through[0]) if len(through) == 1 else [])

    def _block_centres(self) -> list[tuple[str, complex]]:
        return [(name, centre) for name, body in self.bodies.items() for centre, _ in body.blocks]

    def _passes(self, name: str, point: str) -> complex:
        """Unit direction of a bar of the link that passes straight through the point; 0 where none does."""
        body, place = self.bodies.get(name, Body()), self.motion.local(name, point)
        for a, b in body.bars:
            along = (b - a) / abs(b - a)
            share = (place - a) / along
            if abs(share.imag) < NEAR and marks.JOINT < share.real < abs(b - a) - marks.JOINT:
                return along * self.turn(name)
        return 0j

    # the driver's turning

    def _crank(self) -> tuple[float, int]:
        """Length of the driver on paper, mm, and its sense of rotation."""
        ends = [self.points[p] for p in self.mechanism.links[self.driver].points if p in self.joints]
        reach = max((abs(end - self.pivot) for end in ends), default=0.0)
        return reach or 20.0, 1 if number(self.mechanism.driver.omega).real >= 0 else -1

    def _angle(self, zero: complex) -> tuple[float, float, float]:
        """Radius of the arc of the driver's angle, where it starts, and the signed angle, rad."""
        length, sense = self._crank()
        angle = sense * cmath.phase(self.turn(self.driver) / zero)
        if self.full_turn:
            angle %= 2 * math.pi
        return min(max(0.45 * length, 5.0), 9.0), cmath.phase(zero), sense * angle

    @property
    def full_turn(self) -> bool:
        return self.mechanism.driver.sweep >= 2 * math.pi - 1e-9

    def angle(self, zero: complex) -> list[Item]:
        """The driver's angle from `zero`; one too small to be seen is left out."""
        radius, start, angle = self._angle(zero)
        if not SEEN < abs(angle) < 2 * math.pi - SEEN:
            return []
        side = line(self.pivot, self.pivot + (radius + 5) * zero, THIN)
        return [side, *marks.turning(self.pivot, radius, start, angle)]

    def angle_tags(self, zero: complex) -> list[Tag]:
        radius, start, angle = self._angle(zero)
        if not SEEN < abs(angle) < 2 * math.pi - SEEN:
            return []
        return [self._arc_tag("φ", radius, start, angle)]

    def rotation(self) -> list[Item]:
        """The arrow of the driver's rotation, ahead of the driver."""
        return marks.turning(self.pivot, *self._rotation())

    def rotation_tags(self) -> list[Tag]:
        return [self._arc_tag("ω", *self._rotation())]

    def _rotation(self) -> tuple[float, float, float]:
        """Radius, start and sweep of the arrow of rotation, mm, rad."""
        length, sense = self._crank()
        radius = 1.6 * min(max(0.45 * length, 5.0), 9.0)
        radius = radius if radius < 0.8 * length else length + 6  # beyond the numbers round a short crank
        return radius, cmath.phase(self.turn(self.driver)) + 0.4 * sense, 1.0 * sense

    def _arc_tag(self, letter: str, radius: float, start: float, sweep: float) -> Tag:
        """A symbol of the driver outside an arc about its pivot."""
        units = [cmath.rect(1.0, start + share * sweep) for share in (0.5, 0.35, 0.65, 0.2, 0.8)]
        spots = tuple(self.pivot + radius * unit for unit in units)
        return Tag((Symbol(letter, self.driver),), spots, prefer=units[0], gap=0.8)

    # lettering

    def point_tags(self, names: Sequence[str] | None = None) -> list[Tag]:
        wanted = {p: z for p, z in self.points.items() if names is None or p in names}
        groups = together(wanted)
        return [
            Tag(joined([symbol(p) for p in group]), (place,), gap=self._room(group) + 0.7)
            for group, place in groups
        ]

    def _room(self, points: Sequence[str]) -> float:
        """Radius of the mark of points that coincide, mm."""
        return marks.JOINT if any(p in self.joints for p in points) else 0.5

    def number_tags(self, names: Sequence[str] | None = None) -> list[Tag]:
        chosen = [name for name in self.bodies if names is None or name in names]
        return [Tag((Symbol(name),), self._middles(name), gap=1.0) for name in chosen if self._middles(name)]

    def _middles(self, name: str) -> tuple[complex, ...]:
        """Where a link's number may stand: by its longest bar, in its plate, or by its block."""
        body = self.bodies[name]
        if body.plate:
            return (self.at(name, sum(body.plate) / len(body.plate)),)
        if body.bars:
            a, b = max(body.bars, key=lambda bar: abs(bar[1] - bar[0]))
            return tuple(self.at(name, a + share * (b - a)) for share in (0.5, 0.4, 0.6, 0.3, 0.7))
        corners = [self.block, self.block.conjugate(), -self.block, -self.block.conjugate()]
        return tuple(
            self.at(name, centre + corner * along) for centre, along in body.blocks for corner in corners
        )


def _view(mechanism: Mechanism, places: Arrays, turns: Arrays, mu: float, position: int) -> View:
    motion = Motion(mechanism, places, turns, mu)
    return View(motion, position, bodies(motion))


# --- all positions ---


def _superposed(view: View, paths: Arrays, traced: Sequence[str]) -> list[Item]:
    """The view over all other positions drawn thin, with trajectories and the places of the joints."""
    others = [replace(view, position=k) for k in range(view.motion.count) if k != view.position]
    faint = [item for other in others for item in other.skeleton(FAINT)]
    under = [*view.plates(), *view.frame(), *faint]
    return [*under, *_traces(view, paths, traced), *_position_dots(view), *view.links()]


def _grounded(view: View) -> set[str]:
    """Links that turn about a fixed point or slide on a fixed guide: their points go on arcs and straight lines."""
    turning = {name for links in view.joints.values() if FRAME in links for name in links}
    sliding = {s.link for s in view.mechanism.slides if view.mechanism.guides[s.guide].link == FRAME}
    return (turning | sliding) - {FRAME}


def _sliding(view: View) -> set[str]:
    return {s.link for s in view.mechanism.slides if view.mechanism.guides[s.guide].link == FRAME}


def _numbered(view: View) -> list[str]:
    """Joints of grounded links, whose places are marked."""
    grounded = _grounded(view)
    return [p for p, links in view.joints.items() if FRAME not in links and grounded & set(links)]


def _coupler_points(view: View) -> list[str]:
    mechanism, grounded = view.mechanism, _grounded(view) | {FRAME}
    centres = {link.mass_centre for link in mechanism.links.values()}
    points = [p for p in view.points if not grounded & set(mechanism.links_at(p))]
    return [p for p in points if p in view.joints or p not in centres]


def _traces(view: View, paths: Arrays, traced: Sequence[str]) -> list[Item]:
    """Circles of the driver's joints, trajectories of rockers' joints, coupler points and points asked for."""
    on_driver = [p for p in _numbered(view) if view.driver in view.joints[p]] if view.full_turn else []
    items: list[Item] = [Circle(view.pivot, abs(view.points[p] - view.pivot), FAINT) for p in on_driver]
    straight = {p for p in _numbered(view) if _sliding(view) & set(view.joints[p])}
    wanted = dict.fromkeys([*_numbered(view), *_coupler_points(view), *traced])
    for point in [p for p in wanted if p in paths and p not in straight and p not in on_driver]:
        pen = FAINT if point in _numbered(view) else TRACE
        items.append(polyline(_smooth(np.asarray(paths[point]) / view.motion.mu, view.full_turn), pen))
    return items


def _smooth(places: np.ndarray, closed: bool) -> list[complex]:
    """The path through the places; a closed one is refined by its own Fourier series, which a motion is."""
    places = places[np.isfinite(places)] if not closed else places
    if not closed or not np.isfinite(places).all():
        return [complex(z) for z in places[np.isfinite(places)]]
    count = len(places)
    fine = max(180, count)
    spectrum, wide = np.fft.fft(places), np.zeros(fine, complex)
    half = (count + 1) // 2
    wide[:half], wide[fine - (count - half) :] = spectrum[:half], spectrum[half:]
    curve = np.fft.ifft(wide) * fine / count
    return [complex(z) for z in (*curve, curve[0])]


def _position_places(view: View, point: str) -> dict[str, complex]:
    link = view.mechanism.links_at(point)[0]
    places = view.motion.at(link, view.motion.local(link, point))
    return {str(k): complex(z) for k, z in enumerate(places) if np.isfinite(z)}


def _position_dots(view: View) -> list[Item]:
    points = [*_numbered(view), *_coupler_points(view)]
    return [dot(z, 0.4) for p in points for z in _position_places(view, p).values()]


def _labelled(view: View) -> list[str]:
    """Joints whose places are numbered: of the driver's one is enough, the farthest from its pivot."""
    marked = _numbered(view)
    cranks = [p for p in marked if view.driver in view.joints[p]]
    farthest = max(cranks, key=lambda p: round(abs(view.points[p] - view.pivot), 3), default="")
    return [p for p in marked if p not in cranks or p == farthest]


def _position_tags(view: View, point: str) -> list[tuple[complex, Tag]]:
    """Numbers by the places of a joint, coinciding ones together (1=11): outside a circle, over a straight guide."""
    tags = []
    first = view.block.imag if _sliding(view) & set(view.joints[point]) else 0.0
    for names, place in together(_position_places(view, point)):
        out = _outside(view, point, place)
        hidden = first and abs(place - view.points[point]) < view.block.real  # under the block
        rises = (first if hidden else 0.0, *(first + SMALL * tier for tier in range(5)))
        tiers = tuple(place + rise * out for rise in rises) if out else (place,)
        tags.append((place, Tag(("=".join(names),), tiers, 0.9, out, SMALL, "blue")))
    return tags


def _with_numbers(drawing: Drawing, tags: Sequence[tuple[complex, Tag]]) -> Drawing:
    """The drawing with numbers of positions; those put far from their places are led to them by lines."""
    numbered = drawing.labelled([tag for _, tag in tags])
    leaders = []
    for (place, _), text in zip(tags, numbered.items[len(drawing.items) :], strict=True):
        x0, y0, x1, y1 = text.box if isinstance(text, Text) else numbered.box
        end = complex(min(max(place.real, x0), x1), min(max(place.imag, y0), y1))
        leaders += [line(place, end, LEADER)] if abs(end - place) > AWAY else []
    return replace(numbered, items=(*leaders, *numbered.items))


def _outside(view: View, point: str, place: complex) -> complex:
    for slide in view.mechanism.slides:
        guide = view.mechanism.guides[slide.guide]
        if slide.link in view.joints[point] and guide.link == FRAME:
            return -view._hatched_side(guide)
    fixed = [z for p, z in view.points.items() if FRAME in view.joints.get(p, []) and _share(view, p, point)]
    out = place - fixed[0] if fixed else 0j
    return out / abs(out) if out else 0j


def _share(view: View, one: str, other: str) -> bool:
    """Whether a moving link holds both points."""
    return bool((set(view.joints[one]) & set(view.joints[other])) - {FRAME})


# --- groups apart ---


def _taken_off(view: View, name: str, links: Sequence[str]) -> Drawing:
    """One group with its free half-joints, lettered, its name in the middle under it."""
    own = [link for link in links if link in view.bodies]
    items = [*view.plates(own), *_free_guides(view, links), *view.links(links)]
    items += [item for point in view.joints for item in _free_joint(view, point, links)]
    if FRAME in links:
        fixed = [
            view.points[p] for p, names in view.joints.items() if FRAME in names and set(own) & set(names)
        ]
        items = [*(item for z in fixed for item in marks.support(z)), *items]
        items += view.rotation()
    shown = [p for p in view.points if set(view.mechanism.links_at(p)) & set(own)]
    tags = view.point_tags(shown) + view.number_tags(own)
    tags += view.rotation_tags() if FRAME in links else []
    drawing = Drawing(tuple(items)).labelled(tags)
    left, bottom, right, _ = drawing.box
    return Drawing((*drawing.items, Text(complex((left + right) / 2, bottom - 4), (name,), align=0)))


def _free_joint(view: View, point: str, links: Sequence[str]) -> list[Item]:
    """The half of a joint whose other links belong elsewhere."""
    own = [name for name in view.joints[point] if name in links]
    if len(own) != 1 or own[0] == FRAME or own[0] not in view.bodies:
        return []
    body, local = view.bodies[own[0]], view.motion.local(own[0], point)
    if view._passes(own[0], point):
        return view._joint(point)
    ends = [z for bar in body.bars for z in bar] + list(body.plate)
    inward = sum(z - local for z in ends)
    out = -inward / abs(inward) if abs(inward) > NEAR else 0j
    return (
        marks.half_joint(view.points[point], out * view.turn(own[0]))
        if out
        else marks.joint(view.points[point])
    )


def _free_guides(view: View, links: Sequence[str]) -> list[Item]:
    """Guides that stay elsewhere, under the group's own blocks and rods."""
    items: list[Item] = []
    for slide in view.mechanism.slides:
        guide = view.mechanism.guides[slide.guide]
        if slide.link not in links or guide.link in links or slide.link not in view.bodies:
            continue
        along = view.turn(guide.link) * number(guide.direction)
        centre = view.at(slide.link, number(slide.through) / view.motion.mu)
        if is_rod(view.motion, slide):
            items += marks.bushing(
                view.motion.on_guide(guide, bushing(view.motion, slide)), along, fixed=False
            )
        else:
            items += marks.axis(centre - 2.2 * BLOCK.real * along, centre + 2.2 * BLOCK.real * along)
    return items


def _in_rows(drawings: Sequence[Drawing], gap: float = 6.0) -> tuple[Item, ...]:
    """Drawings set in rows not wider than the page, their feet on one line."""
    items: list[Item] = []
    x = y = 0.0
    row: list[tuple[Drawing, float]] = []
    for drawing in [*drawings, None]:
        if row and (drawing is None or x + drawing.size[0] > PAGE[0] - 2):
            y -= max(one.size[1] for one, _ in row)
            items += [
                item for one, at in row for item in one.moved(complex(at, y) - complex(*one.box[:2])).items
            ]
            x, y, row = 0.0, y - gap, []
        if drawing is not None:
            row.append((drawing, x))
            x += drawing.size[0] + gap
    return tuple(items)
