"""Contours of the dyads with a turning link: three pivots, a rod and a slider, a rocking guide."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.initial_data.quantities import length
from tmm_report.chapters.lever.kinematics.contours.equations import (
    AT_JOINT,
    FROM_GUIDE,
    GUIDE_TURNED,
    OFFSET,
    Equations,
    System,
    Written,
    arg,
    bearing,
    differentiated,
    inner_point,
    inner_rates,
    on_guide,
    outer_line,
    projected,
    quantity,
    slid,
    sliding,
    turned_acceleration,
    turned_velocity,
    turning,
    vectors,
)
from tmm_report.chapters.lever.kinematics.contours.known import Pose
from tmm_report.chapters.lever.kinematics.contours.nodes import Bearing, Branched, times, total
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.quantity.formula import arccos, cos, sin, sqrt
from tmm_report.quantity.functions import Degrees
from tmm_report.quantity.symbols import Symbol

Array = Any

# ---------------------------------------------------------------- kind 1: three pivots


def rrr(bench: Bench, d: Dyad) -> Written:
    """Two links pivoted to each other: the triangle of the joints by the theorem of cosines."""
    A, C = bench.spot(d.outer_a.name), bench.spot(d.outer_b.name)
    inner = d.inner.name
    one, other = A.name + inner, C.name + inner
    l1 = bench.length(A.name, inner, abs(d.arm_a))
    l2 = bench.length(C.name, inner, abs(d.arm_b))
    distance = length(A.name + C.name)
    dx, dy = total([(1, C.x), (-1, A.x)]), total([(1, C.y), (-1, A.y)])
    l0 = bench.own(distance, sqrt(dx**2 + dy**2))
    phi0 = bench.own(bearing(A.name + C.name), Bearing(dy, dx))
    corner = quantity(f"alpha_{d.group.label}", Symbol("alpha", A.name), "deg", AT_JOINT, of=A.name)
    alpha = bench.own(corner, arccos((l1**2 + l0**2 - l2**2) / (2 * l1 * l0)))
    phi1 = bench.own(bearing(one), Branched(phi0, alpha, d.root(bench.motion.phi)))
    B = inner_point(bench, inner, (A.x + l1 * cos(phi1), A.y + l1 * sin(phi1)))
    phi2 = bench.own(bearing(other), Bearing(B.y - C.y, B.x - C.x))
    positions = bench.taken()
    u, w = turning(bench, d.a), turning(bench, d.b)
    av, cv = A.v or (None, None), C.v or (None, None)
    eq = Equations(
        (A.x + l1 * cos(phi1), A.y + l1 * sin(phi1)), (C.x + l2 * cos(phi2), C.y + l2 * sin(phi2)),
        (-(l1 * sin(phi1)), l1 * cos(phi1)), (l2 * sin(phi2), -(l2 * cos(phi2))),
        (total([(1, cv[0]), (-1, av[0])]), total([(1, cv[1]), (-1, av[1])])),
    )  # fmt: skip
    system = System(bench, d, u, w, eq)
    w1, w2 = system.velocities
    inner_rates(bench, "v", inner, turned_velocity(A, l1, phi1, w1))
    velocities = bench.taken()
    aa, ca = A.a or (None, None), C.a or (None, None)
    known = (
        total([(1, ca[0]), (-1, aa[0]), (1, l1 * w1**2 * cos(phi1)), (-1, l2 * w2**2 * cos(phi2))]),
        total([(1, ca[1]), (-1, aa[1]), (1, l1 * w1**2 * sin(phi1)), (-1, l2 * w2**2 * sin(phi2))]),
    )
    e1, e2 = system.accelerations(known)
    inner_rates(bench, "a", inner, turned_acceleration(A, l1, phi1, w1, e1))
    bench.poses[d.a] = Pose(A, d.outer_a.at[d.a], phi1, arg(d.arm_a), w1, e1)
    bench.poses[d.b] = Pose(C, d.outer_b.at[d.b], phi2, arg(d.arm_b), w2, e2)
    lines = vectors([f"r_{A.name}", f"l_{one}"], [Symbol("r", C.name), Symbol("l", other)])
    return Written(
        d.group, lines, projected(bench, eq.left, eq.right), positions,
        differentiated(bench, u, w, eq), velocities, bench.taken(), [],
    )  # fmt: skip


# ---------------------------------------------------------------- kind 2: a rod and a slider


def rrp(bench: Bench, d: Dyad) -> Written:
    """A rod whose end slides along a line: in the axes of the guide its projection is a root of l² − h²."""
    A, inner, guide = bench.spot(d.outer_a.name), d.inner.name, d.outer_b.name
    line = outer_line(bench, guide, d.carrier_b, d.outer_b, d.b, d.arm_b)
    G, beta, rod = line.at, line.beta, A.name + inner
    l = bench.length(A.name, inner, abs(d.arm_a))
    dx, dy = total([(1, A.x), (-1, G.x)]), total([(1, A.y), (-1, G.y)])
    letter = Symbol("h", A.name)  # a second rod from the joint, to another guide, has a letter of its own
    if any(one.symbol == letter for one, _ in bench.columns.values()):
        letter = Symbol("h", rod)
    of = quantity(f"h_{rod}", letter, "m", FROM_GUIDE, of=A.name, guide=guide)
    h = bench.own(of, dy * cos(beta) - dx * sin(beta))
    root = sqrt(l**2 - h**2)
    foot = dx * cos(beta) + dy * sin(beta)
    s = bench.own(slid(d.b, guide, G.name), Branched(foot, root, d.root(bench.motion.phi)))
    B = inner_point(bench, inner, (line.place(s, 0), line.place(s, 1)))
    phi = bench.own(bearing(rod), Bearing(B.y - A.y, B.x - A.x))
    positions = bench.taken()
    u, w = turning(bench, d.a), sliding(d.b, guide)
    v = A.v or (None, None)
    eq = Equations(
        (A.x + l * cos(phi), A.y + l * sin(phi)), (line.place(s, 0), line.place(s, 1)),
        (-(l * sin(phi)), l * cos(phi)), (-cos(beta), -sin(beta)),
        (total([*line.carried(s, 0), (-1, v[0])]), total([*line.carried(s, 1), (-1, v[1])])),
    )  # fmt: skip
    system = System(bench, d, u, w, eq)
    w1, rate = system.velocities
    way = (cos(beta), sin(beta))
    inner_rates(bench, "v", inner, [[*line.carried(s, n), (1, rate * way[n])] for n in (0, 1)])
    velocities, a = bench.taken(), A.a or (None, None)
    known = (
        total([*line.bent(s, rate, 0), (-1, a[0]), (1, l * w1**2 * cos(phi))]),
        total([*line.bent(s, rate, 1), (-1, a[1]), (1, l * w1**2 * sin(phi))]),
    )
    e1, bend = system.accelerations(known)
    inner_rates(bench, "a", inner, [[*line.bent(s, rate, n), (1, bend * way[n])] for n in (0, 1)])
    bench.poses[d.a] = Pose(A, d.outer_a.at[d.a], phi, arg(d.arm_a), w1, e1)
    bench.poses[d.b] = on_guide(bench.spot(inner), d.inner.at[d.b], d.outer_b.along[d.b], line)
    lines = vectors([f"r_{A.name}", f"l_{rod}"], [Symbol("r", G.name), Symbol("s", d.b)])
    return Written(
        d.group, lines, projected(bench, eq.left, eq.right), positions,
        differentiated(bench, u, w, eq), velocities, bench.taken(), [],
    )  # fmt: skip


# ---------------------------------------------------------------- kind 3: a rocking guide


def rpr(bench: Bench, d: Dyad) -> Written:
    """A guide that passes a pivot at a constant distance from another: a right-angled triangle."""
    A, C, guide = bench.spot(d.outer_a.name), bench.spot(d.outer_b.name), d.inner.name
    ends = A.name + C.name
    offset = float(cross(d.inner.along[d.a], d.arm_a) - cross(d.inner.along[d.b], d.arm_b))
    size = abs(d.arm_a) + abs(d.arm_b) + float(np.nanmax(np.abs(bench.motion.place(C.name))))
    of = quantity(f"h_{guide}", Symbol("h", guide), "m", OFFSET, of=C.name, guide=guide, other=A.name)
    h = bench.constant(of, offset) if abs(offset) > 1e-12 * size else None
    dx, dy = total([(1, C.x), (-1, A.x)]), total([(1, C.y), (-1, A.y)])
    distance = length(ends)
    l0 = bench.own(distance, sqrt(dx**2 + dy**2))
    phi0 = bench.own(bearing(ends), Bearing(dy, dx))
    sign = d.root(bench.motion.phi)
    root = l0 if h is None else sqrt(l0**2 - h**2)
    s = bench.own(slid(d.b, guide, A.name), Branched(None, root, sign))
    direction = quantity(f"beta_{guide}", Symbol("beta", guide), "deg", GUIDE_TURNED, of=guide)
    turned = (
        phi0 - Bearing(h, s) if h is not None else Branched(phi0, Degrees(np.pi), np.where(sign > 0, 0, 1))
    )
    if h is None and np.all(sign > 0):
        turned = phi0
    beta = bench.own(direction, turned)
    positions = bench.taken()
    u, w = turning(bench, d.a), sliding(d.b, guide)
    t, n = (cos(beta), sin(beta)), (times(h, sin(beta)), times(h, cos(beta)))
    av, cv = A.v or (None, None), C.v or (None, None)
    eq = Equations(
        (total([(1, A.x), (1, s * t[0]), (-1, n[0])]), total([(1, A.y), (1, s * t[1]), (1, n[1])])), (C.x, C.y),
        (total([(-1, s * t[1]), (-1, n[1])]), total([(1, s * t[0]), (-1, n[0])])), t,
        (total([(1, cv[0]), (-1, av[0])]), total([(1, cv[1]), (-1, av[1])])),
    )  # fmt: skip
    system = System(bench, d, u, w, eq)
    w1, rate = system.velocities
    velocities = bench.taken()
    aa, ca = A.a or (None, None), C.a or (None, None)
    square = w1**2
    known = (
        total([
            (1, ca[0]), (-1, aa[0]), (1, 2 * rate * w1 * t[1]), (1, s * square * t[0]),
            (-1, times(h, square, t[1])),
        ]),
        total([
            (1, ca[1]), (-1, aa[1]), (-1, 2 * rate * w1 * t[0]), (1, s * square * t[1]),
            (1, times(h, square, t[0])),
        ]),
    )  # fmt: skip
    e1, _ = system.accelerations(known)
    bench.poses[d.a] = Pose(A, d.outer_a.at[d.a], beta, arg(d.inner.along[d.a]), w1, e1)
    bench.poses[d.b] = Pose(C, d.outer_b.at[d.b], beta, arg(d.inner.along[d.b]), w1, e1)
    left: list[str | Symbol] = [f"r_{A.name}", *([] if h is None else [Symbol("h", guide)]), Symbol("s", d.b)]
    return Written(
        d.group, vectors(left, [Symbol("r", C.name)]),
        projected(bench, eq.left, eq.right), positions,
        differentiated(bench, u, w, eq), velocities, bench.taken(), [],
    )  # fmt: skip
