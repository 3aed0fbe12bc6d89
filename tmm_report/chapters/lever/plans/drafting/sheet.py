"""The sheet on which a plan is drafted: its letters, vertices and strokes, the lengths read and the values written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Literal

import numpy as np

from tmm_report.chapters.lever.initial_data.quantities import segment_between
from tmm_report.chapters.lever.kinematics.quantities import UNITS
from tmm_report.chapters.lever.plans.drafting.plan import Plan, Role, Scales, Sense, Stroke
from tmm_report.chapters.lever.plans.quantities import MU_A, MU_V
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.lever.vector_equations import turning_links
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.formula import Expr, Formula, Symbol, Var
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.paper import Pen
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, Worked, segment_of
from tmm_report.records import dataclass

Named = Mapping[str, Quantity]  # velocities, accelerations and angular rates by key


@dataclass(frozen=True)
class Image:
    """A link in a plan: the place `z`, mm, of its point at world place `at`, and mm of plan per m of arm."""

    z: complex
    at: complex
    turn: complex

    def of(self, place: complex) -> complex:
        """Theorem of similarity: where the link's point now at `place` is in the plan."""
        return self.z + self.turn * (place - self.at)


class Sheet:
    """One plan in the making. `velocity`: the plan of velocities, for one of accelerations."""

    def __init__(
        self, motion: Motion, position: int, scales: Scales, pen: Pen, named: Named, velocity: Plan | None
    ):
        self.motion, self.scales, self.pen, self.velocity = motion, scales, pen, velocity
        self.kind: Literal["v", "a"] = "v" if velocity is None else "a"
        self.scale = scales.velocity if velocity is None else scales.acceleration
        self.pole = "p" if velocity is None else "π"
        self.letters = {"": self.pole}
        self.vertices: dict[str, complex] = {self.pole: 0j}
        self.images = {FRAME: Image(0j, 0j, 0j)}
        self.strokes: list[Stroke] = []
        self.segments: dict[str, float] = {}
        self.ends: dict[str, str] = {}  # of the segment that a value is read off
        self.laid: dict[str, str] = {}  # of the segment by which a value is laid off
        self.values: dict[str, float] = {}
        self.per_mm: dict[str, float] = {}
        self.senses: list[Sense] = []
        self.reference = 0.0
        self.worked = Worked(
            f"{'velocity' if velocity is None else 'acceleration'}_plan_{position}", position
        )
        self.named = named
        self.mu = self.worked.number(MU_V if velocity is None else MU_A, self.scale)
        self.turning = turning_links(self.linkage)
        self.alike: dict[str, str] = {}  # link -> a link that turns as it does, whose rate is known

    @property
    def linkage(self) -> Linkage:
        return self.motion.linkage

    @property
    def omega(self) -> float:
        """Angular velocity of the driving link, rad/s."""
        return self._of_driver(self.motion.angular_velocity)

    @property
    def epsilon(self) -> float:
        """Its angular acceleration, rad/s²."""
        return self._of_driver(self.motion.angular_acceleration)

    def _of_driver(self, rate: Callable[[str], Any]) -> float:
        return float(np.ravel(rate(self.linkage.mechanism.driver.link))[0])

    # ------------------------------------------------------------ places of the mechanism

    def world(self, place: complex) -> complex:
        """A place of the mechanism as it is drawn in the scheme, m."""
        mm = self.scales.length
        return self.pen.place(complex(place) / mm) * mm

    def place(self, point: str) -> complex:
        """Where a named point is drawn in the scheme, m."""
        return self.world(self.motion.place(point)[0])

    def drawn(self, arm: complex, name: str) -> complex:
        """An arm of the scheme, m, long enough to be read off. Raises ProblemError for a shorter one."""
        if self.pen.read(arm / self.scales.length) == 0:
            text = N_("%(name)s is too short to be seen in the drawing at %(scale)g m/mm")
            right = Message(N_("state a finer drawing.scales.length or drawing.accuracy"))
            raise ProblemError([mistake(text, ("drawing",), right, name=name, scale=self.scales.length)])
        return arm

    # ------------------------------------------------------------ paper

    def letter(self, point: str) -> str:
        """Lettering of a point in the plan: its small letter, primed if that is taken (by the pole, say)."""
        if point not in self.letters:
            small = point.strip().lower()
            while small in self.letters.values():
                small += "'"
            self.letters[point] = small
        return self.letters[point]

    def letter_of_bend(self, name: str) -> str:
        """Lettering of the end of a normal or Coriolis part, n1, k2: no point's, though one be called so."""
        return self.letter(f" {name}")

    def has(self, point: str) -> bool:
        return self.letter(point) in self.vertices

    def vertex(self, point: str, z: complex) -> complex:
        """Letter a point; one already drawn stays where it is."""
        return self.vertices.setdefault(self.letter(point), z)

    def stroke(
        self, start: complex, end: complex, key: str, role: Role, symbol: Symbol | None = None
    ) -> None:
        """Draw a vector once. `symbol`: of one that is no quantity of the note."""
        if all(stroke.key != key for stroke in self.strokes):
            self.strokes.append(Stroke(start, end, key, symbol or self.symbol(key), role))

    def absolute(self, point: str, z: complex) -> complex:
        """Letter a point and draw its vector from the pole."""
        z = self.vertex(point, z)
        self.stroke(0j, z, f"{self.kind}_{point}", "absolute")
        return z

    def segment(self, start: str, end: str) -> Var:
        """The length of a segment between two vertices, read off the plan."""
        name = start + end
        self.segments.setdefault(name, self.pen.read(self.vertices[end] - self.vertices[start]))
        return self.worked.number(segment_of(name), self.segments[name])

    # ------------------------------------------------------------ values

    def symbol(self, key: str) -> Symbol:
        """How the quantity of a key is written."""
        return self.named[key].sign

    def number(self, key: str, value: float) -> Var:
        """A rate in a calculation, by its key."""
        return self.worked.number(self.named[key], value)

    def length(self, one: str, other: str, metres: float) -> Var:
        """The length of a segment of the mechanism in a calculation, as it is printed."""
        of = segment_between(self.linkage.mechanism, one, other)
        return self.worked.number(of, float(round_significant(metres, DIGITS)))

    def write(self, key: str, expression: Expr, per_mm: float | None = None) -> Formula:
        """Calculate a value by hand and keep it as written. `per_mm`: the value of 1 mm of paper for it."""
        reference = self.reference if self.named[key].unit == UNITS[self.kind] else 0.0
        formula = self.worked.hand(self.named[key], expression, reference)
        self.values[key], self.per_mm[key] = abs(formula.written), self.scale if per_mm is None else per_mm
        return formula

    def read(self, key: str, start: str, end: str) -> Formula:
        """A value read off the plan: its segment times the scale."""
        self.ends[key] = start + end
        return self.write(key, self.segment(start, end) * self.mu)

    def read_point(self, point: str) -> Formula:
        """A point's own velocity or acceleration, read from the pole."""
        return self.read(f"{self.kind}_{point}", self.pole, self.letter(point))

    def nothing(self, key: str) -> None:
        """Keep a relative value of a link that does not turn."""
        self.values.setdefault(key, 0.0)
        self.per_mm.setdefault(key, self.scale)

    def rate(self, link: str) -> str:
        """Key of the angular rate that is calculated for a link or for one that turns alike."""
        while link in self.alike:
            link = self.alike[link]
        return f"{'w' if self.kind == 'v' else 'e'}_{link}"

    def driver_rate(self) -> None:
        """Write down the driving link's own rate: it is given, not read."""
        key = self.rate(self.linkage.mechanism.driver.link)
        self.values[key] = float(
            round_significant(abs(self.omega if self.kind == "v" else self.epsilon), DIGITS)
        )
        self.per_mm[key] = 0.0

    def copy_rates(self) -> None:
        """Write down the rates of links that turn as others do: on a turning guide."""
        for link in self.turning:
            key = f"{'w' if self.kind == 'v' else 'e'}_{link}"
            if link in self.alike:
                source = self.rate(link)
                self.values[key], self.per_mm[key] = self.values[source], self.per_mm[source]
                self._turns_like(link, source.partition("_")[2])

    def _turns_like(self, link: str, source: str) -> None:
        """Say of a link that it turns as another whose sense was found."""
        found = next((one for one in self.senses if one.link == source), None)
        if found is not None:
            self.senses.append(Sense(link, "", "", found.sense, source))
