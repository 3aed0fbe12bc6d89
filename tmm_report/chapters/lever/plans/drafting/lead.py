"""The driving link in a plan, and points of any link by the theorem of similarity."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmm_report.chapters.lever.plans.drafting.branch import Line
from tmm_report.chapters.lever.plans.drafting.sheet import Image, Sheet
from tmm_report.mechanics.lever.vector_equations import driving_pin
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, segment_of


def formulas(sheet: Sheet) -> tuple[Formula, ...]:
    """The driving link's pin (a joint rather than another point), and its other points by similarity."""
    sheet.driver_rate()
    mechanism, pair = sheet.linkage.mechanism, sheet.linkage.structure.driver_pair
    link = mechanism.driver.link
    pivot = sheet.place(pair.name)
    points = [p for p in mechanism.links[link].points if p != pair.name]
    pin = driving_pin(sheet.linkage)
    if pin is None:
        return _without_pin(sheet, link, pivot)
    arm = sheet.drawn(sheet.place(pin) - pivot, pair.name + pin)
    if sheet.kind == "a" and round_significant(abs(sheet.epsilon), DIGITS) > 0:
        own = _of_accelerated_pin(sheet, link, pin, arm)
        sheet.images[link] = Image(0j, pivot, sheet.vertices[sheet.letter(pin)] / arm)
        return (*own, *(point(sheet, p, link) for p in points if p != pin))
    z = 1j * sheet.omega * arm if sheet.kind == "v" else -(sheet.omega**2) * arm
    z = sheet.absolute(pin, sheet.pen.place(z / sheet.scale))
    sheet.images[link] = Image(0j, pivot, z / arm)
    own = _of_pin(sheet, link, pin)
    return (*own, *(point(sheet, p, link) for p in points if p != pin))


def _without_pin(sheet: Sheet, link: str, pivot: complex) -> tuple[Formula, ...]:
    """A driving link that only carries a guide: nothing to draw, but it turns."""
    turn = 1j * sheet.omega if sheet.kind == "v" else 1j * sheet.epsilon - sheet.omega**2
    sheet.images[link] = Image(0j, pivot, turn / sheet.scale)
    return ()


def _of_pin(sheet: Sheet, link: str, pin: str) -> tuple[Formula, Formula]:
    """The pin's velocity or acceleration, and the segment laid off for it."""
    w = sheet.number(f"w_{link}", float(round_significant(abs(sheet.omega), DIGITS)))
    arms = sheet.linkage.mechanism.links[link].points
    pivot = sheet.linkage.structure.driver_pair.name
    length = sheet.length(pivot, pin, float(np.abs(arms[pin] - arms[pivot])))
    size = w * length if sheet.kind == "v" else w**2 * length
    value = sheet.write(f"{sheet.kind}_{pin}", size)
    sheet.reference = value.written
    name = sheet.laid[f"{sheet.kind}_{pin}"] = sheet.pole + sheet.letter(pin)
    laid = sheet.worked.laid_off(segment_of(name), size / sheet.mu)
    sheet.segments[name] = laid.written
    return value, laid


def _of_accelerated_pin(sheet: Sheet, link: str, pin: str, arm: complex) -> tuple[Formula, ...]:
    """The pin's normal and tangential acceleration, the segments laid off for them, and the whole read off."""
    pivot = sheet.linkage.structure.driver_pair.name
    arms = sheet.linkage.mechanism.links[link].points
    length = sheet.length(pivot, pin, float(np.abs(arms[pin] - arms[pivot])))
    w, e = (
        sheet.number(f"{letter}_{link}", float(round_significant(abs(rate), DIGITS)))
        for letter, rate in (("w", sheet.omega), ("e", sheet.epsilon))
    )
    normal, tangential = (f"a_{pin}{pivot}_{part}" for part in "nt")
    ends = sheet.letter_of_bend("n1")
    z = sheet.vertices[ends] = sheet.pen.place(-(sheet.omega**2) * arm / sheet.scale)
    sheet.stroke(0j, z, normal, "bend")
    by_normal = sheet.write(normal, w**2 * length)
    sheet.reference = by_normal.written
    first = sheet.worked.laid_off(
        segment_of(sheet.pole + ends), sheet.number(normal, by_normal.written) / sheet.mu
    )
    sheet.laid[normal] = sheet.pole + ends
    sheet.segments[sheet.pole + ends] = first.written
    whole = sheet.pen.place(z + 1j * sheet.epsilon * arm / sheet.scale)
    sheet.stroke(z, whole, tangential, "rate")
    by_tangential = sheet.write(tangential, e * length)
    name = sheet.laid[tangential] = ends + sheet.letter(pin)
    second = sheet.worked.laid_off(
        segment_of(name), sheet.number(tangential, by_tangential.written) / sheet.mu
    )
    sheet.segments[name] = second.written
    sheet.absolute(pin, whole)
    return by_normal, first, by_tangential, second, sheet.read_point(pin)


# ---------------------------------------------------------------- points by similarity


def point(sheet: Sheet, name: str, link: str) -> Formula:
    """A point of a link whose image is drawn."""
    sheet.absolute(name, sheet.pen.place(sheet.images[link].of(sheet.place(name))))
    return sheet.read_point(name)


def similar(sheet: Sheet, link: str, lines: Sequence[Line]) -> list[Formula]:
    """Points of a link, beside its joints already drawn, by the theorem of similarity."""
    found = []
    line = next((x for x in lines if x.branch.turns and x.branch.link == link), None)
    for name in sheet.linkage.mechanism.links[link].points:
        if sheet.linkage.carriers[name] != link or sheet.has(name):
            continue
        proportion = _proportion(sheet, link, name, line) if line is not None else None
        value = point(sheet, name, link)
        found += [value] if proportion is None else [proportion, value]
    return found


def _proportion(sheet: Sheet, link: str, name: str, line: Line) -> Formula | None:
    """ac = ab · AC / AB: the link's figure in the plan is similar to the link."""
    points = sheet.linkage.mechanism.links[link].points
    start, end = line.branch.arm or ("", "")
    if start not in points or end not in points or line.branch.end != end or link not in sheet.turning:
        return None
    first = sheet.letter(line.branch.start) if line.branch.start else sheet.pole
    whole = sheet.segment(first, sheet.letter(end))
    part, rod = (sheet.length(start, to, float(np.abs(points[to] - points[start]))) for to in (name, end))
    return sheet.worked.laid_off(segment_of(first + sheet.letter(name)), whole * part / rod)
