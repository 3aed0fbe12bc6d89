"""Loading schemes and Zhukovsky's lever as the script redraws them: what acts, and where, in every position.

A scheme moves only if all that it shows is known in every position. In place of the parts of a reaction, which belong
to the position in which a plan was constructed, stands the whole of it.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tmm_report.chapters.lever.force_plans import lever_quantities
from tmm_report.chapters.lever.kinetostatics.quantities import positions as loads
from tmm_report.chapters.lever.kinetostatics.quantities.driving_gear import FORCE as GEAR
from tmm_report.chapters.lever.kinetostatics.quantities.driving_stroke import FORCE as STROKE
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import COLOURS, Acting, Acts, Drawing
from tmm_report.figures.lettering import Part, lettered
from tmm_report.figures.schemes.view import View
from tmm_report.i18n import Translator
from tmm_report.living.cycle import Cycle, places
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.quantity.model import Quantity

Array = Any
PART = re.compile("_[tnxy]$")  # ends the key of a tangential or a normal part, or of a projection


REACH = 80.0  # mm: a centre of percussion farther from the mass centre is off the sheet
NOTHING = 1e-6  # of the largest couple
AT = 1e-3  # mm: nearer places are one


class _Aside(NamedTuple):
    """Places of a force that has the moment of a couple, mm, and the key of this."""

    couple: str
    at: Array


class Loads:
    """`vectors`: those that the schemes need, key -> complex (Q,), N; `turning`: keys of the couples that they show."""

    def __init__(self, cycle: Cycle, view: View, found: Kinetostatics, at: Mapping[str, Any], tr: Translator):
        """`at`: key of a force -> point in which it acts, or its places."""
        self.words = partial(tr.pgettext, "index")
        self.cycle, self.view, self.found = cycle, view, found
        self.known, self.at = dict(cycle.vectors), dict(at)
        self.moment, self.couples = loads.BALANCING_MOMENT.key, self._couples()
        # the links that replace cam pairs, and the points of which only they and the cams have a place
        self.replacing = {cam.name: cam for cam in view.mechanism.cams}
        self.centres = {cam.centre: cam for cam in view.mechanism.cams}
        self.guides = dict(self._guides())
        self._gear()
        self._stroke()
        self.vectors: dict[str, Array] = {}
        self.turning: dict[str, Array] = {}

    def schemes(self, pictures: Mapping[str, Drawing | Graph]) -> dict[str, Any]:
        found = {}
        for anchor, picture in pictures.items():
            acts = picture.acts if isinstance(picture, Drawing) else None
            if acts is not None and (one := self._lever(acts) if acts.sides else self._scheme(acts)):
                position = int(self.cycle.numbered[acts.position])
                found[anchor] = {
                    "position": position,
                    "moment": self._balanced(acts),
                    **one,
                }
        return found

    def _guides(self) -> Iterator[tuple[str, tuple[Quantity, str]]]:
        """Of each reaction that has a moment in some position: key -> this, and the link that it turns. The moments
        turned round are added to the couples."""
        every = self.found.diagram.statics.reactions.values()
        pairs = [(loads.guide_moment(*one.pair.links), one.pair.links) for one in every]
        largest = max((_most(m) for m in self.couples.values()), default=0.0)
        for of, (by, on) in pairs:
            moment = self.couples.get(of.key)
            if moment is not None and _most(moment) > NOTHING * largest:
                back = loads.guide_moment(on, by)
                self.couples[back.key] = -moment
                yield loads.reaction(by, on).key, (of, on)
                yield loads.reaction(on, by).key, (back, by)

    def _gear(self) -> None:
        """The force of a gear that turns the driving link: in its pitch point along the line of action."""
        linkage = self.found.kinematics.linkage
        gear, moment = linkage.mechanism.driver.gear, self.couples.get(self.moment)
        if gear is None or moment is None:
            return
        omega, mu = self.found.kinematics.omega, self.view.motion.mu
        pivot = self._at(linkage.structure.driver_pair.name)
        at = pivot + complex(gear.pitch_point) / mu
        self.known[GEAR.key] = gear.line(moment, omega) * gear.size(moment, omega)
        self.at[GEAR.key] = [places(at.real, 2), places(at.imag, 2)]

    def _stroke(self) -> None:
        """The force along a driving stroke, as this grows where it is above zero, on the slider or the point that the
        cylinder moves."""
        stroke = self.found.kinematics.linkage.mechanism.driver.stroke
        if isinstance(stroke, Triangle) and "drive" in self.cycle.pairs:
            force = self.cycle.merged(*(table[STROKE.key].numbers() for table in self.cycle.pairs["drive"]))
            _, pin, far = stroke.names
            self.known[STROKE.key] = force * self.cycle.both(stroke.along)
            self.at[STROKE.key] = far if stroke.slides else pin

    def _balanced(self, acts: Acts) -> str:
        """Key of the moment or the force that balances what is shown, "" where nothing does."""
        if any(one.key == STROKE.key for one in acts.forces):
            return STROKE.key
        driven = any(one.key == self.moment for one in acts.couples)
        return self.moment if acts.sides or driven else ""

    # ------------------------------------------------------------ loading schemes

    def _scheme(self, acts: Acts) -> dict[str, Any] | None:
        """None where a force or its place, or the moment of a couple, is not known in every position."""
        links = self.view.mechanism.links.keys()
        if not set(acts.links) <= links | self.replacing.keys():
            return None
        forces: dict[str, list[Any]] = {}
        moved = set()  # couples for which a force stands aside
        for one in (*acts.forces, *self._nil(acts)):
            key = one.key if one.key in self.known else PART.sub("", one.key)
            place = self._place(key)
            if key not in self.known or place is None:
                return None
            if (aside := self._aside(one, acts)) is not None:
                place = [places(aside.at.real, 2), places(aside.at.imag, 2)]
                moved.add(aside.couple)
            whole = one.letter if key == one.key else _whole(one.letter)
            forces[key] = [key, place, letter(whole), COLOURS[one.colour]]
        rods = [self._rod(link) for link in acts.links if link in self.replacing]
        turning = [*acts.couples, *self._nil_couples(acts, moved), *self._of_guides(acts)]
        if any(one.key not in self.couples for one in turning) or any(met is None for _, met, _ in rods):
            return None
        self.vectors |= {key: self.known[key] for key in forces}
        self.turning |= {one.key: self.couples[one.key] for one in turning}
        return {
            "by": round(self.view.motion.mu / acts.scale, 6),
            "links": [link for link in acts.links if link in links],
            "rods": rods,
            "forces": list(forces.values()),
            "couples": [[one.key, self._spot(one, acts), letter(one.letter)] for one in turning],
        }

    def _rod(self, link: str) -> list[Any]:
        """Of a link that replaces a cam pair the places of the centre of curvature, where the follower is met, and the
        letter of the centre."""
        cam = self.replacing[link]
        centre, met = self._at(cam.centre), self._place(loads.reaction(link, cam.follower).key)
        return [[places(centre.real, 2), places(centre.imag, 2)], met, [cam.centre[0], cam.centre[1:]]]

    def _nil(self, acts: Acts) -> Iterator[Acting]:
        """Loads on the links that are nothing in the position of the scheme, and something elsewhere."""
        shown, given = {one.key for one in acts.forces}, self.found.given.forces
        loading, kinematics = self.found.diagram.loading, self.found.kinematics
        every = [(loads.weight(n), n, self._centre(n), "black") for n in loading.gravity]
        every += [(loads.inertia_force(n), n, self._centre(n), "blue") for n in loading.inertia]
        stated = zip(loads.forces(given), given, strict=True)
        every += [(q, loaded_link(kinematics.table, one), one.at, "black") for q, one in stated]
        for quantity, link, point, colour in every:
            if (
                (not acts.links or link in acts.links)
                and quantity.key not in shown
                and self._is(quantity.key)
            ):
                k = int(self.cycle.numbered[acts.position])
                at = complex(self._at(point)[k]) * self.view.motion.mu / acts.scale
                yield Acting(quantity.key, at, lettered(quantity.sign, self.words), colour, point)

    def _nil_couples(self, acts: Acts, moved: Container[str]) -> Iterator[Acting]:
        shown = {one.key for one in acts.couples}
        for quantity, link in self._turned():
            key = quantity.key
            if link in acts.links and key not in shown and key not in moved and key in self.couples:
                k = int(self.cycle.numbered[acts.position])
                point = self._centre(link) or next(iter(self.view.mechanism.links[link].points), "")
                if point and _most(self.couples[key]) > 0:
                    at = complex(self._at(point)[k]) * self.view.motion.mu / acts.scale
                    yield Acting(key, at, lettered(quantity.sign, self.words), "blue", link)

    def _turned(self) -> Iterator[tuple[Quantity, str]]:
        """Every couple that is a load, and the link that it acts on."""
        given = self.found.given.moments
        yield from ((loads.inertia_couple(n), n) for n in self.found.diagram.loading.couples)
        yield from ((q, one.on) for q, one in zip(loads.moments(given), given, strict=True))

    def _of_guides(self, acts: Acts) -> Iterator[Acting]:
        """Moments of guides: the scheme of one position may have their reactions aside in their stead."""
        shown = {one.key for one in acts.couples}
        for one in acts.forces:
            if (guide := self.guides.get(PART.sub("", one.key))) is not None:
                of, on = guide
                if of.key not in shown and on in acts.links:
                    shown.add(of.key)
                    sign = lettered(of.sign, self.words)
                    yield one._replace(key=of.key, letter=sign, colour="blue", on=on)

    def _is(self, key: str) -> bool:
        return key in self.known and _most(self.known[key]) > 0

    def _centre(self, link: str) -> str:
        centre = self.view.mechanism.links[link].mass_centre if link in self.view.mechanism.links else None
        return "" if centre is None else str(centre)

    def _place(self, key: str) -> Any:
        """Where a force acts: a point, the key of the force that acts in the same places, or places of its own, mm of
        the mechanism."""
        if key in self.at:
            at = self.at[key]
            return at if isinstance(at, str) or key == GEAR.key else ["", key]
        opposite = next((k for k in self.known if k in self.at and _opposite(k, key)), None)
        return None if opposite is None else ["", opposite]

    def _aside(self, one: Acting, acts: Acts) -> _Aside | None:
        """Of a force of inertia that is drawn in the centre of percussion, where it alone has the moment of both: its
        places, if they are on the sheet in every position."""
        couples = self.found.diagram.loading.couples
        link = next((n for n in couples if loads.inertia_force(n).key == one.key), None)
        if link is None or (couple := loads.inertia_couple(link).key) not in self.couples:
            return None
        mu, centre = self.view.motion.mu, self._at(self._centre(link))
        k = int(self.cycle.numbered[acts.position])
        force = self.known[one.key]
        with np.errstate(divide="ignore", invalid="ignore"):
            shift = -1j * force * self.couples[couple] / np.abs(force) ** 2 / mu
        drawn = abs(complex(centre[k]) * mu / acts.scale - one.at) > AT
        if not drawn or not _most(shift) <= REACH * acts.scale / mu:
            return None
        return _Aside(couple, centre + shift)

    def _at(self, point: str) -> Array:
        """Places of a point, mm of the mechanism; of a centre of curvature where it is on the sheet."""
        if (cam := self.centres.get(point)) is None:
            return self.view.motion.at(*self._carried(point))
        found = self.cycle.both(Motion.place, point) / self.view.motion.mu
        return np.where(np.abs(found - self._at(cam.point)) <= REACH, found, np.nan)

    def _carried(self, point: str) -> tuple[str, complex]:
        link = self.view.mechanism.links_at(point)[0]
        return link, self.view.motion.local(link, point)

    def _spot(self, one: Acting, acts: Acts) -> list[Any]:
        """Link that carries the place of a couple, and the place in its axes, mm of the mechanism."""
        at = one.at * acts.scale / self.view.motion.mu
        link = one.on or next(name for name in acts.links if name not in self.replacing)
        if link == FRAME:
            return [FRAME, round(at.real, 3), round(at.imag, 3)]
        k = int(self.cycle.numbered[acts.position])
        local = (at - self.view.motion.origins[link][k]) / self.view.motion.axes[link][k]
        return [link, round(local.real, 3), round(local.imag, 3)]

    def _couples(self) -> dict[str, Array]:
        """Key -> moments of all couples in the results, N m, (Q,)."""
        found = {}
        for name in ("stated", "loads", "reactions", "balancing"):
            for one, other in (self.cycle.pairs[name],) if name in self.cycle.pairs else ():
                for column in one.columns:
                    if column.quantity.unit == "N·m" and column.key in other:
                        found[column.key] = self.cycle.merged(column.numbers(), other[column.key].numbers())
        return found

    # ------------------------------------------------------------ the lever

    def _lever(self, acts: Acts) -> dict[str, Any] | None:
        every = (*self.view.mechanism.point_names, *sorted(self.centres))
        points = [p for p in every if f"v_{p}" in acts.sides and f"v_{p}" in self.known]
        fixed = self.view.mechanism.links[FRAME].points
        forces, vectors = [], {}
        for one in (*acts.forces, *self._nil(acts), *self._nil_pairs(acts, points)):
            if any(p not in points and p not in fixed for p in (one.on, one.pair) if p):
                return None
            if (vector := self._on_lever(one)) is None:
                return None
            vectors[one.key] = vector
            ends = [p if p in points else "" for p in ((one.on, one.pair) if one.pair else (one.on,))]
            forces.append([one.key, ends, letter(one.letter), COLOURS[one.colour]])
        there = {p: np.isfinite(self._at(p)) for p in points}
        self.vectors |= vectors | {f"v_{p}": np.where(there[p], self.known[f"v_{p}"], np.nan) for p in points}
        sides = [side for key in acts.sides if (side := _side(key, points)) is not None]
        turn = acts.turn / acts.scale
        return {"turn": [turn.real, turn.imag], "points": points, "sides": sides, "forces": forces}

    def _nil_pairs(self, acts: Acts, points: list[str]) -> Iterator[Acting]:
        """Pairs of forces for the couples that are nothing in the position of the lever."""
        shown = {one.key for one in acts.forces}
        fixed = self.view.mechanism.links[FRAME].points
        for quantity, link in self._turned():
            force = lever_quantities.pair_force(quantity)
            own = [p for p in self.view.mechanism.links[link].points if p in points or p in fixed]
            if force.key not in shown and quantity.key in self.couples and len(own) > 1:
                yield Acting(force.key, 0j, lettered(force.sign, self.words), "blue", own[1], own[0])

    def _on_lever(self, one: Acting) -> Array | None:
        """A force on the lever in all positions, N: one of the results, one of the pair that replaces a couple, or
        that which balances the lever across the crank."""
        if one.key in self.known:
            return self.known[one.key]
        if one.pair:
            along, couple = self._way(one.pair, one.on), self.couples.get(one.key.removeprefix("F_"))
            return None if couple is None else _across(along, couple)
        if one.key == lever_quantities.LEVER_FORCE.key and self.moment in self.couples:
            pivot = self.found.kinematics.linkage.structure.driver_pair.name
            along = self._way(pivot, one.on)
            return _across(along, self.couples[self.moment])
        return None

    def _way(self, start: str, end: str) -> Array:
        """From one point to another, m, (Q,)."""
        one, other = (self._at(p) for p in (start, end))
        return (other - one) * self.view.motion.mu


def _across(along: Array, couple: Array) -> Array:
    """The force across an arm that makes a couple with it, N, (Q,): none where the arm has no length, as a cam at rest
    has, whose centre is the pivot, or where the mechanism cannot be assembled."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return 1j * along / np.abs(along) ** 2 * couple


