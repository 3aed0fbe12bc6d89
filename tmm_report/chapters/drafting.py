"""Drafting a plan of velocities or accelerations on paper, in mm, with the calculations written beside it.

The vector equation of a dyad is solved by crossing two lines of known direction; a point of a link is found by the
theorem of similarity; a length is read to the drawing's accuracy and multiplied by the scale.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from tmm_report.chapters.scales import Pen
from tmm_report.chapters.written import DIGITS, hand, laid_off, length_of, number
from tmm_report.chapters.written import symbol_of as _sign
from tmm_report.formula import Expr, Formula, Symbol, Term, Var, VectorEquation
from tmm_report.mechanics.dyads import Dyad, Side, sides
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import Motion
from tmm_report.mechanics.planar import resolve, unit
from tmm_report.mechanics.relations import Branch, Relation, relations, turning_links
from tmm_report.quantity import round_significant

Role = Literal[
    "absolute", "relative", "bend", "rate"
]  # bend: normal or Coriolis; rate: tangential or relative


@dataclass(frozen=True)
class Scales:
    """m, m/s and m/s² per mm of paper."""

    length: float
    velocity: float
    acceleration: float


@dataclass(frozen=True)
class Stroke:
    """A vector of a plan, mm of paper."""

    start: complex
    end: complex
    key: str
    role: Role


@dataclass(frozen=True, eq=False)
class Step:
    """One dyad in a plan: its vector equation, what is known beforehand, and what is read off the plan."""

    relation: Relation
    equation: VectorEquation
    before: tuple[Formula, ...]  # lengths, normal and Coriolis accelerations, their segments
    after: tuple[Formula, ...]
    points: tuple[Formula, ...]  # points of the dyad's links found by similarity


@dataclass(frozen=True, eq=False)
class Plan:
    """A plan of velocities ("v") or accelerations ("a") at one table position.

    `scale`: m/s or m/s² per mm. `vertices`: lettering -> place, mm, the pole at 0. `segments`: lettering of the ends,
    "pb" -> length read, mm. `values`: key -> written magnitude, SI; `per_mm`: key -> value of 1 mm of paper.
    `lead`: formulas of the driving link. `turns`: link -> mm of plan per m of the link, complex.
    """

    kind: Literal["v", "a"]
    position: int
    scale: float
    pole: str
    vertices: Mapping[str, complex]
    strokes: tuple[Stroke, ...]
    segments: Mapping[str, float]
    values: Mapping[str, float]
    per_mm: Mapping[str, float]
    lead: tuple[Formula, ...]
    steps: tuple[Step, ...]
    turns: Mapping[str, complex]

    def vector(self, key: str) -> complex:
        """A drawn vector by its key, mm."""
        return next(s.end - s.start for s in self.strokes if s.key == key)


def velocity_plan(motion: Motion, position: int, scales: Scales, pen: Pen) -> Plan:
    """Plan of velocities; `motion` at that one position, only its places are used."""
    return _Draft(motion, position, scales, pen, None).plan()


def acceleration_plan(motion: Motion, position: int, scales: Scales, pen: Pen, velocity: Plan) -> Plan:
    """Plan of accelerations; normal and Coriolis parts come from the plan of velocities."""
    return _Draft(motion, position, scales, pen, velocity).plan()


@dataclass(frozen=True)
class _Image:
    """A link in a plan: the place `z`, mm, of its point at world place `at`, and mm of plan per m of arm."""

    z: complex
    at: complex
    turn: complex

    def of(self, place: complex) -> complex:
        """Theorem of similarity: where the link's point now at `place` is in the plan."""
        return self.z + self.turn * (place - self.at)


@dataclass(frozen=True, eq=False)
class _Line:
    """A branch as drawn: from its start (and the end of its known part) along a direction of the paper."""

    branch: Branch
    carrier: str
    start_place: complex  # world, m
    arm: complex  # world, m; the guide's direction where the branch slides
    z_start: complex
    z_bend: complex
    letter: str  # lettering of the vertex at z_bend

    @property
    def direction(self) -> complex:
        return unit(1j * self.arm if self.branch.turns else self.arm)


