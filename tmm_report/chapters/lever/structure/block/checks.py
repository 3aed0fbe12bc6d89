"""Mistakes of a mechanism whose parts are right in themselves: names, lengths, guides, the driver."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

from tmm_report.chapters.lever.structure.block import build, cam_checks, driving
from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.chapters.lever.structure.block.geometry import Circular, Geometry, mentioned
from tmm_report.chapters.lever.structure.block.strokes.build import Refused
from tmm_report.chapters.lever.structure.block.synthesised import (
    Elsewhere,
    Taken,
    coordinate,
    direction,
    offered,
    taken,
)
from tmm_report.chapters.lever.structure.block.weights import Weights, in_the_middle
from tmm_report.chapters.lever.structure.block.wheels import checks as wheel_checks
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.mechanics.lever.stated_masses import Synthesised
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.text import for_example
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.variant.errors import by_another_name, near
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

Found = Iterator[Problem]
_MECHANISM: Path = ("mechanism",)
_PARTS = {
    "frame": "{O: [0, 0]}",
    "links": "{1: {points: {O: 0, A: 100 mm}}}",
    "driver": "{link: 1, speed: 1200 rpm}",
}


@dataclass(frozen=True)
class Names:
    """Names that the file declares, right or wrong otherwise: link -> its points (the frame is 0); guides."""

    points: dict[str, list[str]]
    guides: list[str]

    @property
    def all_points(self) -> list[str]:
        return list(dict.fromkeys(point for points in self.points.values() for point in points))

    def pivot(self, point: str) -> bool:
        """Whether several links, or a link and the frame, share the point."""
        return sum(point in points for points in self.points.values()) > 1


def names(data: Mapping[str, Any]) -> Names:
    parts = _mapping(data.get("mechanism"))
    points = {
        name: _names(_mapping(link).get("points")) for name, link in _mapping(parts.get("links")).items()
    }
    points = {FRAME: _names(parts.get("frame")), **points}
    for name, link in _mapping(parts.get("links")).items():
        link = _mapping(link)
        if middle := in_the_middle(name, bool(link.get("mass")), link.get("mass_centre"), points):
            points[name] = [*points[name], middle]
    return Names(points, list(_mapping(parts.get("guides"))))


def _mapping(value: Any) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}


def _names(value: Any) -> list[str]:
    return [str(name) for name in value] if isinstance(value, dict | list) else []


def stated(read: Read) -> bool:
    """Whether the file states a lever mechanism, or should: gears alone are a variant too."""
    return "mechanism" in read.data or not read.alone


def rails(read: Read) -> dict[str, str]:
    """Guides that stand for a rail on which a wheel rolls -> that wheel: they bear what the rail does, and nothing
    slides."""
    mechanism = _mapping(read.data.get("mechanism"))
    links = {str(name): _mapping(link) for name, link in _mapping(mechanism.get("links")).items()}
    found = {}
    rolling = mechanism.get("rolling")
    for one in map(_mapping, rolling if isinstance(rolling, list) else []):
        slides = links.get(str(one.get("carrier")), {}).get("slides")
        guide = _mapping(slides).get("guide") if isinstance(slides, dict) else slides
        if guide is not None:
            found[str(guide)] = str(one.get("wheel"))
    return found


def driven_by_stroke(read: Read) -> bool:
    """Whether a slider or a cylinder drives."""
    return "stroke" in _mapping(_mapping(read.data.get("mechanism")).get("driver"))


def without(read: Read, key: str) -> Found:
    """A block that speaks of a mechanism where there is none."""
    if key in read.data:
        right = Message(N_("describe the mechanism in the block mechanism, or take this block out"))
        yield mistake(
            N_("there is no lever mechanism that %(block)s could belong to"), (key,), right, block=key
        )


def of_friction(stated: bool | None, mechanism: bool, path: Path, read: Read) -> Found:
    """Of the key `friction` in a block of the machine in motion, at `path`."""
    if stated is not None and not mechanism:
        text = N_("friction of the pairs is that of a mechanism, and this variant has none")
        yield mistake(text, path, Message(N_("leave the key out")))
    elif stated and "friction" not in read.data:
        text = N_("no friction of the pairs is stated")
        yield mistake(text, path, Message(N_("state the friction of pivots, guides or joints")))


def check(mechanism: m.MechanismModel, read: Read) -> Found:
    """All mistakes of the parts that are right in themselves."""
    known = names(read.data)
    yield from _complete(read)
    synthesis = offered(read)
    yield from _frame(mechanism, synthesis)
    yield from _links(mechanism, known, synthesis, read)
    yield from _called_alike(known)
    yield from _guides(mechanism, known, synthesis)
    yield from _slides(mechanism, known)
    yield from _driver(mechanism, read, known)
    yield from _assembly(mechanism, known)
    yield from cam_checks.check(mechanism, read, known)
    yield from wheel_checks.check(mechanism, known, _built(mechanism, synthesis), read)


def _built(mechanism: m.MechanismModel, synthesis: Taken) -> Mechanism | None:
    """The mechanism without cams and wheels; None where its links have mistakes of their own."""
    if mechanism.driver is None or not (mechanism.wheels or mechanism.racks or mechanism.rolling):
        return None
    try:
        return build.without_cams(mechanism, synthesis)
    except (WrongValue, KeyError, ProblemError):
        return None


def _complete(read: Read) -> Found:
    """The parts that every mechanism has. The models let them be absent, to check the rest all the same."""
    written = _mapping(read.data.get("mechanism"))
    if _MECHANISM in read.broken:
        return
    for key, example in _PARTS.items():
        told = (*_MECHANISM, key) in read.broken or _elsewhere(key, _MECHANISM, read)
        if not written.get(key) and not told:
            right = for_example(f"{key}: {example}")
            yield mistake(N_("the key %(key)s is missing"), (*_MECHANISM, key), right, key=key)
    if FRAME in _mapping(written.get("links")):
        right = Message(N_("call it otherwise"))
        yield mistake(N_("0 is the frame and cannot be a moving link"), (*_MECHANISM, "links", FRAME), right)


def _elsewhere(key: str, path: Path, read: Read) -> bool:
    """Whether a key of the part at a path stands there under another name, which is told."""
    return by_another_name(key, [str(one[-1]) for one in read.broken if one[:-1] == path])


def _called_alike(known: Names) -> Found:
    """A point of the name of a moving link: v_3 and S_3 would be those of both."""
    told = set()
    for link, points in known.points.items():
        for point in points:
            if point in known.points and point != FRAME and point not in told:
                told.add(point)
                part = ("frame",) if link == FRAME else ("links", link, "points")
                right = Message(N_("call the point otherwise, for example %(name)s"), {"name": f"A{point}"})
                wrong = N_("a link is also called %(name)s")
                yield mistake(wrong, (*_MECHANISM, *part, point), right, name=point)


def no_point(name: str, path: Path, known: Names) -> Found:
    if name not in known.all_points:
        yield mistake(N_("no link has the point %(name)s"), path, near(name, known.all_points), name=name)


def no_link(name: str, path: Path, known: Names) -> Found:
    if name not in known.points:
        yield mistake(N_("there is no link %(name)s"), path, near(name, list(known.points)), name=name)


def _not_on(name: str, link: str, path: Path, known: Names) -> Found:
    """The point must be one of the link's."""
    points = known.points.get(link, [name])
    if name not in points:
        text = N_("the point %(name)s is not on link %(link)s")
        yield mistake(text, path, near(name, points), name=name, link=link)


