"""How the numbers of the harmonics are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

FOURIER = N_(
    "By Fourier's sums over equal steps of a turn at which the motion is solved; velocities and "
    "accelerations likewise."
)
LEFT = N_("The greatest difference of the motion from the sum of the harmonics that are given, by the swing.")
WAVE = N_("The harmonics of the place along the link: linear between those of its two points.")
CHECK = N_("The harmonics of the wave beside the closed form of a slider-crank, greatest difference.")
TAIL = N_("The largest of the harmonics beyond those that are given, by the largest of all.")
PLACE = N_("Equal parts of the way along the link from its first point to its second.")

WAYS = (
    Way("harmonics_left.motion", NAME),
    Way("harmonic_content.order", COUNTED),
    Way("harmonic_content.*", FOURIER, of="order harmonics_samples"),
    Way("harmonics_left.*", LEFT, of="motion main left"),
    Way("wave_*.xi", PLACE, of="harmonics_samples"),
    Way("wave_*.*", WAVE, of="xi harmonics_samples"),
    Way("wave_check_*", CHECK, of="harmonics_samples"),
    Way("harmonics_tail", TAIL, of="harmonics_samples"),
    Way(
        "harmonics_samples",
        N_("Equal steps of a turn, so many that the harmonics beyond them are next to nothing."),
        enough=True,
    ),
    Way("harmonics_*", STATED),
)
