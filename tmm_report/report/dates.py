"""The date of a document that must have one: that which its texts state."""

from __future__ import annotations

import re
from datetime import date

UNDATED = date(2000, 1, 1)

_DATES = (
    re.compile(r"(?P<d>\d{1,2})[./](?P<m>\d{1,2})[./](?P<y>\d{4})"),
    re.compile(r"(?P<y>\d{4})-(?P<m>\d{2})-(?P<d>\d{2})"),
    re.compile(r"(?<!\d)(?P<y>\d{4})(?!\d)"),
)


def dated(*texts: str) -> date:
    """The first date that is stated, or year; the clock is none: the same note, the same bytes."""
    for text in texts:
        for pattern in _DATES:
            found = pattern.search(text)
            if found is None:
                continue
            parts = {"m": "1", "d": "1", **found.groupdict()}
            try:
                return date(int(parts["y"]), int(parts["m"]), int(parts["d"]))
            except ValueError:
                continue
    return UNDATED
