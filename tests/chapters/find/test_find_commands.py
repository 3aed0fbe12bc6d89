"""Questions asked backwards on the command line: exit codes, a folder of variants."""

import json

import pytest
from typer.testing import CliRunner

from tmm_report.cli import app

PIVOT = """language: en
contacts:
  - {name: step, kind: pivot, outer: 50 mm, inner: 10 mm, coefficient: 0.12, load: 40 kN, speed: 30 rpm}
find: {unknown: {contacts.step.outer: %s}, so_that: {contacts_1.p_mean: 8 MPa}}
"""
RANGES = {"met": ("20 mm .. 90 mm", 0), "not met": ("60 mm .. 90 mm", 1), "wrong": ("90 mm .. 60 mm", 2)}


@pytest.mark.parametrize("case", RANGES)
def test_exit_codes(case, tmp_path):
    span, code = RANGES[case]
    (tmp_path / "v.yaml").write_text(PIVOT % span, encoding="utf-8")
    call = ["solve", str(tmp_path / "v.yaml"), "-o", str(tmp_path / "out"), "--format", "html,json"]
    done = CliRunner().invoke(app, call)
    assert done.exit_code == code
    assert (tmp_path / "out" / "note.html").exists() == (code < 2)
    if code < 2:
        document = json.loads((tmp_path / "out" / "results.json").read_text("utf-8"))
        numbers = {one["key"]: one["value"] for one in document["values"]}
        assert numbers["find_count"] == (1 if code == 0 else 0)


def test_a_folder_of_them(tmp_path):
    (tmp_path / "in").mkdir()
    for case, (span, _) in RANGES.items():
        (tmp_path / "in" / f"{case.replace(' ', '_')}.yaml").write_text(PIVOT % span, encoding="utf-8")
    done = CliRunner().invoke(
        app, ["batch", str(tmp_path / "in"), "-o", str(tmp_path / "out"), "--lang", "en"]
    )
    rows = (tmp_path / "out" / "summary.csv").read_text("utf-8-sig").splitlines()
    assert len(rows) == 4 and done.exit_code
    assert (tmp_path / "out" / "met" / "note.html").exists()
