"""Which pairs rub and with what coefficient: pivots, guides, and the contacts of cams with their followers."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.mechanics.lever.assur_groups import Pair, Structure
from tmm_report.mechanics.lever.cams.rubbing import Contact, replacing


def rubbing_of(given: Friction, pair: Pair) -> Rubbing | None:
    """Friction of a pair: its own, else that of all pivots or guides; None where nothing is stated, and of teeth and of
    what rolls."""
    if pair.kind == "H" or pair.name in given.rails:
        return None
    return given.joints.get(pair.name) or (given.pivots if pair.kind == "R" else given.guides)


def contact_of(given: Friction, contact: Contact) -> Rubbing | None:
    """Friction of a cam pair: its own, else that of all, of which the pin is that of the rollers."""
    own = given.joints.get(contact.cam.name) or given.cams
    return own if own is None or contact.rolls else replace(own, diameter=None)


def sliding_pairs(structure: Structure) -> list[Pair]:
    """The lower pairs but those of the links that stand for cam pairs: teeth are taken without friction."""
    none = replacing(structure)
    return [pair for pair in structure.pairs if pair.kind != "H" and pair.key not in none]
