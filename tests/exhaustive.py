"""What is exhaustive: `pytest` leaves it out, `pytest -m exhaustive` runs it, `pytest -m ""` runs everything.

`--turn 2/4` leaves the second of four shares of it, a ready variant's or a statement's tests together, so that its note
is made in one of them alone. CI takes a share by turns with every commit.

A test that runs for more than three ready variants is quick for FEW of them and exhaustive for the others, without a
word of its own. What else is dear, 0.4 s of CPU or more a case, says so: `@pytest.mark.exhaustive`, or `many(values,
quick)` among its parameters. Of what everybody changes some such are quick all the same: texts, faults, a whole note.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any
from zlib import crc32

import pytest

NAMES = frozenset(path.stem for path in Path(__file__).parents[1].joinpath("variants").glob("*.yaml"))
STATED = frozenset(path.stem for path in Path(__file__).parent.joinpath("statements").glob("*.yaml"))
# with plans, forces, gears, a flywheel; a group of class IV; a cam; a drive
FEW = ("compressor", "press", "cam_press", "hoist_drive")
MARK = pytest.mark.exhaustive


def many(values: Iterable[Any], quick: int = 1) -> list[Any]:
    """Parameters of a test, of which the first few are quick."""
    return [
        value if k < quick else pytest.param(*_several(value), marks=MARK) for k, value in enumerate(values)
    ]


def _several(value: Any) -> tuple[Any, ...]:
    return value if isinstance(value, tuple) else (value,)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--turn", type=turn, metavar="K/N", help="the K-th of N shares of the exhaustive tests")


def turn(text: str) -> tuple[int, int]:
    """ "2/4" → (2, 4); any K counts on, so that 5/4 is 1/4."""
    k, n = map(int, text.split("/"))
    return (k - 1) % n + 1, n


@pytest.hookimpl(tryfirst=True)  # before pytest leaves out what is marked
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    tests = defaultdict(list)
    for item in items:
        name = variant_of(item)
        if name:
            tests[item.nodeid.partition("[")[0]].append((name, item))
    for found in tests.values():
        for item in beyond_few(found):
            item.add_marker(MARK)
    if config.getoption("turn"):
        k, n = config.getoption("turn")
        waits = {item: bool(item.get_closest_marker(MARK.name)) and share(of(item), n) != k for item in items}
        config.hook.pytest_deselected(items=[item for item in items if waits[item]])
        items[:] = [item for item in items if not waits[item]]


def of(item: pytest.Item) -> str:
    """By what a test has its turn: its variant or statement, its own name for others."""
    named = (text.rpartition("/")[2] for text in texts(item))
    return next((name for name in named if name in NAMES | STATED), item.nodeid)


def share(name: str, n: int) -> int:
    """Which of n shares it belongs to, 1 … n: the same on every machine."""
    return crc32(name.encode()) % n + 1


def variant_of(item: pytest.Item) -> str:
    """The ready variant that a test runs for, "" for none."""
    return next((text for text in texts(item) if text in NAMES), "")


def texts(item: pytest.Item) -> Iterator[str]:
    """What texts and paths its parameters have; of a path its stem."""
    parameters = item.callspec.params.values() if hasattr(item, "callspec") else ()
    for part in (part for value in parameters for part in _several(value)):
        if isinstance(part, str | Path):
            yield part.stem if isinstance(part, Path) else part


def beyond_few(found: list[tuple[str, Any]]) -> Iterator[Any]:
    """Of the cases of one test, those of other variants than FEW; where it knows none of these, but the first's."""
    names = dict.fromkeys(name for name, _ in found)
    if len(names) > 3:
        quick = set(names) & set(FEW) or {next(iter(names))}
        yield from (item for name, item in found if name not in quick)
