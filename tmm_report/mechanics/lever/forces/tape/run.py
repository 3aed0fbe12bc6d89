"""A linkage as straight lines, and a motion found by them: what `motion` and `statics` find, to the last bit.

Nothing of this is needed to solve; it saves the general solver's own work where one linkage is solved again and again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.lever.assur_groups import Structure
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.motion import SINGULAR, Linkage, Motion
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.forces.tape.source import Written

Array = Any
Place = int  # where in the list of values a result stands


@dataclass(frozen=True, eq=False)
class Straight:
    """The functions of a linkage of this structure and these groups, and where in the list of values their results
    stand.

    `blank`: the list before anything is run, with the results that are plain numbers in their places. `state`: of each
    field of `State` link -> place; `points`: place, velocity, acceleration; `loads`: link -> force and moment;
    `reactions`: pair, and its force, moment, `at` and `along`; `driven`: force and moment left on the driving
    link, and its pivot.
    """

    structure: Structure
    groups: tuple[Any, ...]
    written: Written
    blank: list[Any]
    state: Mapping[str, Mapping[str, Place]]
    points: Mapping[str, tuple[Place, ...]]
    sines: Mapping[str, Place]
    loads: Mapping[str, tuple[Place, ...]]
    reactions: Mapping[str, tuple[Any, ...]]
    driven: tuple[Place, ...]

    @cached_property
    def functions(self) -> dict[str, Callable[..., None]]:
        return self.written.functions()

    def __getstate__(self) -> dict[str, Any]:
        """What goes to another process: functions are made anew there."""
        return {name: value for name, value in vars(self).items() if name != "functions"}

    def serves(self, linkage: Linkage) -> bool:
        """Whether the linkage is the one that was compiled, not one altered since."""
        return linkage.groups is self.groups and linkage.structure is self.structure

    def motion(self, linkage: Linkage, phi: Array) -> Run:
        """Motion at driver angles `phi`, (P,) or (..., P), rad, at the linkage's own speed."""
        shape = np.broadcast_shapes(linkage.axes, phi.shape) if linkage.axes else phi.shape
        values = self.blank[:]
        with np.errstate(invalid="ignore", divide="ignore"):
            self.functions["motion"](values, phi)
        return Run(self, linkage, phi, shape, values)


class Run(Motion):
    """A motion found by straight lines. Sines and forces are found when they are asked for.

    Who asks for the state may alter it (see `singular.settle`): from then on everything is taken from it.
    """

    straight: Straight
    values: list[Any]
    unaltered: bool  # whether the values are surely still those of the state

    def __init__(
        self, straight: Straight, linkage: Linkage, phi: Array, shape: tuple[int, ...], values: list[Any]
    ):
        omega = linkage.mechanism.driver.omega
        vars(self).update(
            linkage=linkage,
            phi=phi,
            omega=omega,
            shape=shape,
            limits={},
            _arms={},
            straight=straight,
            values=values,
        )
        vars(self)["unaltered"] = True

    @cached_property
    def state(self) -> State:  # type: ignore[override]
        vars(self)["unaltered"] = False
        v = self.values
        parts = {
            name: {link: v[n] for link, n in links.items()} for name, links in self.straight.state.items()
        }
        w, e = parts["w"], parts["e"]
        turned = {link: 1j * w[link] for link in w}  # as `State.turn` has them
        bent = {link: 1j * e[link] - w[link] * w[link] for link in w}
        return State(**parts, iw=turned, ie=bent, phi=self.phi)

    def place(self, point: str) -> Array:
        if self.unaltered:
            return self._whole(self.values[self.straight.points[point][0]])
        return super().place(point)

    def velocity(self, point: str) -> Array:
        if self.unaltered:
            return self._whole(self.values[self.straight.points[point][1]])
        return super().velocity(point)

    def acceleration(self, point: str) -> Array:
        if self.unaltered:
            return self._whole(self.values[self.straight.points[point][2]])
        return super().acceleration(point)

    def turn(self, link: str) -> Array:
        if self.unaltered:
            return self._whole(self.values[self.straight.state["u"][link]])
        return super().turn(link)

    def angular_velocity(self, link: str) -> Array:
        if self.unaltered:
            return self._whole(self.values[self.straight.state["w"][link]])
        return super().angular_velocity(link)

    def angular_acceleration(self, link: str) -> Array:
        if self.unaltered:
            return self._whole(self.values[self.straight.state["e"][link]])
        return super().angular_acceleration(link)

    @cached_property
    def sines(self) -> dict[str, Array]:  # type: ignore[override]
        with np.errstate(invalid="ignore", divide="ignore"):
            if not self.unaltered:
                return {g.group.label: self._whole(g.closeness(self.state)) for g in self.linkage.groups}
            self.straight.functions["sines"](self.values)
        return {label: self._whole(self.values[n]) for label, n in self.straight.sines.items()}

    def inertia_and_gravity(self, gravity: complex) -> dict[str, tuple[Array, Array]]:
        """Force and moment of every moving link (see `statics.inertia_and_gravity`)."""
        v = self.values
        self.straight.functions["loads"](v, gravity)
        return {link: (v[force], v[moment]) for link, (force, moment) in self.straight.loads.items()}

    def forces(self, loads: Mapping[str, Any]) -> list[Any] | None:
        """The values with the reactions under `loads`; None where a group is in a singular position anywhere."""
        v, lines = self.values, self.straight
        given = [part for link in lines.loads for part in (loads[link].force, loads[link].moment)]
        with np.errstate(invalid="ignore", divide="ignore"):
            lines.functions["sines"](v)
            if any((v[n] <= SINGULAR).any() for n in lines.sines.values()):
                return None
            lines.functions["forces"](v, *given)
        return v
