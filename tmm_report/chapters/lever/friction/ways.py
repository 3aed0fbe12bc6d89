"""How the numbers of friction are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.chapters.lever.friction.quantities import LENGTH
from tmm_report.chapters.lever.kinetostatics.quantities.positions import both
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Var
from tmm_report.quantity.ways import AXIS, COUNTED, NAME, STATED, Known, Way, summed

BOOK = N_("From the table of materials, by the two that rub and their lubrication.")
TABLE = N_("Stated, or the middle of the range in the table of materials by the two that rub.")
PAIR = N_(
    "The coefficient of friction by the reaction and the relative velocity: in a pivot at the "
    "radius of the journal."
)
TILTING = N_(
    "The size of the moment of the reaction about the middle of the slider, found without friction from the "
    "equilibrium of its link."
)
PRESSED = N_("Where the slider tilts the sum of the forces at both its ends, else the reaction.")
PRESSING = N_("The size of the reaction in the pair, found without friction.")
RELATIVE = N_(
    "The difference of the rates of the two links: in a pivot of their angular velocities, in a "
    "guide of their velocities."
)
TOUCHES = N_(
    "The velocity of the cam's surface at the contact less that of the follower, across the common normal; of a "
    "roller by its radius, less how the follower turns."
)
SLIDES = N_("The relative angular velocity of the links times the radius of the journal.")
BY_LAW = N_("The stated law of the coefficient at the velocity of sliding of the position.")
MEAN = N_(
    "The mean over the whole cycle: the integral by the angle on the smooth pieces between "
    "kinks, by the angle of the cycle."
)
WORK = N_("The mean power of friction times the time of the cycle.")
WHOLE = N_("The work of the balancing moment by the sum of it and of the work of friction over the cycle.")
NEWTON = N_(
    "The equations of equilibrium with friction, in which the friction follows the reactions, "
    "are solved by Newton's method "
    "from the reactions without friction."
)
MISS = N_("The balancing moment by the forces with friction beside that by the powers.")


def _pressed(q: Known) -> Expr:
    """2|M|/l where that is more than the reaction."""
    pair = q.parts[0]
    length = next(loss.rubbing.length for loss in q.found.table.pairs if loss.pair.key == pair)
    force, couple = q("R_{0}"), q("M_{0}")
    if float(couple.number) * 2 > float(force.number) * length:
        return 2 * couple / Var(LENGTH.sign, length, "m")
    return force


def _pressing(q: Known) -> Expr:
    """The reaction of either link of the pair on the other."""
    one, _, other = q.parts[0].partition("-")
    known = (f"reactions_table.R_{both(*of)}" for of in ((one, other), (other, one)))
    for name in known:
        if q.has(name):
            return q(name)
    raise KeyError(q.parts[0])


WAYS = (
    Way("friction_given.links friction_given.name friction_given.kind friction_materials.links", NAME),
    Way("friction_given.f", TABLE, of="name kind"),
    Way("friction_given.*", STATED),
    Way("friction_materials.f* friction_materials.phi_fr", BOOK, of="materials lubrication"),
    Way("friction_stribeck.names friction_points.names", NAME),
    Way("friction_stribeck.* friction_points.*", STATED),
    Way("friction_table.v_sl_*", SLIDES, of="w_rel_{0} friction_given.d"),
    Way("friction_table.f_*", BY_LAW, of="v_sl_{0} v_rel_{0} friction_stribeck.f_s friction_points.f"),
    Way("E_fr", WORK, of="P_fr_mean"),
    Way("friction_table.P_fr", by=summed("P_fr_")),
    Way("friction_table.P_fr_*", PAIR, of="R_{0} N_{0} v_rel_{0} w_rel_{0} w_roll_* v_touch_*"),
    Way("friction_table.M_*", TILTING, of="R_{0}"),
    Way("friction_table.N_*", PRESSED, by=_pressed, of="R_{0} M_{0}"),
    Way("friction_table.R_*", PRESSING, by=_pressing, of="phi"),
    Way("friction_table.w_roll_* friction_table.v_touch_*", TOUCHES, of="phi omega"),
    Way("friction_table.v_rel_* friction_table.w_rel_*", RELATIVE, of="rates_table.w_* phi"),
    Way("friction_corrected_*.position friction_reactions_*.position", COUNTED),
    Way("friction_corrected_*.phi friction_reactions_*.phi", AXIS),
    Way("friction_corrected_*.* friction_reactions_*.*", NEWTON, of="friction_table.R_*"),
    Way("P_fr_mean", MEAN, of="omega law_time"),
    Way("eta_mean", WHOLE, of="P_bal_mean P_fr_mean"),
    Way("P_fr_corrected_mean eta_corrected_mean M_growth friction_steps", NEWTON, of="P_fr_mean eta_mean"),
    Way("friction_disagreement", MISS, of="P_fr_mean"),
)
