"""What the dimensions of a toothed wheel are called: the rows of the note's tables and of the results."""

from __future__ import annotations

from tmm_report.problems import N_

DIAMETERS = {
    "d": N_("pitch diameter"),
    "d_b": N_("base diameter"),
    "d_w": N_("working diameter"),
    "d_f": N_("root diameter"),
    "d_a": N_("tip diameter"),
}
TEETH = {
    "height": N_("height of the teeth"),
    "s": N_("thickness on the pitch circle"),
    "s_b": N_("thickness on the base circle"),
    "s_w": N_("thickness on the working circle"),
    "s_a": N_("thickness on the tip circle"),
}
