"""Reactions as figures: each curve by its name, hodographs at the scales that are printed, sheets that fit a page."""

from itertools import pairwise

import numpy as np
import pytest
from conftest import read, solved

from tmm_report.chapters.lever.kinetostatics.quantities.cycle import at
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import sampled
from tmm_report.chapters.lever.kinetostatics.view.diagrams import (
    graphs_of,
    load_diagrams,
    reaction,
    reaction_diagrams,
)
from tmm_report.chapters.lever.kinetostatics.view.hodographs import SHEET, hodographs, indicated, sheets
from tmm_report.figures.drawing import Path
from tmm_report.i18n import Translator
from tmm_report.report.paper.sheets import USUAL

TALL = USUAL.page[1]
NAMES = ("compressor", "press", "shaper", "engine_four_stroke")


@pytest.fixture(params=NAMES)
def drawn(request):
    found = solved(request.param).lever.kinetostatics
    own = sampled(found)
    return found, own, graphs_of(found, own, Translator("en"))


def test_every_pair_has_a_panel_with_its_curves_by_name(drawn):
    found, own, graphs = drawn
    panels = [
        (graph, number)
        for graph in reaction_diagrams(found, own, graphs, TALL)
        for number in range(len(graph.panels))
    ]
    assert len(panels) == len(found.table.statics.reactions)
    for (graph, number), key in zip(panels, found.table.statics.reactions, strict=True):
        force = reaction(found, own, key)
        parts = {"": np.abs(force), "x": force.real, "y": force.imag}
        of = "".join(key.split("-"))
        for curve, _ in graph.of(number):
            assert curve.name[0].base == "R" and curve.name[0].sub == of
            np.testing.assert_allclose(
                curve.values, parts.pop(curve.name[0].sup), atol=1e-9 * np.abs(force).max()
            )
        assert all(np.abs(rest).max() < 1e-6 * np.abs(force).max() + 1e-6 for rest in parts.values())


def test_a_page_takes_as_many_panels_as_it_holds(drawn):
    whole = [*reaction_diagrams(*drawn, TALL)]
    assert all(graph.size[1] <= TALL for graph in whole)
    for graph, behind in pairwise(whole):
        assert graph.size[1] + behind.size[1] / len(behind.panels) > TALL - 15
    low = [*reaction_diagrams(*drawn, 90.0)]
    assert len(low) > len(whole) and sum(len(graph.panels) for graph in low) == sum(
        len(g.panels) for g in whole
    )


def test_a_load_that_changes_has_a_curve_and_a_constant_has_none(drawn):
    found, own, graphs = drawn
    count = sum(len(graph.panels) for graph in load_diagrams(found, own, graphs, TALL))
    assert count == len(found.followed)
    laws = [type(load.law).__name__ for load in (*found.given.forces, *found.given.moments)]
    assert count == sum(law != "Constant" for law in laws)


def test_a_hodograph_is_drawn_at_its_scale(drawn):
    """The longest line of its drawing spans the reaction's extent, in millimetres, not turned nor mirrored."""
    found, own, graphs = drawn
    pivots = [key for key, one in found.table.statics.reactions.items() if one.pair.kind == "R"]
    for one, key in zip(hodographs(found, own, graphs, str), pivots, strict=True):
        force = reaction(found, own, key) / one.scale
        lines = [stroke for item in one.drawing.items if isinstance(item, Path) for stroke in item.outline()]
        curve = np.array(max(lines, key=len))
        assert len(curve) == len(force)
        np.testing.assert_allclose(curve - curve[0], force - force[0], atol=1e-6)
        lead = float(f"{one.scale:e}".split("e")[0])
        assert min(abs(lead - good) for good in (1, 2, 2.5, 4, 5)) < 1e-9


def test_sheets_of_hodographs_fit_a_page_and_leave_none_out(drawn):
    found, own, graphs = drawn
    every = hodographs(found, own, graphs, str)
    pages = [page for page, _ in sheets(every)]
    assert sum(len(page.items) for page in pages) == sum(len(one.drawing.items) for one in every)
    for page in pages:
        assert page.size[0] <= SHEET[0] + 5 and page.size[1] <= SHEET[1] + 5


def test_indicator_diagrams_are_those_stated():
    found = solved("engine_four_stroke").lever.kinetostatics
    graphs = graphs_of(found, sampled(found), Translator("en"))
    told = list(indicated(found, graphs, str, str))
    assert [one.of.key for one in told] == ["P_B", "P_D"]
    law = read("engine_four_stroke").lever.loads.forces[0].law
    for curve in law.curves:
        expected = np.array([complex(x / 0.01, y / told[0].scale) for x, y in curve])
        lines = [np.array(s) for i in told[0].drawing.items if isinstance(i, Path) for s in i.outline()]
        alike = [line for line in lines if len(line) == len(expected)]
        spans = [line - line[0] for line in alike]
        assert any(np.allclose(span.imag, (expected - expected[0]).imag, atol=1e-6) for span in spans)


def test_positions_at_which_a_load_drives_are_those_of_its_acute_angle():
    """The angle of the force with the velocity of its point, position by position."""
    for name in ("compressor", "crank_rocker", "shaper"):
        found = solved(name).lever.kinetostatics
        for force, vector, work in zip(
            found.given.forces, found.table.loading.forces, found.works.stated, strict=False
        ):
            power = np.real(np.conj(found.table.motion.velocity(force.at)) * vector)[:-1]
            told = {sign: _numbers(at(work, sign)) for sign in (1, -1)}
            clear = np.abs(power) > 1e-6 * np.abs(power).max()
            for sign in (1, -1):
                assert set(np.flatnonzero(clear & (power * sign > 0))) <= told[sign]
            assert not told[1] & told[-1]


def _numbers(text):
    runs = [part.split("–") for part in text.split(", ") if part]
    return {k for run in runs for k in range(int(run[0]), int(run[-1]) + 1)}
