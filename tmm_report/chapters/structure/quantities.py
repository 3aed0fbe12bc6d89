"""The numbers of structure: links, pairs, mobility, groups, class; what another driving link would make of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmm_report.chapters.structure.solve import Structure
from tmm_report.mechanics.structure import Group, Pair
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol

PAIRS = Message(N_("kinematic pairs"))
GROUPS = Message(N_("Assur groups, in the order in which they are detached"))
DRIVERS = Message(N_("what the mechanism would be if another link drove"))

NUMBER = Quantity("number", None, "", Message(N_("its number")))
MOBILITY = Quantity("mobility", None, "", Message(N_("mobility of the pair")))
CLASS = Quantity("class", None, "", Message(N_("class")))
ORDER = Quantity("order", None, "", Message(N_("order")))

MOVING = Quantity("n", Symbol("n"), "", Message(N_("number of moving links")))
LOWER = Quantity("p5", Symbol("p", "5"), "", Message(N_("number of lower pairs")))
HIGHER = Quantity("p4", Symbol("p", "4"), "", Message(N_("number of higher pairs")))
FREEDOM = Quantity("W", Symbol("W"), "", Message(N_("mobility")))
MECHANISM_CLASS = Quantity("class", None, "", Message(N_("class of the mechanism")))


def values(found: Structure) -> Iterator[Value]:
    yield MOVING.value(found.moving_links)
    yield LOWER.value(found.lower_pairs)
    yield HIGHER.value(found.higher_pairs)
    yield FREEDOM.value(found.mobility)
    yield MECHANISM_CLASS.value(found.mechanism_class)


def tables(found: Structure) -> Iterator[Table]:
    yield Table("pairs", PAIRS, _pairs(found.pairs))
    yield Table("groups", GROUPS, _groups(detached(found)))
    if found.alternatives:
        yield Table("drivers", DRIVERS, _drivers(found))


def detached(found: Structure) -> list[Group]:
    """The groups in the order in which they are detached."""
    return list(reversed(found.groups))


def _pairs(pairs: Sequence[Pair]) -> tuple[Column, ...]:
    ones = [1] * len(pairs)
    return (
        NUMBER.column(list(range(1, len(pairs) + 1))),
        text_column("links", Message(N_("its links")), ["–".join(pair.links) for pair in pairs]),
        text_column("name", Message(N_("point or guide")), [pair.name for pair in pairs]),
        text_column("kind", Message(N_("R: revolute, P: prismatic")), [pair.kind for pair in pairs]),
        MOBILITY.column(ones),
    )


def _groups(groups: Sequence[Group]) -> tuple[Column, ...]:
    return (
        text_column("group", Message(N_("group")), [group.label for group in groups]),
        text_column("links", Message(N_("its links")), [", ".join(group.links) for group in groups]),
        CLASS.column([group.group_class for group in groups]),
        ORDER.column([group.order for group in groups]),
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
