"""Every number of the eccentric epicyclic mechanism with its symbol, unit and meaning."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.quantities.further import further_tables
from tmm_report.chapters.gears.eccentric.quantities.numbers import GAP, values
from tmm_report.chapters.gears.eccentric.solve.mechanism import RING, SUN, WHEELS, Found
from tmm_report.mechanics.gears.pair_sizes import least_ring
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.wheel_words import dimension, of_wheel

__all__ = ["GAP", "book", "tables", "values"]

Array = Any

NUMBER_OF_WHEEL = Message(N_("number of the wheel"))
CONCERNED = Message(N_("wheels concerned"))
TEETH = Quantity("z", Symbol("z"), "", Message(N_("number of teeth")))


def book(found: Found, prefix: str = "eccentric") -> Book:
    """All that is said in numbers of the mechanism."""
    return Book.of(tables(found, prefix), values(found, prefix))


@tabulated
def tables(found: Found, prefix: str = "eccentric") -> Iterator[Table]:
    parts = {
        "family": (N_("Sets of teeth of the family"), _family),
        "satellites": (N_("Positions of the satellites"), _satellites),
        "conditions": (N_("Conditions of the mechanism"), _conditions),
        "teeth": (N_("Overlap and clearance of the teeth over a full pitch"), _proof),
        "wheels": (N_("Dimensions of the wheels"), _wheels),
        "neighbours": (N_("Satellites that stand side by side"), _neighbours),
    }
    if found.given.speed is not None:
        parts["speeds"] = (N_("Angular velocities of the members"), _speeds)
    for key, (meaning, columns) in parts.items():
        yield Table(f"{prefix}_{key}", Message(meaning), tuple(columns(found)))
    yield from further_tables(found, prefix)


# --- the family


def _family(found: Found) -> Iterator[Column]:
    judged, family = found.judged, found.judged.family
    z = family.satellites
    yield Quantity("t", Symbol("t"), "", Message(N_("number of the set"))).column(family.t)
    teeth = ((SUN, family.sun), ("2", z[:, 0]), (RING, family.ring), ("4", z[:, 1]), ("5", z[:, 2]))
    for wheel, numbers in teeth:
        text = Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": wheel})
        yield Quantity(f"z{wheel}", Symbol("z", wheel), "", text).column(numbers)
    residue = Message(N_("residue of assembly of the middle satellite, pitches"))
    yield Quantity("residue_4", math_symbol("epsilon_4"), "", residue).column(judged.residue[:, 1])
    gaps = {("2", "4"): judged.gap[:, 0, 1], ("4", "5"): judged.gap[:, 1, 2]}
    for (one, other), free in gaps.items():
        gap = N_("free distance between the tip circles of satellites %(pair)s")
        meaning = Message(gap, {"pair": f"{one}–{other}"})
        symbol = Symbol(GAP, f"{one},{other}")
        yield Quantity(f"gap_{one}_{other}", symbol, "m", meaning).column(free)
    closed = N_("free distance between the tip circles of satellites 2–4 in closed form")
    yield Quantity("closed_2_4", Symbol(GAP, "2,4"), "m", Message(closed)).column(judged.closed)
    held = [", ".join(w for w, fits in zip(WHEELS.values(), row, strict=True) if fits) for row in judged.fit]
    yield text_column("satellites", Message(N_("satellites that go together")), held)


# --- the satellites of the chosen set


def _satellites(found: Found) -> Iterator[Column]:
    all_ = found.satellites
    names, centres = [s.wheel for s in all_], np.array([s.centre for s in all_])
    yield text_column("wheel", NUMBER_OF_WHEEL, names)
    yield Column(TEETH, [s.teeth for s in all_], [Symbol("z", name) for name in names])
    for about, where, angles in (
        ("1", N_("angle at the axis of the sun"), [s.phi1 for s in all_]),
        ("3", N_("angle at the axis of the ring"), [s.phi3 for s in all_]),
    ):
        angle = Quantity(f"phi{about}", Symbol("phi", about), "deg", Message(where))
        yield Column(angle, np.degrees(angles), [Symbol("phi", f"{about},{name}") for name in names])
    text = Message(N_("x of the centre, from the axis of the sun"))
    yield Quantity("x", Symbol("x"), "m", text).column(centres.real)
    text = Message(N_("y of the centre, from the axis of the sun"))
    yield Quantity("y", Symbol("y"), "m", text).column(centres.imag)
    pitches = Quantity("L", Symbol("L"), "", Message(N_("pitches in the closed line of assembly")))
    yield Column(pitches, [s.belt for s in all_], [Symbol("L", name) for name in names])
    residue = Message(N_("residue of assembly, pitches"))
    yield Quantity("residue", Symbol("epsilon"), "", residue).column([s.residue for s in all_])
    arm = Quantity("l", Symbol("l"), "m", Message(N_("distance of the centre from the axis of the sun")))
    yield Column(arm, [s.arm for s in all_], [Symbol("l", name) for name in names])
    text = Message(N_("radius of curvature of the flank where the tip of the ring of full height touches it"))
    curvature = Quantity("rho", Symbol("rho"), "m", text)
    yield Column(curvature, [s.curvature for s in all_], [Symbol("rho", name) for name in names])
    text = Message(N_("least teeth of a ring without shift that does not interfere with the satellite"))
    least = [float(least_ring(s.teeth, found.given.rack)) for s in all_]
    yield Column(
        Quantity("z3_least", Symbol("z", "3,min"), "", text), least, [Symbol("z", "3,min") for _ in all_]
    )


def _neighbours(found: Found) -> Iterator[Column]:
    """Each pair once, without its mirror image."""
    pairs = found.near
    index = [f"{pair.one.wheel},{pair.other.wheel}" for pair in pairs]
    yield text_column("wheels", CONCERNED, [pair.wheels for pair in pairs])
    distance = Quantity("l", Symbol("l"), "m", Message(N_("distance of the axes")))
    yield Column(distance, [pair.distance for pair in pairs], [Symbol("l", name) for name in index])
    gap = Quantity("gap", Symbol(GAP), "m", Message(N_("free distance between the tip circles")))
    yield Column(gap, [pair.gap for pair in pairs], [Symbol(GAP, name) for name in index])


# --- dimensions, conditions, proof, speeds


def _wheels(found: Found) -> Iterator[Column]:
    """The sun, the satellites that mirror no other, the ring."""
    m, rack = found.given.module, found.given.rack
    named = [(SUN, found.sun, 1), *((s.wheel, s.teeth, 1) for s in found.upper), (RING, found.ring, -1)]
    names, z, out = [name for name, *_ in named], *(np.array(of) for of in list(zip(*named, strict=True))[1:])
    tips = m * (z + 2 * out * rack.ha)
    tips[-1] += 2 * found.cut
    yield text_column("wheel", NUMBER_OF_WHEEL, names)
    yield Column(TEETH, [int(n) for n in z], [Symbol("z", name) for name in names])
    diameters = {
        "d": m * z, "d_b": m * z * math.cos(rack.alpha), "d_a": tips,
        "d_f": m * (z - 2 * out * (rack.ha + rack.c)),
    }  # fmt: skip
    for key, numbers in diameters.items():
        of = dimension(key)
        yield Column(of, numbers, [of_wheel(of.sign, name) for name in names])


def _conditions(found: Found) -> Iterator[Column]:
    """Lengths in m; the rest are pure numbers."""
    rows = found.conditions
    units = ["m" if c.unit == "mm" else c.unit for c in rows]
    yield text_column("condition", Message(N_("condition")), [c.key for c in rows])
    yield text_column("wheels", CONCERNED, [c.wheel for c in rows])
    yield text_column("unit", Message(N_("unit of the numbers in the row")), units)
    for key, text, numbers in (
        ("value", N_("value, SI"), [c.value for c in rows]),
        ("limit", N_("limit, SI"), [c.limit for c in rows]),
        ("in_hand", N_("in hand, SI; negative where the condition fails"), [c.margin for c in rows]),
    ):
        quantity = Quantity(key, None, "", Message(text))
        yield Column(quantity, [float(x) for x in numbers], units=units)


def _proof(found: Found) -> Iterator[Column]:
    proof = found.proof
    yield text_column("wheels", CONCERNED, [f"{one}–{other}" for one, other in proof.meshes])
    overlap = Message(N_("largest overlap of the teeth over a pitch"))
    yield Quantity("overlap", None, "m²", overlap).column(proof.overlap.max(axis=1))
    clearance = Message(N_("least clearance of the teeth over a pitch"))
    yield Quantity("clearance", None, "m", clearance).column(proof.clearance.min(axis=1))


def _speeds(found: Found) -> Iterator[Column]:
    motions = found.motions
    yield text_column("stopped", Message(N_("member stopped")), [motion.stopped for motion in motions])
    for name in motions[0].speed:
        text = Message(N_("angular velocity of member %(name)s"), {"name": name})
        speed = Quantity(f"omega_{name}", Symbol("omega", name), "rad/s", text)
        yield speed.column([motion.speed[name] for motion in motions])
