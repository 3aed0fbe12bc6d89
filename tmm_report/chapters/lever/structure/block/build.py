"""The block `mechanism` -> Mechanism. Only a link's geometry can fail here, and `checks` tries it first."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

from tmm_report.chapters.lever.structure.block import driving
from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.chapters.lever.structure.block.cam_build import cam
from tmm_report.chapters.lever.structure.block.cams import CamModel
from tmm_report.chapters.lever.structure.block.geometry import Geometry
from tmm_report.chapters.lever.structure.block.strokes import models as strokes
from tmm_report.chapters.lever.structure.block.strokes.build import led
from tmm_report.chapters.lever.structure.block.synthesised import (
    Taken,
    coordinate,
    direction,
    placed,
    turning,
)
from tmm_report.chapters.lever.structure.block.weights import Weights, in_the_middle, inertia_of
from tmm_report.chapters.lever.structure.block.wheels.build import meshes
from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.lever.cams.replacing_dyad import replaced
from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive
from tmm_report.mechanics.lever.mechanism import (
    FRAME,
    Assembly,
    Driver,
    Guide,
    Link,
    Mechanism,
    Said,
    Slide,
    ZeroAngle,
    ZeroExtreme,
)
from tmm_report.variant.values import SENSES, SIDES, unit_vector


def mechanism(model: m.MechanismModel, synthesis: Taken = None) -> Mechanism:
    built = with_wheels(model, without_cams(model, synthesis))
    if not model.cams:
        return built
    cams = tuple(cam_of(name, one, built) for name, one in model.cams.items())
    return replaced(built, cams, centre_place(built))


def cam_of(name: str, model: CamModel, built: Mechanism) -> Cam:
    """Raises cam_build.Wrong."""
    driver = built.driver
    sense = 1 if driver.omega > 0 else -1
    return cam(name, model, built.links, built.guides, tuple(built.slides), (driver.link, sense, driver.zero))


def centre_place(built: Mechanism) -> complex:
    """A place of K on the cam that is none of the cam's points: where it really is differs by positions."""
    return complex(1.0 + max((abs(at) for at in built.links[built.driver.link].points.values()), default=0.0))


def without_cams(model: m.MechanismModel, synthesis: Taken = None) -> Mechanism:
    """The mechanism as it is written, without what replaces its cam pairs and without its wheels."""
    geometry = Geometry(model.links, frame(model, synthesis), synthesis)
    weights = Weights(geometry)
    links = {name: link(name, weights) for name in model.links}
    links = {FRAME: Link(FRAME, geometry.frame, said=frame_said(model, synthesis)), **links}
    built = Mechanism(
        links=links,
        driver=driver(model.driver, synthesis),  # type: ignore[arg-type]  # checks: there is one
        guides={name: guide(name, part, links[part.link], synthesis) for name, part in model.guides.items()},
        slides=tuple(
            slide(name, one, links[name]) for name, part in model.links.items() for one in slides_of(part)
        ),
        assembly=tuple(Assembly(key, choice) for key, choice in model.assembly.items()),
        sketch={name: complex(*place) for name, place in model.sketch.items()},
    )
    of = model.driver
    if not (of and of.stroke):
        return built
    return led(built, of.stroke, of.slider, of.cylinder, lambda: with_wheels(model, built))


def with_wheels(model: m.MechanismModel, built: Mechanism) -> Mechanism:
    if not (model.wheels or model.racks or model.rolling):
        return built
    return replace(built, meshes=tuple(meshes(model, built)))


def frame(model: m.MechanismModel, synthesis: Taken = None) -> dict[str, complex]:
    """The fixed points, m. Raises WrongValue for one that is stated by other lengths than those of the synthesis."""
    return {
        name: complex(*(coordinate(part, synthesis) for part in place)) for name, place in model.frame.items()
    }


def frame_said(model: m.MechanismModel, synthesis: Taken) -> Said | None:
    """The coordinates of fixed points that follow from the synthesis; None where none does."""
    found = {
        (name, axis): placed(part, synthesis)
        for name, place in model.frame.items()
        for axis, part in zip("xy", place, strict=True)
        if not isinstance(part, float)
    }
    return Said(coordinates=found) if found else None


