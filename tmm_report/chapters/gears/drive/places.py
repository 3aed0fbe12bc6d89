"""Where the members of a drive stand on the line of centres, and the points that two members have in common."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from tmm_report.chapters.gears.drive.stages import Stage, member
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.mechanics.gears.trains import FRAME, Member, Mesh

LETTERS = "ABCDEFGKLMNQRSTUVWXYZ"  # names of points; H is a carrier, O an axis, P the pole
SAME = 1e-9  # m: points nearer than this are one


class Spot(NamedTuple):
    """A named point common to two members: a pitch point or the axis of a satellite; or of one alone, to which a belt
    or a chain brings the velocity. `y` m from the main axis.

    `tied`: the spot on the other pulley, whose velocity times `share` this one has; "" of a spot of its own.
    """

    name: str
    y: float
    members: tuple[str, ...]
    axis: bool = False
    tied: str = ""
    share: float = 1.0


def placed(stages: Sequence[Stage]) -> tuple[tuple[int, ...], dict[str, float]]:
    """The side of each stage and the y of every member's axis, m.

    A planetary stage stands above the input shaft, else below its own axis; the driven shaft of a pair below, of one
    that leads back to the axis of the pair before above, as that of a worm which lies below.
    """
    main, axes = 0.0, {}
    sides: list[int] = []
    for stage in stages:
        planetary = any(one.kind == "carrier" for one in stage.members)
        side = 1 if planetary and main == 0 and 1 not in sides else getattr(stage, "side", -1)
        if isinstance(stage, spur.Found) and stage.given.coaxial:
            side = -sides[-1]
        sides.append(side)
        start = member(stage, stage.input).distance
        for one in stage.members:
            axes[one.name] = main + side * (one.distance - start)
        main = axes[stage.output]
    return tuple(sides), axes


def height(stages: Sequence[Stage], axes: Mapping[str, float], sides: Sequence[int]) -> float:
    """How tall the scheme is, m; of a planetary stage's ring only the half with the satellite is drawn."""
    reach = [0.0]
    for stage, side in zip(stages, sides, strict=True):
        for one in stage.members:
            if one.kind != "carrier":
                reach.append(axes[one.name] + side * one.radius)
                halved = one.kind == "ring" and one.name not in (stage.input, stage.output)
                reach.append(axes[one.name] - (0 if halved else side * one.radius))
    return max(reach) - min(reach)


def breadth(stages: Sequence[Stage]) -> float:
    """What the wheels take up along the driving shaft that are seen from their sides there, m: axes cross it."""
    crossing = (stage for stage in stages if any(mesh.crosses for mesh in stage.meshes))
    return sum(2 * member(stage, stage.output).radius for stage in crossing)


def spots_of(stages: Sequence[Stage], axes: Mapping[str, float]) -> Iterator[Spot]:
    """Points of every stage: each mesh's pitch point, and after it the axis of its satellite."""
    letters = iter(_letters())
    for stage in stages:
        by_name = {one.name: one for one in stage.members}
        seen: list[float] = []
        for mesh in stage.meshes:
            yield from _meeting(mesh, by_name, axes, letters)
            for wheel in (by_name[mesh.i], by_name[mesh.j]):
                y = axes[wheel.name]
                if wheel.carried_by != FRAME and all(abs(y - other) > SAME for other in seen):
                    seen.append(y)
                    yield Spot(next(letters), y, (wheel.name, wheel.carried_by), True)


def _meeting(
    mesh: Mesh, by_name: Mapping[str, Member], axes: Mapping[str, float], letters: Iterator[str]
) -> Iterator[Spot]:
    """The pitch point; of a belt or a chain the point of the driving pulley that faces the driven one, and that of the
    driven one which moves the same way; of wheels that slip one point of each."""
    one, two = by_name[mesh.i], by_name[mesh.j]
    share = 1.0 if not mesh.size else two.radius / (one.radius * mesh.size)
    if not mesh.apart and abs(share - 1) < SAME:
        yield Spot(next(letters), _contact(mesh, by_name, axes), (mesh.i, mesh.j))
        return
    side = 1 if axes[mesh.j] > axes[mesh.i] else -1
    first = next(letters)
    yield Spot(first, axes[mesh.i] + side * one.radius, (mesh.i,))
    across = side * two.radius if mesh.internal else -side * two.radius
    yield Spot(next(letters), axes[mesh.j] + across, (mesh.j,), False, first, share)


def _letters() -> Iterator[str]:
    yield from LETTERS
    for number in range(1, 1000):
        yield from (f"{letter}{number}" for letter in LETTERS)


def _contact(mesh: Mesh, by_name: Mapping[str, Member], axes: Mapping[str, float]) -> float:
    """y of the pitch point: it divides the line of centres in the ratio of the radii, outside it if internal."""
    ri, rj = by_name[mesh.i].radius, by_name[mesh.j].radius
    return axes[mesh.i] + (axes[mesh.j] - axes[mesh.i]) * ri / (ri - rj if mesh.internal else ri + rj)


def velocity_of(
    spot: Spot, by_name: Mapping[str, Member], axes: Mapping[str, float], speed: Mapping[str, float]
) -> float:
    """Analytical velocity of a spot, m/s: of the axis of the first wheel there and about it."""
    wheel = by_name[spot.members[0]]
    turned = 0.0 if spot.axis else speed[wheel.name] * (spot.y - axes[wheel.name])
    carried = (
        speed[wheel.carried_by] * (axes[wheel.name] - axes[wheel.carried_by]) if wheel.carried_by else 0.0
    )
    return float(turned + carried)