def _frame(mechanism: m.MechanismModel, synthesis: Taken) -> Found:
    for name, place in mechanism.frame.items():
        for k, part in enumerate(place):
            try:
                coordinate(part, synthesis)
            except Elsewhere:
                continue
            except WrongValue as error:
                yield Problem(error.wrong, error.right, (*_MECHANISM, "frame", name, k))


def _known_frame(mechanism: m.MechanismModel, synthesis: Taken) -> dict[str, complex]:
    """The fixed points; those that cannot be worked out anywhere."""
    try:
        return build.frame(mechanism, synthesis)
    except WrongValue:
        return {name: complex(1e3 * k, 1e3) for k, name in enumerate(mechanism.frame)}


def _links(mechanism: m.MechanismModel, known: Names, synthesis: Taken, read: Read) -> Found:
    geometry = Geometry(mechanism.links, _known_frame(mechanism, synthesis), synthesis)
    weights = Weights(geometry)
    for name, link in mechanism.links.items():
        path = (*_MECHANISM, "links", name)
        yield from _geometry(name, geometry, path, known)
        yield from _weight(name, weights, path)
        if link.mass_centre is not None:
            yield from _not_on(link.mass_centre, name, (*path, "mass_centre"), known)
        elif _has_no_centre(link, known.points[name]) and not _elsewhere("mass_centre", path, read):
            yield mistake(N_("the link has a mass and no mass centre"), (*path, "mass"), _centre(name, known))
        if isinstance(link.inertia, m.InertiaModel):
            yield from _inertia(name, weights, link.inertia, (*path, "inertia"), known)


