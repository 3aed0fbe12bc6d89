"""The numbers of a crank-rocker, each assigned the expression that the note prints; what is free is searched for."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tmm_report.chapters.lever.synthesis.given import CrankRocker
from tmm_report.chapters.lever.synthesis.refused import mm, refused
from tmm_report.chapters.lever.synthesis.steps import SAME, between
from tmm_report.chapters.lever.synthesis.values import Values
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.quantity.formula import arccos, cos, sin, sqrt

MOST_FRAME = 10.0  # times the rocker: in step the transmission angle grows with the distance of the pivots


# ---------------------------------------------------------------- crank-rocker


def crank_rocker(s: Values, asked: CrankRocker) -> None:
    theta = between(s, asked.K)
    s.swing, s.rocker, s.mu_permitted = asked.swing, asked.rocker, asked.transmission
    half, swing = s.theta / 2, s.swing / 2
    s.half_chord = s.rocker * sin(swing)
    s.rise = s.rocker * cos(swing)
    if theta == 0:
        _in_step(s, asked)
    else:
        if asked.rod is not None:
            s.rod = asked.rod
            if s.number("rod") * math.sin(theta / 2) >= s.number("half_chord"):
                _no_such("rod", _longest(s.number("half_chord"), theta))
            s.crank = sqrt(s.half_chord**2 - s.rod**2 * sin(half) ** 2) / cos(half)
        else:
            s.crank = asked.crank if asked.crank is not None else _free_crank(s, theta, asked)
            if s.number("crank") * math.cos(theta / 2) >= s.number("half_chord"):
                _no_such("crank", s.number("half_chord"))
            s.rod = sqrt(s.half_chord**2 - s.crank**2 * cos(half) ** 2) / sin(half)
        s.along = s.crank * s.rod / s.half_chord
        s.away = (s.rod**2 - s.crank**2) * sin(s.theta) / (2 * s.half_chord)
        off = s.rise + s.away if asked.beyond else s.rise - s.away
        s.frame = sqrt(s.along**2 + off**2)
    _turns(s, asked)
    towards, from_ = s.frame - s.crank, s.frame + s.crank
    sides, both = s.rod**2 + s.rocker**2, 2 * s.rod * s.rocker
    s.mu_inner = arccos((sides - towards**2) / both)
    s.mu_outer = arccos((sides - from_**2) / both)
    s.transmission = min(s.number("mu_inner"), math.pi - s.number("mu_outer"))
    _placed(s, asked)


def _in_step(s: Values, asked: CrankRocker) -> None:
    """Both strokes last equally long: the crank is half the chord, its pivot lies on the chord."""
    s.crank = s.half_chord
    if asked.rod is not None:
        s.rod = asked.rod
        if asked.rod <= s.number("half_chord"):
            _no_such("rod", s.number("half_chord"), shortest=True)
        s.frame = sqrt(s.rod**2 + s.rise**2)
    else:
        s.frame = asked.frame if asked.frame is not None else _free_frame(s, asked)
        if s.number("frame") <= asked.rocker:
            _no_such("frame", asked.rocker, shortest=True)
        s.rod = sqrt(s.frame**2 - s.rise**2)
    s.along, s.away = s.number("rod"), 0.0


def _no_such(key: str, limit: float, shortest: bool = False) -> None:
    right = Message(
        N_("more than %(limit)s") if shortest else N_("less than %(limit)s"), {"limit": mm(limit)}
    )
    raise refused(
        N_("no crank-rocker of this swing and time ratio has such a length"), "crank_rocker", key, right=right
    )


def _longest(half: float, theta: float) -> float:
    return half / math.sin(theta / 2)


def family(s: Values, asked: CrankRocker, crank: np.ndarray) -> synthesis.CrankRockers:
    return synthesis.crank_rockers(s.number("theta"), asked.swing, asked.rocker, crank, asked.beyond)


def _free_crank(s: Values, theta: float, asked: CrankRocker) -> float:
    """Of the stated distance of the pivots, else of the best transmission angle."""
    if asked.frame is not None:
        found = _of_frame(s, asked, asked.frame)
        sound = [a for a in found if bool(family(s, asked, np.array([a])).sound[0])]
        if not sound:
            raise refused(
                N_("no crank-rocker of this swing and time ratio has this distance between the pivots"),
                "crank_rocker", "frame", right=_reach(s, asked),
            )  # fmt: skip
        return max(sound, key=lambda a: float(family(s, asked, np.array([a])).transmission[0]))
    return _best_crank(s, asked)


def _reach(s: Values, asked: CrankRocker) -> Message:
    """How far apart the pivots of the sound linkages are, within a grid; or that they lie on the other side."""
    if not asked.beyond and asked.frame is not None:
        other = replace(asked, beyond=True)
        cranks = _of_frame(s, other, asked.frame)
        if family(s, other, cranks).sound.any():
            return Message(N_("beyond the chord the pivot of the crank may have it: beyond: true"))
    of = family(s, asked, _longest_crank(s) * np.linspace(1e-3, 1.0, 721))
    if not of.sound.any():
        return Message(N_("leave it out: the best transmission angle chooses"))
    ends = {"least": mm(float(of.d[of.sound].min())), "most": mm(float(of.d[of.sound].max()))}
    return Message(N_("from some %(least)s to %(most)s; left out, the best transmission angle chooses"), ends)


def solutions(s: Values, asked: CrankRocker) -> np.ndarray:
    """All sound linkages of the demand, (4, N): crank, rod, distance of the pivots, least transmission angle; first
    that which is taken, then those with the crank's pivot on the same side of the chord, then on the other one."""
    taken = s.number("crank")
    columns = []
    for beyond in (asked.beyond, not asked.beyond):
        side = replace(asked, beyond=beyond)
        cranks = np.array([taken])
        if asked.frame is not None:
            cranks = _of_frame(s, side, asked.frame)
            cranks = cranks[np.argsort(np.abs(cranks - taken))]
        elif asked.crank is None and asked.rod is None and beyond != asked.beyond:
            try:
                cranks = np.array([_best_crank(s, side)])
            except ProblemError:  # none turns round
                cranks = np.zeros(0)
        of = family(s, side, cranks)
        columns.append(np.array([cranks, of.b, of.d, of.transmission])[:, of.sound])
    return np.concatenate(columns, axis=1)


