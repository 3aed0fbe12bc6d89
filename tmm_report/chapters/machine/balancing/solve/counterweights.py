"""Counterweights and rotors by each method of the course."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tmm_report.chapters.machine.balancing.given import (
    FULL,
    OPTIMUM,
    PIVOTED,
    ROTORS,
    STATED,
    SUBSTITUTED,
    Counterweight,
    Given,
)
from tmm_report.chapters.machine.balancing.solve.cases import MAX, RMS, Case, Ground, Placed, Rotor
from tmm_report.chapters.machine.balancing.solve.substituted_masses import (
    NOTHING,
    Carried,
    Substituted,
    Unbalanced,
    hung,
    line_of,
    order_of_centres,
    turning,
)
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.masses.counterweights import against, pivoted
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

Array = Any


# ---------------------------------------------------------------- a counterweight for a static moment


class Fitting:
    """Makes counterweights of static moments by what is stated of them; gathers what is not stated."""

    def __init__(self, given: Given):
        self.given, self.missing = given, dict[str, list[str]]()

    def placed(
        self,
        method: str,
        link: str,
        about: complex,
        axis: complex,
        moment: complex,
        carried: Unbalanced | None,
    ) -> Placed | None:
        """None where what it needs is not stated."""
        stated = self.given.counterweights.get(link, Counterweight())
        size = abs(moment)
        if stated.distance is not None:
            return Placed(link, about, axis, moment, size / stated.distance, stated.distance, carried)
        if stated.mass is not None:
            return Placed(link, about, axis, moment, stated.mass, size / stated.mass, carried)
        self.missing.setdefault(link, []).append(method)
        return None

    def raise_missing(self) -> None:
        """Raises ProblemError with every link whose counterweight is not stated."""
        if not self.missing:
            return
        right = Message(N_("state its distance from the pivot (distance: 60 mm) or its mass (mass: 2 kg)"))
        raise ProblemError([self._problem(link, methods, right) for link, methods in self.missing.items()])

    def _problem(self, link: str, methods: list[str], right: Message) -> Problem:
        text = N_(
            "link %(link)s needs a counterweight (%(methods)s), but neither its distance nor its mass is stated"
        )
        return mistake(
            text, ("balancing", "counterweights"), right, link=link, methods=", ".join(dict.fromkeys(methods))
        )


# ---------------------------------------------------------------- the methods


def cases(
    ground: Ground, given: Given, substituted: Substituted, whole: bool, targets: Mapping[str, complex]
) -> Iterator[Case]:
    """Each asked method in the course's order. `whole`: whether every link hangs on the frame by pivots; `targets`: by
    the kind of optimum, what of `turned_back` is shifted into the origin. Raises ProblemError for counterweights of
    which nothing is stated."""
    fitting = Fitting(given)
    found: list[tuple[str, tuple[Placed | None, ...], tuple[Rotor, ...]]] = []
    if given.stated:
        found.append((STATED, tuple(existing(ground, given)), ()))
    if FULL in given.ways and whole:
        found.append((FULL, tuple(centres(ground, fitting)), ()))
    if PIVOTED in given.ways:
        found.append((PIVOTED, tuple(by_force(ground, fitting)), ()))
    if SUBSTITUTED in given.ways:
        found.append((SUBSTITUTED, tuple(by_masses(ground, fitting, substituted)), ()))
    if OPTIMUM in given.ways:
        for kind in (RMS, MAX):
            found.append((f"{OPTIMUM}_{kind}", (single(ground, fitting, kind, targets[kind]),), ()))
    if ROTORS in given.ways and given.radii:
        rotors = tuple(pairs_of_rotors(ground, given.radii))
        found += [
            (f"{ROTORS}_{one.order}", (), rotors[: k + 2]) for k, one in enumerate(rotors) if one.order > 0
        ]
    fitting.raise_missing()
    for name, placed, own in found:
        yield ground.case(name, tuple(one for one in placed if one is not None), own)


def existing(ground: Ground, given: Given) -> Iterator[Placed]:
    """Counterweights that are there already."""
    fixed = pivoted(ground.linkage.structure.pairs)
    for link, one in given.stated.items():
        about = fixed[link]
        moment = one.mass * one.distance * np.exp(1j * one.angle)
        axis = line_of(ground.linkage.mechanism, link, about)
        yield Placed(link, about, axis, complex(moment), one.mass, one.distance)


def centres(ground: Ground, fitting: Fitting) -> Iterator[Placed | None]:
    """From the farthest links to the frame: each carries the whole of those that hang on it at their pivots, and its
    counterweight puts the centre of all that into its own pivot."""
    linkage, turns = ground.linkage, turning(ground.linkage)
    hanging: dict[str, list[Carried]] = {}
    carries: dict[str, tuple[str, ...]] = {}  # link -> all that hang on it, and itself
    for support in order_of_centres(linkage):
        one = hung(linkage, support.link, support, tuple(hanging.get(support.link, ())))
        total, placed = one.mass, None
        needed = one.moment and support.link in turns
        if needed:
            args = (support.link, one.about, one.axis, -one.moment, one)
            placed = fitting.placed(FULL, *args)
            yield placed
        if total and support.parent in linkage.mechanism.moving:
            own = _support_of(linkage, support.parent)
            arm = complex((support.on_parent - own) / line_of(linkage.mechanism, support.parent, own))
            mass = total + (placed.mass if placed else 0.0)
            links = (support.link, *carries.get(support.link, ()))
            carries[support.parent] = (*carries.get(support.parent, ()), *links)
            hanging.setdefault(support.parent, []).append(Carried(support.joint, mass, arm, links))


def _support_of(linkage: Linkage, link: str) -> complex:
    return complex(next(one.at for one in order_of_centres(linkage) if one.link == link))


def by_force(ground: Ground, fitting: Fitting) -> Iterator[Placed | None]:
    """Counterweights on all links that turn about fixed pivots, by the force over the cycle."""
    turns = turning(ground.linkage)
    links = {link: at for link, at in pivoted(ground.linkage.structure.pairs).items() if link in turns}
    found, _ = against(ground.motions[2], links, ground.original.cycle.force)
    for link, moment in found.items():
        yield from _by_moment(ground, fitting, PIVOTED, link, links[link], moment)


def _by_moment(
    ground: Ground, fitting: Fitting, method: str, link: str, about: complex, moment: complex
) -> Iterator[Placed | None]:
    """A counterweight for a static moment in the link's axes; none for one that is rounding."""
    axis = line_of(ground.linkage.mechanism, link, about)
    if abs(moment) * ground.omega**2 > NOTHING * ground.size:
        yield fitting.placed(method, link, about, axis, _clean(moment / axis), None)


