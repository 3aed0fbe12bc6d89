"""What cannot be: sentences that explain by the physics why a motion asked for does not exist."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NoReturn

from tmm_report.mechanics.machine.run.motion_law import NeverReached
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.text import number


def _error(text: str, key: str, right: str, **values: Any) -> ProblemError:
    path = ("dynamics", key) if key else ("dynamics",)
    return ProblemError([mistake(text, path, Message(right), **values)])


def _text(value: float) -> str:
    return number(value, 4, ".")


def too_weak(drive: float, load: float) -> NoReturn:
    text = N_(
        "the machine does not start: at rest the driving moments on the main shaft are %(drive)s N·m, the resisting "
        "ones %(load)s N·m"
    )
    right = N_("a stronger motor, a greater ratio, a start without load, or another position to start from")
    raise _error(text, "motor", right, drive=_text(drive), load=_text(load))


def inverted(problem: Problem, path: tuple[str | int, ...], ratio: float) -> ProblemError:
    """Of a machine that would move with a ratio the other way round: the same problem with another cure."""
    right = N_(
        "look at %(key)s: it is the speed of that shaft by that of the main shaft, and with %(ratio)s, the other way "
        "round, the machine would move; else a stronger motor, or less load"
    )
    key = ".".join(map(str, path))
    return ProblemError(
        [replace(problem, right=Message(right, {"key": key, "ratio": _text(ratio)}), path=path)]
    )


def never(key: str, why: NeverReached, speed: float | None) -> ProblemError:
    """Of a start-up or a run-down that does not come to its end."""
    if why.why == "stall":
        text = N_(
            "the machine stops on the way, after turning by %(phi)s degrees: its kinetic energy is spent there"
        )
        right = N_("a greater moment of inertia, a stronger motor, or less load")
        return _error(text, key, right, phi=_text(math.degrees(why.phi)))
    if why.why == "away" and key == "start":
        text = N_(
            "the speed is never reached: from %(omega)s rad/s on the moments change the speed the other way"
        )
        right = N_("a speed at the end to which the moments lead")
        return _error(text, key, right, omega=_text(why.omega))
    if why.why in ("level", "away") and key == "coast":
        text = N_("the speed is never reached: at %(omega)s rad/s nothing is left that brakes the machine")
        right = N_("a constant friction or a brake, or a higher speed at the end")
        return _error(text, key, right, omega=_text(why.omega))
    if why.why == "level":
        text = N_(
            "the speed is never reached: at %(omega)s rad/s the moments are in balance and the speed grows no more"
        )
        return _error(
            text, key, N_("a speed between those at the beginning and in balance"), omega=_text(why.omega)
        )
    if speed is None:
        text = N_("the motion is not followed beyond %(turns)s turns: the speed is %(omega)s rad/s then")
        right = N_("a shorter time or a smaller angle")
        return _error(text, key, right, omega=_text(why.omega), turns=_text(why.phi / (2 * math.pi)))
    text = N_("the speed is not reached: after %(turns)s turns it is %(omega)s rad/s")
    turns = _text(why.phi / (2 * math.pi))
    return _error(
        text, key, N_("a speed that the moments can bring about"), omega=_text(why.omega), turns=turns
    )


def endless() -> ProblemError:
    text = N_("it is not said where the start-up ends: without a steady motion the speed changes without end")
    return _error(text, "start", N_("state speed, time or angle of the start-up"))


def never_steady() -> ProblemError:
    """Of a start-up without an end to a steady motion whose energy is stated and not come to by the moments."""
    text = N_(
        "it is not said where the start-up ends: no moment depends on the speed, so that a machine that is started "
        "does not come to its steady motion by itself"
    )
    right = N_("state speed, time or angle of the start-up, or a motor that depends on the speed")
    return _error(text, "start", right)


def already(omega: float, goal: float) -> ProblemError:
    """Of a start-up that is at its end as it begins."""
    text = N_("there is no start-up: it is to end at %(goal)s rad/s and begins at %(omega)s rad/s")
    right = N_("a speed at the beginning that is farther from that at the end")
    return _error(text, "start", right, omega=_text(omega), goal=_text(goal))


def not_slower() -> ProblemError:
    text = N_("the machine is to coast to a speed that is not lower")
    return _error(text, "coast", N_("a speed below that at the beginning"))


def not_steady(phi: float) -> ProblemError:
    text = N_(
        "there is no steady motion: near %(phi)s degrees the load takes more than the kinetic energy and the motor "
        "give, and the machine stops"
    )
    return _error(
        text, "motor", N_("a flywheel, a stronger motor, or less load"), phi=_text(math.degrees(phi))
    )


def no_level(moment: float, speed: float | None) -> ProblemError:
    if speed == 0:
        text = N_(
            "there is no steady motion: at every speed the mean resisting moment is greater than the driving one, by "
            "%(moment)s N·m at the beginning"
        )
        return _error(text, "motor", N_("a stronger motor, or less load"), moment=_text(-moment))
    text = N_(
        "there is no steady motion: the mean driving moment is greater than the resisting one at every speed, and the "
        "speed grows without end"
    )
    return _error(text, "motor", N_("a motor or a resistance that depends on the speed"))


def not_closed(work: float, driven: bool) -> ProblemError:
    right = N_(
        "a motor or a resistance that depends on the speed, or moments whose work over the cycle is zero"
    )
    if not driven:
        right = N_("state the motor, or leave out the moments that do not repeat")
    if work > 0:
        text = N_(
            "there is no steady motion: no moment depends on the speed, and each cycle leaves %(work)s J over: the "
            "speed grows from cycle to cycle"
        )
    else:
        text = N_(
            "there is no steady motion: no moment depends on the speed, and each cycle lacks %(work)s J: the speed "
            "falls from cycle to cycle"
        )
    return _error(text, "motor", right, work=_text(abs(work)))


def no_speed() -> ProblemError:
    text = N_("the mean speed of the steady motion is not known: the moments do not depend on the speed")
    return _error(text, "speed", N_("state speed of the main shaft"))


def coast_from() -> ProblemError:
    text = N_("the speed from which the machine runs down is not known: it has no steady motion")
    return _error(text, "coast", N_("state begin of the run-down"))
