"""The numbers of an ordinary stage that anyone can read."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.chapters.gears.ordinary.values import Train
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Table, Value, text_column
from tmm_report.quantity.sheet import columns
from tmm_report.quantity.tabulated import tabulated

TRAIN = N_("wheels of a train and their forces on the next ones")
TITLES = {
    "belt open": N_("belt drive, open"),
    "belt crossed": N_("belt drive, crossed"),
    "belt V": N_("V-belt drive"),
    "chain": N_("chain drive"),
    "friction external": N_("friction wheels, outer contact"),
    "friction internal": N_("friction wheels, inner contact"),
    "pair external": N_("pair of wheels, outer mesh"),
    "pair internal": N_("pair of wheels, inner mesh"),
    "friction bevel": N_("friction wheels, cones"),
    "bevel": N_("bevel gear pair"),
    "worm": N_("worm gear pair"),
    "train external": N_("train with idlers"),
    "train internal": N_("train with idlers and a ring"),
}


@tabulated
def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers, whose names begin with the label of the stage, which is `prefix`."""
    return found.s.values()


@tabulated
def tables(found: Found, prefix: str) -> Iterator[Table]:
    if isinstance(found.s, Train):
        wheels = text_column("wheel", Message(N_("number of the wheel")), [*found.given.wheels])
        yield Table(f"{prefix}_train", Message(TRAIN), (wheels, *columns(found.s.rows)))
