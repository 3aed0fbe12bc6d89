"""How many combinations of teeth the stages of a drive may have tried, and how many a listing of them may have."""

from __future__ import annotations

from collections.abc import Iterable

from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.mechanics.gears.planetary.sought import extent
from tmm_report.problems import N_, Message, ProblemError, mistake

MOST = 7_000_000  # nodes of the grids of teeth: the widest ranges, with every scheme, once
LISTED = 650_000  # combinations of a listing


def nodes(given: planetary.Given) -> int:
    """The nodes of the grids of teeth that the search for a stage goes through, with every scheme it tries."""
    return sum(extent(task) for task in planetary.tasks(given))


def check_search(stages: Iterable[object]) -> None:
    """Raises ProblemError, before anything is tried, where the ranges of the stages are too wide together."""
    counts = {k: nodes(one) for k, one in enumerate(stages) if isinstance(one, planetary.Given)}
    if sum(counts.values()) <= MOST:
        return
    wrong = N_("the stages ask for %(count)s combinations of teeth to be tried, and at most %(most)s are")
    right = Message(N_("narrower external_teeth and ring_teeth, a stated scheme or fewer stages"))
    widest = max(counts, key=lambda k: counts[k])
    path = ("drive", "stages", widest)
    raise ProblemError([mistake(wrong, path, right, count=sum(counts.values()), most=MOST)])


def check_listing(found: planetary.Found, stage: int) -> None:
    """Raises ProblemError, before the list is made, where it would be too long."""
    if (count := found.candidates.examined) > LISTED:
        wrong = N_(
            "the list of all combinations of teeth would have %(count)s lines, and at most %(most)s are written"
        )
        right = Message(N_("narrower external_teeth and ring_teeth, or fewer numbers of planet gears"))
        raise ProblemError([mistake(wrong, ("drive", "stages", stage), right, count=count, most=LISTED)])
