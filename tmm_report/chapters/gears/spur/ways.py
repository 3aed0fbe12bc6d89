"""How the numbers of a gear pair are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import NAME, Way

CONDITION = N_("The condition of the row: the number of the pair, its limit, and margin between them.")
SLIDING = N_(
    "At the point of the line of action: ρ from the points where it touches the base circles, λ "
    "by the ratio of both."
)
CONTOUR = N_(
    "Sought along the limits of the blocking contour: the nearest shifts to the chosen that meet every limit."
)
LACK = N_("What the limit allows less what the shifts give.")
DRAWN = N_("Read off the drawing of the mesh at its scale, to its accuracy.")
DIFFER = N_("The difference of both by the calculated one, in per cent.")
PROOF = N_(
    "The outlines of the teeth are made as the rack cuts them, set in mesh and turned through a "
    "pitch; measured at each step."
)
RULE = N_("By the rule of the course for a rack of this profile: 2h_a*/sin²α.")
RATIO = N_("The stated ratio; the larger number of teeth by the smaller is 1 or more.")
SCALE = N_("Chosen so that the drawing fits the paper, from the usual scales.")
SPEED = N_("By the speed of the wheel that is stated, and by the ratio.")
LIMIT = N_("From the table of allowed specific sliding over the pitch-line velocity.")
PATH = N_("Between the pitch point and the farther end of the active part.")
INVOLUTE = N_("By the involute function, inv α = tan α − α, and the angle by its inverse.")
OF_AXES = N_("Stated, or by the angle of engagement that the shifts give.")
WHEEL = N_("By the module, the teeth and the shift of the wheel, as the rack cuts it.")
BASE_HELIX = N_("sin β_b = sin β cos α: the involutes of helical teeth wind up their base cylinder at it.")
SPAN_RULE = N_(
    "By the rule of GOST 16532 the span would touch the tooth half way up; the nearest whole number of teeth with "
    "which it touches the active profiles is taken."
)
SPAN = N_(
    "Base pitches between the teeth that are held, and the thickness of a tooth on the base circle, across the teeth; "
    "it touches the flanks in the middle of its length."
)
CONSTANT = N_("Where the rack touches a tooth in the middle of its space: by the shift of the wheel.")
CHORD = N_("By the angle of the tooth on the circle; of helical teeth in the normal section.")
PINS = N_(
    "The involute that is offset by the radius of the pin goes through its centre; with an odd number of teeth two "
    "pins are half a pitch off the diameter."
)
PHASE = N_(
    "The points of contact in the drawn phase of the mesh, along the line of action from the pitch point."
)
VELOCITY = N_(
    "ω of the wheel by the distance of the point; across the line of action by its radius of curvature."
)

THINNED = N_(
    "Measured as without thinning, with teeth so much thinner: span and pins by their thickness, chords where a "
    "caliper set to the nominal height stands."
)
LOOSE = N_(
    "The outlines stand at the centre distance of the shifts, thinned teeth leave what they lose, as arcs of the "
    "working pitch circles."
)
DIVIDED = N_(
    "The shifts are divided otherwise at the same centre distance, or chosen anew at another, and each pair is found "
    "for itself: λ by the ratio of the velocities along the profiles, γ by the radii of both."
)
BOUND = N_(
    "Sought where the limit of the row is just kept, the sum of the shifts being the same; the bounds together are the "
    "nearest of them."
)
EQUAL = N_("Sought: the shift at which the specific sliding at both roots is the same, the sum kept.")

WAYS = (
    Way("stage*_*.wheel stage*_*.condition stage*_*.unit stage*_*.point stage*_*.key", NAME),
    Way("stage*_lacks.limit", NAME),
    Way("stage*_lacks.*", LACK, of="limit value bound"),
    Way(
        "stage*_conditions.margin stage*_conditions.met stage*_conditions.value stage*_conditions.limit",
        CONDITION,
        of="condition wheel value limit margin",
    ),
    Way("stage*_sliding.* stage*_points.*", SLIDING, of="point s stage{0}_line stage{0}_active"),
    Way("stage*_velocities.*", VELOCITY, of="point stage{0}_v_pitch"),
    Way("stage*_phase.*", PHASE, of="point stage{0}_line"),
    Way("stage*_contour.*", CONTOUR, of="point stage{0}_x_sum"),
    Way("stage*_readings.graph", DRAWN, of="key wheel stage{0}_scale stage{0}_accuracy"),
    Way("stage*_readings.analytic", WHEEL, of="key wheel graph"),
    Way("stage*_readings.delta", DIFFER, of="key graph analytic"),
    Way(
        "stage*_inspection.alpha_m stage*_inspection.span_rule stage*_inspection.span_teeth",
        SPAN_RULE,
        of="wheel span_rule alpha_m",
    ),
    Way(
        "stage*_inspection.W stage*_inspection.rho_W", SPAN, of="wheel span_teeth stage{0}_m stage{0}_beta_b"
    ),
    Way("stage*_inspection.s_c stage*_inspection.h_c", CONSTANT, of="wheel stage{0}_m stage{0}_alpha"),
    Way(
        "stage*_inspection.pin stage*_inspection.*alpha_D stage*_inspection.d_D stage*_inspection.d_k "
        "stage*_inspection.M",
        PINS,
        of="wheel pin stage{0}_m",
    ),
    Way("stage*_inspection.*", CHORD, of="wheel d_y stage{0}_m"),
    Way("stage*_limits.size", NAME),
    Way("stage*_limits.*", THINNED, of="wheel size stage{0}_thin_1 stage{0}_m"),
    Way("stage*_j_w_least stage*_j_w_most", LOOSE, of="stage{0}_a_w stage{0}_x_sum stage{0}_axes"),
    Way("stage*_bounds.limit stage*_bounds.side", NAME),
    Way("stage*_bounds.x_*", BOUND, of="limit wheel side stage{0}_x_sum"),
    Way(
        "stage*_x_least_* stage*_x_most_* stage*_eps_least stage*_eps_most stage*_play",
        BOUND,
        of="stage{0}_x_sum",
    ),
    Way("stage*_x_equal_* stage*_lambda_equal", EQUAL, of="stage{0}_x_sum"),
    Way(
        "stage*_quality.* stage*_quality_curves.* stage*_distances.* stage*_distance_curves.*",
        DIVIDED,
        of="x_1 a_w stage{0}_m stage{0}_x_sum",
    ),
    Way("stage*_cutter.*", WHEEL, of="wheel stage{0}_m"),
    Way("stage*_wheels.*", WHEEL, of="wheel z x stage{0}_m"),
    Way("stage*_overlap stage*_clearance stage*_eps_counted", PROOF, of="stage{0}_eps stage{0}_backlash"),
    Way("stage*_beta_b", BASE_HELIX, of="stage{0}_beta stage{0}_alpha"),
    Way("stage*_z_rule", RULE, of="stage{0}_ha stage{0}_alpha"),
    Way("stage*_u", RATIO, of="stage{0}_u_required"),
    Way(
        "stage*_mu_sliding stage*_scale stage*_reduction stage*_mu_l",
        SCALE,
        of="stage{0}_m stage{0}_accuracy",
    ),
    Way("stage*_omega_*", SPEED, of="stage{0}_ratio drive_u"),
    Way("stage*_sliding_limit", LIMIT, of="stage{0}_v_pitch"),
    Way("stage*_v_way", PATH, of="stage{0}_active stage{0}_line"),
    Way("stage*_inv_alpha stage*_inv_alpha_w", INVOLUTE, of="stage{0}_alpha stage{0}_x_sum"),
    Way("stage*_alpha_w", INVOLUTE, of="stage{0}_inv_alpha_w stage{0}_alpha"),
    Way(
        "stage*_a_w stage*_backlash stage*_backlash_n",
        OF_AXES,
        of="stage{0}_alpha_w stage{0}_x_sum stage{0}_m",
    ),
)
