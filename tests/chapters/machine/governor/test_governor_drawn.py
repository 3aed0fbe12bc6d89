"""What is drawn of the governor against the numbers of the results; governors that no ready variant has."""

from __future__ import annotations

import json
import re
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from conftest import solved
from notes import note, render

from tmm_report import course, loading
from tmm_report.chapters.machine.governor.draw import scheme
from tmm_report.chapters.machine.governor.view import whole as views
from tmm_report.chapters.machine.governor.view.brake import BrakeView
from tmm_report.chapters.machine.governor.view.in_loop import LoopView
from tmm_report.figures.drawing import Circle
from tmm_report.i18n import Translator
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

NAMES = ("governor_porter", "governor_servo")


@cache
def document(name: str) -> dict:
    return json.loads(note(name, "json")["results.json"])


def values(name: str) -> dict[str, float]:
    return {one["key"].removeprefix("governor_"): one["value"] for one in document(name)["values"]}


def table(name: str, key: str) -> dict[str, np.ndarray]:
    columns = document(name)["tables"][f"governor_{key}"]["columns"]
    return {column["key"]: np.array(column["values"]) for column in columns}


def page() -> Page:
    return Page(Html(), Translator("en"), Numbering())


@pytest.mark.parametrize("name", NAMES)
def test_the_curves_of_the_response_are_those_of_the_table(name):
    found, at = solved(name).governor, table(name, "response")
    graph = LoopView(found.loop, page()).response
    wanted = (at["deviation"], at["deviation_linear"], 1e3 * at["z"], at["s"])
    assert graph.x == pytest.approx(at["t"])
    for curve, of in zip(graph.curves, wanted, strict=True):
        assert curve.values == pytest.approx(of, abs=1e-7)
    (time, peak), v = graph.curves[0].extremes[0], values(name)
    assert (time, peak / found.loop.before.omega) == pytest.approx((v["peak_time"], v["peak"]))


def test_the_curves_of_the_brake_are_those_of_the_table():
    found, at = solved("governor_porter").governor, table("governor_porter", "brake")
    view = BrakeView(found.brake, page())
    braking, driving = view.graph.curves
    assert np.interp(at["omega"], view.graph.x, braking.values) == pytest.approx(at["M_b"], abs=0.2)
    assert (driving.values == values("governor_porter")["brake_M"]).all()
    assert view.start.curves[0].values == pytest.approx(table("governor_porter", "brake_start")["omega"])


def reds(drawing) -> list[complex]:
    return [item.centre for item in drawing.items if isinstance(item, Circle) and item.fill == "red"]


def test_the_point_of_the_machine_stands_at_its_parameters():
    """The field of Vyshnegradsky's diagram is at most 95 mm for its larger side, that of the isodrome 2.5 times what is
    stated; both at the smallest round scales."""
    v = values("governor_porter")
    found = solved("governor_porter").governor
    (point,) = reds(LoopView(found.loop, page()).chart)
    far = max(8.0, 1.15 * v["X"], 1.15 * v["Y"])
    assert point == pytest.approx(complex(v["X"], v["Y"]) / 0.1) and 76 < far / 0.1 <= 95  # 0.08 is too fine
    found = solved("governor_servo").governor
    (point,) = reds(LoopView(found.loop, page()).chart)
    v = values("governor_servo")
    assert point == pytest.approx(complex(v["T_i"] / 0.02, v["beta"] / 0.025))
    assert 110 * 0.8 < 2.5 * v["T_i"] / 0.02 <= 110 and 85 * 0.8 < 2.5 * v["beta"] / 0.025 <= 85


@pytest.mark.parametrize("name", NAMES)
def test_the_scheme_is_to_scale(name):
    found, v, at = solved(name).governor.direct, values(name), table(name, "equilibrium")
    place = scheme.places(found, 5)
    lengths = [abs(b - a) for bar in place.bars for a, b in pairwise(bar)]
    wanted = [v["l_1"], v["l_2"]] if name == "governor_porter" else [v["a"], v["b"]]
    assert lengths == pytest.approx(wanted) and place.ball.real == pytest.approx(at["r"][5])
    rise = scheme.places(found, -1).sleeve.imag - scheme.places(found, 0).sleeve.imag
    assert rise == pytest.approx(v["h"])
    drawing, scale = scheme.scheme(found), scheme.drawn_scale(found)
    balls = [item.centre for item in drawing.items if isinstance(item, Circle) and item.fill == "pale"]
    assert sorted(z.real for z in balls) == pytest.approx([-scale * at["r"][5], scale * at["r"][5]])


