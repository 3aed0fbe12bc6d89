"""Unbalances of a rigid shaft: their sums, the masses that balance them, the forces on its bearings.

An unbalance is a complex product D = m r e^{iα}, kg m, at the place z along the shaft, m, in axes that turn with the
shaft; a body whose principal axis is not that of the shaft has besides the couple of its products of inertia
J_xz + i J_yz, kg m². At the angular velocity ω the shaft is pulled by ω² Σ D and turned over by ω² Σ (D z + J).
(Artobolevsky, Theory of mechanisms and machines, ch. 13; Frolov, ch. 6)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any
CLEAR = 1e-9  # of the sizes summed up: less is as good as nothing
ROUNDING = 1e-14  # of the sizes summed up: less is rounding


def tilted(axial: float, across: float, tilt: float, towards: float) -> complex:
    """Products of inertia J_xz + i J_yz, kg m², of a body of revolution set askew on its shaft.

    `axial`, `across`: its own moments of inertia, kg m²; its axis leans by `tilt` towards the direction `towards`, rad.
    """
    size = (across - axial) * np.sin(tilt) * np.cos(tilt)
    return complex(size * np.exp(1j * towards))


def moments(products: Array, places: Array, couples: Array, about: float) -> Array:
    """D (z − z₀) + J of each, kg m², about the plane at `about`, m."""
    return products * (places - about) + couples


def corrections(products: Array, places: Array, couples: Array, planes: Array) -> Array:
    """Products, kg m, to be added in one plane (force alone balanced) or in two (force and couple).

    In two: the couples about the first plane give the product in the second, the forces that in the first. The planes
    must differ.
    """
    planes = np.asarray(planes, dtype=float)
    force, turning = np.sum(products), moments(products, places, couples, planes[0])
    if len(planes) == 1:
        return np.array([-settled(force, products)])
    apart = planes[1] - planes[0]
    second = -settled(np.sum(turning), turning) / apart
    return np.array([settled(-force - second, np.append(products, turning / apart)), second])


def settled(total: complex, terms: Array) -> complex:
    """A sum, 0 where it is nothing but the rounding of its terms."""
    return complex(total) if abs(total) > ROUNDING * np.sum(np.abs(terms)) else 0j


def bearings(products: Array, places: Array, couples: Array, at: Array) -> Array:
    """What the bearings at the two places `at` feel, as unbalances in their planes, kg m, (2,): times ω² the forces on
    them, N.

    Each by the moments about the other bearing, so that the sum of both is a check: it must be Σ D.
    """
    about_both = (moments(products, places, couples, place) for place in at)
    second, first = (settled(np.sum(turning), turning) / (at[1] - at[0]) for turning in about_both)
    return np.array([-first, second])


LEAST_SHARE, LARGEST_SHARE, OVERHUNG_SHARE = 0.3, 0.7, 1.3


def permitted(whole: float, bearing_places: Array, centre: float) -> Array:
    """The permissible unbalance of a rotor shared by its bearings, (2,): by the distances of the mass centre from the
    other bearing, each between 0.3 and 0.7 of the whole, up to 1.3 where the centre overhangs. (ISO 21940-11, 6.2)"""
    first, second = bearing_places
    shares = np.abs(np.array([second - centre, first - centre])) / abs(second - first)
    return whole * np.clip(
        shares, LEAST_SHARE, OVERHUNG_SHARE if overhung(bearing_places, centre) else LARGEST_SHARE
    )


def overhung(bearing_places: Array, centre: float) -> bool:
    """Whether the mass centre does not lie between the bearings."""
    return not min(bearing_places) <= centre <= max(bearing_places)


def kind(products: Array, places: Array, couples: Array, about: float, scale: float) -> str:
    """ "none", "static" (one mass in the right plane balances all), "couple" or "dynamic".

    `scale`: a length of the shaft, m. (ISO 21940-2)
    """
    force, couple = np.sum(products), np.sum(moments(products, places, couples, about))
    size = np.sum(np.abs(products)) + np.sum(np.abs(couples)) / scale
    pulls, turns = abs(force) > CLEAR * size, abs(couple) > CLEAR * size * scale
    if not pulls:
        return "couple" if turns else "none"
    skew = abs((np.conj(force) * couple).imag) > CLEAR * abs(force) * size * scale
    return "dynamic" if skew else "static"


SLIM, STOUT = 0.5, 2.0  # width to diameter
LIMITS = (1000.0, 150.0, 100.0)  # rpm: of discs, of what is between, of long rotors


def one_plane_up_to(ratio: float) -> float:
    """The speed, rad/s, up to which a rotor of this ratio of width to diameter is balanced in one plane.

    1000 rpm for discs (below 0.5), 150 rpm up to 2, 100 rpm for longer ones. (IRD Mechanalysis, Dynamic balancing)
    """
    rpm = LIMITS[0] if ratio < SLIM else LIMITS[1] if ratio <= STOUT else LIMITS[2]
    return rpm * np.pi / 30


# --- a polygon of vectors as drawn by hand

ANGLES = 0.1  # degrees to which an angle is read


@dataclass(frozen=True, eq=False)
class Polygon:
    """`laid`: the vectors as laid off one after another, mm of paper, (N,) complex; `scale`: what a mm stands for;
    `closing`: the vector that closes the polygon, mm, as read: its length to the step, its angle to a tenth of a
    degree; `closes`: its name."""

    names: Sequence[str]
    laid: Array
    scale: float
    closing: complex
    closes: str

    @property
    def lengths(self) -> Array:
        """mm."""
        return np.abs(self.laid)

    @property
    def corners(self) -> Array:
        """Where the vectors begin and where the last of them ends, mm, (N + 1,)."""
        return np.concatenate([[0j], np.cumsum(self.laid)])


def polygon(names: Sequence[str], vectors: Array, scale: float, step: float, closes: str) -> Polygon:
    """`vectors`: (N,) complex, laid off at `scale` to the step, mm."""
    laid = _read(np.abs(vectors) / scale, step) * np.exp(1j * np.angle(vectors))
    end = -complex(np.sum(laid))
    length = float(_read(abs(end), step))
    turned = np.radians(_read(np.degrees(np.angle(end)), ANGLES)) if length else 0.0
    return Polygon(names, laid, scale, complex(length * np.exp(1j * turned)), closes)


def extent(vectors: Array) -> float:
    """The size of the polygon of vectors: the longest of them, or its width or height."""
    corners = np.concatenate([[0j], np.cumsum(vectors)])
    longest = np.max(np.abs(vectors), initial=0.0)
    return float(max(longest, np.ptp(corners.real), np.ptp(corners.imag)))


def _read(values: Array, step: float) -> Array:
    """Rounded half up to multiples of the step, as the decimal numbers that a person writes."""
    return np.round(np.sign(values) * np.floor(np.abs(values) / step + 0.5 + 1e-9) * step, 12)
