"""Sketches of ordinary stages, across their axes and to scale."""

from __future__ import annotations

from collections.abc import Callable

from tmm_report.chapters.gears.ordinary.draw.belt import belt, chain
from tmm_report.chapters.gears.ordinary.draw.cones import cones
from tmm_report.chapters.gears.ordinary.draw.wheels import friction, train
from tmm_report.chapters.gears.ordinary.draw.worm import worm
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import Drawing

SKETCHES = {
    "friction": friction, "train": train, "pair": train, "bevel": cones, "worm": worm,
}  # fmt: skip


ROUND = {"belt": belt, "chain": chain}


def sketch(found: Found, title: str, words: Callable[[str], str] = str) -> Drawing:
    """`words` translates those of indices."""
    if found.kind in ROUND:
        return ROUND[found.kind](found, title, words)
    return (cones if "delta1" in found.s else SKETCHES[found.kind])(found, title)
