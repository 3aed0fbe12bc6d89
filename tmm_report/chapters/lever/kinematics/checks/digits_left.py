"""How many digits remain near singular positions, and which positions these are.

Where the sine of a group's transmission angle is s, s² is known to the rounding ε of a double, and s itself, by which
velocities, accelerations and forces are divided, to ε/s² of its size: so are they, times a few. No method has more in
doubles, as a rounding of the lengths alone changes them as much.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.lever.motion import SINGULAR, Motion
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any

COST = 10 * np.finfo(float).eps  # of velocities, accelerations and forces far from singular positions
FEW = 9  # digits: where fewer remain the position is told to be near a singular one
PRINTED = 6  # digits: the most that a table prints; where fewer remain printed ones are wrong
MOST = 6  # positions that are told one by one


@dataclass(frozen=True)
class Near:
    """Positions in which a group is near a singular one: angles of turn, rad, and numbers of those of the table.

    `closeness`: the least; `digits`: that remain of velocities, accelerations and forces in the worst of them.
    """

    group: str  # label
    links: tuple[str, ...]
    turned: tuple[float, ...]
    positions: tuple[int, ...]
    closeness: float
    digits: int

    @property
    def text(self) -> Message:
        values = {
            "group": self.group,
            "least": f"{self.closeness:.1e}",
            "digits": self.digits,
            "angles": _listed([f"{np.degrees(x):.2f}°" for x in self.turned]),
            "positions": _listed([str(k) for k in self.positions]),
        }
        return Message(AT_POSITIONS if self.positions else BETWEEN, values)

    @property
    def problem(self) -> Problem:
        links = {"links": ", ".join(self.links)}
        text, right = self.text, Message(N_("other lengths of links %(links)s keep away from it"), links)
        return doubt(text.text, ("mechanism", "links", self.links[0]), right, **text.values)


AT_POSITIONS = N_(
    "at the angle of rotation φ = %(angles)s (positions %(positions)s) group %(group)s is near a singular "
    "position, its closeness is %(least)s: %(digits)s digits remain of the velocities, accelerations and forces "
    "there"
)
BETWEEN = N_(
    "at the angle of rotation φ = %(angles)s group %(group)s is near a singular position, its closeness is "
    "%(least)s: %(digits)s digits remain of the velocities, accelerations and forces there"
)


def _listed(parts: list[str]) -> str:
    return ", ".join(parts if len(parts) <= MOST else [*parts[:MOST], "…"])


def digits_left(sine: Array) -> Array:
    """Decimal digits that remain of velocities, accelerations and forces where a group's closeness is this."""
    return np.maximum(np.floor(-np.log10(COST) + 2 * np.log10(np.maximum(sine, 1e-300))), 0.0)


def rounding(motion: Motion) -> Array:
    """Relative error of velocities, accelerations and forces at every position, (P,): a group divides what it takes
    over from those before it by its closeness, and adds its own. In singular positions there are none to be wrong."""
    found = np.zeros(motion.shape)
    for group in motion.linkage.groups:
        sine = motion.sines[group.group.label]
        with np.errstate(invalid="ignore"):
            there = (sine > SINGULAR) & ~motion.limits.get(group.group.label, np.False_)
        sine = np.where(there, sine, 1.0)
        found = found / sine + COST / sine**2
    return found


def near(found: Kinematics) -> tuple[Near, ...]:
    """Of every group the positions of table and diagram in which few digits remain."""
    return tuple(one for group in found.linkage.groups if (one := _near(found, group)) is not None)


def _near(found: Kinematics, group: Any) -> Near | None:
    label = group.group.label
    turned, sines = [], []
    for motion, angles in ((found.table, found.turned), (found.diagram, found.diagram_turned)):
        sine = motion.sines[label]
        with np.errstate(invalid="ignore"):
            # nearer than that they are limits, or left out
            few = (sine > SINGULAR) & ~motion.limits.get(label, np.False_) & (digits_left(sine) < FEW)
        turned.append(np.where(few, angles, np.nan))
        sines.append(sine[few])
    if not any(part.size for part in sines):
        return None
    closeness = float(min(part.min() for part in sines if part.size))
    positions = tuple(int(k) for k in np.flatnonzero(np.isfinite(turned[0])))
    all_ = np.concatenate(turned)
    angles = distinct(np.round(all_[np.isfinite(all_)], 9))
    return Near(label, group.links, tuple(angles.tolist()), positions, closeness, int(digits_left(closeness)))
