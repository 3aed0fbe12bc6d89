"""Doubts about a lever mechanism whose numbers are right one by one: masses, moments of inertia, the speed.

What a link weighs and how it resists turning follow from its size within wide limits; a number that missed its unit
by a thousand is beyond them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from statistics import median

from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.chapters.lever.structure.block.build import mechanism
from tmm_report.chapters.lever.structure.block.cam_size import radius
from tmm_report.chapters.lever.structure.block.cams import CamModel
from tmm_report.chapters.lever.structure.block.synthesised import offered
from tmm_report.mechanics.lever.mechanism import FRAME, Link, Mechanism
from tmm_report.mechanics.lever.stated_masses import PerLength, letters
from tmm_report.problems import N_, Message, Problem, doubt, shown
from tmm_report.records import dataclass
from tmm_report.variant.closed import in_other_units
from tmm_report.variant.measures import Measure, measures
from tmm_report.variant.model import Read
from tmm_report.variant.slips.elsewhere import at
from tmm_report.variant.slips.odd import MEANT, lengths, said

STEEL = 7850.0  # kg/m³
BULK = 5.0
"""A link is lighter than this many solid steel cubes with the edge of the longest link."""
SLIDING = 4.0  # times heavier a slider may be: its size does not follow from the lengths of the links
THIN = 1e-3  # kg/m: no link is lighter than this, of the length of the longest one
WIRE = 5.0  # kg/m³: and none lighter than this many cubes of that length, as those of instruments are
BAR = 0.5
"""Of what is stated by its length: a bar of steel is at most this thick, of the length of the longest link."""
HEAVY = 60.0
"""How many times the usual mass of the links another one may be."""
GYRATION = (0.018, 3.0)
"""Radius of gyration, of the link's own length: of a rod 0.29, of what reaches far beyond its points 2."""
DISC = 3.0
"""The same of a link that may carry a flywheel, or has no length, at most: of the longest link."""
SLOW = 40.0  # rad/s: a smaller number is hardly one of revolutions a minute
CRANK_PIN = (25.0, 80.0)
"""m/s: of the driving link's farthest point; where the speed is a bare number, and otherwise."""


@dataclass(frozen=True, eq=False)
class _Links:
    """Moving links with a mass, kg, their own lengths and that of the longest one, m; the numbers as written."""

    links: Mapping[str, Link]
    own: Mapping[str, float]
    longest: float
    written: Mapping[tuple[str | int, ...], Measure]
    sliding: frozenset[str]
    driving: str

    def masses(self) -> list[float]:
        return [float(link.mass) for link in self.links.values() if link.mass]


def doubts(written: m.MechanismModel, read: Read) -> Iterator[Problem]:
    """A doubt for each mass and moment of inertia that does not belong to such a link; one for the speed."""
    stated = measures(read)
    if any(lengths(read, stated)):
        return  # what all the rest is judged by
    built, numbers = mechanism(written, offered(read)), {one.path: one for one in stated}
    own = _sizes(written, built)
    longest = max(own.values(), default=0.0)
    if longest > 0:
        moving = {name: built.links[name] for name in written.links}
        sliding = frozenset(name for name, link in written.links.items() if link.slides)
        found = _Links(moving, own, longest, numbers, sliding, built.driver.link)
        for name in moving:
            yield from _of_link(name, found)
            yield from _of_metre(written.links[name], name, longest, read)
    yield from _speed(own[built.driver.link], numbers)


def _sizes(written: m.MechanismModel, built: Mechanism) -> dict[str, float]:
    """Of the moving links, m, by the points that are stated: what replaces a cam pair has places of its own. A cam is
    as large as its profile."""
    own = {
        name: extent([at for point, at in built.links[name].points.items() if point in set(link.points)])
        for name, link in written.links.items()
    }
    for cam in written.cams.values():
        name = cam.cam or built.driver.link
        if name in own:
            own[name] = max(own[name], radius(cam, _arm(cam, built, own.get(cam.follower, 0.0))))
    return own


def _arm(cam: CamModel, built: Mechanism, length: float) -> float:
    """From the follower's pivot to its roller, m; else the follower's length."""
    points = built.links[cam.follower].points if cam.follower in built.links else {}
    pivots = [at for name, at in points.items() if name in built.links[FRAME].points]
    if cam.roller is None or cam.roller.at not in points or not pivots:
        return length
    return abs(points[cam.roller.at] - pivots[0])


def extent(places: Sequence[complex]) -> float:
    """The largest distance between two points of a link, m."""
    return max((abs(a - b) for a in places for b in places), default=0.0)


def _of_link(name: str, found: _Links) -> Iterator[Problem]:
    link, path = found.links[name], ("mechanism", "links", name)
    mass = found.written.get((*path, "mass"))
    if mass is not None and link.mass and (odd := _mass(mass, found, name in found.sliding)) is not None:
        yield odd
        return
    inertia = found.written.get(
        (*path, "inertia")
    )  # that about another point is held against the mass by `checks`
    if inertia is not None and inertia.size and mass is not None and mass.size:
        yield from _inertia(inertia, mass, found.own[name], _widest(name, found), _usual_masses(found))


