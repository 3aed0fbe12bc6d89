"""Dimensional synthesis: families of linkages that meet a demand, over their free parameter, and their extremes.

Arrays in, arrays out, m and rad: `a` crank, `b` rod (coupler), `c` rocker, `d` distance of the fixed pivots, `e` offset
of the slider's line from the crank's pivot, `theta` the angle between the two positions of the rod in the extreme
positions. nan where there is no linkage. Source: Artobolevsky, Theory of mechanisms and machines, ch. 27; Freudenstein,
Trans. ASME 77 (1955) 853.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import interpolated
from tmm_report.records import dataclass

Array = Any
GRID = 1440  # points at which a family is tried before its extremes and roots are looked for
FINER = 48  # by as many points the neighbourhood of an extreme is tried again and again
ROUNDS = 9


@dataclass(frozen=True, eq=False)
class SliderCranks:
    """Slider-cranks of one stroke and one time ratio, over the ratio of rod to crank."""

    a: Array
    b: Array
    e: Array

    @property
    def pressure(self) -> Array:
        """Greatest pressure angle over the turn, rad: where the crank stands across the slide line, on its far side."""
        sine = (self.a + np.abs(self.e)) / self.b
        return np.arcsin(np.where(sine <= 1, sine, np.nan))


def slider_cranks(stroke: float, theta: float, ratio: Array) -> SliderCranks:
    """By the triangle of the crank's pivot and the slider's two extreme places: sides b − a, b + a and the stroke, the
    angle theta between the first two. nan where the linkage would have to be assembled anew between them."""
    ratio = np.where(ratio <= most_ratio(theta), ratio, np.nan)
    a = stroke / np.sqrt((ratio - 1) ** 2 + (ratio + 1) ** 2 - 2 * (ratio**2 - 1) * np.cos(theta))
    b = ratio * a
    return SliderCranks(a, b, (b - a) * (b + a) * np.sin(theta) / stroke)


def most_ratio(theta: float) -> float:
    """Of rod to crank: beyond it the foot of the triangle's height, e from the crank's pivot, lies within the stroke,
    and the slider would be in another assembly at its near end: 4 a b < H². Inf where both strokes last equally long.
    """
    return float(1 / np.tan(theta / 2) ** 2) if theta else np.inf


@dataclass(frozen=True, eq=False)
class CrankRockers:
    """Crank-rockers of one swing and one time ratio, over the crank. `u`, `v`: the crank's pivot from the middle of the
    rocker's chord, along the chord and away from the rocker's pivot."""

    a: Array
    b: Array
    c: float
    d: Array
    u: Array
    v: Array

    @property
    def transmission(self) -> Array:
        """Least angle between rod and rocker over the turn, rad; nan where the crank cannot turn round or the linkage
        would have to be assembled anew between its extreme positions."""
        a, b, c, d = self.a, self.b, self.c, self.d
        with np.errstate(invalid="ignore", divide="ignore"):
            inner, outer = (
                np.arccos((b**2 + c**2 - side**2) / (2 * b * c)) for side in (np.abs(d - a), d + a)
            )
        return np.where(self.sound, np.minimum(inner, np.pi - outer), np.nan)

    @property
    def sound(self) -> Array:
        a, b, c, d = self.a, self.b, self.c, self.d
        sides = np.sort(np.stack(np.broadcast_arrays(b, c, d)), axis=0)
        with np.errstate(invalid="ignore"):
            turns = (a < sides[0]) & (a + sides[2] <= sides[0] + sides[1])
            return turns & self.one_assembly

    @property
    def one_assembly(self) -> Array:
        """Whether the rocker's pivot is on one side of the rod in both extreme positions."""
        half, rise = self._chord
        from_pivot = self.u + 1j * (self.v + rise)  # the rocker's pivot is the origin
        ends = np.stack([-half, half]) + 1j * rise
        side = np.imag(np.conj(ends - from_pivot) * -from_pivot)
        return side[0] * side[1] > 0

    @property
    def _chord(self) -> tuple[Array, Array]:
        half = np.sqrt(((self.b - self.a) ** 2 + (self.b + self.a) ** 2) / 2 - self.u**2 - self.v**2)
        return half, np.sqrt(self.c**2 - half**2)


