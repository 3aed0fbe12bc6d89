"""Every number of a planetary stage with its symbol, unit and meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import islice

from tmm_report.chapters.gears.planetary.quantities import search as listing
from tmm_report.chapters.gears.planetary.quantities.conditions import condition_columns
from tmm_report.chapters.gears.planetary.quantities.schemes import schemes_table
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.chapters.gears.planetary.steps import stage
from tmm_report.chapters.gears.planetary.values import ratio_symbol
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.sheet import Row, columns
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

WHEELS = N_("dimensions of the wheels of stage %(name)s")
MESHES = N_("meshes of stage %(name)s")
CONDITIONS = N_("conditions of stage %(name)s")
MOTIONS = N_("motions of stage %(name)s with each member held")


def book(found: Found, prefix: str) -> Book:
    """All that is said in numbers of the stage."""
    return Book.of(tables(found, prefix), values(found, prefix))


@tabulated
def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers of the stage."""
    yield from stage(found, prefix).s.values()


@tabulated
def tables(found: Found, prefix: str) -> Iterator[Table]:
    """Sizes, motions with each member held, the solutions; meshes, conditions, combinations that fail."""
    name, made = {"name": found.name}, stage(found, prefix)
    yield Table(f"{prefix}_wheels", Message(WHEELS, name), tuple(_wheels(found, made.rows)))
    yield Table(f"{prefix}_motions", Message(MOTIONS, name), tuple(_motions(found)))
    yield from listing.tables(found, prefix)
    yield Table(f"{prefix}_rows", Message(MESHES, name), tuple(_meshes(found, made.meshes)))
    yield Table(f"{prefix}_conditions", Message(CONDITIONS, name), tuple(condition_columns(found)))
    if found.choice is not None:
        yield schemes_table(found.choice, prefix, found.name)


def judged(found: Found, say: Callable[[str], str]) -> list[str]:
    """Every combination of teeth that was examined, a line each, with what became of it in words that `say` gives; many
    lines are joined in one text, for there may be half a million."""
    lines = listing.listing(listing.candidates(found), say)
    return ["\n".join(some) for some in iter(lambda: list(islice(lines, listing.AT_ONCE)), [])]


def _wheels(found: Found, rows: Sequence[Row]) -> Iterator[Column]:
    names = found.given.wheels
    yield text_column("wheel", Message(N_("number of the wheel")), [names[i] for i in found.scheme.wheels])
    yield from columns(rows)


def _meshes(found: Found, rows: Sequence[Row]) -> Iterator[Column]:
    names = found.given.wheels
    pairs = [f"{names[0]}-{names[1]}", f"{names[2]}-{names[3]}"]
    yield text_column("mesh", Message(N_("wheels in mesh")), pairs)
    yield from columns(rows)


# --- motions


def _motions(found: Found) -> Iterator[Column]:
    motions, member = found.motions, found.given.member
    for key, text, pick in (
        ("held", N_("member that is held"), lambda m: m.held),
        ("input", N_("input member"), lambda m: m.input),
        ("output", N_("output member"), lambda m: m.output),
    ):
        yield text_column(key, Message(text), [member(pick(motion)) for motion in motions])
    for one in p.MEMBERS:
        about = Message(N_("speed of member %(name)s to that of the input"), {"name": member(one)})
        speed = Quantity(f"omega_{member(one)}", Symbol("omega", member(one)), "", about)
        yield speed.column([motion.speed[one] for motion in motions])
    satellite = Symbol("omega", found.given.crowns[0])
    about = Message(N_("speed of the planet gears to that of the input"))
    yield Quantity("omega_satellite", satellite, "", about).column([motion.satellite for motion in motions])
    yield listing.RATIO.column([motion.ratio for motion in motions])
    about = Message(N_("efficiency; not positive: locks"))
    eta = Quantity("eta", Symbol("eta"), "", about)
    symbols = [replace(ratio_symbol(found.given, of.input, of.output), base="eta") for of in motions]
    yield Column(eta, [motion.efficiency for motion in motions], symbols)
    way = Message(N_("flow of the power, carrier stopped: 1 from wheel 1 to wheel 3, −1 back"))
    yield Quantity("power", None, "", way).column([motion.exponent for motion in motions])
