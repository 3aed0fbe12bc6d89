"""What the README's command leaves out is told, is run by CI, and is never the whole of a test of the variants."""

import re
import tomllib
from pathlib import Path

from exhaustive import FEW, NAMES, beyond_few, many

ROOT = Path(__file__).parents[2]


def test_the_command_leaves_out_what_is_marked_and_ci_runs_it_with_the_others():
    options = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["pytest"]["ini_options"]
    assert "-m 'not exhaustive'" in options["addopts"] and "--strict-markers" in options["addopts"]
    assert [marker.partition(":")[0] for marker in options["markers"]] == ["exhaustive"]
    command = ".venv/bin/python -m pytest -n auto -m exhaustive"
    run, readme, contributing = (
        (ROOT / name).read_text("utf-8") for name in (".ci/run", "README.md", "CONTRIBUTING.md")
    )
    # the options of the environment stand behind those of the project and before those of the command, which has no -m
    assert re.search(r"""^PYTEST_ADDOPTS='-m ""' bash -euo pipefail -c "\$tests"$""", run, re.M)
    assert re.search(r"<!-- tests -->\n```sh\n.*pytest -n auto\n```", readme)
    assert command in readme and command in contributing


def test_a_test_of_the_variants_is_quick_for_one_at_least():
    assert set(FEW) <= NAMES
    for names in (sorted(NAMES), sorted(NAMES - set(FEW))):
        left = set(beyond_few([(name, name) for name in names]))
        assert 0 < len(names) - len(left) <= len(FEW)
    assert not list(beyond_few([(name, name) for name in ("shaper", "loom", "whitworth")]))
    assert [getattr(one, "values", one) for one in many(range(3), 2)] == [0, 1, (2,)]
