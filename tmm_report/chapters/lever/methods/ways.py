"""How the numbers of the comparison of methods are found."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import NAME, STATED, Way

ERROR = N_("The largest difference from the closed form, by the largest value, rounded up to one digit.")
COST = N_(
    "By the table of what each method costs, for the positions of the row; the closed form at the table positions is 1."
)
FRONT = N_("Judged by the cost and the error of all rows: 1 where none is better in both.")
COUNTS = N_("Measured: what the table with so many positions gives beside the exact value over the cycle.")
CHOSEN = N_("The cheapest of those whose error is within what is admitted.")
POSITIONS = N_("The numbers of positions that are tried, with that of the variant's table among them.")

WAYS = (
    Way("methods_*.method methods_*.of", NAME),
    Way(
        "methods_motion.count methods_forces.count methods_counts.count methods_chosen.count",
        POSITIONS,
        of="method of methods_accuracy",
    ),
    Way("methods_*.cost", COST, of="method of count"),
    Way("methods_*.front", FRONT, of="method cost"),
    Way("methods_chosen.* methods_enough.*", CHOSEN, of="method of count methods_accuracy counts_accuracy"),
    Way("counts_recommended", COUNTS, of="counts_accuracy methods_accuracy"),
    Way("methods_counts.*", COUNTS, of="count counts_accuracy"),
    Way("methods_motion.* methods_forces.*", ERROR, of="method count"),
    Way("*_accuracy methods_floor", STATED),
)
