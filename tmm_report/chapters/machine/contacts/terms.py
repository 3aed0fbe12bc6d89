"""What the numbers of every kind of pair are: symbol, unit, meaning."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol

KINDS = {
    "incline": N_("Inclined plane"),
    "wedge": N_("Wedge"),
    "sliders": N_("Pair of guided sliders"),
    "trial": N_("Pull and push of a body"),
    "screw": N_("Screw pair"),
    "pivot": N_("Pivot"),
    "belt": N_("Belt round a drum"),
    "belt_drive": N_("Belt drive"),
    "wheel": N_("Rolling wheel"),
    "journal": N_("Journal"),
    "crank": N_("Slider-crank with friction circles"),
}

RAISED, LOWERED, RED, MAX = NP_("index", "raise"), NP_("index", "lower"), NP_("index", "red"), "max"
BEST, THREAD, COLLAR, HAND = (
    NP_("index", "best"),
    NP_("index", "thread"),
    NP_("index", "collar"),
    NP_("index", "hand"),
)
WORN, EVEN = NP_("index", "worn"), NP_("index", "even")
ROLL, SLIDE, MEAN = NP_("index", "roll"), NP_("index", "slide"), NP_("index", "mean")
IDEAL, DRIVEN, HELD = NP_("index", "ideal"), NP_("index", "drive"), NP_("index", "hold")


def _of(key: str, symbol: Symbol, unit: str, text: str) -> Quantity:
    return Quantity(key, symbol, unit, Message(text))


def _all(*found: Quantity) -> dict[str, Quantity]:
    return {one.key: one for one in found}


LOAD = _of("Q", Symbol("Q"), "N", N_("load"))
F = _of("f", Symbol("f"), "", N_("coefficient of friction"))
PHI = _of("phi", Symbol("phi"), "deg", N_("angle of friction"))
ETA = _of("eta", Symbol("eta"), "", N_("efficiency"))
OMEGA = _of("omega", Symbol("omega"), "rad/s", N_("angular velocity"))
POWER = _of("P", Symbol("P"), "W", N_("power"))
WRAP = _of("alpha", Symbol("alpha"), "rad", N_("angle of contact"))
TIGHT = _of("T_1", Symbol("T", "1"), "N", N_("tension of the tight side"))
SLACK = _of("T_2", Symbol("T", "2"), "N", N_("tension of the slack side"))
TANGENT = _of("F_t", Symbol("F", "t"), "N", N_("force carried by friction"))
SPEED = _of("v", Symbol("v"), "m/s", N_("speed of the belt"))

INCLINE = _all(
    LOAD,
    _of("alpha", Symbol("alpha"), "deg", N_("slope of the plane")),
    F,
    PHI,
    _of("F_up", Symbol("F", RAISED), "N", N_("force that moves the body up")),
    _of("F_down", Symbol("F", LOWERED), "N", N_("force that lets the body down at constant speed")),
    _of("eta", Symbol("eta", RAISED), "", N_("efficiency of raising")),
    _of("eta_back", Symbol("eta", LOWERED), "", N_("efficiency of lowering, the load driving")),
)
WEDGE = _all(
    LOAD,
    _of("alpha", Symbol("alpha"), "deg", N_("angle of the wedge")),
    _of("f", Symbol("f", "1"), "", N_("coefficient of friction on the sloping face")),
    _of("phi", Symbol("phi", "1"), "deg", N_("angle of friction on the sloping face")),
    _of("f_base", Symbol("f", "2"), "", N_("coefficient of friction on the base")),
    _of("phi_base", Symbol("phi", "2"), "deg", N_("angle of friction on the base")),
    _of("F_in", Symbol("F", DRIVEN), "N", N_("force that drives the wedge in")),
    _of("F_out", Symbol("F", HELD), "N", N_("force that holds the wedge against the load")),
    _of("alpha_lock", Symbol("alpha", MAX), "deg", N_("greatest angle at which the wedge locks")),
    ETA,
)
SLIDERS = _all(
    LOAD,
    _of("theta", Symbol("theta"), "deg", N_("angle between the directions of the sliders")),
    _of("f", Symbol("f", "1"), "", N_("coefficient of friction on the sloping face")),
    _of("phi", Symbol("phi", "1"), "deg", N_("angle of friction on the sloping face")),
    _of("f_guide", Symbol("f", "2"), "", N_("coefficient of friction in the guides")),
    _of("phi_guide", Symbol("phi", "2"), "deg", N_("angle of friction in the guides")),
    _of("phi_both", Symbol("Phi"), "deg", N_("angles of friction of face and guide together")),
    _of("alpha_best", Symbol("alpha", BEST), "deg", N_("best angle of the face's normal")),
    _of("eta_best", Symbol("eta", MAX), "", N_("greatest efficiency")),
    _of("alpha", Symbol("alpha"), "deg", N_("angle of the face's normal with the driving direction")),
    ETA,
    _of("F", Symbol("F"), "N", N_("driving force")),
)
TRIAL = _all(
    _of("theta", Symbol("theta"), "deg", N_("angle of the force with the level")),
    _of("P_pull", Symbol("P", "1"), "N", N_("force that just pulls the body")),
    _of("P_push", Symbol("P", "2"), "N", N_("force that just pushes the body")),
    F,
    _of("G", Symbol("G"), "N", N_("weight of the body")),
    PHI,
    _of("P_least", Symbol("P", "min"), "N", N_("least force that moves the body")),
)
SCREW = _all(
    LOAD,
    _of("d_2", Symbol("d", "2"), "m", N_("mean diameter of the thread")),
    _of("p", Symbol("p"), "m", N_("pitch of the thread")),
    _of("z", Symbol("z"), "", N_("number of starts")),
    _of("h", Symbol("h"), "m", N_("lead of the thread")),
    _of("psi", Symbol("psi"), "deg", N_("lead angle")),
    _of("beta", Symbol("beta"), "deg", N_("half the angle of the thread")),
    F,
    _of("phi_red", Symbol("phi'"), "deg", N_("reduced angle of friction")),
    _of("M_thread", Symbol("M", THREAD), "N·m", N_("moment of friction and load in the thread, raising")),
    _of("M_low", Symbol("M", LOWERED), "N·m", N_("moment in the thread that lowers the load")),
    _of("eta_thread", Symbol("eta", THREAD), "", N_("efficiency of the thread")),
    _of("M_screw", Symbol("M"), "N·m", N_("moment that raises the load")),
    ETA,
    _of("f_collar", Symbol("f", COLLAR), "", N_("coefficient of friction of the collar")),
    _of("R_collar", Symbol("R", COLLAR), "m", N_("mean radius of the collar")),
    _of("M_collar", Symbol("M", COLLAR), "N·m", N_("moment of friction of the collar")),
    _of("M_back", Symbol("M'"), "N·m", N_("moment that lowers the load, with the collar")),
    _of("l_hand", Symbol("l", HAND), "m", N_("arm of the hand force")),
    _of("P_hand", Symbol("P", HAND), "N", N_("force of a hand")),
    _of("n_hand", Symbol("n", HAND), "", N_("number of hands")),
    _of("D_wheel", Symbol("D", HAND), "m", N_("diameter of the handwheel")),
)
PIVOT = _all(
    LOAD,
    F,
    _of("R_outer", Symbol("R"), "m", N_("outer radius")),
    _of("r_inner", Symbol("r"), "m", N_("inner radius")),
    _of("half_cone", Symbol("alpha"), "deg", N_("half the angle of the cone")),
    _of("p_mean", Symbol("p", MEAN), "Pa", N_("mean pressure")),
    _of("M_pressure", Symbol("M", EVEN), "N·m", N_("moment of friction under uniform pressure")),
    _of("M_wear", Symbol("M", WORN), "N·m", N_("moment of friction of a run-in pivot")),
    OMEGA,
    _of("P_pressure", Symbol("P", EVEN), "W", N_("power of friction under uniform pressure")),
    _of("P_wear", Symbol("P", WORN), "W", N_("power of friction of a run-in pivot")),
)
BELT = _all(
    F,
    _of("groove", Symbol("gamma"), "deg", N_("half the angle of the groove")),
    _of("f_red", Symbol("f", RED), "", N_("reduced coefficient of friction in the groove")),
    WRAP,
    TIGHT,
    SLACK,
    TANGENT,
    _of("D", Symbol("D"), "m", N_("diameter of the drum")),
    _of("M_drum", Symbol("M"), "N·m", N_("moment of friction on the drum")),
    OMEGA,
    SPEED,
    POWER,
)
BELT_DRIVE = _all(
    _of("d_1", Symbol("d", "1"), "m", N_("diameter of the driving pulley")),
    _of("d_2", Symbol("d", "2"), "m", N_("diameter of the driven pulley")),
    _of("a", Symbol("a"), "m", N_("distance of the axes")),
    _of("omega_1", Symbol("omega", "1"), "rad/s", N_("angular velocity of the driving pulley")),
    _of("b", Symbol("b"), "m", N_("width of the belt")),
    _of("t", Symbol("t"), "m", N_("thickness of the belt")),
    _of("sigma", Symbol("sigma"), "Pa", N_("stress allowed in the belt")),
    F,
    _of("u", Symbol("u"), "", N_("ratio")),
    _of("alpha", Symbol("alpha"), "rad", N_("angle of contact on the smaller pulley")),
    SPEED,
    _of("T_max", Symbol("T", MAX), "N", N_("tension that the belt bears")),
    TIGHT,
    SLACK,
    TANGENT,
    _of("P", Symbol("P"), "W", N_("greatest power")),
    _of("T_0", Symbol("T", "0"), "N", N_("initial tension")),
    _of("rho", Symbol("rho"), "kg/m³", N_("density of the belt")),
    _of("q", Symbol("q"), "kg/m", N_("mass of a metre of the belt")),
    _of("T_c", Symbol("T", "c"), "N", N_("centrifugal tension")),
    _of("v_best", Symbol("v", BEST), "m/s", N_("speed of the greatest power")),
    _of("P_best", Symbol("P", BEST), "W", N_("power at that speed")),
)
WHEEL = _all(
    _of("N", Symbol("N"), "N", N_("load on the wheel")),
    _of("k", Symbol("k"), "m", N_("arm of rolling resistance")),
    _of("r", Symbol("r"), "m", N_("radius of the wheel")),
    F,
    _of("M_roll", Symbol("M", ROLL), "N·m", N_("moment of rolling resistance")),
    _of("F_roll", Symbol("F", ROLL), "N", N_("force at the axle that makes the wheel roll")),
    _of("F_slide", Symbol("F", SLIDE), "N", N_("force at the axle that makes the wheel slide")),
    _of("f_roll", Symbol("f", ROLL), "", N_("coefficient of resistance of the wheel, k/r")),
    _of("phi_roll", Symbol("phi", ROLL), "deg", N_("slope on which the wheel begins to roll")),
    PHI,
    _of("F", Symbol("F"), "N", N_("force stated at the axle")),
)
JOURNAL = _all(
    LOAD,
    _of("d", Symbol("d"), "m", N_("diameter of the journal")),
    F,
    _of("rho", Symbol("rho"), "m", N_("radius of the friction circle")),
    _of("M_fr", Symbol("M", "fr"), "N·m", N_("moment of friction")),
    PHI,
    OMEGA,
    _of("P", Symbol("P", "fr"), "W", N_("power of friction")),
)
CRANK = _all(
    _of("F", Symbol("F"), "N", N_("force on the slider")),
    _of("r", Symbol("r"), "m", N_("length of the crank")),
    _of("l", Symbol("l"), "m", N_("length of the connecting rod")),
    _of("phi", Symbol("phi"), "deg", N_("angle of the crank from its dead point")),
    F,
    _of("d_shaft", Symbol("d", "1"), "m", N_("diameter of the shaft's journal")),
    _of("d_pin", Symbol("d", "2"), "m", N_("diameter of the crankpin")),
    _of("d_wrist", Symbol("d", "3"), "m", N_("diameter of the wrist pin")),
    _of("rho_shaft", Symbol("rho", "1"), "m", N_("radius of the friction circle of the shaft")),
    _of("rho_pin", Symbol("rho", "2"), "m", N_("radius of the friction circle of the crankpin")),
    _of("rho_wrist", Symbol("rho", "3"), "m", N_("radius of the friction circle of the wrist pin")),
    _of("beta", Symbol("beta"), "deg", N_("angle of the connecting rod with the stroke")),
    _of("tau", Symbol("tau"), "deg", N_("angle of the force in the rod with the stroke")),
    _of("M_ideal", Symbol("M", IDEAL), "N·m", N_("moment on the crank without friction")),
    _of("M_crank", Symbol("M"), "N·m", N_("moment on the crank with friction")),
    ETA,
)
TERMS = {
    "incline": INCLINE, "wedge": WEDGE, "sliders": SLIDERS, "trial": TRIAL, "screw": SCREW, "pivot": PIVOT,
    "belt": BELT, "belt_drive": BELT_DRIVE, "wheel": WHEEL, "journal": JOURNAL, "crank": CRANK,
}  # fmt: skip
