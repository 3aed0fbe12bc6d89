"""A cam pair among the groups of a mechanism: it is replaced by a massless link, and the follower with it is a dyad.

The link joins the centre of curvature K, a point of the cam, to the roller's centre B, or slides along a flat face; in
every position velocities and accelerations are those of the mechanism with the cam, as the curves touch to the second
order. K moves on the cam and the link's length is the radius of curvature, so both differ from position to position:
the link is measured in its own length (KB = 1, and the state's direction `u` of it is the vector KB, m).
Source: Artobolevsky, Theory of mechanisms and machines, ch. 2 (replacing of higher pairs), 26.
"""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

import numpy as np

from tmm_report.mechanics.cams.cam import Cam, Moved, Sliding
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.dyads import Dyad, State, dyad
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Link, Mechanism, Slide
from tmm_report.mechanics.lever.motion import Linkage, Motion, solve
from tmm_report.records import dataclass

Array = Any
ALONE = 1.0 + 0j  # KB in the axes of the replacing link


def replaced(real: Mechanism, cams: tuple[Cam, ...], centre_at: complex) -> Mechanism:
    """The mechanism with a link in place of every cam pair. `centre_at`: a place of K on the cam; it moves."""
    links, guides, slides = dict(real.links), dict(real.guides), list(real.slides)
    for cam in cams:
        body, follower = links[cam.cam], links[cam.follower]
        links[cam.cam] = replace(body, points={**body.points, cam.centre: centre_at})
        if cam.flat:
            links[cam.name] = Link(cam.name, {cam.centre: 0j})
            guides[cam.guide] = Guide(cam.guide, cam.follower, follower.points[cam.point], cam.face)
            slides.append(Slide(cam.name, cam.guide, 0j, 1 + 0j))
        else:
            links[cam.name] = Link(cam.name, {cam.centre: 0j, cam.point: ALONE})
    return replace(real, links=links, guides=guides, slides=tuple(slides), cams=cams)


@dataclass(frozen=True, eq=False)
class CamDyad(Dyad):
    """The dyad of a follower and the link that replaces its cam pair: placed and moved by the follower's law."""

    cam: Any = None  # a Cam

    @property
    def two_roots(self) -> bool:
        return False

    def place(self, s: State) -> None:
        """Add the poses of both links to the state."""
        cam: Cam = self.cam
        q, b = cam.moved(s.phi)
        K = cam.axis + cam.contact(s.phi).centre
        turn = cam.turn(q.z)
        s.o[cam.name], s.r[cam.name] = 0j, K
        s.o[cam.follower] = self.references[cam.follower].at[cam.follower]
        s.r[cam.follower], s.u[cam.follower] = cam.axis + self._refers(b), turn
        s.u[cam.name] = turn * cam.face if cam.flat else cam.axis + b.z - K

    def _refers(self, b: Moved) -> Array:
        """The follower's reference point from O: B of one that slides, the pivot of one that swings."""
        return b.z if isinstance(self.cam.motion, Sliding) else self.cam.motion.pivot

    def move(self, s: State) -> None:
        """Add the rates of both links to the state: those of the law."""
        cam: Cam = self.cam
        q, b = cam.moved(s.phi)
        w, e = s.w[cam.cam], s.e[cam.cam]
        v_b, a_b = w * b.d, w * w * b.dd + e * b.d
        if isinstance(cam.motion, Sliding):
            s.turn_with(cam.follower, FRAME)
            s.carry(cam.follower, v_b, a_b)
        else:
            s.turn(cam.follower, w * q.d, w * w * q.dd + e * q.d)
            s.carry(cam.follower, 0j * v_b, 0j * a_b)
        arm = s.r[cam.name] - cam.axis
        v_k, a_k = s.iw[cam.cam] * arm, s.ie[cam.cam] * arm
        s.carry(cam.name, v_k, a_k)
        if cam.flat:
            s.turn_with(cam.name, cam.follower)
        else:
            along = s.u[cam.name]
            s.turn(cam.name, np.imag((v_b - v_k) / along), np.imag((a_b - a_k) / along))

    def closeness(self, s: State) -> Array:
        """Cosine of the pressure angle: 0 where the cam jams, (..., P)."""
        return np.abs(np.cos(self.cam.pressure(s.phi)))


def group_of(mechanism: Mechanism, group: Group, sign: int = 1) -> Dyad:
    """The dyad of a group of class II, of a follower with its cam if it is one."""
    made = dyad(mechanism, group, sign)
    cam = next((cam for cam in mechanism.cams if cam.name in group.links), None)
    if cam is None:
        return made
    return CamDyad(**{item.name: getattr(made, item.name) for item in fields(Dyad)}, cam=cam)


# ---------------------------------------------------------------- one position


def in_position(motion: Motion) -> Motion:
    """The motion at one position with its replacing links as they are there, of stated lengths: that of an ordinary
    mechanism with the same velocities and accelerations, whose plans can be drawn."""
    linkage = motion.linkage
    if not linkage.mechanism.cams:
        return motion
    state = motion.state
    mechanism = linkage.mechanism
    links = dict(mechanism.links)
    for cam in mechanism.cams:
        back = np.conj(_one(state.u[cam.cam]))
        own = links[cam.cam]
        axis = own.points[linkage.structure.driver_pair.name]
        centre = axis + (_one(state.r[cam.name]) - cam.axis) * back
        links[cam.cam] = replace(own, points={**own.points, cam.centre: centre})
        if not cam.flat:
            long = abs(_one(state.u[cam.name]))
            links[cam.name] = Link(cam.name, {cam.centre: 0j, cam.point: complex(long)})
    still = replace(mechanism, links=links)
    groups = tuple(_stood(group, still) for group in linkage.groups)
    structure = replace(linkage.structure, mechanism=still, groups=tuple(group.group for group in groups))
    return replace(motion, linkage=Linkage(structure, groups), state=_unit(state, mechanism), _arms={})


def standing(motion: Motion, k: int) -> Motion:
    """`in_position` of one of the motion's positions."""
    phi = np.broadcast_to(motion.phi, motion.shape)[k : k + 1]
    return in_position(solve(motion.linkage, phi))


def rests(motion: Motion, own: Cam | None = None) -> Array:
    """Positions in which a cam's centre of curvature is on its axis, (P,) of bool: its follower dwells, and there is no
    arm by which a plan could begin. `own`: of this cam alone."""
    found = np.zeros(motion.shape, dtype=bool)
    for cam in (own,) if own else motion.linkage.mechanism.cams:
        found |= np.broadcast_to(np.abs(motion.place(cam.centre) - cam.axis) < 1e-6 * cam.size, motion.shape)
    return found


def _stood(group: Any, still: Mechanism) -> Any:
    """A group with its cam's link as it is in one position: an ordinary dyad."""
    if not isinstance(group, CamDyad):
        return group
    own = group.group
    inner, outer = (tuple(_pair(pair, still) for pair in part) for part in (own.inner, own.outer))
    return dyad(still, replace(own, inner=inner, outer=outer))


def _pair(pair: Pair, still: Mechanism) -> Pair:
    if pair.kind == "P":
        return pair
    return replace(pair, at={link: still.links[link].points[pair.name] for link in pair.links})


def _unit(state: State, mechanism: Mechanism) -> State:
    """The state with unit directions of the replacing links too."""
    turned = dict(state.u)
    for cam in mechanism.cams:
        turned[cam.name] = state.u[cam.name] / np.abs(state.u[cam.name])
    return replace(state, u=turned)


def _one(value: Array) -> complex:
    return complex(np.ravel(value)[0])
