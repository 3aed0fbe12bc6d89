"""What no single pair with friction can be: where it jams, and where its sizes do not go together."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.machine.contacts.given import (
    Belt,
    BeltDrive,
    Contact,
    Crank,
    Incline,
    Pivot,
    Screw,
    Sliders,
    Trial,
    Wedge,
)
from tmm_report.mechanics.pairs import friction as law
from tmm_report.problems import N_, Message, Problem, mistake

Path = tuple[str | int, ...]
RIGHT_ANGLE = math.pi / 2 - 1e-9


def mistakes(of: Contact, path: Path) -> Iterator[Problem]:
    match of:
        case Incline() | Wedge():
            yield from _steep(of, path)
        case Sliders():
            yield from _sliders(of, path)
        case Trial():
            yield from _trial(of, path)
        case Screw():
            yield from _screw(of, path)
        case Pivot():
            yield from _pivot(of, path)
        case Belt():
            yield from _groove(of.groove, path)
        case BeltDrive():
            yield from _drive(of, path)
        case Crank():
            yield from _crank(of, path)


def _deg(angle: float) -> str:
    return f"{math.degrees(angle):.4g}"


def _steep(of: Incline | Wedge, path: Path) -> Iterator[Problem]:
    phi = law.angle(of.f)
    if not 0 < of.angle < RIGHT_ANGLE:
        text, right = (
            N_("a plane that slopes by %(angle)s° is none"),
            Message(N_("an angle between 0 and 90°")),
        )
        yield mistake(text, (*path, "angle"), right, angle=_deg(of.angle))
    elif (isinstance(of, Wedge) or of.force == "level") and of.angle + phi >= RIGHT_ANGLE:
        text = N_(
            "it jams: the slope of %(angle)s° and the angle of friction of %(phi)s° make a right angle or more, so the "
            "reaction has nothing that lifts the load, however great the force is"
        )
        right = Message(N_("slope it less or take a smaller coefficient"))
        yield mistake(text, (*path, "angle"), right, angle=_deg(of.angle), phi=_deg(phi))


def _sliders(of: Sliders, path: Path) -> Iterator[Problem]:
    phi = law.angle(of.f)
    both = phi + law.angle(of.guides)
    if of.between <= 0:
        text = N_("sliders with %(angle)s° between their directions do not drive one another over a face")
        right = Message(N_("an angle greater than 0°"))
        yield mistake(text, (*path, "between"), right, angle=_deg(of.between))
    elif of.between + both >= math.pi:
        text = N_(
            "it jams: the angle of %(angle)s° between the sliders and the angles of friction make 180° or more"
        )
        right = Message(N_("a smaller angle between the sliders"))
        yield mistake(text, (*path, "between"), right, angle=_deg(of.between))
    else:
        best = law.best_face(of.between, both)  # is told, too, where another one is stated
        wrong = (list(_face(of, path, face)) for face in (best, best if of.face is None else of.face))
        yield from next(filter(None, wrong), [])


def _face(of: Sliders, path: Path, face: float) -> Iterator[Problem]:
    """The reaction of the face leans by φ1 and presses both sliders to the sides of their guides on which the formula
    is built while φ1 ≤ α ≤ θ + φ1."""
    phi = law.angle(of.f)
    jam = of.between + phi + law.angle(of.guides) - RIGHT_ANGLE
    least, most = max(jam, phi), min(RIGHT_ANGLE, of.between + phi)
    if least <= face <= most:
        return
    text = (
        N_("it jams: the normal of the face makes %(angle)s° with the driving direction")
        if not jam < face < RIGHT_ANGLE
        else N_(
            "with the normal of the face at %(angle)s° to the driving direction its reaction presses a slider to the "
            "other side of its guide, for which the efficiency has another formula"
        )
    )
    values = {"least": _deg(least), "most": _deg(most)}
    right = Message(N_("an angle between %(least)s and %(most)s°"), values)
    yield mistake(text, (*path, "face"), right, angle=_deg(face))


def _trial(of: Trial, path: Path) -> Iterator[Problem]:
    if not of.push > of.pull:
        text = N_("a push downwards presses the body to the plane, so it is greater than the pull upwards")
        yield mistake(text, (*path, "push"), Message(N_("a push greater than the pull")))
    if not 0 < of.angle < RIGHT_ANGLE:
        text, right = (
            N_("a force at %(angle)s° cannot move the body"),
            Message(N_("an angle between 0 and 90°")),
        )
        yield mistake(text, (*path, "angle"), right, angle=_deg(of.angle))
    elif (f := law.pulled_and_pushed(of.pull, of.push, of.angle)[0]) > 1:
        text = N_(
            "such forces need a coefficient of friction of %(f)s, and that of a dry body on a plane is less than 1"
        )
        yield mistake(
            text, path, Message(N_("forces closer to one another, or a larger angle")), f=f"{f:.4g}"
        )


def _screw(of: Screw, path: Path) -> Iterator[Problem]:
    if not 0 <= of.profile < RIGHT_ANGLE:
        text = N_("half the angle of the thread is %(angle)s°")
        right = Message(N_("0° for a square thread, 15° for a trapezoidal one, less than 90°"))
        yield mistake(text, (*path, "profile"), right, angle=_deg(of.profile))
        return
    psi = law.lead_angle(of.starts * of.pitch, of.diameter)
    phi = law.reduced_angle(of.f, of.profile)
    if psi + phi >= RIGHT_ANGLE:
        text = N_(
            "it jams: the lead angle of %(psi)s° and the angle of friction of %(phi)s° make a right angle or more"
        )
        right = Message(N_("a smaller pitch or a smaller coefficient"))
        yield mistake(text, path, right, psi=_deg(psi), phi=_deg(phi))
    if of.arm is not None and of.hand_force is not None:
        text = N_("both the arm and the force of the hands are stated")
        yield mistake(text, path, Message(N_("one of them: the other follows")))


def _pivot(of: Pivot, path: Path) -> Iterator[Problem]:
    if of.hole >= of.outer:
        text = N_("the inner radius is not less than the outer one")
        yield mistake(text, (*path, "inner"), Message(N_("an inner radius less than the outer one")))
    if not 0 < of.half_cone <= math.pi / 2 + 1e-12:
        text, right = (
            N_("half the angle of the cone is %(angle)s°"),
            Message(N_("90° for a flat pivot, or less")),
        )
        yield mistake(text, (*path, "half_cone"), right, angle=_deg(of.half_cone))


def _groove(half: float, path: Path) -> Iterator[Problem]:
    if not 0 < half <= math.pi / 2 + 1e-12:
        text, right = (
            N_("half the angle of the groove is %(angle)s°"),
            Message(N_("90° for a flat drum, or less")),
        )
        yield mistake(text, (*path, "groove"), right, angle=_deg(half))


def _drive(of: BeltDrive, path: Path) -> Iterator[Problem]:
    driving, driven = of.diameters
    if 2 * of.distance <= driving + driven:
        text = N_(
            "the pulleys overlap: their axes are %(distance)s m apart, the sum of their radii is %(sum)s m"
        )
        right = Message(N_("axes further apart than the sum of the radii"))
        values = {"distance": f"{of.distance:.4g}", "sum": f"{(driving + driven) / 2:.4g}"}
        yield mistake(text, (*path, "distance"), right, **values)
        return
    v = of.speed * driving / 2
    mass = (of.density or 0.0) * of.width * of.thickness
    if mass * v**2 >= of.stress * of.width * of.thickness:
        text = N_(
            "at %(v)s m/s the centrifugal tension of the belt is all that it bears: nothing is left to carry power"
        )
        right = Message(N_("a smaller speed or a greater stress"))
        yield mistake(text, (*path, "speed"), right, v=f"{v:.4g}")


def _crank(of: Crank, path: Path) -> Iterator[Problem]:
    if not 0 < of.angle < math.pi:
        text = N_("at %(angle)s° from the dead point the force on the slider does not turn the crank on")
        right = Message(N_("an angle between 0 and 180°, in the stroke that the force drives"))
        yield mistake(text, (*path, "angle"), right, angle=_deg(of.angle))
        return
    if of.crank >= of.rod:
        text, right = N_("the rod is not longer than the crank"), Message(N_("a rod longer than the crank"))
        yield mistake(text, (*path, "rod"), right)
        return
    shaft, pin, wrist = (law.friction_circle(of.f, d) for d in of.diameters)
    if pin + wrist >= of.rod:
        text, right = N_("the friction circles are larger than the rod"), Message(N_("smaller journals"))
        yield mistake(text, (*path, "journals"), right)
        return
    tilt = law.tilted_rod(of.angle, of.crank, pin + of.swing * wrist, of.rod)
    if law.crank_moment(of.force, of.angle, of.crank, tilt, shaft + pin) <= 0:
        text = N_(
            "the crank stands in its dead zone: the force in the rod passes through the friction circle of the shaft "
            "and cannot turn it"
        )
        right = Message(N_("a position further from the dead point"))
        yield mistake(text, (*path, "angle"), right)
