"""Dotted keys, `mechanism.links.2.points.B`: places of a variant's data, as a teacher names them."""

from __future__ import annotations

import re
from typing import Any

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.variant.errors import near
from tmm_report.yamlread import Path

LONGEST = 200  # characters of a dotted key

_PART = re.compile(r"""\s*(?:"([^"]*)"|'([^']*)'|([^."']+))\s*(\.|$)""")


def path_of(dotted: str, data: Any) -> Path:
    """The path of a value that the data has. Raises ProblemError with the nearest key for one that it has not.

    A part with a dot in it stands in quotes; of lists a part is the number of the item, from 0.
    """
    path: Path = ()
    for part in _parts(dotted):
        key = _step(part, data, path)
        data, path = data[key], (*path, key)
    return path


def value_at(data: Any, path: Path) -> Any:
    for key in path:
        data = data[key]
    return data


def _parts(dotted: str) -> list[str]:
    parts, at = [], 0
    while len(dotted) <= LONGEST and (match := _PART.match(dotted, at)):
        parts.append(next(part for part in match.groups()[:3] if part is not None).strip())
        if match[4] == "":
            return parts
        at = match.end()
    right = Message(N_("for example, %(example)s"), {"example": "mechanism.links.2.points.B"})
    raise ProblemError([mistake(N_("%(key)s is not a dotted key"), right=right, key=shown(dotted))])


def _step(part: str, data: Any, path: Path) -> str | int:
    """The key by which the data is entered, its type as the data has it."""
    if isinstance(data, dict) and part in data:
        return part
    if isinstance(data, list) and re.fullmatch(r"[0-9]{1,5}", part) and int(part) < len(data):
        return int(part)
    raise ProblemError([_missing(part, data, path)])


def _missing(part: str, data: Any, path: Path) -> Problem:
    values: dict[str, Any] = {"key": shown(part), "above": shown(".".join(map(str, path)), 120)}
    right = None
    if isinstance(data, dict):
        right = near(part, list(data))
        text = (
            N_("the template has no key %(key)s in %(above)s")
            if path
            else N_("the template has no key %(key)s")
        )
    elif isinstance(data, list):
        text = N_("%(above)s of the template is a list of %(count)s: %(key)s is none of its numbers")
        right = Message(N_("items are counted from 0"))
        values["count"] = len(data)
    else:
        text = N_("%(above)s of the template is a single value: it has no %(key)s")
    return Problem(Message(text, values), right)
