"""What a package index and a type checker find: the metadata, the licence, the mark of a typed package."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from tmm_report import __version__

ROOT = Path(__file__).resolve().parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
PROJECT = PYPROJECT["project"]


def test_what_an_index_shows():
    assert PROJECT["version"] == __version__
    assert (ROOT / PROJECT["readme"]).is_file()
    assert 20 < len(PROJECT["description"]) < 200 and len(PROJECT["keywords"]) >= 5
    assert PROJECT["authors"]
    assert all(re.fullmatch(r"[A-Z][\w/ -]*( :: [\w/. -]+)+", line) for line in PROJECT["classifiers"])
    assert len(set(PROJECT["classifiers"])) == len(PROJECT["classifiers"])


def test_the_classifiers_agree_with_the_python_that_is_required():
    least = tuple(map(int, PROJECT["requires-python"].removeprefix(">=").split(".")))
    found = re.findall(r"Python :: (\d+)\.(\d+)$", "\n".join(PROJECT["classifiers"]), re.M)
    named = [tuple(map(int, version)) for version in found]
    assert named and min(named) == least


def test_the_licence():
    assert PROJECT["license"] == "MIT" and PROJECT["license-files"] == ["LICENSE"]
    text = (ROOT / "LICENSE").read_text("utf-8")
    assert text.startswith("MIT License\n") and "WITHOUT WARRANTY OF ANY KIND" in text
    assert f"{PROJECT['authors'][0]['name']}\n" in text
    assert not any(line.startswith("License ::") for line in PROJECT["classifiers"])  # an index refuses both


@pytest.mark.parametrize("file", ["py.typed", "__init__.py", "cli.py"])
def test_the_wheel_ships(file):
    wheel = PYPROJECT["tool"]["hatch"]["build"]["targets"]["wheel"]
    assert "tmm_report" in wheel["only-include"] and not {"packages", "include"} & wheel.keys()
    assert not any(Path("tmm_report", file).match(pattern) for pattern in wheel["exclude"])
    assert (ROOT / "tmm_report" / file).is_file()
    ignored = (ROOT / ".gitignore").read_text("utf-8").split()
    assert not any(Path("tmm_report", file).match(pattern) for pattern in ignored)


def test_the_data_are_shipped():
    """All but what only developers read; `tests/docsite/test_wheel.py` builds one."""
    wheel = PYPROJECT["tool"]["hatch"]["build"]["targets"]["wheel"]
    shipped = {"templates", "variants"}
    assert wheel["sources"] == {folder: f"tmm_report/_data/{folder}" for folder in shipped}
    assert {*wheel["only-include"]} == {"tmm_report", *shipped} and all(
        (ROOT / folder).is_dir() for folder in shipped
    )
    assert {*wheel["exclude"]} == {"*.po", "*.md", "note.mo"}
