"""Cams and their followers' ends on a scheme: the outline of the cam, the roller, the flat face, in the axes of the
links, mm."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism

FINE = 361  # points of an outline
PAST = 4.0  # how far a face runs past the contacts at its ends, mm


class Ends(NamedTuple):
    """What a link shows of cam pairs: closed outlines, rollers as (centre, radius), flat faces as bars."""

    outlines: tuple[tuple[complex, ...], ...] = ()
    rollers: tuple[tuple[complex, float], ...] = ()
    faces: tuple[tuple[complex, complex], ...] = ()


def ends(mechanism: Mechanism, name: str, mu: float) -> Ends:
    """Of a link of the mechanism as it is built; nothing where links replace its cam pairs."""
    cams = [cam for cam in mechanism.cams if cam.name not in mechanism.links]
    return Ends(
        tuple(_outline(mechanism, cam, mu) for cam in cams if cam.cam == name),
        tuple(
            (_number(mechanism.links[name].points[cam.point]) / mu, cam.roller / mu)
            for cam in cams
            if cam.follower == name and cam.roller
        ),
        tuple(_face(mechanism, cam, mu) for cam in cams if cam.follower == name and cam.flat),
    )


def _outline(mechanism: Mechanism, cam: Cam, mu: float) -> tuple[complex, ...]:
    own, frame = mechanism.links[cam.cam].points, mechanism.links[FRAME].points
    pivot = next(_number(at) for point, at in own.items() if point in frame)
    return tuple(complex(pivot + z) / mu for z in cam.profile(np.linspace(0, 2 * np.pi, FINE)))


def _face(mechanism: Mechanism, cam: Cam, mu: float) -> tuple[complex, complex]:
    """The face over all contacts, in the follower's axes."""
    phi = np.linspace(0, 2 * np.pi, 181)
    q, b = cam.moved(phi)
    along = np.real((cam.contact(phi).at - b.z) * np.conj(cam.turn(q.z) * cam.face)) / mu
    at = _number(mechanism.links[cam.follower].points[cam.point]) / mu
    low, high = min(float(along.min()), 0.0) - PAST, max(float(along.max()), 0.0) + PAST
    return at + low * cam.face, at + high * cam.face


def _number(value: Any) -> complex:
    return complex(np.ravel(value)[0])
