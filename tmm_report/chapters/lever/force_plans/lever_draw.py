"""The picture of Zhukovsky's lever: the turned plan of velocities at its own scale, forces in its points, arms."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmm_report.chapters.lever.force_plans.lever import Lever, LeverArm
from tmm_report.figures.drawing import Drawing, Item, Tag, dot, together
from tmm_report.figures.lettering import joined, lettered, symbol
from tmm_report.figures.loading import Arm, Force, loading
from tmm_report.figures.plans import PlanVector, Style, plan
from tmm_report.mechanics.calculus.vectors import unit

STYLES: dict[str, Style] = {"F_I": "inertia", "F_M": "inertia"}  # of keys; others are loads


def lever_picture(lever: Lever, words: Callable[[str], str]) -> Drawing:
    """Forces are not to scale, couples are pairs of forces; `words`: how a word of an index is said."""
    turn, drawn = lever.turn, lever.plan
    vectors = [PlanVector(turn * s.start, turn * s.end, of=s.key) for s in drawn.strokes if s.key]
    vertices = {name: turn * z for name, z in drawn.points.items()} | dict(lever.pitch)
    items = [*plan(vectors, {}).items, *_vertices(vertices, drawn.pole)]
    forces = [force for arm in lever.arms for force in _forces(arm, words)]
    balancing = lever.driving
    forces.append(
        Force(
            balancing.place,
            balancing.vector,
            lettered(balancing.quantity.sign, words),
            "reaction",
            balancing.quantity.key,
        )
    )
    own = [balancing] if lever.thrust else []  # that of the force across the crank is a side of the plan
    arms = [_arm(arm, words) for arm in (*lever.arms, *own) if arm.pair is None]
    return loading(items, list(_letters(vertices)), [f for f in forces if abs(f.vector) > 0], arms)


def _vertices(vertices: dict[str, complex], pole: str) -> list[Item]:
    return [dot(place, 0.8 if name == pole else 0.45) for name, place in vertices.items()]


def _letters(vertices: dict[str, complex]) -> Iterator[Tag]:
    middle = sum(vertices.values()) / max(1, len(vertices))
    for names, place in together(vertices):
        out = place - middle
        yield Tag(joined([symbol(name) for name in names]), (place,), prefer=out / abs(out) if out else 0j)


def _forces(arm: LeverArm, words: Callable[[str], str]) -> Iterator[Force]:
    key = arm.quantity.key
    style: Style = next((style for start, style in STYLES.items() if key.startswith(start)), "force")
    label = lettered(arm.quantity.sign, words)
    yield Force(arm.place, arm.vector, label, style, key)
    if arm.pair is not None:
        yield Force(arm.pair, -arm.vector, label, style)


def _arm(arm: LeverArm, words: Callable[[str], str]) -> Arm:
    along = complex(unit(arm.vector)) if abs(arm.vector) else 1 + 0j
    return Arm(0j, arm.place, along, lettered(arm.arm_quantity.sign, words), arm.arm_quantity.key)
