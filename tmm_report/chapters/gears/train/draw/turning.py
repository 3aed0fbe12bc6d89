"""How the members of a compound train turn on its scheme, for the screen: marks on what is seen from the side."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from tmm_report.figures.drawing import Moves, Moving, line
from tmm_report.figures.schemes.marks import MARK, going_round, spot

if TYPE_CHECKING:
    from tmm_report.chapters.gears.train.draw.scheme import Scheme

PIN = 1.8  # half the mark of a carrier, at the pin of its satellites


def turning(drawn: Scheme) -> Moves | None:
    """None where nothing turns, or where bevel wheels would not turn together as they are drawn: on fixed axes each is
    counted in a sense of its own. A satellite shows its own turning: one across its carrier's axis, that about it."""
    speed = {
        name: omega - (drawn.found.speed[drawn.built.carried[name]] if drawn.built.tilted(name) else 0.0)
        for name, omega in drawn.found.speed.items()
    }
    senses = {name: set(_senses(drawn, name, speed)) for name in drawn.built.bevel if _across(drawn, name)}
    if any(len(found) > 1 for found in senses.values()):
        return None
    marks = [mark for name in drawn.x for mark in _of_wheel(drawn, name, sum(senses.get(name, ())))]
    marks += _of_carriers(drawn)
    moving = tuple(mark for mark in marks if speed[mark.of])
    return Moves(moving, (), speed=speed) if moving else None


def _across(drawn: Scheme, name: str) -> bool:
    return any(across == name for across, _, _ in drawn.contacts(name))


def _senses(drawn: Scheme, across: str, speed: Mapping[str, float]) -> Iterator[int]:
    """In which sense each wheel beside it turns the one across the main axis: at its right edge both go back where the
    other goes up in front, at its left edge they come forth."""
    carrier = drawn.found.speed[drawn.built.carried[across]] if drawn.built.tilted(across) else 0.0
    for _, contact, other in drawn.contacts(across):
        if rolled := speed[other] - carrier:
            yield int(math.copysign(1, rolled * (contact - drawn.cone(across)).real))


def _of_wheel(drawn: Scheme, name: str, sense: int) -> list[Moving]:
    """`sense`: of one across the main axis; a bevel wheel has dots where it touches another."""
    y, side = drawn.y(name), int(drawn.built.body(name) in drawn.main)
    if name not in drawn.built.bevel:
        start, end = drawn.rim(name)
        return going_round(line(complex(start, y), complex(end, y), MARK), drawn.half(name), name, side)
    if _across(drawn, name):
        return going_round(spot(drawn.cone(name)), drawn.r(name), name, across=1 + 0j, sense=sense)
    contact = next((at for _, at, _ in drawn.contacts(name)), None)
    if contact is None or not side:
        return []
    return going_round(spot(complex(drawn.x[name], y)), contact.imag, name, side)


def _of_carriers(drawn: Scheme) -> Iterator[Moving]:
    for m in drawn.train.members:
        if m.kind == "carrier" and m.body in drawn.main:
            for x, height, _, _ in drawn.arms(drawn.route, m.name):
                pin = line(complex(x - PIN, 0), complex(x + PIN, 0), MARK)
                yield from going_round(pin, height, m.name, 1)
