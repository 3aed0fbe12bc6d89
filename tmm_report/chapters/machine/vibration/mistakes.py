"""What cannot be solved, in sentences that explain why."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.machine.vibration.solve import Found

NEAR = 1e-3  # of the natural frequency: nearer than three digits of a stated stiffness say is resonance


def check(found: Found) -> None:
    """Raises ProblemError."""
    problems = [*_resonance(found), *_rough(found), *_heavy(found)]
    if problems:
        raise ProblemError(problems)


def _resonance(found: Found) -> Iterator[Problem]:
    """A force of the natural frequency and nothing that takes its work away, nor an absorber or a base that moves."""
    if found.zeta > 0 or (found.unbounded and (found.absorbed or found.stood)):
        return
    orders = [(1, found.omega)]
    if found.shaking is not None:
        orders = [(int(k), k * found.shaking.omega) for k in np.flatnonzero(found.shaking.spectrum) if k]
    for order, omega in orders:
        if abs(omega / found.natural - 1) > NEAR:
            continue
        text = N_(
            "resonance without damping: harmonic %(order)s of the force has the natural frequency %(omega)s rad/s, its "
            "work is never spent, and the amplitude grows without bound"
        )
        right = Message(N_("state damping or damping_ratio, or another stiffness of the isolators"))
        yield mistake(text, ("vibration",), right, order=order, omega=f"{omega:.5g}")


def _rough(found: Found) -> Iterator[Problem]:
    """Dry friction that the force cannot overcome, or that cannot hold the amplitude at resonance."""
    friction = found.given.friction
    if friction is None:
        return
    most = math.pi / 4 * found.force
    if friction >= most:
        text = N_(
            "a dry friction of %(friction)s takes more work out of a cycle than the force of %(force)s gives"
        )
        right = Message(N_("less than %(most)s, π/4 of the amplitude of the force"), {"most": f"{most:.4g}"})
        values = {"friction": f"{friction:.4g}", "force": f"{found.force:.4g}"}
        yield mistake(text, ("vibration", "friction"), right, **values)
    elif abs(found.eta - 1) <= NEAR:
        text = N_(
            "at resonance dry friction does not bound the amplitude: its work over a cycle grows no faster than "
            "that of the force"
        )
        yield mistake(
            text, ("vibration", "friction"), Message(N_("leave it out, or state another stiffness"))
        )


def _heavy(found: Found) -> Iterator[Problem]:
    """A machine on a base that gives way, with a natural frequency at work and nothing that damps it."""
    stood = found.stood
    if stood is None or found.body.damping > 0 or stood.base.damping > 0:
        return
    if min(abs(found.omega / natural - 1) for natural in stood.natural) <= NEAR:
        text = N_(
            "resonance without damping: the machine on its base has the natural frequency %(omega)s rad/s of the force"
        )
        right = Message(N_("state the damping, or another stiffness of the foundation"))
        yield mistake(text, ("vibration", "foundation"), right, omega=f"{found.omega:.5g}")


def unneeded() -> ProblemError:
    """Of an absorber whose mass would be nothing."""
    text = N_("no absorber is needed: no natural frequency of the machine lies between these parts")
    right = Message(N_("state the absorber's mass"))
    return ProblemError([mistake(text, ("vibration", "absorber", "clear"), right)])
