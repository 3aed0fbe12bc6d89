"""Segments of `drawing` by their names: OA of a link, pa and πa of the plans, force."""

from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Annotated, Any

from tmm_report.chapters.lever.plans.given import Kind, Segment
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.errors import near
from tmm_report.variant.values import Reads, quantity

LENGTH = quantity("length", 1e-3, 2.0, "1 … 2000 mm")
Written = Annotated[Any, Reads(lambda value: value, LENGTH.schema)]
"""Read only where its name is that of a segment: a key mistyped is none, whatever its value."""

Meant = tuple[str, Kind, tuple[str, ...]]  # as lettered, what of, its points

FORCE = "force"
POLES: tuple[tuple[str, str, Kind], ...] = (
    ("pi", "π", "acceleration"), ("π", "π", "acceleration"), ("p", "p", "velocity"),
)  # fmt: skip


def known(links: Mapping[str, list[str]]) -> dict[str, Meant]:
    """Every name that a segment of the mechanism may have. `links`: link -> its points."""
    found: dict[str, Meant] = {FORCE: (FORCE, "force", ())}
    fixed = set(links.get(FRAME, ()))
    moving = dict.fromkeys(point for points in links.values() for point in points if point not in fixed)
    for written, pole, kind in POLES:
        for point in moving:
            small = point.lower()
            found.setdefault(written + small, (pole + small, kind, (point,)))
    for points in links.values():
        for pair in combinations(points, 2):
            for one, other in (pair, pair[::-1]):
                found.setdefault(one + other, (one + other, "length", (one, other)))
    return found


def segments(written: Mapping[str, Any], links: Mapping[str, list[str]]) -> tuple[Segment, ...]:
    names = known(links)
    return tuple(Segment(*names[name], mm=LENGTH.read(value) * 1e3) for name, value in written.items())


def mistakes(
    written: Mapping[str, Any], links: Mapping[str, list[str]], stated: set[Kind], others: list[str]
) -> Iterator[Problem]:
    """`stated`: scales that are written as numbers; `others`: the other keys that stand beside the segments."""
    names = known(links)
    first: dict[Kind, str] = {}
    for name, value in written.items():
        path = ("drawing", name)
        if name not in names:
            usual = [name for name in names if not name.startswith("π")]
            text = N_("%(name)s is neither a key of the drawing nor a segment of the scheme or the polygons")
            yield mistake(text, path, near(name, [*others, *usual]), name=shown(name))
            continue
        try:
            LENGTH.read(value)
        except WrongValue as error:
            yield Problem(error.wrong, error.right, path)
        kind = names[name][1]
        if kind in stated:
            text = N_("the scale is stated twice: by the segment %(name)s and in drawing.scales.%(key)s")
            yield mistake(text, path, Message(N_("leave one of the two")), name=name, key=kind)
        elif kind in first:
            text = N_("two segments, %(first)s and %(name)s, state one scale")
            yield mistake(text, path, Message(N_("leave one of the two")), first=first[kind], name=name)
        first.setdefault(kind, name)
