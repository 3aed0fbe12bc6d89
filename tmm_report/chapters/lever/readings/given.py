"""What is given of a student's own numbers."""

from __future__ import annotations

from collections.abc import Mapping

Written = tuple[float, str]  # the number and its unit, "" for that of the results
Readings = Mapping[
    int, Mapping[str, Written]
]  # table position -> key or symbol of the quantity -> what was read
