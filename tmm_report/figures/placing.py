"""Labels that seek their place: each on a clear spot beside what it names, or led to it by a thin line from afar."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, Literal, NamedTuple

import numpy as np

from tmm_report.figures.crowded import Ground, areas, ground, overlapped
from tmm_report.figures.primitives import (
    NORMAL,
    Box,
    Circle,
    Item,
    Leader,
    Measure,
    Path,
    Pen,
    Tag,
    Text,
    letters_box,
)

CLEAR = 0.1  # free space sought round lettering beside that of the grid, mm
AWAY = 1.8  # a label farther than this beyond its gap is led to its place by a line, mm
LEADER = 0.1  # width of that line, mm
SHEET = (165.0, 228.0)  # mm: labels do not make a drawing larger than a sheet where they can help it

CROSSED, COVERED, BEYOND = 0.5, 8.0, 2.0  # dislike of lines, of mm² of lettering, of mm beyond the sheet
ACROSS = 0.02  # dislike of what a leader goes over
_HARD = 100  # places whose leaders are looked at where none is clear
_TRIES = 4  # orders of the labels
_MANY = 60  # labels: of more than these one order is tried
_FEW, _MORE = 24, 240  # places looked at first, and next
_CHOICE = 6  # clear places among which the leader that goes over least decides

# mm beyond the gap
_RINGS = np.array([0.0, 0.6, 1.2, 1.8, 2.8, 4.0, 5.5, 7.5, 10.0, 13.0, 17.0, 22.0, 28.0])
_FAR = _RINGS > AWAY
_SIDES = np.exp(2j * np.pi * np.arange(24) / 24)
_LIKING = np.full(24, 0.12)  # of sides: corners first, then right, left, up, down, then all that is between
_LIKING[[3, 9, 21, 15, 0, 12, 6, 18]] = 0.01 * np.arange(8)
_LEAN = np.clip(1.5 * _SIDES.real, -1, 1), np.clip(1.5 * _SIDES.imag, -1, 1)
_LOOSE = 9  # rings on which what stands loose is tried
_ANCHORS = 5  # of each label that are tried

Array = Any


class Spots(NamedTuple):
    """Places of a label in the order of liking: boxes (N, 4); lean, complex (N,): from the nearest place of a box to
    its centre; anchors; dislike of each before it is looked at what is there; led: whether a line leads to it."""

    boxes: Array
    lean: Array
    anchors: Array
    dislike: Array
    led: Array


def placed(tags: Sequence[Tag], items: Sequence[Item]) -> tuple[Sequence[Text], Sequence[Leader]]:
    """The texts of the tags, in their order, and the lines that lead to those put far from their places.

    Who comes first has the choice. Where that leaves no clear place to some, these are let go first.
    """
    return _placed(tuple(tags), tuple(items))


@lru_cache(maxsize=512)
def _placed(tags: tuple[Tag, ...], items: tuple[Item, ...]) -> tuple[list[Text], list[Leader]]:
    """A note is written in several formats one after another, with the same drawings in each."""
    texts, leaders, _ = _by_turns(tags, *_ground(items, letters_box), letters_box)
    return texts, leaders


def _by_turns(
    tags: Sequence[Tag], on: Ground, sheet: Box, measure: Measure
) -> tuple[list[Text], list[Leader], int]:
    """The texts, their leaders, and how many found no clear place."""
    order, least = list(range(len(tags))), len(tags) + 1
    best: tuple[list[Text], list[Leader]] = [], []
    for _ in range(_TRIES if len(tags) <= _MANY else 1):
        texts, leaders, spoilt = _in_order(tags, order, on.copy(), sheet, measure)
        if len(spoilt) < least:
            least, best = len(spoilt), (texts, leaders)
        if not spoilt:
            break
        order = spoilt + [k for k in order if k not in spoilt]
    return (*best, least)


def relettered(items: Sequence[Item], measures: Sequence[Measure]) -> tuple[tuple[Item, ...], Measure, bool]:
    """The items with other letters, those of the first measure with which all find a clear place, else of the last;
    which it is, and whether all have found one. What has sought its place does so anew; what has its own stays there,
    or as near as nothing is in the way."""
    lines = [item for item in items if not isinstance(item, Text | Leader)]
    own = [item for item in items if isinstance(item, Text) and not item.tag]
    seeking = [item.tag for item in items if isinstance(item, Text) and item.tag]
    on, sheet = _ground((*lines, *own), measures[0])
    for measure in measures:
        boxes = np.array([text.taken(measure) for text in own]).reshape(-1, 4)
        clear = ((on.covered(boxes) == 0) & (overlapped(boxes, boxes).sum(axis=1) == 1)).tolist()
        stay = [text for text, is_clear in zip(own, clear, strict=True) if is_clear]
        loose = [_loose(text, measure) for text, is_clear in zip(own, clear, strict=True) if not is_clear]
        on.taken = [text.taken(measure) for text in stay]
        texts, leaders, spoilt = _by_turns([*loose, *seeking], on, sheet, measure)
        if not spoilt:
            break
    return (*lines, *stay, *leaders, *texts), measure, not spoilt


def _loose(text: Text, measure: Measure) -> Tag:
    left, bottom, right, top = text.taken(measure)
    middle = complex(left + right, bottom + top) / 2
    return Tag(text.parts, (middle,), 0.0, size=text.size, colour=text.colour, loose=True)


def _in_order(
    tags: Sequence[Tag], order: Sequence[int], on: Ground, sheet: Box, measure: Measure
) -> tuple[list[Text], list[Leader], list[int]]:
    """The tags put one after another: their texts, leaders, and which of them found no clear place."""
    texts: dict[int, Text] = {}
    leaders: list[Leader] = []
    spoilt: list[int] = []
    for k in order:
        texts[k], led, clear = _put(tags[k], on, sheet, measure)
        leaders += led
        spoilt += [] if clear else [k]
        on.taken.append(texts[k].taken(measure))
        on.leaders += [(path.strokes[0][0], path.strokes[0][1]) for path in led]
    return [texts[k] for k in range(len(tags))], leaders, spoilt


def _ground(items: Sequence[Item], measure: Measure) -> tuple[Ground, Box]:
    """What labels keep off, and the sheet they keep to."""
    lines = np.array([one for item in items for one in _lines(item)], float).reshape(-1, 5)
    taken = [item.taken(measure) for item in items if isinstance(item, Text)]
    ends = np.concatenate([lines[:, :2], lines[:, 2:4], np.array(taken, float).reshape(-1, 2)])
    ends = ends if len(ends) else np.zeros((1, 2))
    low, high = ends.min(axis=0), ends.max(axis=0)
    aside = np.clip(np.array(SHEET) - 2 - (high - low), 0, None) / 2
    left, bottom, right, top = map(float, (*(low - aside), *(high + aside)))
    on = ground(lines, low, high)
    on.taken += taken
    return on, (left, bottom, right, top)


def clear_of(items: Sequence[Item], boxes: Sequence[Box]) -> list[bool]:
    """Whether nothing of a drawing is in each of the boxes."""
    on, _ = _ground(items, letters_box)
    sought = np.array(boxes, float).reshape(-1, 4)
    return ((on.covered(sought) == 0) & on.free(sought)).tolist()


def _lines(item: Item) -> list[tuple[float, float, float, float, float]]:
    """Lines that lettering keeps off: a thick one more than a thin one, the inside of a white block too; it may stand
    on the pale lines of a grid."""
    if isinstance(item, Text) or (item.pen is not None and item.pen.colour == "pale"):
        return []
    strokes: list[tuple[complex, ...]] = item.outline()
    weight = item.pen.width / NORMAL.width if item.pen else 1.0
    if isinstance(item, Circle) and item.radius < 2:
        reach = item.radius * (1 + 1j)
        strokes = [*strokes, (item.centre - reach, item.centre + reach)]
    if isinstance(item, Path) and item.fill == "white":
        strokes += [pair for corners in item.strokes for pair in zip(corners, corners[2:], strict=False)]
    return [(a.real, a.imag, b.real, b.imag, weight) for stroke in strokes for a, b in pairwise(stroke)]


def _put(tag: Tag, on: Ground, sheet: Box, measure: Measure) -> tuple[Text, list[Leader], bool]:
    """The text, the line that leads to it, and whether its place is clear."""
    left, bottom, right, top = measure(tag.parts, tag.size)
    spots = _spots(tag, complex(right - left, top - bottom) / 2)
    index, clear = _best(tag, spots, on, sheet)
    x0, y0, x1, y1 = spots.boxes[index].tolist()
    lean = complex(spots.lean[index]).real
    # aligned to its anchor's side, so that a narrower font keeps the gap
    align: Literal[-1, 0, 1] = 0 if abs(lean) < 1e-9 else -1 if lean > 0 else 1
    at = complex((x0 + x1 + (right - left) * align) / 2, (y0 + y1 - (bottom + top)) / 2)
    text = Text(at, tag.parts, tag.size, align, tag.colour, tag)
    led = [Leader((_leader(tag, spots, index),), Pen(LEADER, tag.colour))] if spots.led[index] else []
    return text, led, clear


def _spots(tag: Tag, half: complex) -> Spots:
    """All places on the rings round the anchors, the best liked first."""
    anchors = np.array(tag.anchors[:_ANCHORS])
    of, ring, side, dislike, led = _liked(len(anchors), tag.prefer, tag.loose)
    lean = (_LEAN[0] * half.real + 1j * _LEAN[1] * half.imag) * (not tag.loose)
    at = anchors[of] + (tag.gap + _RINGS[ring]) * _SIDES[side] + lean[side]
    wide, tall = half.real + CLEAR, half.imag + CLEAR
    boxes = np.stack([at.real - wide, at.imag - tall, at.real + wide, at.imag + tall], axis=1)
    return Spots(boxes, lean[side], anchors[of], dislike, led)


@lru_cache(maxsize=256)
def _liked(count: int, prefer: complex | None, loose: bool) -> tuple[Array, Array, Array, Array, Array]:
    """Of the places round so many anchors, the best liked first: numbers of their anchors, rings and sides, dislike,
    whether a line leads there."""
    rings, led = (_RINGS[:_LOOSE], np.zeros(_LOOSE, bool)) if loose else (_RINGS, _FAR)
    wrong = 0.5 * abs(_SIDES - prefer) if prefer else 0.0
    dislike = 0.05 * np.arange(count)[:, None, None] + (0.2 * rings + 0.5 * led)[:, None] + _LIKING + wrong
    order = np.argsort(np.round(dislike, 6), axis=None, kind="stable")
    of, ring, side = np.unravel_index(order, dislike.shape)
    return of, ring, side, dislike.ravel()[order], led[ring]


def _best(tag: Tag, spots: Spots, on: Ground, sheet: Box) -> tuple[int, bool]:
    """The first clear place that needs no leader; else the best of the first clear ones; else what covers least."""
    clear: list[tuple[float, int]] = []
    for index in _clear(tag, spots, on, sheet):
        if not spots.led[index]:
            return min([*clear, (float(spots.dislike[index]), index)])[1], True
        across = on.across(*_leader(tag, spots, index))
        clear.append((round(float(spots.dislike[index]) + ACROSS * across, 6), index))
        if len(clear) == _CHOICE:
            break
    return (min(clear)[1], True) if clear else (_least(tag, spots, on, sheet), False)


def _clear(tag: Tag, spots: Spots, on: Ground, sheet: Box) -> Iterator[int]:
    """The places on the sheet that are free of lines, lettering and leaders, and whose leaders are, up to the first
    without one.

    A few of the best liked are looked at first: often one of them is taken.
    """
    for some in np.split(np.arange(len(spots.boxes)), [_FEW, _MORE]):
        boxes = spots.boxes[some]
        bare = (on.covered(boxes) == 0) & (_beyond(boxes, sheet) <= 0)
        free = some[bare][on.free(boxes[bare])] if bare.any() else some[:0]
        near = np.nonzero(~spots.led[free])[0]
        free = free[: near[0] + 1] if len(near) else free
        led = free[spots.led[free]]
        over = on.crossed(_leaders(tag, spots, led)) if len(led) else led
        yield from led[over == 0].tolist()
        yield from free[len(led) :].tolist()


def _least(tag: Tag, spots: Spots, on: Ground, sheet: Box) -> int:
    """Where no place is clear: that which covers least, its leader too."""
    crossed, beyond = on.covered(spots.boxes), _beyond(spots.boxes, sheet)
    spoilt = CROSSED * crossed + COVERED * areas(spots.boxes, on.taken) + BEYOND * np.clip(beyond, 0, None)
    cost = np.round(spots.dislike + spoilt, 6)
    hard = np.nonzero(spots.led & (cost <= np.sort(cost)[:_HARD][-1]))[0]
    if len(hard):
        cost[hard] += COVERED * on.crossed(_leaders(tag, spots, hard))
    return int(np.argmin(cost))


def _beyond(boxes: Array, sheet: Box) -> Array:
    """How far each box (N, 4) reaches beyond the sheet, (N,), mm; negative within it."""
    left, bottom, right, top = sheet
    across = np.maximum(left - boxes[:, 0], boxes[:, 2] - right)
    return np.maximum(across, np.maximum(bottom - boxes[:, 1], boxes[:, 3] - top))


def _leader(tag: Tag, spots: Spots, index: int) -> tuple[complex, complex]:
    """The line from the anchor's mark to the nearest place of the label."""
    anchor, (x0, y0, x1, y1) = complex(spots.anchors[index]), spots.boxes[index].tolist()
    end = complex(min(max(anchor.real, x0), x1), min(max(anchor.imag, y0), y1))
    return anchor + max(0.0, tag.gap - 0.7) * (end - anchor) / abs(end - anchor), end


def _leaders(tag: Tag, spots: Spots, places: Array) -> Array:
    """The lines to several places, (N, 2)."""
    anchors, boxes = spots.anchors[places], spots.boxes[places]
    ends = np.clip(anchors.real, boxes[:, 0], boxes[:, 2]) + 1j * np.clip(
        anchors.imag, boxes[:, 1], boxes[:, 3]
    )
    starts = anchors + max(0.0, tag.gap - 0.7) * (ends - anchors) / np.abs(ends - anchors)
    return np.stack([starts, ends], axis=1)