def _has_no_centre(link: m.LinkModel, points: Collection[str]) -> bool:
    """Whether a link has a mass, and it is not known where; that of a link of one point is in it."""
    return bool(link.mass) and 1 < len(link.points) == len(points)


def _centre(name: str, known: Names) -> Message:
    """What to write of the mass centre; of a link of two points, which may well be thought to have it between them."""
    points = known.points[name]
    words = {"words": ", ".join(points)}
    if len(points) != 2:
        return Message(N_("mass_centre: one of the points %(words)s"), words)
    first, second = points
    middle = {"middle": f"S{name}: 0.5*l_{first}{second}", "name": f"S{name}"}
    right = N_(
        "mass_centre: one of the points %(words)s; or their middle: %(middle)s in points, mass_centre: %(name)s"
    )
    return Message(right, {**words, **middle})


def _weight(name: str, weights: Weights, path: Path) -> Found:
    """Masses and moments of inertia that cannot be worked out as they are stated; each is told where it stands."""
    try:
        weights.geometry.places()
    except WrongValue:  # told by `_geometry`
        return
    for key, work_out in (("mass", weights.mass), ("inertia", weights.inertia)):
        try:
            work_out(name)
        except Elsewhere:
            continue
        except Circular as error:
            first = next(link for link in weights.links if link in error.links)
            if key == "mass" and name == first:
                yield Problem(error.wrong, error.right, (*path, key))
        except WrongValue as error:
            yield Problem(error.wrong, error.right, (*path, key))


def _inertia(name: str, weights: Weights, stated: m.InertiaModel, path: Path, known: Names) -> Found:
    """About a point of the link, no less than its mass makes of the distance of that point."""
    link, about, points = weights.links[name], stated.about, known.points[name]
    middle = next((point for point in points if point not in link.points), None)
    centre = link.mass_centre or (points[0] if len(points) == 1 else middle)
    yield from _not_on(about, name, (*path, "about"), known)
    if centre is None:
        right = Message(N_("mass_centre: one of the points %(words)s"), {"words": ", ".join(points)})
        text = N_(
            "a moment of inertia about point %(name)s is brought to the mass centre, which is not stated"
        )
        yield mistake(text, (*path, "about"), right, name=about)
        return
    try:
        built = build.link(name, weights)
        mass, value = weights.mass(name), weights.inertia(name)
    except (WrongValue, KeyError):  # told by `_geometry`, `_weight`, `_not_on`
        return
    away = abs(built.points[about] - built.points[centre])
    if build.central_inertia(value, mass, away) < -1e-12 * value:
        least = mass * away**2
        text = N_(
            "%(value)s kg·m² about point %(about)s would make the moment of inertia about the mass centre negative: "
            "the mass %(mass)s kg at %(away)s m alone has %(least)s kg·m²"
        )
        right = Message(N_("a larger moment of inertia, or that about the mass centre without about"))
        told = {"value": value, "mass": mass, "away": away, "least": least}
        yield mistake(text, (*path, "value"), right, about=about, **{k: f"{x:.4g}" for k, x in told.items()})


