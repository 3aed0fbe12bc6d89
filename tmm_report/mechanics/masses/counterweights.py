"""Shaking of a foundation by the inertia of a mechanism, and the counterweights against it.

F = −Σ m a_S, M = −Σ (r_S × m a_S + J ε) about a point: what the moving links hand on to the frame, weights and loads
aside. Arrays (..., P), SI. Sources: Artobolevsky, ch. 13 (balancing on the foundation); Berkof, Lowen, A new method
for completely force balancing simple linkages, J. Eng. Ind. 91 (1969); Tepper, Lowen, General theorems concerning full
force balancing of planar linkages by internal mass redistribution, J. Eng. Ind. 94 (1972).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.mechanism import FRAME, Link, Mechanism
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Weight:
    """A counterweight: a point mass, kg, fixed to a link at `at`, complex, m, in the link's axes."""

    link: str
    mass: float
    at: complex


def shaking(motion: Motion, about: Array = 0j) -> tuple[Array, Array]:
    """Shaking force, complex N, and moment about a fixed point, N m: of the inertia of all links."""
    force, moment = np.zeros(motion.shape, dtype=complex), np.zeros(motion.shape)
    for name, link in motion.linkage.mechanism.links.items():
        if name == FRAME:
            continue
        moment = moment - link.inertia * motion.angular_acceleration(name)
        if link.mass_centre is not None and link.mass:
            part = -link.mass * motion.acceleration(link.mass_centre)
            force = force + part
            moment = moment + cross(motion.place(link.mass_centre) - about, part)
    return force, moment


def added(motion: Motion, weights: Iterable[Weight], about: Array = 0j) -> tuple[Array, Array]:
    """What counterweights add to the shaking force and moment."""
    force, moment = np.zeros(motion.shape, dtype=complex), np.zeros(motion.shape)
    s = motion.state
    for weight in weights:
        arm = s.u[weight.link] * (weight.at - s.o[weight.link])
        part = -weight.mass * s.acceleration(weight.link, arm)
        force = force + part
        moment = moment + cross(s.r[weight.link] + arm - about, part)
    return force, moment


def on_frame(motion: Motion, about: Array = 0j) -> tuple[Array, Array]:
    """Force and moment of all pairs of the frame on it under inertia alone, with the reaction of the motor, which
    stands on the frame: the shaking force and moment by the reactions of the groups."""
    found = statics.solve(motion, statics.inertia_and_gravity(motion, 0j))
    force, moment = _of_motor(motion, found.balancing, about)
    for reaction in found.reactions.values():
        if FRAME in reaction.pair.links:
            sign = -1 if reaction.pair.links[0] == FRAME else 1
            force = force + sign * reaction.force
            moment = moment + sign * (cross(reaction.at - about, reaction.force) + reaction.moment)
    return force, moment


def _of_motor(motion: Motion, balancing: Array, about: Array) -> tuple[Array, Array]:
    """What the motor does to the frame: a moment, or the force of the wheel that drives, by its shaft."""
    driver = motion.linkage.mechanism.driver
    if driver.gear is None:
        return np.zeros(motion.shape, dtype=complex), -balancing
    force = -driver.gear.force(balancing, driver.omega)
    pivot = motion.place(motion.linkage.structure.driver_pair.name)
    return force, cross(pivot + driver.gear.pitch_point - about, force)


def fitted(mechanism: Mechanism, weights: Iterable[Weight]) -> Mechanism:
    """The mechanism with the counterweights as parts of its links: new masses, mass centres, moments of inertia."""
    links = dict(mechanism.links)
    for weight in weights:
        links[weight.link] = _joined(links[weight.link], weight)
    return replace(mechanism, links=links)


def _joined(link: Link, weight: Weight) -> Link:
    """The link and a point mass as one body (Steiner)."""
    own = link.points[link.mass_centre] if link.mass_centre is not None else weight.at
    mass = link.mass + weight.mass
    centre = (link.mass * own + weight.mass * weight.at) / mass
    inertia = link.inertia + link.mass * abs(own - centre) ** 2 + weight.mass * abs(weight.at - centre) ** 2
    name = f"centre of {link.name}"  # no name of a variant has a blank
    points = {**link.points, name: centre}
    return replace(link, points=points, mass=mass, mass_centre=name, inertia=inertia)


def weighted(
    linkage: Linkage, weights: Iterable[Weight], inertia: Mapping[str, float] | None = None
) -> Linkage:
    """The linkage whose links have the counterweights; `inertia`: what their moments of inertia have besides, kg m²."""
    mechanism = fitted(linkage.mechanism, weights)
    if inertia:
        more = {name: replace(link, inertia=link.inertia + inertia.get(name, 0.0))
                for name, link in mechanism.links.items()}  # fmt: skip
        mechanism = replace(mechanism, links=more)
    return replace(linkage, structure=replace(linkage.structure, mechanism=mechanism))


