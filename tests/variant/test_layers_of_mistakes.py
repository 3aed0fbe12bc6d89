"""Mistakes that do not depend on one another are told together; suggestions are where they belong, and bounded."""

from __future__ import annotations

import pytest
from mistyped import lines, said, typed
from typer.testing import CliRunner

from tmm_report import cli, load, solve
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError

DRIVE = "drive:\n  speed: 1500 rpm\n  tolerance: 50 %\n  stages: [{kind: spur, ratio: 2, module: 3 mm}]\n"


def keys(*slips, text=None):
    return [problem.key for problem in (said(*slips) if text is None else said(*slips, text=text))]


def test_loads_gears_and_the_mechanism_are_told_at_once():
    found = keys(("at: D", "at: Z"), ("slides: x", "slides: y"), ("loads:", DRIVE + "titel: a\nloads:"))
    assert found == ["mechanism.links.5.slides", "drive.tolerance", "titel", "loads.forces.0.at"]


def test_a_mechanism_that_cannot_be_is_told_beside_a_wrong_key_of_another_block():
    wrong = [("points: [D], slides: x", "points: [D]"), ("loads:", "titel: a\nloads:")]
    found = said(*wrong)
    assert [problem.key for problem in found] == ["mechanism.links", "titel"]
    assert "mobility" in found[0].wrong.text


def test_gears_that_cannot_be_are_told_beside_a_mechanism_that_cannot_be():
    gears = "drive:\n  speed: 1500 rpm\n  stages: [{kind: spur, ratio: 2, teeth: [17, 60], module: 3 mm}]\n"
    wrong = typed(("points: [D], slides: x", "points: [D]"), ("loads:", gears + "titel: a\nloads:"))
    assert {key.split(".")[0] for key in keys(text=wrong)} == {"mechanism", "drive", "titel"}


@pytest.mark.parametrize(
    ("right", "wrong", "key", "told"),
    [
        ("    zero: {", "  zero: {", "mechanism.zero", "it belongs into driver: indent it further"),
        ("loads:\n", "  loads:\n", "mechanism.loads", "it stands at the top of the file"),
        ("      at: D", "      at: D\n      gravity: 3", "loads.forces.0.gravity", "it belongs into loads"),
        ("mass: 4 кг", "mas: 4 кг", "mechanism.links.2.mas", "did you mean mass?"),
        ("      at: D", "      at: D\n      mass: 3", "loads.forces.0.mass", "known: at, by_angle"),
    ],
)
def test_an_unknown_key_is_told_where_it_is_known(right, wrong, key, told):
    first = said((right, wrong))[0]
    assert first.key == key
    assert told in first.text()


def test_a_key_of_another_form_is_told_with_what_excludes_it():
    stage = "{kind: spur, satellites: 3, ratio: 2, module: 3 mm}"
    (line,) = lines(text=f"drive:\n  speed: 1500 rpm\n  stages: [{stage}]\n")
    assert line.endswith("unknown key satellites; satellites does not go together with kind: spur")


@pytest.mark.exhaustive
def test_a_file_full_of_mistakes_is_cut_short():
    strange = "".join(f"z{n}aaaa: 1\n" for n in range(700))
    found = said(("loads:", strange + "loads:"))
    assert len(found) == 51
    assert found[-1].text() == "v: and 650 more mistakes"


# ---------------------------------------------------------------- the language


@pytest.mark.parametrize(
    "slip",
    [("slides: x", "slides: y"), ("S2: 0.2 м}", "S2: 0.2 м"), ("points: [D], slides: x", "points: [D]")],
)
def test_mistakes_are_told_in_the_language_of_the_file(tmp_path, monkeypatch, slip):
    monkeypatch.setenv("LC_ALL", "C")
    (tmp_path / "v.yaml").write_text(typed(slip), "utf-8")
    command = ["solve", str(tmp_path / "v.yaml"), "-o", str(tmp_path)]
    told = told_by(tmp_path / "v.yaml")
    assert CliRunner().invoke(cli.app, command).stderr.splitlines()[0] == told.text(Translator("ru").gettext)
    asked = CliRunner().invoke(cli.app, [*command, "--lang", "en"])
    assert asked.stderr.splitlines()[0] == told.text()


def told_by(file):
    """The first mistake of a file."""
    with pytest.raises(ProblemError) as error:
        solve(load(file))
    return error.value.problems[0]


def test_a_file_without_a_language_is_answered_in_that_of_the_system(tmp_path, monkeypatch):
    monkeypatch.setenv("LC_ALL", "C")
    (tmp_path / "v.yaml").write_text(typed(("language: ru\n", ""), ("slides: x", "slides: y")), "utf-8")
    done = CliRunner().invoke(cli.app, ["check", str(tmp_path)])
    assert "there is no guide y" in done.stderr


@pytest.mark.parametrize("command", ["explain", "assemblies", "check"])
def test_other_commands_speak_the_language_of_the_file_too(tmp_path, monkeypatch, command):
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "v.yaml").write_text(typed(("speed: 90 об/мин", "speed: 90 кг")), "utf-8")
    told = {"explain": ["v.yaml", "v_B"], "assemblies": ["v.yaml"], "check": ["."]}[command]
    done = CliRunner().invoke(cli.app, [command, *told])
    assert done.exit_code == 2
    assert "ожидается" in done.stderr
