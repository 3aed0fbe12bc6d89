"""Where the joints of a found linkage are in the positions that its picture shows, m; the first position is drawn
thick."""

from __future__ import annotations

import cmath
import math
from itertools import pairwise

import numpy as np

from tmm_report.chapters.lever.synthesis import body_steps, points_steps
from tmm_report.chapters.lever.synthesis.given import (
    AnglePairs,
    Body,
    CrankRocker,
    Dwell,
    Generator,
    RockerPositions,
    SliderCrank,
    SliderPositions,
    SlottedLink,
    TurningGuide,
)
from tmm_report.chapters.lever.synthesis.rounding import moved_joints
from tmm_report.chapters.lever.synthesis.solve import Design
from tmm_report.chapters.lever.synthesis.values import Values
from tmm_report.records import dataclass

Chain = tuple[complex, ...]


@dataclass(frozen=True, eq=False)
class Picture:
    """`chains`: of each position the joints from link to link; `pivots`: fixed ones; `names` of places; `lines` along
    which something slides; `circles`: centre and radius; `arcs`: with both their ends, rad; `spans`: lengths between
    two places, by their keys."""

    chains: tuple[tuple[Chain, ...], ...]
    pivots: tuple[complex, ...]
    names: tuple[tuple[str, complex], ...]
    lines: tuple[tuple[complex, complex], ...] = ()
    circles: tuple[tuple[complex, float], ...] = ()
    arcs: tuple[tuple[complex, float, float, float], ...] = ()
    spans: tuple[tuple[str, complex, complex], ...] = ()


def picture(found: Design) -> Picture:
    s = found.s
    match asked := found.given.asked:
        case SliderCrank():
            return _slider_crank(s)
        case CrankRocker():
            return _crank_rocker(s, asked)
        case SlottedLink():
            return _slotted_link(s)
        case TurningGuide():
            return _turning_guide(s)
        case Generator() | AnglePairs():
            return _through(found)
        case Dwell():
            return _dwell(found, asked)
        case Body():
            return _body(found, asked)
        case RockerPositions() | SliderPositions():
            return _two(s, asked.crank_angles)
    raise TypeError(asked)


def _slider_crank(s: Values) -> Picture:
    a, b, e = (s.number(key) for key in ("crank", "rod", "offset"))
    far, near = (complex(math.sqrt(reach**2 - e**2), -e) for reach in (b + a, b - a))
    pins = a * far / abs(far), -a * near / abs(near)
    return Picture(
        chains=(((0j, pins[0], far),), ((0j, pins[1], near),)),
        pivots=(0j,),
        names=(("O", 0j), ("A'", pins[0]), ("B'", far), ('A"', pins[1]), ('B"', near)),
        lines=((near - 0.4 * a, far + 0.4 * a),),
        circles=((0j, a),),
        spans=(("stroke", near, far), *((("offset", 0j, complex(0, -e)),) if e else ())),
    )


def _crank_rocker(s: Values, asked: CrankRocker) -> Picture:
    a, c = s.number("crank"), s.number("rocker")
    pivot = complex(s.number("frame_x"), s.number("frame_y"))
    ends = [pivot + c * cmath.rect(1, asked.middle + turn * asked.swing / 2) for turn in (-1, 1)]
    near, far = sorted(ends, key=abs)
    pins = a * far / abs(far), -a * near / abs(near)
    return Picture(
        chains=(((0j, pins[0], far, pivot),), ((0j, pins[1], near, pivot),)),
        pivots=(0j, pivot),
        names=(("O", 0j), ("C", pivot), ("A'", pins[0]), ("B'", far), ('A"', pins[1]), ('B"', near)),
        circles=((0j, a),),
        spans=(("frame", 0j, pivot),),
    )


def _slotted_link(s: Values) -> Picture:
    a, d, L, b, h = (s.number(key) for key in ("crank", "frame", "link", "rod", "slide_line"))
    half = s.number("theta") / 2
    chains, names = [], [("O", 1j * d), ("C", 0j)]
    for turn, mark in ((1, "'"), (-1, '"')):
        end = L * cmath.rect(1, math.pi / 2 + turn * half)
        pin = d * math.cos(half) * cmath.rect(1, math.pi / 2 + turn * half)
        slider = complex(end.real + math.sqrt(b**2 - (h - end.imag) ** 2), h)
        chains.append(((0j, end, slider), (1j * d, pin)))
        names += [(f"A{mark}", pin), (f"B{mark}", end), (f"D{mark}", slider)]
    left, right = chains[0][0][2], chains[1][0][2]
    return Picture(
        chains=(chains[0], chains[1]),
        pivots=(0j, 1j * d),
        names=tuple(names),
        lines=((left - 0.3 * a, right + 0.3 * a),),
        circles=((1j * d, a),),
        spans=(("stroke", left, right), ("slide_line", 0j, 1j * h)),
    )


def _turning_guide(s: Values) -> Picture:
    a, d, r, b = (s.number(key) for key in ("crank", "frame", "arm", "rod"))
    across = math.sqrt(a**2 - d**2)
    chains, names = [], [("O", 0j), ("C", 1j * d)]
    for turn, mark in ((1, "'"), (-1, '"')):
        pin, end = complex(-turn * across, d), complex(turn * r, d)
        slider = end + b
        chains.append(((pin, end, slider), (0j, pin)))
        names += [(f"A{mark}", pin), (f"B{mark}", end), (f"D{mark}", slider)]
    right, left = chains[0][0][2], chains[1][0][2]
    return Picture(
        chains=(chains[0], chains[1]),
        pivots=(0j, 1j * d),
        names=tuple(names),
        lines=((left - 0.3 * r, right + 0.3 * r),),
        circles=((0j, a),),
        spans=(("stroke", left, right),),
    )