# ---------------------------------------------------------------- paths of pivots


@dataclass(frozen=True)
class Support:
    """The pivot through which a link hangs, by pivots alone, on the frame: `parent` is the next link on the way, `at`
    and `on_parent` the pivot in the axes of either, `depth` how many pivots lie between."""

    link: str
    parent: str
    joint: str
    at: complex
    on_parent: complex
    depth: int


def supports(pairs: Sequence[Pair], driver: str) -> dict[str, Support]:
    """Of every link that a path of pivots joins to the frame the shortest one; of equal ones not by the driving link.

    Where a link is missing, no counterweights balance the mechanism fully (contour theorem of Tepper and Lowen).
    """
    turning = [pair for pair in pairs if pair.kind == "R"]
    found: dict[str, Support] = {}
    level, depth = [FRAME], 0
    while level:
        depth += 1
        reached: dict[str, Support] = {}
        for parent in sorted(level, key=lambda link: link == driver):
            for pair in turning:
                if parent in pair.links and (link := pair.other(parent)) not in (FRAME, *found, *reached):
                    reached[link] = Support(link, parent, pair.name, pair.at[link], pair.at[parent], depth)
        found |= reached
        level = list(reached)
    return found


def pivoted(pairs: Sequence[Pair]) -> dict[str, complex]:
    """Links that turn about a fixed pivot -> the pivot in the link's axes."""
    return {
        pair.other(FRAME): complex(pair.at[pair.other(FRAME)])
        for pair in pairs
        if pair.kind == "R" and FRAME in pair.links
    }


# ---------------------------------------------------------------- counterweights by the force


def against(motion: Motion, links: Mapping[str, complex], force: Array) -> tuple[dict[str, complex], Array]:
    """Static moments m_c ρ_c, complex kg m in the axes of links that turn about fixed pivots: which leave the least
    mean square of the shaking force (P,) over the positions; and the force that is left.

    M s = const + Σ U_j e^{iθ_j}: where the closed contours tell all turning vectors by those of the pivoted links,
    nothing is left (method of linearly independent vectors); else it is the best that their counterweights can do.
    """
    s = motion.state
    columns = np.array([np.broadcast_to(-s.ie[link] * s.u[link], motion.shape) for link in links]).T
    sizes = np.linalg.norm(columns, axis=0)
    x, *_ = np.linalg.lstsq(columns / sizes, -force, rcond=1e-10)
    moments = x / sizes
    left = force + columns @ moments
    return {link: complex(moment) for link, moment in zip(links, moments, strict=True)}, left


def smallest_circle(points: Array) -> tuple[complex, float, Array]:
    """Centre and radius of the smallest circle round points (N,), and the numbers of the two or three on it.

    The farthest point is taken in until none is outside: the circles grow, so it ends, and with the exact one (the
    least of a greatest distance is convex: Elzinga, Hearn, Transportation Science 6).
    """
    points = np.asarray(points, dtype=complex)
    start = int(np.argmax(np.abs(points - points.mean())))
    on = [start, int(np.argmax(np.abs(points - points[start])))]
    size = np.abs(points - points[start]).max()
    centre, radius = _about(points[on])
    for _ in range(len(points)):
        distances = np.abs(points - centre)
        far = int(np.argmax(distances))
        if distances[far] <= radius + 1e-14 * size or far in on:
            break
        centre, radius, on = _least(points, [*on, far])
    return centre, float(radius), np.array(sorted(set(on)))


def _least(points: Array, among: list[int]) -> tuple[complex, float, list[int]]:
    """The smallest circle round three or four points, and those on it."""
    new, rest = among[-1], among[:-1]
    choices = [[k, new] for k in rest] + [[a, b, new] for i, a in enumerate(rest) for b in rest[i + 1 :]]
    best: tuple[complex, float, list[int]] | None = None
    for on in choices:
        centre, radius = _about(points[on])
        holds = np.all(np.abs(points[among] - centre) <= radius * (1 + 1e-13))
        if holds and (best is None or radius < best[1]):
            best = centre, radius, on
    assert best is not None  # one of the circles through the new point holds them all
    return best


def _about(points: Array) -> tuple[complex, float]:
    """The circle on two points as its diameter, or through three."""
    if len(points) == 2:
        centre = complex(points.mean())
        return centre, float(np.abs(points - centre).max())
    a, b, c = points
    u, v = b - a, c - a
    area = 2 * cross(u, v)
    if abs(area) <= 1e-15 * abs(u) * abs(v):
        return complex(np.nan), np.inf
    centre = a + 1j * (u * abs(v) ** 2 - v * abs(u) ** 2) / area
    return complex(centre), float(np.abs(points - centre).max())
