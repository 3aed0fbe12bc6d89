"""The numbers of vibration and its isolation: single values, and tables of responses, motions and absorbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.machine.vibration.solve import Found, ratio_key
from tmm_report.chapters.machine.vibration.values import Harmonics, OverTurn
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("vibration_natural", "vibration_amplitude", "vibration_ratio")  # what is looked for first

Array = Any
PREFIX = "vibration"


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.given.free:
        yield _table("motion", N_("motion of the machine from the start"), _motion(found))
        if "decrement" in found.s:
            yield _table("swings", N_("amplitudes of the free motion, period by period"), _swings(found))
        return
    yield _table(
        "response", N_("response of the machine at other frequencies of the excitation"), _response(found)
    )
    yield _table("dampings", N_("the same isolators with other dampings"), _dampings(found))
    text = N_("magnification factor, lag and transmissibility against the frequency, by damping ratio")
    yield _table("curves", text, _curves(found))
    if found.shaking is None and not found.unbounded:
        yield _table("motion", N_("motion of the machine from the start"), _motion(found))
    if found.shaking is not None:
        yield _table("harmonics", N_("harmonics of the shaking force and what each does"), _harmonics(found))
        yield _table("turn", N_("shaking force, motion and force on the base over a turn"), _turn(found))
    if found.absorbed is not None:
        yield _table("absorbers", N_("absorbers on the machine"), _absorbers(found))
        text = N_("magnification factor of the machine with each absorber against the frequency")
        yield _table("absorbed", text, _absorbed(found))


def _table(name: str, meaning: str, columns: Iterator[Column]) -> Table:
    return Table(f"{PREFIX}_{name}", Message(meaning), tuple(columns))


# --- responses

ROWS = (0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0)  # ω/ω0 of the table of responses


def _response(found: Found) -> Iterator[Column]:
    most = max(ROWS[-1], float(np.ceil(found.eta)))
    eta = np.unique(np.round([*ROWS, most, _working(found)], 12))  # the working one among them
    zeta = found.zeta
    beta, handed = vib.magnification(eta, zeta), vib.transmissibility(eta, zeta)
    moved, pushed = _moved(found, eta, beta, handed)
    yield found.s.column("eta", eta)
    yield found.s.column("omega", eta * found.natural)
    yield found.s.column("beta", beta)
    yield found.s.column("lag", np.where(np.isfinite(beta), vib.lag(eta, zeta), np.nan))
    yield found.s.column(ratio_key(found.given), handed)
    yield found.s.column("amplitude", moved)
    yield found.s.column("on_base", pushed)


def _working(found: Found) -> float:
    """ω/ω0 at work; of a resonance that nothing bounds resonance itself, and not its neighbourhood."""
    return 1.0 if found.unbounded else found.eta


def _moved(found: Found, eta: Array, beta: Array, handed: Array) -> tuple[Array, Array]:
    """Amplitudes of the machine and of the force on its base."""
    if found.given.base is not None:
        moved = handed * found.given.base
        return moved, found.body.inertia * np.square(eta * found.natural) * moved
    force = found.force * (np.square(eta / found.eta) if found.grows else np.ones_like(eta))
    with np.errstate(invalid="ignore"):
        return beta * force / found.body.stiffness, handed * force


def _dampings(found: Found) -> Iterator[Column]:
    zeta = np.unique(np.round([*found.given.curves, found.zeta], 12))
    place, height = vib.peak(zeta)
    yield found.s.column("zeta", zeta)
    yield found.s.column("eta_peak", place)
    yield found.s.column("beta_peak", height)
    yield found.s.column("beta", vib.magnification(_working(found), zeta))
    yield found.s.column(ratio_key(found.given), vib.transmissibility(_working(found), zeta))


POINTS = 401  # of a curve against the frequency
SPAN = 3.0  # ω/ω0 that the curves reach at least
LINES = (
    ("beta", "beta", "", N_("magnification factor at the damping ratio %(zeta)s"), vib.magnification),
    ("lag", "psi", "rad", N_("lag at the damping ratio %(zeta)s"), vib.lag),
    ("ratio", "gamma", "", N_("transmissibility at the damping ratio %(zeta)s"), vib.transmissibility),
)


def _curves(found: Found) -> Iterator[Column]:
    eta = np.linspace(0.0, max(SPAN, 1.2 * found.eta), POINTS)
    yield found.s.column("eta", eta)
    for number, zeta in enumerate(found.given.curves, 1):
        for key, letter, unit, text, of in LINES:
            line = np.asarray(of(eta, zeta))
            line = np.where(np.isfinite(line), line, np.nan)
            meaning = Message(text, {"zeta": f"{zeta:g}"})
            yield Quantity(f"{key}_{number}", Symbol(letter, str(number)), unit, meaning).column(line)


def _motion(found: Found) -> Iterator[Column]:
    yield found.s.column("t", found.times)
    yield found.s.column("x", found.motion)
    if not found.given.free:
        yield found.s.column("x_steady", found.settled)


SWINGS = 10  # periods of which the amplitudes are listed


def _swings(found: Found) -> Iterator[Column]:
    s, count = found.s, np.arange(SWINGS + 1)
    times = count * s.number("period")
    yield s.column("swing", count)
    yield s.column("t", times)
    yield s.column("size", s.number("begins") * np.exp(-s.number("decay") * times))


# --- the mechanism's own force


def _harmonics(found: Found) -> Iterator[Column]:
    shaken = found.shaking
    assert shaken is not None
    eta = shaken.orders * shaken.omega / found.natural
    size = np.where(shaken.sizes <= 1e-9 * shaken.sizes.max(), 0.0, shaken.sizes)
    handed = vib.transmissibility(eta, found.zeta)
    yield Harmonics.order.column(shaken.orders)
    yield found.s.column("omega", shaken.orders * shaken.omega)
    yield found.s.column("force", size)
    yield found.s.column("eta", eta)
    yield found.s.column("ratio", handed)
    yield found.s.column("amplitude", size * vib.magnification(eta, found.zeta) / found.body.stiffness)
    yield found.s.column("on_base", size * handed)


def _turn(found: Found) -> Iterator[Column]:
    shaken = found.shaking
    assert shaken is not None
    yield OverTurn.phi.column(shaken.turned)
    yield OverTurn.force.column(shaken.force)
    yield OverTurn.x.column(shaken.moved)
    yield OverTurn.on_base.column(shaken.handed)


# --- absorbers


def _absorbers(found: Found) -> Iterator[Column]:
    hung = found.absorbed
    assert hung is not None
    rows = hung.fitted
    yield text_column("kind", Message(N_("kind of the absorber")), [one.key for one in rows])
    yield found.s.column("absorber", [one.hung.inertia for one in rows])
    yield found.s.column("absorber_stiffness", [one.hung.stiffness for one in rows])
    yield found.s.column("absorber_damping", [float(one.hung.damping) for one in rows])
    yield found.s.column("amplitude", [found.force * one.work for one in rows])
    yield found.s.column("absorber_swing", [found.force * one.swing for one in rows])
    yield found.s.column("eta_peak", [one.eta if np.isfinite(one.beta) else np.nan for one in rows])
    yield found.s.column("beta_peak", [one.beta for one in rows])


WITH = N_("magnification factor of the machine, absorber: %(kind)s")


def _absorbed(found: Found) -> Iterator[Column]:
    hung = found.absorbed
    assert hung is not None
    eta = np.linspace(0.0, max(2.0, 1.2 * found.eta), POINTS)
    force = (found.body.stiffness, 0.0)
    yield found.s.column("eta", eta)
    yield found.s.column("beta", vib.magnification(eta, found.zeta))
    for number, one in enumerate(hung.fitted, 1):
        with np.errstate(divide="ignore", invalid="ignore"):
            line = np.abs(vib.pair(found.body, one.hung, eta * found.natural, force)[0])
        line = np.where(np.isfinite(line), line, np.nan)
        meaning = Message(WITH, {"kind": one.key})
        yield Quantity(f"beta_{number}", Symbol("beta", str(number)), "", meaning).column(line)