class _Draft:
    """One plan in the making: what has been drawn, read and calculated so far."""

    def __init__(self, motion: Motion, position: int, scales: Scales, pen: Pen, velocity: Plan | None):
        self.motion, self.position, self.scales, self.pen, self.velocity = (
            motion,
            position,
            scales,
            pen,
            velocity,
        )
        self.kind: Literal["v", "a"] = "v" if velocity is None else "a"
        self.scale = scales.velocity if velocity is None else scales.acceleration
        self.pole = "p" if velocity is None else "π"
        self.letters = {"": self.pole}
        self.vertices: dict[str, complex] = {self.pole: 0j}
        self.images = {FRAME: _Image(0j, 0j, 0j)}
        self.strokes: list[Stroke] = []
        self.segments: dict[str, float] = {}
        self.values: dict[str, float] = {}
        self.per_mm: dict[str, float] = {}
        self.reference = 0.0
        self.mu = number(Symbol("mu", self.kind), self.scale, f"({'m/s' if self.kind == 'v' else 'm/s²'})/mm")

    def plan(self) -> Plan:
        lead = self._lead()
        steps = tuple(self._step(r) for r in relations(self.motion.linkage))
        self._links_that_turn_alike()
        turns = {link: image.turn for link, image in self.images.items()}
        return Plan(
            self.kind, self.position, self.scale, self.pole, self.vertices, tuple(self.strokes), self.segments,
            self.values, self.per_mm, lead, steps, turns,
        )  # fmt: skip

    # ------------------------------------------------------------ paper

    def _world(self, place: complex) -> complex:
        """A place of the mechanism as it is drawn in the scheme, m."""
        mm = self.scales.length
        return self.pen.place(complex(place) / mm) * mm

    def _letter(self, point: str) -> str:
        """Lettering of a point in the plan: its small letter, primed if that is taken (by the pole, say)."""
        if point not in self.letters:
            small = point.lower()
            while small in self.letters.values():
                small += "'"
            self.letters[point] = small
        return self.letters[point]

    def _vertex(self, point: str, z: complex) -> complex:
        """Letter a point; one already drawn stays where it is."""
        return self.vertices.setdefault(self._letter(point), z)

    def _stroke(self, start: complex, end: complex, key: str, role: Role) -> None:
        if all(stroke.key != key for stroke in self.strokes):
            self.strokes.append(Stroke(start, end, key, role))

    def _segment(self, start: str, end: str) -> Var:
        """The length of a segment between two vertices, read off the plan."""
        name = start + end
        self.segments.setdefault(name, self.pen.read(self.vertices[end] - self.vertices[start]))
        return length_of(name, self.segments[name])

    def _write(self, key: str, expression: Expr, per_mm: float | None = None) -> Formula:
        """Calculate a value by hand and keep it as written. `per_mm`: the value of 1 mm of paper for it."""
        reference = self.reference if key[0] == self.kind else 0.0
        formula = hand(key, expression, reference)
        self.values[key], self.per_mm[key] = abs(formula.written), self.scale if per_mm is None else per_mm
        return formula

    def _read(self, key: str, start: str, end: str) -> Formula:
        """A value read off the plan: its segment times the scale."""
        return self._write(key, self._segment(start, end) * self.mu)

    # ------------------------------------------------------------ driving link

    def _lead(self) -> tuple[Formula, ...]:
        """The driving link's pin (a joint rather than another point), and its other points by similarity."""
        linkage = self.motion.linkage
        mechanism, pair = linkage.mechanism, linkage.structure.driver_pair
        link = mechanism.driver.link
        pivot = self._world(self.motion.place(pair.name)[0])
        points = [p for p in mechanism.links[link].points if p != pair.name]
        if not points:
            return self._lead_without_pin(link, pivot)
        pin = next((p for p in points if len(mechanism.links_at(p)) > 1), points[0])
        arm = self._world(self.motion.place(pin)[0]) - pivot
        omega = float(np.ravel(mechanism.driver.omega)[0])
        z = 1j * omega * arm if self.kind == "v" else -(omega**2) * arm
        z = self._vertex(pin, self.pen.place(z / self.scale))
        self._stroke(0j, z, f"{self.kind}_{pin}", "absolute")
        self.images[link] = _Image(0j, pivot, z / arm)
        formulas = self._lead_formulas(link, pin, abs(omega), pair.name + pin)
        others = [self._point(p, link) for p in points if p != pin]
        return (*formulas, *others)

    def _lead_without_pin(self, link: str, pivot: complex) -> tuple[Formula, ...]:
        """A driving link that only carries a guide: nothing to draw, but it turns."""
        omega = float(np.ravel(self.motion.linkage.mechanism.driver.omega)[0])
        turn = 1j * omega if self.kind == "v" else -(omega**2)
        self.images[link] = _Image(0j, pivot, turn / self.scale)
        return ()

    def _lead_formulas(self, link: str, pin: str, omega: float, ends: str) -> tuple[Formula, Formula]:
        """The pin's velocity or acceleration, and the segment laid off for it."""
        w = number(Symbol("omega", link), float(round_significant(omega, DIGITS)), "rad/s")
        arms = self.motion.linkage.mechanism.links[link].points
        pivot = self.motion.linkage.structure.driver_pair.name
        length = number(Symbol("l", ends), float(np.abs(arms[pin] - arms[pivot])), "m")
        size = w * length if self.kind == "v" else w**2 * length
        value = self._write(f"{self.kind}_{pin}", size)
        self.reference = value.written
        name = self.pole + self._letter(pin)
        laid = laid_off(name, size / self.mu)
        self.segments[name] = laid.written
        return value, laid

    # ------------------------------------------------------------ dyads

    def _step(self, r: Relation) -> Step:
        lines, before = [], []
        for branch, side in zip((r.left, r.right), sides(self.motion.state, r.dyad), strict=True):
            line, formulas = self._line(branch, side)
            lines.append(line)
            before += formulas
        left, right = lines
        x, _ = resolve(right.z_bend - left.z_bend, left.direction, -right.direction)
        z = self._vertex(r.vertex, self.pen.place(left.z_bend + x * left.direction))
        after = [f for line in lines for f in self._close(line, z)]
        self._stroke(0j, z, f"{self.kind}_{r.vertex}", "absolute")
        if f"{self.kind}_{r.vertex}" not in self.values:
            after.insert(0, self._read(f"{self.kind}_{r.vertex}", self.pole, self._letter(r.vertex)))
        after += [f for line in lines for f in self._angular(line)]
        self._place_links(r.dyad, left, right, z)
        points = [f for link in (r.dyad.a, r.dyad.b) for f in self._similar(link, r, left, right)]
        return Step(r, self._equation(r), tuple(before), tuple(after), tuple(points))

    def _line(self, branch: Branch, side: Side) -> tuple[_Line, list[Formula]]:
        """Draw the known part of a branch: its start, and in accelerations its normal or Coriolis part."""
        start = self._world(np.ravel(side.joint)[0])
        e = complex(np.ravel(side.e)[0])
        arm = self._world(start + e / 1j) - start if branch.turns else e
        z = self.images[side.carrier].of(start)
        if branch.start is not None:
            known = self._letter(branch.start) in self.vertices
            z = self._vertex(branch.start, self.pen.place(z))
            self._stroke(0j, z, f"{self.kind}_{branch.start}", "absolute")
        formulas = [self._coincident(branch.start)] if branch.start is not None and not known else []
        letter = self._letter(branch.start) if branch.start else self.pole
        if self.kind == "v" or not branch.has_bend:
            return _Line(branch, side.carrier, start, arm, z, z, letter), formulas
        letter, bend = self._bend(branch, arm, z, letter)
        return _Line(branch, side.carrier, start, arm, z, self.vertices[letter], letter), formulas + bend

    def _coincident(self, point: str) -> Formula:
        return self._read(f"{self.kind}_{point}", self.pole, self._letter(point))

    def _bend(self, branch: Branch, arm: complex, z: complex, start: str) -> tuple[str, list[Formula]]:
        """The normal (towards the start) or Coriolis part (sliding velocity turned by 90° with the guide), laid off
        from the vertex `start` at `z`; the lettering of its end."""
        assert self.velocity is not None
        v = self.velocity
        sliding = v.vector(branch.v_key) * v.scale
        speed = number(_sign(branch.v_key), v.values[branch.v_key], "m/s")
        if branch.turns:
            vector = -(abs(sliding) ** 2) / abs(arm) * unit(arm)
            key, size = branch.a_key("n"), speed**2 / self._length(branch, arm)
        else:
            omega = (v.turns[branch.link] * v.scale).imag
            vector = 2j * omega * sliding
            w = number(Symbol("omega", branch.link), v.values[f"w_{branch.link}"], "rad/s")
            key, size = branch.a_key("k"), 2 * w * speed
        number_ = 1 + sum(s.role == "bend" for s in self.strokes)
        letter = self._letter(f"{'n' if branch.turns else 'k'}{number_}")
        z_bend = self.vertices[letter] = self.pen.place(z + vector / self.scale)
        self._stroke(z, z_bend, key, "bend")
        value = self._write(key, size)
        name = start + letter
        laid = laid_off(name, number(_sign(key), value.written) / self.mu)
        self.segments[name] = self.pen.read(z_bend - z)
        return letter, [value, laid]

    def _length(self, branch: Branch, arm: complex) -> Var:
        """The length of a turning branch's arm: of a rod it is given, between a pivot and a slider it is read."""
        assert branch.arm is not None
        mm = self.pen.read(arm / self.scales.length)
        points = self.motion.linkage.mechanism.links[branch.link].points
        rigid = all(joint in points for joint in branch.arm)
        given = (
            float(np.abs(points[branch.arm[1]] - points[branch.arm[0]])) if rigid else mm * self.scales.length
        )
        return number(Symbol("l", "".join(branch.arm)), float(round_significant(given, DIGITS + 2)), "m")

    def _close(self, line: _Line, z: complex) -> list[Formula]:
        """Draw a branch's unknown vector to the vertex and read it off."""
        branch, end = line.branch, self._letter(line.branch.end)
        key = branch.v_key if self.kind == "v" else branch.a_key("t" if branch.turns else "r")
        if self.kind == "a" and branch.has_bend and branch.start is not None:
            # the whole relative acceleration: other points of the link lie along it
            self._stroke(line.z_start, z, f"a_{branch.pair}", "relative")
        role: Role = "relative" if self.kind == "v" else "rate"
        self._stroke(line.z_bend, z, key, "absolute" if line.letter == self.pole else role)
        return [self._read(key, line.letter, end)] if key not in self.values else []

    def _angular(self, line: _Line) -> list[Formula]:
        """Angular velocity or acceleration of a turning branch's link."""
        branch = line.branch
        if not branch.turns:
            return []
        length = self._length(branch, line.arm)
        part = branch.v_key if self.kind == "v" else branch.a_key("t")
        top = number(_sign(part), self.values[part])
        key = f"{'w' if self.kind == 'v' else 'e'}_{branch.link}"
        return [self._write(key, top / length, self.scale / float(length.number))]

    def _place_links(self, d: Dyad, left: _Line, right: _Line, z: complex) -> None:
        """Images of both links, so that any point of theirs follows by similarity."""
        vertex = left.start_place + left.arm if left.branch.turns else left.start_place

        def turned(line: _Line) -> _Image:
            return _Image(line.z_start, line.start_place, (z - line.z_start) / line.arm)

        turn_a, turn_b = (self.images[c].turn for c in (d.carrier_a, d.carrier_b))
        if d.kind <= 3:
            self.images[d.a] = turned(left)
        if d.kind == 1:
            self.images[d.b] = turned(right)
        elif d.kind == 3:
            self.images[d.b] = _Image(right.z_start, right.start_place, self.images[d.a].turn)
        elif d.kind == 2:
            self.images[d.b] = _Image(z, vertex, turn_b)
        elif d.kind == 4:
            self.images[d.a], self.images[d.b] = _Image(z, vertex, turn_a), _Image(z, vertex, turn_b)
        else:
            self.images[d.a] = _Image(right.z_start, right.start_place, turn_b)
            self.images[d.b] = _Image(z, vertex, turn_b)

    def _similar(self, link: str, r: Relation, left: _Line, right: _Line) -> list[Formula]:
        """Points of a link, beside its joints already drawn, by the theorem of similarity."""
        formulas = []
        linkage = self.motion.linkage
        for point in linkage.mechanism.links[link].points:
            if linkage.carriers[point] != link or self._letter(point) in self.vertices:
                continue
            line = next((x for x in (left, right) if x.branch.turns and x.branch.link == link), None)
            proportion = self._proportion(link, point, line) if line is not None else None
            value = self._point(point, link)
            formulas += [value] if proportion is None else [proportion, value]
        return formulas

    def _proportion(self, link: str, point: str, line: _Line) -> Formula | None:
        """ac = ab · AC / AB: the link's figure in the plan is similar to the link."""
        points = self.motion.linkage.mechanism.links[link].points
        start, end = line.branch.arm or ("", "")
        if start not in points or end not in points or line.branch.end != end:
            return None
        first = self._letter(line.branch.start) if line.branch.start else self.pole
        whole = self._segment(first, self._letter(end))
        part, rod = (
            number(Symbol("l", start + to), float(np.abs(points[to] - points[start])), "m")
            for to in (point, end)
        )
        return laid_off(first + self._letter(point), whole * part / rod)

    def _point(self, point: str, link: str) -> Formula:
        place = self._world(self.motion.place(point)[0])
        z = self._vertex(point, self.pen.place(self.images[link].of(place)))
        self._stroke(0j, z, f"{self.kind}_{point}", "absolute")
        return self._read(f"{self.kind}_{point}", self.pole, self._letter(point))

    def _links_that_turn_alike(self) -> None:
        """A link that slides on a turning guide has the guide's angular velocity and acceleration."""
        letter = "w" if self.kind == "v" else "e"
        carriers: dict[str, str] = {}
        for d in self.motion.linkage.dyads:
            carriers |= {d.b: d.a} if d.kind == 3 else {d.b: d.carrier_b} if d.kind != 1 else {}
            carriers |= {d.a: d.carrier_a if d.kind == 4 else d.carrier_b} if d.kind > 3 else {}
        driver = self.motion.linkage.mechanism.driver.link
        for link in turning_links(self.motion.linkage):
            if link == driver:
                omega = abs(float(np.ravel(self.motion.linkage.mechanism.driver.omega)[0]))
                self.values[f"{letter}_{link}"] = (
                    float(round_significant(omega, DIGITS)) if letter == "w" else 0.0
                )
                self.per_mm[f"{letter}_{link}"] = 0.0
            elif link in carriers:
                source = f"{letter}_{carriers[link]}"
                self.values[f"{letter}_{link}"], self.per_mm[f"{letter}_{link}"] = (
                    self.values[source],
                    self.per_mm[source],
                )

    # ------------------------------------------------------------ vector equations

    def _equation(self, r: Relation) -> VectorEquation:
        """Vertex = left side = right side; a side that is the vertex's own vector, of known direction, comes first."""
        sides = [self._terms(branch) for branch in (r.left, r.right)]
        own = [side for side in sides if len(side) == 1]
        first = own[:1] or [[Term(Symbol(self.kind, r.vertex))]]
        return VectorEquation([*first, *(side for side in sides if side is not first[0])])

    def _terms(self, branch: Branch) -> list[Term]:
        start = [Term(Symbol(self.kind, branch.start), known=2)] if branch.start else []
        along = "⟂ " + "".join(branch.arm) if branch.arm else f"∥ {branch.guide}"
        if self.kind == "v":
            return [*start, Term(_sign(branch.v_key), 1, along)]
        rate = Term(_sign(branch.a_key("t" if branch.turns else "r")), 1, along)
        if not branch.has_bend:
            return [*start, rate]
        note = "∥ " + "".join(reversed(branch.arm)) if branch.arm else f"⟂ {branch.guide}"
        return [*start, Term(_sign(branch.a_key("n" if branch.turns else "k")), 2, note), rate]
