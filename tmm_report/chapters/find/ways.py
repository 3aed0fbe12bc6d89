"""How the numbers of a question asked backwards are found: the note has no formula for them."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, STATED, Way

SEARCH = N_(
    "The whole variant is solved with many values of the unknown; where the difference from what is wanted changes its "
    "sign, or is least, the place is closed in until it is known to the last digits."
)
SOLVED = N_("The number that the chapter finds with this value of the unknown.")
RATE = N_(
    "By the difference of the numbers found a little beside the root, on both sides where the range has both."
)
PAIRS = N_(
    "The whole variant is solved with pairs of values of the unknowns on a grid; from each of its cells in which both "
    "differences from what is wanted may be nought, Newton's method goes on until it is known to the last digits."
)
FORMULA = N_("By the textbook's formula, which the note prints beside the root.")
WAYS = (
    Way("find_low find_high find_wanted find_low2 find_high2 find_wanted2", STATED),
    Way("find_x", SEARCH, of="find_low find_high find_wanted"),
    Way("find_x2", PAIRS, of="find_low find_high find_wanted find_low2 find_high2 find_wanted2"),
    Way("find_y find_y2", SOLVED, of="find_x find_x2"),
    Way("find_residual", by=lambda q: q("find_y") - q("find_wanted")),
    Way("find_residual2", by=lambda q: q("find_y2") - q("find_wanted2")),
    Way("find_rate", RATE, of="find_x find_y"),
    Way("find_closed find_closed2", FORMULA, of="find_wanted find_wanted2"),
    Way("find_closed_off2", by=lambda q: 100 * (q("find_x2") - q("find_closed2")) / q("find_x2")),
    Way("find_closed_off", by=lambda q: 100 * (q("find_x") - q("find_closed")) / q("find_x")),
    Way("find_count find_solved find_roots.number", COUNTED),
    Way("find_roots.x find_jumps.* find_lost.*", SEARCH, of="find_low find_high find_wanted"),
    Way("find_roots.x2", PAIRS, of="find_low find_high find_wanted find_low2 find_high2 find_wanted2"),
    Way(
        "find_course.x find_course.x2",
        N_("Equal steps over the range, and the places that were looked at closer."),
    ),
    Way("find_roots.y find_roots.y2 find_course.y find_course.y2", SOLVED, of="x x2"),
    Way("find_roots.residual", N_("What the number is, less what is wanted."), of="y find_wanted"),
    Way("find_roots.residual2", N_("What the number is, less what is wanted."), of="y2 find_wanted2"),
    Way("find_roots.rate", RATE, of="x y"),
    Way("find_roots.rate_11 find_roots.rate_12 find_roots.rate_21 find_roots.rate_22", RATE, of="x x2 y y2"),
)
