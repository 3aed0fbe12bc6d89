"""How the numbers of a synthesis are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import NAME, STATED, Way

FREE = N_(
    "Free: chosen for the least pressure angle or the best transmission angle, by a grid over the family and ever "
    "finer ones; or the root at which the stated demand is met."
)
FAMILY = N_("The closed formulas of the chapter, at a value of what is free.")
PAIRS = N_("Stated; the points of accuracy by Chebyshev's spacing, the angles linear in x and in y.")
LINEAR = N_("The three linear equations that Freudenstein's equation gives at the three pairs of angles.")
GREATEST = N_("The greatest over the range, by a grid and ever finer ones.")
LEAST = N_("The least over the range, by a grid and ever finer ones.")
TRACED = N_("The place of the point of the coupler, by the positions of the four-bar linkage.")
CIRCLE = N_("The circle through the three places of the point.")
MET = N_("Of the analysed mechanism: between its exact extreme positions.")
ROUNDED = N_("The length as it is found; rounded to the stated step.")
PLACED = N_("By the distances along and across the middle position of the rocker, and its direction.")

WAYS = (
    Way("synthesis_lengths.key", NAME),
    Way("synthesis_lengths.found synthesis_lengths.taken", ROUNDED),
    Way("synthesis_pairs.x synthesis_pairs.y synthesis_pairs.phi synthesis_pairs.psi", PAIRS),
    Way("synthesis_arc.phi", STATED),
    Way("synthesis_arc.x_P synthesis_arc.y_P synthesis_arc.x synthesis_arc.y", TRACED),
    Way("synthesis_family.*", FAMILY),
    Way("synthesis_course.*", FAMILY),
    Way("synthesis_rod synthesis_rocker", STATED),
    Way("synthesis_k1 synthesis_k2 synthesis_k3", LINEAR),
    Way("synthesis_error", GREATEST),
    Way("synthesis_transmission", LEAST),
    Way("synthesis_centre_x synthesis_centre_y synthesis_radius synthesis_guide_angle", CIRCLE),
    Way("synthesis_stroke_met synthesis_swing_met synthesis_K_met", MET),
    Way("synthesis_frame_x synthesis_frame_y", PLACED),
    Way("synthesis_crank synthesis_ratio synthesis_frame", FREE),
    Way("synthesis_*", STATED),
)
