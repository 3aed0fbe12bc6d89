"""Wear of a slider and its fixed guide: central reaction and couple, face by face, and what follows from it."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.solve.positions import Solved
from tmm_report.chapters.machine.wear import steps
from tmm_report.chapters.machine.wear.mistakes import believable, long_enough
from tmm_report.chapters.machine.wear.values import Guide
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.forces.reactions_with_friction import relative_rate
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.pairs import wear
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.symbols import Symbol
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine.wear.block import GuideModel

Array = Any
FACES = ("lower", "upper")
CAUSES = ("force", "couple")
SIDES = ("guide", "slider")
WORDS = {"lower": N_("lower"), "upper": N_("upper")}
UPRIGHT = {"lower": N_("right-hand"), "upper": N_("left-hand")}
FACED = {"lower": N_("lower face"), "upper": N_("upper face")}  # within a sentence
UPRIGHT_FACED = {"lower": N_("right-hand face"), "upper": N_("left-hand face")}


@dataclass(frozen=True, eq=False)
class Surface:
    """One face of the slider or of the guide. `pressure`, `k`, `c`: mean pressure, Pa, coefficient, 1/Pa, and depth
    of a point by its Σ R|q|Δφ, m/(N m), of the central reaction and of its couple; `work`: Σ R|q|Δφ of the points,
    N m."""

    side: str
    face: str
    pressure: tuple[float, float]
    k: tuple[float, float]
    c: tuple[float, float]
    work: tuple[Array, Array]

    @property
    def symbol(self) -> Symbol:
        """Of its wear: 1 the slider, 2 the guide; the lower face without a mark, the upper one with it."""
        return Symbol("u", ("1" if self.side == "slider" else "2") + ("" if self.face == "lower" else "'"))

    @cached_property
    def parts(self) -> tuple[Array, Array]:
        """Depths uᴿ and uᴹ of the points after all cycles, m."""
        return self.c[0] * self.work[0], self.c[1] * self.work[1]

    @cached_property
    def depth(self) -> Array:
        """u = uᴿ + uᴹ, m."""
        return self.parts[0] + self.parts[1]

    @property
    def greatest(self) -> float:
        return float(self.depth.max())

    @property
    def worst(self) -> int:
        """Number of the point worn most, from 0."""
        return int(np.argmax(self.depth))


@dataclass(frozen=True, eq=False)
class GuideFound:
    """`turned`, `travel`, `force`, `moment`, `analogue`: angle, S from the near end of the stroke, reaction of the
    guide along its normal, its moment about the slider's middle, and q = dS/dφ, (P,), at equal steps `step` over
    the cycle; `period`: of a cycle, s; `upright`: whether the faces stand right and left; `surfaces`: guide and
    slider, lower and upper; `s`: the single numbers."""

    s: Guide
    given: GuideModel
    pair: Pair
    upright: bool
    stroke: float
    period: float
    step: float
    turned: Array
    travel: Array
    force: Array
    moment: Array
    analogue: Array
    grid: wear.Grid
    surfaces: tuple[Surface, ...]

    @property
    def length(self) -> float:
        """L = S_max + l_s, m."""
        return self.stroke + self.given.length

    @property
    def path(self) -> Array:
        return np.abs(self.analogue) * self.step

    @property
    def arm(self) -> Array:
        """h, by which the reaction passes the slider's middle, m, (P,); nan where there is no reaction."""
        small = 1e-9 * np.abs(self.force).max(initial=1e-300)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.where(np.abs(self.force) > small, self.moment / self.force, np.nan)

    @property
    def couple(self) -> Array:
        """F_M, N, (P,)."""
        return wear.couple_force(self.moment, self.given.length)

    @property
    def skewest(self) -> int:
        """Position at which the couple is greatest."""
        return int(np.argmax(self.couple))

    def pressing(self, face: str, point: int) -> tuple[Array, Array]:
        """On a point of the guide: the central reaction of all points while it is pressed, and its own force of the
        couple, N, (P,)."""
        laid = wear.pressing(self.grid, np.abs(self.force), self.couple, self.force, self.moment)
        under = (self.grid.under == point).astype(float)
        even, turning = (np.sum(cause[FACES.index(face)] * under, axis=1) for cause in laid)
        return even * self.grid.covered, turning

    @property
    def skewed(self) -> bool:
        """Whether the reaction ever passes beside the middle."""
        size = np.abs(self.force).max(initial=0.0) * self.given.length
        return bool(np.abs(self.moment).max(initial=0.0) > 1e-9 * size)

    def surface(self, side: str, face: str) -> Surface:
        return next(one for one in self.surfaces if (one.side, one.face) == (side, face))

    def word(self, face: str) -> str:
        """What a face is called."""
        return (UPRIGHT if self.upright else WORDS)[face]

    def faced(self, face: str) -> str:
        """A face within a sentence."""
        return (UPRIGHT_FACED if self.upright else FACED)[face]

    @property
    def worst(self) -> Surface:
        """Of all faces the one worn most."""
        return max(self.surfaces, key=lambda one: one.greatest)

    @property
    def worst_guide(self) -> Surface:
        """Face of the guide worn most: there it is repaired first."""
        return max((one for one in self.surfaces if one.side == "guide"), key=lambda one: one.greatest)

    def volume(self, of: Surface) -> float:
        """∫ u b dx, m³: each point stands for a part of the length ΔL."""
        return float(of.depth.sum()) * self.given.width * self.grid.step

    # --- how the slider stands when it is worn

    @cached_property
    def settled(self) -> tuple[Array, Array]:
        """Displacement along the normal, m, and tilt, rad, + counter-clockwise, (P,); nan where nothing presses."""
        (down, lower), (rise, upper) = (
            wear.settling(
                self.grid, self.travel, self.surface("guide", face).depth, self.surface("slider", face).depth
            )
            for face in FACES
        )
        small = 1e-9 * np.abs(self.force).max(initial=1e-300)
        pressed = np.abs(self.force) > small
        shift = np.where(self.force > 0, -down, rise)
        tilt = np.where(self.force > 0, -lower, upper)
        return np.where(pressed, shift, np.nan), np.where(pressed, tilt, np.nan)

    # --- even wear

    @property
    def even(self) -> float:
        """Depth to which the guide's worst face would wear evenly with the same volume, m."""
        depth = self.worst_guide.depth
        return float(depth[depth > 0].mean()) if (depth > 0).any() else 0.0

    @property
    def resistance(self) -> Array:
        """Of the guide's worst face, relative to its greatest: with it the face would wear evenly, (N + 1,); nan
        where it does not wear."""
        depth = self.worst_guide.depth
        with np.errstate(invalid="ignore"):
            return np.where(depth > 0, depth / depth.max(), np.nan)

    # --- time

    @property
    def time(self) -> float:
        """Of all cycles, s."""
        return self.given.cycles * self.period

    @property
    def rate(self) -> float:
        """Of steady wear where it is greatest, m/s."""
        return self.worst.greatest / self.time

    def worn(self, time: Array) -> Array:
        """Greatest wear after a time, m: running in, then steady."""
        run = self.given.running_in
        return self.rate * time if run is None else wear.staged(time, run.wear, run.time, self.rate)

    @property
    def life(self) -> float | None:
        """Until the stated limit, s."""
        limit, run = self.given.limit, self.given.running_in
        if limit is None or not self.rate > 0:
            return None
        return wear.life(limit, self.rate, run.wear, run.time) if run else limit / self.rate


