"""Tables of what may be asked for besides the family: sets near the ratio, masses of the satellites, paths."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.gears.eccentric.paths import Traced
from tmm_report.chapters.gears.eccentric.solve.mechanism import WHEELS, Found
from tmm_report.chapters.gears.eccentric.solve.near_ratio import LISTED
from tmm_report.chapters.gears.eccentric.steps import steps
from tmm_report.chapters.gears.eccentric.values import Masses, Near, Place, Set, of_place
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, text_column
from tmm_report.quantity.sheet import columns


def further_tables(found: Found) -> Iterator[Table]:
    if found.nearby is not None:
        yield Table("eccentric_near", Message(N_("Sets of teeth near the ratio")), tuple(_near(found)))
    if found.masses is not None:
        yield Table("eccentric_masses", Message(N_("Masses of the planet gears")), tuple(_masses(found)))
    if found.given.load is not None:
        yield Table("eccentric_loads", Message(N_("Forces on the planet gears")), tuple(_loads(found)))
    for path in found.paths:
        meaning = Message(N_("Path of point %(name)s"), {"name": path.name})
        yield Table(f"eccentric_path_{path.name}", meaning, tuple(_path(path)))


def _near(found: Found) -> Iterator[Column]:
    """The best of them."""
    near = found.nearby
    assert near is not None
    family, some = near.judged.family, slice(LISTED)
    z = family.satellites[some]
    yield Near.place.column(family.t[some])
    yield Set.z1.column(family.sun[some])
    yield Set.z2.column(z[:, 0])
    yield Set.z3.column(family.ring[some])
    yield Set.z5.column(z[:, 2])
    yield Near.u.column(near.ratio[some])
    yield Near.delta_u.column(100 * near.deviation[some])
    fits = near.judged.fit[some]
    held = [", ".join(w for w, fit in zip(WHEELS.values(), row, strict=True) if fit) for row in fits]
    yield text_column("satellites", Message(N_("planet gears that go together")), held)
    yield Near.held.column(fits.sum(axis=-1))


def _masses(found: Found) -> Iterator[Column]:
    masses, family = found.masses, found.judged.family
    assert masses is not None
    yield Masses.t.column(family.t)
    for of, each in zip((Masses.m2, Masses.m4, Masses.m5), masses.each.T, strict=False):
        yield of.column(each)
    yield Masses.held.column(masses.held)
    yield Masses.saving.column(masses.saving)


def _loads(found: Found) -> Iterator[Column]:
    yield text_column("wheel", Message(N_("number of the wheel")), [of.wheel for of in found.satellites])
    yield from columns(steps(found).loads)


def _path(path: Traced) -> Iterator[Column]:
    yield Place.position.column(np.arange(len(path.theta)))
    yield Place.theta.column(np.degrees(path.theta))
    yield Place.psi.column(np.degrees(path.rate * path.theta))
    called = of_place(path)
    yield called["x"].column(path.places.real)
    yield called["y"].column(path.places.imag)
