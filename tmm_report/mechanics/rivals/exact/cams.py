"""Followers of cams in exact numbers: their laws or profiles, and the links that replace their cam pairs.

A follower's coordinate q, its place and rates follow from its law and the cam's angle alone; the centre of curvature K
from the pitch curve's (or the face's) derivatives. Source: Artobolevsky, Theory of mechanisms and machines, ch. 26.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.cams.arcs import ArcLaw
from tmm_report.mechanics.cams.cam import FLATTEST, ByLaw, Cam, Sliding
from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN, Phases
from tmm_report.mechanics.cams.shapes import EDGE as SHARE
from tmm_report.mechanics.cams.shapes import Graph, Parabolic, Shape
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.rivals.exact import cam_arcs, cam_profiles
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
    match given.law:
        case Phases():
            s = _phases(given.law, theta, float(rough))
        case ArcLaw():
            s = cam_arcs.displacement(given.law, theta, float(rough))
        case _:
            s = spline_at(given.law.spline, theta)
    sign = given.side * given.sense
    return Three(exact(given.low) + given.side * s.z, sign * s.d, given.side * s.dd)


def _phases(law: Phases, theta: Number, rough: float) -> Three:
    """S with its derivatives; an angle within `EDGE` of the end of a phase belongs to the next."""
    own = context()
    near = float(np.mod(rough + EDGE, FULL_TURN) - EDGE)
    theta = theta - 2 * own.pi * own.nint((theta - near) / (2 * own.pi))
    k = int(np.clip(np.searchsorted(law.edges - EDGE, near, side="right") - 1, 0, len(law.phases) - 1))
    phase = law.phases[k]
    if phase.law is None:
        return Three(exact(law.level(k)), own.mpf(0), own.mpf(0))
    angle, h = exact(phase.angle), exact(law.lift)
    t = (theta - exact(law.edges[k])) / angle
    f = _shape(phase.law, t, float((near - law.edges[k]) / phase.angle))
    way = 1 if phase.kind == "rise" else -1
    return Three((0 if way > 0 else h) + way * h * f.z, way * h * f.d / angle, way * h * f.dd / angle**2)


def _shape(shape: Shape, t: Number, near: float) -> Three:
    """f, f', f'' of the shapes of `shapes.py`; `near`: t in doubles, by which its piece is known."""
    own = context()
    pi = own.pi
    match shape:
        case Parabolic():
            n, left = exact(shape.ratio), 1 - t
            if near < shape.switch - SHARE:
                return Three((1 + n) * t * t, 2 * (1 + n) * t, 2 * (1 + n))
            down = 1 + 1 / n
            return Three(1 - down * left**2, 2 * down * left, -2 * down)
        case Graph():
            return _graph(shape, t, shape.piece_at(near))
    match shape.name:
        case "cosine":
            c, s = own.cos(pi * t), own.sin(pi * t)
            return Three((1 - c) / 2, pi * s / 2, pi**2 * c / 2)
        case "sine":
            c, s = own.cos(2 * pi * t), own.sin(2 * pi * t)
            return Three(t - s / (2 * pi), 1 - c, 2 * pi * s)
    rows = [list(POWERS[shape.name])]
    for _ in range(2):
        rows.append([k * c for k, c in enumerate(rows[-1])][1:])
    return Three(*(sum((c * t**k for k, c in enumerate(row)), own.mpf(0)) for row in rows))


def _graph(graph: Graph, t: Number, number: int) -> Three:
    """A graph of acceleration, from its pieces as they are stated: areas and moments of areas."""
    own = context()
    pieces = [(exact(p.width), exact(p.start), exact(p.end), p.form) for p in graph.pieces]
    whole = sum(width for width, *_ in pieces)
    pieces = [(width / whole, a, b, form) for width, a, b, form in pieces]
    if graph.begin is None:
        areas = [_swept(p, p[0])[1] for p in pieces]
        above, below = (sum(way * x for x in areas if way * x > 0) for way in (1, -1))
        pieces = [
            (w, a, b, form) if x > 0 else (w, a * above / below, b * above / below, form)
            for (w, a, b, form), x in zip(pieces, areas, strict=True)
        ]

    def over(until: Number, last: int) -> Three:
        """Displacement, velocity and acceleration from the beginning on, to a share in piece `last`."""
        s, v, a, at = own.mpf(0), exact(graph.begin or 0.0), own.mpf(0), own.mpf(0)
        for k, piece in enumerate(pieces[: last + 1]):
            x = until - at if k == last else piece[0]
            moved, gained, a = _swept(piece, x)
            s, v, at = s + v * x + moved, v + gained, at + piece[0]
        return Three(s, v, a)

    lift = over(own.mpf(1), len(pieces) - 1).z
    here = over(t, number)
    return Three(here.z / lift, here.d / lift, here.dd / lift)


def _swept(piece: tuple[Number, Number, Number, str], x: Number) -> tuple[Number, Number, Number]:
    """Of a piece over x of it from rest: displacement, velocity, acceleration."""
    own, (width, a, b, form) = context(), piece
    if form == "line":
        bend = (b - a) / width
        return a * x * x / 2 + bend * x**3 / 6, a * x + bend * x * x / 2, a + bend * x
    k = own.pi / 2 / width
    # a wave of cosines from its level end: ψ counts from there
    level, other, psi0 = (b, a, -own.pi / 2) if abs(b) > abs(a) else (a, b, own.mpf(0))
    size = level - other

    def wave(at: Number) -> tuple[Number, Number]:
        return size * own.sin(psi0 + k * at) / k, -size * own.cos(psi0 + k * at) / k**2

    (v0, s0), (v1, s1) = wave(own.mpf(0)), wave(x)
    return other * x * x / 2 + s1 - s0 - v0 * x, other * x + v1 - v0, other + size * own.cos(psi0 + k * x)


POWERS = {
    "uniform": (0, 1),
    "decreasing": (0, 0, 3, -2),
    "polynomial": (0, 0, 0, 10, -15, 6),
    "polynomial_4567": (0, 0, 0, 0, 35, -84, 70, -20),
}
