"""How the numbers of the reduction are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.chapters.lever.kinematics.solve.positions import stands
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Var, expr
from tmm_report.quantity.ways import Known, Way, summed

PART = N_("From the equality of kinetic energies: m(v_S/ω)² + J(ω_i/ω)², by the link's own motion.")
LOAD = N_("From the equality of powers: that of the load by the angular velocity of the driving link.")
SLOPE = N_("By the accelerations: 2(m v·a + J ω ε)/ω³ of each link, summed; no differences are taken.")
EXTREME = N_("Over the whole cycle, between the positions of the table too.")
GRAPH = N_("By the polygon: the masses by the squares of the ratios that are read off it.")
READ = N_(
    "Read off the velocity polygon: the measured segment by its scale and by the angular velocity of the driving "
    "link."
)
MISS = N_(
    "The balancing moment by the reduced moments of loads and inertia beside that by the "
    "reactions, greatest of all."
)


def _part(q: Known) -> Expr:
    """m (v_S/ω)² + J (ω_i/ω)² of a link."""
    omega = _omega(q)
    total: Expr | None = None
    if q.has("masses:{0}.m") and q.own_text("masses:{0}.mass_centre"):
        point = q.own_text("masses:{0}.mass_centre")
        if q.has(f"rates_table.v_{point}"):
            total = q("masses:{0}.m") * (q(f"rates_table.v_{point}") / omega) ** 2
    if q.has("masses:{0}.J") and q.has("rates_table.w_{0}"):
        one = q("masses:{0}.J") * (q("rates_table.w_{0}") / omega) ** 2
        total = one if total is None else total + one
    if total is None:
        raise KeyError("masses")
    return total


def _power(q: Known) -> Expr:
    if q.fine:
        raise KeyError("powers are told at the table positions")
    return expr(q("powers_table.N_{0}") / _omega(q))


def _omega(q: Known) -> Var:
    """Angular velocity of the driving link; a law has it at every position, where the link stands still nothing is
    divided by it."""
    motion = q.found.kinematics
    if not motion.by_law:
        return q("omega")
    omega = q(f"rates_table.w_{motion.linkage.mechanism.driver.link}")
    if stands(motion.table)[q.row or 0]:
        raise KeyError("the driving link stands still")
    return omega


WAYS = (
    Way("reduced_inertia_table.I_red_slope", SLOPE, of="I_red omega I_*"),
    Way("reduced_inertia_table.I_*", PART, of="phi masses:{0}.m masses:{0}.J", by=_part),
    Way("reduced_moment_table.M_red", by=summed("M_red_")),
    Way("reduced_moment_table.M_red_*", LOAD, of="loads_table.{0} omega", by=_power),
    Way("I_red_min I_red_max", EXTREME, of="omega law_*"),
    Way("reduction_plans.I_red_graph", GRAPH, of="vq_* u_*"),
    Way("reduction_plans.I_red", PART, of="position vq_* u_*"),
    Way(
        "reduction_plans.delta_I",
        N_("The difference of both by their mean, in per cent."),
        of="I_red_graph I_red",
    ),
    Way("reduction_plans.*", READ, of="mu_v omega"),
    Way("reduction_disagreement", MISS, of="omega law_*"),
)
