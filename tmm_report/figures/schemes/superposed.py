"""All positions of a mechanism in one drawing: faint skeletons, trajectories, the numbered places of the joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmm_report.figures.drawing import Circle, Item, Pen, Tag, dot, polyline, together
from tmm_report.figures.schemes.view import Arrays, View
from tmm_report.mechanics.lever.mechanism import FRAME

FAINT = Pen(0.18, "grey")
TRACE = Pen(0.22, "blue")
SAME = 1e-6  # mm
SMALL = 2.5  # height of the numbers of positions, mm


def superposed(view: View, paths: Arrays, traced: Sequence[str], under: Sequence[Item] = ()) -> list[Item]:
    """The view over all other positions drawn thin, with trajectories and the places of the joints; `under`: what lies
    beneath them all but the plates."""
    others = [replace(view, position=k) for k in range(view.motion.count) if k != view.position]
    faint = [item for other in others for item in other.skeleton(FAINT)]
    ground = [*view.plates(), *under, *view.frame(), *faint]
    return [*ground, *_traces(view, paths, traced), *_position_dots(view), *view.links()]


def _grounded(view: View) -> set[str]:
    """Links that turn about a fixed point or slide on a fixed guide: their points go on arcs and straight lines."""
    turning = {name for links in view.joints.values() if FRAME in links for name in links}
    sliding = {s.link for s in view.mechanism.slides if view.mechanism.guides[s.guide].link == FRAME}
    return (turning | sliding) - {FRAME}


def _sliding(view: View) -> set[str]:
    return {s.link for s in view.mechanism.slides if view.mechanism.guides[s.guide].link == FRAME}


def _numbered(view: View) -> list[str]:
    """Joints of grounded links, whose places are marked."""
    grounded = _grounded(view)
    return [p for p, links in view.joints.items() if FRAME not in links and grounded & set(links)]


def _coupler_points(view: View) -> list[str]:
    mechanism, grounded = view.mechanism, _grounded(view) | {FRAME}
    centres = {link.mass_centre for link in mechanism.links.values()}
    points = [p for p in view.points if not grounded & set(mechanism.links_at(p))]
    return [p for p in points if p in view.joints or p not in centres]


def _traces(view: View, paths: Arrays, traced: Sequence[str]) -> list[Item]:
    """Circles of the driver's joints, trajectories of rockers' joints, coupler points and points asked for."""
    on_driver = [p for p in _numbered(view) if view.driver in view.joints[p]] if view.full_turn else []
    items: list[Item] = [Circle(view.pivot, abs(view.points[p] - view.pivot), FAINT) for p in on_driver]
    wanted = dict.fromkeys([*_numbered(view), *_coupler_points(view), *traced])
    plain = {*on_driver, *(p for p in wanted if _plain(view, p))}
    for point in [p for p in wanted if p in paths and p not in plain]:
        pen = FAINT if point in _numbered(view) else TRACE
        items.append(polyline(_smooth(np.asarray(paths[point]) / view.motion.mu, view.full_turn), pen))
    return items


def _plain(view: View, point: str) -> bool:
    """Whether a point goes along a guide, stands still or is fixed to the driver alone: its path says nothing."""
    links = set(view.mechanism.links_at(point))
    return bool(links & (_sliding(view) | {FRAME})) or links == {view.driver}


def _smooth(places: np.ndarray, closed: bool) -> list[complex]:
    """The path through the places; a closed one, whose last place may be its first again, is refined by its own Fourier
    series, which a motion is."""
    if closed and len(places) > 1 and abs(places[-1] - places[0]) < SAME:
        places = places[:-1]
    places = places[np.isfinite(places)] if not closed else places
    if not closed or not np.isfinite(places).all():
        return [complex(z) for z in places[np.isfinite(places)]]
    count = len(places)
    fine = max(180, count)
    spectrum, wide = np.fft.fft(places), np.zeros(fine, complex)
    half = (count + 1) // 2
    wide[:half], wide[fine - (count - half) :] = spectrum[:half], spectrum[half:]
    curve = np.fft.ifft(wide) * fine / count
    return [complex(z) for z in (*curve, curve[0])]


def _position_places(view: View, point: str) -> dict[str, complex]:
    link = view.mechanism.links_at(point)[0]
    places = view.motion.at(link, view.motion.local(link, point))
    return {str(k): complex(z) for k, z in enumerate(places) if np.isfinite(z)}


def _position_dots(view: View) -> list[Item]:
    points = [*_numbered(view), *_coupler_points(view)]
    return [dot(z, 0.4) for p in points for z in _position_places(view, p).values()]


def labelled(view: View) -> list[str]:
    """Joints whose places are numbered: of the driver's one is enough, the farthest from its pivot."""
    marked = _numbered(view)
    cranks = [p for p in marked if view.driver in view.joints[p]]
    farthest = max(cranks, key=lambda p: round(abs(view.points[p] - view.pivot), 3), default="")
    return [p for p in marked if p not in cranks or p == farthest]


def position_tags(view: View, point: str) -> list[Tag]:
    """Numbers by the places of a joint, coinciding ones together (1=11): outside a circle, over a straight guide.
    Those of the driver end where they began (0=12)."""
    tags = []
    whole = view.full_turn and view.driver in view.joints[point]
    first = view.block.imag if _sliding(view) & set(view.joints[point]) else 0.0
    for names, place in together(_position_places(view, point)):
        names = [*names, str(view.motion.count)] if whole and "0" in names else names
        out = _outside(view, point, place)
        hidden = first and abs(place - view.points[point]) < view.block.real  # under the block
        rises = (first if hidden else 0.0, *(first + SMALL * tier for tier in range(5)))
        tiers = tuple(place + rise * out for rise in rises) if out else (place,)
        tags.append(Tag(("=".join(names),), tiers, 0.9, out, SMALL, "blue"))
    return tags


def _outside(view: View, point: str, place: complex) -> complex:
    for slide in view.mechanism.slides:
        guide = view.mechanism.guides[slide.guide]
        if slide.link in view.joints[point] and guide.link == FRAME:
            return -view.hatched_side(guide)
    fixed = [z for p, z in view.points.items() if FRAME in view.joints.get(p, []) and _share(view, p, point)]
    out = place - fixed[0] if fixed else 0j
    return out / abs(out) if out else 0j


def _share(view: View, one: str, other: str) -> bool:
    """Whether a moving link holds both points."""
    return bool((set(view.joints[one]) & set(view.joints[other])) - {FRAME})
