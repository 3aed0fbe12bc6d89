"""How the numbers of an eccentric mechanism are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

CONDITION = N_("The condition of the row: its number, its limit, and margin between them.")
FAMILY = N_("Of the family of sets that solve the equation of the teeth: by the number of the set.")
SATELLITE = N_(
    "The centre lies on both distances, from the axis of the sun and of the ring; what is left "
    "over of whole pitches is the residue."
)
NEAR = N_("All sets of teeth near the wanted ratio are looked at and judged by their planet gears.")
SPEED = N_("By Willis' equation with the member of the row stopped.")
PATH = N_("The point is carried by its wheel, which rolls without slip: both angles, then the place.")
WHEEL = N_("By the module and the teeth of the wheel; the ring's tips cut down as stated in the chapter.")
PROOF = N_("The outlines of the teeth in mesh turned through a pitch; measured at each step.")
MASS = N_("The masses of the planet gears that the set holds, by their outlines, width and density.")
TEETH = N_("By the set that is taken of the family.")
RATIO = N_("By the teeth of ring and sun.")
SCALE = N_("Chosen so that the drawing fits the paper, from the usual scales.")
RULE = N_("By the rule of the course for the profile of the rack.")
REST = N_("The remainder of the division by 4.")
EUCLID = N_("By the extended algorithm of Euclid: a x + b y is the greatest common divisor.")
LOADS = N_(
    "The circumferential force that the planet gear has of the sum that the moment needs; from it the normal force, "
    "and the force on its axis."
)
STIFF = N_("The stated ratio of the stiffness of a mesh to that of the axis of a planet gear.")
AXES = N_("The forces of all the planet gears on the wheel, added as vectors.")
TURNS = N_("After as many turns of the axes both wheels have turned whole times: by their teeth.")

WAYS = (
    Way(
        "eccentric_*.condition eccentric_*.unit eccentric_*.wheels eccentric_*.satellites "
        "eccentric_*.wheel eccentric_*.stopped",
        NAME,
    ),
    Way("eccentric_near.place eccentric_path_*.position eccentric_family.t eccentric_masses.t", COUNTED),
    Way("eccentric_conditions.*", CONDITION, of="condition wheels value limit in_hand"),
    Way("eccentric_family.*", FAMILY, of="t eccentric_e eccentric_m"),
    Way("eccentric_satellites.*", SATELLITE, of="wheel z eccentric_e"),
    Way("eccentric_near.*", NEAR, of="place u eccentric_u_wanted"),
    Way("eccentric_speeds.*", SPEED, of="stopped eccentric_omega eccentric_u"),
    Way(
        "eccentric_path_*.*", PATH, of="position theta psi eccentric_path_{0}_radius eccentric_path_{0}_angle"
    ),
    Way("eccentric_wheels.*", WHEEL, of="wheel z eccentric_m"),
    Way(
        "eccentric_teeth.* eccentric_overlap eccentric_clearance",
        PROOF,
        of="wheels eccentric_checked eccentric_j_n",
    ),
    Way("eccentric_masses.*", MASS, of="t eccentric_density eccentric_b"),
    Way("eccentric_loads.*", LOADS, of="wheel gamma eccentric_F_sum eccentric_kappa"),
    Way("eccentric_R_1 eccentric_R_3", AXES, of="eccentric_F_sum eccentric_alpha"),
    Way("eccentric_kappa", STIFF, of="eccentric_F_sum"),
    Way("eccentric_z* eccentric_satellites", TEETH, of="eccentric_t eccentric_E"),
    Way(
        "eccentric_e",
        N_("By the equation of the teeth: as many halves of a module as the set has."),
        of="eccentric_E eccentric_m",
    ),
    Way("eccentric_u_teeth", RATIO, of="eccentric_z1 eccentric_z3"),
    Way("eccentric_r_1", by=lambda q: q("eccentric_m") * q("eccentric_z1") / 2),
    Way("eccentric_r_3", by=lambda q: q("eccentric_m") * q("eccentric_z3") / 2),
    Way("eccentric_in_hand_2_4", by=lambda q: q("eccentric_gap_2_4") - q("eccentric_delta")),
    Way("eccentric_cut", WHEEL, of="eccentric_alpha_a3 eccentric_m"),
    Way("eccentric_least_teeth_rounded eccentric_ring_rule", RULE, of="eccentric_ha eccentric_alpha"),
    Way("eccentric_remainder_*", REST, of="eccentric_z1 eccentric_z3 eccentric_E"),
    Way("eccentric_euclid_* eccentric_equation_k", EUCLID, of="eccentric_divisor eccentric_E"),
    Way("eccentric_near_*", NEAR, of="eccentric_u_wanted eccentric_tolerance"),
    Way("eccentric_checked", PROOF, of="eccentric_m"),
    Way("eccentric_*_enlargement eccentric_*_reduction", SCALE, of="eccentric_m eccentric_r_3"),
    Way("eccentric_path_*_turns", TURNS, of="eccentric_z1 eccentric_z3"),
    Way(
        "eccentric_t",
        N_("The set whose conditions hold, or the one that is stated."),
        of="eccentric_u_wanted eccentric_E",
    ),
    Way("eccentric_*", STATED),
)
