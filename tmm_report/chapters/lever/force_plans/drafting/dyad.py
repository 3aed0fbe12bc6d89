"""The force plan of a dyad.

Loads are laid off in the order P0 → loads of b → P1 → loads of a → P2, then the reactions close the plan:
R_a from P2 to X, R_b from X to P0, and the inner reaction on a from X to P1. So one point X, where two lines cross,
solves any dyad; each line is a condition (see `_lines`): a moment equation, or a guide without friction.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from tmm_report.chapters.lever.force_plans.drafting.plan import Arm, ForcePlan, ForceStroke, Held, Single
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet, laid_end_to_end
from tmm_report.chapters.lever.force_plans.quantities import moment_sum
from tmm_report.chapters.lever.kinetostatics.quantities.positions import guide_moment, reaction, reaction_part
from tmm_report.mechanics.calculus.vectors import cross, resolve, unit
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.quantity.formula import Expr, Formula, Number, Term, VectorEquation
from tmm_report.quantity.model import Quantity

Corners = tuple[complex, complex, complex]  # P0, P1, P2: before the loads of b, between, after those of a; mm


FAR = 15.0  # mm: the reaction of a guide that acts farther from the slider is shown as a force and a moment


def plan(sheet: Sheet, d: Dyad) -> ForcePlan:
    """Draw the plan, read the reactions and pass the outer ones on."""
    arms: list[Arm] = []
    moments: list[Formula] = []
    mu = sheet.scale_of(d.links, (d.outer_a, d.outer_b), _corners(sheet, d))
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
    singles = _single(sheet, d)
    held = tuple(_held(sheet, d, corners, X, components, mu))
    for pair, link, vector in ((d.outer_a, d.a, X - P2), (d.outer_b, d.b, -X)):
        sheet.pass_on(pair, link, vector, mu)
    return ForcePlan(
        d.group.label, d.links, mu, loads, couples, tuple(arms), tuple(moments), equation,
        tuple(strokes), tuple(readings), held=held, singles=(singles,), together=d.kind == 3,
        chosen=sheet.chosen, poles=sheet.poles(d.links),
    )  # fmt: skip


def _corners(sheet: Sheet, d: Dyad) -> list[complex]:
    """Corners of the polygon by the analytical reactions, N; those of the components among them."""
    corners = laid_end_to_end(sheet, (d.b, d.a))
    on_a, on_b = (sheet.exact_on(pair, link) for pair, link in ((d.outer_a, d.a), (d.outer_b, d.b)))
    corners.append(corners[-1] + on_a)
    A, B, C = (sheet.joint(pair) for pair in (d.outer_a, d.inner, d.outer_b))
    if d.kind in (1, 2, 3):
        corners.append(corners[-1] - _across(on_a, A - (C if d.kind == 3 else B)))
    return [*corners, -_across(on_b, C - B)] if d.kind == 1 else corners


def _across(force: complex, arm: complex) -> complex:
    """The part of a force that is across an arm."""
    along = unit(arm)
    return complex(force - (force * along.conjugate()).real * along)


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
        formula = _tangential(sheet, pair, link, (total, joint, links), abs(at - about), moments)
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


def _tangential(
    sheet: Sheet,
    pair: Pair,
    link: str,
    loads: tuple[Expr, str, Sequence[str]],
    arm: float,
    moments: list[Formula],
) -> Formula:
    """−ΣM/l, written out in `moments`; nothing where no load has a moment about the joint."""
    total, joint, links = loads
    of = reaction_part(pair.other(link), link, "t")
    if isinstance(total, Number):
        formula = sheet.hand(of, Number(0.0))
        moments.append(formula)
        return formula
    sum_of = moment_sum(joint, tuple(links), sheet.in_mm)
    sum_of_moments = sheet.hand(sum_of, total)
    moment = sheet.number(sum_of, sum_of_moments.written)
    formula = sheet.hand(of, -moment / sheet.length(joint, pair.name, arm))
    moments.extend((sum_of_moments, formula))
    return formula


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
    """Sum of all forces of the group in the order of the polygon from X on: the reaction on b, loads of b, of a, the
    reaction on a. So one unknown stands first and the other last.

    In an RPP and RPR group the inner reaction has its own known direction.
    """

    def outer(carrier: str, link: str, pair: Pair) -> list[Term]:
        if link in components:
            tangential, normal = _parts(carrier, link)
            return [Term(tangential.sign, 2), Term(normal.sign, 1)]
        return [Term(reaction(carrier, link).sign, 1 if pair.kind == "P" else 0)]

    on_a, on_b = outer(d.carrier_a, d.a, d.outer_a), outer(d.carrier_b, d.b, d.outer_b)
    loads = [term for link in (d.b, d.a) for term in sheet.terms(link)]
    return VectorEquation([[*reversed(on_b), *loads, *on_a], []])


def _single(sheet: Sheet, d: Dyad) -> Single:
    """Link a alone: its loads from P1 to P2, the outer reaction on it to X, the inner one back to P1."""
    on_a, _, inner = _reactions(d)
    terms = [*sheet.terms(d.a), Term(on_a.sign, 2), Term(inner.sign, 0)]
    return Single(d.a, VectorEquation([terms, []]), inner)


def _held(
    sheet: Sheet, d: Dyad, corners: Corners, X: complex, components: Mapping[str, complex], mu: float
) -> Iterator[Held]:
    """The reactions on the links of the group, N, and the inner one on either."""
    P0, P1, P2 = corners
    on_a, on_b, inner = _reactions(d)
    for pair, link, carrier, whole, of in (
        (d.outer_a, d.a, d.carrier_a, X - P2, on_a),
        (d.outer_b, d.b, d.carrier_b, P0 - X, on_b),
    ):
        if (part := components.get(link)) is None:
            yield reaction_held(sheet, pair, of, link, whole * mu)
            continue
        at = sheet.joint(pair)
        tangential, normal = _parts(carrier, link)
        across = 1j * unit(at - sheet.joint(d.outer_b if d.kind == 3 else d.inner))
        turned = (part * across.conjugate()).real < 0
        yield Held(tangential, link, part * mu, at, "component", turned)
        yield Held(normal, link, (whole - part) * mu, at, "component")
    yield replace(reaction_held(sheet, d.inner, inner, d.a, (P1 - X) * mu), kind="inner")
    yield replace(reaction_held(sheet, d.inner, reaction(d.a, d.b), d.b, (X - P1) * mu), kind="inner")


def reaction_held(sheet: Sheet, pair: Pair, of: Quantity, link: str, vector: complex) -> Held:
    """A whole reaction; that of a guide where it acts along the guide, else at the slider with a moment."""
    joint, offset = sheet.joint(pair), sheet.offset(pair)
    if pair.kind == "R" or abs(offset) <= FAR * sheet.mu_l:
        return Held(of, link, vector, joint + offset)
    moment = guide_moment(pair.other(link), link)
    return Held(of, link, vector, joint, couple=float(cross(offset, vector)), moment=moment)
