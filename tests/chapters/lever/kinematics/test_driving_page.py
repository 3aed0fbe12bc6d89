"""The note of a driving link that moves by a law of the time: its words, letters and axes in both languages."""

import re
from pathlib import Path

import pytest
from notes import render

from tmm_report import course, loading

CASES = Path(__file__).parents[3] / "cases" / "explain"
KINDS = {
    "law_rocker": (
        "it oscillates harmonically about a middle position",
        "оно качается по гармоническому закону",
    ),
    "law_accelerated": ("its angle is a polynomial of the time", "его угол — многочлен от времени"),
    "law_angles": ("stated by a table", "его угол задан таблицей"),
    "law_phases": ("phases of rise, dwell and return", "фазы удаления, выстоя и возвращения"),
}


def page(name, language):
    results = course.solve(loading.load(CASES / f"{name}.yaml"))
    return render(results, "html", language)["note.html"].decode()


def words(html):
    html = re.sub(r"<svg.*?</svg>|<style.*?</style>", " ", html, flags=re.S)
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", html))


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_law_is_said(name, language):
    text = words(page(name, language))
    assert KINDS[name][language == "ru"] in text
    assert not any(other[language == "ru"] in text for key, other in KINDS.items() if key != name)
    uniform = (
        "turns uniformly|at a constant angular velocity|its angular acceleration is zero"
        "|вращается равномерно|равно нулю:"
    )
    assert not re.search(uniform, text)


def test_the_axes_are_the_phase_and_the_rates_of_the_driving_link():
    html = page("law_rocker", "en")
    figure = next(
        one for one in re.findall(r"<figure.*?</figure>", html, flags=re.S) if "of the driving link" in one
    )
    assert "angular velocity and acceleration of the driving link" in figure
    text = re.sub(r"<[^>]+>", "", figure)
    order = [text.index(letter) for letter in ("ω", "ε")]
    assert order == sorted(order) and "θ" in text and "φ" not in text
