"""Where the axes of a train stand on its scheme: heights above the main axis, by the working radii of the wheels.

Satellites and idlers stand above the main axis, other shafts in the frame below; of a chain of satellites each stands
where its own meshes put it, though in truth the chain is bent. Radii are those of the teeth, m; where shift opens a
mesh, the wheels keep them and the drawing has a gap of a few tenths of a module.
"""

from __future__ import annotations

from collections.abc import Mapping

from tmm_report.chapters.gears.train.solve.built import Built
from tmm_report.mechanics.gears.compound.conditions import axes
from tmm_report.quantity.paper import round_scale
from tmm_report.records import dataclass

TALL, SMALL = 75.0, 45.0  # mm: the height above the axis, of bevel wheels, as wide as they are tall, less
SHIFTED = 1.6  # modules: by so much shift may open a mesh; what is farther apart is a bent chain


@dataclass(frozen=True, eq=False)
class Places:
    """`main`: the axis of the carriers, or of the input; `height`: of each member's axis, m; `radius`: of each wheel;
    `plane`: whether all parallel axes lie in one plane as they are drawn, so that velocities may be drawn beside;
    `scale`: m of the train per mm of paper."""

    main: str
    axis: Mapping[str, str]
    height: Mapping[str, float]
    radius: Mapping[str, float]
    plane: bool
    scale: float


def placed(built: Built) -> Places:
    train, of = built.train, axes(built.train)
    radius = {m.name: built.module(m.name) * m.teeth / 2 for m in train.members if m.teeth}
    carriers = [m.name for m in train.members if m.kind == "carrier"]
    main = of[carriers[0] if carriers else built.inputs[0]]
    height = {main: 0.0}
    plane = all(built.flat)
    waiting = [main]
    for one in waiting:
        for mesh, flat in zip(train.meshes, built.flat, strict=True):
            for near, far in ((mesh.i, mesh.j), (mesh.j, mesh.i)):
                if of[near] != one or not flat:
                    continue
                sign = 1 if built.given.carriers else -1  # of carriers only the upper half is drawn
                apart = radius[mesh.j] - radius[mesh.i] if mesh.internal else radius[near] + radius[far]
                # a satellite stands as far out from its ring as that is larger, the ring from it as far in
                if mesh.internal and far == mesh.j:
                    apart = -apart
                place = height[one] + sign * apart
                if of[far] not in height:
                    height[of[far]] = place
                    waiting.append(of[far])
                elif abs(abs(height[of[far]] - height[one]) - abs(apart)) > SHIFTED * max(
                    map(built.module, (mesh.i, mesh.j))
                ):
                    plane = False
    for axis in of.values():
        height.setdefault(axis, 0.0)
    heights = {name: height[axis] for name, axis in of.items()}
    tall = max(abs(heights[name]) + r for name, r in radius.items())
    return Places(main, of, heights, radius, plane, round_scale(tall, TALL if all(built.flat) else SMALL))
