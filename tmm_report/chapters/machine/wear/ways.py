"""How the numbers of wear are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import AXIS, COUNTED, NAME, STATED, Way

CYCLE = N_(
    "At the position of the cycle: the reaction of the guide, its moment and arm, by the force "
    "analysis; the place of the slider by its motion."
)
WORN = N_("Of the worn faces at the position: how the slider lies on them.")
SUM = N_(
    "At each position of the cycle the pressure under the slider by the path of the point; "
    "summed over the positions."
)
WEAR = N_(
    "The wear law u = k p s: the wear coefficient by the sum of pressure by path, by the number of cycles."
)
PLACE = N_("Equal parts of the guide or of the slider, counted from its end.")
GREATEST = N_("The greatest of all points, or the sum over them, of the table.")
STAGE = N_("The wear grows by running in to its limit and then evenly with the time.")
SECTOR = N_(
    "The arc of contact follows the direction of the reaction; at each position the sectors in "
    "it take its pressure by the path."
)
MASS = N_("By the wear of all its points, the width of the face and the density.")
EVEN = N_("The sum of all points divided evenly over the length that rubs.")
MATERIAL = N_(
    "Of the material of the face: stated, or by the coefficient of a standard and the relative resistance."
)
STEPS = N_("Stated, or the usual number of equal steps of the cycle.")
TIME = N_("By the speed of the driving link and the number of cycles.")

WAYS = (
    Way("wear_*.cause wear_*.face wear_*.side wear_*.link wear_*.member", NAME),
    Way("wear_*.point", COUNTED),
    Way("wear_*_cycle.phi wear_*_stages.t", AXIS),
    Way(
        "wear_*_profile.x wear_*_sole.xi wear_*_sectors.alpha",
        PLACE,
        of="point wear_{0}_parts wear_{0}_sectors",
    ),
    Way("wear_*_cycle.shift wear_*_cycle.tilt", WORN, of="phi S wear_{0}_greatest"),
    Way("wear_*_cycle.*", CYCLE, of="phi S R M"),
    Way("wear_*_profile.work_* wear_*_sole.work_*", SUM, of="point x xi wear_{0}_positions"),
    Way(
        "wear_*_profile.* wear_*_sole.*",
        WEAR,
        of="point x xi work_force_upper work_force_lower wear_{0}_cycles",
    ),
    Way("wear_*_stages.*", STAGE, of="t u wear_{0}_run_in wear_{0}_constant"),
    Way("wear_*_surfaces.k wear_*_members.k", MATERIAL, of="side face cause member"),
    Way("wear_*_positions", STEPS, of="wear_{0}_cycles"),
    Way("wear_*_constant wear_*_arc", STATED),
    Way("wear_*_surfaces.*", GREATEST, of="side face cause k"),
    Way("wear_*_members.mass", MASS, of="member k wear_{0}_density"),
    Way("wear_*_members.*", GREATEST, of="member k"),
    Way("wear_*_sectors.path_*", SECTOR, of="alpha wear_{0}_arc wear_{0}_positions"),
    Way("wear_*_sectors.*", WEAR, of="alpha path_bushing path_journal wear_{0}_cycles"),
    Way(
        "wear_*_greatest wear_*_rubbed wear_*_volume wear_*_shift wear_*_tilt wear_*_repair",
        GREATEST,
        of="wear_{0}_cycles wear_{0}_positions",
    ),
    Way("wear_*_even", EVEN, of="wear_{0}_greatest wear_{0}_parts"),
    Way("wear_*_pressure", GREATEST, of="wear_{0}_diameter wear_{0}_width wear_{0}_rubbed"),
    Way("wear_*_cycles wear_*_period", TIME, of="omega"),
    Way("wear_*_life", TIME, of="omega wear_{0}_greatest"),
    Way("wear_*_stroke", N_("From one extreme position of the slider to the other."), of="H_*"),
    Way(
        "wear_*_covered",
        N_("Counted: the points of the guide under the slider at a time."),
        of="wear_{0}_slider wear_{0}_parts",
    ),
    Way("wear_*", STATED),
)