def _geometry(name: str, geometry: Geometry, path: Path, known: Names) -> Found:
    """Every pivot of the link has its own place; other points may stand where another is."""
    link = geometry.links[name]
    if isinstance(link.points, list):
        return
    *first, second = list(link.points.items())[:2]
    if first and isinstance(second[1], float) and second[1] < 0 and first[0][1] == 0:
        yield mistake(
            N_("negative length"),
            (*path, "points", second[0]),
            Message(N_("a length is positive; a point behind the first one is given as [x, y]")),
        )
    placed: dict[str, complex] = {}
    # of points that cannot be read themselves their own line tells
    broken = {
        one for key, own in geometry.links.items() for one in known.points[key] if one not in own.points
    }
    for point, written in link.points.items():
        here = (*path, "points", point)
        try:
            placed[point] = geometry.place(name, point, placed)
        except WrongValue as error:
            told = isinstance(error, Elsewhere) or broken & mentioned(written)
            broken.add(point)
            if told:
                continue
            links = getattr(error, "links", (name,))
            if name == next(link for link in geometry.links if link in links):
                yield Problem(error.wrong, error.right, here)
            continue
        if not known.pivot(point):
            continue
        for other in placed:
            if other != point and known.pivot(other) and abs(placed[other] - placed[point]) < 1e-9:
                text = N_("zero length: %(name)s is at the place of %(other)s")
                right = Message(N_("one name for both: links that share a point are joined there"))
                yield mistake(text, here, right, name=point, other=other)


def _guides(mechanism: m.MechanismModel, known: Names, synthesis: Taken) -> Found:
    for name, guide in mechanism.guides.items():
        path = (*_MECHANISM, "guides", name)
        try:
            direction(guide.angle or 0.0, synthesis)
        except Elsewhere:
            pass
        except WrongValue as error:
            yield Problem(error.wrong, error.right, (*path, "angle"))
        yield from no_link(guide.link, (*path, "link"), known)
        points = [guide.through] if isinstance(guide.through, str) else guide.through
        points = [] if isinstance(points, tuple) else points  # coordinates
        for point in points:
            yield from _not_on(point, guide.link, (*path, "through"), known)
        if len(points) == 2 and points[0] == points[1]:
            yield mistake(N_("a line needs two different points"), (*path, "through"))
        if len(points) == 2 and guide.angle is not None:
            right = Message(N_("two points, or one point and an angle"))
            yield mistake(N_("the direction is stated twice"), (*path, "angle"), right)
        if name in known.all_points:
            right = Message(N_("call the guide otherwise"))
            yield mistake(N_("a point is also called %(name)s"), path, right, name=name)


def _slides(mechanism: m.MechanismModel, known: Names) -> Found:
    for name, link in mechanism.links.items():
        for index, slide in enumerate(build.slides_of(link)):
            path: Path = (*_MECHANISM, "links", name, "slides")
            path = (*path, index) if isinstance(link.slides, list) else path
            if slide.guide not in known.guides:
                yield mistake(
                    N_("there is no guide %(name)s"), path, near(slide.guide, known.guides), name=slide.guide
                )
            elif slide.guide in mechanism.guides and mechanism.guides[slide.guide].link == name:
                yield mistake(N_("the link cannot slide along its own guide"), path)
            if slide.at is not None:
                yield from _not_on(slide.at, name, (*path, "at"), known)


def _driving_link(link: str, known: Names, slides: bool) -> Found:
    path = (*_MECHANISM, "driver", "link")
    fixed, moving = known.points[FRAME], [name for name in known.points if name != FRAME]
    if link not in known.points:
        yield mistake(N_("there is no link %(name)s"), path, near(link, moving), name=link)
    elif link == FRAME:
        yield mistake(N_("the frame cannot drive"), path, near(link, moving))
    elif slides and not set(known.points[link]) & set(fixed):
        text = N_("link %(name)s slides: a driving slider is stated with its stroke")
        right = Message(
            N_("slider: %(name)s, stroke: {from: 0.35 m, to: 0.60 m, speed: 1.2 m/s}"), {"name": link}
        )
        yield mistake(text, path, right, name=link)
    elif fixed and not set(known.points[link]) & set(fixed):
        right = Message(N_("one of its points must be of the frame: %(words)s"), {"words": ", ".join(fixed)})
        yield mistake(N_("the driving link %(name)s has no fixed point"), path, right, name=link)


