"""Followers of cams stated by their profiles, in exact numbers: the contact by Newton's method, the rates by K.

The start is the contact found in doubles. Source: Levitsky, Cam mechanisms, ch. 3.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from tmm_report.mechanics.cams.cam import Cam, Sliding
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Spline
from tmm_report.mechanics.cams.stated_profile import LAID, ByProfile, Circle
from tmm_report.mechanics.rivals.exact.numbers import (
    Number,
    Three,
    context,
    cross,
    dot,
    eliminated,
    exact,
    point,
    unit,
)

STEPS = 60  # of Newton's method


def coordinate(cam: Cam, phi: Number) -> Three:
    """q with its derivatives by the driving link's angle, rad; nan where cam and follower do not meet."""
    given = cam.given
    assert isinstance(given, ByProfile)
    return _under_face(cam, given, phi) if given.roller is None else _under_roller(cam, given, phi)


def _under_roller(cam: Cam, given: ByProfile, phi: Number) -> Three:
    own, turned = context(), context().expj(phi)
    rough = float(given._met(np.array([float(phi)]))[0])
    if np.isnan(rough):
        return Three(own.nan, own.nan, own.nan)
    u, motion = own.mpf(rough), cam.motion
    for _ in range(STEPS):
        z, rate = (x * turned for x in _pitch(given, u)[:2])
        if isinstance(motion, Sliding):
            along = unit(motion.along)
            gap, slope = cross(along, z - point(motion.foot)), cross(along, rate)
        else:
            arm = z - point(motion.pivot)
            gap, slope = abs(arm) - abs(point(motion.arm)), dot(arm, rate) / abs(arm)
        u -= gap / slope
        if abs(gap / slope) <= own.eps * 100:
            break
    z, _, K = (x * turned for x in _pitch(given, u))
    w = z - K
    if isinstance(motion, Sliding):
        along = unit(motion.along)
        q, way, bend = dot(along, z - point(motion.foot)), along, own.mpc(0)
    else:
        towards = own.arg(-point(motion.pivot))
        arm = z - point(motion.pivot)
        q = towards + own.arg(arm * own.expj(-towards))
        way, bend = 1j * arm, -arm
    # iK + iω w = q' B_q and −K + (iε − ω²) w = q'' B_q + q'² B_qq, along the normal w
    across = dot(way, w)
    d = dot(1j * K, w) / across
    spin = dot(d * way - 1j * K, 1j * w) / abs(w) ** 2 if w else own.mpf(0)
    return Three(q, d, dot(-K - spin**2 * w - d**2 * bend, w) / across)


def _under_face(cam: Cam, given: ByProfile, phi: Number) -> Three:
    """A flat face that slides rests on the farthest point of the profile: h = max n·p, h' = n·iK, h'' = −n·K."""
    own, motion = context(), cam.motion
    assert isinstance(motion, Sliding)
    n = 1j * unit(given.face) * unit(motion.turn)
    n = n if dot(n, unit(motion.along)) > 0 else -n
    back = n * own.expj(-phi)
    laid = np.arange(LAID) * FULL_TURN / LAID
    u = own.mpf(float(laid[np.argmax((complex(back).conjugate() * given.curve.of(laid).z).real)]))
    for _ in range(STEPS):
        _, d, dd = _curve(given, u)
        step = dot(back, d) / dot(back, dd)
        u -= max(min(step, own.mpf("0.05")), -own.mpf("0.05"))
        if abs(step) <= own.eps * 100:
            break
    p, d, dd = _curve(given, u)
    K = p + 1j * d * abs(d) ** 2 / cross(d, dd)
    slant = dot(n, unit(motion.along))
    h = dot(back, p) - dot(n, point(motion.foot))
    return Three(h / slant, dot(back, 1j * K) / slant, -dot(back, K) / slant)


def _pitch(given: ByProfile, u: Number) -> tuple[Number, Number, Number]:
    """Of the cam's own axes: the roller's centre, its derivative by u, the profile's centre of curvature."""
    p, d, dd = _curve(given, u)
    speed = abs(d)
    bent, r = cross(d, dd) / speed**3, exact(given.roller or 0.0)
    return p - 1j * r * d / speed, d * (1 + r * bent), p + 1j * d / (speed * bent)


def _curve(given: ByProfile, u: Number) -> Three:
    """A point of the profile and its derivatives by its parameter, rad."""
    own = context()
    turn = own.expj(u)
    if isinstance(given.curve, Circle):
        arm = exact(given.curve.radius) * turn
        return Three(point(given.curve.centre) + arm, 1j * arm, -arm)
    r, d, dd = spline_at(given.curve.spline, u)
    return Three(r * turn, (d + 1j * r) * turn, (dd + 2j * d - r) * turn)


# ---------------------------------------------------------------- splines


@cache
def _bends(spline: Spline, digits: int) -> tuple[Number, ...]:
    """Second derivatives of the periodic cubic spline at its knots, to so many digits."""
    x, y = [exact(v) for v in spline.x], [exact(v) for v in spline.values]
    n = len(x) - 1
    h = [x[k + 1] - x[k] for k in range(n)]
    rise = [(y[k + 1] - y[k]) / h[k] for k in range(n)]
    rows: list[dict[int, Number]] = [{} for _ in range(n)]
    for k in range(n):
        for column, value in ((k, 2 * (h[k - 1] + h[k])), ((k - 1) % n, h[k - 1]), ((k + 1) % n, h[k])):
            rows[k][column] = rows[k].get(column, 0) + value
    found = eliminated(rows, [6 * (rise[k] - rise[k - 1]) for k in range(n)])
    assert found is not None
    return (*found, found[0])


def spline_at(spline: Spline, at: Number) -> Three:
    """The periodic cubic spline and its first two derivatives."""
    own = context()
    x, y, bends = spline.x, spline.values, _bends(spline, own.dps)
    period = exact(x[-1]) - exact(x[0])
    at = at - period * own.floor((at - exact(x[0])) / period)
    k = int(np.clip(np.searchsorted(x, float(at), side="right") - 1, 0, len(x) - 2))
    h = exact(x[k + 1]) - exact(x[k])
    b = (at - exact(x[k])) / h
    a, low, high, first, last = 1 - b, bends[k], bends[k + 1], exact(y[k]), exact(y[k + 1])
    return Three(
        a * first + b * last + ((a**3 - a) * low + (b**3 - b) * high) * h * h / 6,
        (last - first) / h + ((3 * b * b - 1) * high - (3 * a * a - 1) * low) * h / 6,
        a * low + b * high,
    )
