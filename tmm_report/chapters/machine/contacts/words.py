"""What is said of every kind of pair with friction: how it is reckoned, and what follows from its numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.contacts.solve import Solved
from tmm_report.problems import N_
from tmm_report.report.chapter_view import ChapterView

INTRODUCED = {
    "incline": N_(
        "The reaction of the plane leans from its normal by the angle of friction against the motion, so the force "
        "polygon of load, moving force and reaction is a triangle with the angles of the plane and of friction."
    ),
    "wedge": N_(
        "The load is guided upright without friction. The reactions of the sloping face and of the base lean from "
        "their normals by the angles of friction against the motion of the wedge."
    ),
    "sliders": N_(
        "One guided slider drives the other over a sloping face. The reactions of the face and of both guides lean by "
        "their angles of friction, the equilibrium of both sliders gives the efficiency; it is greatest where the "
        "normal of the face halves the angle of the directions increased by the angles of friction."
    ),
    "trial": N_(
        "A force that pulls the body at an angle above the level lifts it, one that pushes it at the same angle below "
        "presses it to the plane; from both the coefficient of friction and the weight follow."
    ),
    "screw": N_("The thread unrolled along its mean diameter is an inclined plane."),
    "pivot": N_(
        "A new pivot presses its bearing uniformly; run in, every place of it wears alike, so that the pressure falls "
        "with the radius, and the moment of friction is less."
    ),
    "belt": N_("Where the belt is about to slip, its tension falls along the contact by Euler's formula."),
    "belt_drive": N_(
        "The belt carries most when the tight side bears its allowed stress and the slack side is about to slip on the "
        "smaller pulley; with this initial tension it is put on."
    ),
    "wheel": N_(
        "The wheel and the ground yield under the load, so the reaction acts ahead of the wheel's middle by the arm of "
        "rolling resistance."
    ),
    "journal": N_(
        "The reaction of the bearing is tangent to the friction circle, against the rotation of the journal."
    ),
    "crank": N_(
        "The force in the connecting rod is tangent to the friction circles of both its pins, that of the bearing to "
        "the friction circle of the shaft; so the arm of the driving force about the shaft is shorter."
    ),
}


SHARP = N_(
    "The flank of a thread with an angle presses more than the load, so its friction is that of a reduced coefficient."
)
COLLAR = N_("The collar adds its moment.")
SHOWN = N_("The forces are shown in figure %(figure)s; R is the reaction.")
PLAIN = N_("The forces are shown in figure %(figure)s.")


def introduced(item: Solved) -> list[str]:
    """How the numbers of a pair are found, in sentences."""
    said = [INTRODUCED[item.kind]]
    if item.kind == "screw" and item.s.number("beta"):
        said.append(SHARP)
    if "M_collar" in item.s:
        said.append(COLLAR)
    return said


def shown(item: Solved) -> str:
    """What is said of the sketch."""
    return SHOWN if item.kind in ("incline", "screw", "journal") else PLAIN


def verdicts(item: Solved, view: ChapterView) -> Iterator[Markup]:
    """Sentences that follow from the numbers of a pair."""
    make = _OF.get(item.kind)
    if make is not None:
        yield from make(item, view)


def _incline(item: Solved, view: ChapterView) -> Iterator[Markup]:
    angles = {"alpha": view.number("alpha"), "phi": view.number("phi")}
    if item.locks:
        text = N_(
            "The slope of %(alpha)s° is not greater than the angle of friction of %(phi)s°: the plane locks by itself, "
            "the load alone does not move the body down."
        )
    else:
        text = N_(
            "The slope of %(alpha)s° is greater than the angle of friction of %(phi)s°: the plane does not lock, the "
            "body slides down by itself if it is not held."
        )
    yield view.t(text, **angles)


def _wedge(item: Solved, view: ChapterView) -> Iterator[Markup]:
    angles = {"alpha": view.number("alpha"), "lock": view.number("alpha_lock")}
    if item.locks:
        text = N_(
            "The angle of %(alpha)s° is not greater than both angles of friction, %(lock)s°: the wedge locks, it must "
            "be pulled out."
        )
    else:
        text = N_(
            "The angle of %(alpha)s° is greater than both angles of friction, %(lock)s°: the load drives the wedge out "
            "if it is not held."
        )
    yield view.t(text, **angles)


def _sliders(item: Solved, view: ChapterView) -> Iterator[Markup]:
    text = N_("The face is best at %(best)s°, where the efficiency is %(eta)s.")
    yield view.t(text, best=view.number("alpha_best"), eta=view.number("eta_best"))


def _trial(item: Solved, view: ChapterView) -> Iterator[Markup]:
    text = N_(
        "The body is moved by the least force, %(force)s N, if it is pulled at the angle of friction, %(phi)s°."
    )
    yield view.t(text, force=view.number("P_least"), phi=view.number("phi"))


def _screw(item: Solved, view: ChapterView) -> Iterator[Markup]:
    angles = {"psi": view.number("psi"), "phi": view.number("phi_red")}
    if item.held:
        text = N_(
            "The lead angle of %(psi)s° is greater than the angle of friction of %(phi)s°: the thread itself does not "
            "lock, but the friction of the collar holds the screw."
        )
    elif item.locks:
        text = N_(
            "The lead angle of %(psi)s° is not greater than the angle of friction of %(phi)s°: the thread locks, the "
            "load does not turn the screw back; such a thread has an efficiency of less than one half."
        )
    else:
        text = N_(
            "The lead angle of %(psi)s° is greater than the angle of friction of %(phi)s°: the thread does not lock, "
            "the load turns the screw back."
        )
    yield view.t(text, **angles)


def _wheel(item: Solved, view: ChapterView) -> Iterator[Markup]:
    if "M" in item.s:
        yield from _driven(item, view)
        return
    values = {"f": view.number("f"), "roll": view.number("f_roll")}
    if item.rolls:
        text = N_(
            "The coefficient of friction, %(f)s, is greater than k/r = %(roll)s: the wheel rolls and does not slide."
        )
    else:
        text = N_(
            "The coefficient of friction, %(f)s, is not greater than k/r = %(roll)s: the wheel slides before it rolls."
        )
    yield view.t(text, **values)
    if not item.rolls:
        yield from _to_roll(item, view)
    if "F" in item.s:
        yield view.t(_pulled(item), force=view.number("F"))


def _to_roll(item: Solved, view: ChapterView) -> Iterator[Markup]:
    """What would make a wheel roll that slides; the load does not matter."""
    if "r_least" not in item.s:
        yield view.t(N_("Without friction no wheel rolls."))
        return
    text = N_(
        "It would roll with a coefficient of friction greater than %(roll)s, with a radius greater than %(r)s mm, or "
        "with an arm of rolling resistance less than %(k)s mm; another load changes nothing, as both forces grow "
        "with it."
    )
    numbers = {
        "roll": view.number("f_roll"),
        "r": view.number("r_least", "mm"),
        "k": view.number("k_most", "mm"),
    }
    yield view.t(text, **numbers)


def _driven(item: Solved, view: ChapterView) -> Iterator[Markup]:
    """Whether a driving wheel slips, and what would help."""
    values = {"moment": view.number("M"), "most": view.number("M_most")}
    if "T" not in item.s:
        text = N_(
            "The moment of %(moment)s N·m does not overcome the rolling resistance: the wheel stays at rest."
        )
        yield view.t(text, **values)
        return
    if item.s.number("M") <= item.s.number("M_most"):
        text = N_(
            "The moment of %(moment)s N·m is not greater than %(most)s N·m: the driving wheel rolls without slipping "
            "and pulls with %(force)s N in steady motion."
        )
        yield view.t(text, **values, force=view.number("T"))
        return
    text = N_(
        "The moment of %(moment)s N·m is greater than %(most)s N·m: the driving wheel slips and pulls with no more "
        "than %(force)s N."
    )
    yield view.t(text, **values, force=view.number("F_slide"))
    text = N_(
        "It would not slip with a coefficient of friction of %(f)s (sand, a rougher tyre), with %(load)s N on the "
        "wheel (more of the weight on the driving axle, ballast), with a radius of %(r)s mm, or if it is started more "
        "gently, with no more than %(most)s N·m."
    )
    numbers = {"f": view.number("f_need"), "load": view.number("N_need"), "r": view.number("r_need", "mm")}
    yield view.t(text, **numbers, most=view.number("M_most"))


def _pulled(item: Solved) -> str:
    """What the stated force at the axle does. A wheel that is pulled faster and faster slides where the friction left
    over from rolling resistance does not turn it as fast: by its moment of inertia, which is not known here."""
    n = item.s.number
    if n("F") < min(n("F_roll"), n("F_slide")):
        return N_("The force of %(force)s N at the axle is less than both: the wheel stays at rest.")
    if not item.rolls:
        return N_("The force of %(force)s N at the axle makes the wheel slide.")
    if n("F") > n("F_slide"):
        return N_(
            "The force of %(force)s N at the axle is greater than both: the wheel gathers speed, and by its moment of "
            "inertia it rolls or slides, too."
        )
    return N_("The force of %(force)s N at the axle makes the wheel roll.")


def _belt_drive(item: Solved, view: ChapterView) -> Iterator[Markup]:
    if "P_best" not in item.s:
        yield view.t(N_("The centrifugal forces of the belt are neglected: its density is not stated."))
        return
    text = N_(
        "The power is greatest at the speed of %(v)s m/s, at which the centrifugal tension is a third of what the belt "
        "bears; it is %(power)s kW."
    )
    yield view.t(text, v=view.number("v_best"), power=view.number("P_best"))


def _crank(item: Solved, view: ChapterView) -> Iterator[Markup]:
    text = N_("Friction in the three journals takes so much of the moment that the efficiency is %(eta)s.")
    yield view.t(text, eta=view.number("eta"))


_OF: dict[str, Any] = {
    "incline": _incline, "wedge": _wedge, "sliders": _sliders, "trial": _trial, "screw": _screw, "wheel": _wheel,
    "belt_drive": _belt_drive, "crank": _crank,
}  # fmt: skip
