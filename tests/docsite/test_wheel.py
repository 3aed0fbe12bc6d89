"""The wheel in an environment of its own, and the jobs for samples of docs/ci, which install it, not the checkout."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
import yaml
from pages_of_docs import ROOT

from tmm_report.languages import LANGUAGES

pytestmark = pytest.mark.exhaustive
JOBS = ("github-actions.yml", "gitlab-ci.yml")


def told(command: str, folder: Path, **env: str) -> str:
    """What a shell command says in a folder that knows nothing of the checkout."""
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run(command, shell=True, cwd=folder, env=clean | env, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    place = tmp_path_factory.mktemp("wheels")
    told(f"{sys.executable} -m pip wheel -q --no-deps -w {place} {ROOT}", place)
    (made,) = place.glob("*.whl")
    return made


@pytest.fixture(scope="module")
def bare(tmp_path_factory) -> Path:
    """An environment that has what the program needs, but not the program: its libraries are those of this one."""
    place = tmp_path_factory.mktemp("bare")
    told(f"{sys.executable} -m venv {place}", place)
    (own,) = place.glob("lib/python*/site-packages")
    libraries = [path for path in sys.path if path.endswith("site-packages")]
    (own / "libraries.pth").write_text("\n".join(libraries), encoding="utf-8")
    return place


def lines(node: Any) -> list[str]:
    """The commands of a job, in their order."""
    if isinstance(node, dict):
        return [line for key, one in node.items() if key not in ("uses", "with") for line in lines(one)]
    if isinstance(node, list):
        return [line for one in node for line in lines(one)]
    return [node] if isinstance(node, str) and node.startswith(("pip ", "tmm-report ")) else []


def test_the_wheel_is_for_every_system_and_holds_what_is_needed(wheel):
    assert wheel.name.endswith("-py3-none-any.whl")

    names = zipfile.ZipFile(wheel).namelist()
    for file in ("templates/report.html.j2", "variants/shaper.yaml", "templates/locale/ru/format.yaml"):
        assert f"tmm_report/_data/{file}" in names
    languages = [code for code, row in LANGUAGES.items() if not row.ids]
    assert {name for name in names if "/note.mo" in name} == {
        f"tmm_report/_data/templates/locale/{code}/LC_MESSAGES/note.mo.xz" for code in languages
    }
    assert not [name for name in names if name.endswith((".po", ".md"))]


@pytest.mark.parametrize("job", JOBS)
def test_the_job_for_samples_runs_with_the_wheel_alone(job, wheel, bare, tmp_path):
    (tmp_path / "wheels").mkdir()
    (tmp_path / "samples").mkdir()
    shutil.copy(wheel, tmp_path / "wheels")
    shutil.copy(ROOT / "variants" / "rotor.yaml", tmp_path / "samples")
    env = {"PATH": f"{bare / 'bin'}:{os.environ['PATH']}", "PIP_NO_INDEX": "1", "PIP_NO_DEPS": "1"}
    install, check = lines(yaml.safe_load((ROOT / "docs" / "ci" / job).read_text("utf-8")))
    told(f"{install} --force-reinstall", tmp_path, **env)
    where = told('python -c "import tmm_report; print(tmm_report.__file__)"', tmp_path, **env)
    assert where.startswith(str(bare))
    subprocess.run(
        ["tmm-report", "check", "samples/", "--update"], cwd=tmp_path, env=os.environ | env, check=False
    )
    assert (tmp_path / "samples" / "rotor.expected.json").is_file()
    told(check, tmp_path, **env)
    assert "rotor" in (tmp_path / "check.xml").read_text("utf-8")


def test_a_first_hour_begins_from_the_wheel(wheel, bare, tmp_path):
    """What install.md promises: no checkout, no compiler."""
    env = {
        "PATH": f"{bare / 'bin'}:{os.environ['PATH']}",
        "PIP_NO_INDEX": "1",
        "PIP_NO_DEPS": "1",
        "LANG": "C",
    }
    told(f"pip install -q --force-reinstall {wheel}", tmp_path, **env)
    assert "shaper" in told("tmm-report examples", tmp_path, **env)
    told("tmm-report new my.yaml --like rotor", tmp_path, **env)
    told("tmm-report solve my.yaml", tmp_path, **env)
    assert (tmp_path / "my-note" / "note.html").stat().st_size > 50_000
