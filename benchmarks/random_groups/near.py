"""Mechanisms near a tangency: one rod so long that the branch just has a limit, or just has none.

A rod is altered until one length gives a full turn and the next a limit; between them the bracket is halved a random
number of times, so that gaps, overlaps and near misses of every size from a degree to the rounding of lengths occur.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from benchmarks.random_groups.curve import at_angle
from benchmarks.random_groups.draw import Batch, draw
from benchmarks.random_groups.schemes import RODS, equations
from benchmarks.random_groups.trace import TURN, Run, trace

Array = Any
FIRST = (0.0, 0.05, -0.05, 0.12, -0.12)  # parts of the rod's length that are tried
HALVED = 6  # times with whole turns; after that only the neighbourhood of the limit is followed
STEP = TURN / 72
WINDOW = 0.2  # rad on either side
MOST = 38


def near(family: str, of: str, count: int, seed: int) -> Batch:
    """`count` mechanisms of family `of`, altered."""
    random = np.random.default_rng([seed, *family.encode()])
    found: list[Batch] = []
    total, k = 0, 0
    while total < count:
        batch = _altered(draw(of, 2 * (count - total) + 20, 7919 * seed + k), random)
        found.append(replace(batch, family=family))
        total, k = total + len(batch), k + 1
    return _together(found).of(np.arange(count))


def _together(parts: list[Batch]) -> Batch:
    numbers = {k: np.concatenate([p.numbers[k] for p in parts]) for k in parts[0].numbers}
    sense, size, start = (
        np.concatenate([getattr(p, name) for p in parts]) for name in ("sense", "size", "start")
    )
    return replace(parts[0], numbers=numbers, sense=sense, size=size, start=start)


def _altered(batch: Batch, random: np.random.Generator) -> Batch:
    """Those lanes that could be brought near a tangency, there."""
    rods = RODS[batch.scheme]
    rod = random.integers(len(rods), size=len(batch))
    made: dict[float, Batch] = {part: stretched(batch, rod, np.full(len(batch), part)) for part in FIRST}
    limits = {part: _followed(one).limit for part, one in made.items()}
    full, least, reach = (np.full(len(batch), np.nan) for _ in range(3))
    for one in sorted(FIRST, key=abs):
        for other in sorted(FIRST, key=lambda part: abs(part - one)):
            new = np.isnan(full) & np.isinf(limits[one]) & np.isfinite(limits[other])
            full[new], least[new], reach[new] = one, other, limits[other][new]
    kept = np.flatnonzero(np.isfinite(full))
    batch, rod, full, least, reach = batch.of(kept), rod[kept], full[kept], least[kept], reach[kept]
    halvings = random.integers(3, MOST + 1, size=len(batch))
    anchor = at = None
    for k in range(MOST):
        now = stretched(batch, rod, (full + least) / 2)
        if k < HALVED:
            limit = _followed(now).limit
        else:
            if anchor is None:  # the branch a little before the limit, as it is for the rod with a limit
                at = np.maximum(np.floor((reach - WINDOW) / STEP).astype(int), 0)
                path = _followed(stretched(batch, rod, least)).path
                anchor = path[np.arange(len(batch)), at]
            limit = _limit_near(now, anchor, at)
        on = halvings > k
        jams = np.isfinite(limit)
        full, least = (
            np.where(on & x, (full + least) / 2, old) for x, old in ((np.isinf(limit), full), (jams, least))
        )
        reach = np.where(on & jams, limit, reach)
    chosen = np.where(random.random(len(batch)) < 0.6, least, full)
    result = stretched(batch, rod, chosen)
    return result.of(np.flatnonzero(np.isfinite(result.start).all(axis=1)))


def stretched(batch: Batch, rod: Array, part: Array, steps: int = 12) -> Batch:
    """The mechanisms with one rod each longer by a part of it, x in position 0 followed to there; nan where lost."""
    x, before = batch.start, batch.start
    changed = batch
    for k in range(1, steps + 1):
        numbers = dict(batch.numbers)
        for n, name in enumerate(RODS[batch.scheme]):
            numbers[name] = np.where(rod == n, numbers[name] * (1 + part * (k / steps)), numbers[name])
        changed = replace(batch, numbers=numbers)
        eq = equations(batch.scheme, numbers, batch.size)
        x, before = at_angle(eq, 2 * x - before, batch.start[:, 0], 8, 0.05), x
    return replace(changed, start=x)


def _followed(batch: Batch) -> Run:
    """The run of every lane in its sense, its limit nan where it is lost; recorded every STEP."""
    good = np.flatnonzero(np.isfinite(batch.start).all(axis=1))
    one = batch.of(good)
    run = trace(one.equations, one.start, one.sense, round(TURN / STEP))
    limit = np.full(len(batch), np.nan)
    path = np.full((len(batch), *run.path.shape[1:]), np.nan)
    limit[good] = np.where(run.lost | np.isfinite(run.crossed), np.nan, run.limit)
    path[good] = run.path
    return replace(run, limit=limit, path=path)


def _limit_near(batch: Batch, anchor: Array, at: Array) -> Array:
    """Angle turned to the limit near the point `anchor`, recorded at number `at`; inf, or nan where lost."""
    eq = batch.equations
    phi = batch.start[:, 0] + batch.sense * at * STEP
    x = at_angle(eq, anchor, phi, 8, 0.05)
    good = np.flatnonzero(np.isfinite(x).all(axis=1))
    limit = np.full(len(batch), np.nan)
    run = trace(eq.of(good), x[good], batch.sense[good], 1, 2 * WINDOW)
    found = np.where(run.lost | np.isfinite(run.crossed), np.nan, run.limit)
    limit[good] = found + at[good] * STEP
    return limit