def _through(found: Design) -> Picture:
    """In three pairs of angles."""
    s, bar = found.s, found.bar
    assert bar is not None and found.table is not None
    d = s.number("frame")
    phi = np.asarray(found.table["phi"].values, float)
    pins, ends = s.number("crank") * np.exp(1j * phi), d + s.number("rocker") * bar.rocker(phi)
    chains = tuple(
        ((0j, complex(pin), complex(end), complex(d)),) for pin, end in zip(pins, ends, strict=True)
    )
    marked = [(f"{name}{k}", complex(at)) for k in range(3) for name, at in (("A", pins[k]), ("B", ends[k]))]
    return Picture(chains, (0j, complex(d)), (("O", 0j), ("C", complex(d)), *marked))


def _dwell(found: Design, asked: Dwell) -> Picture:
    s, bar = found.s, points_steps.linkage(asked)
    phi = np.asarray(found.table["phi"].values, float) if found.table is not None else np.zeros(0)
    at = points_steps.traced(asked, bar, phi)
    pin = asked.crank * np.exp(1j * phi)
    end = asked.frame + asked.rocker * bar.rocker(phi)
    centre = complex(s.number("centre_x"), s.number("centre_y"))
    chains = tuple(
        (
            (0j, complex(pin[k]), complex(end[k]), complex(asked.frame)),
            (complex(pin[k]), complex(at[k]), complex(end[k])),
            (complex(at[k]), centre),
        )
        for k in (1, 0, 2)
    )
    named = [(f"P{k + 1}", complex(at[k])) for k in range(3)]
    full = np.linspace(0, 2 * np.pi, 181)
    path = points_steps.traced(asked, bar, full)
    path = path[np.isfinite(path)]
    return Picture(
        chains, (0j, complex(asked.frame)), (("O", 0j), ("C", complex(asked.frame)), ("Q", centre), *named),
        lines=tuple((complex(one), complex(other)) for one, other in pairwise(path)),
        arcs=((centre, s.number("radius"), *_reach(at - centre)),),
    )  # fmt: skip


def _body(found: Design, asked: Body) -> Picture:
    s = found.s
    crank = complex(s.number("crank_pivot_x"), s.number("crank_pivot_y"))
    rocker = complex(s.number("rocker_pivot_x"), s.number("rocker_pivot_y"))
    pins, ends = body_steps.pinned(asked)
    chains = tuple(
        ((crank, complex(pin), complex(end), rocker),) for pin, end in zip(pins, ends, strict=True)
    )
    named = [
        (f"{name}{k + 1}", complex(at[k]))
        for k in range(len(pins))
        for name, at in (("A", pins), ("B", ends))
    ]
    arcs = [
        (centre, radius, *_reach(at - centre))
        for centre, radius, at in ((crank, s.number("crank"), pins), (rocker, s.number("rocker"), ends))
    ]
    bisectors = [_bisector(pivot, at) for pivot, at in ((crank, pins), (rocker, ends)) if len(at) == 2]
    names = (("O", crank), ("C", rocker), *named)
    return Picture(chains, (crank, rocker), names, arcs=tuple(arcs), lines=tuple(bisectors))


def _two(s: Values, angles: list[float] | None) -> Picture:
    """A rocker or a slider in two positions; without `angles` of the crank they are extreme."""
    ends = moved_joints(s, s.number)
    turns = np.exp(1j * np.array(angles)) if angles else ends / np.abs(ends) * np.array([1, -1])
    pins = s.number("crank") * turns
    fixed = complex(s.number("frame")) if "psi_1" in s else 0j
    pivots: tuple[complex, ...] = (0j, fixed) if "psi_1" in s else (0j,)
    chains = tuple(
        ((0j, complex(pin), complex(end), *pivots[1:]),) for pin, end in zip(pins, ends, strict=True)
    )
    marks = ("'", '"')
    named = [
        (f"{name}{mark}", complex(at[k]))
        for k, mark in enumerate(marks)
        for name, at in (("A", pins), ("B", ends))
    ]
    if "psi_1" in s:
        names = (("O", 0j), ("C", fixed), *named)
        return Picture(
            chains, pivots, names, circles=((0j, s.number("crank")),), spans=(("frame", 0j, fixed),)
        )
    reach = 0.4 * s.number("crank")
    low, high = sorted((complex(end) for end in ends), key=lambda end: end.real)
    offset = (("offset", 0j, complex(0, low.imag)),) if low.imag else ()
    return Picture(
        chains, pivots, (("O", 0j), *named), lines=((low - reach, high + reach),),
        circles=((0j, s.number("crank")),), spans=offset,
    )  # fmt: skip


def _bisector(pivot: complex, at: np.ndarray) -> tuple[complex, complex]:
    """From the way of a pin beyond the pivot that stands on it, a little longer on both sides."""
    way = complex(at[1] - at[0])
    middle, along = complex(at[0] + at[1]) / 2, 0.1j * way
    if ((pivot - middle).conjugate() * along).real < 0:
        along = -along
    return middle - along, pivot + along


def _reach(arms: np.ndarray) -> tuple[float, float]:
    """Ends of an arc a little beyond its points, rad."""
    middle = (
        np.angle(arms[1]) if len(arms) == 3 else np.angle(arms.sum() if abs(arms.sum()) else 1j * arms[0])
    )
    off = np.angle(arms * np.exp(-1j * middle))
    return float(middle + 1.6 * off.min()), float(middle + 1.6 * off.max())
