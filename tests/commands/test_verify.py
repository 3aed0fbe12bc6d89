"""`tmm-report verify`: right on this machine, red where the solver is wrong; its references are made by one command."""

from __future__ import annotations

import runpy
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from conftest import ALL_FILES
from told import Told

from tmm_report import load, solve
from tmm_report.chapters.gears.drive import stages
from tmm_report.commands.verify import found, reference, run
from tmm_report.mechanics.gears import involute
from tmm_report.mechanics.gears.eccentric import mechanism as eccentric
from tmm_report.mechanics.lever import motion
from tmm_report.problems import Message, ProblemError, mistake
from tmm_report.resources import references_root

ROOT = Path(__file__).parents[2]
NAMES = [file.stem for file in ALL_FILES]


def told(*names: str) -> tuple[bool, str]:
    talk = Told()
    right = run.run(names, "en", talk)
    return right, "\n".join(talk.lines)


@pytest.mark.exhaustive
def test_a_slider_crank_a_quick_return_and_gears_are_right_on_this_machine():
    right, lines = told("slider_crank_offset", "whitworth", "hoist_drive")
    assert right
    assert "whitworth" in lines and "3 variants" in lines and np.__version__ in lines


def test_a_velocity_wrong_in_the_twelfth_digit_turns_it_red(monkeypatch):
    of = motion.Motion.velocity
    monkeypatch.setattr(motion.Motion, "velocity", lambda self, point: of(self, point) * (1 + 2e-12))
    right, lines = told("elliptic_trammel")
    assert not right
    assert "velocity of point B, position" in lines and "wrong:" in lines


@pytest.fixture
def drives_anew():
    """No drive that was solved before is kept, nor one of the test."""
    stages._solved.cache_clear()
    yield
    stages._solved.cache_clear()


@pytest.mark.usefixtures("drives_anew")
def test_a_wrong_contact_ratio_turns_it_red(monkeypatch):
    from tmm_report.mechanics.gears.meshing import Pair

    of = Pair.p_b.func
    wrong = property(lambda self: of(self) * (1 + 1e-11))
    monkeypatch.setattr(Pair, "p_b", wrong)
    right, lines = told("hoist_drive")
    assert not right
    assert "stage1_eps" in lines


def test_a_number_that_is_lost_or_should_not_be_there_is_wrong():
    exact = reference.Pair(np.array([1.0, np.nan]), np.array([0.0, np.nan]))
    row = reference.Row("velocity", "B", 1.0, exact)
    assert row.errors(np.array([1.0, np.nan])).tolist() == [0.0, 0.0]
    assert row.errors(np.array([np.nan, 5.0])).tolist() == [np.inf, np.inf]


def test_a_name_that_is_none_of_the_ready_variants_is_told_with_those_that_are():
    with pytest.raises(ProblemError, match=r"compresor.*compressor"):
        told("compresor")


def test_a_variant_without_a_reference_is_not_taken_for_right(monkeypatch, tmp_path):
    monkeypatch.setattr(run, "references_root", lambda: tmp_path)
    right, lines = told("scotch_yoke")
    assert not right and "scotch_yoke has no reference" in lines


def test_a_ready_variant_that_is_refused_is_told_and_the_others_are_verified(monkeypatch):
    solved = run.solve

    def refusing(variant):
        if variant.lever is None:
            raise ProblemError([mistake("the wheels are refused", (), Message("wheels"))])
        return solved(variant)

    monkeypatch.setattr(run, "solve", refusing)
    right, lines = told("eccentric", "elliptic_trammel")
    assert not right
    assert "the wheels are refused" in lines and "not verified: 1 variants" in lines
    assert "in 1 variants" in lines  # the trammel is verified all the same


@pytest.mark.parametrize("name", ["forging", "press", "knuckle_press", "offset_press", "shaper"])
def test_a_position_under_load_is_among_those_kept(name):
    kept = reference.read(references_root() / f"{name}.json")
    moment = next(row for row in kept.rows if row.kind == "moment")
    assert np.abs(moment.exact.high).max() > 0.5 * moment.size


@pytest.mark.parametrize(
    "key", ["satellites/phi1/1", "satellites/y/3", "neighbours/gap/0", "speeds/omega_4/2"]
)
def test_the_satellites_of_an_eccentric_mechanism_have_references(key):
    kept = reference.read(references_root() / "eccentric.json")
    assert f"eccentric_{key}" in {value.name for value in kept.values}


