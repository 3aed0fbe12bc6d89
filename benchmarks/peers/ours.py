"""This program's own solver: dyads in closed form, every point's place and rates, reactions, balancing moment."""

from __future__ import annotations

from itertools import product

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer
from benchmarks.peers.scene import Rocker, Scene, Slider, starts
from tmm_report.mechanics.lever import assur_groups, motion
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide


def prepare(scene: Scene, phi: Array, forces: bool = True) -> Call:
    linkage = _linkage(scene, float(phi[0]))

    def run() -> Found:
        found = motion.solve(linkage, phi)
        return _motion(found, scene) | (_moment(found, scene) if forces else {})

    return run


def _motion(found: motion.Motion, scene: Scene) -> Found:
    named: Found = {}
    for point in scene.points:
        named[point], named[f"v_{point}"] = found.place(point), found.velocity(point)
        named[f"a_{point}"] = found.acceleration(point)
    return named


def _moment(found: motion.Motion, scene: Scene) -> Found:
    """All reactions are found with it."""
    loads = statics.inertia_and_gravity(found, 1j * scene.gravity)
    for point, force in scene.forces.items():
        link = f"at {point}"
        loads[link] = statics.Load(loads[link].force + force, loads[link].moment)
    return {"moment": statics.solve(found, loads).balancing}


def _linkage(scene: Scene, phi: float) -> motion.Linkage:
    """The roots are those that put the points where the scene has them at the first angle."""
    known = assur_groups.decompose(_mechanism(scene))
    at = starts(scene, phi)
    for signs in product((1, -1), repeat=len(scene.rods)):
        linkage = motion.linkage_of(known, signs)
        found = motion.solve(linkage, np.array([phi]))
        if all(abs(found.place(p)[0] - at[p]) < 1e-6 * scene.crank for p in scene.points):
            return linkage
    raise ArithmeticError("no assembly has the points where they start")


def _mechanism(scene: Scene) -> Mechanism:
    links = {"0": {"O": 0j}, "1": {"O": 0j, "A": scene.crank + 0j}}
    made, slides, guides = [], [], {}
    for rod in scene.rods:
        points = {rod.start: 0j, rod.end: rod.length + 0j} | {p: at + 0j for p, at in rod.points.items()}
        centre = rod.centre or "middle"
        points.setdefault(centre, rod.at(rod.centre) + 0j)
        made.append(Link(f"to {rod.end}", points, rod.mass, centre, rod.inertia))
        if isinstance(rod.out, Slider):
            made.append(Link(f"at {rod.end}", {rod.end: 0j}, rod.out.mass, rod.end))
            guides[rod.end] = Guide(rod.end, "0", 1j * rod.out.offset, 1 + 0j)
            slides.append(Slide(f"at {rod.end}", rod.end, 0j, 1 + 0j))
        else:
            made.append(_rocker(links, rod.end, rod.out))
    frame = [Link(name, points) for name, points in links.items()]
    return Mechanism({link.name: link for link in [*frame, *made]}, Driver("1", scene.omega), guides, slides)


def _rocker(links: dict[str, dict[str, complex]], end: str, out: Rocker) -> Link:
    pivot = f"pivot of {end}"
    links["0"][pivot] = out.pivot
    return Link(f"at {end}", {pivot: 0j, end: out.length + 0j}, 0.0, pivot, out.inertia)


PEER = Peer("ours", "tmm-report", prepare, {"motion and forces": {}, "motion": {"forces": False}})