def _of_frame(s: Values, asked: CrankRocker, frame: float) -> np.ndarray:
    """Cranks with which the pivots are so far apart."""
    most = _longest_crank(s)
    return np.asarray(synthesis.roots(lambda a: family(s, asked, a).d - frame, most * 1e-6, most))


def _best_crank(s: Values, asked: CrankRocker) -> float:
    """That of the best transmission angle. Raises ProblemError where none turns round."""
    return _best(lambda a: family(s, asked, a).transmission, _longest_crank(s))


def _longest_crank(s: Values) -> float:
    return s.number("half_chord") * (1 - SAME)


def _best(angle: Callable[[np.ndarray], np.ndarray], most: float, low: float = 1e-6) -> float:
    try:
        return synthesis.least(lambda x: -angle(x), most * low, most)[0]
    except ValueError:
        raise refused(
            N_("there is no crank-rocker of this swing and time ratio: each would have to be assembled anew"),
            "crank_rocker", "K", right=Message(N_("a smaller K, or a smaller swing")),
        ) from None  # fmt: skip


def _free_frame(s: Values, asked: CrankRocker) -> float:
    c = asked.rocker
    most = MOST_FRAME * c

    def angle(d: np.ndarray) -> np.ndarray:
        return synthesis.in_step(asked.swing, c, s.number("half_chord"), d).transmission

    return _best(angle, most, low=(1 + SAME) / MOST_FRAME)


def _turns(s: Values, asked: CrankRocker) -> None:
    a, b, c, d = (s.number(key) for key in ("crank", "rod", "rocker", "frame"))
    stated = next((key for key in ("crank", "rod", "frame") if getattr(asked, key) is not None), "K")
    sides = sorted((b, c, d))
    if a >= sides[0] or a + sides[2] > (sides[0] + sides[1]) * (1 + SAME):
        raise refused(
            N_("the crank of %(crank)s cannot turn round: with %(others)s the shortest and the longest link are longer "
            "than the other two"),
            "crank_rocker", stated, right=Message(N_("leave it out: the best transmission angle chooses")),
            crank=mm(a), others=Message("%(b)s, %(c)s, %(d)s", {"b": mm(b), "c": mm(c), "d": mm(d)}),
        )  # fmt: skip
    if s.number("theta") and not bool(family(s, asked, np.array([a])).one_assembly[0]):
        raise refused(
            N_("the linkage would have to be assembled anew between its extreme positions"),
            "crank_rocker", stated, right=Message(N_("leave it out: the best transmission angle chooses")),
        )  # fmt: skip


def _placed(s: Values, asked: CrankRocker) -> None:
    """Where the rocker's pivot is from the crank's, by the direction of the middle position of the rocker."""
    middle = complex(math.cos(asked.middle), math.sin(asked.middle))
    across = 1j * middle
    if (across.conjugate() * asked.crank_at).real < 0:
        across = -across
    away = s.number("away") if asked.beyond else -s.number("away")
    place = middle * (s.number("rise") + away) + across * s.number("along")
    s.frame_x, s.frame_y = -place.real, -place.imag
