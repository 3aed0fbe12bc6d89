"""The tables of harmonics of the motion of points and links."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.harmonics.solve import Found, Signal, Wave
from tmm_report.chapters.machine.harmonics.values import (
    Columns,
    amplitude,
    check,
    phase,
    wave_amplitude,
    wave_phase,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, text_column
from tmm_report.quantity.symbols import GREEK
from tmm_report.quantity.tabulated import tabulated

CONTENT = Message(N_("harmonics of the outputs and of points: amplitudes and phases by order"))
LEFT = Message(N_("what the harmonics leave of each motion"))
WAVE = N_(
    "wave along link %(link)s from point %(start)s to point %(end)s: harmonics of the places between them"
)


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield from found.s.values()
    for wave in found.waves:
        if wave.check is not None:
            yield check(wave.link).value(wave.check)


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.signals:
        orders = Columns.order.column(list(range(found.given.highest + 1)))
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
    yield amplitude(signal.kind, signal.name, signal.of).column(np.where(none, 0.0, size))
    yield phase(signal.kind, signal.name, signal.of).column(at)


def _left(found: Found) -> Table:
    sizes = [signal.series.amplitude[1:] for signal in found.signals]
    names = [_name(signal) for signal in found.signals]
    columns = (
        text_column("motion", Message(N_("motion")), names),
        Columns.main.column([int(np.argmax(size)) + 1 for size in sizes]),
        Columns.left.column(np.array([signal.left for signal in found.signals])),
    )
    return Table("harmonics_left", LEFT, columns)


def _name(signal: Signal) -> str:
    """S_B, ψ_3: as text."""
    letter = signal.of.sign.base
    return f"{GREEK.get(letter, letter)}_{signal.name}"


def _wave(wave: Wave, highest: int) -> Table:
    meaning = Message(WAVE, {"link": wave.link, "start": wave.start, "end": wave.end})
    columns = [Columns.xi.column(wave.xi)]
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
