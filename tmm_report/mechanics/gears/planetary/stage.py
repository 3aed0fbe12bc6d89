"""Planetary stages: Willis' ratio, sizes, the conditions on the numbers of teeth, and the search for the teeth.

Two central wheels 1 and 3, a carrier H and satellites whose crown 2 meshes with wheel 1 and crown 2' with wheel 3;
in the single-row scheme both are one crown. Teeth are integers (4, ...): z1, z2, z2', z3 (z2' = z2 in a single row).
The basic ratio is u = u13(H) = (ω1 − ωH)/(ω3 − ωH). Lengths are m.

Conditions: Frolov (ed.), Theory of mechanisms and machines, ch. 15; Kudryavtsev, Planetary gearing, ch. 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.gears import pair_sizes as wheels
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.pair_sizes import arccos, clear_ring_tip, involute_start, root
from tmm_report.mechanics.gears.ring_interference import fouling, radial
from tmm_report.records import dataclass

Array = Any
Member = Literal["wheel1", "wheel3", "carrier"]
MEMBERS: tuple[Member, ...] = ("wheel1", "wheel3", "carrier")

EXTERNAL, INTERNAL = 1, -1
ROWS = ((0, 1), (3, 2))  # places of each row's central wheel and crown among the teeth


@dataclass(frozen=True)
class Scheme:
    """`rows`: the kind of mesh of wheel 1 with crown 2 and of wheel 3 with crown 2', EXTERNAL or INTERNAL."""

    name: str
    rows: tuple[int, int]
    single: bool = False

    @property
    def wheels(self) -> tuple[int, ...]:
        """Places of the different wheels among the teeth: the one crown of a single row is taken once."""
        return (0, 1, 3) if self.single else (0, 1, 2, 3)


SCHEMES = {
    scheme.name: scheme
    for scheme in (
        Scheme("sun-ring", (EXTERNAL, INTERNAL), single=True),
        Scheme("external-external", (EXTERNAL, EXTERNAL)),
        Scheme("external-internal", (EXTERNAL, INTERNAL)),
        Scheme("internal-internal", (INTERNAL, INTERNAL)),
    )
}


def kinds(scheme: Scheme) -> tuple[int, int, int, int]:
    """EXTERNAL or INTERNAL teeth of the wheels 1, 2, 2', 3."""
    return scheme.rows[0], EXTERNAL, EXTERNAL, scheme.rows[1]


# --- kinematics and efficiency


def basic_ratio(scheme: Scheme, z: Array) -> Array:
    """u13(H) with the carrier stopped, (...): (∓z2/z1)(∓z3/z2'), minus for an external mesh."""
    z1, z2, z2_, z3 = z
    return scheme.rows[0] * scheme.rows[1] * (z2 * z3) / (z1 * z2_)


def relative_speeds(basic: Array, input: Member, held: Member) -> dict[Member, Array]:
    """Speeds of wheels 1, 3 and the carrier for an input speed of 1 and one member held, by Willis."""
    u = np.asarray(basic, dtype=float)
    one, zero = np.ones_like(u), np.zeros_like(u)
    frames = {  # ω1, ω3, ωH of a motion in which the member stands still
        "wheel1": (zero, 1 - 1 / u, one),
        "wheel3": (1 - u, zero, one),
        "carrier": (u, one, zero),
    }
    with np.errstate(divide="ignore", invalid="ignore"):
        motion = dict(zip(MEMBERS, frames[held], strict=True))
        return {member: motion[member] / motion[input] + 0.0 for member in MEMBERS}  # no -0


def stage_ratio(basic: Array, input: Member, output: Member) -> Array:
    """ω_input/ω_output with the third member held, (...); infinite where the output stands still."""
    held = next(member for member in MEMBERS if member not in (input, output))
    with np.errstate(divide="ignore"):
        return 1 / relative_speeds(basic, input, held)[output]


def satellite_speed(scheme: Scheme, z: Array, speed1: Array, speed_carrier: Array) -> Array:
    """Absolute speed of the satellites, (...), from (ω2 − ωH)/(ω1 − ωH) = ∓z1/z2."""
    return speed_carrier - scheme.rows[0] * (z[0] / z[1]) * (speed1 - speed_carrier)


