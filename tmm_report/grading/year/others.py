"""The solutions of a whole year in one file, so that each process can tell whose numbers a student handed in."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from tmm_report.grading.model import Digest, Expected, Name
from tmm_report.judging.diagnose.variants import Others, prepared

LARGEST = 3000  # variants that one work is compared with


def save(digests: Iterable[Digest], file: Path) -> bool:
    """Write what the digests say was right; whether there are two variants at least. Raises OSError."""
    found = [digest for digest in digests if digest.right][:LARGEST]
    cells = list(dict.fromkeys(cell for digest in found for cell in digest.right))
    place = {cell: index for index, cell in enumerate(cells)}
    numbers = np.full((len(found), len(cells)), np.nan)
    for row, digest in zip(numbers, found, strict=True):
        row[[place[cell] for cell in digest.right]] = list(digest.right.values())
    np.savez(
        file,
        ids=np.array([digest.id for digest in found]),
        cells=np.array(cells).reshape(-1, 3),
        numbers=numbers,
    )
    return len(found) > 1


@lru_cache(maxsize=2)
def _read(file: Path) -> tuple[list[str], dict[Name, dict[str, int]], np.ndarray]:
    with np.load(file, allow_pickle=False) as stored:
        places: dict[Name, dict[str, int]] = {}
        for index, (table, key, row) in enumerate(stored["cells"].tolist()):
            places.setdefault((table, key), {})[row] = index
        return stored["ids"].tolist(), places, stored["numbers"]


_made: dict[tuple[Path, tuple[tuple[Name, tuple[str, ...]], ...]], Others] = {}


def load(file: Path, asked: Expected) -> Others:
    """The year's solutions of the columns that a variant asks for; made once for all variants that ask alike."""
    alike = file, tuple((name, one.rows) for name, one in asked.items())
    if alike not in _made:
        _made.clear()  # of one topology after the other
        _made[alike] = prepared(_expected(file, asked))
    return _made[alike]


def _expected(file: Path, asked: Expected) -> Mapping[str, Expected]:
    ids, places, numbers = _read(file)
    columns: dict[Name, np.ndarray] = {}
    for name, one in asked.items():
        if at := places.get(name):
            columns[name] = np.full((len(ids), len(one.rows)), np.nan)
            for k, row in enumerate(one.rows):
                if row in at:
                    columns[name][:, k] = numbers[:, at[row]]
    return {
        id: {name: replace(asked[name], values=column[v]) for name, column in columns.items()}
        for v, id in enumerate(ids)
    }
