"""Of what a mass is the sum that masses put into joints leave on a pivoted link: where rods hang on it directly."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.initial_data import quantities as initial
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import ChapterView

SAME = 1e-9  # relative: the sum is the mass, and nothing else was handed on to the joint


def sum_at(found: Found, view: ChapterView, given: Book, link: str, joint: str, mass: float) -> Expr | None:
    """m_2A + k (m_3 + m_2B): of all rods at the joint, with the part k of what they drive; None where the mass is that
    of one term, or where masses come from farther links too."""
    if not view.has("substituted_masses"):
        return None
    rods = [k for k, one in enumerate(found.substituted.splits) if joint in one.joints and one.link != link]
    terms: list[Expr] = [_at(view, row, found, joint) for row in rods]
    if found.given.part:
        k = view.s.var("k_part")
        terms += [k * whole for row in rods for whole in _driven(found, view, given, row, joint)]
    if not terms or (len(terms) == 1 and len(rods) == 1):
        return None
    total = sum(terms[1:], terms[0])
    return total if abs(total.value - mass) <= SAME * mass else None


def _at(view: ChapterView, row: int, found: Found, joint: str) -> Expr:
    """The mass that a rod has at a joint."""
    first = found.substituted.splits[row].joints[0] == joint
    return view.table("substituted_masses").var("m_A" if first else "m_B", row)


def _driven(found: Found, view: ChapterView, given: Book, row: int, joint: str) -> Iterator[Expr]:
    """What reciprocates at the other joint of a rod."""
    rod = found.substituted.splits[row]
    (end,) = (name for name in rod.joints if name != joint)
    heavy = [link.name for link in initial.heavy_links(found.kinematics.linkage.mechanism)]
    for pair in found.kinematics.linkage.structure.pairs:
        slider = pair.other(rod.link)
        if pair.kind != "R" or pair.name != end or rod.link not in pair.links or slider == FRAME:
            continue
        if slider in found.substituted.sliding:
            own = _at(view, row, found, end)
            yield given.tables["masses"].var("m", heavy.index(slider)) + own if slider in heavy else own
