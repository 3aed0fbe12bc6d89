"""The numbers of the forces of a cam that stands alone. Of a follower that slides forces along its lift, of one that
swings moments about its pivot."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.cams.cam.quantities import acceleration, displacement, velocity
from tmm_report.chapters.cams.cam.quantities.tables import KINDS, NUMBER, TURNED
from tmm_report.chapters.cams.cam_forces.solve import At, Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.cycle import POSITION

FORCES = Message(N_("what the follower needs, what presses it to the cam, the moment of the drive"))
ASKED = Message(N_("the same at the angles asked for"))
PHASES = Message(N_("least and greatest of the rises and returns"))
SPRINGS = Message(N_("springs that just keep the follower on the cam"))
LEAVES = Message(N_("angles over which the follower leaves the cam"))

SPRING, INERTIA, FR = NP_("index", "spr"), NP_("index", "ine"), NP_("index", "fr")
MAX, MIN, OFF, PERMITTED = NP_("index", "max"), NP_("index", "min"), NP_("index", "off"), NP_("index", "lim")
MEAN, NEED, JAM = NP_("index", "mean"), NP_("index", "need"), NP_("index", "jam")
RUBS = {
    "guide": NP_("index", "way"), "pin": NP_("index", "axle"), "face": NP_("index", "face"),
    "pivot": NP_("index", "hub"),
}  # fmt: skip

SPRING_KINDS = {
    "chosen": N_("the chosen one"),
    "constant": N_("of a constant force"),
    "half": N_("preload half of the greatest"),
    "unloaded": N_("without a preload"),
}
LOST = {
    "guide": N_("moment of the drive that the friction in the guide takes"),
    "pin": N_("moment of the drive that the friction in the roller's pin takes"),
    "face": N_("moment of the drive that the sliding on the cam takes"),
    "pivot": N_("moment of the drive that the friction in the follower's pivot takes"),
}


def _unit(found: Found) -> str:
    return "N" if found.slides else "N·m"


def _need(found: Found, key: str, letter: str, index: str, force: str, moment: str) -> Quantity:
    """A force on a sliding follower, a moment on a swinging one."""
    if found.slides:
        return Quantity(key, Symbol(letter, index), "N", Message(force))
    return Quantity(key, Symbol("M", index or letter), "N·m", Message(moment))


def load(found: Found) -> Quantity:
    return _need(
        found, "cam_load", "P", "", N_("load on the follower against its lift"),
        N_("moment of the load on the follower against its lift"),
    )  # fmt: skip


def weight(found: Found) -> Quantity:
    return _need(
        found, "cam_weight", "G", "", N_("weight of the follower against its lift"),
        N_("moment of the follower's weight against its lift"),
    )  # fmt: skip


def spring(found: Found) -> Quantity:
    return _need(found, "cam_spring", "F", SPRING, N_("force of the spring"), N_("moment of the spring"))


def inertia(found: Found) -> Quantity:
    return _need(
        found, "cam_inertia", "F", INERTIA, N_("force that the acceleration of the follower takes"),
        N_("moment that the angular acceleration of the follower takes"),
    )  # fmt: skip


def needed(found: Found) -> Quantity:
    return _need(
        found, "cam_needed", "Q", "",
        N_("force of the cam along the follower's lift; below zero the follower would have to be pulled"),
        N_("moment of the cam about the follower's pivot; below zero the follower would have to be pulled"),
    )  # fmt: skip


def normal() -> Quantity:
    text = N_(
        "force of the cam on the follower along the common normal, below zero where it would have to pull"
    )
    return Quantity("cam_N", Symbol("N"), "N", Message(text))


SMOOTH = Quantity("cam_T0", Symbol("T", "0"), "N·m", Message(N_("moment of the drive without friction")))
TORQUE = Quantity(
    "cam_T", Symbol("T"), "N·m", Message(N_("moment of the drive of the cam, above zero where it drives"))
)
RUBBED = Quantity(
    "cam_T_fr", Symbol("T", FR), "N·m", Message(N_("moment of the drive that all friction takes"))
)
PRESSURE = Quantity("cam_sigma", Symbol("sigma"), "MPa", Message(N_("greatest pressure in the contact")))
STATE = Message(N_("whether the cam presses, the follower has left it, or it jams"))
MEGA = 1e6


def lost(name: str) -> Quantity:
    return Quantity(f"cam_T_{name}", Symbol("T", f"{FR},{RUBS[name]}"), "N·m", Message(LOST[name]))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for name, at in (("table", found.table), ("diagram", found.diagram)):
        first = POSITION.column(list(range(len(at.turned))))
        turned = TURNED.column(np.degrees(at.turned))
        yield Table(f"cam_forces_{name}", FORCES, (first, turned, *_needs(found, at), *_forces(found, at)))
    if len(found.asked.turned):
        yield Table("cam_asked", ASKED, tuple(_asked(found)))
    if found.cam.phases:
        yield Table("cam_force_ends", PHASES, tuple(_ends(found)))
    if found.springs:
        yield Table("cam_springs", SPRINGS, tuple(_springs(found)))
    if found.leaves:
        begin = Message(N_("angle turned at which the follower leaves the cam"))
        end = Message(N_("angle turned at which the force of the cam is above zero again"))
        spans = np.degrees(np.array(found.leaves))
        columns = (
            Quantity("from", Symbol("phi"), "deg", begin).column(spans[:, 0]),
            Quantity("to", Symbol("phi"), "deg", end).column(spans[:, 1]),
        )
        yield Table("cam_leaves", LEAVES, columns)


def _needs(found: Found, at: At) -> Iterator[Column]:
    for quantity, numbers, there in (
        (load(found), at.parts.load, loads(found)),
        (weight(found), at.parts.weight, found.given.weighs),
        (spring(found), at.parts.spring, springs(found)),
        (inertia(found), at.parts.inertia, bool(found.loaded.inertia)),
    ):
        if there:
            yield quantity.column(numbers)
    yield needed(found).column(at.parts.whole)


def loads(found: Found) -> bool:
    return bool(np.any(found.diagram.parts.load))


def springs(found: Found) -> bool:
    return any(found.loaded.spring) or bool(found.springs)


def _forces(found: Found, at: At) -> Iterator[Column]:
    yield normal().column(at.pressed.N)
    yield SMOOTH.column(at.pressed.smooth)
    if found.loaded.rubs.any:
        for name, power in at.pressed.lost.items():
            yield lost(name).column(power)
        yield RUBBED.column(at.pressed.wasted)
        yield TORQUE.column(at.pressed.torque)
    if at.pressure is not None:
        yield PRESSURE.column(at.pressure / MEGA)


def _asked(found: Found) -> Iterator[Column]:
    at, omega = found.asked, found.loaded.omega
    yield TURNED.column(np.degrees(at.turned))
    S, first, second = at.moved
    yield displacement(found.cam).column(S)
    if omega:
        yield velocity(found.cam).column(omega * first)
        yield acceleration(found.cam).column(omega**2 * second)
    yield from _needs(found, at)
    yield from _forces(found, at)
    yield text_column("state", STATE, at.state)


def _ends(found: Found) -> Iterator[Column]:
    phases = found.phases
    own = needed(found)
    yield NUMBER.column([one.phase + 1 for one in phases])
    kinds = [KINDS[found.cam.phases[one.phase].kind] for one in phases]
    yield text_column("phase", Message(N_("what the follower does")), kinds)
    for end, index, text, where in (
        (0, MIN, N_("least of the phase: %(of)s"), N_("angle turned at which it is least")),
        (1, MAX, N_("greatest of the phase: %(of)s"), N_("angle turned at which it is greatest")),
    ):
        suffix = ("min", "max")[end]
        for quantity, ends in (
            (own, [one.needed for one in phases]),
            (TORQUE, [one.torque for one in phases]),
        ):
            symbol = quantity.sign
            name = Symbol(symbol.base, ",".join(filter(None, (symbol.sub, index))))
            meaning = Message(text, {"of": quantity.meaning})
            numbers = [math.nan if one is None else one[end].value for one in ends]
            angles = [math.nan if one is None else math.degrees(one[end].turned) for one in ends]
            yield Quantity(f"{quantity.key}_{suffix}", name, quantity.unit, meaning).column(numbers)
            at = Quantity(f"{quantity.key}_{suffix}_at", Symbol("phi"), "deg", Message(where))
            yield at.column(angles)


def preload(found: Found, index: str = "0") -> Quantity:
    if found.slides:
        return Quantity(
            "cam_F0", Symbol("F", index), "N", Message(N_("preload of the spring in the lowest position"))
        )
    return Quantity(
        "cam_F0", Symbol("M", index), "N·m", Message(N_("preload of the spring in the lowest position"))
    )


def rate(found: Found) -> Quantity:
    text = Message(N_("rate of the spring"))
    return Quantity("cam_c", Symbol("c"), "N/m" if found.slides else "N·m/rad", text)


def _greatest(found: Found) -> Quantity:
    base = "F" if found.slides else "M"
    text = Message(
        N_("greatest force of the spring") if found.slides else N_("greatest moment of the spring")
    )
    return Quantity("cam_F_max", Symbol(base, MAX), _unit(found), text)


def _springs(found: Found) -> Iterator[Column]:
    own = found.springs
    yield text_column("kind", Message(N_("which spring it is")), [SPRING_KINDS[one.kind] for one in own])
    yield preload(found).column([one.preload for one in own])
    yield rate(found).column([one.rate for one in own])
    yield _greatest(found).column([one.greatest for one in own])


@tabulated
def values(found: Found) -> Iterator[Value]:
    loaded, given = found.loaded, found.given
    if loaded.inertia:
        yield mass(found).value(loaded.inertia)
    if springs(found):
        yield preload(found).value(loaded.spring.preload)
        yield rate(found).value(loaded.spring.rate)
    if given.spring is not None:
        text = Message(N_("reserve with which the inertia of the follower is held"))
        yield Quantity("cam_reserve", Symbol("K"), "", text).value(given.spring.reserve)
    if (guide := loaded.rubs.guide) is not None:
        yield GUIDE.value(guide.length)
        yield OVERHANG.value(guide.overhang)
        yield FRICTION.value(guide.friction)
        if not guide.lowest:
            yield JAMS.value(math.degrees(float(guide.jams_from(np.array(0.0)))))
    yield from _reached(found)
    if (off := found.lifts_off) is not None:
        yield OMEGA_OFF.value(off.value, off.at)
        yield N_OFF.value(off.value * 30 / math.pi, off.at)
    if (least := found.needed_preload) is not None:
        yield _needed_preload(found).value(least.value, least.at)


def mass(found: Found) -> Quantity:
    if found.slides:
        return Quantity("cam_mass", Symbol("m"), "kg", Message(N_("mass of the follower")))
    text = Message(N_("moment of inertia of the follower about its pivot"))
    return Quantity("cam_mass", Symbol("J"), "kg·m²", text)


GUIDE = Quantity("cam_guide", Symbol("c", "g"), "m", Message(N_("length of the guide")))
OVERHANG = Quantity(
    "cam_overhang", Symbol("b"), "m", Message(N_("overhang of the follower before its guide"))
)
FRICTION = Quantity("cam_guide_f", Symbol("f"), "", Message(N_("coefficient of friction in the guide")))
JAMS = Quantity(
    "cam_alpha_jam", Symbol("alpha", JAM), "deg",
    Message(N_("pressure angle from which on the friction in the guide jams the follower")),
)  # fmt: skip
OMEGA_OFF = Quantity(
    "cam_omega_off", Symbol("omega", OFF), "rad/s",
    Message(N_("angular velocity of the cam at which the follower begins to leave it")),
)  # fmt: skip
N_OFF = Quantity(
    "cam_n_off",
    Symbol("n", OFF),
    "rpm",
    Message(N_("speed of the cam at which the follower begins to leave it")),
)
MEAN_TORQUE = Quantity(
    "cam_T_mean", Symbol("T", MEAN), "N·m", Message(N_("mean moment of the drive of the cam"))
)
WORK = Quantity("cam_work", Symbol("A"), "J", Message(N_("work of the drive of the cam in a turn")))
WORK_LOST = Quantity("cam_work_fr", Symbol("A", FR), "J", Message(N_("work that friction takes in a turn")))
MISS = Quantity(
    "cam_disagreement", None, "",
    Message(N_("relative disagreement of the moment of the drive by the forces and by the powers")),
)  # fmt: skip
BEARS = Quantity(
    "cam_sigma_perm", Symbol("sigma", PERMITTED), "MPa", Message(N_("permitted pressure in the contact"))
)
SHARE = Quantity(
    "cam_share",
    None,
    "",
    Message(N_("least part of the force of the cam that friction leaves while it lifts")),
)


def _needed_preload(found: Found) -> Quantity:
    own = preload(found, f"0,{NEED}")
    text = Message(N_("preload with which the spring of this rate keeps the follower on the cam"))
    return Quantity("cam_F0_needed", own.symbol, own.unit, text)


def _reached(found: Found) -> Iterator[Value]:
    """Extremes, means and works of the turn."""
    own = needed(found)
    texts = (
        (MIN, N_("least: %(of)s"), "min"),
        (MAX, N_("greatest: %(of)s"), "max"),
    )
    for end, (index, text, suffix) in enumerate(texts):
        for quantity, ends in ((own, found.needed), (normal(), found.pressing), (TORQUE, found.torque)):
            if ends is not None:
                symbol = Symbol(quantity.sign.base, ",".join(filter(None, (quantity.sign.sub, index))))
                meaning = Message(text, {"of": quantity.meaning})
                one = Quantity(f"{quantity.key}_{suffix}", symbol, quantity.unit, meaning)
                yield one.value(ends[end].value, ends[end].turned)
    if found.jams:
        yield SHARE.value(found.jammed.value, found.jammed.turned)
    else:
        yield MEAN_TORQUE.value(found.mean)
        yield WORK.value(2 * math.pi * found.mean)
        if found.loaded.rubs.any:
            yield WORK_LOST.value(found.lost)
    yield MISS.value(found.disagreement)
    if found.contact is not None:
        yield Quantity("cam_sigma_max", Symbol("sigma", MAX), "MPa", PRESSURE.meaning).value(
            found.contact.value / MEGA, found.contact.turned
        )
    if found.given.permitted:
        yield BEARS.value(found.given.permitted / MEGA)
