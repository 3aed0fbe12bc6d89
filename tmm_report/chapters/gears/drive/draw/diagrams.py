"""Pictures of a gear drive: its kinematic scheme, and beside the scheme the diagrams of velocities, mm of paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tmm_report.chapters.gears.drive.draw.scheme import scheme
from tmm_report.chapters.gears.drive.draw.sketch import Sketch
from tmm_report.chapters.gears.drive.plans import Plans
from tmm_report.chapters.gears.drive.sheet import Line
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.figures.drawing import AXIS, NORMAL, THIN, Arrow, Drawing, Item, Pen, Tag, dot, line
from tmm_report.figures.lettering import Parts, joined, symbol

AXIS_ARROW = 3.0  # mm
GAP = 8.0  # mm: between the scheme and the diagram, and above the plan of angular velocities
PAGE = 162.0  # mm: the widest drawing that is not reduced, less the lettering at its end
COLOURED = ("blue", "red", "green", "black")


def kinematic_scheme(
    stages: Sequence[Stage], plans: Plans, speed: Mapping[str, float], title: str = ""
) -> Drawing:
    """The scheme alone, with the numbers of the wheels and the speeds of the input and the output."""
    sketch = scheme(stages, plans, speed)
    return Drawing(tuple(sketch.items), title, moves=sketch.moves).labelled(sketch.tags)


def velocities(stages: Sequence[Stage], plans: Plans, speed: Mapping[str, float], title: str = "") -> Drawing:
    """The scheme with the diagram of linear velocities beside it and the plan of angular velocities below."""
    sketch = scheme(stages, plans, speed)
    left, bottom, right, top = Drawing(tuple(sketch.items)).box
    zero = right + GAP - min(0.0, *plans.velocity.values())
    if not beside(stages, plans, speed):
        sketch, zero = Sketch(plans, speed), left - min(0.0, *plans.velocity.values())
        heights = [y / plans.length_scale for y in (*plans.axes.values(), *(spot.y for spot in plans.spots))]
        bottom, top = min(heights) - AXIS_ARROW, max(heights) + AXIS_ARROW
    linear = _Linear(stages, plans, zero, (bottom, top))
    guides = linear.guides() if sketch.items else []
    items, tags = [*guides, *sketch.items, *linear.items()], [*sketch.tags, *linear.tags()]
    segments = [line_.s for line_ in plans.lines]
    angular = _Angular(plans, complex(left + 2 - min(0.0, *segments), bottom - GAP))
    whole = Drawing((*items, *angular.items()), title, moves=sketch.moves)
    return whole.labelled([*tags, *angular.tags()])


def beside(stages: Sequence[Stage], plans: Plans, speed: Mapping[str, float]) -> bool:
    """Whether the scheme stands beside the diagrams, or is so wide that it has a figure of its own."""
    right, speeds = Drawing(tuple(scheme(stages, plans, speed).items)).box[2], plans.velocity.values()
    return right + GAP - min(0.0, *speeds) + max(0.0, *speeds) <= PAGE


def _names(line_: Line) -> Parts:
    return joined([symbol(name) for name in line_.members])


def _pen(index: int) -> Pen:
    return Pen(0.4, COLOURED[index % len(COLOURED)])


class _Linear:
    """Velocity against the place on the line of centres; the axis of places stands at x = `zero`."""

    def __init__(self, stages: Sequence[Stage], plans: Plans, zero: float, reach: tuple[float, float]):
        self.stages, self.plans, self.zero, self.reach = stages, plans, zero, reach
        self.heights = {spot.name: spot.y / plans.length_scale for spot in plans.spots}

    def at(self, point: complex) -> complex:
        return point + self.zero

    def tip(self, name: str) -> complex:
        return self.at(complex(self.plans.velocity[name], self.heights[name]))

    def guides(self) -> list[Item]:
        """Thin lines from the scheme to the axis of places, at every point and every fixed axis."""
        heights = {round(y, 3) for y in (*self.heights.values(), *self._axes().values())}
        return [line(complex(0, y), complex(self.zero, y), AXIS) for y in sorted(heights)]

    def _axes(self) -> dict[str, float]:
        """Heights of the axes that stand still by the first member there."""
        found: dict[str, float] = {}
        for stage in self.stages:
            for member in stage.members:
                y = self.plans.axes[member.name] / self.plans.length_scale
                if not member.carried_by and all(abs(y - other) > 0.05 for other in found.values()):
                    found[member.name] = y
        return found

    def items(self) -> list[Item]:
        low, high = self.reach
        found: list[Item] = [line(complex(self.zero, low), complex(self.zero, high), THIN)]
        found.append(Arrow(complex(self.zero, high), complex(self.zero + AXIS_ARROW, high), THIN))
        found += [dot(complex(self.zero, y)) for y in self._axes().values()]
        for index, line_ in enumerate(self.plans.lines):
            if line_.s:
                start, end = self._whole(line_)
                found.append(line(self.at(start), self.at(end), _pen(index)))
        for name, v in self.plans.velocity.items():
            foot = complex(self.zero, self.heights[name])
            found += [Arrow(foot, foot + v, THIN)] if abs(v) > 0.05 else []
            found.append(dot(foot))
        return found

    def _whole(self, line_: Line) -> tuple[complex, complex]:
        """The line over all points of its members."""
        low, high = line_.ends
        slope = (high - low).real / (high - low).imag
        names = [s.name for s in self.plans.spots if set(s.members) & set(line_.members)]
        ys = sorted([low.imag, high.imag, *(self.heights[name] for name in names)])
        return complex(low.real + slope * (ys[0] - low.imag), ys[0]), complex(
            low.real + slope * (ys[-1] - low.imag), ys[-1]
        )

    def tags(self) -> list[Tag]:
        found = [Tag((symbol("v"),), (complex(self.zero + AXIS_ARROW, self.reach[1]),), prefer=1 + 0j)]
        for name, y in self._axes().items():
            found.append(Tag((symbol(f"O_{name}"),), (complex(self.zero, y),), prefer=-1 + 1j))
        for name, v in self.plans.velocity.items():
            foot = complex(self.zero, self.heights[name])
            found.append(Tag((symbol(name),), (foot,), prefer=complex(1 if v < 0 else -1, 1)))
            if abs(v) > 2:
                found.append(Tag((symbol(name.lower()),), (foot + v,), prefer=complex(1 if v > 0 else -1, 0)))
        for index, line_ in enumerate(self.plans.lines):
            if line_.s:
                start, end = map(self.at, self._whole(line_))
                places = tuple(start + part * (end - start) for part in (0.6, 0.4, 0.75, 0.25))
                colour = COLOURED[index % len(COLOURED)]
                found.append(Tag(_names(line_), places, gap=0.8, colour=colour))
        return found


class _Angular:
    """Segments of angular velocities from the point s0 at `origin`; the pole P stands below it at the pole distance."""

    def __init__(self, plans: Plans, origin: complex):
        self.plans, self.origin = plans, origin
        self.pole = origin - 1j * plans.pole
        self.ends = [line_.s for line_ in plans.lines]

    def items(self) -> list[Item]:
        start = self.origin + min(0.0, *self.ends) - 2
        end = self.origin + max(0.0, *self.ends) + AXIS_ARROW
        found: list[Item] = [line(start, end, NORMAL), Arrow(end - AXIS_ARROW, end, THIN)]
        found.append(line(self.pole, self.origin, THIN))
        for index, line_ in enumerate(self.plans.lines):
            if line_.s:
                found.append(line(self.pole, self.origin + line_.s, _pen(index)))
                found.append(dot(self.origin + line_.s))
        return [*found, dot(self.origin), dot(self.pole)]

    def tags(self) -> list[Tag]:
        still = [symbol(name) for line_ in self.plans.lines if not line_.s for name in line_.members]
        found = [
            Tag((symbol("ω"),), (self.origin + max(0.0, *self.ends) + AXIS_ARROW,), prefer=-1j),
            Tag((symbol("P"),), (self.pole,), prefer=-1j),
            Tag((symbol("h"),), (self.pole / 2 + self.origin / 2,), prefer=1 + 0j),
            Tag(joined([symbol("s_0"), *still]), (self.origin,), prefer=1j),
        ]
        for index, line_ in enumerate(self.plans.lines):
            if line_.s:
                colour = COLOURED[index % len(COLOURED)]
                found.append(Tag(_names(line_), (self.origin + line_.s,), prefer=1j, colour=colour))
        return found
