"""Single values of the vibration: of the machine on its isolators, of the excitation, of each way to quieten it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from tmm_report.chapters.machine.vibration.solve import Found, G
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import math_symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.records import dataclass

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


@dataclass(frozen=True)
class Units:
    """Of a machine that moves along a line or a disc that swings: units, `letters` of mass, place and force."""

    mass: str
    stiffness: str
    damping: str
    force: str
    place: str
    speed: str
    letters: tuple[str, str, str]

    @property
    def x(self) -> str:
        """Letter of the displacement."""
        return self.letters[1]

    @property
    def F(self) -> str:
        """Letter of a force."""
        return self.letters[2]


LINEAR = Units("kg", "N/m", "N·s/m", "N", "m", "m/s", ("m", "x", "F"))
TURNING = Units("kg·m²", "N·m/rad", "N·m·s/rad", "N·m", "rad", "rad/s", ("J", "theta", "M"))

# key -> symbol, in which {m}, {x}, {F} are the letters of `Units`; unit, a field of `Units` or itself; meaning
QUANTITIES = {
    "inertia": ("{m}", "mass", N_("mass of the machine")),
    "isolators": ("i", "", N_("number of isolators")),
    "stiffness_each": ("c_1", "stiffness", N_("stiffness of one isolator")),
    "stiffness": ("c", "stiffness", N_("stiffness of all the isolators")),
    "damping_each": ("b_1", "damping", N_("damping of one isolator")),
    "damping": ("b", "damping", N_("damping of all the isolators")),
    "natural": ("omega_0", "rad/s", N_("natural frequency without damping")),
    "decay": ("n", "rad/s", N_("coefficient of damping")),
    "zeta": ("zeta", "", N_("damping ratio")),
    "damped": ("omega_d", "rad/s", N_("frequency of the free damped motion")),
    "g": ("g", "m/s²", N_("acceleration of free fall")),
    "sag": ("delta_st", "m", N_("deflection of the isolators under the weight")),
    "omega": ("omega", "rad/s", N_("frequency of the excitation")),
    "direction": ("alpha", "rad", N_("angle of the motion of the machine from the x axis")),
    "unbalance": ("m_e", "kg", N_("mass of the unbalance")),
    "radius": ("e", "m", N_("distance of the unbalance from the axis")),
    "base": ("z_0", "place", N_("amplitude of the motion of the base")),
    "force": ("{F}", "force", N_("amplitude of the exciting force")),
    "place": ("{x}_0", "place", N_("displacement at the start")),
    "speed": ("v_0", "speed", N_("velocity at the start")),
    "root": ("q", "rad/s", N_("coefficient of the motion that does not swing")),
    "C1": ("C_1", "place", N_("constant of the free motion, by the displacement at the start")),
    "C2": ("C_2", "place", N_("constant of the free motion, by the velocity at the start")),
    "eta": ("eta", "", N_("ratio of the frequency of the excitation to the natural one")),
    "static": ("{x}_st", "place", N_("deflection under the force at rest")),
    "beta": ("beta", "", N_("dynamic coefficient, amplitude by the static deflection")),
    "lag": ("psi", "rad", N_("angle by which the motion lags behind the force")),
    "ratio": ("gamma_F", "", N_("force ratio: force on the base by the exciting force")),
    "ratio_z": ("gamma_z", "", N_("ratio of the amplitudes of the machine and of the moving base")),
    "amplitude": ("A", "place", N_("amplitude of the machine")),
    "on_base": ("{F}_base", "force", N_("amplitude of the force on the base")),
    "on_base_each": ("{F}_1", "force", N_("amplitude of the force of one isolator")),
    "eta_peak": ("eta_max", "", N_("frequency ratio at which the dynamic coefficient is greatest")),
    "beta_peak": ("beta_max", "", N_("greatest dynamic coefficient")),
    "eta_most": ("eta_A", "", N_("frequency ratio at which the amplitude is greatest")),
    "resonance": ("omega_reson", "rad/s", N_("frequency of the excitation at resonance")),
    "growth": ("A_cyc", "place", N_("growth of the amplitude with every cycle of the resonance")),
    "period": ("t_c", "s", N_("period of the free damped motion")),
    "decrement": ("Lambda", "", N_("logarithmic decrement")),
    "falls": ("k", "", N_("ratio of two amplitudes that follow one another in a period")),
    "begins": ("A_0", "place", N_("amplitude of the free motion at the start")),
    "wanted": ("gamma_want", "", N_("force ratio wanted")),
    "half": ("p", "", N_("half the coefficient of the equation of the frequency ratio")),
    "needed": ("eta_want", "", N_("frequency ratio needed")),
    "needed_stiffness": ("c_want", "stiffness", N_("greatest stiffness that gives the wanted ratio")),
    "most_damping": (
        "zeta_max",
        "",
        N_("greatest damping ratio that gives the wanted ratio at this stiffness"),
    ),
    "friction": ("{F}_fr", "force", N_("dry friction in place of the dampers")),
    "dry": ("A_dry", "place", N_("amplitude with dry friction")),
    "equivalent": ("k_eq", "damping", N_("damping that takes the same work as the dry friction")),
    "dry_exact": ("A_ex", "place", N_("amplitude with dry friction by the motion in closed form")),
    "base_inertia": ("{m}_base", "mass", N_("mass of the base")),
    "base_stiffness": ("c_base", "stiffness", N_("stiffness under the base")),
    "base_damping": ("b_base", "damping", N_("damping under the base")),
    "pair_low": ("omega_I", "rad/s", N_("lower natural frequency of the machine on its base")),
    "pair_high": ("omega_II", "rad/s", N_("higher natural frequency of the machine on its base")),
    "pair_half": ("h", "rad²/s²", N_("mean of the squares of both natural frequencies")),
    "pair_machine": ("A_1", "place", N_("amplitude of the machine on the base that gives way")),
    "pair_base": ("A_base", "place", N_("amplitude of the base")),
    "gamma": ("gamma", "", N_("ratio of the amplitudes of the machine and of its base")),
    "gamma_ground": ("gamma_footing", "", N_("force on the ground by the exciting force")),
    "mu": ("mu", "", N_("mass of the absorber by that of the machine")),
    "absorber": ("{m}_a", "mass", N_("mass of the absorber")),
    "absorber_stiffness": ("c_a", "stiffness", N_("stiffness of the absorber's springs")),
    "absorber_springs": ("i_a", "", N_("number of springs of the absorber")),
    "absorber_each": ("c_a,1", "stiffness", N_("stiffness of one spring of the absorber")),
    "absorber_arm": ("r_a", "m", N_("arm of the absorber's springs")),
    "absorber_swing": ("A_a", "place", N_("amplitude of the absorber")),
    "split_low": ("omega_I,a", "rad/s", N_("lower natural frequency with the absorber")),
    "split_high": ("omega_II,a", "rad/s", N_("higher natural frequency with the absorber")),
    "split_half": ("h_a", "rad²/s²", N_("mean of the squares of both natural frequencies with the absorber")),
    "best_natural": ("omega_a", "rad/s", N_("own frequency of the absorber with the best damping")),
    "best_ratio": ("zeta_a", "", N_("best damping ratio of the absorber")),
    "lanchester_ratio": ("zeta_L", "", N_("best damping ratio of a damper without a spring")),
    "order": ("k", "", N_("order of the harmonic that is followed in full")),
    "shaft": ("omega_1", "rad/s", N_("angular velocity of the driving link")),
    "force_most": ("F_max", "N", N_("greatest shaking force")),
    "moved_most": ("x_max", "m", N_("greatest displacement of the machine")),
    "handed_most": ("F_base,max", "N", N_("greatest force on the base")),
}
TURNED = {  # what a disc calls otherwise
    "inertia": N_("moment of inertia of the disc"),
    "stiffness": N_("stiffness of the shaft"),
    "damping": N_("damping of the shaft"),
    "amplitude": N_("amplitude of the disc"),
    "mu": N_("moment of inertia of the absorber by that of the disc"),
    "force": N_("amplitude of the exciting moment"),
    "static": N_("angle under the moment at rest"),
    "on_base": N_("amplitude of the moment on the base"),
    "base_inertia": N_("moment of inertia of the base"),
    "absorber": N_("moment of inertia of the absorber"),
}


OF_BASE = {  # what a moving base calls otherwise
    "lag": N_("angle by which the motion lags behind that of the base"),
    "wanted": N_("ratio of the amplitudes wanted"),
}
OF_SHAFT = {  # and what a shaft that turns
    "resonance": N_("speed of the shaft at which there is resonance"),
}


def units(found: Found) -> Units:
    return TURNING if found.given.turning else LINEAR


def quantity(found: Found, key: str, prefix: str = "vibration_") -> Quantity:
    """A number of the machine; `prefix` "": as a column."""
    symbol, unit, text = QUANTITIES[key]
    of = units(found)
    text = TURNED.get(key, text) if found.given.turning else text
    text = OF_BASE.get(key, text) if found.given.base is not None else text
    text = OF_SHAFT.get(key, text) if found.grows else text
    sign = math_symbol(symbol.format(m=of.letters[0], x=of.x, F=of.F))
    return Quantity(f"{prefix}{key}", sign, getattr(of, unit, unit), Message(text))


@tabulated
def values(found: Found) -> Iterator[Value]:
    parts = (_body, _excitation, _steady, _wanted, _dry, _stood, _absorber, _shaken)
    for part in (_body, _free) if found.given.free else parts:
        for key, number in part(found):
            if number is not None:
                yield quantity(found, key).value(float(number))
    hung = found.given.absorber
    if (
        found.absorbed is not None and hung is not None
    ):  # a spring at an arm is straight, whatever it hangs on
        each = quantity(found, "absorber_each")
        unit = "N/m" if hung.arm is not None else each.unit
        yield Quantity(each.key, each.symbol, unit, each.meaning).value(found.absorbed.each)


Numbers = Iterator[tuple[str, float | None]]


def _body(found: Found) -> Numbers:
    given, body = found.given, found.body
    yield "inertia", body.inertia
    yield "isolators", given.isolators
    yield "stiffness_each", body.stiffness / given.isolators
    yield "stiffness", body.stiffness
    yield "damping_each", body.damping / given.isolators
    yield "damping", body.damping
    yield "natural", found.natural
    yield "decay", found.decay
    yield "zeta", found.zeta
    yield "damped", found.damped
    yield "g", None if given.turning else G
    yield "sag", found.sag


def _free(found: Found) -> Numbers:
    yield "place", found.given.place
    yield "speed", found.given.speed
    yield from _constants(found)
    yield "period", found.period
    yield "decrement", found.decrement
    yield "falls", None if found.decrement is None else math.exp(found.decrement)
    yield "begins", found.begins


def _constants(found: Found) -> Numbers:
    yield "root", found.creep
    yield "C1", found.constants[0]
    yield "C2", found.constants[1]


def _excitation(found: Found) -> Numbers:
    given = found.given
    yield "omega", found.omega
    yield "direction", None if given.direction is None else cmath.phase(given.direction)
    if given.unbalance is not None:
        yield "unbalance", given.unbalance.mass
        yield "radius", given.unbalance.radius
    yield "base", given.base
    yield "force", None if given.base is not None else found.force
    yield "place", given.place
    yield "speed", given.speed


def _steady(found: Found) -> Numbers:
    still = found.given.base is None
    yield "eta", found.eta
    if found.unbounded:
        yield "static", found.static
        yield "growth", found.growth
        yield "resonance", found.natural
        return
    if still:
        yield "static", found.static
        yield "beta", found.amplitude / found.static
    yield "lag", found.lag
    yield ("ratio" if still else "ratio_z"), found.ratio
    yield "amplitude", found.amplitude
    yield "on_base", found.on_base
    yield "on_base_each", found.on_base / found.given.isolators
    if 0 < found.zeta < 2**-0.5:
        yield "eta_peak", found.peak[0]
        yield "beta_peak", found.peak[1]
    yield "eta_most", found.most
    yield "resonance", found.natural / found.order
    if found.shaking is None:
        yield from _constants(found)


def _wanted(found: Found) -> Numbers:
    yield "wanted", found.given.wanted
    yield "half", found.half
    yield "needed", found.needed
    yield "needed_stiffness", found.needed_stiffness
    yield "most_damping", found.most_damping


def _dry(found: Found) -> Numbers:
    yield "friction", found.given.friction
    yield "dry", found.dry
    yield "equivalent", found.equivalent
    yield "dry_exact", found.dry_exact


def _stood(found: Found) -> Numbers:
    stood = found.stood
    if stood is None:
        return
    yield "base_inertia", stood.base.inertia
    yield "base_stiffness", stood.base.stiffness
    yield "base_damping", stood.base.damping
    yield "pair_low", stood.natural[0]
    yield "pair_high", stood.natural[1]
    yield "pair_half", (stood.natural[0] ** 2 + stood.natural[1] ** 2) / 2
    yield "pair_machine", found.force * abs(stood.machine)
    yield "pair_base", found.force * abs(stood.under)
    yield "gamma", stood.ratio
    yield "gamma_ground", stood.grounded


def _absorber(found: Found) -> Numbers:
    hung, stated = found.absorbed, found.given.absorber
    if hung is None or stated is None:
        return
    yield "mu", hung.mu
    yield "absorber", hung.tuned.hung.inertia
    yield "absorber_stiffness", hung.tuned.hung.stiffness
    yield "absorber_springs", stated.springs
    yield "absorber_arm", stated.arm
    yield "absorber_swing", found.force * hung.tuned.swing
    yield "split_low", hung.natural[0]
    yield "split_high", hung.natural[1]
    yield "split_half", (hung.natural[0] ** 2 + hung.natural[1] ** 2) / 2
    yield "best_natural", hung.fitted[1].natural
    yield "best_ratio", hung.fitted[1].ratio
    damper = hung.fitted[2].hung
    yield "lanchester_ratio", damper.damping / (2 * damper.inertia * found.natural)


def _shaken(found: Found) -> Numbers:
    shaken = found.shaking
    if shaken is None or shaken.moved is None or shaken.handed is None:
        return
    yield "order", found.order
    yield "shaft", shaken.omega
    yield "force_most", abs(shaken.force).max()
    yield "moved_most", abs(shaken.moved).max()
    yield "handed_most", abs(shaken.handed).max()
