"""The contours of an Assur group, built: directions and vectors linear in the group's unknown directions.

Links joined by guides turn alike and share one unknown direction.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.mechanism import Scalar
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
Root = int | str  # what a direction turns with: an unknown direction by number, or a known link by name


@dataclass(frozen=True, eq=False)
class Direction:
    """A direction fixed to an unknown direction U_c or to a known link: U_c·turn, or u_link·turn."""

    root: Root
    turn: Scalar


@dataclass(frozen=True, eq=False)
class Form:
    """A vector linear in the unknown vectors: Σ points of known links + Σ vectors fixed to known links + Σ
    units[c]·U_c + Σ slides[p]·s_p·T_p."""

    points: tuple[tuple[int, str, Scalar], ...] = ()  # ±1, known link, place in its axes
    vectors: tuple[tuple[str, Scalar], ...] = ()
    units: tuple[tuple[int, Scalar], ...] = ()
    slides: tuple[tuple[int, int], ...] = ()

    def __add__(self, other: Form) -> Form:
        return Form(
            self.points + other.points,
            self.vectors + other.vectors,
            self.units + other.units,
            self.slides + other.slides,
        )

    def __neg__(self) -> Form:
        return Form(
            tuple((-sign, link, at) for sign, link, at in self.points),
            tuple((link, -arm) for link, arm in self.vectors),
            tuple((c, -arm) for c, arm in self.units),
            tuple((p, -sign) for p, sign in self.slides),
        )


def directions_of(group: Group) -> dict[str, Direction]:
    """Direction of every link: links joined by guides turn alike. Raises ProblemError for a contour of guides alone."""
    found: dict[str, Direction] = {}
    sliding = [pair for pair in (*group.outer, *group.inner) if pair.kind == "P"]

    def spread() -> None:
        while pair := next(
            (p for p in sliding if any(end in found or end not in group.links for end in p.links)), None
        ):
            sliding.remove(pair)
            known = next(end for end in pair.links if end in found or end not in group.links)
            other = pair.other(known)
            of = found.get(known, Direction(known, 1.0))
            if other in found:
                raise ProblemError([_only_guides(pair, group)])
            found[other] = Direction(of.root, of.turn * pair.along[known] / pair.along[other])

    spread()
    count = 0
    for link in group.links:
        if link not in found:
            found[link] = Direction(count, 1.0)
            count += 1
            spread()
    return found


def _only_guides(pair: Pair, group: Group) -> Any:
    text = N_("links %(links)s are joined in a loop by prismatic pairs alone: a translation stays free")
    right = Message(N_("make one of the pairs a pivot"))
    return mistake(text, ("mechanism", "guides", pair.name), right, links=", ".join(group.links))


def known_part(s: State, form: Form, order: int) -> Array:
    """The known part of a form, or its first or second derivative."""
    total: Array = 0j
    for sign, link, at in form.points:
        if order == 0:
            total = total + sign * s.world(link, at)
        else:
            rate = s.velocity if order == 1 else s.acceleration
            total = total + sign * rate(link, s.u[link] * (at - s.o[link]))
    for link, arm in form.vectors:
        total = total + (1.0, s.iw.get(link), s.ie.get(link))[order] * s.u[link] * arm
    return total


class Contours:
    """The contours of one group, built from its pairs, and the places of its links."""

    def __init__(self, group: Group):
        self.group = group
        self.sliding = tuple(pair for pair in (*group.outer, *group.inner) if pair.kind == "P")
        self.directions = directions_of(group)
        self.angles = 1 + max(
            (d.root for d in self.directions.values() if isinstance(d.root, int)), default=-1
        )
        self.guides = tuple(self._guide(pair) for pair in self.sliding)
        self.origins: dict[str, Scalar] = {}
        self.places: dict[str, Form] = {}
        self.references: dict[str, Pair] = {}
        self.closures = self._build()

    # ------------------------------------------------------------ building

    def _guide(self, pair: Pair) -> Direction:
        """Direction of a guide as seen from the group."""
        link = next(end for end in pair.links if end in self.directions)
        of = self.directions[link]
        return Direction(of.root, of.turn * pair.along[link])

    def _build(self) -> tuple[Form, ...]:
        """Place the links one from another, outer pairs first; the pairs left over close the contours."""
        waiting = [*self.group.outer, *self.group.inner]
        while len(self.places) < len(self.group.links):
            pair = next(p for p in waiting if self._open_end(p) is not None)
            waiting.remove(pair)
            child = str(self._open_end(pair))
            self.origins[child], self.references[child] = pair.at[child], pair
            gap = self._gap(pair, child)
            self.places[child] = self._point(pair.other(child), pair.at[pair.other(child)]) + gap
        return tuple(self._closure(pair) for pair in waiting)

    def _open_end(self, pair: Pair) -> str | None:
        """The link that the pair can place from its other end; None where both or neither are placed."""
        known = [end not in self.group.links or end in self.places for end in pair.links]
        return pair.links[known.index(False)] if sum(known) == 1 else None

    def _point(self, link: str, at: Scalar) -> Form:
        if link not in self.group.links:
            return Form(points=((1, link, at),))
        return self.places[link] + self._fixed(link, at - self.origins[link])

    def _fixed(self, link: str, arm: Scalar) -> Form:
        """A vector fixed to a link of the group."""
        of = self.directions[link]
        if isinstance(of.root, str):
            return Form(vectors=((of.root, of.turn * arm),))
        return Form(units=((of.root, of.turn * arm),))

    def _gap(self, pair: Pair, end: str) -> Form:
        """From the other link's joint to that of `end`: nothing in a pivot, ±s·T along a guide."""
        if pair.kind == "R":
            return Form()
        return Form(slides=((self.sliding.index(pair), 1 if end == pair.slider else -1),))

    def _closure(self, pair: Pair) -> Form:
        one, other = pair.links
        return self._point(one, pair.at[one]) + self._gap(pair, other) + -self._point(other, pair.at[other])

    @cached_property
    def _rows(self) -> tuple[Form, ...]:
        """The contours, then the places of the links."""
        return (*self.closures, *(self.places[link] for link in self.group.links))

    @cached_property
    def units(self) -> Array:
        """Coefficients of U, (rows, angles) or (rows, angles, V, 1), m."""
        rows = [
            [sum((arm for c, arm in form.units if c == n), 0j) for n in range(self.angles)]
            for form in self._rows
        ]
        shape = np.broadcast_shapes(*(np.shape(x) for row in rows for x in row))
        rows = [[np.broadcast_to(x, shape) for x in row] for row in rows]
        return np.array(rows, dtype=complex).reshape(len(self._rows), self.angles, *shape)

    @cached_property
    def slides(self) -> Array:
        """Coefficients of s·T, (rows, guides)."""
        count = len(self.sliding)
        rows = [[sum(sign for p, sign in form.slides if p == n) for n in range(count)] for form in self._rows]
        return np.array(rows, dtype=float).reshape(len(self._rows), count)

    @cached_property
    def size(self) -> float:
        """The longest arm of the group, m: its measure of length."""
        arms = [pair.at[link] for pair in (*self.group.outer, *self.group.inner) for link in pair.links]
        sizes = (np.max(np.abs(x), initial=0.0) for x in (self.units, *arms))
        return float(next((size for size in sizes if size > 0), 1.0))
