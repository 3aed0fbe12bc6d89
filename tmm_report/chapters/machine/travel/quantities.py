"""The numbers of a machine whose main link slides: wheels, springs, the motion over the stroke, the works."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.travel.plant import DRIVING, REDUCED, RESISTING
from tmm_report.chapters.machine.travel.solve import Found
from tmm_report.chapters.machine.travel.values import Motion
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("travel_way", "travel_t_end", "travel_v_max")  # what is looked for first

ROWS = 12  # of the table of the motion

WHEELS = Message(N_("wheels that the main link turns"))
SPRINGS = Message(N_("springs along the guide"))
MOTION = Message(N_("motion of the main link"))
WORKS = Message(N_("work of the forces along the path"))
INERTIA = Quantity("J", Symbol("J"), "kg·m²", Message(N_("moment of inertia of the wheel")))
RADIUS = Quantity("r", Symbol("r"), "m", Message(N_("radius at which the main link turns the wheel")))
OWN = Quantity("m", Symbol("m"), "kg", Message(N_("its mass on the main link")))
STIFFNESS = Quantity("c", Symbol("c"), "N/m", Message(N_("stiffness of the spring")))
FREE = Quantity(
    "s_free", Symbol("s", "c"), "m", Message(N_("place of the main link at which the spring is free"))
)
WORK = Quantity("A", Symbol("A"), "J", Message(N_("work along the way")))


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


def book(found: Found) -> Book:
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    given = found.given
    if given.wheels:
        names = text_column("wheel", Message(N_("wheel")), [one.name or "" for one in given.wheels])
        inertia, radius = (
            np.array([getattr(one, key) for one in given.wheels]) for key in ("inertia", "radius")
        )
        columns = (INERTIA.column(inertia), RADIUS.column(radius), OWN.column(inertia / radius**2))
        yield Table("travel_wheels", WHEELS, (names, *columns))
    if given.springs:
        names = text_column("spring", Message(N_("spring")), [one.name or "" for one in given.springs])
        stiffness = STIFFNESS.column([one.stiffness for one in given.springs])
        free = FREE.column([one.free for one in given.springs])
        yield Table("travel_springs", SPRINGS, (names, stiffness, free))
    apart = max(1, (len(found.t) - 1) // ROWS)
    yield Table("travel_motion", MOTION, tuple(_motion(found, slice(None, None, apart))))
    yield Table("travel_motion_diagram", MOTION, tuple(_motion(found, slice(None))))
    yield Table("travel_works", WORKS, tuple(_works(found)))


def _motion(found: Found, rows: slice) -> Iterator[Column]:
    yield Motion.t.column(found.t[rows])
    yield Motion.s.column(found.place[rows])
    if not found.constant_mass:
        yield Motion.m_red.column(found.mass[rows])
        yield Motion.m_red_slope.column(found.slope[rows])
    forces = {kind: found.force(kind) for kind in (DRIVING, REDUCED, RESISTING)}
    there = {kind for kind, _ in found.whole.acting}
    if DRIVING in there:
        yield Motion.F_dr.column(forces[DRIVING][rows])
    if REDUCED in there:
        yield Motion.F_red.column(forces[REDUCED][rows])
    if RESISTING in there:
        yield Motion.F_res.column(-forces[RESISTING][rows])
    yield Motion.F.column(sum(forces.values())[rows])
    yield Motion.A.column(found.work[rows])
    yield Motion.v.column(found.v[rows])
    yield Motion.a.column(found.a[rows])
    stroke = found.whole.stroke
    if stroke is not None:
        transfer = stroke.transfer(found.place[rows])
        yield Motion.omega.column(found.whole.way * found.v[rows] * transfer)
        yield Motion.I_red.column(found.mass[rows] / transfer**2)


def _works(found: Found) -> Iterator[Column]:
    """A row for each that acts, then their sum and the change of the kinetic energy."""
    works = found.motion.works
    yield text_column("acting", Message(N_("what acts")), [*works, "sum", "gained"])
    yield WORK.column(np.array([*works.values(), sum(works.values()), found.motion.gained]))
