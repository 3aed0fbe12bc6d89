"""Quantities of a drive that turns the driving link: its balancing moment on the shafts and in the teeth."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, text_column
from tmm_report.quantity.symbols import Symbol

TEETH = Message(N_("forces in the teeth of the drive by the balancing moment of the driving link"))
MEAN, GREATEST = NP_("index", "mean"), NP_("index", "max")

# key, symbol (None of what is never written as one), unit, meaning, number
Row = tuple[str, Symbol | None, str, str, float]


def crank_rows(found: Found) -> Iterator[Row]:
    """The moments of the link that the drive turns, and the torques at the input that overcome them."""
    moments, torque = found.moments, found.given.torque
    if moments is None:
        return
    if moments.friction is not None and not math.isnan(moments.friction):
        rubbing = N_("mean moment of friction in the pairs, reduced to the driving link")
        yield "M_fr", Symbol("M", "fr"), "N·m", rubbing, moments.friction
    mean = N_("mean balancing moment of the driving link over the cycle")
    if moments.rubs:
        mean = N_("mean balancing moment of the driving link over the cycle, friction in the pairs in it")
    yield "M_mean", Symbol("M", MEAN), "N·m", mean, moments.mean
    greatest = N_("balancing moment of the driving link of the greatest size")
    yield "M_greatest", Symbol("M", GREATEST), "N·m", greatest, moments.greatest
    angle = N_("angle turned by the driving link at which the balancing moment has its greatest size")
    yield "M_angle", Symbol("phi", GREATEST), "deg", angle, math.degrees(moments.angle)
    if torque is not None:
        at_input = N_("torque on the input shaft")
        yield "T_mean", Symbol("T", found.input), "N·m", at_input, torque
        times = N_("how many times the greatest balancing moment is the mean one")
        yield "peak", Symbol("k", "M"), "", times, moments.peak


def teeth_columns(found: Found) -> Iterator[Column]:
    """Circumferential and radial force of every mesh, on one satellite where there are several."""
    assert found.moments is not None
    meshes = found.train.meshes
    yield text_column("mesh", Message(N_("wheels in mesh")), [f"{mesh.i}-{mesh.j}" for mesh in meshes])
    forces = list(_forces(found))
    for key, index, times in (("mean", MEAN, 1.0), ("greatest", GREATEST, abs(found.moments.peak))):
        text = N_("circumferential force in the mesh, on one satellite where there are several")
        along = Quantity(f"F_t_{key}", Symbol("F", "t", index), "N", Message(text))
        yield along.column([times * force for force, _ in forces])
        text = N_("radial force in the mesh, on one satellite where there are several")
        across = Quantity(f"F_r_{key}", Symbol("F", "r", index), "N", Message(text))
        yield across.column([times * force * math.tan(angle) for force, angle in forces])


def _forces(found: Found) -> Iterator[tuple[float, float]]:
    """Of every mesh under the mean moment: the circumferential force, N, and the operating pressure angle, rad."""
    torques = iter(found.loads.mesh_torque)
    for stage in found.stages:
        for row, mesh in enumerate(stage.meshes):
            radius = found.train.by_name[mesh.i].radius
            share = stage.satellites if isinstance(stage, planetary.Found) else 1
            force = abs(float(next(torques))) / (radius * share)
            yield force, _angle(stage, row)


def _angle(stage: spur.Found | planetary.Found, row: int) -> float:
    return float(stage.pair.alpha_w if isinstance(stage, spur.Found) else stage.sizes.angles[row])
