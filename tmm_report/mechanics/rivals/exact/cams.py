"""Followers of cams in exact numbers: their laws or profiles, and the links that replace their cam pairs.

A follower's coordinate q, its place and rates follow from its law and the cam's angle alone; the centre of curvature K
from the pitch curve's (or the face's) derivatives. Source: Artobolevsky, Theory of mechanisms and machines, ch. 26.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.cams.cam import FLATTEST, ByLaw, Cam, Sliding
from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN, Phases
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.rivals.exact import cam_profiles
from tmm_report.mechanics.rivals.exact.cam_profiles import spline_at
from tmm_report.mechanics.rivals.exact.numbers import Number, Three, context, cross, dot, exact, point, unit
from tmm_report.mechanics.rivals.exact.scheme import Body, Drives, Pose


def followers(linkage: Linkage) -> Drives | None:
    """The motion of every follower and of the link that replaces its cam pair; None without cams."""
    groups = [group for group in linkage.groups if isinstance(group, CamDyad)]
    if not groups:
        return None

    def found(phi: Any, pose: Pose) -> Pose:
        return {link: body for group in groups for link, body in _of(group, exact(phi), pose).items()}

    return found


def _of(group: CamDyad, phi: Number, pose: Pose) -> Pose:
    cam: Cam = group.cam
    own, axis, omega = context(), point(cam.axis), pose[cam.cam].w
    q = coordinate(cam, phi)
    b, u = _point(cam, q), _turn(cam, q.z)
    w, e = (
        (own.mpf(0), own.mpf(0)) if isinstance(cam.motion, Sliding) else (omega * q.d, omega * omega * q.dd)
    )
    arm = u * point(group.references[cam.follower].at[cam.follower])
    if isinstance(cam.motion, Sliding):
        follower = Body(axis + b.z - arm, u, omega * b.d, w, omega * omega * b.dd, e)
    else:
        pivot = axis + point(cam.motion.pivot)
        follower = Body(pivot - arm, u, -1j * w * arm, w, (w * w - 1j * e) * arm, e)
    K = (_centre_of_face if cam.flat else _centre_of_roller)(cam, q, b)
    v, a = 1j * omega * K, -omega * omega * K
    if cam.flat:
        link = Body(axis + K, u * unit(cam.face), v, w, a, e)
    else:
        along = b.z - K
        rate, second = ((omega**k * x - y) / along for k, x, y in ((1, b.d, v), (2, b.dd, a)))
        link = Body(axis + K, along, v, rate.imag, a, second.imag)
    return {cam.follower: follower, cam.name: link}


def _point(cam: Cam, q: Three) -> Three:
    """The follower's point B from the cam's axis."""
    if isinstance(cam.motion, Sliding):
        along = unit(cam.motion.along)
        return Three(point(cam.motion.foot) + q.z * along, q.d * along, q.dd * along)
    w = abs(point(cam.motion.arm)) * context().expj(q.z)
    return Three(point(cam.motion.pivot) + w, 1j * w * q.d, (1j * q.dd - q.d * q.d) * w)


def _turn(cam: Cam, q: Number) -> Number:
    if isinstance(cam.motion, Sliding):
        return unit(cam.motion.turn)
    return context().expj(q) * unit(cam.motion.arm).conjugate()


def _centre_of_roller(cam: Cam, q: Three, b: Three) -> Number:
    """K from the axis: the centre of curvature of the path of B in axes that turn with the cam."""
    c1, c2 = b.d - 1j * b.z, b.dd - 2j * b.d - b.z
    speed = abs(c1)
    radius = _bounded(cam, -(speed**3), cross(c1, c2))
    return b.z - 1j * radius * c1 / speed


def _centre_of_face(cam: Cam, q: Three, b: Three) -> Number:
    """K from the axis, by the distance h of the face and the rate p at which its normal turns in the cam's axes."""
    n = 1j * unit(cam.face) * _turn(cam, q.z)
    if isinstance(cam.motion, Sliding):
        n = n if dot(n, unit(cam.motion.along)) > 0 else -n
        slant = dot(n, unit(cam.motion.along))
        h, p = Three(dot(n, b.z), slant * q.d, slant * q.dd), Three(-1, 0, 0)
    else:
        n = n if cam.motion.side * dot(point(cam.motion.arm), point(cam.face)) > 0 else -n
        pivot = point(cam.motion.pivot)
        across, along = dot(1j * n, pivot), dot(n, pivot)
        h = Three(dot(n, b.z), across * q.d, across * q.dd - along * q.d**2)
        p = Three(q.d - 1, q.dd, 0)
    radius = h.z + h.dd / p.z**2 - h.d * p.d / p.z**3
    return n * (h.z - radius + 1j * h.d / p.z)


