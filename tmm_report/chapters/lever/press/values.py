"""The numbers of a press: single ones, and the columns of its tables."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet

WORDS = (
    NP_("index", "lim"),
    NP_("index", "nom"),
    NP_("index", "max"),
    NP_("index", "min"),
    NP_("index", "mean"),
)


class Stroke(Sheet):
    """Before the dead point, over its angle or its path."""

    alpha = Q("alpha", "rad", N_("angle of the driving link before the dead point"), "deg")
    s = Q("s", "m", N_("path of the slider left to the dead point"), "mm")
    h = Q("h", "m", N_("arm of the slider's force on the driving link, the analogue of its velocity"), "mm")
    v = Q("v", "m/s", N_("velocity of the slider towards the dead point"))
    F_lim = Q("F_lim", "N", N_("force of the slider that the permitted torque allows"), "kN")
    F_nom = Q("F_nom", "N", N_("rated force of the slider"), "kN")


class Values(Sheet, prefix="press"):
    omega = Q("omega", "rad/s", N_("size of the angular velocity of the driving link"))
    alpha_dead = Q("phi_0", "rad", N_("angle turned from position 0 to the dead point"), "deg")
    stroke = Q("H", "m", N_("stroke of the slider to the dead point"), "mm")
    alpha_stroke = Q("alpha_H", "rad", N_("angle of the driving link that this stroke takes"), "deg")
    torque = Q("M_lim", "N·m", N_("permitted torque on the driving link"))
    h_max = Q("h_max", "m", N_("greatest arm over the stroke"), "mm")
    F_least = Q("F_min", "N", N_("force that is permitted over the whole stroke"), "kN")
    rated = Q("F_nom", "N", N_("rated force of the slider"), "kN")
    h_nom = Q("h_nom", "m", N_("arm at which the rated force needs the permitted torque"), "mm")
    alpha_nom = Q(
        "alpha_nom", "rad", N_("angle before the dead point from which the rated force is permitted"), "deg"
    )
    s_nom = Q("s_nom", "m", N_("path before the dead point from which the rated force is permitted"), "mm")
    within = Q("delta", "m", N_("distance from the dead point within which the slider dwells"), "mm")
    before = Q("alpha_b", "rad", N_("angle of the dwell before the dead point"), "deg", formed="")
    after = Q("alpha_a", "rad", N_("angle of the dwell after the dead point"), "deg", formed="")
    dwell = Q("alpha_d", "rad", N_("angle of the dwell"), "deg", formed="")
    t_dwell = Q("t_d", "s", N_("time of the dwell"))
    s_1 = Q("s_1", "m", N_("path left at the beginning of the working stroke"), "mm")
    s_2 = Q("s_2", "m", N_("path left at the end of the working stroke"), "mm")
    alpha_1 = Q("alpha_1", "rad", N_("angle before the dead point at the beginning"), "deg", formed="")
    alpha_2 = Q("alpha_2", "rad", N_("angle before the dead point at the end"), "deg", formed="")
    t_working = Q("t_w", "s", N_("time of the working stroke"))
    v_mean = Q("v_mean", "m/s", N_("mean velocity of the slider over the working stroke"))
    v_max = Q("v_max", "m/s", N_("greatest velocity of the slider over the working stroke"))
    v_min = Q("v_min", "m/s", N_("least velocity of the slider over the working stroke"))
    peak = Q("k_v", "", N_("ratio of the greatest velocity to the mean one"))
    unevenness = Q("delta_v", "", N_("unevenness of the velocity over the working stroke"))
