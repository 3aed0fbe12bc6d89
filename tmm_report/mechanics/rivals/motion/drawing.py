"""Places and plans as pencil and compasses give them, of all positions at once: to so many mm of paper.

The scheme is drawn at a round scale on a sheet of 200 mm, group by group: joints are placed to the accuracy, a link
lies between two of its joints as they are drawn. The plans of velocities and of accelerations have a round scale each
for the whole cycle, at which their longest vector is up to 180 mm: of a group the vector equations are closed in the
scheme as it is drawn, vertices are placed to the accuracy, ω and ε come from segments read to it, normal and Coriolis
parts from these ω, all other points by similarity. With 0.01 mm, by computer, points are exact and lengths are read, as
in the note's own plans. Nothing is random.

A dyad is constructed by arcs and lines. A group above class II, for which there is no such construction, is placed
where its links fit the joints drawn before it, as a template shifted by trial would be; then its joints are rounded as
all others. Source: Artobolevsky, Theory of mechanisms and machines, ch. 4.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import unit
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.loop_equations import solve_each
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage, Motion, drive
from tmm_report.mechanics.rivals.motion.coordinates import Coordinates, coordinates
from tmm_report.mechanics.rivals.motion.turning import Turning, turning
from tmm_report.mechanics.rivals.paper import LONGEST, SHEET, Pen, round_scale, rounded
from tmm_report.problems import N_

Array = Any


LARGEST = 5000.0  # mm: a vector of a plan that is longer has no sheet


class Scheme(State):
    """A state whose joints are where they are drawn."""

    pen: Pen

    def world(self, link: str, at: Array) -> Array:
        """Where a point of a link is drawn, m."""
        return self.drawn(super().world(link, at))

    def drawn(self, place: Array) -> Array:
        return self.pen.placed(np.asarray(place) / self.pen.metres) * self.pen.metres


def drawing(cycle: Cycle, count: int, accuracy: float) -> Motion:
    """Motion as read off drawings with an accuracy of so many mm; nan where a group does not close as it is drawn, or
    the lines of its plan cross on no sheet.

    The exact motion says how large the drawings are, and nothing else. Raises ArithmeticError where nothing of it
    exists.
    """
    exact = cycle.motion(cycle.once(count))
    c = coordinates(cycle.linkage)
    phi = cycle.phi(cycle.once(count))
    with np.errstate(all="ignore"):
        pen = Pen(accuracy, scale(_span(exact.places), SHEET))
        q = c.read(Motion(cycle.linkage, phi, exact.omega, scheme(cycle.linkage, phi, pen), exact.shape))
        omega = abs(float(exact.omega))
        v, a = (scale(_largest(np.abs(x)), LONGEST) for x in (exact.velocities, exact.accelerations))
        first, velocities = _plan(c, q, pen, v / (c.size * omega), None)
        accelerations = _plan(c, q, pen, a / (c.size * omega**2), first)[1]
        return _read_off(c.motion(phi, q, velocities, accelerations), pen)


def scale(largest: float, paper: float) -> float:
    """The round scale at which `largest`, SI, is at most `paper` mm long."""
    return float(round_scale(np.array([largest]), paper)[0])


def _largest(values: Array) -> float:
    known = values[np.isfinite(values)]
    if not known.size:
        raise ArithmeticError(N_("there is no position to draw"))
    return float(known.max())


def _span(places: Array) -> float:
    """Width or height of the mechanism over its cycle, m."""
    return max(_largest(x) + _largest(-x) for x in (places.real, places.imag))


# ---------------------------------------------------------------- the scheme


def scheme(linkage: Linkage, phi: Array, pen: Pen) -> Scheme:
    """All links where they are drawn at driver angles `phi` (P,), no rates."""
    known = drive(linkage, phi)
    s = Scheme(phi=phi)
    s.pen = pen
    for link in (FRAME, linkage.mechanism.driver.link):
        s.o[link], s.r[link], s.u[link] = known.o[link], known.r[link], known.u[link]
    _draw(s, linkage, linkage.mechanism.driver.link)
    for group in linkage.groups:
        group.place(s)
        alone = [link for one in turning(linkage, group.group) if len(one.links) == 1 for link in one.links]
        for link in group.links:
            _draw(s, linkage, link, link in alone)
    return s


def _draw(s: Scheme, linkage: Linkage, link: str, turned: bool = True) -> None:
    """A link placed by its joints: its reference point, and the farthest joint, which gives its direction."""
    pivots = [pair for pair in linkage.structure.pairs if link in pair.links and pair.kind == "R"]
    arms = [complex(pair.at[link] - s.o[link]) for pair in pivots]
    far = max(arms, key=abs, default=0j)
    end = s.world(link, s.o[link] + far)
    s.r[link] = s.drawn(s.r[link])
    if turned and far:
        s.u[link] = unit((end - s.r[link]) / far)


# ---------------------------------------------------------------- the plans


def _plan(c: Coordinates, q: Array, pen: Pen, per_mm: float, velocity: Array | None) -> tuple[Array, Array]:
    """Rates of all coordinates (P, 3n) by the driver's angle, from a plan of so much per mm; of second order where the
    first, `velocity`, are given. First as they are drawn on with, then as they are read."""
    _, J = c.equations(q, np.zeros(q.shape[:-1]))
    right = np.zeros(q.shape) if velocity is None else c.bend(q, velocity)
    x = np.zeros(q.shape)
    x[..., c.driver] = 1.0 if velocity is None else 0.0
    for (rows, columns), group in zip(c.blocks, c.linkage.structure.groups, strict=True):
        own = J[..., rows, columns]
        rest = np.einsum("...ij,...j->...i", J[..., rows[:, 0], :], x)
        x[..., columns] = on_a_sheet(solve_each(own, right[..., rows[:, 0]] - rest), per_mm)
        for one in turning(c.linkage, group):
            _read_turning(c, q, x, one, pen, per_mm, velocity)
        _on_paper(x, columns[::3], pen.placed, per_mm)
    read = x.copy()
    _on_paper(read, np.arange(0, c.count, 3), pen.read, per_mm)
    return x, read


def on_a_sheet(x: Array, per_mm: float) -> Array:
    """Rates of a group's links where its lines cross on a sheet, else nan: they are as good as parallel."""
    mm = np.hypot(x[..., 0::3], x[..., 1::3]) / per_mm
    return np.where((mm < LARGEST).all(axis=-1)[..., None], x, np.nan)


