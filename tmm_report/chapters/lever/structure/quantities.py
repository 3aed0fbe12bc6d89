"""The numbers of structure: links, pairs, mobility, groups, class; what another driving link would make of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.lever.structure.solve import Structure
from tmm_report.i18n import NP_
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, kept, text_column
from tmm_report.quantity.symbols import Symbol, both
from tmm_report.quantity.tabulated import tabulated

PAIRS = Message(N_("kinematic pairs"))
GROUPS = Message(N_("Assur groups, in the order in which they are detached"))
DRIVERS = Message(N_("what the mechanism would be if another link drove"))

NUMBER = Quantity("number", None, "", Message(N_("its number")))
MOBILITY = Quantity("mobility", None, "", Message(N_("mobility of the pair")))
CLASS = Quantity("class", None, "", Message(N_("class")))
ORDER = Quantity("order", None, "", Message(N_("order")))
OWN_LINKS = Quantity("links_count", None, "", Message(N_("number of its links")))
OWN_LOWER = Quantity("lower", None, "", Message(N_("number of its lower pairs, outer and inner")))
OWN_HIGHER = Quantity("higher", None, "", Message(N_("number of its higher pairs")))
EQUATIONS = Quantity("equations", None, "", Message(N_("number of its equations of equilibrium, 3n")))
UNKNOWNS = Quantity("unknowns", None, "", Message(N_("number of unknowns of its reactions, 2p5 + p4")))

MOVING = Quantity("n", Symbol("n"), "", Message(N_("number of moving links")))
LOWER = Quantity("p5", Symbol("p", "5"), "", Message(N_("number of lower pairs")))
HIGHER = Quantity("p4", Symbol("p", "4"), "", Message(N_("number of higher pairs")))
REPLACED = NP_("index", "repl")  # of the mechanism whose higher pairs are replaced by links
REPLACED_MOVING = Quantity(
    "n_repl", Symbol("n", REPLACED), "", Message(N_("number of moving links, the replacing ones included"))
)
REPLACED_LOWER = Quantity(
    "p5_repl",
    Symbol("p", "5", REPLACED),
    "",
    Message(N_("number of lower pairs, those of the replacing links included")),
)
REPLACED_FREEDOM = Quantity(
    "W_repl", Symbol("W", REPLACED), "", Message(N_("mobility of the replacing mechanism"))
)
FREEDOM = Quantity("W", Symbol("W"), "", Message(N_("mobility")))
MECHANISM_CLASS = Quantity("class", None, "", Message(N_("class of the mechanism")))


def index_of(mesh: Mesh) -> str:
    """The links of a mesh in an index: 12; longer names are told apart by a comma."""
    return mesh.pole.removeprefix("P")


@kept
def _radius(link: str, index: str, symbol: str, rolls: bool) -> Quantity:
    text = (
        N_("radius of wheel %(link)s") if rolls else N_("working pitch radius of the wheel on link %(link)s")
    )
    meaning = Message(text, {"link": link})
    return Quantity(f"r_{link}_{index}", Symbol("r", symbol), "m", meaning)


def pitch_radius(linkage: Linkage, mesh: Mesh, link: str) -> Quantity:
    """The radius r_2 of the wheel on link 2; of several on one link r_2,12 and r_2,23."""
    several = sum(link in one.links for one in linkage.mechanism.meshes) > 1
    return _radius(link, index_of(mesh), f"{link},{index_of(mesh)}" if several else link, mesh.rolls)


@kept
def transfer(one: str, other: str, index: str, rack: bool, carrier: str = FRAME) -> Quantity:
    """The ratio by which the second link follows the first; relative to a moving carrier."""
    names = {"one": one, "other": other, "carrier": carrier}
    unit, sign = "1/m" if rack else "", Symbol("i", index, f"({carrier})" if carrier != FRAME else "")
    if rack and carrier != FRAME:
        text = N_(
            "angular velocity of wheel %(other)s by the velocity of rack %(one)s relative to carrier %(carrier)s, "
            "along its guide"
        )
    elif rack:
        text = N_("angular velocity of wheel %(other)s by the velocity of rack %(one)s along its guide")
    elif carrier != FRAME:
        text = N_(
            "angular velocity of link %(other)s by that of link %(one)s, both relative to carrier %(carrier)s; below "
            "zero: in the opposite sense"
        )
    else:
        text = N_(
            "angular velocity of link %(other)s by that of link %(one)s; below zero: in the opposite sense"
        )
    return Quantity(f"i_{index}", sign, unit, Message(text, names))


def transfer_of(mesh: Mesh) -> Quantity:
    return transfer(*mesh.links, index_of(mesh), mesh.kind == "rack", mesh.carrier)


@kept
def _share(carrier: str, other: str, rack: bool) -> Quantity:
    """The ratio by which the wheel that rolls on a fixed one follows its carrier."""
    if rack:
        text = N_("angular velocity of wheel %(other)s by the velocity of carrier %(one)s along its guide")
    else:
        text = N_(
            "angular velocity of link %(other)s by that of carrier %(one)s; below zero: in the opposite sense"
        )
    of, unit = Message(text, {"one": carrier, "other": other}), "1/m" if rack else ""
    return Quantity(f"i_{carrier}_{other}", Symbol("i", both(carrier, other)), unit, of)


def share_of(mesh: Mesh) -> Quantity:
    """Of a mesh with the frame."""
    return _share(mesh.carrier, mesh.links[1], mesh.kind == "rack")


@kept
def _teeth(link: str, index: str) -> Quantity:
    meaning = Message(N_("number of teeth of the wheel on link %(link)s"), {"link": link})
    return Quantity(f"z_{link}_{index}", Symbol("z", f"{link},{index}"), "", meaning)


def teeth_of(mesh: Mesh, link: str) -> Quantity:
    return _teeth(link, index_of(mesh))


@kept
def _module(index: str) -> Quantity:
    return Quantity(f"m_{index}", Symbol("m", index), "m", Message(N_("module of the teeth")), "mm")


def module_of(mesh: Mesh) -> Quantity:
    return _module(index_of(mesh))


@kept
def _phase(one: str, other: str, index: str, rack: bool, carrier: str) -> Quantity:
    names = {"one": one, "other": other, "carrier": carrier}
    if rack and one == FRAME:
        text = N_("angle of wheel %(other)s where carrier %(carrier)s is at the point of its guide")
    elif rack and carrier != FRAME:
        text = N_(
            "angle of wheel %(other)s where rack %(one)s and carrier %(carrier)s are at the points of their guides"
        )
    elif rack:
        text = N_("angle of wheel %(other)s where rack %(one)s is at the point of its guide")
    elif one == FRAME:
        text = N_("angle of link %(other)s where that of carrier %(carrier)s is 0")
    elif carrier != FRAME:
        text = N_("angle of link %(other)s where those of link %(one)s and of carrier %(carrier)s are 0")
    else:
        text = N_("angle of link %(other)s where that of link %(one)s is 0")
    return Quantity(f"phase_{index}", Symbol("phi", f"{other},0"), "deg", Message(text, names))


def phase_of(mesh: Mesh) -> Quantity:
    return _phase(*mesh.links, index_of(mesh), mesh.kind == "rack", mesh.carrier)


def _of_meshes(found: Structure) -> Iterator[Value]:
    for mesh in found.linkage.mechanism.meshes:
        for link in mesh.links:
            if mesh.radius(link):
                yield pitch_radius(found.linkage, mesh, link).value(mesh.radius(link))
        if not (FRAME in mesh.links and mesh.kind == "rack"):
            yield transfer_of(mesh).value(mesh.ratio)
        if FRAME in mesh.links:
            yield share_of(mesh).value(mesh.share)
        yield phase_of(mesh).value(float(np.degrees(mesh.phase)))
        for link, count in zip(mesh.links, mesh.teeth or (), strict=mesh.teeth is not None):
            if count:
                yield teeth_of(mesh, link).value(count)
        if mesh.module is not None:
            yield _module(index_of(mesh)).value(mesh.module)


@tabulated
def values(found: Structure) -> Iterator[Value]:
    yield MOVING.value(found.moving_links)
    yield LOWER.value(found.lower_pairs)
    yield HIGHER.value(found.higher_pairs)
    yield FREEDOM.value(found.mobility)
    yield MECHANISM_CLASS.value(found.mechanism_class)
    if found.cams:
        yield REPLACED_MOVING.value(found.moving_links + found.higher_pairs)
        yield REPLACED_LOWER.value(found.lower_pairs + 2 * found.higher_pairs)
        yield REPLACED_FREEDOM.value(found.mobility)
    yield from _of_meshes(found)


@tabulated
def tables(found: Structure) -> Iterator[Table]:
    yield Table("pairs", PAIRS, _pairs(found.pairs))
    yield Table("groups", GROUPS, _groups(found, detached(found)))
    if found.alternatives:
        yield Table("drivers", DRIVERS, _drivers(found))


def detached(found: Structure) -> list[Group]:
    """The groups in the order in which they are detached."""
    return list(reversed(found.groups))


def _pairs(pairs: Sequence[Pair]) -> tuple[Column, ...]:
    freedoms = [2 if pair.kind == "H" else 1 for pair in pairs]
    return (
        NUMBER.column(list(range(1, len(pairs) + 1))),
        text_column("links", Message(N_("its links")), ["–".join(pair.links) for pair in pairs]),
        text_column("name", Message(N_("point or guide")), [pair.name for pair in pairs]),
        text_column(
            "kind", Message(N_("R: revolute, P: prismatic, H: higher")), [pair.kind for pair in pairs]
        ),
        MOBILITY.column(freedoms),
    )


def _groups(found: Structure, groups: Sequence[Group]) -> tuple[Column, ...]:
    return (
        text_column("group", Message(N_("group")), [group.label for group in groups]),
        text_column("links", Message(N_("its links")), [", ".join(group.links) for group in groups]),
        CLASS.column([group.group_class for group in groups]),
        ORDER.column([group.order for group in groups]),
        *_determinacy([found.counted(group) for group in groups]),
    )


def _determinacy(counts: Sequence[tuple[int, int, int]]) -> tuple[Column, ...]:
    """A group is statically determinate: as many equations of equilibrium as unknowns, 3n = 2p5 + p4."""
    return (
        OWN_LINKS.column([n for n, _, _ in counts]),
        OWN_LOWER.column([p5 for _, p5, _ in counts]),
        OWN_HIGHER.column([p4 for _, _, p4 in counts]),
        EQUATIONS.column([3 * n for n, _, _ in counts]),
        UNKNOWNS.column([2 * p5 + p4 for _, p5, p4 in counts]),
    )


def _drivers(found: Structure) -> tuple[Column, ...]:
    others = found.alternatives
    classes = [0 if o.structure is None else o.structure.mechanism_class for o in others]
    formulas = ["" if o.structure is None else o.structure.formula for o in others]
    return (
        text_column("link", Message(N_("driving link")), [other.link for other in others]),
        text_column("formula", Message(N_("structural formula; empty: it cannot drive")), formulas),
        CLASS.column(classes),
    )
