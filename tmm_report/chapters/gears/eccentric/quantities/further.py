"""Quantities of what may be asked for besides the family: sets near the ratio, masses of the satellites, paths."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.gears.eccentric.paths import Traced
from tmm_report.chapters.gears.eccentric.solve import paper
from tmm_report.chapters.gears.eccentric.solve.mechanism import RING, SUN, WHEELS, Found
from tmm_report.chapters.gears.eccentric.solve.near_ratio import LISTED
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol, math_symbol

MASSES = (("2", 0), ("4", 1), ("5", 2))  # wheel and its place in KINDS


def further_tables(found: Found, prefix: str) -> Iterator[Table]:
    if found.nearby is not None:
        yield Table(f"{prefix}_near", Message(N_("Sets of teeth near the ratio")), tuple(_near(found)))
    if found.masses is not None:
        yield Table(f"{prefix}_masses", Message(N_("Masses of the satellites")), tuple(_masses(found)))
    for path in found.paths:
        meaning = Message(N_("Path of point %(name)s"), {"name": path.point.name})
        yield Table(f"{prefix}_path_{path.point.name}", meaning, tuple(_path(path)))


def _near(found: Found) -> Iterator[Column]:
    """The best of them."""
    near = found.nearby
    assert near is not None
    family, some = near.judged.family, slice(LISTED)
    z = family.satellites[some]
    yield Quantity("place", None, "", Message(N_("place in the ranking"))).column(family.t[some])
    for wheel, numbers in (
        (SUN, family.sun[some]),
        ("2", z[:, 0]),
        (RING, family.ring[some]),
        ("5", z[:, 2]),
    ):
        text = Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": wheel})
        yield Quantity(f"z{wheel}", Symbol("z", wheel), "", text).column(numbers)
    ratio = Message(N_("ratio of the teeth of ring and sun"))
    yield Quantity("u", Symbol("u"), "", ratio).column(near.ratio[some])
    off = Message(N_("deviation of the ratio from the wanted one"))
    yield Quantity("delta_u", Symbol("Delta", "u"), "%", off).column(100 * near.deviation[some])
    fits = near.judged.fit[some]
    held = [", ".join(w for w, fit in zip(WHEELS.values(), row, strict=True) if fit) for row in fits]
    yield text_column("satellites", Message(N_("satellites that go together")), held)
    yield Quantity("held", None, "", Message(N_("number of satellites"))).column(fits.sum(axis=-1))


def _masses(found: Found) -> Iterator[Column]:
    masses, family = found.masses, found.judged.family
    assert masses is not None
    yield Quantity("t", Symbol("t"), "", Message(N_("number of the set"))).column(family.t)
    for wheel, place in MASSES:
        text = Message(N_("mass of satellite %(wheel)s"), {"wheel": wheel})
        yield Quantity(f"m{wheel}", Symbol("m", wheel), "kg", text).column(masses.each[:, place])
    held = Message(N_("mass of the satellites that the set holds together"))
    yield Quantity("held", Symbol("m", "Sigma"), "kg", held).column(masses.held)
    saving = Message(N_("what the smallest satellite saves in place of the largest"))
    yield Quantity("saving", Symbol("Deltam"), "kg", saving).column(masses.saving)


def _path(path: Traced) -> Iterator[Column]:
    yield Quantity("position", None, "", Message(N_("number of the position"))).column(
        np.arange(len(path.theta))
    )
    theta = Message(N_("angle turned by the body of the axes"))
    yield Quantity("theta", math_symbol("theta"), "deg", theta).column(np.degrees(path.theta))
    psi = Message(N_("angle turned by the wheel of the point"))
    yield Quantity("psi", math_symbol("psi"), "deg", psi).column(np.degrees(path.rate * path.theta))
    for axis, numbers in (("x", path.places.real), ("y", path.places.imag)):
        text = N_("%(axis)s of point %(name)s, from the axis of the wheel that stands still")
        meaning = Message(text, {"axis": axis, "name": path.point.name})
        yield Quantity(axis, Symbol(axis, path.point.name), "m", meaning).column(numbers)


def further_values(found: Found) -> Iterator[tuple[str, Symbol | None, str, str | Message, float]]:
    """As `values` has them: key, symbol, unit, meaning, number."""
    if found.nearby is not None and found.given.tolerance is not None:
        wide = N_("allowed deviation of the ratio")
        yield "tolerance", Symbol("Delta", "u"), "%", wide, 100 * found.given.tolerance
        wanted = N_("wanted ratio of the teeth of ring and sun")
        yield "u_wanted", Symbol("u"), "", wanted, float(found.given.ratio or found.ratio_of_teeth)
        yield "near_sets", None, "", N_("sets of teeth near the ratio"), len(found.nearby.ratio)
        yield (
            "near_holding",
            None,
            "",
            N_("those of them that hold two satellites or more"),
            found.nearby.holding,
        )
        yield "near_ring", None, "", N_("teeth of the largest ring looked at"), found.nearby.ring
    if found.masses is not None:
        assert found.given.width is not None and found.given.density is not None
        yield "b", Symbol("b"), "m", N_("face width"), found.given.width
        yield "density", Symbol("rho"), "kg/m³", N_("density of the satellites"), found.given.density
        share = N_("what the smallest satellite saves of the mass of the largest")
        saved = float(found.masses.saving[found.row] / found.masses.each[found.row, 0])
        yield "saved_share", Symbol("delta", "m"), "%", share, 100 * saved
    for path in found.paths:
        yield from _of_path(path)


def _of_path(path: Traced) -> Iterator[tuple[str, Symbol | None, str, str | Message, float]]:
    name = path.point.name
    about = {"name": name}
    far = Message(N_("distance of point %(name)s from the axis of its wheel"), about)
    yield f"path_{name}_radius", Symbol("rho", name), "m", far, path.point.radius
    start = Message(N_("angle of point %(name)s at the start, from the line of the axes"), about)
    yield f"path_{name}_angle", Symbol("alpha", name), "deg", start, float(np.degrees(path.point.angle))
    rate = Message(N_("turns of the wheel of point %(name)s for one of the axes"), about)
    held = SUN if path.point.wheel == RING else RING
    yield f"path_{name}_rate", Symbol("u", path.point.wheel + "H", held), "", rate, path.rate
    scale = paper.path_scale(path)
    if scale >= 1:
        larger = N_("how many times the drawing is larger than the mechanism")
        yield f"path_{name}_enlargement", None, "", larger, scale
    else:
        smaller = N_("how many times the drawing is smaller than the mechanism")
        yield f"path_{name}_reduction", None, "", smaller, 1 / scale
    turns = Message(N_("turns of the axes after which the path of point %(name)s closes"), about)
    yield f"path_{name}_turns", None, "", turns, path.turns
