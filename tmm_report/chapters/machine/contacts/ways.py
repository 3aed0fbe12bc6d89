"""How the numbers of friction in single pairs are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

PAIR = N_("From the section of the pair: its coefficient, its angle of friction and its efficiency.")
LOCKS = N_(
    "It locks by itself where the angle of friction is the larger, so that the efficiency "
    "backwards is not above zero."
)
BOOK = N_("From the table of materials, by the two that rub and their lubrication.")
TABLE = N_("Stated, or the middle of the range in the table of materials by the two that rub.")
RATIO = N_("Stated, or by the ratio and the other pulley.")
CONE = N_("The angle whose tangent is the coefficient of friction.")

WAYS = (
    Way("contacts.kind contacts.name", NAME),
    Way("contacts.number", COUNTED),
    Way("contacts.locks", LOCKS, of="kind phi_fr eta"),
    Way("contacts.f_low contacts.f_high", BOOK, of="name f"),
    Way("contacts.phi_fr", CONE, of="name f"),
    Way("contacts.f", PAIR, of="number kind"),
    Way("contacts.*", PAIR, of="number kind f phi_fr"),
    Way("contacts_*_eta", PAIR, of="contacts_{0}.*"),
    Way(
        "contacts_*.f contacts_*.f_base contacts_*.f_collar contacts_*.f_guide contacts_*.f_red",
        TABLE,
        of="phi_fr eta groove",
    ),
    Way("contacts_*.d_2", RATIO, of="d_1 omega_1"),
    Way("contacts_*.*", STATED),
)
