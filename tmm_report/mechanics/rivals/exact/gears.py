"""Gears in exact numbers: the involute function and its inverse, an external pair in mesh, speeds of a train.

Sources: Artobolevsky, Theory of mechanisms and machines, ch. 22 (pairs), ch. 7 (Willis); GOST 16532.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmm_report.mechanics.gears.trains import FRAME, Member, Mesh
from tmm_report.mechanics.rivals.exact.numbers import DIGITS, GUARD, Number, context, exact, solve
from tmm_report.records import dataclass

STEPS = 60  # of Newton's method


def inv(alpha: Any) -> Number:
    """tan α − α to 40 digits; α in rad, |α| < π/2."""
    own = context()
    with own.workdps(3 * (DIGITS + GUARD)):  # at small angles nearly all digits are lost in the difference
        angle = exact(alpha)
        return own.tan(angle) - angle


def inverse(v: Any) -> Number:
    """α with tan α − α = v, rad, to 40 digits: Newton's method from above the root, where the curve is convex."""
    own = context()
    with own.workdps(3 * (DIGITS + GUARD)):
        goal = exact(v)
        if goal == 0:
            return own.mpf(0)
        size = abs(goal)
        alpha = min(own.cbrt(3 * size), own.atan(size + own.pi / 2))
        for _ in range(STEPS):
            t = own.tan(alpha)
            step = (t - alpha - size) / (t * t)
            alpha -= step
            if abs(step) <= abs(alpha) * own.mpf(10) ** -(DIGITS + GUARD):
                break
        return own.sign(goal) * alpha


@dataclass(frozen=True)
class External:
    """An external pair of wheels cut by a rack, at a centre distance without backlash: what is stated of it.

    `z`: teeth; `m`: normal module, m; `alpha`: of the rack, rad; `beta`: helix angle, rad; `a_w`: m; `x1`: shift
    coefficient of wheel 1; `shortened`: tips cut down to keep the clearance."""

    z: tuple[int, int]
    m: float
    alpha: float
    ha: float
    c: float
    beta: float
    a_w: float
    x1: float
    shortened: bool = True


def pair(of: External) -> dict[str, Number | tuple[Number, Number]]:
    """Numbers of the pair, and of its wheels by twos; lengths in m, angles in rad.

    The contact is taken between the tip circles: the involutes must reach so far."""
    own = context()
    m, a_w, beta, teeth = exact(of.m), exact(of.a_w), exact(of.beta), of.z[0] + of.z[1]
    m_t, alpha_t = m / own.cos(beta), own.atan(own.tan(exact(of.alpha)) / own.cos(beta))
    a = m_t * teeth / 2
    alpha_w = own.acos(a * own.cos(alpha_t) / a_w)
    inv_alpha, inv_alpha_w = inv(alpha_t), inv(alpha_w)
    x_sum = teeth * (inv_alpha_w - inv_alpha) / (2 * own.tan(alpha_t) * own.cos(beta))
    x = exact(of.x1), x_sum - exact(of.x1)
    y = (a_w - a) / m
    shortening = max(x_sum - y, own.mpf(0)) if of.shortened else own.mpf(0)
    p, line = own.pi * m_t, a_w * own.sin(alpha_w)
    p_b = p * own.cos(alpha_t)
    d = [m_t * z for z in of.z]
    d_a = [d[i] + 2 * m * (exact(of.ha) + x[i] - shortening) for i in (0, 1)]
    d_b = [d[i] * own.cos(alpha_t) for i in (0, 1)]
    s = [p / 2 + 2 * x[i] * m * own.tan(alpha_t) for i in (0, 1)]
    alpha_a = [own.acos(d_b[i] / d_a[i]) for i in (0, 1)]
    rho_a = [own.sqrt(d_a[i] ** 2 - d_b[i] ** 2) / 2 for i in (0, 1)]
    rho_p = [line - rho_a[1], line - rho_a[0]]
    active = rho_a[0] + rho_a[1] - line
    turns = [own.mpf(of.z[i]) / of.z[1 - i] for i in (0, 1)]
    of_wheels = {
        "x": x,
        "d": d,
        "d_b": d_b,
        "d_a": d_a,
        "d_f": [d[i] - 2 * m * (exact(of.ha) + exact(of.c) - x[i]) for i in (0, 1)],
        "d_w": [2 * a_w * z / teeth for z in of.z],
        "s": s,
        "s_a": [d_a[i] * (s[i] / d[i] + inv_alpha - inv(alpha_a[i])) for i in (0, 1)],
        "alpha_a": alpha_a,
        "rho_a": rho_a,
        "rho_p": rho_p,
        "root_sliding": [1 - (line - rho_p[i]) * turns[i] / rho_p[i] for i in (0, 1)],
        "tip_sliding": [1 - (line - rho_a[i]) * turns[i] / rho_a[i] for i in (0, 1)],
    }
    return {
        "ratio": -own.mpf(of.z[1]) / of.z[0],
        "a": a,
        "a_w": a_w,
        "alpha_w": alpha_w,
        "x_sum": x_sum,
        "y": y,
        "shortening": shortening,
        "p": p,
        "p_b": p_b,
        "p_w": p_b / own.cos(alpha_w),
        "line": line,
        "active": active,
        "eps": active / p_b,
        "m_t": m_t,
        "alpha_t": alpha_t,
        "inv_alpha": inv_alpha,
        "inv_alpha_w": inv_alpha_w,
        "two_length": active - p_b,
        **{key: (both[0], both[1]) for key, both in of_wheels.items()},
    }


