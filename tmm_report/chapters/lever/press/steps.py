"""The single numbers of a press, each assigned the expression that the note prints."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.text import number

if TYPE_CHECKING:
    from tmm_report.chapters.lever.press.solve import Found


def worked(found: Found) -> Found:
    """With its numbers. Raises ProblemError."""
    s = found.s
    s.omega, s.alpha_dead = float(np.abs(np.ravel(found.kinematics.table.omega)[0])), found.dead
    s.stroke, s.alpha_stroke = float(found.path(found.before([found.begins]))[0]), found.begins
    given, always = found.given, False
    if given.torque is not None:
        always = _forces(found, given.torque)
    if given.within is not None:
        _dwells(found, given.within)
    if given.working is not None:
        _works(found, *given.working)
    return replace(found, always=always)


def _forces(found: Found, torque: float) -> bool:
    """Whether the rated force is permitted over the whole stroke."""
    s = found.s
    s.torque, s.h_max = torque, float(found.arm(found.before([0.0, *found.peaks])).max())
    s.F_least = s.torque / s.h_max
    if found.given.rated is None:
        return False
    s.rated = found.given.rated
    s.h_nom = s.torque / s.rated
    limit = s.number("h_nom")
    before, _ = found.where(lambda motion: found.arm(motion) - limit)
    s.alpha_nom = float(before[0]) if before.size else found.begins
    s.s_nom = float(found.path(found.before([s.number("alpha_nom")]))[0])
    return not before.size


def _dwells(found: Found, within: float) -> None:
    s = found.s
    before, after = found.where(lambda motion: found.path(motion) - within)
    if not before.size:
        _too_long(found, ("press", "within"))
    s.within, s.before, s.after = within, float(before[0]), float(after[0])
    s.dwell = s.before + s.after
    s.t_dwell = s.dwell / s.omega


def _works(found: Found, first: float, last: float) -> None:
    s = found.s
    begin, end = found.at_path(first), found.at_path(last)
    if np.isnan(begin):
        _too_long(found, ("press", "working"))
    s.s_1, s.s_2, s.alpha_1, s.alpha_2 = first, last, begin, end
    s.t_working = (s.alpha_1 - s.alpha_2) / s.omega
    s.v_mean = (s.s_1 - s.s_2) / s.t_working
    inner = found.peaks[(found.peaks > end) & (found.peaks < begin)]
    alpha = np.array([begin, *inner, end])
    speeds = np.where(alpha == 0, 0.0, found.output.velocity(found.before(alpha)))  # in the dead point itself
    s.v_max, s.v_min = float(speeds.max()), float(speeds.min())
    s.peak = s.v_max / s.v_mean
    s.unevenness = (s.v_max - s.v_min) / s.v_mean


def _too_long(found: Found, path: tuple[str, ...]) -> None:
    stroke = number(found.s.number("stroke") * 1e3, 5, ".")
    right = Message(
        N_("less than the stroke of the slider to its dead point, %(stroke)s mm"), {"stroke": stroke}
    )
    raise ProblemError([mistake(N_("the slider does not go so far from its dead point"), path, right)])
