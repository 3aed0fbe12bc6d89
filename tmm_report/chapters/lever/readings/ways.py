"""How the numbers of the comparison with a student's own are found."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import NAME, Known, Way

STATED = N_("The student's own reading, as the variant states it.")
ANALYTIC = N_("The value of the analytical method at the position: of a vector its size.")
ALLOWED = N_("Judged by the difference that is allowed and by what can be read off the polygon.")


def _differ(q: Known) -> Expr:
    graph, analytic = q("graph"), q("analytic")
    if graph.number * analytic.number < 0:
        raise KeyError("the signs differ")
    return 200 * (graph - analytic) / (graph + analytic)


WAYS = (
    Way("*.key *.unit", NAME),
    Way("*.graph", STATED, of="key"),
    Way("*.analytic", ANALYTIC, of="key"),
    Way("*.delta", by=_differ),
    Way(
        "*.delta",
        N_("Twice the difference by the sum of both; 200 where the signs differ."),
        of="graph analytic",
    ),
    Way("*.right", ALLOWED, of="delta accuracy"),
)