def belt(one: float, other: float, distance: float, crossed: bool) -> dict[str, Number]:
    """Angle of a strand with the line of centres, angles of wrap, rad, and length of a belt, m, by the outline: the
    strand is a leg of a triangle with the distance and the sum or the difference of the radii."""
    own = context()
    d1, d2, a = exact(one), exact(other), exact(distance)
    reach = (d2 + d1) / 2 if crossed else (d2 - d1) / 2
    strand = own.sqrt(a * a - reach * reach)
    theta = own.atan2(reach, strand)
    first, second = own.pi + (2 * theta if crossed else -2 * theta), own.pi + 2 * theta
    length = 2 * strand + (first * d1 + second * d2) / 2
    return {"theta": theta, "alpha1": first, "alpha2": second, "L": length}


def chain(z: tuple[int, int], pitch: float, links: int) -> dict[str, Number]:
    """Pitch diameters by the polygons, length, m, and the distance of the centres as the greater root of
    2 a² − (W − (z1 + z2)/2) p a + ((z2 − z1)/2π)² p² = 0."""
    own = context()
    p = exact(pitch)
    middle = links - own.mpf(z[0] + z[1]) / 2
    bent = ((z[1] - z[0]) / (2 * own.pi)) ** 2
    a = p * (middle + own.sqrt(middle**2 - 8 * bent)) / 4
    d1, d2 = (p / own.sin(own.pi / one) for one in z)
    return {"d1": d1, "d2": d2, "a": a, "L": links * p}


def speeds(members: Sequence[Member], meshes: Sequence[Mesh], given: Mapping[str, Any]) -> dict[str, Number]:
    """Angular velocities of all members by Willis' equations, (ω_i − ω_H) z_i = ∓(ω_j − ω_H) z_j, for stated ones."""
    by_name = {member.name: member for member in members}
    bodies = list(dict.fromkeys(member.body for member in members))
    own = context()
    rows: list[dict[int, Number]] = []
    right: list[Number] = []

    def add(row: dict[int, Number], name: str, factor: Number) -> None:
        if name != FRAME:
            column = bodies.index(by_name[name].body)
            row[column] = row.get(column, own.mpf(0)) + factor

    for mesh in meshes:
        row: dict[int, Number] = {}
        first = own.mpf(1) if mesh.size else own.mpf(by_name[mesh.i].teeth)
        second = exact(mesh.size) if mesh.size else own.mpf(by_name[mesh.j].teeth)
        second *= -1 if mesh.internal else 1
        add(row, mesh.i, first)
        add(row, mesh.j, second)
        add(row, mesh.carrier, -first - second)
        rows.append(row)
        right.append(own.mpf(0))
    for name, value in given.items():
        rows.append({bodies.index(by_name[name].body): own.mpf(1)})
        right.append(exact(value))
    found = solve(rows, right)
    assert found is not None
    return {name: found[bodies.index(member.body)] for name, member in by_name.items()}
