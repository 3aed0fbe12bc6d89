"""Single values of the vibration: of the machine on its isolators, of the excitation, of each way to quieten it."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet

BASE = NP_("index", "base")
WORDS = (
    NP_("index", "footing"),
    NP_("index", "st"),
    NP_("index", "eq"),
    NP_("index", "ex"),
    NP_("index", "dry"),
    NP_("index", "reson"),
    NP_("index", "want"),
)


class Values(Sheet, prefix="vibration"):
    inertia = Q("m", "kg", N_("mass of the machine"))
    isolators = Q("i", "", N_("number of isolators"))
    stiffness_each = Q("c_1", "N/m", N_("stiffness of one isolator"))
    stiffness = Q("c", "N/m", N_("total stiffness of the isolators"))
    damping_each = Q("b_1", "N·s/m", N_("damping of one isolator"))
    damping = Q("b", "N·s/m", N_("total damping coefficient of the isolators"))
    natural = Q("omega_0", "rad/s", N_("natural frequency without damping"))
    decay = Q("n", "rad/s", N_("decay constant"))
    zeta = Q("zeta", "", N_("damping ratio"))
    damped = Q("omega_d", "rad/s", N_("frequency of the free damped motion"))
    g = Q("g", "m/s²", N_("acceleration due to gravity"))
    sag = Q("delta_st", "m", N_("deflection of the isolators under the weight"))
    deflection = Q("delta_st", "m", N_("deflection of the isolators under the weight"), "mm")
    omega = Q("omega", "rad/s", N_("frequency of the excitation"))
    direction = Q("alpha", "rad", N_("angle of the motion of the machine from the x axis"), "deg")
    unbalance = Q("m_e", "kg", N_("mass of the unbalance"))
    radius = Q("e", "m", N_("distance of the unbalance from the axis"), "mm")
    base = Q("z_0", "m", N_("amplitude of the motion of the base"), "mm")
    force = Q("F", "N", N_("amplitude of the exciting force"))
    place = Q("x_0", "m", N_("displacement at the start"), "mm")
    speed = Q("v_0", "m/s", N_("velocity at the start"))
    root = Q("q", "rad/s", N_("coefficient of the motion that does not swing"))
    C1 = Q("C_1", "m", N_("constant of the free motion, by the displacement at the start"))
    C2 = Q("C_2", "m", N_("constant of the free motion, by the velocity at the start"))
    eta = Q("eta", "", N_("ratio of the frequency of the excitation to the natural one"))
    static = Q("x_st", "m", N_("deflection under the force at rest"))
    beta = Q("beta", "", N_("magnification factor, ratio of the amplitude to the static deflection"))
    lag = Q("psi", "rad", N_("angle by which the motion lags behind the force"), "deg")
    ratio = Q("gamma_F", "", N_("transmissibility, ratio of the force on the base to the exciting force"))
    ratio_z = Q("gamma_z", "", N_("ratio of the amplitudes of the machine and of the moving base"))
    amplitude = Q("A", "m", N_("amplitude of the machine"), "mm")
    on_base = Q("F_base", "N", N_("amplitude of the force on the base"))
    on_base_each = Q("F_1", "N", N_("amplitude of the force of one isolator"))
    eta_peak = Q("eta_max", "", N_("frequency ratio at which the magnification factor is greatest"))
    beta_peak = Q("beta_max", "", N_("greatest magnification factor"))
    eta_most = Q("eta_A", "", N_("frequency ratio at which the amplitude is greatest"))
    resonance = Q("omega_reson", "rad/s", N_("frequency of the excitation at resonance"))
    growth = Q("A_cyc", "m", N_("growth of the amplitude with every cycle of the resonance"))
    period = Q("t_c", "s", N_("period of the free damped motion"))
    decrement = Q("Lambda", "", N_("logarithmic decrement"))
    falls = Q("k", "", N_("ratio of two amplitudes that follow one another in a period"))
    begins = Q("A_0", "m", N_("amplitude of the free motion at the start"))
    wanted = Q("gamma_want", "", N_("required transmissibility"))
    half = Q("p", "", N_("half the coefficient of the equation of the frequency ratio"))
    needed = Q("eta_want", "", N_("frequency ratio needed"))
    needed_stiffness = Q("c_want", "N/m", N_("greatest stiffness that gives the wanted ratio"))
    most_damping = Q(
        "zeta_max", "", N_("greatest damping ratio that gives the wanted ratio at this stiffness")
    )
    friction = Q("F_fr", "N", N_("dry friction in place of the dampers"))
    dry = Q("A_dry", "m", N_("amplitude with dry friction"))
    equivalent = Q("k_eq", "N·s/m", N_("damping coefficient that takes the same work as the dry friction"))
    dry_exact = Q("A_ex", "m", N_("amplitude with dry friction by the motion in closed form"), "mm")
    base_inertia = Q("m_base", "kg", N_("mass of the base"))
    base_stiffness = Q("c_base", "N/m", N_("stiffness under the base"))
    base_damping = Q("b_base", "N·s/m", N_("damping coefficient under the base"))
    pair_low = Q("omega_I", "rad/s", N_("lower natural frequency of the machine on its base"))
    pair_high = Q("omega_II", "rad/s", N_("higher natural frequency of the machine on its base"))
    pair_half = Q("h", "rad²/s²", N_("mean of the squares of both natural frequencies"))
    pair_machine = Q("A_1", "m", N_("amplitude of the machine on the flexible base"), "mm")
    pair_base = Q("A_base", "m", N_("amplitude of the base"), "mm")
    gamma = Q("gamma", "", N_("ratio of the amplitudes of the machine and of its base"))
    gamma_ground = Q("gamma_footing", "", N_("ratio of the force on the ground to the exciting force"))
    mu = Q("mu", "", N_("ratio of the mass of the absorber to that of the machine"))
    absorber = Q("m_a", "kg", N_("mass of the absorber"))
    absorber_stiffness = Q("c_a", "N/m", N_("stiffness of the absorber's springs"), "kN/m")
    absorber_springs = Q("i_a", "", N_("number of springs of the absorber"))
    absorber_each = Q("c_a,1", "N/m", N_("stiffness of one spring of the absorber"))
    absorber_arm = Q("r_a", "m", N_("arm of the absorber's springs"), "mm")
    absorber_swing = Q("A_a", "m", N_("amplitude of the absorber"), "mm")
    split_low = Q("omega_I,a", "rad/s", N_("lower natural frequency with the absorber"))
    split_high = Q("omega_II,a", "rad/s", N_("higher natural frequency with the absorber"))
    split_half = Q("h_a", "rad²/s²", N_("mean of the squares of both natural frequencies with the absorber"))
    best_natural = Q("omega_a", "rad/s", N_("natural frequency of the absorber with the best damping"))
    best_ratio = Q("zeta_a", "", N_("best damping ratio of the absorber"))
    lanchester_ratio = Q("zeta_L", "", N_("best damping ratio of a damper without a spring"))
    order = Q("k", "", N_("order of the harmonic that is followed in full"))
    shaft = Q("omega_1", "rad/s", N_("angular velocity of the driving link"))
    force_most = Q("F_max", "N", N_("greatest shaking force"))
    moved_most = Q("x_max", "m", N_("greatest displacement of the machine"), "mm")
    handed_most = Q("F_base,max", "N", N_("greatest force on the base"))

    # of tables alone
    t = Q("t", "s", N_("time"))
    x = Q("x", "m", N_("displacement of the machine"), "mm")
    x_steady = Q("x_s", "m", N_("the steady part of the displacement"), "mm")
    swing = Q("i", "", N_("number of whole periods"))
    size = Q("A_i", "m", N_("amplitude of the free motion"), "mm")
    absorber_damping = Q("b_a", "N·s/m", N_("damping of the absorber"))


class OverTurn(Sheet):
    """Under the mechanism's own force."""

    phi = Q("phi", "rad", N_("angle turned from position 0"))
    force = Q("F", "N", N_("shaking force of the mechanism"))
    x = Q("x", "m", N_("displacement of the machine"), "mm")
    on_base = Q("F_base", "N", N_("force that the isolators transmit to the base"))


