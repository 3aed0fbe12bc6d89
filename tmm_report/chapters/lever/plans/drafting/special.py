"""A group of class III with three legs in a plan: constructed by lines through a special point (Assur) of its basis.

The basis link is joined to three legs. Of a leg the motion of its outer end is known, and the direction in which its
inner end moves about that: across the leg, or along its guide. The line of a leg is the one through its inner end
across that direction. Whatever point of the basis link lies on it, its velocity beside the known one has the same
direction; the point S in which the lines of two legs cross therefore has two such directions, and its velocity is where
two lines of the plan cross. With S known, the third leg gives its inner end as in a dyad, and the rest of the link is
similar to it. Accelerations: the same, beside the normal and Coriolis parts, which are known from the velocities.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 4 (special points of a group of class III).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import permutations

from tmm_report.chapters.lever.kinematics.quantities import coordinate
from tmm_report.chapters.lever.plans.drafting.branch import Line, bend, bends, terms
from tmm_report.chapters.lever.plans.drafting.plan import LegLine, Special, Stroke
from tmm_report.chapters.lever.plans.drafting.sheet import Sheet
from tmm_report.mechanics.calculus.vectors import resolve, sine, unit
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.vector_equations import Branch, System
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Formula, Symbol, Term, Var, VectorEquation
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.terms.directions import X_OF, Y_OF
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, segment_of
from tmm_report.records import dataclass

LEAST = (
    0.1  # sine of the angle at which lines cross, in the scheme and in the plan, that a point is read from
)
FAR = 200.0  # mm of paper: a special point further away is not drawn

NORMAL = N_("normal acceleration of point %(one)s relative to point %(other)s")

Lines = Mapping[Branch, tuple[Line, list[Formula]]]


@dataclass(frozen=True, eq=False)
class Leg:
    """A leg on the scheme: its inner end `place`, a point of the basis link, m; the unit direction in which that moves
    about the known point `start` (None: a fixed one). `on_basis`: its guide is on the basis link."""

    branch: Branch
    end: str
    place: complex
    direction: complex
    start: str | None
    on_basis: bool = False

    @property
    def line(self) -> LegLine:
        if self.branch.arm is not None:
            return LegLine("".join(self.branch.arm), "", "")
        return LegLine("", str(self.branch.guide), self.branch.start or "" if self.on_basis else self.end)

    @property
    def note(self) -> str:
        return "⟂ " + "".join(self.branch.arm) if self.branch.arm else f"∥ {self.branch.guide}"

    @property
    def about(self) -> str:
        """The point about which the special point is found: the outer end, or the guide's point under the inner end."""
        return self.branch.arm[0] if self.branch.arm else self.start or f"{self.end}0"


@dataclass(frozen=True, eq=False)
class Basis:
    """The basis link, its legs, the last of which gives the second point, and the place of the special point, m."""

    link: str
    legs: tuple[Leg, Leg, Leg]
    place: complex

    @property
    def pair(self) -> tuple[Leg, Leg]:
        return self.legs[0], self.legs[1]


def basis(sheet: Sheet, system: System, directions: dict[Branch, complex]) -> Basis | None:
    """The basis link of a group that can be constructed so; None where it cannot. `directions`: of branches' guides."""
    group = system.group.group
    joined: dict[str, list[Pair]] = {}
    for pair in group.inner:
        for link in pair.links:
            joined.setdefault(link, []).append(pair)
    links = [link for link, pairs in joined.items() if len(pairs) == 3]
    if group.group_class != 3 or len(group.outer) != 3 or len(links) != 1:
        return None
    legs = [_leg(sheet, system, links[0], pair, directions) for pair in joined[links[0]]]
    found = [leg for leg in legs if leg is not None]
    known = {leg.end for leg in found}
    if len(found) < 3 or any(point not in known and not sheet.has(point) for point in system.vertices):
        return None
    return _best(sheet, links[0], found)


