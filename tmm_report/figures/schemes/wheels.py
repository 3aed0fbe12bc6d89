"""Pitch circles of wheels and pitch lines of racks on a scheme, in the axes of the links, mm."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.mechanics.lever.wheels.mesh import Mesh

FINE = 181  # points of a circle


def circles(mechanism: Mechanism, name: str, mu: float) -> tuple[tuple[complex, ...], ...]:
    """The pitch circles that a link carries."""
    round_ = np.exp(1j * np.linspace(0, 2 * np.pi, FINE))
    found = []
    for mesh in mechanism.meshes:
        if name in mesh.links and mesh.radius(name):
            centre = _number(mechanism.links[name].points[mesh.points[mesh.links.index(name)]])
            found.append(tuple(complex(centre + mesh.radius(name) * z) / mu for z in round_))
    return tuple(found)


def racks(
    mechanism: Mechanism, name: str, mu: float, travel: tuple[float, float]
) -> tuple[tuple[complex, complex], ...]:
    """The pitch lines of a link's racks, as long as they pass the wheel. `travel`: least and greatest way of the
    link along its guide from the guide's own point, mm."""
    return tuple(
        _rack(mechanism, mesh, mu, travel)
        for mesh in mechanism.meshes
        if mesh.kind == "rack" and mesh.links[0] == name
    )


def _rack(
    mechanism: Mechanism, mesh: Mesh, mu: float, travel: tuple[float, float]
) -> tuple[complex, complex]:
    slide = next(
        s for s in mechanism.slides
        if s.link == mesh.links[0] and mechanism.guides[s.guide].link == FRAME
    )  # fmt: skip
    turn = _number(slide.direction) / mesh.along  # from the drawing's axes to the slider's
    away = mesh.pitch_point - mesh.through
    along, across = float(dot(mesh.along, away)) / mu, float(dot(1j * mesh.along, away)) / mu
    own = _number(slide.through) / mu
    past = 0.3 * mesh.radii[1] / mu
    ends = (along - travel[1] - past, along - travel[0] + past)
    first, last = (own + turn * mesh.along * complex(end, across) for end in ends)
    return first, last


def _number(value: Any) -> complex:
    return complex(np.ravel(value)[0])
