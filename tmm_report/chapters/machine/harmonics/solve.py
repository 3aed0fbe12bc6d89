"""Chapter of harmonics: the motion of the outputs and of points by orders of the driving link's turn, and the wave that
runs along a link when it moves.

    x(ξ, φ) = x_P + ξ (x_Q − x_P):  each harmonic of a place between two joints is between those of the joints
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Output
from tmm_report.chapters.machine.harmonics import values
from tmm_report.chapters.machine.harmonics.given import Given
from tmm_report.chapters.machine.harmonics.values import Values
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.calculus.harmonics import Series
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.lever.vector_equations import moving_points, turning_links
from tmm_report.mechanics.masses.counterweights import pivoted
from tmm_report.mechanics.masses.slider_harmonics import SliderCrank, slider_cranks
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import Amount
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "solve"]

Array = Any
NOISE = 1e-11  # of its natural size: a motion that is rounding
TURNS = Message(N_("a mechanism that turns all round, or take this block out"))
BROKEN = N_(
    "the motion has a break within the turn: in some position the links can turn over, two motions meet there"
)


@dataclass(frozen=True, eq=False)
class Signal:
    """One number of the motion over the turn, `of` what: a `kind` "S", "V", "a" of an output (m or rad), "x", "y" of a
    point; `samples` (N,) at equal steps from position 0; `left`: greatest difference from the sum of the orders found,
    by the greatest difference from the mean."""

    kind: str
    name: str
    of: Quantity
    samples: Array
    series: Series
    left: float


@dataclass(frozen=True, eq=False)
class Wave:
    """Along a link from joint `start` to joint `end`: `places` (2, N), complex m, of both; `x`, `y`: harmonics at the
    parts `xi` (M,) of the way, (M, K+1); `check`: of the rod of a slider-crank, worst difference of the amplitudes from
    its closed formulas, by the crank's radius; None of other links."""

    link: str
    start: str
    end: str
    places: Array
    xi: Array
    x: Series
    y: Series
    crank: SliderCrank | None = None
    check: float | None = None


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `turned`: angles of the samples, rad, (N,)."""

    given: Given
    kinematics: Kinematics
    s: Values
    signals: tuple[Signal, ...]
    waves: tuple[Wave, ...]
    turned: Array = field(repr=False)

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        if self.signals:
            worst = max(100 * signal.left for signal in self.signals)
            text = N_("harmonics up to order %(order)s leave at most %(left)s %% of a motion")
            yield Message(text, {"order": self.given.highest, "left": Amount(worst, 3)})


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism. Raises ProblemError where the driving link makes no full turn, or where a
    link has no two points."""
    if moving is None:
        raise ProblemError([mistake(N_("there is no mechanism that moves"), ("harmonics",))])
    found = moving.kinematics
    motion, turned, tail = _sampled(found)
    s = Values()
    s.samples, s.tail = len(turned), tail
    signals, waves = _signals(given, found, motion), _waves(given, found, motion)
    return Found(given, found, s, tuple(signals), tuple(waves), turned)


def _sampled(found: Kinematics) -> tuple[Motion, Array, float]:
    """The motion at so many equal steps of a turn that what they miss of the places is rounding."""
    cycle = found.cycle
    centres = {
        cam.centre for cam in found.linkage.mechanism.cams
    }  # of curvature: places that jump along the cam
    points = [point for point in moving_points(found.linkage) if point not in centres]
    motions: dict[int, Motion] = {}

    def places(count: int) -> Array:
        motions[count] = cycle.motion(np.arange(count) * (2 * np.pi / count))
        if not (cycle.closed and motions[count].closes.all()):
            text = N_("the driving link makes no full turn: its motion has no harmonics")
            raise ProblemError([mistake(text, ("harmonics",), TURNS)])
        return np.array([motions[count].place(point) for point in points])

    count, tail = fourier.enough(places)
    if tail > fourier.BROKEN:
        raise ProblemError([mistake(BROKEN, ("harmonics",), TURNS)])
    return motions[count], np.arange(count) * (2 * np.pi / count), tail


# ---------------------------------------------------------------- outputs and points


def _signals(given: Given, found: Kinematics, motion: Motion) -> Iterator[Signal]:
    size, omega = float(np.ptp(np.abs(motion.places))), abs(found.omega)
    for travel in found.travels:
        output = travel.output
        for kind, samples in _rates(output, motion):
            scale = (1.0 if output.kind == "rocker" else size) * omega ** "SVa".index(kind)
            of = values.rate(kind, output)
            yield _signal(kind, output.name, of, _settled(samples, scale), given.highest)
    for point in dict.fromkeys(given.points):
        place = motion.place(point)
        for axis, samples in (("x", place.real), ("y", place.imag)):
            of = values.place(axis, point)
            yield _signal(axis, point, of, _settled(samples, size), given.highest)


