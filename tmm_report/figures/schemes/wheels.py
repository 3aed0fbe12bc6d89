"""Pitch circles of wheels and pitch lines of racks on a scheme, in the axes of the links, mm."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.mechanics.lever.wheels.mesh import Mesh

if TYPE_CHECKING:
    from tmm_report.figures.schemes.bodies import Motion

FINE = 181  # points of a circle


def circles(mechanism: Mechanism, name: str, mu: float) -> tuple[tuple[complex, ...], ...]:
    """The pitch circles that a link carries."""
    round_ = np.exp(1j * np.linspace(0, 2 * np.pi, FINE))
    found = []
    for mesh in mechanism.meshes:
        if name in mesh.links and mesh.radius(name):
            centre = centre_of(mechanism, mesh, name)
            found.append(tuple(complex(centre + mesh.radius(name) * z) / mu for z in round_))
    return tuple(found)


def centre_of(mechanism: Mechanism, mesh: Mesh, name: str) -> complex:
    """The axis of a wheel in the axes of its link, m."""
    return complex(np.ravel(mechanism.links[name].points[mesh.points[mesh.links.index(name)]])[0])


def racks(motion: Motion, name: str) -> tuple[tuple[complex, complex], ...]:
    """The pitch lines of a link's racks, as long as they pass the wheel."""
    meshes = [mesh for mesh in motion.mechanism.meshes if mesh.kind == "rack" and mesh.links[0] == name]
    return tuple(rack(motion, mesh, name) for mesh in meshes)


def rack(motion: Motion, mesh: Mesh, name: str) -> tuple[complex, complex]:
    """In the axes of the link, from the first to the last place at which it is touched, and a little on."""
    axis, radius = motion.at(mesh.carrier, mesh.axes[1] / motion.mu), mesh.radii[1] / motion.mu
    touched = (axis + radius * mesh.toward - motion.origins[name]) / motion.axes[name]
    turns = motion.axes[name][np.isfinite(motion.axes[name])]  # all the same
    along = mesh.along / complex(turns[0]) if len(turns) else mesh.along
    places = (touched / along)[np.isfinite(touched)]
    past = 0.3 * radius
    across = float(np.mean(places.imag)) if len(places) else 0.0
    ways = places.real if len(places) else np.zeros(1)
    return along * complex(ways.min() - past, across), along * complex(ways.max() + past, across)
