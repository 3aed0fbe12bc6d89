"""The program's answer to a drawn mechanism, held against the search."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from time import perf_counter
from typing import Any

import numpy as np

from benchmarks.random_groups.behind import gaps_behind
from benchmarks.random_groups.cusp import cusp
from benchmarks.random_groups.draw import Batch
from benchmarks.random_groups.schemes import places
from benchmarks.random_groups.search import COUNT, TURN, Interval, Truth
from tmm_report.chapters.lever.kinematics.checks.open_cycle import gaps
from tmm_report.loading import loads
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import ProblemError

Array = Any
CLOSES = 1e-9  # of the largest length
ON_BRANCH = 1e-6  # of the largest length: nearer than any other assembly that is not undecidable
SINGULAR = 3e-5  # a position 0 nearer to singular than that may be refused
Missing = tuple[tuple[Interval, Interval], ...]  # gaps, each with what its ends may be off by, rad
BESIDE = (1e-9, 1e-7, 1e-5, 1e-3, 1e-2)  # rad within a limit, where the mechanism must exist and close


@dataclass(frozen=True, eq=False)
class Answer:
    """What the program says of one mechanism. Angles turned from position 0, rad."""

    cycle: Cycle | None
    gaps: tuple[Interval, ...] = ()
    motion: Motion | None = None
    told: bool = False  # that a turn does not bring back the assembly
    error: str = ""
    seconds: float = 0.0


@dataclass(frozen=True)
class Verdict:
    """How right an answer is: names of what is wrong, and the measures."""

    family: str
    lane: int
    kind: str  # full turn, does not return, gap, no way back, undecided
    wrong: tuple[str, ...] = ()
    residual: float = 0.0  # of the largest length
    strays: float = 0.0
    end: float = 0.0  # error of the gap's ends, rad
    width: float = np.nan
    seconds: float = 0.0
    note: str = field(default="")


def asked(text: str) -> Answer:
    """Ask the program: the variant read, assembled, followed, and solved at equal steps of a turn."""
    begin = perf_counter()
    try:
        variant = loads(text)
        assert variant.lever is not None
        cycle = cycle_of(assemble(variant.lever.mechanism))
        found = _joined(interval for gap in gaps(cycle) for interval in gap.intervals)
        motion = cycle.motion(cycle.turned(COUNT))
        told = _told(cycle)
    except ProblemError as refused:
        return Answer(
            None, error=f"refused: {refused.problems[0].wrong.text}", seconds=perf_counter() - begin
        )
    except Exception as crash:  # a crash is an answer too, and a wrong one
        return Answer(None, error=f"{type(crash).__name__}: {crash}", seconds=perf_counter() - begin)
    return Answer(cycle, found, motion, told, seconds=perf_counter() - begin)


def _joined(intervals: Iterable[Interval]) -> tuple[Interval, ...]:
    """Intervals of all groups, those that touch or overlap as one."""
    found: list[Interval] = []
    for first, last in sorted(intervals):
        if found and first <= found[-1][1] + 2e-9:
            found[-1] = found[-1][0], max(found[-1][1], last)
        else:
            found.append((first, last))
    return tuple(found)


def _told(cycle: Cycle) -> bool:
    """Whether the program says that the assembly of position 0 does not come back after a turn."""
    runs = [getattr(critical, "run", None) for critical in cycle.critical]
    return any(run is not None and not run.returns for run in runs)


def judged(batch: Batch, truth: Truth, lane: int, answer: Answer) -> Verdict:
    """Everything that is wrong with an answer."""
    missing = expected(batch, truth, lane)
    kind = kind_of(truth, lane) if missing is not None else "undecided"
    width = min((last - first for (first, last), _ in missing or ()), default=np.nan)
    if answer.cycle is None or answer.motion is None:
        fair = kind == "undecided" and answer.error.startswith("refused")
        return Verdict(
            batch.family,
            lane,
            kind,
            () if fair else ("no answer",),
            width=width,
            seconds=answer.seconds,
            note=answer.error,
        )
    size = float(batch.size[lane])
    residual, end, strays = _unclosed(answer.motion) / size, 0.0, 0.0
    wrong = ["unclosed"] * bool(residual > CLOSES)
    if missing is not None and kind != "undecided":
        named, end = _gaps_wrong(missing, answer.gaps)
        strays = _strays(batch, truth, lane, answer.motion)
        wrong += [*named, *["another branch"] * bool(strays > ON_BRANCH)]
        wrong += _missing(missing, answer.motion)
        wrong += _beside(missing, answer.cycle, size)
        wrong += ["no return untold"] * bool(kind == "no return" and not answer.told)
        wrong += ["falsely told"] * bool(kind != "no return" and answer.told)
    text = f"right {_text([gap for gap, _ in missing or ()])}, said {_text(answer.gaps)}" if wrong else ""
    names = tuple(dict.fromkeys(wrong))
    return Verdict(batch.family, lane, kind, names, residual, strays, end, width, answer.seconds, text)


def expected(batch: Batch, truth: Truth, lane: int) -> Missing | None:
    """Where the mechanism does not exist, and by what rounding may alter each end; None where that is not decided."""
    eq, sense = batch.of(np.array([lane])).equations, float(batch.sense[lane])
    runs = (truth.forward, sense), (truth.backward, -sense)
    least = np.linalg.svd(eq.rates(batch.start[[lane]])[0, :, 1:], compute_uv=False)[-1]
    if truth.undecided[lane] or least < SINGULAR or any(cusp(eq, run, lane, way) for run, way in runs):
        return None
    gap = truth.gap(lane)
    own = [] if gap is None else [(gap, truth.allowed(lane))]
    if batch.scheme != "RRRD":
        return tuple(own)
    limits = np.stack([truth.forward.at[lane], truth.backward.at[lane]])
    behind = gaps_behind(batch, lane, truth.path(lane), limits)
    if behind is None:
        return None
    every = _joined([*behind, *(gap for gap, _ in own)])
    ends = dict.fromkeys((end for interval in every for end in interval), 1e-9)
    ends |= {end: allowed for interval, pair in own for end, allowed in zip(interval, pair, strict=True)}
    return tuple(((first, last), (ends[first], ends[last])) for first, last in every)


def kind_of(truth: Truth, lane: int) -> str:
    if truth.undecided[lane]:
        return "undecided"
    if truth.whole[lane]:
        return "full turn" if truth.returns[lane] else "no return"
    return "no way back" if truth.overlaps[lane] else "gap"


def _text(intervals: Any) -> str:
    return ", ".join(f"{np.degrees(a):.9g}..{np.degrees(b):.9g}" for a, b in intervals) or "all round"


def _gaps_wrong(missing: Missing, said: tuple[Interval, ...]) -> tuple[list[str], float]:
    if len(said) != len(missing):
        return ["false gap" if len(said) > len(missing) else "missed gap"], 0.0
    wrong, worst = [], 0.0
    for (right, allowed), found in zip(missing, said, strict=True):
        for a, b, least in zip(right, found, allowed, strict=True):
            wrong += ["wrong gap"] * bool(abs(a - b) > 1e-3) + ["end off"] * bool(least < abs(a - b) <= 1e-3)
            worst = max(worst, abs(a - b))
    return wrong[:1], worst


def _unclosed(motion: Motion) -> float:
    """Greatest distance between two links in one joint, or off a guide, where the mechanism is said to close, m."""
    s, made, worst = motion.state, motion.linkage.mechanism, 0.0
    with np.errstate(invalid="ignore"):
        for point in made.point_names:
            at = [s.world(link, made.links[link].points[point]) for link in made.links_at(point)]
            worst = max(worst, *(float(np.nanmax(np.abs(place - at[0]), initial=0.0)) for place in at))
        for slide in made.slides:
            guide = made.guides[slide.guide]
            t = s.u[guide.link] * guide.direction
            gap = s.world(slide.link, slide.through) - s.world(guide.link, guide.through)
            worst = max(worst, float(np.nanmax(np.abs((np.conj(t) * gap).imag), initial=0.0)))
        return max(worst, *(float(np.nanmax(np.abs(np.abs(u) - 1), initial=0.0)) for u in s.u.values()))


def _strays(batch: Batch, truth: Truth, lane: int, motion: Motion) -> float:
    """How far any joint lies from where it is on the branch, of the size."""
    one = batch.of(np.array([lane]))
    right = places(one.scheme, one.numbers, one.size, truth.path(lane)[None, :COUNT])
    at = [
        np.abs(motion.place(point) - place[0])
        for point, place in right.items()
        if point in motion.point_index
    ]
    return float(np.nanmax(at, initial=0.0) / one.size[0])


def _missing(missing: Missing, motion: Motion) -> list[str]:
    """Positions that are null and exist, or are printed and do not."""
    turned = np.arange(COUNT) * (TURN / COUNT)
    exists, sure = np.ones((2, COUNT), dtype=bool)
    for (first, last), allowed in missing:
        exists &= ~((turned > first) & (turned < last))
        sure &= (np.abs(turned - first) > 2 * allowed[0]) & (np.abs(turned - last) > 2 * allowed[1])
    closes = motion.closes
    named = ["null though it exists"] * bool((sure & exists & ~closes).any())
    return named + ["printed in a gap"] * bool((sure & ~exists & closes).any())


def _beside(missing: Missing, cycle: Cycle, size: float) -> list[str]:
    """Whether positions a little within the limits exist and close, and those a little beyond are null."""
    ends = [(end, out, a) for gap, pair in missing for end, out, a in zip(gap, (-1, 1), pair, strict=True)]
    steps = [(end, out * step) for end, out, allowed in ends for step in BESIDE if step > 3 * allowed]

    def lost(turned: float) -> bool:
        return any(first < turned < last for (first, last), _ in missing)

    inside = [end + step for end, step in steps if 0 <= end + step < TURN - 1e-6 and not lost(end + step)]
    beyond = [end - step for end, step in steps if lost(end - step)]
    wrong = []
    if inside:
        motion = cycle.motion(np.array(inside))
        wrong += ["null beside a limit"] * bool(not motion.closes.all())
        wrong += ["unclosed beside a limit"] * bool(_unclosed(motion) > CLOSES * size)
    if beyond:
        wrong += ["printed beyond a limit"] * bool(cycle.motion(np.array(beyond)).closes.any())
    return wrong
