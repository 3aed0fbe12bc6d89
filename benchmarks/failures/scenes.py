"""The failing scenes: variants, and what is true of them at each driver angle, from closed formulas alone.

`roots(φ)`: the assemblies of the dyads at the driver angle φ, rad, of mpmath; NOWHERE where the mechanism cannot be
assembled, or cannot come from position 0; CORNER where its rates are not defined. In a change point the motion is the
limit from both sides.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from benchmarks.failures import schemes
from benchmarks.failures.schemes import Variant
from benchmarks.near_singular.closed import mp

NOWHERE, CORNER = "nowhere", "corner"
Root = int | str


@dataclass(frozen=True, eq=False)
class Scene:
    """`told`: what a program must say beside the numbers, were they all right: that the mechanism does not turn, say.
    `peer`: the same for other programs: ("slider", r, l, offset, side) or ("four-bar", a, b, c, f, side)."""

    title: str
    variant: Variant
    roots: Callable[[Any], Root] = field(default=lambda phi: 1)
    told: str = ""
    peer: tuple[Any, ...] = ()


def _first(phi: Any) -> Root:
    return 1


def _not_at_zero(phi: Any) -> Root:
    return NOWHERE if abs(mp.sin(phi)) < 1e-12 else 1


def _smooth(phi: Any) -> Root:
    """Rod equal to crank: B at 2r cos φ."""
    return 1 if mp.cos(phi) >= 0 else -1


def _parallel(phi: Any) -> Root:
    """A parallelogram: B left of A → C in the upper half of the turn."""
    return 1 if mp.sin(phi) >= 0 else -1


def _crossed(phi: Any) -> Root:
    return -int(_parallel(phi))


def _kite(phi: Any) -> Root:
    return CORNER if abs(mp.sin(phi / 2)) < 1e-12 else 1


def _within(sine: float) -> Callable[[Any], Root]:
    """A rod that reaches its guide only while the crank's sine is below this."""
    return lambda phi: 1 if abs(mp.sin(phi)) <= mp.mpf(sine) else NOWHERE


def _before(cosine: float) -> Callable[[Any], Root]:
    """A four-bar that comes to its limit where the crank's cosine is this: AC is then as long as both its links."""
    return lambda phi: 1 if mp.cos(phi) >= mp.mpf(cosine) else NOWHERE


def _corner_at(angle: float) -> Callable[[Any], Root]:
    return lambda phi: CORNER if abs(mp.sin((phi - mp.mpf(angle)) / 2)) < 1e-7 else 1


def _jam(a: float, b: float, c: float, f: float) -> float:
    return (a * a + f * f - (b + c) ** 2) / (2 * a * f)


def _limit(phi: Any) -> Root:
    """The four-bar that jams, whose limit itself is a position: it is there, its rates are not bounded."""
    return CORNER if abs(phi - mp.acos(mp.mpf(_jam(*JAM)))) < 1e-9 else _before(_jam(*JAM))(phi)


JAM = (3.0, 1.0, 2.0, 4.2)
JAM_AT = math.degrees(math.acos(_jam(*JAM)))


def _slider(
    title: str,
    r: float,
    l: float,
    offset: float = 0.0,
    zero: float = 0.0,
    table: int = 12,
    roots: Any = None,
    told: str = "",
) -> Scene:
    made = schemes.slider_crank(r, l, offset, zero, table)
    return Scene(title, made, roots or _first, told, ("slider", r, l, offset))


def _bar(
    title: str,
    lengths: tuple[float, float, float, float],
    zero: float = 0.0,
    table: int = 12,
    roots: Any = None,
    side: int = 1,
) -> Scene:
    """Crank, rod, rocker, frame."""
    made = schemes.four_bar(*lengths, zero, table, "left" if side > 0 else "right")
    return Scene(title, made, roots or _first, "", ("four-bar", *lengths, side))


def _swing(title: str, degrees: float, sweep: float, roots: Any) -> Scene:
    """The four-bar that jams, swung from an angle, 6 positions."""
    made = schemes.four_bar(*JAM, degrees, 6, range=math.radians(sweep))
    return Scene(title, made, roots)


TRIAD_FROM, TRIAD_TO = (
    -2.35,
    4.648567170104 - 2 * math.pi,
)  # rad: where its sketch is, and where it stretches out


def _stretched(phi: Any) -> Root:
    return 1 if mp.mpf(TRIAD_FROM) - 1e-9 <= phi <= mp.mpf(TRIAD_TO) else NOWHERE


