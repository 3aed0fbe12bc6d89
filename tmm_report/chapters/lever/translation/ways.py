"""How the numbers of the reduction to a link that slides are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import Known, Way, summed

PART = N_("From the equality of kinetic energies: m(v_S/v)² + J(ω/v)², by the link's own motion.")
LOAD = N_("From the equality of powers: that of the load by the speed of the stroke.")
SLOPE = N_("By the accelerations of the links and of the stroke; no differences are taken.")
ALONG = N_("By the motion of the link along its guide.")
EXTREME = N_(
    "Over the positions of the diagram, but where the link moves slower than a quarter of its greatest speed."
)
MISS = N_(
    "The driving force by the reduced mass and force beside the balancing moment by the reactions, greatest of all."
)


def _needed(q: Known) -> Expr:
    v = q("reduced_mass_table.v")
    total = q("reduced_mass_table.m_red") * q("reduced_mass_table.a")
    total = total + q("reduced_mass_table.m_red_slope") * v**2 / 2
    return total - q("F_red") if q.has("F_red") else total


WAYS = (
    Way("reduced_mass_table.s reduced_mass_table.v reduced_mass_table.a", ALONG, of="phi"),
    Way("reduced_mass_table.m_red_slope", SLOPE, of="m_red v m_red_*"),
    Way("reduced_mass_table.m_red", by=summed("m_red_", but="m_red_slope")),
    Way("reduced_mass_table.m_red_*", PART, of="v masses:{0}.m masses:{0}.J"),
    Way("reduced_force_table.F_red", by=summed("F_red_")),
    Way("reduced_force_table.F_red_*", LOAD, of="loads_table.{0} reduced_mass_table.v"),
    Way("reduced_force_table.F_dr", by=_needed),
    Way("m_red_min m_red_max", EXTREME, of="omega stroke_arm"),
    Way("translation_disagreement", MISS, of="omega F_stroke_min F_stroke_max"),
)