def crank_rockers(theta: float, swing: float, c: float, a: Array, beyond: bool = False) -> CrankRockers:
    """By the triangle of the crank's pivot and the rocker's extreme ends: sides b − a, b + a and the chord, the angle
    theta between the first two. `beyond`: the pivot lies beyond the chord, as seen from the rocker's pivot."""
    half, rise = c * np.sin(swing / 2), c * np.cos(swing / 2)
    with np.errstate(invalid="ignore", divide="ignore"):
        b = np.sqrt(half**2 - (a * np.cos(theta / 2)) ** 2) / np.sin(theta / 2)
        u = -a * b / half
        away = np.sqrt((b - a) ** 2 - (half + u) ** 2)
    v = away if beyond else -away
    return CrankRockers(a, b, c, np.hypot(u, rise + v), u, v)


def in_step(swing: float, c: float, a: float, d: Array) -> CrankRockers:
    """Those whose strokes last equally long, over the distance of the pivots: the crank's pivot is on the chord."""
    rise = c * np.cos(swing / 2)
    u = -np.sqrt(d**2 - rise**2)
    return CrankRockers(a, -u, c, d, u, np.zeros_like(u))


# ---------------------------------------------------------------- what a linkage of given lengths does


@dataclass(frozen=True, eq=False)
class Does:
    """`travel`: stroke, m, or swing, rad; `K`: time of the slower stroke by that of the faster; `angle`: greatest
    pressure angle, or least transmission angle, rad. nan where the crank does not turn round."""

    travel: float
    K: float
    angle: float


def _time_ratio(theta: float) -> float:
    return float((np.pi + theta) / (np.pi - theta))


def slider_crank_does(a: float, b: float, e: float) -> Does:
    with np.errstate(invalid="ignore", divide="ignore"):
        far, near = np.sqrt((b + a) ** 2 - e**2), np.sqrt((b - a) ** 2 - e**2)
        theta = np.arctan2(abs(e), near) - np.arctan2(abs(e), far)
        return Does(float(far - near), _time_ratio(theta), float(np.arcsin((a + abs(e)) / b)))


def crank_rocker_does(a: float, b: float, c: float, d: float) -> Does:
    if a >= min(b, c, d):
        return Does(np.nan, np.nan, np.nan)
    with np.errstate(invalid="ignore", divide="ignore"):
        rocker = [np.arccos((d**2 + c**2 - side**2) / (2 * d * c)) for side in (b + a, b - a)]
        line = [np.arccos((d**2 + side**2 - c**2) / (2 * d * side)) for side in (b + a, b - a)]
        inner, outer = (np.arccos((b**2 + c**2 - side**2) / (2 * b * c)) for side in (abs(d - a), d + a))
        least = float(np.minimum(inner, np.pi - outer))
        return Does(float(rocker[0] - rocker[1]), _time_ratio(abs(line[0] - line[1])), least)


def slotted_link_does(a: float, d: float, length: float, line: float, b: float) -> Does:
    """`length` of the slotted link, its end moves a rod; the slide line stands `line` from the link's pivot."""
    with np.errstate(invalid="ignore", divide="ignore"):
        half = np.arcsin(a / d)
        off = max(abs(line - length), abs(line - length * np.cos(half)))
        return Does(float(2 * length * np.sin(half)), _time_ratio(2 * half), float(np.arcsin(off / b)))


def turning_guide_does(a: float, d: float, arm: float, b: float) -> Does:
    with np.errstate(invalid="ignore", divide="ignore"):
        return Does(2 * arm, float(np.pi / np.arccos(d / a) - 1), float(np.arcsin(arm / b)))


# ---------------------------------------------------------------- a function by three pairs

FUNCTIONS: dict[str, Callable[[Array], Array]] = {
    "log10": np.log10, "ln": np.log, "exp": np.exp, "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos, "tan": np.tan,
}  # fmt: skip


