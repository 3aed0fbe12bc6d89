"""What is given of a cam that stands alone, and of the forces that it has to overcome."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.cams.cam import Cam
    from tmm_report.mechanics.cams.turn import Loaded

Follower = Literal["roller", "knife", "flat"]


@dataclass(frozen=True, eq=False)
class Given:
    """A cam with its follower over a turn: `sense` +1 counter-clockwise; `omega`: rad/s, above zero, None where no
    speed is stated; `table`, `diagram`: equal parts of the turn for the tables and the curves;
    `shaft`: its diameter, m; `cutter`: its radius, m, where the path of its centre is asked for; `groove`: the
    roller runs between two walls; `driven`: the drive's output shaft turns it."""

    cam: Cam
    sense: int
    omega: float | None = None
    table: int = 12
    diagram: int = 72
    shaft: float | None = None
    cutter: float | None = None
    groove: bool = False
    driven: bool = False


@dataclass(frozen=True)
class SpringAsked:
    """A spring of which something is to be found: `rate`, N/m or N m/rad, `preload`, N or N m, None of what is; `ratio`
    of the preload by the greatest force; `reserve`: K."""

    rate: float | None = None
    preload: float | None = None
    ratio: float | None = None
    reserve: float = 1.0


@dataclass(frozen=True, eq=False)
class Forces:
    """`loaded`: the follower with its loads, without a spring of which something is to be found, `spring`; `asked`:
    angles turned at which forces are wanted, rad; `permitted`: pressure in the contact, Pa; `weighs`: whether the
    weight counts."""

    loaded: Loaded
    spring: SpringAsked | None = None
    asked: tuple[float, ...] = ()
    permitted: float | None = None
    weighs: bool = False
    table: int = 12
    diagram: int = 72
