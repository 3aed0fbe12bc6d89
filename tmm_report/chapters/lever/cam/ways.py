"""How the numbers of a cam are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

LAW = N_(
    "By the law of the phase in which the cam is: S and its derivatives over the share of the "
    "phase that is over."
)
PHASE = N_("The phases follow one another; each begins where the one before ends.")
PROFILE = N_(
    "The envelope of the roller, or of the flat face, in the axes of the cam: from the "
    "follower's place, turned back by the cam."
)
EXTREME = N_("Over the whole turn, sought between the positions of the table too; law by law.")
GRAPH = N_(
    "The stated graph of acceleration: widths made shares of the phase, ordinates below zero scaled to equal "
    "areas, all ordinates to the lift, then integrated twice, piece by piece."
)
ASKED = N_(
    "Where the law asks most of the size: sought over it, piece by piece; of a roller by the permitted pressure "
    "angles, under a flat face where s + s'' is least."
)
BASE = N_("Stated; or the smallest that the law asks for, rounded up to the stated step.")
REACH = N_(
    "The contact is as far along a flat face as the first derivative of the displacement: its greatest size."
)
JUMP = N_("Where two phases meet: the difference of the derivatives on both sides.")
APART = N_("By the places of both pivots that the variant states.")
LIFT = N_("The greatest displacement of the law less the least.")

WAYS = (
    Way("cam_*.phase cam_*.law cam_*.shock", NAME),
    Way("cam_phases_*.number", COUNTED),
    Way("cam_phases_*.*", PHASE, of="phase law start angle"),
    Way("cam_law_*.ratio", STATED),
    Way("cam_law_*.*", LAW, of="phase law theta delta tau"),
    Way("cam_pieces_*.number", COUNTED),
    Way("cam_pieces_*.form", NAME),
    Way("cam_pieces_*.*", GRAPH, of="number form"),
    Way("cam_least_*.phase", NAME),
    Way("cam_least_*.*", ASKED, of="phase"),
    Way("cam_shocks_*.*", JUMP, of="phi shock"),
    Way("cam_motion_*_table.*", LAW, of="phi cam_S_* cam_lift_{0}"),
    Way("cam_profile_*.*", PROFILE, of="phi cam_base_{0} cam_roller_{0}"),
    Way(
        "cam_alpha_rise_* cam_alpha_return_* cam_rho_*", EXTREME, of="cam_base_{0} cam_lift_{0} cam_apart_{0}"
    ),
    Way("cam_lift_*", LIFT, of="cam_base_{0}"),
    Way("cam_apart_*", APART, of="cam_base_{0} cam_arm_{0}"),
    Way("cam_base_*", BASE, of="cam_r0_least_{0}"),
    Way("cam_reach_*", REACH, of="cam_lift_{0}"),
    Way(
        "cam_alpha_limit_* cam_alpha_back_* cam_curvature_* cam_arm_* cam_roller_* cam_offset_*",
        STATED,
    ),
    Way("cam_*", EXTREME, of="cam_base_* cam_lift_*"),
)
