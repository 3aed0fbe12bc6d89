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
WAYS = (
    Way("find_low find_high find_wanted", STATED),
    Way("find_x", SEARCH, of="find_low find_high find_wanted"),
    Way("find_y", SOLVED, of="find_x"),
    Way("find_residual", by=lambda q: q("find_y") - q("find_wanted")),
    Way("find_rate", RATE, of="find_x find_y"),
    Way("find_count find_solved find_roots.number", COUNTED),
    Way("find_roots.x find_jumps.* find_lost.*", SEARCH, of="find_low find_high find_wanted"),
    Way("find_course.x", N_("Equal steps over the range, and the places that were looked at closer.")),
    Way("find_roots.y find_course.y", SOLVED, of="x"),
    Way("find_roots.residual", N_("What the number is, less what is wanted."), of="y find_wanted"),
    Way("find_roots.rate", RATE, of="x y"),
)