def solve(given: GuideModel, solved: Solved, cycle: Cycle, index: int) -> GuideFound:
    """Raises ProblemError: a guide that moves, several sliders, a slider that stands or is shorter than two parts of
    the guide, a wear of nothing or out of all proportion."""
    path = ("wear", "guides", index)
    pair = _pair(given, solved.motion, path)
    reaction = solved.statics.reactions[pair.key]
    sign = 1 if pair.slider == pair.links[1] else -1  # of the guide on the slider
    along = _forwards(complex(pair.along[FRAME]))
    motion = solved.motion
    stroke, near = _stroke(cycle, pair, along, path)
    travel = dot(_place(motion, pair), along) - near
    force = sign * dot(np.broadcast_to(reaction.force, motion.shape), 1j * along)
    moment = sign * np.broadcast_to(reaction.moment, motion.shape) - given.middle * force
    if not np.isfinite(force + moment).all():
        raise ProblemError([mistake(N_("the reaction of the guide is not known at every position"), path)])
    analogue = _rate(motion, pair, along) / abs(float(motion.omega))  # by the angle turned
    step = cycle.period / len(force)
    grid = wear.grid(travel, stroke, given.length, given.parts)
    long_enough(grid, given.length, path)
    period = cycle.period / abs(float(motion.omega))
    surfaces = _surfaces(given, grid, force, moment, np.abs(analogue) * step)
    believable(max(one.greatest for one in surfaces), given.length, path)
    found = GuideFound(
        Guide(prefix=f"wear_guide_{index + 1}"), given, pair, bool(abs(along.real) < 1e-9), stroke, period, step,
        solved.turned, travel, force, moment, analogue, grid, surfaces,
    )  # fmt: skip
    steps.guide(found.s, found)
    return found