@dataclass(frozen=True)
class Wanted:
    """A function of x by its name, or a power of x."""

    name: str = ""
    power: float = 1.0

    def __call__(self, x: Array) -> Array:
        with np.errstate(invalid="ignore", divide="ignore", over="ignore", under="ignore"):
            return FUNCTIONS[self.name](x) if self.name else np.asarray(x, float) ** self.power

    def defined(self, low: float, high: float) -> bool:
        """Whether it is finite all over a range."""
        match self.name:
            case "log10" | "ln":
                sound = low > 0
            case "sqrt":
                sound = low >= 0
            case "tan":
                sound = np.floor(low / np.pi + 0.5) == np.floor(high / np.pi + 0.5)
            case "":
                whole = self.power == int(self.power)
                past = not low <= 0 <= high if whole else low > 0
                sound = (self.power >= 0 and (whole or low >= 0)) or past
            case _:
                sound = True
        return bool(sound) and bool(np.isfinite(self(np.array([low, high]))).all())


@dataclass(frozen=True, eq=False)
class FourBar:
    """`a`, `c`: crank and rocker, negative where they are laid off backwards; their angles are counted from the line of
    the pivots, from the crank's to the rocker's, counter-clockwise. `side`: +1 or -1, on which side of the line from
    crank pin to the rocker's pivot the joint of rod and rocker is."""

    a: float
    b: float
    c: float
    d: float
    side: int

    def rocker(self, phi: Array) -> Array:
        """Direction of the rocker, unit complex; nan where the linkage cannot be assembled."""
        pin = self.a * np.exp(1j * np.asarray(phi)) - self.d
        size = np.abs(pin)
        with np.errstate(invalid="ignore", divide="ignore"):
            cosine = (size**2 + self.c**2 - self.b**2) / (2 * size * abs(self.c))
            off = np.arccos(np.where(np.abs(cosine) <= 1, cosine, np.nan))
            found: Array = np.sign(self.c) * pin / size * np.exp(1j * self.side * off)
        return found

    def transmission(self, phi: Array) -> Array:
        """Acute angle between rod and rocker, rad."""
        end = self.d + self.c * self.rocker(phi)
        rod, rocker = end - self.a * np.exp(1j * np.asarray(phi)), end - self.d
        return np.arcsin(np.minimum(np.abs(np.imag(np.conj(rod) * rocker)) / abs(self.b * self.c), 1.0))

    def order(self, phi: Array) -> tuple[int, ...] | None:
        """In which order the crank, turning one way, comes to these angles without leaving a closed linkage; of a crank
        that turns all round that of its sense which begins with the first two. None where it does not come to all. Of
        positive lengths."""
        a, b, c, d = self.a, self.b, self.c, self.d
        most, least = (np.array([(b - c) ** 2, (b + c) ** 2]) - a**2 - d**2) / (-2 * a * d)
        inward, outward = most >= 1, least <= -1  # whether the crank may stand along the frame, either way
        turn = np.angle(np.exp(1j * np.asarray(phi, float)))
        if inward and outward:
            turn = (turn - turn[0]) % (2 * np.pi)
            turn = turn if turn[1] == turn[1:].min() else -turn % (2 * np.pi)
        elif outward:
            turn %= 2 * np.pi
        elif not inward and np.min(turn) * np.max(turn) < 0:
            return None
        return tuple(int(k) for k in np.argsort(turn))


def through_pairs(phi: Array, psi: Array, d: float) -> tuple[float, float, float]:
    """k1, k2, k3 of cos(φ − ψ) = k1 + k2 cos ψ − k3 cos φ at three pairs of angles. Raises LinAlgError where they are
    of no one linkage."""
    rows = np.stack([np.ones(3), np.cos(psi), -np.cos(phi)], axis=1)
    k1, k2, k3 = np.linalg.solve(rows, np.cos(phi - psi))
    return float(k1), float(k2), float(k3)


# ---------------------------------------------------------------- a body led from one position to another


