"""How the transmission angles are found that no formula of the note defines."""

from tmm_report.problems import N_
from tmm_report.quantity.ways import STATED, Way

CROSSED = N_("The arc sine of the sine between both links, or between the link and the normal of the guide.")
WAYS = (
    Way("transmission_table.d_*", N_("By the places of the joints."), of="phi"),
    Way(
        "mu_*_min",
        N_("Over the whole cycle, between the positions of the table too."),
        of="transmission transmission_l_*",
    ),
    Way("*.mu_* transmission_diagram.*", CROSSED, of="phi"),
    Way("transmission transmission_l_*", STATED),
)
