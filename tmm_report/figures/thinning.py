"""Curves with no more points than a pen shows: one computed at hundreds of places is drawn by those it bends at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import compress

import numpy as np

from tmm_report.figures.primitives import Item, Path

APART = 0.005  # mm: half of a hundredth, to which drawings are read; a line is drawn 0.2 mm wide
SHORT = 40  # points: a stroke of no more, as a diagram at its positions has them, stays as it is
PIECE = 16  # steps of a stroke, a power of two, that one straight line may stand for


def thinned(items: Sequence[Item]) -> Sequence[Item]:
    """The items with long strokes drawn through fewer of their own points, nowhere further than APART from the rest."""
    held = [(stroke, item.held) for item in items if isinstance(item, Path) for stroke in _long(item)]
    if not held:
        return items
    stays = iter(_kept([stroke for stroke, _ in held], [places for _, places in held]))
    return [
        replace(
            item,
            strokes=tuple(tuple(compress(s, next(stays))) if len(s) > SHORT else s for s in item.strokes),
        )
        if isinstance(item, Path) and _long(item)
        else item
        for item in items
    ]


def _long(path: Path) -> list[tuple[complex, ...]]:
    return [stroke for stroke in path.strokes if len(stroke) > SHORT]


def _kept(strokes: Sequence[tuple[complex, ...]], held: Sequence[frozenset[complex]]) -> list[list[bool]]:
    """Which points of each stroke stay: its ends, those held, and of the others as the curve bends. Pieces of 2, 4, …
    steps are tried, for all strokes at once: one whose inner points lie near its chord is drawn by it. Of a graph,
    which has points held, these lie near it above or below themselves: there its values are read."""
    places = np.array([place for stroke in strokes for place in stroke], complex)
    ends = np.cumsum([len(stroke) for stroke in strokes])
    asked = [place in those for stroke, those in zip(strokes, held, strict=True) for place in stroke]
    fixed = np.unique(np.concatenate([np.flatnonzero(asked), [0], ends[:-1], ends - 1]))
    here, after = np.arange(len(places)), np.searchsorted(fixed, np.arange(len(places)), "right")
    # steps from a fixed place and to the next one
    done, left = here - fixed[after - 1], np.append(fixed, len(places))[after] - here
    graph = np.repeat([bool(those) for those in held], [len(stroke) for stroke in strokes])
    stays, steps = np.ones(len(places), bool), 2
    while steps <= PIECE:
        first = np.flatnonzero((done % steps == 0) & (left >= steps))
        inner = first[:, None] + np.arange(1, steps)
        chord, off = (places[first + steps] - places[first])[:, None], places[inner] - places[first][:, None]
        square = np.maximum(np.abs(chord) ** 2, np.finfo(float).tiny)
        along = np.clip((off * chord.conj()).real / square, 0, 1)
        level = graph[first][:, None] & (chord.real > 0)
        along = np.where(level, off.real / np.where(level, chord.real, 1.0), along)
        away = np.abs(off - along * chord)
        stays[inner[(away <= APART).all(axis=1)]] = False
        steps *= 2
    return [part.tolist() for part in np.split(stays, ends[:-1])]