@pytest.mark.parametrize("name", ["_inv_small", "_inverse_small", "_inverse_large"])
def test_an_involute_function_wrong_in_the_eleventh_digit_turns_it_red(monkeypatch, name):
    of = getattr(involute, name)
    kept = reference.read(references_root() / "involute.json")
    names = [value.name for value in kept.values]
    assert not run._values(found.of_functions(names), kept).wrong
    monkeypatch.setattr(involute, name, lambda x: of(x) * (1 + 1e-11))
    assert run._values(found.of_functions(names), kept).wrong


def test_without_names_the_involute_is_verified_too(monkeypatch):
    assert run._chosen([])["involute"] is None and "involute" not in run._chosen(["shaper"])
    monkeypatch.setattr(run, "_chosen", lambda names: {"involute": None})
    right, lines = told()
    assert right and "right: 22 numbers in 0 variants" in lines


@pytest.mark.exhaustive
def test_a_satellite_that_lies_on_the_wrong_side_turns_it_red(monkeypatch):
    of = eccentric.centres
    monkeypatch.setattr(eccentric, "centres", lambda *given: of(*given).conj())
    right, lines = told("eccentric")
    assert not right
    assert "eccentric_satellites/y/1" in lines


@pytest.mark.parametrize("name", NAMES)
def test_every_ready_variant_has_a_reference_with_the_limit_of_the_issue(name):
    kept = reference.read(references_root() / f"{name}.json")
    assert (kept.limits == 1e-12).all()
    assert not kept.rows or {"place", "velocity", "acceleration", "angular velocity"} <= {
        r.kind for r in kept.rows
    }


def test_references_are_small_and_each_is_of_a_variant():
    files = list(references_root().glob("*.json"))
    assert {file.stem for file in files} == {*NAMES, "involute"}
    assert sum(file.stat().st_size for file in files) < 700_000


@pytest.mark.parametrize("text", ["0.1", "-3.141592653589793238462643383279502884197", "1.5e-7", "0"])
def test_a_text_of_40_digits_is_read_as_two_doubles(text):
    high, low = reference._halves(text)
    assert abs(Fraction(high) + Fraction(low) - Fraction(text)) <= abs(Fraction(text)) / 10**31


def test_a_vector_and_a_number_that_does_not_exist_are_read_as_such():
    high, _ = reference._halves(["1", "-2"])
    assert high == 1 - 2j
    assert np.isnan(reference._halves(None)[0])


def test_position_numbers_and_largest_values_of_the_whole_table_are_kept():
    kept = reference.read(references_root() / "scotch_yoke.json")
    table = solve(load(ROOT / "variants" / "scotch_yoke.yaml")).lever.kinematics.table
    for row in kept.rows:
        if row.kind == "velocity" and np.abs(row.exact.high).any():
            assert row.size == pytest.approx(np.abs(table.velocity(row.name)).max(), rel=1e-6)


@pytest.mark.parametrize("name", ["elliptic_trammel", "machine_train"])
def test_the_command_that_made_a_reference_makes_it_again_byte_by_byte(name):
    tool = runpy.run_path(str(ROOT / "tools" / "references.py"))
    made = tool["text_of"](ROOT / "variants" / f"{name}.yaml")
    assert made.encode() == (references_root() / f"{name}.json").read_bytes()
    assert tool["text_of_involute"]().encode() == (references_root() / "involute.json").read_bytes()


def test_a_reference_of_another_mechanism_is_told_wrong():
    results = solve(load(ROOT / "variants" / "elliptic_trammel.yaml"))
    kept = reference.read(references_root() / "elliptic_trammel.json")
    assert not run.verified(results, kept).wrong
    moved = replace(kept, rows=tuple(replace(row, size=row.size * 1e-6) for row in kept.rows))
    assert run.verified(results, moved).wrong


@pytest.mark.exhaustive
def test_it_needs_no_library_of_many_digits():
    code = (
        "import sys; sys.modules['mpmath'] = None\n"
        "from tmm_report.cli import app\n"
        "app(['verify', 'elliptic_trammel', '--lang', 'en'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "right:" in done.stdout