def link(name: str, weights: Weights) -> Link:
    model, all_places = weights.links[name], weights.geometry.places()
    places = dict(all_places[name])
    centre = model.mass_centre or (next(iter(places)) if model.mass and len(places) == 1 else None)
    said = Said(
        weights.told(model.mass, name),
        weights.told(inertia_of(model), name),
        places=weights.geometry.stated(name),
    )
    if middle := in_the_middle(name, bool(model.mass), centre, all_places):
        first, second = places
        centre, said = middle, replace(said, middle=(first, second))
        places[middle] = (places[first] + places[second]) / 2
    stated = None if said == Said() else said
    mass, inertia = weights.mass(name), weights.inertia(name)
    if not isinstance(model.inertia, m.InertiaModel):
        return Link(name, places, mass, centre, inertia, said=stated)
    about = model.inertia.about
    central = central_inertia(inertia, mass, places[about] - places[str(centre)])
    return Link(name, places, mass, centre, max(central, 0.0), (about, inertia), stated)


def central_inertia(stated: float, mass: float, away: complex) -> float:
    """J_S = J − m l², kg m², by Steiner: about the mass centre of a link from that about a point `away` from it, m."""
    return stated - mass * abs(away) ** 2


def guide(name: str, model: m.GuideModel, carrier: Link, synthesis: Taken = None) -> Guide:
    if not isinstance(model.through, list):
        at = carrier.points[model.through] if isinstance(model.through, str) else complex(*model.through)
        return Guide(name, model.link, at, unit_vector(direction(model.angle or 0.0, synthesis)))
    start, end = (carrier.points[point] for point in model.through)
    return Guide(name, model.link, start, unit_vector(cmath.phase(end - start)))


def slides_of(model: m.LinkModel) -> list[m.SlideModel]:
    """The link's slides, one or many, written short or long."""
    written = model.slides if isinstance(model.slides, list) else [model.slides] if model.slides else []
    return [m.SlideModel(guide=one) if isinstance(one, str) else one for one in written]


def slide(name: str, model: m.SlideModel, own: Link) -> Slide:
    at = model.at or next(iter(own.points))
    return Slide(name, model.guide, own.points[at], unit_vector(model.angle))


def driver(model: m.DriverModel, synthesis: Taken = None) -> Driver:
    """Of a slider or a cylinder the law of its stroke, whose link the mechanism tells."""
    if model.stroke is not None:
        law = strokes.build(model.stroke)
        return Driver(model.slider or FRAME, 2 * math.pi / law.period, law=law)
    assert model.link is not None  # the model: one of the three is stated
    if model.law is not None:
        law = driving.build(model.law)
        start = ZeroAngle(float(law.of_phase(0.0)[0])) if model.zero is None else zero(model.zero, synthesis)
        return Driver(model.link, 2 * math.pi / law.period, start, law=law)
    speed = model.speed if model.speed is not None else 2 * math.pi / (model.period or math.inf)
    if isinstance(speed, str):  # that of the drive, which puts it here before the mechanism is built for good
        speed = 1.0
    turned = SENSES[model.rotation] * turning(speed, synthesis)
    start, sweep = zero(model.zero, synthesis), direction(model.range, synthesis)
    return Driver(model.link, turned, start, sweep, model.turns, gear(model.gear), model.period)


def gear(model: m.GearModel | None) -> GearDrive | None:
    if model is None:
        return None
    return GearDrive(model.radius, model.alpha_w, model.at, model.flank == "driving")


def zero(model: m.ZeroModel | None, synthesis: Taken = None) -> ZeroAngle | ZeroExtreme:
    if model is None or model.angle is not None:
        return ZeroAngle(direction(model.angle or 0.0, synthesis) if model else 0.0)
    if model.point is not None:
        return ZeroExtreme(point=model.point, direction=SIDES[str(model.extreme)])
    return ZeroExtreme(link=model.link, direction=complex(1 if model.extreme == "counter-clockwise" else -1))
