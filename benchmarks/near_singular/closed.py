"""Dyads in 130 digits: places by closed formulas, rates by differences of the driver's angle, forces by one system.

Independent of the program but for what a group is (`mechanics/lever/assur_groups`) and the order of its links
(`mechanics/lever/dyads.dyad`). Numbers of a mechanism may be doubles or numbers of mpmath.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from mpmath import MPContext

from tmm_report.mechanics.lever.assur_groups import Structure, decompose
from tmm_report.mechanics.lever.dyads import Dyad, dyad
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism

Number = Any  # of mpmath
Roots = Sequence[int]  # of every dyad with its number, ±1

mp = MPContext()
mp.dps = 130
STEP = mp.mpf(10) ** -32  # of the differences: to 60 digits where the closeness is 1e-6


@dataclass
class Body:
    """Motion of a link's axes: place of the origin, unit direction of x, their rates by time."""

    r: Number
    u: Number
    v: Number = 0
    w: Number = 0
    a: Number = 0
    e: Number = 0

    def place(self, at: Number) -> Number:
        return self.r + self.u * at

    def velocity(self, at: Number) -> Number:
        return self.v + mp.mpc(0, self.w) * self.u * at

    def acceleration(self, at: Number) -> Number:
        return self.a + mp.mpc(-self.w * self.w, self.e) * self.u * at


Pose = dict[str, Body]


def cross(a: Number, b: Number) -> Number:
    return a.real * b.imag - a.imag * b.real


def exactly(x: Any) -> Number:
    """A double, complex or not, without any rounding."""
    if hasattr(x, "_mpf_") or hasattr(x, "_mpc_"):
        return mp.convert(x) if hasattr(x, "_mpf_") else mp.mpc(mp.convert(x.real), mp.convert(x.imag))
    return mp.mpc(x.real, x.imag) if isinstance(x, complex) else mp.mpf(float(x))


def unit(z: Number) -> Number:
    return z / abs(z)


def lifted(m: Mechanism) -> Mechanism:
    """The mechanism with numbers of mpmath, equal to its doubles."""

    def vector(z: Any) -> Number:
        return exactly(complex(z))

    links = {
        name: replace(
            link,
            points={p: vector(z) for p, z in link.points.items()},
            mass=exactly(link.mass),
            inertia=exactly(link.inertia),
        )
        for name, link in m.links.items()
    }
    guides = {
        name: replace(g, through=vector(g.through), direction=vector(g.direction))
        for name, g in m.guides.items()
    }
    slides = [replace(s, through=vector(s.through), direction=vector(s.direction)) for s in m.slides]
    driver = replace(m.driver, omega=exactly(m.driver.omega))
    return replace(m, links=links, guides=guides, slides=slides, driver=driver)


# ---------------------------------------------------------------- places


@dataclass(frozen=True, eq=False)
class Chain:
    """A mechanism of dyads in the assemblies `roots`."""

    structure: Structure
    dyads: tuple[Dyad, ...]

    def pose(self, phi: Number) -> Pose:
        m, pair = self.structure.mechanism, self.structure.driver_pair
        link, u = m.driver.link, mp.expj(phi)
        pose = {FRAME: Body(mp.mpc(0), mp.mpc(1)), link: Body(pair.at[FRAME] - u * pair.at[link], u)}
        for d in self.dyads:
            pose[d.a], pose[d.b] = _PLACE[d.kind](pose, d)
        return pose

    def motion(self, phi: Number, omega: Number) -> Pose:
        """Rates by central differences of the places."""
        back, now, on = (self.pose(phi + k * STEP) for k in (-1, 0, 1))
        for link, body in now.items():
            (r0, u0), (r1, u1), (r2, u2) = ((x[link].r, x[link].u) for x in (back, now, on))
            body.v, body.w = omega * (r2 - r0) / (2 * STEP), omega * ((u2 - u0) / u1).imag / (2 * STEP)
            body.a = omega**2 * (r2 - 2 * r1 + r0) / STEP**2
            body.e = omega**2 * ((u2 - 2 * u1 + u0) / u1).imag / STEP**2
        return now


def chain(m: Mechanism, roots: Roots) -> Chain:
    structure = decompose(m)
    groups = zip(structure.groups, roots, strict=True)
    return Chain(structure, tuple(dyad(m, group, sign) for group, sign in groups))


def _at(at: Number, joint: Number, u: Number) -> Body:
    """A link whose point `at` lies in `joint`."""
    return Body(joint - u * at, u)


def _ends(pose: Pose, d: Dyad) -> tuple[Number, Number]:
    return pose[d.carrier_a].place(d.outer_a.at[d.carrier_a]), pose[d.carrier_b].place(
        d.outer_b.at[d.carrier_b]
    )


def _line(pose: Pose, pair: Any, carrier: str, link: str) -> tuple[Number, Number]:
    """World direction of a guide, and of the x axis of the link that slides on it."""
    t = unit(pose[carrier].u * pair.along[carrier])
    return t, unit(t * mp.conj(pair.along[link]))


def _rrr(pose: Pose, d: Dyad) -> tuple[Body, Body]:
    A, C = _ends(pose, d)
    p, q, AC = abs(d.arm_a), abs(d.arm_b), abs(C - A)
    cosine = (AC**2 + p**2 - q**2) / (2 * AC * p)
    AB = p * unit(C - A) * mp.mpc(cosine, d.sign * mp.sqrt(1 - cosine**2))
    return _at(d.outer_a.at[d.a], A, AB / d.arm_a), _at(d.outer_b.at[d.b], C, unit((A + AB - C) / d.arm_b))


