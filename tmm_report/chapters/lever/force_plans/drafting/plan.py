"""A finished force plan and the calculations that belong to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from tmm_report.chapters.lever.plans.solve import Comparison
from tmm_report.quantity.formula import Formula, Var, VectorEquation
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.written import Equation, Worked
from tmm_report.records import dataclass

Kind = Literal["gravity", "inertia", "load", "reaction", "component", "inner"]
Stage = Literal["group", "driver", "wheel", "rolling", "rack", "led", "line", "thrust"]
"""What a plan is of: an Assur group; the driving link; a link that a mesh moves, as a wheel, a wheel that rolls or a
rack; where a stroke drives, the link that follows it, its rod or the whole cylinder, the slider or the cylinder's rod
along which the force acts."""


@dataclass(frozen=True)
class Acting:
    """A force on a link as it enters a plan: complex N, world place of application, m, and that place's name.

    `sense`: −1 of a component whose number came out below zero."""

    quantity: Quantity
    kind: Kind
    vector: complex
    at: complex
    point: str = ""
    sense: int = 1

    @property
    def key(self) -> str:
        return self.quantity.key


@dataclass(frozen=True)
class Couple:
    """A moment on a link, N m, + counter-clockwise; `printed`: as its table has it, an inertia couple with its sign, a
    stated moment along its own sense."""

    quantity: Quantity
    value: float
    printed: float

    @property
    def key(self) -> str:
        return self.quantity.key


@dataclass(frozen=True)
class ForceStroke:
    """A vector of a force plan, mm of paper."""

    start: complex
    end: complex
    quantity: Quantity
    kind: Kind

    @property
    def key(self) -> str:
        return self.quantity.key


@dataclass(frozen=True)
class Held:
    """A reaction, or a component of one, on a link as the loading scheme shows it: complex N, world place, m.

    `turned`: a tangential component that came out against the sense assumed for it; `couple`: the moment of a guide,
    N m, in place of a force, or beside it as `moment`.
    """

    quantity: Quantity
    link: str
    vector: complex
    at: complex
    kind: Kind = "reaction"
    turned: bool = False
    couple: float = 0.0
    moment: Quantity | None = None

    @property
    def key(self) -> str:
        return self.quantity.key


@dataclass(frozen=True)
class Pole:
    """The pitch point of two links in mesh: its name and world place, m."""

    name: str
    links: tuple[str, str]
    at: complex


@dataclass(frozen=True)
class Single:
    """Equilibrium of one link, whose polygon the reaction of an inner pair closes."""

    link: str
    equation: VectorEquation
    closing: Quantity


@dataclass(frozen=True)
class Arm:
    """The arm of a force on a link about a joint, read off the scheme: mm of paper, and m.

    `quantity`: what it is called; `centre`: world place of the joint; `at`, `along`: a place, m, and the direction of
    the line in which the force acts.
    """

    force: Quantity
    about: str
    millimetres: float
    metres: float
    quantity: Quantity
    link: str
    centre: complex
    at: complex
    along: complex

    @property
    def key(self) -> str:
        return self.force.key


@dataclass(frozen=True, eq=False)
class Balance:
    """Equilibrium of one link of a group above class II: of its forces, and of the moments about a joint."""

    link: str
    about: str
    forces: VectorEquation
    loads: Formula  # their moment about the joint
    moments: Equation


@dataclass(frozen=True, eq=False)
class ForcePlan:
    """The plan of one group, or of the driving link, at one position.

    `links`: those it is drawn for; `moments`: moment equations with their numbers; `equation`: the vector equation of
    the whole group; `loads`, `couples`: what acts, by link; `scale`: N per mm; `held`: the reactions as the loading
    scheme shows them; `singles`: links whose equilibrium gives an inner reaction. Of a group above class II, `balances`
    of its links, which are solved together, and the `solution`: projections of the reactions, N, and moments, N m.
    `together`: its links must stand in one loading scheme; `drive`: what balances the driving link. `poles`: pitch
    points on its links.
    """

    label: str
    links: tuple[str, ...]
    scale: float
    loads: Mapping[str, tuple[Acting, ...]]
    couples: Mapping[str, tuple[Couple, ...]]
    arms: tuple[Arm, ...]
    moments: tuple[Formula, ...]
    equation: VectorEquation
    strokes: tuple[ForceStroke, ...]
    readings: tuple[Formula, ...]
    balances: tuple[Balance, ...] = ()
    solution: tuple[Var, ...] = ()
    held: tuple[Held, ...] = ()
    singles: tuple[Single, ...] = ()
    together: bool = False
    drive: Couple | None = None
    chosen: Formula | None = None  # the scale, where it follows from a stated segment
    stage: Stage = "group"
    poles: tuple[Pole, ...] = ()

    @property
    def turned(self) -> tuple[Quantity, ...]:
        """Tangential components that came out against the sense assumed for them."""
        return tuple(one.quantity for one in self.held if one.turned)


@dataclass(frozen=True, eq=False)
class Reduced:
    """Inertia force and couple of a link reduced to one force: its arm h = M/F about the mass centre, m, and the
    centre of percussion through which it acts, world place, m, with its letter."""

    link: str
    letter: str
    force: float
    couple: float
    arm: float
    centre: complex


@dataclass(frozen=True, eq=False)
class ForceDrawn:
    """Force plans of one table position, the driving link's last, and the comparison of reactions and moment.

    `inertia`: formulas of the inertia forces and couples, F_I = m a_S and M_I = −J ε; `apart`: links whose inertia
    force and couple are left as they are, as the centre of percussion would lie off the sheet.
    """

    position: int
    inertia: tuple[Formula, ...]
    plans: tuple[ForcePlan, ...]
    reduced: tuple[Reduced, ...]
    worked: tuple[Worked, ...]  # of the inertia forces, then of every plan
    balancing: float  # signed, N m, + counter-clockwise; of a stroke the force, N, + where it grows
    comparison: tuple[Comparison, ...]
    apart: tuple[str, ...] = ()
    acting: tuple[tuple[str, Acting], ...] = ()  # every load by its link, inertia forces in the mass centres
    couples: tuple[tuple[str, Couple], ...] = ()
