"""Quantities of the schemes that were judged side by side."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.gears.planetary.solve.schemes import Choice, Judged
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol


def schemes_table(choice: Choice, prefix: str, name: str) -> Table:
    meaning = Message(N_("schemes judged for stage %(name)s"), {"name": name})
    return Table(f"{prefix}_schemes", meaning, tuple(_columns(choice)))


def _columns(choice: Choice) -> Iterator[Column]:
    rows = choice.judged
    yield text_column("scheme", Message(N_("scheme of the stage")), [one.scheme.name for one in rows])
    count = Message(N_("number of solutions"))
    yield Quantity("solutions", None, "", count).column([one.solutions for one in rows])
    yield text_column("teeth", Message(N_("best teeth")), [_teeth(one) for one in rows])
    satellites = Message(N_("number of planet gears"))
    yield Quantity("k", Symbol("k"), "", satellites).column([one.satellites or math.nan for one in rows])
    ratio = Message(N_("ratio of the stage"))
    yield Quantity("u", Symbol("u"), "", ratio).column([one.ratio for one in rows])
    size = Message(N_("diameter that the stage fills"))
    yield Quantity("D", Symbol("D"), "m", size).column([one.overall for one in rows])
    eta = Message(N_("efficiency; not positive: locks"))
    yield Quantity("eta", Symbol("eta"), "", eta).column([one.efficiency for one in rows])
    taken = Message(N_("1 where the scheme is taken"))
    yield Quantity("taken", None, "", taken).column([int(k == choice.chosen) for k in range(len(rows))])


def _teeth(one: Judged) -> str:
    if one.teeth is None:
        return ""
    z1, z2, z2_, z3 = one.teeth
    return ", ".join(map(str, (z1, z2, z3) if one.scheme.single else (z1, z2, z2_, z3)))
