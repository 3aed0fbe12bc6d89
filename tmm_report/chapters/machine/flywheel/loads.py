"""The cycle of the machine that the flywheel is for: its loads and moments of inertia, of a solved lever mechanism or
as they are stated."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.chapters.lever.moving import Machine, Moving, machine
from tmm_report.chapters.machine.flywheel.given import Areas, Given, Punch
from tmm_report.mechanics.calculus.laws import ByAngle, Constant, Law
from tmm_report.mechanics.calculus.panels import NARROWEST, WIDEST, Panels, panels
from tmm_report.mechanics.machine.flywheel.inertia import Cycle
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
CLOSED = 0.01  # of the work of a cycle: by so much the works of both sides may differ
EVEN = 1e-12  # of the inertia: what varies less is a constant part
FULL_TURN = 2 * math.pi
POSITIONS, DRAWN = 24, 72  # of the table and of the diagrams over a stated cycle


@dataclass(frozen=True, eq=False)
class Sides:
    """The cycle with both its sides, N m at the points of the panels: `driving` ≥ 0 on the whole, `resisting` ≤ 0; None
    where only the excess is stated. `balancing`: the side that was found as the constant moment that closes the cycle,
    "" where both are stated; `spread`: the moment, N m, by which they did not close, taken out of the excess."""

    cycle: Cycle
    driving: Array | None
    resisting: Array | None
    balancing: str
    spread: float
    turned: Array  # of the table's positions, rad
    drawn: Array  # of the diagrams'
    links: float = 0.0  # kg m²: those parts of the links' inertia that do not vary
    machine: Machine | None = None  # the mechanism, where there is one
    uneven: tuple[str, ...] = ()  # its links whose inertia varies

    @property
    def rubbing(self) -> Array | None:
        """Moment of the friction of the pairs, a part of `resisting`; None where there is none in it."""
        friction = self.machine.friction if self.machine else None
        return None if friction is None or friction.moment is None else -friction.moment


def sides(given: Given, moving: Moving | None, omega: float) -> Sides:
    """Raises ProblemError where the cycle does no work, or its works do not close."""
    return _of_mechanism(given, moving) if moving else _stated(given, omega)


# ---------------------------------------------------------------- of a lever mechanism


def _of_mechanism(given: Given, moving: Moving) -> Sides:
    """All its loads are one side: they resist where with the friction of the pairs they take work over the cycle, and
    drive where they give it; the friction resists."""
    found, kinematics = machine(moving, given.friction is not False), moving.kinematics
    parts = found.inertia
    even = tuple(link for link, part in parts.items() if np.ptp(part) <= EVEN * np.max(part))
    links = sum(float(np.mean(parts[link])) for link in even)
    uneven = tuple(link for link in parts if link not in even)
    varying = sum((parts[link] for link in uneven), np.zeros(found.panels.shape))
    loads, rubbing = found.whole_moment, found.rubbing
    mean = _mean(found.panels, loads + rubbing, "loads")
    driven = mean < 0
    other = np.full(found.panels.shape, -mean)
    return Sides(
        Cycle(found.panels, loads + rubbing - mean, varying, _constant(given, found.omega) + links),
        other if driven else loads,
        loads + rubbing if driven else other + rubbing,
        "driving" if driven else "resisting",
        0.0,
        kinematics.turned,
        kinematics.diagram_turned,
        links,
        found,
        uneven,
    )


def _mean(over: Panels, moment: Array, key: str) -> float:
    """Mean moment of the stated side. Raises ProblemError where its work over the cycle is nothing."""
    mean = float(over.mean(moment))
    if not abs(mean) > 1e-9 * float(np.max(np.abs(moment), initial=0.0)):
        text = N_("the loads do no work over the cycle: nothing drives and nothing is driven")
        right = Message(N_("state the load that takes the work, or the moment that drives"))
        raise ProblemError([mistake(text, (key,), right)])
    return mean


# ---------------------------------------------------------------- stated


def period(given: Given, omega: float) -> float:
    """The angle of a cycle, rad."""
    return omega * given.punch.period if given.punch else FULL_TURN * (given.turns or 1)


def _stated(given: Given, omega: float) -> Sides:
    whole = period(given, omega)
    driven, resisted = _laws(given, omega)
    between = _of_areas(given.areas, whole) if given.areas else None
    of_inertia = _repeated_inertia(given, whole)
    over = _panels(whole, [law for law in (driven, resisted, between, of_inertia) if law])
    driving = driven.value(over.x) if driven else None
    resisting = -resisted.value(over.x) if resisted else None
    balancing, spread = "", 0.0
    if between:
        excess = between.value(over.x)
    else:
        driving, resisting, balancing, spread = _both(over, driving, resisting)
        excess = driving + resisting - spread
    cycle = Cycle(over, excess, _inertia(of_inertia, over), _constant(given, omega))
    count = given.positions or POSITIONS
    turned, drawn = (_on_edges(over, n) for n in (count, count * max(1, DRAWN // count)))
    return Sides(cycle, driving, resisting, balancing, spread, turned, drawn)


def _on_edges(over: Panels, count: int) -> Array:
    """Equal parts of the cycle; what is next to an edge is the edge, so that at a jump the value after it holds."""
    turned = np.arange(count + 1) * (over.period / count)
    nearest = over.edges[np.argmin(np.abs(turned[:, None] - over.edges), axis=1)]
    return np.where(np.abs(turned - nearest) < NARROWEST * over.period, nearest, turned)


def _laws(given: Given, omega: float) -> tuple[Law | None, Law | None]:
    """Of the driving and of the resisting side, each as it is stated, over the whole cycle."""
    whole = period(given, omega)
    driving = given.driving.law if given.driving else None
    resisting = given.resisting.law if given.resisting else None
    if given.punch:
        resisting = _stroke(given.punch, omega)
    return driving and driving.repeating(whole), resisting and resisting.repeating(whole)


def _stroke(punch: Punch, omega: float) -> ByAngle:
    """The resistance of a punch: its work spread evenly over the stroke, at the beginning of the cycle."""
    end, moment = omega * punch.time, punch.work / (omega * punch.time)
    return ByAngle((0.0, end, end, omega * punch.period), (moment, moment, 0.0, 0.0))


def _panels(whole: float, laws: list[Law]) -> Panels:
    """Edges at the breaks of all the laws, and narrow enough for the highest harmonic."""
    marks = [one.at for law in laws for one in law.breaks(whole)]
    widest = min(WIDEST * max(1.0, whole / FULL_TURN), math.pi / 2, *(law.widest for law in laws))
    return panels(whole, marks, widest)


def _repeated_inertia(given: Given, whole: float) -> Law:
    """The moment of inertia over the whole cycle: what is stated of one turn repeats in every turn."""
    of = given.varying
    one_turn = given.turns not in (None, 1) and all(one.at <= FULL_TURN * (1 + 1e-12) for one in of.breaks())
    return of.repeating(FULL_TURN if one_turn else whole)


def _inertia(law: Law, over: Panels) -> Array:
    """J_II at the points: of a table all that it states. Raises ProblemError where no masses have such inertia."""
    if isinstance(law, Constant):
        return np.zeros(over.shape)
    found = law.value(over.x)
    (least, at), _ = over.extremes(found)
    if least < -EVEN * np.max(np.abs(found)):
        text = N_(
            "at %(angle)s deg the moment of inertia would be %(least)s kg·m²: no mass has a negative one"
        )
        right = Message(N_("state the mean with the harmonics: they take away no more than it has"))
        values = {"angle": f"{math.degrees(at):.4g}", "least": f"{least:.4g}"}
        raise ProblemError([mistake(text, ("flywheel", "inertia"), right, **values)])
    _without_jumps(over, found)
    return found


def _without_jumps(over: Panels, inertia: Array) -> None:
    """Raises ProblemError where the inertia jumps: masses do not come and go within the cycle."""
    ends = over.ends(inertia)
    before, after = ends[:, 1], np.roll(ends[:, 0], -1)
    k = int(np.argmax(np.abs(after - before)))
    if abs(after[k] - before[k]) > 1e-9 * np.max(inertia):
        text = N_(
            "at %(angle)s deg the moment of inertia jumps from %(before)s to %(after)s kg·m²: no mass comes or goes"
        )
        right = Message(
            N_("state one value at each angle, and at the end of the cycle that of its beginning")
        )
        angle = math.degrees(over.edges[1:][k])
        values = {"angle": f"{angle:.4g}", "before": f"{before[k]:.4g}", "after": f"{after[k]:.4g}"}
        raise ProblemError([mistake(text, ("flywheel", "inertia"), right, **values)])


def _constant(given: Given, omega: float) -> float:
    """What turns with the main link besides the flywheel, the motor's rotor reduced to it, kg m²."""
    rotor = given.motor.inertia * (given.motor.speed / omega) ** 2 if given.motor else 0.0
    return given.fixed + rotor


