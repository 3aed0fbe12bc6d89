"""Springs and dampers as schemes show them: a zigzag between two leads, a piston in an open cup.

They lie along the line of their ends and are as long as these are apart; their width and the number of coils stay.
"""

from __future__ import annotations

from tmm_report.figures.drawing import NORMAL, Item, Pen, line, polyline

NOTHING = 1e-6  # mm: ends as near as this have no line between them
LEAD = 0.15  # of the least length: the straight ends of a spring, the rod of a cup
CUP = 0.55  # of the least length
ROOM = (0.2, 0.8)  # between which parts of the cup the piston goes


def zigzag(
    start: complex, end: complex, coils: int, half: float, lead: float | None = None, pen: Pen = NORMAL
) -> list[Item]:
    """A helical spring of so many coils, twice `half` wide, mm; `lead`: length of its straight ends, mm."""
    long = abs(end - start)
    if long < NOTHING:
        return []
    along = (end - start) / long
    lead = LEAD * long if lead is None else min(lead, long / 3)
    pitch = (long - 2 * lead) / (2 * coils)
    side = 1j * half * along
    bends = [
        start + (lead + (k + 0.5) * pitch) * along + (side if k % 2 else -side) for k in range(2 * coils)
    ]
    return [polyline([start, start + lead * along, *bends, end - lead * along, end], pen)]


def dashpot(
    start: complex, end: complex, least: float, most: float, half: float, pen: Pen = NORMAL
) -> list[Item]:
    """A damper: a cup on a rod from `start`, a piston on a rod from `end`, which are between `least` and `most` mm
    apart over the motion, so that the piston stays in the cup."""
    long = abs(end - start)
    if long < NOTHING:
        return []
    along = (end - start) / long
    side = 1j * half * along
    low = min(LEAD * least, long / 3)
    cup = min(CUP * least, long / 2)
    share = (long - least) / (most - least) if most > least else 0.5
    piston = start + (low + cup * (ROOM[0] + (ROOM[1] - ROOM[0]) * min(max(share, 0.0), 1.0))) * along
    near, far = start + low * along, start + (low + cup) * along
    return [
        line(start, near, pen),
        polyline([far + side, near + side, near - side, far - side], pen),
        line(piston + 0.8 * side, piston - 0.8 * side, pen),
        line(piston, end, pen),
    ]
