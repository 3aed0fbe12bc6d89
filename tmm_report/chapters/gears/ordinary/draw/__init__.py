"""Sketches of ordinary stages, across their axes and to scale."""

from __future__ import annotations

from tmm_report.chapters.gears.ordinary.draw.belt import belt, chain
from tmm_report.chapters.gears.ordinary.draw.cones import cones
from tmm_report.chapters.gears.ordinary.draw.wheels import friction, train
from tmm_report.chapters.gears.ordinary.draw.worm import worm
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import Drawing

SKETCHES = {
    "belt": belt, "chain": chain, "friction": friction, "train": train, "pair": train, "bevel": cones, "worm": worm,
}  # fmt: skip


def sketch(found: Found, title: str) -> Drawing:
    return (cones if "delta1" in found.s else SKETCHES[found.kind])(found, title)
