"""Counterweights by masses: the mass centres of all links moved to the frame, and masses substituted into joints.

Both put masses m at places z of a link that turns about a pivot p; their static moment Σ m (z − p) is to be met by that
of a counterweight, m_c ρ_c, on the other side.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np

from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.mechanism import FRAME, Link, Mechanism
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.lever.vector_equations import turning_links
from tmm_report.mechanics.masses.counterweights import Support, pivoted, supports
from tmm_report.records import dataclass

NOTHING = 1e-12  # of the sizes of its terms: a static moment that is rounding


@dataclass(frozen=True)
class Carried:
    """A mass on a link: at a joint or the link's own centre `name`, `arm` from the pivot in the link's line, m.

    `links`: whose masses, with their counterweights, it is the sum of, where it is one."""

    name: str
    mass: float
    arm: complex
    links: tuple[str, ...] = ()


@dataclass(frozen=True)
class Unbalanced:
    """A link with the masses that it carries about a pivot.

    `about`, `axis`: the pivot and the unit direction from it to the link's next joint, in the link's axes: the line
    from which angles are measured."""

    link: str
    joint: str
    about: complex
    axis: complex
    carried: tuple[Carried, ...]

    @property
    def mass(self) -> float:
        return sum(one.mass for one in self.carried)

    @property
    def moment(self) -> complex:
        """Σ m (z − p) in the link's line, kg m."""
        total = sum((one.mass * one.arm for one in self.carried), 0j)
        size = sum(abs(one.mass * one.arm) for one in self.carried)
        x, y = (0.0 if abs(part) <= NOTHING * size else part for part in (total.real, total.imag))
        return complex(x, y)


def line_of(mechanism: Mechanism, name: str, about: complex) -> complex:
    """Unit direction from a pivot to the next joint of a link; where it has none, to its next point, a mass centre
    last."""
    link = mechanism.links[name]
    points = sorted(link.points, key=lambda p: (len(mechanism.links_at(p)) < 2, p == link.mass_centre))
    arms = (link.points[point] - about for point in points)
    found = next((arm for arm in arms if abs(arm) > 1e-12), 1 + 0j)
    return complex(found / abs(found))


# ---------------------------------------------------------------- the mass centres moved to the frame


def unreached(linkage: Linkage) -> list[str]:
    """Links with mass that no path of pivots joins to the frame: they cannot be balanced fully (Tepper, Lowen)."""
    found = supports(linkage.structure.pairs, linkage.mechanism.driver.link)
    return [name for name in linkage.mechanism.moving if name not in found and _heavy(linkage, name)]


def _heavy(linkage: Linkage, name: str) -> bool:
    return linkage.mechanism.links[name].mass > 0


def hung(linkage: Linkage, name: str, support: Support, carried: tuple[Carried, ...]) -> Unbalanced:
    link = linkage.mechanism.links[name]
    axis = line_of(linkage.mechanism, name, support.at)
    own: tuple[Carried, ...] = ()
    if link.mass and link.mass_centre is not None:
        arm = complex((link.points[link.mass_centre] - support.at) / axis)
        own = (Carried(link.mass_centre, float(link.mass), arm),)
    return Unbalanced(name, support.joint, complex(support.at), axis, (*own, *carried))


def order_of_centres(linkage: Linkage) -> list[Support]:
    """The links from the farthest to those that are pivoted to the frame."""
    found = supports(linkage.structure.pairs, linkage.mechanism.driver.link)
    return sorted(found.values(), key=lambda support: -support.depth)


def turning(linkage: Linkage) -> set[str]:
    return set(turning_links(linkage))


# ---------------------------------------------------------------- masses substituted into joints


@dataclass(frozen=True)
class Split:
    """A floating link's own mass by two joints, and by three points: `masses` at the joints (total mass and mass centre
    kept), `rest`: what they lack of the moment of inertia, kg m²; `dynamic`: masses at both joints and at the mass
    centre (moment of inertia kept too). `off`: distance of the centre from the line of the joints, m."""

    link: str
    joints: tuple[str, str]
    mass: float
    inertia: float
    arms: tuple[float, float]
    off: float
    masses: tuple[float, float]
    rest: float
    dynamic: tuple[float, float, float]


@dataclass(eq=False)
class Substituted:
    """Found by `substitute`: the splits; the masses of each pivoted link; the reciprocating mass of each sliding one;
    `free`: masses at joints of links that no counterweight of a pivoted link follows; `unmet`: sliding links that hang
    on no rod, of whose masses no part is met."""

    splits: list[Split] = field(default_factory=list)
    carried: dict[str, dict[str, Carried]] = field(default_factory=dict)
    sliding: dict[str, float] = field(default_factory=dict)
    free: dict[str, float] = field(default_factory=dict)
    unmet: list[str] = field(default_factory=list)


def substitute(linkage: Linkage, part: float) -> Substituted:
    """Masses of the floating links put into their joints, handed on until they lie on pivoted or sliding links; `part`
    of what slides is balanced where its rod hangs."""
    found = _Substitution(linkage)
    for name, link in linkage.mechanism.links.items():
        if name != FRAME and link.mass and link.mass_centre is not None:
            if (split := found.split(link)) is not None:
                found.of.splits.append(split)
            found.put(name, link.mass_centre, complex(link.points[link.mass_centre]), float(link.mass))
    for name, mass in list(found.of.sliding.items()):
        found.reciprocating(name, part * mass)
    return found.of


