"""The axes of the diagrams of harmonics, balancing and engines: letter and unit of what the curves beside them are."""

import numpy as np
import pytest
from conftest import solved

from tmm_report.chapters.machine.balancing.view.slider_crank import SliderView
from tmm_report.chapters.machine.balancing.view.whole import BalancingView
from tmm_report.chapters.machine.engine.view import EngineView
from tmm_report.chapters.machine.harmonics.view import HarmonicsView
from tmm_report.figures.drawing import Text
from tmm_report.i18n import Translator
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page


@pytest.fixture
def page():
    return Page(Html(), Translator("en"), Numbering())


def said(parts) -> str:
    """Letters and indices of a label, as text."""
    return "".join(
        part if isinstance(part, str) else "^".join(filter(None, (part.base + part.sub, part.sup)))
        for part in parts
    )


def panels(graph) -> list[tuple[str, list[np.ndarray]]]:
    """The label of each panel and its curves."""
    return [
        (said(label), [curve.values for curve in graph.curves if curve.panel == k])
        for k, label in enumerate(graph.ylabels)
    ]


def agree(drawn, numbers) -> bool:
    """Whether curves are these numbers but for rounding."""
    size = max(np.abs(one).max() for one in numbers)
    pairs = zip(drawn, numbers, strict=True)
    return all(np.allclose(one, other, rtol=0, atol=1e-9 * size) for one, other in pairs)


def test_harmonics(page):
    found = solved("slider_crank_offset").harmonics
    view, wave = HarmonicsView(found, page), found.waves[0]
    graph = view.amplitudes(wave)
    (x, along), (y, across) = panels(graph)
    assert (said(graph.xlabel), x, y) == ("ξ", "Ax, mm", "Ay, mm")
    assert agree(along, 1e3 * wave.x.amplitude[:, 1:].T) and agree(across, 1e3 * wave.y.amplitude[:, 1:].T)
    ((of, curves),) = panels(view.sums(view.drawn))
    assert of == f"a{view.drawn.name}, m/s²" and agree(
        curves[:1], [[*view.drawn.samples, view.drawn.samples[0]]]
    )


def test_balancing(page):
    found = solved("slider_crank_offset").balancing
    view = BalancingView(found, page)
    (force, sizes), (moment, turns) = panels(view.diagram)
    assert (force, moment) == ("F, N", "M, N·m")
    assert agree(sizes[:1], [np.abs(found.original.diagram.force)])
    assert agree(turns[:1], [found.original.diagram.moment])
    ((slider, curves),) = panels(SliderView(found, 0, page).diagram)
    remains = found.cycle_remains[0]
    own = (remains.exact, remains.first, remains.second)
    assert slider == "F, N" and agree([curve[:-1] for curve in curves], own)


@pytest.mark.parametrize(
    ("drawn", "x", "y"), [("hodographs", "F^x, N", "F^y, N"), ("seen", "U^x, kg·m", "U^y, kg·m")]
)
def test_hodographs_of_the_balancing(page, drawn, x, y):
    view = BalancingView(solved("slider_crank_offset").balancing, page)
    assert labels(getattr(view, drawn)) == [y, x]


def labels(drawing) -> list[str]:
    """Those of both axes, from the left: that of y stands over its axis, that of x at the end of its own."""
    found = [(item.at.real, said(item.parts)) for item in drawing.items if isinstance(item, Text)]
    return [text for _, text in sorted(found) if ", " in text]


def test_engine(page):
    found = solved("engine_balance").engine
    view = EngineView(found, page)
    for of, graph in view.diagrams:
        unit = "N" if of == "force" else "N·m"
        letter = "F" if of == "force" else "M"
        exact = getattr(found.diagram["after"], of)
        for label, curves in panels(graph):
            axis = label[1]
            assert label == f"{letter}{axis}, {unit}"
            assert agree(curves[:1], [exact.real if axis == "x" else exact.imag])
    for of, drawing in view.hodographs:
        letter, unit = ("F", "N") if of == "force" else ("M", "N·m")
        assert labels(drawing) == [f"{letter}y, {unit}", f"{letter}x, {unit}"]