@dataclass(frozen=True, eq=False)
class Flow:
    """Where the power goes. Torques from outside for wheel 1's of size 1, with losses, and the efficiency.

    `exponent`: +1 where in the stopped-carrier frame wheel 1 drives wheel 3, so that u·η_H stands for u, −1 where
    wheel 3 drives, and u/η_H does. `efficiency` is ≤ 0 where the stage locks itself.
    """

    torque: dict[Member, Array]
    exponent: Array
    efficiency: Array


def power_flow(basic: Array, eta: Array, input: Member, output: Member) -> Flow:
    """Torques and efficiency for η_H of the stage with its carrier stopped, (...); Kudryavtsev, ch. 3.

    The way of the power is that of the train without losses.
    """
    held = next(member for member in MEMBERS if member not in (input, output))
    u, speed = np.asarray(basic, dtype=float), relative_speeds(basic, input, held)
    sign = np.sign(_torques(u)[input])  # the input speed is 1: its torque is made positive
    exponent = np.sign(sign * (speed["wheel1"] - speed["carrier"]))
    lossy = _torques(u * np.asarray(eta, dtype=float) ** exponent)
    efficiency = -lossy[output] * speed[output] / lossy[input]
    return Flow({member: sign * torque for member, torque in lossy.items()}, exponent, efficiency)


def _torques(u: Array) -> dict[Member, Array]:
    """M1 = 1, M3 = −u M1 by the power in the stopped-carrier frame, MH = −M1 − M3."""
    return {"wheel1": np.ones_like(u), "wheel3": -u, "carrier": u - 1}


# --- sizes


@dataclass(frozen=True, eq=False)
class Sizes:
    """Sizes of a stage, m: rows (2, ...), wheels (4, ...) in the order z1, z2, z2', z3.

    `pitch_distances`: m (z1 ± z2)/2 of each row; `centre_distance` (...): the larger of them, to which the other
    row is opened by profile shift. `shift_sums`: x1 + x2, or x_ring − x_satellite, of each row. `tip`: tip diameters of
    full height; `trimmed`: those of rings cut down where they would touch the fillets of the satellites.
    """

    pitch_distances: Array
    centre_distance: Array
    angles: Array
    shift_sums: Array
    shifts: Array
    pitch: Array
    base: Array
    working: Array
    tip: Array
    root: Array
    trimmed: Array

    def at(self, chosen: Array) -> Sizes:
        """The sizes of some of the stages, by index or mask of the last axis."""
        return Sizes(*(getattr(self, field.name)[..., chosen] for field in fields(self)))

    @property
    def diameters(self) -> dict[str, Array]:
        """The diameters as they are cut, by the keys of `wheels.Wheels`."""
        return {
            "d": self.pitch, "d_b": self.base, "d_w": self.working, "d_f": self.root, "d_a": self.trimmed
        }  # fmt: skip

    @cached_property
    def largest_satellite(self) -> Array:
        """Tip diameter of the larger crown, (...)."""
        return np.maximum(self.tip[1], self.tip[2])

    @cached_property
    def overall(self) -> Array:
        """Diameter of what the stage fills, (...): rings to their roots, suns and satellites to their tips."""
        outer = np.maximum(self.tip, self.root)
        across = 2 * self.centre_distance + self.largest_satellite
        return np.maximum(across, np.maximum(outer[0], outer[3]))


def teeth_sums(scheme: Scheme, z: Array) -> Array:
    """z1 ± z2 and z3 ± z2', minus for an internal mesh, (2, ...)."""
    return np.stack([z[0] + scheme.rows[0] * z[1], z[3] + scheme.rows[1] * z[2]])


