"""The numbers of a gear drive as a whole: single ones, those of each stage, of each member."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol, both, segment

MEAN, GREATEST = NP_("index", "mean"), NP_("index", "max")
ERROR = N_("difference of the ratio by the diagram from the calculated one")
ARM = N_("distance of the point whose velocity is laid off from the axis of the input member")
RUBBING = N_("mean moment of friction in the pairs, reduced to the driving link")
MOMENT = N_("mean balancing moment of the driving link over the cycle")
RUBBED = N_("mean balancing moment of the driving link over the cycle, friction in the pairs included")
ANGLE = N_("angle turned by the driving link at which the balancing moment has its greatest size")


class Values(Sheet):
    u = Q("u", "", N_("ratio of the drive at work"))
    u_teeth = Q("u", "", N_("ratio of the drive, second inputs at rest"))
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the drive"))
    delta_u = Q("delta_u", "%", N_("deviation of the ratio"))
    u_graph = Q(Symbol("u", "", "gr"), "", N_("ratio by the diagram of angular velocities"))
    error = Q("delta", "%", ERROR)
    tolerance = Q(None, "%", N_("allowed deviation of the ratio"))
    eta = Q("eta", "", N_("efficiency of the drive"))
    losses = Q(None, "W", N_("power lost in all the meshes"))
    mu_l = Q("mu_l", "m/mm", N_("scale of the kinematic scheme"))
    mu_v = Q("mu_v", "(m/s)/mm", N_("scale of the diagram of linear velocities"))
    mu_omega = Q("mu_omega", "(rad/s)/mm", N_("scale of the diagram of angular velocities"))
    h = Q("h", "mm", N_("pole distance of the diagram of angular velocities"))
    step = Q(None, "mm", N_("to which the segments are read"))
    arm = Q("r", "m", ARM)
    v = Q("v", "m/s", N_("velocity of the point that is laid off"))
    laid = Q(None, "mm", N_("segment as which this velocity is laid off"))

    M_fr = Q("M_fr", "N·m", RUBBING)
    M_mean = Q(Symbol("M", f"bal,{MEAN}"), "N·m", MOMENT)
    M_greatest = Q(
        Symbol("M", GREATEST), "N·m", N_("balancing moment of the driving link of the greatest size")
    )
    M_angle = Q(Symbol("phi", GREATEST), "deg", ANGLE)
    T_mean = Q("T", "N·m", N_("torque on the input shaft"))
    peak = Q("k_M", "", N_("how many times the greatest balancing moment is the mean one"))


class OfStage(Row):
    u = Q("u", "", N_("ratio of the stage"))
    u_required = Q(Symbol("u", "", "′"), "", N_("required ratio of the stage"))
    eta = Q("eta", "", N_("efficiency of the stage"))


class Member(Row):
    z = Q("z", "", N_("number of teeth; 0: a carrier"))
    omega = Q("omega", "rad/s", N_("angular velocity"))
    n = Q("n", "rpm", N_("rotational speed"))
    omega_rel = Q(Symbol("omega", "", "(H)"), "rad/s", N_("angular velocity about the carrier of the axis"))


class Segment(Row):
    s = Q("s", "mm", N_("segment as it is read, signed"))


def letters(found: Found) -> dict[str, Q]:
    """What this drive calls otherwise: by the names of its members and of the point that is laid off."""
    first, of = found.plans.first.name, Values.DECLARED
    whole = Symbol("u", both(found.input, found.output))
    # i of a differential, whose u is that with the second input at rest
    work = replace(whole, base="i") if found.differential else whole
    called = {
        "u": work, "u_teeth": whole, "u_required": replace(whole, sup="′"), "u_graph": replace(work, sup="gr"),
        "arm": Symbol("r", found.input), "v": Symbol("v", first), "laid": segment(f"{first}{first.lower()}"),
        "T_mean": Symbol("T", found.input),
    }  # fmt: skip
    own = {key: of[key].called(symbol) for key, symbol in called.items()}
    if found.moments is not None and found.moments.rubs:
        own["M_mean"] = Q(Symbol("M", f"bal,{MEAN}"), "N·m", RUBBED)
    return own
