"""Contours of the dyads of two guides, whose links turn with known ones: the crossing of two lines."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.contours.equations import (
    Equations,
    System,
    Two,
    Written,
    arg,
    differentiated,
    inner_point,
    inner_rates,
    on_guide,
    outer_line,
    projected,
    slid,
    sliding,
    vectors,
)
from tmm_report.chapters.lever.kinematics.contours.known import Line, Pose, Spot
from tmm_report.chapters.lever.kinematics.contours.nodes import total
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.quantity.formula import Expr, Var, cos, sin
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol

Array = Any

# ---------------------------------------------------------------- kinds 4 and 5: two guides


def prp(bench: Bench, d: Dyad) -> Written:
    """A pivot of two sliders: the crossing of the lines on which they bring it."""
    inner = d.inner.name
    one = outer_line(bench, d.outer_a.name, d.carrier_a, d.outer_a, d.a, d.arm_a)
    other = outer_line(bench, d.outer_b.name, d.carrier_b, d.outer_b, d.b, d.arm_b)
    of = (slid(d.a, one.guide, one.at.name), slid(d.b, other.guide, other.at.name))
    lead = bench.taken()
    by = ((cos(one.beta), sin(one.beta)), (-cos(other.beta), -sin(other.beta)))
    gap = (
        total([(1, other.at.x), (-1, one.at.x)]),
        total([(1, other.at.y), (-1, one.at.y)]),
    )
    s1, s2 = _crossing(bench, of, by, gap)
    B = inner_point(bench, inner, (one.place(s1, 0), one.place(s1, 1)))
    positions = [*lead, *bench.taken()]
    u, w = sliding(d.a, one.guide), sliding(d.b, other.guide)
    eq = Equations(
        (one.place(s1, 0), one.place(s1, 1)), (other.place(s2, 0), other.place(s2, 1)), *by,
        (_carried(one, other, s1, s2, 0), _carried(one, other, s1, s2, 1)),
    )  # fmt: skip
    system = System(bench, d, u, w, eq)
    v1, v2 = system.velocities
    inner_rates(bench, "v", inner, [[*one.carried(s1, n), (1, v1 * by[0][n])] for n in (0, 1)])
    velocities = bench.taken()
    known = [
        total([*other.bent(s2, v2, n), *((-sign, term) for sign, term in one.bent(s1, v1, n))])
        for n in (0, 1)
    ]
    a1, _ = system.accelerations((known[0], known[1]))
    inner_rates(bench, "a", inner, [[*one.bent(s1, v1, n), (1, a1 * by[0][n])] for n in (0, 1)])
    for link, line, pair in ((d.a, one, d.outer_a), (d.b, other, d.outer_b)):
        bench.poses[link] = on_guide(B, d.inner.at[link], pair.along[link], line)
    lines = vectors([f"r_{one.at.name}", f"s_{d.a}"], [Symbol("r", other.at.name), Symbol("s", d.b)])
    return Written(
        d.group, lines, projected(bench, eq.left, eq.right), positions,
        differentiated(bench, u, w, eq), velocities, bench.taken(), [],
    )  # fmt: skip


def _crossing(bench: Bench, of: tuple[Quantity, Quantity], by: tuple[Two, Two], gap: Two) -> tuple[Var, Var]:
    """u·by[0] + w·by[1] = gap by determinants."""
    (k11, k21), (k12, k22) = by
    det = k11 * k22 - k12 * k21
    first = bench.own(of[0], (gap[0] * k22 - gap[1] * k12) / det)
    second = bench.own(of[1], (gap[1] * k11 - gap[0] * k21) / det)
    return first, second


def _carried(one: Line, other: Line, s1: Expr, s2: Expr, axis: int) -> Expr:
    return total([*other.carried(s2, axis), *((-sign, term) for sign, term in one.carried(s1, axis))])


def rpp(bench: Bench, d: Dyad) -> Written:
    """A pivoted slider on a guide of a link that itself slides: the crossing of two lines."""
    A, c = bench.spot(d.outer_a.name), d.carrier_b
    along = d.outer_b.along[c]
    turn = along * np.conj(d.outer_b.along[d.b])  # from the axes of b to those of the carrier
    inner = turn * d.inner.along[d.b]
    u_a = inner * np.conj(d.inner.along[d.a])
    lateral = cross(inner, u_a * d.arm_a)  # of the slider's line from its pivot
    through = d.outer_b.at[c] + turn * d.arm_b - 1j * inner * lateral
    slide = bench.line(d.outer_b.name, c, through, along)
    start = complex(bench.mechanism.links[c].points.get(slide.at.name, through))
    cut = Line(d.inner.name, slide.at, bench.direction(d.inner.name, c, inner), slide.w, slide.e)
    of = (slid(d.b, slide.guide, slide.at.name), slid(d.a, cut.guide, slide.at.name))
    lead = bench.taken()
    by = ((cos(slide.beta), sin(slide.beta)), (cos(cut.beta), sin(cut.beta)))
    gap = (total([(1, A.x), (-1, slide.at.x)]), total([(1, A.y), (-1, slide.at.y)]))
    s2, s1 = _crossing(bench, of, by, gap)
    positions = [*lead, *bench.taken()]
    u, w = sliding(d.b, slide.guide), sliding(d.a, cut.guide)
    v = A.v or (None, None)
    both = [[*slide.carried(s2, n), *cut.carried(s1, n)[1:]] for n in (0, 1)]
    eq = Equations(
        _pair([total([(1, slide.place(s2, n)), (1, s1 * by[1][n])]) for n in (0, 1)]), (A.x, A.y), *by,
        _pair([total([(1, v[n]), *((-sign, term) for sign, term in both[n])]) for n in (0, 1)]),
    )  # fmt: skip
    system = System(bench, d, u, w, eq)
    v2, v1 = system.velocities
    velocities, a = bench.taken(), A.a or (None, None)
    known = [
        total([
            (1, a[n]),
            *((-sign, term) for sign, term in [*slide.bent(s2, v2, n), *cut.bent(s1, v1, n)[1:]]),
        ])
        for n in (0, 1)
    ]  # fmt: skip
    a2, _ = system.accelerations((known[0], known[1]))
    base = Spot(
        slide.at.name, slide.place(s2, 0), slide.place(s2, 1),
        _pair([total([*slide.carried(s2, n), (1, v2 * by[0][n])]) for n in (0, 1)]),
        _pair([total([*slide.bent(s2, v2, n), (1, a2 * by[0][n])]) for n in (0, 1)]),
    )  # fmt: skip
    # the point of b that has gone from the line's own point: where b's axes have it
    origin = d.outer_b.at[d.b] + np.conj(turn) * (start - d.outer_b.at[c])
    bench.poses[d.b] = on_guide(base, complex(origin), d.outer_b.along[d.b], slide)
    bench.poses[d.a] = Pose(A, d.outer_a.at[d.a], cut.beta, arg(d.inner.along[d.a]), cut.w, cut.e)
    lines = vectors([f"r_{slide.at.name}", f"s_{d.b}", f"s_{d.a}"], [Symbol("r", A.name)])
    return Written(
        d.group, lines, projected(bench, eq.left, eq.right), positions,
        differentiated(bench, u, w, eq), velocities, bench.taken(), [],
    )  # fmt: skip


def _pair(both: list[Expr]) -> Two:
    return both[0], both[1]
