"""The picture of Zhukovsky's lever: the turned plan of velocities at its own scale, forces in its points, arms."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from tmm_report.chapters.lever.force_plans.lever import Lever, LeverArm
from tmm_report.figures.drawing import Acting, Acts, Drawing, Item, Tag, dot, together
from tmm_report.figures.lettering import joined, lettered, symbol
from tmm_report.figures.loading import Arm, Force, loading
from tmm_report.figures.plans import PENS, PlanVector, Style, plan
from tmm_report.mechanics.calculus.vectors import unit

STYLES: dict[str, Style] = {"F_I": "inertia", "F_M": "inertia"}  # of keys; others are loads


def lever_picture(lever: Lever, words: Callable[[str], str]) -> Drawing:
    """Forces are not to scale, couples are pairs of forces; `words`: how a word of an index is said."""
    turn, drawn = lever.turn, lever.plan
    vectors = [PlanVector(turn * s.start, turn * s.end, of=s.key) for s in drawn.strokes if s.key]
    vertices = {name: turn * z for name, z in drawn.points.items()} | dict(lever.pitch)
    items = [*plan(vectors, {}).items, *_vertices(vertices, drawn.pole)]
    balancing = lever.driving
    forces = [force for arm in (*lever.arms, balancing) for force in _forces(arm, _style(arm, lever), words)]
    own = [balancing] if lever.thrust else []  # that of the force across the crank is a side of the plan
    arms = [_arm(arm, words) for arm in (*lever.arms, *own) if arm.pair is None]
    shown = loading(items, list(_letters(vertices)), [f for f in forces if abs(f.vector) > 0], arms)
    return replace(shown, acts=_acts(lever, words))


def _acts(lever: Lever, words: Callable[[str], str]) -> Acts:
    acting = []
    for arm in (*lever.arms, lever.driving):
        other, on = arm.ends or ("", arm.point)
        letter, style = lettered(arm.quantity.sign, words), _style(arm, lever)
        acting.append(Acting(arm.quantity.key, arm.place, letter, PENS[style].colour, on, other))
    sides = tuple(stroke.key for stroke in lever.plan.strokes if stroke.key)
    return Acts(lever.position, lever.plan.scale, tuple(acting), sides=sides, turn=lever.turn)


def _style(arm: LeverArm, lever: Lever) -> Style:
    if arm is lever.driving:
        return "reaction"
    return next((style for start, style in STYLES.items() if arm.quantity.key.startswith(start)), "force")


def _vertices(vertices: dict[str, complex], pole: str) -> list[Item]:
    return [dot(place, 0.8 if name == pole else 0.45) for name, place in vertices.items()]


def _letters(vertices: dict[str, complex]) -> Iterator[Tag]:
    middle = sum(vertices.values()) / max(1, len(vertices))
    for names, place in together(vertices):
        out = place - middle
        yield Tag(joined([symbol(name) for name in names]), (place,), prefer=out / abs(out) if out else 0j)


def _forces(arm: LeverArm, style: Style, words: Callable[[str], str]) -> Iterator[Force]:
    label = lettered(arm.quantity.sign, words)
    yield Force(arm.place, arm.vector, label, style, arm.quantity.key)
    if arm.pair is not None:
        yield Force(arm.pair, -arm.vector, label, style)


def _arm(arm: LeverArm, words: Callable[[str], str]) -> Arm:
    along = complex(unit(arm.vector)) if abs(arm.vector) else 1 + 0j
    return Arm(0j, arm.place, along, lettered(arm.arm_quantity.sign, words), arm.arm_quantity.key)
