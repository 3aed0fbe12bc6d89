"""Words and labels that several chapters of a lever mechanism print: groups, directions, senses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.i18n import NP_, Translator
from tmm_report.mechanics.lever.assur_groups import Group, Structure
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.problems import N_
from tmm_report.quantity.terms.directions import COMPASS
from tmm_report.quantity.text import roman, unit_text
from tmm_report.report.page import LOWERED, Page

if TYPE_CHECKING:  # loaded only where methods are compared
    from tmm_report.mechanics.rivals.model import Method

PAIR_KINDS = {"R": N_("revolute"), "P": N_("prismatic"), "H": N_("higher")}
ALONG_POINT = {
    "along": N_("along the motion of the point"),
    "against": N_("against the motion of the point"),
}
ALONG_LINK = {
    "along": N_("along the rotation of the link"),
    "against": N_("against the rotation of the link"),
}


OF_SO_MANY = (  # in words up to ten, as a sentence says them of things it counts: of two links, two pairs
    NP_("of so many", "one"), NP_("of so many", "two"), NP_("of so many", "three"), NP_("of so many", "four"),
    NP_("of so many", "five"),
    NP_("of so many", "six"), NP_("of so many", "seven"), NP_("of so many", "eight"), NP_("of so many", "nine"),
    NP_("of so many", "ten"),
)  # fmt: skip
SO_MANY_PAIRS = (
    NP_("so many pairs", "one"), NP_("so many pairs", "two"), NP_("so many pairs", "three"),
    NP_("so many pairs", "four"),
    NP_("so many pairs", "five"), NP_("so many pairs", "six"), NP_("so many pairs", "seven"),
    NP_("so many pairs", "eight"), NP_("so many pairs", "nine"), NP_("so many pairs", "ten"),
)  # fmt: skip


def of_so_many(count: int, tr: Translator) -> str:
    """How many things something consists of, in words up to ten."""
    return tr.pgettext("of so many", OF_SO_MANY[count - 1]) if 1 <= count <= 10 else str(count)


def so_many_pairs(count: int, tr: Translator) -> str:
    return tr.pgettext("so many pairs", SO_MANY_PAIRS[count - 1]) if 1 <= count <= 10 else str(count)


def group_name(group: Group) -> str:
    """The label with the order as an index: II₂(2,3)."""
    return f"{roman(group.group_class)}{str(group.order).translate(LOWERED)}({','.join(group.links)})"


def group_label(label: str) -> str:
    """A group's label as the solvers write it, "II2(2,3)", with the order as an index."""
    name, _, links = label.partition("(")
    return f"{name.translate(LOWERED)}({links}"


def structural_formula(structure: Structure) -> str:
    """The structural formula of a decomposition: I(0,1) → II₂(2,3)."""
    parts = [f"I(0,{structure.mechanism.driver.link})", *(_wheel(one) for one in structure.wheels)]
    for group in structure.groups:
        parts += [group_name(group), *(_wheel(one) for one in group.wheels)]
    return " → ".join(parts)


def _wheel(one: Coupled) -> str:
    """A link that a mesh moves: z(4)."""
    return f"z({one.link})"


def force_direction(direction: complex | str, page: Page) -> Markup:
    """Of a force: fixed, or along its point's motion."""
    if isinstance(direction, str):
        return page.t(ALONG_POINT[direction])
    for unit, word in COMPASS.items():
        if abs(direction - unit) < 1e-9:
            return page.t(word)
    return page.t("at %(angle)s° to the x axis", angle=page.num(np.degrees(np.angle(direction)), 4))


def sense(direction: float | str, page: Page) -> Markup:
    """Of a moment or a rotation: its sense, or along its link's rotation."""
    if isinstance(direction, str):
        return page.t(ALONG_LINK[direction])
    return page.t("counter-clockwise") if direction > 0 else page.t("clockwise")


def degrees(angle: float, page: Page) -> str:
    """An angle given in rad, in degrees, to a tenth."""
    return page.num(np.degrees(angle), places=1)


def method_name(method: Method[Any, Any], tr: Translator) -> str:
    """A method in words, with what its error depends on: "construction, 0.1 mm", as the language writes it."""
    number, _, unit = method.settings.partition(" ")
    said = tr.gettext(method.title)
    if not number:
        return said
    return f"{said}, {number.replace('.', tr.decimal)} {unit_text(unit, tr.language)}".strip()
