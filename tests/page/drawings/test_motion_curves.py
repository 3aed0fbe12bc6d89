"""Diagrams of the machine in motion against results.json, read by the figures beside their axes."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from curves import Curve
from notes import NAMES
from pages import table_of
from reading import CHOSEN, html, results, wrong
from test_curves import graphs

CLOSE = 4e-4  # of the height of a panel
MOVING = [name for name in ("piston_pump", "hoist_start", "tram_start") if name in CHOSEN and name in NAMES]
FIGURES = {  # the end of the caption -> table, what lies along, columns of the curves from the top panel down
    "angular velocity of the main shaft": ("characteristics", "omega", ("M_dr", "M_res")),
    "main shaft in steady motion": ("cycle_diagram", "phi", ("M_dr", "M_res", "domega", "epsilon")),
    "moments in the start-up": ("start_diagram", "t", ("omega", "M_dr", "M_res")),
    "moments in the run-down": ("coast_diagram", "t", ("omega", "M_dr", "M_res")),
    "steady motion, IV — run-down": ("joined", "t", ("omega",)),
}


def wrong_figure(name: str, caption: str, drawn: list[Curve]) -> Iterator[str]:
    end = next((end for end in FIGURES if caption.endswith(end)), None)
    if end is None:
        return
    table, along, keys = FIGURES[end]
    of = table_of(results(name, "en"), f"dynamics_{table}")
    x = np.degrees(of[along]) if along == "phi" and table == "cycle_diagram" else of[along]
    if len(drawn) != len(keys):
        yield f"{caption}: {len(drawn)} curves, not {len(keys)}"
    for key, curve in zip(keys, drawn, strict=False):
        order = np.argsort(curve.turned, kind="stable")
        read = np.interp(x, curve.turned[order], curve.values[order])
        off = np.abs(read - of[key]).max()
        height = max(np.abs(one.values).max() for one in drawn if one.axis == curve.axis)  # of the panel
        if off > CLOSE * height:
            yield f"{caption}: {key} is drawn {off:.3g} off"


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", MOVING)
def test_diagrams_of_the_machine_in_motion(name):
    found = [(caption, drawn) for caption, drawn in graphs(html(name, "en"))]
    wrong([line for caption, drawn in found for line in wrong_figure(name, caption, drawn)])
    ends = [end for end in FIGURES if any(caption.endswith(end) for caption, _ in found)]
    tables = results(name, "en")["tables"]
    assert len(ends) == sum(f"dynamics_{FIGURES[end][0]}" in tables for end in FIGURES)


# ---------------------------------------------------------------- a main link that slides

SLIDING = [name for name in ("steam_hammer", "boom_by_cylinder") if name in CHOSEN]
OVER_PLACE = (("v", "v"), ("F", "F_dr"), ("F", "F_red"), ("F", "F_res"), ("mred", "m_red"))
OVER_TIME = (("s", "s"), ("v", "v"), ("a", "a"))


def wrong_sliding(name: str, caption: str, drawn: list[Curve]) -> Iterator[str]:
    """Curves over the place and over the time, each on the axis of its letter."""
    of = table_of(results(name, "en"), "travel_motion_diagram")
    along, shown = ("t", OVER_TIME) if caption.endswith("against time") else ("s", OVER_PLACE)
    wanted = [(letter, key) for letter, key in shown if key in of]
    if [curve.axis.letter for curve in drawn] != [letter for letter, _ in wanted]:
        yield f"{caption}: the axes are {[curve.axis.letter for curve in drawn]}"
    for (_, key), curve in zip(wanted, drawn, strict=False):
        order = np.argsort(curve.turned, kind="stable")
        places = np.argsort(of[along], kind="stable")
        read = np.interp(of[along][places], curve.turned[order], curve.values[order])
        height = max(np.abs(one.values).max() for one in drawn if one.axis == curve.axis)
        off = np.abs(read - of[key][places])[1:-1].max()
        if off > 5e-3 * height:
            yield f"{caption}: {key} is drawn {off:.3g} off"


@pytest.mark.parametrize("name", SLIDING)
def test_diagrams_of_a_main_link_that_slides(name):
    found = [(caption, drawn) for caption, drawn in graphs(html(name, "en")) if "main link" in caption]
    assert len(found) == 2
    wrong([line for caption, drawn in found for line in wrong_sliding(name, caption, drawn)])