def sizes(
    scheme: Scheme,
    modules: tuple[float, float],
    rack: Rack,
    z: Array,
    distance: float | None = None,
    stated: Sequence[float] | None = None,
) -> Sizes:
    """All sizes for teeth (4, ...) whose sums are positive; `modules` of the rows, m. `distance`: the centre distance
    where it is stated, m; `stated`: shift coefficients x1, x2, x2', x3, those of the central wheels nan where they
    follow from the distance.

    The row of the smaller pitch centre distance is shifted; an external mesh halves the sum of its coefficients,
    in an internal one the ring takes the difference. The rack cuts the involute of a satellite down to the radius of
    curvature ρ_l = r sin α − (ha* − x) m/sin α, and no tip of a ring may go deeper (Litvin, Gear geometry, ch. 11).
    """
    z = np.asarray(z)
    module = np.array(modules).reshape(2, *[1] * (z.ndim - 1))
    sums = teeth_sums(scheme, z)
    distances = module * sums / 2
    common = distances.max(axis=0) if distance is None else np.full(distances.shape[1:], distance)
    opened = np.abs(distances - common) > 1e-12 * common  # else the pitch circles roll, to the last digit
    angles = np.where(opened, arccos(np.cos(rack.alpha) * distances / common), rack.alpha)
    shift_sums = np.zeros(sums.shape)
    involute = inv(angles[opened]) - inv(rack.alpha)
    shift_sums[opened] = sums[opened] * involute / (2 * np.tan(rack.alpha))
    shifts = _shifts(scheme, shift_sums, stated)
    if stated is not None:
        shift_sums = _sums_of(scheme, shifts)
    shortening = shift_sums - (common - distances) / module
    of = np.repeat(module, 2, axis=0)
    pitch, stretch = of * z, np.repeat(common / distances, 2, axis=0)
    # + where the tip is outside the pitch circle, − in a ring
    out = np.array(kinds(scheme)).reshape(4, *[1] * (z.ndim - 1))
    cut = _shortening(scheme, shortening)
    tip = pitch + 2 * of * (out * rack.ha + shifts - cut)
    roots = pitch - 2 * of * (out * (rack.ha + rack.c) - shifts)
    base, working = pitch * np.cos(rack.alpha), pitch * stretch
    found = Sizes(distances, common, angles, shift_sums, shifts, pitch, base, working, tip, roots, tip)
    return replace(found, trimmed=_trimmed(scheme, found, of, rack))


def _trimmed(scheme: Scheme, found: Sizes, modules: Array, rack: Rack) -> Array:
    """Tip diameters (4, ...), those of rings no smaller than where they would touch the fillets of the satellites."""
    trimmed = found.tip.copy()
    for row, (ring, satellite) in enumerate(ROWS):
        if scheme.rows[row] == INTERNAL:
            start = involute_start(found.pitch[satellite], modules[satellite], found.shifts[satellite], rack)
            line = found.centre_distance * np.sin(found.angles[row])
            clear = 2 * clear_ring_tip(found.base[ring] / 2, line, start)
            trimmed[ring] = np.maximum(found.tip[ring], clear)
    return trimmed


def _shifts(scheme: Scheme, sums: Array, stated: Sequence[float] | None) -> Array:
    """Coefficients x1, x2, x2', x3 from the sums of the rows (2, ...), but for those that are stated."""
    satellite = [
        np.where(row == EXTERNAL, total / 2, 0.0) for row, total in zip(scheme.rows, sums, strict=True)
    ]
    if scheme.single:
        satellite[1] = satellite[0]
    if stated is not None:
        satellite = [np.full(sums.shape[1:], x) for x in stated[1:3]]
    central = [
        total - satellite[k] if row == EXTERNAL else total + satellite[k]
        for k, (row, total) in enumerate(zip(scheme.rows, sums, strict=True))
    ]
    if stated is not None:
        central = [
            found if np.isnan(x) else np.full(sums.shape[1:], x)
            for found, x in zip(central, (stated[0], stated[3]), strict=True)
        ]
    return np.stack([central[0], satellite[0], satellite[1], central[1]])


def _sums_of(scheme: Scheme, shifts: Array) -> Array:
    """x1 + x2, or x_ring − x_satellite, of each row, (2, ...)."""
    return np.stack(
        [shifts[central] + scheme.rows[k] * shifts[crown] for k, (central, crown) in enumerate(ROWS)]
    )


def _shortening(scheme: Scheme, rows: Array) -> Array:
    """Tip shortening Δy of each wheel: both wheels of an external mesh keep the radial clearance by it."""
    first, second = (
        rows[k] if row == EXTERNAL else np.zeros_like(rows[k]) for k, row in enumerate(scheme.rows)
    )
    return np.stack([first, first, first if scheme.single else second, second])


# --- conditions


def least_teeth(rack: Rack, shift: Array) -> Array:
    """Least teeth that the rack does not undercut, (...): `wheels.least_teeth` by 1 − x."""
    return wheels.least_teeth(rack) * (1 - shift)