class Harmonics(Sheet):
    order = Q("k", "", N_("order of the harmonic"))


# --- a disc that swings: other letters and units, degrees for millimetres, and words of its own

LETTERS = {"m": "J", "x": "theta", "F": "M"}
UNITS = {
    "kg": "kg·m²", "N/m": "N·m/rad", "N·s/m": "N·m·s/rad", "N": "N·m", "m": "rad", "m/s": "rad/s",
}  # fmt: skip
STRAIGHT = (
    "sag",
    "deflection",
    "radius",
    "absorber_arm",
    "unbalance",
    "force_most",
    "moved_most",
    "handed_most",
)
NOUNS = {
    "inertia": N_("moment of inertia of the disc"),
    "stiffness": N_("stiffness of the shaft"),
    "damping": N_("damping of the shaft"),
    "amplitude": N_("amplitude of the disc"),
    "force": N_("amplitude of the exciting moment"),
    "static": N_("angle under the moment at rest"),
    "on_base": N_("amplitude of the moment on the base"),
    "base_inertia": N_("moment of inertia of the base"),
    "absorber": N_("moment of inertia of the absorber"),
}


def _turned(key: str, of: Q) -> Q:
    assert of.symbol is not None
    letter = replace(of.symbol, base=LETTERS.get(of.symbol.base, of.symbol.base))
    unit, noun = UNITS.get(of.unit, of.unit), NOUNS.get(key, of.meaning)
    return Q(letter, unit, noun, "deg" if of.shown == "mm" else "", formed=unit)


TURNING = {
    key: _turned(key, of) for key, of in Values.DECLARED.items() if of.unit in UNITS and key not in STRAIGHT
}
TURNING["mu"] = Q("mu", "", N_("ratio of the moment of inertia of the absorber to that of the disc"))
OF_BASE = {  # what a moving base calls otherwise
    "lag": Q("psi", "rad", N_("angle by which the motion lags behind that of the base"), "deg"),
    "wanted": Q("gamma_want", "", N_("ratio of the amplitudes wanted")),
}
OF_SHAFT = {  # and what a shaft that turns
    "resonance": Q("omega_reson", "rad/s", N_("speed of the shaft at which there is resonance")),
}
AT_ARM = {  # a spring at an arm is straight, whatever it hangs on
    "absorber_each": Q("c_a,1", "N/m", N_("stiffness of one spring of the absorber")),
}


def sheet(turning: bool, moving_base: bool, grows: bool, at_arm: bool) -> Values:
    """The numbers of one variant, by what it calls otherwise."""
    kinds = ((turning, TURNING), (moving_base, OF_BASE), (grows, OF_SHAFT), (at_arm, AT_ARM))
    return Values({key: of for applies, kind in kinds if applies for key, of in kind.items()})
