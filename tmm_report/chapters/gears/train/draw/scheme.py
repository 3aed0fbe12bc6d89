"""Kinematic scheme of a compound train in the conventional signs (GOST 2.770), the half above the main axis.

Wheels in mesh stand in one plane; a wheel is a rim on a web, a ring's rim lies outside its pitch line; shafts about the
main axis are drawn one above another, the innermost on the axis. Bevel wheels have their rims along their cones. Across
the shafts the scheme is to scale, along them it is not; mm of paper.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from tmm_report.chapters.gears.train.draw.routes import Bar, Route, best, crossings
from tmm_report.chapters.gears.train.draw.turning import turning
from tmm_report.chapters.gears.train.solve.train import Found
from tmm_report.figures.drawing import AXIS, NORMAL, THICK, THIN, Arrow, Drawing, Item, Tag, line
from tmm_report.figures.lettering import symbol
from tmm_report.figures.schemes.marks import ground
from tmm_report.mechanics.gears.trains import Member

COLUMN, BESIDE = 24.0, 9.0  # from plane to plane, between two rings of one plane
RIM, CLEAR = 3.0, 0.45  # half the length of a rim; from its pitch line
DISC, ARM = 8.5, 6.0  # from a plane to the web of a ring, to the arm of a carrier
LEVEL = 3.6  # from shaft to shaft, at most
END = 9.0  # of a shaft beyond what stands beside it
OVER = 4.0  # above all else, of what goes round outside


def scheme(found: Found, title: str = "") -> Drawing:
    return Scheme(found).drawing(title)


class Scheme:
    def __init__(self, found: Found):
        self.found, self.built, self.train = found, found.built, found.train
        self.places = found.places
        self.scale = self.places.scale
        self.held = {found.built.body(name) for name in found.given.fixed}
        self.x: dict[str, float] = {}
        self.wide: dict[str, float] = {}  # how far the rim of a wheel reaches to the right of its place
        self._columns()
        self.left, self.right = min(self.x.values()) - 14, max(self.x.values()) + 14
        main = [b for b in self.train.bodies if self._axis(b) == self.places.main and not self._carried(b)]
        self.main = main if found.given.carriers or found.built.bevel else []
        least = min((r for name, r in self.places.radius.items()), default=1.0) / self.scale
        self.step = min(LEVEL, 0.8 * least / max(1, len(self.main)))
        self.route = self._routed()

    # ------------------------------------------------------------ places

    def _axis(self, body: str) -> str:
        return self.places.axis[body]

    def _carried(self, body: str) -> bool:
        return any(m.carried_by for m in self.train.members if m.body == body)

    def y(self, name: str) -> float:
        return self.places.height[name] / self.scale

    def r(self, name: str) -> float:
        return self.places.radius[name] / self.scale

    def half(self, name: str) -> float:
        """From the axis of a wheel to its rim as it is drawn."""
        return self.r(name) + (CLEAR if self.train.by_name[name].kind == "ring" else -CLEAR)

    def rim(self, name: str) -> tuple[float, float]:
        """The ends of its rim, along the axis."""
        return self.x[name] - RIM, self.x[name] + self.wide[name] + RIM

    def _top(self, name: str) -> float:
        return self.y(name) + self.r(name)

    def _members(self, body: str) -> list[Member]:
        return [m for m in self.train.members if m.body == body]

    def _columns(self) -> None:
        """A plane for every group of wheels in mesh; several rings, or suns, stand side by side in it."""
        at = 0.0
        done: set[str] = set()
        for first in [m.name for m in self.train.members if m.teeth]:
            if first in done:
                continue
            group, bevel = self._group(first)
            done |= set(group)
            at = self._bevel_column(group, at) if bevel else self._flat_column(group, at)

    def _group(self, first: str) -> tuple[list[str], bool]:
        """Wheels that meshes of one kind join."""
        kind = next(flat for m, flat in self._meshes() if first in (m.i, m.j))
        found = [first]
        for name in found:
            for mesh, flat in self._meshes():
                if flat == kind and name in (mesh.i, mesh.j):
                    found += [one for one in (mesh.i, mesh.j) if one not in found]
        return found, not kind

    def _meshes(self) -> Iterator[tuple]:
        return zip(self.train.meshes, self.built.flat, strict=True)

    def _flat_column(self, group: list[str], at: float) -> float:
        counts: dict[tuple[str, bool], int] = {}
        for name in group:
            ring = self.train.by_name[name].kind == "ring"
            key = (self.places.axis[name], ring)
            self.x[name] = at + BESIDE * counts.get(key, 0)
            counts[key] = counts.get(key, 0) + 1
        most = BESIDE * (max(counts.values()) - 1)
        for name in group:
            mates = [m.j if m.i == name else m.i for m in self.train.meshes if name in (m.i, m.j)]
            self.wide[name] = max([0.0, *(self.x[mate] - self.x[name] for mate in mates if mate in group)])
        return at + most + COLUMN

    def _bevel_column(self, group: list[str], at: float) -> float:
        """Wheels about the main axis on both sides of the one across it."""
        across = self.across(group)
        reach = self.r(across)
        middle = at + reach
        self.x[across] = middle
        sides = [name for name in group if name != across]
        for k, name in enumerate(sides):
            way = -1 if k % 2 == 0 and len(sides) > 1 else 1
            self.x[name] = middle + way * reach
        return at + 2 * reach + COLUMN

    def across(self, group: list[str]) -> str:
        """Of bevel wheels the one whose axis lies across the main one: a satellite, else what is not on it."""
        satellites = [name for name in group if name in self.built.carried]
        aside = [name for name in group if self.places.axis[name] != self.places.main]
        return (satellites or aside or group)[0]

    # ------------------------------------------------------------ routes

    def _routed(self) -> Route:
        sided = [
            m.name
            for m in self.train.members
            if (m.kind == "carrier" and self._pinned(m.name))
            or (m.body in self.main and (m.kind == "ring" or (m.body in self.held and m.teeth)))
        ]
        free = [b for b in self.main if self._may_go_outside(b)]
        inputs = {self.built.body(name) for name in self.built.inputs}
        order = sorted(self.main, key=lambda body: (body not in inputs, body in self.held))
        right = frozenset(name for name in sided if self.built.body(name) not in inputs)
        start = Route(tuple(order), right)
        tried = [start, Route(tuple(order), frozenset()), Route(tuple(reversed(order)), right)]
        tried += [Route(tuple(order), right, frozenset({body})) for body in free]
        routes = [best(one, sided, free, self.bars) for one in tried]
        return min(routes, key=lambda one: crossings(self.bars(one)))

    def _may_go_outside(self, body: str) -> bool:
        """What has no sun, and more than one place to go to."""
        members = self._members(body)
        suns = [m for m in members if m.teeth and m.kind != "ring" and not self._is_bevel(m.name)]
        return not suns and len(members) > 1

    def _is_bevel(self, name: str) -> bool:
        return name in self.built.bevel

    def _pinned(self, carrier: str) -> list[str]:
        """Its satellites with axes along the main one."""
        return [n for n, of in self.built.carried.items() if of == carrier and not self.built.tilted(n)]

    def level(self, route: Route, body: str) -> float:
        inside = [one for one in route.order if one not in route.outside and not self._only_ground(one)]
        return self.step * inside.index(body) if body in inside else 0.0

    def _only_ground(self, body: str) -> bool:
        """A held ring, whose stem goes to the frame at once."""
        members = self._members(body)
        return body in self.held and len(members) == 1 and members[0].kind == "ring"

    def over(self, body: str) -> float:
        """The height at which a body goes round outside: above all that turns about the axis but itself."""
        others = [
            name
            for name in self.x
            if (self._carried(self.built.body(name)) or self.built.body(name) in self.main)
            and self.built.body(name) != body
        ]
        tops = [self.cone(n).imag if self.built.tilted(n) else self._top(n) for n in others]
        rings = [self.r(m.name) for m in self._members(body) if m.kind == "ring"]
        return max([*tops, *rings]) + OVER

    def bars(self, route: Route) -> list[Bar]:
        """Strokes of the bodies about the main axis, and of what they must not cross."""
        found: list[Bar] = []
        for body in self.main:
            found += self._body_bars(route, body)
        for name, carrier in self.built.carried.items():
            found += self._satellite_bars(name, carrier)
        return found

    def _satellite_bars(self, name: str, carrier: str) -> Iterator[Bar]:
        if self.built.tilted(name):
            return
        y, half, x = self.y(name), self.r(name) - CLEAR, self.x[name]
        yield Bar(f"*{name}", complex(x, y + 1.2), complex(x, y + half))
        yield Bar(f"*{name}", complex(x, y - half), complex(x, y - 1.2))

    def _body_bars(self, route: Route, body: str) -> Iterator[Bar]:
        outside = body in route.outside
        base = self.over(body) if outside else self.level(route, body)
        feet: list[float] = []
        if self._only_ground(body):
            yield from self._held_ring(self._members(body)[0])
            return
        for m in self._members(body):
            if m.kind == "carrier":
                for x, low, high, pin in self.arms(route, m.name):
                    if pin is not None:
                        yield Bar(body, complex(pin[0], low), complex(pin[1], low))
                    yield Bar(body, complex(x, base), complex(x, high if outside else low))
                    feet.append(x)
            elif m.kind == "ring":
                rim = self.y(m.name) + self.r(m.name) + CLEAR
                way = 1 if m.name in route.right else -1
                x = self.x[m.name] if outside else self.x[m.name] + way * DISC
                yield Bar(body, complex(self.x[m.name] - RIM, rim), complex(self.x[m.name] + RIM, rim))
                if not outside:
                    yield Bar(body, complex(self.x[m.name], rim), complex(x, rim))
                yield Bar(body, complex(x, base), complex(x, rim))
                feet.append(x)
            elif m.teeth:
                x = self.x[m.name]
                tip = self.r(m.name) - (0.0 if self._is_bevel(m.name) else CLEAR)
                yield Bar(body, complex(x, base), complex(x, tip))
                feet.append(x)
        yield from self._shaft(route, body, base, feet)

    def _held_ring(self, m: Member) -> Iterator[Bar]:
        rim = self.y(m.name) + self.r(m.name) + CLEAR
        x = self.x[m.name]
        yield Bar(m.body, complex(x - RIM, rim), complex(x + RIM, rim))
        yield Bar(m.body, complex(x, rim), complex(x, rim + 3))

    def arms(
        self, route: Route, carrier: str
    ) -> Iterator[tuple[float, float, float, tuple[float, float] | None]]:
        """x of each arm, heights between which it may stand, and the pin from end to end."""
        flat = self._pinned(carrier)
        for y in sorted({round(self.y(name), 3) for name in flat}):
            xs = [
                x
                for name in flat
                if abs(self.y(name) - y) < 1e-2
                for x in (self.x[name], self.x[name] + self.wide[name])
            ]
            right = carrier in route.right
            x = max(xs) + ARM if right else min(xs) - ARM
            yield x, y, y, (min([*xs, x]) - (1.8 if right else 0), max([*xs, x]) + (0 if right else 1.8))
        for name, of in self.built.carried.items():
            if of == carrier and self.built.tilted(name):
                yield self.x[name], self.cone(name).imag, self.cone(name).imag, None

    def cone(self, name: str) -> complex:
        """The middle of a bevel wheel that lies across the main axis."""
        mate = next(
            (m.j if m.i == name else m.i) for m, flat in self._meshes() if not flat and name in (m.i, m.j)
        )
        return complex(self.x[name], self.r(mate))

    def _shaft(self, route: Route, body: str, base: float, feet: list[float]) -> Iterator[Bar]:
        """Along the axis, out at the left where it is driven or held, at the right where power is taken."""
        ends, outside = list(feet), body in route.outside
        names = [m.name for m in self._members(body)]
        several = len(self.built.outputs) > 1
        for name in names:
            if body in self.held and not self._only_ground(body):
                turned = name in route.right and self.train.by_name[name].kind != "ring"
                ends.append(self.right if turned else self.left)
            if name in self.built.inputs:
                ends.append(self.left - END)
            if name in self.built.outputs:
                first = several and name == self.built.outputs[0]
                ends.append(self.left - END if first else self.right + END)
        if outside and max(ends) > max(feet) + 1:
            ends = [min(max(one, self.left - 2), self.right + 2) for one in ends]
        if max(ends) - min(ends) > 1e-6:
            yield Bar(body, complex(min(ends), base), complex(max(ends), base))
        else:
            yield Bar(body, complex(ends[0] - 2, base), complex(ends[0] + 2, base))
        if outside:
            for end in (min(ends), max(ends)):
                if not min(feet) - 1 < end < max(feet) + 1:
                    way = 1 if end > 0 else -1
                    yield Bar(body, complex(end, base), complex(end, 0.0))
                    yield Bar(body, complex(end, 0.0), complex(end + way * END, 0.0))

    # ------------------------------------------------------------ drawing

    def drawing(self, title: str) -> Drawing:
        items, tags = self.parts()
        return Drawing(tuple(items), title, moves=turning(self)).labelled(tags)

    def parts(self) -> tuple[list[Item], list[Tag]]:
        items: list[Item] = [line(complex(self.left - END - 6, 0), complex(self.right + END + 6, 0), AXIS)]
        tags: list[Tag] = []
        for bar in self.bars(self.route):
            if not bar.body.startswith("*"):
                items.append(line(bar.start, bar.end, NORMAL if bar.upright else THICK))
        for name in self.x:
            more, named = self._wheel(name)
            items += more
            tags += named
        for body in self.train.bodies:
            if body not in self.main and not self._carried(body):
                items += self._aside(body)
        items += self._pins()
        more, named = self._ends()
        return [*items, *more], [*tags, *named, *self._carriers()]

    def _wheel(self, name: str) -> tuple[list[Item], list[Tag]]:
        if self._is_bevel(name):
            return self._bevel_wheel(name)
        m, x, y = self.train.by_name[name], self.x[name], self.y(name)
        ring, wide, half = m.kind == "ring", self.wide[name], self.half(name)
        start, end = self.rim(name)
        sides = (1,) if m.body in self.main else (1, -1)
        items: list[Item] = []
        for side in sides:
            items.append(line(complex(start, y + side * half), complex(end, y + side * half), THICK))
            if m.body not in self.main:
                hub = 1.2 if m.carried_by or self._idler(m.body) else 0.0
                items.append(line(complex(x, y + side * hub), complex(x, y + side * half), NORMAL))
                if hub:
                    items.append(
                        line(complex(x - 2, y + side * hub), complex(x + wide + 2, y + side * hub), NORMAL)
                    )
        if self._only_ground(m.body):
            foot = complex(x, y + half + 3)
            items += ground(foot - 3.5, foot + 3.5, 1j)
        at = complex(x - RIM if not ring else x + RIM, y + half)
        return items, [
            Tag((symbol(name),), (at, complex(x + RIM, y + half)), prefer=complex(-1, 1 if ring else -1))
        ]

    def _bevel_wheel(self, name: str) -> tuple[list[Item], list[Tag]]:
        """Its rim along the cone at each mesh; the web of a wheel across the main axis."""
        items: list[Item] = []
        middle = None
        for across, contact, _ in self.contacts(name):
            centre = self.cone(across)
            apex = complex(centre.real, 0)
            along = (contact - apex) / abs(contact - apex)
            aside = 1j * along * (1 if (1j * along).real * (contact.real - centre.real) < 0 else -1)
            shift = aside if name == across else -aside
            start = contact + CLEAR * shift
            items.append(line(start, start - 5.0 * along, THICK))
            if name == across:
                middle = centre
                items.append(
                    line(complex(centre.real, centre.imag), complex(contact.real, contact.imag), NORMAL)
                )
        if middle is not None:
            if len(items) == 2:  # of one mesh: the other half
                mirrored = 2 * middle.real
                items.append(line(middle, complex(mirrored - self._far(name), middle.imag), NORMAL))
            return items, [Tag((symbol(name),), (middle + 1.5 + 2j, middle - 2 - 2j), prefer=1 + 1j)]
        way = 1 if self.y(name) >= 0 else -1
        at = complex(self.x[name], way * self.r(name) * 0.7)
        return items, [Tag((symbol(name),), (at,), prefer=complex(-1 if self.x[name] < 0 else 1, 0))]

    def contacts(self, name: str) -> Iterator[tuple[str, complex, str]]:
        """Of the bevel meshes of a wheel that are drawn: the wheel across the main axis, where it touches the other."""
        for mesh, flat in self._meshes():
            if not flat and name in (mesh.i, mesh.j):
                across = self.across(self._group(mesh.i)[0])
                if across in (mesh.i, mesh.j):
                    other = mesh.j if mesh.i == across else mesh.i
                    yield across, complex(self.x[other], self.cone(across).imag), other

    def _far(self, name: str) -> float:
        mate = next(
            (m.j if m.i == name else m.i) for m, flat in self._meshes() if not flat and name in (m.i, m.j)
        )
        return self.x[mate]

    def _idler(self, body: str) -> bool:
        return len(self._members(body)) == 1 and body not in {self.built.body(n) for n in self.built.outer}

    def _aside(self, body: str) -> Iterator[Item]:
        """A shaft in the frame beside the main one, or an idler's pin."""
        wheels = [m.name for m in self._members(body)]
        if all(self._is_bevel(name) for name in wheels):
            name = wheels[0]
            centre = (
                self.cone(name) if name == self.across(self._group(name)[0]) else complex(self.x[name], 0)
            )
            yield line(centre, centre + 14j, THICK)
            for way in (1, -1):
                side = complex(1.1 * way, 7)
                yield from ground(centre + side - 2.5j, centre + side + 2.5j, complex(way, 0))
            return
        xs = [self.x[name] for name in wheels]
        y = self.y(wheels[0])
        start, end = min(xs) - 7, max(xs) + 7
        driven = set(wheels) & {*self.built.inputs}
        taken = set(wheels) & {*self.built.outputs}
        if self._idler(body):
            yield line(complex(min(xs) - 2.5, y), complex(end, y), THICK)
            yield from ground(complex(end, y - 3), complex(end, y + 3), 1 + 0j)
            return
        yield line(
            complex(self.left - END if driven else start, y),
            complex(self.right + END if taken else end, y),
            THICK,
        )
        for x in (start + 2.5, end - 2.5):
            for side in (1j, -1j):
                yield from ground(complex(x - 2, y) + 1.1 * side, complex(x + 2, y) + 1.1 * side, side)

    def _pins(self) -> Iterator[Item]:
        """Crowns of one satellite joined about their pin."""
        for body in self.train.bodies:
            crowns = [m.name for m in self._members(body) if m.carried_by and not self.built.tilted(m.name)]
            for one, other in pairwise(crowns):
                for side in (1.2, -1.2):
                    start, end = (complex(self.x[name], self.y(one) + side) for name in (one, other))
                    yield line(start, end, NORMAL)

    def _carriers(self) -> Iterator[Tag]:
        for m in self.train.members:
            if m.kind == "carrier":
                for x, low, _, _ in self.arms(self.route, m.name):
                    base = (
                        self.over(m.body) if m.body in self.route.outside else self.level(self.route, m.body)
                    )
                    at = complex(x, (low + base) / 2)
                    yield Tag((symbol(m.name),), (at, complex(x, 0.3 * low + 0.7 * base)), prefer=1 + 0j)
                    break

    def _ends(self) -> tuple[list[Item], list[Tag]]:
        """Arrows at the driven members and those that give power; the frame at held shafts."""
        items: list[Item] = []
        tags: list[Tag] = []
        for body in self.main:
            bars = [b for b in self._body_bars(self.route, body) if not b.upright]
            for name in (m.name for m in self._members(body)):
                into, out = name in self.built.inputs, name in self.built.outputs
                if not into and not out:
                    continue
                ends = [end for bar in bars for end in (bar.start, bar.end)]
                low = [end for end in ends if body not in self.route.outside or end.imag < 1]
                leftmost = into or (len(self.built.outputs) > 1 and name == self.built.outputs[0])
                at = (min if leftmost else max)(low or ends, key=lambda one: one.real)
                way = -1 if leftmost else 1
                tip = at + way * 7
                items.append(Arrow(tip, at + way, THIN) if into else Arrow(at + way, tip, THIN))
                tags.append(Tag((symbol(f"ω_{name}"),), (tip,), prefer=complex(way, 1)))
            if body in self.held and not self._only_ground(body):
                ends = [end for bar in bars for end in (bar.start, bar.end)]
                at = max(ends, key=lambda one: abs(one.real - (self.left + self.right) / 2))
                way = 1 if at.real > self.left + 1 else -1
                items += ground(at - 2j, at + 2j, complex(way, 0))
        for body in self.train.bodies:
            if body in self.main or self._carried(body):
                continue
            for name in (m.name for m in self._members(body)):
                if name in (*self.built.inputs, *self.built.outputs):
                    y = self.cone(name).imag + 14 if self._is_bevel(name) else self.y(name)
                    x = (
                        self.x[name]
                        if self._is_bevel(name)
                        else (self.left - END if name in self.built.inputs else self.right + END)
                    )
                    tags.append(Tag((symbol(f"ω_{name}"),), (complex(x, y),), prefer=-1 + 1j))
        return items, tags
