"""The numbers of torsion springs: what is stated of them, and how far their links turn against one another."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinetostatics.solve.lengths import torsions_of, turned
from tmm_report.chapters.lever.kinetostatics.ties import Twist
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, kept, text_column
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics

SPRINGS = Message(N_("torsion springs"))
ANGLES = Message(N_("angles by which links turn against one another, with torsion springs between them"))
STIFFNESS = Quantity("c", Symbol("c"), "N·m/rad", Message(N_("stiffness of the torsion spring")))
PRELOAD = Quantity("M_0", Symbol("M", "0"), "N·m", Message(N_("moment of the torsion spring at position 0")))
FREE = Quantity(
    "alpha_0",
    Symbol("alpha", "0"),
    "rad",
    Message(N_("angle from position 0 at which the torsion spring has no moment")),
)


@kept
def angle(of: str, one: str, other: str) -> Quantity:
    meaning = Message(
        N_("angle from position 0 by which link %(one)s has turned against link %(other)s: spring %(of)s"),
        {"one": one, "other": other, "of": of},
    )
    if other == FRAME:
        text = N_("angle from position 0 by which link %(one)s has turned: spring %(of)s")
        meaning = Message(text, {"one": one, "of": of})
    return Quantity(f"phi_{of}", Symbol("phi", of), "rad", meaning, "deg")


def angle_of(twist: Twist) -> Quantity:
    """Of the link of one end against that of the other."""
    return angle(twist.of, twist.on, twist.other)


def at_end(twist: Twist) -> Quantity:
    """The moment on one of its links."""
    return _at_end(twist.of, twist.on, twist.name or twist.of)


@kept
def _at_end(of: str, on: str, name: str) -> Quantity:
    meaning = Message(N_("moment on link %(on)s: %(name)s"), {"on": on, "name": name})
    return Quantity(f"M_{of},{on}", Symbol("M", f"{of},{on}"), "N·m", meaning)


def tables(found: Kinetostatics) -> Iterator[Table]:
    springs = torsions_of(found.given)
    if not springs:
        return
    ties = [one.tie for one in springs]
    numbered = [(STIFFNESS, [tie.stiffness for tie in ties])]
    if any(tie.preload is not None for tie in ties):
        numbered.append((PRELOAD, [math.nan if tie.preload is None else tie.preload for tie in ties]))
    numbered.append((FREE, [one.law.free for one in springs]))
    texts = (
        ("key", N_("how it is called"), [one.of for one in springs]),
        ("name", N_("its name"), [one.name or one.of for one in springs]),
        ("one", N_("link that takes its moment"), [one.on for one in springs]),
        ("other", N_("link that takes the opposite moment"), [one.other for one in springs]),
    )
    yield Table(
        "torsion_springs",
        SPRINGS,
        (
            *(text_column(key, Message(text), values) for key, text, values in texts),
            *(Column(of, values, [_numbered(of, one) for one in springs]) for of, values in numbered),
        ),
    )
    law = found.kinematics.by_law
    for name, solved in (("table", found.table), ("diagram", found.diagram)):
        columns = (angle_of(one).column(turned(one, found.kinematics, solved.motion)) for one in springs)
        yield Table(f"twists_{name}", ANGLES, (*where(solved.turned, law), *columns))


def _numbered(of: Quantity, one: Twist) -> Symbol:
    """The symbol of one of them: c_k1."""
    sign = of.sign
    return Symbol(sign.base, ",".join(filter(None, (sign.sub, one.of))))
