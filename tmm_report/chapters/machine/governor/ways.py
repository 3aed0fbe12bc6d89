"""How the numbers of a governor are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import AXIS, COUNTED, NAME, STATED, Known, Way

LIFT = N_(
    "By the geometry of the arms at the lift of the row; its derivatives with respect to the lift in closed form."
)
EQUILIBRIUM = N_("Equilibrium of the sleeve: the supporting force by the inertial coefficient, ω² = E/A.")
RESPONSE = N_(
    "The equations of motion of the machine, the sleeve and the servomotor after the step, "
    "integrated step by step; those of small motions in closed form beside."
)
MATRIX = N_("The equations of motion, linear about the steady state after the step.")
ROOTS = N_("Eigenvalues of the matrix of small motions.")
HURWITZ = N_("From the coefficients of the characteristic equation of the matrix of small motions.")
STEADY = N_("The speed at which the supply that the governor gives balances the load.")
BOUNDARY = N_(
    "Where a pair of eigenvalues crosses the imaginary axis: the last but one of Hurwitz's "
    "determinants is zero."
)
BRAKE = N_("The shoes press by the centrifugal force less the springs'; the start is integrated from rest.")
PEAK = N_("Sought in the response between its samples, too.")
LIMIT = N_("The least of all lifts at which the factor of stability is zero.")
AFTER = N_("At the steady state after the step.")
START = N_("By the geometry of the arms at the lower stop.")
SPRING = N_("The force at the lower stop and the stiffness times the lift.")
STOPS = N_("The lift between the stops: stated, or by the geometry of the arms at both.")
MIDLIFT = N_("Stated, or the middle of the lift.")
MACHINE = N_("Stated, or that of the driving link, or the mean of the governor by the ratio.")
MIDDLE = N_("The speed of the governor's shaft at the mean of the machine's.")


def _top(q: Known) -> Expr:
    return q("governor_F_0") + q("governor_c") * q("governor_h")


WAYS = (
    Way("governor_*.state", NAME),
    Way("governor_eigenvalues.number governor_hurwitz.k governor_equilibrium.point", COUNTED),
    Way(
        "governor_response.t governor_brake_start.t governor_brake.omega governor_boundary.nu "
        "governor_equilibrium.z governor_curve.z",
        AXIS,
    ),
    Way("governor_response.*", RESPONSE, of="t omega z s"),
    Way("governor_matrix.*", MATRIX, of="state phi eta vartheta"),
    Way("governor_eigenvalues.*", ROOTS, of="number real imaginary"),
    Way("governor_hurwitz.*", HURWITZ, of="k a Delta"),
    Way("governor_boundary.*", BOUNDARY, of="nu beta T_i"),
    Way("governor_steady.*", STEADY, of="state omega s z M_d M_c"),
    Way("governor_curve.*", EQUILIBRIUM, of="z r C omega_g"),
    Way("governor_equilibrium.*", LIFT, of="point z x r A E"),
    Way("governor_brake_start.* governor_brake.*", BRAKE, of="t omega governor_brake_K"),
    Way("governor_brake_settled", BRAKE, of="governor_brake_held governor_brake_J governor_brake_M"),
    Way("governor_after_*", AFTER, of="governor_load_after governor_M_mean governor_J"),
    Way(
        "governor_omega_h governor_omega_0 governor_omega_m",
        EQUILIBRIUM,
        of="governor_h governor_m governor_delta",
    ),
    Way("governor_omega_mean", MACHINE, of="governor_i governor_omega_m omega"),
    Way(
        "governor_peak governor_peak_time governor_settled governor_final",
        PEAK,
        of="governor_load_after governor_after_omega governor_slowest",
    ),
    Way("governor_static", STEADY, of="governor_after_omega governor_load_after"),
    Way("governor_slowest", ROOTS, of="governor_after_S governor_k"),
    Way("governor_stiffness_needed governor_preload_allowed", LIMIT, of="governor_h governor_c governor_F_0"),
    Way("governor_spring_top", by=_top),
    Way("governor_p", HURWITZ, of="governor_X governor_Y"),
    Way("governor_x_0 governor_r_min", START, of="governor_l_1 governor_l_2 governor_a"),
    Way("governor_omega_m", MIDDLE, of="governor_i"),
    Way(
        "governor_beta_min governor_beta_max governor_k_min",
        HURWITZ,
        of="governor_after_S governor_T_s governor_k governor_R",
    ),
    Way("governor_h", STOPS, of="governor_l_1 governor_a governor_x_0 governor_r_min"),
    Way("governor_z_m", MIDLIFT, of="governor_h"),
    Way("governor_*", STATED),
)
