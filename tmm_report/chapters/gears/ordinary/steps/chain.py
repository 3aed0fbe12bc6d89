"""A chain drive: sprockets, an even number of links and the distance that it gives, unevenness, tension."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.given import ChainStage
from tmm_report.chapters.gears.ordinary.values import Chain
from tmm_report.mechanics.gears import belts, trains
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake
from tmm_report.quantity.formula import PI, Expr, cos, sin, sqrt

FORTY = 40  # pitches: the usual distance of the centres


def geometry(s: Chain, of: ChainStage) -> None:
    """Raises ProblemError for sprockets that meet and for too few links."""
    s.u_required, s.p, s.z1 = of.ratio, of.pitch, float(of.z[0])
    if not isinstance(of.teeth, tuple):
        s.z_exact = s.z1 * s.u_required
    s.z2 = float(of.z[1])
    s.u = s.z2 / s.z1
    s.d1 = s.p / sin(PI / s.z1)
    s.d2 = s.p / sin(PI / s.z2)
    if of.links is None:
        s.a_about = FORTY * of.pitch if of.distance is None else of.distance
        _check(s, s.number("a_about"))
        bent = ((s.z2 - s.z1) / (2 * PI)) ** 2
        s.links_about = 2 * s.a_about / s.p + (s.z1 + s.z2) / 2 + bent * s.p / s.a_about
    s.links = float(of.links or 2 * round(s.number("links_about") / 2))
    _enough(s)
    left = s.links - (s.z1 + s.z2) / 2
    s.a = s.p / 4 * (left + sqrt(left**2 - 8 * ((s.z2 - s.z1) / (2 * PI)) ** 2))
    _check(s, s.number("a"))
    if of.slack:
        s.slack = of.slack
        s.a_put = s.a * (1 - s.slack)
    s.L = s.links * s.p


def _check(s: Chain, distance: float) -> None:
    """The sprockets do not meet."""
    least = (s.number("d1") + s.number("d2")) / 2
    if distance <= least:
        wrong = N_("at a distance of %(distance)s mm the sprockets meet")
        right = Message(N_("a centre distance above %(least)s mm"), {"least": f"{1e3 * least:.5g}"})
        raise ProblemError([mistake(wrong, ("distance",), right, distance=f"{1e3 * distance:.5g}")])


def _enough(s: Chain) -> None:
    """The formula of the distance has a root, and the chain reaches about both sprockets."""
    one, two = s.number("d1"), s.number("d2")
    least = belts.length(one, two, (one + two) / 2, False) / s.number("p")
    if s.number("links") <= least:
        wrong = N_("a chain of %(links)s links is too short for the sprockets")
        right = Message(N_("more than %(least)s links"), {"least": f"{least:.4g}"})
        raise ProblemError([mistake(wrong, ("links",), right, links=f"{s.number('links'):.0f}")])


def doubts(of: ChainStage) -> tuple[Problem, ...]:
    """An odd number of links."""
    if of.links is None or of.links % 2 == 0:
        return ()
    text = N_("a chain of an odd number of links, %(links)s, is closed by a bent link, which is weaker")
    return (doubt(text, ("links",), Message(N_("an even number of links")), links=of.links),)


def members(s: Chain, of: ChainStage) -> tuple[trains.Member, ...]:
    """Their radii are those at which a belt would run with the mean velocity of the chain."""
    rolling = [z * of.pitch / (2 * math.pi) for z in of.z]
    one, two = of.wheels
    return (
        trains.Member(one, "wheel", of.z[0], rolling[0]),
        trains.Member(two, "wheel", of.z[1], rolling[1], s.number("a")),
    )


def meshes(s: Chain, of: ChainStage) -> tuple[trains.Mesh, ...]:
    one, two = of.wheels
    return (trains.Mesh(one, two, internal=True, efficiency=of.eta, apart=True),)


def work(s: Chain, of: ChainStage, speed: float, torque: float | None) -> None:
    """`speed`: of the driving sprocket, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    s.v = s.omega1 * s.z1 * s.p / (2 * PI)
    s.v_max = s.omega1 * s.d1 / 2
    s.v_min = s.v_max * cos(PI / s.z1)
    s.delta = (s.v_max - s.v_min) / s.v
    if torque is None or not speed:
        return
    s.T1 = abs(torque)
    force: Expr = s.T1 * s.omega1 / s.v
    s.F_t = force
    if of.mass is not None:
        s.q = of.mass
        s.F_c = s.q * s.v**2
        s.F_tight = s.F_t + s.F_c