def _driver(mechanism: m.MechanismModel, read: Read, known: Names) -> Found:
    # the link is looked at as written: another mistake in the block must not hide a missing link
    written = _mapping(_mapping(read.data.get("mechanism")).get("driver"))
    if written.get("link") is not None and (*_MECHANISM, "driver", "link") not in read.broken:
        link = str(written["link"])
        slides = "slides" in _mapping(_mapping(_mapping(read.data["mechanism"]).get("links")).get(link))
        yield from _driving_link(link, known, slides)
    if (driver := mechanism.driver) is None:
        return
    if driver.law is not None or driver.stroke is not None:
        yield from driving.mistakes(read)
    if driver.stroke is not None:
        yield from _stroke(mechanism, driver, read, known)
    if driver.speed == "drive" and "drive" not in read.data:
        wrong = N_("speed: drive takes the speed of the drive's output shaft, and there is no drive")
        right = Message(N_("state the block drive, or the speed: 100 rpm"))
        yield mistake(wrong, (*_MECHANISM, "driver", "speed"), right)
    yield from _synthesised(driver, read)
    if driver.zero and driver.zero.point is not None:
        yield from no_point(driver.zero.point, (*_MECHANISM, "driver", "zero", "point"), known)
    if driver.zero and driver.zero.link is not None:
        yield from no_link(driver.zero.link, (*_MECHANISM, "driver", "zero", "link"), known)


def _synthesised(driver: m.DriverModel, read: Read) -> Found:
    """What the driving link takes of the synthesis is found there, and measures what is asked."""
    zero = driver.zero.angle if driver.zero else None
    for key, stated, measures in (
        (("speed",), driver.speed, "speed"),
        (("range",), driver.range, "angle"),
        (("zero", "angle"), zero, "angle"),
    ):
        if isinstance(stated, Synthesised):
            try:
                taken(stated, offered(read), measures)
            except Elsewhere:
                continue
            except WrongValue as error:
                yield Problem(error.wrong, error.right, (*_MECHANISM, "driver", *key))


def _stroke(mechanism: m.MechanismModel, driver: m.DriverModel, read: Read, known: Names) -> Found:
    """Of a driving slider or cylinder: that its links and points are there and that it can go by its stroke."""
    path = (*_MECHANISM, "driver")
    unknown = [
        *(no_link(driver.slider, (*path, "slider"), known) if driver.slider is not None else ()),
        *(
            found
            for k, one in enumerate(driver.cylinder or ())
            for found in no_point(one, (*path, "cylinder", k), known)
        ),
    ]
    yield from unknown
    if unknown:
        return
    try:
        build.without_cams(mechanism, offered(read))
    except Refused as error:
        yield error.problem
    except ProblemError as error:  # of the structure and the assembly, which the stroke needs
        yield from error.problems
    except (WrongValue, KeyError):  # told by the links themselves
        return


def _assembly(mechanism: m.MechanismModel, known: Names) -> Found:
    for key, choice in mechanism.assembly.items():
        path = (*_MECHANISM, "assembly", key)
        pair = key.split("-")
        if key not in known.all_points and not (
            len(pair) == 2 and all(link in known.points for link in pair)
        ):
            right = near(key, known.all_points)
            yield mistake(N_("%(key)s is neither a point nor a pair of links"), path, right, key=key)
        for point in choice[1:] if isinstance(choice, tuple) else ():
            yield from no_point(point, path, known)
    for name in mechanism.sketch:
        yield from no_point(name, (*_MECHANISM, "sketch", name), known)
