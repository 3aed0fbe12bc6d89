"""Diagrams of linear and angular velocities of a compound train beside its scheme, mm of paper."""

from __future__ import annotations

from tmm_report.chapters.gears.train.draw.scheme import Scheme
from tmm_report.chapters.gears.train.draw.turning import turning
from tmm_report.chapters.gears.train.solve.plans import Plans
from tmm_report.chapters.gears.train.solve.train import Found
from tmm_report.figures.drawing import AXIS, NORMAL, THIN, Arrow, Drawing, Item, Pen, Tag, dot, line
from tmm_report.figures.lettering import Parts, joined, symbol

GAP = 10.0
HEAD = 3.0
COLOURED = ("blue", "red", "green", "black")
PAGE = 160.0


def diagrams(found: Found, title: str) -> Drawing | None:
    """None where the axes do not lie in one plane."""
    plans = found.plans
    if plans is None:
        return None
    drawn = Scheme(found)
    items, tags = drawn.parts()
    left, bottom, right, _ = Drawing(tuple(items)).box
    speeds = [spot.v / plans.velocity for spot in plans.spots]
    if not beside(found):
        items, tags, right, bottom = [], [], left - GAP, 0.0
    zero = right + GAP - min(0.0, *speeds)
    linear = _Linear(found, plans, zero)
    low = min([bottom, *(spot.y / plans.length for spot in plans.spots)])
    segments = [omega / plans.angular for _, omega, _, _ in plans.lines.values()]
    origin = complex(left + 4 - min(0.0, *segments), low - GAP - 4)
    more, named = _angular(found, plans, origin)
    guides = linear.guides(left) if items else []
    whole = (*guides, *items, *linear.items(), *more)
    moves = turning(drawn) if items else None
    return Drawing(whole, title, moves=moves).labelled([*tags, *linear.tags(), *named])


def beside(found: Found) -> bool:
    """Whether the scheme stands beside the diagrams, or is so wide that it has a figure of its own."""
    if found.plans is None:
        return False
    left, _, right, _ = Drawing(tuple(Scheme(found).parts()[0])).box
    speeds = [spot.v / found.plans.velocity for spot in found.plans.spots]
    return right - left + GAP + max(0.0, *speeds) - min(0.0, *speeds) <= PAGE


def _names(found: Found, body: str) -> Parts:
    return joined([symbol(m.name) for m in found.train.members if m.body == body])


def _pen(index: int) -> Pen:
    return Pen(0.4, COLOURED[index % len(COLOURED)])


class _Linear:
    """Velocity over the height above the main axis; the axis of heights stands at x = `zero`."""

    def __init__(self, found: Found, plans: Plans, zero: float):
        self.found, self.plans, self.zero = found, plans, zero
        self.moving = [(k, body, line) for k, (body, line) in enumerate(plans.lines.items()) if line[1]]

    def at(self, v: float, y: float) -> complex:
        return complex(self.zero + v / self.plans.velocity, y / self.plans.length)

    def guides(self, left: float) -> list[Item]:
        heights = sorted({0.0, *(spot.y for spot in self.plans.spots)})
        return [line(complex(left + 12, self.at(0, y).imag), self.at(0, y), AXIS) for y in heights]

    def ends(self, line_: tuple[float, float, float, float]) -> tuple[complex, complex]:
        at_zero, omega, low, high = line_
        return self.at(at_zero + omega * low, low), self.at(at_zero + omega * high, high)

    def items(self) -> list[Item]:
        heights = [0.0, *(spot.y for spot in self.plans.spots)]
        low, high = self.at(0, min(heights)) - 4j, self.at(0, max(heights)) + 4j
        found: list[Item] = [line(low, high, THIN), Arrow(high, high + HEAD, THIN), dot(self.at(0, 0))]
        for k, _, line_ in self.moving:
            found.append(line(*self.ends(line_), _pen(k)))
        for spot in self.plans.spots:
            foot, tip = self.at(0, spot.y), self.at(spot.v, spot.y)
            found += [Arrow(foot, tip, THIN)] if abs(tip - foot) > 0.05 else []
            found.append(dot(foot))
        return found

    def tags(self) -> list[Tag]:
        heights = [0.0, *(spot.y for spot in self.plans.spots)]
        high = self.at(0, max(heights)) + 4j
        found = [Tag((symbol("v"),), (high + HEAD,), prefer=1 + 0j)]
        found.append(Tag((symbol("O"),), (self.at(0, 0),), prefer=-1 - 1j))
        for spot in self.plans.spots:
            foot, tip = self.at(0, spot.y), self.at(spot.v, spot.y)
            found.append(Tag((symbol(spot.name),), (foot,), prefer=complex(1 if spot.v < 0 else -1, 1)))
            if abs(tip - foot) > 2:
                way = complex(1 if spot.v > 0 else -1, 0)
                found.append(Tag((symbol(spot.name.lower()),), (tip,), prefer=way))
        for k, body, line_ in self.moving:
            start, end = self.ends(line_)
            places = tuple(start + part * (end - start) for part in (0.6, 0.4, 0.75, 0.25))
            colour = COLOURED[k % len(COLOURED)]
            found.append(Tag(_names(self.found, body), places, gap=0.8, colour=colour))
        return found


def _angular(found: Found, plans: Plans, origin: complex) -> tuple[list[Item], list[Tag]]:
    """Segments of angular velocities from the point s0 at `origin`; the pole P below it at the pole distance."""
    pole = origin - 1j * plans.pole
    ends = {body: omega / plans.angular for body, (_, omega, _, _) in plans.lines.items()}
    start, end = origin + min(0.0, *ends.values()) - 2, origin + max(0.0, *ends.values()) + HEAD
    items: list[Item] = [line(start, end, NORMAL), Arrow(end - HEAD, end, THIN), line(pole, origin, THIN)]
    still = [m.name for m in found.train.members if not found.speed[m.name]]
    tags = [
        Tag((symbol("ω"),), (end,), prefer=-1j),
        Tag((symbol("P"),), (pole,), prefer=-1j),
        Tag((symbol("h"),), ((pole + origin) / 2,), prefer=1 + 0j),
        Tag(joined([symbol("s_0"), *map(symbol, still)]), (origin,), prefer=1j),
    ]
    for k, (body, s) in enumerate(ends.items()):
        if s:
            items += [line(pole, origin + s, _pen(k)), dot(origin + s)]
            colour = COLOURED[k % len(COLOURED)]
            tags.append(Tag(_names(found, body), (origin + s,), prefer=1j, colour=colour))
    return [*items, dot(origin), dot(pole)], tags
