"""How the numbers of a cam's forces are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

LAW = N_("By the law of the phase in which the cam is, at the angle that is asked.")
LOADED = N_("The load by its stated law at the angle, or at the part of the lift.")
WEIGHT = N_("The weight of the follower; of one that swings by its arm about the pivot.")
SPRUNG = N_("The preload and the rate of the spring times the displacement.")
HEAVY = N_("The mass, or the moment of inertia, times the acceleration of the follower.")
NEEDS = N_("The sum of load, weight, spring and inertia.")
NORMAL = N_(
    "From the equilibrium of the follower along its lift, or about its pivot: what the cam does along the common "
    "normal, less what friction takes."
)
SMOOTH = N_("What the follower needs times the first derivative of its displacement: the powers are alike.")
RUBBED = N_("The power of this friction, force by velocity, over the angular velocity of the cam.")
TORQUE = N_("The moment of the cam's force on the follower about the axis of the cam.")
HERTZ = N_(
    "By Hertz's formula for two cylinders: the normal force, the width, both radii of curvature, both materials."
)
EXTREME = N_("Over the turn, between all its kinks: at their ends and where the curve stands still.")
ENDS = N_("Over the phase, between all its kinks: at their ends and where the curve stands still.")
HELD = N_(
    "The line of the spring over the displacement lies nowhere below what the inertia requires less load and "
    "weight, and touches it: a linear programme of two unknowns."
)
OFF = N_(
    "The least over the turn of the root of what holds the follower by its mass and its acceleration for ω = 1."
)
LEAVES = N_("Where the force of the cam along the lift passes through zero.")
MEAN = N_("The integral of the moment of the drive over the turn.")
JAM = N_("tan α = c/(f(c + 2b)) by the length and the overhang of the guide.")

WAYS = (
    Way("cam_asked.state cam_force_ends.phase cam_springs.kind", NAME),
    Way("cam_force_ends.number", COUNTED),
    Way("cam_mass cam_reserve cam_guide cam_overhang cam_guide_f cam_sigma_perm cam_asked.phi", STATED),
    Way("cam_asked.cam_S cam_asked.cam_v cam_asked.cam_a cam_asked.cam_w cam_asked.cam_e", LAW, of="phi"),
    Way("cam_forces_*.cam_load cam_asked.cam_load", LOADED, of="phi"),
    Way("cam_forces_*.cam_weight cam_asked.cam_weight", WEIGHT, of="cam_mass"),
    Way("cam_forces_*.cam_spring cam_asked.cam_spring", SPRUNG, of="cam_F0 cam_c"),
    Way("cam_forces_*.cam_inertia cam_asked.cam_inertia", HEAVY, of="cam_mass"),
    Way(
        "cam_forces_*.cam_needed cam_asked.cam_needed", NEEDS, of="cam_load cam_weight cam_spring cam_inertia"
    ),
    Way("cam_forces_*.cam_N cam_asked.cam_N", NORMAL, of="cam_needed"),
    Way("cam_forces_*.cam_T0 cam_asked.cam_T0", SMOOTH, of="cam_needed"),
    Way("cam_forces_*.cam_T_* cam_asked.cam_T_*", RUBBED, of="cam_N"),
    Way("cam_forces_*.cam_T cam_asked.cam_T", TORQUE, of="cam_N cam_T0"),
    Way("cam_forces_*.cam_sigma cam_asked.cam_sigma", HERTZ, of="cam_N"),
    Way("cam_force_ends.*", ENDS, of="number phase"),
    Way("cam_springs.*", HELD, of="kind cam_reserve"),
    Way("cam_leaves.*", LEAVES, of="cam_needed_min"),
    Way("cam_F0 cam_c", HELD, of="cam_reserve cam_mass"),
    Way("cam_F0_needed", HELD, of="cam_c cam_mass"),
    Way("cam_omega_off cam_n_off", OFF, of="cam_F0 cam_c cam_mass"),
    Way("cam_alpha_jam", JAM, of="cam_guide cam_overhang cam_guide_f"),
    Way("cam_T_mean cam_work cam_work_fr", MEAN, of="cam_T_max cam_T_min"),
    Way("cam_disagreement", TORQUE, of="cam_T_max"),
    Way("cam_*", EXTREME, of="cam_mass"),
)