def _on_paper(x: Array, columns: Array, mark: Callable[[Array], Array], per_mm: float) -> None:
    """Vectors whose components stand in these columns and the next, as they are marked on paper."""
    z = mark((x[..., columns] + 1j * x[..., columns + 1]) / per_mm) * per_mm
    x[..., columns], x[..., columns + 1] = z.real, z.imag


def _read_turning(
    c: Coordinates, q: Array, x: Array, one: Turning, pen: Pen, per_mm: float, velocity: Array | None
) -> None:
    """ω, or ε, of links that turn alike: the segment between two joints in the plan, over their distance as drawn."""
    if one.ends is None:
        return
    (from_link, at), (to_link, to) = one.ends
    start, end = c.place(q, from_link, at), c.place(q, to_link, to)
    arm = end - start
    column = c.column(from_link)
    turn = x[..., column]
    normal = 0.0 if velocity is None else -(velocity[..., column] ** 2)
    base = x[..., column - 2] + 1j * x[..., column - 1] + (1j * turn + normal) * c.arm(q, from_link, at)
    base = pen.placed(base / per_mm)
    bent = pen.placed(base + normal * arm / per_mm)
    vertex = pen.placed(base + (1j * turn + normal) * arm / per_mm)
    length = rounded(np.abs(vertex - bent), pen.accuracy) * per_mm
    found = np.copysign(length / np.abs(arm), turn)
    for link in one.links:
        x[..., c.column(link)] = np.where(np.abs(arm) > 0, found, turn)


def _read_off(motion: Motion, pen: Pen) -> Motion:
    """The places of all points as they are read off the scheme: with coordinates to the accuracy."""

    def read(place: Array) -> Array:
        mm = place / pen.metres
        return (rounded(mm.real, pen.accuracy) + 1j * rounded(mm.imag, pen.accuracy)) * pen.metres

    s = motion.state
    places = {
        point: (link, read(s.r[link] + s.u[link] * arm)) for point, (link, arm) in motion.linkage.arms.items()
    }
    s.r |= {link: read(r) for link, r in s.r.items() if link != FRAME}
    arms = {point: (link, place - s.r[link]) for point, (link, place) in places.items() if link != FRAME}
    return replace(motion, _arms=arms)