def _leg(
    sheet: Sheet, system: System, link: str, inner: Pair, directions: dict[Branch, complex]
) -> Leg | None:
    """The leg at an inner pair of the basis link."""
    own = inner.other(link)
    outer = next((pair for pair in system.group.group.outer if own in pair.links), None)
    if outer is None:
        return None
    for branch in system.branches:
        if inner.kind == outer.kind == "R" and branch.arm == (outer.name, inner.name):
            place = sheet.place(inner.name)
            start = branch.start if branch.start and sheet.has(branch.start) else None
            if branch.start is None or start:
                return Leg(branch, inner.name, place, unit(1j * (place - sheet.place(outer.name))), start)
        elif branch.turns:
            continue
        elif (inner.kind, outer.kind) == ("R", "P") and (branch.guide, branch.end) == (
            outer.name,
            inner.name,
        ):
            if branch.link not in system.group.links:
                return Leg(branch, branch.end, sheet.place(branch.end), directions[branch], branch.start)
        elif (inner.kind, outer.kind, branch.guide, branch.link) == ("P", "R", inner.name, link):
            end, at = branch.start, outer.name
            if end and branch.end == at and sheet.has(at):
                return Leg(branch, end, sheet.place(at), directions[branch], at, True)
    return None


def _best(sheet: Sheet, link: str, legs: Sequence[Leg]) -> Basis | None:
    """The special point from which most can be read: lines that cross at large angles, near the mechanism."""
    best, found = LEAST, None
    for one, other, third in permutations(legs):
        crossing = sine(one.direction, other.direction)
        if crossing < LEAST:
            continue
        x, _ = resolve(other.place - one.place, 1j * one.direction, -1j * other.direction)
        place = complex(one.place + x * 1j * one.direction)
        away = third.place - place
        if not 0.002 < abs(away) / sheet.scales.length / 1e3 < FAR / 1e3:
            continue
        quality = min(crossing, sine(1j * away, third.direction))
        if quality > best * (1 + 1e-9):
            best, found = quality, Basis(link, (one, other, third), place)
    return found


def construct(sheet: Sheet, found: Basis, lines: Lines) -> Special:
    """Draw the special point, then the inner ends of the legs; all of the basis link is similar to them. `lines`: of
    the legs whose known parts are drawn."""
    pair, third = found.legs[:2], found.legs[2]
    letter = sheet.letter(" s")
    name = letter.upper()
    worked: list[Formula] = []
    starts = []
    for leg in pair:
        at, ends = _known(sheet, leg, lines)
        at, _, formulas = _normal(sheet, found.link, at, ends, (name, leg.end), found.place - leg.place)
        starts.append(at)
        worked += formulas
    x, _ = resolve(starts[1] - starts[0], pair[0].direction, -pair[1].direction)
    z = sheet.vertices[letter] = sheet.pen.place(starts[0] + complex(x) * pair[0].direction)
    end, begin, formulas = _third(sheet, found, lines, z, letter, name)
    for start, to in ((starts[0], z), (starts[1], z), (begin, end)):
        sheet.strokes.append(Stroke(start, to, "", None, "line"))
    turn = (end - z) / (third.place - found.place)
    for leg in found.legs:
        sheet.absolute(leg.end, sheet.pen.place(z + turn * (leg.place - found.place)))
    equations = (_special_equation(sheet, pair, name), _third_equation(sheet, third, name))
    crossing = (pair[0].line, pair[1].line)
    place = _coordinates(sheet, name, found.place)
    return Special(name, letter, found.link, third.end, place, crossing, equations, tuple(worked + formulas))


def _coordinates(sheet: Sheet, name: str, place: complex) -> tuple[Var, Var]:
    """Where the special point lies in the scheme, m, as it is read there."""

    def read(metres: float) -> float:
        mm = math.copysign(sheet.pen.read(metres / sheet.scales.length), metres)
        return float(round_significant(mm * sheet.scales.length, DIGITS + 2)) + 0.0  # no -0

    x = sheet.worked.number(coordinate("x", X_OF, name), read(place.real))
    return x, sheet.worked.number(coordinate("y", Y_OF, name), read(place.imag))


def _third(
    sheet: Sheet, found: Basis, lines: Lines, z: complex, letter: str, name: str
) -> tuple[complex, complex, list[Formula]]:
    """The inner end of the third leg in the plan, from the special point at `z`; where its line begins; how."""
    leg = found.legs[2]
    away = leg.place - found.place
    begin, _, formulas = _normal(sheet, found.link, z, letter, (leg.end, name), away)
    own, _ = _known(sheet, leg, lines)
    across = unit(1j * away)
    y, _ = resolve(own - begin, across, -leg.direction)
    return begin + complex(y) * across, begin, formulas


