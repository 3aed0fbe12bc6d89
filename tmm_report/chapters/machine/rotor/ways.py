"""How the numbers of a rotor are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import NAME, STATED, Way

MASS = N_("By the mass, its radius, its angle and its place along the shaft, from plane I.")
LAID = N_("The product by the scale of the polygon.")
POLYGON = N_("Read off the polygon: the vector that closes it, measured and turned.")
CORRECTION = N_(
    "The two products that take the unbalance away, by the closing vectors of both polygons; as "
    "made, by what is stated of the weight."
)
BEARING = N_("By the moments of the unbalances about the other bearing.")
PER = N_(
    "The permissible unbalance by the grade, divided between the planes by their distances to "
    "the mass centre."
)
LEFT = N_("The sums of the unbalances and of their moments with the weights as made, or exact.")
SCALE = N_("Chosen so that the polygon fits the paper, from the usual scales.")
DIFFER = N_("The difference of both by their mean, in per cent.")
DIST = N_("The distance of the two places along the shaft.")
SUM = N_("The sum of the forces of both bearings beside that of the unbalances.")
ONE = N_("By the speed and the width: up to it one plane suffices for a rotor of this shape.")
CENTRE = N_("By the masses and their places along the shaft.")

WAYS = (
    Way("rotor_*.name rotor_*.plane rotor_*.bearing rotor_*.key rotor_*.unit", NAME),
    Way(
        "rotor_masses.m rotor_masses.r rotor_masses.alpha rotor_masses.z rotor_corrections.z "
        "rotor_bearings.z",
        STATED,
    ),
    Way("rotor_masses.D_mm rotor_masses.M_mm", LAID, of="name D M rotor_mu_D rotor_mu_M"),
    Way("rotor_masses.*", MASS, of="name m r alpha z"),
    Way(
        "rotor_corrections.*", CORRECTION, of="plane D_c alpha m_made r_made rotor_closing_D rotor_closing_M"
    ),
    Way("rotor_bearings.D_per", PER, of="bearing rotor_G rotor_mass rotor_omega"),
    Way("rotor_bearings.*", BEARING, of="bearing z R D_made rotor_omega rotor_L_AB"),
    Way("rotor_comparison.graph", POLYGON, of="key rotor_mu_D rotor_mu_M"),
    Way("rotor_comparison.analytic", CORRECTION, of="key"),
    Way("rotor_comparison.delta", DIFFER, of="key graph analytic"),
    Way("rotor_mu_*", SCALE, enough=True),
    Way("rotor_read_* rotor_closing_* rotor_laid_*", POLYGON, of="rotor_mu_D rotor_mu_M"),
    Way("rotor_L rotor_L_AB", DIST, of="rotor_centre rotor_mass"),
    Way("rotor_left_* rotor_uneven", LEFT, of="rotor_closing_D rotor_omega"),
    Way("rotor_disagreement", SUM, of="rotor_omega rotor_L_AB"),
    Way("rotor_one_plane rotor_ratio", ONE, of="rotor_omega rotor_mass"),
    Way("rotor_centre", CENTRE, of="rotor_mass"),
    Way("rotor_*", STATED),
)
