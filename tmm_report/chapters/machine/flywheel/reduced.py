"""A lever mechanism reduced to its driving link, written out at a position: the varying moment of inertia by the energy
of the links, the moment of weights and loads by their power. (Artobolevsky, Theory of mechanisms and machines, ch. 15)
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.lever.initial_data import quantities as initial
from tmm_report.chapters.lever.kinematics import quantities as rates
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.quantities import positions as statics
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.quantity.formula import Expr, Formula
from tmm_report.quantity.model import Table

NOTHING = 1e-9  # of the greatest power of a load: a share that is nowhere more is left out


def formulas(found: Found, table: Table, k: int) -> Iterator[Formula]:
    """J_II, and the moment of the side that the loads are on, at position k of the table."""
    moving = found.moving
    assert moving is not None and moving.forces is not None  # a flywheel asks for loads
    moved = rates.book(moving.kinematics).tables["rates_table"]
    if found.varies:
        yield table.formula("J_II", k, _inertia(found, moving.kinematics, moved, k))
    moment = _moment(found, moving.forces, moved, k)
    if moment is None:
        return
    if found.sides.balancing == "resisting":
        yield table.formula("M_dr", k, moment)
    else:
        yield table.formula("M_res", k, moment - table.var("M_fr", k) if "M_fr" in table else moment)


def _inertia(found: Found, kinematics: Kinematics, moved: Table, k: int) -> Expr:
    """Σ m (v_S/ω₁)² + J (ω/ω₁)² of the links whose inertia varies."""
    masses = next(one for one in initial.given_tables(kinematics.linkage.mechanism) if one.name == "masses")
    first, *others = rates.kinetic(kinematics, found.sides.uneven, masses, moved, found.s.omega_m, k)
    return sum(others, first)


def _moment(found: Found, forces: Kinetostatics, moved: Table, k: int) -> Expr | None:
    """Σ F_x v_x/ω₁ + F_y v_y/ω₁ + M ω/ω₁ of the weights and stated loads; None where none of them does any work."""
    terms = list(_shares(forces, moved))
    sizes = [float(np.max(np.abs(moved[rate].numbers() * of[key].numbers()))) for of, key, rate in terms]
    kept = [
        of.var(key, k) * moved.var(rate, k) / found.s.omega_m
        for (of, key, rate), size in zip(terms, sizes, strict=True)
        if size > NOTHING * max(sizes)
    ]
    return sum(kept[1:], kept[0]) if kept else None


def _shares(forces: Kinetostatics, moved: Table) -> Iterator[tuple[Table, str, str]]:
    """Of each load its column in the table of the loads, and that of the rate by which it does work."""
    loads, given = statics.book(forces).tables["loads_table"], forces.given
    links = forces.kinematics.linkage.mechanism.links
    at = [(statics.weight(link).key, str(links[link].mass_centre)) for link in forces.table.loading.gravity]
    at += [(of.key, load.at) for of, load in zip(statics.forces(given.forces), given.forces, strict=True)]
    for key, point in at:
        for axis in "xy":
            rate = f"{rates.point_rate('v', point).key}_{axis}"
            if rate in moved:
                yield loads, f"{key}_{axis}", rate
    for of, load in zip(statics.moments(given.moments), given.moments, strict=True):
        rate = rates.link_rate("w", load.on).key
        if rate in moved:
            yield loads, of.key, rate