def _bounded(cam: Cam, top: Number, below: Number) -> Number:
    """Radius of curvature, no longer than a straight piece's is taken."""
    most = exact(FLATTEST) * exact(cam.size)
    return most if below == 0 else min(max(top / below, -most), most)


# ---------------------------------------------------------------- laws


def coordinate(cam: Cam, phi: Number) -> Three:
    """q with its derivatives by the driving link's angle, rad."""
    given = cam.given
    if not isinstance(given, ByLaw):
        return cam_profiles.coordinate(cam, phi)
    rough = given.theta(float(phi))
    theta = given.sense * (phi - exact(given.start))
    s = (
        _phases(given.law, theta, float(rough))
        if isinstance(given.law, Phases)
        else spline_at(given.law.spline, theta)
    )
    sign = given.side * given.sense
    return Three(exact(given.low) + given.side * s.z, sign * s.d, given.side * s.dd)


def _phases(law: Phases, theta: Number, rough: float) -> Three:
    """S with its derivatives; an angle within `EDGE` of the end of a phase belongs to the next."""
    own = context()
    near = float(np.mod(rough + EDGE, FULL_TURN) - EDGE)
    theta = theta - 2 * own.pi * own.nint((theta - near) / (2 * own.pi))
    k = int(np.clip(np.searchsorted(law.edges - EDGE, near, side="right") - 1, 0, len(law.phases) - 1))
    phase = law.phases[k]
    if phase.kind == "dwell":
        return Three(exact(law.level(k)), own.mpf(0), own.mpf(0))
    angle, h = exact(phase.angle), exact(law.lift)
    t = (theta - exact(law.edges[k])) / angle
    half = (near - law.edges[k]) / phase.angle < 0.5 - EDGE
    f = _law(phase.law, t, half)
    way = 1 if phase.kind == "rise" else -1
    return Three((0 if way > 0 else h) + way * h * f.z, way * h * f.d / angle, way * h * f.dd / angle**2)


def _law(name: str, t: Number, first_half: bool) -> Three:
    """f, f', f'' of the laws of `cam_laws`."""
    own = context()
    one, pi = own.mpf(1), own.pi
    if name == "parabolic":
        return (
            Three(2 * t * t, 4 * t, 4 * one)
            if first_half
            else Three(1 - 2 * (1 - t) ** 2, 4 * (1 - t), -4 * one)
        )
    if name == "cosine":
        c, s = own.cos(pi * t), own.sin(pi * t)
        return Three((1 - c) / 2, pi * s / 2, pi**2 * c / 2)
    if name == "sine":
        c, s = own.cos(2 * pi * t), own.sin(2 * pi * t)
        return Three(t - s / (2 * pi), 1 - c, 2 * pi * s)
    if name == "polynomial":
        return Three(
            10 * t**3 - 15 * t**4 + 6 * t**5,
            30 * t**2 - 60 * t**3 + 30 * t**4,
            60 * t - 180 * t**2 + 120 * t**3,
        )
    return Three(t, one, 0 * one)
