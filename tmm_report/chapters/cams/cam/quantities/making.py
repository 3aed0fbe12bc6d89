"""The numbers of the finished cam: its walls, the path of the cutter, the outline, the proof by reversed motion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.cams.cam.quantities.names import letter, named, of, unit
from tmm_report.chapters.cams.cam.quantities.tables import PITCH, TURNED, where
from tmm_report.chapters.cams.cam.solve.making import Making
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

Array = Any
WALLS = Message(N_("walls of the groove and path of the cutter's centre in the cam's axes"))
OUTLINE = Message(N_("outline of the cam degree by degree, in its axes"))
OUTER, CUT, CUT_OUTER = NP_("index", "out"), NP_("index", "cut"), NP_("index", "cut,out")
CURVES = {
    "profile": ("", "", N_("the profile")),
    "pitch": ("_pitch", PITCH, N_("the pitch curve")),
    "outer": ("_outer", OUTER, N_("the outer wall of the groove")),
    "cut": ("_cut", CUT, N_("the path of the cutter's centre")),
    "cut_outer": ("_cut_outer", CUT_OUTER, N_("the path of the cutter's centre along the outer wall")),
}
MADE = ("outer", "cut", "cut_outer")


def tables(made: Making) -> Iterator[Table]:
    found = made.found
    if made.asked:
        columns = [column for name in MADE for column in _polar(made, name)]
        columns += [column for name in MADE for column in _xy(made, name, made.table)]
        yield Table(named(found, "cam_walls"), WALLS, (*where(found, found.table), *columns))
    turned = TURNED.column(np.degrees(made.outline.turned))
    every = [column for name in CURVES for column in _xy(made, name, made.outline)]
    yield Table(named(found, "cam_outline"), OUTLINE, (turned, *every))


def _polar(made: Making, name: str) -> Iterator[Column]:
    if (points := getattr(made.table, name)) is not None:
        key, index, text = CURVES[name]
        meaning = Message(N_("polar radius of %(curve)s"), {"curve": Message(text)})
        own = of(made.found, f"cam_R{key}", Symbol("R", index), "m", "")
        yield Quantity(own.key, own.symbol, "m", meaning).column(np.abs(points))


def _xy(made: Making, name: str, curves: Any) -> Iterator[Column]:
    points = getattr(curves, name)
    if points is None:
        return
    key, index, text = CURVES[name]
    for axis, part, words in (
        ("x", np.real, N_("abscissa of %(curve)s")),
        ("y", np.imag, N_("ordinate of %(curve)s")),
    ):
        own = of(made.found, f"cam_{axis}{key}", Symbol(axis, index), "m", "")
        yield Quantity(own.key, own.symbol, "m", Message(words, {"curve": Message(text)})).column(
            part(points)
        )


def values(made: Making) -> Iterator[Value]:
    found = made.found
    if made.cutter is not None:
        text = N_("radius of the cutter")
        yield of(found, "cam_cutter", Symbol("r", CUT), "m", text, "mm").value(made.cutter)
    shown = "mm" if found.slides else ""
    for key, symbol, text, end in (
        ("cam_recovered", Symbol(f"Delta{letter(found)}"),
         N_("greatest difference of the displacement found back from the profile by kinematic inversion"), made.proof),
        ("cam_recovered_rounded", Symbol(f"Delta{letter(found)}", "r"),
         N_("the same from the coordinates as they are printed"), made.proof_as_printed),
    ):  # fmt: skip
        yield of(found, key, symbol, unit(found), text, shown).value(end.value, end.turned)