def _mass(mass: Measure, found: _Links, slides: bool) -> Problem | None:
    """A mass that such a link cannot have, or that is far from those of the other links."""
    cube = found.longest**3
    most, least = BULK * STEEL * cube, min(THIN * found.longest, WIRE * cube)
    usual = median([one for one in found.masses() if least <= one <= most] or found.masses())
    room = SLIDING if slides else 1.0
    most, highest = most * room, usual * HEAVY * room
    if not least <= mass.size <= most:
        text = N_("%(value)s is odd for a link of a mechanism whose longest link has %(length)s m")
        return said(mass, text, least, most, length=f"{found.longest:.3g}")
    if not usual / HEAVY <= mass.size <= highest and mass.meant(usual / HEAVY, usual * HEAVY):
        text = N_("%(value)s is odd: the usual mass of a link here is %(usual)s kg")
        return said(mass, text, usual / HEAVY, usual * HEAVY, usual=f"{usual:.3g}")
    return None


def _of_metre(link: m.LinkModel, name: str, longest: float, read: Read) -> Iterator[Problem]:
    """A mass of a metre, kg/m, that no bar of such a mechanism has."""
    if isinstance(link.mass, float):
        return
    path = ("mechanism", "links", name, "mass")
    stated, least, most = str(at(read.data, path)), THIN, STEEL * (BAR * longest) ** 2
    for size in (one.value for one in letters(link.mass) if isinstance(one, PerLength)):
        if not least <= size <= most:
            near = next(
                (text for text, times in in_other_units(stated) if least <= size * times <= most), None
            )
            right = Message(MEANT, {"near": near}) if near else None
            text = N_(
                "%(value)s is odd: a metre has %(size)s kg, in a mechanism whose longest link has %(length)s m"
            )
            told = {"value": shown(stated), "size": f"{size:.3g}", "length": f"{longest:.3g}"}
            yield doubt(text, path, right, **told)


def _widest(name: str, found: _Links) -> float:
    """The largest radius of gyration that the link may have, m."""
    own = found.own[name]
    return GYRATION[1] * own if own and name != found.driving else DISC * found.longest


def _usual_masses(found: _Links) -> tuple[float, float]:
    """Between which masses, kg, that of a link is usual."""
    usual = median(found.masses())
    return usual / HEAVY, min(usual * HEAVY, BULK * STEEL * found.longest**3)


def _inertia(
    inertia: Measure, mass: Measure, own: float, widest: float, masses: tuple[float, float]
) -> Iterator[Problem]:
    """A moment of inertia whose radius of gyration is far beyond the link, or a speck in it."""
    radius = math.sqrt(inertia.size / mass.size)
    if GYRATION[0] * own <= radius <= widest:
        return
    length = own or widest / DISC
    text = N_(
        "%(value)s is odd: with the mass %(mass)s the radius of gyration is %(radius)s m, the link has %(length)s m"
    )
    if not own:
        text = N_(
            "%(value)s is odd: with the mass %(mass)s the radius of gyration is %(radius)s m, the longest link has "
            "%(length)s m"
        )
    told = {"value": inertia.text, "mass": mass.text, "radius": f"{radius:.3g}", "length": f"{length:.3g}"}
    place, near = _likely(inertia, mass, length, masses)
    yield doubt(text, place.path, Message(MEANT, {"near": near}) if near else None, **told)


def _likely(
    inertia: Measure, mass: Measure, length: float, masses: tuple[float, float]
) -> tuple[Measure, str | None]:
    """Which of the two missed its unit, and what is meant: that by which the radius of gyration comes nearest to 0.3
    of the length, as it is of a rod; the mass only where it is usual then."""
    radii = [(inertia, text, math.sqrt(size / mass.size)) for text, size in inertia.others()]
    low, high = masses
    others = [(text, size) for text, size in mass.others() if low <= size <= high]
    radii += [(mass, text, math.sqrt(inertia.size / size)) for text, size in others]
    place, text, radius = min(radii, key=lambda one: abs(math.log(one[2] / (0.3 * length))))
    return (place, text) if 0.05 < radius / length < 2 else (inertia, None)


def _speed(length: float, numbers: Mapping[tuple[str | int, ...], Measure]) -> Iterator[Problem]:
    """A bare number of revolutions a minute is read as rad/s: the driving link's end would fly."""
    speed = numbers.get(("mechanism", "driver", "speed"))
    if speed is None:
        return
    velocity = abs(speed.size) * length
    if velocity > CRANK_PIN[0 if speed.bare else 1] and SLOW <= abs(speed.size) <= 400:
        text = N_("%(value)s is odd: the end of the driving link would move at %(velocity)s m/s")
        highest = CRANK_PIN[0] / length
        yield said(speed, text, 0.0, highest, velocity=f"{velocity:.3g}")
