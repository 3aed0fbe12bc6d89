"""A compound train taken apart: the rows of its kinematic formula, and the order in which they give the speeds.

A row is two central members and the meshes between them through satellites or idlers, all on axes of one carrier:

    (ω_a − ω_c)/(ω_b − ω_c) = u_ab(c),  the product of (−1)^k z_j/z_i over its meshes, Willis;

in the frame c stands still. Simple trains have one row, closed differentials and 3K two. With all but one speed of a
row known the row gives the last one, so that the rows in a fit order give every speed by that of one member.
Source: Artobolevsky, Theory of mechanisms and machines, ch. VII; Kudryavtsev, Planetary gearing, ch. 1.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Any

from tmm_report.mechanics.gears.trains import FRAME, Train
from tmm_report.records import dataclass

Number = Any  # a float, an array, an expression


@dataclass(frozen=True)
class Link:
    """A mesh of `Train.meshes` by its place, passed from wheel `i` to wheel `j`; `forth`: as the mesh is stated."""

    mesh: int
    i: str
    j: str
    forth: bool


@dataclass(frozen=True)
class Row:
    """Bodies `a` and `b`, and the meshes from a to b on axes of the body `carrier`, "" the frame."""

    a: str
    b: str
    carrier: str
    links: tuple[Link, ...]

    def turned(self) -> Row:
        """The same from b to a."""
        back = tuple(Link(one.mesh, one.j, one.i, not one.forth) for one in reversed(self.links))
        return Row(self.b, self.a, self.carrier, back)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Whose speeds it joins."""
        return tuple(filter(None, (self.a, self.b, self.carrier)))


@dataclass(frozen=True)
class Step:
    """What a row gives: the speed of `body` by those of the other two; the row is turned so that the body is its a, or
    its carrier."""

    body: str
    row: Row


def body_of(train: Train, name: str) -> str:
    """The body of a member, "" of the frame."""
    return train.by_name[name].body if name else FRAME


def satellites(train: Train) -> dict[str, str]:
    """Bodies that a carrier carries, with the carrier's body."""
    return {m.body: body_of(train, m.carried_by) for m in train.members if m.carried_by}


def rows_of(train: Train, outer: Collection[str], held: Collection[str] = ()) -> tuple[Row, ...]:
    """All rows. `outer`: names of members that are driven, held or taken from: the other wheels of the frame are idlers
    where they do nothing besides.

    From the first central member of each connected group of meshes on one carrier to each of the others; one of the
    `held` members is the first where there is one, so that of 3K each row has one speed less.
    """
    carried = satellites(train)
    outside = {body_of(train, name) for name in outer} | set(carried.values())
    still = {body_of(train, name) for name in held}
    groups: dict[str, dict[str, list[Link]]] = {}
    for k, mesh in enumerate(train.meshes):
        edges = groups.setdefault(body_of(train, mesh.carrier), {})
        one, other = body_of(train, mesh.i), body_of(train, mesh.j)
        edges.setdefault(one, []).append(Link(k, mesh.i, mesh.j, True))
        edges.setdefault(other, []).append(Link(k, mesh.j, mesh.i, False))
    found: list[Row] = []
    for carrier, edges in groups.items():
        elsewhere = {body for other, there in groups.items() if other != carrier for body in there}
        central = [
            body
            for body in edges
            if (carried.get(body) != carrier if carrier else body in outside | elsewhere)
        ]
        central.sort(key=lambda body: body not in still)
        while central:
            start = central[0]
            reached = _reached(train, edges, start, set(central))
            found += [Row(start, end, carrier, path) for end, path in reached.items() if end in central[1:]]
            central = [body for body in central if body not in reached]
    return tuple(found)


