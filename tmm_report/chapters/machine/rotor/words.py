"""Sentences on the kind of an unbalance and on what the bearings may feel."""

from __future__ import annotations

from tmm_report.problems import N_

KINDS = {
    "none": N_("The rotor is balanced: neither force nor moment of the unbalances is left."),
    "static": N_(
        "The unbalance is static: forces and moment are those of one vector in one plane, so that a single weight in "
        "that plane would balance the rotor."
    ),
    "couple": N_(
        "The unbalance is one of moment: the forces are balanced, the couple is not, and a single weight cannot "
        "balance it."
    ),
    "dynamic": N_(
        "The unbalance is dynamic: force and couple do not lie in one plane through the axis, and two weights in two "
        "planes are needed."
    ),
}

LIMITED = {
    "made": N_("With the weights as they are made both bearings stay within what is permitted."),
    "exact": N_(
        "With the weights as they are made a bearing carries more than is permitted: the weights must be made more "
        "finely."
    ),
    "none": N_("With one correction plane a bearing carries more than is permitted: two planes are needed."),
}
"""By what is within the limits: the weights as they are made, the exact ones, neither."""

SHARED = {
    "between": N_(
        "It is shared by the bearings as the weight of the rotor is, but each carries between 0.3 and 0.7 of it."
    ),
    "overhung": N_(
        "It is shared by the bearings by the distances of the overhanging mass centre from the other bearing, but each "
        "carries between 0.3 and 1.3 of it."
    ),
}
