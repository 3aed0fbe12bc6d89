"""Exact single numbers of machines without a lever mechanism: their closed formulas, roots and integrals in 40 digits.

Each is written from what the variant states, by another way than the program's own where there is one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from tmm_report.chapters.machine.contacts.given import Screw
from tmm_report.chapters.machine.efficiency.given import Module
from tmm_report.chapters.machine.governor.given import Choose
from tmm_report.course import Results
from tmm_report.mechanics.machine.characteristics import Kloss, Series
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.mechanics.rivals.exact.numbers import Number, context
from tmm_report.mechanics.rivals.exact.numbers import exact as number

Named = Iterator[tuple[str, Number]]


def machines(results: Results) -> Named:
    """Key of a single value of results.json and its exact number."""
    of = results.variant
    for given, name in (
        (of.efficiency, _efficiency), (of.rotor, _rotor), (of.engine, _engine), (of.vibration, _vibration),
        (of.contacts, _contacts), (_sought(results), _governor), (of.dynamics, _dynamics), (of.flywheel, _flywheel),
    ):  # fmt: skip
        if given is not None:
            yield from name(given)


# ---------------------------------------------------------------- efficiency, contacts


def _efficiency(given: Any) -> Named:
    whole = _eta(given.tree)
    yield "eta_whole", whole
    yield "psi_whole", 1 - whole
    if given.input is not None:
        yield "P_out_whole", number(given.input) * whole


def _eta(part: Any) -> Number:
    """Of parts in series the product; in parallel by their shares of the input or of the output."""
    if isinstance(part, Module):
        return number(part.efficiency)
    own = context()
    inner = [_eta(one) for one in part.parts]
    if part.kind == "series":
        return own.fprod(inner)
    shares = [number(one.share) for one in part.parts]
    if part.by == "input":
        return own.fsum(share * eta for share, eta in zip(shares, inner, strict=True))
    return 1 / own.fsum(share / eta for share, eta in zip(shares, inner, strict=True))


def _contacts(given: Any) -> Named:
    """Efficiency of screws with a square thread and no collar: tan ψ/tan(ψ + ρ)."""
    own = context()
    for k, contact in enumerate(given.items, 1):
        if isinstance(contact, Screw) and not contact.profile and contact.collar is None:
            rise = own.atan(number(contact.pitch) * contact.starts / (own.pi * number(contact.diameter)))
            rough = own.atan(number(contact.f))
            yield f"contacts_{k}_eta", own.tan(rise) / own.tan(rise + rough)


# ---------------------------------------------------------------- rotor, engine


def _rotor(given: Any) -> Named:
    own = context()
    first, last = (number(plane.at) for plane in given.planes)
    turned = [number(one.product) * own.expj(number(one.angle)) for one in given.heavy]
    couples = [own.mpc(one.couple.real, one.couple.imag) for one in given.heavy]
    D = own.fsum(turned)
    M = own.fsum(
        z * (number(one.at) - first) + couple
        for z, one, couple in zip(turned, given.heavy, couples, strict=True)
    )
    yield "rotor_D_x", D.real
    yield "rotor_D_y", D.imag
    yield "rotor_D", abs(D)
    yield "rotor_alpha", own.arg(D) * 180 / own.pi % 360
    yield "rotor_M_x", M.real
    yield "rotor_M_y", M.imag
    yield "rotor_M", abs(M)
    yield "rotor_L", last - first
    yield "rotor_e", abs(D) / number(given.mass)
    yield "rotor_D_per", number(given.mass) * number(given.grade) / 1000 / number(given.speed)


def _engine(given: Any) -> Named:
    r, l, rod, at = (
        number(x) for x in (given.crank_radius, given.rod_length, given.rod.mass, given.rod.centre)
    )
    moving = number(given.reciprocating) + rod * at / l
    yield "engine_m", moving
    yield "engine_m_rot", number(given.rotating) + rod * (l - at) / l
    yield "engine_lambda", r / l
    yield "engine_unit", moving * r * number(given.speed) ** 2


# ---------------------------------------------------------------- vibration


def _vibration(given: Any) -> Named:
    if given.transmissibility is None or given.shaken is None:
        return
    own = context()
    m, omega = number(given.inertia), number(given.speed)
    zeta, wanted = number(given.damping_ratio), number(given.transmissibility)
    q = own.polyroots(
        [wanted**2, -2 * wanted**2 + 4 * zeta**2 * (wanted**2 - 1), wanted**2 - 1],
        maxsteps=200,
        extraprec=200,
    )[-1].real  # (1 + 4ζ²q)/((1 − q)² + 4ζ²q) = T², q = η²
    natural, eta = omega / own.sqrt(q), own.sqrt(q)
    c, force = m * natural**2, number(given.shaken)
    beta = 1 / own.sqrt((1 - q) ** 2 + 4 * zeta**2 * q)
    yield "vibration_needed", eta
    yield "vibration_natural", natural
    yield "vibration_stiffness", c
    yield "vibration_stiffness_each", c / given.isolators
    yield "vibration_damping", 2 * zeta * m * natural
    yield "vibration_decay", zeta * natural
    yield "vibration_damped", natural * own.sqrt(1 - zeta**2)
    yield "vibration_sag", m * number(9.81) / c
    yield "vibration_static", force / c
    yield "vibration_beta", beta
    yield "vibration_lag", own.atan2(2 * zeta * eta, 1 - q)
    yield "vibration_amplitude", force / c * beta
    yield "vibration_on_base", force * wanted
    yield "vibration_eta_peak", own.sqrt(1 - 2 * zeta**2)
    yield "vibration_beta_peak", 1 / (2 * zeta * own.sqrt(1 - zeta**2))
    if given.foundation is not None:
        base, below = number(given.foundation.inertia), number(given.foundation.stiffness)
        low, high = sorted(
            root.real
            for root in own.polyroots(
                [base * m, -(base * c + m * (below + c)), below * c], maxsteps=200, extraprec=200
            )
        )
        yield "vibration_pair_low", own.sqrt(low)
        yield "vibration_pair_high", own.sqrt(high)
    if given.absorber is not None:
        mu = number(given.absorber.inertia) / m
        yield "vibration_mu", mu
        yield "vibration_absorber_stiffness", number(given.absorber.inertia) * omega**2
        yield "vibration_best_natural", natural / (1 + mu)
        yield "vibration_best_ratio", own.sqrt(3 * mu / (8 * (1 + mu)))
        yield "vibration_lanchester_ratio", 1 / own.sqrt(2 * (1 + mu) * (2 + mu))


# ---------------------------------------------------------------- governors


def _sought(results: Results) -> Any:
    """The governor; one whose spring is asked backwards for two speeds, as one that chooses it for them."""
    governor, asked = results.variant.governor, results.find
    if (
        governor is None
        or asked is None
        or [one.name for one in asked.given.demands] != ["omega_0", "omega_h"]
    ):
        return governor
    return replace(governor, choose=Choose(spring=asked.levels), spring=None)


def _governor(given: Any) -> Named:
    """Speeds of equilibrium in the lowest and highest positions, or the spring that two speeds ask for; of a brake on
    arms that stands alone the force of its spring at rest and the speed of contact."""
    if not given.centrifugal:
        yield from _brake(given.brake)
        return
    own, geometry = context(), given.geometry
    weights, low = given.weights, number(given.lowest)
    pull, sleeve = weights.count * number(weights.ball), number(weights.sleeve) * number(weights.gravity)
    weight = pull * number(weights.gravity)
    if isinstance(geometry, Arms) and given.choose is None and not geometry.upper_offset:
        ends = []
        for x in (low, number(given.highest)):
            upper = x / own.sqrt(number(geometry.upper) ** 2 - x**2)
            away = x - number(geometry.lower_offset)
            lower = away / own.sqrt(number(geometry.lower) ** 2 - away**2)
            ends.append(own.sqrt((weight * upper + sleeve * (upper + lower)) / (pull * x)))
        yield "governor_omega_0", ends[0]
        yield "governor_omega_h", ends[1]
        yield "governor_delta", 2 * (ends[1] - ends[0]) / (ends[1] + ends[0])
    elif isinstance(geometry, BellCrank) and not geometry.level and given.choose is not None:
        ratio = number(geometry.ball_arm) / number(geometry.sleeve_arm)
        pressed = []
        for lift, speed in zip((number(0), number(given.lift)), given.choose.spring, strict=True):
            r = low + ratio * lift
            lean = own.asin((r - number(geometry.fulcrum)) / number(geometry.ball_arm))
            held = -weight * ratio * own.tan(lean) + sleeve
            pressed.append(pull * r * ratio * number(speed) ** 2 - held)
        yield "governor_F_0", pressed[0]
        yield "governor_c", (pressed[1] - pressed[0]) / number(given.lift)


def _brake(of: Any) -> Named:
    """M_b = n f N R, N (l_N ∓ f l_T) = (m ρ ω² l_C − F l_F), whose spring is chosen for a speed."""
    own, arm = context(), of.arm
    a, f, drum = number(arm.pivot), number(of.friction), number(of.drum)
    at_c, at_n = a * own.sin(number(arm.mass_centre)), a * own.sin(number(arm.shoe))
    side = -1 if arm.ahead == "shoe" else 1
    closes = at_n + side * f * (drum - a * own.cos(number(arm.shoe)))
    swing = number(of.gap) / at_n
    mass = number(of.mass) * (number(of.radius) + swing * at_c)
    normal = number(of.moment) / (of.count * f * drum)
    held = (mass * number(of.choose.spring) ** 2 * at_c - normal * closes) / number(arm.spring)
    yield "governor_brake_F_0", held - number(of.spring.stiffness) * swing * number(arm.spring)
    yield "governor_brake_contact", own.sqrt(held * number(arm.spring) / (mass * at_c))
    yield "governor_brake_pressing", normal


# ---------------------------------------------------------------- start-up and run-down, flywheel


def _dynamics(given: Any) -> Named:
    """Steady speed as a root, times and angles as integrals J dω/M and J ω dω/M: where all moments are of the speed."""
    law = getattr(given.motor, "law", None)
    if given.springs or given.varying or given.passing or not isinstance(law, Kloss | Series):
        return
    own = context()
    J = own.fsum(
        number(p.inertia) * number(p.ratio) ** 2 + number(p.mass) * number(p.arm) ** 2 for p in given.parts
    )
    load = own.fsum(_part(p, number(given.gravity)) for p in given.parts)
    drives = _kloss(law) if isinstance(law, Kloss) else _series(law)

    def resists(w: Number) -> Number:
        fans = (number(one.law.moment) * (w / number(one.law.speed)) ** 2 for one in given.resistances)
        return load + own.fsum(fans)

    top = number(law.synchronous) if isinstance(law, Kloss) else 4 * number(law.b)
    steady = own.findroot(
        lambda w: drives(w) - resists(w), (0.9 * top, top * 0.999), solver="anderson", tol=1e-80
    )
    yield "dynamics_J_parts", J
    yield "dynamics_M_parts", load
    yield "dynamics_omega_m", steady
    yield "dynamics_M_steady", resists(steady)
    yield "dynamics_P", resists(steady) * steady
    yield "dynamics_T_steady", J * steady**2 / 2
    arrived = steady * (1 - number(given.start.within))
    yield "dynamics_omega_start", arrived
    yield from _run("start", lambda w: (drives(w) - resists(w)) / J, own.mpf(0), arrived)
    brake = number(given.coast.brake or 0)
    yield from _run("coast", lambda w: -(resists(w) + brake) / J, steady, number(given.coast.speed))


def _run(name: str, rate: Callable[[Number], Number], begin: Number, end: Number) -> Named:
    """Time and angle from one speed to another with the angular acceleration `rate`."""
    own = context()
    pieces = own.linspace(begin, end, 9)
    yield f"dynamics_t_{name}", own.quad(lambda w: 1 / rate(w), pieces)
    yield f"dynamics_phi_{name}", own.quad(lambda w: w / rate(w), pieces)


def _part(part: Any, gravity: Number) -> Number:
    """Resisting moment of a part on the main shaft: what is lifted takes more through the losses, what sinks gives less
    back."""
    eta, lifted = number(part.efficiency), part.moves * number(part.mass) * gravity * number(part.arm)
    against = number(part.moment) * number(part.ratio) + number(part.force) * number(part.arm)
    return against / eta + (lifted / eta if part.moves > 0 else lifted * eta)


def _kloss(law: Kloss) -> Callable[[Number], Number]:
    def moment(w: Number) -> Number:
        s, m, a = 1 - w / number(law.synchronous), number(law.critical), number(law.a)
        return 2 * number(law.greatest) * (1 + a * m) / (s / m + m / s + 2 * a * m)

    return moment


def _series(law: Series) -> Callable[[Number], Number]:
    return lambda w: number(law.a) / (w + number(law.b)) ** 2


def _flywheel(given: Any) -> Named:
    """Works of a resisting moment by straight lines over the cycle, against the constant moment that closes it."""
    if given.resisting is None or given.resisting.table is None or given.driving is not None:
        return
    own = context()
    x, y = ([number(one) for one in row] for row in zip(*given.resisting.table, strict=True))
    cycle = 2 * own.pi * (given.turns or 1)
    area = own.fsum((b - a) * (u + v) / 2 for a, b, u, v in zip(x, x[1:], y, y[1:], strict=False))
    mean = area / cycle
    done, works = own.mpf(0), [own.mpf(0)]
    for a, b, u, v in zip(x, x[1:], y, y[1:], strict=False):
        if (u - mean) * (v - mean) < 0:  # extreme within the stretch
            part = (mean - u) / (v - u) * (b - a)
            works.append(done + part * (mean - u) / 2)
        done += (b - a) * (mean - (u + v) / 2)
        works.append(done)
    yield "flywheel_W", area
    yield "flywheel_M_m", mean
    yield "flywheel_A_max", max(works)
    yield "flywheel_A_min", min(works)
    yield "flywheel_A_ex", max(works) - min(works)