def _rrp(pose: Pose, d: Dyad) -> tuple[Body, Body]:
    A = _ends(pose, d)[0]
    t, u = _line(pose, d.outer_b, d.carrier_b, d.b)
    G = _ends(pose, d)[1] + u * d.arm_b
    h = cross(t, G - A)
    AB = t * mp.mpc(d.sign * mp.sqrt(abs(d.arm_a) ** 2 - h**2), h)
    return _at(d.outer_a.at[d.a], A, unit(AB / d.arm_a)), _at(d.inner.at[d.b], A + AB, u)


def _rpr(pose: Pose, d: Dyad) -> tuple[Body, Body]:
    A, C = _ends(pose, d)
    ta, tb = (unit(d.inner.along[link]) for link in (d.a, d.b))
    h = cross(ta, d.arm_a) - cross(tb, d.arm_b)
    t = unit((C - A) / mp.mpc(d.sign * mp.sqrt(abs(C - A) ** 2 - h**2), h))
    return _at(d.outer_a.at[d.a], A, t * mp.conj(ta)), _at(d.outer_b.at[d.b], C, t * mp.conj(tb))


def _prp(pose: Pose, d: Dyad) -> tuple[Body, Body]:
    (G1, G2), (t1, u1), (t2, u2) = (
        _ends(pose, d),
        _line(pose, d.outer_a, d.carrier_a, d.a),
        _line(pose, d.outer_b, d.carrier_b, d.b),
    )
    G1, G2 = G1 + u1 * d.arm_a, G2 + u2 * d.arm_b
    B = G1 + t1 * (cross(G2 - G1, t2) / cross(t1, t2))
    return _at(d.inner.at[d.a], B, u1), _at(d.inner.at[d.b], B, u2)


def _rpp(pose: Pose, d: Dyad) -> tuple[Body, Body]:
    A, G = _ends(pose, d)
    t2, u_b = _line(pose, d.outer_b, d.carrier_b, d.b)
    t1 = unit(u_b * d.inner.along[d.b])
    u_a = unit(t1 * mp.conj(d.inner.along[d.a]))
    G = G + u_b * d.arm_b
    along = cross(A + u_a * d.arm_a - G, t1) / cross(t2, t1)
    return _at(d.outer_a.at[d.a], A, u_a), _at(d.inner.at[d.b], G + t2 * along, u_b)


_PLACE: dict[int, Callable[[Pose, Dyad], tuple[Body, Body]]] = {1: _rrr, 2: _rrp, 3: _rpr, 4: _prp, 5: _rpp}

# ---------------------------------------------------------------- forces

Push = Mapping[str, tuple[complex, str]]  # link -> force, N, and the point in which it acts


def forces(structure: Structure, pose: Mapping[str, Any], gravity: complex, push: Push) -> dict[str, Number]:
    """Reactions of all pairs by their keys, of the first link on the second, N, and "balancing", the moment on the
    driving link, N m: the equilibrium of all links as one system."""
    m = structure.mechanism
    row = {link: 3 * k for k, link in enumerate(m.moving)}
    A, b = mp.zeros(3 * len(row)), mp.zeros(3 * len(row), 1)
    for link, k in row.items():
        load, moment = mp.mpc(0), -m.links[link].inertia * pose[link].e
        for force, point in _acting(m, link, pose, gravity, push):
            load, moment = load + force, moment + cross(pose[link].place(m.links[link].points[point]), force)
        b[k], b[k + 1], b[k + 2] = -load.real, -load.imag, -moment
    for c, pair in zip(range(0, 3 * len(row), 2), structure.pairs, strict=False):
        at, vectors = _acts(pair, pose)
        for sign, link in zip((-1, 1), pair.links, strict=True):
            if (k := row.get(link)) is None:
                continue
            for n, e in enumerate(vectors):
                A[k, c + n], A[k + 1, c + n], A[k + 2, c + n] = (
                    sign * e.real,
                    sign * e.imag,
                    sign * cross(at, e),
                )
            if pair.kind == "P":
                A[k + 2, c + 1] = sign
    A[row[m.driver.link] + 2, 3 * len(row) - 1] = 1
    x = mp.lu_solve(A, b)
    found: dict[str, Number] = {"balancing": x[3 * len(row) - 1]}
    for c, pair in zip(range(0, 3 * len(row), 2), structure.pairs, strict=False):
        found[pair.key] = sum((x[c + n] * e for n, e in enumerate(_acts(pair, pose)[1])), mp.mpc(0))
    return found


def _acting(
    m: Mechanism, link: str, pose: Mapping[str, Any], gravity: complex, push: Push
) -> list[tuple[Number, str]]:
    body = m.links[link]
    found = [(exactly(push[link][0]), push[link][1])] if link in push else []
    if body.mass_centre is None:
        return found
    weight = body.mass * (exactly(gravity) - pose[link].acceleration(body.points[body.mass_centre]))
    return [*found, (weight, body.mass_centre)]


def _acts(pair: Any, pose: Mapping[str, Any]) -> tuple[Number, list[Number]]:
    """Where a pair's force acts, and the directions of what is unknown of it: a pivot's two, a guide's normal."""
    link = pair.slider or pair.links[1]
    at = pose[link].place(pair.at[link])
    if pair.kind == "R":
        return at, [mp.mpc(1), mp.mpc(0, 1)]
    carrier = pair.other(pair.slider)
    return at, [mp.mpc(0, 1) * unit(pose[carrier].u * pair.along[carrier])]
