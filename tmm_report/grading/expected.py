"""What can be asked of a solved variant: its columns of numbers, by table and key."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from tmm_report.course import Results, room, with_data
from tmm_report.judging import asked
from tmm_report.judging.model import Asked, Name
from tmm_report.quantity.model import Quantity

OF_MOTION = {"positions_table", "outputs_table", "rates_table"}
OF_FORCES = {"powers_table", "loads_table", "reactions_table", "balancing_table"}


def expected(results: Results) -> dict[Name, Asked]:
    """Every column of numbers of a solved variant that a student may be asked for, in the order of the note."""
    return {one.name: one for chapter, found in with_data(results) for one in _of_chapter(chapter, found)}


def of_tables(results: Results, names: Collection[str]) -> dict[Name, Asked]:
    """The columns of some tables of motion and forces alone: no other is made."""
    lever, found = results.lever, {}
    assert lever is not None
    left = set(names)
    for chapter, solved in (("kinematics", lever.kinematics), ("kinetostatics", lever.kinetostatics)):
        tables = room(chapter, "quantities").tables(solved) if solved is not None else ()
        own = OF_MOTION if chapter == "kinematics" else OF_FORCES
        for table in tables:
            if not left & own:
                break
            if table.name in left:
                left.discard(table.name)
                found.update({one.name: one for one in asked.of_table(table, chapter)})
    return found


def reversed_reactions(results: Results) -> list[tuple[Quantity, Name]]:
    """The reaction of link b on link a, which is as great as that of a on b: where the column asked stands."""
    if results.lever is None or results.lever.kinetostatics is None:
        return []
    reaction = room("kinetostatics", "quantities.positions").reaction
    pairs = [pair.links for pair in results.lever.structure.pairs]
    both = [(one, other) for pair in pairs for one, other in (pair, pair[::-1])]
    return [(reaction(b, a), ("reactions_table", reaction(a, b).key)) for a, b in both]


def _of_chapter(chapter: str, found: object) -> Iterator[Asked]:
    quantities = room(chapter, "quantities")
    for table in quantities.tables(found):
        yield from asked.of_table(table, chapter)
    for value in quantities.values(found):
        yield from asked.of_value(value, chapter)
