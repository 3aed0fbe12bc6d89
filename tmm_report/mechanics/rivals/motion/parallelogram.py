"""Groups with a parallelogram among their links, in elementary closed form.

Four links joined by pivots whose opposite sides are equal, and which do not cross, keep these sides parallel: opposite
links turn alike, however the contour moves. That leaves of the group

    dyad RRR      nothing: each link turns as the known link opposite to it
    class III     one side is a known link's, its own turning is the basis link's: a leg X and the third leg close
    class IV      the links with the outer joints turn alike: a rod X closes with the rest

one triangle X + Y = d or X + s·T = d, with |X| and |Y| or the direction T known: a square root, as of a dyad.
Source: the thesis of the press with twin rods, (2.7)–(2.9), of a class IV group whose slider does not turn.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot, resolve
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.motion import Motion, drive
from tmm_report.mechanics.rivals.motion.contours import Parallel, recognised
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

Array = Any
CHECKED = 24  # positions at which a contour must stand uncrossed
ALIKE = 1e-6  # of two directions: sides that are parallel


@dataclass(frozen=True, eq=False)
class Elementary:
    """A recognised group in the assembly `sign`, with the reference points that the linkage gives its links."""

    parallel: Parallel
    references: Mapping[str, Pair]
    sign: float = 1.0

    def solve(self, s: State) -> None:
        """Add poses and rates of the group's links to the state; nan where it does not close."""
        p = self.parallel
        roots: dict[str, tuple[Array, Array, Array]] = {}
        if p.gap is not None:
            roots = self._triangle(s)
        for link, (root, factor) in p.turns.items():
            vector, w, e = roots[root] if root in roots else (s.u[root], s.w[root], s.e[root])
            s.u[link] = vector * factor
            s.turn(link, w, e)
        for link, parent, pair in p.hung:
            self._hang(s, link, parent, pair)

    def _hang(self, s: State, link: str, parent: str, pair: Pair) -> None:
        """Place a link whose turning is known by the pivot that it has in common with one already placed."""
        o = self.references[link].at[link]
        arm = s.u[link] * (o - pair.at[link])
        s.o[link], s.r[link] = o, s.world(parent, pair.at[parent]) + arm
        held = s.u[parent] * (pair.at[parent] - s.o[parent])
        s.carry(
            link,
            s.velocity(parent, held) + s.iw[link] * arm,
            s.acceleration(parent, held) + s.ie[link] * arm,
        )

    def _triangle(self, s: State) -> dict[str, tuple[Array, Array, Array]]:
        """X and Y of X + Y = d, or X of X + s·T = d: vector, ω, ε."""
        p = self.parallel
        assert p.gap is not None
        d, dv, da = (p.gap.of(s, order) for order in (0, 1, 2))
        if p.guide is None:
            X = self._by_two_lengths(d)
            Y = d - X
            wx, wy = resolve(dv, 1j * X, 1j * Y)
            ex, ey = resolve(da + wx**2 * X + wy**2 * Y, 1j * X, 1j * Y)
            return {"x": (X, wx, ex), "y": (Y, wy, ey)}
        link, along = p.guide
        T = s.u[link] * along
        across = cross(T, d)
        X = T * (self.sign * np.sqrt(p.x**2 - across**2) + 1j * across)
        slid = dot(T, d - X)
        wx, ds = resolve(dv - slid * s.iw[link] * T, 1j * X, T)
        bent = da + wx**2 * X - 2 * ds * s.iw[link] * T - slid * s.ie[link] * T
        ex, _ = resolve(bent, 1j * X, T)
        return {"x": (X, wx, ex)}

    def _by_two_lengths(self, d: Array) -> Array:
        """X of the triangle with sides |X|, |Y| and d, on the stated side of d."""
        p, long = self.parallel, np.abs(d)
        along = (long**2 + p.x**2 - p.y**2) / (2 * long)
        return d / long * (along + 1j * self.sign * np.sqrt(p.x**2 - along**2))


@lru_cache(maxsize=8)
def elementary(cycle: Cycle) -> dict[Group, Elementary]:
    """The groups of a cycle's linkage that have an uncrossed parallelogram, in their assemblies; found once."""
    structure = cycle.linkage.structure
    found = {group: recognised(structure, group) for group in structure.groups}
    if not any(found.values()):
        return {}
    motion = cycle.motion(cycle.once(CHECKED))
    return {
        of.group: _assembled(parallel, of.references, motion)
        for of in cycle.linkage.groups
        if (parallel := found[of.group]) is not None and _uncrossed(parallel, motion)
    }


def _uncrossed(parallel: Parallel, motion: Motion) -> bool:
    """Whether the sides that are to be parallel are so wherever the mechanism closes."""
    (one, side), (other, opposite) = parallel.sides
    u = motion.state.u
    off = np.abs(u[one] * side - u[other] * opposite) / abs(side)
    return bool(np.all(np.nan_to_num(off) < ALIKE))


def _assembled(parallel: Parallel, references: Mapping[str, Pair], motion: Motion) -> Elementary:
    """The sign of the triangle's root, from position 0."""
    found = Elementary(parallel, references)
    if parallel.gap is None:
        return found
    s = motion.state
    link, factor = next((name, turn) for name, (root, turn) in parallel.turns.items() if root == "x")
    X, d = s.u[link] / factor, parallel.gap.of(s, 0)
    side = cross(d, X) if parallel.guide is None else dot(s.u[parallel.guide[0]] * parallel.guide[1], X)
    return replace(found, sign=float(np.sign(np.ravel(side)[0])))


def parallelogram(cycle: Cycle, count: int) -> Motion:
    """Motion with every parallelogram in closed form, the other groups in their own way. In a change point, where all
    four pivots of the contour lie in a line, the sides stay parallel and nothing is lost.

    Raises ArithmeticError where no group has one.
    """
    own = elementary(cycle)
    if not own:
        raise ArithmeticError(N_("no group has a parallelogram"))
    linkage = cycle.linkage
    phi = cycle.phi(cycle.once(count))
    with np.errstate(all="ignore"):
        s = drive(linkage, phi)
        for of in linkage.groups:
            if of.group in own:
                own[of.group].solve(s)
            else:
                of.place(s)
                of.move(s)
    return Motion(linkage, phi, linkage.mechanism.driver.omega, s, np.shape(phi))


def refuses(cycle: Cycle) -> Message | None:
    """Why the closed form of the parallelogram cannot be used."""
    structure = cycle.linkage.structure
    if all(recognised(structure, group) is None for group in structure.groups):
        return Message(
            N_("no four links joined by pivots have opposite sides equal: there is no parallelogram")
        )
    if not elementary(cycle):
        return Message(N_("the links with equal opposite sides stand crossed, not as a parallelogram"))
    return None
