"""The numbers of linkages through stated points: a function or three pairs of angles, a dwell by three points
of a path."""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.lever.synthesis.given import AnglePairs, Dwell, Generator
from tmm_report.chapters.lever.synthesis.refused import mm, refused
from tmm_report.chapters.lever.synthesis.steps import SAME
from tmm_report.chapters.lever.synthesis.values import Pairs, Path, Values
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import sqrt
from tmm_report.quantity.model import Table

# ---------------------------------------------------------------- a function


def generator(s: Values, asked: Generator) -> tuple[Table, synthesis.FourBar]:
    low, high = asked.x
    if not low < high:
        right = Message(N_("for example, %(example)s"), {"example": "x: [1, 2]"})
        raise refused(N_("the range of the variable goes upwards"), "function", "x", right=right)
    at = points(asked)
    x = (low + high) / 2 + (high - low) / 2 * at
    y = asked.y(x)
    if not asked.y.defined(low, high) or asked.y(low) == asked.y(high):
        raise refused(
            N_("the function has no finite values over the range, or equal ones at its ends"), "function", "x",
            right=Message(N_("a range over which the function goes from one value to another")),
        )  # fmt: skip
    phi, psi = angles(asked, x)
    s.low, s.high = low, high
    s.take(asked, "frame", "crank_from", "crank_turn", "rocker_from", "rocker_turn")
    bar = _through(s, phi, psi)
    table = Table(
        "synthesis_pairs", Message(N_("precision points")),
        (Pairs.x.column(x), Pairs.y.column(y), Pairs.phi.column(phi), Pairs.psi.column(psi)),
    )  # fmt: skip
    _judged(s, asked, bar)
    return table, bar


def _through(s: Values, phi: np.ndarray, psi: np.ndarray) -> synthesis.FourBar:
    """Of three pairs of angles, rad. Raises ProblemError where no linkage goes through them."""
    right = Message(N_("other angles of crank and rocker"))
    try:
        s.k1, s.k2, s.k3 = synthesis.through_pairs(phi, psi, s.number("frame"))
    except np.linalg.LinAlgError:
        raise refused(
            N_("no four-bar linkage has these three pairs of angles"), "function", right=right
        ) from None
    if min(abs(s.number("k2")), abs(s.number("k3"))) < SAME * max(1.0, abs(s.number("k1"))):
        raise refused(N_("a link would be infinitely long: both angles go alike"), "function", right=right)
    s.crank = s.frame / s.k2
    s.rocker = s.frame / s.k3
    squares = s.crank**2 + s.rocker**2 + s.frame**2
    s.rod = sqrt(squares - 2 * s.k1 * s.crank * s.rocker)
    if not math.isfinite(s.number("rod")) or s.number("rod") <= 0:
        wrong = N_("no rod joins these cranks: the square of its length would be negative")
        raise refused(wrong, "function", right=right)
    return _one_branch(s, phi, psi)


def points(asked: Generator) -> np.ndarray:
    """Of accuracy, −1 … 1."""
    if asked.spacing == "ends":
        return np.array([-1.0, 0.0, 1.0])
    return -np.cos((2 * np.arange(1, 4) - 1) * np.pi / 6)


