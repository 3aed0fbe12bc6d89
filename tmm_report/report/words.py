"""What things are called in the note: links by their motion, pairs, groups, and the meaning of every symbol."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields
from typing import Any, NamedTuple

import numpy as np
from markupsafe import Markup

from tmm_report.mechanics.cycle import Extreme, larger
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.higher import HigherGroup
from tmm_report.mechanics.mechanism import FRAME, Guide, ZeroAngle
from tmm_report.mechanics.structure import ROMAN, Group, Pair, Structure
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.written import Equation, Unknown, reaction_key, symbol_of
from tmm_report.report.page import Page

SUBSCRIPT = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


class LinkName(NamedTuple):
    name: str
    motion: str


FIXED = LinkName(N_("frame"), N_("fixed"))
ROTATION, ROCKING, TRANSLATION, PLANE = N_("rotation"), N_("rocking"), N_("translation"), N_("plane motion")

KINDS = {1: "RRR", 2: "RRP", 3: "RPR", 4: "PRP", 5: "RPP"}
PAIR_KINDS = {"R": N_("revolute"), "P": N_("prismatic")}
ORDINALS = {1: N_("1st kind"), 2: N_("2nd kind"), 3: N_("3rd kind"), 4: N_("4th kind"), 5: N_("5th kind")}
COMPASS = {1: N_("to the right"), -1: N_("to the left"), 1j: N_("upwards"), -1j: N_("downwards")}
EXTREMES = {1: N_("rightmost"), -1: N_("leftmost"), 1j: N_("topmost"), -1j: N_("lowest")}

# Dyad kind -> how its position is found.
CLOSURES = {
    1: N_(
        "group %(group)s: point %(inner)s lies at the intersection of two circles, the one about %(a)s "
        "described by link %(one)s and the one about %(b)s described by link %(other)s"
    ),
    2: N_(
        "group %(group)s: point %(inner)s lies at the intersection of the circle about %(a)s described "
        "by link %(one)s with the line of guide %(b)s"
    ),
    3: N_(
        "group %(group)s: the direction of guide %(inner)s is found from the triangle with the vertices "
        "%(a)s and %(b)s, in which the distance of the guide from the joints is known"
    ),
    4: N_("group %(group)s: point %(inner)s lies at the intersection of the lines of guides %(a)s and %(b)s"),
    5: N_(
        "group %(group)s: the position of link %(other)s on guide %(b)s is found from the condition that"
        " guide %(inner)s passes at a known distance from point %(a)s"
    ),
}
# The same of a group above class II.
HIGHER_CLOSURE = N_(
    "group %(group)s: the equations of its closed vector contours, %(n)s in projections on the axes, are solved "
    "together by Newton's method; the group is followed from the assembly of the sketch by steps so short that by the "
    "Newton–Kantorovich condition only one solution lies near, so it cannot pass into another assembly"
)

# Base of a symbol, and its upper index where that matters -> meaning; %(of)s is the lower index.
MEANINGS = {
    ("v", ""): (N_("velocity of point %(of)s"), "m/s"),
    ("a", ""): (N_("acceleration of point %(of)s"), "m/s²"),
    ("v", "relative"): (N_("velocity of point %(one)s relative to point %(other)s"), "m/s"),
    ("a", "n"): (N_("normal acceleration of point %(one)s relative to point %(other)s"), "m/s²"),
    ("a", "t"): (N_("tangential acceleration of point %(one)s relative to point %(other)s"), "m/s²"),
    ("a", "k"): (N_("Coriolis acceleration of point %(one)s relative to point %(other)s"), "m/s²"),
    ("a", "r"): (N_("sliding acceleration of point %(one)s relative to point %(other)s"), "m/s²"),
    ("omega", ""): (N_("angular velocity of link %(of)s"), "rad/s"),
    ("epsilon", ""): (N_("angular acceleration of link %(of)s"), "rad/s²"),
    ("l", ""): (N_("length of segment %(of)s"), "m"),
    ("m", ""): (N_("mass of link %(of)s"), "kg"),
    ("J", ""): (N_("moment of inertia of link %(of)s about its mass centre"), "kg·m²"),
    ("G", ""): (N_("weight of link %(of)s"), "N"),
    ("F", ""): (N_("inertia force of link %(of)s"), "N"),
    ("M", ""): (N_("inertia couple of link %(of)s"), "N·m"),
    ("M", "stated"): (N_("moment applied to link %(of)s"), "N·m"),
    ("SigmaM", ""): (N_("sum of the moments of the loads about point %(of)s"), "N·m"),
    ("M", "guide"): (N_("moment of the reaction of link %(one)s on link %(other)s in their guide"), "N·m"),
    ("M", "bal"): (N_("balancing moment on the driving link"), "N·m"),
    ("P", ""): (N_("load applied at point %(of)s"), "N"),
    ("h", ""): (N_("arm of force %(of)s"), "m"),
    ("L", ""): (N_("length of the vector of reaction %(of)s in the plan"), "mm"),
    ("R", ""): (N_("reaction of link %(one)s on link %(other)s"), "N"),
    ("R", "x"): (N_("projection of the reaction of link %(one)s on link %(other)s on the x axis"), "N"),
    ("R", "y"): (N_("projection of the reaction of link %(one)s on link %(other)s on the y axis"), "N"),
    ("R", "t"): (N_("tangential component of the reaction of link %(one)s on link %(other)s"), "N"),
    ("mu", "l"): (N_("scale of lengths"), "m/mm"),
    ("mu", "v"): (N_("scale of the velocity plan"), "(m/s)/mm"),
    ("mu", "a"): (N_("scale of the acceleration plan"), "(m/s²)/mm"),
    ("mu", "F"): (N_("scale of the force plan"), "N/mm"),
    ("segment", ""): (N_("length of a vector in the plan"), "mm"),
}


class Words:
    """Names in the language of the note."""

    def __init__(self, results: Any, page: Page):
        self.results, self.page = results, page
        self.mechanism = results.variant.mechanism
        self.pairs: Sequence[Pair] = results.structure.pairs

    # ------------------------------------------------------------ links, pairs, groups

    def link(self, link: str) -> LinkName:
        """The link's name by its motion, and its motion (message ids)."""
        if link == FRAME:
            return FIXED
        carries = any(p.kind == "P" and p.slider != link and link in p.links for p in self.pairs)
        slides = [p.other(link) for p in self.pairs if p.kind == "P" and p.slider == link]
        pivoted = any(p.kind == "R" and FRAME in p.links and link in p.links for p in self.pairs)
        turning = ROTATION if self._makes_turns(link) else ROCKING
        if link == self.mechanism.driver.link:
            return LinkName(N_("crank") if turning == ROTATION else N_("driving rocker"), turning)
        if FRAME in slides:
            return LinkName(N_("translating slotted link") if carries else N_("slider"), TRANSLATION)
        if self._is_ternary(link) and not pivoted:
            return LinkName(N_("ternary link"), self._free_motion(link))
        if pivoted and carries:
            return LinkName(N_("slotted link"), turning)
        if pivoted:
            name = N_("rocking block") if slides else N_("rocker")
            return LinkName(name if turning == ROCKING or slides else N_("driven crank"), turning)
        if slides:
            return LinkName(N_("block of the slotted link"), self._free_motion(link))
        return LinkName(
            N_("slotted connecting rod") if carries else N_("connecting rod"), self._free_motion(link)
        )

    def _is_ternary(self, link: str) -> bool:
        """Whether the link is one of those with three or more pairs in a group above class II."""
        higher = any(link in g.links and g.group_class > 2 for g in self.results.structure.groups)
        return higher and sum(link in pair.links for pair in self.pairs) > 2

    def _free_motion(self, link: str) -> str:
        rate = self.results.kinematics.diagram.angular_velocity(link)
        return PLANE if np.any(np.abs(rate) > 1e-9 * abs(self.results.kinematics.omega)) else TRANSLATION

    def _makes_turns(self, link: str) -> bool:
        turn = np.unwrap(np.angle(self.results.kinematics.diagram.turn(link)))
        return bool(abs(turn[-1] - turn[0]) > 2 * np.pi - 1e-6)

    def name(self, link: str) -> str:
        return self.page.tr.gettext(self.link(link).name)

    def motion(self, link: str) -> str:
        return self.page.tr.gettext(self.link(link).motion)

    def pair_kind(self, pair: Pair) -> str:
        return self.page.tr.gettext(PAIR_KINDS[pair.kind])

    def group_kind(self, group: Group) -> str:
        """ "2nd kind (RRP)"; a dash for a group that is no dyad."""
        if group.kind is None:
            return "—"
        return f"{self.page.tr.gettext(ORDINALS[group.kind])} ({KINDS[group.kind]})"

    def roman(self, number: int) -> str:
        return ROMAN[number]

    def group(self, group: Group) -> str:
        """The label with the order as an index: II₂(2,3)."""
        return f"{ROMAN[group.group_class]}{str(group.order).translate(SUBSCRIPT)}({','.join(group.links)})"

    def structural_formula(self) -> str:
        return self.formula(self.results.structure.linkage.structure)

    def formula(self, structure: Structure) -> str:
        """The structural formula of a decomposition: I(0,1) → II₂(2,3)."""
        groups = [self.group(group) for group in structure.groups]
        return " → ".join([f"I(0,{structure.mechanism.driver.link})", *groups])

    # ------------------------------------------------------------ directions and position 0

    def direction(self, direction: complex | str) -> Markup:
        """Of a force: fixed, or along its point's motion."""
        if isinstance(direction, str):
            words = {
                "along": N_("along the motion of the point"),
                "against": N_("against the motion of the point"),
            }
            return self.page.t(words[direction])
        for unit, word in COMPASS.items():
            if abs(direction - unit) < 1e-9:
                return self.page.t(word)
        return self.page.t(
            "at %(angle)s° to the x axis", angle=self.page.num(np.degrees(np.angle(direction)), 4)
        )

    def turning(self, direction: int | str) -> Markup:
        """Of a moment: a sense, or along its link's rotation."""
        if isinstance(direction, str):
            words = {
                "along": N_("along the rotation of the link"),
                "against": N_("against the rotation of the link"),
            }
            return self.page.t(words[direction])
        return self.page.t("counter-clockwise") if direction > 0 else self.page.t("clockwise")

    def zero(self) -> Markup:
        """Which position counts as position 0."""
        t, zero = self.page.t, self.mechanism.driver.zero
        if isinstance(zero, ZeroAngle):
            angle = self.page.num(np.degrees(zero.angle), 5)
            text = N_("the position in which link %(link)s makes an angle of %(angle)s° with the x axis")
            return t(text, link=self.mechanism.driver.link, angle=angle)
        if zero.point is None:
            sense = self.turning(1 if np.real(zero.direction) > 0 else -1)
            return t("the extreme %(sense)s position of link %(link)s", sense=sense, link=zero.link)
        word = next((w for unit, w in EXTREMES.items() if abs(zero.direction - unit) < 1e-9), N_("extreme"))
        return t("the %(which)s position of point %(point)s", which=t(word), point=zero.point)

    # ------------------------------------------------------------ positions of the groups

    def closures(self) -> list[Markup]:
        """How the position of each group is found, in the order of assembly."""
        return [self._closure(d) for d in self.results.structure.linkage.groups]

    @property
    def has_assemblies(self) -> bool:
        """Whether a group has several assemblies: not where guides alone fix it."""
        return any(isinstance(d, HigherGroup) or d.kind <= 3 for d in self.results.structure.linkage.groups)

    def _closure(self, d: Dyad | HigherGroup) -> Markup:
        if isinstance(d, HigherGroup):
            return self.page.t(HIGHER_CLOSURE, group=self.group(d.group), n=len(d.links))
        text = CLOSURES[d.kind]
        a, b, inner = d.outer_a.name, d.outer_b.name, d.inner.name
        return self.page.t(text, group=self.group(d.group), a=a, b=b, inner=inner, one=d.a, other=d.b)

    def guided(self, links: Sequence[str]) -> bool:
        """Whether a guide joins one of the links."""
        return any(pair.kind == "P" and set(pair.links) & set(links) for pair in self.pairs)

    def label(self, label: str) -> str:
        """A group's label as the chapters write it, "II2(2,3)", with the order as an index."""
        name, _, links = label.partition("(")
        return f"{name.translate(SUBSCRIPT)}({links}"

    def guides(self) -> list[Markup]:
        """Sentences that describe the guides."""
        return [self._guide(guide) for guide in self.mechanism.guides.values()]

    def _guide(self, guide: Guide) -> Markup:
        angle = self.page.num(np.degrees(np.angle(guide.direction)), 5, scale=180.0)
        x, y = (self.page.num(part) for part in (guide.through.real, guide.through.imag))
        if guide.link == FRAME:
            text = N_(
                "guide %(name)s is fixed, it passes through the point (%(x)s; %(y)s) m at an angle of "
                "%(angle)s° to the x axis"
            )
        else:
            text = N_(
                "guide %(name)s belongs to link %(link)s, in whose own axes it passes through the "
                "point (%(x)s; %(y)s) m at an angle of %(angle)s°"
            )
        return self.page.t(text, name=guide.name, link=guide.link, x=x, y=y, angle=angle)

    @property
    def heavy_links(self) -> list[str]:
        return [
            name
            for name, link in self.mechanism.links.items()
            if name != FRAME and (link.mass or link.inertia)
        ]

    def has_output(self, kind: str) -> bool:
        return any(travel.output.kind == kind for travel in self.results.kinematics.travels)

    # ------------------------------------------------------------ numbers

    def degrees(self, angle: float) -> str:
        """An angle given in rad, in degrees, to a tenth."""
        return self.page.num(np.degrees(angle), places=1)

    @staticmethod
    def largest(extremes: tuple[Extreme, Extreme]) -> Extreme:
        """Of the least and the greatest value the one with the larger magnitude."""
        return larger(extremes)

    # ------------------------------------------------------------ symbols

    def symbols(self, keys: Sequence[str]) -> Markup:
        return self.page.listed(self.page.sym(symbol_of(key)) for key in keys)

    def of(self, *formulas: Formula | Equation) -> list[dict[str, Any]]:
        """Items of a "where" list: every symbol of the formulas in their order, with its meaning and unit."""
        symbols = [s for f in formulas for s in _symbols_of(f)]
        items = [self._item(symbol) for symbol in symbols]
        return [item for item in items if item is not None]

    def _item(self, symbol: Symbol) -> dict[str, Any] | None:
        found = MEANINGS.get(self._meaning_key(symbol))
        if found is None:
            return None
        message, unit = found
        one, other = self._two(symbol.sub)
        of = (
            self.page.sym(Symbol(*_force(symbol.sub)))
            if symbol.base in "hL"
            else symbol.sub.removeprefix("I")
        )
        meaning = self.page.t(message, of=of, one=one, other=other)
        # segments differ only by their ends, which name themselves
        same = "segment" if symbol.kind == "segment" else symbol
        return {"symbol": symbol, "id": same, "meaning": meaning, "unit": unit}

    def _two(self, sub: str) -> tuple[str, str]:
        """The two points or links that an index names: "BA" -> B, A; "B2B4" -> B2, B4; "12,3" -> 12, 3."""
        if "," in sub:
            first, _, second = sub.partition(",")
            return first, second
        known = {*self.mechanism.point_names, *self.mechanism.links}
        cuts = [(sub[:k], sub[k:]) for k in range(1, len(sub))]
        halves = [cut for cut in cuts if all(self._named(half, known) for half in cut)]
        return next(iter([*halves, (sub[:1], sub[1:])]))

    def _meaning_key(self, symbol: Symbol) -> tuple[str, str]:
        base, sub = symbol.base, symbol.sub
        if symbol.kind == "segment":
            return "segment", ""
        if base == "mu":
            return base, sub
        if base == "M":
            return base, self._moment_of(sub)
        if base == "v":
            return base, "" if self._named(sub, {*self.mechanism.point_names}) else "relative"
        return base, symbol.sup

    def _moment_of(self, sub: str) -> str:
        if sub in [reaction_key(*pair.links)[2:] for pair in self.pairs if pair.kind == "P"]:
            return "guide"
        return "bal" if sub == "bal" else "" if sub.startswith("I") else "stated"

    def _named(self, half: str, known: set[str]) -> bool:
        return half in known or any(half == point + link for point in known for link in self.mechanism.links)


def _symbol(key: Symbol | str) -> Symbol:
    return math_symbol(key) if isinstance(key, str) else key


def _symbols_of(formula: Formula | Equation) -> Iterator[Symbol]:
    """Symbols of a formula in their order; of an equation its unknowns, its numbers having none."""
    if isinstance(formula, Formula):
        yield _symbol(formula.result)
    for var in _variables(formula.expression):
        if isinstance(formula, Formula) or isinstance(var, Unknown):
            yield var.sign


def _variables(node: Expr) -> Iterator[Var]:
    if isinstance(node, Var):
        yield node
        return
    for item in fields(node):
        child = getattr(node, item.name)
        if isinstance(child, Expr):
            yield from _variables(child)


def _force(sub: str) -> tuple[str, str]:
    """A force's base and index from the index of its arm or vector: "FI2" -> F, I2; "R12" -> R, 12."""
    return sub[:1], sub[1:]
