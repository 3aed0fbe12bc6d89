"""The force plan of a dyad.

Loads are laid off in the order P0 → loads of b → P1 → loads of a → P2, then the reactions close the plan:
R_a from P2 to X, R_b from X to P0, and the inner reaction on a from X to P1. So one point X, where two lines cross,
solves any dyad; each line is a condition (see `_lines`): a moment equation, or a guide without friction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tmm_report.chapters.force_plans.drafting.plan import Arm, ForcePlan, ForceStroke
from tmm_report.chapters.force_plans.drafting.sheet import Sheet
from tmm_report.chapters.force_plans.quantities import moment_sum
from tmm_report.chapters.initial_data.quantities import length
from tmm_report.chapters.kinetostatics.quantities import reaction, reaction_part
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.planar import resolve, unit
from tmm_report.mechanics.structure import Pair
from tmm_report.quantity.formula import Formula, Term, VectorEquation
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS

Corners = tuple[complex, complex, complex]  # P0, P1, P2: before the loads of b, between, after those of a; mm


def plan(sheet: Sheet, d: Dyad) -> ForcePlan:
    """Draw the plan, read the reactions and pass the outer ones on."""
    arms: list[Arm] = []
    moments: list[Formula] = []
    mu = sheet.scale_of(d.group)
    of_b, P1 = sheet.laid_off(d.b, 0j, mu)
    of_a, P2 = sheet.laid_off(d.a, P1, mu)
    corners = 0j, P1, P2
    ((start1, along1), (start2, along2)), components = _lines(sheet, d, corners, mu, arms, moments)
    x, _ = resolve(start2 - start1, along1, -along2)
    X = sheet.pen.place(complex(start1 + x * along1))
    strokes = [*of_b, *of_a, *_reaction_strokes(d, corners, X, components)]
    readings = _readings(sheet, d, corners, X, mu)
    loads = {link: tuple(sheet.acting[link]) for link in d.links}
    couples = {link: tuple(sheet.couples[link]) for link in d.links}
    equation = _equation(sheet, d, components)
    for pair, link, vector in ((d.outer_a, d.a, X - P2), (d.outer_b, d.b, -X)):
        sheet.pass_on(pair, link, vector, mu)
    return ForcePlan(
        d.group.label, d.links, mu, loads, couples, tuple(arms), tuple(moments), equation,
        tuple(strokes), tuple(readings),
    )  # fmt: skip


def _lines(
    sheet: Sheet, d: Dyad, corners: Corners, mu: float, arms: list[Arm], moments: list[Formula]
) -> tuple[list[tuple[complex, complex]], dict[str, complex]]:
    """The two lines that cross in X, and the tangential components laid off on the way, mm by link."""
    P0, P1, P2 = corners
    A, B, C = (sheet.joint(pair) for pair in (d.outer_a, d.inner, d.outer_b))
    components: dict[str, complex] = {}
    lines = []

    def tangential(
        pair: Pair, link: str, links: Sequence[str], about: complex, joint: str, at: complex
    ) -> complex:
        """Component of an outer reaction across its arm, from the moments about a joint; mm."""
        total = sheet.moment_sum(links, joint, about, arms)
        arm = float(round_significant(abs(at - about), DIGITS + 2))
        of = reaction_part(pair.other(link), link, "t")
        sum_of_moments = sheet.hand(moment_sum(joint, tuple(links)), total)
        moment = sheet.number(moment_sum(joint, tuple(links)), sum_of_moments.written)
        formula = sheet.hand(of, -moment / sheet.number(length(joint + pair.name), arm))
        moments.extend((sum_of_moments, formula))
        components[link] = sheet.pen.place(1j * unit(at - about) * formula.written / mu)
        return components[link]

    def across(pair: Pair) -> complex:
        """Direction of a reaction across a guide."""
        return 1j * sheet.guide(pair)

    if d.kind in (1, 2):
        lines.append((P2 + tangential(d.outer_a, d.a, (d.a,), B, d.inner.name, A), unit(A - B)))
    elif d.kind == 3:
        lines.append((P2 + tangential(d.outer_a, d.a, (d.a, d.b), C, d.outer_b.name, A), unit(A - C)))
    else:
        lines.append((P2, across(d.outer_a)) if d.kind == 4 else (P1, across(d.inner)))
    if d.kind == 1:
        lines.append((P0 - tangential(d.outer_b, d.b, (d.b,), B, d.inner.name, C), unit(C - B)))
    elif d.kind == 3:
        lines.append((P1, across(d.inner)))
    else:
        lines.append((P0, across(d.outer_b)))
    return lines, components


def _reaction_strokes(
    d: Dyad, corners: Corners, X: complex, components: Mapping[str, complex]
) -> list[ForceStroke]:
    P0, P1, P2 = corners
    on_a, on_b, inner = _reactions(d)
    (a_t, a_n), (b_t, b_n) = _parts(d.carrier_a, d.a), _parts(d.carrier_b, d.b)
    strokes = []
    if (part := components.get(d.a)) is not None:
        strokes += [
            ForceStroke(P2, P2 + part, a_t, "component"),
            ForceStroke(P2 + part, X, a_n, "component"),
        ]
    if (part := components.get(d.b)) is not None:
        strokes += [
            ForceStroke(X, P0 - part, b_n, "component"),
            ForceStroke(P0 - part, P0, b_t, "component"),
        ]
    return [
        *strokes,
        ForceStroke(P2, X, on_a, "reaction"),
        ForceStroke(X, P0, on_b, "reaction"),
        ForceStroke(X, P1, inner, "reaction"),
    ]


def _reactions(d: Dyad) -> tuple[Quantity, Quantity, Quantity]:
    """Outer reactions on a and on b, and the inner one, of b on a."""
    return reaction(d.carrier_a, d.a), reaction(d.carrier_b, d.b), reaction(d.b, d.a)


def _parts(by: str, on: str) -> tuple[Quantity, Quantity]:
    """Tangential and normal component of a reaction."""
    return reaction_part(by, on, "t"), reaction_part(by, on, "n")


def _readings(sheet: Sheet, d: Dyad, corners: Corners, X: complex, mu: float) -> list[Formula]:
    """Reactions read off the plan."""
    P0, P1, P2 = corners
    vectors, pairs = (X - P2, P0 - X, P1 - X), (d.outer_a, d.outer_b, d.inner)
    return [sheet.read(*row, mu) for row in zip(_reactions(d), vectors, pairs, strict=True)]


def _equation(sheet: Sheet, d: Dyad, components: Mapping[str, complex]) -> VectorEquation:
    """Sum of all forces of the group; in an RPP and RPR group the inner reaction has its own known direction."""

    def outer(carrier: str, link: str, pair: Pair) -> list[Term]:
        if link in components:
            tangential, normal = _parts(carrier, link)
            return [Term(normal.sign, 1), Term(tangential.sign, 2)]
        return [Term(reaction(carrier, link).sign, 1 if pair.kind == "P" else 0)]

    on_a, on_b = outer(d.carrier_a, d.a, d.outer_a), outer(d.carrier_b, d.b, d.outer_b)
    loads = [term for link in (d.a, d.b) for term in sheet.terms(link)]
    return VectorEquation([[*on_a, *loads, *reversed(on_b)], []])
