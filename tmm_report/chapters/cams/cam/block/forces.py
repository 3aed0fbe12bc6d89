"""The keys of a cam's forces -> Given, and what they say wrong of one another."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.cams.cam.block.alone import CamAloneModel
from tmm_report.chapters.cams.cam.block.loads import (
    SMALLEST,
    STOCK,
    ForceLaw,
    MaterialModel,
    MomentLaw,
    PinModel,
    SpringModel,
    TorsionModel,
)
from tmm_report.chapters.cams.cam.given import Forces, Given, SpringAsked
from tmm_report.mechanics.calculus.laws import ByAngle, ByDisplacement, Constant, Law
from tmm_report.mechanics.cams.contact_pressure import Material
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.forces import Guide, Pin, Rubs
from tmm_report.mechanics.cams.turn import Contact, Loaded, Spring
from tmm_report.problems import N_, Message, Problem, mistake


def built_forces(stated: CamAloneModel, own: Given) -> Forces:
    swings = stated.swinging
    spring = stated.torsion if swings else stated.spring
    rubs = Rubs(
        guide=None if stated.guide is None else Guide(
            stated.guide.length, stated.guide.overhang, stated.guide.friction, stated.guide.shortens
        ),
        pin=_pin(stated.pin), face=stated.face_friction or 0.0, pivot=_pin(stated.pivot),
    )  # fmt: skip
    mass = stated.mass or 0.0
    loaded = Loaded(
        own.cam, own.sense, own.omega or 0.0, 0.0, (stated.inertia or 0.0) if swings else mass, mass,
        complex(stated.mass_centre or 0.0), -1j * (stated.gravity or 0.0),
        _law(stated.moment if swings else stated.load), _spring(spring), rubs, stated.closure == "groove",
        _contact(stated),
    )  # fmt: skip
    asked = _asked(spring)
    permitted = stated.contact.permitted if stated.contact else None
    weighs = bool(stated.gravity and mass)
    return Forces(loaded, asked, tuple(stated.at), permitted, weighs, own.table, own.diagram)


def _pin(stated: PinModel | None) -> Pin | None:
    return None if stated is None else Pin(stated.half, stated.friction)


def _law(stated: float | ForceLaw | MomentLaw | None) -> Law:
    if stated is None or isinstance(stated, int | float):
        return Constant(float(stated or 0.0))
    if stated.constant is not None:
        return Constant(stated.constant)
    if stated.by_angle is not None:
        return ByAngle.through(stated.by_angle, FULL_TURN)
    if stated.forward is not None and stated.back is not None:
        return ByDisplacement(1 + 0j, tuple(stated.forward), tuple(stated.back))
    out, back = ((0.0, x or 0.0) for x in (stated.rise, stated.return_))
    return ByDisplacement(1 + 0j, (out, (1.0, out[1])), (back, (1.0, back[1])))


def _spring(stated: str | SpringModel | TorsionModel | None) -> Spring:
    """One of which nothing is to be found."""
    if stated is None or _asked(stated) is not None or isinstance(stated, str):
        return Spring(0.0, 0.0)
    assert isinstance(stated.rate, float)
    return Spring(_preload(stated) or 0.0, stated.rate)


def _preload(stated: SpringModel | TorsionModel) -> float | None:
    pressed = stated.compression if isinstance(stated, SpringModel) else stated.turned
    if pressed is not None and isinstance(stated.rate, float):
        return stated.rate * pressed
    return stated.preload if isinstance(stated.preload, float) else None


def _asked(stated: str | SpringModel | TorsionModel | None) -> SpringAsked | None:
    """What is to be found of a spring; None where nothing is."""
    if stated is None:
        return None
    if isinstance(stated, str):
        return SpringAsked()
    rate = stated.rate if isinstance(stated.rate, float) else None
    preload = _preload(stated)
    if rate is not None and preload is not None:
        return None
    return SpringAsked(rate, preload, stated.ratio, stated.reserve)


def _contact(stated: CamAloneModel) -> Contact | None:
    own = stated.contact
    return None if own is None else Contact(own.width, _material(own.cam), _material(own.follower))


def _material(stated: str | MaterialModel) -> Material:
    if isinstance(stated, MaterialModel):
        return Material(stated.young, stated.poisson)
    return Material(*STOCK[stated])


# ---------------------------------------------------------------- mistakes


FOREIGN = {
    True: ("load", "spring", "guide"),
    False: ("moment", "torsion", "pivot", "inertia", "mass_centre"),
}
OTHERS = {
    "load": "moment", "spring": "torsion", "guide": "pivot", "moment": "load", "torsion": "spring",
    "pivot": "guide", "inertia": "mass",
}  # fmt: skip


def wrong(stated: CamAloneModel, own: Given) -> Iterator[Problem]:
    """What the keys say wrong of one another and of the cam."""
    yield from _foreign(stated)
    yield from _rubbing(stated, own.cam.roller)
    yield from _speed(stated)
    if stated.at and stated.model_fields_set.isdisjoint({*FOREIGN[True], *FOREIGN[False], "mass"}):
        text = N_("nothing loads the follower, so that no forces can be asked for")
        yield mistake(text, ("cam", "at"), Message(N_("load: 200 N, mass: 1.8 kg, spring: {…}")))


def _foreign(stated: CamAloneModel) -> Iterator[Problem]:
    """What is of the other kind of follower."""
    for key in FOREIGN[stated.swinging]:
        if key in stated.model_fields_set:
            text = (
                N_("%(key)s is of a follower that slides; this one swings")
                if stated.swinging
                else N_("%(key)s is of a follower that swings; this one slides")
            )
            other = OTHERS.get(key)
            right = (
                Message(N_("%(key)s, in its place"), {"key": other}) if other else Message(N_("leave it out"))
            )
            yield mistake(text, ("cam", key), right, key=key)
    if stated.swinging and stated.mass_centre is not None and stated.mass is None:
        yield mistake(N_("the centre of mass is stated without the mass"), ("cam", "mass_centre"))


def _rubbing(stated: CamAloneModel, roller: float | None) -> Iterator[Problem]:
    """`roller`: its radius, m, also of one that was chosen."""
    rolls = bool(roller)
    if stated.pin is not None and not rolls:
        text = N_("an edge or a flat face slides on its cam and has no pin")
        yield mistake(text, ("cam", "pin"), Message(N_("face_friction: 0.1")))
    if stated.pin is not None and roller and stated.pin.half >= roller:
        right = Message(N_("below %(most)s mm, the diameter of the roller"), {"most": f"{2e3 * roller:g}"})
        yield mistake(N_("the pin of a roller is as thick as the roller itself"), ("cam", "pin"), right)
    if stated.face_friction is not None and rolls:
        text = N_("a roller does not slide on its cam")
        yield mistake(text, ("cam", "face_friction"), Message(N_("pin: {diameter: 8 mm, friction: 0.1}")))
    if stated.contact is not None and not rolls and not stated.faced:
        text = N_("an edge touches the cam along no width: its pressure has no bound")
        yield mistake(text, ("cam", "contact"), Message(N_("roller: 10 mm, or leave it out")))


def _speed(stated: CamAloneModel) -> Iterator[Problem]:
    """The inertia of the follower needs the speed, the least spring its inertia."""
    massive = stated.inertia if stated.swinging else stated.mass
    if massive and stated.speed is None:
        text = N_("the inertia of the follower needs the speed of the cam")
        yield mistake(text, ("cam",), Message(N_("speed: 150 rpm")))
    key = "torsion" if stated.swinging else "spring"
    spring = getattr(stated, key)
    finds = spring == SMALLEST or (spring is not None and _asked(spring) is not None)
    if finds and not massive:
        text = N_("the least spring holds against the inertia of the follower, of which nothing is stated")
        right = N_("inertia: 0.004 kg*m^2") if stated.swinging else N_("mass: 1.8 kg")
        yield mistake(text, ("cam", key), Message(right))
