"""Span, chords and pins against gauges laid on drawn outlines, with no formula shared: flanks are points, their normals
differences between these, and helical flanks the same points wound along the axis."""

import math

import numpy as np
import pytest

from tmm_report.mechanics.gears import meshing, tooth_outlines
from tmm_report.mechanics.gears.inspection import Gauged
from tmm_report.mechanics.gears.rack import Rack

POINTS = 8001
ALMOST = 1e-7  # of the module: what normals by differences leave
ACROSS = 5e-3  # of the module: helical teeth by the wheel that stands for their normal section


class Flank:
    """The counter-clockwise flank of tooth 0, whose middle is the +x axis; (N, 3) points at z = 0 and unit normals that
    look out of the metal."""

    def __init__(self, gauge: Gauged):
        pair, i = gauge.pair, gauge.i
        z, x = gauge.z, gauge.shift * math.cos(pair.beta)
        if gauge.ring:
            self.drawn = tooth_outlines.ring(z, pair.m_t, x, pair.t, pair.d_a[i] / 2, pair.d_f[i] / 2)
        else:
            self.drawn = tooth_outlines.external(z, pair.m_t, x, pair.t, pair.d_a[i] / 2)
        plane = self.drawn.flank(np.hypot(gauge.of("d_b") / 2, np.linspace(*gauge.involute, POINTS)))
        self.wound = math.tan(pair.beta) / (gauge.of("d") / 2)  # rad per metre along the axis
        self.points = np.stack([plane.real, plane.imag, 0 * plane.real], axis=-1)
        along = np.gradient(self.points, axis=0, edge_order=2)
        helix = np.stack([-self.wound * plane.imag, self.wound * plane.real, np.ones(POINTS)], axis=-1)
        normal = np.cross(along, helix)
        normal /= np.linalg.norm(normal, axis=-1)[:, None]
        self.normals = normal * np.sign(normal[:, 1])[:, None]
        self.half_pitch = math.pi / z

    def turned(self, vectors, angle):
        c, s = np.cos(angle), np.sin(angle)
        x, y, z = vectors.T
        return np.stack([c * x - s * y, s * x + c * y, z], axis=-1)

    def facing(self, direction, start=0.0):
        """Points and normals after the turn `start`, each wound up along the helix until its normal looks in a
        `direction` of the transverse section; and by what angle: straight flanks stay."""
        points, normals = self.turned(self.points, start), self.turned(self.normals, start)
        left = direction - np.arctan2(normals[:, 1], normals[:, 0])
        if self.wound:
            points, normals = self.turned(points, left), self.turned(normals, left)
            points[:, 2] = left / self.wound
        return points, normals, left


def crossing(of, *numbers):
    """The numbers (N, ...) where `of` (N,) changes its sign, by the cubic through four of them."""
    at = np.flatnonzero((of[1:] > 0) != (of[:-1] > 0))
    assert len(at) == 1
    four = np.clip(at[0] - 1, 0, POINTS - 4) + np.arange(4)
    others = [np.delete(of[four], k) for k in range(4)]
    shares = [np.prod(left / (left - own)) for own, left in zip(of[four], others, strict=True)]
    return [float(np.dot(shares, one[four])) for one in numbers]


def by_planes(flank, gauge, count):
    """W and the radius of the touching point. The outer flanks, of a ring those of its outer spaces, are turned into
    one another by half a turn about the +x axis: planes on both are parallel where their normals have no x."""
    points, normals, left = flank.facing(
        math.pi / 2, (-count if gauge.ring else count - 1) * flank.half_pitch
    )
    apart = 2 * np.einsum("nk,nk->n", points, normals)
    off = points[:, 1] * normals[:, 2] - points[:, 2] * normals[:, 1] if flank.wound else left
    width, radius = crossing(off, apart, np.hypot(points[:, 0], points[:, 1]))
    return abs(width), radius


