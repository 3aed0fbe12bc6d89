"""What the README's command leaves out is told, is run by turns in CI, and is never all that a test of variants has."""

import re
import tomllib
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import pytest
from exhaustive import FEW, NAMES, STATED, beyond_few, many, pytest_collection_modifyitems, turn

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
    assert re.search(r"""^turn=\$\(git rev-list --count HEAD\)/5$""", run, re.M)
    assert re.search(r"""^PYTEST_ADDOPTS="-m '' --turn \$turn" bash -euo pipefail -c "\$tests"$""", run, re.M)
    assert re.search(r"<!-- tests -->\n```sh\n.*pytest -n auto\n```", readme)
    assert command in readme and command in contributing


def test_a_test_of_the_variants_is_quick_for_one_at_least():
    assert set(FEW) <= NAMES
    for names in (sorted(NAMES), sorted(NAMES - set(FEW))):
        left = set(beyond_few([(name, name) for name in names]))
        assert 0 < len(names) - len(left) <= len(FEW)
    assert not list(beyond_few([(name, name) for name in ("shaper", "loom", "whitworth")]))
    assert [getattr(one, "values", one) for one in many(range(3), 2)] == [0, 1, (2,)]


class Item:
    """What `exhaustive.py` asks of a test."""

    def __init__(self, nodeid: str, *parameters: str, dear: bool = False) -> None:
        self.nodeid, self.marks = nodeid, {"exhaustive"} if dear else set()
        self.callspec = SimpleNamespace(params=dict(enumerate(parameters)))

    def add_marker(self, mark: pytest.MarkDecorator) -> None:
        self.marks.add(mark.name)

    def get_closest_marker(self, name: str) -> bool:
        return name in self.marks


def test_five_commits_run_every_exhaustive_test_once_and_each_of_them_the_others():
    """The tests of a variant or a statement in one turn."""
    tests = {
        f"{test}[{name}]": (name,) for test in ("a.py::test", "b.py::test") for name in sorted(NAMES | STATED)
    }
    alone = {f"c.py::test_{k}" for k in range(100)}
    run = Counter()
    for count in range(4811, 4816):
        items = [
            *(Item(id, *of, dear=of[0] in STATED) for id, of in tests.items()),
            *(Item(id, dear=True) for id in sorted(alone)),
            Item("d.py::test"),
        ]
        hook = SimpleNamespace(pytest_deselected=lambda items: None)
        config = SimpleNamespace(getoption=lambda _, of=turn(f"{count}/5"): of, hook=hook)
        pytest_collection_modifyitems(config, items)
        left = {item.nodeid for item in items}
        assert all((f"a.py::test[{x}]" in left) == (f"b.py::test[{x}]" in left) for x in NAMES | STATED)
        assert len(tests) / 10 < len(left & {*tests}) < len(tests) / 3 and 10 < len(left & alone) < 33
        run.update(left)
    often = {id: 5 if of[0] in FEW else 1 for id, of in tests.items()} | dict.fromkeys(alone, 1)
    assert run == often | {"d.py::test": 5}