def _clean(moment: complex) -> complex:
    """Without the rounding beside the axis."""
    x, y = (0.0 if abs(part) <= 1e-10 * abs(moment) else part for part in (moment.real, moment.imag))
    return complex(x, y)


def by_masses(ground: Ground, fitting: Fitting, substituted: Substituted) -> Iterator[Placed | None]:
    """Counterweights on the pivoted links against the masses that were put there."""
    fixed = pivoted(ground.linkage.structure.pairs)
    for link, masses in substituted.carried.items():
        about = fixed[link]
        axis = line_of(ground.linkage.mechanism, link, about)
        one = Unbalanced(link, _pivot_name(ground, link), about, axis, tuple(masses.values()))
        if one.moment:
            yield fitting.placed(SUBSTITUTED, link, about, axis, -one.moment, one)


def _pivot_name(ground: Ground, link: str) -> str:
    pairs = ground.linkage.structure.pairs
    return next(p.name for p in pairs if p.kind == "R" and FRAME in p.links and link in p.links)


def turned_back(ground: Ground) -> Array:
    """The shaking force over the cycle in the line of the driving link, over ω²: a counterweight of static moment U
    adds U to it, kg m."""
    motion, mechanism = ground.motions[2], ground.linkage.mechanism
    driver = mechanism.driver.link
    line = line_of(mechanism, driver, pivoted(ground.linkage.structure.pairs)[driver])
    return ground.original.cycle.force / (motion.turn(driver) * line) / ground.omega**2


def single(ground: Ground, fitting: Fitting, kind: str, target: complex) -> Placed | None:
    """One counterweight on the driving link: by the mean of the force in its axes (least mean square), or by the centre
    of the smallest circle round it (least maximum), the `target` that is shifted into the origin."""
    driver = ground.linkage.mechanism.driver.link
    about = pivoted(ground.linkage.structure.pairs)[driver]
    line = line_of(ground.linkage.mechanism, driver, about)
    return next(_by_moment(ground, fitting, f"{OPTIMUM}_{kind}", driver, about, -target * line), None)


def pairs_of_rotors(ground: Ground, radii: Mapping[int, float]) -> Iterator[Rotor]:
    """Two rotors at ±kω against the harmonic of each order, of which the vector describes an ellipse (Lanchester)."""
    highest = max(radii)
    harmonics = force_harmonics(ground.original, ground.cycle.sense, highest)
    for order in (sense * order for order in radii for sense in (1, -1)):
        force = -harmonics[order + highest]
        moment = abs(force) / (order * ground.omega) ** 2
        if abs(force) <= 1e-11 * ground.size:
            moment, force = 0.0, 1.0
        yield Rotor(order, moment, half_turn(float(np.angle(force))), radii[abs(order)])


def half_turn(angle: Array) -> Array:
    """Angles, rad, within (−π, π], of which rounding does not make −π."""
    return np.where(angle <= -np.pi + 1e-9, np.pi, angle)[()]


def force_harmonics(case: Case, sense: int, highest: int) -> Array:
    """c_k of F = Σ c_k e^{ikφ}, k = −highest … highest, φ in the sense of the driving link: + turns with it."""
    found = fourier.turning(case.cycle.force, highest)
    return found if sense > 0 else found[::-1]