def by_balls(flank, gauge, diameter):
    """M over or between balls that touch the flank and lie in the middle of the space, diameter of the circle of their
    centres, radius of the touching point."""
    centres = flank.points + diameter / 2 * flank.normals
    angles = np.arctan2(centres[:, 1], centres[:, 0]) - flank.wound * centres[:, 2]
    radii = np.hypot(flank.points[:, 0], flank.points[:, 1])
    middle, touching = crossing(angles - flank.half_pitch, np.hypot(centres[:, 0], centres[:, 1]), radii)
    opposite = middle * np.exp(2j * math.pi * (gauge.z // 2) / gauge.z)
    return abs(middle - opposite) + (-diameter if gauge.ring else diameter), 2 * middle, touching


def by_rack(flank, gauge):
    """Constant chord and its distance from the tip: points whose normals are those of the rack's flank, in the normal
    section through the middle of the tooth."""
    pair = gauge.pair
    alpha, beta = pair.rack.alpha, pair.beta
    way = -1 if gauge.ring else 1
    direction = math.atan2(math.cos(alpha) * math.cos(beta), way * math.sin(alpha))
    points, _, left = flank.facing(direction)
    across = points[:, 1] * math.cos(beta) - points[:, 2] * math.sin(beta)
    aside = points[:, 1] * math.sin(beta) + points[:, 2] * math.cos(beta) if flank.wound else left
    chord, level = crossing(aside, 2 * across, points[:, 0])
    return chord, tip(flank, gauge) - level if not gauge.ring else level - tip(flank, gauge)


def tip(flank, gauge):
    """Where a caliper stands: on the middle of a tooth, on the corners of a ring's hollow tip."""
    return flank.points[0, 0] if gauge.ring else gauge.of("d_a") / 2


def by_caliper(flank, gauge, diameter):
    """Chord between the helices of both flanks on a cylinder, where they are nearest, and its distance from the tip."""
    radii = np.hypot(flank.points[:, 0], flank.points[:, 1])
    (angle,) = crossing(radii - diameter / 2, np.arctan2(flank.points[:, 1], flank.points[:, 0]))
    rise = np.linspace(-1, 1, POINTS) * diameter / 4 if flank.wound else np.zeros(1)
    apart = 2 * np.hypot(diameter / 2 * np.sin(angle + flank.wound * rise), rise)
    least = np.argmin(apart)
    level = diameter / 2 * math.cos(angle + flank.wound * rise[least])
    height = level - tip(flank, gauge)
    return apart[least], height if gauge.ring else -height


def random_pair(rng):
    """One that can be cut, with teeth that are not pointed; None where the draw is none."""
    internal, helical = rng.random() < 0.35, rng.random() < 0.4
    rack = Rack(math.radians(rng.choice([20.0, 20.0, 15.0, 25.0])), *rng.choice([(1.0, 0.25), (0.8, 0.3)]))
    z1 = int(rng.integers(10, 60))
    z2 = z1 + int(rng.integers(12, 70)) if internal else int(rng.integers(10, 120))
    beta = math.radians(rng.uniform(5, 35)) if helical else 0.0
    x1, x2 = rng.uniform(-0.3, 0.8, 2)
    pair = meshing.meshed(z1, z2, rng.uniform(1e-3, 9e-3), rack, beta, x1, x2, internal, trimmed=internal)
    sound = (
        np.isfinite(pair.alpha_w) and min(pair.s_a) > 0.1 * pair.m and pair.eps > 1 and min(pair.rho_p) > 0
    )
    return pair if sound else None


def drawn_pairs(count, seed=4):
    rng, found = np.random.default_rng(seed), 0
    while found < count:
        with np.errstate(invalid="ignore"):
            pair = random_pair(rng)
        if pair is not None:
            found += 1
            yield from (Gauged(pair, i) for i in (0, 1))


@pytest.mark.parametrize("count", [60, pytest.param(2000, marks=pytest.mark.exhaustive)])
def test_sizes_of_random_pairs_measured_on_their_outlines(count):
    told = dict.fromkeys(("span", "pins", "constant", "chord"), 0)
    for gauge in drawn_pairs(count):
        flank, m = Flank(gauge), gauge.pair.m
        for teeth in gauge.spans(gauge.involute):
            width, radius = by_planes(flank, gauge, teeth)
            assert gauge.span(teeth) == pytest.approx(width, abs=ALMOST * m)
            assert gauge.at(gauge.span_touches(teeth)) / 2 == pytest.approx(radius, abs=ALMOST * m)
            told["span"] += 1
        for D in np.array([1.5, 1.7, 2.0]) * m:
            if gauge.pin_fits(D):
                over, centres, radius = by_balls(flank, gauge, D)
                assert gauge.over(D) == pytest.approx(over, abs=ALMOST * m)
                assert gauge.pin_centres(D) == pytest.approx(centres, abs=ALMOST * m)
                assert gauge.at(gauge.pin_touches(D)) / 2 == pytest.approx(radius, abs=ALMOST * m)
                told["pins"] += 1
        low, high = gauge.involute
        if low < gauge.chord_touches < high:
            exact = gauge.pair.beta == 0 or not gauge.ring  # the tip of a helical ring is hollow
            chord, height = by_rack(flank, gauge)
            assert gauge.constant_chord[0] == pytest.approx(chord, abs=ALMOST * m)
            assert gauge.constant_chord[1] == pytest.approx(height, abs=(ALMOST if exact else ACROSS) * m)
            told["constant"] += 1
        for rho in (low + 0.3 * (high - low), low + 0.8 * (high - low)):
            d, near = float(gauge.at(rho)), ALMOST if gauge.pair.beta == 0 else ACROSS
            assert gauge.chord(d) == pytest.approx(by_caliper(flank, gauge, d), abs=near * m)
            told["chord"] += 1
    assert min(told.values()) > count
