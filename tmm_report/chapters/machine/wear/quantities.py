"""The numbers of the wear: of every guide its surfaces, the profiles of its wear and how the slider stands; of every
pivot its members and the wear of their sectors."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.machine.wear.guide import FACES, GuideFound, Surface
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.chapters.machine.wear.solve import Found
from tmm_report.chapters.machine.wear.values import HOUR, guide_values, pivot_values
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.part import Part
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

Array = Any
CAUSES = ("force", "couple")
SHORT = {"force": "R", "couple": "M"}
STAGES = 61  # moments of the diagram of the greatest wear against the time


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for prefix, guide in guides(found):
        yield from guide_tables(guide, prefix)
    for prefix, pivot in pivots(found):
        yield from pivot_tables(pivot, prefix)


@tabulated
def values(found: Found) -> Iterator[Value]:
    for prefix, guide in guides(found):
        yield from guide_values(guide, prefix)
    for prefix, pivot in pivots(found):
        yield from pivot_values(pivot, prefix)


def guides(found: Found) -> Iterator[tuple[str, GuideFound]]:
    """Every guide with the prefix of its numbers."""
    return ((f"wear_guide_{number}", one) for number, one in enumerate(found.guides, 1))


def pivots(found: Found) -> Iterator[tuple[str, PivotFound]]:
    """Every pivot with the prefix of its numbers."""
    return ((f"wear_pivot_{number}", one) for number, one in enumerate(found.pivots, 1))


def guide_book(found: GuideFound, prefix: str) -> Part:
    return Part(prefix, Book.of(guide_tables(found, prefix), guide_values(found, prefix)))


def pivot_book(found: PivotFound, prefix: str) -> Part:
    return Part(prefix, Book.of(pivot_tables(found, prefix), pivot_values(found, prefix)))


# --- guides


def guide_tables(found: GuideFound, prefix: str) -> Iterator[Table]:
    of = {"name": found.given.guide}
    for key, text, columns in (
        (
            "surfaces",
            N_("faces of guide %(name)s and of its slider: pressures, coefficients, wear"),
            _surfaces,
        ),
        ("profile", N_("wear along guide %(name)s"), _profile),
        ("sole", N_("wear along the slider of guide %(name)s"), _sole),
        ("cycle", N_("slider on guide %(name)s over the cycle"), _cycle),
        ("stages", N_("greatest wear of guide %(name)s against the time"), _stages),
    ):
        yield Table(f"{prefix}_{key}", Message(text, of), tuple(columns(found)))


K_UNIT, K_SIZE = "mm³/(kN·m)", 1e12  # of a coefficient, which in 1/Pa has fifteen noughts
U, PRESSURE, K, C = Symbol("u"), Symbol("p"), Symbol("k"), Symbol("c")


def _surfaces(found: GuideFound) -> Iterator[Column]:
    """A row for each face and each cause."""
    rows = [(one, cause) for one in found.surfaces for cause in range(2)]
    index = [f"{side_index(one)},{SHORT[CAUSES[cause]]}" for one, cause in rows]
    yield text_column("side", Message(N_("member")), [one.side for one, _ in rows])
    yield text_column("face", Message(N_("face")), [one.face for one, _ in rows])
    yield text_column("cause", Message(N_("central reaction or its moment")), [CAUSES[n] for _, n in rows])
    numbers: dict[str, tuple[Symbol, str, str, list[float]]] = {
        "pressure": (PRESSURE, "Pa", N_("mean pressure"), [one.pressure[n] for one, n in rows]),
        "k": (K, K_UNIT, N_("coefficient of wear"), [K_SIZE * one.k[n] for one, n in rows]),
        "c": (C, "µm/(N·m)", N_("wear of a point by its sum"), [1e6 * one.c[n] for one, n in rows]),
        "work": (Symbol("W", "max"), "N·m", N_("greatest sum of a point"), [one.work[n].max() for one, n in rows]),
        "rubbed": (Symbol("W"), "N·m", N_("sum over all the points"), [one.work[n].sum() for one, n in rows]),
        "depth": (Symbol("u", "max"), "m", N_("greatest wear"), [one.parts[n].max() for one, n in rows]),
        "volume": (Symbol("V"), "m³", N_("volume worn off"), [_volume(found, one, n) for one, n in rows]),
    }  # fmt: skip
    for key, (symbol, unit, text, column) in numbers.items():
        signs = [Symbol(symbol.base, ",".join(filter(None, (name, symbol.sub)))) for name in index]
        yield Column(Quantity(key, symbol, unit, Message(text)), [float(x) for x in column], signs)


def side_index(one: Surface) -> str:
    """1 the slider, 2 the guide; the lower face without a mark, the upper one with it."""
    return ("1" if one.side == "slider" else "2") + ("" if one.face == "lower" else "'")


def _volume(found: GuideFound, one: Surface, cause: int) -> float:
    return float(one.parts[cause].sum()) * found.given.width * found.grid.step


def _profile(found: GuideFound) -> Iterator[Column]:
    points = np.arange(len(found.grid.x)) + 1
    yield Quantity("point", Symbol("j"), "", Message(N_("point of the guide"))).column(points)
    place = Message(N_("place from the beginning of the guide"))
    yield Quantity("x", Symbol("x"), "m", place).column(found.grid.x)
    yield from _depths(found, "guide")
    even = Message(N_("relative wear resistance with which the face worn most would wear evenly"))
    yield Quantity("resistance", Symbol("epsilon"), "", even).column(found.resistance)
    after = np.where(np.isfinite(found.resistance), found.even, 0.0)
    yield Quantity("even", Symbol("u", "unif"), "m", Message(N_("its wear then"))).column(after)


def _sole(found: GuideFound) -> Iterator[Column]:
    points = np.arange(found.grid.covered) + 1
    yield Quantity("point", Symbol("k"), "", Message(N_("point of the slider"))).column(points)
    place = Message(N_("place from the middle of the slider"))
    yield Quantity("xi", Symbol("xi"), "m", place).column(found.grid.xi)
    yield from _depths(found, "slider")


def _depths(found: GuideFound, side: str) -> Iterator[Column]:
    """Of both faces: sums, wear without skew, and with it."""
    for face in FACES:
        one = found.surface(side, face)
        number = side_index(one)
        texts = {"face": Message(face_word(found, face))}
        for n, cause in enumerate(CAUSES):
            text = (N_("sum of the central reaction, %(face)s face"), N_("sum of its moment, %(face)s face"))[
                n
            ]
            symbol = Symbol("W", number, SHORT[cause])
            yield Quantity(f"work_{cause}_{face}", symbol, "N·m", Message(text, texts)).column(one.work[n])
        for n, cause in enumerate(CAUSES):
            text = (
                N_("wear by the central reaction, %(face)s face"),
                N_("wear by its moment, %(face)s face"),
            )[n]
            symbol = Symbol("u", number, SHORT[cause])
            yield Quantity(f"u_{cause}_{face}", symbol, "m", Message(text, texts)).column(one.parts[n])
        whole = Message(N_("wear of the %(face)s face"), texts)
        yield Quantity(f"u_{face}", Symbol("u", number), "m", whole).column(one.depth)


FACE_WORDS = {"lower": N_("lower"), "upper": N_("upper")}
UPRIGHT = {"lower": N_("right-hand"), "upper": N_("left-hand")}


def face_word(found: GuideFound, face: str) -> str:
    return (UPRIGHT if found.upright else FACE_WORDS)[face]


ACROSS = {False: N_("reaction of the guide, + upwards"), True: N_("reaction of the guide, + to the left")}


def _cycle(found: GuideFound) -> Iterator[Column]:
    """At every position over which it is summed."""
    shift, tilt = found.settled
    start = found.grid.start + 1
    for key, symbol, unit, text, numbers in (
        ("phi", Symbol("phi"), "rad", N_("angle turned from position 0"), found.turned),
        ("S", Symbol("S"), "m", N_("displacement from the beginning of the stroke"), found.travel),
        ("start", Symbol("N", "begin"), "", N_("first point of the guide under the slider"), start),
        ("q", Symbol("q"), "m", N_("velocity analogue of the slider"), found.analogue),
        ("R", Symbol("R"), "N", ACROSS[found.upright], found.force),
        ("M", Symbol("M"), "N·m", N_("moment of the reaction about the slider's middle"), found.moment),
        ("h", Symbol("h"), "m", N_("arm of the reaction about the slider's middle"), found.arm),
        ("F_M", Symbol("F", "M"), "N", N_("force of the couple"), found.couple),
        ("shift", Symbol("delta"), "m", N_("displacement of the worn slider across the guide"), shift),
        ("tilt", Symbol("theta"), "rad", N_("tilt of the worn slider, + counter-clockwise"), tilt),
    ):
        yield Quantity(key, symbol, unit, Message(text)).column(numbers)


def _stages(found: GuideFound) -> Iterator[Column]:
    most = max(found.time, found.life or 0.0)
    time = np.linspace(0.0, most, STAGES)
    yield Quantity("t", Symbol("t"), "h", Message(N_("time of work"))).column(time / HOUR)
    yield Quantity("u", U, "m", Message(N_("greatest wear"))).column(found.worn(time))


# --- pivots


def pivot_tables(found: PivotFound, prefix: str) -> Iterator[Table]:
    of = {"name": found.given.pivot}
    text = N_("journal and bushing of pivot %(name)s")
    yield Table(f"{prefix}_members", Message(text, of), tuple(_members(found)))
    text = N_("wear along the circumference of pivot %(name)s")
    yield Table(f"{prefix}_sectors", Message(text, of), tuple(_sectors(found)))


def _members(found: PivotFound) -> Iterator[Column]:
    rows = found.members
    density = found.given.density
    yield text_column("member", Message(N_("member")), [one.name for one in rows])
    yield text_column("link", Message(N_("link")), [one.link for one in rows])
    columns: dict[str, tuple[Symbol, str, str, list[float]]] = {
        "k": (K, K_UNIT, N_("coefficient of wear"), [K_SIZE * one.k for one in rows]),
        "path": (Symbol("w", "max"), "MPa·m", N_("greatest sum of pressure by path"),
                 [1e-6 * one.path.max() for one in rows]),
        "depth": (Symbol("u", "max"), "m", N_("greatest wear"), [one.greatest for one in rows]),
        "angle": (Symbol("alpha", "max"), "rad", N_("angle of that sector from the x axis of the link"),
                  [found.centres[one.worst] for one in rows]),
        "volume": (Symbol("V"), "m³", N_("volume worn off"), [found.volume(one) for one in rows]),
    }  # fmt: skip
    if density is not None:
        masses = [density * found.volume(one) for one in rows]
        columns["mass"] = (Symbol("m"), "kg", N_("mass worn off"), masses)
    for key, (symbol, unit, meaning, numbers) in columns.items():
        signs = [Symbol(symbol.base, ",".join(filter(None, (str(n), symbol.sub)))) for n in (1, 2)]
        yield Column(Quantity(key, symbol, unit, Message(meaning)), [float(x) for x in numbers], signs)


def _sectors(found: PivotFound) -> Iterator[Column]:
    yield Quantity("alpha", Symbol("alpha"), "rad", Message(N_("angle of the sector's middle"))).column(
        found.centres
    )
    for number, one in enumerate(found.members, 1):
        values = {"member": Message(MEMBER_WORDS[one.name])}
        text = N_("sum of pressure by path, %(member)s")
        path = Quantity(f"path_{one.name}", Symbol("w", str(number)), "MPa·m", Message(text, values))
        yield path.column(1e-6 * one.path)
        text = N_("wear, %(member)s")
        yield Quantity(f"u_{one.name}", Symbol("u", str(number)), "m", Message(text, values)).column(
            one.depth
        )


MEMBER_WORDS = {"journal": N_("journal"), "bushing": N_("bushing")}
