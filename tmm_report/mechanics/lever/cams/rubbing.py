"""Friction of a cam pair as loads on its two links: of a roller on its pin, of an edge or a face that slides.

The link that replaces the pair bears what is along the normal. Friction is what the true contact has beside it, across
the normal at the point where cam and follower touch; a roller is drawn along by the cam against the friction of its pin
(`mechanics/cams/forces.py`).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.cams.forces import Pin, Rubs, touching
from tmm_report.mechanics.lever.assur_groups import Pair, Structure
from tmm_report.mechanics.lever.forces.reactions import Load, Statics
from tmm_report.mechanics.lever.forces.reactions_with_friction import Rub
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Contact:
    """Where a cam and its follower rub. `presses`: the pair of the follower and the link that replaces the contact;
    `pair`: as it is told: the roller's pin, R, between that link, the roller, and the follower; else the higher
    pair."""

    cam: Cam
    presses: Pair
    pair: Pair

    @property
    def rolls(self) -> bool:
        return bool(self.cam.roller)


def contacts(structure: Structure) -> tuple[Contact, ...]:
    """One a cam pair."""
    found = []
    for cam in structure.mechanism.cams:
        presses = next(pair for pair in structure.pairs if set(pair.links) == {cam.name, cam.follower})
        higher = Pair("H", cam.name, (cam.cam, cam.follower), {})
        found.append(Contact(cam, presses, presses if cam.roller else higher))
    return tuple(found)


def replacing(structure: Structure) -> set[str]:
    """Keys of the pairs of the links that stand for cam pairs: none of them rubs itself."""
    names = {cam.name for cam in structure.mechanism.cams}
    return {pair.key for pair in structure.pairs if names & set(pair.links)}


def normal_force(contact: Contact, motion: Motion, found: Statics) -> Array:
    """Of the cam on its follower along the normal from the one to the other, N, (..., P)."""
    own = found.reactions[contact.presses.key].force
    phi = np.broadcast_to(motion.phi, motion.shape)
    on_follower = own if contact.presses.links[1] == contact.cam.follower else -own
    return dot(on_follower, contact.cam.contact(phi).normal)


def rate(contact: Contact, motion: Motion) -> Array:
    """How fast the roller turns on its pin, rad/s, or the contact slides, m/s; not below zero, (..., P)."""
    return _touching(contact, motion, Rubs()).drag * np.abs(motion.state.w[contact.cam.cam])


def rub(contact: Contact, motion: Motion, coefficient: Array, radius: float) -> Rub:
    """What rubs there for 1 N along the normal. `radius`: of the pin, m."""
    cam, s = contact.cam, motion.state
    here = _touching(
        contact, motion, Rubs(pin=Pin(radius, coefficient)) if contact.rolls else Rubs(face=coefficient)
    )
    phi = np.broadcast_to(motion.phi, motion.shape)
    push, at = here.direction - cam.contact(phi).normal, cam.axis + here.at
    loads = {
        link: Load(sign * push, cross(at - s.r[link], sign * push))
        for link, sign in ((cam.follower, 1), (cam.cam, -1))
    }
    # the pin bears the whole force of the contact
    size = coefficient * np.abs(here.direction) if contact.rolls else coefficient
    return Rub(contact.presses, size, np.ones(motion.shape), radius if contact.rolls else 1.0, loads=loads)


def across(contact: Contact, made: Rub) -> Array:
    """Force of friction on the follower for 1 N along the normal, complex."""
    assert made.loads is not None
    return made.loads[contact.cam.follower].force


def _touching(contact: Contact, motion: Motion, rubs: Rubs) -> Any:
    sense = 1 if np.ravel(motion.state.w[contact.cam.cam])[0] >= 0 else -1
    return touching(contact.cam, contact.cam.moved(np.broadcast_to(motion.phi, motion.shape)), sense, rubs)