SCENES: dict[str, Scene] = {
    "harmless": _slider("slider-crank, r/l = 1/3", 0.1, 0.3),
    "harmless bar": _bar("crank-rocker 0.1, 0.3, 0.25, 0.35", (0.1, 0.3, 0.25, 0.35)),
    "near dead 12": _slider("r/l = 0.999, 12 positions", 0.0999, 0.1),
    "near dead 36": _slider("r/l = 0.999, 36 positions", 0.0999, 0.1, table=36),
    "nearer dead": _slider("r/l = 1 − 1e-9, 12 positions", 0.1 * (1 - 1e-9), 0.1),
    "rod = crank": _slider("rod = crank, change points at positions", 0.1, 0.1, roots=_smooth),
    "rod = crank, aside": _slider("rod = crank, between positions", 0.1, 0.1, zero=7.0, roots=_smooth),
    "parallelogram": _bar("parallelogram, change points at positions", (0.1, 0.3, 0.1, 0.3), 30.0, roots=_parallel),
    "parallelogram, aside": _bar("parallelogram, between positions", (0.1, 0.3, 0.1, 0.3), 37.0, roots=_parallel),
    "antiparallelogram": _bar("antiparallelogram", (0.1, 0.3, 0.1, 0.3), 37.0, roots=_crossed, side=-1),
    "kite": _bar("kite, crank = frame, rod = rocker", (0.2, 0.3, 0.3, 0.2), 30.0, roots=_kite),
    "1 nm": _bar("parallelogram, rocker 1 nm longer", (0.1, 0.3, 0.1 + 1e-9, 0.3), 30.0),
    "10 pm": _bar("parallelogram, rocker 10 pm longer", (0.1, 0.3, 0.1 + 1e-11, 0.3), 30.0),
    "1 nm, aside": _bar("the same with 1 nm, between positions", (0.1, 0.3, 0.1 + 1e-9, 0.3), 37.0),
    "short rod": _slider("rod 0.8 of the crank: no closure over part", 0.1, 0.08, zero=4.0, roots=_within(0.8)),
    "narrow gap": _slider(
        "rod short by 1e-6: a gap of 0.16° between positions",
        0.1, 0.1 * (1 - 1e-6), zero=10.0, roots=_within(1 - 1e-6), told="a gap",
    ),
    "jam": _bar("four-bar 3, 1, 2, 4.2 that jams at 45.57°", JAM, roots=_before(_jam(*JAM))),
    "limit": _swing("the same, its limit a position of the table", JAM_AT - 30.0, 60.0, _limit),
    "merging": _swing("the same, 1e-9 rad before its limit", JAM_AT - 30.0 - 1e-9 * 57.3, 30.0, _before(_jam(*JAM))),
    "corner": _slider("offset = rod − crank: a corner at 270°", 0.1, 0.3, 0.2, roots=_corner_at(1.5 * math.pi)),
    "beside a corner": _slider("offset 1e-7 less", 0.1, 0.3, 0.2 - 1e-7),
    "parallel guides": Scene("crossing guides, parallel at positions", schemes.crossing(0.0), _not_at_zero),
    "parallel between": Scene(
        "crossing guides, parallel between positions", schemes.crossing(10.0), _first, "parallel guides"
    ),
    "tangent slot": Scene("slot nearly tangent, 1e-9", schemes.slotted(0.1, 0.3, 0.2 * (1 - 1e-9), 0.0)),
    "pin past pivot": Scene("pin 1 nm beside the pivot of its slot", schemes.slotted(0.1, 0.1 + 1e-9, 0.0, 0.0)),
    "pin through pivot": Scene("pin through the pivot of its slot", schemes.slotted(0.1, 0.1, 0.0, 30.0), _kite),
    "triad": Scene("class III, stretched out at 41.0°", schemes.triad(TRIAD_FROM, 36), _stretched),
    "triad, merging": Scene(
        "class III, 1e-9 rad before its limit",
        schemes.triad(TRIAD_FROM, 6, range=TRIAD_TO - TRIAD_FROM - 1e-9), _stretched,
    ),
    "micrometres": _slider("crank of 1 µm, rod 3 µm", 1e-6, 3e-6),
    "kilometres": _slider("crank of 1 km, rod 3 km", 1e3, 3e3),
    "both scales": _slider("crank of 1 mm on a rod of 1 m", 1e-3, 1.0),
    "long links": _bar("rod and rocker 1000 times the crank", (0.1, 100.0, 100.0, 0.3)),
    "whip": _bar("drag link 0.3, 0.25, 0.28, 0.1: steps of 60°", (0.3, 0.25, 0.28, 0.1), table=6),
}  # fmt: skip
