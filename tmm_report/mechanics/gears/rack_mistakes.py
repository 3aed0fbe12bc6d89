"""What may be wrong with the rack of a gear chapter, in one sentence with what would work."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.mechanics.gears.pair_sizes import Rack
from tmm_report.problems import N_, Message, Problem, mistake


def of_rack(rack: Rack, path: tuple[str, ...]) -> Iterator[Problem]:
    """A rack without teeth, or whose teeth come to a point; `path`: its place in the stage's or chapter's block."""
    most = math.pi / 4 / math.tan(rack.alpha)
    if rack.ha <= 0:
        right = Message(N_("the height of the teeth ha* must be greater than zero, usually 1"))
        yield mistake(N_("ha* = %(ha)s leaves no teeth"), (*path, "ha*"), right, ha=f"{rack.ha:.5g}")
    elif rack.ha + rack.c >= most:
        right = Message(N_("ha* + c* must be less than %(most)s at this angle"), {"most": f"{most:.5g}"})
        yield mistake(N_("the teeth of the rack come to a point below their height"), path, right)
