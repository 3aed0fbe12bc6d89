"""Analogues of velocities and accelerations: derivatives by the angle of turn of the driving link; the time.

S′ = dS/dφ, S″ = d²S/dφ² of sliders, ψ′ and ψ″ of links, φ being the angle turned in the sense of rotation:
V = S′·|ω₁|, a = S″·ω₁² + S′·ε₁ with ε₁ = 0. Of a driving link that moves by a law of the time they are found with
that link at 1 rad/s counter-clockwise; then V = S′·ω₁ with the sign of ω₁. Source: Artobolevsky, Theory of mechanisms
and machines, ch. 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.points_and_links import angle, where
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Output, Travel
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.motion import solve as solve_motion
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, kept
from tmm_report.quantity.symbols import Symbol

Array = Any

ANALOGUES = Message(N_("analogues of the velocities and accelerations of the output links and driven links"))
TIME = Quantity("t", Symbol("t"), "s", Message(N_("time from position 0")))

SLIDER = (
    ("dS", "S′", "m", N_("analogue of the velocity of slider %(name)s")),
    ("ddS", "S′′", "m", N_("analogue of the acceleration of slider %(name)s")),
)
LINK = (
    ("dpsi", "psi′", "", N_("analogue of the angular velocity of link %(name)s")),
    ("ddpsi", "psi′′", "", N_("analogue of the angular acceleration of link %(name)s")),
)


def analogues_of(output: Output) -> tuple[Quantity, Quantity]:
    """Analogues of the velocity and of the acceleration of an output or of a link."""
    return _analogues_of(output.kind, output.name)


@kept
def _analogues_of(kind: str, name: str) -> tuple[Quantity, Quantity]:
    first, second = (
        Quantity(f"{key}_{name}", Symbol(base, name), unit, Message(text, {"name": name}))
        for key, base, unit, text in (SLIDER if kind == "slider" else LINK)
    )
    return first, second


def moving(found: Kinematics) -> tuple[Travel, ...]:
    """Sliders, then all driven links that turn."""
    return (*found.travels, *found.links)


def tables(found: Kinematics) -> Iterator[Table]:
    """At the table positions and at the diagram positions."""
    for name, turned in (("table", found.turned), ("diagram", found.diagram_turned)):
        columns = [column for travel in moving(found) for column in _of(found, travel, name)]
        at = where(turned, found.by_law)
        yield Table(f"analogues_{name}", ANALOGUES, (*at, time(found, turned), *columns))


LAW_ANGLE = "phi_law"


def by_law(found: Kinematics, turned: Array) -> tuple[Column, ...]:
    """The angle of a driving link that moves by a law, without jumps of a turn; nothing of another."""
    if not found.by_law:
        return ()
    link = found.linkage.mechanism.driver.link
    own = replace(angle(link), key=LAW_ANGLE)
    return (replace(own.column(np.degrees(found.cycle.phi(turned))), asked=False),)


def time(found: Kinematics, turned: Array) -> Column:
    """Time at which the driving link has turned so far, s."""
    return replace(TIME.column(turned / abs(found.omega)), asked=False)


def in_unit_motion(motion: Motion) -> Motion:
    """The same positions with the driving link at 1 rad/s: the rates by its angle."""
    return solve_motion(motion.linkage, motion.phi, 1.0)


def _of(found: Kinematics, travel: Travel, name: str) -> Iterator[Column]:
    first, second = analogues_of(travel.output)
    if found.by_law:
        unit = in_unit_motion(found.table if name == "table" else found.diagram)
        yield first.column(np.asarray(travel.output.velocity(unit), dtype=float))
        yield second.column(np.asarray(travel.output.acceleration(unit), dtype=float))
        return
    V, a = (travel.V, travel.a) if name == "table" else (travel.diagram_V, travel.diagram_a)
    omega = abs(found.omega)
    yield first.column(np.asarray(V, dtype=float) / omega)
    yield second.column(np.asarray(a, dtype=float) / omega**2)
