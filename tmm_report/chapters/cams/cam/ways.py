"""How the numbers of a cam are found that no formula of the note defines."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

LAW = N_(
    "By the law of the phase in which the cam is: S and its derivatives over the completed fraction of the phase."
)
PHASE = N_("The phases follow one another; each begins where the one before ends.")
PROFILE = N_(
    "The envelope of the roller, or of the flat face, in the axes of the cam: from the "
    "follower's place, turned back by the cam."
)
EXTREME = N_("Over the whole turn, sought between the positions of the table too; law by law.")
PARTS = N_(
    "By the law of the phase and, for the profile, by the envelope of the follower's end; at the ends of a phase "
    "as the phase has them."
)
WALLS = N_(
    "From the point of contact along the common normal: by the roller's diameter to the outer wall, by the radius of "
    "the cutter to the path of its centre."
)
REVERSED = N_(
    "The profile is turned back and the follower let down on it: where it rests is compared with its law, position by "
    "position."
)
GRAPH = N_(
    "The stated graph of acceleration: widths made shares of the phase, ordinates below zero scaled to equal "
    "areas, all ordinates to the lift, then integrated twice, piece by piece."
)
ASKED = N_(
    "Where the law requires the largest size: sought over it, piece by piece; of a roller by the permitted "
    "pressure angles, under a flat face where s + s'' is least."
)
BASE = N_("Stated; or the smallest that the law asks for, rounded up to the stated step.")
REACH = N_(
    "The contact is as far along a flat face as the first derivative of the displacement: its greatest size."
)
SIZED = N_("Stated, or of what is stated: the circles of base and nose and the flanks touch one another.")
MEETS = N_(
    "On each piece of the profile the follower stands where a circle, or a line, turned by the cam holds it; the "
    "condition of contact differentiated twice."
)
CHANGES = N_("By the piece of the profile that ends or begins there, flank, nose or base circle.")
ZONE = N_(
    "In the zone where the axis of the cam may stand, bounded by two straight lines for each position of the "
    "follower: its place nearest to the lowest centre of the roller, or to the pivot."
)
HOLDS = N_("The two positions of the follower whose lines hold the axis there, sought over the law.")
AWAY = N_("As the variant states the face: its distance from the pivot.")
ROLLER = N_("Stated; or chosen: the greatest that the rules allow, rounded down to a whole millimetre.")
LESSER = N_("The least of them.")
JUMP = N_("Where two phases meet: the difference of the derivatives on both sides.")
APART = N_("By the places of both pivots that the variant states.")
LIFT = N_("The greatest displacement of the law less the least.")


def _ways(own: str, same: str) -> tuple[Way, ...]:
    """`own`: what follows the names of one pair, in what is looked for; `same`: in what that is made of."""
    listed = (
        Way("cam_*.phase cam_*.law cam_*.shock", NAME),
        Way("cam_phases@.number", COUNTED),
        Way("cam_phases@.*", PHASE, of="phase law start angle"),
        Way("cam_law@.ratio", STATED),
        Way("cam_law@.*", LAW, of="phase law theta delta tau"),
        Way("cam_pieces@.number", COUNTED),
        Way("cam_pieces@.form", NAME),
        Way("cam_pieces@.*", GRAPH, of="number form"),
        Way("cam_least@.phase", NAME),
        Way("cam_least@.*", ASKED, of="phase"),
        Way("cam_changes@.place", NAME),
        Way("cam_changes@.*", CHANGES, of="place"),
        Way("cam_nose@ cam_flank@ cam_distance@ cam_half_angle@", SIZED, of="cam_base@"),
        Way(
            "cam_flank_angle@ cam_nose_angle@ cam_S_change@ cam_S1_change@ cam_S2_start@ cam_S2_flank@",
            MEETS,
            of="cam_base@ cam_nose@ cam_half_angle@",
        ),
        Way("cam_S2_nose@ cam_S2_apex@", MEETS, of="cam_base@ cam_nose@ cam_half_angle@"),
        Way("cam_zone@.phase", NAME),
        Way("cam_zone@.*", HOLDS, of="phase"),
        Way(
            "cam_apart_best@ cam_start_least_best@ cam_apart_least@",
            ZONE,
            of="cam_arm@ cam_alpha_limit@ cam_alpha_back@",
        ),
        Way("cam_away@", AWAY, of="cam_apart@"),
        Way(
            "cam_roller_most@",
            LESSER,
            of="cam_roller_by_radius@ cam_roller_by_curvature@ cam_roller_by_hollow@",
        ),
        Way("cam_shaft@", STATED),
        Way("cam_roller@", ROLLER, of="cam_roller_most@"),
        Way("cam_shocks@.*", JUMP, of="phi shock"),
        Way("cam_motion@_table.*", LAW, of="phi cam_S@ cam_lift@"),
        Way("cam_divisions@_*.part", COUNTED),
        Way("cam_divisions@_*.*", PARTS, of="part phi cam_lift@ cam_base@"),
        Way("cam_walls@.*", WALLS, of="phi cam_roller@ cam_cutter@"),
        Way("cam_outline@.*", WALLS, of="phi cam_roller@ cam_cutter@"),
        Way("cam_recovered@ cam_recovered_rounded@", REVERSED, of="cam_base@ cam_lift@"),
        Way("cam_cutter@", STATED),
        Way("cam_profile@.*", PROFILE, of="phi cam_base@ cam_roller@"),
        Way("cam_alpha_rise@ cam_alpha_return@ cam_rho@", EXTREME, of="cam_base@ cam_lift@ cam_apart@"),
        Way("cam_r0_least@", EXTREME, of="cam_lift@ cam_alpha_limit@ cam_arm@"),
        Way("cam_lift@", LIFT, enough=True),
        Way("cam_apart@", APART, of="cam_base@ cam_arm@"),
        Way("cam_base@", BASE, of="cam_r0_least@"),
        Way("cam_base@", STATED),
        Way("cam_reach@", REACH, of="cam_lift@"),
        Way("cam_alpha_limit@ cam_alpha_back@ cam_curvature@ cam_arm@ cam_offset@", STATED),
        Way("cam_*", EXTREME, of="cam_base* cam_lift*"),
    )
    return tuple(
        replace(way, keys=way.keys.replace("@", own), of=way.of.replace("@", same)) for way in listed
    )


WAYS = _ways("", "")
PAIRS = _ways("_*", "_{0}")
"""Those of the cam pairs of a lever mechanism, by the names of the pairs."""
