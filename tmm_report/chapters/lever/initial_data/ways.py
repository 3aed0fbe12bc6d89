"""How the numbers of the initial data are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import PI
from tmm_report.quantity.ways import NAME, STATED, Way

LENGTH = N_("Distance between the two points of the link, by their places in it as the variant states them.")
DRAWN = N_("The length by the scale of the scheme, to the accuracy of the drawing.")
SPEED = N_(
    "By what the variant states of the driving link: its speed, its time of a turn, or the "
    "drive that turns it."
)
LAW_TIME = N_(
    "Stated; of a harmonic its period, or so many of them as make whole turns; of a constant acceleration for which no "
    "time is stated, that of one turn."
)

STROKE_TIME = N_(
    "Stated; of a harmonic its period; of a stroke whose end is stated the time in which it comes there; of parts one "
    "after another their sum."
)

WAYS = (
    Way(
        "dimensions.key dimensions.link fixed_points.point masses.link masses.mass_centre masses.about", NAME
    ),
    Way("dimensions.length", LENGTH, of="key link"),
    Way("fixed_points.x fixed_points.y masses.m masses.q masses.J_about", STATED),
    Way("masses.J", STATED, by=lambda q: q("J_about") - q("m") * q("l_about") ** 2),
    Way("masses.l_about", LENGTH, of="about mass_centre"),
    Way("T_turn turns", STATED),
    Way("omega", SPEED, of="n_1 T_turn drive_omega_out"),
    Way("law_time", LAW_TIME, of="law_frequency law_speed law_acceleration"),
    Way(
        "law_time",
        STROKE_TIME,
        of="law_stroke law_stroke_speed law_stroke_acceleration law_part_time_1 law_stroke_steady law_run_up",
    ),
    Way("law_*", STATED),
    Way("phi_cycle", by=lambda q: 2 * PI * q("turns")),
    Way("T_cycle", by=lambda q: q("phi_cycle") / abs(q("omega"))),
    Way("drawn_*", DRAWN, by=lambda q: q("dimensions:l_{0}.length") / q("mu_l")),
    Way("drawn_*", DRAWN, of="mu_l dimensions:l_{0}.length"),
    Way(
        "mu_l", N_("Chosen so that the largest length fits the paper, from the usual scales."), of="accuracy"
    ),
)
