"""How the quantities of a cam and its follower are called, and those that tables, formulas and pictures share."""

from __future__ import annotations

from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol


def unit(found: CamFound) -> str:
    """Of a displacement."""
    return "m" if found.slides else "rad"


def letter(found: CamFound) -> str:
    return "s" if found.slides else "beta"


def of(found: CamFound, key: str, symbol: Symbol, unit_: str, text: str, shown: str = "") -> Quantity:
    """A quantity of one cam pair, with its name in key and index."""
    index = ",".join(filter(None, (symbol.sub, found.cam.name)))
    meaning = Message(text, {"cam": found.cam.cam, "follower": found.cam.follower, "point": found.cam.point})
    return Quantity(named(found, key), Symbol(symbol.base, index, symbol.sup), unit_, meaning, shown)


def named(found: CamFound, key: str, more: str = "") -> str:
    """The name in the results of what is of one pair: that of the pair follows, where it is one of a mechanism."""
    return "_".join(filter(None, (key, found.cam.name, more)))


def displacement(found: CamFound) -> Quantity:
    text = (
        N_("displacement of follower %(follower)s")
        if found.slides
        else N_("angle of swing of follower %(follower)s")
    )
    return of(found, "cam_S", Symbol(letter(found)), unit(found), text)


def first(found: CamFound) -> Quantity:
    text = N_(
        "first derivative of the displacement of follower %(follower)s with respect to the angle of cam %(cam)s"
    )
    return of(found, "cam_S1", Symbol(letter(found) + "′"), unit(found) if found.slides else "", text)


def second(found: CamFound) -> Quantity:
    text = N_(
        "second derivative of the displacement of follower %(follower)s with respect to the angle of cam %(cam)s"
    )
    return of(found, "cam_S2", Symbol(letter(found) + "′′"), unit(found) if found.slides else "", text)


def velocity(found: CamFound) -> Quantity:
    if found.slides:
        return of(found, "cam_v", Symbol("v"), "m/s", N_("velocity of follower %(follower)s"))
    return of(found, "cam_w", Symbol("omega"), "rad/s", N_("angular velocity of follower %(follower)s"))


def acceleration(found: CamFound) -> Quantity:
    if found.slides:
        return of(found, "cam_a", Symbol("a"), "m/s²", N_("acceleration of follower %(follower)s"))
    return of(
        found, "cam_e", Symbol("epsilon"), "rad/s²", N_("angular acceleration of follower %(follower)s")
    )


def speed(found: CamFound) -> Quantity:
    return of(
        found, "cam_omega", Symbol("omega", found.cam.cam), "rad/s", N_("angular velocity of cam %(cam)s")
    )


def pressure(found: CamFound) -> Quantity:
    return of(
        found,
        "cam_alpha",
        Symbol("alpha"),
        "deg",
        N_("pressure angle between cam %(cam)s and follower %(follower)s"),
    )


def lowest_sign(found: CamFound) -> Symbol:
    """Letter of the lowest position of the follower."""
    return Symbol(letter(found), ",".join(filter(None, ("0", found.cam.name))))
