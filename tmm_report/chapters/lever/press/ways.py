"""How the numbers of a press are found that no formula of the note defines."""

from tmm_report.problems import N_
from tmm_report.quantity.ways import AXIS, STATED, Way

WAYS = (
    Way("press_table.alpha press_diagram.alpha", AXIS),
    Way("press_*.s", N_("By the place of the slider, from that at the dead point."), of="alpha"),
    Way(
        "press_*.h",
        N_("The velocity of the slider by the angular velocity of the driving link."),
        of="v press_omega",
    ),
    Way("press_*.v", N_("By the motion of the mechanism at the angle before the dead point."), of="alpha s"),
    Way("press_*.F_lim", by=lambda q: q("press_torque") / q("h")),
    Way("press_*.F_nom press_torque press_rated press_within press_s_1 press_s_2", STATED),
    Way(
        "press_alpha_dead",
        N_("Where the slider stands still farthest to the stated side, over the whole cycle."),
        of="press_omega",
    ),
    Way(
        "press_stroke press_alpha_stroke",
        N_("From where the slider stands still before."),
        of="press_alpha_dead",
    ),
    Way(
        "press_h_max press_v_max press_v_min",
        N_("Where the acceleration of the slider is zero, or at an end."),
        of="press_omega",
    ),
    Way(
        "press_alpha_nom press_s_nom",
        N_("Nearest to the dead point where the arm is that of the rated force."),
        of="press_h_nom",
    ),
    Way(
        "press_before press_after",
        N_("Where the path from the dead point is the stated one."),
        of="press_within",
    ),
    Way("press_alpha_1", N_("Where the path from the dead point is the stated one."), of="press_s_1"),
    Way("press_alpha_2", N_("Where the path from the dead point is the stated one."), of="press_s_2"),
    Way("press_omega", N_("The size of the angular velocity of the driving link."), of="omega n_1"),
)
