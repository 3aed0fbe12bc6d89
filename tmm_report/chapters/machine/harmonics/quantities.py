"""The numbers of harmonics of the motion of points and links."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.harmonics.solve import Found, Signal, Wave
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, kept, text_column
from tmm_report.quantity.symbols import GREEK, Symbol
from tmm_report.quantity.tabulated import tabulated

CONTENT = Message(N_("harmonics of the outputs and of points: amplitudes and phases by order"))
LEFT = Message(N_("what the harmonics leave of each motion"))
WAVE = N_(
    "wave along link %(link)s from point %(start)s to point %(end)s: harmonics of the places between them"
)

ORDER = Quantity("order", Symbol("k"), "", Message(N_("order of the harmonic")))
SAMPLES = Quantity(
    "harmonics_samples", Symbol("N"), "", Message(N_("equal steps of a turn at which the motion was solved"))
)
TAIL = Quantity(
    "harmonics_tail", None, "", Message(N_("largest harmonic of the places that these miss, relative"))
)
XI = Quantity("xi", Symbol("xi"), "", Message(N_("part of the way along the link")))

UNITS = {"S": ("m", "rad"), "V": ("m/s", "rad/s"), "a": ("m/s²", "rad/s²"), "x": ("m", "m"), "y": ("m", "m")}
LETTERS = {"S": ("S", "psi"), "V": ("V", "omega"), "a": ("a", "epsilon"), "x": ("x", "x"), "y": ("y", "y")}
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


@kept
def amplitude(kind: str, name: str, rocker: bool) -> Quantity:
    """Of a signal, of order 0 the mean."""
    letter = LETTERS[kind][rocker]
    meaning = Message(AMPLITUDES[kind], {"name": name})
    return Quantity(f"A_{kind}_{name}", Symbol("A", f"{letter}{name}"), UNITS[kind][rocker], meaning)


@kept
def phase(kind: str, name: str, rocker: bool) -> Quantity:
    letter = LETTERS[kind][rocker]
    meaning = Message(PHASES[kind], {"name": name})
    return Quantity(f"alpha_{kind}_{name}", Symbol("alpha", f"{letter}{name}"), "deg", meaning)


def signal_name(signal: Signal) -> str:
    """S_B, ψ_3: as text."""
    letter = LETTERS[signal.kind][signal.rocker]
    return f"{GREEK.get(letter, letter)}_{signal.name}"


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.signals:
        orders = ORDER.column(list(range(found.given.highest + 1)))
        columns = (column for signal in found.signals for column in _columns(signal))
        yield Table("harmonic_content", CONTENT, (orders, *columns))
        yield _left(found)
    for wave in found.waves:
        yield _wave(wave, found.given.highest)


def _columns(signal: Signal) -> Iterator[Column]:
    size, at = signal.series.amplitude, np.degrees(signal.series.phase)
    none = np.abs(size) <= 1e-12 * np.abs(size).max(initial=0.0)
    at = np.where(none, np.nan, at)
    at[0] = np.nan
    yield amplitude(signal.kind, signal.name, signal.rocker).column(np.where(none, 0.0, size))
    yield phase(signal.kind, signal.name, signal.rocker).column(at)


REST = Quantity(
    "left",
    Symbol("delta"),
    "",
    Message(N_("greatest difference from the sum of the harmonics, by the swing")),
)
MAIN = Quantity("main", None, "", Message(N_("order of the largest harmonic")))


def _left(found: Found) -> Table:
    sizes = [signal.series.amplitude[1:] for signal in found.signals]
    return Table(
        "harmonics_left",
        LEFT,
        (
            text_column("motion", Message(N_("motion")), [signal_name(signal) for signal in found.signals]),
            MAIN.column([int(np.argmax(size)) + 1 for size in sizes]),
            REST.column(np.array([signal.left for signal in found.signals])),
        ),
    )


# ---------------------------------------------------------------- waves


@kept
def wave_amplitude(axis: str, order: int) -> Quantity:
    text = (
        N_("amplitude of harmonic %(order)s of x")
        if axis == "x"
        else N_("amplitude of harmonic %(order)s of y")
    )
    return Quantity(f"A_{axis}{order}", Symbol("A", f"{axis}{order}"), "m", Message(text, {"order": order}))


@kept
def wave_phase(axis: str, order: int) -> Quantity:
    text = N_("phase of harmonic %(order)s of x") if axis == "x" else N_("phase of harmonic %(order)s of y")
    return Quantity(
        f"alpha_{axis}{order}", Symbol("alpha", f"{axis}{order}"), "deg", Message(text, {"order": order})
    )


def _wave(wave: Wave, highest: int) -> Table:
    meaning = Message(WAVE, {"link": wave.link, "start": wave.start, "end": wave.end})
    columns = [XI.column(wave.xi)]
    size = max(np.abs(part.amplitude[:, 1:]).max() for part in (wave.x, wave.y))
    for axis, part in (("x", wave.x), ("y", wave.y)):
        for k in range(1, highest + 1):
            columns.append(wave_amplitude(axis, k).column(_settled(part.amplitude[:, k], size)))
    for axis, part in (("x", wave.x), ("y", wave.y)):
        for k in range(1, highest + 1):
            none = part.amplitude[:, k] <= 1e-12 * size
            at = np.where(none, np.nan, np.degrees(np.arctan2(part.sine[:, k], part.cosine[:, k])))
            columns.append(wave_phase(axis, k).column(np.where(at <= -180 + 1e-7, 180.0, at)))
    return Table(f"wave_{wave.link}", meaning, tuple(columns))


def _settled(values: np.ndarray, size: float) -> np.ndarray:
    return np.where(np.abs(values) <= 1e-12 * size, 0.0, values)


# ---------------------------------------------------------------- single numbers


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield SAMPLES.value(found.count)
    yield TAIL.value(found.tail)
    for wave in found.waves:
        if wave.check is not None:
            text = N_(
                "worst difference of the wave along link %(link)s from the formulas of the slider-crank, relative"
            )
            yield Quantity(f"wave_check_{wave.link}", None, "", Message(text, {"link": wave.link})).value(
                wave.check
            )