@dataclass(frozen=True, eq=False)
class Led:
    """Four-bar linkages whose coupler comes from one position to another, over the place of the rocker's pivot.
    `transmission`: least acute angle of rod and rocker on the way, rad; nan where the linkage would have to be
    assembled anew, or its crank comes to where the links do not meet."""

    crank_pivot: complex
    rocker_pivot: Array
    transmission: Array


def led(pins: Array, ends: Array, off_crank: float, off_rocker: Array) -> Led:
    """`pins`, `ends`: both places of the pins of crank and rocker, complex, m. The pivots stand on the perpendicular
    bisectors of the ways of their pins, `off_crank` and `off_rocker` to the left of the ways; the crank turns by less
    than half a turn."""
    pivots = []
    for places, off in ((pins, off_crank), (ends, off_rocker)):
        way = places[1] - places[0]
        pivots.append((places[0] + places[1]) / 2 + 1j * way / abs(way) * off)
    crank, rocker = complex(pivots[0]), np.asarray(pivots[1])
    a, b = abs(pins[0] - crank), abs(ends[0] - pins[0])
    c, frame = np.abs(ends[0] - rocker), rocker - crank
    with np.errstate(invalid="ignore", divide="ignore"):
        first = np.angle((pins[0] - crank) / frame)
        turn = np.angle((pins[1] - crank) / (pins[0] - crank))
        # the pin is nearest to the rocker's pivot and farthest from it along the frame, else at the ends of its way
        sizes = [np.abs(place - rocker) for place in pins]
        for along, size in ((0.0, np.abs(np.abs(frame) - a)), (np.pi, np.abs(frame) + a)):
            on_way = (np.sign(turn) * (along - first)) % (2 * np.pi) < abs(turn)
            sizes.append(np.where(on_way, size, sizes[0]))
        cosines = [(b**2 + c**2 - size**2) / (2 * b * c) for size in sizes]
        angles = np.arccos(np.abs(cosines))
    side = [np.imag(np.conj(rocker - pin) * (end - pin)) for pin, end in zip(pins, ends, strict=True)]
    sound = (side[0] * side[1] > 0) & (np.abs(frame) > 1e-9 * a)
    return Led(crank, rocker, np.where(sound, np.min(angles, axis=0), np.nan))


# ---------------------------------------------------------------- two positions of a rocker or of a slider


@dataclass(frozen=True, eq=False)
class Between:
    """Crank and rod over what is free; `angle`: the least transmission angle, or the greatest pressure angle, rad; all
    nan where no linkage meets the demand."""

    a: Array
    b: Array
    angle: Array


def rockers_between(psi: tuple[float, float], c: float, d: Array) -> Between:
    """Crank-rockers whose rocker is extreme at the angles psi from the line of the pivots, the nearer to it first, over
    the distance of the pivots: in both the crank is on the line of the rod."""
    far, near = (np.abs(d + c * np.exp(1j * one)) for one in psi)
    a, b = (far - near) / 2, (far + near) / 2
    inner, outer = (np.arccos((b**2 + c**2 - side**2) / (2 * b * c)) for side in (d - a, d + a))
    return Between(a, b, np.minimum(inner, np.pi - outer))


def rockers_through(phi: tuple[float, float], psi: tuple[float, float], d: float, c: Array) -> Between:
    """Four-bar linkages at the angles phi of the crank and psi of the rocker, over the rocker: the rod is equally long
    in both."""
    over = c * d * (np.cos(psi[0]) - np.cos(psi[1]))
    under = d * (np.cos(phi[0]) - np.cos(phi[1])) + c * (np.cos(phi[0] - psi[0]) - np.cos(phi[1] - psi[1]))
    with np.errstate(divide="ignore", invalid="ignore"):
        a = over / under
    ends = [d + c * np.exp(1j * one) for one in psi]
    pins = [a * np.exp(1j * one) for one in phi]
    b = np.abs(ends[0] - pins[0])
    sides = [np.imag(np.conj(end - pin) * (d - pin)) for end, pin in zip(ends, pins, strict=True)]
    pin = a[..., None] * np.exp(1j * _way(phi))
    size, long = np.abs(pin - d), c[..., None]
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (b[..., None] ** 2 + long**2 - size**2) / (2 * b[..., None] * long)
    meets = (np.abs(cosine) < 1).all(axis=-1)
    angle = np.arccos(np.minimum(np.abs(cosine).max(axis=-1), 1.0))
    return _met((a > 0) & (b > 0) & (sides[0] * sides[1] > 0) & meets, a, b, angle)


