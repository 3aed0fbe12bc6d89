"""How much a variant may hold: refused at the door, before any work, with the limit and what is to be lessened.

The limits are far above what a course project needs; a variant within all of them gets its note within 500 MB and
20 s. What a single list of a block may hold stands in the block; here stands what no block sees alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.yamlread import Path

ENTRIES = 2000  # of any list or mapping
COUNTS: Mapping[Path, int] = {
    ("mechanism", "links"): 40,
    ("mechanism", "frame"): 60,
    ("mechanism", "guides"): 40,
    ("mechanism", "cams"): 8,
    ("mechanism", "assembly"): 60,
    ("mechanism", "sketch"): 120,
    ("loads", "forces"): 60,
    ("loads", "moments"): 60,
    ("drawing", "scales", "force"): 40,
    ("positions", "plans"): 36,
    ("positions", "force_plan"): 36,
    ("readings",): 361,
}
SLIDES = 10  # guides along which one link slides
POINTS = 120  # of all links together, the frame's too
ROWS = 12_000  # positions of the table, times points and moving links
PLANS = 200  # positions with plans or a force plan, times moving links
TABLE = 12  # positions of a table that states none


def beyond(data: Mapping[str, Any]) -> list[Problem]:
    """What of the file is more than is taken; nothing of a file of usual size."""
    return [*_counts(data), *_points(data), *_work(data)] or [*_entries(data, ())]


def _counts(data: Mapping[str, Any]) -> Iterator[Problem]:
    for path, most in COUNTS.items():
        yield from _many(_at(data, path), path, most)
    for name, link in _items(_at(data, ("mechanism", "links"))):
        if isinstance(link, dict) and isinstance(slides := link.get("slides"), list):
            yield from _many(slides, ("mechanism", "links", name, "slides"), SLIDES)


def _points(data: Mapping[str, Any]) -> Iterator[Problem]:
    if (count := points(data)) > POINTS:
        text = N_("%(count)s points in all links are too many: at most %(limit)s")
        right = Message(N_("leave out points that nothing needs"))
        yield mistake(text, ("mechanism", "links"), right, count=count, limit=POINTS)


def points(data: Mapping[str, Any]) -> int:
    """Points of all links, as often as they are written."""
    links = (
        link.get("points") for _, link in _items(_at(data, ("mechanism", "links"))) if isinstance(link, dict)
    )
    return _length(_at(data, ("mechanism", "frame"))) + sum(map(_length, links))


def _work(data: Mapping[str, Any]) -> Iterator[Problem]:
    """Tables and plans grow with the positions and with the mechanism."""
    links = max(1, _length(_at(data, ("mechanism", "links"))))
    rows, parts = _whole(_at(data, ("positions", "table")), TABLE), links + points(data)
    if rows * parts > ROWS:
        text = N_("%(rows)s positions of a mechanism with %(parts)s points and links are too many")
        right = Message(N_("at most %(count)s positions, or fewer points"), {"count": ROWS // parts})
        yield mistake(text, ("positions", "table"), right, rows=rows, parts=parts)
    for key in ("plans", "force_plan"):
        plans = _length(_at(data, ("positions", key)))
        if plans * links > PLANS and plans > 1:
            text = N_(
                "polygons in %(plans)s positions of a mechanism with %(links)s moving links are too many"
            )
            right = Message(N_("at most %(count)s positions"), {"count": max(1, PLANS // links)})
            yield mistake(text, ("positions", key), right, plans=plans, links=links)


def _entries(inside: Any, path: Path) -> Iterator[Problem]:
    """Lists and mappings of a length that no key has a use for."""
    if isinstance(inside, dict | list):
        yield from _many(inside, path, ENTRIES)
        for key, item in inside.items() if isinstance(inside, dict) else enumerate(inside):
            if isinstance(item, dict | list):
                yield from _entries(item, (*path, key))


def _many(inside: Any, path: Path, most: int) -> Iterator[Problem]:
    if _length(inside) > most:
        text = N_("%(count)s entries are too many here: at most %(limit)s")
        yield mistake(text, path, Message(N_("take some out")), count=_length(inside), limit=most)


def _at(data: Any, path: Sequence[str | int]) -> Any:
    for key in path:
        data = data.get(key) if isinstance(data, dict) else None
    return data


def _items(inside: Any) -> Iterator[tuple[str, Any]]:
    yield from inside.items() if isinstance(inside, dict) else ()


def _length(inside: Any) -> int:
    return len(inside) if isinstance(inside, dict | list) else 0


def _whole(value: Any, otherwise: int) -> int:
    """A count as it is written; one that is wrong in itself is told elsewhere."""
    return value if isinstance(value, int) and 0 < value <= 360 else otherwise