# --- governors that no ready variant has

OTHERS = {
    "Watt": "  arms: {upper: 400 mm, lower: 400 mm}\n  balls: {mass: 2 kg}\n  radius: {lowest: 200 mm}\n"
    "  lift: 40 mm\n",
    "beyond the pin": "  arms: {upper: 300 mm, lower: 200 mm, upper_offset: 20 mm, lower_offset: 30 mm}\n"
    "  balls: {mass: 3 kg, distance: 380 mm}\n  radius: {lowest: 120 mm, highest: 170 mm}\n  sleeve: {mass: 5 kg}\n",
    "Proell, balls chosen": "  arms: {upper: 300 mm, lower: 300 mm, lower_offset: 35 mm}\n"
    "  balls: {extension: 100 mm}\n  sleeve: {mass: 60 kg, friction: 20 N}\n"
    "  radius: {lowest: 200 mm, highest: 250 mm}\n  choose: {balls: 150 rpm}\n",
    "sleeve chosen, spring": "  arms: {upper: 300 mm, lower: 300 mm}\n  balls: {mass: 5 kg}\n"
    "  radius: {lowest: 150 mm, highest: 200 mm}\n  spring: {stiffness: 2 kN/m, force: 50 N}\n"
    "  choose: {sleeve: 180 rpm}\n",
    "unstable": "  bell_crank: {ball_arm: 120 mm, sleeve_arm: 80 mm, fulcrum: 140 mm, level: true}\n"
    "  balls: {mass: 2 kg}\n"
    "  radius: {lowest: 120 mm}\n  lift: 20 mm\n  spring: {stiffness: 10 kN/m, force: 1600 N}\n"
    "  machine:\n    inertia: 10 kg*m^2\n    torque: {full: 100 N*m}\n    load: {before: 50 N*m, after: 60 N*m}\n",
    "servo without isodrome": "  bell_crank: {ball_arm: 80 mm, sleeve_arm: 60 mm, fulcrum: 90 mm}\n"
    "  balls: {mass: 1 kg}\n  radius: {lowest: 75 mm}\n  lift: 20 mm\n  choose: {spring: [900 rpm, 1000 rpm]}\n"
    "  machine:\n    inertia: 10 kg*m^2\n    torque: {full: 100 N*m}\n    time: 2 s\n"
    "    load: {before: 50 N*m, after: 60 N*m, slope: 1 N*m*s/rad}\n    throttle: {least: 0.1}\n"
    "  servo: {time: 0.3 s, dead_zone: 0.1 mm}\n",
    "brake alone": "  brake:\n    mass: 1 kg\n    radius: 60 mm\n    gap: 2 mm\n    drum: 80 mm\n    friction: 0.3\n"
    "    spring: {stiffness: 20 kN/m}\n    moment: 10 N*m\n",
}  # fmt: skip


@pytest.mark.parametrize("name", OTHERS)
def test_other_governors_are_written_up(name):
    found = course.solve(loading.loads("language: en\ngovernor:\n" + OTHERS[name]))
    text = render(found, "html")["note.html"].decode()
    assert not re.search(r"\bnan\b|\binf\b", text) and "<math" in text and list(found.governor.summary())
    assert render(found, "tex")["note.tex"]
    drawn = views.picture(found.governor, page())
    assert drawn.items and min(drawn.size) > 30


def test_an_unstable_governor_is_said_first_with_what_would_help():
    found = course.solve(loading.loads("language: en\ngovernor:\n" + OTHERS["unstable"]))
    text = render(found, "html")["note.html"].decode()
    assert text.index("The governor is unstable") < text.index("Figure 1")
    assert "It would be made stable by" in text and "No dashpot makes the loop stable" in text