def mean_speed(given: Given) -> float:
    """ω_m of the main link of a machine that stands alone, rad/s: stated, or between the stated speeds."""
    if given.speeds:
        return (given.speeds[0] + given.speeds[1]) / 2
    if given.speed is not None:
        return given.speed
    assert given.motor is not None  # the block asks for one of the three
    return given.motor.speed


def _of_areas(areas: Areas, whole: float) -> ByAngle:
    """A moment that gives the stated works one after another, each over its equal part of the cycle. Raises
    ProblemError where they do not close."""
    works = np.array(areas.works)
    if abs(works.sum()) > CLOSED * np.abs(works).max():
        text = N_("the work of the cycle does not close: the areas make %(left)s J together, not zero")
        right = Message(N_("what is above the line of the mean moment is as much as what is below it"))
        raise ProblemError([mistake(text, ("flywheel", "areas"), right, left=f"{works.sum():.6g}")])
    count = len(works)
    moments = (works - works.mean()) * (count / whole)
    ends = [whole * k / count for k in range(count + 1)]
    return ByAngle(
        tuple(x for pair in pairwise(ends) for x in pair), tuple(np.repeat(moments, 2).tolist()), whole
    )


def _both(over: Panels, driving: Array | None, resisting: Array | None) -> tuple[Array, Array, str, float]:
    """The side that is not stated is the constant moment that closes the cycle. Raises ProblemError where both are
    stated and do not close, or where the only one does the other's work."""
    if driving is not None and resisting is not None:
        return driving, resisting, "", _closed(over, driving, resisting)
    stated, key = (driving, "driving") if driving is not None else (resisting, "resisting")
    assert stated is not None
    mean = _mean(over, stated, "flywheel")
    if (mean > 0) != (key == "driving"):
        text = N_("over the cycle the driving moment takes work: %(work)s J")
        if key == "resisting":
            text = N_("over the cycle the resisting moment gives work: %(work)s J")
        right = Message(N_("a driving moment is positive where it drives, a resisting one where it resists"))
        work = f"{abs(mean) * over.period:.6g}"
        raise ProblemError([mistake(text, ("flywheel", key), right, work=work)])
    other = np.full(over.shape, -mean)
    return (stated, other, "resisting", 0.0) if key == "driving" else (other, stated, "driving", 0.0)


def _closed(over: Panels, driving: Array, resisting: Array) -> float:
    """The moment left over of both sides. Raises ProblemError where it is too large for a rounding of the data."""
    given, taken = float(over.total(driving)), -float(over.total(resisting))
    left = (given - taken) / over.period
    if abs(given - taken) > CLOSED * max(abs(given), abs(taken)):
        text = N_(
            "the work of the cycle does not close: the driving moment gives %(given)s J, the resisting one takes "
            "%(taken)s J, so the speed would change from cycle to cycle"
        )
        right = Message(N_("leave one of them out: it is then the constant moment that closes the cycle"))
        values = {"given": f"{given:.6g}", "taken": f"{taken:.6g}"}
        raise ProblemError([mistake(text, ("flywheel", "driving"), right, **values)])
    return left
