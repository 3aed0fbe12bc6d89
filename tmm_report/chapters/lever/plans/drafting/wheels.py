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
from tmm_report.records import dataclass


def moved(sheet: Sheet, wheels: Sequence[Coupled]) -> Iterator[Formula]:
    """The rates of the links, and their points, one after another."""
    for wheel in wheels:
        yield from _rack(sheet, wheel) if wheel.slides else _wheel(sheet, wheel)
        for name in sheet.linkage.mechanism.links[wheel.link].points:
            if sheet.linkage.carriers[name] == wheel.link and not sheet.has(name):
                yield point(sheet, name, wheel.link)


@dataclass(frozen=True)
class Term:
    """What another link adds to r·ω of a wheel: signed, mm of plan; its size in a calculation, and the value of 1 mm of
    paper for it."""

    drawn: float
    size: Expr
    per_mm: float


def _wheel(sheet: Sheet, wheel: Coupled) -> Iterator[Formula]:
    link, mesh = wheel.link, wheel.mesh
    carrier = sheet.images[wheel.bearing.other(link)]
    axis = sheet.world(complex(np.ravel(sheet.motion.state.r[link])[0]))
    terms = list(_terms(sheet, wheel))
    turn = sum(term.drawn for term in terms) / mesh.radius(link)  # mm of plan per m
    bend = 0.0
    if sheet.velocity is not None:
        omega = (sheet.velocity.turns[link] * sheet.velocity.scale).imag
        bend = omega**2 / sheet.scale
    sheet.images[link] = Image(carrier.of(axis), axis, complex(-bend, turn))
    own = sheet.rate(link)
    if all(not term.per_mm and not term.size.value for term in terms):
        sheet.values[own], sheet.per_mm[own] = 0.0, 0.0  # what moves it turns evenly, and so does the wheel
        return
    radius = sheet.worked.number(pitch_radius(sheet.linkage, mesh, link), mesh.radius(link))
    terms.sort(key=lambda term: -abs(term.drawn))
    size = terms[0].size
    for term in terms[1:]:
        size = size + term.size if term.drawn * terms[0].drawn >= 0 else size - term.size
    yield sheet.write(own, size / radius, sum(term.per_mm for term in terms))


def _terms(sheet: Sheet, wheel: Coupled) -> Iterator[Term]:
    """Of the other wheel or the rack, and of a moving carrier, to r·ω of a wheel."""
    link, by, mesh = wheel.link, wheel.by, wheel.mesh
    radius = mesh.radius(link)
    sizes = {
        name: sheet.worked.number(pitch_radius(sheet.linkage, mesh, name), mesh.radius(name))
        for name in mesh.links
        if mesh.radius(name)
    }
    for name, rate in ((by, wheel.rate), (mesh.carrier, wheel.share)):
        if name == FRAME:
            continue
        source, per_mm = _source(sheet, wheel, name)
        drawn = radius * rate * _along(sheet, wheel, name)
        if name == by and not wheel.by_slides:
            source = source * sizes[by]
        elif name == mesh.carrier and mesh.carried is None:
            one, other = sorted(sizes.values(), key=lambda size: -size.value)
            source = source * (one + other if mesh.kind == "external" else one - other)
        yield Term(drawn, source, per_mm * abs(rate))


def _rack(sheet: Sheet, wheel: Coupled) -> Iterator[Formula]:
    t = complex(np.ravel(wheel.bearing.along[FRAME])[0])
    moved = wheel.rate * _along(sheet, wheel, wheel.by)
    if wheel.mesh.carrier != FRAME:
        moved += wheel.share * _along(sheet, wheel, wheel.mesh.carrier)
    z = sheet.pen.place(t * moved)
    place = sheet.world(complex(np.ravel(sheet.motion.state.r[wheel.link])[0]))
    sheet.images[wheel.link] = Image(z, place, 0j)
    yield from ()


def _along(sheet: Sheet, wheel: Coupled, link: str) -> float:
    """The rate of a link that moves it, by the plan: of a turning one mm per m, of a slider mm."""
    image, way = sheet.images[link], _way(wheel, link)
    return float(image.turn.imag) if way is None else float(dot(way, image.z))


def _way(wheel: Coupled, link: str) -> complex | None:
    """The direction along which a link that moves it slides; None of one that turns."""
    mesh = wheel.mesh
    if link == wheel.by:
        return mesh.along if wheel.by_slides else None
    return mesh.carried.along if mesh.carried is not None else None


def _source(sheet: Sheet, wheel: Coupled, link: str) -> tuple[Expr, float]:
    """The number of a link that moves it, and the value of 1 mm of paper for it."""
    if _way(wheel, link) is None:
        key = sheet.rate(link)
    else:
        points = sheet.linkage.mechanism.links[link].points
        key = next(f"{sheet.kind}_{name}" for name in points if sheet.has(name))
    return sheet.number(key, sheet.values[key]), sheet.per_mm[key]
