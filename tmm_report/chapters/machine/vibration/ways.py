"""How the numbers of vibration are found that no formula of the note defines."""

from __future__ import annotations

import numpy as np

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Function, sqrt
from tmm_report.quantity.ways import AXIS, COUNTED, NAME, STATED, Known, Way

RESPONSE = N_(
    "By the closed form of the response of a machine on springs: β = 1/√((1 − η²)² + 4ζ²η²), "
    "lag and transmissibility from the same."
)
MOTION = N_("The free motion that fits the state at the start, and the forced one.")
SHAKEN = N_(
    "The harmonics of the shaking force by Fourier's sums; the machine answers each by the "
    "closed form, and the answers are added."
)
HARMONIC = N_(
    "The harmonic of the shaking force of the mechanism, and the answer of the machine at its frequency."
)
ABSORBER = N_(
    "The two equations of machine and absorber, solved for the amplitudes; the greatest is "
    "sought over the frequency."
)
DRY = N_("The piece-wise motion with dry friction in closed form: the amplitude at which it repeats.")
PAIR = N_("The two equations of machine and base, solved for the amplitudes.")
GREATEST = N_("The greatest over a turn of the sum of all harmonics.")
RESONANCE = N_(
    "The frequency of the excitation at which the natural frequency is met; of an order by its number."
)
DAMPED = N_("ω₀√(1 − ζ²).")
ZETA = N_("By the damping: n/ω₀; or stated.")
SEARCH = N_("The damping at which the transmissibility at this stiffness is the wanted one.")
WHOLE = N_("Stated of one isolator, or of all of them by their number.")
HUNG = N_("Stated of the absorber, or by its ratio to the mass of the machine.")


def _falling(q: Known) -> Expr:
    """A_0 exp(−n t) after whole periods."""
    decays = Function(NP_("function", "exp"), -(q("vibration_decay") * q("t")), np.exp)
    return q("vibration_begins") * decays


def _damped(q: Known) -> Expr:
    return q("vibration_natural") * sqrt(1 - q("vibration_zeta") ** 2)


WAYS = (
    Way("vibration_*.kind", NAME),
    Way("vibration_harmonics.order vibration_swings.swing", COUNTED),
    Way("vibration_swings.t", by=lambda q: q("swing") * q("vibration_period")),
    Way("vibration_swings.size", by=_falling),
    Way(
        "vibration_response.eta vibration_curves.eta vibration_motion.t vibration_turn.phi "
        "vibration_absorbed.eta vibration_dampings.zeta",
        AXIS,
    ),
    Way("vibration_response.*", RESPONSE, of="eta vibration_zeta vibration_static"),
    Way("vibration_curves.*", RESPONSE, of="eta vibration_zeta"),
    Way("vibration_dampings.*", RESPONSE, of="zeta vibration_eta"),
    Way("vibration_motion.*", MOTION, of="t vibration_place vibration_speed vibration_amplitude"),
    Way("vibration_turn.*", SHAKEN, of="phi vibration_zeta"),
    Way("vibration_harmonics.*", HARMONIC, of="order omega eta force"),
    Way("vibration_absorbed.*", ABSORBER, of="eta vibration_mu"),
    Way("vibration_absorbers.*", ABSORBER, of="kind absorber absorber_stiffness vibration_mu"),
    Way("vibration_sag", by=lambda q: q("vibration_g") / q("vibration_natural") ** 2),
    Way("vibration_damped", DAMPED, by=_damped),
    Way("vibration_dry_exact", DRY, of="vibration_friction vibration_force vibration_omega"),
    Way(
        "vibration_pair_* vibration_gamma_ground",
        PAIR,
        of="vibration_base_inertia vibration_base_stiffness vibration_force",
    ),
    Way("vibration_force_most vibration_handed_most vibration_moved_most", GREATEST, of="vibration_shaft"),
    Way("vibration_resonance", RESONANCE, of="vibration_natural vibration_order vibration_eta"),
    Way("vibration_most_damping", SEARCH, of="vibration_wanted vibration_eta"),
    Way("vibration_force", HARMONIC, of="vibration_order vibration_shaft"),
    Way("vibration_omega", by=lambda q: q("vibration_order") * abs(q("vibration_shaft"))),
    Way("vibration_omega", N_("The stated speed or frequency of the excitation."), of="vibration_eta"),
    Way("vibration_zeta", ZETA, of="vibration_decay vibration_natural"),
    Way(
        "vibration_stiffness vibration_damping_each vibration_stiffness_each",
        WHOLE,
        of="vibration_isolators vibration_stiffness vibration_stiffness_each vibration_damping",
    ),
    Way("vibration_absorber", HUNG, of="vibration_mu vibration_inertia"),
    Way("vibration_order", N_("Stated, or the harmonic that moves the machine most."), of="vibration_shaft"),
    Way("vibration_shaft", N_("The angular velocity of the driving link."), of="omega n_1"),
    Way("vibration_*", STATED),
)
