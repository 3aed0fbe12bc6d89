"""The force plan of a dyad.

Loads are laid off in the order P0 → loads of b → P1 → loads of a → P2, then the reactions close the plan:
R_a from P2 to X, R_b from X to P0, and the inner reaction on a from X to P1. So one point X, where two lines cross,
solves any dyad; each line is a condition (see `_lines`): a moment equation, or a guide without friction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tmm_report.chapters.force_plans.drafting.plan import Arm, ForcePlan, ForceStroke
from tmm_report.chapters.force_plans.drafting.sheet import Sheet
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.planar import resolve, unit
from tmm_report.mechanics.structure import Pair
from tmm_report.quantity.formula import Formula, Symbol, Term, VectorEquation
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, hand, number, reaction_key, symbol_of

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
    """The two lines that cross in X, and the tangential components laid off on the way, mm by key."""
    P0, P1, P2 = corners
    A, B, C = (sheet.joint(pair) for pair in (d.outer_a, d.inner, d.outer_b))
    components: dict[str, complex] = {}
    lines = []

    def tangential(
        pair: Pair, link: str, links: Sequence[str], about: complex, joint: str, at: complex
    ) -> complex:
        """Component of an outer reaction across its arm, from the moments about a joint; mm."""
        total = sheet.moment_sum(links, joint, about, arms)
        size = number(
            Symbol("l", joint + pair.name), float(round_significant(abs(at - about), DIGITS + 2)), "m"
        )
        key = f"{reaction_key(pair.other(link), link)}_t"
        sum_of_moments = hand(f"SigmaM_{joint}", total, 0.0)
        moment = number(sum_of_moments.result, sum_of_moments.written, "N·m")
        formula = hand(key, -moment / size, 0.0)
        moments.extend((sum_of_moments, formula))
        components[key] = sheet.pen.place(1j * unit(at - about) * formula.written / mu)
        return components[key]

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
    on_a, on_b, inner = _keys(d)
    strokes = []
    if (part := components.get(f"{on_a}_t")) is not None:
        strokes += [
            ForceStroke(P2, P2 + part, f"{on_a}_t", "component"),
            ForceStroke(P2 + part, X, f"{on_a}_n", "component"),
        ]
    if (part := components.get(f"{on_b}_t")) is not None:
        strokes += [
            ForceStroke(X, P0 - part, f"{on_b}_n", "component"),
            ForceStroke(P0 - part, P0, f"{on_b}_t", "component"),
        ]
    return [
        *strokes,
        ForceStroke(P2, X, on_a, "reaction"),
        ForceStroke(X, P0, on_b, "reaction"),
        ForceStroke(X, P1, inner, "reaction"),
    ]


def _keys(d: Dyad) -> tuple[str, str, str]:
    """Outer reactions on a and on b, and the inner one, of b on a."""
    return reaction_key(d.carrier_a, d.a), reaction_key(d.carrier_b, d.b), reaction_key(d.b, d.a)


def _readings(sheet: Sheet, d: Dyad, corners: Corners, X: complex, mu: float) -> list[Formula]:
    """Reactions read off the plan."""
    P0, P1, P2 = corners
    vectors, pairs = (X - P2, P0 - X, P1 - X), (d.outer_a, d.outer_b, d.inner)
    return [sheet.read(*row, mu) for row in zip(_keys(d), vectors, pairs, strict=True)]


def _equation(sheet: Sheet, d: Dyad, components: Mapping[str, complex]) -> VectorEquation:
    """Sum of all forces of the group; in an RPP and RPR group the inner reaction has its own known direction."""
    on_a, on_b, _ = _keys(d)

    def reaction(key: str) -> list[Term]:
        if f"{key}_t" in components:
            return [Term(symbol_of(f"{key}_n"), 1), Term(symbol_of(f"{key}_t"), 2)]
        pair = d.outer_a if key == on_a else d.outer_b
        return [Term(symbol_of(key), 1 if pair.kind == "P" else 0)]

    loads = [term for link in (d.a, d.b) for term in sheet.terms(link)]
    return VectorEquation([[*reaction(on_a), *loads, *reversed(reaction(on_b))], []])
