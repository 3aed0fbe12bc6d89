"""A ratio written the wrong way round: the machine that does not move would, with its reciprocal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tmm_report.chapters.machine.dynamics.given import Given, Motor
from tmm_report.mechanics.machine.characteristics import Geared

Path = tuple[str | int, ...]


def turned_round(given: Given) -> Iterator[tuple[Path, float, Given]]:
    """Each ratio that is stated, with the variant in which it stands the other way round. A mass on a drum moves with
    its shaft."""
    motor = given.motor
    if motor is not None and motor.ratio != 1:
        ratio = 1 / motor.ratio
        law = Geared(motor.own, ratio, motor.efficiency)
        other = Motor(motor.kind, motor.own, law, ratio, motor.efficiency)
        yield ("dynamics", "motor", "ratio"), ratio, replace(given, motor=other)
    for k, part in enumerate(given.parts):
        if part.ratio not in (0.0, 1.0):
            ratio = 1 / part.ratio
            other_part = replace(part, ratio=ratio, arm=part.arm * ratio**2)
            parts = (*given.parts[:k], other_part, *given.parts[k + 1 :])
            yield ("dynamics", "parts", k, "ratio"), ratio, replace(given, parts=parts)
