"""Diagrams against lengths of a stroke or angles of a swing, brought to its parts.

by_displacement: {zero: left, forward: [[0 mm, 0], [40 mm, 2 kN], [120 mm, 1 kN]], back: [[0, 0], [1, 0]]}
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, TypeVar

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment, StrokesDiagram
from tmm_report.chapters.lever.kinetostatics.solve.coordinates import coordinate
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.variant.gaps import not_to_the_end
from tmm_report.variant.values import Measured
from tmm_report.yamlread import Path

AnyLoad = TypeVar("AnyLoad", Force, Moment)
NONE = 1e-9  # of the distance: a way as short as this is none
ROUNDED = 0.01  # of the stroke: by so much a table that ends with it may miss its end


def is_measured(load: Force | Moment) -> bool:
    """Whether a diagram of the load has places in lengths or angles."""
    return any(isinstance(curve, Measured) for curve in curves(load.by_displacement).values())


def curves(diagram: Any) -> dict[Path, Any]:
    """The curves of a diagram, by the keys under which they stand; of one that is shared none."""
    if hasattr(diagram, "strokes"):
        return {("strokes", name): curve for name, curve in diagram.strokes.items()}
    if hasattr(diagram, "forward"):
        return {("forward",): diagram.forward, ("back",): diagram.back}
    return {}


def in_parts(load: AnyLoad, path: Path, cycle: Cycle) -> AnyLoad:
    """The load with its diagram in parts of the stroke that its point makes, or its link swings. `path`: of the load.
    Raises ProblemError where a curve goes beyond the stroke, or does not reach its end."""
    low, high = reach(cycle, coordinate(load, cycle))[1]
    whole = high.value - low.value
    if not whole > NONE * max(abs(high.value), abs(low.value)):
        text = N_("%(name)s does not move that way: its diagram has no stroke")
        name = load.at if isinstance(load, Force) else load.on
        raise ProblemError([mistake(text, (*path, "by_displacement", "zero"), name=name)])
    drawn = _divided(load.by_displacement, whole, (*path, "by_displacement"), isinstance(load, Moment))
    return replace(load, by_displacement=drawn)


def _divided(diagram: Any, whole: float, path: Path, turns: bool) -> Any:
    """The diagram with its places by the stroke, m, or the swing, rad."""
    found, wrong = dict[str, Any](), list[Problem]()
    for keys, curve in curves(diagram).items():
        parts = [(x / whole, y) for x, y in curve] if isinstance(curve, Measured) else list(curve)
        wrong += _ends(parts, (*path, *keys), curve, whole, turns)
        found[str(keys[-1])] = [(min(x, 1.0), y) for x, y in parts]
    if wrong:
        raise ProblemError(wrong)
    return replace(diagram, **({"strokes": found} if isinstance(diagram, StrokesDiagram) else found))


def _ends(
    parts: list[tuple[float, float]], path: Path, curve: Any, whole: float, turns: bool
) -> Iterator[Problem]:
    """What is said of the end of the stroke."""
    if parts[-1][0] > 1 + ROUNDED:
        text = N_("the diagram goes to %(end)s, the stroke is %(whole)s")
        scale, unit = (180 / math.pi, "deg") if turns else (1e3, "mm")
        told = {"end": f"{curve[-1][0] * scale:.6g} {unit}", "whole": f"{whole * scale:.6g} {unit}"}
        yield mistake(text, path, Message(N_("state it to the end of the stroke")), **told)
    else:
        yield from not_to_the_end(parts, path, 1.0)
