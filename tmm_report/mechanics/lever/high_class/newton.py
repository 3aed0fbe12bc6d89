"""Assur groups above class II: Newton's method on their own loop equations, along one branch that is proved.

A group is followed once over the turn from the assembly of position 0, in the sense of rotation (see `branch`). Any
position is then solved from the nearest nodes in two or three Newton steps, all at once; a root that lies farther from
the branch than its own can is not taken.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.high_class.branch.known import Known
from tmm_report.mechanics.lever.high_class.branch.sheet import FULL_TURN, Branch, Run, follow
from tmm_report.mechanics.lever.high_class.branch.trace import Interval
from tmm_report.mechanics.lever.loop_equations import Loops, newton
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass

__all__ = ["Branch", "HigherGroup", "Known", "Run"]

Array = Any
SINGULAR = 1e-6  # smallest singular value of the scaled Jacobian at which a branch can begin
CLOSED = 1e-10  # of the contours over the size: what is kept where Newton's method has no more to give


@dataclass(frozen=True, eq=False)
class HigherGroup:
    """A group of class III, IV or above in the assembly `start`: (driver angle, rad; q there).

    `known`: motion of the links before it; one such function a variant. `own`: of several variants at once, the loops
    of each alone. `senses` of rotation, one a variant. `sweep`: how far it is followed, rad. `walls`: driver angles
    between which the links before it do not exist, where they are known.
    """

    group: Group
    loops: Loops
    start: tuple[tuple[float, Array], ...]
    known: tuple[Known, ...]
    own: tuple[Loops, ...] = ()
    senses: tuple[int, ...] = (1,)
    sweep: float = FULL_TURN
    walls: tuple[Interval, ...] = ()

    @property
    def links(self) -> tuple[str, ...]:
        return self.group.links

    @property
    def references(self) -> Mapping[str, Pair]:
        return self.loops.references

    @cached_property
    def branches(self) -> tuple[Branch, ...]:
        """The branch of every variant."""
        each = zip(self.own or (self.loops,), self.known, self.start, self.senses, strict=True)
        return tuple(
            follow(loops, known, *start, sense, self.sweep, self.walls) for loops, known, start, sense in each
        )

    @property
    def changes(self) -> tuple[float, ...]:
        return self.branches[0].changes

    @property
    def meetings(self) -> tuple[float, ...]:
        """Driver angles at which two assemblies meet, rad: each is passed straight on."""
        return self.changes

    def beginning(self, phi: float, sweep: float) -> HigherGroup:
        """The group followed from position 0 at driver angle `phi`, rad, over the sweep, if it goes not all round or
        not so far. Its assembly there is the sketch's, brought to it the shorter way; where it cannot be brought to it,
        the branch stays as it is."""
        (angle, _), run = self.start[0], self.branches[0].run
        if run.whole and sweep >= FULL_TURN - 1e-12:
            return self
        off = float(np.angle(np.exp(1j * (phi - angle))))
        if abs(off) < 1e-12:
            return self if sweep == self.sweep else replace(self, sweep=sweep)
        ways = [off, off - np.copysign(FULL_TURN, off)]
        for way in ways:
            sense = 1 if way > 0 else -1
            there = replace(self, senses=(sense,), sweep=abs(way) + 1e-9).branches[0]
            q = there.guess(np.array([angle + way]))
            s = self.known[0](np.array([angle + way]))
            q = newton(self.loops, s, q)
            if np.isfinite(q).all():
                if not self.loops.closeness(s, q)[0] > SINGULAR:
                    raise ProblemError([self._singular(phi)])
                return replace(self, start=((phi, q[0]),), sweep=sweep)
        return self

    def _singular(self, phi: float) -> Problem:
        text = N_("position 0 (driving link at %(angle).4f°) is a singular position of group %(group)s")
        right = Message(N_("state position 0 by another angle"))
        angle = float(np.degrees(phi))
        return mistake(text, ("mechanism", "driver", "zero"), right, group=self.group.label, angle=angle)

    def place(self, s: State) -> None:
        """Add the poses of the links to the state; nan where the group cannot be assembled."""
        phi = np.asarray(s.phi, dtype=float)
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            guess, room = self._near(phi)
            q = newton(self.loops, s, guess)
            # next to a singular position Newton's method may slip to another root, or not settle
            astray = ~(np.abs(q - guess).max(axis=-1) <= room)
            if astray.any():
                left = np.abs(self.loops.residual(s, guess)).max(axis=-1)
                kept = np.where((left <= CLOSED)[..., None], guess, np.nan)
                q = np.where(astray[..., None], kept, q)
        self.loops.place(s, q)
        for wheel in self.group.wheels:
            wheel.place(s)

    def _near(self, phi: Array) -> tuple[Array, Array]:
        """q near the branches at driver angles (..., P), and how far from it the branches' own roots may be."""
        if len(self.branches) == 1:
            return self.branches[0].near(phi)
        rows = np.broadcast_to(phi, np.broadcast_shapes(phi.shape, (len(self.branches), 1)))
        axis = rows.ndim - 2
        parts = [b.near(np.take(rows, v, axis=axis)) for v, b in enumerate(self.branches)]
        return np.stack([q for q, _ in parts], axis=axis), np.stack([room for _, room in parts], axis=axis)

    def move(self, s: State) -> None:
        """Add the rates of the links to the state."""
        self.loops.move(s)
        for wheel in self.group.wheels:
            wheel.move(s)

    def closeness(self, s: State) -> Array:
        """Smallest singular value of the scaled Jacobian, (..., P)."""
        return self.loops.closeness(s, self.loops.read(s))
