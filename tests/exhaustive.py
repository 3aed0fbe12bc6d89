"""What is exhaustive: `pytest` leaves it out, `pytest -m exhaustive` runs it, `pytest -m ""` runs everything.

A test that runs for more than three ready variants is quick for FEW of them and exhaustive for the others, without a
word of its own. What else is dear, 0.4 s of CPU or more a case, says so: `@pytest.mark.exhaustive`, or `many(values,
quick)` among its parameters. Of what everybody changes some such are quick all the same: texts, faults, a whole note.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

NAMES = frozenset(path.stem for path in Path(__file__).parents[1].joinpath("variants").glob("*.yaml"))
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


@pytest.hookimpl(tryfirst=True)  # before pytest leaves out what is marked
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    tests = defaultdict(list)
    for item in items:
        name = variant_of(item)
        if name:
            tests[item.nodeid.partition("[")[0]].append((name, item))
    for found in tests.values():
        for item in beyond_few(found):
            item.add_marker(MARK)


def variant_of(item: pytest.Item) -> str:
    """The ready variant that a test runs for, "" for none."""
    parameters = item.callspec.params.values() if hasattr(item, "callspec") else ()
    texts = (part.stem if isinstance(part, Path) else part for x in parameters for part in _several(x))
    return next((text for text in texts if isinstance(text, str) and text in NAMES), "")


def beyond_few(found: list[tuple[str, Any]]) -> Iterator[Any]:
    """Of the cases of one test, those of other variants than FEW; where it knows none of these, but the first's."""
    names = dict.fromkeys(name for name, _ in found)
    if len(names) > 3:
        quick = set(names) & set(FEW) or {next(iter(names))}
        yield from (item for name, item in found if name not in quick)
