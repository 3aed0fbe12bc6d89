"""Structure of a planar mechanism: pairs, mobility, and its Assur groups, found from links and joints.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 2-3; W = 3n - 2p5 (Chebyshev).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import combinations, islice
from typing import Literal

from tmm_report.mechanics.lever.mechanism import FRAME, Link, Mechanism, Scalar
from tmm_report.mechanics.lever.wheels.coupled import Coupled, coupled
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.records import dataclass

# (inner pair, sorted outer pairs) -> kind of the dyad; a third sliding pair (PPP) would leave a free translation
DYAD_KINDS: dict[tuple[str, str], int] = {
    ("R", "RR"): 1,
    ("R", "PR"): 2,
    ("P", "RR"): 3,
    ("R", "PP"): 4,
    ("P", "PR"): 5,
}
KIND_NAMES = {1: "RRR", 2: "RRP", 3: "RPR", 4: "PRP", 5: "RPP"}
MOST_TURNS = 1e5  # of a wheel for one turn of another link
MOST_SETS = 20_000  # sets of links that are tried for the next group
ROMAN = {1: "I", 2: "II", 3: "III", 4: "IV", 5: "V", 6: "VI"}


@dataclass(frozen=True, eq=False)
class Pair:
    """A lower pair of two links, the one nearer to the frame first; or a higher one, H, of a cam and its
    follower or of two wheels.

    `at`: link -> place of the joint (R) or of a point of the guide line (P) in that link's axes, m.
    `along`: link -> unit direction of the guide line in that link's axes (P only). `slider`: the link that slides;
    the other carries the guide.
    """

    kind: Literal["R", "P", "H"]
    name: str
    links: tuple[str, str]
    at: Mapping[str, Scalar]
    along: Mapping[str, Scalar] = field(default_factory=dict)
    slider: str | None = None

    def other(self, link: str | None) -> str:
        """The other link of the pair."""
        return self.links[1] if link == self.links[0] else self.links[0]

    @property
    def key(self) -> str:
        return f"{self.links[0]}-{self.links[1]}"


@dataclass(frozen=True, eq=False)
class Group:
    """An Assur group: its links, inner and outer pairs, class and order (= number of outer pairs). `wheels`: the links
    that meshes with its own move, in the order in which they become known."""

    links: tuple[str, ...]
    inner: tuple[Pair, ...]
    outer: tuple[Pair, ...]
    group_class: int
    kind: int | None  # of a dyad, 1..5
    wheels: tuple[Coupled, ...] = ()

    @property
    def order(self) -> int:
        return len(self.outer)

    @property
    def label(self) -> str:
        return f"{ROMAN.get(self.group_class, self.group_class)}{self.order}({','.join(self.links)})"


@dataclass(frozen=True, eq=False)
class Structure:
    """`groups` in the order of assembly: each hangs on the frame, the driving link and groups before it. `wheels`: the
    links that meshes with the driving link move."""

    mechanism: Mechanism
    driver_pair: Pair
    groups: tuple[Group, ...]
    wheels: tuple[Coupled, ...] = ()

    @property
    def coupled(self) -> tuple[Coupled, ...]:
        """All links that meshes move, in the order of assembly."""
        return (*self.wheels, *(wheel for group in self.groups for wheel in group.wheels))

    @property
    def order(self) -> list[str]:
        """The moving links in the order of assembly."""
        found = [self.mechanism.driver.link, *(wheel.link for wheel in self.wheels)]
        for group in self.groups:
            found += [*group.links, *(wheel.link for wheel in group.wheels)]
        return found

    @property
    def pairs(self) -> list[Pair]:
        """The lower pairs, and the higher ones of the wheels after all of them."""
        lower = [self.driver_pair, *(wheel.bearing for wheel in self.wheels)]
        for group in self.groups:
            lower += [*group.outer, *group.inner, *(wheel.bearing for wheel in group.wheels)]
        return [*lower, *(wheel.contact for wheel in self.coupled)]

    @property
    def formula(self) -> str:
        """E.g. I(0,1) → II2(2,3) → II2(4,5); a link moved by a mesh is z(4)."""
        parts = [f"I(0,{self.mechanism.driver.link})", *(f"z({wheel.link})" for wheel in self.wheels)]
        for group in self.groups:
            parts += [group.label, *(f"z({wheel.link})" for wheel in group.wheels)]
        return " → ".join(parts)

    @property
    def mechanism_class(self) -> int:
        return max((group.group_class for group in self.groups), default=1)


def count_pairs(mechanism: Mechanism) -> int:
    """Number of lower pairs p5; a point shared by k links counts as k - 1 revolute pairs."""
    shared = (len(mechanism.links_at(point)) for point in mechanism.point_names)
    return sum(k - 1 for k in shared) + len(mechanism.slides)


def mobility(mechanism: Mechanism) -> int:
    """W = 3n - 2p5 - p4 (Chebyshev); a cam pair, replaced by a link with two lower pairs, takes as much as -p4
    would."""
    return 3 * len(mechanism.moving) - 2 * count_pairs(mechanism) - len(mechanism.meshes)


def decompose(mechanism: Mechanism, sliding: bool = False) -> Structure:
    """Find the Assur groups. Raises ProblemError for W ≠ 1, redundant constraints, loose links and links that stand
    still.

    `sliding`: the driving link may also slide on the frame; its groups are found, but such a drive is not solved.
    """
    driver_pair = _driver_pair(mechanism, "RP" if sliding else "R")
    if (w := mobility(mechanism)) != 1:
        raise ProblemError([_wrong_mobility(mechanism, w)])
    if (w := _freedom(mechanism, [FRAME], (mechanism.driver.link,))) != 1:  # held by more than its pivot
        raise ProblemError([_redundant([mechanism.driver.link], [FRAME], w)])
    known = [FRAME, mechanism.driver.link]
    moved: list[Coupled] = []
    wheels = _moved_by_meshes(mechanism, known, moved)
    groups: list[Group] = []
    while rest := [name for name in mechanism.moving if name not in known]:
        links = _next_group(mechanism, known, rest)
        group = _group(mechanism, known, links)
        if all(pair.links[0] == FRAME for pair in group.outer):
            raise ProblemError([_still(links)])
        known += links
        groups.append(replace(group, wheels=_moved_by_meshes(mechanism, known, moved)))
    return Structure(mechanism, driver_pair, tuple(groups), wheels)


@dataclass(frozen=True, eq=False)
class Alternative:
    """Another choice of driving link: what the groups become, or why it cannot drive."""

    link: str
    structure: Structure | None
    reason: Message | None = None

    @property
    def taken_apart(self) -> bool:
        """Whether the mechanism has only dyads then."""
        return self.structure is not None and self.structure.mechanism_class <= 2


def alternatives(mechanism: Mechanism) -> list[Alternative]:
    """Every other link that is joined to the frame as the driving link: pivoted links, then sliders.

    A group of higher class may fall apart into dyads when another link drives; the mechanism's class changes with it.
    """
    found: list[Alternative] = []
    if mechanism.cams or mechanism.meshes:  # a follower cannot turn its cam
        return found
    for kind in "RP":
        for link in mechanism.moving:
            if link == mechanism.driver.link or link in [a.link for a in found]:
                continue
            if any(pair.kind == kind for pair in _pairs_of(mechanism, [FRAME], [link])):
                found.append(_alternative(mechanism, link))
    return found


def _alternative(mechanism: Mechanism, link: str) -> Alternative:
    try:
        driven = replace(mechanism, driver=replace(mechanism.driver, link=link))
        return Alternative(link, decompose(driven, sliding=True))
    except ProblemError as error:
        return Alternative(link, None, error.problems[0].wrong)


def with_cylinder_held(mechanism: Mechanism, ends: Sequence[str], links: Sequence[str]) -> tuple[Group, ...]:
    """The groups of a mechanism that a cylinder between two points drives: its length held, it is one link, and all
    links hang on the frame. `links`: barrel and rod, where they are links of the mechanism. Raises ProblemError.
    """
    name = "+".join(links) or "".join(ends)
    cylinder = Link(name, {point: at for link in links for point, at in mechanism.links[link].points.items()})
    if not links:
        cylinder = Link(name, {ends[0]: 0.0, ends[1]: 1.0})
    inner = {
        slide.guide
        for slide in mechanism.slides
        if {slide.link, mechanism.guides[slide.guide].link} == {*links}
    }
    one = replace(
        mechanism,
        links={**{key: link for key, link in mechanism.links.items() if key not in links}, name: cylinder},
        slides=tuple(
            replace(slide, link=name if slide.link in links else slide.link)
            for slide in mechanism.slides
            if slide.guide not in inner
        ),
        guides={
            key: replace(guide, link=name if guide.link in links else guide.link)
            for key, guide in mechanism.guides.items()
            if key not in inner
        },
    )
    known, found = [FRAME], list[Group]()
    while rest := [link for link in one.moving if link not in known]:
        group = _next_group(one, known, rest)
        found.append(_group(one, known, group))
        known += group
    return tuple(found)


def _driver_pair(mechanism: Mechanism, kinds: str) -> Pair:
    link = mechanism.driver.link
    for pair in _pairs_of(mechanism, [FRAME], [link]):
        if pair.kind in kinds:
            return pair
    right = Message(N_("give it a point of the frame, or choose another driving link"))
    path = ("mechanism", "driver", "link")
    raise ProblemError(
        [mistake(N_("driving link %(link)s is not pivoted to the frame"), path, right, link=link)]
    )


def _wrong_mobility(mechanism: Mechanism, w: int) -> Problem:
    built = mechanism.real
    n, p = len(built.moving), count_pairs(built)
    higher = len(mechanism.cams) + len(mechanism.meshes)
    with_cams = N_(
        "mobility is W = 3·%(n)d − 2·%(p)d − %(higher)d = %(w)d (n = %(n)d moving links, p5 = %(p)d lower pairs, "
        "p4 = %(higher)d higher pairs), it must be 1"
    )
    text = N_(
        "mobility is W = 3·%(n)d − 2·%(p)d = %(w)d (n = %(n)d moving links, p5 = %(p)d lower pairs), it must be 1"
    )
    if w > 1:
        right = Message(
            N_("%(excess)d link end(s) too free: join them to another link, to a fixed point or to a guide"),
            {"excess": w - 1},
        )
    else:
        right = Message(
            N_("%(excess)d constraint(s) too many: a link or a pair is redundant, leave it out"),
            {"excess": 1 - w},
        )
    if higher:
        return mistake(with_cams, ("mechanism", "links"), right, n=n, p=p, higher=higher, w=w)
    return mistake(text, ("mechanism", "links"), right, n=n, p=p, w=w)


def _pairs_of(mechanism: Mechanism, known: list[str], group: list[str] | tuple[str, ...]) -> Iterator[Pair]:
    """Pairs of the links of `group` with each other and with `known` links.

    At a point shared by several links each hangs on the known link that came first (or, inside the group, on
    the first of the group): k links at a point make k - 1 pairs.
    """
    for place in sorted({place for link in group for place in mechanism.shared_by[link]}):
        point = mechanism.shared[place]
        here = mechanism.links_at(point)
        inside = [name for name in here if name in group]
        base = next((name for name in known if name in here), inside[0])
        for name in inside:
            if name != base:
                at = {link: mechanism.links[link].points[point] for link in (base, name)}
                yield Pair("R", point, (base, name), at)
    for slide in mechanism.slides:
        guide = mechanism.guides[slide.guide]
        ends = (guide.link, slide.link)
        if all(link in known or link in group for link in ends) and any(link in group for link in ends):
            links = (
                ends if _rank(mechanism, known, ends[0]) <= _rank(mechanism, known, ends[1]) else ends[::-1]
            )
            at = {guide.link: guide.through, slide.link: slide.through}
            along = {guide.link: guide.direction, slide.link: slide.direction}
            yield Pair("P", guide.name, links, at, along, slide.link)


def _rank(mechanism: Mechanism, known: list[str], link: str) -> int:
    """Known links first, in the order they became known; then in the order of the description."""
    return known.index(link) if link in known else len(known) + mechanism.moving.index(link)


def _freedom(mechanism: Mechanism, known: list[str], links: tuple[str, ...]) -> int:
    """Mobility of `links` when `known` stand still: 0 for an Assur group, < 0 for redundant constraints."""
    return 3 * len(links) - 2 * sum(1 for _ in _pairs_of(mechanism, known, links))


def _next_group(mechanism: Mechanism, known: list[str], rest: list[str]) -> list[str]:
    """The smallest set of links that the known links fix: first in the order of the description."""
    sets = (links for size in range(1, len(rest) + 1) for links in combinations(rest, size))
    for links in islice(sets, MOST_SETS):
        freedom = _freedom(mechanism, known, links)
        if freedom == 0 and _joined(mechanism, known, links):
            return list(links)
        if freedom < 0:
            raise ProblemError([_redundant(links, known, freedom)])
    if next(islice(sets, 1), None) is not None:
        raise ProblemError([_not_found(rest)])
    idle = [m for m in mechanism.meshes if not set(m.links) <= {*known} and set(m.links) & {*rest}]
    if idle:
        raise ProblemError([_in_a_group(idle[0], rest)])
    text = N_("links %(links)s form no Assur group: nothing joins them to the driving link and the frame")
    raise ProblemError([mistake(text, ("mechanism", "links", rest[0]), links=", ".join(rest))])


def _moved_by_meshes(mechanism: Mechanism, known: list[str], done: list[Coupled]) -> tuple[Coupled, ...]:
    """The links that become known by meshes with `known` ones, wheel after wheel; `known` and `done` grow."""
    found: list[Coupled] = []
    while True:
        ready = (
            m for m in mechanism.meshes if _is_ready(m, known) and all(m is not one.mesh for one in done)
        )
        mesh = next(ready, None)
        if mesh is None:
            return tuple(found)
        if set(mesh.links) <= {*known}:
            raise ProblemError([_twice_moved(mesh)])
        link = next(one for one in mesh.links if one not in known)
        bearings = list(_pairs_of(mechanism, known, [link]))
        if len(bearings) != 1 or (bearings[0].kind == "P" and bearings[0].links[0] != FRAME):
            raise ProblemError([_twice_moved(mesh)])
        contact = Pair("H", mesh.pole, (mesh.other(link), link), {})
        bearing = _on_carrier(mechanism, mesh, link, bearings[0])
        moved = coupled(mesh, link, bearing, contact, done, mechanism.driver.link)
        if (wrong := _not_repeated(mechanism, moved)) is not None:
            raise ProblemError([wrong])
        done.append(moved)
        found.append(moved)
        known.append(link)


def _on_carrier(mechanism: Mechanism, mesh: Mesh, link: str, bearing: Pair) -> Pair:
    """The pivot of a wheel on its carrier, where several moving links share it."""
    points = mechanism.links[mesh.carrier].points
    if FRAME in (mesh.carrier, bearing.links[0]) or bearing.name not in points:
        return bearing
    at = {mesh.carrier: points[bearing.name], link: bearing.at[link]}
    return Pair("R", bearing.name, (mesh.carrier, link), at)


def _is_ready(mesh: Mesh, known: list[str]) -> bool:
    """Whether the carrier and one of the links are known."""
    return mesh.carrier in known and bool(set(mesh.links) & {*known})


def _mesh_path(mesh: Mesh) -> tuple[str | int, ...]:
    key, _, number = mesh.name.partition(" ")
    return ("mechanism", key, int(number))


def _twice_moved(mesh: Mesh) -> Problem:
    text = N_("links %(links)s are moved by other parts of the mechanism already: their mesh is redundant")
    right = Message(N_("leave the mesh out, or one of the links or pairs that move both of them"))
    return mistake(text, _mesh_path(mesh), right, links=", ".join(mesh.links))


def _in_a_group(mesh: Mesh, rest: Sequence[str]) -> Problem:
    text = N_(
        "links %(links)s become known neither from each other nor before their mesh: a mesh within a group, whose "
        "equations would be solved together with it, is not offered"
    )
    right = Message(
        N_(
            "let the driving link, or what it moves through dyads, turn one of the wheels, and the carrier where its "
            "axis moves"
        )
    )
    return mistake(text, _mesh_path(mesh), right, links=shown(", ".join(rest), 80))


def _not_repeated(mechanism: Mechanism, moved: Coupled) -> Problem | None:
    """A wheel with joints, or a rack, that a full turn of the driving link does not bring back, or a wheel whose angle
    would be lost in rounding."""
    turns, driver, own = moved.by_turns, mechanism.driver, mechanism.links[moved.link]
    if any(root.way is None and abs(root.rate) > MOST_TURNS for root in moved.roots):
        text = N_(
            "link %(link)s makes more than %(most)s turns for one of another link: its angle is not told so far"
        )
        right = Message(N_("ratios that do not multiply to so many turns"))
        return mistake(text, _mesh_path(moved.mesh), right, link=moved.link, most=f"{MOST_TURNS:.0f}")
    if not driver.goes_round:
        return None
    if moved.slides and abs(turns) > 1e-12:
        text = N_("the rack on link %(link)s runs away: the wheel that drives it makes full turns")
        right = Message(N_("state driver.range, less than a full turn, or let a rocker drive the rack"))
        return mistake(text, _mesh_path(moved.mesh), right, link=moved.link)
    axis = moved.bearing.at[moved.link]
    plain = all(abs(complex(at) - complex(axis)) < 1e-12 for at in own.points.values())
    carries = any(guide.link == moved.link for guide in mechanism.guides.values())
    if moved.slides or abs(turns - round(turns)) < 1e-9 or (plain and not carries):
        return None
    text = N_(
        "link %(link)s makes %(turns)s turns for each turn of the driving link: the motion does not repeat with every "
        "turn, and such a cycle is not offered"
    )
    right = Message(
        N_("a whole number of turns (radii or teeth in a ratio as 1:1 or 2:1), or driver.range below a turn")
    )
    return mistake(text, _mesh_path(moved.mesh), right, link=moved.link, turns=f"{abs(turns):.4g}")


def _not_found(rest: Sequence[str]) -> Problem:
    text = N_(
        "links %(links)s: none of the first %(count)s sets of them is an Assur group; larger ones are not sought"
    )
    right = Message(N_("take links out, or join them so that smaller groups arise"))
    names = shown(", ".join(rest), 80)
    return mistake(text, ("mechanism", "links", rest[0]), right, links=names, count=MOST_SETS)


def _joined(mechanism: Mechanism, known: list[str], links: tuple[str, ...]) -> bool:
    """Whether a pair joins `links` to known ones: a rigid truss that floats has freedom 0 by count too."""
    return any(link in known for pair in _pairs_of(mechanism, known, links) for link in pair.links)


def _redundant(links: Sequence[str], known: list[str], w: int) -> Problem:
    text = N_("links %(links)s have redundant constraints: alone with links %(known)s they have W = %(w)d")
    right = Message(N_("leave out the redundant link or pair (another part of the mechanism is too free)"))
    values = {"links": ", ".join(links), "known": ", ".join(known), "w": w}
    return mistake(text, ("mechanism", "links", links[0]), right, **values)


def _still(links: Sequence[str]) -> Problem:
    """Of a group that hangs on the frame alone: the first such one is met before all that would hang on it."""
    text = N_("links %(links)s stand still: the frame alone holds them, the driving link does not move them")
    right = Message(N_("join them to a moving link; a guide on a moving link states it: link: 1"))
    return mistake(text, ("mechanism", "links", links[0]), right, links=", ".join(links))


def _group(mechanism: Mechanism, known: list[str], links: list[str]) -> Group:
    pairs = list(_pairs_of(mechanism, known, links))
    inner = tuple(pair for pair in pairs if all(link in links for link in pair.links))
    outer = tuple(pair for pair in pairs if pair not in inner)
    if len(links) != 2:
        return Group(tuple(links), inner, outer, _higher_class(links, inner), None)
    kind = (
        DYAD_KINDS.get((inner[0].kind, "".join(sorted(pair.kind for pair in outer))))
        if len(inner) == 1
        else None
    )
    if kind is None:
        text = N_("links %(links)s form no dyad: with three prismatic pairs a translation stays free")
        right = Message(N_("a dyad has at most two prismatic pairs"))
        raise ProblemError([mistake(text, ("mechanism", "links", links[0]), right, links=", ".join(links))])
    return Group(tuple(links), inner, outer, 2, kind)


def _higher_class(links: list[str], inner: tuple[Pair, ...]) -> int:
    """III for an open group with a ternary basis link; else the number of sides of its largest closed contour."""
    neighbours = {link: [pair.other(link) for pair in inner if link in pair.links] for link in links}
    longest = 0

    def walk(path: list[str]) -> None:
        nonlocal longest
        for step in neighbours[path[-1]]:
            if step == path[0] and len(path) > 2:
                longest = max(longest, len(path))
            elif step not in path:
                walk([*path, step])

    for link in links:
        walk([link])
    return max(longest, 3)
