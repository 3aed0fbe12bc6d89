"""Every number of a compound gear train with its symbol, unit and meaning."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.gears.train.solve.train import Found
from tmm_report.chapters.gears.train.steps import Numbers, whole
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.sheet import Row, columns
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("train_u", "train_delta_u", "train_eta")  # what is looked for first

ROWS = Message(N_("rows of the kinematic formula of the train"))
RATIOS = Message(N_("ratios of the speeds of the members of the train"))
SPEEDS = Message(N_("speeds of the members of the train"))
LOADS = Message(N_("external torques and powers of the train"))
MESHES = Message(N_("flow of the power through the meshes of the train"))
FLOW = Message(N_("torques and powers that the meshes give to each member of the train"))
BRANCHES = Message(N_("shares of the power through the branches of the train"))
DISTANCES = Message(N_("coaxiality of the meshes of the train"))
ASSEMBLY = Message(N_("condition of assembly of the train"))
NEIGHBOURS = Message(N_("condition of neighbourhood of the planet gears of the train"))
CASES = Message(N_("speeds of the members of the train in other motions"))
REJECTED = Message(N_("sets of teeth of the train by the first condition that fails"))
SOLUTIONS = Message(N_("sets of teeth of the train that meet every condition, best first"))
MEMBER, MESH = Message(N_("member")), Message(N_("wheels in mesh"))


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield from whole(found).s.values()


@tabulated
def tables(found: Found) -> Iterator[Table]:
    of = whole(found)
    yield Table("train_rows", ROWS, tuple(_rows(of)))
    if of.ratios:
        yield Table("train_ratios", RATIOS, tuple(_named("member", list(of.ratios), [*of.ratios.values()])))
    alike = text_column(
        "with", Message(N_("members that turn as one with it")), [*map(of.joined, of.members)]
    )
    speeds = _named("member", list(of.members), [*of.members.values()])
    yield Table("train_speeds", SPEEDS, (*speeds, alike))
    yield Table("train_loads", LOADS, tuple(_named("member", list(of.loads), [*of.loads.values()])))
    yield Table("train_meshes", MESHES, tuple(_meshes(of)))
    yield Table("train_flow", FLOW, tuple(_named("member", list(of.flows), [*of.flows.values()])))
    if of.branches:
        names = list(of.branches)
        shafts = [found.built.body(name) for name in names]
        shaft = text_column("shaft", Message(N_("shaft at which the branches meet")), shafts)
        yield Table("train_branches", BRANCHES, (shaft, *_named("member", names, [*of.branches.values()])))
    yield from _conditions(found, of)
    if of.cases:
        yield Table("train_cases", CASES, tuple(_cases(of)))
    if found.sought:
        yield Table("train_rejected", REJECTED, tuple(_rejected(found)))
        yield Table("train_solutions", SOLUTIONS, tuple(_solutions(found)))


def _named(key: str, names: Sequence[str], rows: Sequence[Row]) -> Iterator[Column]:
    yield text_column(key, MEMBER, list(names))
    yield from columns(rows)


def _rows(of: Numbers) -> Iterator[Column]:
    ends = ["-".join(of.ends_of(row)) for row in of.turned]
    yield text_column("row", Message(N_("central members of the row")), ends)
    yield text_column(
        "carrier", Message(N_("carrier of the axes")), [of.carrier_of(row) for row in of.turned]
    )
    yield from columns([*of.rows.values()])


def _meshes(of: Numbers) -> Iterator[Column]:
    meshes, way = of.train.meshes, of.found.flow.way
    driving = [mesh.i if x > 0 else mesh.j if x < 0 else "" for mesh, x in zip(meshes, way, strict=True)]
    yield text_column("mesh", MESH, [f"{mesh.i}-{mesh.j}" for mesh in meshes])
    yield text_column("carrier", Message(N_("carrier of the axes")), [mesh.carrier for mesh in meshes])
    yield text_column("driving", Message(N_("driving wheel")), driving)
    yield from columns(of.meshes)


def _conditions(found: Found, of: Numbers) -> Iterator[Table]:
    meshes = found.train.meshes
    if of.distances:
        pairs = [(meshes[one.pair.first], meshes[one.pair.other]) for one in found.conditions.coaxial]
        first, other = ([f"{pair[k].i}-{pair[k].j}" for pair in pairs] for k in (0, 1))
        names = (text_column("mesh", MESH, first), text_column("other", MESH, other))
        yield Table("train_distances", DISTANCES, (*names, *columns(of.distances)))
    if of.assembly:
        ends = ["-".join(of.ends_of(one.row)) for one in found.conditions.assembly]
        row = text_column("row", Message(N_("central members of the row")), ends)
        yield Table("train_assembly", ASSEMBLY, (row, *columns(of.assembly)))
    if of.neighbours:
        crowns = [", ".join(one.crowd.crowns) for one in found.conditions.neighbours]
        name = text_column("satellite", Message(N_("planet gears")), crowns)
        yield Table("train_neighbours", NEIGHBOURS, (name, *columns(of.neighbours)))


def _cases(of: Numbers) -> Iterator[Column]:
    yield Quantity("case", None, "", Message(N_("number of the motion"))).column([k for k, _, _ in of.cases])
    yield text_column("member", MEMBER, [name for _, name, _ in of.cases])
    yield from columns([row for _, _, row in of.cases])


# --- the search


def _rejected(found: Found) -> Iterator[Column]:
    assert found.sought is not None
    counts = found.sought.candidates.counts
    yield text_column(
        "reason", Message(N_("condition that fails first")), [one.name.lower() for one in counts]
    )
    yield Quantity("count", None, "", Message(N_("number of sets of teeth"))).column(list(counts.values()))


def _solutions(found: Found) -> Iterator[Column]:
    assert found.sought is not None
    of, task = found.sought.candidates, found.sought.task
    yield Quantity("place", None, "", Message(N_("rank of the solution"))).column(
        list(range(1, len(of.ratio) + 1))
    )
    for name, teeth in zip(of.wheels, of.teeth, strict=True):
        yield Quantity(f"z_{name}", Symbol("z", name), "", Message(N_("number of teeth"))).column(teeth)
    if task.satellites:
        yield Quantity("k", Symbol("k"), "", Message(N_("number of planet gears"))).column(of.satellites)
    yield Quantity("u", Symbol("u"), "", Message(N_("ratio of the angular velocities"))).column(of.ratio)
    miss = 100 * (np.asarray(of.ratio) / task.ratio - 1)
    yield Quantity("delta_u", Symbol("Delta", "u"), "%", Message(N_("deviation of the ratio"))).column(miss)
    if found.sought.efficiency:
        eta = Message(N_("efficiency of the train with this set; 0: it locks itself"))
        yield Quantity("eta", Symbol("eta"), "", eta).column(list(found.sought.efficiency))
    size = Message(N_("diameter that the train fills, in modules of the first wheel"))
    yield Quantity("D", Symbol("D"), "", size).column(of.size)
