"""Every number of the harmonics: single values, columns of tables, and what a rod's closed form is made of."""

from __future__ import annotations

from tmm_report.chapters.lever.kinematics.quantities import motion_of
from tmm_report.chapters.lever.kinematics.solve.positions import Output
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import X_PART, Y_PART, Quantity, kept
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.symbols import Symbol

PRINTED = {"m": "mm", "rad": "deg"}  # units of print of amplitudes


class Values(Sheet, prefix="harmonics"):
    samples = Q("N", "", N_("equal steps of a turn at which the motion was solved"))
    tail = Q(None, "", N_("largest harmonic of the places that these miss, relative"))


class Columns(Sheet):
    """Of tables and diagrams."""

    order = Q("k", "", N_("order of the harmonic"))
    main = Q(None, "", N_("order of the largest harmonic"))
    left = Q("delta", "", N_("greatest difference from the sum of the harmonics, by the swing"), "%")
    phi = Q("phi", "rad", N_("angle turned from position 0"), "deg")
    xi = Q("xi", "", N_("part of the way along the link"))


class Rod(Sheet):
    """A rod of a slider-crank in the axes of its guide."""

    r = Q("r", "m", N_("radius of the crank"))
    l = Q("l", "m", N_("length of the connecting rod"))
    phi = Q("phi", "", N_("angle of the crank from the guide, in the sense of rotation"))
    xi = Q("xi", "", N_("part of the way along the link"))


def check(link: str) -> Quantity:
    text = N_(
        "worst difference of the wave along link %(link)s from the formulas of the slider-crank, relative"
    )
    return Quantity(f"wave_check_{link}", None, "", Message(text, {"link": link}))


# --- motions of outputs and points, and their harmonics

AMPLITUDES = {
    "S": N_("amplitude of the displacement of %(name)s"),
    "V": N_("amplitude of the velocity of %(name)s"),
    "a": N_("amplitude of the acceleration of %(name)s"),
    "x": N_("amplitude of x of point %(name)s"),
    "y": N_("amplitude of y of point %(name)s"),
}
PHASES = {
    "S": N_("phase of the displacement of %(name)s"),
    "V": N_("phase of the velocity of %(name)s"),
    "a": N_("phase of the acceleration of %(name)s"),
    "x": N_("phase of x of point %(name)s"),
    "y": N_("phase of y of point %(name)s"),
}


def rate(kind: str, output: Output) -> Quantity:
    """Displacement "S", velocity "V" or acceleration "a" of an output, as the kinematics has it."""
    return motion_of(output)["SVa".index(kind)]


@kept
def place(axis: str, point: str) -> Quantity:
    path = Message(N_("Path of point %(name)s"), {"name": point})
    meaning = Message({"x": X_PART, "y": Y_PART}[axis], {"of": path})
    return Quantity(f"{axis}_{point}", Symbol(axis, point), "m", meaning)


def amplitude(kind: str, name: str, of: Quantity) -> Quantity:
    """Of a motion, of order 0 the mean."""
    sign = Symbol("A", f"{of.sign.base}{of.sign.sub}")
    meaning = Message(AMPLITUDES[kind], {"name": name})
    return Quantity(f"A_{kind}_{name}", sign, of.unit, meaning, PRINTED.get(of.unit, ""))


def phase(kind: str, name: str, of: Quantity) -> Quantity:
    sign = Symbol("alpha", f"{of.sign.base}{of.sign.sub}")
    return Quantity(f"alpha_{kind}_{name}", sign, "deg", Message(PHASES[kind], {"name": name}))


# --- waves along links

SIZES = {"x": N_("amplitude of harmonic %(order)s of x"), "y": N_("amplitude of harmonic %(order)s of y")}
LAGS = {"x": N_("phase of harmonic %(order)s of x"), "y": N_("phase of harmonic %(order)s of y")}


@kept
def wave_amplitude(axis: str, order: int | str) -> Quantity:
    """`order`: "" of any."""
    meaning = Message(SIZES[axis], {"order": order})
    return Quantity(f"A_{axis}{order}", Symbol("A", f"{axis}{order}"), "m", meaning, PRINTED["m"])


@kept
def wave_phase(axis: str, order: int) -> Quantity:
    sign = Symbol("alpha", f"{axis}{order}")
    return Quantity(f"alpha_{axis}{order}", sign, "deg", Message(LAGS[axis], {"order": order}))
