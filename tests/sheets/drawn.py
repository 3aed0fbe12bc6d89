"""Sheets of shipped variants, and what is measured on them from their lines alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import chain, pairwise

import numpy as np
from conftest import solved
from exhaustive import NAMES

from tmm_report import sheets
from tmm_report.commands.files import translator
from tmm_report.figures.crowded import cut, overlapped
from tmm_report.figures.primitives import Box, Leader, Path
from tmm_report.figures.sheets.block import Block
from tmm_report.figures.sheets.sheet import Sheet
from tmm_report.figures.sheets.strokes import LINE, Letters
from tmm_report.sheets.pictures import Figure

HAIR = 0.2  # mm: letters of 3.5 mm in rows of 5 mm come as near

EVERY = tuple(sorted(NAMES))
# of all five kinds, of several sheets, alone, without a lever mechanism
SOME = ("cam_press", "compressor", "hoist_drive", "shaper_project", "rotor")


@cache
def pictures_of(name: str) -> list[Figure]:
    results = solved(name)
    return sheets.figures(results, translator(results.variant))


@cache
def sheets_of(name: str) -> tuple[Sheet, ...]:
    results = solved(name)
    return tuple(sheets.composed(results, translator(results.variant), pictures_of(name)))


@cache
def files_of(name: str) -> dict[str, bytes]:
    return sheets.written(sheets_of(name))


def ink(block: Block) -> Box:
    """What the lines of a picture and of its letters take, by all of their points."""
    strokes = chain.from_iterable(item.outline() for item in block.items)
    letters = chain.from_iterable(one.path.strokes for one in block.letters)
    points = np.array(list(chain.from_iterable(chain(strokes, letters))))
    x, y = points.real, points.imag
    return x.min(), y.min(), x.max(), y.max()


def form_letters(sheet: Sheet) -> tuple[Letters, ...]:
    return sheet.frame[1]


@cache
def _reach(text: str, squeeze: float) -> Box:
    """What the lines of letters one high take, by all of their points, from where their line begins."""
    alone = Letters(0j, (text,), 1.0, squeeze=squeeze)
    points = np.array([z for stroke in alone.path.strokes for z in stroke]) - alone.runs[0].at
    return points.real.min(), points.imag.min(), points.real.max(), points.imag.max()


def boxes(one: Letters) -> Iterator[Box]:
    """What each run of letters takes with its lines but for a hair."""
    half = LINE * one.tall / 2 - HAIR
    for run in one.runs:
        left, low, right, high = _reach(run.text, one.squeeze)
        ends = [one.place(run.at + run.tall * z) for z in (complex(left, low), complex(right, high))]
        x, y = sorted(z.real for z in ends), sorted(z.imag for z in ends)
        yield x[0] - half, y[0] - half, x[1] + half, y[1] + half


def written(one: Letters) -> str:
    return "".join(run.text for run in one.runs)


def touching(letters: Sequence[Letters]) -> Iterator[tuple[str, str]]:
    """Texts of which some letters lie on those of another."""
    taken = [(k, box) for k, one in enumerate(letters) for box in boxes(one)]
    of = np.array([k for k, _ in taken])
    upon = overlapped(*(np.array([box for _, box in taken]).reshape(-1, 4),) * 2)
    for k, other in {(of[i], of[j]) for i, j in np.argwhere(upon & (of[:, None] < of))}:
        yield written(letters[k]), written(letters[other])


def crossed(block: Block) -> list[str]:
    """Texts through which a line goes, a leader among them."""
    seen = [
        item for item in block.items if getattr(item, "pen", None) or getattr(item, "fill", "") == "black"
    ]
    strokes = [stroke for item in seen for stroke in item.outline()]
    lines = np.array([pair for stroke in strokes for pair in pairwise(stroke)], complex).reshape(-1, 2)
    taken = [(one, box) for one in block.letters for box in boxes(one)]
    room = np.array([box for _, box in taken]).reshape(-1, 4)
    low, high = lines.min(axis=1), lines.max(axis=1)  # by the real part
    beside = (high.real <= room[:, :1]) | (low.real >= room[:, 2:3])
    k, near = np.nonzero(~beside)
    through = k[cut(room[k], lines[near])]
    return [written(taken[k][0]) for k in dict.fromkeys(through.tolist())]


def figures_on(sheet: Sheet, name: str) -> Iterator[tuple[Figure, float, Block]]:
    """Every picture of a sheet as it is in the note, how many times as large it is on the sheet, and it there."""
    for block in sheet.blocks:
        yield next(
            (figure, times, block)
            for figure in pictures_of(name)
            for times, made in figure.made.items()
            if made.title == block.title and np.allclose(made.size, block.size)
        )


def lines_of(figure: Figure, block: Block) -> Iterator[tuple[Path, Path]]:
    """Lines of a picture in the note and on its sheet, without those of a grid; of a graph its curves."""
    old, new = ([one for one in items if isinstance(one, Path) and not isinstance(one, Leader)]
                for items in (figure.drawing.items, block.items))  # fmt: skip
    if figure.diagram:
        old = [one for one in old if one.held]
        shapes = [[len(stroke) for stroke in one.strokes] for one in old]
        new = [one for one in new if [len(stroke) for stroke in one.strokes] in shapes]
    pairs = zip(old, new, strict=True)
    return (pair for pair in pairs if pair[0].pen is None or pair[0].pen.colour != "pale")


def said(block: Block) -> str:
    """A title on one line; of a symbol its letters alone."""
    words = (
        "".join(one if isinstance(one, str) else f"{one.base}_{one.sub}" for one in word)
        for word in block.title
    )
    return " ".join(words)
