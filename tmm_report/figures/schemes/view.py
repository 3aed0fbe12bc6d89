"""One position of a motion as items of a drawing: the frame, the links, the driver's turning, the lettering."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import combinations

import numpy as np

from tmm_report.figures.drawing import (
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Circle,
    Item,
    Pen,
    Tag,
    dot,
    line,
    polygon,
    together,
)
from tmm_report.figures.lettering import Symbol, joined, symbol
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.bodies import (
    BLOCK,
    NEAR,
    PAST,
    Body,
    Motion,
    bodies,
    bushing,
    held_at,
    is_rod,
    number,
)
from tmm_report.figures.schemes.fixed_wheels import fixed
from tmm_report.figures.schemes.ties import Tie, Ties
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Mechanism, Slide
from tmm_report.records import dataclass

LETTERED = 6.0  # mm about a point that its letter takes
ARROW = 9.0  # mm, of a driving stroke
SEEN = 0.15  # the least angle that is marked, rad

Arrays = Mapping[str, np.ndarray]


@dataclass(frozen=True, eq=False)
class View:
    """One position of a motion, seen as items of a drawing; links that do not assemble are left out."""

    motion: Motion
    position: int
    shapes: Mapping[str, Body]  # the same in all positions
    ties: Sequence[Tie] = ()  # springs and dampers

    @property
    def mechanism(self) -> Mechanism:
        return self.motion.mechanism

    @cached_property
    def bodies(self) -> dict[str, Body]:
        """The links that assemble in this position."""
        return {name: body for name, body in self.shapes.items() if cmath.isfinite(self.at(name, 0))}

    @cached_property
    def tied(self) -> Ties:
        return Ties(self.motion, self.position, self.ties)

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

    def frame(self) -> list[Item]:
        items: list[Item] = []
        for slide in self.mechanism.slides:
            guide = self.mechanism.guides[slide.guide]
            if guide.link == FRAME:
                items += self._fixed_slide(slide, guide)
        items += fixed(self.motion)
        for point, names in self.joints.items():
            items += marks.support(self.points[point]) if FRAME in names else []
        bare = self.cylinder and self._fixed(self.cylinder[0]) and self.cylinder[0]
        items += marks.support(self.points[bare]) if bare and bare not in self.joints else []
        stands = [self.points[p] for p, names in self.joints.items() if FRAME in names]
        held = [z for z in self.tied.fixed if all(abs(z - other) > NEAR for other in stands)]
        items += [item for z in held for item in marks.support(z)]
        guiding = [p for p in self.points if self._fixed(p) and p not in self.joints and p != bare]
        guiding = [p for p in guiding if all(abs(self.points[p] - z) > NEAR for z in held)]
        return items + [item for p in guiding for item in marks.place(self.points[p])]

    def _fixed_slide(self, slide: Slide, guide: Guide) -> list[Item]:
        along = number(guide.direction)
        if is_rod(self.motion, slide):
            return marks.bushing(self.motion.on_guide(guide, bushing(self.motion, slide)), along)
        low, high = self.motion.travel(slide)
        margin = BLOCK.real + PAST
        ends = [self.motion.on_guide(guide, low - margin), self.motion.on_guide(guide, high + margin)]
        return marks.fixed_guide(ends[0], ends[1], self.hatched_side(guide)) + self._axis(guide, ends)

    def _axis(self, guide: Guide, ends: Sequence[complex]) -> list[Item]:
        """The axis of a fixed guide, drawn on to the fixed pivots that lie on it."""
        along, origin = number(guide.direction), ends[0]
        fixed = [place for point, place in self.points.items() if self._fixed(point)]
        offsets = [(place - origin) / along for place in fixed]
        reach = [z.real for z in offsets if abs(z.imag) < NEAR] + [0.0, ((ends[1] - origin) / along).real]
        return marks.axis(origin + min(reach) * along, origin + max(reach) * along)

    def hatched_side(self, guide: Guide) -> complex:
        """The lower side of a guide; of an upright one the side away from the driver's pivot."""
        side = 1j * number(guide.direction)
        if abs(side.imag) > 0.1:
            return side if side.imag < 0 else -side
        away = self.motion.on_guide(guide, 0.0) - self.pivot
        return side if (away.conjugate() * side).real > 0 else -side

    def links(self, names: Sequence[str] | None = None) -> list[Item]:
        """The links drawn thick, with blocks, joints and mass centres."""
        chosen = [name for name in self.bodies if names is None or name in names]
        items = [] if names is not None else [*self.tied.items(), *self._held()]
        items += [*self._ties_of_centres(chosen), *self.skeleton(THICK, chosen)]
        for name in chosen:
            for outline in self.bodies[name].outlines:
                items.append(polygon([self.at(name, z) for z in outline], NORMAL))
            items += [Circle(self.at(name, z), r, NORMAL, "white") for z, r in self.bodies[name].rollers]
        for name in chosen:
            for centre, along in self.bodies[name].blocks:
                items += marks.block(self.at(name, centre), self.turn(name) * along, self.block)
        joints = [
            point for point, links in self.joints.items() if names is None or len(set(links) & set(names)) > 1
        ]
        items += [item for point in joints for item in self.joint_mark(point)]
        if names is None and self.cylinder:
            items += marks.cylinder(
                self.points[self.cylinder[0]], self.points[self.cylinder[1]], *self.lengths
            )
        centres = {self.mechanism.links[name].mass_centre for name in chosen}
        single = [p for name in chosen for p in self.mechanism.links[name].points if p not in self.joints]
        return items + [dot(self.points[p], 0.7 if p in centres else 0.5) for p in single if p in self.points]

    def _ties_of_centres(self, names: Sequence[str]) -> list[Item]:
        """Thin lines from the links to those of their mass centres that would float beside them."""
        items: list[Item] = []
        for name in names:
            centre = self.mechanism.links[name].mass_centre
            if centre in self.points and centre not in self.joints:
                local = self.motion.local(name, str(centre))
                ends = held_at(self.bodies[name], local)
                items += [line(self.at(name, end), self.at(name, local), THIN) for end in ends]
        return items

    def _held(self) -> list[Item]:
        """The pivots on the frame of springs and dampers."""
        return [item for z in self.tied.fixed for item in marks.joint(z)]

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
        corners += [
            [self.at(name, z) for z in outline] for name in chosen for outline in self.bodies[name].outlines
        ]
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

    def joint_mark(self, point: str) -> list[Item]:
        items = marks.joint(self.points[point])
        if any(abs(self.at(name, z) - self.points[point]) < NEAR for name, z in self._block_centres()):
            return items
        through = [u for name in self.joints[point] if name != FRAME and (u := self.passes(name, point))]
        return items + (marks.passing(self.points[point], through[0]) if len(through) == 1 else [])

    def _block_centres(self) -> list[tuple[str, complex]]:
        return [(name, centre) for name, body in self.bodies.items() for centre, _ in body.blocks]

    def passes(self, name: str, point: str) -> complex:
        """Unit direction of a bar of the link that passes straight through the point; 0 where none does."""
        body, place = self.bodies.get(name, Body()), self.motion.local(name, point)
        for a, b in body.bars:
            along = (b - a) / abs(b - a)
            share = (place - a) / along
            if abs(share.imag) < NEAR and marks.JOINT < share.real < abs(b - a) - marks.JOINT:
                return along * self.turn(name)
        return 0j

    # a driving slider or cylinder

    @cached_property
    def cylinder(self) -> tuple[str, str] | None:
        """The points between which a driving cylinder is whose barrel and rod are no links of the mechanism."""
        stroke = self.mechanism.driver.stroke
        if stroke is None or stroke.slides or stroke.by:
            return None
        far, pin = stroke.ends
        return (far, pin) if {far, pin} <= self.points.keys() else None

    @cached_property
    def lengths(self) -> tuple[float, float]:
        """The least and the greatest length of the cylinder over the motion, mm."""
        stroke = self.mechanism.driver.stroke
        assert stroke is not None
        low, high = stroke.law.reach
        return low / self.motion.mu, high / self.motion.mu

    @cached_property
    def _travel(self) -> tuple[complex, complex] | None:
        """Ends of the arrow by which a driving stroke begins, beside the slider or the cylinder."""
        stroke = self.mechanism.driver.stroke
        if stroke is None or not {*stroke.ends} <= self.points.keys():
            return None
        far, pin = (self.points[name] for name in (stroke.ends[0], stroke.ends[-1]))
        along = stroke.way if stroke.slides else (pin - far) / abs(pin - far)
        sense = 1 if float(np.ravel(stroke.law.of_phase(0.01)[1])[0]) >= 0 else -1
        middle = far if stroke.slides else (pin + far) / 2
        middle += (BLOCK.imag + 2.5) * 1j * along * (1 if (1j * along).imag >= 0 else -1)
        half = ARROW / 2 * sense * along
        return middle - half, middle + half

    def driving(self) -> list[Item]:
        """The arrow of the stroke that drives, else of the driver's rotation."""
        return [Arrow(*self._travel, THIN)] if self._travel else self.rotation()

    def driving_tags(self) -> list[Tag]:
        if self._travel is None:
            return self.rotation_tags()
        start, end = self._travel
        return [Tag((Symbol("v", "s"),), (end, (start + end) / 2, start), gap=0.8)]

    # the driver's turning

    @cached_property
    def crank(self) -> tuple[float, int]:
        """Length of the driver on paper, mm, and its sense of rotation."""
        reach, law = abs(self._arm - self.pivot), self.mechanism.driver.law
        rate = number(self.mechanism.driver.omega).real if law is None else float(law.of_phase(0.01)[1])
        return reach or 20.0, 1 if rate >= 0 else -1

    @cached_property
    def _arm(self) -> complex:
        """The driver's joint that is farthest from its pivot, which stands for one that has none."""
        ends = [self.points[p] for p in self.mechanism.links[self.driver].points if p in self.joints]
        return max(ends, key=lambda end: round(abs(end - self.pivot), 3), default=self.pivot)

    @cached_property
    def start(self) -> float:
        """Direction of the driver's arm in position 0, rad."""
        turned = self.turn(self.driver) / complex(self.motion.axes[self.driver][0])
        return cmath.phase((self._arm - self.pivot or turned) / turned)

    def _angle(self, zero: complex) -> tuple[float, float, float]:
        """Radius of the arc of the driver's angle, where it starts, and the signed angle, rad."""
        length, sense = self.crank
        angle = sense * cmath.phase(self.turn(self.driver) / zero)
        if self.full_turn:
            angle %= 2 * math.pi
        return min(max(0.45 * length, 5.0), 9.0), cmath.phase(zero), sense * angle

    @property
    def full_turn(self) -> bool:
        law = self.mechanism.driver.law
        sweep = self.mechanism.driver.sweep if law is None else law.reach[1] - law.reach[0]
        return sweep >= 2 * math.pi - 1e-9

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
        length, sense = self.crank
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
        """Where a link's number may stand: by its longest bar, in its plate, or by its block; off its points."""
        body = self.bodies[name]
        if body.plate:
            middle = sum(body.plate) / len(body.plate)
            return self._off_points(name, (middle, *(0.55 * middle + 0.45 * corner for corner in body.plate)))
        if body.bars:
            a, b = max(body.bars, key=lambda bar: abs(bar[1] - bar[0]))
            return self._off_points(name, [a + share * (b - a) for share in (0.5, 0.4, 0.6, 0.3, 0.7)])
        if not body.blocks and any(name in mesh.links for mesh in self.mechanism.meshes):  # a wheel by itself
            rim = body.outlines[0]
            middle = sum(rim[1:]) / len(rim[1:])
            return tuple(
                self.at(name, 0.4 * middle + 0.6 * rim[k]) for k in range(0, len(rim), len(rim) // 8)
            )
        corners = [self.block, self.block.conjugate(), -self.block, -self.block.conjugate()]
        return tuple(
            self.at(name, centre + corner * along) for centre, along in body.blocks for corner in corners
        )

    def _off_points(self, name: str, places: Sequence[complex]) -> tuple[complex, ...]:
        """Places given in a link's axes; first those at which no point of it is lettered."""
        points = [self.motion.local(name, point) for point in self.mechanism.links[name].points]
        crowded = {place: any(abs(place - point) < LETTERED for point in points) for place in places}
        return tuple(self.at(name, place) for place in sorted(places, key=crowded.__getitem__))


def view_of(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu: float,
    position: int,
    ties: Sequence[Tie] = (),
) -> View:
    motion = Motion(mechanism, places, turns, mu)
    return View(motion, position, bodies(motion), ties)
