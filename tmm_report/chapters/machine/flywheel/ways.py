"""How the numbers of the flywheel are found that no formula of the note defines."""

from __future__ import annotations

from typing import cast

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import NAME, STATED, Known, Way

SIDE = N_(
    "The moments reduced to the main link: the side that the loads give, and the other that closes the cycle."
)
WORK = N_(
    "The integral of the excess moment by the angle, exact on smooth pieces between the jumps of the moments."
)
VARYING = N_("The reduced moment of inertia of the links less its constant parts.")
MOTION = N_(
    "By the energy at the angle with the flywheel: J ω²/2 at the beginning and the work of the excess moment."
)
BEFORE = N_("By the energy at the angle without the flywheel, at the same mean speed.")
MEAN = N_("The mean over the cycle: the integral over the angle, divided by the angle of the cycle.")
EXTREME = N_("Over the whole cycle, between the positions of the table too.")
METHOD = N_(
    "What the method of the row takes for the positions of the greatest and the least speed, by its own rule."
)
PROOF = N_(
    "The motion with this flywheel: by the energy integral, and by integration of the equation "
    "of motion step by step; the "
    "two are independent."
)
SIZES = N_(
    "By the moment of inertia on the flywheel's shaft and the stated shape; stated proportions "
    "are taken as they are."
)
SPEED = N_("The greatest angular velocity of the main link times the ratio of the speeds.")
USUAL = N_("From the table of usual coefficients for machines of the kind.")
CLOSES = N_(
    "The mean excess moment by the mean driving moment: what is left is rounding, or the "
    "machine does not repeat."
)
KIND = N_("Stated, or chosen among what is usual for machines of the kind.")
MATERIAL = N_("Of the stated material: from the table, or as the variant states it.")
LINKS = N_("Of the links that only turn or only slide with a constant ratio, J (ω/ω₁)² + m (v/ω₁)² summed.")

RUBBING = N_(
    "The power of friction of all the pairs at the angle by the angular velocity of the driving link, against the "
    "rotation."
)
RUBBED = N_("The mean of the moment of friction over the cycle by the speed of the driving link.")
SHARE = N_("The ratio of the mean power of friction to that of all that drives.")
NEEDED = N_("The mean power of the cycle, over the efficiency of the gear of the motor.")


def _excess(q: Known) -> Expr:
    return q("M_dr") + q("M_res")


def _rubbed(q: Known) -> Expr:
    return q("P_fr_corrected_mean" if q.has("P_fr_corrected_mean") else "P_fr_mean")


def _assigned(q: Known) -> Expr:
    """By its formula, which the note does not print."""
    return cast(Expr, q.found.s.formula(q.own.removeprefix("flywheel_")).expression)


WAYS = (
    Way("flywheel_methods.method flywheel_proof.way", NAME),
    Way("flywheel_table.M_ex", SIDE, by=_excess, of="phi"),
    Way("flywheel_table.M_dr flywheel_table.M_res", SIDE, of="phi flywheel_M_m"),
    Way("flywheel_table.M_fr", RUBBING, of="friction_table.P_fr friction_table.T_fr phi omega flywheel_P_fr"),
    Way("flywheel_table.A", WORK, of="phi M_ex"),
    Way("flywheel_table.J_II", VARYING, of="reduced_inertia_table.I_red flywheel_J_c phi"),
    Way("flywheel_table.T_II", by=lambda q: q("J_II") * q("flywheel_omega_m") ** 2 / 2),
    Way("flywheel_table.dT_I", by=lambda q: q("A") - q("T_II")),
    Way("flywheel_table.domega", by=lambda q: q("omega") - q("flywheel_omega_m")),
    Way("flywheel_table.omega", MOTION, of="A J_II flywheel_J_fl flywheel_omega_m"),
    Way("flywheel_table.omega_0", BEFORE, of="A J_II flywheel_omega_m"),
    Way("flywheel_table.epsilon", N_("(M_ex − J′ω²/2)/J at the angle."), of="M_ex omega J_II flywheel_J_fl"),
    Way(
        "flywheel_methods.deviation",
        N_("The difference from the exact row, in per cent of it."),
        of="method J_fl",
    ),
    Way("flywheel_methods.*", METHOD, of="method J_fl"),
    Way("flywheel_proof.delta", by=lambda q: (q("omega_max") - q("omega_min")) / q("flywheel_omega_m")),
    Way("flywheel_proof.*", PROOF, of="way"),
    Way(
        "flywheel_C_E flywheel_J_own flywheel_J_shaft flywheel_sigma flywheel_D_lim flywheel_omega_min flywheel_psi_2",
        by=_assigned,
    ),
    Way("flywheel_W", WORK, of="flywheel_M_m flywheel_Phi"),
    Way("flywheel_left", CLOSES, of="flywheel_M_m"),
    Way("flywheel_J_mean", MEAN, of="flywheel_Phi"),
    Way(
        "flywheel_J_fl",
        N_("The constant moment of inertia that is needed less the machine's own."),
        of="flywheel_J_own flywheel_delta flywheel_A_ex",
    ),
    Way("flywheel_J_own", by=lambda q: q("flywheel_J_0") + q("flywheel_J_c")),
    Way("flywheel_J_c", LINKS, of="omega"),
    Way("flywheel_delta_fine flywheel_delta_coarse", USUAL, enough=True),
    Way("flywheel_delta_0", BEFORE, of="flywheel_J_own flywheel_omega_m"),
    Way("flywheel_delta_run flywheel_closure", PROOF, of="flywheel_J_fl flywheel_omega_m"),
    Way("flywheel_A_max flywheel_A_min flywheel_eps_max flywheel_eps_min", EXTREME, of="flywheel_Phi"),
    Way(
        "flywheel_mu_J flywheel_mu_T",
        N_("Chosen so that the diagram fits the paper, from the usual scales."),
        of="flywheel_J_mean flywheel_A_ex",
    ),
    Way("flywheel_omega_s", SPEED, of="flywheel_omega_max flywheel_i"),
    Way("flywheel_k_h", by=lambda q: q("flywheel_h") / q("flywheel_D")),
    Way(
        "flywheel_k_b flywheel_k_s flywheel_k_h flywheel_D_out", SIZES, of="flywheel_D flywheel_b flywheel_h"
    ),
    Way(
        "flywheel_omega_m",
        N_("The stated speed of the main link, of a mechanism that of its driving link."),
        of="omega n_1 flywheel_n",
    ),
    Way(
        "flywheel_Phi",
        N_("The angle after which the machine repeats: its turns by 2π."),
        of="turns flywheel_omega_m",
    ),
    Way("flywheel_delta", KIND, of="flywheel_delta_fine flywheel_delta_coarse"),
    Way("flywheel_rho flywheel_v_lim flywheel_sigma_lim", MATERIAL, of="flywheel_sigma flywheel_D"),
    Way("flywheel_P_fr", RUBBED, by=_rubbed, of="omega"),
    Way("flywheel_P_fr_share", SHARE, of="flywheel_P_fr flywheel_P_m"),
    Way("flywheel_P_need", NEEDED, of="flywheel_P_m flywheel_eta_motor flywheel_P_fr"),
    Way("flywheel_*", STATED),
)
