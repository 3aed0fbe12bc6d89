"""The numbers of the choice of method: errors and costs of every method, and what follows from them."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.methods.solve import Family, Found
from tmm_report.i18n import NP_
from tmm_report.mechanics.rivals.choice import FLOOR, rounded
from tmm_report.mechanics.rivals.counts import Counted
from tmm_report.mechanics.rivals.model import Trial
from tmm_report.mechanics.rivals.trials import worst
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.text import round_significant

TRIED = {
    "motion": Message(N_("methods of the motion: errors and costs by the number of positions")),
    "forces": Message(N_("methods of the forces: errors and costs by the number of positions")),
}
TAKEN = Message(N_("the cheapest methods that hold the accuracy at the table and diagram positions"))
METHOD = Message(N_("the method, by its name in the results"))
TAKEN_KEY = Message(N_("what is taken from the table, by its name in the results"))
FAMILY = Message(N_("what it is a method for: motion or forces"))

COUNT = Quantity("count", Symbol("N"), "", Message(N_("positions of the cycle")))
COST = Quantity(
    "cost",
    Symbol("c"),
    "",
    Message(N_("cost of the calculation, that of the closed form at the table positions being 1")),
)
WORST = Quantity("worst", Symbol("epsilon"), "", Message(N_("largest of the relative errors")))
FRONT = Message(N_("1: no other method is both cheaper and more accurate, 0: some is"))
ACCURACY = Quantity(
    "methods_accuracy",
    Symbol("epsilon", NP_("index", "adm")),
    "",
    Message(N_("relative error that is admitted")),
)
LEAST = Quantity(
    "methods_floor", None, "", Message(N_("relative error below which two ways differ by rounding"))
)


def _error(key: str, index: str, meaning: str, taken: str = "") -> Quantity:
    """`taken`: how many positions the table has from which something is taken."""
    return Quantity(key, Symbol("epsilon", index, taken), "", Message(meaning))


def _by_key(*quantities: Quantity) -> dict[str, Quantity]:
    return {quantity.key: quantity for quantity in quantities}


ERRORS = _by_key(
    _error("place", "r", N_("largest relative error of the places of points")),
    _error("velocity", "v", N_("largest relative error of the velocities of points")),
    _error("acceleration", "a", N_("largest relative error of the accelerations of points")),
    _error("reaction", "R", N_("largest relative error of the reactions")),
    _error("moment", "M", N_("largest relative error of the balancing moment")),
)

COUNTS = Message(N_("errors of what is taken from a table, by its number of positions"))
ENOUGH = Message(N_("least number of positions from which on the error is admitted"))
OF_TABLE = "N"
TAKEN_FROM = _by_key(
    _error("velocity", "v", N_("error of the greatest velocities of points"), OF_TABLE),
    _error("acceleration", "a", N_("error of the greatest accelerations of points"), OF_TABLE),
    _error("moment", "M", N_("error of the extremes of the balancing moment"), OF_TABLE),
    _error("work", "A", N_("error of the work of the loads over the cycle"), OF_TABLE),
    _error(
        "inertia_mean",
        NP_("index", "mean"),
        N_("error of the mean of the reduced moment of inertia"),
        OF_TABLE,
    ),
    _error("inertia", "I", N_("error of the extremes of the reduced moment of inertia"), OF_TABLE),
    _error(
        "unevenness",
        "delta",
        N_("error of the coefficient of speed fluctuation, and so of the flywheel"),
        OF_TABLE,
    ),
)
ADMITTED = Quantity(
    "counts_accuracy",
    Symbol("epsilon", NP_("index", "adm")),
    "",
    Message(N_("relative error that is admitted of what is taken from a table")),
    "%",
)
RECOMMENDED = Quantity(
    "counts_recommended", Symbol("N", NP_("index", "rec")), "", Message(N_("recommended number of positions"))
)


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for family in found.families.values():
        yield Table(f"methods_{family.key}", TRIED[family.key], tuple(_columns(family)))
    yield _taken(found)
    if found.counted is not None:
        yield _counts(found.counted)
        yield _enough(found.counted)


def _columns(family: Family) -> Iterator[Column]:
    rows = family.rows
    yield text_column("method", METHOD, [one.method.key for one in rows])
    yield COUNT.column([one.count for one in rows])
    yield COST.column([_cost(family, one) for one in rows])
    for kind in family.kinds:
        yield ERRORS[kind].column([one.errors.get(kind, float("nan")) for one in rows])
    yield Column(Quantity("front", None, "", FRONT), [int(k in family.front) for k in range(len(rows))])


def _cost(family: Family, one: Trial) -> float:
    """To three digits: the table that it is counted by has no more."""
    return float(round_significant(one.seconds / family.unit, 3))


def _taken(found: Found) -> Table:
    best = [(family, family.best) for family in found.families.values() if family.best is not None]
    return Table(
        "methods_chosen",
        TAKEN,
        (
            text_column("of", FAMILY, [family.key for family, _ in best]),
            text_column("method", METHOD, [one.method.key for _, one in best]),
            COUNT.column([one.count for _, one in best]),
            COST.column([_cost(family, one) for family, one in best]),
            WORST.column([worst(one.errors) for _, one in best]),
        ),
    )


def _counts(found: Counted) -> Table:
    errors = (TAKEN_FROM[key].column([rounded(error) for error in row]) for key, row in found.errors.items())
    return Table("methods_counts", COUNTS, (COUNT.column(list(found.counts)), *errors))


def _enough(found: Counted) -> Table:
    """A row for each of what is taken; nan where no number of positions is enough."""
    least = [float("nan") if count is None else count for count in found.enough.values()]
    return Table(
        "methods_enough",
        ENOUGH,
        (text_column("of", TAKEN_KEY, list(found.enough)), COUNT.column(least)),
    )


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield ACCURACY.value(found.accuracy)
    yield LEAST.value(FLOOR)
    if found.counted is not None:
        yield ADMITTED.value(found.counted.accuracy)
        if found.counted.recommended is not None:
            yield RECOMMENDED.value(found.counted.recommended)
