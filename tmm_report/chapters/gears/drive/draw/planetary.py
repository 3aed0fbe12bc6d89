"""A planetary stage in the kinematic scheme of a drive."""

from __future__ import annotations

from tmm_report.chapters.gears.drive.draw.sketch import CLEAR, DISC, RIM, SIDE, Sketch
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.figures.drawing import NORMAL, THICK, Tag, line
from tmm_report.figures.lettering import symbol
from tmm_report.figures.schemes.marks import ground
from tmm_report.mechanics.gears.trains import Member, Mesh
from tmm_report.records import dataclass

ROW = 13.0  # from row to row of a double-row stage
ARM = 6.5  # from a row to the arm of the carrier
HOLLOW = 1.7  # half the bore of a hollow shaft
STEM = 2.5  # of a ring that stands still
SLEEVE = 4.0  # of a hollow shaft
PIN = 1.8  # of the pin of a satellite beyond its row


@dataclass
class _Central:
    """A member on the main axis: x of its row and of its web, and its shaft's way: −1 left, +1 right, 0 none."""

    member: Member
    row: float
    web: float
    way: int

    def shaft_passes(self, x: float) -> bool:
        return self.way != 0 and (x - self.web) * self.way > 1e-6


class _Planetary:
    """One planetary stage: its rows at x, its central members, its axis at `y`; satellites stand on the side `up`."""

    def __init__(self, sketch: Sketch, stage: Found):
        self.sketch, self.stage = sketch, stage
        self.by_name = {m.name: m for m in stage.members}
        self.carrier = next(m for m in stage.members if m.kind == "carrier")
        satellites = [m for m in stage.members if m.kind == "satellite"]
        self.double = len(satellites) > 1
        self.pairs = [self._apart(mesh) for mesh in stage.meshes]  # central wheel, satellite
        if self._mirrored():
            satellites.reverse()
        first = sketch.x + self._room(-1)
        self.rows = {m.name: first + ROW * k for k, m in enumerate(satellites)}
        self.end = max(self.rows.values()) + self._room(1)
        self.y = sketch.y(self.carrier)
        self.pin = sketch.y(satellites[0])
        self.up = 1 if self.pin > self.y else -1
        names = [*(central.name for central, _ in self.pairs), self.carrier.name]
        self.central = {name: self._placed(name) for name in names}

    def _room(self, way: int) -> float:
        """What the stage takes up beside its rows on the side −1 or +1."""
        ways = [(m.kind, self._way(m.name)) for m in self.stage.members if m.kind != "satellite"]
        web = (
            DISC if ("ring", way) in ways else ARM if {("carrier", way), ("carrier", 0)} & set(ways) else RIM
        )
        sleeve = SLEEVE if self.stage.second and self._way(self.stage.second[0]) == way else 0.0
        return web + sleeve + SIDE

    def _apart(self, mesh: Mesh) -> tuple[Member, Member]:
        one, other = self.by_name[mesh.i], self.by_name[mesh.j]
        return (other, one) if one.kind == "satellite" else (one, other)

    def _mirrored(self) -> bool:
        """The wheel that gives the power out stands right, the one that takes it in, left."""
        first, last = self.pairs[0][0].name, self.pairs[-1][0].name
        return bool(first == self.stage.output or last == self.stage.input)

    def _placed(self, name: str) -> _Central:
        member, way = self.by_name[name], self._way(name)
        low, high = min(self.rows.values()), max(self.rows.values())
        if member.kind == "carrier":
            return _Central(member, low, low - ARM if way < 0 else high + ARM, way)
        row = next(self.rows[satellite.name] for central, satellite in self.pairs if central.name == name)
        if member.kind == "ring" and way:
            return _Central(member, row, low - DISC if way < 0 else high + DISC, way)
        return _Central(member, row, row, way)

    def _way(self, name: str) -> int:
        """Where the shaft goes: in at the left, out at the right; a second input as a hollow one about another."""
        if name in (self.stage.input, self.stage.output):
            return -1 if name == self.stage.input else 1
        if name in self.stage.fixed or self.by_name[name].kind == "wheel":  # a sun is closed in by the others
            return 0
        if (
            name != self.carrier.name
        ):  # a ring reaches past the carrier's arm, unless another row is in its way
            return -1 if self.double and self.pairs[self._mirrored()][0].name == name else 1
        return 1 if self.by_name[self.stage.output].kind == "wheel" else -1

    def draw(self) -> float:
        """Everything; gives where the input shaft ends."""
        for one in self.central.values():
            if one.member.kind == "carrier":
                self._draw_carrier(one)
            elif one.member.kind == "ring":
                self._draw_ring(one)
            else:
                self._draw_sun(one)
        for name, x in self.rows.items():
            self._draw_satellite(self.by_name[name], x)
        if self.stage.second:
            self._draw_second(self.central[self.stage.second[0]])
        out = self.central[self.stage.output]
        self.sketch.shaft(out.web, self.end, self.y)
        return self.central[self.stage.input].web

    def _draw_sun(self, one: _Central) -> None:
        sketch, half = self.sketch, self.sketch.radius(one.member) - CLEAR
        held = one.member.name in self.stage.fixed
        for side in (self.up, -self.up):
            if not held or side == self.up:
                sketch.rim(one.web, self.y + side * half)
            sketch.web(one.web, self._inner(one, side), self.y + side * half)
        if held:
            self._ground(one.web, self.y - self.up * half, -self.up)
        else:
            sketch.mark(one.web, self.y, half, one.member.name)
        at = complex(one.web - RIM, self.y + self.up * (half / 2 if held else half))
        sketch.name(one.member.name, at, complex(-1, -self.up))

    def _draw_ring(self, one: _Central) -> None:
        sketch, rim = self.sketch, self.y + self.up * (self.sketch.radius(one.member) + CLEAR)
        if one.way:
            start = one.row - one.way * RIM
            sketch.items.append(line(complex(start, rim), complex(one.web, rim), THICK))
            sketch.web(one.web, self._inner(one, self.up), rim)
            sketch.mark(one.row, self.y, abs(rim - self.y), one.member.name, side=self.up)
        else:
            sketch.rim(one.row, rim)
            sketch.web(one.row, rim, rim + self.up * STEM)
            self._ground(one.row, rim + self.up * STEM, self.up)
        sketch.name(one.member.name, complex(one.row - RIM, rim), complex(-1, self.up))

    def _draw_carrier(self, one: _Central) -> None:
        """The pin of the satellites and the arm; a carrier that is held has its pin in the frame."""
        sketch, low, high = self.sketch, min(self.rows.values()), max(self.rows.values())
        away = 1 if one.web > low else -1
        start = low - PIN if away > 0 else high + PIN
        sketch.items.append(line(complex(start, self.pin), complex(one.web, self.pin), THICK))
        if one.way:
            sketch.items.append(
                line(complex(one.web, self._inner(one, self.up)), complex(one.web, self.pin), THICK)
            )
            sketch.mark(one.web, self.y, abs(self.pin - self.y), one.member.name, PIN, self.up)
        else:
            up = complex(0, 3.5)
            wall = complex(one.web, self.pin)
            sketch.items += ground(wall - up, wall + up, complex(away, 0))
        at = complex(one.web, (self.pin + self.y) / 2) if one.way else complex(one.web, self.pin) + away * 2.5
        sketch.name(one.member.name, at, complex(away, 0))

    def _draw_satellite(self, member: Member, x: float) -> None:
        sketch, half = self.sketch, self.sketch.radius(member) - CLEAR
        for side in (1, -1):
            sketch.rim(x, self.pin + side * half)
            sketch.web(x, self.pin + side * 0.9, self.pin + side * half)
            sketch.items.append(
                line(complex(x - 1.5, self.pin + side * 0.9), complex(x + 1.5, self.pin + side * 0.9), NORMAL)
            )
        sketch.mark(x, self.pin, half, member.name)
        sketch.name(member.name, complex(x, self.pin + self.up * half / 2), complex(-1, 0))

    def _draw_second(self, one: _Central) -> None:
        """The speed of the second input, at the end of its sleeve; of a sun, at its free half."""
        off = HOLLOW if one.way else self.sketch.radius(one.member)
        place = complex(one.web + one.way * SLEEVE, self.y - self.up * off)
        omega = symbol(f"ω_{one.member.name}")
        self.sketch.tags.append(Tag((omega,), (place,), prefer=complex(one.way, -self.up)))

    def _inner(self, one: _Central, side: int) -> float:
        """Where a web begins: on the shaft, which it holds fast, or at the bore through which another passes."""
        others = [other for other in self.central.values() if other is not one]
        if not any(other.shaft_passes(one.web) for other in others):
            if side == self.up and one.way:
                self.sketch.cross(one.web, self.y)
            return self.y
        start, end = one.web - 1.5, one.web + 1.5
        if one.way:
            start, end = sorted((one.web - 1.5 * one.way, one.web + SLEEVE * one.way))
        for bore in (self.y + HOLLOW, self.y - HOLLOW):
            self.sketch.items.append(line(complex(start, bore), complex(end, bore), NORMAL))
        return self.y + side * HOLLOW

    def _ground(self, x: float, y: float, side: int) -> None:
        """The frame to which a wheel is fastened, its hatching on the side ±1 of y."""
        self.sketch.items += ground(complex(x - 3.5, y), complex(x + 3.5, y), complex(0, side))


def planetary(sketch: Sketch, stage: Found) -> float:
    """The stage drawn; gives where the input shaft ends and leaves `sketch.x` where the stage does."""
    drawn = _Planetary(sketch, stage)
    end = drawn.draw()
    sketch.x = drawn.end
    return end
