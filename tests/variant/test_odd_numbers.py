"""Numbers that missed their unit by a thousand: solved as written, with a warning that names the likely unit."""

from __future__ import annotations

from pathlib import Path

import pytest
from mistyped import PUMP, lines, typed
from typer.testing import CliRunner

from tmm_report import cli, loading

VARIANTS = sorted((Path(__file__).parents[2] / "variants").glob("*.yaml"))


@pytest.mark.parametrize("file", VARIANTS, ids=lambda file: file.stem)
def test_no_ready_variant_has_an_odd_number(file):
    assert [d.text() for d in loading.load(file).doubts if "odd" in d.text() or "unusual" in d.text()] == []


def test_millimetres_forgotten_everywhere_are_told_once():
    slips = [("[380 мм, -120 мм]", "[380, -120]"), ("140 мм", "140")]
    for metres, bare in (("0.1 м", "100"), ("0.4 м", "400"), ("0.28 м", "280"), ("0.35 м", "350")):
        slips.append((metres, bare))
    (line,) = lines(*slips)
    assert line.startswith("11:24: mechanism.links.1.points.A: warning: 100 m is too large a length")
    assert line.endswith("a bare number is in metres; did you mean 100 мм?")


@pytest.mark.parametrize(
    ("right", "wrong", "place", "meant"),
    [
        ("B: 0.28 м", "B: 0.28 мм", "13:24", "0.28 м?"),
        ("A: 0.1 м", "A: 100", "11:24", "100 мм?"),
        ("A: 0.1 м", "A: 0.1 мм", "11:24", "0.1 м?"),
        ("Q: [0, 140 мм]", "Q: [0, 140]", "7:12", "140 мм?"),
        ("piston_diameter: 90 мм", "piston_diameter: 90", "26:7", "90 мм?"),
        ("mass: 2.8 кг", "mass: 2800", "13:48", "2800 г?"),
        ("mass: 2.8 кг", "mass: 2.8 т", "13:48", "2.8 кг?"),
        ("inertia: 0.0533", "inertia: 53300", "12:75", "53300 кг*мм^2?"),
        ("speed: 90 об/мин", "speed: 900", "18:5", "900 об/мин?"),
        ("speed: 90 об/мин", "speed: 300", "18:5", "300 об/мин?"),
        ("{point: D, extreme: right}", "{angle: 30}", "19:12", "30 град?"),
    ],
)
def test_one_number_that_missed_its_unit_is_named_with_the_likely_one(right, wrong, place, meant):
    (line,) = lines((right, wrong))
    assert line.startswith(place + ":")
    assert "warning: " in line
    assert line.endswith(f"did you mean {meant}")


def test_a_pressure_in_megapascals_without_the_unit_is_told_once_for_its_law():
    (line,) = lines(text=PUMP.replace("0.8 МПа", "0.8"))
    assert "loads.forces.0.by_displacement.back" in line
    assert line.endswith("did you mean 0.8 МПа?")


def test_masses_in_grams_are_each_told():
    grams = {"mass: 1 кг": "mass: 1000", "mass: 4 кг": "mass: 4000", "mass: 2.8 кг": "mass: 2800"}
    found = lines(*grams.items())
    assert [line.split(": ")[1] for line in found] == [f"mechanism.links.{k}.mass" for k in (1, 2, 3)]
    assert all(line.endswith(" г?") for line in found)


def test_a_lonely_drive_is_judged_by_what_a_person_builds():
    text = "drive:\n  speed: 1500\n  stages: [{kind: spur, ratio: 2, module: 3 mm}]\n"
    assert lines(text=text)[0].endswith("did you mean 1500 rpm?")


@pytest.mark.exhaustive
def test_the_warning_is_printed_and_the_note_says_it_and_the_exit_code_stays(tmp_path):
    (tmp_path / "v.yaml").write_text(typed(("mass: 2.8 кг", "mass: 2800")), "utf-8")
    asked = ["solve", str(tmp_path / "v.yaml"), "-o", str(tmp_path), "--format", "html", "--lang", "en"]
    done = CliRunner().invoke(cli.app, asked)
    assert done.exit_code == 0
    assert "mechanism.links.3.mass: warning: 2800 kg is odd" in done.stderr
    note = (tmp_path / "note.html").read_text("utf-8")
    assert note.index("To be checked in the initial data:") < note.index("did you mean 2800 г?")


def test_what_stops_the_solving_is_told_with_the_doubt_that_may_be_its_cause(tmp_path):
    (tmp_path / "v.yaml").write_text(typed(("slides: x, ", ""), ("mass: 2.8 кг", "mass: 2800")), "utf-8")
    done = CliRunner().invoke(
        cli.app, ["solve", str(tmp_path / "v.yaml"), "-o", str(tmp_path), "--lang", "en"]
    )
    assert done.exit_code == 2
    first, *others = done.stderr.splitlines()
    assert "mobility" in first
    assert any("links.3.mass: warning: 2800 kg is odd" in line for line in others)


CAM = (VARIANTS[0].parent / "cam_press.yaml").read_text("utf-8")


@pytest.mark.parametrize(
    ("speed", "odd"), [("1000 rpm", False), ("3000 rpm", False), ("380 rad/s", False), ("380", True)]
)
def test_a_cam_is_judged_by_its_own_radius(speed, odd):
    """Base, lift and the roller's arm give 100 mm: what replaces the pair has places a metre away."""
    said = [one.text() for one in loading.loads(CAM.replace("speed: 90 rpm", f"speed: {speed}")).doubts]
    told = [text for text in said if "end of the driving link" in text]
    assert bool(told) == odd
    if odd:
        assert float(told[0].split(" m/s")[0].split()[-1]) == pytest.approx(
            380 * (0.055 + 0.145 * 0.31416), rel=0.01
        )


def test_a_mass_in_a_cam_mechanism_is_judged_by_the_links_that_there_are():
    """Its longest link has 265 mm and not a metre."""
    said = [one.text() for one in loading.loads(CAM.replace("mass: 5.2 kg", "mass: 5200 kg")).doubts]
    assert any("longest link has 0.26" in text or "longest link has 0.27" in text for text in said), said