def _settled(samples: Array, scale: float) -> Array:
    """Without the rounding of what stays the same, beside the natural size of its kind."""
    mean = samples.mean()
    return np.full(samples.shape, mean) if np.abs(samples - mean).max() <= NOISE * scale else samples


def _rates(output: Output, motion: Motion) -> Iterator[tuple[str, Array]]:
    """Displacement from position 0, velocity, acceleration; of a link that turns right round no displacement."""
    travelled, velocity, acceleration = output.rates(motion)
    if output.kind == "rocker":
        round_ = np.unwrap(np.append(travelled, travelled[0]))
        travelled = round_[:-1] if abs(round_[-1] - round_[0]) < 1.0 else None
    if travelled is not None:
        yield "S", travelled - travelled[0]
    yield "V", velocity
    yield "a", acceleration


def _signal(kind: str, name: str, of: Quantity, samples: Array, highest: int) -> Signal:
    series = fourier.series(samples, highest)
    theta = np.arange(len(samples)) * (2 * np.pi / len(samples))
    swing = np.abs(samples - series.cosine[0]).max()
    left = np.abs(samples - series.at(theta)).max()
    still = swing <= NOISE * np.abs(samples).max()
    if still:
        series = Series(np.where(np.arange(highest + 1) > 0, 0.0, series.cosine), 0 * series.sine)
    return Signal(kind, name, of, samples, series, 0.0 if still else float(left / swing))


# ---------------------------------------------------------------- waves along links


def _waves(given: Given, found: Kinematics, motion: Motion) -> Iterator[Wave]:
    linkage = found.linkage
    cranks = {crank.rod: crank for crank in slider_cranks(linkage, found.cycle, {})}
    for link in _links(given, linkage):
        ends = _ends(linkage, link)
        if ends is None:
            text = N_(
                "link %(name)s has less than two points: there is no line along which a wave could be followed"
            )
            raise ProblemError([mistake(text, ("harmonics", "links"), name=link)])
        yield _wave(given, link, ends, motion, cranks.get(link))


def _links(given: Given, linkage: Linkage) -> Iterator[str]:
    if given.links is not None:
        yield from dict.fromkeys(given.links)
        return
    fixed, turning = pivoted(linkage.structure.pairs), turning_links(linkage)
    for name in linkage.mechanism.real.moving:
        if name in turning and name not in fixed and _ends(linkage, name) is not None:
            yield name


def _ends(linkage: Linkage, link: str) -> tuple[str, str] | None:
    """The first two joints of a link, else its first two points."""
    points: Mapping[str, Any] = linkage.mechanism.links[link].points
    joints = [p for p in points if len(linkage.mechanism.links_at(p)) > 1]
    first, *others = (*joints, *(p for p in points if p not in joints)) or ("",)
    apart = [p for p in others if abs(points[p] - points[first]) > 1e-12]
    return (first, apart[0]) if apart else None


def _wave(given: Given, link: str, ends: tuple[str, str], motion: Motion, crank: SliderCrank | None) -> Wave:
    places = np.array([motion.place(point) for point in ends])
    xi = np.linspace(0.0, 1.0, given.steps + 1)
    along = places[0] + xi[:, None] * (places[1] - places[0])
    x, y = (fourier.series(part, given.highest) for part in (along.real, along.imag))
    if crank is None or (crank.pin, crank.joint) != ends:
        return Wave(link, *ends, places, xi, x, y)
    return Wave(
        link, *ends, places, xi, x, y, crank, _against_formulas(crank, along, xi, given.highest, motion)
    )


def _against_formulas(crank: SliderCrank, along: Array, xi: Array, highest: int, motion: Motion) -> float:
    """In the axes of the guide: x = r cos φ + ξ √(l² − (r sin φ − e)²), y = (1 − ξ) r sin φ + ξ e."""
    pivot = motion.linkage.structure.driver_pair.at[FRAME]
    own = (along - pivot) / crank.along
    exact = [fourier.series(part, highest).amplitude[:, 1:] for part in (own.real, own.imag)]
    orders = np.arange(1, highest + 1)
    first = np.where(orders == 1, 1.0, 0.0)
    known = min(highest, len(crank.harmonics.cosine) - 1)
    cosine = crank.harmonics.cosine[1 : known + 1] / orders[:known] ** 2 - first[:known]
    sine = crank.harmonics.sine[1 : known + 1] / orders[:known] ** 2
    of_rod = crank.r * np.hypot(first[:known] + xi[:, None] * cosine, xi[:, None] * sine)
    across = crank.r * (1 - xi[:, None]) * first
    misses = np.abs(exact[0][:, :known] - of_rod).max(), np.abs(exact[1] - across).max()
    return float(max(misses) / crank.r)