def sliders_through(phi: tuple[float, float], x: tuple[float, float], e: Array) -> Between:
    """Slider-cranks at the angles phi of the crank and the places x of the slider, over the offset; the slide line is
    below the crank's pivot."""
    under = x[0] * np.cos(phi[0]) - x[1] * np.cos(phi[1]) - e * (np.sin(phi[0]) - np.sin(phi[1]))
    with np.errstate(divide="ignore", invalid="ignore"):
        a = (x[0] ** 2 - x[1] ** 2) / (2 * under)
    b = np.abs(x[0] - 1j * e - a * np.exp(1j * phi[0]))
    ahead = [x[k] - a * np.cos(phi[k]) for k in (0, 1)]
    with np.errstate(divide="ignore", invalid="ignore"):
        sine = np.abs(e[..., None] + a[..., None] * np.sin(_way(phi))) / b[..., None]
    most = sine.max(axis=-1)
    sound = (a > 0) & (b > 0) & (ahead[0] * ahead[1] > 0) & (most < 1)
    return _met(sound, a, b, np.arcsin(np.minimum(most, 1.0)))


WAY = 720  # steps of the way of a crank between two positions


def _way(phi: tuple[float, float]) -> Array:
    """Angles of the crank from the first position to the second, with those at which it lies along or across the frame,
    where the angle of transmission or pressure is extreme."""
    low, high = min(phi), max(phi)
    quarters = np.arange(np.ceil(low / (np.pi / 2)), np.floor(high / (np.pi / 2)) + 1) * (np.pi / 2)
    return np.concatenate([np.linspace(*phi, WAY + 1), quarters])


def _met(sound: Array, *parts: Array) -> Between:
    return Between(*(np.where(sound, one, np.nan) for one in parts))


# ---------------------------------------------------------------- extremes and roots over a parameter


def least(f: Callable[[Array], Array], low: float, high: float) -> tuple[float, float]:
    """Where a function of arrays is least between two ends, and its value there; what is nan is not looked at. By a
    grid, then by ever finer ones about its lowest point. Raises ValueError where it is nan everywhere."""
    x = np.linspace(low, high, GRID + 1)
    for _ in range(ROUNDS):
        y = f(x)
        k = int(np.nanargmin(y))
        best = float(x[k]), float(y[k])
        x = np.linspace(x[max(k - 1, 0)], x[min(k + 1, len(x) - 1)], FINER + 1)
    return best


def roots(f: Callable[[Array], Array], low: float, high: float) -> Array:
    """All roots that a grid of the range parts, ascending."""
    x = np.linspace(low, high, GRID + 1)
    y = f(x)
    with np.errstate(invalid="ignore"):
        at = np.flatnonzero(y[:-1] * y[1:] <= 0)
    at = at[y[at] != 0] if at.size else at
    exact = x[y == 0]
    if not at.size:
        return exact
    found = interpolated(f, x[at], x[at + 1], y[at], np.zeros(at.size))[0]
    return np.unique(np.concatenate([exact, found]))


def circle(points: Array) -> tuple[complex, float]:
    """Centre and radius of the circle through three points, complex, m. Raises ZeroDivisionError where they lie on one
    line."""
    a, b, c = (complex(point) for point in points)
    one, other = b - a, c - a
    area = (one.conjugate() * other).imag
    if abs(area) <= 1e-12 * abs(one) * abs(other):
        raise ZeroDivisionError
    away = 1j * (abs(one) ** 2 * other - abs(other) ** 2 * one) / (2 * area)
    return a - away, abs(away)