@dataclass(frozen=True, eq=False)
class Internal:
    """Margins of an internal pair, (...): the condition holds where they are positive.

    `trimming`, m: radius of curvature of the ring's tip less a_w sin α_w, the distance between the limit points of
    the line of action. `tips`, rad of the ring: how far the satellite's tip has cleared the ring's where the tip
    circles cross (`spur.fouling`). Both are nan where the ring's tips are inside its base circle.
    """

    trimming: Array
    tips: Array

    @property
    def free(self) -> Array:
        return (self.trimming >= 0) & (self.tips >= 0)  # nan is not free


def internal_pair(scheme: Scheme, found: Sizes, z: Array, row: int) -> Internal:
    """Interference in a row with a ring; Litvin, Gear geometry, ch. 11 (the same as GOST 19274-73)."""
    ring, satellite = ROWS[row]
    distance, alpha_w = found.centre_distance, found.angles[row]
    angles = [arccos(found.base[i] / found.tip[i]) for i in (satellite, ring)]
    tips = fouling(
        (z[satellite], z[ring]), (found.tip[satellite] / 2, found.tip[ring] / 2), (angles[0], angles[1]),
        distance, alpha_w,
    )  # fmt: skip
    curvature = root(found.tip[ring] ** 2 - found.base[ring] ** 2) / 2
    return Internal(curvature - distance * np.sin(alpha_w), tips)


def radial_pair(scheme: Scheme, found: Sizes, z: Array, row: int) -> Array:
    """Gap between the corners of a satellite and its ring as it is put in radially, rad of the ring."""
    ring, satellite = ROWS[row]
    tips = found.tip[satellite] / 2, found.trimmed[ring] / 2
    angles = arccos(found.base[satellite] / (2 * tips[0])), arccos(found.base[ring] / (2 * tips[1]))
    return radial((z[satellite], z[ring]), tips, angles, found.centre_distance, found.angles[row])


def contact_ratio(scheme: Scheme, found: Sizes, z: Array, row: int) -> Array:
    """Contact ratio of a row, (...): its tips over its operating angle, the ring's counted off."""
    central, satellite = ROWS[row]
    with np.errstate(invalid="ignore"):  # tips inside the base circle: nan
        beyond = np.sqrt(found.trimmed**2 - found.base**2) / found.base - np.tan(found.angles[row])
    path = z[satellite] * beyond[satellite] + scheme.rows[row] * z[central] * beyond[central]
    return path / (2 * np.pi)


def neighbourhood_gap(found: Sizes, k: Array) -> Array:
    """Free space between neighbouring satellites, m, (...): 2 a_w sin(π/k) − d_a."""
    return 2 * found.centre_distance * np.sin(np.pi / k) - found.largest_satellite


def assembly_number(scheme: Scheme, z: Array, k: Array) -> Array:
    """(z1 z2' − s z2 z3)/(k gcd(z2, z2')), s the sign of u: whole where k equal satellites can be put in, (...).

    Necessary and sufficient (Müller, Epicyclic drive trains, ch. 5); in a single row (z1 + z3)/k. The course's
    z1 u1H (1 + k p)/k with a whole p is sufficient only.
    """
    z = np.asarray(z, dtype=np.int64)
    numerator = z[0] * z[2] - scheme.rows[0] * scheme.rows[1] * z[1] * z[3]
    return np.abs(numerator) / (k * np.gcd(z[1], z[2]))


def carrier_turns(scheme: Scheme, z: Sequence[int], k: int) -> int | None:
    """Least whole p for which the course's C = z1 u1H (1 + k p)/k is whole, of one stage; None: there is none."""
    z1, z2, z2_, z3 = (int(teeth) for teeth in z)
    numerator = z1 * z2_ - scheme.rows[0] * scheme.rows[1] * z2 * z3
    period = z2_ // int(np.gcd(numerator, z2_))
    return next((p for p in range(period) if numerator * (1 + k * p) % (k * z2_) == 0), None)


def assembles(scheme: Scheme, z: Array, k: Array) -> Array:
    """Whether k satellites at equal angles can be put in, (...)."""
    number = assembly_number(scheme, z, k)
    return np.abs(number - np.round(number)) < 1e-9
