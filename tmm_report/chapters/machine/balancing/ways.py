"""How the numbers of the balancing are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

SHAKE = N_(
    "The sum of the inertia forces of all links; its moment that of these forces and of the "
    "inertia couples about the pivot of the driving link."
)
BALANCED = N_("The same sum with the counterweights of the way of balancing on their links.")
CASE = N_(
    "Of the shaking with the counterweights of the row, over the cycle: greatest between the "
    "positions too; the root of the mean square."
)
SEEN = N_(
    "The path of the force's end in the axes of the driving link is enclosed by the smallest "
    "circle: its centre is what a counterweight takes away."
)
SEEN_MEAN = N_("The force in the axes of the driving link, its mean over the cycle.")
CHECK = N_(
    "The sum of the inertia forces beside the forces of the frame on the links less the weights "
    "and loads, greatest difference."
)
TAIL = N_("The harmonics beyond those that the samples of the cycle can tell, by the largest.")
WEIGHT = N_("By the masses that the counterweight meets, with their arms; opposite to their static moment.")
MEETS = N_("The arm of the mass in the axes of the link: of a joint or of the mass centre, from the pivot.")
SPLIT = N_(
    "The mass centre by the joints; two masses keep mass and mass centre, a third the moment of inertia, too."
)
HARMONIC = N_(
    "By Fourier's sums of equal steps of the cycle, as vectors that turn with the driving link "
    "and against it."
)
ROTOR = N_(
    "Half the amplitude of the harmonic by the square of its speed: two rotors turn against one another."
)
SERIES = N_(
    "The harmonic of the slider's exact acceleration by Fourier's sums; beside it the first "
    "terms of the series in λ."
)
LEFT = N_("The inertia force of what reciprocates less what the rotors of the orders take.")
GREATEST = N_("The greatest over the cycle of the force in the table.")
MASS = N_("The mass of the slider with what is attached to it, and the part of the rod that goes with it.")
GIVEN = N_("The radius at which the rotors are stated to be, or the mass by that radius.")

MOMENT_LEFT = N_("The ratio of the greatest shaking moment to that of row 0.")
WHEELS = N_(
    "The moments of inertia, none negative, that leave the least mean square of the shaking moment over the cycle."
)
ANTIPHASE = N_(
    "Against the harmonic of the order of the shaking moment that is left: both weights with their arm give it with "
    "the other sign."
)
MOMENT_HARMONIC = N_("By Fourier's sums of the shaking moment over equal steps of the cycle.")

WAYS = (
    Way("*.method *.link *.point *.first *.second", NAME),
    Way("balancing_cases.case *.order", COUNTED),
    Way("shaking_table.*", SHAKE, of="phi loads_table.F_I*"),
    Way(
        "balanced_table.F_shake_* balanced_table.M_shake_*",
        BALANCED,
        of="phi F_shake_{0} shaking_table.F_shake shaking_table.M_shake",
    ),
    Way("balancing_cases.left", N_("The ratio of the greatest shaking force to that of row 0."), of="F_max"),
    Way("balancing_cases.M_left", MOMENT_LEFT, of="M_max"),
    Way("geared_inertia.i antiphase_weights.d antiphase_weights.r", STATED),
    Way("geared_inertia.J", WHEELS, of="link i"),
    Way("moment_harmonics.*", MOMENT_HARMONIC, of="order shaking_table.M_shake"),
    Way("antiphase_weights.*", ANTIPHASE, of="order M U d r"),
    Way("balancing_cases.m_total", N_("The sum of the counterweights of the way."), of="case method"),
    Way("balancing_cases.*", CASE, of="case method F_max F_rms M_max M_rms"),
    Way("counterweights.*", WEIGHT, of="method link U_x U"),
    Way("counterweight_masses.*", MEETS, of="method link point"),
    Way("substituted_masses.*", SPLIT, of="link first second m a b"),
    Way("shaking_harmonics.*", HARMONIC, of="order F_with F_against"),
    Way("lanchester_rotors.*", ROTOR, of="order mr m r"),
    Way("slider_harmonics_*.*", SERIES, of="order slider_lambda_{0} A F"),
    Way("slider_forces_*.*", LEFT, of="phi", enough=True),
    Way("balancing_disagreement", CHECK, of="omega"),
    Way("shaking_tail", TAIL, of="omega"),
    Way("seen_mean_*", SEEN_MEAN, of="omega"),
    Way("seen_*", SEEN, of="omega seen_mean_x seen_mean_y"),
    Way("slider_r_I_* slider_r_II_*", GIVEN, of="slider_U_I_{0} slider_U_II_{0} slider_m_B_{0}"),
    Way("slider_U_I_* slider_U_II_*", ROTOR, of="slider_m_B_{0} slider_r_{0}"),
    Way("slider_F_*", GREATEST, of="slider_m_B_* omega"),
    Way("slider_m_B_*", MASS, of="masses:{0}.m"),
    Way("slider_m_B_*", MASS, of="slider_r_{0} slider_l_{0}"),
    Way("slider_r_* slider_l_* slider_offset_* k_part", STATED),
)