def _reached(
    train: Train, edges: Mapping[str, list[Link]], start: str, central: set[str]
) -> dict[str, tuple[Link, ...]]:
    """Every body that meshes lead to from `start`, with the way there."""
    found: dict[str, tuple[Link, ...]] = {start: ()}
    waiting = [start]
    for body in waiting:
        for link in edges[body]:
            to = body_of(train, link.j)
            if to not in found:
                found[to] = (*found[body], link)
                waiting.append(to)
    return found


def order(rows: Sequence[Row], known: Iterable[str]) -> tuple[Step, ...] | None:
    """The steps that give every speed from the known ones, by body; None where the rows must be solved together."""
    there, left, steps = {FRAME, *known}, list(rows), []
    while left:
        ready = next((row for row in left if sum(body not in there for body in set(row.bodies)) == 1), None)
        if ready is None:
            return None
        left.remove(ready)
        body = next(body for body in ready.bodies if body not in there)
        steps.append(Step(body, ready.turned() if body == ready.b != ready.carrier else ready))
        there.add(body)
    return tuple(steps)


def by_steps(
    steps: Iterable[Step],
    known: Mapping[str, Number],
    ratio: Callable[[Row], Number],
    still: Collection[str] = (),
    unit: str = "",
    keep: Callable[[Step, Number], Number] = lambda step, value: value,
) -> dict[str, Number]:
    """Speeds of the bodies, from the known ones. `ratio`: u of a row; `still`: bodies that stand; `unit`: a body whose
    speed is 1, which no expression needs to be multiplied by; `keep`: what becomes of a speed as it is found. Works
    with numbers, arrays and expressions alike."""
    speed = dict(known)
    for step in steps:
        speed[step.body] = keep(step, _given_by(step, speed, ratio, {FRAME, *still}, unit))
    return speed


def _given_by(
    step: Step, speed: Mapping[str, Number], ratio: Callable[[Row], Number], still: Collection[str], unit: str
) -> Number:
    row = step.row

    def times(factor: Number, body: str) -> Number | None:
        if body in still:
            return None
        return factor if body == unit else factor * speed[body]

    if step.body != row.carrier:
        u = ratio(row)
        return _sum(times(u, row.b), None if row.carrier in still else times(1 - u, row.carrier))
    if row.b in still:
        return speed[row.a] / (1 - ratio(row)) if row.a not in still else 0.0
    if row.a in still:
        return speed[row.b] / (1 - ratio(row.turned()))
    u = ratio(row)
    return (speed[row.a] - times(u, row.b)) / (1 - u)


def _sum(one: Number | None, other: Number | None) -> Number:
    if one is None:
        return 0.0 if other is None else other
    return one if other is None else one + other


def mesh_ratio(train: Train, link: Link, teeth: Mapping[str, Number] | None = None) -> Number:
    """ω_i/ω_j of a link with its carrier stopped; `teeth`: others than the train's, numbers or arrays by wheel."""
    z = teeth or {name: member.teeth for name, member in train.by_name.items()}
    size = z[link.j] / z[link.i]
    return size if train.meshes[link.mesh].internal else -size


def row_ratio(train: Train, row: Row, teeth: Mapping[str, Number] | None = None) -> Number:
    """u_ab(c) of a row."""
    u: Number = 1.0
    for link in row.links:
        u = u * mesh_ratio(train, link, teeth)
    return u


def weighted(train: Train, row: Row, way: Sequence[float], efficiency: Sequence[float]) -> float:
    """u_ab(c) of a row with each mesh's ratio times η^x, x = +1 where the power goes from a to b through it: −T_b/T_a
    of a row with losses (the method of Kreines). `way`: +1 where wheel i of the stated mesh drives."""
    u = float(row_ratio(train, row))
    for link in row.links:
        x = way[link.mesh] if link.forth else -way[link.mesh]
        u *= efficiency[link.mesh] ** x
    return u


def sign(train: Train, row: Row) -> int:
    """+1 or −1 of u_ab(c)."""
    outside = sum(not train.meshes[link.mesh].internal for link in row.links)
    return -1 if outside % 2 else 1
