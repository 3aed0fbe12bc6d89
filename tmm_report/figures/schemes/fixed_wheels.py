"""Wheels and racks of the frame on a scheme, hatched on the side of the material."""

from __future__ import annotations

import cmath

from tmm_report.figures.drawing import NORMAL, THIN, Circle, Item, line
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.bodies import Motion
from tmm_report.figures.schemes.wheels import centre_of, rack
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.mesh import Mesh

HATCH, APART = 1.6, 3.0  # length of a stroke of the hatching, and how far they are apart at least, mm
FEWEST, SLANT = 24, cmath.rect(1.0, 0.7)


def fixed(motion: Motion) -> list[Item]:
    items: list[Item] = []
    for mesh in motion.mechanism.meshes:
        if FRAME in mesh.links:
            items += _rail(motion, mesh) if mesh.kind == "rack" else _wheel(motion, mesh)
    return items


def _rail(motion: Motion, mesh: Mesh) -> list[Item]:
    return marks.ground(*rack(motion, mesh, FRAME), mesh.toward)


def _wheel(motion: Motion, mesh: Mesh) -> list[Item]:
    centre = centre_of(motion.mechanism, mesh, FRAME) / motion.mu
    radius = mesh.radius(FRAME) / motion.mu
    out = HATCH if mesh.rings(FRAME) else -HATCH
    count = max(FEWEST, int(2 * cmath.pi * radius / APART))
    strokes = []
    for k in range(count):
        z = cmath.rect(1.0, 2 * cmath.pi * k / count)
        strokes.append(line(centre + radius * z, centre + (radius + out * SLANT) * z, THIN))
    return [Circle(centre, radius, NORMAL), *strokes]
