"""What a cam states of its follower's motion: a law by phases or by a table, or the cam's own profile. What cannot be
built raises Wrong with the key that is wrong."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from tmm_report.chapters.cams.cam.block import models as c
from tmm_report.mechanics.cams.cam import Sliding, Swinging
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Kind, Law, Phase, Phases, Tabled
from tmm_report.mechanics.cams.stated_profile import ByProfile, Circle, Polar
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue


class Wrong(WrongValue):
    """A mistake of one key of a cam."""

    def __init__(self, key: str, wrong: Message, right: Message | None = None):
        super().__init__(wrong, right)
        self.key = key


def law(model: c.CamStated, swings: bool) -> Law:
    """The law of the follower; its lift, m, of one that slides, rad of one that swings."""
    wanted, other = ("swing", "lift") if swings else ("lift", "swing")
    table, foreign = (model.swings, model.lifts) if swings else (model.lifts, model.swings)
    if getattr(model, other) is not None or foreign:
        text = (
            N_("a swinging follower has a swing, not a lift")
            if swings
            else N_("a sliding follower has a lift, not a swing")
        )
        raise Wrong(other if getattr(model, other) is not None else f"{other}s", Message(text))
    if table:
        return _tabled(table, f"{wanted}s")
    if (height := getattr(model, wanted)) is None:
        raise Wrong(wanted, Message(N_("the key %(key)s is missing"), {"key": wanted}))
    return Phases(turn_of(model.phases), height)


def turn_of(stated: Sequence[c.PhaseModel], back: bool = True, divided: bool = True) -> tuple[Phase, ...]:
    """The phases, those of no angle left out. They fill a turn, and rises and returns take turns, from the lowest
    position, `back` to it in the end; `divided`: whether they may be divided into parts."""
    phases = [phase_of(one, dwell) for one, dwell in zip(stated, _dwells(stated), strict=True)]
    if not divided and any(phase.parts for phase in phases):
        raise Wrong("phases", Message(N_("the phases of a cam alone are divided into parts")))
    whole = math.degrees(sum(phase.angle for phase in phases))
    if abs(whole - 360.0) > 1e-6:
        text = N_("the phases of the law make %(sum)s° and not 360°")
        raise Wrong("phases", Message(text, {"sum": f"{whole:.6g}"}))
    ways = [phase.kind for phase in phases if phase.kind != "dwell"]
    alternate = (["rise", "return"] * len(ways))[: len(ways)]
    if not ways or ways != alternate or (back and len(ways) % 2):
        text = N_("rises and returns do not take turns, beginning with a rise and ending with a return")
        if not back:
            text = N_("rises and returns do not take turns, beginning with a rise")
        raise Wrong(
            "phases", Message(text), Message(N_("begin with a rise from the lowest position; start turns it"))
        )
    return tuple(phase for phase in phases if phase.angle > 0)


def _dwells(stated: Sequence[c.PhaseModel]) -> list[float]:
    """The angles of the dwells, rad: those that are to be the rest of the turn share what the others leave."""
    sums = [sum(x for x in (one.rise, one.dwell, one.return_) if isinstance(x, float)) for one in stated]
    left, sharing = FULL_TURN - sum(sums), sum(one.dwell == "rest" for one in stated)
    if sharing and left < -1e-9:
        text = N_("the other phases take %(sum)s° already: nothing of the turn is left for a dwell")
        raise Wrong("phases", Message(text, {"sum": f"{math.degrees(sum(sums)):.6g}"}))
    share = max(left, 0.0) / sharing if sharing else 0.0
    return [share if one.dwell == "rest" else float(one.dwell or 0.0) for one in stated]


def phase_of(model: c.PhaseModel, dwell: float) -> Phase:
    kinds: tuple[tuple[Kind, float | None], ...] = (
        ("rise", model.rise), ("dwell", None if model.dwell is None else dwell), ("return", model.return_),
    )  # fmt: skip
    kind, angle = next((kind, angle) for kind, angle in kinds if angle is not None)
    return Phase(kind, angle, model.shape(), model.divisions or 0)


def _tabled(table: list[tuple[float, float]], key: str) -> Tabled:
    angles = [angle for angle, _ in table]
    if len(angles) > 1 and abs(angles[-1] - angles[0] - FULL_TURN) < 1e-9 and table[-1][1] == table[0][1]:
        table, angles = table[:-1], angles[:-1]
    if len(angles) < 8 or any(b - a < 1e-6 for a, b in pairwise(angles)):
        raise Wrong(key, Message(N_("a table of a law has at least 8 ascending angles")))
    if angles[-1] - angles[0] >= FULL_TURN - 1e-6:
        raise Wrong(key, Message(N_("a table of a law goes once round, below 360° from its first angle")))
    gap = angles[0] + FULL_TURN - angles[-1]
    if gap > max(b - a for a, b in pairwise(angles)) + 1e-6:  # a curve of its own making, not a straight line
        told = {
            "last": f"{math.degrees(angles[-1]):.6g}",
            "next": f"{math.degrees(angles[0] + FULL_TURN):.6g}",
        }
        text = N_("nothing is stated from %(last)s to %(next)s deg, where the next cycle begins")
        right = N_("go on all round, also where the follower stands still")
        raise Wrong(key, Message(text, told), Message(right))
    if min(value for _, value in table) < 0:
        raise Wrong(key, Message(N_("lifts are counted from the base circle: none is negative")))
    return Tabled(tuple(angles), tuple(value for _, value in table))


# ---------------------------------------------------------------- the profile


def by_profile(
    model: c.CamStated, motion: Sliding | Swinging, roller: float | None, face: complex
) -> ByProfile:
    for key in ("base", "pitch_base", "lift", "swing", "start"):
        if getattr(model, key, None) is not None:
            raise Wrong(key, Message(N_("this follows from the profile of the cam")))
    if roller is None and isinstance(motion, Swinging):
        right = N_("state its law, or let it end in a roller")
        raise Wrong(
            "profile", Message(N_("a swinging flat face is not found from a profile")), Message(right)
        )
    assert model.profile is not None
    return ByProfile(_curve(model.profile), motion, roller, face)


def _curve(model: c.ProfileModel) -> Circle | Polar:
    if model.circle:
        centre = complex(*model.circle.at)
        if abs(centre) >= model.circle.radius:
            raise Wrong("profile", Message(N_("the cam's pivot lies outside its circle")))
        return Circle(centre, model.circle.radius)
    polar = model.polar or [(math.atan2(y, x), math.hypot(x, y)) for x, y in model.points or []]
    pairs = sorted((angle % FULL_TURN, radius) for angle, radius in polar)
    steps = [b[0] - a[0] for a, b in pairwise(pairs)]
    if len(pairs) < 8 or min(steps) < 1e-6 or max([*steps, FULL_TURN - sum(steps)]) > math.pi / 2:
        text = N_("a profile has at least 8 points all round its pivot, each in a direction of its own")
        raise Wrong("profile", Message(text))
    return Polar(tuple(angle for angle, _ in pairs), tuple(radius for _, radius in pairs))
