"""The numbers of the force plans: arms, loads reduced to one force, what was worked by hand, comparison."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.force_plans import lever_quantities
from tmm_report.chapters.lever.kinetostatics.quantities.positions import ALONG_STROKE, BALANCING_MOMENT
from tmm_report.chapters.lever.plans.quantities import COMPARISON, comparison
from tmm_report.chapters.lever.structure.quantities import index_of
from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.written import worked_table

if TYPE_CHECKING:  # drafting takes the names of its quantities from here
    from tmm_report.chapters.lever.force_plans.drafting import ForceDrawn
    from tmm_report.chapters.lever.force_plans.solve import ForcePlans

ARMS = Message(N_("arms of the forces as read off the scheme"))
REDUCED = Message(N_("inertia forces and couples reduced to one force through the centre of percussion"))
MU_F = Quantity("mu_F", Symbol("mu", "F"), "N/mm", Message(N_("scale of the force polygon")))
ON_PAPER = Quantity("arm_mm", None, "mm", Message(N_("arm on the scheme")))
ARM = Quantity("arm", Symbol("h"), "m", Message(N_("arm of the force")))
WORST = Quantity(
    "delta_F_max", None, "%", Message(N_("largest difference of force polygons from the analytical method"))
)


MU_L = Quantity("mu_l", Symbol("mu", "l"), "m/mm", Message(N_("scale of the scheme")))

CHOSEN = Quantity("L_largest", Symbol("L"), "mm", Message(N_("length at which the largest force is drawn")))


def arm(force: Quantity, about: str, in_mm: bool = False) -> Quantity:
    """Arm of a force about a point, m, or mm of paper."""
    name = force.sign
    symbol = Symbol("h", name.base + name.sub, name.sup)
    unit = "mm" if in_mm else "m"
    return Quantity(f"h_{force.key}_{about}", symbol, unit, Message(N_("arm of force %(of)s"), {"of": name}))


def base_radius(mesh: Mesh, link: str) -> Quantity:
    """The radius of the base circle: the arm of the force in the teeth about the wheel's axis."""
    index = index_of(mesh)
    meaning = Message(N_("radius of the base circle of the wheel on link %(link)s"), {"link": link})
    return Quantity(f"r_b_{link}_{index}", Symbol("r", f"b{link}"), "m", meaning)


def on_paper(length: Quantity) -> Quantity:
    """A length as the scheme has it, mm of paper."""
    return replace(length, key=f"{length.key}_mm", unit="mm")


def drawn_length(force: Quantity) -> Quantity:
    """Length of the vector of a reaction, or of the balancing force, in the plan."""
    text = N_("length of the vector of reaction %(of)s in the polygon")
    if force.key == ALONG_STROKE.key:
        text = N_("length of the vector of force %(of)s in the polygon")
    symbol = Symbol("L", force.sign.base + force.sign.sub, force.sign.sup)
    return Quantity(f"L_{force.key}", symbol, "mm", Message(text, {"of": force.symbol}))


def moment_sum(about: str, links: tuple[str, ...], in_mm: bool = False) -> Quantity:
    """Sum of the moments of the loads on some links about a point, N m, or N mm of paper."""
    meaning = Message(N_("sum of the moments of the loads about point %(of)s"), {"of": about})
    unit = "N·mm" if in_mm else "N·m"
    return Quantity(f"SigmaM_{about}_{'-'.join(links)}", Symbol("SigmaM", about), unit, meaning)


def percussion_letter(mechanism: Mechanism) -> str:
    """Of the centres of percussion: K, or the next letter with which the name of no point begins."""
    taken = {name[0] for link in mechanism.links.values() for name in link.points}
    taken |= {cam.centre[0] for cam in mechanism.cams}
    return next((letter for letter in "KTNLQUVW" if letter not in taken), "K")


@tabulated
def values(found: ForcePlans) -> Iterator[Value]:
    yield WORST.value(found.worst)


@tabulated
def tables(found: ForcePlans) -> Iterator[Table]:
    for drawn in found.drawn:
        yield from (worked_table(worked) for worked in drawn.worked)
        yield _arms(drawn)
        if drawn.reduced:
            yield _reduced(drawn)
        units = {row.key: "N·m" if row.key == BALANCING_MOMENT.key else "N" for row in drawn.comparison}
        yield comparison(
            f"force_comparison_{drawn.position}", COMPARISON, drawn.comparison, units.__getitem__
        )
    yield from lever_quantities.tables(found.levers)


def compared(drawn: ForceDrawn) -> list[Quantity]:
    """The quantities of the rows of the comparison."""
    known = {quantity.key: quantity for worked in drawn.worked for quantity, _ in worked.rows.values()}
    return [known[row.key] for row in drawn.comparison]


def _arms(drawn: ForceDrawn) -> Table:
    arms = [arm for plan in drawn.plans for arm in plan.arms]
    return Table(
        f"arms_{drawn.position}",
        ARMS,
        (
            text_column("force", Message(N_("force")), [arm.key for arm in arms]),
            text_column(
                "about", Message(N_("point about which the moment is taken")), [a.about for a in arms]
            ),
            ON_PAPER.column([arm.millimetres for arm in arms]),
            ARM.column([arm.metres for arm in arms]),
        ),
    )


def _reduced(drawn: ForceDrawn) -> Table:
    rows = drawn.reduced
    centres = np.array([one.centre for one in rows])
    links, letter = [one.link for one in rows], rows[0].letter
    force = Quantity("F_I", Symbol("F", "I"), "N", Message(N_("inertia force")))
    couple = Quantity("M_I", Symbol("M", "I"), "N·m", Message(N_("inertia couple")))
    h = Quantity("h", Symbol("h"), "m", Message(N_("arm of the one force about the mass centre")))
    return Table(
        f"reduced_{drawn.position}",
        REDUCED,
        (
            text_column("link", Message(N_("link")), links),
            force.column([one.force for one in rows]),
            couple.column([one.couple for one in rows]),
            h.column([one.arm for one in rows]),
            Quantity(
                "x_K", Symbol("x", letter), "m", Message(N_("x coordinate of the centre of percussion"))
            ).column(centres.real),
            Quantity(
                "y_K", Symbol("y", letter), "m", Message(N_("y coordinate of the centre of percussion"))
            ).column(centres.imag),
        ),
    )
