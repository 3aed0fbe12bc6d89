"""The numbers of masses on a turning shaft balanced."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.chapters.machine.rotor.values import values
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, plain, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

__all__ = ["tables", "values"]

Array = Any
NONE = float("nan")

MASS = Quantity("m", Symbol("m"), "kg", Message(N_("mass")))
RADIUS = Quantity("r", Symbol("r"), "m", Message(N_("distance of the mass centre from the axis")))
ANGLE = Quantity(
    "alpha", Symbol("alpha"), "deg", Message(N_("angle of the unbalance from the axis x of the shaft"))
)
PLACE = Quantity("z", Symbol("z"), "m", Message(N_("place along the shaft")))
PRODUCT = Quantity("D", Symbol("D"), "kg·m", Message(N_("unbalance, product of mass and radius")))
ARM = Quantity("l", Symbol("l"), "m", Message(N_("distance from plane I along the shaft")))
MOMENT = Quantity("M", Symbol("M"), "kg·m²", Message(N_("moment of the unbalance about plane I")))
XZ = Quantity("J_xz", Symbol("J", "xz"), "kg·m²", Message(N_("product of inertia about the axes x and z")))
YZ = Quantity("J_yz", Symbol("J", "yz"), "kg·m²", Message(N_("product of inertia about the axes y and z")))


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


def _named(of: Quantity, names: Sequence[str], values: Any) -> Column:
    """A column whose rows are called by the masses: m_1, m_2."""
    sign = of.sign
    return Column(of, values, [Symbol(sign.base, name, sign.sub) for name in names])


def _degrees(angles: Array) -> Array:
    """0 … 360."""
    return np.degrees(angles) % 360.0


# --- what is on the shaft


def _masses(found: Found) -> Iterator[Column]:
    heavy = found.given.heavy
    names = [one.name for one in heavy]
    yield text_column("name", Message(N_("name of the mass")), names)
    yield _named(MASS, names, [NONE if one.mass is None else one.mass for one in heavy])
    yield _named(RADIUS, names, [NONE if one.radius is None else one.radius for one in heavy])
    yield _named(PRODUCT, names, np.abs(found.products))
    yield _named(ANGLE, names, _degrees(np.array([one.angle for one in heavy])))
    yield _named(PLACE, names, found.places)
    if np.any(found.couples):
        yield _named(XZ, names, np.real(found.couples))
        yield _named(YZ, names, np.imag(found.couples))
    yield _named(ARM, names, found.places - found.given.planes[0].at)
    yield _named(MOMENT, names, np.abs(found.moments))
    yield from _on_paper(found)


def _on_paper(found: Found) -> Iterator[Column]:
    """Lengths of the vectors of the polygons, mm."""
    count = len(found.given.heavy)
    text = Message(N_("length of the vector in the polygon of the unbalances"))
    yield Quantity("D_mm", Symbol("d"), "mm", text).column(found.force.lengths[:count])
    if found.couple is not None:
        text = Message(N_("length of the vector in the polygon of the moments"))
        yield Quantity("M_mm", Symbol("d", "M"), "mm", text).column(found.couple.lengths)


# --- what balances it


def _corrections(found: Found) -> Iterator[Column]:
    rows = found.corrections
    names = [one.name for one in rows]
    products = np.array([one.product for one in rows])
    yield text_column("plane", Message(N_("plane of correction")), names)
    yield _named(PLACE, names, [one.at for one in rows])
    for axis, text, part in (
        ("x", N_("component of the product of the weight along x"), np.real),
        ("y", N_("component of the product of the weight along y"), np.imag),
    ):
        of = Quantity(f"D_{axis}", Symbol("D", "", axis), "kg·m", Message(text))
        yield Column(of, part(products), [Symbol("D", name, axis) for name in names])
    balancing = Quantity("D", Symbol("D"), "kg·m", Message(N_("product of mass and radius that balances")))
    yield _named(balancing, names, np.abs(products))
    direction = Quantity("alpha", Symbol("alpha"), "deg", Message(N_("angle of the product that balances")))
    yield _named(direction, names, _degrees(np.array([one.direction for one in rows])))
    weight = Quantity("m", Symbol("m"), "kg", Message(N_("mass of the balancing weight")))
    radius = Quantity("r", Symbol("r"), "m", Message(N_("distance of the balancing weight from the axis")))
    yield _named(weight, names, [one.mass for one in rows])
    yield _named(radius, names, [one.radius for one in rows])
    yield from _as_made(found, names)


def _as_made(found: Found, names: Sequence[str]) -> Iterator[Column]:
    rows = found.corrections
    place = Quantity(
        "beta", Symbol("beta"), "deg", Message(N_("angle at which the weight is put or taken off"))
    )
    needed = np.array([1.0 if one.product else NONE for one in rows])
    yield _named(place, names, _degrees(needed * [one.angle for one in rows]))
    made = (
        ("m_made", "m'", "kg", N_("mass of the weight as it is made"), [one.made_mass for one in rows]),
        ("r_made", "r'", "m", N_("distance of the weight as it is made"), [one.made_radius for one in rows]),
        ("beta_made", "beta'", "deg", N_("angle of the weight as it is made"),
         _degrees(needed * [one.made_angle for one in rows])),
    )  # fmt: skip
    for key, base, unit, text, numbers in made:
        of = Quantity(key, Symbol(base), unit, Message(text))
        yield Column(of, numbers, [Symbol(base, name) for name in names])


# --- bearings


def _bearings(found: Found) -> Iterator[Column]:
    names, given = ["A", "B"], found.given
    yield text_column("bearing", Message(N_("bearing")), names)
    yield _named(PLACE, names, list(given.bearings or ()))
    for axis, text, part in (
        ("x", N_("unbalance in the plane of the bearing before balancing, component along x"), np.real),
        ("y", N_("unbalance in the plane of the bearing before balancing, component along y"), np.imag),
    ):
        of = Quantity(f"D_{axis}", Symbol("D", "", axis), "kg·m", Message(text))
        yield Column(of, part(found.before), [Symbol("D", name, axis) for name in names])
    for key, base, text, felt in (
        ("before", "R", N_("before balancing"), found.before),
        ("made", "R'", N_("with the weights as they are made"), found.made),
    ):
        meaning = Message(N_("unbalance in the plane of the bearing: %(when)s"), {"when": Message(text)})
        sign = "D" + base[1:]
        own = Quantity(f"D_{key}", Symbol(sign), "kg·m", meaning)
        yield Column(own, np.abs(felt), [Symbol(sign, name) for name in names])
        if given.speed:
            meaning = Message(N_("force of the unbalance on the bearing: %(when)s"), {"when": Message(text)})
            force = Quantity(f"R_{key}", Symbol(base), "N", meaning)
            yield Column(force, given.speed**2 * np.abs(felt), [Symbol(base, name) for name in names])
    turned = Quantity("psi", Symbol("psi"), "deg", Message(N_("angle of the force before balancing from x")))
    yield _named(turned, names, _degrees(np.where(found.before != 0, np.angle(found.before), NONE)))
    if found.permitted is not None:
        meaning = Message(N_("permissible unbalance in the plane of the bearing"))
        yield Column(
            Quantity("D_per", Symbol("D", "lim"), "kg·m", meaning),
            found.permitted,
            [Symbol("D", f"lim,{name}") for name in names],
        )


# --- the polygons against the calculation


def compared(found: Found) -> list[tuple[Quantity, float, float]]:
    """Quantity, by the polygon, by calculation; in the order in which they are drawn."""
    rows, polygons = [], [(found.corrections[0], found.force)]
    if found.couple is not None:
        polygons.insert(0, (found.corrections[1], found.couple))
    for one, drawn in polygons:
        arm = 1.0 if drawn is found.force else abs(one.at - found.corrections[0].at)
        text = Message(N_("product of the weight in plane %(plane)s"), {"plane": one.name})
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
