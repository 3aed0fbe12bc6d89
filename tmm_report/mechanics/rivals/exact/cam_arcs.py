"""Followers on cams of arcs, in exact numbers: where circle or line, turned by the cam, holds them; the rates by the
condition of contact, differentiated twice.

From the cam's centre, the cam counter-clockwise: see `mechanics/cams/arcs.py`, of which this takes the sizes alone.
"""

from __future__ import annotations

import numpy as np

from tmm_report.mechanics.cams.arcs import EDGE, FULL_TURN, ArcLaw, Outline, Rocker, Slider
from tmm_report.mechanics.rivals.exact.numbers import Number, Three, context, dot, exact


def displacement(law: ArcLaw, theta: Number, rough: float) -> Three:
    """S with its derivatives; `rough`: the angle in doubles, by which its piece is known."""
    own = context()
    near = float(np.mod(rough + EDGE, FULL_TURN) - EDGE)
    piece = int(np.clip(np.searchsorted(law.edges - EDGE, near, side="right") - 1, 0, 3))
    if piece == 3:
        return Three(own.mpf(0), own.mpf(0), own.mpf(0))
    one, side = law.outline, 1 - piece
    turn = own.expj(theta + _begins(law))
    base, half = exact(one.base), side * _half_angle(one)
    if piece == 1:
        q = _coordinate(law.follower, Three(*_turned(exact(one.distance), turn)), exact(one.nose), False)
    elif one.straight:
        q = _coordinate(law.follower, Three(*_turned(own.expj(half), turn)), base, True)
    else:
        away = exact(one.flank) - base
        q = _coordinate(law.follower, Three(*_turned(-away * own.expj(half), turn)), exact(one.flank), False)
    low = _lowest(law)
    if isinstance(law.follower, Slider):
        return Three(q.z - low, q.d, q.dd)
    sign, S = law.follower.side, q.z - low
    S -= 2 * own.pi * own.nint(S / (2 * own.pi))
    return Three(sign * S, sign * q.d, sign * q.dd)


def _turned(z: Number, turn: Number) -> tuple[Number, Number, Number]:
    at = z * turn
    return at, 1j * at, -at


def _half_angle(one: Outline) -> Number:
    own, base, nose, r = context(), exact(one.base), exact(one.nose), exact(one.distance)
    if one.straight:
        return own.acos((base - nose) / r)
    R = exact(one.flank)
    return own.acos(((R - nose) ** 2 - (R - base) ** 2 - r**2) / (2 * (R - base) * r))


def _lowest(law: ArcLaw) -> Number:
    """The follower's coordinate on the base circle, an arc about the axis."""
    own = context()
    still = Three(own.mpc(0), own.mpc(0), own.mpc(0))
    return _coordinate(law.follower, still, exact(law.outline.base), False).z


def _begins(law: ArcLaw) -> Number:
    """The angle of the cam's axis where the rise begins: the follower touches the base circle at α from it."""
    own, one = context(), law.follower
    q = _lowest(law)
    if one.roller is None:
        touches = own.pi / 2 if isinstance(one, Slider) else q
    else:
        place = (
            exact(one.offset) + 1j * q
            if isinstance(one, Slider)
            else _pivot(one) + exact(one.arm) * own.expj(q)
        )
        touches = own.arg(place)
    return touches - _half_angle(law.outline)


def _pivot(one: Rocker) -> Number:
    return context().mpc(-one.side * exact(one.apart))


def _coordinate(one: Slider | Rocker, c: Three, size: Number, line: bool) -> Three:
    """Over an arc of the radius `size` about c, or a `line` of the normal c so far from the axis: the condition of
    contact f(q, angle) = 0 has q' = −f_a/f_q and q'' = −(f_aa + 2f_aq q' + f_qq q'²)/f_q."""
    own = context()
    if one.roller is None:
        if isinstance(one, Slider):
            return Three(c.z.imag + size, c.d.imag, c.dd.imag)
        w, short = c.z - _pivot(one), exact(one.arm) - size
        q = own.arg(w) + one.side * own.acos(short / abs(w))
        n = own.expj(q)  # dot(n, c − pivot) = b − ρ
        parts = dot(n, c.d), dot(n, c.dd), dot(1j * n, w), dot(1j * n, c.d), dot(-n, w)
        return _implicit(q, *parts)
    far = size + exact(one.roller)
    if isinstance(one, Slider):
        e = exact(one.offset)
        if line:
            q = (far - e * c.z.real) / c.z.imag
            b = own.mpc(e, q)
            return _implicit(q, dot(c.d, b), dot(c.dd, b), c.z.imag, c.d.imag, own.mpf(0))
        x = c.z.real - e
        q = c.z.imag + own.sqrt(far**2 - x**2)
        b, way, bend = own.mpc(e, q), own.mpc(0, 1), own.mpc(0)
    else:
        pivot, arm = _pivot(one), exact(one.arm)
        if line:
            q = own.arg(c.z) - one.side * own.acos((far - dot(c.z, pivot)) / arm)
            v = arm * own.expj(q)
            b = pivot + v
            return _implicit(q, dot(c.d, b), dot(c.dd, b), dot(c.z, 1j * v), dot(c.d, 1j * v), dot(c.z, -v))
        w = c.z - pivot
        q = own.arg(w) + one.side * own.acos((abs(w) ** 2 + arm**2 - far**2) / (2 * abs(w) * arm))
        v = arm * own.expj(q)
        b, way, bend = pivot + v, 1j * v, -v
    u = b - c.z  # |u|² = (ρ + r)²
    return _implicit(
        q,
        -dot(u, c.d),
        dot(c.d, c.d) - dot(u, c.dd),
        dot(u, way),
        -dot(c.d, way),
        dot(way, way) + dot(u, bend),
    )


def _implicit(q: Number, a: Number, aa: Number, by_q: Number, aq: Number, qq: Number) -> Three:
    d = -a / by_q
    return Three(q, d, -(aa + 2 * aq * d + qq * d * d) / by_q)
