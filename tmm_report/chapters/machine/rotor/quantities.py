"""The numbers of masses on a turning shaft balanced: single values, and tables of masses, weights and bearings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.rotor.values import Bearings, Masses, Weights
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, plain, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("rotor_D", "rotor_M")  # what is looked for first

if TYPE_CHECKING:
    from tmm_report.chapters.machine.rotor.solve import Found

__all__ = ["table", "tables", "values"]

Array = Any
NONE = float("nan")


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


@tabulated
def tables(found: Found) -> Iterator[Table]:
    yield Table("rotor_masses", Message(N_("unbalances of the rotor")), tuple(_masses(found)))
    yield Table(
        "rotor_corrections", Message(N_("weights that balance the rotor")), tuple(_corrections(found))
    )
    if found.given.bearings is not None:
        yield Table("rotor_bearings", Message(N_("bearings of the rotor")), tuple(_bearings(found)))
    meaning = Message(N_("products of the weights by the polygons and by calculation"))
    yield Table("rotor_comparison", meaning, tuple(_comparison(found)))


def table(found: Found, name: str) -> Table:
    return next(one for one in tables(found) if one.name == f"rotor_{name}")


PRODUCT = N_("product of the weight in plane %(plane)s")


def _own(of: Q, names: Sequence[str], values: Any) -> Column:
    """A column whose head alone has the index by which its letter differs from those of other tables."""
    symbols = [Symbol(of.quantity.sign.base, name) for name in names]
    meanings = [Message(PRODUCT, {"plane": name}) for name in names] if of is Weights.D else ()
    return Column(of.quantity, values, symbols, meanings=meanings)


def _named(of: Q, names: Sequence[str], values: Any) -> Column:
    """A column whose rows are called by the masses: m_1, m_2; an index of the letter goes up."""
    sign = of.quantity.sign
    return Column(of.quantity, values, [Symbol(sign.base, name, sign.sub or sign.sup) for name in names])


def _degrees(angles: Array) -> Array:
    """0 … 360."""
    return np.degrees(angles) % 360.0


# --- what is on the shaft


def _masses(found: Found) -> Iterator[Column]:
    heavy, names = found.given.heavy, found.given.names
    yield text_column("name", Message(N_("name of the mass")), names)
    yield _named(Masses.m, names, [NONE if one.mass is None else one.mass for one in heavy])
    yield _named(Masses.r, names, [NONE if one.radius is None else one.radius for one in heavy])
    yield _named(Masses.D, names, np.abs(found.products))
    yield _named(Masses.alpha, names, _degrees(np.array([one.angle for one in heavy])))
    yield _named(Masses.z, names, found.places)
    if np.any(found.couples):
        yield _named(Masses.J_xz, names, np.real(found.couples))
        yield _named(Masses.J_yz, names, np.imag(found.couples))
    yield _named(Masses.l, names, found.places - found.given.planes[0].at)
    yield _named(Masses.M, names, np.abs(found.moments))
    yield Masses.D_mm.column(found.force.lengths[: len(heavy)])
    if found.couple is not None:
        yield Masses.M_mm.column(found.couple.lengths)


# --- what balances it


def _corrections(found: Found) -> Iterator[Column]:
    rows = found.corrections
    names = [one.name for one in rows]
    products = np.array([one.product for one in rows])
    needed = np.array([1.0 if one.product else NONE for one in rows])
    yield text_column("plane", Message(N_("correction plane")), names)
    yield _named(Weights.z, names, [one.at for one in rows])
    yield _named(Weights.D_x, names, np.real(products))
    yield _named(Weights.D_y, names, np.imag(products))
    yield _own(Weights.D, names, np.abs(products))
    yield _own(Weights.alpha, names, _degrees(np.array([one.direction for one in rows])))
    yield _own(Weights.m, names, [one.mass for one in rows])
    yield _own(Weights.r, names, [one.radius for one in rows])
    yield _named(Weights.beta, names, _degrees(needed * [one.angle for one in rows]))
    yield _named(Weights.m_made, names, [one.made_mass for one in rows])
    yield _named(Weights.r_made, names, [one.made_radius for one in rows])
    yield _named(Weights.beta_made, names, _degrees(needed * [one.made_angle for one in rows]))


# --- bearings


def _bearings(found: Found) -> Iterator[Column]:
    names, given = ["A", "B"], found.given
    yield text_column("bearing", Message(N_("bearing")), names)
    yield _named(Bearings.z, names, list(given.bearings or ()))
    yield _named(Bearings.D_x, names, np.real(found.before))
    yield _named(Bearings.D_y, names, np.imag(found.before))
    for product, force, felt in (
        (Bearings.D_before, Bearings.R_before, found.before),
        (Bearings.D_made, Bearings.R_made, found.made),
    ):
        yield _own(product, names, np.abs(felt))
        if given.speed:
            yield _named(force, names, given.speed**2 * np.abs(felt))
    yield _named(Bearings.psi, names, _degrees(np.where(found.before != 0, np.angle(found.before), NONE)))
    if found.permitted is not None:
        symbols = [Symbol("D", f"lim,{name}") for name in names]
        yield Column(Bearings.D_per.quantity, found.permitted, symbols)


# --- the polygons against the calculation


def compared(found: Found) -> list[tuple[Quantity, float, float]]:
    """Quantity, by the polygon, by calculation; in the order in which they are drawn."""
    rows, polygons = [], [(found.corrections[0], found.force)]
    if found.couple is not None:
        polygons.insert(0, (found.corrections[1], found.couple))
    for one, drawn in polygons:
        arm = 1.0 if drawn is found.force else abs(one.at - found.corrections[0].at)
        text = Message(PRODUCT, {"plane": one.name})
        quantity = Quantity(f"D_{one.name}", Symbol("D", one.name), "kg·m", text)
        rows.append((quantity, abs(drawn.closing) * drawn.scale / arm, abs(one.product)))
    return rows


def _comparison(found: Found) -> Iterator[Column]:
    rows = compared(found)
    graph, analytic = (np.array([row[k] for row in rows]) for k in (1, 2))
    with np.errstate(all="ignore"):
        delta = np.where(analytic > 1e-9 * found.size, 200 * (graph - analytic) / (graph + analytic), NONE)
    yield text_column("key", Message(N_("quantity")), [row[0].key for row in rows])
    yield text_column("unit", Message(N_("its unit")), [row[0].unit for row in rows])
    yield plain("graph", "", Message(N_("by the polygon")), graph)
    yield plain("analytic", "", Message(N_("by calculation")), analytic)
    yield plain("delta", "%", Message(N_("difference in per cent of the mean")), delta)
