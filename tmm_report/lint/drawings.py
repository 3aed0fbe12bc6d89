"""Drawings: lettering that lies on lettering, on lines or outside of its picture; a drawing without its scale."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from tmm_report.figures.crowded import cut
from tmm_report.lint.lettered import Lettered, lettering, lines
from tmm_report.lint.made import Made
from tmm_report.lint.page import Picture
from tmm_report.problems import N_, Message, Problem

SLACK = 0.2  # mm: lettering may touch its neighbour by so much
# a scale, a ratio, or words that there is none, in every language of the notes
SCALED = re.compile(
    r"μ|:|not to scale|logarithmic|не в масштабе|без масштаба|логарифмические"
    r"|без масштабу|не в масштабі|логарифмічні|масштабсыз|логарифмдік"
)


def scales(made: Made) -> Iterator[Problem]:
    """Drawings that say neither their scale nor that they have none."""
    for picture in made.page.pictures if made.page else ():
        if not SCALED.search(picture.caption):
            wrong = Message(N_("%(what)s has no scale under it"), {"what": _name(made, picture)})
            right = Message(N_("give the scale in the caption, or say that it is not to scale"))
            yield _found(made, "scale", picture, wrong, right)


def on_lettering(made: Made) -> Iterator[Problem]:
    """Lettering over other lettering, or cut by the edge of its picture."""
    for picture in made.page.pictures if made.page else ():
        texts = lettering(picture.svg)
        boxes = np.array([text.box for text in texts]).reshape(-1, 4) + _INWARDS
        low = np.maximum(boxes[:, None, :2], boxes[:, :2])
        high = np.minimum(boxes[:, None, 2:], boxes[:, 2:])
        for one, other in np.argwhere(np.triu((low < high).all(axis=-1), 1)):
            values = _values(made, picture, texts[one]) | {"other": texts[other].text}
            wrong = Message(N_("%(what)s: the lettering “%(text)s” lies on “%(other)s”"), values)
            yield _found(made, "lettering", picture, wrong)
        for text in _outside(picture, texts, boxes):
            wrong = Message(
                N_("%(what)s: the lettering “%(text)s” is cut off by the edge"), _values(made, picture, text)
            )
            yield _found(made, "lettering", picture, wrong)


def on_lines(made: Made) -> Iterator[Problem]:
    """Lettering that lines of its picture go through."""
    for picture in made.page.pictures if made.page else ():
        texts, drawn = lettering(picture.svg), lines(picture.svg)
        boxes = np.array([text.box for text in texts]).reshape(-1, 4) + _INWARDS
        for text, box in zip(texts, boxes, strict=True):
            if cut(box, drawn).any():
                told = N_("%(what)s: a line goes through the lettering “%(text)s”")
                yield _found(made, "crossed", picture, Message(told, _values(made, picture, text)))


_INWARDS = np.array([SLACK, SLACK, -SLACK, -SLACK])


def _outside(picture: Picture, texts: list[Lettered], boxes: np.ndarray) -> Iterator[Lettered]:
    """Lettering beyond the edge of the picture's own coordinates."""
    numbers = [float(one) for one in re.findall(r"-?\d+(?:\.\d+)?", picture.svg.get("viewBox") or "")[:4]]
    if len(numbers) == 4:
        left, top, wide, tall = numbers
        inside = (boxes[:, 0] >= left) & (boxes[:, 2] <= left + wide)
        inside &= (boxes[:, 3] <= -top) & (boxes[:, 1] >= -top - tall)
        yield from (text for text, within in zip(texts, inside, strict=True) if not within)


def _name(made: Made, picture: Picture) -> str:
    return made.page.name(picture.anchor) if made.page else picture.anchor


def _values(made: Made, picture: Picture, text: Lettered) -> dict[str, str]:
    return {"what": _name(made, picture), "text": text.text}


def _found(made: Made, check: str, picture: Picture, wrong: Message, right: Message | None = None) -> Problem:
    return made.found(check, "note.html", made.line(picture.anchor), wrong, right)