def _pair(given: GuideModel, motion: Motion, path: tuple[str | int, ...]) -> Pair:
    pairs = [p for p in motion.linkage.structure.pairs if p.kind == "P" and p.name == given.guide]
    fixed = [p for p in pairs if FRAME in p.links]
    if not fixed:
        right = Message(N_("name a guide of the frame"))
        raise ProblemError(
            [mistake(N_("the guide %(name)s is not fixed"), (*path, "guide"), right, name=given.guide)]
        )
    found = [p for p in fixed if given.slider in (None, p.slider)]
    if len(found) != 1:
        raise ProblemError([_unclear(given, fixed, path)])
    return found[0]


def _unclear(given: GuideModel, pairs: list[Pair], path: tuple[str | int, ...]) -> Problem:
    links = ", ".join(str(p.slider) for p in pairs)
    text = N_("several links slide on the guide %(name)s")
    if given.slider is not None:
        text = N_("another link slides on the guide %(name)s")
    right = Message(N_("one of: %(words)s"), {"words": links})
    return mistake(text, (*path, "slider"), right, name=given.guide)


def _forwards(along: complex) -> complex:
    """To the right, or upwards where the guide stands upright: its normal then points up, or to the left."""
    if abs(along.real) < 1e-9:
        return along if along.imag > 0 else -along
    return along if along.real > 0 else -along


def _place(motion: Motion, pair: Pair) -> Array:
    slider = str(pair.slider)
    return np.broadcast_to(motion.state.world(slider, pair.at[slider]), motion.shape)


def _rate(motion: Motion, pair: Pair, along: complex) -> Array:
    """Velocity along the guide, m/s."""
    return relative_rate(motion, pair) * np.sign(dot(complex(pair.along[FRAME]), along))


def _stroke(cycle: Cycle, pair: Pair, along: complex, path: tuple[str | int, ...]) -> tuple[float, float]:
    """S_max, and the coordinate of its beginning; exact, by the roots of the velocity."""
    low, high = cycle.extremes(lambda m: dot(_place(m, pair), along), lambda m: _rate(m, pair, along))
    if not high.value - low.value > 1e-9:
        raise ProblemError([mistake(N_("the slider stands still: nothing wears"), path)])
    return float(high.value - low.value), float(low.value)


def _surfaces(
    given: GuideModel, grid: wear.Grid, force: Array, moment: Array, path: Array
) -> tuple[Surface, ...]:
    rubbed = wear.rubbed(grid, force, moment, path, given.length)
    area = given.width * given.length
    central = [wear.mean_over_path(force, path, on) / area for on in (force > 0, force < 0)]
    couple = wear.couple_force(moment, given.length)
    turning = wear.mean_over_path(couple, path, couple > 0) / (area / 2)
    found = []
    for side in SIDES:
        forces, couples = getattr(rubbed, f"{side}_force"), getattr(rubbed, f"{side}_couple")
        for n, face in enumerate(FACES):
            of = [getattr(cause, side)[n] for cause in given.faces]
            pressure = central[n], turning
            k = of[0].at(pressure[0]), of[1].at(pressure[1])
            c = given.cycles / (given.width * grid.step)
            found.append(Surface(side, face, pressure, k, (c * k[0], c * k[1]), (forces[n], couples[n])))
    return tuple(found)
