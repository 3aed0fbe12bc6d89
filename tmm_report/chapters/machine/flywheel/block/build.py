"""What the block `flywheel` becomes, SI."""

from tmm_report.chapters.machine.flywheel import given as stated_as
from tmm_report.chapters.machine.flywheel.block.models import (
    FlywheelModel,
    InertiaModel,
    MaterialModel,
    MomentModel,
)
from tmm_report.chapters.machine.flywheel.given import MATERIALS
from tmm_report.chapters.machine.flywheel.given import Given as Stated
from tmm_report.mechanics.calculus.laws import ByAngle, Constant, Harmonics, Law, Wave


def built(w: FlywheelModel) -> Stated:
    return Stated(
        delta=w.delta,
        speeds=w.speeds,
        wheel=w.wheel,
        machine=w.machine or "",
        speed=w.speed,
        motor=w.motor,
        turns=w.turns or 1,
        driving=_law(w.driving),
        resisting=_law(w.resisting),
        areas=stated_as.Areas(tuple(x * w.areas.scale for x in w.areas.values)) if w.areas else None,
        punch=w.punch,
        inertia=_law(w.inertia) or Constant(0.0),
        own=w.own,
        shaft=w.shaft,
        ratio=w.ratio,
        shape=_shape(w),
        material=_material(w.material),
        positions=w.positions or 24,
        friction=w.friction is not False,
    )


def _law(w: MomentModel | InertiaModel | None) -> Law | None:
    if w is None:
        return None
    if w.table is not None:
        return ByAngle.through(w.table)
    if w.harmonics is not None:
        waves = (Wave(one.order, one.cos, one.sin) for one in w.harmonics)
        return Harmonics(w.mean or 0.0, tuple(waves))
    return Constant(w.constant if w.constant is not None else w.mean or 0.0)


def _shape(w: FlywheelModel) -> stated_as.Shape:
    if w.radius_of_gyration is not None:
        return stated_as.Gyration(w.radius_of_gyration)
    return w.rim or w.disc or stated_as.Disc()


def _material(w: str | MaterialModel) -> stated_as.Material:
    return MATERIALS[w] if isinstance(w, str) else stated_as.Material("", w.density, w.speed)