def angles(asked: Generator, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of crank and rocker, rad, that are wanted."""
    low, high = asked.x
    first, last = asked.y(low), asked.y(high)
    phi = asked.crank_from + asked.crank_turn * (x - low) / (high - low)
    return phi, asked.rocker_from + asked.rocker_turn * (asked.y(x) - first) / (last - first)


def _one_branch(s: Values, phi: np.ndarray, psi: np.ndarray) -> synthesis.FourBar:
    """The assembly in which all pairs are met. Raises ProblemError where there is none."""
    sizes = (s.number(key) for key in ("crank", "rod", "rocker", "frame"))
    a, b, c, d = sizes
    for side in (1, -1):
        bar = synthesis.FourBar(a, b, c, d, side)
        if np.abs(bar.rocker(phi) - np.exp(1j * psi)).max() < 1e-6:
            return bar
    raise refused(
        N_("the three pairs are of different assemblies: the linkage cannot go from one to the next"), "function",
        right=Message(N_("other angles of crank and rocker")),
    )  # fmt: skip


def differences(asked: Generator, bar: synthesis.FourBar, x: np.ndarray) -> np.ndarray:
    """Angle of the rocker less the wanted one, rad."""
    phi, psi = angles(asked, x)
    return np.angle(bar.rocker(phi) * np.exp(-1j * psi))


def greatest_error(asked: Generator, bar: synthesis.FourBar) -> float:
    """Over the range, rad."""
    return -synthesis.least(lambda x: -np.abs(differences(asked, bar, x)), *asked.x)[1]


def _judged(s: Values, asked: Generator, bar: synthesis.FourBar) -> None:
    low, high = asked.x
    grid = np.linspace(low, high, 721)
    if not np.isfinite(bar.rocker(angles(asked, grid)[0])).all():
        raise refused(
            N_("the linkage cannot be assembled all over the range"), "function",
            right=Message(N_("a smaller turn of the crank, or other angles")),
        )  # fmt: skip
    s.error = greatest_error(asked, bar)
    s.transmission = synthesis.least(lambda x: bar.transmission(angles(asked, x)[0]), low, high)[1]


# ---------------------------------------------------------------- pairs of angles


def pairs(s: Values, asked: AnglePairs) -> tuple[Table, synthesis.FourBar]:
    phi, psi = np.array(asked.pairs).T
    if not np.prod(np.diff(phi)) > 0:
        wrong = N_(
            "the crank goes through its three angles in one sense, to and fro it would come to one twice"
        )
        right = Message(N_("the pairs in the order in which the crank goes through them"))
        raise refused(wrong, "function", "pairs", right=right)
    s.take(asked, "frame")
    bar = _through(s, phi, psi)
    if not np.isfinite(bar.rocker(np.linspace(phi[0], phi[-1], synthesis.GRID + 1))).all():
        wrong = N_("the linkage comes apart between the pairs")
        raise refused(wrong, "function", right=Message(N_("other angles of crank and rocker")))
    s.transmission = synthesis.least(bar.transmission, *sorted((phi[0], phi[-1])))[1]
    table = Table(
        "synthesis_pairs", Message(N_("pairs of angles")), (Pairs.phi.column(phi), Pairs.psi.column(psi))
    )
    return table, bar


# ---------------------------------------------------------------- a dwell


def dwell(s: Values, asked: Dwell) -> Table:
    s.crank, s.rod, s.rocker, s.frame = asked.crank, asked.coupler, asked.rocker, asked.frame
    s.point_x, s.point_y = asked.point
    _goes_round(asked)
    place = traced(asked, linkage(asked), np.array(asked.angles))
    try:
        centre, radius = synthesis.circle(place)
    except ZeroDivisionError:
        right = Message(N_("other angles, or another point of the coupler"))
        raise refused(N_("the three points lie on one line"), "dwell", "angles", right=right) from None
    _along_the_arc(np.angle((place - centre) / (place[1] - centre)))
    s.centre_x, s.centre_y, s.radius = centre.real, centre.imag, radius
    towards = centre - complex(place[1])
    s.guide_angle = math.atan2(towards.imag, towards.real)
    return Table(
        "synthesis_arc", Message(N_("points through which the arc is laid")),
        (Path.phi.column(np.array(asked.angles)), Path.x.column(place.real), Path.y.column(place.imag)),
    )  # fmt: skip


def _goes_round(asked: Dwell) -> None:
    near, far = abs(asked.frame - asked.crank), asked.frame + asked.crank
    short, long = abs(asked.coupler - asked.rocker), asked.coupler + asked.rocker
    if near < short * (1 + SAME) or far > long * (1 - SAME):
        raise refused(
            N_("the crank cannot turn round: its pin comes as near as %(near)s to the rocker's pivot and as far as "
            "%(far)s from it, coupler and rocker reach from %(short)s to %(long)s"),
            "dwell", "crank", right=Message(N_("a shorter crank, or another distance between the pivots")),
            near=mm(near), far=mm(far), short=mm(short), long=mm(long),
        )  # fmt: skip


def _along_the_arc(off: np.ndarray) -> None:
    """`off`: the places of the point about the centre of the arc, from the middle one, rad."""
    if off[0] * off[2] >= 0:
        raise refused(
            N_("the point comes to its three places in another order than they lie on the arc"), "dwell", "angles",
            right=Message(N_("angles closer together, or another point of the coupler")),
        )  # fmt: skip
    if np.abs(off).max() > np.pi / 2 * (1 - SAME):
        raise refused(
            N_("on the arc the rod would come to stand across the slide line, and the slider would not keep its way"),
            "dwell", "angles", right=Message(N_("angles closer together, or another point of the coupler")),
        )  # fmt: skip


def traced(asked: Dwell, bar: synthesis.FourBar, phi: np.ndarray) -> np.ndarray:
    """Places of the point of the coupler, complex, m; the crank's pivot is the origin."""
    pin = asked.crank * np.exp(1j * phi)
    along = (asked.frame + asked.rocker * bar.rocker(phi) - pin) / asked.coupler
    return pin + along * complex(*asked.point)


def linkage(asked: Dwell) -> synthesis.FourBar:
    side = -1 if asked.rocker_joint == "left" else 1
    return synthesis.FourBar(asked.crank, asked.coupler, asked.rocker, asked.frame, side)
