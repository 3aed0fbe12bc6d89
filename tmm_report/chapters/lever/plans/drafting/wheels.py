"""Links that meshes move in a plan: their rates follow from the radii, their points from the theorem of similarity."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.lever.plans.drafting.lead import point
from tmm_report.chapters.lever.plans.drafting.sheet import Image, Sheet
from tmm_report.chapters.lever.structure.quantities import pitch_radius
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.quantity.formula import Expr, Formula


def moved(sheet: Sheet, wheels: Sequence[Coupled]) -> Iterator[Formula]:
    """The rates of the links, and their points, one after another."""
    for wheel in wheels:
        yield from _rack(sheet, wheel) if wheel.slides else _wheel(sheet, wheel)
        for name in sheet.linkage.mechanism.links[wheel.link].points:
            if sheet.linkage.carriers[name] == wheel.link and not sheet.has(name):
                yield point(sheet, name, wheel.link)


def _wheel(sheet: Sheet, wheel: Coupled) -> Iterator[Formula]:
    link, by, mesh = wheel.link, wheel.by, wheel.mesh
    pivot = sheet.world(complex(np.ravel(wheel.bearing.at[FRAME])[0]))
    turn = wheel.rate * _along(sheet, wheel)  # mm of plan per m
    bend = 0.0
    if sheet.velocity is not None:
        omega = (sheet.velocity.turns[link] * sheet.velocity.scale).imag
        bend = omega**2 / sheet.scale
    sheet.images[link] = Image(0j, pivot, complex(-bend, turn))
    own = sheet.rate(link)
    source, per_mm = _source(sheet, wheel)
    if not per_mm and not source.value:  # the driving link turns evenly, and so does its partner
        sheet.values[own], sheet.per_mm[own] = 0.0, 0.0
        return
    radius = sheet.worked.number(pitch_radius(sheet.linkage, mesh, link), mesh.radius(link))
    if not wheel.by_slides:
        source = source * sheet.worked.number(pitch_radius(sheet.linkage, mesh, by), mesh.radius(by))
    yield sheet.write(own, source / radius, per_mm * abs(wheel.rate))


def _rack(sheet: Sheet, wheel: Coupled) -> Iterator[Formula]:
    t = complex(np.ravel(wheel.bearing.along[FRAME])[0])
    z = sheet.pen.place(t * wheel.rate * _along(sheet, wheel))
    place = sheet.world(complex(np.ravel(sheet.motion.state.r[wheel.link])[0]))
    sheet.images[wheel.link] = Image(z, place, 0j)
    yield from ()


def _along(sheet: Sheet, wheel: Coupled) -> float:
    """The rate of the link that moves it, by the plan: of a turning one mm per m, of a slider mm."""
    image = sheet.images[wheel.by]
    return float(dot(wheel.mesh.along, image.z)) if wheel.by_slides else float(image.turn.imag)


def _source(sheet: Sheet, wheel: Coupled) -> tuple[Expr, float]:
    """The number from which the rate is calculated, and the value of 1 mm of paper for it."""
    if not wheel.by_slides:
        key = sheet.rate(wheel.by)
    else:
        points = sheet.linkage.mechanism.links[wheel.by].points
        key = next(f"{sheet.kind}_{name}" for name in points if sheet.has(name))
    return sheet.number(key, sheet.values[key]), sheet.per_mm[key]
