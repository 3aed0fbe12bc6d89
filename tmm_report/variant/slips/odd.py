"""Numbers that look as if they had missed their unit, by a thousand or so: each is solved as written, with a doubt.

A length is judged by the others of the file, and all of them by what a person builds; other dimensions by limits
that no course project comes near. Where a usual unit brings the number back among the others, it is named.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from statistics import median

from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.records import dataclass
from tmm_report.variant.measures import Measure, measures
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

LARGE, SMALL = 20.0, 5e-4
"""m: a mechanism whose usual length is beyond these is not built."""
BARE, STATED, APART = 12.0, 16.0, 40.0
"""How many times the usual length another one may be: of a bare number, of one with a unit; and a coordinate."""
FAMILY = (1 / 40, 12.0)
"""Where the usual unit must bring an odd length back to, of the usual one."""

MEANT = N_("did you mean %(near)s?")


@dataclass(frozen=True)
class Limit:
    """Numbers of a dimension, SI, that are usual: of bare ones only, or of all."""

    low: float
    high: float
    bare_only: bool = True


USUAL = {
    "speed": Limit(0.0, 400.0),  # rad/s: 3800 rpm
    "pressure": Limit(50.0, 5e8, bare_only=False),
    "angle": Limit(0.0, 8 * 3.1416),
    "power": Limit(20.0, 1e7),
    "density": Limit(100.0, 3e4, bare_only=False),
}


def doubts(read: Read) -> Iterator[Problem]:
    """A doubt for each number, or law, that is odd."""
    found = measures(read)
    yield from lengths(read, found)
    for law in _laws(found):
        yield from _beyond(law)


def said(measure: Measure, text: str, low: float, high: float, **values: object) -> Problem:
    """A doubt about a number, with the unit that would bring it, SI, between two limits."""
    near = measure.meant(low, high)
    right = Message(MEANT, {"near": near}) if near else None
    return doubt(text, measure.path, right, value=measure.text, **values)


# ---------------------------------------------------------------- lengths


def lengths(read: Read, found: Sequence[Measure]) -> Iterator[Problem]:
    """Doubts about lengths."""
    stated, alike = _stated(read, found)
    if not alike:  # nothing to judge by but what a person builds
        yield from (_too_large(one) for one in stated if abs(one.size) > LARGE)
        return
    usual = median(abs(one.size) for one in alike)
    if not SMALL <= usual <= LARGE:
        yield _all_of_them(alike, usual)
        return
    own = {id(one) for one in alike}
    for one in stated:
        if _far(one, usual, id(one) in own):
            text = N_("%(value)s is odd: the usual length here is %(usual)s m")
            low, high = usual * FAMILY[0], usual * FAMILY[1]
            yield said(one, text, low, high, usual=f"{usual:.3g}")


def all_lengths(read: Read) -> Iterator[Problem]:
    """The doubt about all lengths together: it is told beside mistakes, too, as it may be the cause of some."""
    _, alike = _stated(read, measures(read))
    usual = median(abs(one.size) for one in alike) if alike else 0.0
    if alike and not SMALL <= usual <= LARGE:
        yield _all_of_them(alike, usual)


def _stated(read: Read, found: Sequence[Measure]) -> tuple[list[Measure], list[Measure]]:
    """Lengths that have no range of their own, and those of them that are of one order of magnitude."""
    stated = [one for one in found if one.dimension == "length" and one.size and not one.bounded]
    return stated, [one for one in stated if one.path[0] in _one_size(read)]


def _too_large(one: Measure) -> Problem:
    return said(one, N_("%(value)s is unusually large here"), 1e-3, LARGE)


def _one_size(read: Read) -> set[str]:
    """The keys of blocks whose lengths are of one order of magnitude."""
    return {key for block in read.blocks if block.ONE_SIZE for key in block.model_fields}


def _far(one: Measure, usual: float, alike: bool) -> bool:
    """Whether a length is far from the usual one and another unit would bring it back; or beyond what is built."""
    ratio = abs(one.size) / usual
    back = one.meant(usual * FAMILY[0], usual * FAMILY[1]) is not None
    most = APART if isinstance(one.path[-1], int) else BARE if one.bare else STATED
    if ratio > most:
        return back or abs(one.size) > LARGE
    return alike and back and ratio < 1 / 50 and not one.bare and abs(one.number) < 1


def _all_of_them(alike: Sequence[Measure], usual: float) -> Problem:
    """All lengths together are too large or too small to be built: told once, by the first of those that are so."""
    odd = [one for one in alike if not SMALL <= abs(one.size) <= LARGE]
    odd.sort(key=lambda one: isinstance(one.path[-1], int))  # lengths before coordinates
    text = N_("%(value)s is too small a length to be built, and so are %(count)s others")
    if usual > LARGE:
        text = N_("%(value)s is too large a length to be built, and so are %(count)s others")
        if odd[0].bare:
            text = N_(
                "%(value)s is too large a length to be built, and so are %(count)s others: a bare number is in metres"
            )
    return said(odd[0], text, 1e-3, 5.0, count=len(odd) - 1)


# ---------------------------------------------------------------- other dimensions


def _laws(found: Sequence[Measure]) -> Iterator[Measure]:
    """The largest number of each key, or of each load that a law states by many numbers."""
    largest: dict[tuple[str, Path], Measure] = {}
    for one in found:
        if one.dimension in USUAL and one.size and not one.bounded:
            key = one.dimension, _law(one)
            if key not in largest or abs(one.size) > abs(largest[key].size):
                largest[key] = one
    yield from largest.values()


def _law(one: Measure) -> Path:
    """What is judged by its largest number: of pressures the whole load, else the list."""
    depth = 3 if one.dimension == "pressure" else len(one.path)
    path = one.path[:depth]
    while path and isinstance(path[-1], int) and len(path) > 3:
        path = path[:-1]
    return path


def _beyond(one: Measure) -> Iterator[Problem]:
    limit, size = USUAL[one.dimension], abs(one.size)
    if (limit.bare_only and not one.bare) or limit.low <= size <= limit.high:
        return
    text = N_("%(value)s is unusually large here")
    if size < limit.low:
        text = N_("%(value)s is unusually small here")
    yield said(one, text, limit.low, limit.high)