def _known(sheet: Sheet, leg: Leg, lines: Lines) -> tuple[complex, str]:
    """Where the known part of a leg's vector ends in the plan, and its lettering."""
    if not leg.on_basis:
        line, _ = lines[leg.branch]
        return line.z_bend, line.letter
    start = sheet.letter(str(leg.start))
    z = sheet.vertices[start]
    if not bends(sheet, leg.branch):
        return z, start
    # the point of the basis link about the one that slides along it: the Coriolis part is turned round
    return _laid(sheet, z, -bend(sheet, leg.branch, leg.direction), Symbol("a", leg.branch.pair, "k"))


def _laid(sheet: Sheet, z: complex, acceleration: complex, symbol: Symbol) -> tuple[complex, str]:
    """Lay off an acceleration of the construction, and letter its end."""
    count = 1 + sum(stroke.role == "bend" and not stroke.key for stroke in sheet.strokes)
    letter = sheet.letter_of_bend(f"m{count}")
    end = sheet.vertices[letter] = sheet.pen.place(z + acceleration / sheet.scale)
    sheet.strokes.append(Stroke(z, end, "", symbol, "bend"))
    return end, letter


def _normal(
    sheet: Sheet, link: str, z: complex, start: str, points: tuple[str, str], arm: complex
) -> tuple[complex, str, list[Formula]]:
    """Lay off the normal acceleration of one point of the basis link about another, `arm` m away, from the vertex
    `start` at `z`: its end, its lettering, and how it is worked."""
    v, mm = sheet.velocity, sheet.pen.read(arm / sheet.scales.length)
    if v is None or mm == 0 or not v.values[f"w_{link}"]:
        return z, start, []
    ends = "".join(points)
    size = sheet.number(f"w_{link}", v.values[f"w_{link}"]) ** 2 * sheet.length(
        *points, mm * sheet.scales.length
    )
    symbol = Symbol("a", ends, "n")
    meaning = Message(NORMAL, {"one": points[0], "other": points[1]})
    quantity = Quantity(f"a_{ends}_n", symbol, "m/s²", meaning)
    value = sheet.worked.hand(quantity, size)
    end, letter = _laid(sheet, z, -((v.turns[link] * v.scale).imag ** 2) * arm, symbol)
    segment = segment_of(start + letter)
    laid = sheet.worked.laid_off(segment, sheet.worked.number(quantity, value.written) / sheet.mu)
    return end, letter, [value, laid]


# ---------------------------------------------------------------- the equations


def _special_equation(sheet: Sheet, legs: Sequence[Leg], name: str) -> VectorEquation:
    """The special point by both legs."""
    sides = []
    for leg in legs:
        side = _side(sheet, leg)[:-1]
        if sheet.kind == "a":
            side.append(Term(Symbol("a", name + leg.end, "n"), 2))
        part = {"v": ""}.get(sheet.kind, "t" if leg.branch.turns else "r")
        sides.append([*side, Term(Symbol(sheet.kind, name + leg.about, part), 1, leg.note)])
    return VectorEquation([[Term(Symbol(sheet.kind, name))], *sides])


def _third_equation(sheet: Sheet, leg: Leg, name: str) -> VectorEquation:
    """The inner end of the third leg: from the special point, and by the leg."""
    ends, across = leg.end + name, "⟂ " + leg.end + name
    side = [Term(Symbol(sheet.kind, name), 2)]
    if sheet.kind == "a":
        side.append(Term(Symbol("a", ends, "n"), 2))
    side.append(Term(Symbol(sheet.kind, ends, "t" if sheet.kind == "a" else ""), 1, across))
    return VectorEquation([[Term(sheet.symbol(f"{sheet.kind}_{leg.end}"))], side, _side(sheet, leg)])


def _side(sheet: Sheet, leg: Leg) -> list[Term]:
    """A leg as a side of a vector equation; one whose guide is on the basis link is turned round."""
    side = terms(sheet, leg.branch)
    if not leg.on_basis:
        return side
    # v_A = v_A3 + v_AA3, so v_A3 = v_A - v_AA3
    own = Term(sheet.symbol(f"{sheet.kind}_{leg.start}"), 2)
    return [own, *(Term(term.symbol, term.known, term.note, True) for term in side[1:])]