class _Substitution:
    def __init__(self, linkage: Linkage):
        self.mechanism: Mechanism = linkage.mechanism
        self.pairs: list[Pair] = linkage.structure.pairs
        self.fixed = pivoted(self.pairs)
        self.turning = turning(linkage)
        self.rank = {name: k for k, name in enumerate((FRAME, *linkage.structure.order))}
        self.of = Substituted()

    def joints(self, name: str) -> list[Pair]:
        """The pivots of a link, those with links found before it first."""
        own = [pair for pair in self.pairs if pair.kind == "R" and name in pair.links]
        return sorted(own, key=lambda pair: self.rank[pair.other(name)])

    def floating(self, name: str) -> bool:
        return name not in self.fixed and name in self.turning

    def two(self, name: str) -> tuple[Pair, Pair] | None:
        """The two joints between which a floating link's masses are shared."""
        joints = self.joints(name) if self.floating(name) else []
        apart = [pair for pair in joints[1:] if abs(pair.at[name] - joints[0].at[name]) > 1e-12]
        return (joints[0], apart[0]) if apart else None

    def put(
        self, name: str, label: str, at: complex, mass: float, real: bool = True, seen: tuple = ()
    ) -> None:
        """A mass at a place of a link; what only stands for a part of a reciprocating mass is not `real`."""
        if name == FRAME or abs(mass) <= 0:
            return
        if name in self.fixed:
            self._on_pivoted(name, label, at, mass)
        elif not self.floating(name):
            self._on_sliding(name, mass, real, seen)
        elif (both := self.two(name)) is None or name in seen:
            self._alone(name, label, mass, real, seen)
        else:
            first, second = both
            p, q = first.at[name], second.at[name]
            share = mass * complex((at - p) / (q - p)).real
            for pair, of in ((first, mass - share), (second, share)):
                if abs(of) > NOTHING * abs(mass):
                    other = pair.other(name)
                    self.put(other, pair.name, complex(pair.at[other]), of, real, (*seen, name))

    def _on_pivoted(self, name: str, label: str, at: complex, mass: float) -> None:
        about = self.fixed[name]
        arm = complex((at - about) / line_of(self.mechanism, name, about))
        masses = self.of.carried.setdefault(name, {})
        before = masses[label].mass if label in masses else 0.0
        masses[label] = Carried(label, before + mass, arm)

    def _on_sliding(self, name: str, mass: float, real: bool, seen: tuple) -> None:
        """All places of a link that does not turn move alike: its masses lie in the pivot by which it hangs on a
        pivoted link; else they reciprocate."""
        hung = next((pair for pair in self.joints(name) if pair.other(name) in self.fixed), None)
        if hung is not None:
            other = hung.other(name)
            self._on_pivoted(other, hung.name, complex(hung.at[other]), mass)
        elif real:
            self.of.sliding[name] = self.of.sliding.get(name, 0.0) + mass
        else:
            self.reciprocating(name, mass, seen)

    def _alone(self, name: str, label: str, mass: float, real: bool, seen: tuple) -> None:
        """Of a block with a single pivot, at the pivot; else nothing turned by the frame follows it."""
        joints = self.joints(name)
        if name not in seen and len(joints) == 1:
            other = joints[0].other(name)
            self.put(other, joints[0].name, complex(joints[0].at[other]), mass, real, (*seen, name))
        elif real:
            self.of.free[label] = self.of.free.get(label, 0.0) + mass

    def reciprocating(self, name: str, mass: float, seen: tuple = ()) -> None:
        """A part of a sliding mass, put where the rod that drives it hangs, or into the block that drives it."""
        if name in seen:
            return
        for pair in self.joints(name):
            rod = pair.other(name)
            if (both := self.two(rod)) is not None:
                hung = next((one for one in both if one is not pair), both[0])
                other = hung.other(rod)
                self.put(other, hung.name, complex(hung.at[other]), mass, False, (*seen, name, rod))
                return
        if (block := self._block(name)) is not None:
            self._on_sliding(block, mass, False, (*seen, name))
        else:
            self.of.unmet.append(name)

    def _block(self, name: str) -> str | None:
        """A link that slides on a sliding one, does not turn and hangs on a link with a fixed pivot."""
        guides = (pair.other(name) for pair in self.pairs if pair.kind == "P" and name in pair.links)
        blocks = (one for one in guides if one != FRAME and one not in self.fixed and not self.floating(one))
        return next((b for b in blocks if any(p.other(b) in self.fixed for p in self.joints(b))), None)

    def split(self, link: Link) -> Split | None:
        """A link's own mass by its two joints; None for one that is not shared out."""
        both = self.two(link.name)
        if both is None or link.mass_centre is None:
            return None
        p, q = (complex(pair.at[link.name]) for pair in both)
        s = complex(link.points[link.mass_centre])
        line = (q - p) / abs(q - p)
        a, b = ((s - p) / line).real, ((q - s) / line).real
        off = ((s - p) / line).imag
        m, inertia, length = float(link.mass), float(link.inertia), a + b
        at_p, at_q = m * b / length, m * a / length
        off = 0.0 if abs(off) < 1e-12 else off
        rest = inertia - at_p * abs(s - p) ** 2 - at_q * abs(s - q) ** 2
        three = (np.nan, np.nan, np.nan)
        if not off and min(abs(a), abs(b)) > 1e-9 * length:  # the three points are in one line, and apart
            three = (inertia / (a * length), inertia / (b * length), m - inertia / (a * b))
        return Split(
            link.name, (both[0].name, both[1].name), m, inertia, (a, b), off, (at_p, at_q), rest, three
        )
