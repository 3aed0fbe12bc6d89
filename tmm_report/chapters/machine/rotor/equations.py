"""Formulas of the rows of the tables: of masses, weights and bearings, in symbols, in numbers, with their value."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmm_report.chapters.machine.rotor.quantities import compared, table
from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.quantity.formula import Expr, Formula, sqrt


def product(found: Found) -> Iterator[Formula]:
    """D = m r of the first mass that is stated so."""
    known = [k for k, one in enumerate(found.given.heavy) if one.mass and one.radius]
    masses = table(found, "masses")
    for k in known[:1]:
        yield masses.formula("D", k, masses.var("m", k) * masses.var("r", k))


# --- weights


def balancing(found: Found) -> Iterator[Formula]:
    """Components of what balances: of plane II first, by the moments; then of plane I, by the forces."""
    s, weights = found.s, table(found, "corrections")
    if found.two:
        for axis in "xy":
            yield weights.formula(f"D_{axis}", 1, -(s.var(f"M_{axis}") / s.L), scale=found.size)
    for axis in "xy":
        total: Expr = -s.var(f"D_{axis}")
        if found.two:
            total = total - weights.var(f"D_{axis}", 1)
        yield weights.formula(f"D_{axis}", 0, total, scale=found.size)


def balancing_sizes(found: Found) -> Iterator[Formula]:
    weights = table(found, "corrections")
    for row in reversed(range(len(weights))):
        x, y = (weights.var(f"D_{axis}", row) for axis in "xy")
        yield weights.formula("D", row, sqrt(x**2 + y**2))


def weight(found: Found) -> Iterator[Formula]:
    """The mass from the distance, or the distance from the mass."""
    weights = table(found, "corrections")
    for row, plane in enumerate(found.given.planes):
        wanted, stated = ("m", "r") if plane.mass is None else ("r", "m")
        yield weights.formula(wanted, row, weights.var("D", row) / weights.var(stated, row))


# --- by the polygons


def read(found: Found) -> Iterator[Formula]:
    """Products by the closing vectors as read."""
    s = found.s
    quantities = {quantity.key: quantity for quantity, *_ in compared(found)}
    by_hand: dict[str, Expr] = {}
    if found.two:
        by_hand["D_II"] = s.closing_M * s.mu_M / s["L"].var(size=True)
    by_hand["D_I"] = s.closing_D * s.mu_D
    for key, expression in by_hand.items():
        of, ref = quantities[key], table(found, "comparison").by_key(key, "graph")
        yield Formula(of.sign, expression, of.unit, ref=ref, meaning=of.meaning)


# --- bearings


def carried(found: Found) -> Iterator[Formula]:
    """Unbalances in the planes of the bearings: of B by the moments about A, of A by the sum; then their sizes."""
    s, bearings = found.s, table(found, "bearings")
    back = table(found, "corrections").var("z", 0) - bearings.var("z", 0)
    for axis in "xy":
        moment = s.var(f"M_{axis}") + s.var(f"D_{axis}") * back
        yield bearings.formula(f"D_{axis}", 1, moment / s.L_AB, scale=found.size)
    for axis in "xy":
        total = s.var(f"D_{axis}") - bearings.var(f"D_{axis}", 1)
        yield bearings.formula(f"D_{axis}", 0, total, scale=found.size)
    for row in (0, 1):
        x, y = (bearings.var(f"D_{axis}", row) for axis in "xy")
        yield bearings.formula("D_before", row, sqrt(x**2 + y**2))


def force(found: Found) -> Iterator[Formula]:
    """Of the bearings, by their unbalances."""
    bearings = table(found, "bearings")
    for row in (0, 1):
        yield bearings.formula("R_before", row, bearings.var("D_before", row) * found.s.omega**2)


ROWS: dict[str, Callable[[Found], Iterator[Formula]]] = {
    one.__name__: one for one in (product, balancing, balancing_sizes, weight, read, carried, force)
}
