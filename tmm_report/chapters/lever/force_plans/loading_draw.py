"""Loading schemes of the force plans: each group, or each of its links, with all that acts on it, arms dimensioned."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from tmm_report.chapters.lever.force_plans.drafting import ForceDrawn, ForcePlan
from tmm_report.chapters.lever.force_plans.drafting.plan import Held
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.figures.drawing import AXIS, Acting, Acts, Circle, Drawing, Item, Pen, Tag
from tmm_report.figures.lettering import Part, lettered, symbol
from tmm_report.figures.loading import Arm, Couple, Force, loading, point_mark
from tmm_report.figures.plans import PENS, Style
from tmm_report.figures.schemes.apart import loose
from tmm_report.figures.schemes.ties import Tie
from tmm_report.figures.schemes.view import View, view_of
from tmm_report.mechanics.lever.cams.replacing_dyad import standing
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.quantity.symbols import Symbol

Letter = Callable[[Symbol], Part | None]

TIED = Pen(0.2, "grey")
CROWDED = 13  # forces and arms: more of them are told apart in a figure a link
STYLES: dict[str, Style] = {"gravity": "force", "load": "force", "inertia": "inertia"}  # others are reactions


class Loaded(NamedTuple):
    """A loading scheme and the links that it shows."""

    links: tuple[str, ...]
    drawing: Drawing


def loading_schemes(
    kinematics: Kinematics,
    mu_l: float,
    drawn: ForceDrawn,
    plan: ForcePlan,
    words: Callable[[str], str],
    ties: Sequence[Tie] = (),
) -> list[Loaded]:
    """At the scale `mu_l`, m/mm, as the mechanism lies; `words`: how a word of an index is said; `ties`: springs and
    dampers, shown thin under the forces with which they act."""
    letter = partial(lettered, words=words)
    view = replace(_view(kinematics, mu_l, drawn.position), ties=ties)
    single = bool(plan.balances) or (not plan.together and _count(plan) > CROWDED)
    shown = [(link,) for link in plan.links] if single and len(plan.links) > 1 else [plan.links]
    return [Loaded(links, _scheme(view, drawn, plan, links, letter)) for links in shown]


def _view(kinematics: Kinematics, mu_l: float, position: int) -> View:
    motion, mechanism = kinematics.table, kinematics.linkage.mechanism
    if mechanism.cams:  # the links that replace cam pairs are those of this position
        motion, position = standing(motion, position), 0
        mechanism = motion.linkage.mechanism
    places = {point: np.broadcast_to(motion.place(point), motion.shape) for point in mechanism.point_names}
    turns = {link: np.broadcast_to(motion.turn(link), motion.shape) for link in mechanism.moving}
    return view_of(mechanism, places, turns, mu_l, position)


def _count(plan: ForcePlan) -> int:
    held = [one for one in plan.held if one.kind != "inner"]
    return len(held) + len(plan.arms) + sum(map(len, plan.loads.values()))


def _scheme(view: View, drawn: ForceDrawn, plan: ForcePlan, links: Sequence[str], letter: Letter) -> Drawing:
    items, tags = loose(view, links)
    tied = [*view.tied.items(links, TIED), *map(point_mark, view.tied.far(links))]
    items = [*tied, *_pitch_circle(view, links), *items]
    mu = view.motion.mu
    marks, letters = _swing_centres(view, drawn, links)
    for pole in (one for one in plan.poles if set(one.links) & set(links)):
        marks.append(point_mark(pole.at / mu))
        letters.append(Tag((symbol(pole.name),), (pole.at / mu,)))
    arms = [
        Arm(a.centre / mu, a.at / mu, a.along, letter(a.quantity.sign), a.quantity.key)
        for a in plan.arms if a.link in links
    ]  # fmt: skip
    forces = [*_loads(plan, links, mu, letter), *_reactions(view, plan, links, letter)]
    couples = list(_couples(view, plan, links, letter))
    shown = loading([*items, *marks], [*tags, *letters], forces, arms, [couple for _, couple in couples])
    acting = [Acting(f.of, f.at, f.label, PENS[f.style].colour) for f in forces if not f.assumed]
    turning = [Acting(acts.key, couple.at, couple.label, "blue", acts.on) for acts, couple in couples]
    return replace(shown, acts=Acts(drawn.position, mu, tuple(acting), tuple(turning), tuple(links)))


def _pitch_circle(view: View, links: Sequence[str]) -> list[Item]:
    """Of the gear that turns the driving link, with the pitch point."""
    gear = view.mechanism.driver.gear
    if gear is None or tuple(links) != (view.driver,):
        return []
    point = view.pivot + complex(gear.pitch_point) / view.motion.mu
    return [Circle(view.pivot, float(gear.radius) / view.motion.mu, AXIS), point_mark(point)]


def _swing_centres(view: View, drawn: ForceDrawn, links: Sequence[str]) -> tuple[list[Item], list[Tag]]:
    places = {
        f"{one.letter}{one.link}": one.centre / view.motion.mu for one in drawn.reduced if one.link in links
    }
    tags = [Tag((symbol(name),), (place,)) for name, place in places.items()]
    return [point_mark(place) for place in places.values()], tags


def _loads(plan: ForcePlan, links: Sequence[str], mu: float, letter: Letter) -> Iterator[Force]:
    for link in links:
        for force in plan.loads[link]:
            style = STYLES.get(force.kind, "reaction")
            label = letter(force.quantity.sign)
            yield Force(force.at / mu, force.vector, label, style, force.key)


def _reactions(view: View, plan: ForcePlan, links: Sequence[str], letter: Letter) -> Iterator[Force]:
    """One that was found against the sense assumed is shown as it acts, beside it what was assumed."""
    for one in _held(plan, links):
        label, at = letter(one.quantity.sign), _place(view, one)
        if abs(one.vector) > 0:
            yield Force(at, one.vector, label, "reaction", one.key)
            if one.turned:
                yield Force(at, -one.vector, None, "reaction", assumed=True)


def _held(plan: ForcePlan, links: Sequence[str]) -> Iterator[Held]:
    """What holds the links; where all of a group are shown, inner reactions are none of them."""
    whole = tuple(links) == plan.links and len(links) > 1
    yield from (one for one in plan.held if one.link in links and not (whole and one.kind == "inner"))


def _place(view: View, one: Held) -> complex:
    return one.at / view.motion.mu


class _On(NamedTuple):
    """Key of a couple, and the link on which it is drawn, "" of one in a joint."""

    key: str
    on: str


def _couples(
    view: View, plan: ForcePlan, links: Sequence[str], letter: Letter
) -> Iterator[tuple[_On, Couple]]:
    for link in links:
        for couple in plan.couples[link]:
            drawn = Couple(_on(view, link), couple.value, letter(couple.quantity.sign))
            yield _On(couple.key, link), drawn
    for one in _held(plan, links):
        if one.couple:
            of = one.moment or one.quantity
            yield _On(of.key, ""), Couple(_place(view, one), one.couple, letter(of.sign))
    if plan.drive is not None and plan.links[0] in links:
        of = plan.drive.quantity
        yield _On(of.key, FRAME), Couple(view.pivot, plan.drive.value, letter(of.sign))


def _on(view: View, link: str) -> complex:
    """Where a couple on a link is drawn: in the middle of its points, off them."""
    own = [view.points[p] for p in view.mechanism.links[link].points if p in view.points]
    if not own:
        return view.at(link, 0j)
    far = max(own, key=lambda z: abs(z - own[0]))
    return own[0] + 0.7 * (far - own[0])
