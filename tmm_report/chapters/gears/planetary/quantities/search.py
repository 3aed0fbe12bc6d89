"""Quantities of the search for teeth: the solutions, how many fail and why, the list of all combinations."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tmm_report.chapters.gears.planetary.solve.combinations import Combinations
from tmm_report.chapters.gears.planetary.solve.limits import REASONS
from tmm_report.chapters.gears.planetary.solve.stage import Found, Given
from tmm_report.chapters.gears.planetary.values import Values
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol

SOLUTIONS = N_("teeth of stage %(name)s that satisfy every condition, best first")
REJECTED = N_("combinations of teeth examined for stage %(name)s by the first condition that fails")
CANDIDATES = Message(N_("combinations of teeth: the solutions, best first, then those rejected"))

AT_ONCE = 10_000  # rows that are numbers of Python at one time

TEETH = Message(N_("number of teeth"))
SATELLITES = Quantity("k", Symbol("k"), "", Message(N_("number of planet gears; 0: any")))
RATIO = Quantity("u", Symbol("u"), "", Message(N_("ratio of the angular velocities")))
DEVIATION = Quantity("delta_u", Symbol("Delta", "u"), "%", Message(N_("deviation of the ratio")))
MULTIPLE = Quantity(
    "multiple",
    None,
    "",
    Message(N_("1: teeth of a central wheel are a multiple of the planet gears' number")),
)
PLACE = Quantity("place", None, "", Message(N_("rank of the solution")))
OVERALL = Quantity("D", Symbol("D"), "m", Message(N_("diameter that the stage fills")))
SHIFTED = Quantity("shifted", None, "", Message(N_("1: coaxiality is by profile shift")))
CHOSEN = Quantity("chosen", None, "", Message(N_("1: the combination that is taken")))
VERDICT = Quantity("verdict", None, "", Message(N_("why the combination is rejected")))


def tables(found: Found, prefix: str) -> Iterator[Table]:
    """The solutions; how many combinations are rejected by each condition."""
    name = {"name": found.name}
    yield Table(f"{prefix}_solutions", Message(SOLUTIONS, name), tuple(_solutions(found)))
    yield Table(f"{prefix}_rejected", Message(REJECTED, name), tuple(_rejected(found)))


def _solutions(found: Found) -> Iterator[Column]:
    of = found.solutions
    places = np.arange(len(found.ranking))
    yield from _combinations(found.given, of.of)
    yield PLACE.column(places + 1)
    yield OVERALL.column(of.overall)
    yield SHIFTED.column(of.shifted.astype(int))
    yield CHOSEN.column((places == found.chosen).astype(int))


def _combinations(given: Given, of: Combinations) -> Iterator[Column]:
    """Teeth, satellites, ratio, deviation."""
    for wheel, key in ((0, "z1"), (1, "z2"), (2, "z2'"), (3, "z3")):
        if wheel in given.task.scheme.wheels:
            yield Quantity(key, Symbol("z", given.wheels[wheel]), "", TEETH).column(of.teeth[wheel])
    yield SATELLITES.column(of.satellites)
    yield RATIO.column(of.ratio)
    yield DEVIATION.column(100 * of.deviation)
    yield MULTIPLE.column(of.multiple.astype(int))


def _rejected(found: Found) -> Iterator[Column]:
    counts = {reason: found.candidates.count(reason) for reason in REASONS}
    met = {reason: count for reason, count in counts.items() if count}
    name = Message(N_("condition that fails first"))
    yield text_column("reason", name, [reason.name.lower() for reason in met])
    yield Values.combinations.column(list(met.values()))


# --- every combination


def candidates(found: Found) -> Table:
    """Every combination of teeth judged: the solutions, best first, then the others, the nearest to success first."""
    of = found.combinations
    return Table("candidates", CANDIDATES, (*_combinations(found.given, of), VERDICT.column(of.reason)))


def listing(table: Table, translate: Callable[[str], str] = str) -> Iterator[str]:
    """The table of `candidates` as rows of text: a head, then one combination in each line."""
    *numbers, verdict = table.columns
    words = {int(reason): translate(text) for reason, text in REASONS.items()}
    yield "".join(f"{column.key:>{_width(column.key)}}" for column in numbers)
    formats = ["{:" + f"{_width(column.key)}{_form(column.key)}" + "}" for column in numbers]
    line = "".join(formats) + "  {}"
    every = [np.asarray(column.values) for column in (*numbers, verdict)]
    for start in range(0, len(every[-1]), AT_ONCE):
        for *row, code in zip(*(one[start : start + AT_ONCE].tolist() for one in every), strict=True):
            yield line.format(*row, words[code])


def _width(key: str) -> int:
    return 11 if key in ("u", "delta_u", "multiple") else 6


def _form(key: str) -> str:
    return {"u": ".5g", "delta_u": ".2f"}.get(key, "d")
