"""Forces in the teeth of a drive that turns the driving link, by its balancing moment."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.drive.stages import run
from tmm_report.chapters.gears.drive.values import GREATEST, MEAN
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, text_column
from tmm_report.quantity.symbols import Symbol

TEETH = Message(N_("forces in the teeth of the drive by the balancing moment of the driving link"))


def teeth_columns(found: Found) -> Iterator[Column]:
    """Circumferential and radial force of every mesh, on one satellite where there are several."""
    assert found.moments is not None
    meshes = found.train.meshes
    yield text_column("mesh", Message(N_("wheels in mesh")), [f"{mesh.i}-{mesh.j}" for mesh in meshes])
    forces = list(_forces(found))
    for key, index, times in (("mean", MEAN, 1.0), ("greatest", GREATEST, abs(found.moments.peak))):
        text = N_("circumferential force in the mesh, on one planet gear where there are several")
        along = Quantity(f"F_t_{key}", Symbol("F", "t", index), "N", Message(text))
        yield along.column([times * force for force, _ in forces])
        text = N_("radial force in the mesh, on one planet gear where there are several")
        across = Quantity(f"F_r_{key}", Symbol("F", "r", index), "N", Message(text))
        yield across.column(
            [math.nan if angle is None else times * force * math.tan(angle) for force, angle in forces]
        )


def _forces(found: Found) -> Iterator[tuple[float, float | None]]:
    """Of every mesh under the mean moment: the circumferential force, N, and the operating pressure angle, rad."""
    torques = iter(found.loads.mesh_torque)
    for stage in map(run, found.stages):
        for mesh, angle in zip(stage.meshes, stage.angles, strict=True):
            radius = found.train.by_name[mesh.i].radius
            force = abs(float(next(torques))) / (radius * stage.shares)
            yield force if stage.sized else math.nan, angle
