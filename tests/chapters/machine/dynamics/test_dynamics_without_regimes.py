"""The machine reduced to its shaft and no more: a note without the regimes that there are not, in words that say so."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from exhaustive import many
from notes import render, static
from test_dynamics_chapter import alone, book
from told import Told

from tmm_report import course, loading
from tmm_report.commands.explain import run as explain
from tmm_report.commands.gallery import run as gallery

CASES = sorted((Path(__file__).parents[3] / "cases" / "machine").glob("crash_*.yaml"))
FLYWHEEL = "parts: [{name: flywheel, inertia: 3}]"
SHUNT = "motor: {shunt: {power: 5.5 kW, speed: 1430 rpm, no_load: 1500 rpm}}"
TEXTS = {
    **{file.stem: file.read_text("utf-8") for file in CASES},
    "weights": "dynamics: {parts: [{name: cage, inertia: 1, mass: 20 kg, radius: 0.1, moves: down}]}",
    "no moment": "dynamics: {parts: [{name: flywheel, inertia: 3}], springs: "
    "[{stiffness: 2000, length: 0.1, radius: 0.05, apart: 0.2}]}",
    "by time": f"dynamics: {{{FLYWHEEL}, motor: {{by_time: [[0, 5], [1, 9]]}}}}",
    "by angle": f"dynamics: {{{FLYWHEEL}, motor: {{by_angle: [[0, 5], [90 deg, 9], [360 deg, 5]]}}}}",
    "by speed": f"dynamics: {{{FLYWHEEL}, {SHUNT}, resistance: [{{fan: {{moment: 30, speed: 100}}}}], steady: false}}",
    "geared": f"dynamics: {{{FLYWHEEL}, motor: {{constant: 20, ratio: 3, efficiency: 0.9}}}}",
    "varying": "dynamics: {varying_inertia: [[0, 2], [180 deg, 3], [360 deg, 2]], resistance: [{friction: 4}]}",
}


@pytest.mark.parametrize("language", many(("ru", "en")))
@pytest.mark.parametrize("name", TEXTS)
def test_there_is_a_note_in_every_form(name, language):
    results = course.solve(loading.loads(TEXTS[name]))
    files = {form: render(results, form, language) for form in ("html", "tex", "json", "csv")}
    assert b"</html>" in files["html"]["note.html"] and b"\\end{document}" in files["tex"]["note.tex"]
    assert not any("dynamics_works" in str(file) for file in files["csv"])
    page = re.sub("<[^>]+>", " ", static(files["html"]["note.html"].decode()))
    assert not re.search(r"\b(None|nan|inf|null)\b", page)
    assert "Баланс работ" not in page and "Balance of works" not in page


@pytest.mark.parametrize("name", TEXTS)
def test_the_page_says_that_no_regime_is_asked_for_or_gives_the_acceleration(name):
    results = course.solve(loading.loads(TEXTS[name]))
    page = render(results, "html", "en")["note.html"].decode()
    constant = name in ("crash_reduction_only", "crash_constant_motor", "weights", "geared")
    assert ("No regime of the motion is asked for" in page) != constant
    assert ("has the angular acceleration" in page) == constant
    assert ("dynamics_epsilon" in book(results.dynamics).values) == constant


@pytest.mark.parametrize(
    ("text", "acceleration"),
    (
        (" parts: [{name: f, inertia: 3}]\n motor: {constant: 50 N*m}", 50 / 3),
        (" parts: [{name: f, inertia: 3}]\n motor: {constant: 50}\n resistance: [{friction: 10}]", 40 / 3),
        (" parts: [{name: f, inertia: 3}]\n motor: {constant: 20, ratio: 3, efficiency: 0.9}", 54 / 3),
        # a cage of 20 kg on a drum of 0.1 m: m g r = (J + m r²) ε
        (" parts: [{name: c, inertia: 1, mass: 20, radius: 0.1, moves: down}]", 20 * 9.81 * 0.1 / 1.2),
    ),
)
def test_under_constant_moments_the_acceleration_is_that_of_the_start_up(text, acceleration):
    assert book(alone(text))["dynamics_epsilon"].value == pytest.approx(acceleration, rel=1e-12)
    start = alone(text + "\n start: {begin: 1, time: 2 s}").start
    assert (start.omega[-1] - 1) / 2 == pytest.approx(acceleration, rel=1e-9)


def test_characteristics_reach_to_the_speeds_of_the_motor_or_of_the_fan():
    assert alone(f" {FLYWHEEL}\n {SHUNT}\n steady: false").speeds[-1] == pytest.approx(
        1.05 * 157.08, rel=1e-4
    )
    fan = " resistance: [{fan: {moment: 30, speed: 100}}]\n motor: {constant: 5}\n steady: false"
    assert alone(f" {FLYWHEEL}\n{fan}").speeds[-1] == pytest.approx(105)


def test_the_acceleration_is_explained(tmp_path):
    file = tmp_path / "v.yaml"
    file.write_text(TEXTS["geared"], encoding="utf-8")
    talk = Told()
    explain.run(file, "dynamics_epsilon", None, "en", talk)
    assert "18 rad/s²" in "\n".join(map(str, talk.lines))


def test_the_gallery_shows_such_machines(tmp_path):
    folder = tmp_path / "variants"
    folder.mkdir()
    for name, text in TEXTS.items():
        (folder / f"{name.replace(' ', '_')}.yaml").write_text(text, encoding="utf-8")
    talk = Told()
    assert gallery.run(folder, tmp_path / "out", "en", talk), talk.lines