def _side(key: str, points: list[str]) -> list[str] | None:
    """Key of a velocity, the points from which and to which it leads on the plan, "" for the pole."""
    name = key.removeprefix("v_")
    if name in points:
        return [key, "", name]
    pairs: Iterator[tuple[str, str]] = ((p, r) for p in points for r in points)
    return next(([key, p, r] for p, r in pairs if name in (r + p, f"{r},{p}")), None)


def _opposite(one: str, other: str) -> bool:
    """Whether two keys are of a reaction and of its opposite: R_24 and R_42, R_10,9 and R_9,10."""
    ends = one.partition("_")[2], other.partition("_")[2]
    if not (one.startswith("R_") and other.startswith("R_")):
        return False
    one_by, other_by = (e.split(",") if "," in e else list(e) for e in ends)
    return one_by == other_by[::-1]


def _whole(letter: Part | None) -> Part | None:
    return letter if letter is None or isinstance(letter, str) else type(letter)(letter.base, letter.sub)


def letter(part: Part | None) -> list[str]:
    """Base, lower and upper index."""
    if part is None:
        return [""]
    found = [part] if isinstance(part, str) else [part.base, part.sub, part.sup]
    return found if found[-1] else found[:-1]


def _most(values: Array) -> float:
    """The largest size among the positions that are there."""
    return float(np.max(np.abs(values), initial=0.0, where=np.isfinite(values)))
