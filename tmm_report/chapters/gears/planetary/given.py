"""What a planetary stage states."""

from __future__ import annotations

from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import Task
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Given:
    """A planetary stage. `task`: what teeth are sought for, its ratio with the held member at rest.

    `names`: of wheel 1, of the satellite (its two crowns), of wheel 3 and of the carrier. `teeth`: z1, z2, z2', z3
    chosen by the teacher. `second`: the held member and its speed, rad/s: a differential with two inputs.
    `helix`: angle of the teeth on the pitch cylinders, rad: modules, rack and shifts of the task are then those of the
    transverse section, `module_n` of each row, m, and `rack_n` those of the normal one. `efficiency`: η_H, of the stage
    with its carrier stopped. `any_scheme`: the four schemes are judged side by side, that of `task` is none; `names`
    are then those of two rows.
    """

    task: Task
    names: tuple[str, ...] = ("1", "2", "3", "H")
    efficiency: float = 0.98
    teeth: tuple[int, int, int, int] | None = None
    driven: float | None = None
    title: str = ""
    any_scheme: bool = False
    helix: float = 0.0
    module_n: tuple[float, float] | None = None
    rack_n: Rack | None = None

    def member(self, member: p.Member) -> str:
        """The name of wheel 1, wheel 3 or the carrier."""
        return {"wheel1": self.names[0], "wheel3": self.names[-2], "carrier": self.names[-1]}[member]

    @property
    def crowns(self) -> tuple[str, str]:
        """Names of the crowns that mesh with wheels 1 and 3: in a single row one."""
        return self.names[1], self.names[-3]

    @property
    def wheels(self) -> tuple[str, str, str, str]:
        """Names of the wheels in the order of the teeth z1, z2, z2', z3."""
        return self.names[0], *self.crowns, self.names[-2]

    @property
    def one_module(self) -> bool:
        """Whether both rows have the same module."""
        return self.task.scheme.single or self.task.modules[0] == self.task.modules[1]
